//! Uniform B-splines of degree p by matrix: the p + 1 functions that are not zero on one segment, u ∈ [0, 1] along it.
//!
//! Pᵢ(u) = (uᵖ, …, u, 1) M (Pᵢ, …, P_{i+p})ᵀ is the textbook's form. Its numbers have signs, and where a function fades out they cancel: in
//! floating point nothing is left of it (see [`power_matrix`]). The same functions in Bernstein form,
//! Pᵢ(u) = (J_{p,0}(u), …, J_{p,p}(u)) W (Pᵢ, …, P_{i+p})ᵀ, have a matrix W without a sign: all entries are whole multiples of 1/p! from 0 to 1
//! and every row sums to 1, so that only weighted means are taken. [`UniformBasis`] evaluates by W.
//!
//! Both are made of whole numbers below 2¹²⁸, which ends the family at degree 30 (30! < 2¹⁰⁸); a
//! [`Knots::uniform`](crate::knot::Knots::uniform) knows no such end.
//!
//! *Source.* D. Salomon, Curves and Surfaces for Computer Graphics (2006), §4.15, for M; W by the recursion of Cox and de Boor (1972) in
//! Bernstein form.

use crate::basis::bernstein;
use crate::basis::scratch::Scratch;
use crate::error::{Code, Error, Result};
use crate::num::Scalar;
use crate::space::Vector;
use alloc::format;
use alloc::vec::Vec;

/// The greatest degree of the matrices.
pub const MAX_DEGREE: usize = 30;

fn check_degree(degree: usize) -> Result<()> {
    if degree <= MAX_DEGREE {
        return Ok(());
    }
    let message = format!("degree {degree} is above {MAX_DEGREE}, where the matrices end; BSpline::uniform goes on");
    Err(Error::new(Code::K006, message))
}

/// p! W for the degrees 0 … p: row r holds the shares of the p + 1 control points in Bernstein point r.
///
/// Row 0 by N_{j,p}(0) = ((p−j) N_{j−1,p−1}(0) + (j+1) N_{j,p−1}(0))/p, the others by the derivative,
/// p (b_{r+1} − b_r) = Σ W′_{rj} (P_{j+1} − P_j), where W′ belongs to degree p − 1: one addition and one subtraction each.
fn numerators(degree: usize) -> Vec<Vec<Vec<u128>>> {
    let mut all: Vec<Vec<Vec<u128>>> = alloc::vec![alloc::vec![alloc::vec![1]]];
    for p in 1..=degree {
        let below = &all[p - 1];
        let at = |r: usize, j: usize| below[r].get(j).copied().unwrap_or(0);
        let before = |r: usize, j: usize| if j > 0 { at(r, j - 1) } else { 0 };
        let first = (0..=p).map(|j| (p - j) as u128 * before(0, j) + (j + 1) as u128 * at(0, j)).collect();
        let mut rows: Vec<Vec<u128>> = alloc::vec![first];
        for r in 0..p {
            let next = rows[r].iter().enumerate().map(|(j, share)| share + before(r, j) - at(r, j)).collect();
            rows.push(next);
        }
        all.push(rows);
    }
    all
}

/// p!, which fits up to degree 30.
fn factorial(degree: usize) -> u128 {
    (1..=degree as u128).product()
}

/// C(n, k) for n ≤ 30.
fn binomial(n: usize, k: usize) -> i128 {
    (0..k).fold(1, |product, i| product * (n - i) as i128 / (i + 1) as i128)
}

/// A whole number as a scalar; `f64` rounds it twice at most.
fn whole<S: Scalar>(n: u128) -> S {
    let low = S::from_int((n & ((1 << 62) - 1)) as i64);
    match (n >> 62) as i64 {
        0 => low,
        high => S::from_int(high) * S::from_int(1 << 62) + low,
    }
}

/// n/d in lowest terms, which a float then holds as well as it can.
fn fraction<S: Scalar>(n: u128, d: u128) -> S {
    let (mut a, mut b) = (n, d);
    while b > 0 {
        (a, b) = (b, a % b);
    }
    whole::<S>(n / a) / whole::<S>(d / a)
}

