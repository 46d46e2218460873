//! Eigenvalues of small matrices: characteristic polynomials and their roots.
//!
//! Over fractions the polynomial is split into parts with simple roots by greatest common divisors; each root is guessed
//! from its float by continued fractions and then tested exactly, so that a rational root is never an approximation.

use crate::num::Scalar;
use crate::subdivide::matrix::{Matrix, product};
use crate::subdivide::scheme::magnitude;
use alloc::vec::Vec;

/// det(z − A), ascending powers, by Faddeev and LeVerrier.
pub(crate) fn characteristic<S: Scalar>(a: &Matrix<S>) -> Vec<S> {
    let n = a.len();
    let mut coefficients = alloc::vec![S::zero(); n + 1];
    coefficients[n] = S::one();
    let mut m: Matrix<S> = alloc::vec![alloc::vec![S::zero(); n]; n];
    for k in 1..=n {
        // M_k = A M_{k−1} + c_{n−k+1}, c_{n−k} = −tr(A M_k)/k.
        m = product(a, &m);
        for (i, row) in m.iter_mut().enumerate() {
            row[i] = row[i].clone() + coefficients[n - k + 1].clone();
        }
        let am = product(a, &m);
        let trace = am.iter().enumerate().fold(S::zero(), |sum, (i, row)| sum + row[i].clone());
        coefficients[n - k] = -trace / S::from_int(k as i64);
    }
    coefficients
}

/// All roots with their multiplicities, if all are rational; exact scalars only.
pub(crate) fn rational_roots<S: Scalar>(polynomial: &[S]) -> Option<Vec<(S, usize)>> {
    let mut roots = Vec::new();
    for (part, multiplicity) in square_free(polynomial) {
        let mut rest = part.clone();
        for [re, im] in numeric_roots(&floats(&part)) {
            if im.abs() > 1e-6 * (1.0 + re.abs()) {
                return None;
            }
            let root = convergents::<S>(re).into_iter().find(|x| value(&rest, x).is_zero())?;
            rest = deflated(&rest, &root);
            roots.push((root, multiplicity));
        }
    }
    Some(roots)
}

/// All roots as estimates, each as often as it occurs: [real, imaginary].
pub(crate) fn estimated_roots<S: Scalar>(polynomial: &[S], exact: bool) -> Vec<[f64; 2]> {
    if !exact {
        return numeric_roots(&floats(polynomial));
    }
    let parts = square_free(polynomial);
    let repeated = |(part, times): &(Vec<S>, usize)| {
        let roots = numeric_roots(&floats(part));
        roots.into_iter().flat_map(|root| core::iter::repeat_n(root, *times)).collect::<Vec<_>>()
    };
    parts.iter().flat_map(repeated).collect()
}

fn value<S: Scalar>(polynomial: &[S], x: &S) -> S {
    polynomial.iter().rev().fold(S::zero(), |sum, c| sum * x.clone() + c.clone())
}

/// The quotient by z − root.
fn deflated<S: Scalar>(polynomial: &[S], root: &S) -> Vec<S> {
    let mut carry = S::zero();
    let mut quotient: Vec<S> = Vec::with_capacity(polynomial.len());
    for c in polynomial.iter().rev() {
        carry = carry * root.clone() + c.clone();
        quotient.push(carry.clone());
    }
    quotient.pop();
    quotient.reverse();
    quotient
}

/// Parts with simple roots and the multiplicity of each: Yun's decomposition.
fn square_free<S: Scalar>(polynomial: &[S]) -> Vec<(Vec<S>, usize)> {
    let mut parts = Vec::new();
    let mut common = gcd(polynomial.to_vec(), derivative(polynomial));
    let mut rest = divide(polynomial, &common).0;
    let mut multiplicity = 1;
    while rest.len() > 1 {
        let deeper = gcd(rest.clone(), common.clone());
        let part = divide(&rest, &deeper).0;
        if part.len() > 1 {
            parts.push((part, multiplicity));
        }
        common = divide(&common, &deeper).0;
        rest = deeper;
        multiplicity += 1;
    }
    parts
}

fn derivative<S: Scalar>(polynomial: &[S]) -> Vec<S> {
    let term = |(k, c): (usize, &S)| S::from_int(k as i64) * c.clone();
    polynomial.iter().enumerate().skip(1).map(term).collect()
}

/// Quotient and remainder; the divisor's leading coefficient is not zero.
fn divide<S: Scalar>(dividend: &[S], divisor: &[S]) -> (Vec<S>, Vec<S>) {
    let (mut rest, mut quotient) = (dividend.to_vec(), Vec::new());
    while let (true, Some(top), Some(lead)) = (rest.len() >= divisor.len(), rest.last(), divisor.last()) {
        let factor = top.clone() / lead.clone();
        let shift = rest.len() - divisor.len();
        for (i, c) in divisor.iter().enumerate() {
            rest[shift + i] = rest[shift + i].clone() - factor.clone() * c.clone();
        }
        rest.pop();
        quotient.push(factor);
    }
    quotient.reverse();
    (quotient, trimmed(rest))
}

