//! How long a curve is.

use crate::basis::bernstein::split_in_place;
use crate::curve::Curve;
use crate::error::{Code, Error, Limits, Number, Result};
use crate::num::Bound;
use crate::space::{Vector, Weighted, distance};
use alloc::format;

/// The length of the curve, and how far it may be off.
///
/// *Idea.* A Bézier piece is at least as long as its chord and at most as long as its control polygon (it diminishes variation, also
/// with weights that are not negative, and by Crofton's formula a length is a mean of crossings); halving brings the two together by a factor of four. In between, (2 chord + (p − 1) polygon)/(p + 1) is a good guess (Gravesen, Adaptive
/// subdivision and the length and energy of Bézier curves, 1997).
///
/// *Cost.* O(p²) a halving, about √(length/accuracy) halvings for each curved piece.
///
/// *Error.* Proven for piecewise polynomial and rational curves, jumps not counted: within `accuracy`, up to rounding, or the bound says how much
/// more, if that many halvings pass the budget of points. Other curves: the length of a polyline of 256 steps a piece, an estimate.
///
/// ```
/// use lath::{curve::Bezier, error::Limits, query::length};
///
/// let line = Bezier::new([[0.0, 0.0], [3.0, 4.0]])?;
/// assert_eq!(length(&line, 1e-6, &Limits::default())?.0, 5.0);
/// # Ok::<(), lath::error::Error>(())
/// ```
///
/// # Errors
/// Q001 for an accuracy that is not positive and finite; P003 for a length that overflows; B002 when cancelled.
pub fn length<const D: usize>(curve: &dyn Curve<D>, accuracy: f64, limits: &Limits<'_>) -> Result<(f64, Bound)> {
    if !(accuracy > 0.0 && accuracy.is_finite()) {
        return Err(Error::new(Code::Q001, format!("the accuracy is {}", Number(accuracy))));
    }
    let domain = curve.domain();
    let mut total = Bracket { length: 0.0, slack: 0.0, halvings: 0 };
    let mut outcome = Ok(());
    let share = |start: f64, end: f64| 2.0 * accuracy * ((end - start) / domain.length());
    let mut exact = curve.bezier_pieces(&mut |piece| {
        if outcome.is_ok() {
            outcome = limits.check_cancel();
        }
        if outcome.is_ok() {
            total.add(&mut piece.points.to_vec(), share(piece.start, piece.end), 40, limits.max_points);
        }
    });
    exact = exact
        || curve.rational_pieces(&mut |piece| {
            if outcome.is_ok() {
                outcome = limits.check_cancel();
            }
            if outcome.is_ok() {
                total.add(&mut piece.points.to_vec(), share(piece.start, piece.end), 40, limits.max_points);
            }
        });
    outcome?;
    let (length, bound) = if exact { (total.length, Bound::Proven(total.slack)) } else { by_steps(curve) };
    // Also where control points of a piece overflow, of which nothing is known.
    if !(length.is_finite() && bound.value().is_finite()) {
        return Err(Error::new(Code::P003, "the length overflows"));
    }
    Ok((length, bound))
}

/// Sums of what was certainly there and of what may have been too much.
struct Bracket {
    length: f64,
    slack: f64,
    halvings: u64,
}

impl Bracket {
    fn add<V: Place>(&mut self, points: &mut [V], share: f64, depth: u32, budget: u64) {
        let (Some(first), Some(last)) = (points.first(), points.last()) else { return };
        let chord = first.to(last);
        let (mut polygon, mut corner) = (0.0, first);
        for point in points[1..].iter().filter(|point| point.counts()) {
            polygon += corner.to(point);
            corner = point;
        }
        if polygon - chord <= share || depth == 0 || self.halvings >= budget {
            let degree = points.len() as f64 - 1.0;
            let guess = (2.0 * chord + (degree - 1.0) * polygon) / (degree + 1.0);
            self.length += guess;
            let (below, above) = (guess - chord, polygon - guess);
            self.slack += if below > above { below } else { above };
            return;
        }
        self.halvings += 1;
        let mut right = split_in_place(points, (&0.5, &0.5));
        self.add(points, share * 0.5, depth - 1, budget);
        self.add(&mut right, share * 0.5, depth - 1, budget);
    }
}

