//! Rational B-splines: NURBS.

use crate::basis::rational::Functions;
use crate::curve::bspline::{BSpline, local};
use crate::curve::denominator::{self, PoleSearch};
use crate::curve::interval::Interval;
use crate::curve::protocol::{Curve, RationalPiece};
use crate::error::Result;
use crate::knot::{Knots, Side};
use crate::space::{Homogeneous, IntoPoint};
use alloc::vec::Vec;

/// A rational B-spline curve P(t) = Σ wᵢ Pᵢ N_{i,p}(t) / Σ wᵢ N_{i,p}(t) on [t_p, t_n]: a NURBS curve.
///
/// *Shape.* Control points are Cartesian, never multiplied by their weights, and kept to the bit. A common factor of all weights
/// changes nothing; with equal weights the curve is the [`BSpline`] of its points, and still rational.
///
/// *Invariance:* projective. With positive weights each span lies in the convex hull of its p + 1 control points.
///
/// *Cost.* O(log n + p²) an evaluation.
///
/// *Error.* Inside the domain E ≤ 3(p + 1) for values, with the condition K = Σ |wᵢ|(|Pᵢ| + |P(t)|)|Nᵢ| / |Σ wᵢNᵢ|, and E ≤ 10p for first
/// derivatives, with what N′ᵢ adds up in place of |Nᵢ| and K in place of |P(t)|: measured to degree 8, not proven. The worst values known, 20 at
/// degree 8, are found where all wᵢNᵢ are of one size and one point is far greater than the sum. Proven for values and positive weights is
/// (p + 1)(p + 4.5), to first order; see [`rational_jet`](Functions::rational_jet). Where weights of one span differ by more than 2⁴⁰⁰, values keep
/// the bound; derivatives then come from the Bézier points of the span, and lose as many digits as it is shorter than its neighbours.
///
/// *Degenerate input.* Weights from 1e-300 to 1e300 may stand beside each other. Weights may be zero or negative as long as the
/// denominator is proven to stay above 2⁻⁴⁰ of the greatest weight nearby (above zero, if none is negative); a point of weight zero has no part in the curve.
///
/// *Source.* K. Versprille 1975; L. Piegl and W. Tiller, The NURBS Book (2nd ed. 1997), ch. 4.
///
/// ```
/// use lath::curve::{Curve, Nurbs};
/// use lath::knot::Knots;
///
/// // Half of the unit circle, as a rational quadratic of two spans.
/// let points = [[1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [-1.0, 1.0], [-1.0, 0.0]];
/// let knots = Knots::new(vec![0.0, 0.0, 0.0, 1.0, 1.0, 2.0, 2.0, 2.0], 2)?;
/// let half = Nurbs::new(knots, points, [1.0, 0.5_f64.sqrt(), 1.0, 0.5_f64.sqrt(), 1.0])?;
/// assert_eq!(half.eval(1.0)?, [0.0, 1.0]);
/// let [x, y] = half.eval(0.3)?;
/// assert!((x * x + y * y - 1.0).abs() < 1e-15);
/// # Ok::<(), lath::error::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Nurbs<const D: usize> {
    /// The knots and the points, as those of a polynomial curve.
    spline: BSpline<D>,
    /// One a point.
    weights: Vec<f64>,
    /// Whether all weights are positive and of ordinary size.
    plain: bool,
}

impl<const D: usize> BSpline<D> {
    /// The rational curve of these control points and knots with the given weights, one a point.
    ///
    /// ```
    /// use lath::curve::{BSpline, Curve};
    ///
    /// let curve = BSpline::clamped(1, [[0.0], [1.0]])?.weighted([1.0, 3.0])?;
    /// assert_eq!(curve.eval(0.5)?, [0.75]);
    /// # Ok::<(), lath::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// R001, R002 and R003 for the weights; R004 if the denominator may be zero somewhere in the domain, with the interval.
    pub fn weighted(self, weights: impl IntoIterator<Item = f64>) -> Result<Nurbs<D>> {
        let weights: Vec<f64> = weights.into_iter().collect();
        denominator::check_weights(&weights, self.control_points().len())?;
        let plain = denominator::are_plain(&weights);
        let curve = Nurbs { spline: self, weights, plain };
        if curve.weights.iter().any(|weight| *weight <= 0.0) {
            let mut search = PoleSearch::new();
            curve.spans().try_for_each(|span| curve.check_span(&mut search, span))?;
        }
        Ok(curve)
    }
}

