//! What the tests of lath stand on; published nowhere.
//!
//! The tests of a library that promises exactness need something to be exact against, inputs that look for trouble, and
//! laws that hold for every family alike:
//!
//! - [`rational`]: exact fractions as a scalar of the core, so that generic code can be run on them;
//! - [`naive`]: the mathematics by definition, slowly, sharing no code with what it tests;
//! - [`error_measure`]: how wrong a float is, in units of what its data allow;
//! - [`corpus`]: reads `testdata/`, the cases that every engine and every language replays;
//! - [`answer`]: holds an answer in fractions against its case of the corpus;
//! - [`schema`]: is a JSON document what its schema says?
//! - [`generators`]: proptest strategies that love the edge;
//! - [`conformance`](mod@conformance): the laws of a curve, stamped onto a family by one macro;
//! - [`layers`]: does the house keep its order?
//!
//! It imports the core only, and serves the `tests/` folders: unit tests inside the core cannot use it, because a library
//! under test and the library its dev-dependency sees are two builds.
//!
//! Everything here panics at the first fault, with the fault in the message; that is what a test wants.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)] // tests stop at the first fault, loudly

pub mod answer;
pub mod conformance;
pub mod corpus;
pub mod error_measure;
pub mod generators;
pub mod layers;
pub mod naive;
pub mod rational;
pub mod schema;
