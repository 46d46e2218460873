//! Inserting knots: the same curve over more knots.
//!
//! *Source.* W. Boehm, Inserting new knots into B-spline curves (1980); E. Cohen, T. Lyche and R. Riesenfeld, Discrete B-splines and
//! subdivision techniques (1980). Each new point is found from the given ones at once (see `window.rs`), not knot by knot, so that fifty
//! insertions cost no more accuracy than p.

use crate::curve::BSpline;
use crate::error::{Code, Error, Limits, Result};
use crate::num::Scalar;
use crate::refine::spline::Spline;
use crate::refine::window::{Marked, blossom};
use crate::space::Vector;
use alloc::format;
use alloc::vec::Vec;
use core::cmp::Ordering;

impl<S: Scalar, V: Vector<S>> Spline<V, S> {
    /// The same spline with these knots added, in any order; a repeated one, or one that is there already, raises the
    /// multiplicity, up to p + 1.
    ///
    /// *Cost.* O(n + m) points copied, O(p²) blends for each of the m + p·(distinct) that change. *Error.* E ≤ 5p, convex combinations only.
    ///
    /// # Errors
    /// T001 and T002 with the index of a knot that is not finite, or outside the domain; K003 with the index of one that
    /// would be there more than p + 1 times.
    pub fn insert(&self, at: &[S]) -> Result<Spline<V, S>> {
        let p = self.degree();
        let fresh = self.check(at)?;
        let marked = if self.is_closed() { self.merge_closed(&fresh) } else { self.merge(&fresh) };
        let (count, first) = (self.points().len() + fresh.len(), self.first(&marked));
        let knots = if self.is_closed() {
            let start = marked.place(p);
            let mut period = marked.values(start, start + count);
            period.extend(self.own_knots().last().cloned());
            period
        } else {
            marked.values(0, marked.knots.len())
        };
        let mut points = Vec::with_capacity(count);
        let (mut before, mut arguments) = (marked.old(first), Vec::with_capacity(p));
        for window in (first..first + count).map(|i| &marked.knots[i..i + p]) {
            arguments.clear();
            arguments.extend(window.iter().filter(|(_, fresh)| *fresh).map(|(t, _)| t.clone()));
            points.push(blossom(self, before, &arguments));
            before += usize::from(!marked.knots[first + points.len() - 1].1);
        }
        self.alike(knots, p, points)
    }

    /// The middle of every span inserted, `levels` times: 2^levels spans for each.
    ///
    /// # Errors
    /// B001 if more points would be made than the budget allows; T005 where a span has no middle left.
    pub fn insert_middles(&self, levels: usize, limits: &Limits<'_>) -> Result<Spline<V, S>> {
        let spans = self.knots().breaks().len() as u64 - 1;
        let factor = u32::try_from(levels).ok().and_then(|levels| 1_u64.checked_shl(levels)).unwrap_or(u64::MAX);
        limits.check_points(spans.saturating_mul(factor).saturating_add(self.points().len() as u64))?;
        let mut spline = self.clone();
        for _ in 0..levels {
            limits.check_cancel()?;
            let (breaks, two) = (spline.knots().breaks(), S::from_int(2));
            let mut middles = Vec::with_capacity(breaks.len());
            for (i, pair) in breaks.windows(2).enumerate() {
                let middle = pair[0].clone() / two.clone() + pair[1].clone() / two.clone();
                if !(pair[0] < middle && middle < pair[1]) {
                    let message = format!("span {i}, from {:?} to {:?}, has no number inside", pair[0], pair[1]);
                    return Err(Error::new(Code::T005, message).at(i));
                }
                middles.push(middle);
            }
            spline = spline.insert(&middles)?;
        }
        Ok(spline)
    }

    /// The place of the first control point's first argument.
    fn first(&self, marked: &Marked<S>) -> usize {
        // An open spline keeps its first knot; the period starts with the last argument of the first point.
        if self.is_closed() { (marked.place(self.degree()) + 1).saturating_sub(self.degree()) } else { 1 }
    }

    /// The knots to insert in increasing order, checked; the end of a closed spline's period is its start.
    fn check(&self, at: &[S]) -> Result<Vec<S>> {
        let (start, end) = self.knots().domain();
        let mut fresh = Vec::with_capacity(at.len());
        for (i, t) in at.iter().enumerate() {
            if !t.is_finite() {
                return Err(Error::new(Code::T001, format!("the knot to insert is {t:?}")).at(i));
            }
            if *t < start || *t > end {
                let message = format!("the knot {t:?} lies outside the domain [{start:?}, {end:?}]");
                return Err(Error::new(Code::T002, message).at(i));
            }
            fresh.push((if self.is_closed() && *t == end { start.clone() } else { t.clone() }, i));
        }
        fresh.sort_by(|a, b| a.0.partial_cmp(&b.0).unwrap_or(Ordering::Equal));
        let most = self.degree() + 1;
        let mut run = 0;
        for k in 0..fresh.len() {
            run = if k > 0 && fresh[k].0 == fresh[k - 1].0 { run + 1 } else { self.multiplicity(&fresh[k].0) + 1 };
            if run > most {
                let message =
                    format!("the knot {:?} would be there {run} times, above degree + 1 = {most}", fresh[k].0);
                return Err(Error::new(Code::K003, message).at(fresh[k].1));
            }
        }
        Ok(fresh.into_iter().map(|(t, _)| t).collect())
    }

