//! Interpolating B-splines of any degree.
//!
//! *Source.* de Boor, A Practical Guide to Splines (1978), ch. XIII; for the solution without pivoting de Boor and Pinkus
//! (1977); for solvability I. Schoenberg and A. Whitney (1953).
//!
//! Odd degree: knots at the data. Even degree: knots at the middles between data, so that the data lie inside the spans.
//! Every end has ⌊p/2⌋ conditions to give, or gives up ⌊p/2⌋ knots instead (not-a-knot).

use crate::basis::bspline::{derivatives, values};
use crate::curve::{BSpline, check_increasing};
use crate::error::{Code, Error, Number, Result};
use crate::knot::{Knots, Side};
use crate::num::{Banded, CyclicBanded};
use crate::space::{IntoPoint, collect};
use alloc::format;
use alloc::vec::Vec;

/// The greatest degree with not-a-knot ends: at degree 30 forty smooth points are still met within 1e-13 of their size.
const MAX_DEGREE: usize = 30;

/// The greatest degree with derivatives at an end: their rows are not totally positive, and from degree 18 on elimination loses
/// digits fast (measured: within 1e-13 up to 17, 1e-11 at 20, nothing at 28).
const MAX_BY_DERIVATIVES: usize = 15;

/// What an interpolating B-spline of degree p does at one end.
#[derive(Clone, Debug, PartialEq)]
pub enum BSplineEnd<const D: usize> {
    /// The ⌊p/2⌋ knots next to this end are left out.
    NotAKnot,
    /// The ⌊p/2⌋ derivatives from order ⌊p/2⌋ + 1 on are zero: for p = 3 and for p = 2 the second.
    Natural,
    /// ⌊p/2⌋ derivatives of given orders, increasing, each from 1 to p.
    Derivatives(Vec<(usize, [f64; D])>),
}

/// The B-spline of degree p through the points at the given parameters.
///
/// *Cost.* O(n p²) time, O(n p) memory; all coordinates in one sweep. *Error.* With not-a-knot ends the collocation matrix is
/// totally positive: the backward error is a few u · p, and the points are met within some u of their size. Control points carry
/// the matrix's condition, which grows with the degree and with the unevenness of the parameters.
///
/// *Invariance:* affine for given parameters.
///
/// *Degenerate input.* Degree 0 is piecewise constant with the steps at the middles; degree 1 the polygon.
///
/// ```
/// use lath::curve::Curve;
/// use lath::interpolate::{bspline, BSplineEnd};
///
/// // Six points of t⁵: not-a-knot ends reproduce it.
/// let t: Vec<f64> = (0..6).map(f64::from).collect();
/// let points: Vec<[f64; 1]> = t.iter().map(|t| [t * t * t * t * t]).collect();
/// let curve = bspline(points, t, 5, &BSplineEnd::NotAKnot, &BSplineEnd::NotAKnot)?;
/// assert!((curve.eval(2.5)?[0] - 97.65625).abs() < 1e-11);
/// # Ok::<(), lath::error::Error>(())
/// ```
///
/// # Errors
/// P001 for too few points; K006 for a degree above 30, or above 15 with derivatives at an end; T001, T003, T004, T005 for the parameters; P002, P003 for coordinates; C001 for
/// another number of end derivatives than ⌊p/2⌋ or orders that do not fit; P003 if the control points overflow.
pub fn bspline<const D: usize>(
    points: impl IntoIterator<Item = impl IntoPoint<D>>,
    parameters: Vec<f64>,
    degree: usize,
    start: &BSplineEnd<D>,
    end: &BSplineEnd<D>,
) -> Result<BSpline<D>> {
    let points = checked(points, &parameters, 0, degree)?;
    let (first, last) = (conditions(start, degree, "start")?, conditions(end, degree, "end")?);
    let share = degree / 2;
    let (t, n) = (&parameters, points.len());
    // Candidates for inner knots: the inner data, or all middles.
    let mut inner: Vec<f64> = match degree % 2 {
        1 => t[1..n - 1].to_vec(),
        _ => t.windows(2).map(|pair| middle(pair[0], pair[1])).collect(),
    };
    let given_up = |end: &BSplineEnd<D>| if matches!(end, BSplineEnd::NotAKnot) { share } else { 0 };
    let (drop_first, drop_last) = (given_up(start), given_up(end));
    if inner.len() < drop_first + drop_last {
        let least = drop_first + drop_last + n - inner.len();
        let message = format!("{n} points for degree {degree}, which takes at least {least} with these ends");
        return Err(Error::new(Code::P001, message));
    }
    inner.truncate(inner.len() - drop_last);
    inner.drain(..drop_first);
    let mut values = alloc::vec![t[0]; degree + 1];
    values.extend(inner);
    values.extend(core::iter::repeat_n(t[n - 1], degree + 1));
    let knots = Knots::new(values, degree)?;
    // One row a condition: the value at the start, its derivatives, the inner values, the derivatives at the end, its value.
    let at = |i: usize| (t[i], 0, points[i]);
    let mut rows: Vec<(f64, usize, [f64; D])> = alloc::vec![at(0)];
    rows.extend(first.iter().map(|(order, value)| (t[0], *order, *value)));
    rows.extend((1..n - 1).map(at));
    rows.extend(last.iter().rev().map(|(order, value)| (t[n - 1], *order, *value)));
    if n > 1 {
        rows.push(at(n - 1));
    }
    let control = collocate(&knots, &rows)?;
    BSpline::new(knots, control)
}

