//! A control point over finer knots, from those over coarser ones.
//!
//! The control point over the knots u_{i+1}, …, u_{i+p} is the blossom of the spline at these p arguments. Where the finer knots
//! contain all the coarser ones, some arguments are *old* (consecutive coarse knots, t_b, t_{b+1}, …) and the ν others *fresh*. Old arguments
//! need no work: only the ν + 1 coarse points whose arguments contain all old ones take part, and ν rounds of the triangle put in the
//! fresh ones. All fresh arguments lie between the coarse knots left and right of the old ones, so every step is a convex
//! combination, whatever the number of knots that come in at once.
//!
//! *Source.* L. Ramshaw 1987 for the blossom; T. Lyche and K. Mørken, Making the Oslo algorithm more efficient (1986), for leaving the
//! old arguments out.

use crate::basis::bernstein::weights;
use crate::num::Scalar;
use crate::refine::spline::Spline;
use crate::space::Vector;
use alloc::vec::Vec;

/// The triangle for ν fresh arguments beside the old ones, some rounds of it done.
#[derive(Clone)]
struct Triangle<'a, V, S> {
    knots: &'a [S],
    /// The place of the first old argument, the degree, and ν.
    place: (usize, usize, usize),
    points: Vec<V>,
}

impl<'a, S: Scalar, V: Vector<S>> Triangle<'a, V, S> {
    fn new(spline: &'a Spline<V, S>, before: usize, nu: usize) -> Self {
        let last = before as isize - 1;
        let points = (last - nu as isize..=last).map(|i| spline.point(i).clone()).collect();
        Triangle { knots: spline.knots().values(), place: (before, spline.degree(), nu), points }
    }

    /// The coarse knots around the old arguments, ν on each side, and none of them.
    fn knot(&self, k: usize) -> &'a S {
        let (before, p, nu) = self.place;
        if k < nu { &self.knots[before + k - nu] } else { &self.knots[before + p + k - 2 * nu] }
    }

    /// One round: puts in one argument.
    fn put(&mut self, x: &S) {
        let (nu, level) = (self.place.2, self.points.len() - 1);
        for k in 0..level {
            let (a, b) = (self.knot(nu + k - level), self.knot(nu + k));
            // Empty only where the shift of a period swallowed a span: then both points stand for the same place.
            if a < b {
                let (complement, u) = weights(a, b, x);
                self.points[k] = self.points[k].blend(&complement, &self.points[k + 1], &u);
            }
        }
        self.points.truncate(level);
    }
}

/// The blossom of the spline at p arguments: the coarse knots from place `before` on, p − ν of them, and the ν fresh ones.
///
/// *Cost.* ν(ν + 1)/2 blends. *Error.* E ≤ 5ν; with ν = 0 the point itself.
pub(crate) fn blossom<S: Scalar, V: Vector<S>>(spline: &Spline<V, S>, before: usize, fresh: &[S]) -> V {
    let mut triangle = Triangle::new(spline, before, fresh.len());
    fresh.iter().for_each(|x| triangle.put(x));
    triangle.points.swap_remove(0)
}

/// The blossoms at all fresh arguments but one, for each of them in order.
///
/// Half of the arguments are put in for the other half together, and so on down: O(ν² log ν) blends for all ν.
pub(crate) fn blossoms_without_one<S: Scalar, V: Vector<S>>(
    spline: &Spline<V, S>,
    before: usize,
    fresh: &[S],
) -> Vec<V> {
    let mut found = Vec::with_capacity(fresh.len());
    if let Some(rounds) = fresh.len().checked_sub(1) {
        without_one(Triangle::new(spline, before, rounds), fresh, &mut found);
    }
    found
}

fn without_one<S: Scalar, V: Vector<S>>(triangle: Triangle<'_, V, S>, fresh: &[S], found: &mut Vec<V>) {
    if fresh.len() == 1 {
        found.extend(triangle.points.into_iter().next());
        return;
    }
    let (left, right) = fresh.split_at(fresh.len() / 2);
    let mut for_left = triangle.clone();
    right.iter().for_each(|x| for_left.put(x));
    without_one(for_left, left, found);
    let mut for_right = triangle;
    left.iter().for_each(|x| for_right.put(x));
    without_one(for_right, right, found);
}

/// Knots in order, each with the mark whether it is fresh.
#[derive(Clone, Debug)]
pub(crate) struct Marked<S> {
    pub(crate) knots: Vec<(S, bool)>,
}

impl<S: Scalar> Marked<S> {
    /// How many of the first `end` knots are old.
    pub(crate) fn old(&self, end: usize) -> usize {
        self.knots[..end].iter().filter(|(_, fresh)| !fresh).count()
    }

    /// The place of the old knot with this number.
    pub(crate) fn place(&self, old: usize) -> usize {
        let mut places = self.knots.iter().enumerate().filter(|(_, (_, fresh))| !fresh).map(|(place, _)| place);
        places.nth(old).unwrap_or(self.knots.len())
    }

    /// The knots from one place up to another.
    pub(crate) fn values(&self, from: usize, to: usize) -> Vec<S> {
        self.knots[from..to].iter().map(|(t, _)| t.clone()).collect()
    }
}
