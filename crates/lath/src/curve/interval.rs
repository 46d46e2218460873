//! Domains, and what happens outside them.

use crate::error::{Code, Error, Number, Result};
use crate::knot::Side;
use alloc::format;

/// A closed interval of parameters, start < end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// The least parameter.
    pub start: f64,
    /// The greatest parameter.
    pub end: f64,
}

/// What to answer for a parameter outside the domain.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Outside {
    /// An error (T002).
    #[default]
    Error,
    /// The curve's end, with its derivatives.
    Clamp,
    /// The first or last polynomial piece continued.
    Extrapolate,
    /// The curve repeated with the period end − start.
    Periodic,
}

impl Interval {
    /// end − start.
    pub fn length(&self) -> f64 {
        self.end - self.start
    }

    /// Whether t lies inside or at an end.
    pub fn contains(&self, t: f64) -> bool {
        self.start <= t && t <= self.end
    }

    /// The parameter at which to evaluate for t under a policy; t itself inside the domain.
    ///
    /// ```
    /// use lath::curve::{Interval, Outside};
    ///
    /// let domain = Interval { start: 1.0, end: 3.0 };
    /// assert_eq!(domain.resolve(7.5, Outside::Clamp)?, 3.0);
    /// assert_eq!(domain.resolve(7.5, Outside::Periodic)?, 1.5);
    /// assert_eq!(domain.resolve(0.5, Outside::Periodic)?, 2.5);
    /// assert!(domain.resolve(7.5, Outside::Error).is_err());
    /// # Ok::<(), lath::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// T001 for a parameter that is not finite; T002 outside under [`Outside::Error`].
    pub fn resolve(&self, t: f64, outside: Outside) -> Result<f64> {
        if !t.is_finite() {
            return Err(Error::new(Code::T001, format!("the parameter is {t}")));
        }
        if self.contains(t) {
            return Ok(t);
        }
        match outside {
            Outside::Error => {
                let (start, end) = (Number(self.start), Number(self.end));
                let message = format!("t = {} lies outside the domain [{start}, {end}]", Number(t));
                Err(Error::new(Code::T002, message))
            }
            Outside::Clamp => Ok(if t < self.start { self.start } else { self.end }),
            Outside::Extrapolate => Ok(t),
            Outside::Periodic => {
                // The remainder is exact; only its sum with the start is rounded, and must not pass the end.
                let rest = (t - self.start) % self.length();
                let wrapped = self.start + if rest < 0.0 { rest + self.length() } else { rest };
                Ok(if wrapped > self.end { self.end } else { wrapped })
            }
        }
    }
}

/// The index of the segment [tᵢ, tᵢ₊₁] of increasing breaks that answers for t; outside, the first or the last.
pub(crate) fn segment(breaks: &[f64], t: f64, side: Side) -> usize {
    let below = match side {
        Side::Right => breaks.partition_point(|b| *b <= t),
        Side::Left => breaks.partition_point(|b| *b < t),
    };
    below.saturating_sub(1).min(breaks.len().saturating_sub(2))
}

/// Refuses parameters that are not finite (T001), out of scale (T005) or not increasing (T003), and fewer than two (T004).
pub(crate) fn check_increasing(parameters: &[f64]) -> Result<()> {
    if parameters.len() < 2 {
        let message = format!("a curve takes at least 2 parameters, not {}", parameters.len());
        return Err(Error::new(Code::T004, message));
    }
    for (i, t) in parameters.iter().enumerate() {
        if !t.is_finite() {
            return Err(Error::new(Code::T001, format!("parameter {i} is {t}")).at(i));
        }
        if t.abs() > 1e300 {
            return Err(Error::new(Code::T005, format!("parameter {i} is {t:e}")).at(i));
        }
        if i > 0 && *t <= parameters[i - 1] {
            let message = format!("parameter {i} is {}, not above {}", Number(*t), Number(parameters[i - 1]));
            return Err(Error::new(Code::T003, message).at(i));
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn wrapping_never_leaves_the_domain() {
        let domain = Interval { start: 0.1, end: 0.7 };
        for k in -1000..1000 {
            let t = 0.1 + 0.6 * f64::from(k) + 1e-17;
            let wrapped = domain.resolve(t, Outside::Periodic).unwrap();
            assert!(domain.contains(wrapped), "{t} became {wrapped}");
        }
        assert_eq!(domain.resolve(0.7, Outside::Periodic).unwrap(), 0.7);
    }

    #[test]
    fn segments_by_side() {
        let breaks = [0.0, 1.0, 2.0];
        let both = |t| (segment(&breaks, t, Side::Left), segment(&breaks, t, Side::Right));
        assert_eq!([both(-1.0), both(0.0), both(1.0), both(2.0), both(3.0)], [(0, 0), (0, 0), (0, 1), (1, 1), (1, 1)]);
    }
}
