//! The cubic spline through given points, in tangents and in control points.

use crate::budget;
use crate::error::{Code, Error, Result};
use crate::parse::{self, same_length};
use crate::rational::Rational;
use lath::basis::{blossom, hermite};
use lath::error::{Code as Core, Limits};
use lath::interpolate;
use lath::knot::Knots;
use std::fmt;
use std::str::FromStr;

/// What holds at one end.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Condition {
    /// Second derivative zero.
    Natural,
    /// The two pieces at this end are one cubic.
    NotAKnot,
    /// This first derivative.
    Clamped(Vec<Rational>),
    /// This second derivative.
    Second(Vec<Rational>),
}

impl FromStr for Condition {
    type Err = Error;

    /// Reads `natural`, `not-a-knot`, `clamped:1,1/2`, `second:0,-3`.
    fn from_str(text: &str) -> Result<Condition> {
        match text.split_once(':') {
            Some(("clamped", vector)) => Ok(Condition::Clamped(parse::fractions(vector)?)),
            Some(("second", vector)) => Ok(Condition::Second(parse::fractions(vector)?)),
            None if text == "natural" => Ok(Condition::Natural),
            None if text == "not-a-knot" => Ok(Condition::NotAKnot),
            _ => {
                let message =
                    format!("no condition `{text}`; there are natural, not-a-knot, clamped:X,Y,…, second:X,Y,…");
                Err(Error::new(Code::X003, message))
            }
        }
    }
}

impl fmt::Display for Condition {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (name, vector) = match self {
            Condition::Natural => return f.write_str("natural"),
            Condition::NotAKnot => return f.write_str("not-a-knot"),
            Condition::Clamped(vector) => ("clamped", vector),
            Condition::Second(vector) => ("second", vector),
        };
        let vector: Vec<String> = vector.iter().map(ToString::to_string).collect();
        write!(f, "{name}:{}", vector.join(","))
    }
}

/// What holds at both ends.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Ends {
    /// One condition at the start, one at the end.
    Open(Condition, Condition),
    /// First and second derivative agree at both ends; the values may differ.
    Cyclic,
    /// They agree with opposite sign.
    Anticyclic,
    /// The curve returns to its first point, C² there too; one more parameter than points.
    Closed,
}

impl fmt::Display for Ends {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Ends::Open(start, end) if start == end => write!(f, "{start}"),
            Ends::Open(start, end) => write!(f, "{start} … {end}"),
            Ends::Cyclic => f.write_str("cyclic"),
            Ends::Anticyclic => f.write_str("anticyclic"),
            Ends::Closed => f.write_str("closed"),
        }
    }
}

/// An interpolating cubic spline.
#[derive(Clone, Debug, PartialEq)]
pub struct Interpolation {
    /// t₀ < t₁ < …; one more than points if closed.
    pub parameters: Vec<Rational>,
    /// The points it passes.
    pub points: Vec<Vec<Rational>>,
    /// The conditions at its ends.
    pub ends: Ends,
    /// The first derivative by t at each point.
    pub tangents: Vec<Vec<Rational>>,
    /// All knots of the same curve as a B-spline of degree 3: the parameters, and three more on each side, which repeat the
    /// end interval, or the period if closed.
    pub knots: Vec<Rational>,
    /// Its control points: two more than points, or as many if closed.
    pub control_points: Vec<Vec<Rational>>,
}

