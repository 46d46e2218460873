//! Points as text: CSV, TSV, and columns between blanks.
//!
//! One reader for all: the first row of numbers shows whether semicolons, commas, tabs or blanks separate the columns.
//! So `.csv` files with semicolons, and `.dat` files with commas, are what they are. The grammar:
//!
//! - `#` begins a comment, at the start of a line or behind a row; blank lines mean nothing.
//! - A first line that is not all numbers is a title. Where it has one word for every column, and none of them a
//!   number, the words are the columns' names; quoted ones may contain anything.
//! - Every other line is a row; all rows have one length. A separator at the end of a line is ignored.
//! - Where columns are chosen, the fields of the others may be anything, dates for example, and are not looked at. Then a first
//!   line that has numbers in them is a row, unless the line behind it is all numbers: what is a title to those who read all
//!   columns is one to those who read a few.
//! - A number is decimal and finite: `1`, `-.5`, `+6.02e23`, with quotation marks or without; it is rounded to the
//!   nearest double.

use std::collections::VecDeque;

use lath::error::Limits;

use crate::error::{Error, Result};
use crate::points::diagnosis;
use crate::points::fields::{Delimiter, without_comment};
use crate::points::layout::{self, Layout};
use crate::points::lines::{Line, Lines};
use crate::points::table::{PointTable, RowsAt};
use crate::source::Source;
use crate::stream::Stream;

/// Rows between two looks at the flag for cancelling.
const BETWEEN_LOOKS: usize = 4096;

/// Reads CSV, TSV or blanks-separated text.
///
/// # Errors
/// F002 a NUL byte, F003 bytes that are not UTF-8, F005 a word, F006 a number in a notation that is not read, F007 an
/// empty field, F008 a stray quotation mark, P002 NaN or infinity, P003 a number too large, all with line and column;
/// P005 a row of another length, with its line; F001 nothing but blanks, P001 no rows; B001 above the budget.
pub fn read(source: &Source, limits: &Limits<'_>) -> Result<PointTable> {
    read_chosen(source, None, limits)
}

/// Reads only the columns of these names or indices from 0, in the order given; the others may hold anything.
///
/// ```
/// use lath::error::Limits;
/// use lath_io::{points::text, source::Source};
///
/// let source = Source::from_bytes("log.csv", "date,x,y,note\n2020-01-01,0,1.5,start\n2020-01-02,1,2.5,\n");
/// let table = text::read_columns(&source, &["y", "1"], &Limits::default())?;
/// assert_eq!(table.columns(), Some(&["y".to_owned(), "x".to_owned()][..]));
/// assert_eq!(table.values(), [1.5, 0.0, 2.5, 1.0]);
/// # Ok::<(), lath_io::Error>(())
/// ```
///
/// # Errors
/// As [`read`] for the chosen columns; F009 a column that is not there, F022 a name that two columns have.
pub fn read_columns(source: &Source, columns: &[&str], limits: &Limits<'_>) -> Result<PointTable> {
    read_chosen(source, Some(columns), limits)
}

pub(crate) fn read_chosen(source: &Source, wanted: Option<&[&str]>, limits: &Limits<'_>) -> Result<PointTable> {
    table(source, wanted, limits, &mut Err)?.ok_or_else(|| layout::nothing(false, false).in_source(source.name()))
}

/// Reads every row that can be read, and hands out an error for each that cannot.
pub(crate) fn read_tolerantly(
    source: &Source,
    limits: &Limits<'_>,
    mut found: impl FnMut(Error) -> Result<()>,
) -> Result<Option<PointTable>> {
    table(source, None, limits, &mut found)
}

/// The rows as a table, where there are any; what is wrong goes to `found`, which decides whether to go on.
fn table(
    source: &Source,
    wanted: Option<&[&str]>,
    limits: &Limits<'_>,
    found: &mut dyn FnMut(Error) -> Result<()>,
) -> Result<Option<PointTable>> {
    let wanted = wanted.map(|wanted| wanted.iter().map(|&name| name.to_owned()).collect());
    let mut scan = Scan::new(Stream::of(source), wanted, limits);
    let spent = source.bytes().len() as u64;
    let (mut values, mut lines) = (Vec::new(), Vec::new());
    loop {
        match scan.row(&mut values) {
            Ok(Some(line)) => lines.push(u32::try_from(line).unwrap_or(u32::MAX)),
            Ok(None) => break,
            Err(error) => found(error)?,
        }
        let bytes = (values.len() * size_of::<f64>() + lines.len() * size_of::<u32>()) as u64;
        limits.check_bytes(spent.saturating_add(bytes)).map_err(|error| Error::from(error).in_source(source.name()))?;
    }
    let Some(layout) = scan.layout.as_ref().filter(|_| !lines.is_empty()) else { return Ok(None) };
    Ok(Some(PointTable {
        source: Some(source.name().to_owned()),
        title: scan.title().map(str::to_owned),
        width: layout.columns_read(),
        columns: layout.names_read(),
        values,
        rows_at: RowsAt::Lines(lines),
    }))
}

