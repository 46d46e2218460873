//! Piecewise quintics by points, first and second derivatives.

use crate::basis::bernstein;
use crate::curve::interval::{Interval, check_increasing, segment};
use crate::curve::protocol::{BezierPiece, Curve};
use crate::error::{Code, Count, Error, Result};
use crate::knot::Side;
use crate::space::{IntoPoint, collect};
use alloc::format;
use alloc::vec::Vec;

/// A piecewise quintic that passes through `points[i]` with first derivative `tangents[i]` and second derivative
/// `seconds[i]` at `parameters[i]`: position, velocity and acceleration at every way-point.
///
/// *Invariance:* affine (derivatives transform as vectors). C² always.
///
/// *Cost.* O(log n) an evaluation, in Bernstein form. *Error.* E ≤ 18 for values with respect to the pieces' Bernstein points.
///
/// *Degenerate input.* Coinciding points and zero derivatives are allowed; parameters must increase.
///
/// *Source.* G. Farin, Curves and Surfaces for CAGD (5th ed. 2002), §7.6: Bernstein points P₀, P₀ + h m₀/5,
/// P₀ + 2h m₀/5 + h² a₀/20, and their mirror images.
///
/// ```
/// use lath::curve::{Curve, QuinticHermite};
///
/// // From rest to rest: the minimum-jerk profile, half-way at half the time with speed 15/8.
/// let zero = [[0.0], [0.0]];
/// let curve = QuinticHermite::new(vec![0.0, 1.0], [[0.0], [1.0]], zero, zero)?;
/// assert_eq!(curve.jet(0.5, 2)?, [[0.5], [1.875], [0.0]]);
/// # Ok::<(), lath::error::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct QuinticHermite<const D: usize> {
    parameters: Vec<f64>,
    points: Vec<[f64; D]>,
    tangents: Vec<[f64; D]>,
    seconds: Vec<[f64; D]>,
}

impl<const D: usize> QuinticHermite<D> {
    /// As many parameters, first and second derivatives as points, at least two.
    ///
    /// # Errors
    /// T001, T003, T004 and P003 for the parameters; P005 for another number of derivatives; P002 and P003 for coordinates.
    pub fn new(
        parameters: Vec<f64>,
        points: impl IntoIterator<Item = impl IntoPoint<D>>,
        tangents: impl IntoIterator<Item = impl IntoPoint<D>>,
        seconds: impl IntoIterator<Item = impl IntoPoint<D>>,
    ) -> Result<QuinticHermite<D>> {
        let (points, tangents, seconds) = (collect(points)?, collect(tangents)?, collect(seconds)?);
        let n = points.len();
        if (tangents.len(), seconds.len()) != (n, n) {
            let message =
                format!("{} first and {} second derivatives for {}", tangents.len(), seconds.len(), Count(n, "point"));
            return Err(Error::new(Code::P005, message));
        }
        if parameters.len() != n {
            return Err(Error::new(
                Code::T004,
                format!("{} for {}", Count(parameters.len(), "parameter"), Count(n, "point")),
            ));
        }
        check_increasing(&parameters)?;
        Ok(QuinticHermite { parameters, points, tangents, seconds })
    }

    /// The parameters, increasing.
    pub fn parameters(&self) -> &[f64] {
        &self.parameters
    }

    /// The points.
    pub fn points(&self) -> &[[f64; D]] {
        &self.points
    }

    /// The first derivative at each point.
    pub fn tangents(&self) -> &[[f64; D]] {
        &self.tangents
    }

    /// The second derivative at each point.
    pub fn seconds(&self) -> &[[f64; D]] {
        &self.seconds
    }

    /// The Bernstein points of segment k.
    fn bernstein(&self, k: usize) -> [[f64; D]; 6] {
        let h = self.parameters[k + 1] - self.parameters[k];
        let (p, m, a) = (&self.points, &self.tangents, &self.seconds);
        // The first point inside, and the second, seen from end i in the direction of the step.
        let one = |i: usize, step: f64| core::array::from_fn(|c| p[i][c] + step * m[i][c] / 5.0);
        let two = |i: usize, step: f64| {
            core::array::from_fn(|c| p[i][c] + (2.0 * step * m[i][c] / 5.0 + step * step * a[i][c] / 20.0))
        };
        [p[k], one(k, h), two(k, h), two(k + 1, -h), one(k + 1, -h), p[k + 1]]
    }

    /// The Bernstein points of the first and second derivative of segment k, from the data and the chord's slope δ; see
    /// [`Hermite`](crate::curve::Hermite) for why not from differences of Bernstein points.
    fn derivatives(&self, k: usize) -> ([[f64; D]; 5], [[f64; D]; 4]) {
        let h = self.parameters[k + 1] - self.parameters[k];
        let (p, m, a) = (&self.points, &self.tangents, &self.seconds);
        let slope: [f64; D] = core::array::from_fn(|c| (p[k + 1][c] - p[k][c]) / h);
        let axis = |f: &dyn Fn(f64, f64, f64, f64, f64) -> f64| {
            core::array::from_fn(|c| f(slope[c], m[k][c], m[k + 1][c], a[k][c], a[k + 1][c]))
        };
        let first = [
            m[k],
            axis(&|_, m0, _, a0, _| m0 + h * a0 / 4.0),
            axis(&|d, m0, m1, a0, a1| (5.0 * d - 2.0 * (m0 + m1)) + h * (a1 - a0) / 4.0),
            axis(&|_, _, m1, _, a1| m1 - h * a1 / 4.0),
            m[k + 1],
        ];
        let second = [
            a[k],
            axis(&|d, m0, m1, a0, a1| (20.0 * d - 12.0 * m0 - 8.0 * m1) / h + (a1 - 2.0 * a0)),
            axis(&|d, m0, m1, a0, a1| (8.0 * m0 + 12.0 * m1 - 20.0 * d) / h + (a0 - 2.0 * a1)),
            a[k + 1],
        ];
        (first, second)
    }
}

impl<const D: usize> Curve<D> for QuinticHermite<D> {
    fn kind(&self) -> &'static str {
        "quintic-hermite"
    }

    fn degree(&self) -> usize {
        5
    }

    fn domain(&self) -> Interval {
        Interval { start: self.parameters[0], end: self.parameters[self.parameters.len() - 1] }
    }

    fn jet_into(&self, t: f64, side: Side, out: &mut [[f64; D]]) {
        let k = segment(&self.parameters, t, side);
        let (a, b) = (&self.parameters[k], &self.parameters[k + 1]);
        let (first, second) = self.derivatives(k);
        let (low, high) = out.split_at_mut(out.len().min(2));
        if let Some(value) = low.first_mut() {
            bernstein::jet(&self.bernstein(k), a, b, &t, core::slice::from_mut(value));
        }
        if let Some(derivative) = low.get_mut(1) {
            bernstein::jet(&first, a, b, &t, core::slice::from_mut(derivative));
        }
        bernstein::jet(&second, a, b, &t, high);
    }

    fn breaks(&self) -> Vec<f64> {
        self.parameters.clone()
    }

    fn bezier_pieces(&self, visit: &mut dyn FnMut(BezierPiece<'_, D>)) -> bool {
        for k in 0..self.parameters.len() - 1 {
            let (start, end) = (self.parameters[k], self.parameters[k + 1]);
            visit(BezierPiece { start, end, points: &self.bernstein(k) });
        }
        true
    }
}
