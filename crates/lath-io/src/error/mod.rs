//! One error for everything that can go wrong between bytes and numbers.
//!
//! An error is plain data: a stable [`Code`], a message naming the culprit, a remedy, and a [`Place`]: which file,
//! which line and column (from 1), which member of a JSON document, which index (from 0). Its [`Class`] decides the
//! exit code of a program.

mod code;

pub use code::Code;

use core::fmt;
use std::io;

/// A result whose error is [`Error`] unless another is named.
pub type Result<T, E = Error> = core::result::Result<T, E>;

/// What sort of failure it is: the decision a caller makes first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Class {
    /// The data are wrong, or the data together with what was asked.
    Invalid,
    /// The operating system refused.
    Io,
    /// The data may be right, but they exceed the budget.
    Budget,
    /// Somebody asked to stop.
    Cancelled,
}

impl Class {
    /// The exit code of a command-line tool: 3, 4, 5 or 130.
    #[must_use]
    pub fn exit_code(self) -> u8 {
        match self {
            Class::Invalid => 3,
            Class::Io => 4,
            Class::Budget => 5,
            Class::Cancelled => 130,
        }
    }
}

/// Where it went wrong, as far as known.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Place {
    /// The file as the user named it, or "standard input".
    pub source: Option<String>,
    /// The line, from 1.
    pub line: Option<u64>,
    /// The column in characters, from 1.
    pub column: Option<u64>,
    /// The JSON pointer (RFC 6901) of the member at fault.
    pub pointer: Option<String>,
    /// The index of the point, knot or shape at fault, from 0.
    pub index: Option<usize>,
}

/// What could not be read or written, where, and what to do about it.
///
/// ```
/// use lath::error::Limits;
/// use lath_io::{Class, format, source::Source};
///
/// let source = Source::from_bytes("wing.csv", "x,y\n0,0\n1,zero\n");
/// let error = format::read_points(&source, None, &Limits::default()).unwrap_err();
/// assert_eq!(error.code().as_str(), "F005");
/// assert_eq!((error.place().line, error.place().column), (Some(3), Some(3)));
/// assert_eq!(error.class(), Class::Invalid);
/// assert_eq!(error.excerpt(), Some("1,zero"));
/// assert!(error.to_string().starts_with("wing.csv:3:3: F005: \"zero\" is not a number. "));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Error(Box<Fault>);

#[derive(Clone, Debug, PartialEq)]
struct Fault {
    code: Code,
    class: Class,
    message: String,
    remedy: Option<String>,
    place: Place,
    excerpt: Option<String>,
    caret: Option<u64>,
    os: Option<io::ErrorKind>,
}

impl Error {
    /// An error of the class Invalid; the remedy is the one of the code until another is given.
    pub fn new(code: Code, message: impl Into<String>) -> Error {
        let class = match code {
            Code::I001 | Code::I002 | Code::I003 | Code::I004 | Code::I005 => Class::Io,
            _ => Class::Invalid,
        };
        Error(Box::new(Fault {
            code,
            class,
            message: message.into(),
            remedy: None,
            place: Place::default(),
            excerpt: None,
            caret: None,
            os: None,
        }))
    }

    /// What the operating system refused: `deed` says what was tried ("reading"), `otherwise` is the code when nothing
    /// better is known.
    pub(crate) fn from_os(error: &io::Error, deed: &str, otherwise: Code) -> Error {
        let code = match error.kind() {
            io::ErrorKind::NotFound => Code::I001,
            io::ErrorKind::PermissionDenied => Code::I002,
            io::ErrorKind::IsADirectory => Code::I003,
            _ => otherwise,
        };
        let mut made = Error::new(code, format!("{deed} failed: {error}"));
        made.0.os = Some(error.kind());
        made
    }

    /// A write that the operating system refused, as to standard output.
    #[must_use]
    pub fn writing(error: &io::Error) -> Error {
        Error::from_os(error, "writing", Code::I005)
    }

    /// The same error with another remedy.
    #[must_use]
    pub fn remedied(mut self, remedy: impl Into<String>) -> Error {
        self.0.remedy = Some(remedy.into());
        self
    }

    /// The same error, naming the file or stream it concerns unless one is named already.
    #[must_use]
    pub fn in_source(mut self, name: &str) -> Error {
        self.0.place.source.get_or_insert_with(|| name.to_owned());
        self
    }

    /// The same error at a line and, where known, a column, unless a line is known already.
    #[must_use]
    pub fn at_line(mut self, line: u64, column: Option<u64>) -> Error {
        if self.0.place.line.is_none() {
            self.0.place.line = Some(line);
            self.0.place.column = column;
        }
        self
    }

    /// The same error at a member of a JSON document.
    #[must_use]
    pub fn at_pointer(mut self, pointer: impl Into<String>) -> Error {
        self.0.place.pointer = Some(pointer.into());
        self
    }