/// A corner of a control polygon.
trait Place: Vector<f64> {
    /// The distance to another.
    fn to(&self, other: &Self) -> f64;
    /// Whether it pulls at the curve at all.
    fn counts(&self) -> bool;
}

impl<const D: usize> Place for [f64; D] {
    fn to(&self, other: &Self) -> f64 {
        distance(self, other)
    }
    fn counts(&self) -> bool {
        true
    }
}

impl<const D: usize> Place for Weighted<D> {
    fn to(&self, other: &Self) -> f64 {
        distance(&self.point, &other.point)
    }
    fn counts(&self) -> bool {
        self.weight > 0.0
    }
}

/// The polyline of equal steps, and what half as many steps would have missed.
fn by_steps<const D: usize>(curve: &dyn Curve<D>) -> (f64, Bound) {
    const STEPS: u32 = 256;
    let (mut fine, mut coarse) = (0.0, 0.0);
    for pair in curve.breaks().windows(2) {
        let at = |k: u32| {
            let u = f64::from(k) / f64::from(STEPS);
            let side = if k == STEPS { crate::knot::Side::Left } else { crate::knot::Side::Right };
            let mut point = [[0.0; D]];
            curve.jet_into(pair[0] * (1.0 - u) + pair[1] * u, side, &mut point);
            point[0]
        };
        for k in (0..STEPS).step_by(2) {
            let (a, b, c) = (at(k), at(k + 1), at(k + 2));
            fine += distance(&a, &b) + distance(&b, &c);
            coarse += distance(&a, &c);
        }
    }
    (fine, Bound::Estimate(fine - coarse))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::curve::{Bezier, Hermite};
    use alloc::vec;

    #[test]
    fn a_parabola_keeps_every_accuracy() {
        // y = x² on [−1, 1]: √5 + asinh(2)/2.
        let parabola = Bezier::new([[-1.0, 1.0], [0.0, -1.0], [1.0, 1.0]]).unwrap();
        let exact = libm::sqrt(5.0) + libm::asinh(2.0) / 2.0;
        for e in 1..9 {
            let accuracy = libm::pow(10.0, -f64::from(e));
            let (found, bound) = length(&parabola, accuracy, &Limits::default()).unwrap();
            assert!(bound.is_proven() && bound.value() <= accuracy, "{bound:?}");
            assert!((found - exact).abs() <= bound.value() + 1e-12, "{found} at {accuracy}");
        }
    }

    #[test]
    fn cusps_points_and_budgets_end() {
        // A cusp: out and back, twice the distance of its tip.
        let cusp = Bezier::new([[0.0], [1.0], [0.0]]).unwrap();
        let (found, _) = length(&cusp, 1e-9, &Limits::default()).unwrap();
        assert!((found - 1.0).abs() <= 1e-9, "{found}");
        let point = Bezier::new([[7.0, 7.0]; 4]).unwrap();
        assert_eq!(length(&point, 1e-9, &Limits::default()).unwrap().0, 0.0);
        let arch = Bezier::new([[0.0, 0.0], [1.0, 2.0], [2.0, 0.0]]).unwrap();
        let few = Limits { max_points: 10, ..Limits::default() };
        let (_, bound) = length(&arch, 1e-15, &few).unwrap();
        assert!(bound.value() > 1e-15 && bound.value() < 1.0);
        assert_eq!(length(&arch, 0.0, &few).unwrap_err().code(), Code::Q001);
    }

    #[test]
    fn pieces_that_overflow_have_no_length() {
        let wild = Hermite::new(vec![-1e300, 1e300], [[0.0], [1.0]], [[1e298], [-1e298]]).unwrap();
        assert_eq!(length(&wild, 1.0, &Limits::default()).unwrap_err().code(), Code::P003);
    }
}
