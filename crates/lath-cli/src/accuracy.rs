//! How accurately a curve is measured: `--accuracy`.

use crate::numbers;
use lath::curve::{AnyCurve, Curve, CurveVisitor};
use lath::error::{Limits, Result};
use lath::num::Bound;
use lath::query::{ArcLength, bounds, length};

/// The option.
#[derive(Debug, Default, clap::Args)]
pub(crate) struct Accuracy {
    /// How far a length may be off, in the units of the points (default 1e-9 of the size of the curve's box).
    #[arg(long, value_name = "A", value_parser = numbers::positive, allow_hyphen_values = true)]
    accuracy: Option<f64>,
}

/// A length is looked for to this part of the size of the box, unless another accuracy is asked for …
const USUAL: f64 = 1e-9;
/// … and never beyond this part, where nothing but rounding is left …
const FINEST: f64 = 1e-17;
/// … with at most this many intervals for a curve, and so many more for each piece.
const INTERVALS: u64 = 1 << 18;
const INTERVALS_A_PIECE: u64 = 64;
/// Degrees above 40 take many intervals, each with the work of the degree squared: at most this much, a second or so …
const WORK: u64 = 1 << 25;
/// … and half a minute where an accuracy is asked for.
const WORK_ASKED_FOR: u64 = 1 << 30;

impl Accuracy {
    /// What was asked for, if it is less than this bound.
    pub(crate) fn missed_by(&self, bound: Bound) -> Option<f64> {
        self.accuracy.filter(|accuracy| bound.value() > *accuracy)
    }

    /// The length of a curve.
    pub(crate) fn length(&self, curve: &AnyCurve, limits: &Limits<'_>) -> Result<(f64, Bound)> {
        struct Ask<'a>(&'a Accuracy, &'a Limits<'a>);
        impl CurveVisitor for Ask<'_> {
            type Output = Result<(f64, Bound)>;
            fn visit<const D: usize>(self, curve: &dyn Curve<D>, _dimension: usize) -> Self::Output {
                let (accuracy, limits) = self.0.of(curve, self.1);
                length(curve, accuracy, &limits)
            }
        }
        curve.visit(Ask(self, limits))
    }

    /// A curve measured along its length.
    pub(crate) fn along(&self, curve: &AnyCurve, limits: &Limits<'_>) -> Result<Along> {
        struct Ask<'a>(&'a Accuracy, &'a Limits<'a>);
        impl CurveVisitor for Ask<'_> {
            type Output = Result<Along>;
            fn visit<const D: usize>(self, curve: &dyn Curve<D>, _dimension: usize) -> Self::Output {
                let (accuracy, limits) = self.0.of(curve, self.1);
                let along = ArcLength::new(curve, accuracy, &limits)?;
                let (length, bound) = (along.length(), along.bound());
                Ok(Along { length, bound, parameter: Box::new(move |distance| along.parameter_at(distance)) })
            }
        }
        curve.visit(Ask(self, limits))
    }

    /// The accuracy for this curve, and the limits of measuring it.
    fn of<'a, const D: usize>(&self, curve: &dyn Curve<D>, limits: &Limits<'a>) -> (f64, Limits<'a>) {
        let around = bounds(curve).0;
        let size = around.lo.iter().zip(&around.hi).fold(0.0, |sum, (lo, hi)| sum + (hi - lo));
        let size = if size > 0.0 && size.is_finite() { size } else { 1.0 };
        let asked = self.accuracy.unwrap_or(size * USUAL);
        let accuracy = if asked > size * FINEST { asked } else { size * FINEST };
        let pieces = curve.breaks().len() as u64;
        let each = (curve.degree() as u64).saturating_mul(curve.degree() as u64).max(1);
        let work = if self.accuracy.is_some() { WORK_ASKED_FOR } else { WORK };
        let intervals = (work / each).min(INTERVALS).saturating_add(pieces.saturating_mul(INTERVALS_A_PIECE));
        // The smallest floats have no part so small.
        let accuracy = if accuracy > 0.0 { accuracy } else { f64::MIN_POSITIVE };
        (accuracy, Limits { max_points: intervals.min(limits.max_points), ..*limits })
    }
}

/// A curve measured along its length, in whatever dimension it is.
pub(crate) struct Along {
    pub(crate) length: f64,
    /// How far any length along the curve may be off.
    pub(crate) bound: Bound,
    parameter: Box<dyn Fn(f64) -> Result<f64>>,
}

impl Along {
    /// The parameter at which that much of the curve lies behind.
    pub(crate) fn parameter_at(&self, distance: f64) -> Result<f64> {
        (self.parameter)(distance)
    }
}
