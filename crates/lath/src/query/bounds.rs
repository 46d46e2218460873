//! The box around a curve.

use crate::basis::bernstein::split_in_place;
use crate::basis::rational::balance;
use crate::curve::Curve;
use crate::knot::Side;
use crate::num::Bound;
use crate::space::{Bounds, Vector, Weighted, distance};
use alloc::vec::Vec;

/// How much of its own size the box may be too large: 2⁻⁴⁰.
const SLACK: f64 = 1.0 / (1u64 << 40) as f64;

/// The box around the curve, and by how much it may be too large along its widest axis.
///
/// *Idea.* A Bézier piece lies in the box of its control points, rational ones with weights that are not negative too, and its end points
/// are on the curve. Pieces whose control points stand out of the box known so far are halved; the gap shrinks by four each time.
///
/// *Cost.* O(pieces · p) for most curves, about 20 halvings of O(p²) for each extremum inside a piece.
///
/// *Error.* Proven for piecewise polynomial and rational curves: the box contains the pieces, and is at most 2⁻⁴⁰ of its own size and the
/// rounding of the halvings too large; exactly tight where it ends at an end of a piece. An evaluated point may stand out by the
/// rounding of its evaluation. Points that overflow on the way give an infinite bound. Other curves are sampled: an estimate.
///
/// ```
/// use lath::{curve::Bezier, query::bounds};
///
/// let arch = Bezier::new([[0.0, 0.0], [1.0, 2.0], [2.0, 0.0]])?;
/// let (bounds, bound) = bounds(&arch);
/// assert_eq!((bounds.lo, bounds.hi[0]), ([0.0, 0.0], 2.0));
/// assert!((bounds.hi[1] - 1.0).abs() <= bound.value());
/// assert!(bound.is_proven() && bound.value() <= 1e-11);
/// # Ok::<(), lath::error::Error>(())
/// ```
pub fn bounds<const D: usize>(curve: &dyn Curve<D>) -> (Bounds<D>, Bound) {
    // First the points that are certainly on the curve, so that few pieces stand out afterwards.
    let mut ends: Option<Bounds<D>> = None;
    let mut reach = |end: &[f64; D]| ends.get_or_insert(Bounds::at(*end)).include(end);
    let polynomial = curve.bezier_pieces(&mut |piece| {
        [piece.points.first(), piece.points.last()].into_iter().flatten().for_each(&mut reach);
    });
    let exact = polynomial
        || curve.rational_pieces(&mut |piece| {
            [piece.points.first(), piece.points.last()].into_iter().flatten().for_each(|end| reach(&end.point));
        });
    let Some(reached) = ends.filter(|_| exact) else {
        return sampled(curve);
    };
    let mut found = Found { reached, excess: 0.0 };
    if polynomial {
        let mut values: Vec<[f64; 1]> = Vec::new();
        curve.bezier_pieces(&mut |piece| {
            found.widen(&mut values, &mut |values, axis, sign| {
                values.clear();
                values.extend(piece.points.iter().map(|point| [sign * point[axis]]));
            });
        });
    } else {
        let mut values: Vec<Weighted<1>> = Vec::new();
        curve.rational_pieces(&mut |piece| {
            found.widen(&mut values, &mut |values, axis, sign| {
                values.clear();
                let along = |point: &Weighted<D>| Weighted { point: [sign * point.point[axis]], weight: point.weight };
                values.extend(piece.points.iter().map(along));
            });
        });
    }
    // An end of a piece that overflowed.
    if found.reached.lo.iter().chain(&found.reached.hi).any(|x| !x.is_finite()) {
        found.excess = f64::INFINITY;
    }
    (found.reached, Bound::Proven(found.excess))
}

/// The box so far, and by how much it may be too large.
struct Found<const D: usize> {
    reached: Bounds<D>,
    excess: f64,
}

impl<const D: usize> Found<D> {
    /// Takes in one piece; `project` fills in its coordinates along an axis, times a sign.
    fn widen<V: Height>(&mut self, values: &mut Vec<V>, project: &mut dyn FnMut(&mut Vec<V>, usize, f64)) {
        for axis in 0..D {
            let size = self.reached.hi[axis] - self.reached.lo[axis];
            for sign in [1.0, -1.0] {
                let known = if sign > 0.0 { self.reached.hi[axis] } else { -self.reached.lo[axis] };
                project(values, axis, sign);
                if values.iter().all(|value| value.height() <= known) {
                    continue;
                }
                let rounding = rounding(values);
                let (top, over) = highest(values, known, size * SLACK, 60);
                let (top, over) = (top + rounding, over + rounding);
                if over > self.excess {
                    self.excess = over;
                }
                if sign > 0.0 { self.reached.hi[axis] = top } else { self.reached.lo[axis] = -top }
            }
        }
    }
}

