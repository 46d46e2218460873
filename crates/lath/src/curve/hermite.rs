//! Piecewise cubics by points and tangents: the form in which people know cubic splines.

use crate::basis::bernstein;
use crate::basis::hermite::to_bernstein;
use crate::curve::interval::{Interval, check_increasing, segment};
use crate::curve::protocol::{BezierPiece, Curve};
use crate::error::{Code, Count, Error, Result};
use crate::knot::Side;
use crate::space::{IntoPoint, collect};
use alloc::format;
use alloc::vec::Vec;

/// A piecewise cubic that passes through `points[i]` with derivative `tangents[i]` at `parameters[i]`:
/// P_k(u) = F₁P_k + F₂P_{k+1} + F₃P′_k + F₄P′_{k+1} between neighbours.
///
/// *Invariance:* affine (tangents transform as vectors). C¹ always; C² if the tangents solve a spline's equations.
///
/// *Closed:* one more parameter than points; the last piece returns to the first point.
///
/// *Cost.* O(log n) an evaluation, in Bernstein form. *Error.* E ≤ 12 for values with respect to the pieces' Bernstein points.
///
/// *Degenerate input.* Coinciding points and zero tangents are allowed; parameters must increase.
///
/// *Source.* Rogers and Adams, ch. 5.
///
/// ```
/// use lath::curve::{Curve, Hermite};
///
/// let curve = Hermite::new(vec![0.0, 3.0], [[0.0, 0.0], [3.0, 0.0]], [[1.0, 1.0], [1.0, -1.0]])?;
/// assert_eq!(curve.eval(1.5)?, [1.5, 0.75]);
/// assert_eq!(curve.jet(3.0, 1)?[1], [1.0, -1.0]);
/// # Ok::<(), lath::error::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Hermite<const D: usize> {
    parameters: Vec<f64>,
    points: Vec<[f64; D]>,
    tangents: Vec<[f64; D]>,
}

impl<const D: usize> Hermite<D> {
    /// The open curve: as many parameters and tangents as points.
    ///
    /// # Errors
    /// T001, T003, T004 and T005 for the parameters; P005 for another number of tangents; P002 and P003 for coordinates.
    pub fn new(
        parameters: Vec<f64>,
        points: impl IntoIterator<Item = impl IntoPoint<D>>,
        tangents: impl IntoIterator<Item = impl IntoPoint<D>>,
    ) -> Result<Hermite<D>> {
        Hermite::checked(parameters, collect(points)?, collect(tangents)?, 0)
    }

    /// The closed curve: n points and tangents, n + 1 parameters.
    ///
    /// # Errors
    /// As [`Hermite::new`].
    pub fn closed(
        parameters: Vec<f64>,
        points: impl IntoIterator<Item = impl IntoPoint<D>>,
        tangents: impl IntoIterator<Item = impl IntoPoint<D>>,
    ) -> Result<Hermite<D>> {
        Hermite::checked(parameters, collect(points)?, collect(tangents)?, 1)
    }

    /// From points and tangents that were checked before; `extra` is 1 for a closed curve.
    pub(crate) fn checked(
        parameters: Vec<f64>,
        points: Vec<[f64; D]>,
        tangents: Vec<[f64; D]>,
        extra: usize,
    ) -> Result<Hermite<D>> {
        let n = points.len();
        if tangents.len() != n {
            let message = format!("{} for {}", Count(tangents.len(), "tangent"), Count(n, "point"));
            return Err(Error::new(Code::P005, message));
        }
        if parameters.len() != n + extra {
            let message =
                format!("{} for {}, which take {}", Count(parameters.len(), "parameter"), Count(n, "point"), n + extra);
            return Err(Error::new(Code::T004, message));
        }
        check_increasing(&parameters)?;
        Ok(Hermite { parameters, points, tangents })
    }

    /// The parameters, increasing; one more than points if the curve is closed.
    pub fn parameters(&self) -> &[f64] {
        &self.parameters
    }

    /// The points, each once.
    pub fn points(&self) -> &[[f64; D]] {
        &self.points
    }

    /// The derivative at each point.
    pub fn tangents(&self) -> &[[f64; D]] {
        &self.tangents
    }

    /// The Bernstein points of segment k.
    fn bernstein(&self, k: usize) -> [[f64; D]; 4] {
        let next = if k + 1 < self.points.len() { k + 1 } else { 0 };
        let h = self.parameters[k + 1] - self.parameters[k];
        to_bernstein(&self.points[k], &self.tangents[k], &self.points[next], &self.tangents[next], &h)
    }

    /// The Bernstein points of the derivative of segment k: m₀, 3δ − m₀ − m₁, m₁ with the chord's slope δ. Taken from the
    /// data: where the interval is short beside the coordinates, differences of Bernstein points are mostly rounding.
    fn derivative(&self, k: usize) -> [[f64; D]; 3] {
        let next = if k + 1 < self.points.len() { k + 1 } else { 0 };
        let h = self.parameters[k + 1] - self.parameters[k];
        let (first, last) = (self.tangents[k], self.tangents[next]);
        let slope = |c: usize| (self.points[next][c] - self.points[k][c]) / h;
        [first, core::array::from_fn(|c| 3.0 * slope(c) - first[c] - last[c]), last]
    }
}

impl<const D: usize> Curve<D> for Hermite<D> {
    fn kind(&self) -> &'static str {
        "hermite"
    }

    fn degree(&self) -> usize {
        3
    }

    fn domain(&self) -> Interval {
        Interval { start: self.parameters[0], end: self.parameters[self.parameters.len() - 1] }
    }

    fn jet_into(&self, t: f64, side: Side, out: &mut [[f64; D]]) {
        let k = segment(&self.parameters, t, side);
        let Some((value, derivatives)) = out.split_first_mut() else { return };
        let (a, b) = (&self.parameters[k], &self.parameters[k + 1]);
        bernstein::jet(&self.bernstein(k), a, b, &t, core::slice::from_mut(value));
        bernstein::jet(&self.derivative(k), a, b, &t, derivatives);
    }

    fn breaks(&self) -> Vec<f64> {
        self.parameters.clone()
    }

    fn is_closed(&self) -> bool {
        self.parameters.len() > self.points.len()
    }

    fn bezier_pieces(&self, visit: &mut dyn FnMut(BezierPiece<'_, D>)) -> bool {
        for k in 0..self.parameters.len() - 1 {
            let (start, end) = (self.parameters[k], self.parameters[k + 1]);
            visit(BezierPiece { start, end, points: &self.bernstein(k) });
        }
        true
    }
}
