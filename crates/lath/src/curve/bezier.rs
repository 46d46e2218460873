//! Bézier curves of any degree.

use crate::basis::bernstein;
use crate::curve::interval::{Interval, check_increasing};
use crate::curve::protocol::{BezierPiece, Curve};
use crate::error::{Code, Error, Result};
use crate::knot::Side;
use crate::space::{IntoPoint, collect};
use alloc::format;
use alloc::vec::Vec;

/// A Bézier curve P(t) = Σ bᵢ J_{n,i}(u), u = (t − a)/(b − a), of degree n = points − 1.
///
/// *Invariance:* affine. The curve starts and ends in its end points, tangent to the polygon, inside the points' convex hull.
///
/// *Cost.* O(n²) an evaluation, by de Casteljau's triangle. *Error.* E ≤ 3n for values, 10n for derivatives, inside the domain.
///
/// *Degenerate input.* One point is a constant curve; coinciding points are allowed.
///
/// *Source.* P. Bézier 1968, P. de Casteljau 1959; Rogers and Adams, ch. 5.
///
/// ```
/// use lath::curve::{Bezier, Curve};
///
/// let curve = Bezier::new([[0.0, 0.0], [1.0, 2.0], [2.0, 0.0]])?;
/// assert_eq!(curve.eval(0.5)?, [1.0, 1.0]);
/// assert_eq!(curve.jet(0.5, 2)?[1..], [[2.0, 0.0], [0.0, -8.0]]);
/// # Ok::<(), lath::error::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Bezier<const D: usize> {
    points: Vec<[f64; D]>,
    domain: Interval,
}

impl<const D: usize> Bezier<D> {
    /// The curve of these control points on [0, 1].
    ///
    /// # Errors
    /// P001 for no points, P002 and P003 for coordinates, K006 for a degree above 1000.
    pub fn new(points: impl IntoIterator<Item = impl IntoPoint<D>>) -> Result<Bezier<D>> {
        Bezier::on(points, Interval { start: 0.0, end: 1.0 })
    }

    /// The curve of these control points on the given domain.
    ///
    /// # Errors
    /// As [`Bezier::new`]; T001, T003 and T005 for the domain.
    pub fn on(points: impl IntoIterator<Item = impl IntoPoint<D>>, domain: Interval) -> Result<Bezier<D>> {
        let points = collect(points)?;
        if points.is_empty() {
            return Err(Error::new(Code::P001, "0 points; a Bézier curve takes at least 1"));
        }
        if points.len() > 1001 {
            let message = format!("{} points make degree {}, above 1000", points.len(), points.len() - 1);
            return Err(Error::new(Code::K006, message));
        }
        check_increasing(&[domain.start, domain.end])?;
        Ok(Bezier { points, domain })
    }

    /// The control points b₀ … bₙ.
    pub fn control_points(&self) -> &[[f64; D]] {
        &self.points
    }
}

impl<const D: usize> Curve<D> for Bezier<D> {
    fn kind(&self) -> &'static str {
        "bezier"
    }

    fn degree(&self) -> usize {
        self.points.len() - 1
    }

    fn domain(&self) -> Interval {
        self.domain
    }

    fn jet_into(&self, t: f64, _side: Side, out: &mut [[f64; D]]) {
        bernstein::jet(&self.points, &self.domain.start, &self.domain.end, &t, out);
    }

    fn bezier_pieces(&self, visit: &mut dyn FnMut(BezierPiece<'_, D>)) -> bool {
        let Interval { start, end } = self.domain;
        visit(BezierPiece { start, end, points: &self.points });
        true
    }
}
