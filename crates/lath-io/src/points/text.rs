//! Points as text: CSV, TSV, and columns between blanks.
//!
//! One reader for all: the first row of numbers shows whether semicolons, commas, tabs or blanks separate the columns.
//! So `.csv` files with semicolons, and `.dat` files with commas, are what they are. The grammar:
//!
//! - `#` begins a comment, at the start of a line or behind a row; blank lines mean nothing.
//! - A first line that is not all numbers is a title. Where it has one word for every column, and none of them a
//!   number, the words are the columns' names; quoted ones may contain anything.
//! - Every other line is a row; all rows have one length. A separator at the end of a line is ignored.
//! - Where columns are chosen, the fields of the others may be anything, dates for example, and are not looked at.
//! - A number is decimal and finite: `1`, `-.5`, `+6.02e23`, with quotation marks or without; it is rounded to the
//!   nearest double.

use lath::error::{Code as CoreCode, Limits};

use crate::error::{Code, Error, Result};
use crate::number;
use crate::points::fields::{Delimiter, Field, split, without_comment};
use crate::points::select::choose;
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
    let mut scan = Scan::new(source, wanted, limits)?;
    let (mut values, mut lines) = (Vec::new(), Vec::new());
    while let Some(line) = scan.row(&mut values) {
        lines.push(u32::try_from(line?.number).unwrap_or(u32::MAX));
    }
    if lines.is_empty() {
        return Err(scan.nothing());
    }
    Ok(PointTable {
        source: Some(source.name().to_owned()),
        title: scan.title().map(str::to_owned),
        width: scan.picks.as_ref().map_or(scan.width, Vec::len),
        columns: scan.columns(),
        values,
        rows_at: RowsAt::Lines(lines),
    })
}

/// Reads every row that can be read, and hands out an error for each that cannot; with the table, their number.
pub(crate) fn read_tolerantly(
    source: &Source,
    limits: &Limits<'_>,
    mut found: impl FnMut(Error) -> Result<()>,
) -> Result<(Option<PointTable>, usize)> {
    let mut scan = match Scan::new(source, None, limits) {
        Ok(scan) => scan,
        Err(error) => return found(error).map(|()| (None, 1)),
    };
    let (mut values, mut lines, mut errors) = (Vec::new(), Vec::new(), 0);
    while let Some(line) = scan.row(&mut values) {
        match line {
            Ok(line) => lines.push(u32::try_from(line.number).unwrap_or(u32::MAX)),
            Err(error) => {
                errors += 1;
                found(error)?;
            }
        }
    }
    let table = (!lines.is_empty()).then(|| PointTable {
        source: Some(source.name().to_owned()),
        title: scan.title().map(str::to_owned),
        width: scan.width,
        columns: scan.columns(),
        values,
        rows_at: RowsAt::Lines(lines),
    });
    Ok((table, errors))
}

/// The names of `width` columns, if that is what the first line holds.
fn names(title: &str, delimiter: Delimiter, width: usize) -> Option<Vec<String>> {
    let is_name = |field: &Result<Field<'_>, usize>| field.is_ok_and(|field| number::parse(field.text).is_err());
    let is_names = split(title, delimiter).all(|field| is_name(&field)) && split(title, delimiter).count() == width;
    is_names.then(|| split(title, delimiter).flatten().map(|field| field.unescaped()).collect())
}

/// The rows of a text, one by one. After an error the scan goes on behind the line at fault.
pub(crate) struct Scan<'a> {
    source: &'a Source,
    limits: &'a Limits<'a>,
    lines: Box<dyn Iterator<Item = Line<'a>> + 'a>,
    wanted: Option<&'a [&'a str]>,
    /// The bytes of the text.
    spent: u64,
    /// The first line, where it is no row.
    first: Option<&'a str>,
    delimiter: Option<Delimiter>,
    /// The fields of the first row, and its line.
    width: usize,
    first_row: u64,
    names: Option<Vec<String>>,
    /// The indices of the wanted columns.
    picks: Option<Vec<usize>>,
    rows: usize,
}

