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

/// The blossom of the spline at p arguments: the coarse knots from place `before` on, p − ν of them, and the ν fresh ones.
///
/// *Cost.* ν(ν + 1)/2 blends. *Error.* E ≤ 5ν; with ν = 0 the point itself.
pub(crate) fn blossom<S: Scalar, V: Vector<S>>(spline: &Spline<V, S>, before: usize, fresh: &[S]) -> V {
    let (t_, p, nu) = (spline.knots().values(), spline.degree(), fresh.len());
    let last = before as isize - 1;
    let mut points: Vec<V> = (last - nu as isize..=last).map(|i| spline.point(i).clone()).collect();
    // The coarse knots around the old arguments, ν on each side, and none of them.
    let knot = |k: usize| if k < nu { &t_[before + k - nu] } else { &t_[before + p + k - 2 * nu] };
    for (round, x) in fresh.iter().enumerate() {
        let level = nu - round;
        for k in 0..level {
            let (a, b) = (knot(nu + k - level), knot(nu + k));
            // Empty only where the shift of a period swallowed a span: then both points stand for the same place.
            if a < b {
                let (complement, u) = weights(a, b, x);
                points[k] = points[k].blend(&complement, &points[k + 1], &u);
            }
        }
    }
    points.swap_remove(0)
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
