//! Closed curves: closing, opening, and moving the seam.

use crate::curve::BSpline;
use crate::error::{Code, Error, Result};
use crate::num::{Bound, Scalar};
use crate::refine::measure::{Measure, Points, check_tolerance};
use crate::refine::spline::Spline;
use crate::space::Vector;
use alloc::format;

impl<S: Scalar, V: Vector<S>> Spline<V, S> {
    /// The same closed spline with all copies of the seam's knot at the start of the period; an open one as it is.
    ///
    /// A renumbering: no number changes but the shifted copies of one knot.
    pub(crate) fn canonical(&self) -> Result<Spline<V, S>> {
        let own = self.own_knots();
        let Some(end) = own.last().filter(|_| self.is_closed()) else {
            return Ok(self.clone());
        };
        let tail = own.iter().rev().skip(1).take_while(|t| *t == end).count();
        if tail == 0 {
            return Ok(self.clone());
        }
        let mut knots = alloc::vec![own[0].clone(); tail];
        knots.extend_from_slice(&own[..own.len() - tail]);
        let mut points = self.points().to_vec();
        points.rotate_right(tail);
        self.alike(knots, self.degree(), points)
    }

    /// The same closed spline with its seam at t, on [t, t + period]; t becomes a knot if it is none.
    ///
    /// *Error.* Insertion where t is no knot; the knots before t are shifted by the period, and rounded.
    ///
    /// # Errors
    /// C005 for an open spline; T001 and T002 for t outside the domain.
    pub fn move_seam(&self, t: &S) -> Result<Spline<V, S>> {
        if !self.is_closed() {
            return Err(Error::new(Code::C005, "an open curve has no seam to move"));
        }
        let present = self.multiplicity(t) > 0;
        let spline = if present { self.clone() } else { self.insert(core::slice::from_ref(t))? }.canonical()?;
        let own = spline.own_knots();
        let (start, end) = spline.knots().domain();
        let place = if *t == end { 0 } else { own.partition_point(|knot| knot < t) };
        let length = end.clone() - start;
        let mut knots = own[place..].to_vec();
        for knot in &own[1..=place] {
            let shifted = knot.clone() + length.clone();
            let last = knots.last().cloned().unwrap_or_else(|| end.clone());
            knots.push(if shifted < last { last } else { shifted });
        }
        let mut points = spline.points().to_vec();
        points.rotate_left(place);
        spline.alike(knots, spline.degree(), points)
    }

    /// The closed spline of a clamped open one whose ends meet, as smooth at the seam as `accept` allows: it is asked for every move
    /// of control points that closing, and then removing copies of the seam's knot, would take.
    ///
    /// # Errors
    /// C004 if the ends' meeting in the middle is not accepted.
    pub fn close(&self, accept: &mut dyn FnMut(&V) -> bool) -> Result<Spline<V, S>> {
        if self.is_closed() {
            return Ok(self.clone());
        }
        let (clamped, p) = (self.clamp()?, self.degree());
        let (t_, n) = (clamped.knots().values(), clamped.points().len());
        if p == 0 {
            return Spline::closed(t_, 0, clamped.points().to_vec());
        }
        let middle = clamped.meet(&clamped.points()[n - 1], &clamped.points()[0], accept)?;
        let mut points = alloc::vec![middle];
        points.extend_from_slice(&clamped.points()[1..n - 1]);
        // The point over p copies of the seam is number p − 1.
        let count = points.len();
        points.rotate_right((p - 1) % count);
        let mut closed = Spline::closed(&t_[1..n + 1], p, points)?;
        let (seam, _) = closed.knots().domain();
        while closed.multiplicity(&seam) > 1 {
            match closed.remove(&seam) {
                Ok((smoother, moved)) if accept(&moved) => closed = smoother,
                _ => break,
            }
        }
        Ok(closed)
    }

    /// The point in the middle of two that should be one.
    pub(crate) fn meet(&self, a: &V, b: &V, accept: &mut dyn FnMut(&V) -> bool) -> Result<V> {
        let half = S::one() / S::from_int(2);
        let mut gap = a.clone();
        gap.add_scaled(&-S::one(), b);
        gap.scale(&half);
        if !accept(&gap) {
            return Err(Error::new(Code::C004, "the ends are farther apart than the tolerance"));
        }
        Ok(a.blend(&half, b, &half))
    }
}

