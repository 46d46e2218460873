//! The laws of a curve, stamped onto a family by one macro.
//!
//! A family conforms if every curve it makes has the domain it says, derivatives that are derivatives, pieces that are the
//! curve, limits on both sides of a break, the invariance that its page declares and no more, a box that holds it, and
//! a polyline that stays within any tolerance. None of that depends on what the family is, so it is written once, in
//! [`laws`], against the [`Curve`](lath::curve::Curve) trait; a new family is one invocation:
//!
//! ```
//! use lath::curve::Bezier;
//! use testkit::conformance::Definition;
//! use testkit::conformance::strategies::control_points;
//!
//! testkit::conformance! {
//!     bezier,
//!     dimension: 2,
//!     invariance: Affine,
//!     edge: control_points::<2>(1..8),
//!     mild: control_points::<2>(1..8),
//!     build: |d: &Definition<2>| Bezier::new(&d.points),
//!     reverse: |d: &Definition<2>| Definition { points: d.points.iter().rev().copied().collect(), ..d.clone() },
//! }
//! ```
//!
//! `edge` draws definitions that look for trouble, `mild` such whose spans differ by no more than a thousand, for the laws that
//! compare across spans. `reverse` may be left out where reversal means nothing. Every test runs on a fixed seed, so that a
//! failure stays; `PROPTEST_CASES` and `PROPTEST_RNG_SEED` widen the search.

pub mod laws;
pub mod strategies;

use proptest::strategy::Strategy;
use proptest::test_runner::{Config, RngSeed, TestCaseError, TestError, TestRunner};

/// What defines a curve, in the terms by which maps act on it: points move as points, vectors as vectors, numbers not at all, and
/// weights with their points under projective maps.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct Definition<const D: usize> {
    /// The degree, where the family has a choice.
    pub degree: usize,
    /// Knots, parameters, or the ends of the domain.
    pub numbers: Vec<f64>,
    /// Control points or data.
    pub points: Vec<[f64; D]>,
    /// Tangents and higher derivatives.
    pub vectors: Vec<[f64; D]>,
    /// The weights of a rational curve, one a point.
    pub weights: Vec<f64>,
}

/// The maps under which mapping the definition is mapping the curve.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Invariance {
    /// All projective maps, of points with weights; a common factor of the weights among them.
    Projective,
    /// All affine maps.
    Affine,
    /// Rotation, reflection, uniform scaling, translation.
    Similarity,
    /// Scaling of each axis by itself, and translation.
    PerAxis,
}

/// The outcome of one law for one curve.
pub type Law = Result<(), TestCaseError>;

/// Runs a law over the draws of a strategy.
///
/// # Panics
/// With the smallest definition that breaks the law.
pub fn run<S: Strategy>(strategy: S, law: impl Fn(S::Value) -> Law) {
    match runner().run(&strategy, law) {
        Ok(()) => {}
        Err(TestError::Fail(reason, smallest)) => panic!("{reason}\nfor {smallest:#?}"),
        Err(TestError::Abort(reason)) => panic!("{reason}"),
    }
}

/// A runner with a fixed seed, unless the environment says otherwise, and without files of its own.
pub fn runner() -> TestRunner {
    let given = Config::default();
    let seed = match given.rng_seed {
        RngSeed::Random => RngSeed::Fixed(0x1a7),
        fixed => fixed,
    };
    let cases = if std::env::var_os("PROPTEST_CASES").is_some() { given.cases } else { 64 };
    TestRunner::new(Config { cases, rng_seed: seed, failure_persistence: None, ..given })
}

/// Stamps every law of [`laws`] onto a family, as tests of a module with the family's name. See the
/// [module](mod@crate::conformance).
#[macro_export]
macro_rules! conformance {
    (
        $(#[$attribute:meta])*
        $family:ident,
        dimension: $dimension:literal,
        invariance: $invariance:ident,
        edge: $edge:expr,
        mild: $mild:expr,
        build: $build:expr
        $(, reverse: $reverse:expr)? $(,)?
    ) => {
        $(#[$attribute])*
        mod $family {
            #[allow(unused_imports)]
            use super::*;
            use $crate::conformance::{Invariance, laws, run};

            $crate::conformance!(@laws $dimension, $edge, $build, any_domain_is_kept any_parameter_is_answered_or_refused
                any_side_of_a_break_is_its_piece any_piece_is_the_curve any_box_holds_the_curve any_hull_holds_the_curve);
            $crate::conformance!(@laws $dimension, $mild, $build, derivatives_are_derivatives outside_follows_the_policy
                box_is_tight flattening_stays_within_tolerance);

            #[test]
            fn invariance_holds() {
                let build = $build;
                run(($mild, laws::maps::<$dimension>(Invariance::$invariance)), |(definition, map)| {
                    laws::invariance(&definition, &map, |definition| build(definition).unwrap())
                });
            }

            #[test]
            fn invariance_ends_there() {
                let build = $build;
                laws::invariance_ends($mild, Invariance::$invariance, |definition| build(definition).unwrap());
            }

            $(
                #[test]
                fn reversal_is_the_same_curve_backwards() {
                    let (build, reverse) = ($build, $reverse);
                    run($mild, |definition| {
                        laws::reversal(&definition, &build(&definition).unwrap(), &build(&reverse(&definition)).unwrap())
                    });
                }
            )?
        }
    };
    (@laws $dimension:literal, $strategy:expr, $build:expr, $($law:ident)*) => {
        $(
            #[test]
            fn $law() {
                let build = $build;
                run($strategy, |definition| laws::$law::<$dimension>(&definition, &build(&definition).unwrap()));
            }
        )*
    };
}

#[cfg(test)]
mod tests;