/// The C² cubic spline through the points: its tangents by the system of the slopes, its control points by the blossoms of its
/// pieces. Uniform parameters 0, 1, 2, … if none are given.
///
/// *Cost.* O(n) operations; but digits grow with n: two a point are usual.
///
/// ```
/// use lath_exact::{answer::{interpolation, Condition, Ends}, parse};
///
/// let natural = Ends::Open(Condition::Natural, Condition::Natural);
/// let answer = interpolation(&parse::rows("0; 1; 0")?, None, natural, &Default::default())?;
/// assert_eq!(answer.tangents, parse::rows("3/2; 0; -3/2")?);
/// assert_eq!(answer.control_points, parse::rows("-3/2; 0; 3/2; 0; -3/2")?);
/// # Ok::<(), lath_exact::error::Error>(())
/// ```
///
/// # Errors
/// P001 for fewer than two points; P005 for rows of different length, also of the conditions; T003, T004 for the parameters; N001
/// for a singular system (anticyclic and cyclic ends know some); B001 where the budget is exceeded.
pub fn interpolation(
    points: &[Vec<Rational>],
    parameters: Option<&[Rational]>,
    ends: Ends,
    limits: &Limits<'_>,
) -> Result<Interpolation> {
    same_length(points)?;
    if points.len() < 2 {
        let message = format!("{} points; a curve takes at least 2", points.len());
        return Err(Error::new(Code::Core(Core::P001), message));
    }
    let (dimension, closed) = (points[0].len(), ends == Ends::Closed);
    let count = points.len() + usize::from(closed);
    let parameters = match parameters {
        Some(given) => given.to_vec(),
        None => (0..count).map(|i| Rational::from(i as i64)).collect(),
    };
    check_parameters(&parameters, points.len(), count)?;
    let digits = budget::bits(parameters.iter().chain(points.iter().flatten())).saturating_add(4);
    let bits = digits.saturating_mul(count as u64);
    budget::check_size(limits, budget::product(&[3, count, dimension]), bits)?;
    budget::check(limits, budget::product(&[20, count, dimension]), bits)?;

    let h: Vec<Rational> = parameters.windows(2).map(|pair| &pair[1] - &pair[0]).collect();
    let mut tangents = vec![Vec::with_capacity(dimension); points.len()];
    for c in 0..dimension {
        limits.check_cancel()?;
        let column: Vec<[Rational; 1]> = points.iter().map(|point| [point[c].clone()]).collect();
        let slopes = match &ends {
            Ends::Closed => interpolate::slopes_closed(&h, &column)?,
            Ends::Cyclic => interpolate::slopes(&h, &column, &interpolate::Ends::Cyclic)?,
            Ends::Anticyclic => interpolate::slopes(&h, &column, &interpolate::Ends::Anticyclic)?,
            Ends::Open(start, end) => {
                let both = interpolate::Ends::Open(one(start, c, dimension)?, one(end, c, dimension)?);
                interpolate::slopes(&h, &column, &both)?
            }
        };
        for (row, [slope]) in tangents.iter_mut().zip(slopes) {
            row.push(slope);
        }
    }
    let knots = knots(&parameters, closed)?;
    let control_points = control_points(&knots, points, &tangents);
    let knots = knots.values().to_vec();
    Ok(Interpolation { parameters, points: points.to_vec(), ends, tangents, knots, control_points })
}

pub(super) fn check_parameters(parameters: &[Rational], points: usize, wanted: usize) -> Result<()> {
    if parameters.len() != wanted {
        let message = format!("{} parameters for {points} points, which take {wanted}", parameters.len());
        return Err(Error::new(Code::Core(Core::T004), message));
    }
    match (1..wanted).find(|&i| parameters[i] <= parameters[i - 1]) {
        None => Ok(()),
        Some(i) => {
            let message = format!("parameter {i} is {}, not above {}", parameters[i], parameters[i - 1]);
            Err(Error::new(Code::Core(Core::T003), message).at(i))
        }
    }
}

/// One coordinate of a condition.
fn one(condition: &Condition, c: usize, dimension: usize) -> Result<interpolate::End<1, Rational>> {
    let coordinate = |vector: &[Rational]| match vector.get(c) {
        Some(x) if vector.len() == dimension => Ok([x.clone()]),
        _ => {
            let message = format!("`{condition}` has {} coordinates, the points {dimension}", vector.len());
            Err(Error::new(Code::Core(Core::P005), message))
        }
    };
    Ok(match condition {
        Condition::Natural => interpolate::End::Natural,
        Condition::NotAKnot => interpolate::End::NotAKnot,
        Condition::Clamped(vector) => interpolate::End::Clamped(coordinate(vector)?),
        Condition::Second(vector) => interpolate::End::Second(coordinate(vector)?),
    })
}

fn knots(parameters: &[Rational], closed: bool) -> Result<Knots<Rational>> {
    if closed {
        return Ok(Knots::periodic(parameters, 3)?);
    }
    let last = parameters.len() - 1;
    let (first, end) = (&parameters[1] - &parameters[0], &parameters[last] - &parameters[last - 1]);
    let step = |h: &Rational, i: i64| h * &Rational::from(i);
    let mut all: Vec<Rational> = (1..=3).rev().map(|i| &parameters[0] - &step(&first, i)).collect();
    all.extend_from_slice(parameters);
    all.extend((1..=3).map(|i| &parameters[last] + &step(&end, i)));
    Ok(Knots::new(all, 3)?)
}

/// Control point i is the blossom at the knots i + 1, i + 2, i + 3 of any piece that it weighs in on.
fn control_points(knots: &Knots<Rational>, points: &[Vec<Rational>], tangents: &[Vec<Rational>]) -> Vec<Vec<Rational>> {
    let (t, n) = (knots.values(), points.len());
    let count = if t.len() == n + 6 { n + 2 } else { n };
    let point = |i: usize| {
        let span = i.max(3);
        let (here, there) = (span - 3, (span - 2) % n);
        let h = &t[span + 1] - &t[span];
        let coordinate = |c: usize| {
            let of = |rows: &[Vec<Rational>], i: usize| [rows[i][c].clone()];
            let bezier = hermite::to_bernstein(
                &of(points, here),
                &of(tangents, here),
                &of(points, there),
                &of(tangents, there),
                &h,
            );
            let [x] = blossom::bezier(&bezier, &t[span], &t[span + 1], &t[i + 1..i + 4]);
            x
        };
        (0..points[0].len()).map(coordinate).collect()
    };
    (0..count).map(point).collect()
}
