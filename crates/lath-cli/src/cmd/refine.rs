//! `lath refine`: the same curves in another description.

use crate::failure::{Failure, Result};
use crate::input::Reading;
use crate::output::{Output, check_extension};
use crate::steps::{Step, Steps};
use crate::verbs;
use crate::voice::Voice;
use lath::curve::AnyCurve;
use lath::error::Limits;
use lath_io::shapes::{self, Shape};
use std::path::PathBuf;

/// Change the description of curves: knots, degree, ends, direction
///
/// The steps are taken in the order in which they stand, on every curve of the file. Most leave every point of a curve where it is; those that
/// cannot say on standard error how far points may have moved, which is proven. Curves that are not Bézier curves or B-splines become
/// B-splines.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Args {
    /// The file of curves, lath JSON; `-` is standard input.
    shapes: PathBuf,
    #[command(flatten)]
    steps: Steps,
    #[command(flatten)]
    reading: Reading,
    #[command(flatten)]
    output: Output,
}

const EXAMPLES: &str = "\
Examples:
  lath refine curve.json --insert 1/4,1/2 --elevate 1 -o finer.json
  lath refine curve.json --remove 1e-3 -o coarser.json
  lath refine curve.json --reduce 1 --tolerance 0.01
  lath refine curve.json --trim 0.2,0.8 --reverse --domain 0,1
  lath refine ring.json --seam 2 --clamp
  lath refine halves.json --join 1e-9";

/// Takes the steps and writes the curves.
pub(crate) fn run(args: &Args, limits: &Limits<'_>, voice: Voice) -> Result<()> {
    check_extension(args.output.file(), &["json"], "curves are written as .json; `lath eval` makes points of them")?;
    let steps = args.steps.checked()?;
    let source = match args.shapes.as_os_str() == "-" {
        true => "standard input".to_owned(),
        false => args.shapes.display().to_string(),
    };
    let shapes = args.reading.shapes(&args.shapes, limits)?;
    if shapes.is_empty() {
        return Err(Failure::no_shapes(&source));
    }
    let mut curves = Vec::with_capacity(shapes.len());
    for shape in &shapes {
        let curve = shape.curve().ok_or_else(|| Failure::no_shapes(&source))?;
        curves.push(Named { name: shape.name().map(str::to_owned), curve: curve.clone() });
    }
    let mut notes = Vec::new();
    for step in &steps {
        curves = taken(step, &curves, limits, &mut notes).map_err(|(index, error)| {
            let error = lath_io::Error::from(error).in_source(&source);
            Failure::from(if shapes.len() > 1 { error.at_index(index) } else { error })
        })?;
    }
    let written: Vec<Shape> = curves.into_iter().map(Named::shape).collect();
    // Refused here, before anything is written, if a curve has no form in a file.
    let text = shapes::to_string(&written)?;
    notes.iter().for_each(|note| voice.note(note));
    args.output.write(|out| out.write_all(text.as_bytes()).map_err(|error| lath_io::Error::writing(&error)))
}

/// A curve and its name.
struct Named {
    name: Option<String>,
    curve: AnyCurve,
}

impl Named {
    fn shape(self) -> Shape {
        let shape = Shape::from(self.curve);
        match self.name {
            Some(name) => shape.named(name),
            None => shape,
        }
    }
}

/// The curves after a step, or what went wrong with which of them.
fn taken(
    step: &Step,
    curves: &[Named],
    limits: &Limits<'_>,
    notes: &mut Vec<String>,
) -> Result<Vec<Named>, (usize, lath::error::Error)> {
    let mut after: Vec<Named> = Vec::with_capacity(curves.len());
    let of = |index: usize| if curves.len() > 1 { format!("curve {index}: ") } else { String::new() };
    for (index, Named { name, curve }) in curves.iter().enumerate() {
        let result = match (step, after.pop()) {
            (Step::Join(tolerance), Some(before)) => {
                let outcome = verbs::join(&before.curve, curve, *tolerance).map_err(|error| (index, error))?;
                after.push(Named { name: before.name, curve: outcome.curves[0].clone() });
                notes.extend(outcome.note.map(|note| of(index) + &note));
                continue;
            }
            (Step::Join(_), None) => {
                after.push(Named { name: name.clone(), curve: curve.clone() });
                continue;
            }
            (step, before) => {
                after.extend(before);
                verbs::take(step, curve, limits)
            }
        };
        let outcome = result.map_err(|error| (index, error))?;
        notes.extend(outcome.note.map(|note| of(index) + &note));
        after.extend(outcome.curves.into_iter().map(|curve| Named { name: name.clone(), curve }));
    }
    Ok(after)
}
