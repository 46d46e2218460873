//! What can go wrong: the core's errors, and a few of reading and printing fractions.

use core::fmt;

/// The result of everything here that can fail.
pub type Result<T, E = Error> = core::result::Result<T, E>;

macro_rules! codes {
    ($($code:ident $class:ident $summary:literal $remedy:literal)*) => {
        /// A stable code: the core's own, or one of this crate, which begin with X.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        #[non_exhaustive]
        pub enum Code {
            /// The core refused; its own code says why.
            Core(lath::error::Code),
            $(#[doc = $summary] $code,)*
        }

        impl Code {
            /// The codes of this crate, in order; those of the core are in [`lath::error::Code::ALL`].
            pub const ALL: &'static [Code] = &[$(Code::$code),*];

            /// The code as text, `"X001"`.
            pub fn as_str(self) -> &'static str {
                match self { Code::Core(code) => code.as_str(), $(Code::$code => stringify!($code)),* }
            }

            /// What the code means, in a few words.
            pub fn summary(self) -> &'static str {
                match self { Code::Core(code) => code.summary(), $(Code::$code => $summary),* }
            }

            /// What to do about it.
            pub fn remedy(self) -> &'static str {
                match self { Code::Core(code) => code.remedy(), $(Code::$code => $remedy),* }
            }

            /// What sort of failure it is.
            pub fn class(self) -> Class {
                match self {
                    Code::Core(lath::error::Code::B001) => Class::Budget,
                    Code::Core(lath::error::Code::B002) => Class::Cancelled,
                    Code::Core(_) => Class::Invalid,
                    $(Code::$code => Class::$class),*
                }
            }
        }
    };
}

codes! {
    X001 Invalid "not a fraction" "Write an integer, a fraction such as -1/3, or a decimal such as 0.25."
    X002 Invalid "a zero denominator" "Give a denominator other than zero."
    X003 Usage "an unknown name" "Use one of the names listed."
    X004 Usage "the degree does not fit the basis" "Leave the degree out, or give the one named."
    X005 Invalid "no double holds the number" "Ask for text, JSON or LaTeX, which have no greatest number; or scale the input."
    X006 Invalid "the interval is empty or reversed" "Give two different numbers, the smaller one first."
    X007 Invalid "the interval is not inside one span" "Give an interval between neighbouring knots of the domain."
}

/// The decision a program makes first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Class {
    /// The question is wrong, whatever the data.
    Usage,
    /// The data are wrong, or the data together with what was asked.
    Invalid,
    /// The answer would exceed the budget.
    Budget,
    /// The work was cancelled.
    Cancelled,
}

/// Why there is no answer: a stable code, the culprit's index, a message and a remedy.
///
/// ```
/// use lath_exact::error::Code;
///
/// let error = lath_exact::parse::fractions("0, 1/0, 2").unwrap_err();
/// assert_eq!((error.code(), error.index()), (Code::X002, Some(1)));
/// assert_eq!(error.message(), "number 1, `1/0`, divides by zero");
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Error {
    code: Code,
    index: Option<usize>,
    message: String,
}

impl Error {
    /// An error of this code; `message` is one sentence without a full stop that names the culprit.
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

    /// What is wrong, with the culprit.
    pub fn message(&self) -> &str {
        &self.message
    }

    /// What to do about it.
    pub fn remedy(&self) -> &'static str {
        self.code.remedy()
    }

    /// What sort of failure it is.
    pub fn class(&self) -> Class {
        self.code.class()
    }
}

impl From<lath::error::Error> for Error {
    fn from(error: lath::error::Error) -> Error {
        Error { code: Code::Core(error.code()), index: error.index(), message: error.message().to_owned() }
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}. {}", self.code.as_str(), self.message, self.remedy())
    }
}

impl std::error::Error for Error {}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn codes_are_distinct_and_remedies_are_sentences() {
        for (i, code) in Code::ALL.iter().enumerate() {
            assert!(!code.summary().is_empty() && code.remedy().ends_with('.'), "{code:?}");
            assert!(Code::ALL[..i].iter().all(|other| other.as_str() != code.as_str()));
        }
        assert_eq!(Code::Core(lath::error::Code::B001).class(), Class::Budget);
    }
}
