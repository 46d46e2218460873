//! Interpolating B-splines with derivatives given at any of the points.

use crate::curve::BSpline;
use crate::error::{Code, Count, Error, Result};
use crate::interpolate::bspline::{BSplineEnd, checked, middle};
use crate::interpolate::collocation::{Row, collocate};
use crate::knot::Knots;
use crate::space::{IntoPoint, check_point, collect};
use alloc::format;
use alloc::vec::Vec;

/// A derivative that a curve is to have at one of its points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Derivative<const D: usize> {
    /// The index of the point.
    pub index: usize,
    /// The order, from 1 to one below the degree.
    pub order: usize,
    /// Its value, for the curve's parameter.
    pub value: [f64; D],
}

/// The B-spline of degree p through the points, with derivatives given at some of them besides, at the ends or inside.
///
/// Every derivative beyond those of the [`ends`](BSplineEnd) adds a condition, and so a control point and a knot near its point: the r
/// conditions of a point divide its share of the parameters, half the way to either neighbour, evenly among each other, and the
/// knots are laid to these sites as [`bspline`](crate::interpolate::bspline) lays them to parameters. All knots are simple: the curve keeps its p − 1
/// continuous derivatives. Without derivatives it is that curve, to the bit.
///
/// *Solvability.* Where the orders of each point are 1, 2, …, without a gap, every condition lies inside its function's support, which is
/// necessary and sufficient (I. Schoenberg and A. Whitney 1953; S. Karlin and Z. Ziegler 1966). With gaps, as for a second derivative
/// without the first, most systems are regular, and those that are not are refused (N001).
///
/// *Cost.* O((n + m) p²) time for m derivatives, O((n + m) p) memory. *Error.* The system is solved with exchange of rows; what could miss a
/// condition by more than 1e-10 of the greatest one is refused (N003). *Invariance:* affine, derivatives transforming as vectors.
///
/// *Source.* L. Piegl and W. Tiller, The NURBS Book (2nd ed. 1997), §9.2.4, whose knots for slopes at every point are at thirds of the intervals
/// for cubics, are close relatives; these become uniform over uniform parameters.
///
/// ```
/// use lath::curve::Curve;
/// use lath::interpolate::{BSplineEnd, Derivative, bspline_with_derivatives};
///
/// // Flat on the summit.
/// let ends = BSplineEnd::NotAKnot;
/// let summit = Derivative { index: 2, order: 1, value: [0.0] };
/// let t = vec![0.0, 1.0, 2.0, 3.0, 4.0];
/// let curve = bspline_with_derivatives([[0.0], [2.0], [5.0], [1.0], [0.0]], t, 3, &ends, &ends, &[summit])?;
/// let jet = curve.jet(2.0, 1)?;
/// assert!((jet[0][0] - 5.0).abs() < 1e-14 && jet[1][0].abs() < 1e-14);
/// # Ok::<(), lath::error::Error>(())
/// ```
///
/// # Errors
/// As [`bspline`](crate::interpolate::bspline); C003 with the position in `derivatives` of one whose point does not exist, whose order is 0 or not below the degree, or
/// that was given before, there or by an end; P002 and P003 for its value; N001 if the
/// conditions do not determine the curve.
pub fn bspline_with_derivatives<const D: usize>(
    points: impl IntoIterator<Item = impl IntoPoint<D>>,
    parameters: Vec<f64>,
    degree: usize,
    start: &BSplineEnd<D>,
    end: &BSplineEnd<D>,
    derivatives: &[Derivative<D>],
) -> Result<BSpline<D>> {
    let points = checked(points, &parameters, 0, degree)?;
    let n = points.len();
    // The conditions of each point beside its value.
    let mut given: Vec<Vec<(usize, [f64; D])>> = alloc::vec![Vec::new(); n];
    given[0] = conditions(start, degree, "start")?;
    given[n - 1].extend(conditions(end, degree, "end")?);
    for (i, derivative) in derivatives.iter().enumerate() {
        add(&mut given, derivative, degree).map_err(|error| error.at(i))?;
    }
    let (mut rows, mut sites) = (Vec::new(), Vec::new());
    for (i, orders) in given.iter_mut().enumerate() {
        orders.sort_by_key(|(order, _)| *order);
        let t = parameters[i];
        let mut group: Vec<Row<D>> = alloc::vec![(t, 0, points[i])];
        group.extend(orders.iter().map(|(order, value)| (t, *order, *value)));
        spread(&parameters, i, group.len(), degree / 2, &mut sites);
        // The value comes last at the end, where the last function alone gives it.
        if i > 0 && i == n - 1 {
            group.reverse();
        }
        rows.extend(group);
    }
    if rows.len() <= degree {
        let least = n + degree + 1 - rows.len();
        let message =
            format!("{} for degree {degree}, which takes at least {least} with these ends", Count(n, "point"));
        return Err(Error::new(Code::P001, message));
    }
    let knots = knots_at(&parameters, &sites, degree)?;
    let control = collocate(&knots, &rows)?;
    BSpline::new(knots, control)
}

