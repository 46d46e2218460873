//! Joining: two curves end to start as one.

use crate::curve::BSpline;
use crate::error::{Code, Error, Result};
use crate::num::{Bound, Scalar};
use crate::refine::measure::{Points, check_tolerance};
use crate::refine::seam::Purse;
use crate::refine::spline::Spline;
use crate::space::Vector;
use alloc::format;
use alloc::vec::Vec;

/// How two curves have been joined.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Joint {
    /// The parameter of the joint.
    pub t: f64,
    /// How often t is a knot of the joined curve: it is C^{degree − multiplicity} there; 0 if both were one polynomial.
    pub multiplicity: usize,
    /// How far points of the joined curve may be from those of the two.
    pub bound: Bound,
}

impl<S: Scalar, V: Vector<S>> Spline<V, S> {
    /// This open spline followed by another one, whose parameters are shifted to begin where this one ends; the degree is the greater
    /// of both. `accept` is asked for every move of control points: that of both ends to their middle, and those which removing
    /// copies of the joint's knot would take.
    ///
    /// # Errors
    /// C005 for a closed spline, with its index; C004 if the meeting of the ends is not accepted; T005 where the shift swallows a
    /// span.
    pub fn join(&self, other: &Spline<V, S>, accept: &mut dyn FnMut(&V) -> bool) -> Result<Spline<V, S>> {
        if let Some(i) = [self, other].iter().position(|spline| spline.is_closed()) {
            return Err(Error::new(Code::C005, "a closed curve has no end to join at").at(i));
        }
        let p = self.degree().max(other.degree());
        let (a, b) = (self.elevate(p - self.degree())?, other.elevate(p - other.degree())?);
        let ((_, end), (first, last)) = (a.knots().domain(), b.knots().domain());
        // Both clamped at the joint.
        let a = a.clamp_ends(None, Some(&end))?;
        let b = b.clamp_ends(Some(&first), None)?;
        // Parameters that fit already stay as they are.
        let until = if first == end { last } else { end.clone() + (last - first) };
        let b = b.reparametrise(&end, &until)?;
        let mut knots: Vec<S> = a.knots().values().to_vec();
        let mut points: Vec<V> = a.points().to_vec();
        if p == 0 {
            knots.extend_from_slice(&b.knots().values()[1..]);
            points.extend_from_slice(b.points());
        } else {
            let ends = points.pop();
            let middle = match (&ends, b.points().first()) {
                (Some(a), Some(b)) => self.meet(a, b, accept)?,
                _ => V::zero(),
            };
            points.push(middle);
            points.extend_from_slice(&b.points()[1..]);
            knots.truncate(knots.len() - 1);
            knots.extend_from_slice(&b.knots().values()[p + 1..]);
        }
        let mut joined = a.alike(knots, p, points)?;
        while joined.multiplicity(&end) > 0 {
            match joined.remove(&end) {
                Ok((smoother, moved)) if accept(&moved) => joined = smoother,
                _ => break,
            }
        }
        Ok(joined)
    }
}

impl<const D: usize> BSpline<D> {
    /// This open curve followed by another one whose start lies at this one's end, up to the tolerance; its parameters are shifted
    /// to begin where this one ends, and the degree is the greater of both. The joint is as smooth as the tolerance allows.
    ///
    /// *Cost.* O(n + p²). *Error.* The bound is proven: the moves of control points, with what rounding may add. Ends that are equal to
    /// the bit cost nothing.
    ///
    /// *Source.* Tiller 1992 for the removal of the joint's knots.
    ///
    /// ```
    /// use lath::curve::{BSpline, Curve};
    ///
    /// let curve = BSpline::clamped(2, [[0.0, 0.0], [2.0, 4.0], [4.0, 0.0]])?;
    /// let (left, right) = curve.split(0.25)?;
    /// let (again, joint) = left.join(&right, 1e-12)?;
    /// assert_eq!((joint.t, joint.multiplicity), (0.25, 0));
    /// assert_eq!(again.control_points().len(), 3);
    /// # Ok::<(), lath::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// Q001 unless the tolerance is a positive finite number; C004 if the ends are more than twice the tolerance apart; C005 with the
    /// index of a closed curve; T005 where the shift swallows a span.
    pub fn join(&self, other: &BSpline<D>, tolerance: f64) -> Result<(BSpline<D>, Joint)> {
        check_tolerance(tolerance)?;
        let measure = Points::of(&[self.control_points(), other.control_points()].concat());
        let degree = self.knots().degree().max(other.knots().degree());
        let mut purse = Purse { tolerance, spent: 0.0, met: false, measure: &measure, degree };
        let joined = self.to_spline().join(&other.to_spline(), &mut |moved| purse.pays(moved));
        let joined = joined.map_err(|error| match error.code() {
            Code::C004 => Error::new(Code::C004, format!("the ends are more than twice {tolerance:e} apart")),
            _ => error,
        })?;
        let t = self.knots().domain().1;
        let joint = Joint { t, multiplicity: joined.multiplicity(&t), bound: Bound::Proven(purse.spent) };
        Ok((BSpline::from_spline(joined)?, joint))
    }
}
