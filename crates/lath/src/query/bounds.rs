//! The box around a curve.

use crate::basis::bernstein::split_in_place;
use crate::curve::{Curve, Interval};
use crate::knot::Side;
use crate::num::Bound;
use crate::space::Bounds;
use alloc::vec::Vec;

/// How much of its own size the box may be too large: 2⁻⁴⁰.
const SLACK: f64 = 1.0 / (1u64 << 40) as f64;

/// The box around the curve, and by how much it may be too large along its widest axis.
///
/// *Idea.* A Bézier piece lies in the box of its control points, and its end points are on the curve. Pieces whose
/// control points stand out of the box known so far are halved; the gap shrinks by four each time.
///
/// *Cost.* O(pieces · p) for most curves, about 20 halvings of O(p²) for each extremum inside a piece.
///
/// *Error.* Proven for piecewise polynomial curves: the box contains the pieces, and is at most 2⁻⁴⁰ of its own size too
/// large. An evaluated point may stand out by the rounding of its evaluation. Other curves are sampled: an estimate.
///
/// ```
/// use lath::{curve::Bezier, query::bounds};
///
/// let arch = Bezier::new([[0.0, 0.0], [1.0, 2.0], [2.0, 0.0]])?;
/// let (bounds, bound) = bounds(&arch);
/// assert_eq!((bounds.lo, bounds.hi), ([0.0, 0.0], [2.0, 1.0]));
/// assert!(bound.is_proven() && bound.value() <= 1e-11);
/// # Ok::<(), lath::error::Error>(())
/// ```
pub fn bounds<const D: usize>(curve: &dyn Curve<D>) -> (Bounds<D>, Bound) {
    let Interval { start, .. } = curve.domain();
    let mut first = [[0.0; D]];
    curve.jet_into(start, Side::Right, &mut first);
    // First the points that are certainly on the curve, so that few pieces stand out afterwards.
    let mut reached = Bounds::at(first[0]);
    let exact = curve.bezier_pieces(&mut |piece| {
        for end in [piece.points.first(), piece.points.last()].into_iter().flatten() {
            reached.include(end);
        }
    });
    if !exact {
        return sampled(curve, reached);
    }
    let mut values: Vec<[f64; 1]> = Vec::new();
    let mut excess = 0.0;
    curve.bezier_pieces(&mut |piece| {
        for axis in 0..D {
            let size = reached.hi[axis] - reached.lo[axis];
            for sign in [1.0, -1.0] {
                let known = if sign > 0.0 { reached.hi[axis] } else { -reached.lo[axis] };
                values.clear();
                values.extend(piece.points.iter().map(|point| [sign * point[axis]]));
                let (top, over) = highest(&mut values, known, size * SLACK, 60);
                if over > excess {
                    excess = over;
                }
                if top > known {
                    if sign > 0.0 { reached.hi[axis] = top } else { reached.lo[axis] = -top }
                }
            }
        }
    });
    (reached, Bound::Proven(excess))
}

/// An upper bound of a Bernstein polynomial, at most `slack` above what it or `known` reaches, and how much it may be above.
fn highest(values: &mut [[f64; 1]], known: f64, slack: f64, depth: usize) -> (f64, f64) {
    let ends = [values.first(), values.last()].into_iter().flatten();
    let known = ends.fold(known, |top, end| if end[0] > top { end[0] } else { top });
    let hull = values.iter().fold(known, |top, value| if value[0] > top { value[0] } else { top });
    if hull - known <= slack || depth == 0 {
        return (hull, hull - known);
    }
    let mut right = split_in_place(values, (&0.5, &0.5));
    let (left_top, left_over) = highest(values, known, slack, depth - 1);
    let (top, right_over) = highest(&mut right, left_top, slack, depth - 1);
    (top, if left_over > right_over { left_over } else { right_over })
}

/// The box of many samples, for curves that cannot prove anything.
fn sampled<const D: usize>(curve: &dyn Curve<D>, mut reached: Bounds<D>) -> (Bounds<D>, Bound) {
    const SAMPLES: u32 = 256;
    let mut step = 0.0;
    let mut last = reached.lo;
    let mut point = [[0.0; D]];
    for pair in curve.breaks().windows(2) {
        for k in 0..=SAMPLES {
            let u = f64::from(k) / f64::from(SAMPLES);
            curve.jet_into(pair[0] * (1.0 - u) + pair[1] * u, Side::Right, &mut point);
            reached.include(&point[0]);
            let moved = crate::space::distance(&last, &point[0]);
            if k > 0 && moved > step {
                step = moved;
            }
            last = point[0];
        }
    }
    (reached, Bound::Estimate(step))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::curve::Bezier;

    #[test]
    fn an_extremum_inside_a_piece_is_found_to_the_slack() {
        // (u − 1/3)² has its minimum 0 at 1/3: Bernstein points 1/9, −2/9, 4/9.
        let curve = Bezier::new([[1.0 / 9.0], [-2.0 / 9.0], [4.0 / 9.0]]).unwrap();
        let (found, bound) = bounds(&curve);
        assert!(found.lo[0] <= 0.0 && found.lo[0] > -1e-12, "{found:?}");
        assert_eq!(found.hi, [4.0 / 9.0]);
        assert!(bound.is_proven() && bound.value() <= 1e-12);
    }

    #[test]
    fn a_constant_curve_has_an_empty_box() {
        let (found, bound) = bounds(&Bezier::new([[3.0, 4.0]; 4]).unwrap());
        assert_eq!((found.lo, found.hi, bound), ([3.0, 4.0], [3.0, 4.0], Bound::Proven(0.0)));
    }
}
