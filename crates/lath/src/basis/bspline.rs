//! The B-splines that are not zero at a parameter, their derivatives, and the evaluation of one span.
//!
//! *Source.* C. de Boor, On calculating with B-splines (1972) and M. Cox (1972) for the recurrence;
//! de Boor, A Practical Guide to Splines (1978), ch. X, eq. (4) for values and (10) for derivatives.

use crate::basis::scratch::Scratch;
use crate::knot::Knots;
use crate::num::Scalar;
use crate::space::Vector;
use alloc::vec::Vec;

/// The p + 1 B-splines N_{span−p} … N_{span} at t, where `span` comes from [`Knots::span`].
///
/// The recurrence N_{i,r} = (t−tᵢ)/(t_{i+r}−tᵢ) N_{i,r−1} + (t_{i+r+1}−t)/(t_{i+r+1}−t_{i+1}) N_{i+1,r−1} is carried out for
/// the functions that live on the span only, so that no 0/0 can occur. For t outside the span it extends the polynomials.
///
/// *Cost.* O(p²). *Error.* At most 3p u relative for t inside the span: sums of non-negative numbers only.
///
/// ```
/// use lath::{basis::bspline::values, knot::{Knots, Side}};
///
/// let knots = Knots::<f64>::uniform(4, 3)?;
/// let span = knots.span(&0.0, Side::Right);
/// assert_eq!(values(&knots, span, &0.0), [1.0 / 6.0, 2.0 / 3.0, 1.0 / 6.0, 0.0]);
/// # Ok::<(), lath::error::Error>(())
/// ```
pub fn values<S: Scalar>(knots: &Knots<S>, span: usize, t: &S) -> Vec<S> {
    values_of_degree(knots.values(), span, knots.degree(), t)
}

/// The r + 1 B-splines of degree r ≤ p over the same knots that are not zero on the span.
fn values_of_degree<S: Scalar>(knots: &[S], span: usize, degree: usize, t: &S) -> Vec<S> {
    let mut out = alloc::vec![S::zero(); degree + 1];
    values_into(knots, span, t, &mut out);
    out
}

/// The same into `out`, whose length is the degree and one.
pub(crate) fn values_into<S: Scalar>(knots: &[S], span: usize, t: &S, out: &mut [S]) {
    let Some(first) = out.first_mut() else { return };
    *first = S::one();
    for r in 1..out.len() {
        // out holds N_{span−r+1, r−1} … N_{span, r−1}; the first and last of degree r have one share only.
        let mut carry = S::zero();
        for (j, value) in out[..r].iter_mut().enumerate() {
            let i = span + 1 + j - r; // this function is N_{i, r−1}, living on [t_i, t_{i+r}]
            // Ratios of lengths, which neither overflow nor vanish however close or far the knots.
            let (falling, rising) = S::weights(&knots[i], &knots[i + r], t);
            let rising = rising * value.clone();
            *value = falling * value.clone() + carry;
            carry = rising;
        }
        out[r] = carry;
    }
}

/// Values and derivatives up to `order` of the p + 1 B-splines of a span: `[k][j]` is the k-th derivative of N_{span−p+j}.
///
/// The k-th derivative starts from the values of degree p − k and climbs k times by
/// N′_{i,r} = r/(t_{i+r}−tᵢ) N_{i,r−1} − r/(t_{i+r+1}−t_{i+1}) N_{i+1,r−1}.
///
/// *Cost.* O(order · p²). Orders above p are zero.
///
/// ```
/// use lath::{basis::bspline::derivatives, knot::{Knots, Side}};
///
/// let knots = Knots::<f64>::uniform(4, 3)?;
/// let rows = derivatives(&knots, knots.span(&0.0, Side::Right), &0.0, 2);
/// assert_eq!(rows[1], [-0.5, 0.0, 0.5, 0.0]);
/// assert_eq!(rows[2], [1.0, -2.0, 1.0, 0.0]);
/// # Ok::<(), lath::error::Error>(())
/// ```
pub fn derivatives<S: Scalar>(knots: &Knots<S>, span: usize, t: &S, order: usize) -> Vec<Vec<S>> {
    let (t_, p) = (knots.values(), knots.degree());
    let row = |k: usize| {
        if k > p {
            return alloc::vec![S::zero(); p + 1];
        }
        let mut out = values_of_degree(t_, span, p - k, t);
        for r in p - k + 1..=p {
            let mut carry = S::zero();
            for (j, value) in out.iter_mut().enumerate() {
                let i = span + 1 + j - r;
                let slope = S::from_int(r as i64) * value.clone() / (t_[i + r].clone() - t_[i].clone());
                *value = carry - slope.clone();
                carry = slope;
            }
            out.push(carry);
        }
        out
    };
    (0..=order).map(row).collect()
}

