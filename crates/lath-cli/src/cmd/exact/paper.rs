//! How an answer is written down: text, JSON, LaTeX, source code, its derivation, or a picture.

use crate::failure::{Failure, Result};
use crate::output::{Output, extension};
use clap::ValueEnum;
use lath_draw::figure::Figure;
use lath_exact::print::{self, Answer, Language, render};
use lath_io::Error;

/// The options of every question.
#[derive(Debug, clap::Args)]
pub(crate) struct Paper {
    /// How the answer is written (default: by the extension of the output, else text).
    #[arg(long, value_enum, display_order = 800)]
    format: Option<Format>,
    /// The same as --format json.
    #[arg(long, conflicts_with = "format", display_order = 801)]
    json: bool,
    /// The derivation in steps.
    #[arg(long, conflicts_with_all = ["format", "json"], display_order = 802)]
    explain: bool,
    #[command(flatten)]
    output: Output,
}

#[derive(Clone, Copy, Debug, PartialEq, ValueEnum)]
enum Format {
    /// Text that lines up
    Text,
    /// One object, fractions as strings
    Json,
    /// Formulas for LaTeX and KaTeX
    Latex,
    /// Constants for Rust
    Rust,
    /// Constants for Python
    Python,
    /// Constants for C
    C,
}

/// Makes the picture of an answer.
pub(crate) type Draw<'a> = &'a dyn Fn() -> lath::error::Result<Figure>;

impl Paper {
    /// Writes the answer; `draw` makes its picture, where there is something to draw.
    pub(crate) fn write(&self, answer: &dyn Answer, draw: Option<Draw<'_>>) -> Result<()> {
        let extension = extension(self.output.file());
        let bytes = match (extension.as_deref(), draw) {
            (Some("svg" | "png"), _) if self.format.is_some() || self.json || self.explain => {
                return Err(Failure::usage("a picture has no '--format', '--json' or '--explain'"));
            }
            (Some("svg"), Some(draw)) => draw()?.to_svg()?.into_bytes(),
            (Some("png"), Some(draw)) => draw()?.to_png()?,
            (Some("svg" | "png"), None) => {
                return Err(Failure::usage("there is nothing to draw; 'matrix' and 'blending' make pictures"));
            }
            (extension, _) => {
                let text = match (self.explain, self.format(extension)?) {
                    (true, _) => answer.explain(),
                    (false, format) => render(answer, format)?,
                };
                text.into_bytes()
            }
        };
        self.output.write(|out| out.write_all(&bytes).map_err(|error| Error::writing(&error)))
    }

    fn format(&self, extension: Option<&str>) -> Result<print::Format> {
        let chosen = match (self.format, self.json, extension) {
            (Some(format), ..) => format,
            (None, true, _) => Format::Json,
            (None, false, None | Some("txt")) => Format::Text,
            (None, false, Some("json")) => Format::Json,
            (None, false, Some("tex")) => Format::Latex,
            (None, false, Some("rs")) => Format::Rust,
            (None, false, Some("py")) => Format::Python,
            (None, false, Some("c" | "h")) => Format::C,
            (None, false, Some(_)) if self.explain => Format::Text,
            (None, false, Some(extension)) => {
                let message = format!("no format has the extension '.{extension}': choose one with '--format'");
                return Err(Failure::usage(message));
            }
        };
        Ok(match chosen {
            Format::Text => print::Format::Text,
            Format::Json => print::Format::Json,
            Format::Latex => print::Format::Latex,
            Format::Rust => print::Format::Source(Language::Rust),
            Format::Python => print::Format::Source(Language::Python),
            Format::C => print::Format::Source(Language::C),
        })
    }
}
