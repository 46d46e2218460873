//! Straight pieces from point to point.

use crate::basis::bernstein;
use crate::curve::interval::Interval;
use crate::curve::protocol::{BezierPiece, Curve};
use crate::error::{Code, Error, Result};
use crate::knot::Side;
use crate::space::{IntoPoint, collect};
use alloc::format;
use alloc::vec::Vec;

/// The polyline through the points at t = 0, 1, 2, …
///
/// *Invariance:* affine. *Cost.* O(1) an evaluation. *Error.* E ≤ 6. Coinciding points are allowed.
///
/// ```
/// use lath::curve::{Curve, Polyline};
///
/// let line = Polyline::new([[0.0, 0.0], [4.0, 0.0], [4.0, 2.0]])?;
/// assert_eq!(line.eval(1.5)?, [4.0, 1.0]);
/// # Ok::<(), lath::error::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Polyline<const D: usize> {
    points: Vec<[f64; D]>,
}

impl<const D: usize> Polyline<D> {
    /// The polyline through at least two points.
    ///
    /// # Errors
    /// P001 for fewer than two points; P002 and P003 for coordinates.
    pub fn new(points: impl IntoIterator<Item = impl IntoPoint<D>>) -> Result<Polyline<D>> {
        let points = collect(points)?;
        if points.len() < 2 {
            let message = format!("a polyline takes at least 2 points, not {}", points.len());
            return Err(Error::new(Code::P001, message));
        }
        Ok(Polyline { points })
    }

    /// The points.
    pub fn points(&self) -> &[[f64; D]] {
        &self.points
    }
}

impl<const D: usize> Curve<D> for Polyline<D> {
    fn kind(&self) -> &'static str {
        "polyline"
    }

    fn degree(&self) -> usize {
        1
    }

    fn domain(&self) -> Interval {
        Interval { start: 0.0, end: (self.points.len() - 1) as f64 }
    }

    fn jet_into(&self, t: f64, side: Side, out: &mut [[f64; D]]) {
        let below = match side {
            Side::Right => libm::floor(t),
            Side::Left => libm::ceil(t) - 1.0,
        };
        // The cast saturates: below the domain (and for NaN) the first piece, above it the last.
        let k = (below as usize).min(self.points.len() - 2);
        bernstein::jet(&self.points[k..k + 2], &(k as f64), &((k + 1) as f64), &t, out);
    }

    fn breaks(&self) -> Vec<f64> {
        (0..self.points.len()).map(|i| i as f64).collect()
    }

    fn bezier_pieces(&self, visit: &mut dyn FnMut(BezierPiece<'_, D>)) -> bool {
        for (k, points) in self.points.windows(2).enumerate() {
            visit(BezierPiece { start: k as f64, end: (k + 1) as f64, points });
        }
        true
    }
}
