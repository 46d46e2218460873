//! Points as text: CSV, TSV, and columns between blanks.
//!
//! One reader for all: the first row of numbers shows whether semicolons, commas, tabs or blanks separate the columns.
//! So `.csv` files with semicolons, and `.dat` files with commas, are what they are. The grammar:
//!
//! - `#` begins a comment, at the start of a line or behind a row; blank lines mean nothing.
//! - A first line that is not all numbers is a title. Where it has one word for every column, and none of them a
//!   number, the words are the columns' names; quoted ones may contain anything.
//! - Every other line is a row; all rows have one length. A separator at the end of a line is ignored.
//! - A number is decimal and finite: `1`, `-.5`, `+6.02e23`, with quotation marks or without; it is rounded to the
//!   nearest double.

use lath::error::{Code as CoreCode, Limits};

use crate::error::{Code, Error, Result};
use crate::number;
use crate::points::fields::{Delimiter, Field, split, without_comment};
use crate::points::table::{PointTable, RowsAt};
use crate::source::{Line, Source, lines};

/// Rows between two looks at the flag for cancelling.
const BETWEEN_LOOKS: usize = 4096;

/// Reads CSV, TSV or blanks-separated text.
///
/// # Errors
/// F005 a word, F006 a number in a notation that is not read, F007 an empty field, F008 a stray quotation mark, P002
/// NaN or infinity, P003 a number too large, all with line and column; P005 a row of another length, with its line;
/// P001 no rows; B001 above the budget; and what [`Source::text`] refuses.
pub fn read(source: &Source, limits: &Limits<'_>) -> Result<PointTable> {
    let text = source.text()?;
    let mut reader =
        Reader { source, limits, spent: text.len() as u64, width: 0, values: Vec::new(), lines: Vec::new() };
    let mut title = None;
    let mut delimiter = None;
    let mut fields = Vec::new();
    for line in lines(text) {
        let content = without_comment(line.text);
        if content.trim().is_empty() {
            continue;
        }
        delimiter = delimiter.or_else(|| Delimiter::of_row(content));
        match delimiter {
            Some(delimiter) => reader.row(line, content, delimiter, &mut fields)?,
            None if title.is_none() => title = Some(content),
            None => return Err(reader.words(line, content)),
        }
    }
    let Some(delimiter) = delimiter else {
        let message = if title.is_some() {
            "there is no row of numbers behind the first line"
        } else {
            "there is nothing but comments"
        };
        return Err(Error::new(Code::Core(CoreCode::P001), message).in_source(source.name()));
    };
    let columns = title.and_then(|title| names(title, delimiter, reader.width));
    Ok(PointTable {
        source: Some(source.name().to_owned()),
        title: title.filter(|_| columns.is_none()).map(|title| title.trim().to_owned()),
        columns,
        width: reader.width,
        values: reader.values,
        rows_at: RowsAt::Lines(reader.lines),
    })
}

/// The names of `width` columns, if that is what the first line holds.
fn names(title: &str, delimiter: Delimiter, width: usize) -> Option<Vec<String>> {
    let mut fields = Vec::new();
    split(title, delimiter, &mut fields).ok()?;
    let is_names = fields.len() == width && fields.iter().all(|field| number::parse(field.text).is_err());
    is_names.then(|| fields.iter().map(Field::unescaped).collect())
}

struct Reader<'a> {
    source: &'a Source,
    limits: &'a Limits<'a>,
    /// The bytes of the text.
    spent: u64,
    width: usize,
    values: Vec<f64>,
    lines: Vec<u32>,
}

impl<'a> Reader<'a> {
    fn row(
        &mut self,
        line: Line<'a>,
        content: &'a str,
        delimiter: Delimiter,
        fields: &mut Vec<Field<'a>>,
    ) -> Result<()> {
        split(content, delimiter, fields).map_err(|offset| self.stray_quotation(line, offset))?;
        if self.lines.is_empty() {
            self.width = fields.len();
        }
        if fields.len() != self.width {
            return Err(self.ragged(line, fields));
        }
        self.check_budget()?;
        for field in fields.iter() {
            let value = number::parse(field.text)
                .map_err(|refusal| self.fault(line, field.offset, refusal.error(field.text)))?;
            self.values.push(value);
        }
        self.lines.push(u32::try_from(line.number).unwrap_or(u32::MAX));
        Ok(())
    }

