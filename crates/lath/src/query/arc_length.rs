//! From lengths along a curve to parameters, and back.

use crate::curve::{Curve, Interval};
use crate::error::{Code, Error, Limits, Number, Result};
use crate::num::Bound;
use crate::query::length::{Sum, bound};
use crate::query::measure::{Stretch, measure};
use alloc::format;
use alloc::vec::Vec;

/// A curve measured once, so that lengths along it can be turned into parameters: equal distances, constant speed.
///
/// *Cost.* Preparing is as [`length`](crate::query::length). Then O(log n) to find the stretch, up to 32 speeds for a length, and some 5 times as
/// many for a parameter, by Newton's method within a bracket. *Memory:* the expansion of each stretch, (p + 1)·D numbers.
///
/// *Error.* Lengths along the curve are within [`bound`](ArcLength::bound): the accuracy asked for, or as much more as rounding and
/// the budget made it. The ends are exact.
///
/// *Degenerate input.* Where the curve stands still any parameter of the rest has the same length, and the answer is one of
/// them. Jumps have no length.
///
/// *Source.* B. Guenter and R. Parent, Computing the arc length of parametric curves (1990), for stretches with quadrature; the error bound
/// as in [`length`](crate::query::length).
///
/// ```
/// use lath::{curve::{Bezier, Curve}, error::Limits, query::ArcLength};
///
/// // Half the length of this curve is far from t = ½.
/// let curve = Bezier::new([[0.0, 0.0], [0.0, 0.0], [0.0, 0.0], [8.0, 0.0]])?; // x = 8t³
/// let along = ArcLength::new(&curve, 1e-12, &Limits::default())?;
/// let t = along.parameter_at(1.0)?;
/// assert!((t - 0.5).abs() < 1e-12);
/// assert!((curve.eval(along.parameter_at(4.0)?)?[0] - 4.0).abs() < 1e-12);
/// assert!((along.length_to(0.5)? - 1.0).abs() < 1e-12);
/// assert_eq!(along.parameter_at(along.length())?, 1.0);
/// # Ok::<(), lath::error::Error>(())
/// ```
#[derive(Debug)]
pub struct ArcLength<const D: usize> {
    domain: Interval,
    stretches: Vec<Stretch<D>>,
    /// The length before each stretch, and the whole.
    before: Vec<f64>,
    bound: Bound,
}

impl<const D: usize> ArcLength<D> {
    /// Measures the curve; the lengths along it shall be within `accuracy`.
    ///
    /// # Errors
    /// As [`length`](crate::query::length).
    pub fn new(curve: &dyn Curve<D>, accuracy: f64, limits: &Limits<'_>) -> Result<ArcLength<D>> {
        let (stretches, proven) = measure(curve, accuracy, limits)?;
        let (mut sum, mut error) = (Sum::default(), 0.0);
        let mut before = Vec::with_capacity(stretches.len() + 1);
        before.push(0.0);
        for stretch in &stretches {
            sum.add(stretch.length);
            error += stretch.error;
            before.push(sum.value());
        }
        let bound = bound(sum.value(), error, proven)?;
        Ok(ArcLength { domain: curve.domain(), stretches, before, bound })
    }

    /// The length of the whole curve.
    pub fn length(&self) -> f64 {
        self.before[self.before.len() - 1]
    }

    /// How far any length along the curve may be off.
    pub fn bound(&self) -> Bound {
        self.bound
    }

    /// The length of the curve from its start to t.
    ///
    /// # Errors
    /// T001 for a parameter that is not finite, T002 outside the domain.
    pub fn length_to(&self, t: f64) -> Result<f64> {
        let t = self.domain.resolve(t, crate::curve::Outside::Error)?;
        let place = self.stretches.partition_point(|stretch| stretch.end < t);
        let Some(stretch) = self.stretches.get(place) else { return Ok(self.length()) };
        let (from, to) = (self.before[place], self.before[place + 1]);
        if t <= stretch.start {
            return Ok(from);
        }
        if t >= stretch.end {
            return Ok(to);
        }
        let z = ((t - stretch.start) - (stretch.end - t)) / (stretch.end - stretch.start);
        Ok(at_most(from + partial(stretch, z), to))
    }

