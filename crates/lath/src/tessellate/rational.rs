//! Steps along a rational Bézier piece.
//!
//! *Balance.* Pieces are taken with equal end weights ([`balance`]), which spreads equal steps evenly over the arc.
//!
//! *Bound.* Let (A, W) be the homogeneous curve, A = Σ wᵢ(Pᵢ − O)Jᵢ, W = Σ wᵢJᵢ > 0, and cut [0, 1] into N steps. On a step let Ã, W̃ interpolate
//! A, W linearly. Q = Ã/W̃ runs along the chord, and C − Q = ((A − Ã) − (W − W̃)Q)/W, whose numerator is for each fixed Q the error of
//! linear interpolation of A − WQ, a polynomial of degree n. So, with r the greatest distance of a control point from O,
//!
//!   |C − Q| ≤ n(n−1)/(8N²) · max (|Δ²(wᵢ(Pᵢ − O))| + r |Δ²wᵢ|) / min wᵢ.
//!
//! As the parameter runs over the step, C covers the curve and Q the chord: it is their distance as sets of points.
//! O is the middle of the piece's end points. A piece that would take more than a few steps is halved first, so that they are short
//! only where the curve bends.
//!
//! *Source.* The bound is that of J. Zheng and T. Sederberg, Estimating tessellation parameter intervals for rational curves and surfaces (2000).

use crate::basis::bernstein::{eval_in_place, split_in_place};
use crate::basis::rational::balance;
use crate::curve::RationalPiece;
use crate::space::{Vector, Weighted, norm};
use alloc::vec::Vec;

/// Pieces that take more steps are halved.
const MOST: f64 = 4.0;

/// How often a piece may be halved.
const DEPTH: usize = 48;

/// A part of a piece that is cut into equal steps.
pub(crate) struct Part<const D: usize> {
    /// Its points, with balanced weights.
    points: Vec<Weighted<D>>,
    /// The part of the piece's own [0, 1] that it covers.
    ends: (f64, f64),
    /// What the weights were balanced by.
    ratio: f64,
    /// The number of steps.
    pub(crate) steps: f64,
    /// The deviation that they leave.
    pub(crate) deviation: f64,
}

impl<const D: usize> Part<D> {
    /// The point after k steps, inside, and where it is in the piece's [0, 1].
    pub(crate) fn at(&self, k: u64) -> (f64, [f64; D]) {
        let v = k as f64 / self.steps;
        let (rest, share) = (1.0 - v, self.ratio * v);
        let u = share / (rest + share);
        let point = eval_in_place(&mut self.points.clone(), (&rest, &v)).point;
        (self.ends.0 * (1.0 - u) + self.ends.1 * u, point)
    }

    /// The last point.
    pub(crate) fn last(&self) -> (f64, [f64; D]) {
        (self.ends.1, self.points.last().map_or([0.0; D], |point| point.point))
    }
}

/// Hands out the parts of a piece in order, each to be cut into equal steps within the tolerance, until one is refused.
pub(crate) fn parts<const D: usize>(
    piece: &RationalPiece<'_, D>,
    tolerance: f64,
    visit: &mut dyn FnMut(&Part<D>) -> bool,
) -> bool {
    cut(piece.points.to_vec(), (0.0, 1.0), tolerance, DEPTH, visit)
}

fn cut<const D: usize>(
    mut points: Vec<Weighted<D>>,
    ends: (f64, f64),
    tolerance: f64,
    depth: usize,
    visit: &mut dyn FnMut(&Part<D>) -> bool,
) -> bool {
    let mut balanced = points.clone();
    let ratio = balance(&mut balanced);
    let whole = deviation(&balanced);
    let steps = if whole <= tolerance { 1.0 } else { libm::ceil(libm::sqrt(whole / tolerance)) };
    if depth == 0 || steps <= MOST {
        let deviation = whole / steps / steps;
        return visit(&Part { points: balanced, ends, ratio, steps, deviation });
    }
    // The middle of the balanced piece, in the parameter that it came with.
    let (complement, u) = (1.0 / (1.0 + ratio), ratio / (1.0 + ratio));
    let middle = ends.0 * complement + ends.1 * u;
    let right = split_in_place(&mut points, (&complement, &u));
    cut(points, (ends.0, middle), tolerance, depth - 1, visit)
        && cut(right, (middle, ends.1), tolerance, depth - 1, visit)
}

/// The bound for one step.
fn deviation<const D: usize>(points: &[Weighted<D>]) -> f64 {
    let (Some(first), Some(last)) = (points.first(), points.last()) else { return 0.0 };
    let degree = points.len() as f64 - 1.0;
    let origin: [f64; D] = core::array::from_fn(|c| first.point[c] / 2.0 + last.point[c] / 2.0);
    let least =
        points.iter().fold(f64::INFINITY, |least, point| if point.weight < least { point.weight } else { least });
    let mut radius = 0.0;
    let row: Vec<([f64; D], f64)> = points
        .iter()
        .map(|Weighted { point, weight }| {
            let mut from: [f64; D] = core::array::from_fn(|c| point[c] - origin[c]);
            let distance = norm(&from);
            if distance > radius {
                radius = distance;
            }
            from.scale(&(weight / least));
            (from, weight / least)
        })
        .collect();
    let bend = row.windows(3).fold(0.0, |most: f64, b| {
        let second = norm::<D>(&core::array::from_fn(|c| (b[2].0[c] - b[1].0[c]) - (b[1].0[c] - b[0].0[c])));
        let bend = second + radius * ((b[2].1 - b[1].1) - (b[1].1 - b[0].1)).abs();
        if bend > most || bend.is_nan() { bend } else { most }
    });
    let whole = degree * (degree - 1.0) / 8.0 * bend;
    // What overflowed, or has a weight of zero, has no bound before it is halved.
    if whole.is_nan() { f64::INFINITY } else { whole }
}