/// The B-spline over knots of the user's own through points at the given parameters: as many functions as points.
///
/// *Cost, error* as [`bspline`].
///
/// ```
/// use lath::interpolate::bspline_over;
/// use lath::knot::Knots;
///
/// let knots = Knots::clamped(3, 2)?;
/// let error = bspline_over([[0.0], [1.0], [2.0]], &[0.0, 0.0, 1.0], knots).unwrap_err();
/// assert_eq!(error.index(), Some(1)); // two points at one parameter
/// # Ok::<(), lath::error::Error>(())
/// ```
///
/// # Errors
/// K001 if there are not as many points as functions; N002 with the index of the first parameter that its B-spline does not reach:
/// tᵢ < τᵢ < t_{i+p+1} is necessary and sufficient (Schoenberg and Whitney 1953); otherwise as [`bspline`].
pub fn bspline_over<const D: usize>(
    points: impl IntoIterator<Item = impl IntoPoint<D>>,
    parameters: &[f64],
    knots: Knots,
) -> Result<BSpline<D>> {
    let points = checked(points, parameters, 0, knots.degree())?;
    knots.check_points(points.len())?;
    let (t, p) = (knots.values(), knots.degree());
    for (i, tau) in parameters.iter().enumerate() {
        // At a knot of full multiplicity the function does not vanish.
        let reaches = (t[i] < *tau && *tau < t[i + p + 1])
            || (*tau == t[i] && t[i + p] == t[i])
            || (*tau == t[i + p + 1] && t[i + 1] == t[i + p + 1]);
        if !reaches {
            let (tau, from, to) = (Number(*tau), Number(t[i]), Number(t[i + p + 1]));
            let message = format!("parameter {i} = {tau} is not inside [{from}, {to}], where function {i} lives");
            return Err(Error::new(Code::N002, message).at(i));
        }
    }
    let rows: Vec<(f64, usize, [f64; D])> = parameters.iter().zip(&points).map(|(t, p)| (*t, 0, *p)).collect();
    let control = collocate(&knots, &rows)?;
    BSpline::new(knots, control)
}

/// The closed B-spline of degree p through the points: one more parameter than points.
///
/// Odd degree: knots at the parameters. Even degree: knots at the middles, so that the domain starts half an interval before the
/// first parameter (knots at the data would make the system singular for an even number of points).
///
/// *Cost.* O(n p²). *Error, invariance* as [`bspline`].
///
/// ```
/// use lath::curve::Curve;
/// use lath::interpolate::bspline_closed;
///
/// let square = [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]];
/// let curve = bspline_closed(square, vec![0.0, 1.0, 2.0, 3.0, 4.0], 4)?;
/// assert_eq!(curve.domain().start, -0.5);
/// assert!((curve.eval(1.0)?[1] - 1.0).abs() < 1e-15);
/// # Ok::<(), lath::error::Error>(())
/// ```
///
/// # Errors
/// As [`bspline`]; N001 if the data do not determine the curve.
pub fn bspline_closed<const D: usize>(
    points: impl IntoIterator<Item = impl IntoPoint<D>>,
    parameters: Vec<f64>,
    degree: usize,
) -> Result<BSpline<D>> {
    let mut points = checked(points, &parameters, 1, degree)?;
    let (n, half) = (points.len(), degree / 2);
    let length = parameters[n] - parameters[0];
    let period: Vec<f64> = match degree % 2 {
        1 => parameters.clone(),
        _ => {
            let before = middle(parameters[n - 1] - length, parameters[0]);
            let mut period = alloc::vec![before];
            period.extend(parameters.windows(2).take(n - 1).map(|pair| middle(pair[0], pair[1])));
            period.push(before + length);
            period
        }
    };
    let knots = Knots::periodic(&period, degree)?;
    // Row j is answered by the functions j … j + p of the extended vector; unknown u stands for point u + ⌊p/2⌋.
    let mut matrix = CyclicBanded::new(n, half, half);
    for (j, t) in parameters[..n].iter().enumerate() {
        let values = values(&knots, degree + j, t);
        // At a knot the last function of an odd degree is zero.
        for (k, value) in values.iter().enumerate().take(2 * half + 1) {
            matrix.add(j, k as isize - half as isize, *value);
        }
    }
    matrix.solve(&mut points)?;
    let control: Vec<[f64; D]> = (0..n).map(|i| points[(i + n - half % n) % n]).collect();
    BSpline::closed(&period, degree, finite(control)?)
}

