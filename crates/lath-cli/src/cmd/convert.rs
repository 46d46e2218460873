//! `lath convert`: the same points in another format.
//!
//! Rows go out as they come in, so that any number of them is converted in constant memory. What goes to standard output is
//! read twice, because nothing may be there when row ten million is no row; a file is written whole or not at all, and read
//! once, unless its format begins with the number of rows.

use crate::failure::{Failure, Result};
use crate::input::{Coordinates, Reading, not_points};
use crate::output;
use crate::table::TableFormat;
use crate::verbs::{self, Form};
use crate::voice::Voice;
use lath::error::Limits;
use lath_io::format::{Format, Opened};
use lath_io::points::Rows;
use lath_io::shapes::Shape;
use std::path::{Path, PathBuf};

/// Write the same points in another format, or the same curves in another form
///
/// Reads points (CSV, TSV, text, JSON, .npy) and writes the same numbers, bit by bit, in the format that the extension of OUT
/// or --format names. Names of columns are kept where the format has a place for them (.npy has none), comments and titles
/// are not. Memory does not grow with the number of rows; JSON alone is held whole while it is read.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Args {
    /// The file of points; `-` is standard input.
    #[arg(value_name = "IN")]
    input: PathBuf,
    /// The file to write, replacing it; `-` is standard output.
    #[arg(value_name = "OUT")]
    output: PathBuf,
    /// Write curves, in this form: exact where it can be, else the distance is printed.
    #[arg(long, value_enum, value_name = "FORM", conflicts_with_all = ["format", "json", "columns"])]
    to: Option<Form>,
    #[command(flatten)]
    table: TableFormat,
    #[command(flatten)]
    reading: Reading,
    #[command(flatten)]
    coordinates: Coordinates,
}

const EXAMPLES: &str = "\
Examples:
  lath convert wing.dat wing.csv
  lath convert log.csv xy.npy --columns x,y
      two columns of many; the others may hold words
  lath convert points.npy - --format json
  lath eval curve.json --count 1e6 | lath convert - points.npy
  lath convert curve.json pieces.json --to bezier
      one Bézier curve for each piece";

/// Writes the points.
pub(crate) fn run(args: &Args, limits: &Limits<'_>, voice: Voice) -> Result<()> {
    let file = output::file(Some(&args.output));
    if let Some(form) = args.to {
        return shapes(args, form, file, limits, voice);
    }
    let format = args.table.choose_for(file)?;
    match args.reading.open(&args.input, &args.coordinates.names(), limits)? {
        Opened::Rows(rows) => points(rows, file, format, voice.unless(args.table.is_json())),
        Opened::Shapes(_) => Err(not_points(&args.input)),
    }
}

/// Curve by curve.
fn shapes(args: &Args, form: Form, file: Option<&Path>, limits: &Limits<'_>, voice: Voice) -> Result<()> {
    output::check_extension(file, &["json"], "curves are written as .json")?;
    let name =
        if args.input.as_os_str() == "-" { "standard input".to_owned() } else { args.input.display().to_string() };
    let given = args.reading.shapes(&args.input, limits)?;
    let (mut made, mut notes) = (Vec::new(), Vec::new());
    for (index, shape) in given.iter().enumerate() {
        let curve = shape.curve().ok_or_else(|| Failure::no_shapes(&name))?;
        let outcome = verbs::convert(curve, form).map_err(|error| {
            let error = lath_io::Error::from(error).in_source(&name);
            if given.len() > 1 { error.at_index(index) } else { error }
        })?;
        let of = if given.len() > 1 { format!("curve {index}: ") } else { String::new() };
        notes.extend(outcome.note.map(|note| of + &note));
        made.extend(outcome.curves.into_iter().map(|curve| match shape.name() {
            Some(name) => Shape::from(curve).named(name),
            None => Shape::from(curve),
        }));
    }
    let text = lath_io::shapes::to_string(&made)?;
    notes.iter().for_each(|note| voice.note(note));
    output::write(file, |out| out.write_all(text.as_bytes()).map_err(|error| lath_io::Error::writing(&error)))
}

/// Row by row.
fn points(mut rows: Rows<'_>, file: Option<&Path>, format: &Format, voice: Voice) -> Result<()> {
    let mut count = None;
    if !output::is_whole(file) || format.counts_rows() {
        while rows.next_row()?.is_some() {}
        count = Some(rows.count());
        rows.rewind()?;
    }
    output::write(file, |out| {
        let mut progress = voice.progress(count, file.is_some());
        // The names are known with the first row, which every table has.
        let first = rows.next_row()?.map(<[f64]>::to_vec);
        let mut sink = match count {
            Some(count) => format.rows_counted(out, rows.columns(), count)?,
            None => format.rows(out, rows.columns())?,
        };
        first.into_iter().try_for_each(|row| sink.row(&row))?;
        while let Some(row) = rows.next_row()? {
            progress.step();
            sink.row(row)?;
        }
        sink.finish()
    })
}
