//! `lath through`: a curve through points.

use crate::failure::Result;
use crate::input::{Coordinates, Reading};
use crate::interpolation::Interpolation;
use crate::output::{Output, check_extension};
use lath::error::Limits;
use lath_io::shapes::{self, Shape};
use std::path::PathBuf;

/// Make a curve through points
///
/// Reads points (CSV, TSV, text, JSON) and writes the curve as lath JSON: a cubic spline through all of them, with
/// continuous second derivative.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Args {
    /// The file of points; `-` is standard input.
    points: PathBuf,
    #[command(flatten)]
    reading: Reading,
    #[command(flatten)]
    coordinates: Coordinates,
    #[command(flatten)]
    interpolation: Interpolation,
    #[command(flatten)]
    output: Output,
}

const EXAMPLES: &str = "\
Examples:
  lath through wing.dat
      centripetal parameters and not-a-knot ends: nothing else to say
  lath through nile.csv --params column:year --ends natural -o nile.json
      y(x): the year is t, the other column the value
  lath through path.csv --params chord --start clamped:1,0 --end natural
      start along the x axis with unit speed
  lath through coast.csv --closed | lath draw - -o coast.png
  lath through half.csv --ends anticyclic
      half a period of something that returns mirrored";

/// Writes the curve.
pub(crate) fn run(args: &Args, limits: &Limits<'_>) -> Result<()> {
    check_extension(args.output.file(), &["json"], "curves are written as .json; `lath eval` makes points of them")?;
    args.interpolation.check()?;
    let table = args.reading.points(&args.points, limits)?;
    let (curve, _) = args.interpolation.curve(&table, &args.coordinates, limits)?;
    args.output.write(|out| shapes::write(out, &[Shape::from(curve)]))
}
