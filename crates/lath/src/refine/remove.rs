//! Removing knots: as few as a tolerance allows, with the distance that was reached.
//!
//! Taking out one copy of a knot asks for control points Q from which insertion would give back the P around it:
//! Pᵢ = αᵢQᵢ + (1 − αᵢ)Qᵢ₋₁ on m = p − s + 1 rows (s the multiplicity) for m − 1 unknowns. One combination of the rows, Σ zᵢPᵢ with zᵢ of
//! alternating sign, must vanish. Where it does not, moving each Pᵢ by −sign(zᵢ) v with v = Σ zᵢPᵢ / Σ|zᵢ| makes the rows agree, and no smaller
//! greatest move does: ‖v‖ is the least distance of the control points, and so a bound for the distance of the curves. Then the
//! rows are solved from both sides, dividing by numbers of at least ½.
//!
//! *Source.* W. Tiller, Knot-removal algorithms for NURBS curves and surfaces (1992); M. Eck and J. Hadenfeld, Knot removal for
//! B-spline curves (1995), for the best move; T. Lyche and K. Mørken, Knot removal for parametric B-spline curves and surfaces (1987),
//! for taking many at once.

use crate::basis::bernstein::weights;
use crate::curve::BSpline;
use crate::error::{Code, Error, Result};
use crate::num::{Bound, Scalar};
use crate::refine::measure::{Measure, Points, check_tolerance};
use crate::refine::spline::Spline;
use crate::space::Vector;
use alloc::format;
use alloc::vec::Vec;

/// One copy of a knot that could go.
#[derive(Clone, Copy, Debug)]
struct Copy {
    /// The place of its last copy among the (extended) knots.
    place: usize,
    /// How many copies there are.
    multiplicity: usize,
    /// The place of the copy among the knots that define the spline.
    own: usize,
}

/// What removing it does: points `first`, `first` + 1, … are replaced, and the one after them goes.
struct Removal<V> {
    copy: Copy,
    first: isize,
    replaced: Vec<V>,
    /// How far each control point moves, but for the sign.
    moved: V,
}

impl<S: Scalar, V: Vector<S>> Spline<V, S> {
    /// The spline without one copy of the knot t, and the vector v by which the control points around t were moved back and forth
    /// to make that possible: zero if the spline stays the same, otherwise its points move by at most ‖v‖.
    ///
    /// The end points of the part that changes stay, so that clamped ends and corners do. Where the spline jumps at t, both sides
    /// meet in the middle.
    ///
    /// *Cost.* O(n + p). *Error.* The moves are found to a few u of the points' size.
    ///
    /// # Errors
    /// T002 if no copy of t can go: it is no knot, or an end of the domain, or the last one at the seam of a closed spline, or the
    /// spline is closed with fewer than p + 2 points.
    pub fn remove(&self, t: &S) -> Result<(Spline<V, S>, V)> {
        let spline = self.canonical()?;
        let copies = spline.copies();
        let copy = copies.iter().find(|copy| spline.knots().values()[copy.place] == *t);
        let Some(removal) = copy.and_then(|copy| spline.removal(*copy)) else {
            return Err(Error::new(Code::T002, format!("there is no knot {t:?} that could be removed")));
        };
        let moved = removal.moved.clone();
        Ok((spline.without(&[removal])?, moved))
    }

    /// One copy of each knot that may be removed, increasing.
    fn copies(&self) -> Vec<Copy> {
        let (p, n, own) = (self.degree(), self.points().len(), self.own_knots());
        let (start, end) = self.knots().domain();
        let mut copies = Vec::new();
        if self.is_closed() && n < p + 2 {
            return copies;
        }
        let mut run = 0;
        for (i, t) in own.iter().enumerate() {
            run = if i > 0 && own[i - 1] == *t { run + 1 } else { 1 };
            let last = own.get(i + 1) != Some(t);
            let inside = start < *t && *t < end;
            // The seam of a canonical closed spline has all its copies at the start, and must keep one.
            if last && (inside || self.is_closed() && run > 1) {
                let place = if self.is_closed() { p + i } else { i };
                copies.push(Copy { place, multiplicity: run, own: i });
            }
        }
        copies
    }

