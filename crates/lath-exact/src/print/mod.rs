//! Answers on paper: text that lines up, JSON, LaTeX, constants for programs, and derivations in steps.
//!
//! Every answer says once what it consists of (a [`Sheet`] of matrices, rows of weights and functions); text, LaTeX and source code
//! are three ways to write a sheet down. JSON has a fixed shape for each question instead, a promise to programs: fractions are
//! strings in lowest terms, `"121/384"`.
//!
//! Conventions of the text: the common denominator stands before a matrix, minus signs are typographic (`−`; [`parse`](crate::parse)
//! reads them), polynomials descend in powers and stand over one denominator, powers of a linear factor stay powers.

mod json;
mod latex;
mod number;
mod polynomial;
mod shapes;
mod sheet;
mod sheets;
mod source;
mod text;

pub use sheet::Sheet;
pub use source::Language;

pub(crate) use number::{Symbol, exponent, subscript, sum_text, superscript, text as number_text};
pub(crate) use polynomial::piece_text;
pub(crate) use sheets::{comma, derived};
pub(crate) use text::{matrix_lines, vector_line};

use crate::error::{Code, Error, Result};
use lath::error::Limits;
use std::str::FromStr;

/// How an answer is written down.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// Unicode text in a fixed-width font.
    Text,
    /// One object, with fractions as strings.
    Json,
    /// Formulas between `\[` and `\]`; for LaTeX with amsmath, and KaTeX.
    Latex,
    /// Constants for a program, as doubles: quotients of integers, or the nearest double beside the fraction.
    Source(Language),
}

impl FromStr for Format {
    type Err = Error;

    /// Reads `text`, `json`, `latex`, `rust`, `python` or `c`.
    fn from_str(text: &str) -> Result<Format> {
        Ok(match text {
            "text" => Format::Text,
            "json" => Format::Json,
            "latex" => Format::Latex,
            "rust" => Format::Source(Language::Rust),
            "python" => Format::Source(Language::Python),
            "c" => Format::Source(Language::C),
            _ => {
                let message = format!("no format `{text}`; there are text, json, latex, rust, python, c");
                return Err(Error::new(Code::X003, message));
            }
        })
    }
}

/// An answer that can be written down.
pub trait Answer {
    /// What text, LaTeX and source code show.
    fn sheet(&self) -> Sheet;

    /// One JSON object, without a line end.
    fn json(&self) -> String;

    /// The derivation in steps, as text.
    ///
    /// # Errors
    /// B001 where the budget is exceeded. A derivation goes the textbook's way, often the longer one: there may be an answer
    /// and no derivation within the budget.
    fn explain(&self, limits: &Limits<'_>) -> Result<String>;
}

/// The answer in a format, with a line end.
///
/// ```
/// use lath_exact::answer::{limit, scheme_named};
/// use lath_exact::print::{render, Format};
///
/// let answer = limit(&scheme_named("cubic")?, 3, &"6".parse().unwrap(), &Default::default())?;
/// let json = r#"{"degree":3,"level":3,"index":6,"parameter":"3/4","weights":["1/384","121/384","235/384","9/128"]}"#;
/// assert_eq!(render(&answer, Format::Json)?, format!("{json}\n"));
/// # Ok::<(), lath_exact::error::Error>(())
/// ```
///
/// # Errors
/// X005 if a number is beyond the doubles, for source code only.
pub fn render(answer: &dyn Answer, format: Format) -> Result<String> {
    match format {
        Format::Text => Ok(text::sheet(&answer.sheet())),
        Format::Json => Ok(answer.json() + "\n"),
        Format::Latex => Ok(latex::sheet(&answer.sheet())),
        Format::Source(language) => source::sheet(&answer.sheet(), language),
    }
}
