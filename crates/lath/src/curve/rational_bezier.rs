//! Rational Bézier curves of any degree.

use crate::basis::rational::Functions;
use crate::curve::bezier::Bezier;
use crate::curve::denominator::{self, PoleSearch};
use crate::curve::interval::Interval;
use crate::curve::protocol::{Curve, RationalPiece};
use crate::error::Result;
use crate::knot::Side;
use crate::space::{Homogeneous, IntoPoint};
use alloc::vec::Vec;

/// A rational Bézier curve P(t) = Σ wᵢ bᵢ Jᵢ(u) / Σ wᵢ Jᵢ(u), u = (t − a)/(b − a).
///
/// Of degree 2 these are the conics; see [`conic`](mod@crate::curve::conic).
///
/// *Invariance:* projective. With positive weights the curve lies in the convex hull of its points.
///
/// *Cost.* O(n²) an evaluation. *Error.* E ≤ 3(n + 1) for values and 10n for first derivatives of degree n inside the domain,
/// measured to degree 8, with the conditions of [`Nurbs`](crate::curve::Nurbs). *Degenerate input.* As there.
///
/// *Source.* A. R. Forrest 1968; G. Farin, Curves and Surfaces for CAGD (5th ed. 2002), ch. 13.
///
/// ```
/// use lath::curve::{Curve, RationalBezier};
///
/// let quarter = RationalBezier::new([[1.0, 0.0], [1.0, 1.0], [0.0, 1.0]], [1.0, 1.0, 2.0])?;
/// assert_eq!(quarter.eval(0.5)?, [0.6, 0.8]);
/// # Ok::<(), lath::error::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct RationalBezier<const D: usize> {
    bezier: Bezier<D>,
    weights: Vec<f64>,
    /// Whether all weights are positive and of ordinary size.
    plain: bool,
}

impl<const D: usize> Bezier<D> {
    /// The rational curve of these control points with the given weights, one a point.
    ///
    /// # Errors
    /// R001, R002 and R003 for the weights; R004 if the denominator may be zero somewhere in the domain, with the interval.
    pub fn weighted(self, weights: impl IntoIterator<Item = f64>) -> Result<RationalBezier<D>> {
        let weights: Vec<f64> = weights.into_iter().collect();
        denominator::check_weights(&weights, self.control_points().len())?;
        let plain = denominator::are_plain(&weights);
        if weights.iter().any(|weight| *weight <= 0.0) {
            let Interval { start, end } = self.domain();
            let functions = Functions::Bernstein { start: &start, end: &end };
            PoleSearch::new().check(&functions, &weights, (start, end), (1, 1))?;
        }
        Ok(RationalBezier { bezier: self, weights, plain })
    }
}

impl<const D: usize> RationalBezier<D> {
    /// The curve of these control points with these weights on [0, 1].
    ///
    /// # Errors
    /// As [`Bezier::new`] and [`Bezier::weighted`].
    pub fn new(
        points: impl IntoIterator<Item = impl IntoPoint<D>>,
        weights: impl IntoIterator<Item = f64>,
    ) -> Result<RationalBezier<D>> {
        Bezier::new(points)?.weighted(weights)
    }

    /// The same on the given domain.
    ///
    /// # Errors
    /// As [`Bezier::on`] and [`Bezier::weighted`].
    pub fn on(
        points: impl IntoIterator<Item = impl IntoPoint<D>>,
        weights: impl IntoIterator<Item = f64>,
        domain: Interval,
    ) -> Result<RationalBezier<D>> {
        Bezier::on(points, domain)?.weighted(weights)
    }

    /// The curve of homogeneous control points on the given domain.
    ///
    /// # Errors
    /// R005 for a point that is infinitely far away; otherwise as [`RationalBezier::on`].
    pub fn from_homogeneous(points: &[Homogeneous<D>], domain: Interval) -> Result<RationalBezier<D>> {
        let (points, weights) = denominator::cartesian(points)?;
        RationalBezier::on(points, weights, domain)
    }

    /// The Cartesian control points, as they were given.
    pub fn control_points(&self) -> &[[f64; D]] {
        self.bezier.control_points()
    }

    /// The weights, one a control point, as they were given.
    pub fn weights(&self) -> &[f64] {
        &self.weights
    }

    /// The polynomial curve of the control points without their weights.
    pub fn unweighted(&self) -> &Bezier<D> {
        &self.bezier
    }

    /// The homogeneous control points (wᵢbᵢ, wᵢ), scaled as those of [`Nurbs`](crate::curve::Nurbs::homogeneous).
    pub fn homogeneous(&self) -> Vec<Homogeneous<D>> {
        denominator::homogeneous(self.control_points(), &self.weights)
    }
}

impl<const D: usize> Curve<D> for RationalBezier<D> {
    fn kind(&self) -> &'static str {
        "bezier"
    }

    /// The degree of numerator and denominator.
    fn degree(&self) -> usize {
        self.bezier.degree()
    }

    fn domain(&self) -> Interval {
        self.bezier.domain()
    }

    fn jet_into(&self, t: f64, _side: Side, out: &mut [[f64; D]]) {
        let Interval { start, end } = self.domain();
        let functions = Functions::Bernstein { start: &start, end: &end };
        denominator::jet(&functions, self.control_points(), &self.weights, (self.plain, (start, end)), t, out);
    }

    fn is_rational(&self) -> bool {
        true
    }

    fn rational_pieces(&self, visit: &mut dyn FnMut(RationalPiece<'_, D>)) -> bool {
        let Interval { start, end } = self.domain();
        let functions = Functions::Bernstein { start: &start, end: &end };
        denominator::visit_piece(&functions, self.control_points(), &self.weights, (start, end), visit);
        true
    }
}
