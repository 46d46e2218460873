//! Catmull–Rom and cardinal splines: slopes from the two neighbours.
//!
//! *Source.* E. Catmull and R. Rom, A class of local interpolating splines (1974); for uneven parameters P. Barry and
//! R. Goldman, A recursive evaluation algorithm for a class of Catmull–Rom splines (1988), whose slope at a point is that of the
//! parabola through it and its neighbours.

use crate::curve::Hermite;
use crate::error::{Code, Error, Result};
use crate::interpolate::chords::{Chords, Place, parabola_end, parabola_middle};
use crate::space::IntoPoint;
use alloc::format;
use alloc::vec::Vec;

/// The Catmull–Rom spline through the points: every slope is that of the parabola through a point and its two neighbours,
/// at an open end of the parabola through the last three points.
///
/// With centripetal parameters it makes no loops or cusps inside a piece (C. Yuksel, S. Schaefer and J. Keyser 2011).
/// C¹, local: a point moves four pieces.
///
/// *Invariance:* affine for given parameters. *Cost.* O(n). *Error.* A few u of the chords' slopes.
///
/// *Degenerate input.* Two points give the straight line.
///
/// ```
/// use lath::curve::Curve;
/// use lath::interpolate::catmull_rom;
///
/// let curve = catmull_rom([[0.0], [1.0], [4.0], [9.0]], vec![0.0, 1.0, 2.0, 3.0], false)?;
/// assert_eq!(curve.eval(1.5)?, [2.25]); // parabolas are reproduced
/// # Ok::<(), lath::error::Error>(())
/// ```
///
/// # Errors
/// P001 for fewer than two points; T001, T003, T004, T005 for the parameters (one more than points if `closed`); P002, P003 for
/// coordinates.
pub fn catmull_rom<const D: usize>(
    points: impl IntoIterator<Item = impl IntoPoint<D>>,
    parameters: Vec<f64>,
    closed: bool,
) -> Result<Hermite<D>> {
    cardinal(points, parameters, closed, 0.0)
}

/// The cardinal spline: Catmull–Rom with all slopes multiplied by 1 − tension; tension 1 stops at every point and draws the polygon.
///
/// *Invariance, cost, error, degenerate input* as [`catmull_rom`].
///
/// # Errors
/// As [`catmull_rom`]; Q002 for a tension that is not finite.
pub fn cardinal<const D: usize>(
    points: impl IntoIterator<Item = impl IntoPoint<D>>,
    parameters: Vec<f64>,
    closed: bool,
    tension: f64,
) -> Result<Hermite<D>> {
    if !tension.is_finite() {
        return Err(Error::new(Code::Q002, format!("the tension is {tension}")));
    }
    Chords::new(points, parameters, closed)?.hermite(|place, axis| (1.0 - tension) * parabola_slope(place, axis))
}

/// The slope of the parabola through a point and its neighbours, along one axis.
pub(crate) fn parabola_slope<const D: usize>(place: &Place<'_, D>, axis: usize) -> f64 {
    match place {
        Place::Inner(before, behind) => parabola_middle((before.0, before.1[axis]), (behind.0, behind.1[axis])),
        Place::End(near, far) => parabola_end((near.0, near.1[axis]), (far.0, far.1[axis])),
        Place::Alone(slope) => slope[axis],
    }
}

impl<const D: usize> Chords<D> {
    /// The curve whose slope at each point and along each axis is given by a rule.
    pub(crate) fn hermite(self, rule: impl Fn(&Place<'_, D>, usize) -> f64) -> Result<Hermite<D>> {
        let slopes: Vec<[f64; D]> = (0..self.points.len())
            .map(|i| {
                let place = self.place(i);
                core::array::from_fn(|axis| rule(&place, axis))
            })
            .collect();
        self.with_slopes(slopes)
    }

    /// The curve with these slopes.
    pub(crate) fn with_slopes(self, slopes: Vec<[f64; D]>) -> Result<Hermite<D>> {
        let make = if self.closed { Hermite::closed } else { Hermite::new };
        make(self.parameters, self.points, slopes)
    }
}
