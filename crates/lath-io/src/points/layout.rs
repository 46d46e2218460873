//! How the rows of a text are laid out: what its first lines tell about all others.

use crate::error::{Error, Result};
use crate::number;
use crate::points::diagnosis::stray_quotation;
use crate::points::fields::{Delimiter, Field, split};
use crate::points::lines::Line;
use crate::points::select::choose;

/// What the first row tells, with the title before it.
#[derive(Clone, Debug)]
pub(crate) struct Layout {
    pub(crate) delimiter: Delimiter,
    /// The fields of the first row, and its line.
    pub(crate) width: usize,
    /// Only names show the last column: the first row has nothing there.
    ends_empty: bool,
    pub(crate) first_row: u64,
    pub(crate) names: Option<Vec<String>>,
    /// The indices of the wanted columns.
    pub(crate) picks: Option<Vec<usize>>,
}

impl Layout {
    /// The layout that the first row shows; `title` is the line before it.
    pub(crate) fn of(
        line: Line<'_>,
        content: &str,
        delimiter: Delimiter,
        title: Option<&str>,
        wanted: Option<&[String]>,
    ) -> Result<Layout> {
        if let Some(Err(offset)) = split(content, delimiter).find(Result::is_err) {
            return Err(stray_quotation(line, offset));
        }
        let mut width = split(content, delimiter).count();
        // An empty last field, where there are names to show that it is one.
        let named = title.map_or(0, |title| split(title, delimiter).count());
        let ends_empty = wanted.is_some() && delimiter.ends(content) && named == width + 1;
        width += usize::from(ends_empty);
        let names = title.and_then(|title| names(title, delimiter, width));
        let picks = wanted.map(|wanted| choose(names.as_deref(), width, wanted)).transpose()?;
        Ok(Layout { delimiter, width, ends_empty, first_row: line.number, names, picks })
    }

    /// The number of columns that are read.
    pub(crate) fn columns_read(&self) -> usize {
        self.picks.as_ref().map_or(self.width, Vec::len)
    }

    /// The names of the columns that are read.
    pub(crate) fn names_read(&self) -> Option<Vec<String>> {
        let names = self.names.as_ref()?;
        match &self.picks {
            None => Some(names.clone()),
            Some(picks) => Some(picks.iter().filter_map(|&pick| names.get(pick).cloned()).collect()),
        }
    }

    /// Appends the numbers of a row; false where it is none of this layout, and what was appended means nothing.
    pub(crate) fn take(&self, content: &str, values: &mut Vec<f64>) -> bool {
        let number = |field: Result<Field<'_>, usize>| number::parse(field.ok()?.text).ok();
        let Some(picks) = &self.picks else {
            let start = values.len();
            for field in split(content, self.delimiter) {
                let Some(value) = number(field) else { return false };
                values.push(value);
            }
            return values.len() - start == self.width;
        };
        let start = values.len();
        values.resize(start + picks.len(), 0.0);
        let mut count = 0;
        for (index, field) in split(content, self.delimiter).enumerate() {
            count += 1;
            if field.is_err() {
                return false;
            }
            for (slot, _) in picks.iter().enumerate().filter(|(_, pick)| **pick == index) {
                match (values.get_mut(start + slot), number(field)) {
                    (Some(place), Some(value)) => *place = value,
                    _ => return false,
                }
            }
        }
        // An empty last field that nobody asked for; who reads all columns does not miss the delimiter before it.
        let absent = self.ends_empty || self.delimiter.ends(content);
        let unread = count + 1 == self.width && absent && !picks.contains(&count);
        count + usize::from(unread) == self.width
    }
}

/// The delimiter that a line shows, if it is a row; `title` is the line before it. Where columns are wanted, a row may
/// hold words in others.
pub(crate) fn delimiter(content: &str, title: Option<&str>, wanted: Option<&[String]>) -> Option<Delimiter> {
    Delimiter::of_row(content).or_else(|| match (wanted, title) {
        (None, _) => None,
        (Some(wanted), Some(title)) => {
            // The one that cuts out the wanted columns.
            let fits = |delimiter: &Delimiter| {
                let width = split(content, *delimiter).count();
                choose(names(title, *delimiter, width).as_deref(), width, wanted).is_ok()
            };
            Delimiter::candidates(content).find(fits).or_else(|| Some(Delimiter::of_words(content)))
        }
        // The first line.
        (Some(wanted), None) => has_numbers_at(content, wanted).then(|| Delimiter::of_words(content)),
    })
}

/// Whether a first line may be a row although it holds words: there are none in the wanted columns.
pub(crate) fn is_row_of_words(content: &str, wanted: Option<&[String]>) -> bool {
    wanted.is_some_and(|wanted| Delimiter::of_row(content).is_none() && has_numbers_at(content, wanted))
}

/// Whether the wanted columns, all by index, hold numbers in this line of words.
fn has_numbers_at(content: &str, wanted: &[String]) -> bool {
    let delimiter = Delimiter::of_words(content);
    let field = |index: usize| split(content, delimiter).nth(index)?.ok();
    let is_number = |name: &String| {
        let field = name.trim().parse().ok().and_then(field);
        field.is_some_and(|field| number::parse(field.text).is_ok())
    };
    !wanted.is_empty() && wanted.iter().all(is_number)
}

/// The names of `width` columns, if that is what the title holds.
fn names(title: &str, delimiter: Delimiter, width: usize) -> Option<Vec<String>> {
    let is_name = |field: &Result<Field<'_>, usize>| field.is_ok_and(|field| number::parse(field.text).is_err());
    let is_names = split(title, delimiter).all(|field| is_name(&field)) && split(title, delimiter).count() == width;
    is_names.then(|| split(title, delimiter).flatten().map(|field| field.unescaped()).collect())
}

/// The error of a text without rows: there may have been a title, or comments.
pub(crate) fn nothing(title: bool, comments: bool) -> Error {
    use crate::error::Code;
    use lath::error::Code as CoreCode;
    match (title, comments) {
        (true, _) => Error::new(Code::Core(CoreCode::P001), "there is no row of numbers behind the first line"),
        (_, true) => Error::new(Code::Core(CoreCode::P001), "there is nothing but comments"),
        _ => Error::new(Code::F001, "the input is empty"),
    }
}
