//! Raising the degree: the same curve, every piece one degree higher.
//!
//! The blossom of a polynomial of degree p, seen as one of degree p + 1, is the mean of the old blossom over all ways to leave out one
//! argument. The knots all get their multiplicity raised by one, so whichever is left out, what remains are knots that contain
//! the given ones: each term is a control point over finer knots (`window.rs`), and the mean of convex combinations is one.
//!
//! *Source.* H. Prautzsch, Degree elevation of B-spline curves (1984), here by L. Ramshaw's blossoms (1987).

use crate::curve::{BSpline, Bezier};
use crate::error::{Error, Result};
use crate::knot::check_degree;
use crate::num::Scalar;
use crate::refine::spline::Spline;
use crate::refine::window::{Marked, blossom, blossoms_without_one};
use crate::space::Vector;
use alloc::vec::Vec;

impl<S: Scalar, V: Vector<S>> Spline<V, S> {
    /// The same spline with its degree raised by `by`, and every multiplicity with it.
    ///
    /// Of an unclamped spline only as many knots outside the domain are kept as the new degree needs.
    ///
    /// *Cost.* Each degree O(p² log p) blends a point over simple knots, O(p) over the ends alone. *Error.* Each degree E ≤ 6p + 3; convex
    /// combinations only.
    ///
    /// # Errors
    /// K006 for a degree above 1000.
    pub fn elevate(&self, by: usize) -> Result<Spline<V, S>> {
        check_degree(self.degree().saturating_add(by))?;
        let mut spline = self.clone();
        for _ in 0..by {
            spline = spline.elevate_once()?;
        }
        Ok(spline)
    }

    /// One degree more.
    fn elevate_once(&self) -> Result<Spline<V, S>> {
        let (p, degree) = (self.degree(), self.degree() + 1);
        let marked = self.doubled();
        let (first, count, knots) = if self.is_closed() {
            let (start, end) = (marked.place(p), marked.place(p + self.points().len()));
            let mut period = marked.values(start, end);
            period.extend(self.own_knots().last().cloned());
            ((start + 1).saturating_sub(degree), end - start, period)
        } else {
            // The last copy of the domain's start becomes knot p + 1, the first copy of its end knot n.
            let (start, end) = self.knots().domain();
            let last = marked.knots.partition_point(|(t, _)| *t <= start) - 1;
            let until = marked.knots.partition_point(|(t, _)| *t < end);
            let from = last - degree;
            (from + 1, until - from, marked.values(from, until + degree + 1))
        };
        let mut points = Vec::with_capacity(count);
        let mut before = marked.old(first);
        for i in first..first + count {
            points.push(mean(self, before, &marked.knots[i..i + degree]));
            before += usize::from(!marked.knots[i].1);
        }
        self.alike(knots, degree, points)
    }

    /// The knots, each distinct one followed by a fresh copy.
    fn doubled(&self) -> Marked<S> {
        let (t_, p, n) = (self.knots().values(), self.degree(), self.points().len());
        let own = self.own_knots();
        let mut knots = Vec::with_capacity(2 * t_.len());
        for (e, t) in t_.iter().enumerate() {
            knots.push((t.clone(), false));
            let last_of_its_kind = if self.is_closed() {
                // Asked of the period: its shifted copies are rounded.
                let place = (e as isize - p as isize).rem_euclid(n as isize) as usize;
                own[place] != own[place + 1]
            } else {
                t_.get(e + 1) != Some(t)
            };
            if last_of_its_kind {
                knots.push((t.clone(), true));
            }
        }
        Marked { knots }
    }
}

/// The mean of the blossom over all ways to leave out one of the window's p + 1 knots. Equal ones give equal terms, so that
/// each group is left out once, and counts by its size.
fn mean<S: Scalar, V: Vector<S>>(spline: &Spline<V, S>, before: usize, window: &[(S, bool)]) -> V {
    let fresh: Vec<S> = window.iter().filter(|(_, fresh)| *fresh).map(|(t, _)| t.clone()).collect();
    let mut sum = V::zero();
    let mut terms = blossoms_without_one(spline, before, &fresh).into_iter();
    let mut size = 0;
    for (k, (_, is_fresh)) in window.iter().enumerate() {
        size += 1;
        // A group ends with its fresh copy. Without it, an old one is left out, and the fresh one outside counts as old.
        if !is_fresh && k + 1 < window.len() {
            continue;
        }
        let term = match terms.next() {
            Some(term) if *is_fresh => term,
            _ => blossom(spline, before, &fresh),
        };
        if size == window.len() {
            return term;
        }
        sum.add_scaled(&(S::from_int(size as i64) / S::from_int(window.len() as i64)), &term);
        size = 0;
    }
    sum
}

impl<const D: usize> BSpline<D> {
    /// The same curve with its degree raised by `by`; every knot's multiplicity rises with it, so that the curve is as smooth as it
    /// was.
    ///
    /// Of an unclamped curve only as many knots outside the domain are kept as the new degree needs.
    ///
    /// *Cost.* Each degree O(p² log p) blends a point over simple knots, O(p) over the ends alone. *Error.* Each degree E ≤ 6p + 3, measured
    /// below 8 to degree 5; ends of a clamped curve keep their bits.
    ///
    /// *Source.* Prautzsch 1984.
    ///
    /// ```
    /// use lath::curve::{BSpline, Curve};
    ///
    /// let curve = BSpline::clamped(1, [[0.0, 0.0], [2.0, 4.0], [4.0, 0.0]])?;
    /// let elevated = curve.elevate(1)?;
    /// assert_eq!(elevated.knots().values(), [0.0, 0.0, 0.0, 1.0, 1.0, 2.0, 2.0, 2.0]);
    /// assert_eq!(elevated.control_points(), [[0.0, 0.0], [1.0, 2.0], [2.0, 4.0], [3.0, 2.0], [4.0, 0.0]]);
    /// # Ok::<(), lath::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// K006 for a degree above 1000.
    pub fn elevate(&self, by: usize) -> Result<BSpline<D>> {
        BSpline::from_spline(self.to_spline().elevate(by)?)
    }
}

impl<const D: usize> Bezier<D> {
    /// The same curve with its degree raised by `by`.
    ///
    /// *Cost.* O(p) blends for each degree. *Error.* Each degree E ≤ 5; the ends keep their bits.
    ///
    /// *Source.* A. R. Forrest, Interactive interpolation and approximation by Bézier polynomials (1972).
    ///
    /// ```
    /// use lath::curve::Bezier;
    ///
    /// let line = Bezier::new([[0.0], [6.0]])?;
    /// assert_eq!(line.elevate(2)?.control_points(), [[0.0], [2.0], [4.0], [6.0]]);
    /// # Ok::<(), lath::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// K006 for a degree above 1000.
    pub fn elevate(&self, by: usize) -> Result<Bezier<D>, Error> {
        Bezier::from_spline(self.to_spline()?.elevate(by)?)
    }
}