/// Value and derivatives at t of the spline whose p + 1 control points on `span` are `points` (P_{span−p} … P_span):
/// `out[k]` receives the k-th derivative.
///
/// Differences first, Qᵢ = r (P_{i+1} − Pᵢ)/(t_{i+r+1} − t_{i+1}), then de Boor's triangle of degree p − k.
///
/// *Cost.* O(p²) for each order. *Error.* E ≤ 3p for values, 3(p − k) + 4k for the k-th derivative, for t inside the span:
/// a weight, a product and a sum for each level, four roundings for each difference.
/// Orders above p are zero. `points` must hold p + 1 points; missing ones count as absent and the answer is zero.
pub fn jet<S: Scalar, V: Vector<S>>(knots: &Knots<S>, span: usize, points: &[V], t: &S, out: &mut [V]) {
    let (t_, p) = (knots.values(), knots.degree());
    if let ([value], true) = (&mut *out, points.len() == p + 1) {
        *value = match p {
            1 => de_boor_fixed::<2, S, V>(t_, span, points, t),
            2 => de_boor_fixed::<3, S, V>(t_, span, points, t),
            3 => de_boor_fixed::<4, S, V>(t_, span, points, t),
            4 => de_boor_fixed::<5, S, V>(t_, span, points, t),
            5 => de_boor_fixed::<6, S, V>(t_, span, points, t),
            _ => de_boor(t_, span, Scratch::of(points).points(), t),
        };
        return;
    }
    let mut differences = Scratch::of(points);
    let last = out.len().saturating_sub(1);
    for (k, slot) in out.iter_mut().enumerate() {
        if k > p || points.len() != p + 1 {
            *slot = V::zero();
            continue;
        }
        if k > 0 {
            let degree = p + 1 - k; // of the derivative before this one
            let row = differences.points();
            for j in 0..degree {
                let i = span - degree + 1 + j; // the difference lives on [t_i, t_{i+degree}]
                let mut step = row[j + 1].clone();
                step.add_scaled(&-S::one(), &row[j]);
                step.scale(&(S::from_int(degree as i64) / (t_[i + degree].clone() - t_[i].clone())));
                row[j] = step;
            }
            differences.shorten(degree);
        }
        *slot = if k == last {
            de_boor(t_, span, differences.points(), t)
        } else {
            de_boor(t_, span, differences.clone().points(), t)
        };
    }
}

/// [`de_boor`] on a copy of N points, N known when compiling: the same operations in the same order, unrolled.
fn de_boor_fixed<const N: usize, S: Scalar, V: Vector<S>>(knots: &[S], span: usize, points: &[V], t: &S) -> V {
    let mut copy: [V; N] = core::array::from_fn(|j| points[j].clone());
    de_boor(knots, span, &mut copy, t)
}

/// de Boor's triangle on the r + 1 points of a span, degree r; overwrites them.
#[inline(always)]
fn de_boor<S: Scalar, V: Vector<S>>(knots: &[S], span: usize, points: &mut [V], t: &S) -> V {
    let degree = points.len() - 1;
    for level in (1..=degree).rev() {
        for j in 0..level {
            // The blend lives on [t_i, t_{i+level}], which contains the span.
            let i = span + 1 + j - level;
            let (complement, weight) = S::weights(&knots[i], &knots[i + level], t);
            points[j] = points[j].blend(&complement, &points[j + 1], &weight);
        }
    }
    points[0].clone()
}