/// M of degree p, exactly over fractions: rows belong to uᵖ, …, u, 1, columns to the control points.
///
/// m_{ij} = (1/p!) C(p,i) Σ_{k=j}^{p} (p−k)ⁱ (−1)^{k−j} C(p+1, k−j), row i to u^{p−i} and 0⁰ = 1. It is computed by Taylor's
/// formula instead, from the functions of lower degrees at u = 0, whose numbers are smaller.
///
/// It is for paper and for exchange. Evaluation by M is off by a few roundings beside the largest control point, but not beside
/// Σ|Pⱼ|Nⱼ(u): of the first function at u = 0.9, which is (1 − u)ᵖ/p!, Horner's scheme on floats is off by E = 1e3 at degree 3, 1e12 at degree
/// 10 and 2e36 at degree 30 (measured), so that a far away point of great size spoils what it should not reach. [`UniformBasis`] keeps E ≤ 3(p + 1).
///
/// *Cost.* O(p³) operations on whole numbers.
///
/// ```
/// use lath::basis::uniform::power_matrix;
///
/// let m = power_matrix::<f64>(2)?;
/// assert_eq!(m, [[0.5, -1.0, 0.5], [-1.0, 1.0, 0.0], [0.5, 0.5, 0.0]]);
/// # Ok::<(), lath::error::Error>(())
/// ```
///
/// # Errors
/// K006 above degree 30.
pub fn power_matrix<S: Scalar>(degree: usize) -> Result<Vec<Vec<S>>> {
    check_degree(degree)?;
    let (all, denominator) = (numerators(degree), factorial(degree));
    // The m-th derivative at 0 is Σ Nᵢ(0) Δᵐ Pᵢ with the functions of degree p − m; divided by m! it is the coefficient of uᵐ.
    let entry = |m: usize, j: usize| {
        let values = &all[degree - m][0];
        let share = |l: usize| j.checked_sub(l).and_then(|i| values.get(i)).map_or(0, |share| *share as i128);
        let sign = |l: usize| if (m - l).is_multiple_of(2) { 1 } else { -1 };
        let sum: i128 = (0..=m).map(|l| sign(l) * binomial(m, l) * share(l)).sum();
        let size = fraction::<S>((binomial(degree, m) * sum).unsigned_abs(), denominator);
        if sum < 0 { -size } else { size }
    };
    Ok((0..=degree).rev().map(|m| (0..=degree).map(|j| entry(m, j)).collect()).collect())
}

/// The matrices W of a degree and of all below it, which its derivatives need: computed once, exactly, in whole numbers.
///
/// *Cost.* O(p³) additions of whole numbers to make, (p+1)(p+2)(2p+3)/6 numbers to keep (30 for cubics).
///
/// ```
/// use lath::basis::uniform::UniformBasis;
///
/// let cubic = UniformBasis::<f64>::new(3)?;
/// // The point where two segments join, (P₀ + 4P₁ + P₂)/6.
/// assert_eq!(cubic.joint(), [1.0 / 6.0, 2.0 / 3.0, 1.0 / 6.0]);
/// // Bernstein points of the segment: (P₀ + 4P₁ + P₂)/6, (2P₁ + P₂)/3, (P₁ + 2P₂)/3, (P₁ + 4P₂ + P₃)/6.
/// assert_eq!(cubic.row(1), [0.0, 2.0 / 3.0, 1.0 / 3.0, 0.0]);
/// # Ok::<(), lath::error::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct UniformBasis<S = f64> {
    degree: usize,
    /// W of degree 0, 1, …, p, row after row.
    matrices: Vec<Vec<S>>,
}

impl<S: Scalar> UniformBasis<S> {
    /// The matrices of this degree.
    ///
    /// # Errors
    /// K006 above degree 30.
    pub fn new(degree: usize) -> Result<UniformBasis<S>> {
        check_degree(degree)?;
        let scaled = |(p, rows): (usize, Vec<Vec<u128>>)| {
            let denominator = factorial(p);
            rows.into_iter().flatten().map(|share| fraction(share, denominator)).collect()
        };
        Ok(UniformBasis { degree, matrices: numerators(degree).into_iter().enumerate().map(scaled).collect() })
    }

    /// The degree p.
    pub fn degree(&self) -> usize {
        self.degree
    }

    /// Row r of W: the shares of the p + 1 control points of a segment in its Bernstein point r; no row beyond p.
    pub fn row(&self, r: usize) -> &[S] {
        self.row_of(self.degree, r)
    }

