//! Replays `testdata/` through the library: on fractions, where the answer must be the answer, and on floats, where it may
//! be off by rounding. One module for each floor; `testdata/README.md` describes the cases.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)] // a test stops at the first fault, loudly

mod basis;
mod control;
mod curve;
mod interpolate;
mod knot;
mod subdivide;

use lath::error::Result;
use lath::num::Scalar;
use testkit::corpus::Entry;
use testkit::rational::Rational;

/// Holds an outcome against the case's `error` and `index`; gives back the value of a case that has none.
fn refused<T: std::fmt::Debug>(case: &Entry, outcome: Result<T>) -> Option<T> {
    let Some(code) = case.text_if("error") else {
        return Some(outcome.unwrap_or_else(|error| panic!("{}: {error}", case.place)));
    };
    let error = outcome.expect_err(&format!("{}: takes what it should refuse with {code}", case.place));
    assert_eq!((error.code().as_str(), error.index()), (code, case.count_if("index")), "{}: {error}", case.place);
    assert!(!error.message().is_empty() && !error.remedy().is_empty());
    None
}

/// The polynomial Σ cₖ xᵏ at x, in fractions.
fn polynomial(coefficients: &[Rational], x: &Rational) -> Rational {
    coefficients.iter().rev().fold(Rational::zero(), |sum, c| sum * x.clone() + c.clone())
}

/// The coefficients of the derivative.
fn derivative(coefficients: &[Rational]) -> Vec<Rational> {
    (1..coefficients.len()).map(|k| Rational::from(k as i64) * coefficients[k].clone()).collect()
}

/// Points between a and b, the ends included.
fn between(a: &Rational, b: &Rational) -> Vec<Rational> {
    let at = |k: i64| a.clone() + (b.clone() - a.clone()) * Rational::from(k) / Rational::from(8);
    (0..=8).map(at).collect()
}