impl<'a> Scan<'a> {
    pub(crate) fn new(source: &'a Source, wanted: Option<&'a [&'a str]>, limits: &'a Limits<'a>) -> Result<Scan<'a>> {
        let text = source.text()?;
        Ok(Scan {
            source,
            limits,
            lines: Box::new(lines(text)),
            wanted,
            spent: text.len() as u64,
            first: None,
            delimiter: None,
            width: 0,
            first_row: 0,
            names: None,
            picks: None,
            rows: 0,
        })
    }

    /// Appends the numbers of the next row to `values` and returns its line.
    pub(crate) fn row(&mut self, values: &mut Vec<f64>) -> Option<Result<Line<'a>>> {
        loop {
            let line = self.lines.next()?;
            let content = without_comment(line.text);
            if content.trim().is_empty() {
                continue;
            }
            let delimiter = match self.delimiter.or_else(|| self.delimiter_of(content)) {
                Some(delimiter) => delimiter,
                None if self.first.is_none() => {
                    self.first = Some(content);
                    continue;
                }
                None => return Some(Err(self.words(line, content))),
            };
            let before = values.len();
            let taken = self.take(line, content, delimiter, values);
            if taken.is_err() {
                values.truncate(before);
            }
            return Some(taken.map(|()| line));
        }
    }

    /// The delimiter, once a row shows it.
    fn delimiter_of(&self, content: &str) -> Option<Delimiter> {
        Delimiter::of_row(content).or_else(|| match (self.wanted, self.first) {
            (None, _) => None,
            (Some(wanted), Some(first)) => {
                // The one that cuts out the wanted columns.
                let fits = |delimiter: &Delimiter| {
                    let width = split(content, *delimiter).count();
                    choose(names(first, *delimiter, width).as_deref(), width, wanted).is_ok()
                };
                Delimiter::candidates(content).find(fits).or_else(|| Some(Delimiter::of_words(content)))
            }
            (Some(wanted), None) => {
                // The first line: a row, if the fields of the wanted columns are numbers.
                let delimiter = Delimiter::of_words(content);
                let field = |index: usize| split(content, delimiter).nth(index)?.ok();
                let is_number = |name: &&str| {
                    let field = name.trim().parse().ok().and_then(field);
                    field.is_some_and(|field| number::parse(field.text).is_ok())
                };
                (!wanted.is_empty() && wanted.iter().all(is_number)).then_some(delimiter)
            }
        })
    }

    /// What the first row tells: the delimiter, the width, the names, and with them the wanted columns.
    fn begin(&mut self, line: Line<'_>, content: &str, delimiter: Delimiter) -> Result<()> {
        let mut width = split(content, delimiter).count();
        if self.wanted.is_some() && delimiter.ends(content) {
            // An empty last field, where there are names to show that it is one.
            let named = self.first.map_or(0, |first| split(first, delimiter).count());
            width += usize::from(named == width + 1);
        }
        let names = self.first.and_then(|first| names(first, delimiter, width));
        if let Some(wanted) = self.wanted {
            let picks = choose(names.as_deref(), width, wanted);
            self.picks = Some(picks.map_err(|error| error.in_source(self.source.name()))?);
        }
        (self.delimiter, self.width, self.names, self.first_row) = (Some(delimiter), width, names, line.number);
        Ok(())
    }

    fn take(&mut self, line: Line<'a>, content: &'a str, delimiter: Delimiter, values: &mut Vec<f64>) -> Result<()> {
        if self.delimiter.is_none() {
            if let Some(Err(offset)) = split(content, delimiter).find(Result::is_err) {
                return Err(self.stray_quotation(line, offset));
            }
            self.begin(line, content, delimiter)?;
        }
        self.check_budget()?;
        let mut count = 0;
        let mut good = true;
        match &self.picks {
            None => {
                for field in split(content, delimiter) {
                    let value = field.ok().and_then(|field| number::parse(field.text).ok());
                    good &= value.is_some();
                    values.push(value.unwrap_or(0.0));
                    count += 1;
                }
            }
            Some(picks) => {
                let start = values.len();
                values.resize(start + picks.len(), 0.0);
                for (index, field) in split(content, delimiter).enumerate() {
                    count += 1;
                    good &= field.is_ok();
                    for (slot, _) in picks.iter().enumerate().filter(|(_, pick)| **pick == index) {
                        let value = field.ok().and_then(|field| number::parse(field.text).ok());
                        good &= value.is_some();
                        if let Some(place) = values.get_mut(start + slot) {
                            *place = value.unwrap_or(0.0);
                        }
                    }
                }
            }
        }
        let unread = |picks: &Vec<usize>| delimiter.ends(content) && !picks.contains(&count);
        count += usize::from(count + 1 == self.width && self.picks.as_ref().is_some_and(unread));
        if !good || count != self.width {
            return Err(self.diagnose(line, content, delimiter));
        }
        self.rows += 1;
        Ok(())
    }

    /// What is wrong with a row: a quotation, else its length, else the first field that is no number.
    fn diagnose(&self, line: Line<'_>, content: &str, delimiter: Delimiter) -> Error {
        if let Some(Err(offset)) = split(content, delimiter).find(Result::is_err) {
            return self.stray_quotation(line, offset);
        }
        let chosen = |index: &usize| self.picks.as_ref().is_none_or(|picks| picks.contains(index));
        let count = split(content, delimiter).count();
        if count != self.width {
            let extra = split(content, delimiter).flatten().nth(self.width).map(|field| field.offset);
            return self.ragged(line, count, extra);
        }
        let culprit = split(content, delimiter).flatten().enumerate().filter(|(index, _)| chosen(index));
        let mut refusals = culprit.filter_map(|(_, field)| Some((field, number::parse(field.text).err()?)));
        match refusals.next() {
            Some((field, refusal)) => self.fault(line, field.offset, refusal.error(field.text)),
            None => self.fault(line, 0, Error::new(Code::F005, "this line is not a row of numbers")),
        }
    }

    /// The first line, where it is neither a row nor names.
    pub(crate) fn title(&self) -> Option<&'a str> {
        self.first.filter(|_| self.names.is_none()).map(str::trim)
    }