    fn row_of(&self, degree: usize, r: usize) -> &[S] {
        self.matrices.get(degree).and_then(|matrix| matrix.chunks(degree + 1).nth(r)).unwrap_or_default()
    }

    /// The shares of the p points that make a joint, the point where a segment starts: for degree 2 (1, 1)/2, for degree 3 (1, 4, 1)/6, for
    /// degree 5 (1, 26, 66, 26, 1)/120. They are symmetric. Degree 0 has the one share 1.
    pub fn joint(&self) -> &[S] {
        let row = self.row(0);
        row.get(..self.degree.max(1)).unwrap_or(row)
    }

    /// The Bernstein points of a segment with these p + 1 control points; another number of points gives none.
    ///
    /// *Error.* Weighted means: E ≤ p + 5.
    pub fn bernstein_points<V: Vector<S>>(&self, points: &[V]) -> Vec<V> {
        let rows = if points.len() == self.degree + 1 { points.len() } else { 0 };
        (0..rows).map(|r| mean(self.row(r), points)).collect()
    }

    /// Value and derivatives of the segment with these p + 1 control points at the weights (1 − u, u): `out[k]` receives the k-th
    /// derivative by u.
    ///
    /// The k-th derivative is the segment of degree p − k of the k-th differences: subtracted first, evaluated afterwards, and
    /// with unit spans no factor arises.
    ///
    /// *Cost.* O(p²) for each order. *Error.* E ≤ 3(p + 1) for values, 10p for derivatives scaled by their own condition, for u in [0, 1].
    /// Orders above p are zero. `points` must hold p + 1 points; otherwise the answer is zero.
    pub fn jet<V: Vector<S>>(&self, points: &[V], (complement, u): (&S, &S), out: &mut [V]) {
        let mut differences = Scratch::of(points);
        let mut segment = differences.clone();
        for (k, slot) in out.iter_mut().enumerate() {
            if k > self.degree || points.len() != self.degree + 1 {
                *slot = V::zero();
                continue;
            }
            let degree = self.degree - k;
            let row = differences.points();
            if k > 0 {
                for j in 0..=degree {
                    let mut step = row[j + 1].clone();
                    step.add_scaled(&-S::one(), &row[j]);
                    row[j] = step;
                }
            }
            let row = &row[..=degree];
            segment.shorten(degree + 1);
            let bernstein_points = segment.points();
            for (r, point) in bernstein_points.iter_mut().enumerate() {
                *point = mean(self.row_of(degree, r), row);
            }
            *slot = bernstein::eval_in_place(bernstein_points, (complement, u));
        }
    }
}

/// Σ wⱼ Pⱼ, in order; shares of zero are passed over.
fn mean<S: Scalar, V: Vector<S>>(shares: &[S], points: &[V]) -> V {
    let mut sum = V::zero();
    for (share, point) in shares.iter().zip(points).filter(|(share, _)| !share.is_zero()) {
        sum.add_scaled(share, point);
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shares_are_whole_never_negative_and_make_one() {
        // Subtraction of unsigned numbers would have stopped the recursion, had an entry become negative.
        for (p, rows) in numerators(MAX_DEGREE).iter().enumerate() {
            assert_eq!(rows.len(), p + 1);
            assert!(rows.iter().all(|row| row.iter().sum::<u128>() == factorial(p)), "degree {p}");
            // Run backwards, the segment has its control points in opposite order.
            let turned: Vec<Vec<u128>> = rows.iter().rev().map(|row| row.iter().rev().copied().collect()).collect();
            assert_eq!(*rows, turned, "degree {p}");
        }
        assert_eq!(power_matrix::<f64>(31).unwrap_err().code(), Code::K006);
        assert_eq!(UniformBasis::<f64>::new(31).unwrap_err().code(), Code::K006);
    }

    #[test]
    fn whole_numbers_survive_the_limbs() {
        assert_eq!(whole::<f64>(factorial(30)), 265_252_859_812_191_058_636_308_480_000_000.0);
        assert_eq!(whole::<f64>(1 << 62), 4_611_686_018_427_387_904.0);
        assert_eq!(fraction::<f64>(factorial(29), factorial(30)), 1.0 / 30.0);
        assert_eq!(fraction::<f64>(0, factorial(30)), 0.0);
    }
}
