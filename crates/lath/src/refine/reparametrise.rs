//! Another parameter for the same points: a linear map of the domain, and the way back.

use crate::curve::{BSpline, Bezier, Curve, Interval};
use crate::error::{Code, Error, Result};
use crate::num::Scalar;
use crate::refine::spline::Spline;
use crate::space::Vector;
use alloc::format;
use alloc::vec::Vec;

impl<S: Scalar, V: Vector<S>> Spline<V, S> {
    /// The same points over the domain [start, end]: t ↦ start + (t − a)(end − start)/(b − a).
    ///
    /// The ends are exact and points keep their bits; in floats the other knots are rounded, for a mere shift with one or two roundings each.
    ///
    /// # Errors
    /// T001 for an end that is not finite; T003 unless start < end; T005 with the index of a knot that rounding moves onto its
    /// neighbour; K007 for knots beyond 1e300.
    pub fn reparametrise(&self, start: &S, end: &S) -> Result<Spline<V, S>> {
        for (i, t) in [start, end].into_iter().enumerate() {
            if !t.is_finite() {
                return Err(Error::new(Code::T001, format!("end {i} of the new domain is {t:?}")).at(i));
            }
        }
        if start >= end {
            return Err(Error::new(Code::T003, format!("the domain from {start:?} to {end:?} is empty")).at(1));
        }
        let (a, b) = self.knots().domain();
        if a == *start && b == *end {
            return Ok(self.clone());
        }
        let (old, new) = (b.clone() - a.clone(), end.clone() - start.clone());
        let image = |t: &S| {
            if *t == a {
                start.clone()
            } else if *t == b {
                end.clone()
            } else if old == new {
                start.clone() + (t.clone() - a.clone())
            } else {
                // Each end with its own weight, so that both are met.
                (b.clone() - t.clone()) / old.clone() * start.clone()
                    + (t.clone() - a.clone()) / old.clone() * end.clone()
            }
        };
        let knots: Vec<S> = self.own_knots().iter().map(image).collect();
        check_distinct(self.own_knots(), &knots)?;
        self.alike(knots, self.degree(), self.points().to_vec())
    }

    /// The same points the other way: t ↦ a + b − t, on the same domain.
    ///
    /// Points keep their bits; in floats the knots are rounded.
    ///
    /// # Errors
    /// T005 with the index of a knot that rounding moves onto its neighbour.
    pub fn reverse(&self) -> Result<Spline<V, S>> {
        let (a, b) = self.knots().domain();
        let image = |t: &S| {
            if *t == a {
                b.clone()
            } else if *t == b {
                a.clone()
            } else {
                a.clone() + (b.clone() - t.clone())
            }
        };
        let turned: Vec<S> = self.own_knots().iter().rev().cloned().collect();
        let knots: Vec<S> = turned.iter().map(image).collect();
        check_distinct(&turned, &knots)?;
        let mut points: Vec<V> = self.points().iter().rev().cloned().collect();
        if self.is_closed() {
            // Point i over the knots behind number i is point n + p − 1 − i from the other side.
            let count = points.len();
            points.rotate_right(self.degree() % count);
        }
        self.alike(knots, self.degree(), points)
    }
}

/// Refuses knots that stand in another order than those they came from.
fn check_distinct<S: Scalar>(from: &[S], to: &[S]) -> Result<()> {
    for i in 1..to.len() {
        if from[i] != from[i - 1] && to[i] <= to[i - 1] {
            let message = format!("knots {} and {i} would both be at {:?}", i - 1, to[i]);
            return Err(Error::new(Code::T005, message).at(i));
        }
    }
    Ok(())
}

impl<const D: usize> BSpline<D> {
    /// The same points over another domain, by a linear map of the parameter.
    ///
    /// Control points keep their bits and the ends are exact; the other knots are rounded, so that a point is off by at most the speed
    /// of the curve times some units of the last place of the parameter.
    ///
    /// ```
    /// use lath::curve::{BSpline, Curve, Interval};
    ///
    /// let curve = BSpline::clamped(2, [[0.0], [2.0], [4.0], [0.0]])?;
    /// let unit = curve.reparametrise(Interval { start: 0.0, end: 1.0 })?;
    /// assert_eq!(unit.knots().values(), [0.0, 0.0, 0.0, 0.5, 1.0, 1.0, 1.0]);
    /// assert_eq!(unit.eval(0.25)?, curve.eval(0.5)?);
    /// # Ok::<(), lath::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// T001 for an end that is not finite; T003 unless start < end; T005 with the index of a knot that rounding would move onto
    /// its neighbour; K007 for knots beyond 1e300.
    pub fn reparametrise(&self, domain: Interval) -> Result<BSpline<D>> {
        BSpline::from_spline(self.to_spline().reparametrise(&domain.start, &domain.end)?)
    }

    /// The same curve from its end to its start, over the same domain.
    ///
    /// Control points keep their bits; knots inside are rounded as in [`BSpline::reparametrise`].
    ///
    /// ```
    /// use lath::curve::{BSpline, Curve};
    ///
    /// let curve = BSpline::over(vec![0.0, 0.0, 1.0, 4.0, 4.0], 1, [[0.0], [2.0], [3.0]])?;
    /// let back = curve.reverse()?;
    /// assert_eq!(back.knots().values(), [0.0, 0.0, 3.0, 4.0, 4.0]);
    /// assert_eq!(back.eval(1.0)?, curve.eval(3.0)?);
    /// # Ok::<(), lath::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// T005 with the index of a knot that rounding would move onto its neighbour.
    pub fn reverse(&self) -> Result<BSpline<D>> {
        BSpline::from_spline(self.to_spline().reverse()?)
    }
}

impl<const D: usize> Bezier<D> {
    /// The same points over another domain.
    ///
    /// # Errors
    /// T001, T003 and T005 for the domain.
    pub fn reparametrise(&self, domain: Interval) -> Result<Bezier<D>> {
        Bezier::on(self.control_points(), domain)
    }

    /// The same curve from its end to its start, over the same domain: the same bits in the other order.
    ///
    /// ```
    /// use lath::curve::Bezier;
    ///
    /// let back = Bezier::new([[0.0], [2.0], [5.0]])?.reverse();
    /// assert_eq!(back?.control_points(), [[5.0], [2.0], [0.0]]);
    /// # Ok::<(), lath::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// None that a valid curve can meet.
    pub fn reverse(&self) -> Result<Bezier<D>> {
        Bezier::on(self.control_points().iter().rev(), self.domain())
    }
}