    /// The names of the columns that are read.
    pub(crate) fn columns(&self) -> Option<Vec<String>> {
        let names = self.names.as_ref()?;
        match &self.picks {
            None => Some(names.clone()),
            Some(picks) => Some(picks.iter().filter_map(|&pick| names.get(pick).cloned()).collect()),
        }
    }

    /// The error of a text without rows.
    pub(crate) fn nothing(&self) -> Error {
        let message = match self.first {
            Some(_) => "there is no row of numbers behind the first line",
            None => "there is nothing but comments",
        };
        Error::new(Code::Core(CoreCode::P001), message).in_source(self.source.name())
    }

    fn check_budget(&self) -> Result<()> {
        let rows = self.rows + 1;
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

    /// The error about a row of another length; `extra` is where the first field too many begins.
    fn ragged(&self, line: Line<'_>, count: usize, extra: Option<usize>) -> Error {
        let plural = |n: usize| if n == 1 { "" } else { "s" };
        let (first, width) = (self.first_row, self.width);
        let message = format!("this row has {count} number{}, the first row (line {first}) has {width}", plural(count));
        let error = Error::new(Code::Core(CoreCode::P005), message).at_index(self.rows);
        self.fault(line, extra.unwrap_or(line.text.len()), error)
    }

    /// The error about a line of words that is not the first one.
    fn words(&self, line: Line<'a>, content: &'a str) -> Error {
        let delimiter = Delimiter::of_words(content);
        if let Some(Err(offset)) = split(content, delimiter).find(Result::is_err) {
            return self.stray_quotation(line, offset);
        }
        let read = |field: Field<'a>| (field, number::parse(field.text));
        let some = split(content, delimiter).flatten().map(read).any(|(_, value)| value.is_ok());
        let remedy = if some {
            "Choose the columns of numbers, or begin lines of words with #."
        } else {
            "Only the first line may be a title; begin other lines of words with #."
        };
        let culprit =
            split(content, delimiter).flatten().map(read).find_map(|(field, value)| Some((field, value.err()?)));
        match culprit {
            Some((field, refusal)) => self.fault(line, field.offset, refusal.error(field.text).remedied(remedy)),
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
        self.source.fault_in(line.number, line.offset, line.offset + offset, error)
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
