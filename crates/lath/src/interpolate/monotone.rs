//! Slopes that keep the shape: no overshoot, no wiggle that the data do not have.
//!
//! Both rules work along each axis by itself: where the data rise the curve rises, where they turn it turns, at the data point.
//! The price is curvature that jumps, and a slope of zero at every local extremum.

use crate::curve::Hermite;
use crate::error::Result;
use crate::interpolate::chords::{Chords, Place, parabola_end, parabola_middle};
use crate::space::IntoPoint;
use alloc::vec::Vec;

/// The monotone piecewise cubic of Fritsch and Butland: where neighbouring chords agree in sign, the slope is their weighted
/// harmonic mean, else zero.
///
/// *Source.* F. Fritsch and J. Butland, A method for constructing local monotone piecewise cubic interpolants (1984), eq. (3.2);
/// at open ends the parabola's slope, limited to keep the shape (F. Fritsch and R. Carlson 1980), as scipy's `PchipInterpolator`.
///
/// *Invariance:* scaling of each axis by itself, translation. *Cost.* O(n). C¹.
///
/// *Degenerate input.* Two points give the straight line; flat stretches stay flat.
///
/// ```
/// use lath::curve::Curve;
/// use lath::interpolate::pchip;
///
/// let step = pchip([[0.0], [0.0], [1.0], [1.0]], vec![0.0, 1.0, 2.0, 3.0], false)?;
/// assert_eq!(step.eval(0.5)?, [0.0]);
/// assert_eq!(step.eval(1.5)?, [0.5]);
/// # Ok::<(), lath::error::Error>(())
/// ```
///
/// # Errors
/// P001 for fewer than two points; T001, T003, T004, T005 for the parameters (one more than points if `closed`); P002, P003 for
/// coordinates.
pub fn pchip<const D: usize>(
    points: impl IntoIterator<Item = impl IntoPoint<D>>,
    parameters: Vec<f64>,
    closed: bool,
) -> Result<Hermite<D>> {
    Chords::new(points, parameters, closed)?.hermite(|place, axis| match place {
        Place::Inner((h0, d0), (h1, d1)) => harmonic((*h0, d0[axis]), (*h1, d1[axis])),
        Place::End((h0, d0), (h1, d1)) => {
            let (near, far) = (d0[axis], d1[axis]);
            let slope = parabola_end((*h0, near), (*h1, far));
            if sign(slope) != sign(near) {
                0.0
            } else if sign(near) != sign(far) && slope.abs() > 3.0 * near.abs() {
                3.0 * near
            } else {
                slope
            }
        }
        Place::Alone(slope) => slope[axis],
    })
}

/// The harmonic mean weighted by 2h₁ + h₀ and h₁ + 2h₀, zero where the signs differ.
fn harmonic((h0, before): (f64, f64), (h1, behind): (f64, f64)) -> f64 {
    if sign(before) != sign(behind) || before == 0.0 {
        return 0.0;
    }
    let (w0, w1) = (2.0 * h1 + h0, h1 + 2.0 * h0);
    // (w0 + w1)/(w0/before + w1/behind), arranged so that slopes of any size neither overflow nor vanish.
    let (small, large, w_small, w_large) =
        if before.abs() < behind.abs() { (before, behind, w0, w1) } else { (behind, before, w1, w0) };
    let ratio = small / large;
    small * ((w0 + w1) / (w_small + w_large * ratio))
}

/// The monotone piecewise cubic of Steffen: the parabola's slope, limited to twice the smaller neighbouring chord.
///
/// *Source.* M. Steffen, A simple method for monotonic interpolation in one dimension (1990), eq. (11), ends by (24) to (27).
///
/// *Invariance, cost, degenerate input, errors* as [`pchip`]; rounder than it, because the parabola's slope is kept where it can be.
///
/// ```
/// use lath::curve::Curve;
/// use lath::interpolate::steffen;
///
/// let curve = steffen([[0.0], [1.0], [4.0], [4.0]], vec![0.0, 1.0, 2.0, 3.0], false)?;
/// assert_eq!(curve.tangents()[1..3], [[2.0], [0.0]]);
/// # Ok::<(), lath::error::Error>(())
/// ```
///
/// # Errors
/// As [`pchip`].
pub fn steffen<const D: usize>(
    points: impl IntoIterator<Item = impl IntoPoint<D>>,
    parameters: Vec<f64>,
    closed: bool,
) -> Result<Hermite<D>> {
    Chords::new(points, parameters, closed)?.hermite(|place, axis| match place {
        Place::Inner((h0, d0), (h1, d1)) => {
            let (before, behind) = (d0[axis], d1[axis]);
            let slope = parabola_middle((*h0, before), (*h1, behind)).abs() * 0.5;
            (sign(before) + sign(behind)) * least(least(before.abs(), behind.abs()), slope)
        }
        Place::End((h0, d0), (h1, d1)) => {
            let near = d0[axis];
            let slope = parabola_end((*h0, near), (*h1, d1[axis]));
            if sign(slope) != sign(near) {
                0.0
            } else if slope.abs() > 2.0 * near.abs() {
                2.0 * near
            } else {
                slope
            }
        }
        Place::Alone(slope) => slope[axis],
    })
}

/// −1, 0 or 1.
fn sign(x: f64) -> f64 {
    f64::from(i8::from(x > 0.0) - i8::from(x < 0.0))
}

fn least(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}