    /// The parameter at which that much of the curve lies behind.
    ///
    /// # Errors
    /// T001 for a distance that is not finite; Q007 for one below 0 or above the [`length`](ArcLength::length).
    pub fn parameter_at(&self, distance: f64) -> Result<f64> {
        if !distance.is_finite() {
            return Err(Error::new(Code::T001, format!("the distance along the curve is {distance}")));
        }
        if distance < 0.0 || distance > self.length() {
            let message = format!("the distance {} on a curve of length {}", Number(distance), Number(self.length()));
            return Err(Error::new(Code::Q007, message));
        }
        if distance == 0.0 {
            return Ok(self.domain.start);
        }
        // The stretch whose end is the first that is not before the place.
        let place = self.before[1..].partition_point(|length| *length < distance);
        let Some(stretch) = self.stretches.get(place) else { return Ok(self.domain.end) };
        let (from, to) = (self.before[place], self.before[place + 1]);
        if distance >= to {
            return Ok(stretch.end);
        }
        let z = invert(stretch, distance - from);
        let v = 0.5 + 0.5 * z;
        let t = stretch.start * (1.0 - v) + stretch.end * v;
        Ok(at_most(if t > stretch.start { t } else { stretch.start }, stretch.end))
    }

    /// The parameters of `count` points at equal distances along the curve, both ends among them; of a single one the start.
    ///
    /// *Error.* Neighbours are equally far along the curve within [`bound`](ArcLength::bound) and a few roundings of the length.
    ///
    /// ```
    /// use lath::{curve::Bezier, error::Limits, query::ArcLength};
    ///
    /// let curve = Bezier::new([[0.0], [0.0], [9.0]])?; // 9t²
    /// let along = ArcLength::new(&curve, 1e-12, &Limits::default())?;
    /// let t = along.equal_steps(4, &Limits::default())?;
    /// assert_eq!((t[0], t[3]), (0.0, 1.0));
    /// assert!((9.0 * t[1] * t[1] - 3.0).abs() < 1e-12);
    /// # Ok::<(), lath::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// B001 above the budget of points; B002 when cancelled.
    pub fn equal_steps(&self, count: usize, limits: &Limits<'_>) -> Result<Vec<f64>> {
        limits.check_points(count as u64)?;
        let mut parameters = Vec::with_capacity(count);
        let last = count.saturating_sub(1);
        for i in 0..count {
            limits.check_cancel()?;
            parameters.push(match i {
                0 => self.domain.start,
                _ if i == last => self.domain.end,
                _ => self.parameter_at(at_most(self.length() * (i as f64 / last as f64), self.length()))?,
            });
        }
        Ok(parameters)
    }
}

fn at_most(x: f64, most: f64) -> f64 {
    if x < most { x } else { most }
}

/// The length of a stretch up to z, −1 ≤ z ≤ 1.
///
/// The rule that measures the whole misses no more on a part: the part's ellipse lies within that of the whole.
fn partial<const D: usize>(stretch: &Stretch<D>, z: f64) -> f64 {
    match &stretch.growth {
        Some((expansion, rule)) => expansion.integrate(-1.0, z, *rule),
        None => stretch.length * (0.5 + 0.5 * z),
    }
}

/// Where a stretch has grown to this length: −1 ≤ z ≤ 1.
fn invert<const D: usize>(stretch: &Stretch<D>, length: f64) -> f64 {
    let mut z = 2.0 * (length / stretch.length) - 1.0;
    let Some((expansion, _)) = &stretch.growth else { return z };
    let (mut lo, mut hi) = (-1.0, 1.0);
    for _ in 0..64 {
        let over = partial(stretch, z) - length;
        if over == 0.0 {
            break;
        }
        if over > 0.0 {
            hi = z
        } else {
            lo = z
        }
        let next = z - over / expansion.speed(z);
        // Newton's step where it stays in the bracket, halving where it does not, or is no number.
        let next = if lo < next && next < hi { next } else { 0.5 * lo + 0.5 * hi };
        let step = (next - z).abs();
        z = next;
        if step <= f64::EPSILON {
            break;
        }
    }
    z
}
