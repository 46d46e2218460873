//! One thing that was found, and the list of them.

use core::fmt;

use crate::check::codes::severity;
use crate::error::{Class, Error, Place, Result};
use crate::json;
use crate::source::Source;

/// How many findings of one code are kept: a file of nothing but faults would make a report larger than itself.
const KEPT: usize = 20;

/// How bad a finding is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Severity {
    /// Worth knowing.
    Note,
    /// Valid, and seldom meant.
    Warning,
    /// Refused by a reader or a constructor.
    Error,
}

impl fmt::Display for Severity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Severity::Note => "note",
            Severity::Warning => "warning",
            Severity::Error => "error",
        })
    }
}

/// One thing that was found in a file.
#[derive(Clone, Debug, PartialEq)]
pub struct Finding(Error);

impl Finding {
    /// The stable code, `"W005"`.
    #[must_use]
    pub fn code(&self) -> &'static str {
        self.0.code().as_str()
    }

    /// How bad it is.
    #[must_use]
    pub fn severity(&self) -> Severity {
        severity(self.0.code())
    }

    /// Where it is.
    #[must_use]
    pub fn place(&self) -> &Place {
        self.0.place()
    }

    /// Where it is, in words: `walk.csv:3:5`, `arch.json:2:7 /shapes/0/knots/4`.
    #[must_use]
    pub fn location(&self) -> String {
        let place = self.place();
        let mut text = place.source.clone().unwrap_or_default();
        for number in [place.line, place.column].into_iter().flatten() {
            text.push_str(&format!(":{number}"));
        }
        match (&place.pointer, place.index) {
            (Some(pointer), _) if !pointer.is_empty() => text + " " + pointer,
            (None, Some(index)) if place.line.is_none() => format!("{text} row {index}"),
            _ => text,
        }
    }

    /// What is wrong, naming the culprit.
    #[must_use]
    pub fn message(&self) -> &str {
        self.0.message()
    }

    /// What to do about it.
    #[must_use]
    pub fn remedy(&self) -> &str {
        self.0.remedy()
    }

    /// The line at fault, or the part of it around the culprit.
    #[must_use]
    pub fn excerpt(&self) -> Option<&str> {
        self.0.excerpt()
    }

    /// The column of the culprit in the excerpt, from 1.
    #[must_use]
    pub fn caret(&self) -> Option<u64> {
        self.0.caret()
    }
}

impl fmt::Display for Finding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let location = self.location();
        write!(f, "{location}: {} {}: {}. {}", self.severity(), self.code(), self.message(), self.remedy())
    }
}

/// The list while it grows.
pub(crate) struct Findings<'a> {
    source: &'a Source,
    list: Vec<Error>,
    /// How often each code came.
    counts: Vec<(&'static str, usize)>,
}

impl<'a> Findings<'a> {
    pub(crate) fn new(source: &'a Source) -> Findings<'a> {
        Findings { source, list: Vec::new(), counts: Vec::new() }
    }

    /// Adds a finding, placed in the source by its pointer where it has one.
    ///
    /// # Errors
    /// The error itself, where it says nothing about the content.
    pub(crate) fn push(&mut self, error: Error) -> Result<()> {
        if error.class() != Class::Invalid {
            return Err(error);
        }
        let code = error.code().as_str();
        let seen = match self.counts.iter_mut().find(|(counted, _)| *counted == code) {
            Some((_, count)) => {
                *count += 1;
                *count
            }
            None => {
                self.counts.push((code, 1));
                1
            }
        };
        if seen <= KEPT {
            let placed = error.place().line.is_some() || error.place().pointer.is_none();
            let error = if placed { error.in_source(self.source.name()) } else { json::place(self.source, error) };
            self.list.push(error);
        }
        Ok(())
    }

    pub(crate) fn finish(mut self) -> Vec<Finding> {
        let line = |error: &Error| (error.place().line.unwrap_or(0), error.place().column.unwrap_or(0));
        self.list.sort_by_key(line);
        let mut rest = Vec::new();
        for &(code, count) in self.counts.iter().filter(|(_, count)| *count > KEPT) {
            if let Some(last) = self.list.iter().rev().find(|error| error.code().as_str() == code) {
                let message = format!("{} more: {}", count - KEPT, last.code().summary());
                rest.push(Error::new(last.code(), message).in_source(self.source.name()));
            }
        }
        self.list.into_iter().chain(rest).map(Finding).collect()
    }
}
