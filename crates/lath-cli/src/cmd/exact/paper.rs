//! How an answer is written down: text, JSON, LaTeX, source code, its derivation, or a picture.

use crate::failure::{Failure, Result};
use crate::look::Look;
use crate::output::{Output, extension};
use clap::ValueEnum;
use lath::error::Limits;
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
    /// A picture of the functions of 'matrix' and 'blending'
    Svg,
    /// The same in pixels
    Png,
}

impl Format {
    /// What the extension of a file promises.
    fn of(extension: &str) -> Option<Format> {
        Some(match extension {
            "txt" => Format::Text,
            "json" => Format::Json,
            "tex" => Format::Latex,
            "rs" => Format::Rust,
            "py" => Format::Python,
            "c" | "h" => Format::C,
            "svg" => Format::Svg,
            "png" => Format::Png,
            _ => return None,
        })
    }
}

impl Paper {
    /// Writes an answer of which there is nothing to draw.
    pub(crate) fn write(&self, answer: &dyn Answer, limits: &Limits<'_>) -> Result<()> {
        let format = match self.format()? {
            Format::Text => print::Format::Text,
            Format::Json => print::Format::Json,
            Format::Latex => print::Format::Latex,
            Format::Rust => print::Format::Source(Language::Rust),
            Format::Python => print::Format::Source(Language::Python),
            Format::C => print::Format::Source(Language::C),
            Format::Svg | Format::Png => {
                return Err(Failure::usage("there is nothing to draw; 'matrix' and 'blending' make pictures"));
            }
        };
        let text = if self.explain { answer.explain(limits)? } else { render(answer, format)? };
        self.put(text.as_bytes())
    }

    /// Writes an answer, or the picture that `draw` makes of it.
    pub(crate) fn write_or_draw(
        &self,
        answer: &dyn Answer,
        look: &Look,
        draw: impl FnOnce() -> lath::error::Result<Figure>,
        limits: &Limits<'_>,
    ) -> Result<()> {
        match self.format()? {
            Format::Svg => self.put(look.apply(draw()?).to_svg()?.as_bytes()),
            Format::Png => self.put(&look.apply(draw()?).to_png()?),
            _ if look.is_given() => {
                let options = "'--dark', '--size', '--title' and '--density' belong to a picture";
                Err(Failure::usage(format!("{options}: write to a file .svg or .png, or choose one with '--format'")))
            }
            _ => self.write(answer, limits),
        }
    }

    fn put(&self, bytes: &[u8]) -> Result<()> {
        self.output.write(|out| out.write_all(bytes).map_err(|error| Error::writing(&error)))
    }

    /// As asked for, else by the extension of the output, else text.
    fn format(&self) -> Result<Format> {
        let extension = extension(self.output.file());
        let promised = extension.as_deref().and_then(Format::of);
        let asked = self.format.or(self.json.then_some(Format::Json)).or(self.explain.then_some(Format::Text));
        match (asked, promised, extension) {
            (Some(asked), Some(Format::Svg | Format::Png), _) if !matches!(asked, Format::Svg | Format::Png) => {
                let message = "a picture is neither text nor a derivation: give the output another extension";
                Err(Failure::usage(message))
            }
            (Some(format), ..) | (None, Some(format), _) => Ok(format),
            (None, None, None) => Ok(Format::Text),
            (None, None, Some(extension)) => {
                let message = format!("no format has the extension '.{extension}': choose one with '--format'");
                Err(Failure::usage(message))
            }
        }
    }
}
