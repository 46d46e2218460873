//! The mathematics by definition, slowly, on fractions: independent oracles.
//!
//! Nothing here calls the core, nothing is clever, and each function is the textbook's formula read aloud. B-splines are
//! the plain recursion with 0/0 = 0 over *all* functions, not only those of a span; splines are found from 4n unknown
//! coefficients by dense elimination, not from slopes. A fault shared with the core would have to be made twice.

use crate::rational::{Rational, ratio};
use lath::knot::Side;
use lath::num::Scalar;

/// C(n, k).
pub fn binomial(n: usize, k: usize) -> Rational {
    (0..k).map(|i| ratio((n - i) as i64, (i + 1) as i64)).fold(Rational::one(), |product, factor| product * factor)
}

/// J_{n,i}(u) = C(n,i) uⁱ (1−u)ⁿ⁻ⁱ, with 0⁰ = 1.
pub fn bernstein(n: usize, i: usize, u: &Rational) -> Rational {
    binomial(n, i) * u.power(i) * (Rational::one() - u.clone()).power(n - i)
}

/// The k-th derivative of J_{n,i} at u: J′_{n,i} = n (J_{n−1,i−1} − J_{n−1,i}).
pub fn bernstein_derivative(n: usize, i: usize, k: usize, u: &Rational) -> Rational {
    if k == 0 {
        return bernstein(n, i, u);
    }
    if n == 0 {
        return Rational::zero();
    }
    let left = if i > 0 { bernstein_derivative(n - 1, i - 1, k - 1, u) } else { Rational::zero() };
    let right = if i < n { bernstein_derivative(n - 1, i, k - 1, u) } else { Rational::zero() };
    Rational::from(n as i64) * (left - right)
}

/// a/b, and 0 if b = 0: the convention of the recursion.
fn ratio_or_zero(a: Rational, b: Rational) -> Rational {
    if b == 0 { Rational::zero() } else { a / b }
}

/// N_{i,p}(t) by the recursion of Cox and de Boor, 0/0 = 0, on any non-decreasing knots.
///
/// From the right, N_{i,0} is 1 on [tᵢ, tᵢ₊₁); from the left on (tᵢ, tᵢ₊₁].
pub fn bspline(knots: &[Rational], p: usize, i: usize, t: &Rational, side: Side) -> Rational {
    if p == 0 {
        let inside = match side {
            Side::Right => knots[i] <= *t && *t < knots[i + 1],
            Side::Left => knots[i] < *t && *t <= knots[i + 1],
        };
        return if inside { Rational::one() } else { Rational::zero() };
    }
    let rising = ratio_or_zero(t.clone() - knots[i].clone(), knots[i + p].clone() - knots[i].clone());
    let falling = ratio_or_zero(knots[i + p + 1].clone() - t.clone(), knots[i + p + 1].clone() - knots[i + 1].clone());
    rising * bspline(knots, p - 1, i, t, side) + falling * bspline(knots, p - 1, i + 1, t, side)
}

/// The k-th derivative of N_{i,p} at t: N′_{i,p} = p/(t_{i+p}−tᵢ) N_{i,p−1} − p/(t_{i+p+1}−t_{i+1}) N_{i+1,p−1}.
pub fn bspline_derivative(knots: &[Rational], p: usize, i: usize, k: usize, t: &Rational, side: Side) -> Rational {
    if k == 0 {
        return bspline(knots, p, i, t, side);
    }
    if p == 0 {
        return Rational::zero();
    }
    let degree = Rational::from(p as i64);
    let rising = ratio_or_zero(degree.clone(), knots[i + p].clone() - knots[i].clone());
    let falling = ratio_or_zero(degree, knots[i + p + 1].clone() - knots[i + 1].clone());
    rising * bspline_derivative(knots, p - 1, i, k - 1, t, side)
        - falling * bspline_derivative(knots, p - 1, i + 1, k - 1, t, side)
}

/// The k-th derivatives of all functions at once: the same recursion, each value computed once instead of 2ᵖ times.
pub fn bspline_row(knots: &[Rational], p: usize, k: usize, t: &Rational, side: Side) -> Vec<Rational> {
    let mut row: Vec<Rational> = (0..knots.len() - 1).map(|i| bspline(knots, 0, i, t, side)).collect();
    if k > p {
        return vec![Rational::zero(); knots.len() - p - 1];
    }
    for r in 1..=p {
        row = (0..knots.len() - r - 1)
            .map(|i| {
                let (a, b) = (&knots[i], &knots[i + r]);
                let (c, d) = (&knots[i + 1], &knots[i + r + 1]);
                // Values up to degree p − k, derivatives of them above.
                let (rising, falling) = if r <= p - k {
                    (t.clone() - a.clone(), d.clone() - t.clone())
                } else {
                    (Rational::from(r as i64), -Rational::from(r as i64))
                };
                ratio_or_zero(rising, b.clone() - a.clone()) * row[i].clone()
                    + ratio_or_zero(falling, d.clone() - c.clone()) * row[i + 1].clone()
            })
            .collect();
    }
    row
}

