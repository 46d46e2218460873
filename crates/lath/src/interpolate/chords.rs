//! What local rules look at: the chords around a point.

use crate::curve::check_increasing;
use crate::error::{Code, Count, Error, Result};
use crate::space::{IntoPoint, collect};
use alloc::format;
use alloc::vec::Vec;

/// Checked points and parameters with the intervals h and the slopes δ of the chords between neighbours; of a closed
/// curve, the chord that returns is the last.
pub(crate) struct Chords<const D: usize> {
    pub(crate) points: Vec<[f64; D]>,
    pub(crate) parameters: Vec<f64>,
    pub(crate) closed: bool,
    h: Vec<f64>,
    slopes: Vec<[f64; D]>,
}

impl<const D: usize> Chords<D> {
    /// # Errors
    /// P001 for fewer than two points; T004 for another number of parameters than points (one more if closed); T001, T003,
    /// T005, P002, P003 for what is in them; P003 with the index of a chord whose slope overflows.
    pub(crate) fn new(
        points: impl IntoIterator<Item = impl IntoPoint<D>>,
        parameters: Vec<f64>,
        closed: bool,
    ) -> Result<Chords<D>> {
        let points = collect(points)?;
        if points.len() < 2 {
            return Err(Error::new(Code::P001, format!("a curve takes at least 2 points, not {}", points.len())));
        }
        if parameters.len() != points.len() + usize::from(closed) {
            let message = format!("{} for {}", Count(parameters.len(), "parameter"), Count(points.len(), "point"));
            return Err(Error::new(Code::T004, message));
        }
        check_increasing(&parameters)?;
        let h: Vec<f64> = parameters.windows(2).map(|pair| pair[1] - pair[0]).collect();
        let slope = |i: usize| -> [f64; D] {
            let next = &points[if i + 1 < points.len() { i + 1 } else { 0 }];
            core::array::from_fn(|c| (next[c] - points[i][c]) / h[i])
        };
        let slopes: Vec<[f64; D]> = (0..h.len()).map(slope).collect();
        if let Some(i) = slopes.iter().position(|slope| !slope.iter().all(|x| x.abs() <= 1e300)) {
            return Err(Error::new(Code::P003, format!("the slope from point {i} on overflows: {:?}", slopes[i])).at(i));
        }
        Ok(Chords { points, parameters, closed, h, slopes })
    }

    /// The number of chords.
    pub(crate) fn count(&self) -> usize {
        self.h.len()
    }

    /// Interval and slope of chord i; a closed curve continues on both sides, an open one has none there.
    pub(crate) fn get(&self, i: isize) -> Option<Chord<'_, D>> {
        let n = self.count() as isize;
        let i = if self.closed { i.rem_euclid(n) } else { i };
        let i = usize::try_from(i).ok()?;
        Some((*self.h.get(i)?, self.slopes.get(i)?))
    }
}

/// The interval and the slope of a chord.
pub(crate) type Chord<'a, const D: usize> = (f64, &'a [f64; D]);

/// Where a point stands among its chords: (h, slope) of the near and the far one at an end, of both sides inside.
pub(crate) enum Place<'a, const D: usize> {
    /// Between two chords.
    Inner(Chord<'a, D>, Chord<'a, D>),
    /// At an end, looking inwards.
    End(Chord<'a, D>, Chord<'a, D>),
    /// At the end of the only chord.
    Alone(&'a [f64; D]),
}

impl<const D: usize> Chords<D> {
    /// The place of point i.
    pub(crate) fn place(&self, i: usize) -> Place<'_, D> {
        match (self.get(i as isize - 1), self.get(i as isize)) {
            (Some(before), Some(behind)) => Place::Inner(before, behind),
            (None, Some(near)) => self.get(i as isize + 1).map_or(Place::Alone(near.1), |far| Place::End(near, far)),
            (Some(near), None) => self.get(i as isize - 2).map_or(Place::Alone(near.1), |far| Place::End(near, far)),
            // There are two points, so there is a chord.
            (None, None) => Place::Alone(&self.slopes[0]),
        }
    }
}

/// The slope at the end of the parabola through three points, seen from the end: near and far interval and slope.
pub(crate) fn parabola_end(near: (f64, f64), far: (f64, f64)) -> f64 {
    let (h0, m0) = near;
    let (h1, m1) = far;
    let whole = h0 + h1;
    m0 * ((h0 + whole) / whole) - m1 * (h0 / whole)
}

/// The slope at the middle of the parabola through three points.
pub(crate) fn parabola_middle(before: (f64, f64), behind: (f64, f64)) -> f64 {
    let whole = before.0 + behind.0;
    before.1 * (behind.0 / whole) + behind.1 * (before.0 / whole)
}