    /// What removing a copy would do; none where the shift of a period has swallowed the spans around it.
    fn removal(&self, copy: Copy) -> Option<Removal<V>> {
        let (t_, p, Copy { place: r, multiplicity: s, .. }) = (self.knots().values(), self.degree(), copy);
        let half = S::one() / S::from_int(2);
        let left = self.point(r as isize - p as isize - 1);
        let right = self.point(r as isize - s as isize + 1);
        if s > p {
            // A jump: both sides meet in the middle.
            let mut moved = left.clone();
            moved.add_scaled(&-S::one(), right);
            moved.scale(&half);
            let replaced = alloc::vec![left.blend(&half, right, &half)];
            return Some(Removal { copy, first: r as isize - p as isize - 1, replaced, moved });
        }
        let first = r - p;
        let rows: Vec<(S, S)> = (first..=r - s).map(|i| weights(&t_[i], &t_[i + p + 1], &t_[r])).collect();
        if rows.iter().any(|(a, b)| !(*a > S::zero() && *b > S::zero())) {
            return None;
        }
        let mut row: Vec<V> = (first..=r - s).map(|i| self.point(i as isize).clone()).collect();
        let last = row.len() - 1;
        row[0].add_scaled(&-rows[0].0.clone(), left);
        row[last].add_scaled(&-rows[last].1.clone(), right);
        // αᵢ falls with i. Around the row where it passes ½ the numbers zᵢ are built outwards, each from its neighbour.
        let middle = rows.iter().position(|(complement, alpha)| alpha < complement).unwrap_or(last);
        let mut z = alloc::vec![S::one(); row.len()];
        for i in middle + 1..=last {
            z[i] = z[i - 1].clone() * (rows[i - 1].1.clone() / rows[i].0.clone());
        }
        for i in (0..middle).rev() {
            z[i] = z[i + 1].clone() * (rows[i + 1].0.clone() / rows[i].1.clone());
        }
        let (mut moved, mut sum) = (V::zero(), S::zero());
        let sign = |i: usize| if i.abs_diff(middle).is_multiple_of(2) { S::one() } else { -S::one() };
        for i in 0..=last {
            moved.add_scaled(&(sign(i) * z[i].clone()), &row[i]);
            sum = sum + z[i].clone();
        }
        moved.scale(&(S::one() / sum));
        for i in 0..=last {
            row[i].add_scaled(&-sign(i), &moved);
        }
        let mut replaced = alloc::vec![V::zero(); last];
        for i in 0..middle {
            let mut point = row[i].clone();
            if i > 0 {
                point.add_scaled(&-rows[i].0.clone(), &replaced[i - 1]);
            }
            point.scale(&(S::one() / rows[i].1.clone()));
            replaced[i] = point;
        }
        for i in (middle + 1..=last).rev() {
            let mut point = row[i].clone();
            if i < last {
                point.add_scaled(&-rows[i].1.clone(), &replaced[i]);
            }
            point.scale(&(S::one() / rows[i].0.clone()));
            replaced[i - 1] = point;
        }
        Some(Removal { copy, first: first as isize, replaced, moved })
    }

    /// The spline after removals that do not touch the same points.
    fn without(&self, removals: &[Removal<V>]) -> Result<Spline<V, S>> {
        let n = self.points().len();
        let mut points: Vec<Option<V>> = self.points().iter().cloned().map(Some).collect();
        let mut knots: Vec<Option<S>> = self.own_knots().iter().cloned().map(Some).collect();
        let mut passed_the_seam = 0;
        for removal in removals {
            let end = removal.first + removal.replaced.len() as isize;
            let place = |i: isize| i.rem_euclid(n as isize) as usize;
            for (i, point) in (removal.first..).zip(&removal.replaced) {
                points[place(i)] = Some(point.clone());
            }
            points[place(end)] = None;
            knots[removal.copy.own] = None;
            passed_the_seam += usize::from(end >= n as isize);
        }
        let mut points: Vec<V> = points.into_iter().flatten().collect();
        // A point that went beyond the seam counts as gone at its end, not at its start.
        if self.is_closed() && !points.is_empty() {
            let count = points.len();
            points.rotate_right(passed_the_seam % count);
        }
        self.alike(knots.into_iter().flatten().collect(), self.degree(), points)
    }
}

