//! F0 — what can go wrong, and the budgets that keep work from going on for ever.
//!
//! One opaque [`Error`] serves the whole crate: plain data, no source chain, cheap to return. It holds a stable
//! [`Code`], the index of the culprit where there is one, a message with the numbers in it, and a remedy. Programs
//! branch on the code or on the predicates (`is_knots`, `is_budget`, …), people read the message.
//!
//! Conventions: indices start at 0; a code never changes its meaning, and a retired one is never used again.
//!
//! Deliberately absent: error enums per module (callers would match on our internals), backtraces, and panics.
//!
//! [`Limits`] is the other half of "it never breaks": whatever can be made arbitrarily long by its input takes
//! one as an argument and refuses before it allocates.

mod code;
mod count;
mod limits;
mod number;

pub use code::Code;
pub(crate) use count::Count;
pub use limits::Limits;
pub(crate) use number::Number;

use alloc::string::String;
use core::fmt;

/// The result of everything here that can fail.
pub type Result<T, E = Error> = core::result::Result<T, E>;

/// Why something could not be done: a stable code, the culprit's index, a message and a remedy.
///
/// ```
/// use lath::{error::Code, knot::Knots};
///
/// let error = Knots::new(vec![0.0, 0.0, 1.0, 0.5], 1).unwrap_err();
/// assert_eq!(error.code(), Code::K004);
/// assert_eq!(error.index(), Some(3));
/// assert!(error.is_knots());
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Error {
    code: Code,
    index: Option<usize>,
    message: String,
}

impl Error {
    /// An error of this code; `message` is one sentence without a full stop that names the culprit and the numbers.
    pub fn new(code: Code, message: impl Into<String>) -> Error {
        Error { code, index: None, message: message.into() }
    }

    /// The same error with the culprit's index (from 0).
    pub fn at(mut self, index: usize) -> Error {
        self.index = Some(index);
        self
    }

    /// The stable code.
    pub fn code(&self) -> Code {
        self.code
    }

    /// The index of the culprit in the sequence that was passed in, from 0.
    pub fn index(&self) -> Option<usize> {
        self.index
    }

    /// What is wrong, with the numbers.
    pub fn message(&self) -> &str {
        &self.message
    }

    /// What to do about it.
    pub fn remedy(&self) -> &'static str {
        self.code.remedy()
    }

    /// A fault of a knot vector or of a degree.
    pub fn is_knots(&self) -> bool {
        self.code.as_str().starts_with('K')
    }

    /// A fault of points or coordinates.
    pub fn is_points(&self) -> bool {
        self.code.as_str().starts_with('P')
    }

    /// A fault of parameters.
    pub fn is_parameter(&self) -> bool {
        self.code.as_str().starts_with('T')
    }

    /// A fault of the weights of a rational shape.
    pub fn is_weights(&self) -> bool {
        self.code.as_str().starts_with('R')
    }

    /// A budget was exceeded before the work began.
    pub fn is_budget(&self) -> bool {
        self.code == Code::B001
    }

    /// The work was cancelled through [`Limits::cancel`].
    pub fn is_cancelled(&self) -> bool {
        self.code == Code::B002
    }

    /// The input itself is at fault: neither a budget nor a cancellation.
    pub fn is_invalid_input(&self) -> bool {
        !self.is_budget() && !self.is_cancelled()
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}. {}", self.code, self.message, self.remedy())
    }
}

impl core::error::Error for Error {}