/// The rows of a text, one by one. After an error in a row the scan goes on behind it.
#[derive(Debug)]
pub(crate) struct Scan<'a> {
    lines: Lines<'a>,
    limits: &'a Limits<'a>,
    wanted: Option<Vec<String>>,
    /// The first line, where it is no row.
    first: Option<String>,
    /// The first line holds words and is a row all the same.
    begins_with_row: bool,
    /// Lines that were looked at, and are still to be read.
    ahead: VecDeque<Kept>,
    /// Known from the first row on.
    pub(crate) layout: Option<Layout>,
    /// The rows that were read, and whether there was anything else.
    rows: usize,
    faults: bool,
    comments: bool,
    /// Where the last row ended, in bytes.
    last: u64,
    ended: bool,
}

impl<'a> Scan<'a> {
    /// Begins at the start of a stream; only the `wanted` columns are read, where some are named.
    pub(crate) fn new(stream: Stream<'a>, wanted: Option<Vec<String>>, limits: &'a Limits<'a>) -> Scan<'a> {
        Scan {
            lines: Lines::new(stream, limits),
            limits,
            wanted,
            first: None,
            begins_with_row: false,
            ahead: VecDeque::new(),
            layout: None,
            rows: 0,
            faults: false,
            comments: false,
            last: 0,
            ended: false,
        }
    }

    /// The same rows from the first on.
    pub(crate) fn rewind(&mut self) -> Result<()> {
        self.lines.rewind()?;
        (self.first, self.layout, self.rows, self.last) = (None, None, 0, 0);
        (self.faults, self.comments, self.ended, self.begins_with_row) = (false, false, false, false);
        self.ahead.clear();
        Ok(())
    }

    /// The name of the stream.
    pub(crate) fn name(&self) -> &str {
        self.lines.name()
    }

    /// Appends the numbers of the next row to `values` and returns its line; none behind the last row.
    ///
    /// # Errors
    /// As [`read`]. A text without rows is an error once, unless it had others.
    pub(crate) fn row(&mut self, values: &mut Vec<f64>) -> Result<Option<u64>> {
        if self.ended {
            return Ok(None);
        }
        let start = values.len();
        let taken = self.next(values);
        match &taken {
            Ok(Some(_)) => self.rows += 1,
            Ok(None) => self.ended = true,
            Err(_) => {
                self.faults = true;
                values.truncate(start);
            }
        }
        taken.map_err(|error| error.in_source(self.lines.name()))
    }

    fn next(&mut self, values: &mut Vec<f64>) -> Result<Option<u64>> {
        loop {
            let kept = self.ahead.pop_front();
            let line = match &kept {
                Some(kept) => Some(kept.line()),
                None => self.lines.next()?,
            };
            let Some(line) = line else {
                if self.rows > 0 || self.faults {
                    return Ok(None);
                }
                self.faults = true; // said once
                return Err(layout::nothing(self.first.is_some(), self.comments));
            };
            let content = without_comment(line.text);
            if content.trim().is_empty() {
                self.comments |= !line.text.trim().is_empty();
                // A stream without rows must end as well.
                self.limits.check_bytes(line.offset - self.last)?;
                continue;
            }
            let (title, wanted) = (self.first.as_deref(), self.wanted.as_deref());
            let begins = self.layout.is_none() && title.is_none() && !self.begins_with_row;
            if begins && layout::is_row_of_words(content, wanted) {
                let line = Kept::of(line);
                self.look_behind(line)?;
                continue;
            }
            let delimiter = match &self.layout {
                Some(layout) => layout.delimiter,
                None => match layout::delimiter(content, title, wanted) {
                    Some(delimiter) => delimiter,
                    None if title.is_none() => {
                        self.first = Some(content.to_owned());
                        continue;
                    }
                    None => return Err(diagnosis::words(line, content)),
                },
            };
            let layout = match &mut self.layout {
                Some(layout) => layout,
                none => none.insert(Layout::of(line, content, delimiter, title, wanted)?),
            };
            self.limits.check_points(self.rows as u64 + 1)?;
            if (self.rows + 1).is_multiple_of(BETWEEN_LOOKS) {
                self.limits.check_cancel()?;
            }
            if !layout.take(content, values) {
                return Err(diagnosis::row(layout, self.rows, line, content));
            }
            self.last = line.offset;
            return Ok(Some(line.number));
        }
    }

    /// Settles whether a first line of words, with numbers in the wanted columns, is a title: by the line behind it.
    fn look_behind(&mut self, first: Kept) -> Result<()> {
        let mut behind = None;
        while let Some(line) = self.lines.next()? {
            if !without_comment(line.text).trim().is_empty() {
                behind = Some(Kept::of(line));
                break;
            }
            self.limits.check_bytes(line.offset - self.last)?;
        }
        if behind.as_ref().is_some_and(|line| Delimiter::of_row(without_comment(&line.text)).is_some()) {
            self.first = Some(without_comment(&first.text).to_owned());
        } else {
            self.begins_with_row = true;
            self.ahead.push_back(first);
        }
        self.ahead.extend(behind);
        Ok(())
    }

    /// The first line, where it is neither a row nor names.
    pub(crate) fn title(&self) -> Option<&str> {
        let named = self.layout.as_ref().is_some_and(|layout| layout.names.is_some());
        self.first.as_deref().filter(|_| !named).map(str::trim)
    }
}

/// A line that outlives the buffer it was read into.
#[derive(Debug)]
struct Kept {
    number: u64,
    offset: u64,
    text: String,
}

impl Kept {
    fn of(line: Line<'_>) -> Kept {
        Kept { number: line.number, offset: line.offset, text: line.text.to_owned() }
    }