/// The side from which t is answered by default: from the left at the domain's end [t_p, t_n], else from the right.
pub fn default_side(knots: &[Rational], p: usize, t: &Rational) -> Side {
    if *t == knots[knots.len() - p - 1] { Side::Left } else { Side::Right }
}

/// The k-th derivative at t of Σ bᵢ N_{i,p}, for one coordinate.
pub fn spline(knots: &[Rational], p: usize, b: &[Rational], k: usize, t: &Rational, side: Side) -> Rational {
    let row = bspline_row(knots, p, k, t, side);
    b.iter().zip(row).map(|(b, value)| b.clone() * value).sum()
}

/// The k-th derivative at t of the Bézier curve of the points b on [a, c], for one coordinate.
pub fn bezier(b: &[Rational], (a, c): (&Rational, &Rational), k: usize, t: &Rational) -> Rational {
    let length = c.clone() - a.clone();
    let u = (t.clone() - a.clone()) / length.clone();
    let n = b.len() - 1;
    let sum: Rational = (0..=n).map(|i| b[i].clone() * bernstein_derivative(n, i, k, &u)).sum();
    sum / length.power(k)
}

/// The derivatives of a/b from those of a and b: C = A/B, so A⁽ᵏ⁾ = Σ binom(k,i) B⁽ⁱ⁾ C⁽ᵏ⁻ⁱ⁾, solved for C⁽ᵏ⁾.
pub fn quotient(a: &[Rational], b: &[Rational]) -> Vec<Rational> {
    let mut out: Vec<Rational> = Vec::new();
    for k in 0..a.len() {
        let known: Rational = (1..=k).map(|i| binomial(k, i) * b[i].clone() * out[k - i].clone()).sum();
        out.push((a[k].clone() - known) / b[0].clone());
    }
    out
}

/// The solution of a dense linear system, by elimination with exchange of rows; none if it is singular.
pub fn solve(mut matrix: Vec<Vec<Rational>>, mut rhs: Vec<Rational>) -> Option<Vec<Rational>> {
    let n = rhs.len();
    for k in 0..n {
        let pivot = (k..n).find(|&i| matrix[i][k] != 0)?;
        matrix.swap(k, pivot);
        rhs.swap(k, pivot);
        for i in 0..n {
            if i == k || matrix[i][k] == 0 {
                continue;
            }
            let factor = matrix[i][k].clone() / matrix[k][k].clone();
            for j in k..n {
                matrix[i][j] = matrix[i][j].clone() - factor.clone() * matrix[k][j].clone();
            }
            rhs[i] = rhs[i].clone() - factor * rhs[k].clone();
        }
    }
    Some((0..n).map(|i| rhs[i].clone() / matrix[i][i].clone()).collect())
}

/// The condition at one end of a cubic spline, for one coordinate.
#[derive(Clone, Debug)]
pub enum End {
    /// Second derivative 0.
    Natural,
    /// The third derivative is continuous at the neighbouring parameter.
    NotAKnot,
    /// The first derivative.
    Clamped(Rational),
    /// The second derivative.
    Second(Rational),
}

/// The conditions at both ends.
#[derive(Clone, Debug)]
pub enum Ends {
    /// One at the start, one at the end.
    Open(End, End),
    /// First and second derivative agree at both ends.
    Cyclic,
    /// They agree with opposite sign.
    Anticyclic,
}

/// The cubic spline through (tᵢ, yᵢ): for every interval its coefficients of 1, s, s², s³ with s = t − tᵢ.
///
/// All 4n coefficients are unknowns of one dense system: 2n values, n − 1 slopes, n − 1 second derivatives, two ends.
/// None if the system is singular, as it is for two not-a-knot ends that speak of the same parameter.
pub fn cubic_spline(t: &[Rational], y: &[Rational], ends: &Ends) -> Option<Vec<[Rational; 4]>> {
    let n = t.len() - 1;
    let zero = Rational::zero();
    let mut matrix: Vec<Vec<Rational>> = Vec::new();
    let mut rhs = Vec::new();
    // The k-th derivative of piece i at distance s from its start, times `factor`, as entries of a row.
    let add = |row: &mut Vec<Rational>, i: usize, k: usize, s: &Rational, factor: i64| {
        for power in k..4 {
            let falling: i64 = (power - k + 1..=power).map(|f| f as i64).product();
            row[4 * i + power] += Rational::from(falling * factor) * s.power(power - k);
        }
    };
    let mut equation = |entries: &[(usize, usize, Rational, i64)], value: &Rational| {
        let mut row = vec![zero.clone(); 4 * n];
        for (i, k, s, factor) in entries {
            add(&mut row, *i, *k, s, *factor);
        }
        matrix.push(row);
        rhs.push(value.clone());
    };
    let start = |i: usize, k: usize, factor: i64| (i, k, Rational::zero(), factor);
    let end = |i: usize, k: usize, factor: i64| (i, k, t[i + 1].clone() - t[i].clone(), factor);
    for i in 0..n {
        equation(&[start(i, 0, 1)], &y[i]);
        equation(&[end(i, 0, 1)], &y[i + 1]);
    }
    for i in 1..n {
        for k in [1, 2] {
            equation(&[end(i - 1, k, 1), start(i, k, -1)], &zero);
        }
    }
    match ends {
        Ends::Open(first, last) => {
            match first {
                End::Natural => equation(&[start(0, 2, 1)], &zero),
                End::NotAKnot => equation(&[end(0, 3, 1), start(1, 3, -1)], &zero),
                End::Clamped(slope) => equation(&[start(0, 1, 1)], slope),
                End::Second(second) => equation(&[start(0, 2, 1)], second),
            }
            match last {
                End::Natural => equation(&[end(n - 1, 2, 1)], &zero),
                End::NotAKnot => equation(&[end(n - 2, 3, 1), start(n - 1, 3, -1)], &zero),
                End::Clamped(slope) => equation(&[end(n - 1, 1, 1)], slope),
                End::Second(second) => equation(&[end(n - 1, 2, 1)], second),
            }
        }
        Ends::Cyclic => (1..=2).for_each(|k| equation(&[start(0, k, 1), end(n - 1, k, -1)], &zero)),
        Ends::Anticyclic => (1..=2).for_each(|k| equation(&[start(0, k, 1), end(n - 1, k, 1)], &zero)),
    }
    let solution = solve(matrix, rhs)?;
    Some(solution.chunks(4).map(|c| std::array::from_fn(|k| c[k].clone())).collect())
}

