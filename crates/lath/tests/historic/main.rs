//! Defects of other libraries, each with its input and the right answer by exact arithmetic or a closed form.
//!
//! A test is named after the project, the number of its report where there is one, and what went wrong there; what it says about
//! a project is about the version or the report named, and may be mended by now.
#![allow(clippy::unwrap_used, clippy::panic)] // a failing unwrap is a failing test

mod degenerate;
mod derivatives;
mod descriptions;
mod ends;
mod lengths;
mod refusals;
mod weights;

use lath::curve::Curve;
use lath::error::Result;
use std::fmt::Debug;

/// What must be refused, with this code and culprit.
#[track_caller]
pub(crate) fn refused<T: Debug>(result: Result<T>, code: &str, index: impl Into<Option<usize>>) {
    let error = result.unwrap_err();
    assert_eq!((error.code().as_str(), error.index()), (code, index.into()), "{error}");
}

/// Whether a number is right but for some roundings of a number of that scale.
#[track_caller]
pub(crate) fn near(found: f64, exact: f64, scale: f64) {
    assert!((found - exact).abs() <= 32.0 * f64::EPSILON * scale, "{found:e} is not {exact:e}");
}

/// Value and derivatives of a curve on a line.
#[track_caller]
pub(crate) fn jet(curve: &dyn Curve<1>, t: f64, order: usize) -> Vec<f64> {
    curve.jet(t, order).unwrap().concat()
}
