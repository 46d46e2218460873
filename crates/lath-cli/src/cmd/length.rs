//! `lath length`: how long curves are, and how far that may be off.

use crate::accuracy::Accuracy;
use crate::certainty::{bound_json, with_margin};
use crate::failure::{Failure, Result};
use crate::input::Reading;
use crate::one_shape::source;
use crate::output;
use crate::voice::Voice;
use lath::error::{Code, Error, Limits};
use lath::num::Bound;
use lath_io::shapes::Shape;
use serde_json::{Value, json};
use std::path::PathBuf;

/// Say how long curves are, and how far that may be off
///
/// One line a shape, and the total of several. Jumps have no length; a curve in one dimension is as long as the way that its value goes up and
/// down. The bound behind ± is proven unless it says that it is an estimate.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Args {
    /// The file of curves, lath JSON; `-` is standard input.
    shapes: PathBuf,
    #[command(flatten)]
    accuracy: Accuracy,
    /// One JSON object instead of text.
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    reading: Reading,
}

const EXAMPLES: &str = "\
Examples:
  lath length curve.json
  lath length curve.json --accuracy 1e-3
  lath length outline.json --json
  lath through wing.dat | lath length -";

/// Writes the lengths.
pub(crate) fn run(args: &Args, limits: &Limits<'_>, voice: Voice) -> Result<()> {
    let source = source(&args.shapes);
    let shapes = args.reading.shapes(&args.shapes, limits)?;
    if shapes.is_empty() {
        return Err(Failure::no_shapes(&source));
    }
    let refused = |error: Error| lath_io::Error::from(error).in_source(&source);
    let (mut lengths, mut missed) = (Vec::with_capacity(shapes.len()), None);
    for (index, shape) in shapes.iter().enumerate() {
        let curve = shape.curve().ok_or_else(|| Failure::no_shapes(&source))?;
        let found = args.accuracy.length(curve, limits).map_err(|error| {
            let error = refused(error);
            if shapes.len() > 1 { error.at_index(index) } else { error }
        })?;
        missed = args.accuracy.missed_by(found.1).or(missed);
        lengths.push(found);
    }
    let total = total(&lengths).map_err(refused)?;
    let text = match args.json {
        true => as_json(&shapes, &lengths, total).to_string() + "\n",
        false => as_text(&shapes, &lengths, total),
    };
    if let Some(accuracy) = missed {
        voice.note(&format!("the accuracy {accuracy:e} is not reached: see the bounds"));
    }
    output::write(None, |out| out.write_all(text.as_bytes()).map_err(|error| lath_io::Error::writing(&error)))
}

/// The lengths together, with the rounding of the sum.
fn total(lengths: &[(f64, Bound)]) -> lath::error::Result<(f64, Bound)> {
    let (mut sum, mut error, mut proven) = (0.0, 0.0, true);
    for (length, bound) in lengths {
        sum += length;
        error += bound.value();
        proven &= bound.is_proven();
    }
    // The first sum is exact.
    let roundings = lengths.len().saturating_sub(1) as f64;
    let error = error * (1.0 + roundings * f64::EPSILON) + roundings * f64::EPSILON * sum;
    if !(sum.is_finite() && error.is_finite()) {
        return Err(Error::new(Code::P003, "the lengths together overflow"));
    }
    Ok((sum, if proven { Bound::Proven(error) } else { Bound::Estimate(error) }))
}

fn as_json(shapes: &[Shape], lengths: &[(f64, Bound)], (total, bound): (f64, Bound)) -> Value {
    let one = |(index, (shape, (length, bound))): (usize, (&Shape, &(f64, Bound)))| {
        let mut object = json!({ "index": index, "kind": shape.kind() });
        if let Some(name) = shape.name() {
            object["name"] = json!(name);
        }
        object["length"] = json!(length);
        object["length_bound"] = bound_json(*bound);
        object
    };
    let shapes: Vec<Value> = shapes.iter().zip(lengths).enumerate().map(one).collect();
    json!({ "count": shapes.len(), "shapes": shapes, "length": total, "length_bound": bound_json(bound) })
}

fn as_text(shapes: &[Shape], lengths: &[(f64, Bound)], total: (f64, Bound)) -> String {
    let label = |(index, shape): (usize, &Shape)| match shape.name() {
        Some(name) => format!("shape {index} \"{name}\""),
        None => format!("shape {index}"),
    };
    let mut lines: Vec<(String, (f64, Bound))> =
        shapes.iter().enumerate().map(label).zip(lengths.iter().copied()).collect();
    if lines.len() > 1 {
        lines.push(("total".into(), total));
    }
    let width = lines.iter().map(|(label, _)| label.chars().count()).max().unwrap_or(0);
    lines.iter().map(|(label, (length, bound))| format!("{label:width$}  {}\n", with_margin(*length, *bound))).collect()
}
