//! Uniform B-splines as a family of their own: segments by one matrix, no knots.

use crate::basis::bernstein::weights;
use crate::basis::uniform::UniformBasis;
use crate::curve::bspline::BSpline;
use crate::curve::interval::Interval;
use crate::curve::protocol::{BezierPiece, Curve};
use crate::error::{Code, Count, Error, Result};
use crate::knot::Side;
use crate::space::{IntoPoint, check_point, collect};
use alloc::borrow::Cow;
use alloc::format;
use alloc::vec::Vec;

/// A uniform B-spline of degree p ≤ 30: n control points make n − p segments, each of p + 1 neighbours, over unit spans from t = 0;
/// closed they make n segments.
///
/// It is the curve of [`BSpline::uniform`] and [`BSpline::closed_uniform`], evaluated by the matrix of
/// [`UniformBasis`](crate::basis::uniform::UniformBasis) instead of by knots: exactly the same over fractions, within the error below on
/// floats. In files it is a `bspline` without knots, and reads back as a [`BSpline`].
///
/// *Invariance:* affine. Each segment lies in the convex hull of its p + 1 control points.
///
/// *Ends.* The open curve starts and ends inside its polygon, in the first and last [joint](UniformBSpline::joint);
/// [`at_polygon`](UniformBSpline::at_polygon) leads it to the polygon's ends. *Multiple points:* a point given m times pulls: once more lowers
/// the curve's distance, p times in all make the curve pass through it, between straight pieces.
///
/// *Cost.* O(p²) an evaluation, without a search. *Error.* E ≤ 3(p + 1) for values, 10p for derivatives, inside the domain.
///
/// *Degenerate input.* Degree 0 is piecewise constant, degree 1 the polygon. Equal points are allowed.
///
/// *Source.* I. Schoenberg (1946); as matrices D. Salomon, Curves and Surfaces for Computer Graphics (2006), §4.15.
///
/// ```
/// use lath::curve::{Curve, UniformBSpline};
///
/// // A closed cubic that touches the unit circle at its four joints.
/// let curve = UniformBSpline::closed(3, [[0.0, -1.5], [1.5, 0.0], [0.0, 1.5], [-1.5, 0.0]])?;
/// assert_eq!(curve.joint(0)?, [1.0, 0.0]);
/// let middle = curve.eval(0.5)?;
/// assert!((lath::space::norm(&middle) - 33.0 * 2.0_f64.sqrt() / 48.0).abs() < 1e-15);
/// # Ok::<(), lath::error::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct UniformBSpline<const D: usize> {
    basis: UniformBasis,
    /// Never repeated: a closed curve takes them modulo their number.
    points: Vec<[f64; D]>,
    closed: bool,
}

/// How an open uniform B-spline reaches the ends of its polygon.
///
/// | | points added at each end, degree p | first segment | derivatives at the end |
/// |---|---|---|---|
/// | `Repeat` | p − 1 times P₀ | P₀ + uᵖ/p! (P₁ − P₀), straight | orders 1 … p − 1 are zero |
/// | `Phantom` | ⌊p/2⌋ mirror images | as elsewhere | even orders below p are zero |
///
/// Both give the end the curvature 0. Repeated, the curve also stops there for a moment, and runs along the polygon's first side. With phantom points
/// it starts with a speed, (P₁ − P₀) for cubics, where the degree is 3 or above; the speed of degree 2 is zero, for it has room for
/// one condition only: its phantom point is P₀ itself, the same as repeating it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum PolygonEnd {
    /// The end point p times in all.
    Repeat,
    /// The polygon continued by its mirror image in the end point, x ↦ 2P₀ − x: for odd degrees P₋ₖ = 2P₀ − Pₖ (2P₀ − P₁ for cubics); for even
    /// degrees, whose joints lie at the middles of sides, the end point is mirrored too and counts twice, P₋ₖ = 2P₀ − Pₖ₋₁.
    ///
    /// The extended polygon is odd about P₀, and so is the curve, f(−t) = 2P₀ − f(t): it passes through P₀, and its even derivatives vanish
    /// there as far as they are continuous.
    Phantom,
}