    fn check_budget(&self) -> Result<()> {
        let rows = self.lines.len() + 1;
        let bytes = (rows as u64).saturating_mul((self.width * size_of::<f64>() + size_of::<u32>()) as u64);
        let checked = self
            .limits
            .check_points(rows as u64)
            .and_then(|()| self.limits.check_bytes(self.spent.saturating_add(bytes)));
        let checked = if rows.is_multiple_of(BETWEEN_LOOKS) {
            checked.and_then(|()| self.limits.check_cancel())
        } else {
            checked
        };
        checked.map_err(|error| Error::from(error).in_source(self.source.name()))
    }

    fn ragged(&self, line: Line<'_>, fields: &[Field<'_>]) -> Error {
        let (count, first) = (fields.len(), self.lines.first().copied().unwrap_or(0));
        let plural = |n: usize| if n == 1 { "" } else { "s" };
        let message =
            format!("this row has {count} number{}, the first row (line {first}) has {}", plural(count), self.width);
        // The column of the first number too many; a row too short has none.
        let extra = fields.get(self.width).map(|field| field.offset);
        let error = Error::new(Code::Core(CoreCode::P005), message).at_index(self.lines.len());
        match extra {
            Some(offset) => self.fault(line, offset, error),
            None => self.fault(line, line.text.len(), error),
        }
    }

    /// The error about a line of words that is not the first one.
    fn words(&self, line: Line<'a>, content: &'a str) -> Error {
        let mut fields = Vec::new();
        if let Err(offset) = split(content, Delimiter::of_words(content), &mut fields) {
            return self.stray_quotation(line, offset);
        }
        let culprit = fields.iter().find_map(|field| number::parse(field.text).err().map(|refusal| (field, refusal)));
        match culprit {
            Some((field, refusal)) => {
                let error = refusal
                    .error(field.text)
                    .remedied("Only the first line may be a title; begin other lines of words with #.");
                self.fault(line, field.offset, error)
            }
            None => self.fault(line, 0, Error::new(Code::F005, "this line is not a row of numbers")),
        }
    }

    fn stray_quotation(&self, line: Line<'_>, offset: usize) -> Error {
        let message = if line.text[offset..].starts_with('"') {
            "a quotation is never closed"
        } else {
            "text follows a closed quotation"
        };
        self.fault(line, offset, Error::new(Code::F008, message))
    }

    fn fault(&self, line: Line<'_>, offset: usize, error: Error) -> Error {
        self.source.fault(line.offset + offset, error)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn table(text: &str) -> PointTable {
        read(&Source::from_bytes("a.txt", text), &Limits::default()).unwrap()
    }

    fn fault(text: &str) -> (&'static str, Option<u64>, Option<u64>) {
        let error = read(&Source::from_bytes("a.txt", text), &Limits::default()).unwrap_err();
        assert_eq!(error.place().source.as_deref(), Some("a.txt"));
        (error.code().as_str(), error.place().line, error.place().column)
    }

    #[test]
    fn all_separators_read_alike() {
        for text in [
            "1,2\n3,4",
            "1\t2\r\n3\t4\r\n",
            "  1   2\n\n 3 \t 4 \n",
            "1;2;\n3;4;\n",
            "\u{feff}\"1\",\"2\"\r3,4\r",
            "1,2,\n3,4 # four\n#\n",
        ] {
            let t = table(text);
            assert_eq!(
                (t.width(), t.values(), t.columns(), t.title()),
                (2, &[1.0, 2.0, 3.0, 4.0][..], None, None),
                "{text:?}"
            );
        }
    }

    #[test]
    fn titles_and_headers() {
        let t = table(" RAE 2822 AIRFOIL\n1.000000 0.000000\n0.999398 0.000128\n");
        assert_eq!((t.title(), t.columns(), t.line(1)), (Some("RAE 2822 AIRFOIL"), None, Some(3)));
        let t = table("\"YEAR\",\"SUN, \"\"ACTIVITY\"\"\"\n1700,5\n");
        assert_eq!((t.title(), t.columns().unwrap().join("|")), (None, "YEAR|SUN, \"ACTIVITY\"".into()));
        assert_eq!(table(",x,\n0,1,\n").columns().unwrap(), ["", "x"]);
        assert_eq!(table("NACA 2412\n1 0\n").title(), Some("NACA 2412"));
        assert_eq!(table("# c\n\nx y\n1 2\n").columns().unwrap(), ["x", "y"]);
        assert_eq!(table("x,y\n1 2\n").title(), Some("x,y")); // another separator: not names
        assert_eq!(table("\"the 5-inch pipe\n1 2\n").title(), Some("\"the 5-inch pipe"));
        assert_eq!(table("1,2 # x\n").len(), 1);
    }

    #[test]
    fn faults_have_code_line_and_column() {
        assert_eq!(fault("x,y\n1,2\n3,abc\n"), ("F005", Some(3), Some(3)));
        assert_eq!(fault("1,2\n3,4,5\n"), ("P005", Some(2), Some(5)));
        assert_eq!(fault("1,2\n\n3\n"), ("P005", Some(3), Some(2)));
        assert_eq!(fault("nan,1\n"), ("P002", Some(1), Some(1)));
        assert_eq!(fault("1 2\r\n1 -inf\r\n"), ("P002", Some(2), Some(3)));
        assert_eq!(fault("1,2\n1,1e400\n"), ("P003", Some(2), Some(3)));
        assert_eq!(fault("1,5;2,5\n"), ("F006", Some(1), Some(1)));
        assert_eq!(fault("x;y\n1;2,5\n"), ("F006", Some(2), Some(3)));
        assert_eq!(fault("1 0x10\n"), ("F006", Some(1), Some(3)));
        assert_eq!(fault("1,,3\n"), ("F007", Some(1), Some(3)));
        assert_eq!(fault("1,2\n,4\n"), ("F007", Some(2), Some(1)));
        assert_eq!(fault("1,2\n\"3,4\n"), ("F008", Some(2), Some(1)));
        assert_eq!(fault("1,2\n\"3\"x,4\n"), ("F008", Some(2), Some(4)));
        assert_eq!(fault("title\nx,y\n1,2\n"), ("F005", Some(2), Some(1)));
        assert_eq!(fault("title\n1,2,\"\n1,2\n"), ("F008", Some(2), Some(5)));
        assert_eq!(fault("title\n"), ("P001", None, None));
        assert_eq!(fault("# only\n# comments\n"), ("P001", None, None));
        assert_eq!(fault("é 1\n\u{e9}\u{e9},1\n"), ("F005", Some(2), Some(1)));
        assert_eq!(fault("1,2\n\u{a0}\u{a0}3,z\n"), ("F005", Some(2), Some(5)));
    }

    #[test]
    fn ragged_rows_name_both_counts() {
        let error = read(&Source::from_bytes("a.txt", "x y\n1 2\n3 4 5\n"), &Limits::default()).unwrap_err();
        assert_eq!(error.message(), "this row has 3 numbers, the first row (line 2) has 2");
        assert_eq!((error.place().index, error.excerpt()), (Some(1), Some("3 4 5")));
    }

    #[test]
    fn the_budget_counts_points_and_bytes() {
        let source = Source::from_bytes("a.txt", "1\n".repeat(100));
        let code = |limits: &Limits<'_>| read(&source, limits).map(|t| t.len()).map_err(|e| e.code().as_str());
        assert_eq!(code(&Limits { max_points: 99, ..Limits::default() }), Err("B001"));
        assert_eq!(code(&Limits { max_points: 100, ..Limits::default() }), Ok(100));
        assert_eq!(code(&Limits { max_bytes: 1399, ..Limits::default() }), Err("B001"));
        assert_eq!(code(&Limits { max_bytes: 1400, ..Limits::default() }), Ok(100));
        let stop = std::sync::atomic::AtomicBool::new(true);
        let long = Source::from_bytes("a.txt", "1\n".repeat(BETWEEN_LOOKS));
        let error = read(&long, &Limits { cancel: Some(&stop), ..Limits::default() }).unwrap_err();
        assert_eq!(error.class().exit_code(), 130);
    }
}
