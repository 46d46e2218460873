//! What it takes to be a curve.

use crate::curve::interval::{Interval, Outside};
use crate::error::{Code, Error, Number, Result};
use crate::knot::Side;
use crate::space::Weighted;
use alloc::format;
use alloc::vec::Vec;
use core::any::Any;
use core::fmt::Debug;

/// A stretch of a curve that is one polynomial, by its Bernstein points over [start, end]; the degree is one less than
/// their number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BezierPiece<'a, const D: usize> {
    /// The parameter where the piece starts.
    pub start: f64,
    /// The parameter where it ends.
    pub end: f64,
    /// The control points of the piece.
    pub points: &'a [[f64; D]],
}

/// A stretch of a curve that is one rational function, by its weighted Bernstein points over [start, end]:
/// P(u) = Σ wᵢ Pᵢ Jᵢ(u) / Σ wᵢ Jᵢ(u).
///
/// No weight is negative, and the first and the last are positive: the stretch lies in the convex hull of its points, and ends in
/// the first and the last of them. Weights are known up to a common factor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RationalPiece<'a, const D: usize> {
    /// The parameter where the piece starts.
    pub start: f64,
    /// The parameter where it ends.
    pub end: f64,
    /// The Cartesian control points of the piece, each with its weight.
    pub points: &'a [Weighted<D>],
}

/// A curve in D dimensions: five things to say, and everything else follows.
///
/// # A family in full
///
/// ```
/// use lath::curve::{BezierPiece, Curve, Interval};
/// use lath::knot::Side;
///
/// /// The parabola (t, t²) on [−1, 1].
/// #[derive(Debug)]
/// struct Parabola;
///
/// impl Curve<2> for Parabola {
///     fn kind(&self) -> &'static str {
///         "parabola"
///     }
///     fn degree(&self) -> usize {
///         2
///     }
///     fn domain(&self) -> Interval {
///         Interval { start: -1.0, end: 1.0 }
///     }
///     fn jet_into(&self, t: f64, _side: Side, out: &mut [[f64; 2]]) {
///         for (k, derivative) in out.iter_mut().enumerate() {
///             *derivative = match k {
///                 0 => [t, t * t],
///                 1 => [1.0, 2.0 * t],
///                 2 => [0.0, 2.0],
///                 _ => [0.0, 0.0],
///             };
///         }
///     }
///     // A polynomial can prove it, and gets proven boxes and flattening for it.
///     fn bezier_pieces(&self, visit: &mut dyn FnMut(BezierPiece<'_, 2>)) -> bool {
///         visit(BezierPiece { start: -1.0, end: 1.0, points: &[[-1.0, 1.0], [0.0, -1.0], [1.0, 1.0]] });
///         true
///     }
/// }
///
/// assert_eq!(Parabola.eval(0.5)?, [0.5, 0.25]);
/// assert!(Parabola.eval(2.0).is_err());
/// # Ok::<(), lath::error::Error>(())
/// ```
pub trait Curve<const D: usize>: Any + Debug + Send + Sync {
    /// The family's name, as in files: `"bspline"`.
    fn kind(&self) -> &'static str;

    /// The degree of the pieces; what "degree" means for a family that is not polynomial, its own page says.
    fn degree(&self) -> usize;

    /// The closed interval of parameters.
    fn domain(&self) -> Interval;

    /// Value and derivatives: `out[k]` receives the k-th derivative at t, the limit from `side` at a break.
    ///
    /// Outside the domain the end pieces continue. This is the unchecked work-horse: a NaN parameter gives NaN.
    fn jet_into(&self, t: f64, side: Side, out: &mut [[f64; D]]);

    /// The parameters where smoothness may end, increasing, the domain's ends included.
    fn breaks(&self) -> Vec<f64> {
        let Interval { start, end } = self.domain();
        alloc::vec![start, end]
    }

    /// Whether the curve returns into itself.
    fn is_closed(&self) -> bool {
        false
    }

    /// Hands out the curve as Bézier pieces in order, without gaps, and returns true; or returns false and hands out
    /// nothing, if the curve is not piecewise polynomial.
    ///
    /// The pieces are the curve up to the rounding of a few convex combinations.
    fn bezier_pieces(&self, visit: &mut dyn FnMut(BezierPiece<'_, D>)) -> bool {
        let _ = visit;
        false
    }

    /// Whether the pieces are quotients of polynomials: then [`Curve::bezier_pieces`] has nothing to say, and
    /// [`Curve::rational_pieces`] has.
    fn is_rational(&self) -> bool {
        false
    }

    /// Hands out the curve as rational Bézier pieces in order, without gaps, and returns true; or returns false and hands
    /// out nothing. A curve whose pieces are all polynomial need not: ask for [`Curve::bezier_pieces`] first.
    ///
    /// The pieces are the curve up to the rounding of a few convex combinations. Every break is the end of a piece; where weights of
    /// both signs meet, other ends are not breaks.
    fn rational_pieces(&self, visit: &mut dyn FnMut(RationalPiece<'_, D>)) -> bool {
        let _ = visit;
        false
    }

    /// The point at t.
    ///
    /// # Errors
    /// T001 if t is not finite, T002 outside the domain, P003 if the point overflows.
    fn eval(&self, t: f64) -> Result<[f64; D]> {
        self.eval_outside(t, Outside::Error)
    }

    /// The point at t, outside the domain by a policy.
    ///
    /// # Errors
    /// T001 if t is not finite; T002 outside the domain under [`Outside::Error`]; P003 if the point overflows.
    fn eval_outside(&self, t: f64, outside: Outside) -> Result<[f64; D]> {
        let t = self.domain().resolve(t, outside)?;
        let mut out = [[0.0; D]];
        self.jet_into(t, Side::Right, &mut out);
        check_finite(t, out.as_flattened())?;
        Ok(out[0])
    }

    /// The point at t and the derivatives up to `order`: order + 1 rows.
    ///
    /// # Errors
    /// As [`Curve::eval`]; B001 for an order above 65536.
    fn jet(&self, t: f64, order: usize) -> Result<Vec<[f64; D]>> {
        if order > MAX_ORDER {
            let message = format!("derivatives up to order {order} are above the budget of {MAX_ORDER}");
            return Err(Error::new(Code::B001, message));
        }
        let t = self.domain().resolve(t, Outside::Error)?;
        let mut out = alloc::vec![[0.0; D]; order + 1];
        self.jet_into(t, Side::Right, &mut out);
        check_finite(t, out.as_flattened())?;
        Ok(out)
    }
}

/// The greatest order of a jet: the work of a rational one grows with its square.
const MAX_ORDER: usize = 1 << 16;

/// Refuses an answer that overflowed (P003): what is not finite was not put in, and must not come out.
pub(crate) fn check_finite(t: f64, answer: &[f64]) -> Result<()> {
    match answer.iter().find(|x| !x.is_finite()) {
        None => Ok(()),
        Some(x) => Err(Error::new(Code::P003, format!("the answer at t = {} overflows: {x}", Number(t)))),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::curve::Bezier;

    #[test]
    fn absurd_orders_are_refused() {
        let curve = Bezier::new([[1.0], [3.0]]).unwrap();
        assert_eq!(curve.jet(0.0, MAX_ORDER).unwrap()[..3], [[1.0], [2.0], [0.0]]);
        for order in [MAX_ORDER + 1, 1 << 40, usize::MAX] {
            assert!(curve.jet(0.0, order).unwrap_err().is_budget(), "{order}");
        }
    }
}