/// The k-th derivative at t of a spline by its coefficients, from the right inside, from the left at the end.
pub fn piecewise(t: &[Rational], pieces: &[[Rational; 4]], k: usize, at: &Rational) -> Rational {
    let i = (0..pieces.len()).rev().find(|&i| t[i] <= *at).unwrap_or(0);
    let s = at.clone() - t[i].clone();
    let term = |power: usize| {
        let falling: i64 = (power - k + 1..=power).map(|f| f as i64).product();
        Rational::from(falling) * pieces[i][power].clone() * s.power(power - k)
    };
    (k..4).map(term).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn fractions(texts: &[&str]) -> Vec<Rational> {
        texts.iter().map(|text| text.parse().unwrap()).collect()
    }

    #[test]
    fn the_oracle_knows_the_uniform_cubic() {
        let knots: Vec<Rational> = (0..8).map(Rational::from).collect();
        let at = |t: i64| -> Vec<Rational> {
            (0..4).map(|i| bspline(&knots, 3, i, &Rational::from(t), Side::Right)).collect()
        };
        assert_eq!(at(3), fractions(&["1/6", "2/3", "1/6", "0"]));
        let slopes: Vec<Rational> =
            (0..4).map(|i| bspline_derivative(&knots, 3, i, 1, &Rational::from(3), Side::Right)).collect();
        assert_eq!(slopes, fractions(&["-1/2", "0", "1/2", "0"]));
    }

    #[test]
    fn a_row_is_the_recursion_for_every_function() {
        let knots: Vec<Rational> = [0, 0, 0, 1, 3, 3, 4, 4, 4, 4, 6].map(Rational::from).to_vec();
        for t in [ratio(1, 3), ratio(1, 1), ratio(3, 1), ratio(4, 1), ratio(9, 2)] {
            for side in [Side::Left, Side::Right] {
                for (p, k) in [(0, 0), (1, 0), (3, 0), (3, 1), (3, 2), (3, 3), (2, 3), (4, 2)] {
                    let row = bspline_row(&knots, p, k, &t, side);
                    let each = (0..knots.len() - p - 1).map(|i| bspline_derivative(&knots, p, i, k, &t, side));
                    assert_eq!(row, each.collect::<Vec<_>>(), "degree {p}, derivative {k} at {t}");
                }
            }
        }
    }

    #[test]
    fn the_oracle_reproduces_a_cubic() {
        let t: Vec<Rational> = [0, 1, 3, 4, 7].map(Rational::from).to_vec();
        let y: Vec<Rational> = t.iter().map(|t| t.power(3) - t.clone()).collect();
        let pieces = cubic_spline(&t, &y, &Ends::Open(End::NotAKnot, End::NotAKnot)).unwrap();
        for at in [ratio(1, 2), ratio(7, 2), ratio(7, 1)] {
            assert_eq!(piecewise(&t, &pieces, 0, &at), at.power(3) - at.clone());
            assert_eq!(piecewise(&t, &pieces, 1, &at), Rational::from(3) * at.power(2) - Rational::one());
            assert_eq!(piecewise(&t, &pieces, 3, &at), 6);
        }
    }

    #[test]
    fn two_not_a_knot_ends_at_one_parameter_are_singular() {
        let t: Vec<Rational> = [0, 1, 2].map(Rational::from).to_vec();
        assert!(cubic_spline(&t, &t, &Ends::Open(End::NotAKnot, End::NotAKnot)).is_none());
    }
}
