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
/// Reads points (CSV, TSV, text, JSON) and writes a curve through all of them as lath JSON: a cubic spline with continuous
/// second derivative, or another --kind.
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
      half a period of something that returns mirrored
  lath through path.csv --kind bspline --degree 5
      four continuous derivatives
  lath through path.csv --kind bspline --derivative 2:1:1,0
      along the x axis at point 2
  lath through path.csv --kind catmull-rom --params alpha:1/4
      between uniform and centripetal
  lath through prices.csv --params column:day --kind pchip
      no overshoot: it rises and falls only where the data do";

/// Writes the curve.
pub(crate) fn run(args: &Args, limits: &Limits<'_>) -> Result<()> {
    check_extension(args.output.file(), &["json"], "curves are written as .json; `lath eval` makes points of them")?;
    args.interpolation.check()?;
    args.interpolation.check_single()?;
    let names = args.interpolation.names(&args.coordinates);
    let table = args.reading.points_named(&args.points, &names, limits)?;
    let (made, _) = args.interpolation.curves(&table, &args.coordinates, limits)?;
    let shapes: Vec<Shape> = made.into_iter().map(|passing| Shape::from(passing.curve)).collect();
    args.output.write(|out| shapes::write(out, &shapes))
}
