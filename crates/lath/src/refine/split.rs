//! Cutting: two parts, or one part of a curve, each the same curve on a shorter domain.

use crate::curve::{BSpline, Bezier, Interval};
use crate::error::{Code, Error, Result};
use crate::num::Scalar;
use crate::refine::spline::Spline;
use crate::space::Vector;
use alloc::format;
use alloc::vec::Vec;

impl<S: Scalar, V: Vector<S>> Spline<V, S> {
    /// The parts below and above t, each clamped there; both have the same point at t, bit for bit, unless the spline jumps.
    ///
    /// # Errors
    /// T001 if t is not finite; T002 if it does not lie inside the domain.
    pub fn split(&self, t: &S) -> Result<(Spline<V, S>, Spline<V, S>)> {
        self.check_inside(t)?;
        let refined = self.unroll().up_to(&[t])?;
        Ok((refined.cut(None, Some(t))?, refined.cut(Some(t), None)?))
    }

    /// The part on [from, to], clamped at both ends.
    ///
    /// # Errors
    /// T001 if an end is not finite; T002 outside the domain; T003 unless from < to.
    pub fn trim(&self, from: &S, to: &S) -> Result<Spline<V, S>> {
        for (i, t) in [from, to].into_iter().enumerate() {
            self.check_closed(t).map_err(|error| error.at(i))?;
        }
        if from >= to {
            return Err(Error::new(Code::T003, format!("the interval from {from:?} to {to:?} is empty")).at(1));
        }
        self.unroll().clamp_ends(Some(from), Some(to))
    }

    /// The open spline over the same domain that starts and ends in its first and last control point: a closed one is opened at
    /// its seam, an unclamped one clamped.
    ///
    /// *Error.* As insertion; a spline that is clamped already comes back with its bits.
    pub fn clamp(&self) -> Result<Spline<V, S>> {
        let (start, end) = self.knots().domain();
        self.trim(&start, &end)
    }

    /// The part of an open spline between two parameters, clamped there; without one, an end stays as it is.
    pub(crate) fn clamp_ends(&self, start: Option<&S>, end: Option<&S>) -> Result<Spline<V, S>> {
        let ends: Vec<&S> = [start, end].into_iter().flatten().collect();
        self.up_to(&ends)?.cut(start, end)
    }

    /// Refuses t outside the domain.
    pub(crate) fn check_closed(&self, t: &S) -> Result<()> {
        if !t.is_finite() {
            return Err(Error::new(Code::T001, format!("the parameter is {t:?}")));
        }
        let (start, end) = self.knots().domain();
        if *t < start || *t > end {
            return Err(Error::new(Code::T002, format!("t = {t:?} lies outside the domain [{start:?}, {end:?}]")));
        }
        Ok(())
    }

    /// Refuses t outside the open interval of the domain.
    pub(crate) fn check_inside(&self, t: &S) -> Result<()> {
        if !t.is_finite() {
            return Err(Error::new(Code::T001, format!("the parameter is {t:?}")));
        }
        let (start, end) = self.knots().domain();
        if *t <= start || *t >= end {
            let message = format!("t = {t:?} does not lie inside the domain, from {start:?} to {end:?}");
            return Err(Error::new(Code::T002, message));
        }
        Ok(())
    }

    /// The same spline with multiplicity p or more at these parameters, all at once: so the error is that of one insertion.
    pub(crate) fn up_to(&self, parameters: &[&S]) -> Result<Spline<V, S>> {
        let mut at = Vec::new();
        for t in parameters {
            let missing = self.degree().saturating_sub(self.multiplicity(t));
            at.extend(core::iter::repeat_n(*t, missing).cloned());
        }
        if at.is_empty() { Ok(self.clone()) } else { self.insert(&at) }
    }

    /// The part of an open spline between two knots of multiplicity p or more, clamped there; without a cut an end stays as
    /// it is. Where the spline jumps, each part gets its own side.
    fn cut(&self, from: Option<&S>, to: Option<&S>) -> Result<Spline<V, S>> {
        let (u, p) = (self.knots().values(), self.degree());
        // The last copy of the start, the first of the end: between them lie the knots of the part.
        let last = from.map(|t| u.partition_point(|knot| knot <= t) - 1);
        let first = to.map(|t| u.partition_point(|knot| knot < t));
        let mut knots: Vec<S> = Vec::with_capacity(u.len());
        if let (Some(t), Some(_)) = (from, last) {
            knots.extend(core::iter::repeat_n(t, p + 1).cloned());
        }
        knots.extend_from_slice(&u[last.map_or(0, |last| last + 1)..first.unwrap_or(u.len())]);
        if let Some(t) = to {
            knots.extend(core::iter::repeat_n(t, p + 1).cloned());
        }
        let points = &self.points()[last.map_or(0, |last| last - p)..first.unwrap_or(self.points().len())];
        self.alike(knots, p, points.to_vec())
    }
}

