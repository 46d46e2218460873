//! Kochanek–Bartels splines: tension, continuity and bias at every point.
//!
//! *Source.* D. Kochanek and R. Bartels, Interpolating splines with local tension, continuity, and bias control (1984),
//! eq. (8) and (9), with their correction for uneven parameters, (10).

use crate::basis::hermite::to_bernstein;
use crate::curve::BSpline;
use crate::error::{Code, Error, Result};
use crate::interpolate::catmull_rom::parabola_slope;
use crate::interpolate::chords::{Chords, Place};
use crate::knot::Knots;
use crate::space::IntoPoint;
use alloc::format;
use alloc::vec::Vec;

/// How an animator shapes a curve at its points; all zero is the Catmull–Rom spline over even parameters.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Tcb {
    /// 1 stops at the point, −1 goes twice as far.
    pub tension: f64,
    /// Other than 0: a corner; 1 and −1 turn the tangents towards or away from the chords.
    pub continuity: f64,
    /// 1 overshoots (follows the chord before the point), −1 undershoots.
    pub bias: f64,
}

/// The Kochanek–Bartels spline through the points, as a cubic B-spline with triple knots at the parameters: the directions in which
/// it arrives and leaves differ where `continuity` is not zero.
///
/// At an open end the missing chord is continued as in the parabola through the last three points, scaled by 1 − tension.
///
/// *Invariance:* affine for given parameters. *Cost.* O(n). C¹ in direction only if `continuity` is 0.
///
/// *Degenerate input.* Two points give the straight line (with tension 0).
///
/// ```
/// use lath::curve::Curve;
/// use lath::interpolate::{Tcb, kochanek_bartels};
/// use lath::knot::Side;
///
/// let corner = Tcb { continuity: -1.0, ..Tcb::default() };
/// let curve = kochanek_bartels([[0.0, 0.0], [1.0, 1.0], [2.0, 0.0]], vec![0.0, 1.0, 2.0], false, corner)?;
/// let (mut left, mut right) = ([[0.0; 2]; 2], [[0.0; 2]; 2]);
/// curve.jet_into(1.0, Side::Left, &mut left);
/// curve.jet_into(1.0, Side::Right, &mut right);
/// // Along the chords: the polygon's corner.
/// assert!((left[1][1] - 1.0).abs() < 1e-15 && (right[1][1] + 1.0).abs() < 1e-15);
/// # Ok::<(), lath::error::Error>(())
/// ```
///
/// # Errors
/// P001 for fewer than two points; T001, T003, T004, T005 for the parameters (one more than points if `closed`); P002, P003 for
/// coordinates; Q002 if a shape parameter is not finite.
pub fn kochanek_bartels<const D: usize>(
    points: impl IntoIterator<Item = impl IntoPoint<D>>,
    parameters: Vec<f64>,
    closed: bool,
    tcb: Tcb,
) -> Result<BSpline<D>> {
    let Tcb { tension, continuity, bias } = tcb;
    if let Some(x) = [tension, continuity, bias].iter().find(|x| !x.is_finite()) {
        return Err(Error::new(Code::Q002, format!("tension, continuity or bias is {x}")));
    }
    let chords = Chords::new(points, parameters, closed)?;
    let n = chords.points.len();
    // The slopes of arrival and departure.
    let slopes = |i: usize| -> ([f64; D], [f64; D]) {
        let place = chords.place(i);
        let axis = |arrive: bool, c: usize| match &place {
            Place::Inner((h0, d0), (h1, d1)) => {
                let side = if arrive { -1.0 } else { 1.0 };
                let before = (1.0 - tension) * (1.0 + side * continuity) * (1.0 + bias) / 2.0;
                let behind = (1.0 - tension) * (1.0 - side * continuity) * (1.0 - bias) / 2.0;
                // Sides of the polygon, weighted; by (10) they are covered in the mean of both intervals.
                2.0 * (before * (d0[c] * h0) + behind * (d1[c] * h1)) / (h0 + h1)
            }
            _ => (1.0 - tension) * parabola_slope(&place, c),
        };
        (core::array::from_fn(|c| axis(true, c)), core::array::from_fn(|c| axis(false, c)))
    };
    let mut control = Vec::with_capacity(3 * chords.count() + 1);
    for k in 0..chords.count() {
        let next = if k + 1 < n { k + 1 } else { 0 };
        let h = chords.parameters[k + 1] - chords.parameters[k];
        let (leave, arrive) = (slopes(k).1, slopes(next).0);
        let piece = to_bernstein(&chords.points[k], &leave, &chords.points[next], &arrive, &h);
        control.extend_from_slice(&piece[..3]);
    }
    control.push(chords.points[if closed { 0 } else { n - 1 }]);
    let t = &chords.parameters;
    let mut knots = alloc::vec![t[0]];
    knots.extend(t.iter().flat_map(|t| [*t; 3]));
    knots.push(t[t.len() - 1]);
    BSpline::new(Knots::new(knots, 3)?, control)
}