impl<const D: usize> UniformBSpline<D> {
    /// The open curve of these control points, domain [0, n − p].
    ///
    /// # Errors
    /// K006 above degree 30; P001 for fewer than p + 1 points; P002 and P003 for coordinates.
    pub fn new(degree: usize, points: impl IntoIterator<Item = impl IntoPoint<D>>) -> Result<UniformBSpline<D>> {
        let (basis, points) = (UniformBasis::new(degree)?, collect(points)?);
        if points.len() <= degree {
            let message =
                format!("{} for degree {degree}, which takes at least {}", Count(points.len(), "point"), degree + 1);
            return Err(Error::new(Code::P001, message));
        }
        Ok(UniformBSpline { basis, points, closed: false })
    }

    /// The closed curve of n control points, domain [0, n]; t = 0 is the first joint, for cubics (P₀ + 4P₁ + P₂)/6. There may be fewer
    /// points than the degree: they are counted around.
    ///
    /// # Errors
    /// K006 above degree 30; P001 for no points; P002 and P003 for coordinates.
    pub fn closed(degree: usize, points: impl IntoIterator<Item = impl IntoPoint<D>>) -> Result<UniformBSpline<D>> {
        let (basis, points) = (UniformBasis::new(degree)?, collect(points)?);
        if points.is_empty() {
            return Err(Error::new(Code::P001, "0 points; a closed B-spline takes at least 1"));
        }
        Ok(UniformBSpline { basis, points, closed: true })
    }

    /// The open curve that starts in the first and ends in the last of these points, by points added at both ends; they become
    /// control points.
    ///
    /// ```
    /// use lath::curve::{Curve, PolygonEnd, UniformBSpline};
    ///
    /// let polygon = [[0.0, 0.0], [1.0, 2.0], [3.0, 2.0], [4.0, 0.0]];
    /// let curve = UniformBSpline::at_polygon(3, polygon, PolygonEnd::Phantom)?;
    /// assert_eq!(curve.control_points()[0], [-1.0, -2.0]); // 2P₀ − P₁
    /// // From P₀ on with the speed P₁ − P₀, and not bent.
    /// assert_eq!(curve.jet(0.0, 2)?, [[0.0, 0.0], [1.0, 2.0], [0.0, 0.0]]);
    /// # Ok::<(), lath::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`UniformBSpline::new`]; P001 also for fewer points than are to be mirrored, ⌊p/2⌋ + 1 for odd and p/2 for even degrees; P003
    /// for a mirror image out of scale.
    pub fn at_polygon(
        degree: usize,
        points: impl IntoIterator<Item = impl IntoPoint<D>>,
        end: PolygonEnd,
    ) -> Result<UniformBSpline<D>> {
        let points = collect(points)?;
        let n = points.len();
        let added = match end {
            PolygonEnd::Repeat => degree.saturating_sub(1),
            PolygonEnd::Phantom => degree / 2,
        };
        // The first point that is mirrored: P₁ for odd degrees, P₀ itself for even ones.
        let skipped = degree % 2;
        let least = if end == PolygonEnd::Phantom { (added + skipped).max(1) } else { 1 };
        if n < least {
            let message = format!("{} for phantom ends of degree {degree}, which mirror {least}", Count(n, "point"));
            return Err(Error::new(Code::P001, message));
        }
        // Point k before the first, seen from either end.
        let outside = |from: &dyn Fn(usize) -> [f64; D], k: usize| -> [f64; D] {
            let first = from(0);
            match end {
                PolygonEnd::Repeat => first,
                PolygonEnd::Phantom => {
                    let mirrored = from(k + skipped);
                    core::array::from_fn(|c| first[c] + (first[c] - mirrored[c]))
                }
            }
        };
        let (front, back) = (|k: usize| points[k], |k: usize| points[n - 1 - k]);
        let mut all: Vec<[f64; D]> = (0..added).rev().map(|k| outside(&front, k)).collect();
        all.extend_from_slice(&points);
        all.extend((0..added).map(|k| outside(&back, k)));
        for k in 0..added {
            check_point(k, &all[k])?;
            check_point(n - 1, &all[added + n + k])?;
        }
        UniformBSpline::new(degree, all)
    }