impl<const D: usize> BSpline<D> {
    /// The parts below and above t, with the parameters they had. Both are clamped at t and have the same point there, bit for
    /// bit, unless the curve jumps; a closed curve is opened at its seam first.
    ///
    /// *Cost.* O(n + p²). *Error.* E ≤ 5p: convex combinations.
    ///
    /// *Source.* Boehm 1980.
    ///
    /// ```
    /// use lath::curve::{BSpline, Curve};
    ///
    /// let curve = BSpline::clamped(2, [[0.0, 0.0], [2.0, 4.0], [4.0, 0.0]])?;
    /// let (left, right) = curve.split(0.5)?;
    /// assert_eq!(left.control_points(), [[0.0, 0.0], [1.0, 2.0], [2.0, 2.0]]);
    /// assert_eq!(right.eval(0.75)?, curve.eval(0.75)?);
    /// # Ok::<(), lath::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// T001 if t is not finite; T002 if it does not lie inside the domain.
    pub fn split(&self, t: f64) -> Result<(BSpline<D>, BSpline<D>)> {
        let (left, right) = self.to_spline().split(&t)?;
        Ok((BSpline::from_spline(left)?, BSpline::from_spline(right)?))
    }

    /// The part on an interval of the domain, clamped at both ends, with the parameters it had.
    ///
    /// *Cost, error.* As [`BSpline::split`].
    ///
    /// ```
    /// use lath::curve::{BSpline, Curve, Interval};
    ///
    /// let ring = BSpline::closed_uniform(3, [[0.0, -1.5], [1.5, 0.0], [0.0, 1.5], [-1.5, 0.0]])?;
    /// let quarter = ring.trim(Interval { start: 0.0, end: 1.0 })?;
    /// assert_eq!(quarter.control_points().first(), Some(&[1.0, 0.0]));
    /// assert_eq!(quarter.control_points().last(), Some(&[0.0, 1.0]));
    /// # Ok::<(), lath::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// T001, T002 for an end that is not finite, or outside the domain; T003 unless start < end.
    pub fn trim(&self, part: Interval) -> Result<BSpline<D>> {
        BSpline::from_spline(self.to_spline().trim(&part.start, &part.end)?)
    }

    /// The same curve over the same domain, open, and starting and ending in its first and last control point: a closed curve is
    /// opened at its seam, an unclamped one clamped. One that is clamped already comes back with its bits.
    ///
    /// ```
    /// use lath::curve::{BSpline, Curve};
    ///
    /// let curve = BSpline::uniform(2, [[0.0], [2.0], [6.0]])?;
    /// let clamped = curve.clamp()?;
    /// assert_eq!(clamped.control_points(), [[1.0], [2.0], [4.0]]);
    /// assert_eq!(clamped.domain(), curve.domain());
    /// # Ok::<(), lath::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// None that a valid curve can meet.
    pub fn clamp(&self) -> Result<BSpline<D>> {
        BSpline::from_spline(self.to_spline().clamp()?)
    }
}

impl<const D: usize> Bezier<D> {
    /// The parts below and above t, with the parameters they had; both have the same point at t, bit for bit.
    ///
    /// *Cost.* O(p²). *Error.* E ≤ 3p: convex combinations.
    ///
    /// *Source.* de Casteljau 1959.
    ///
    /// ```
    /// use lath::curve::Bezier;
    ///
    /// let (left, right) = Bezier::new([[0.0], [2.0], [0.0]])?.split(0.5)?;
    /// assert_eq!(left.control_points(), [[0.0], [1.0], [1.0]]);
    /// assert_eq!(right.control_points(), [[1.0], [1.0], [0.0]]);
    /// # Ok::<(), lath::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// T001 if t is not finite; T002 if it does not lie inside the domain.
    pub fn split(&self, t: f64) -> Result<(Bezier<D>, Bezier<D>)> {
        let (left, right) = self.to_spline()?.split(&t)?;
        Ok((Bezier::from_spline(left)?, Bezier::from_spline(right)?))
    }

    /// The part on an interval of the domain, with the parameters it had.
    ///
    /// ```
    /// use lath::curve::{Bezier, Interval};
    ///
    /// let part = Bezier::new([[0.0], [2.0], [0.0]])?.trim(Interval { start: 0.25, end: 0.75 })?;
    /// assert_eq!(part.control_points(), [[0.75], [1.25], [0.75]]);
    /// # Ok::<(), lath::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// T001, T002 for an end that is not finite, or outside the domain; T003 unless start < end.
    pub fn trim(&self, part: Interval) -> Result<Bezier<D>> {
        Bezier::from_spline(self.to_spline()?.trim(&part.start, &part.end)?)
    }
}