fn checked<const D: usize>(
    points: impl IntoIterator<Item = impl IntoPoint<D>>,
    parameters: &[f64],
    extra: usize,
    degree: usize,
) -> Result<Vec<[f64; D]>> {
    let points = collect(points)?;
    if degree > MAX_DEGREE {
        return Err(Error::new(
            Code::K006,
            format!("degree {degree} is above {MAX_DEGREE}, beyond which rounding decides"),
        ));
    }
    if points.len() < 2 {
        return Err(Error::new(Code::P001, format!("a curve takes at least 2 points, not {}", points.len())));
    }
    if parameters.len() != points.len() + extra {
        let message = format!("{} parameters for {} points", parameters.len(), points.len());
        return Err(Error::new(Code::T004, message));
    }
    check_increasing(parameters)?;
    Ok(points)
}

/// The derivative conditions that an end gives.
fn conditions<const D: usize>(end: &BSplineEnd<D>, degree: usize, name: &str) -> Result<Vec<(usize, [f64; D])>> {
    let share = degree / 2;
    if degree > MAX_BY_DERIVATIVES && *end != BSplineEnd::NotAKnot {
        let message =
            format!("degree {degree} with derivatives at the {name}; they hold up to degree {MAX_BY_DERIVATIVES}");
        return Err(Error::new(Code::K006, message));
    }
    match end {
        BSplineEnd::NotAKnot => Ok(Vec::new()),
        BSplineEnd::Natural => Ok((0..share).map(|k| (degree / 2 + 1 + k, [0.0; D])).collect()),
        BSplineEnd::Derivatives(given) => {
            let fits = given.len() == share
                && given.iter().all(|(order, _)| (1..=degree).contains(order))
                && given.windows(2).all(|pair| pair[0].0 < pair[1].0);
            if !fits {
                let orders: Vec<usize> = given.iter().map(|(order, _)| *order).collect();
                let message = format!("the {name} of degree {degree} takes {share} derivatives, not orders {orders:?}");
                return Err(Error::new(Code::C001, message));
            }
            collect(given.iter().map(|(_, value)| value))?;
            Ok(given.clone())
        }
    }
}

/// Solves for the control points: one row (parameter, order of derivative, value) for each function.
fn collocate<const D: usize>(knots: &Knots, rows: &[(f64, usize, [f64; D])]) -> Result<Vec<[f64; D]>> {
    let p = knots.degree();
    let mut matrix = Banded::new(rows.len(), p, p);
    let mut control = Vec::with_capacity(rows.len());
    for (i, (t, order, value)) in rows.iter().enumerate() {
        let span = knots.span(t, Side::Right);
        let weights = derivatives(knots, span, t, *order).pop().unwrap_or_default();
        // Derivatives grow with the inverse powers of the intervals: rows of one size keep the elimination even.
        let size = weights.iter().fold(0.0, |most: f64, w| if w.abs() > most { w.abs() } else { most });
        for (k, weight) in weights.iter().enumerate().filter(|(_, w)| **w != 0.0) {
            if !matrix.set(i, span - p + k, weight / size) {
                let message = format!("condition {i} at {} lies too far from its functions", Number(*t));
                return Err(Error::new(Code::N002, message).at(i));
            }
        }
        control.push(value.map(|x| x / size));
    }
    matrix.factor()?.solve(&mut control)?;
    finite(control)
}

fn finite<const D: usize>(control: Vec<[f64; D]>) -> Result<Vec<[f64; D]>> {
    match control.iter().position(|point| !point.iter().all(|x| x.abs() <= 1e300)) {
        None => Ok(control),
        Some(i) => Err(Error::new(Code::P003, format!("control point {i} overflows: {:?}", control[i])).at(i)),
    }
}

/// The middle of two numbers, without overflow.
fn middle(a: f64, b: f64) -> f64 {
    a / 2.0 + b / 2.0
}
