//! Conditions on a B-spline, as a banded system for its control points.

use crate::basis::bspline::derivatives;
use crate::error::{Code, Error, Number, Result};
use crate::knot::{Knots, Side};
use crate::num::{Banded, PivotedBanded};
use alloc::format;
use alloc::vec::Vec;

/// The share of the greatest condition by which rounding may miss one.
const LOST: f64 = 1e-10;

/// A condition: the parameter, the order of the derivative, its value.
pub(crate) type Row<const D: usize> = (f64, usize, [f64; D]);

/// Solves for the control points: one row for each function.
pub(crate) fn collocate<const D: usize>(knots: &Knots, rows: &[Row<D>]) -> Result<Vec<[f64; D]>> {
    let (n, p) = (rows.len(), knots.degree());
    // Values alone are totally positive; rows of derivatives among them are not.
    let mut matrix = match rows.iter().all(|(_, order, _)| *order == 0) {
        true => System::Positive(Banded::new(n, p, p)),
        false => System::Mixed(PivotedBanded::new(n, p, p)),
    };
    let mut control = Vec::with_capacity(n);
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
    let matrix = match matrix {
        System::Positive(matrix) => {
            matrix.factor()?.solve(&mut control)?;
            return finite(control);
        }
        System::Mixed(matrix) => matrix,
    };
    let asked = greatest(&control);
    matrix.solve(&mut control)?;
    let control = finite(control)?;
    let found = greatest(&control);
    // Every condition is met up to (p + 1) u of the greatest control point.
    match (0..D).find(|&c| (p + 1) as f64 * f64::EPSILON / 2.0 * found[c] > LOST * asked[c]) {
        None => Ok(control),
        Some(c) => {
            let (found, asked) = (Number(found[c]), Number(asked[c]));
            let message = format!("conditions of size {asked} take control points of size {found} at degree {p}");
            Err(Error::new(Code::N003, message))
        }
    }
}

/// The two kinds of systems that occur.
enum System {
    Positive(Banded<f64>),
    Mixed(PivotedBanded<f64>),
}

impl System {
    fn set(&mut self, i: usize, j: usize, value: f64) -> bool {
        match self {
            System::Positive(matrix) => matrix.set(i, j, value),
            System::Mixed(matrix) => matrix.set(i, j, value),
        }
    }
}

/// The greatest magnitude along each axis.
fn greatest<const D: usize>(points: &[[f64; D]]) -> [f64; D] {
    core::array::from_fn(|c| points.iter().fold(0.0, |most: f64, p| if p[c].abs() > most { p[c].abs() } else { most }))
}

pub(crate) fn finite<const D: usize>(control: Vec<[f64; D]>) -> Result<Vec<[f64; D]>> {
    match control.iter().position(|point| !point.iter().all(|x| x.abs() <= 1e300)) {
        None => Ok(control),
        Some(i) => Err(Error::new(Code::P003, format!("control point {i} overflows: {:?}", control[i])).at(i)),
    }
}
