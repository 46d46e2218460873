//! The blossom, or polar form: the one symmetric function of n arguments, affine in each, that agrees with the
//! polynomial where all arguments agree.
//!
//! Control points are values of the blossom: b(a,…,a, b,…,b) for a Bézier segment on [a, b], b(t_{i+1}, …, t_{i+p}) for
//! B-splines. de Casteljau's and de Boor's triangles compute b(t, …, t); with different arguments in each round they
//! compute splits, knot insertions and changes of interval.
//!
//! *Source.* L. Ramshaw, Blossoming: a connect-the-dots approach to splines (1987); H.-P. Seidel 1989.

use crate::basis::bernstein::weights;
use crate::knot::Knots;
use crate::num::Scalar;
use crate::space::Vector;
use alloc::vec::Vec;

/// The blossom of the Bézier segment `points` on [a, b] at the given arguments, one for each degree.
/// Arguments beyond the degree are ignored; no points give zero.
///
/// ```
/// use lath::basis::blossom::bezier;
///
/// let points = [[1.0], [4.0], [9.0]];
/// assert_eq!(bezier(&points, &0.0, &1.0, &[0.0, 1.0]), [4.0]); // the middle control point
/// ```
pub fn bezier<S: Scalar, V: Vector<S>>(points: &[V], a: &S, b: &S, arguments: &[S]) -> V {
    let mut points = points.to_vec();
    let mut rest = points.len();
    for t in arguments.iter().take(points.len().saturating_sub(1)) {
        rest -= 1;
        let (complement, u) = weights(a, b, t);
        for i in 0..rest {
            points[i] = points[i].blend(&complement, &points[i + 1], &u);
        }
    }
    points.first().map_or_else(V::zero, V::clone)
}

/// The blossom of the polynomial of one span of a spline, `points` being its p + 1 control points on that span.
///
/// ```
/// use lath::{basis::blossom::bspline, knot::{Knots, Side}};
///
/// // The control points of a span are its blossom at consecutive knots.
/// let knots = Knots::<f64>::uniform(4, 3)?;
/// let span = knots.span(&0.5, Side::Right);
/// let points = [[1.0], [7.0], [2.0], [8.0]];
/// assert_eq!(bspline(&knots, span, &points, &[-1.0, 0.0, 1.0]), [7.0]);
/// # Ok::<(), lath::error::Error>(())
/// ```
pub fn bspline<S: Scalar, V: Vector<S>>(knots: &Knots<S>, span: usize, points: &[V], arguments: &[S]) -> V {
    let (t_, degree) = (knots.values(), knots.degree());
    let mut points: Vec<V> = points.to_vec();
    let mut level = degree;
    for t in arguments.iter().take(degree.min(points.len().saturating_sub(1))) {
        for j in 0..level {
            let i = span + 1 + j - level;
            let (complement, u) = weights(&t_[i], &t_[i + level], t);
            points[j] = points[j].blend(&complement, &points[j + 1], &u);
        }
        level -= 1;
    }
    points.first().map_or_else(V::zero, V::clone)
}

/// The Bernstein points of one span over [tᵢ, tᵢ₊₁], i = `span`: point j is the blossom at p − j times the left end and j
/// times the right end.
///
/// *Cost.* O(p²) blends. *Error.* Every blend is a convex combination. Another number of points than p + 1 gives them back.
///
/// ```
/// use lath::{basis::blossom::span_to_bernstein, knot::{Knots, Side}};
///
/// let knots = Knots::<f64>::uniform(3, 2)?;
/// let span = knots.span(&0.5, Side::Right);
/// assert_eq!(span_to_bernstein(&knots, span, &[[0.0], [2.0], [6.0]]), [[1.0], [2.0], [4.0]]);
/// # Ok::<(), lath::error::Error>(())
/// ```
pub fn span_to_bernstein<S: Scalar, V: Vector<S>>(knots: &Knots<S>, span: usize, points: &[V]) -> Vec<V> {
    let (t_, p) = (knots.values(), knots.degree());
    let mut row = points.to_vec();
    if row.len() != p + 1 {
        return row;
    }
    let (a, b) = (&t_[span], &t_[span + 1]);
    // de Boor's triangle at the left end leaves its right edge: row[j] = blossom(a p−j times, t_{span+1} … t_{span+j}).
    for level in (1..=p).rev() {
        for j in 0..level {
            let i = span + 1 + j - level;
            let (complement, u) = weights(&t_[i], &t_[i + level], a);
            row[j] = row[j].blend(&complement, &row[j + 1], &u);
        }
    }
    // Then the knots right of the span are replaced by its right end, one more in each round.
    for round in 1..p {
        for j in (round + 1..=p).rev() {
            let (complement, u) = weights(a, &t_[span + j + 1 - round], b);
            row[j] = row[j - 1].blend(&complement, &row[j], &u);
        }
    }
    row
}