    fn line(&self) -> Line<'_> {
        Line { number: self.number, offset: self.offset, text: &self.text }
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
    fn other_columns_may_hold_words() {
        let chosen = |text: &str, columns: &[&str]| {
            read_columns(&Source::from_bytes("a.txt", text), columns, &Limits::default())
        };
        let values = |text, columns: &[&str]| chosen(text, columns).unwrap().values().to_vec();
        let dates = "date,x,y\n2020-01-01,1,2\n2020-01-02,3,4\n";
        assert_eq!(values(dates, &["y", "x"]), [2.0, 1.0, 4.0, 3.0]);
        assert_eq!(chosen(dates, &["2"]).unwrap().columns().unwrap(), ["y"]);
        assert_eq!(values("2020-01-01 10:00 1 2\n2020-01-01 11:00 3 4\n", &["3", "2"]), [2.0, 1.0, 4.0, 3.0]);
        assert_eq!(values("a, b\tx\nc, d\t7\n", &["x"]), [7.0]);
        assert_eq!(values("when;x\n\"1 May; late\";1\n\"\";2\n", &["x", "x"]), [1.0, 1.0, 2.0, 2.0]);
        assert_eq!(values("x y\n1 2\n", &["y"]), [2.0]);
        assert_eq!(values("x,note\n1,nan\n2,\n", &["x"]), [1.0, 2.0]);
        let fault = |text, columns: &[&str]| {
            let error = chosen(text, columns).unwrap_err();
            (error.code().as_str(), error.place().line, error.place().column)
        };
        assert_eq!(fault(dates, &["date"]), ("F005", Some(2), Some(1)));
        assert_eq!(fault(dates, &["z"]), ("F009", None, None));
        assert_eq!(fault("d,x\na,1\nb,2,3\n", &["x"]), ("P005", Some(3), Some(5)));
        assert_eq!(fault("d,x\na,1\nb,two\n", &["x"]), ("F005", Some(3), Some(3)));
        assert_eq!(fault("d,x,x\na,1,2\n", &["x"]), ("F022", None, None));
        assert_eq!(fault("d,x\n", &["x"]), ("P001", None, None));
        // A title with a number at the chosen place, as it is to those who read all; a row, where the next one has words as well.
        assert_eq!(values("NACA 2412\n1 0\n2 5\n", &["1"]), [0.0, 5.0]);
        assert_eq!(values("section 5 of 7\n\n# c\n1 0\n", &["1"]), [0.0]);
        assert_eq!(values("a,5\n\nb,6\n1,7\n", &["1"]), [5.0, 6.0, 7.0]);
        assert_eq!(values("a,5\n", &["1"]), [5.0]);
        assert_eq!(values("x,note\n6,\n10\n", &["0"]), [6.0, 10.0]);
        assert_eq!(fault("1,2\n", &[]), ("F009", None, None));
        let error = read(&Source::from_bytes("a.txt", dates), &Limits::default()).unwrap_err();
        assert_eq!(error.remedy(), "Choose the columns of numbers, or begin lines of words with #.");
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
