//! Points as arrays: conversion into them, their lengths, and the check at the door.

use crate::error::{Code, Error, Result};
use alloc::format;
use alloc::vec::Vec;

/// Whatever turns into a point of D coordinates without loss.
///
/// ```
/// use lath::space::IntoPoint;
///
/// assert_eq!([1.0_f32, 2.5].into_point(), [1.0_f64, 2.5]);
/// ```
pub trait IntoPoint<const D: usize> {
    /// The coordinates.
    fn into_point(self) -> [f64; D];
}

impl<const D: usize> IntoPoint<D> for [f64; D] {
    fn into_point(self) -> [f64; D] {
        self
    }
}

impl<const D: usize> IntoPoint<D> for &[f64; D] {
    fn into_point(self) -> [f64; D] {
        *self
    }
}

impl<const D: usize> IntoPoint<D> for [f32; D] {
    fn into_point(self) -> [f64; D] {
        self.map(f64::from)
    }
}

/// The greatest magnitude of a coordinate, knot or parameter that constructors take: differences and their ratios to
/// ordinary intervals stay finite.
pub(crate) const SCALE_LIMIT: f64 = 1e300;

/// Refuses coordinates that are not finite (P002) or out of scale (P003); `index` is the point's.
pub(crate) fn check_point<const D: usize>(index: usize, point: &[f64; D]) -> Result<()> {
    for (axis, x) in point.iter().enumerate() {
        if !x.is_finite() {
            return Err(Error::new(Code::P002, format!("coordinate {axis} of point {index} is {x}")).at(index));
        }
        if x.abs() > SCALE_LIMIT {
            return Err(Error::new(Code::P003, format!("coordinate {axis} of point {index} is {x:e}")).at(index));
        }
    }
    Ok(())
}

/// Converts and checks all points.
pub(crate) fn collect<const D: usize>(points: impl IntoIterator<Item = impl IntoPoint<D>>) -> Result<Vec<[f64; D]>> {
    let points: Vec<[f64; D]> = points.into_iter().map(IntoPoint::into_point).collect();
    for (index, point) in points.iter().enumerate() {
        check_point(index, point)?;
    }
    Ok(points)
}

/// The Euclidean length of a vector, without overflow or underflow on the way.
///
/// *Error.* At most (D/2 + 2) u relative, at every scale; the sum runs in the order of the coordinates. A NaN
/// coordinate gives NaN.
///
/// ```
/// use lath::space::norm;
///
/// assert_eq!(norm(&[3.0, 4.0]), 5.0);
/// assert!((norm(&[3e-200, 4e-200]) / 5e-200 - 1.0).abs() < 1e-15);
/// assert!((norm(&[3e200, 4e200]) / 5e200 - 1.0).abs() < 1e-15);
/// ```
pub fn norm<const D: usize>(v: &[f64; D]) -> f64 {
    let sum = squares(v, 1.0);
    if (1e-280..=1e280).contains(&sum) {
        return libm::sqrt(sum);
    }
    let largest = v.iter().fold(0.0, |m: f64, x| if x.abs() > m || x.is_nan() { x.abs() } else { m });
    if largest == 0.0 || !largest.is_finite() {
        return largest;
    }
    // 2^600 lifts what underflowed, 2^-600 lowers what overflowed; both exactly.
    const LIFT: f64 = f64::from_bits((1023 + 600) << 52);
    const LOWER: f64 = f64::from_bits((1023 - 600) << 52);
    let (scale, back) = if largest < 1.0 { (LIFT, LOWER) } else { (LOWER, LIFT) };
    libm::sqrt(squares(v, scale)) * back
}

fn squares<const D: usize>(v: &[f64; D], scale: f64) -> f64 {
    v.iter().fold(0.0, |sum, x| sum + (x * scale) * (x * scale))
}

/// The distance of two points; see [`norm`].
pub fn distance<const D: usize>(a: &[f64; D], b: &[f64; D]) -> f64 {
    norm::<D>(&core::array::from_fn(|c| b[c] - a[c]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lengths_survive_the_exponent_range() {
        for e in [-1070, -600, -540, -500, -100, 0, 100, 500, 540, 900] {
            let unit = libm::ldexp(1.0, e);
            assert_eq!(norm(&[3.0 * unit, 4.0 * unit]), 5.0 * unit, "2^{e}");
        }
        assert_eq!(norm(&[0.0, -0.0]), 0.0);
        assert!(norm(&[f64::NAN, 1e300]).is_nan());
        assert_eq!(distance(&[1.0, 1.0], &[4.0, 5.0]), 5.0);
    }

    #[test]
    fn the_door_names_the_culprit() {
        let error = collect([[0.0, 1.0], [f64::NAN, 0.0]]).unwrap_err();
        assert_eq!((error.code(), error.index()), (Code::P002, Some(1)));
        let error = collect([[0.0, -1e301]]).unwrap_err();
        assert_eq!((error.code(), error.index()), (Code::P003, Some(0)));
    }
}
