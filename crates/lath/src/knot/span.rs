//! Finding the span of a parameter.

use crate::knot::vector::Knots;
use crate::num::Scalar;

/// Which limit is meant at a knot.
///
/// Inside a span both are the same. At a knot where the curve jumps or bends they differ: `Right` is the value as the
/// parameter comes down to the knot, `Left` as it comes up.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Side {
    /// The limit from below.
    Left,
    /// The limit from above: the default everywhere but at the end of the domain.
    #[default]
    Right,
}

impl<S: Scalar> Knots<S> {
    /// The index i of the span [tᵢ, tᵢ₊₁] that answers for t: tᵢ ≤ t < tᵢ₊₁ from the right, tᵢ < t ≤ tᵢ₊₁ from the left.
    ///
    /// Always a span of the domain that is not empty: below the domain the first, above it the last, so that these two
    /// extrapolate, and the domain's own ends are answered from inside whatever the side.
    ///
    /// *Cost.* O(log n). A parameter that compares with nothing (NaN) gets the first span.
    ///
    /// ```
    /// use lath::knot::{Knots, Side};
    ///
    /// let knots = Knots::new(vec![0.0, 0.0, 1.0, 1.0, 2.0, 2.0], 1)?;
    /// assert_eq!(knots.span(&1.0, Side::Left), 1);
    /// assert_eq!(knots.span(&1.0, Side::Right), 3);
    /// assert_eq!(knots.span(&2.0, Side::Right), 3);
    /// assert_eq!(knots.span(&-7.0, Side::Right), 1);
    /// # Ok::<(), lath::error::Error>(())
    /// ```
    pub fn span(&self, t: &S, side: Side) -> usize {
        let (first, end) = (self.degree(), self.functions());
        let inner = &self.values()[first..=end];
        // The number of domain knots left of the span's right end.
        let below = match side {
            Side::Right => inner.partition_point(|knot| knot <= t),
            Side::Left => inner.partition_point(|knot| knot < t),
        };
        if below == 0 {
            // At or below the start: the first span that is not empty.
            return first + inner.partition_point(|knot| *knot == inner[0]) - 1;
        }
        if below == inner.len() {
            // At or above the end: the last span that is not empty.
            return first + inner.partition_point(|knot| *knot < inner[inner.len() - 1]) - 1;
        }
        first + below - 1
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use alloc::vec;

    #[test]
    fn spans_at_and_beside_knots() {
        // Exercise 4.103: five spans of which two are empty at the triple knot.
        let knots = Knots::new(vec![-3., -2., -1., 0., 1., 1., 1., 2., 3., 4., 5., 6.], 3).unwrap();
        let below = f64::from_bits(1.0_f64.to_bits() - 1);
        let cases = [
            (-5.0, 3, 3),
            (0.0, 3, 3),
            (0.5, 3, 3),
            (below, 3, 3),
            (1.0, 3, 6),
            (1.5, 6, 6),
            (2.0, 6, 7),
            (2.5, 7, 7),
            (3.0, 7, 7),
            (9.0, 7, 7),
        ];
        for (t, left, right) in cases {
            assert_eq!((knots.span(&t, Side::Left), knots.span(&t, Side::Right)), (left, right), "t = {t}");
        }
        assert_eq!(knots.span(&f64::NAN, Side::Right), 3);
    }

    #[test]
    fn repeated_ends_inside_the_domain_are_skipped() {
        // t_p = t_{p+1}: the first span of the domain is empty.
        let knots = Knots::new(vec![0., 1., 1., 2., 2., 3.], 1).unwrap();
        assert_eq!(knots.span(&1.0, Side::Left), 2);
        assert_eq!(knots.span(&2.0, Side::Right), 2);
    }
}
