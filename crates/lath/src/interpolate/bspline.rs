//! Interpolating B-splines of any degree.
//!
//! *Source.* de Boor, A Practical Guide to Splines (1978), ch. XIII; for the solution without pivoting de Boor and Pinkus
//! (1977); for solvability I. Schoenberg and A. Whitney (1953).
//!
//! Odd degree: knots at the data. Even degree: knots at the middles between data, so that the data lie inside the spans.
//! Every end has ⌊p/2⌋ conditions to give, or gives up ⌊p/2⌋ knots instead (not-a-knot).

use crate::basis::bspline::values;
use crate::curve::{BSpline, check_increasing};
use crate::error::{Code, Count, Error, Number, Result};
use crate::interpolate::collocation::{Row, collocate, finite};
use crate::interpolate::derivatives::bspline_with_derivatives;
use crate::knot::Knots;
use crate::num::CyclicBanded;
use crate::space::{IntoPoint, collect};
use alloc::format;
use alloc::vec::Vec;

/// The greatest degree with not-a-knot ends: at degree 30 forty smooth points are still met within 1e-13 of their size.
const MAX_DEGREE: usize = 30;

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
/// totally positive: the backward error is a few u · p, and the points are met within some u of their size. Derivatives at the ends are
/// not; they are solved with exchange of rows and meet the points within 1e-10 of the greatest condition at worst. Control points carry
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
/// P001 for too few points; K006 for a degree above 30; T001, T003, T004, T005 for the parameters; P002, P003 for coordinates; C001 for
/// another number of end derivatives than ⌊p/2⌋ or orders that do not fit; P003 if the control points overflow; N003 if derivatives at an
/// end take control points so large that rounding could miss a condition by 1e-10 of the greatest one. That depends on the data: natural ends
/// of a smooth curve hold up to degree 21, and for every odd degree up to 25.
pub fn bspline<const D: usize>(
    points: impl IntoIterator<Item = impl IntoPoint<D>>,
    parameters: Vec<f64>,
    degree: usize,
    start: &BSplineEnd<D>,
    end: &BSplineEnd<D>,
) -> Result<BSpline<D>> {
    bspline_with_derivatives(points, parameters, degree, start, end, &[])
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
    let rows: Vec<Row<D>> = parameters.iter().zip(&points).map(|(t, p)| (*t, 0, *p)).collect();
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

pub(crate) fn checked<const D: usize>(
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
        let message = format!("{} for {}", Count(parameters.len(), "parameter"), Count(points.len(), "point"));
        return Err(Error::new(Code::T004, message));
    }
    check_increasing(parameters)?;
    Ok(points)
}

/// The middle of two numbers, without overflow.
pub(crate) fn middle(a: f64, b: f64) -> f64 {
    a / 2.0 + b / 2.0
}