impl<const D: usize> Nurbs<D> {
    /// The open curve of these control points with these weights over these knots.
    ///
    /// # Errors
    /// As [`BSpline::new`] and [`BSpline::weighted`].
    pub fn new(
        knots: Knots,
        points: impl IntoIterator<Item = impl IntoPoint<D>>,
        weights: impl IntoIterator<Item = f64>,
    ) -> Result<Nurbs<D>> {
        BSpline::new(knots, points)?.weighted(weights)
    }

    /// The same for knots that were not checked yet.
    ///
    /// # Errors
    /// As [`BSpline::over`] and [`BSpline::weighted`].
    pub fn over(
        knots: Vec<f64>,
        degree: usize,
        points: impl IntoIterator<Item = impl IntoPoint<D>>,
        weights: impl IntoIterator<Item = f64>,
    ) -> Result<Nurbs<D>> {
        BSpline::over(knots, degree, points)?.weighted(weights)
    }

    /// The closed curve of n control points and weights over n + 1 knots of one period.
    ///
    /// # Errors
    /// As [`BSpline::closed`] and [`BSpline::weighted`].
    pub fn closed(
        period: &[f64],
        degree: usize,
        points: impl IntoIterator<Item = impl IntoPoint<D>>,
        weights: impl IntoIterator<Item = f64>,
    ) -> Result<Nurbs<D>> {
        BSpline::closed(period, degree, points)?.weighted(weights)
    }

    /// The open curve of homogeneous control points.
    ///
    /// ```
    /// use lath::curve::Nurbs;
    /// use lath::knot::Knots;
    ///
    /// let curve = Nurbs::new(Knots::clamped(2, 1)?, [[1.0], [5.0]], [1.0, 0.5])?;
    /// assert_eq!(curve.homogeneous()[1].point, [2.5]);
    /// assert_eq!(Nurbs::from_homogeneous(curve.knots().clone(), &curve.homogeneous())?, curve);
    /// # Ok::<(), lath::error::Error>(())
    /// ```
    ///
    /// *Error.* One rounding a coordinate.
    ///
    /// # Errors
    /// R005 for a point that is infinitely far away; otherwise as [`Nurbs::new`].
    pub fn from_homogeneous(knots: Knots, points: &[Homogeneous<D>]) -> Result<Nurbs<D>> {
        let (points, weights) = denominator::cartesian(points)?;
        Nurbs::new(knots, points, weights)
    }

    /// The closed curve of homogeneous control points.
    ///
    /// # Errors
    /// R005 for a point that is infinitely far away; otherwise as [`Nurbs::closed`].
    pub fn closed_from_homogeneous(period: &[f64], degree: usize, points: &[Homogeneous<D>]) -> Result<Nurbs<D>> {
        let (points, weights) = denominator::cartesian(points)?;
        Nurbs::closed(period, degree, points, weights)
    }

    /// The knots; of a closed curve, one period extended by p knots on both sides.
    pub fn knots(&self) -> &Knots {
        self.spline.knots()
    }

    /// The n + 1 knots of one period, if the curve is closed.
    pub fn period(&self) -> Option<&[f64]> {
        self.spline.period()
    }

    /// The Cartesian control points, each once, as they were given.
    pub fn control_points(&self) -> &[[f64; D]] {
        self.spline.control_points()
    }

    /// The weights, one a control point, as they were given.
    pub fn weights(&self) -> &[f64] {
        &self.weights
    }

    /// The polynomial curve of the control points without their weights.
    pub fn unweighted(&self) -> &BSpline<D> {
        &self.spline
    }

    /// The homogeneous control points (wᵢPᵢ, wᵢ); where weights are out of [2⁻²⁰, 2²⁰], all of them times a power of two that makes the
    /// greatest about 1, so that the products stay finite.
    pub fn homogeneous(&self) -> Vec<Homogeneous<D>> {
        denominator::homogeneous(self.control_points(), &self.weights)
    }

    /// The spans of the domain that are not empty.
    fn spans(&self) -> impl Iterator<Item = usize> {
        let (t, p) = (self.knots().values(), self.knots().degree());
        (p..self.knots().functions()).filter(move |&i| t[i] < t[i + 1])
    }

    /// Refuses a span with a pole.
    fn check_span(&self, search: &mut PoleSearch, span: usize) -> Result<()> {
        let (t, p) = (self.knots().values(), self.knots().degree());
        let (start, end) = (t[span], t[span + 1]);
        // A function vanishes at a knot unless it has more knots there than its degree leaves free.
        let before = t[..=span].iter().rev().take_while(|knot| **knot == start).take(p).count();
        let after = t[span + 1..].iter().take_while(|knot| **knot == end).take(p).count();
        let functions = Functions::Splines { knots: self.knots(), span };
        let weights = local(&self.weights, span, p);
        search.check(&functions, &weights, (start, end), (p + 1 - before, p + 1 - after))
    }
}

