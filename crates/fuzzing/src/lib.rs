//! Bytes in, laws held: what the fuzz targets run, and what the tests replay. Published nowhere.
//!
//! A fuzz target needs nightly tools; what it has found must be replayed by everybody. So the targets are ordinary functions
//! here, `fn(&[u8])`, and panic where the library breaks a promise:
//!
//! | target | bytes are | what must hold |
//! |---|---|---|
//! | [`points`] | a file of points, behind one byte of options | every reader answers or refuses; tables are finite, and come back with the same bits from every format |
//! | [`shapes`] | a file of curves, behind one byte of options | as above; every curve answers every question; checking agrees with reading, mending ends |
//! | [`curves`] | decisions and numbers ([`tape`]) | constructors, interpolants, schemes and solvers answer or refuse; finite in, finite out |
//! | [`exact`] | lines: a question and its arguments | an answer within its budget, printable in every format, or an error |
//! | [`arguments`] | lines: the arguments of the tool | an exit code of the contract, no panic, nothing on standard output beside a failure |
//!
//! `fuzz/` (a workspace of its own) hangs them on a fuzzer; `tests/replay.rs` here, and `tests/fuzzed_lines.rs` of the tool for the
//! last, run the kept inputs in an ordinary `cargo test`. There are few targets, each wide: a fuzzer finds the way into a
//! branch by itself, and hours are shared between fewer.
//!
//! *Hangs* are caught by counting, not by a clock: whatever can run long takes [`lath::error::Limits`], and gets small ones;
//! curves are asked through [`counted`], which stops a question that asks too often.
//!
//! It sits beside testkit, not in it: testkit imports the core alone, so that the core's tests need nothing else built.
#![forbid(unsafe_code)]
#![allow(clippy::panic)] // a broken promise stops the fuzzer, loudly

pub mod arguments;

pub mod counted;
pub mod curves;
pub mod exact;
pub mod interpolants;
pub mod points;
pub mod questions;
pub mod refinement;
pub mod shapes;
pub mod solvers;
pub mod subdivision;
pub mod tape;

use lath::error::Limits;

/// Longer inputs are not made, and not kept: what breaks a reader breaks it with few bytes.
pub const LONGEST: usize = 4096;

/// What a target is: it takes any bytes, and panics where a promise is broken.
pub type Target = fn(&[u8]);

/// The targets that need no process of their own, by the names of their folders.
pub const TARGETS: [(&str, Target); 4] =
    [("points", points::run), ("shapes", shapes::run), ("curves", curves::run), ("exact", exact::run)];

/// Budgets so small that every refusal for their sake is met, and none takes long.
#[must_use]
pub fn small() -> Limits<'static> {
    Limits { max_points: 4000, max_bytes: 400_000, cancel: None }
}
