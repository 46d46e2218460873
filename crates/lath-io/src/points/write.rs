//! Rows going out, one by one.

use std::io::Write;

use lath::error::Code as CoreCode;

use crate::error::{Code, Error, Result};
use crate::number::{parse, shortest};

/// Where rows of numbers are pushed; made by [`crate::format::Format::rows`].
pub trait RowSink {
    /// Writes one row.
    ///
    /// # Errors
    /// P002 where a number is not finite: no format here writes NaN or infinity; P005 where the row is not as long as
    /// the names or the first row; I005 where writing fails.
    fn row(&mut self, row: &[f64]) -> Result<()>;

    /// Writes what belongs behind the last row, and flushes. A sink that is not finished has written an incomplete
    /// file.
    ///
    /// # Errors
    /// I005 where writing fails.
    fn finish(&mut self) -> Result<()>;
}

/// What the rows so far were like.
#[derive(Debug, Default)]
struct Guard {
    count: usize,
    width: Option<usize>,
}

impl Guard {
    /// Begins with the names of the columns, where there are any.
    fn new(columns: Option<&[String]>) -> Guard {
        Guard { count: 0, width: columns.map(<[String]>::len) }
    }

    /// Counts a row that can be written.
    fn check(&mut self, row: &[f64]) -> Result<()> {
        let refuse = |code, message: String| Err(Error::new(Code::Core(code), message).at_index(self.count));
        let width = *self.width.get_or_insert(row.len());
        if row.len() != width {
            return refuse(CoreCode::P005, format!("row {} has {} numbers, not {width}", self.count, row.len()));
        }
        if let Some(culprit) = row.iter().find(|x| !x.is_finite()) {
            return refuse(CoreCode::P002, format!("{culprit} in row {} cannot be written", self.count));
        }
        self.count += 1;
        Ok(())
    }
}

/// CSV, TSV and text: rows of numbers between separators, under a line of names.
pub(crate) struct Separated<'w> {
    out: &'w mut dyn Write,
    separator: &'static str,
    guard: Guard,
    line: String,
}

impl<'w> Separated<'w> {
    /// Begins the table; `separator` is one character. Names that are all numbers are left out: they would read back
    /// as a row.
    pub(crate) fn begin(
        out: &'w mut dyn Write,
        separator: &'static str,
        columns: Option<&[String]>,
    ) -> Result<Separated<'w>> {
        let is_row = |names: &&[String]| names.iter().all(|name| name.is_empty() || parse(name).is_ok());
        if let Some(names) = columns.filter(|names| !is_row(names)) {
            let names: Vec<String> = names.iter().map(|name| quoted(name, separator)).collect();
            writeln!(out, "{}", names.join(separator)).map_err(|e| Error::writing(&e))?;
        }
        Ok(Separated { out, separator, guard: Guard::new(columns), line: String::new() })
    }
}

/// A name as a field: between quotation marks where it would be read otherwise without.
fn quoted(name: &str, separator: &str) -> String {
    let name = name.replace(['\r', '\n'], " ");
    let plain = !name.is_empty() && !name.contains(|c: char| "\"#;,".contains(c) || c.is_whitespace());
    if plain || (name.is_empty() && separator != " ") { name } else { format!("\"{}\"", name.replace('"', "\"\"")) }
}

impl RowSink for Separated<'_> {
    fn row(&mut self, row: &[f64]) -> Result<()> {
        use std::fmt::Write as _;
        self.guard.check(row)?;
        self.line.clear();
        for (i, &number) in row.iter().enumerate() {
            let separator = if i == 0 { "" } else { self.separator };
            // Writing into a String cannot fail.
            let _ = write!(self.line, "{separator}{}", shortest(number));
        }
        self.line.push('\n');
        self.out.write_all(self.line.as_bytes()).map_err(|e| Error::writing(&e))
    }

    fn finish(&mut self) -> Result<()> {
        self.out.flush().map_err(|e| Error::writing(&e))
    }
}

/// JSON: `{"columns":[…],"rows":[[…],…]}`, or `[[…],…]` without names; one row a line.
pub(crate) struct JsonRows<'w> {
    out: &'w mut dyn Write,
    named: bool,
    guard: Guard,
}

impl<'w> JsonRows<'w> {
    /// Begins the document.
    pub(crate) fn begin(out: &'w mut dyn Write, columns: Option<&[String]>) -> Result<JsonRows<'w>> {
        match columns {
            Some(names) => {
                let names: Vec<String> =
                    names.iter().map(|name| serde_json::Value::from(name.as_str()).to_string()).collect();
                write!(out, "{{\"columns\":[{}],\"rows\":[", names.join(",")).map_err(|e| Error::writing(&e))?;
            }
            None => write!(out, "[").map_err(|e| Error::writing(&e))?,
        }
        Ok(JsonRows { out, named: columns.is_some(), guard: Guard::new(columns) })
    }
}

impl RowSink for JsonRows<'_> {
    fn row(&mut self, row: &[f64]) -> Result<()> {
        let before = if self.guard.count == 0 { "" } else { "," };
        self.guard.check(row)?;
        let numbers: Vec<String> = row.iter().map(|&number| shortest(number).to_string()).collect();
        write!(self.out, "{before}\n[{}]", numbers.join(",")).map_err(|e| Error::writing(&e))
    }

    fn finish(&mut self) -> Result<()> {
        let end = if self.named { "]}" } else { "]" };
        writeln!(self.out, "\n{end}").and_then(|()| self.out.flush()).map_err(|e| Error::writing(&e))
    }
}