    /// How often a knot occurs; the seam of a closed spline counts both ends of the period.
    pub(crate) fn multiplicity(&self, t: &S) -> usize {
        let own = self.own_knots();
        let count = |t: &S| own.partition_point(|knot| knot <= t) - own.partition_point(|knot| knot < t);
        match (own.first(), own.last()) {
            (Some(first), Some(last)) if self.is_closed() && (t == first || t == last) => {
                count(first) + count(last) - 1
            }
            _ => count(t),
        }
    }

    /// The knots of an open spline with the fresh ones among them: after their equals, at the domain's end before.
    fn merge(&self, fresh: &[S]) -> Marked<S> {
        let (t_, (_, end)) = (self.knots().values(), self.knots().domain());
        let mut knots = Vec::with_capacity(t_.len() + fresh.len());
        let mut rest = fresh.iter().peekable();
        for t in t_ {
            while let Some(x) = rest.next_if(|x| *x < t || **x == end && *x <= t) {
                knots.push((x.clone(), true));
            }
            knots.push((t.clone(), false));
        }
        Marked { knots }
    }

    /// The extended knots of a closed spline with the fresh ones of the period among them, in every turn.
    fn merge_closed(&self, fresh: &[S]) -> Marked<S> {
        let (t_, p, n) = (self.knots().values(), self.degree(), self.points().len());
        let period = &t_[p..=p + n];
        let mut knots = Vec::with_capacity(t_.len() + 3 * fresh.len());
        for (e, t) in t_.iter().enumerate() {
            knots.push((t.clone(), false));
            let Some(next) = t_.get(e + 1) else { break };
            // Which gap of the period this is, and what lies in it.
            let gap = (e as isize - p as isize).rem_euclid(n as isize) as usize;
            let below = |bound: &S| fresh.partition_point(|x| x < bound);
            let (from, to) = (below(&period[gap]), below(&period[gap + 1]));
            for x in &fresh[from..to] {
                let shifted = if (p..p + n).contains(&e) {
                    x.clone()
                } else {
                    // As far from the gap's start as in the period, and never beyond its end.
                    let shifted = t.clone() + (x.clone() - period[gap].clone());
                    if shifted > *next { next.clone() } else { shifted }
                };
                knots.push((shifted, true));
            }
        }
        Marked { knots }
    }
}

impl<const D: usize> BSpline<D> {
    /// The same curve with these knots added, in any order; a knot that is there already gets a higher multiplicity, at most
    /// p + 1.
    ///
    /// *Cost.* O(n) points copied, O(p²) blends for each that changes. *Error.* E ≤ 5p, measured below 8 to degree 5: convex combinations of the given
    /// points only, however many knots come in at once. Points that keep their knots keep their bits.
    ///
    /// *Closed curves:* knots of the period; its end stands for its start.
    ///
    /// *Source.* Boehm 1980; Cohen, Lyche and Riesenfeld 1980.
    ///
    /// ```
    /// use lath::curve::{BSpline, Curve};
    ///
    /// let curve = BSpline::clamped(2, [[0.0, 0.0], [2.0, 4.0], [4.0, 0.0]])?;
    /// let refined = curve.insert_knots(&[0.5])?;
    /// assert_eq!(refined.control_points(), [[0.0, 0.0], [1.0, 2.0], [3.0, 2.0], [4.0, 0.0]]);
    /// assert_eq!(refined.eval(0.25)?, curve.eval(0.25)?);
    /// # Ok::<(), lath::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// T001 and T002 with the index of a knot that is not finite, or outside the domain; K003 with the index of one that would be
    /// there more than p + 1 times.
    pub fn insert_knots(&self, at: &[f64]) -> Result<BSpline<D>> {
        BSpline::from_spline(self.to_spline().insert(at)?)
    }

    /// The same curve with the middle of every span inserted, `levels` times.
    ///
    /// ```
    /// use lath::{curve::BSpline, error::Limits};
    ///
    /// // A closed cubic polygon is subdivided: edge and vertex points.
    /// let curve = BSpline::closed_uniform(3, [[0.0], [8.0], [0.0], [0.0]])?;
    /// let refined = curve.refine_uniformly(1, &Limits::default())?;
    /// assert_eq!(refined.control_points(), [[4.0], [6.0], [4.0], [1.0], [0.0], [0.0], [0.0], [1.0]]);
    /// # Ok::<(), lath::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// B001 if more points would be made than the budget allows; T005 where a span has no middle left.
    pub fn refine_uniformly(&self, levels: usize, limits: &Limits<'_>) -> Result<BSpline<D>> {
        BSpline::from_spline(self.to_spline().insert_middles(levels, limits)?)
    }
}
