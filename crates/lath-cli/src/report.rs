//! Failures as people read them, on standard error.
//!
//! ```text
//! lath: wing.csv:3:3: F005: "zero" is not a number
//!   3 | 1,zero
//!     |   ^
//! Remedy: Correct the field, or begin the line with # to make it a comment.
//! ```
//!
//! Colours only where a terminal reads along and `NO_COLOR` is not set.

use crate::args::Cli;
use crate::failure::Failure;
use clap::CommandFactory;
use clap::error::ErrorKind;
use lath_exact::error::Class;
use lath_io::Error;
use std::fmt::Write as _;
use std::io::{self, IsTerminal, Write as _};

/// Done; also when the reader of a pipe has gone away.
pub(crate) const DONE: u8 = 0;
/// The check found an error, and has said so.
const FOUND: u8 = 1;
/// The command line alone is wrong.
const USAGE: u8 = 2;
/// The data, or the data with the options, are invalid.
const INVALID: u8 = 3;
/// The budget would be exceeded.
const BUDGET: u8 = 5;
/// The work was cancelled.
const INTERRUPTED: u8 = 130;
/// A file could not be read or written.
const INPUT_OUTPUT: u8 = 4;

/// Prints what clap has to say: help and version to standard output, faults to standard error.
pub(crate) fn usage(message: &clap::Error) -> u8 {
    let printed = message.print();
    match (message.use_stderr(), printed) {
        (true, _) => USAGE,
        (false, Err(error)) if error.kind() != io::ErrorKind::BrokenPipe => INPUT_OUTPUT,
        (false, _) => DONE,
    }
}

/// Prints a failure and gives its exit code.
pub(crate) fn failure(failure: Failure) -> u8 {
    match failure {
        Failure::Usage { verb, message } => {
            let mut tool = Cli::command();
            tool.build();
            let command = tool.find_subcommand_mut(verb);
            usage(&match command {
                Some(command) => command.error(ErrorKind::ArgumentConflict, message),
                None => tool.error(ErrorKind::ArgumentConflict, message),
            })
        }
        Failure::Data(error) if error.is_broken_pipe() => DONE,
        Failure::Data(error) => {
            let excerpt = excerpt(error.place().line, error.excerpt(), error.caret());
            print(&head(&error), error.code().as_str(), &tail(&error), &excerpt, error.remedy());
            error.class().exit_code()
        }
        Failure::Exact { place, error } => {
            let place = if place.is_empty() { String::new() } else { format!("{place}: ") };
            print(&place, error.code().as_str(), error.message(), "", error.remedy());
            match error.class() {
                Class::Budget => BUDGET,
                Class::Cancelled => INTERRUPTED,
                _ => INVALID,
            }
        }
        Failure::Found => FOUND,
        Failure::Choice(choice) => {
            print(&format!("{}: ", choice.source), choice.code, &choice.message, "", &choice.remedy);
            INVALID
        }
    }
}

/// The place before the code: `wing.csv:3:3: `.
fn head(error: &Error) -> String {
    let place = error.place();
    let mut head = place.source.clone().unwrap_or_default();
    for number in [place.line, place.column].into_iter().flatten() {
        // Writing into a String cannot fail.
        let _ = write!(head, "{}{number}", if head.is_empty() { "line " } else { ":" });
    }
    if head.is_empty() { head } else { head + ": " }
}

/// The message, and what is known about the place where line and column do not say it.
fn tail(error: &Error) -> String {
    let place = error.place();
    match (&place.pointer, place.index) {
        (Some(pointer), _) if !pointer.is_empty() => format!("{} (at {pointer})", error.message()),
        (None, Some(index)) if place.column.is_none() => format!("{} (index {index})", error.message()),
        _ => error.message().to_owned(),
    }
}

/// The offending line, with a caret under the column.
pub(crate) fn excerpt(line: Option<u64>, text: Option<&str>, caret: Option<u64>) -> String {
    let (Some(line), Some(text)) = (line, text) else {
        return String::new();
    };
    let number = line.to_string();
    let margin = " ".repeat(number.len());
    let mut shown = format!("  {number} | {text}\n");
    if let Some(caret) = caret.and_then(|caret| usize::try_from(caret).ok()) {
        // Tabs stay tabs, so that the caret stands under its character however wide they are.
        let before: String =
            text.chars().take(caret.saturating_sub(1)).map(|c| if c == '\t' { '\t' } else { ' ' }).collect();
        if before.chars().count() + 1 == caret {
            let _ = writeln!(shown, "  {margin} | {before}^");
        }
    }
    shown
}

fn print(place: &str, code: &str, message: &str, excerpt: &str, remedy: &str) {
    let mut out = io::stderr().lock();
    let plain = std::env::var_os("NO_COLOR").is_some_and(|value| !value.is_empty());
    let (red, bold, reset) =
        if out.is_terminal() && !plain { ("\x1b[1;31m", "\x1b[1m", "\x1b[0m") } else { ("", "", "") };
    // Nobody is left to be told that standard error cannot be written.
    let _ = write!(out, "lath: {place}{red}{code}{reset}: {bold}{message}{reset}\n{excerpt}Remedy: {remedy}\n");
}
