//! The inputs that break spline code, through the library: the rows of `testdata/bad-inputs.toml`, one test each, by theme.
//! Those that only files can hold are in `lath-io`; the command line has its own.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)] // a failing unwrap is a failing test

mod counts;
mod geometry;
mod knots;
mod numbers;
mod weights;

use lath::curve::{BSpline, Bezier, Hermite, Polyline, Power, QuinticHermite};
use lath::error::{Error, Result};
use lath::interpolate::{
    BSplineEnd, End, Ends, Parameters, akima, bspline, cardinal, catmull_rom, cubic, cubic_closed, makima, parameters,
    pchip, steffen,
};
use lath::subdivide::{self, Scheme, Subdivision};
use std::fmt::Debug;

/// The error of what must be refused, with this code and culprit, and words for people.
#[track_caller]
pub(crate) fn refused<T: Debug>(result: Result<T>, code: &str, index: impl Into<Option<usize>>) -> Error {
    let error = result.unwrap_err();
    assert_eq!((error.code().as_str(), error.index()), (code, index.into()), "{error}");
    assert!(!error.message().is_empty() && !error.message().ends_with('.') && error.remedy().ends_with('.'), "{error}");
    error
}

/// Whether two numbers agree to some units of u = 2⁻⁵³ of a scale.
#[track_caller]
pub(crate) fn near(found: f64, exact: f64, units: f64, scale: f64) {
    assert!((found - exact).abs() <= units * scale * f64::EPSILON / 2.0, "{found:e} is not {exact:e}");
}

/// Whatever takes points in the plane, by name, and what it answers; the points must be the culprits, if any are.
pub(crate) fn every_taker(points: &[[f64; 2]]) -> Vec<(&'static str, Result<()>)> {
    let (n, p) = (points.len(), || points.iter().copied());
    let t = || (0..n).map(|i| i as f64).collect::<Vec<f64>>();
    let longer = || (0..=n).map(|i| i as f64).collect::<Vec<f64>>();
    let zero = || vec![[0.0; 2]; n];
    let free = Ends::Open(End::NotAKnot, End::NotAKnot);
    let ends = || BSplineEnd::NotAKnot;
    let closed = subdivide::Ends::Closed;
    vec![
        ("bezier", Bezier::new(p()).map(drop)),
        ("bspline", BSpline::uniform(1, p()).map(drop)),
        ("closed bspline", BSpline::closed_uniform(3, p()).map(drop)),
        ("polyline", Polyline::new(p()).map(drop)),
        ("hermite", Hermite::new(t(), p(), zero()).map(drop)),
        ("tangents", Hermite::new(t(), zero(), p()).map(drop)),
        ("closed hermite", Hermite::closed(longer(), p(), zero()).map(drop)),
        ("quintic", QuinticHermite::new(t(), p(), zero(), zero()).map(drop)),
        ("seconds", QuinticHermite::new(t(), zero(), zero(), p()).map(drop)),
        ("power", Power::new(longer(), points.iter().map(|c| [*c])).map(drop)),
        ("cubic", cubic(p(), t(), &free).map(drop)),
        ("closed cubic", cubic_closed(p(), longer()).map(drop)),
        ("through bspline", bspline(p(), t(), 3, &ends(), &ends()).map(drop)),
        ("catmull-rom", catmull_rom(p(), t(), false).map(drop)),
        ("cardinal", cardinal(p(), t(), false, 0.5).map(drop)),
        ("pchip", pchip(p(), t(), false).map(drop)),
        ("akima", akima(p(), t(), false).map(drop)),
        ("makima", makima(p(), t(), false).map(drop)),
        ("steffen", steffen(p(), t(), false).map(drop)),
        ("subdivision", Subdivision::new(Scheme::<f64>::chaikin(), p(), closed).map(drop)),
        ("chord length", parameters(points, false, Parameters::Chord).map(drop)),
    ]
}
