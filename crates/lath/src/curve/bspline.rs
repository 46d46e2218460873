//! B-spline curves of any degree over any knots, open and closed.

use crate::basis::{blossom, bspline};
use crate::curve::interval::Interval;
use crate::curve::protocol::{BezierPiece, Curve};
use crate::error::{Code, Error, Result};
use crate::knot::{Knots, Side, check_count, check_degree, check_period};
use crate::space::{IntoPoint, collect};
use alloc::borrow::Cow;
use alloc::vec::Vec;

/// A B-spline curve P(t) = Σ Pᵢ N_{i,p}(t) on [t_p, t_n].
///
/// *Invariance:* affine. Each span lies in the convex hull of its p + 1 control points.
///
/// *Open, clamped, half-clamped:* whatever the [`Knots`] say. *Closed:* n control points, the first p of them used again
/// at the end, over n + 1 knots of one period; the seam is as smooth as any other knot.
///
/// *Cost.* O(log n + p²) an evaluation. *Error.* E ≤ 3(p + 1) for values, 10p for derivatives, inside the domain.
///
/// *Degenerate input.* Degree 0 is piecewise constant; a knot of multiplicity p + 1 breaks the curve in two, and both
/// sides of the break can be asked for.
///
/// *Source.* C. de Boor, A Practical Guide to Splines (1978).
///
/// ```
/// use lath::curve::{BSpline, Curve};
/// use lath::knot::Knots;
///
/// // A closed cubic that touches the unit circle at its four joints.
/// let curve = BSpline::closed_uniform(3, [[0.0, -1.5], [1.5, 0.0], [0.0, 1.5], [-1.5, 0.0]])?;
/// assert_eq!(curve.eval(0.0)?, [1.0, 0.0]);
/// assert_eq!(curve.eval(1.0)?, [0.0, 1.0]);
///
/// let knots = Knots::new(vec![0.0, 0.0, 0.0, 1.0, 2.0, 2.0, 2.0], 2)?;
/// let curve = BSpline::new(knots, [[0.0], [1.0], [1.0], [0.0]])?;
/// assert_eq!(curve.eval(1.0)?, [1.0]);
/// # Ok::<(), lath::error::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct BSpline<const D: usize> {
    /// Extended over the period's ends for a closed curve.
    knots: Knots,
    /// Never repeated: a closed curve takes them modulo their number.
    points: Vec<[f64; D]>,
    closed: bool,
}

impl<const D: usize> BSpline<D> {
    /// The open curve of these control points over these knots.
    ///
    /// # Errors
    /// K001 if there are not as many points as functions; P002 and P003 for coordinates.
    pub fn new(knots: Knots, points: impl IntoIterator<Item = impl IntoPoint<D>>) -> Result<BSpline<D>> {
        let points = collect(points)?;
        knots.check_points(points.len())?;
        Ok(BSpline { knots, points, closed: false })
    }

    /// The open curve of this degree over these knots: [`BSpline::new`] for knots that were not checked yet. The number of
    /// knots is held against the points first, so that another convention is recognised.
    ///
    /// ```
    /// use lath::curve::BSpline;
    ///
    /// // Two knots fewer: the first and last are taken as superfluous elsewhere.
    /// let error = BSpline::over(vec![0.0, 0.0, 0.0, 1.0, 1.0, 1.0], 3, [[0.0], [1.0], [2.0], [3.0]]).unwrap_err();
    /// assert!(error.message().contains("repeat both"));
    /// ```
    ///
    /// # Errors
    /// As [`BSpline::new`] and [`Knots::new`].
    pub fn over(
        knots: Vec<f64>,
        degree: usize,
        points: impl IntoIterator<Item = impl IntoPoint<D>>,
    ) -> Result<BSpline<D>> {
        let points = collect(points)?;
        check_degree(degree)?;
        check_count(knots.len(), degree, points.len())?;
        BSpline::new(Knots::new(knots, degree)?, points)
    }

