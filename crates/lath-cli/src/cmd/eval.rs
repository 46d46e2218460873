//! `lath eval`: points and derivatives of a curve, as a table.
//!
//! Nothing may be on standard output when something is wrong, and no table is held in memory. So what goes to standard
//! output is evaluated twice: once to see that every row can be written, and once to write. A file is written whole or not
//! at all: there once is enough.

use crate::failure::{Failure, Result};
use crate::input::{Reading, check_standard_input};
use crate::numbers;
use crate::one_shape::OneShape;
use crate::output::Output;
use crate::side::Side;
use crate::sites::{At, Sites};
use crate::table::{TableFormat, axis_names};
use crate::voice::Voice;
use clap::{ArgGroup, ValueEnum};
use lath::curve::{AnyCurve, Outside};
use lath::error::{Code, Error, Limits};
use std::path::PathBuf;

/// Evaluate a curve: points and derivatives
///
/// Writes a table with the columns t, x, y, z (x0, x1, … beyond three coordinates), then x_1, y_1, … for first derivatives,
/// x_2, … for second ones.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
#[command(group = ArgGroup::new("where").required(true).args(["at", "count", "at_file"]))]
pub(crate) struct Args {
    /// The file of curves, lath JSON; `-` is standard input.
    shapes: PathBuf,
    /// At these parameters, such as 0,1/3,1; or at the breaks of the curve, with the word breaks.
    #[arg(long, value_name = "T,…|breaks", allow_hyphen_values = true)]
    at: Option<At>,
    /// At N parameters in equal steps from one end of the domain to the other.
    #[arg(long, value_name = "N", value_parser = numbers::positive_count, allow_hyphen_values = true)]
    count: Option<u64>,
    /// At the parameters in this file, one a row, in any points format.
    #[arg(long, value_name = "FILE")]
    at_file: Option<PathBuf>,
    /// Also the derivatives up to this order.
    #[arg(long, value_name = "K", value_parser = numbers::count, allow_hyphen_values = true, default_value = "0")]
    derivatives: u64,
    #[command(flatten)]
    shape: OneShape,
    /// What to answer outside the domain (default error, and periodic for closed curves).
    #[arg(long, value_enum, value_name = "POLICY")]
    outside: Option<Policy>,
    /// From which side derivatives (and values, where the curve jumps) are taken at a break.
    #[arg(long, value_enum, default_value = "right")]
    side: Side,
    #[command(flatten)]
    table: TableFormat,
    #[command(flatten)]
    reading: Reading,
    #[command(flatten)]
    output: Output,
}

const EXAMPLES: &str = "\
Examples:
  lath eval curve.json --count 200 -o points.csv
  lath eval curve.json --at 0,1/3,1 --derivatives 2
  lath eval curve.json --at breaks --json
  lath eval curve.json --at breaks --derivatives 2 --side left
  lath eval curve.json --at-file t.txt --outside clamp --format tsv
  lath through wing.dat | lath eval - --count 5";

#[derive(Clone, Copy, Debug, PartialEq, ValueEnum)]
enum Policy {
    /// Refuse, naming the first t outside
    Error,
    /// The nearer end of the curve
    Clamp,
    /// The first or last polynomial piece, continued
    Extrapolate,
    /// The curve repeated
    Periodic,
}

/// Writes the table.
pub(crate) fn run(args: &Args, limits: &Limits<'_>, voice: Voice) -> Result<()> {
    check_standard_input([Some(&args.shapes), args.at_file.as_ref()].into_iter().flatten().map(PathBuf::as_path))?;
    let format = args.table.choose(&args.output)?;
    let shapes = args.reading.shapes(&args.shapes, limits)?;
    let curve = args.shape.of(&args.shapes, &shapes)?;
    let mut sites = match (&args.at, args.count, &args.at_file) {
        (Some(at), ..) => Sites::at(at, curve),
        (_, Some(count), _) => Sites::even(curve.domain(), count),
        (_, _, Some(path)) => Sites::in_file(path, limits)?,
        (None, None, None) => return Err(Failure::usage("give one of '--at', '--count' and '--at-file'")),
    };
    let mut count = sites.count();
    count.into_iter().try_for_each(|count| limits.check_points(count))?;
    let table = Table::new(curve, args, limits)?;
    let mut row = Vec::new();
    let check = !args.output.is_whole();
    if check || (count.is_none() && format.counts_rows()) {
        let mut found = 0;
        while let Some(t) = sites.next()? {
            if check {
                table.fill(t, &mut row).map_err(|error| sites.locate(error))?;
            }
            found += 1;
        }
        count = Some(found);
        sites.rewind()?;
    }
    args.output.write(|out| {
        let columns = table.columns();
        let mut sink = match count {
            Some(count) => format.rows_counted(out, Some(&columns), count)?,
            None => format.rows(out, Some(&columns))?,
        };
        let mut progress = voice.unless(args.table.is_json()).progress(count, args.output.file().is_some());
        while let Some(t) = sites.next()? {
            progress.step();
            table.fill(t, &mut row).map_err(|error| sites.locate(error))?;
            sink.row(&row)?;
        }
        sink.finish()
    })
}

/// The rows of the answer.
struct Table<'a> {
    curve: &'a AnyCurve,
    order: usize,
    outside: Outside,
    side: lath::knot::Side,
}

impl<'a> Table<'a> {
    fn new(curve: &'a AnyCurve, args: &Args, limits: &Limits<'_>) -> Result<Table<'a>> {
        // A row with its columns' names is held three times over.
        let cells = args.derivatives.saturating_add(1).saturating_mul(16);
        limits.check_bytes(cells.saturating_mul(64))?;
        let outside = match args.outside {
            Some(Policy::Error) => Outside::Error,
            Some(Policy::Clamp) => Outside::Clamp,
            Some(Policy::Extrapolate) => Outside::Extrapolate,
            Some(Policy::Periodic) => Outside::Periodic,
            None if curve.is_closed() => Outside::Periodic,
            None => Outside::Error,
        };
        Ok(Table {
            curve,
            order: usize::try_from(args.derivatives).unwrap_or(usize::MAX),
            outside,
            side: args.side.into(),
        })
    }

    fn columns(&self) -> Vec<String> {
        let axes = axis_names(self.curve.dimension());
        let mut columns = vec!["t".to_owned()];
        columns.extend(axes.iter().cloned());
        for k in 1..=self.order {
            columns.extend(axes.iter().map(|axis| format!("{axis}_{k}")));
        }
        columns
    }

    /// The row at t: t itself, the point, the derivatives.
    fn fill(&self, t: f64, row: &mut Vec<f64>) -> lath::error::Result<()> {
        row.clear();
        row.resize(1 + (self.order + 1) * self.curve.dimension(), 0.0);
        let Some((first, jet)) = row.split_first_mut() else {
            return Ok(());
        };
        *first = t;
        let at = self.curve.domain().resolve(t, self.outside)?;
        // Before the seam of a closed curve lies its end.
        let before = self.curve.is_closed() && self.side == Side::Left.into() && at == self.curve.domain().start;
        let at = if before { self.curve.domain().end } else { at };
        self.curve.jet_into(at, self.side, self.order, jet);
        match jet.iter().position(|x| !x.is_finite()) {
            None => Ok(()),
            Some(i) => {
                let message = format!("the {} overflows at t = {t}", derivative_name(i / self.curve.dimension()));
                Err(Error::new(Code::P003, message))
            }
        }
    }
}

fn derivative_name(order: usize) -> String {
    match order {
        0 => "point".into(),
        _ => format!("derivative of order {order}"),
    }
}
