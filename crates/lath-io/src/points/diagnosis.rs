//! What is wrong with a line that is no row: the culprit, its column, and what to do.

use lath::error::Code as CoreCode;

use crate::error::{Code, Error};
use crate::number::{self, counted};
use crate::points::fields::{Delimiter, Field, split};
use crate::points::layout::Layout;
use crate::points::lines::Line;

/// What is wrong with row `index`: a quotation, else its length, else the first field that is no number.
pub(crate) fn row(layout: &Layout, index: usize, line: Line<'_>, content: &str) -> Error {
    let fields = || split(content, layout.delimiter);
    if let Some(Err(offset)) = fields().find(Result::is_err) {
        return stray_quotation(line, offset);
    }
    let count = fields().count();
    if count != layout.width {
        let extra = fields().flatten().nth(layout.width).map(|field| field.offset);
        return ragged(layout, index, line, count, extra);
    }
    let chosen = |index: &usize| layout.picks.as_ref().is_none_or(|picks| picks.contains(index));
    let culprit = fields().flatten().enumerate().filter(|(index, _)| chosen(index));
    let mut refusals = culprit.filter_map(|(_, field)| Some((field, number::parse(field.text).err()?)));
    match refusals.next() {
        Some((field, refusal)) => line.fault(field.offset, refusal.error(field.text)),
        None => line.fault(0, no_row()),
    }
}

/// What is wrong with a line of words that is not the first one.
pub(crate) fn words(line: Line<'_>, content: &str) -> Error {
    let delimiter = Delimiter::of_words(content);
    if let Some(Err(offset)) = split(content, delimiter).find(Result::is_err) {
        return stray_quotation(line, offset);
    }
    fn read(field: Field<'_>) -> (Field<'_>, Result<f64, number::Refusal>) {
        (field, number::parse(field.text))
    }
    let some = split(content, delimiter).flatten().map(read).any(|(_, value)| value.is_ok());
    let remedy = if some {
        "Choose the columns of numbers, or begin lines of words with #."
    } else {
        "Only the first line may be a title; begin other lines of words with #."
    };
    let culprit = split(content, delimiter).flatten().map(read).find_map(|(field, value)| Some((field, value.err()?)));
    match culprit {
        Some((field, refusal)) => line.fault(field.offset, refusal.error(field.text).remedied(remedy)),
        None => line.fault(0, no_row()),
    }
}

/// The error about a quotation mark at this offset, or behind one.
pub(crate) fn stray_quotation(line: Line<'_>, offset: usize) -> Error {
    let message = if line.text[offset..].starts_with('"') {
        "a quotation is never closed"
    } else {
        "text follows a closed quotation"
    };
    line.fault(offset, Error::new(Code::F008, message))
}

/// The error about a row of another length; `extra` is where the first field too many begins.
fn ragged(layout: &Layout, index: usize, line: Line<'_>, count: usize, extra: Option<usize>) -> Error {
    let (first, width) = (layout.first_row, layout.width);
    let message = format!("this row has {}, the first row (line {first}) has {width}", counted(count, "number"));
    let error = Error::new(Code::Core(CoreCode::P005), message).at_index(index);
    line.fault(extra.unwrap_or(line.text.len()), error)
}

fn no_row() -> Error {
    Error::new(Code::F005, "this line is not a row of numbers")
}