/// Accepts moves as long as their sum stays within a tolerance.
pub(crate) struct Purse<'a, M> {
    pub(crate) tolerance: f64,
    pub(crate) spent: f64,
    /// Whether the ends have been brought together.
    pub(crate) met: bool,
    pub(crate) measure: &'a M,
    pub(crate) degree: usize,
}

impl<M> Purse<'_, M> {
    /// Whether one more move fits, which it then has.
    pub(crate) fn pays<V>(&mut self, moved: &V) -> bool
    where
        M: Measure<V>,
    {
        let size = self.measure.size(moved);
        // The first move brings the ends together; ends that meet to the bit cost nothing, not even rounding.
        let free = !self.met && size == 0.0;
        self.met = true;
        let sum = self.spent + if free { 0.0 } else { size + self.measure.slack(self.degree) };
        let fits = sum <= self.tolerance;
        if fits {
            self.spent = sum;
        }
        fits
    }
}

impl<const D: usize> BSpline<D> {
    /// The closed curve of an open one whose ends meet within the tolerance, as smooth at the seam as the tolerance allows, and the
    /// distance that was reached. A closed curve comes back as it is.
    ///
    /// *Cost.* O(n p). *Error.* The bound is proven: the sum of the moves of control points, with what rounding may add.
    ///
    /// *Source.* Tiller 1992.
    ///
    /// ```
    /// use lath::curve::{BSpline, Curve};
    ///
    /// let ring = BSpline::closed_uniform(3, [[0.0, -1.5], [1.5, 0.0], [0.0, 1.5], [-1.5, 0.0]])?;
    /// let (again, bound) = ring.clamp()?.close(1e-12)?;
    /// assert!(again.is_closed() && again.control_points().len() == 4 && bound.value() < 1e-13);
    /// # Ok::<(), lath::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// Q001 unless the tolerance is a positive finite number; C004 if the ends are farther apart.
    pub fn close(&self, tolerance: f64) -> Result<(BSpline<D>, Bound)> {
        check_tolerance(tolerance)?;
        let measure = Points::of(self.control_points());
        let mut purse = Purse { tolerance, spent: 0.0, met: false, measure: &measure, degree: self.knots().degree() };
        let closed = self.to_spline().close(&mut |moved| purse.pays(moved)).map_err(|error| match error.code() {
            Code::C004 => Error::new(Code::C004, format!("the ends are more than twice {tolerance:e} apart")),
            _ => error,
        })?;
        Ok((BSpline::from_spline(closed)?, Bound::Proven(purse.spent)))
    }

    /// The same closed curve with its seam at t, on [t, t + period]; t becomes a knot if it is none.
    ///
    /// *Error.* Insertion where t is no knot; the knots before t are shifted by the period and rounded, which changes no point.
    ///
    /// ```
    /// use lath::curve::{BSpline, Curve, Interval};
    ///
    /// let ring = BSpline::closed_uniform(3, [[0.0, -1.5], [1.5, 0.0], [0.0, 1.5], [-1.5, 0.0]])?;
    /// let turned = ring.move_seam(1.0)?;
    /// assert_eq!(turned.domain(), Interval { start: 1.0, end: 5.0 });
    /// assert_eq!(turned.eval(1.0)?, [0.0, 1.0]);
    /// # Ok::<(), lath::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// C005 for an open curve; T001 and T002 for t outside the domain.
    pub fn move_seam(&self, t: f64) -> Result<BSpline<D>> {
        BSpline::from_spline(self.to_spline().move_seam(&t)?)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn copies_of_the_seam_move_to_the_start() {
        let spline = Spline::closed(&[0.0, 1.0, 4.0, 4.0], 2, alloc::vec![[1.0], [2.0], [5.0]]).unwrap();
        let canonical = spline.canonical().unwrap();
        assert_eq!(canonical.own_knots(), [0.0, 0.0, 1.0, 4.0]);
        assert_eq!(canonical.points(), [[5.0], [1.0], [2.0]]);
        assert_eq!(canonical.unroll().points().len(), 5);
    }
}