/// Takes a derivative among the conditions of its point.
fn add<const D: usize>(given: &mut [Vec<(usize, [f64; D])>], derivative: &Derivative<D>, degree: usize) -> Result<()> {
    let Derivative { index, order, value } = *derivative;
    let refuse = |message| Err(Error::new(Code::C003, message));
    let count = given.len();
    let Some(orders) = given.get_mut(index) else {
        return refuse(format!("a derivative at point {index} of {count}"));
    };
    if order == 0 || order >= degree {
        return refuse(format!("a derivative of order {order} at point {index} of a curve of degree {degree}"));
    }
    if orders.iter().any(|(other, _)| *other == order) {
        return refuse(format!("a second derivative of order {order} at point {index}"));
    }
    check_point(index, &value)?;
    orders.push((order, value));
    Ok(())
}

/// Adds the sites of the `count` conditions of point i: evenly over half the way to both neighbours. At an end the first 1 + `share` stay
/// with the end, where its knots are.
fn spread(t: &[f64], i: usize, count: usize, share: usize, sites: &mut Vec<f64>) {
    let last = t.len() - 1;
    let (before, behind) = (t[i] - t[i.saturating_sub(1)], t[if i < last { i + 1 } else { last }] - t[i]);
    for j in 0..count {
        // Twice the part of the whole way, in steps of 1/count.
        let (steps, of) = match i {
            0 => (j.saturating_sub(share) as f64, count.saturating_sub(share) as f64),
            _ if i == last => (-((count - 1 - j).saturating_sub(share) as f64), count.saturating_sub(share) as f64),
            _ => ((2 * j + 1) as f64 - count as f64, count as f64),
        };
        let side = if steps < 0.0 { before } else { behind };
        sites.push(if steps == 0.0 { t[i] } else { t[i] + side * (steps / (2.0 * of)) });
    }
}

/// The knots for conditions at these sites: odd degree at the sites, even degree at the middles, without ⌊p/2⌋ at each end.
fn knots_at(t: &[f64], sites: &[f64], degree: usize) -> Result<Knots> {
    let share = degree / 2;
    let ends = |t: f64| core::iter::repeat_n(t, degree + 1);
    let mut values: Vec<f64> = ends(t[0]).collect();
    let inner = &sites[share..sites.len() - share];
    match degree % 2 {
        1 => values.extend(&inner[1..inner.len() - 1]),
        _ => values.extend(inner.windows(2).map(|pair| middle(pair[0], pair[1]))),
    }
    values.extend(ends(t[t.len() - 1]));
    Knots::new(values, degree)
}

/// The derivative conditions that an end gives.
fn conditions<const D: usize>(end: &BSplineEnd<D>, degree: usize, name: &str) -> Result<Vec<(usize, [f64; D])>> {
    let share = degree / 2;
    match end {
        BSplineEnd::NotAKnot => Ok(Vec::new()),
        BSplineEnd::Natural => Ok((0..share).map(|k| (share + 1 + k, [0.0; D])).collect()),
        BSplineEnd::Derivatives(given) => {
            let fits = given.len() == share
                && given.iter().all(|(order, _)| (1..=degree).contains(order))
                && given.windows(2).all(|pair| pair[0].0 < pair[1].0);
            if !fits {
                let orders: Vec<usize> = given.iter().map(|(order, _)| *order).collect();
                let message = format!(
                    "the {name} of degree {degree} takes {}, not orders {orders:?}",
                    Count(share, "derivative")
                );
                return Err(Error::new(Code::C001, message));
            }
            collect(given.iter().map(|(_, value)| value))?;
            Ok(given.clone())
        }
    }
}
