//! When the curve passes each point.

use crate::curve::check_increasing;
use crate::error::{Code, Count, Error, Number, Result};
use crate::space::{check_point, distance};
use alloc::format;
use alloc::vec::Vec;

/// The rule by which points get their parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Parameters<'a> {
    /// t = 0, 1, 2, …
    Uniform,
    /// The cumulated length of the polygon, in the units of the points.
    Chord,
    /// The cumulated square roots of the polygon's sides (E. T. Y. Lee, Choosing nodes in parametric curve interpolation,
    /// 1989): fewer wiggles where long and short sides meet.
    Centripetal,
    /// The cumulated sides to a power α ≥ 0 (E. T. Y. Lee 1989): α = 0 is uniform also for equal neighbours, ½ centripetal, 1 chord length, each to
    /// the bit; between them each parameter moves from one to the next, beyond 1 long sides take ever more of the time.
    Power(f64),
    /// These, strictly increasing.
    Given(&'a [f64]),
}

/// One parameter for each point; for a closed curve one more, where it returns to the first point.
///
/// *Cost.* O(n). *Error.* The sum of n lengths, roots or powers, each within a few u (of a power times the logarithm of the length); n u relative
/// in all. *Invariance:* a similarity multiplies all parameters by one factor.
///
/// ```
/// use lath::interpolate::{parameters, Parameters};
///
/// let points = [[0.0, 0.0], [3.0, 4.0], [3.0, 0.0]];
/// assert_eq!(parameters(&points, false, Parameters::Chord)?, [0.0, 5.0, 9.0]);
/// assert_eq!(parameters(&points, true, Parameters::Chord)?, [0.0, 5.0, 9.0, 12.0]);
/// assert_eq!(parameters(&points, true, Parameters::Uniform)?, [0.0, 1.0, 2.0, 3.0]);
/// # Ok::<(), lath::error::Error>(())
/// ```
///
/// # Errors
/// P001 for fewer than two points; P002 and P003 for coordinates, P003 also for a length that is out of scale; P004 with the
/// index of the second of two neighbours so close that the parameter cannot increase; for given parameters T001, T003, T004, T005;
/// Q002 for a power that is not finite, Q003 for a negative one.
pub fn parameters<const D: usize>(points: &[[f64; D]], closed: bool, rule: Parameters<'_>) -> Result<Vec<f64>> {
    let sides = points.len().saturating_sub(1) + usize::from(closed);
    if points.len() < 2 {
        return Err(Error::new(Code::P001, format!("a curve takes at least 2 points, not {}", points.len())));
    }
    let power = match rule {
        Parameters::Uniform => return Ok((0..=sides).map(|i| i as f64).collect()),
        Parameters::Given(given) => {
            if given.len() != sides + 1 {
                let message = format!("{}, but {} are needed", Count(given.len(), "parameter"), sides + 1);
                return Err(Error::new(Code::T004, message));
            }
            check_increasing(given)?;
            return Ok(given.to_vec());
        }
        Parameters::Chord => 1.0,
        Parameters::Centripetal => 0.5,
        Parameters::Power(power) if !power.is_finite() => {
            return Err(Error::new(Code::Q002, format!("the power of the sides is {power}")));
        }
        Parameters::Power(power) if power < 0.0 => {
            let message = format!("the power of the sides is {}, not from 0 on", Number(power));
            return Err(Error::new(Code::Q003, message));
        }
        Parameters::Power(power) => power,
    };
    let step = |side: f64| match power {
        0.5 => libm::sqrt(side),
        1.0 => side,
        _ => libm::pow(side, power),
    };
    for (index, point) in points.iter().enumerate() {
        check_point(index, point)?;
    }
    let mut t = 0.0;
    let mut out = Vec::with_capacity(sides + 1);
    out.push(t);
    for i in 0..sides {
        let j = if i + 1 < points.len() { i + 1 } else { 0 };
        let side = distance(&points[i], &points[j]);
        let next = t + step(side);
        if next >= 1e300 {
            return Err(
                Error::new(Code::P003, format!("the parameter behind point {i} would be {}", Number(next))).at(j)
            );
        }
        if next <= t {
            let message = match side {
                0.0 => format!("points {i} and {j} are the same"),
                _ => format!("points {i} and {j} are {} apart, too close at parameter {}", Number(side), Number(t)),
            };
            return Err(Error::new(Code::P004, message).at(j));
        }
        t = next;
        out.push(t);
    }
    Ok(out)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn fault(points: &[[f64; 2]], closed: bool, rule: Parameters<'_>) -> (Code, Option<usize>) {
        let error = parameters(points, closed, rule).unwrap_err();
        (error.code(), error.index())
    }

    #[test]
    fn every_fault_names_the_culprit() {
        let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
        assert_eq!(fault(&square, false, Parameters::Chord), (Code::P004, Some(2)));
        assert_eq!(fault(&square, false, Parameters::Centripetal), (Code::P004, Some(2)));
        assert_eq!(fault(&[[0.0, 0.0], [1.0, 0.0], [0.0, 0.0]], true, Parameters::Chord), (Code::P004, Some(0)));
        assert_eq!(fault(&[[0.0, 0.0], [1e10, 0.0], [1e10, 1e-10]], false, Parameters::Chord), (Code::P004, Some(2)));
        assert_eq!(fault(&[[0.0, 0.0]], false, Parameters::Uniform), (Code::P001, None));
        assert_eq!(fault(&[[0.0, 0.0], [f64::NAN, 0.0]], false, Parameters::Chord), (Code::P002, Some(1)));
        assert_eq!(fault(&[[-1e300, 0.0], [1e300, 0.0]], false, Parameters::Chord), (Code::P003, Some(1)));
        // Not its neighbour, which would seem too close behind so long a side.
        let huge = [[0.0, 0.0], [1e305, 0.0], [1.0, 0.0], [2.0, 0.0]];
        assert_eq!(fault(&huge, false, Parameters::Centripetal), (Code::P003, Some(1)));
        assert_eq!(fault(&square, false, Parameters::Given(&[0.0, 1.0, 1.0, 2.0])), (Code::T003, Some(2)));
        assert_eq!(fault(&square, true, Parameters::Given(&[0.0, 1.0, 2.0, 3.0])), (Code::T004, None));
        assert_eq!(fault(&square, false, Parameters::Given(&[0.0, 1.0, f64::NAN, 2.0])), (Code::T001, Some(2)));
    }

    #[test]
    fn powers_hold_the_other_rules() {
        let points = [[0.0, 0.0], [3.0, 4.0], [3.0, 0.0], [19.0, 0.0]];
        let by = |power, closed| parameters(&points, closed, Parameters::Power(power)).unwrap();
        for closed in [false, true] {
            assert_eq!(by(0.0, closed), parameters(&points, closed, Parameters::Uniform).unwrap());
            assert_eq!(by(0.5, closed), parameters(&points, closed, Parameters::Centripetal).unwrap());
            assert_eq!(by(1.0, closed), parameters(&points, closed, Parameters::Chord).unwrap());
        }
        assert_eq!(by(2.0, false), [0.0, 25.0, 41.0, 297.0]);
        let quarter = by(0.25, false);
        assert!((quarter[3] - quarter[2] - 2.0).abs() < 1e-15, "{quarter:?}");
        // With α = 0 equal neighbours do not matter; else they are refused, as far apart as they would count.
        let twice = [[0.0, 0.0], [1.0, 0.0], [1.0, 0.0]];
        assert_eq!(parameters(&twice, false, Parameters::Power(0.0)).unwrap(), [0.0, 1.0, 2.0]);
        assert_eq!(fault(&twice, false, Parameters::Power(0.1)), (Code::P004, Some(2)));
        assert_eq!(fault(&twice[..2], false, Parameters::Power(-0.5)), (Code::Q003, None));
        assert_eq!(fault(&twice[..2], false, Parameters::Power(f64::NAN)), (Code::Q002, None));
        assert_eq!(fault(&[[0.0, 0.0], [1e200, 0.0]], false, Parameters::Power(2.0)), (Code::P003, Some(1)));
        assert_eq!(fault(&[[0.0, 0.0], [1e-200, 0.0]], false, Parameters::Power(2.0)), (Code::P004, Some(1)));
    }

    #[test]
    fn tiny_and_huge_sides_keep_their_length() {
        let tiny = parameters(&[[0.0], [-5e-200]], false, Parameters::Chord).unwrap();
        assert_eq!(tiny, [0.0, 5e-200]);
        let huge = parameters(&[[0.0], [5e200]], false, Parameters::Chord).unwrap();
        assert_eq!(huge, [0.0, 5e200]);
    }
}
