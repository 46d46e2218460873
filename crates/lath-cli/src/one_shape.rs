//! The one curve of a file that a question is about: `--shape`.

use crate::failure::{Choice, Failure, Result};
use crate::numbers;
use lath::curve::AnyCurve;
use lath_io::shapes::Shape;
use std::path::Path;

/// The option.
#[derive(Debug, clap::Args)]
pub(crate) struct OneShape {
    /// The shape to take, by index from 0, where the file has several.
    #[arg(long, value_name = "I", value_parser = numbers::count, allow_hyphen_values = true)]
    shape: Option<u64>,
}

impl OneShape {
    /// The one shape, or the one chosen.
    pub(crate) fn of<'a>(&self, path: &Path, shapes: &'a [Shape]) -> Result<&'a AnyCurve> {
        let choice = |code, message, remedy: &str| {
            Failure::Choice(Choice { code, source: source(path), message, remedy: remedy.into() })
        };
        let index = match self.shape {
            Some(index) => usize::try_from(index).unwrap_or(usize::MAX),
            None if shapes.len() == 1 => 0,
            None if shapes.is_empty() => {
                return Err(choice("A002", "there are no shapes".into(), "Give a file with a curve."));
            }
            None => {
                let message = format!("{} shapes, and none chosen: {}", shapes.len(), listed(shapes));
                return Err(choice("A001", message, "Choose one with --shape."));
            }
        };
        let shape = shapes.get(index).ok_or_else(|| {
            let message = format!("there is no shape {index} among {}: {}", shapes.len(), listed(shapes));
            choice("A002", message, "Choose one of the shapes listed with --shape.")
        })?;
        shape.curve().ok_or_else(|| choice("A002", format!("shape {index} is not a curve"), "Choose a curve."))
    }
}

/// What a file is called in messages.
pub(crate) fn source(path: &Path) -> String {
    match path.as_os_str() == "-" {
        true => "standard input".to_owned(),
        false => path.display().to_string(),
    }
}

/// `0 bezier "nose", 1 bspline, …`
fn listed(shapes: &[Shape]) -> String {
    /// More would fill the screen.
    const MOST: usize = 20;
    let one = |(i, shape): (usize, &Shape)| match shape.name() {
        Some(name) => format!("{i} {} \"{name}\"", shape.kind()),
        None => format!("{i} {}", shape.kind()),
    };
    let mut list: Vec<String> = shapes.iter().enumerate().take(MOST).map(one).collect();
    if shapes.len() > MOST {
        list.push("…".into());
    }
    list.join(", ")
}