    /// The same error at an index, from 0.
    #[must_use]
    pub fn at_index(mut self, index: usize) -> Error {
        self.0.place.index = Some(index);
        self
    }

    /// The same error showing an excerpt of the offending line, with the column of the culprit in it, from 1.
    #[must_use]
    pub fn showing(mut self, excerpt: impl Into<String>, caret: u64) -> Error {
        self.0.excerpt = Some(excerpt.into());
        self.0.caret = Some(caret);
        self
    }

    /// The stable code.
    #[must_use]
    pub fn code(&self) -> Code {
        self.0.code
    }

    /// The sort of failure.
    #[must_use]
    pub fn class(&self) -> Class {
        self.0.class
    }

    /// What is wrong, naming the culprit.
    #[must_use]
    pub fn message(&self) -> &str {
        &self.0.message
    }

    /// What to do about it.
    #[must_use]
    pub fn remedy(&self) -> &str {
        self.0.remedy.as_deref().unwrap_or_else(|| self.0.code.remedy())
    }

    /// Where it is wrong.
    #[must_use]
    pub fn place(&self) -> &Place {
        &self.0.place
    }

    /// The offending line, or the part of it around the culprit where it is long.
    #[must_use]
    pub fn excerpt(&self) -> Option<&str> {
        self.0.excerpt.as_deref()
    }

    /// The column of the culprit in [`Error::excerpt`], from 1: where to print a caret.
    #[must_use]
    pub fn caret(&self) -> Option<u64> {
        self.0.caret
    }

    /// True where the reader of a pipe has gone away, which a tool takes for a normal end.
    #[must_use]
    pub fn is_broken_pipe(&self) -> bool {
        self.0.os == Some(io::ErrorKind::BrokenPipe)
    }
}

impl From<lath::error::Error> for Error {
    /// Keeps code, message, remedy and index.
    fn from(core: lath::error::Error) -> Error {
        let mut error = Error::new(Code::Core(core.code()), core.message()).remedied(core.remedy());
        error.0.place.index = core.index();
        error.0.class = if core.is_cancelled() {
            Class::Cancelled
        } else if core.is_budget() {
            Class::Budget
        } else {
            Class::Invalid
        };
        error
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let place = self.place();
        if let Some(source) = &place.source {
            write!(f, "{source}:")?;
        }
        if let Some(line) = place.line {
            if place.source.is_none() {
                f.write_str("line ")?;
            }
            write!(f, "{line}:")?;
            if let Some(column) = place.column {
                write!(f, "{column}:")?;
            }
        }
        if place.source.is_some() || place.line.is_some() {
            f.write_str(" ")?;
        }
        write!(f, "{}: {}", self.code(), self.message())?;
        match (&place.pointer, place.index) {
            (Some(pointer), _) => write!(f, " (at {})", if pointer.is_empty() { "the top" } else { pointer })?,
            (None, Some(index)) => write!(f, " (index {index})")?,
            (None, None) => {}
        }
        write!(f, ". {}", self.remedy())
    }
}

impl std::error::Error for Error {}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_are_printed_as_far_as_they_are_known() {
        let error = || Error::new(Code::F005, "\"x\" is not a number").remedied("Correct it.");
        assert_eq!(error().to_string(), "F005: \"x\" is not a number. Correct it.");
        assert_eq!(error().at_line(3, None).to_string(), "line 3: F005: \"x\" is not a number. Correct it.");
        let named = error().in_source("a").in_source("b").at_line(3, Some(4)).at_line(5, None);
        assert_eq!(named.to_string(), "a:3:4: F005: \"x\" is not a number. Correct it.");
        assert_eq!(error().at_index(7).to_string(), "F005: \"x\" is not a number (index 7). Correct it.");
        assert_eq!(
            error().at_pointer("/a").at_index(7).to_string(),
            "F005: \"x\" is not a number (at /a). Correct it."
        );
        assert_eq!(error().at_pointer("").to_string(), "F005: \"x\" is not a number (at the top). Correct it.");
    }

    #[test]
    fn refusals_of_the_core_keep_code_index_and_class() {
        use lath::error::{Code as CoreCode, Error as CoreError};
        let class = |code| Error::from(CoreError::new(code, "m")).class().exit_code();
        assert_eq!([CoreCode::K004, CoreCode::B001, CoreCode::B002].map(class), [3, 5, 130]);
        let error = Error::from(CoreError::new(CoreCode::K004, "knot 2 decreases").at(2));
        assert_eq!(
            (error.code().as_str(), error.place().index, error.remedy()),
            ("K004", Some(2), CoreCode::K004.remedy())
        );
    }

    #[test]
    fn a_broken_pipe_is_told_from_other_faults() {
        assert!(Error::writing(&io::ErrorKind::BrokenPipe.into()).is_broken_pipe());
        let full = Error::writing(&io::ErrorKind::StorageFull.into());
        assert_eq!((full.is_broken_pipe(), full.code().as_str(), full.class().exit_code()), (false, "I005", 4));
    }
}