impl<const D: usize> Curve<D> for Nurbs<D> {
    fn kind(&self) -> &'static str {
        "bspline"
    }

    /// The degree of numerator and denominator.
    fn degree(&self) -> usize {
        self.spline.degree()
    }

    fn domain(&self) -> Interval {
        self.spline.domain()
    }

    fn jet_into(&self, t: f64, side: Side, out: &mut [[f64; D]]) {
        let (knots, p) = (self.knots(), self.knots().degree());
        let span = knots.span(&t, side);
        let (points, weights) = (local(self.control_points(), span, p), local(&self.weights, span, p));
        let ends = (knots.values()[span], knots.values()[span + 1]);
        denominator::jet(&Functions::Splines { knots, span }, &points, &weights, (self.plain, ends), t, out);
    }

    fn breaks(&self) -> Vec<f64> {
        self.spline.breaks()
    }

    fn is_closed(&self) -> bool {
        self.spline.is_closed()
    }

    fn is_rational(&self) -> bool {
        true
    }

    fn rational_pieces(&self, visit: &mut dyn FnMut(RationalPiece<'_, D>)) -> bool {
        let (knots, p) = (self.knots(), self.knots().degree());
        for span in self.spans() {
            let ends = (knots.values()[span], knots.values()[span + 1]);
            let (points, weights) = (local(self.control_points(), span, p), local(&self.weights, span, p));
            denominator::visit_piece(&Functions::Splines { knots, span }, &points, &weights, ends, visit);
        }
        true
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::error::Code;
    use alloc::vec;

    fn refused(weights: [f64; 3]) -> (Code, Option<usize>) {
        let points = [[0.0, 0.0], [1.0, 2.0], [3.0, 0.0]];
        let error = BSpline::clamped(2, points).unwrap().weighted(weights).unwrap_err();
        (error.code(), error.index())
    }

    #[test]
    fn faults_of_weights_have_their_codes() {
        assert_eq!(refused([1.0, f64::NAN, 1.0]), (Code::R001, Some(1)));
        assert_eq!(refused([1.0, 1.0, -1e301]), (Code::R002, Some(2)));
        assert_eq!(refused([0.0, 1.0, 1.0]), (Code::R004, None));
        assert_eq!(refused([1.0, 1.0, 0.0]), (Code::R004, None));
        assert_eq!(refused([0.0; 3]), (Code::R004, None));
        assert_eq!(refused([1.0, -1.0, 1.0]), (Code::R004, None)); // (1 − 2u)²
        assert_eq!(refused([1.0, -2.0, 1.0]), (Code::R004, None));
        let few = BSpline::clamped(2, [[0.0]; 3]).unwrap().weighted([1.0, 2.0]).unwrap_err();
        assert_eq!((few.code(), few.is_weights()), (Code::R003, true));
    }

    #[test]
    fn weights_that_are_harmless_are_taken() {
        let points = [[0.0, 0.0], [1.0, 2.0], [3.0, 0.0]];
        for weights in [[1.0, 0.0, 1.0], [1.0, -0.5, 1.0], [-1.0, -2.0, -1.0], [1e-300, 1.0, 1e300]] {
            let curve = BSpline::clamped(2, points).unwrap().weighted(weights).unwrap();
            assert_eq!((curve.eval(0.0).unwrap(), curve.eval(1.0).unwrap()), (points[0], points[2]), "{weights:?}");
            let mut ends = vec![];
            assert!(curve.rational_pieces(&mut |piece| {
                assert!(piece.points.iter().all(|point| point.weight >= 0.0));
                ends.push((piece.start, piece.end));
            }));
            assert_eq!((ends[0].0, ends[ends.len() - 1].1), (0.0, 1.0));
            assert!(ends.windows(2).all(|pair| pair[0].1 == pair[1].0));
        }
    }

    #[test]
    fn derivatives_beside_weights_of_every_size() {
        let points = [[0.0], [1.0], [3.0]];
        let curve = BSpline::clamped(2, points).unwrap().weighted([1e-300, 1.0, 1e300]).unwrap();
        // 2 w₁/w₀ (P₁ − P₀) and 2 w₁/w₂ (P₂ − P₁).
        let slope = curve.jet(0.0, 1).unwrap()[1][0];
        assert!((slope / 2e300 - 1.0).abs() < 1e-14, "{slope:e}");
        let slope = curve.jet(1.0, 1).unwrap()[1][0];
        assert!((slope / 4e-300 - 1.0).abs() < 1e-14, "{slope:e}");
        assert_eq!(curve.jet(0.0, 2).unwrap_err().code(), Code::P003);
    }
}
