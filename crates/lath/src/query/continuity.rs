//! How smoothly the pieces of a curve join.

use crate::curve::Curve;
use crate::knot::Side;
use crate::space::norm;
use alloc::vec::Vec;
use core::fmt;

/// How a curve passes a break.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Continuity {
    /// The values of both sides differ: the curve is broken.
    Jump,
    /// C^k: derivatives up to the k-th agree, the next does not.
    Order(usize),
    /// All derivatives up to the degree agree, of rational pieces up to twice the degree: no break at all for either.
    Smooth,
}

impl fmt::Display for Continuity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Continuity::Jump => f.write_str("jump"),
            Continuity::Order(k) => write!(f, "C{k}"),
            Continuity::Smooth => f.write_str("smooth"),
        }
    }
}

/// How much two derivatives may differ, relative to what the neighbouring pieces move, and still be called equal.
const AGREEMENT: f64 = 1e-9;

/// Every inner break with the continuity found there; for a closed curve also its seam, at the domain's start.
///
/// *Idea.* The derivatives of both sides are compared, the k-th scaled by hᵏ/k! with h the shorter neighbouring interval, so
/// that it says how far the two pieces part.
///
/// *Cost.* O(p) jets a break. *Error.* A decision by tolerance, not a proof: differences up to 1e-9 of what the curve moves
/// nearby, or of the rounding of its coordinates, count as none.
///
/// ```
/// use lath::{curve::BSpline, knot::Knots, query::{continuity, Continuity}};
///
/// let knots = Knots::new(vec![0.0, 0.0, 0.0, 1.0, 2.0, 2.0, 3.0, 3.0, 3.0], 2)?;
/// let curve = BSpline::new(knots, [[0.0, 0.0], [1.0, 2.0], [3.0, 1.0], [4.0, 4.0], [5.0, 0.0], [6.0, 1.0]])?;
/// assert_eq!(continuity(&curve), [(1.0, Continuity::Order(1)), (2.0, Continuity::Order(0))]);
/// # Ok::<(), lath::error::Error>(())
/// ```
pub fn continuity<const D: usize>(curve: &dyn Curve<D>) -> Vec<(f64, Continuity)> {
    let breaks = curve.breaks();
    let mut joints: Vec<(f64, f64, f64)> = Vec::new();
    if let (true, [first, second, ..], [.., before, last]) = (curve.is_closed(), &breaks[..], &breaks[..]) {
        joints.push((*last, *first, shorter(second - first, last - before)));
    }
    joints.extend(breaks.windows(3).map(|b| (b[1], b[1], shorter(b[1] - b[0], b[2] - b[1]))));
    // Two quotients of degree p that agree to the order 2p are the same: the difference has a numerator of degree 2p.
    let order = if curve.is_rational() { 2 * curve.degree() } else { curve.degree() };
    let (mut left, mut right) = (alloc::vec![[0.0; D]; order + 1], alloc::vec![[0.0; D]; order + 1]);
    let mut found = Vec::with_capacity(joints.len());
    for (end, start, h) in joints {
        curve.jet_into(end, Side::Left, &mut left);
        curve.jet_into(start, Side::Right, &mut right);
        found.push((start, compare(&mut left, &mut right, h)));
    }
    found
}

fn shorter(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}

fn compare<const D: usize>(left: &mut [[f64; D]], right: &mut [[f64; D]], h: f64) -> Continuity {
    let mut scale = 1.0;
    let mut moved = 0.0;
    for k in 0..left.len() {
        if k > 0 {
            scale *= h / k as f64;
            for row in [&mut left[k], &mut right[k]] {
                *row = row.map(|x| x * scale);
                moved += norm(row);
            }
        }
    }
    let size = norm(&left[0]) + norm(&right[0]);
    let allowed = AGREEMENT * moved + 64.0 * f64::EPSILON * size;
    let parts = |k: usize| norm::<D>(&core::array::from_fn(|c| right[k][c] - left[k][c])) > allowed;
    match (0..left.len()).find(|&k| parts(k)) {
        None => Continuity::Smooth,
        Some(0) => Continuity::Jump,
        Some(k) => Continuity::Order(k - 1),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::curve::{BSpline, Hermite, Polyline};
    use crate::knot::Knots;
    use alloc::vec;

    fn orders<const D: usize>(curve: &dyn Curve<D>) -> Vec<Continuity> {
        continuity(curve).into_iter().map(|(_, order)| order).collect()
    }

    #[test]
    fn multiplicities_show() {
        let knots =
            Knots::new(vec![0., 0., 0., 0., 1., 2., 2., 3., 3., 3., 4., 4., 4., 4., 5., 5., 5., 5.], 3).unwrap();
        let points: Vec<[f64; 1]> = (0..14).map(|i| [f64::from(i * i % 7)]).collect();
        let curve = BSpline::new(knots, points).unwrap();
        use Continuity::{Jump, Order};
        assert_eq!(orders(&curve), [Order(2), Order(1), Order(0), Jump]);
    }

    #[test]
    fn seams_of_closed_curves_come_first() {
        let curve = BSpline::closed_uniform(3, [[0.0, -1.5], [1.5, 0.0], [0.0, 1.5], [-1.5, 0.0]]).unwrap();
        assert_eq!(continuity(&curve)[0], (0.0, Continuity::Order(2)));
        assert_eq!(orders(&curve), [Continuity::Order(2); 4]);
    }

    #[test]
    fn corners_and_places_without_a_break_are_told_apart() {
        let corner = Polyline::new([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [1.0, 2.0]]).unwrap();
        assert_eq!(orders(&corner), [Continuity::Order(0), Continuity::Smooth]);
        let still = Hermite::new(vec![0.0, 1.0, 2.0], [[5.0]; 3], [[0.0]; 3]).unwrap();
        assert_eq!(orders(&still), [Continuity::Smooth]);
    }
}
