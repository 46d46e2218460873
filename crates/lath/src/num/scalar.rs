//! The numbers that the generic algorithms run on.

use crate::num::weights::weights;
use core::fmt::Debug;
use core::ops::{Add, Div, Mul, Neg, Sub};

/// An ordered field: `f64` here, exact fractions elsewhere.
///
/// `Clone` rather than `Copy`, because a fraction owns its digits. Implementations must be exact or correctly rounded,
/// so that results do not depend on the platform.
///
/// ```
/// use lath::num::Scalar;
///
/// fn half<S: Scalar>() -> S {
///     S::one() / S::from_int(2)
/// }
/// assert_eq!(half::<f64>(), 0.5);
/// ```
pub trait Scalar:
    Clone
    + PartialEq
    + PartialOrd
    + Debug
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// The neutral element of addition.
    fn zero() -> Self;
    /// The neutral element of multiplication.
    fn one() -> Self;
    /// The integer `n`; exact as long as the type can hold it (`f64`: |n| ≤ 2⁵³).
    fn from_int(n: i64) -> Self;
    /// Neither infinite nor NaN. Always true for fractions.
    fn is_finite(&self) -> bool;
    /// Whether the number is exactly zero.
    fn is_zero(&self) -> bool {
        *self == Self::zero()
    }
    /// The barycentric weights of t on [a, b], (b − t)/(b − a) and (t − a)/(b − a): what every triangle blends with.
    ///
    /// Fractions are exact by the formula. For `f64` and t in [a, b] each weight is off by at most u(1 + 2⁻²⁰) of itself,
    /// u = 2⁻⁵³, as long as it does not underflow. The plain formula rounds three times, and a triangle of degree p would
    /// repeat the same error p times.
    ///
    /// ```
    /// use lath::num::Scalar;
    ///
    /// assert_eq!(f64::weights(&1.0, &5.0, &2.0), (0.75, 0.25));
    /// ```
    fn weights(a: &Self, b: &Self, t: &Self) -> (Self, Self) {
        let length = b.clone() - a.clone();
        ((b.clone() - t.clone()) / length.clone(), (t.clone() - a.clone()) / length)
    }
}

impl Scalar for f64 {
    fn zero() -> Self {
        0.0
    }
    fn one() -> Self {
        1.0
    }
    fn from_int(n: i64) -> Self {
        n as f64
    }
    fn is_finite(&self) -> bool {
        f64::is_finite(*self)
    }
    #[inline]
    fn weights(a: &f64, b: &f64, t: &f64) -> (f64, f64) {
        weights(*a, *b, *t)
    }
}
