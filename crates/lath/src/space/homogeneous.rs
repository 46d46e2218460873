//! Points with weights, in the two forms in which they enter the mathematics.

use crate::num::Scalar;
use crate::space::vector::Vector;

/// A point of projective space: the Cartesian point P with weight w as (w·P, w).
///
/// Rational shapes are polynomial ones of these, so whatever is linear (evaluation, insertion of knots, elevation) runs on them
/// unchanged. A weight of zero with another point than zero is a direction, infinitely far away.
///
/// *Shape.* D + 1 scalars. *Degenerate input.* (0, 0) is no point at all.
///
/// *Source.* A. F. Möbius, Der barycentrische Calcul (1827); L. Piegl and W. Tiller, The NURBS Book (2nd ed. 1997), ch. 1.4.
///
/// ```
/// use lath::space::{Homogeneous, Vector, Weighted};
///
/// let a = Homogeneous::from(Weighted { point: [1.0, 1.0], weight: 1.0 });
/// let b = Homogeneous::from(Weighted { point: [0.0, 1.0], weight: 2.0 });
/// let middle = a.blend(&0.5, &b, &0.5);
/// assert_eq!((middle.point, middle.weight), ([0.5, 1.5], 1.5));
/// assert_eq!(middle.cartesian(), Some([1.0 / 3.0, 1.0]));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Homogeneous<const D: usize, S = f64> {
    /// The point times its weight, w·P.
    pub point: [S; D],
    /// The weight w.
    pub weight: S,
}

impl<const D: usize, S: Scalar> Homogeneous<D, S> {
    /// The Cartesian point P = (w·P)/w; none where the weight is zero.
    ///
    /// *Error.* One rounding a coordinate.
    pub fn cartesian(&self) -> Option<[S; D]> {
        let divided = || core::array::from_fn(|c| self.point[c].clone() / self.weight.clone());
        (!self.weight.is_zero()).then(divided)
    }
}

impl<const D: usize, S: Scalar> From<Weighted<D, S>> for Homogeneous<D, S> {
    fn from(weighted: Weighted<D, S>) -> Self {
        let Weighted { point, weight } = weighted;
        Homogeneous { point: point.map(|x| weight.clone() * x), weight }
    }
}

impl<S: Scalar, const D: usize> Vector<S> for Homogeneous<D, S> {
    fn zero() -> Self {
        Homogeneous { point: <[S; D]>::zero(), weight: S::zero() }
    }

    fn scale(&mut self, factor: &S) {
        self.point.scale(factor);
        self.weight = factor.clone() * self.weight.clone();
    }

    fn add_scaled(&mut self, factor: &S, other: &Self) {
        self.point.add_scaled(factor, &other.point);
        self.weight = self.weight.clone() + factor.clone() * other.weight.clone();
    }
}

/// A Cartesian point with its weight beside it: the form of files and of control points.
///
/// It is a [`Vector`] too, with the operations of [`Homogeneous`]: sums add weights, and put the point between the two
/// in the ratio of their weights. Products w·P are never formed, so weights from 1e-300 to 1e300 may stand beside each other, and a
/// blend of non-negative weights lies between its points.
///
/// *Degenerate input.* Where weights cancel there is no such point: a sum of weight zero keeps the point it had. Use
/// [`Homogeneous`] where weights of both signs meet.
///
/// ```
/// use lath::space::{Vector, Weighted};
///
/// let light = Weighted { point: [0.0], weight: 1e-300 };
/// let heavy = Weighted { point: [8.0], weight: 3e-300 };
/// assert_eq!(light.blend(&0.5, &heavy, &0.5).point, [6.0]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Weighted<const D: usize, S = f64> {
    /// The Cartesian point P.
    pub point: [S; D],
    /// The weight w.
    pub weight: S,
}

impl<S: Scalar, const D: usize> Vector<S> for Weighted<D, S> {
    fn zero() -> Self {
        Weighted { point: <[S; D]>::zero(), weight: S::zero() }
    }

    fn scale(&mut self, factor: &S) {
        self.weight = factor.clone() * self.weight.clone();
    }

    fn add_scaled(&mut self, factor: &S, other: &Self) {
        let share = factor.clone() * other.weight.clone();
        if share.is_zero() {
            return;
        }
        let sum = self.weight.clone() + share.clone();
        if !sum.is_zero() {
            self.point = self.point.blend(&(self.weight.clone() / sum.clone()), &other.point, &(share / sum.clone()));
        }
        self.weight = sum;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_forms_add_alike() {
        let (a, b) = (Weighted { point: [2.0, -4.0], weight: 0.5 }, Weighted { point: [1.0, 8.0], weight: 1.5 });
        let mut sum = a;
        sum.add_scaled(&2.0, &b);
        let mut other = Homogeneous::from(a);
        other.add_scaled(&2.0, &Homogeneous::from(b));
        assert_eq!((Some(sum.point), sum.weight), (other.cartesian(), other.weight));
        assert_eq!(Homogeneous::<2>::zero().cartesian(), None);
    }

    #[test]
    fn a_point_without_weight_changes_nothing() {
        let (nothing, b) = (Weighted { point: [7.0], weight: 0.0 }, Weighted { point: [1.0], weight: 1e-300 });
        assert_eq!(nothing.blend(&0.5, &b, &0.5), Weighted { point: [1.0], weight: 0.5e-300 });
        assert_eq!(b.blend(&0.5, &nothing, &0.5), Weighted { point: [1.0], weight: 0.5e-300 });
        assert_eq!(b.blend(&0.0, &b, &0.0).weight, 0.0);
    }
}
