//! How long a curve is.

use crate::curve::Curve;
use crate::error::{Code, Error, Limits, Number, Result};
use crate::num::Bound;
use crate::query::measure::measure;
use alloc::format;

/// The length of the curve, and how far it may be off.
///
/// *Idea.* Gauss quadrature of the speed, on intervals so short that the speed, as a function of a complex parameter, has no zero
/// nearby: then the error is proven, and falls by a fixed factor with each node. Towards a cusp the intervals are halved, and the last one
/// lies between its chord and its control polygon.
///
/// *Cost.* O(p³) an interval and up to 32 speeds. A smooth arch takes at most 12 halvings for twelve digits, a cusp at most 300 (tested); over
/// random cubics twelve digits cost an eighth more time than six (measured).
///
/// *Error.* Proven for piecewise polynomial and rational curves, jumps not counted: at most `accuracy`, or the bound says how much
/// more, where rounding or the budget of points (one an interval) does not allow it. The bound contains the rounding of
/// the measuring, not that of the pieces. Other curves: the length of a polyline of 256 steps a piece, an estimate.
///
/// *Degenerate input.* A point has length 0; a piece of a degree above 40, or with weights further apart than 10⁶, is bracketed by chord and control polygon
/// alone: about √(length/accuracy) intervals.
///
/// *Source.* L. N. Trefethen, Is Gauss quadrature better than Clenshaw–Curtis? (2008); J. Gravesen, Adaptive subdivision and the length and
/// energy of Bézier curves (1997).
///
/// ```
/// use lath::{curve::Bezier, error::Limits, query::length};
///
/// // y = x² from −1 to 1: √5 + asinh(2)/2.
/// let parabola = Bezier::new([[-1.0, 1.0], [0.0, -1.0], [1.0, 1.0]])?;
/// let (found, bound) = length(&parabola, 1e-12, &Limits::default())?;
/// assert!((found - 2.957_885_715_089_195).abs() <= 1e-12 && bound.is_proven() && bound.value() <= 1e-12);
/// # Ok::<(), lath::error::Error>(())
/// ```
///
/// # Errors
/// Q001 for an accuracy that is not positive and finite; P003 for a length that overflows; B002 when cancelled.
pub fn length<const D: usize>(curve: &dyn Curve<D>, accuracy: f64, limits: &Limits<'_>) -> Result<(f64, Bound)> {
    let (stretches, proven) = measure(curve, accuracy, limits)?;
    let (mut length, mut error) = (Sum::default(), 0.0);
    for stretch in &stretches {
        length.add(stretch.length);
        error += stretch.error;
    }
    let length = length.value();
    Ok((length, bound(length, error, proven)?))
}

/// The bound of a sum of lengths with the rounding of the summing; refuses what overflowed (P003).
pub(crate) fn bound(length: f64, error: f64, proven: bool) -> Result<Bound> {
    let error = error * (1.0 + 1e-9) + length * f64::EPSILON;
    if !(length.is_finite() && error.is_finite()) {
        return Err(Error::new(Code::P003, "the length overflows"));
    }
    Ok(if proven { Bound::Proven(error) } else { Bound::Estimate(error) })
}

/// Refuses an accuracy that is not positive and finite (Q001).
pub(crate) fn check_accuracy(accuracy: f64) -> Result<()> {
    if accuracy > 0.0 && accuracy.is_finite() {
        return Ok(());
    }
    Err(Error::new(Code::Q001, format!("the accuracy is {}", Number(accuracy))))
}

/// A sum that keeps what each addition rounds away.
///
/// *Source.* A. Neumaier 1974.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Sum {
    sum: f64,
    rest: f64,
}

impl Sum {
    pub(crate) fn add(&mut self, x: f64) {
        let sum = self.sum + x;
        self.rest += if self.sum.abs() >= x.abs() { (self.sum - sum) + x } else { (x - sum) + self.sum };
        self.sum = sum;
    }

    pub(crate) fn value(&self) -> f64 {
        // Where the sum overflowed the rest is no number.
        if self.sum.is_finite() { self.sum + self.rest } else { self.sum }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::curve::{Bezier, Hermite};
    use alloc::vec;

    #[test]
    fn a_parabola_keeps_every_accuracy() {
        // y = x² on [−1, 1]: √5 + asinh(2)/2.
        let parabola = Bezier::new([[-1.0, 1.0], [0.0, -1.0], [1.0, 1.0]]).unwrap();
        let exact = libm::sqrt(5.0) + libm::asinh(2.0) / 2.0;
        for e in 1..9 {
            let accuracy = libm::pow(10.0, -f64::from(e));
            let (found, bound) = length(&parabola, accuracy, &Limits::default()).unwrap();
            assert!(bound.is_proven() && bound.value() <= accuracy, "{bound:?}");
            assert!((found - exact).abs() <= bound.value() + 1e-12, "{found} at {accuracy}");
        }
    }

    #[test]
    fn cusps_points_and_budgets_end() {
        // A cusp: out and back, twice the distance of its tip.
        let cusp = Bezier::new([[0.0], [1.0], [0.0]]).unwrap();
        let (found, _) = length(&cusp, 1e-9, &Limits::default()).unwrap();
        assert!((found - 1.0).abs() <= 1e-9, "{found}");
        let point = Bezier::new([[7.0, 7.0]; 4]).unwrap();
        assert_eq!(length(&point, 1e-9, &Limits::default()).unwrap().0, 0.0);
        let arch = Bezier::new([[0.0, 0.0], [1.0, 2.0], [2.0, 0.0]]).unwrap();
        let few = Limits { max_points: 10, ..Limits::default() };
        let (_, bound) = length(&arch, 1e-15, &few).unwrap();
        assert!(bound.value() > 1e-15 && bound.value() < 1.0);
        assert_eq!(length(&arch, 0.0, &few).unwrap_err().code(), Code::Q001);
    }

    #[test]
    fn pieces_that_overflow_have_no_length() {
        let wild = Hermite::new(vec![-1e300, 1e300], [[0.0], [1.0]], [[1e298], [-1e298]]).unwrap();
        assert_eq!(length(&wild, 1.0, &Limits::default()).unwrap_err().code(), Code::P003);
    }
}
