//! How far apart two curves are, from how far their control points are apart.
//!
//! Two splines over the same knots differ by Σ (Pᵢ − Qᵢ) N_i, a convex combination of the differences: never more than the greatest of them.

use crate::error::{Code, Error, Result};
use crate::space::norm;
use alloc::format;

/// The unit of rounding, 2⁻⁵³.
pub(crate) const UNIT: f64 = f64::EPSILON / 2.0;

/// A bound for the distance of two curves, from the difference of two control points.
pub(crate) trait Measure<V> {
    /// How far points of the curve may move if each control point moves by at most this vector.
    fn size(&self, moved: &V) -> f64;

    /// What the rounding of one verb of this degree may add.
    fn slack(&self, degree: usize) -> f64;

    /// The measure of a stretch of the curve with these control points, some of which are replaced; none if there is no bound.
    fn near(&self, points: &[V], replaced: &[V]) -> Option<Self>
    where
        Self: Sized;
}

/// Ordinary points: the distance is the vector's length.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Points {
    /// The greatest length of a control point.
    size: f64,
}

impl Points {
    /// The measure of a curve with these control points.
    pub(crate) fn of<const D: usize>(points: &[[f64; D]]) -> Points {
        let larger = |most: f64, x: f64| if x > most { x } else { most };
        Points { size: points.iter().map(norm).fold(0.0, larger) }
    }
}

impl<const D: usize> Measure<[f64; D]> for Points {
    fn size(&self, moved: &[f64; D]) -> f64 {
        norm(moved)
    }

    fn slack(&self, degree: usize) -> f64 {
        16.0 * (degree + 1) as f64 * UNIT * self.size
    }

    fn near(&self, _points: &[[f64; D]], _replaced: &[[f64; D]]) -> Option<Points> {
        Some(*self)
    }
}

/// Refuses a tolerance that is no positive finite number (Q001).
pub(crate) fn check_tolerance(tolerance: f64) -> Result<()> {
    if tolerance > 0.0 && tolerance.is_finite() {
        return Ok(());
    }
    Err(Error::new(Code::Q001, format!("the tolerance is {tolerance}")))
}
