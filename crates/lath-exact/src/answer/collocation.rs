//! B-splines of any degree through given points: one equation between control points for each point.

use crate::answer::interpolation::check_parameters;
use crate::budget;
use crate::error::{Code, Error, Result};
use crate::parse::same_length;
use crate::rational::Rational;
use lath::basis::bspline;
use lath::error::{Code as Core, Limits};
use lath::knot::{Knots, Side};
use lath::num::{Banded, CyclicBanded};
use std::fmt;
use std::str::FromStr;

/// What happens at the ends of an interpolating B-spline of degree p.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SplineEnds {
    /// The ⌊p/2⌋ knots next to each end are left out.
    NotAKnot,
    /// The ⌊p/2⌋ derivatives from order ⌈(p+1)/2⌉ on are zero at each end.
    Natural,
    /// The curve returns to its first point; one more parameter than points.
    Closed,
}

impl fmt::Display for SplineEnds {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            SplineEnds::NotAKnot => "not-a-knot",
            SplineEnds::Natural => "natural",
            SplineEnds::Closed => "closed",
        })
    }
}

impl FromStr for SplineEnds {
    type Err = Error;

    /// Reads `not-a-knot`, `natural` or `closed`.
    fn from_str(text: &str) -> Result<SplineEnds> {
        match text {
            "not-a-knot" => Ok(SplineEnds::NotAKnot),
            "natural" => Ok(SplineEnds::Natural),
            "closed" => Ok(SplineEnds::Closed),
            _ => Err(Error::new(Code::X003, format!("no ends `{text}`; there are not-a-knot, natural, closed"))),
        }
    }
}

/// One equation: at `t`, the derivative of this order is Σ weight · control point.
#[derive(Clone, Debug, PartialEq)]
pub struct Equation {
    /// The parameter.
    pub t: Rational,
    /// The order of the derivative, 0 for a point.
    pub order: usize,
    /// The index of the first control point that weighs in; modulo their number if closed.
    pub first: usize,
    /// The weights from there on.
    pub weights: Vec<Rational>,
    /// What it is to be, one number a coordinate.
    pub right: Vec<Rational>,
}

/// An interpolating B-spline.
#[derive(Clone, Debug, PartialEq)]
pub struct Collocation {
    /// The degree p.
    pub degree: usize,
    /// t₀ < t₁ < …; one more than points if closed.
    pub parameters: Vec<Rational>,
    /// The points it passes.
    pub points: Vec<Vec<Rational>>,
    /// The conditions at its ends.
    pub ends: SplineEnds,
    /// All knots; of a closed curve those from p to p + n are its period.
    pub knots: Vec<Rational>,
    /// The equations that determine the control points.
    pub equations: Vec<Equation>,
    /// Its control points.
    pub control_points: Vec<Vec<Rational>>,
}

/// The B-spline of degree p through the points, in control points. Uniform parameters 0, 1, 2, … if none are given.
///
/// Odd degree: knots at the data. Even degree: knots at the middles between them, so that the data lie inside the spans.
///
/// *Cost.* O(n p²) operations; but digits grow with n.
///
/// ```
/// use lath_exact::{answer::{collocation, SplineEnds}, parse};
///
/// // A parabola through three points is met by degree 2 without inner knots.
/// let answer = collocation(&parse::rows("0; 1; 4")?, None, 2, SplineEnds::NotAKnot, &Default::default())?;
/// assert_eq!(answer.control_points, parse::rows("0; 0; 4")?);
/// # Ok::<(), lath_exact::error::Error>(())
/// ```
///
/// *Source.* C. de Boor, A Practical Guide to Splines (1978), ch. XIII.
///
/// # Errors
/// P001 for too few points; P005, T003, T004 as [`interpolation`](crate::answer::interpolation); N001 for a singular system; B001
/// where the budget is exceeded.
pub fn collocation(
    points: &[Vec<Rational>],
    parameters: Option<&[Rational]>,
    degree: usize,
    ends: SplineEnds,
    limits: &Limits<'_>,
) -> Result<Collocation> {
    same_length(points)?;
    let (n, closed) = (points.len(), ends == SplineEnds::Closed);
    if n < 2 {
        return Err(Error::new(Code::Core(Core::P001), format!("{n} points; a curve takes at least 2")));
    }
    let count = n + usize::from(closed);
    let parameters = match parameters {
        Some(given) => given.to_vec(),
        None => (0..count).map(|i| Rational::from(i as i64)).collect(),
    };
    check_parameters(&parameters, n, count)?;
    let (size, dimension) = (degree.saturating_add(1), points[0].len());
    let digits = budget::bits(parameters.iter().chain(points.iter().flatten())).saturating_add(4);
    let bits = digits.saturating_mul(budget::product(&[count, size]));
    budget::check_size(limits, budget::product(&[count, size.saturating_add(dimension)]), bits)?;
    budget::check(limits, budget::product(&[4, count, size, size.saturating_add(dimension)]), bits)?;

    let knots = if closed { closed_knots(&parameters, degree)? } else { open_knots(&parameters, degree, ends)? };
    let equations = if closed {
        (0..n).map(|j| equation(&knots, &parameters[j], 0, degree + j, points[j].clone())).collect()
    } else {
        open_equations(&knots, &parameters, points, ends)
    };
    let control_points = solve(&equations, degree, closed, dimension, limits)?;
    let knots = knots.values().to_vec();
    Ok(Collocation { degree, parameters, points: points.to_vec(), ends, knots, equations, control_points })
}