    /// The closed curve of n control points over n + 1 knots of one period; `t = period[0]` is the first joint, for cubics
    /// (P₀ + 4P₁ + P₂)/6 over uniform knots.
    ///
    /// # Errors
    /// K001 if there are not n + 1 knots; otherwise as [`Knots::periodic`] and [`BSpline::new`].
    pub fn closed(
        period: &[f64],
        degree: usize,
        points: impl IntoIterator<Item = impl IntoPoint<D>>,
    ) -> Result<BSpline<D>> {
        let points = collect(points)?;
        check_period(period.len(), points.len())?;
        Ok(BSpline { knots: Knots::periodic(period, degree)?, points, closed: true })
    }

    /// The open curve over uniform knots with unit spans, domain [0, n − p].
    ///
    /// # Errors
    /// P001 for fewer than p + 1 points; K006, P002, P003.
    pub fn uniform(degree: usize, points: impl IntoIterator<Item = impl IntoPoint<D>>) -> Result<BSpline<D>> {
        let points = collect(points)?;
        BSpline::new(Knots::uniform(points.len(), degree)?, points)
    }

    /// The open curve over clamped knots with unit spans, domain [0, n − p].
    ///
    /// # Errors
    /// As [`BSpline::uniform`].
    pub fn clamped(degree: usize, points: impl IntoIterator<Item = impl IntoPoint<D>>) -> Result<BSpline<D>> {
        let points = collect(points)?;
        BSpline::new(Knots::clamped(points.len(), degree)?, points)
    }

    /// The closed curve over uniform knots with unit spans, domain [0, n].
    ///
    /// # Errors
    /// P001 for no points; K006, P002, P003.
    pub fn closed_uniform(degree: usize, points: impl IntoIterator<Item = impl IntoPoint<D>>) -> Result<BSpline<D>> {
        let points = collect(points)?;
        if points.is_empty() {
            return Err(Error::new(Code::P001, "0 points; a closed B-spline takes at least 1"));
        }
        let period: Vec<f64> = (0..=points.len()).map(|i| i as f64).collect();
        BSpline::closed(&period, degree, points)
    }

    /// The knots; of a closed curve, one period extended by p knots on both sides.
    pub fn knots(&self) -> &Knots {
        &self.knots
    }

    /// The n + 1 knots of one period, if the curve is closed.
    pub fn period(&self) -> Option<&[f64]> {
        let p = self.knots.degree();
        self.closed.then(|| &self.knots.values()[p..=p + self.points.len()])
    }

    /// The control points, each once.
    pub fn control_points(&self) -> &[[f64; D]] {
        &self.points
    }

    /// The p + 1 control points of a span; copied only where they pass the seam of a closed curve.
    fn local_points(&self, span: usize) -> Cow<'_, [[f64; D]]> {
        local(&self.points, span, self.knots.degree())
    }
}

/// The p + 1 items of a span; copied only where they pass the seam of a closed curve.
pub(crate) fn local<T: Copy>(items: &[T], span: usize, degree: usize) -> Cow<'_, [T]> {
    let first = span - degree;
    match items.get(first..=span) {
        Some(items) => Cow::Borrowed(items),
        None => Cow::Owned((first..=span).map(|i| items[i % items.len()]).collect()),
    }
}

impl<const D: usize> Curve<D> for BSpline<D> {
    fn kind(&self) -> &'static str {
        "bspline"
    }

    fn degree(&self) -> usize {
        self.knots.degree()
    }

    fn domain(&self) -> Interval {
        let (start, end) = self.knots.domain();
        Interval { start, end }
    }

    fn jet_into(&self, t: f64, side: Side, out: &mut [[f64; D]]) {
        let span = self.knots.span(&t, side);
        bspline::jet(&self.knots, span, &self.local_points(span), &t, out);
    }

    fn breaks(&self) -> Vec<f64> {
        self.knots.breaks()
    }

    fn is_closed(&self) -> bool {
        self.closed
    }

    fn bezier_pieces(&self, visit: &mut dyn FnMut(BezierPiece<'_, D>)) -> bool {
        let (t_, p) = (self.knots.values(), self.knots.degree());
        for span in (p..self.knots.functions()).filter(|&i| t_[i] < t_[i + 1]) {
            let points = blossom::span_to_bernstein(&self.knots, span, &self.local_points(span));
            visit(BezierPiece { start: t_[span], end: t_[span + 1], points: &points });
        }
        true
    }
}
