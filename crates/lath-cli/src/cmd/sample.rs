//! `lath sample`: points of a curve at equal distances along it, as a table.
//!
//! The curve is measured once; then every row is found by itself, so that no table is held in memory. Nothing may be on standard
//! output when something is wrong: what goes there is found twice, as in `eval`.

use crate::accuracy::{Accuracy, Along};
use crate::certainty::rounded;
use crate::failure::{Failure, Result};
use crate::input::Reading;
use crate::numbers;
use crate::one_shape::{OneShape, source};
use crate::output::Output;
use crate::table::{TableFormat, axis_names};
use crate::voice::Voice;
use clap::ArgGroup;
use lath::curve::AnyCurve;
use lath::error::{Code, Error, Limits};
use lath::knot::Side;
use std::path::PathBuf;

/// Points of a curve at equal distances along it
///
/// Writes a table with the columns t, s and x, y, z (x0, x1, … beyond three coordinates): the parameter, the length of the curve from its start, the
/// point. Distances are measured along the curve, not as the crow flies.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
#[command(group = ArgGroup::new("steps").required(true).args(["spacing", "count"]))]
pub(crate) struct Args {
    /// The file of curves, lath JSON; `-` is standard input.
    shapes: PathBuf,
    /// At the distances 0, D, 2D, … from the start; what remains at the end is said on standard error.
    #[arg(long, value_name = "D", value_parser = numbers::positive, allow_hyphen_values = true)]
    spacing: Option<f64>,
    /// N points in equal distances, both ends among them: of a closed curve the last is the first again.
    #[arg(long, value_name = "N", value_parser = numbers::positive_count, allow_hyphen_values = true)]
    count: Option<u64>,
    #[command(flatten)]
    shape: OneShape,
    #[command(flatten)]
    accuracy: Accuracy,
    #[command(flatten)]
    table: TableFormat,
    #[command(flatten)]
    reading: Reading,
    #[command(flatten)]
    output: Output,
}

const EXAMPLES: &str = "\
Examples:
  lath sample track.json --spacing 25 -o posts.csv
  lath sample curve.json --count 100 --format npy -o points.npy
  lath sample outlines.json --shape 2 --count 13 --json
  lath through wing.dat | lath sample - --count 200 --accuracy 1e-6";

/// Writes the table.
pub(crate) fn run(args: &Args, limits: &Limits<'_>, voice: Voice) -> Result<()> {
    let format = args.table.choose(&args.output)?;
    let shapes = args.reading.shapes(&args.shapes, limits)?;
    let curve = args.shape.of(&args.shapes, &shapes)?;
    let refused = |error: Error| lath_io::Error::from(error).in_source(&source(&args.shapes));
    let along = args.accuracy.along(curve, limits).map_err(refused)?;
    let steps = match (args.spacing, args.count) {
        (Some(spacing), _) => Steps::of_length(spacing, &along),
        (_, Some(count)) => Steps::in_number(count),
        (None, None) => return Err(Failure::usage("give one of '--spacing' and '--count'")),
    };
    limits.check_points(steps.count)?;
    let walk = Walk { curve, along, steps };
    let mut row = Vec::new();
    if !args.output.is_whole() {
        (0..walk.steps.count).try_for_each(|i| walk.fill(i, &mut row)).map_err(refused)?;
    }
    args.output.write(|out| {
        let mut sink = format.rows_counted(out, Some(&walk.columns()), walk.steps.count)?;
        let mut progress =
            voice.unless(args.table.is_json()).progress(Some(walk.steps.count), args.output.file().is_some());
        for i in 0..walk.steps.count {
            progress.step();
            walk.fill(i, &mut row).map_err(refused)?;
            sink.row(&row)?;
        }
        sink.finish()
    })?;
    walk.remarks(&args.accuracy, voice);
    Ok(())
}

/// The distances of the rows.
struct Steps {
    count: u64,
    /// From row to row.
    each: Step,
    /// Whether the last row is the end of the curve.
    to_end: bool,
}

enum Step {
    Distance(f64),
    Share,
}

impl Steps {
    /// Steps of this length; one that ends at the curve's end as far as its length is known does end there.
    fn of_length(spacing: f64, along: &Along) -> Steps {
        let steps = (along.length / spacing).round();
        let slack = along.bound.value() + 4.0 * f64::EPSILON * along.length;
        let to_end = (steps * spacing - along.length).abs() <= slack && slack < spacing;
        let steps = if to_end { steps } else { (along.length / spacing).floor() };
        // The cast saturates: far beyond every budget.
        Steps { count: (steps as u64).saturating_add(1), each: Step::Distance(spacing), to_end }
    }

    /// This many points.
    fn in_number(count: u64) -> Steps {
        Steps { count, each: Step::Share, to_end: count > 1 }
    }
}

/// The rows of the answer.
struct Walk<'a> {
    curve: &'a AnyCurve,
    along: Along,
    steps: Steps,
}

impl Walk<'_> {
    fn columns(&self) -> Vec<String> {
        let mut columns = vec!["t".to_owned(), "s".to_owned()];
        columns.extend(axis_names(self.curve.dimension()));
        columns
    }

    /// How far along the curve row i is.
    fn distance(&self, i: u64) -> f64 {
        let (length, last) = (self.along.length, self.steps.count - 1);
        if self.steps.to_end && i == last {
            return length;
        }
        let distance = match self.steps.each {
            Step::Distance(spacing) => spacing * i as f64,
            Step::Share if last == 0 => 0.0,
            Step::Share => length * (i as f64 / last as f64),
        };
        // Rounding must not lead beyond the end.
        if distance < length { distance } else { length }
    }

    /// Row i: the parameter, the distance, the point.
    fn fill(&self, i: u64, row: &mut Vec<f64>) -> lath::error::Result<()> {
        let (domain, s) = (self.curve.domain(), self.distance(i));
        let t = match i {
            0 => domain.start,
            _ if self.steps.to_end && i == self.steps.count - 1 => domain.end,
            _ => self.along.parameter_at(s)?,
        };
        row.clear();
        row.resize(2 + self.curve.dimension(), 0.0);
        (row[0], row[1]) = (t, s);
        // The end of a closed curve is its start, to the bit.
        let at = if self.curve.is_closed() && t == domain.end { domain.start } else { t };
        self.curve.jet_into(at, Side::Right, 0, &mut row[2..]);
        match row.iter().all(|x| x.is_finite()) {
            true => Ok(()),
            false => Err(Error::new(Code::P003, format!("the point overflows at t = {t}"))),
        }
    }

    /// What the table does not say.
    fn remarks(&self, accuracy: &Accuracy, voice: Voice) {
        let Along { length, bound, .. } = &self.along;
        if !self.steps.to_end && matches!(self.steps.each, Step::Distance(_)) {
            let rest = length - self.distance(self.steps.count - 1);
            let (rest, whole) = (rounded(rest, *bound), rounded(*length, *bound));
            voice.note(&format!("{rest} of {whole} remain after the last point"));
        }
        if !bound.is_proven() {
            voice.note(&format!("distances are an estimate, within about {:.0e}", bound.value()));
        } else if let Some(asked) = accuracy.missed_by(*bound) {
            voice.note(&format!(
                "the accuracy {asked:e} is not reached: distances are within {:.0e}",
                1.5 * bound.value()
            ));
        }
    }
}
