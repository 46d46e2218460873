//! The command-line tool `lath`: points in, curve out, picture out.
//!
//! The tool has no mathematics. It turns words into values, hands them to the library, and hands the results back; each
//! verb is one file in `cmd`. What all verbs promise lives beside them, one idea a file:
//!
//! - `args`: the verbs, and the options that every verb has;
//! - `numbers`: numbers on the command line, fractions and minus signs included;
//! - `input`, `output`: where data come from and where results go; `-` is standard input or output;
//! - `interruption`: what Ctrl-C does to a file half written;
//! - `table`: tables as results; `dimension`: the dimension of points as a constant;
//! - `accuracy`, `certainty`: how accurately curves are measured, and numbers with their bounds;
//! - `sites`, `side`: where a curve is evaluated, and from which side;
//! - `one_shape`: the one curve of a file that is asked about;
//! - `scheme`: subdivision schemes as words; `levels`: their levels as layers of a figure;
//!   `level_index`: a place in a level;
//! - `kind`, `condition`, `interpolation`, `construction`: the options of `through`, which `draw --through` takes too, and
//!   the curves they ask for;
//! - `steps`: the changes that `refine` makes, in order; `verbs`: these on curves of any family;
//! - `words`: words that options take, and suggestions for mistyped ones;
//! - `voice`: notes and progress;
//! - `failure`, `report`: what can go wrong, its exit code, and its text for people.
//!
//! Conduct: results go to standard output and everything else to standard error; a run that fails has written nothing to
//! standard output and left every file as it was; a reader that goes away early is no failure.
//!
//! It is a library so that a fuzzer can run it without a new process for every line; the program is `main.rs`.
#![forbid(unsafe_code)]

mod accuracy;
mod args;
mod certainty;
mod cmd;
mod condition;
mod construction;
mod derivative;
mod dimension;
mod failure;
mod input;
mod interpolation;
mod interruption;
mod kind;
mod level_index;
mod levels;
mod look;
mod marks;
mod numbers;
mod one_shape;
mod output;
mod report;
mod scheme;
mod side;
mod sites;
mod steps;
mod table;
mod verbs;
mod voice;
mod words;

use clap::Parser;
use std::ffi::OsString;

/// Does what the arguments ask, the first of which is the tool's own name, and returns the exit code.
///
/// Results, files and messages go where they go in the tool.
///
/// ```
/// assert_eq!(lath_cli::run(["lath", "info"]), 2); // no file
/// ```
pub fn run<A: Into<OsString> + Clone>(arguments: impl IntoIterator<Item = A>) -> u8 {
    let outcome = match args::Cli::try_parse_from(arguments) {
        Ok(cli) => cli.run(),
        Err(message) => return report::usage(&message),
    };
    match outcome {
        Ok(()) => report::DONE,
        Err(failure) => report::failure(failure),
    }
}