fn trimmed<S: Scalar>(mut polynomial: Vec<S>) -> Vec<S> {
    while polynomial.last().is_some_and(S::is_zero) {
        polynomial.pop();
    }
    polynomial
}

/// The monic greatest common divisor. Every remainder is made monic, which keeps its digits few.
fn gcd<S: Scalar>(a: Vec<S>, b: Vec<S>) -> Vec<S> {
    let (mut a, mut b) = (monic(trimmed(a)), monic(trimmed(b)));
    while !b.is_empty() {
        let rest = monic(divide(&a, &b).1);
        (a, b) = (b, rest);
    }
    a
}

/// The polynomial over its leading coefficient, which is not zero.
fn monic<S: Scalar>(polynomial: Vec<S>) -> Vec<S> {
    let lead = polynomial.last().cloned().unwrap_or_else(S::one);
    polynomial.into_iter().map(|c| c / lead.clone()).collect()
}

/// The continued-fraction convergents of a float, with denominators below 2³¹.
fn convergents<S: Scalar>(x: f64) -> Vec<S> {
    let mut found = Vec::new();
    let (mut before, mut now) = ((0i64, 1i64), (1i64, 0i64));
    let mut rest = x;
    for _ in 0..40 {
        let whole = libm::floor(rest);
        if whole.abs() > 1e9 {
            break;
        }
        let whole_part = whole as i64;
        let next = (whole_part * now.0 + before.0, whole_part * now.1 + before.1);
        if next.0.abs() >= 1 << 31 || next.1.abs() >= 1 << 31 {
            break;
        }
        (before, now) = (now, next);
        found.push(S::from_int(now.0) / S::from_int(now.1));
        let fraction = rest - whole;
        if fraction < 1e-12 {
            break;
        }
        rest = 1.0 / fraction;
    }
    found
}

/// The coefficients as floats.
fn floats<S: Scalar>(polynomial: &[S]) -> Vec<f64> {
    polynomial.iter().map(nearby_float).collect()
}

/// A float within one unit of the last place, by comparisons only; infinite beyond the range.
pub(crate) fn nearby_float<S: Scalar>(x: &S) -> f64 {
    let (two, one) = (S::from_int(2), S::one());
    let mut rest = magnitude(x);
    if rest.is_zero() {
        return 0.0;
    }
    let mut exponent = 0;
    while rest >= two {
        rest = rest / two.clone();
        exponent += 1;
        if exponent > 1100 {
            return if *x < S::zero() { f64::NEG_INFINITY } else { f64::INFINITY };
        }
    }
    while rest < one {
        rest = rest * two.clone();
        exponent -= 1;
        if exponent < -1100 {
            return 0.0;
        }
    }
    let mut bits = 0u64;
    for _ in 0..60 {
        bits <<= 1;
        if rest >= one {
            bits |= 1;
            rest = rest - one.clone();
        }
        rest = rest * two.clone();
    }
    let size = libm::ldexp(bits as f64, exponent - 59);
    if *x < S::zero() { -size } else { size }
}

/// All complex roots of a polynomial with non-zero leading coefficient, by the iteration of Durand and Kerner.
fn numeric_roots(polynomial: &[f64]) -> Vec<[f64; 2]> {
    let n = polynomial.len().saturating_sub(1);
    let Some(lead) = polynomial.last() else { return Vec::new() };
    let monic: Vec<f64> = polynomial.iter().map(|c| c / lead).collect();
    let times = |a: [f64; 2], b: [f64; 2]| [a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]];
    let over = |a: [f64; 2], b: [f64; 2]| {
        let size = b[0] * b[0] + b[1] * b[1];
        let [re, im] = times(a, [b[0], -b[1]]);
        [re / size, im / size]
    };
    let radius = 1.0 + monic[..n].iter().fold(0.0, |most: f64, c| if c.abs() > most { c.abs() } else { most });
    let mut start = [1.0, 0.0];
    let mut roots: Vec<[f64; 2]> = (0..n)
        .map(|_| {
            start = times(start, [0.4, 0.9]);
            [start[0] * radius, start[1] * radius]
        })
        .collect();
    for _ in 0..1000 {
        let mut moved = 0.0;
        for i in 0..n {
            let root = roots[i];
            let value = monic.iter().rev().fold([0.0, 0.0], |sum, c| {
                let [re, im] = times(sum, root);
                [re + c, im]
            });
            let apart = roots
                .iter()
                .enumerate()
                .filter(|(j, _)| *j != i)
                .fold([1.0, 0.0], |product, (_, other)| times(product, [root[0] - other[0], root[1] - other[1]]));
            let step = over(value, apart);
            if !(step[0].is_finite() && step[1].is_finite()) {
                continue;
            }
            roots[i] = [root[0] - step[0], root[1] - step[1]];
            moved += step[0].abs() + step[1].abs();
        }
        if moved < 1e-17 * n as f64 {
            break;
        }
    }
    roots
}
