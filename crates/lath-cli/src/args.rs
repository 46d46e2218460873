//! The verbs, and what is said about the tool as a whole.

use crate::cmd::{
    check, completions, convert, curve, draw, eval, exact, info, length, man, refine, sample, subdivide, through,
};
use crate::failure::Result;
use crate::numbers;
use crate::voice::Voice;
use clap::{Parser, Subcommand};
use lath::error::Limits;

/// Splines: points in, curve out, picture out.
#[derive(Debug, Parser)]
#[command(
    name = "lath",
    version,
    long_version = LONG_VERSION,
    max_term_width = 100,
    subcommand_value_name = "VERB",
    subcommand_help_heading = "Verbs",
    long_about = "Splines: points in, curve out, picture out.\n\n\
        Points are CSV, TSV, text or JSON; curves travel as lath JSON. `-` is standard input or output, so that verbs can \
        be joined by pipes. Results go to standard output, everything else to standard error.",
    after_help = "Run `lath VERB --help` for the options of a verb, with examples.",
    after_long_help = EXIT_CODES
)]
pub(crate) struct Cli {
    #[command(subcommand)]
    verb: Verb,
    /// Refuse work on more points than this (default 2147483648).
    #[arg(long, global = true, display_order = 900, value_name = "POINTS", value_parser = numbers::count, allow_hyphen_values = true)]
    budget: Option<u64>,
    /// Say nothing on standard error but failures: no notes, no progress.
    #[arg(short, long, global = true, display_order = 901)]
    quiet: bool,
}

/// The features are those that change what the tool can do; every SIMD level gives the same bits.
const LONG_VERSION: &str = concat!(env!("CARGO_PKG_VERSION"), "\nfeatures: none\nSIMD level: scalar");

const EXIT_CODES: &str = "\
Examples:
  lath draw wing.dat --through --comb --axes -o wing.svg
      a curve through measured points, with its curvature, as a picture
  lath through wing.dat | lath eval - --count 200
      the same curve, as 200 points
  lath curve polygon.csv --kind bspline | lath info -
      what a B-spline over a polygon is like

Exit codes:
  0    done; also when the reader of a pipe stops reading
  1    the computation failed, or `check` found an error
  2    the command line is wrong, whatever the data
  3    the data are invalid, or do not fit the options
  4    a file could not be read or written
  5    the budget would be exceeded
  130  interrupted

An error names its code, its place and a remedy; then nothing is on standard output, and no file
has changed.";

#[derive(Debug, Subcommand)]
enum Verb {
    Through(through::Args),
    Curve(curve::Args),
    Eval(eval::Args),
    Sample(sample::Args),
    Length(length::Args),
    Refine(refine::Args),
    Subdivide(subdivide::Args),
    Draw(draw::Args),
    Info(info::Args),
    Check(check::Args),
    Convert(convert::Args),
    Exact(exact::Args),
    Completions(completions::Args),
    Man(man::Args),
}

impl Cli {
    /// Does what was asked.
    pub(crate) fn run(self) -> Result<()> {
        let limits = Limits::default();
        let limits = Limits { max_points: self.budget.unwrap_or(limits.max_points), ..limits };
        let voice = Voice { quiet: self.quiet };
        let (name, outcome) = match self.verb {
            Verb::Through(args) => ("through", through::run(&args, &limits)),
            Verb::Curve(args) => ("curve", curve::run(&args, &limits)),
            Verb::Eval(args) => ("eval", eval::run(&args, &limits, voice)),
            Verb::Sample(args) => ("sample", sample::run(&args, &limits, voice)),
            Verb::Length(args) => ("length", length::run(&args, &limits, voice)),
            Verb::Refine(args) => ("refine", refine::run(&args, &limits, voice)),
            Verb::Subdivide(args) => ("subdivide", subdivide::run(&args, &limits, voice)),
            Verb::Draw(args) => ("draw", draw::run(&args, &limits)),
            Verb::Info(args) => ("info", info::run(&args, &limits)),
            Verb::Check(args) => ("check", check::run(&args, &limits, voice)),
            Verb::Convert(args) => ("convert", convert::run(&args, &limits, voice)),
            Verb::Exact(args) => ("exact", exact::run(&args, &limits)),
            Verb::Completions(args) => ("completions", completions::run(&args)),
            Verb::Man(args) => ("man", man::run(&args)),
        };
        outcome.map_err(|failure| failure.in_verb(name))
    }
}