    /// The same curve over knots: [`BSpline::uniform`] or [`BSpline::closed_uniform`] of the same control points.
    ///
    /// # Errors
    /// None that the curve itself has not met already.
    pub fn to_bspline(&self) -> Result<BSpline<D>> {
        let make = if self.closed { BSpline::closed_uniform } else { BSpline::uniform };
        make(self.basis.degree(), &self.points)
    }

    /// The matrices of its segments.
    pub fn basis(&self) -> &UniformBasis {
        &self.basis
    }

    /// The control points, each once; of [`UniformBSpline::at_polygon`] with those that were added.
    pub fn control_points(&self) -> &[[f64; D]] {
        &self.points
    }

    /// The number of segments: n − p, closed n.
    pub fn segments(&self) -> usize {
        if self.closed { self.points.len() } else { self.points.len() - self.basis.degree() }
    }

    /// The point at t = i, where segments join: for cubics (Pᵢ + 4Pᵢ₊₁ + Pᵢ₊₂)/6, for every degree the weighted mean of p neighbours by
    /// [`UniformBasis::joint`](crate::basis::uniform::UniformBasis::joint). There are as many as segments, and one more, which closes a closed curve.
    ///
    /// # Errors
    /// T002 for an index beyond the last joint.
    pub fn joint(&self, index: usize) -> Result<[f64; D]> {
        if index > self.segments() {
            let message = format!("joint {index} of a curve whose last one is {}", self.segments());
            return Err(Error::new(Code::T002, message).at(index));
        }
        self.eval(index as f64)
    }

    /// The p + 1 control points of a segment; copied only where they pass the seam of a closed curve.
    pub(crate) fn local_points(&self, segment: usize) -> Cow<'_, [[f64; D]]> {
        let (last, n) = (segment + self.basis.degree(), self.points.len());
        match self.points.get(segment..=last) {
            Some(points) => Cow::Borrowed(points),
            None => Cow::Owned((segment..=last).map(|i| self.points[i % n]).collect()),
        }
    }

    /// The segment that answers for t.
    fn segment(&self, t: f64, side: Side) -> usize {
        let whole = libm::floor(t);
        // Saturates on both sides, and takes NaN to 0.
        let below = whole as usize;
        let from_left = side == Side::Left && whole == t;
        below.saturating_sub(usize::from(from_left)).min(self.segments() - 1)
    }
}

impl<const D: usize> Curve<D> for UniformBSpline<D> {
    /// The kind in files is that of all B-splines.
    fn kind(&self) -> &'static str {
        "bspline"
    }

    fn degree(&self) -> usize {
        self.basis.degree()
    }

    fn domain(&self) -> Interval {
        Interval { start: 0.0, end: self.segments() as f64 }
    }

    fn jet_into(&self, t: f64, side: Side, out: &mut [[f64; D]]) {
        let i = self.segment(t, side);
        let (complement, u) = weights(&(i as f64), &((i + 1) as f64), &t);
        self.basis.jet(&self.local_points(i), (&complement, &u), out);
    }

    fn breaks(&self) -> Vec<f64> {
        (0..=self.segments()).map(|i| i as f64).collect()
    }

    fn is_closed(&self) -> bool {
        self.closed
    }

    fn bezier_pieces(&self, visit: &mut dyn FnMut(BezierPiece<'_, D>)) -> bool {
        for i in 0..self.segments() {
            let points = self.basis.bernstein_points(&self.local_points(i));
            visit(BezierPiece { start: i as f64, end: (i + 1) as f64, points: &points });
        }
        true
    }
}