fn middle(a: &Rational, b: &Rational) -> Rational {
    (a + b) / Rational::from(2)
}

fn open_knots(t: &[Rational], degree: usize, ends: SplineEnds) -> Result<Knots<Rational>> {
    if ends == SplineEnds::NotAKnot {
        return Ok(Knots::from_data(t, degree)?);
    }
    let (n, size) = (t.len(), degree + 1);
    let mut all = vec![t[0].clone(); size];
    match degree % 2 {
        1 => all.extend_from_slice(&t[1..n - 1]),
        _ => all.extend(t.windows(2).map(|pair| middle(&pair[0], &pair[1]))),
    }
    all.extend(vec![t[n - 1].clone(); size]);
    Ok(Knots::new(all, degree)?)
}

/// One period, at the data or at the middles, extended on both sides.
fn closed_knots(t: &[Rational], degree: usize) -> Result<Knots<Rational>> {
    if degree % 2 == 1 {
        return Ok(Knots::periodic(t, degree)?);
    }
    let n = t.len() - 1;
    let length = &t[n] - &t[0];
    let before = middle(&(&t[n - 1] - &length), &t[0]);
    let mut period = vec![before.clone()];
    period.extend(t.windows(2).take(n - 1).map(|pair| middle(&pair[0], &pair[1])));
    period.push(before + length);
    Ok(Knots::periodic(&period, degree)?)
}

fn equation(knots: &Knots<Rational>, t: &Rational, order: usize, span: usize, right: Vec<Rational>) -> Equation {
    let weights = bspline::derivatives(knots, span, t, order).pop().unwrap_or_default();
    Equation { t: t.clone(), order, first: span - knots.degree(), weights, right }
}

/// The value at the start, its derivatives, the inner values, the derivatives at the end, its value.
fn open_equations(
    knots: &Knots<Rational>,
    t: &[Rational],
    points: &[Vec<Rational>],
    ends: SplineEnds,
) -> Vec<Equation> {
    let (n, p) = (t.len(), knots.degree());
    let row = |i: usize, order: usize| {
        let zero = || vec![Rational::from(0); points[i].len()];
        let right = if order == 0 { points[i].clone() } else { zero() };
        equation(knots, &t[i], order, knots.span(&t[i], Side::Right), right)
    };
    let orders: Vec<usize> = match ends {
        SplineEnds::Natural => (0..p / 2).map(|k| (p + 1).div_ceil(2) + k).collect(),
        _ => Vec::new(),
    };
    let mut all = vec![row(0, 0)];
    all.extend(orders.iter().map(|order| row(0, *order)));
    all.extend((1..n - 1).map(|i| row(i, 0)));
    all.extend(orders.iter().rev().map(|order| row(n - 1, *order)));
    all.push(row(n - 1, 0));
    all
}

fn solve(
    equations: &[Equation],
    degree: usize,
    closed: bool,
    dimension: usize,
    limits: &Limits<'_>,
) -> Result<Vec<Vec<Rational>>> {
    let (n, half) = (equations.len(), degree / 2);
    let mut control = vec![Vec::with_capacity(dimension); n];
    let column = |c: usize| -> Vec<[Rational; 1]> { equations.iter().map(|row| [row.right[c].clone()]).collect() };
    if closed {
        let mut matrix = CyclicBanded::new(n, half, half);
        for (j, row) in equations.iter().enumerate() {
            // At a knot the last function of an odd degree is zero. Column u stands for control point u + ⌊p/2⌋.
            for (k, weight) in row.weights.iter().enumerate().take(2 * half + 1) {
                matrix.add(j, k as isize - half as isize, weight.clone());
            }
        }
        for c in 0..dimension {
            limits.check_cancel()?;
            let mut x = column(c);
            matrix.clone().solve(&mut x)?;
            for (i, point) in control.iter_mut().enumerate() {
                point.push(x[(i + n - half % n) % n][0].clone());
            }
        }
        return Ok(control);
    }
    let mut matrix = Banded::new(n, degree, degree);
    for (i, row) in equations.iter().enumerate() {
        for (k, weight) in row.weights.iter().enumerate().filter(|(_, w)| **w != 0) {
            if !matrix.set(i, row.first + k, weight.clone()) {
                let message = format!("equation {i} at {} lies too far from its functions", row.t);
                return Err(Error::new(Code::Core(Core::N001), message).at(i));
            }
        }
    }
    let factored = matrix.factor()?;
    for c in 0..dimension {
        limits.check_cancel()?;
        let mut x = column(c);
        factored.solve(&mut x)?;
        for (point, [value]) in control.iter_mut().zip(x) {
            point.push(value);
        }
    }
    Ok(control)
}
