//! The two operations through which points enter the mathematics.

use crate::num::Scalar;

/// A vector space over `S`: what evaluation, refinement and subdivision ask of points.
///
/// Implemented for arrays of scalars. It is the seam between the algorithms and their data, not a geometry library:
/// no dot product, no dimension.
///
/// ```
/// use lath::space::Vector;
///
/// let mut sum = <[f64; 2]>::zero();
/// sum.add_scaled(&0.5, &[4.0, 2.0]);
/// assert_eq!(sum, [2.0, 1.0]);
/// ```
pub trait Vector<S: Scalar>: Clone {
    /// The zero vector.
    fn zero() -> Self;
    /// self ← factor · self.
    fn scale(&mut self, factor: &S);
    /// self ← self + factor · other.
    fn add_scaled(&mut self, factor: &S, other: &Self);

    /// (1 − s) · self + s · other, with the complement 1 − s given, because both weights must be accurate.
    fn blend(&self, complement: &S, other: &Self, s: &S) -> Self {
        let mut sum = self.clone();
        sum.scale(complement);
        sum.add_scaled(s, other);
        sum
    }
}

impl<S: Scalar, const D: usize> Vector<S> for [S; D] {
    fn zero() -> Self {
        core::array::from_fn(|_| S::zero())
    }

    fn scale(&mut self, factor: &S) {
        for x in self {
            *x = factor.clone() * x.clone();
        }
    }

    fn add_scaled(&mut self, factor: &S, other: &Self) {
        for (x, y) in self.iter_mut().zip(other) {
            *x = x.clone() + factor.clone() * y.clone();
        }
    }
}