/// A control point on a line.
trait Height: Vector<f64> {
    /// How much more a halving rounds than one of plain numbers.
    const ROUNDING: f64;
    /// How high it is; one without weight is no obstacle.
    fn height(&self) -> f64;
    /// Prepares a piece for being halved.
    fn balance(_piece: &mut [Self]) {}
}

impl Height for [f64; 1] {
    const ROUNDING: f64 = 1.0;
    fn height(&self) -> f64 {
        self[0]
    }
}

impl Height for Weighted<1> {
    // Rounding of the weights shifts the point between its neighbours, besides its own.
    const ROUNDING: f64 = 4.0;
    fn height(&self) -> f64 {
        if self.weight > 0.0 { self.point[0] } else { f64::NEG_INFINITY }
    }
    fn balance(piece: &mut [Self]) {
        balance(piece);
    }
}

/// An upper bound of a Bernstein polynomial or quotient, at most `slack` above what it or `known` reaches, and how much it may be above.
fn highest<V: Height>(values: &mut [V], known: f64, slack: f64, depth: usize) -> (f64, f64) {
    let ends = [values.first(), values.last()].into_iter().flatten();
    let known = ends.fold(known, |top, end| if end.height() > top { end.height() } else { top });
    let hull = values.iter().fold(known, |top, value| if value.height() > top { value.height() } else { top });
    let over = hull - known;
    // An infinite hull would never shrink.
    if over <= slack || depth == 0 || !over.is_finite() {
        return (hull, over);
    }
    V::balance(values);
    let mut right = split_in_place(values, (&0.5, &0.5));
    let (left_top, left_over) = highest(values, known, slack, depth - 1);
    let (top, right_over) = highest(&mut right, left_top, slack, depth - 1);
    (top, if left_over > right_over { left_over } else { right_over })
}

/// What halvings may have rounded away from points of this magnitude; the last term is for those so small that a half of them is
/// zero.
fn rounding<V: Height>(values: &[V]) -> f64 {
    let size = values.iter().map(|value| value.height().abs()).filter(|size| size.is_finite());
    let largest = size.fold(0.0, |most: f64, size| if size > most { size } else { most });
    let steps = 60.0 * values.len() as f64 * V::ROUNDING;
    steps * f64::EPSILON * largest + steps * f64::from_bits(1)
}

/// The box of many samples, for curves that cannot prove anything.
fn sampled<const D: usize>(curve: &dyn Curve<D>) -> (Bounds<D>, Bound) {
    const SAMPLES: u32 = 256;
    let at = |t: f64, side: Side| {
        let mut point = [[0.0; D]];
        curve.jet_into(t, side, &mut point);
        point[0]
    };
    let mut reached = Bounds::at(at(curve.domain().start, Side::Right));
    let mut step = 0.0;
    for pair in curve.breaks().windows(2) {
        let mut last = at(pair[0], Side::Right);
        for k in 1..=SAMPLES {
            let u = f64::from(k) / f64::from(SAMPLES);
            let point = at(pair[0] * (1.0 - u) + pair[1] * u, if k < SAMPLES { Side::Right } else { Side::Left });
            reached.include(&point);
            let moved = distance(&last, &point);
            if moved > step {
                step = moved;
            }
            last = point;
        }
    }
    (reached, Bound::Estimate(step))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::curve::{Bezier, Hermite};
    use alloc::vec;

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
    fn numbers_at_the_edge_end_and_stay_inside() {
        let tiny = f64::from_bits(1);
        let (found, bound) = bounds(&Bezier::new([[0.0], [tiny], [tiny], [0.0]]).unwrap());
        assert!(found.hi[0] >= tiny && bound.value() < 1e-300, "{found:?}");
        // Tangents that overflow in Bernstein form: a box all the same, and at once.
        let wild = Hermite::new(vec![-1e300, 1e300], [[0.0], [1.0]], [[1e298], [-1e298]]).unwrap();
        let (found, bound) = bounds(&wild);
        assert!(found.lo[0] <= 0.0 && found.hi[0] >= 1.0 && !bound.value().is_nan(), "{found:?} {bound:?}");
    }

    #[test]
    fn a_constant_curve_has_an_empty_box() {
        let (found, bound) = bounds(&Bezier::new([[3.0, 4.0]; 4]).unwrap());
        assert_eq!((found.lo, found.hi, bound), ([3.0, 4.0], [3.0, 4.0], Bound::Proven(0.0)));
    }
}