impl<V: Vector<f64>> Spline<V> {
    /// The spline without as many knots as the tolerance allows, cheapest first, and the proven distance.
    pub(crate) fn thin(&self, tolerance: f64, measure: &impl Measure<V>) -> Result<(Spline<V>, f64)> {
        let mut spline = self.canonical()?;
        let p = spline.degree();
        // What each span between neighbouring knots has been moved by so far.
        let mut spent = alloc::vec![0.0; spline.own_knots().len()];
        loop {
            let cost = |removal: &Removal<V>| {
                // The control points that act where the curve changes.
                let place = removal.copy.place as isize;
                let reach = place - 2 * p as isize - 1..=place + p as isize + 1;
                let there =
                    |i: &isize| spline.is_closed() || usize::try_from(*i).is_ok_and(|i| i < spline.points().len());
                let around: Vec<V> = reach.filter(there).map(|i| spline.point(i).clone()).collect();
                let near = measure.near(&around, &removal.replaced)?;
                Some(near.size(&removal.moved) + near.slack(p))
            };
            let mut offers: Vec<(f64, Removal<V>)> = (spline.copies().into_iter())
                .filter_map(|copy| spline.removal(copy))
                .filter_map(|removal| Some((cost(&removal)?, removal)))
                .filter(|(cost, _)| *cost <= tolerance)
                .collect();
            // A stable sort: among equals the first knot goes first.
            offers.sort_by(|a, b| a.0.total_cmp(&b.0));
            let (m, mut touched) = (spent.len(), alloc::vec![false; spent.len()]);
            let mut taken: Vec<Removal<V>> = Vec::new();
            let mut count = spline.points().len();
            for (cost, removal) in offers {
                // The spans that the moved points act on; modulo the period of a closed spline.
                let spans = removal.copy.own as isize - p as isize - 1..removal.copy.own as isize + p as isize + 1;
                let turn = if spline.is_closed() { m as isize - 1 } else { isize::MAX };
                let spans: Vec<usize> = (spans.map(|i| if spline.is_closed() { i.rem_euclid(turn) } else { i }))
                    .filter_map(|i| usize::try_from(i).ok())
                    .filter(|i| *i < m)
                    .collect();
                let worst = spans.iter().fold(0.0, |worst: f64, i| if spent[*i] > worst { spent[*i] } else { worst });
                let free = spans.iter().all(|i| !touched[*i]);
                if !free || worst + cost > tolerance || spline.is_closed() && count < p + 2 {
                    continue;
                }
                for i in spans {
                    touched[i] = true;
                    spent[i] = worst + cost;
                }
                count -= 1;
                taken.push(removal);
            }
            if taken.is_empty() {
                break;
            }
            let mut gone: Vec<usize> = taken.iter().map(|removal| removal.copy.own).collect();
            gone.sort_unstable();
            for own in gone.into_iter().rev() {
                // Both spans beside the knot become one.
                let after = spent.remove(own);
                if own > 0 && after > spent[own - 1] {
                    spent[own - 1] = after;
                }
            }
            spline = spline.without(&taken)?;
        }
        let reached = spent.iter().fold(0.0, |most: f64, x| if *x > most { *x } else { most });
        Ok((spline, reached))
    }
}

impl<const D: usize> BSpline<D> {
    /// The curve without as many knots as the tolerance allows, the cheapest first, and the distance that was reached: at every
    /// parameter the curves are at most that far apart.
    ///
    /// The ends of the domain stay, and so do the end points of a clamped curve. Of the seam of a closed curve one knot stays.
    ///
    /// *Cost.* O(n log n + n p) a pass; a pass takes a fixed share of what can go. *Error.* The bound is proven: the sum of the moves of the
    /// control points that act on a span, with what rounding may add, 16 (p + 1) u of their size for each. Below that nothing
    /// is removed.
    ///
    /// *Degenerate input.* A curve that nothing can be taken from comes back with bound 0; a closed curve keeps p + 1 points.
    ///
    /// *Source.* Tiller 1992; Eck and Hadenfeld 1995; Lyche and Mørken 1987.
    ///
    /// ```
    /// use lath::curve::BSpline;
    ///
    /// let curve = BSpline::clamped(2, [[0.0, 0.0], [2.0, 4.0], [4.0, 0.0]])?;
    /// let (same, bound) = curve.insert_knots(&[0.25, 0.5, 0.5])?.remove_knots(1e-12)?;
    /// assert_eq!(same.control_points().len(), 3);
    /// assert!(bound.is_proven() && bound.value() < 1e-13);
    /// # Ok::<(), lath::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// Q001 unless the tolerance is a positive finite number.
    pub fn remove_knots(&self, tolerance: f64) -> Result<(BSpline<D>, Bound)> {
        check_tolerance(tolerance)?;
        let (spline, reached) = self.to_spline().thin(tolerance, &Points::of(self.control_points()))?;
        Ok((BSpline::from_spline(spline)?, Bound::Proven(reached)))
    }
}
