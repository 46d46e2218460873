//! Rows going out, one by one.

use std::io::Write;

use lath::error::Code as CoreCode;

use crate::error::{Code, Error, Result};
use crate::number::{Printer, counted, parse};

/// Where rows of numbers are pushed; made by [`crate::format::Format::rows`].
pub trait RowSink {
    /// Writes one row.
    ///
    /// # Errors
    /// P002 where a number is not finite: no format here writes NaN or infinity; P005 where the row is not as long as
    /// the names or the first row; F024 where it is one more than announced; I005 where writing fails.
    fn row(&mut self, row: &[f64]) -> Result<()>;

    /// Writes what belongs behind the last row, and flushes. A sink that is not finished has written an incomplete
    /// file.
    ///
    /// # Errors
    /// F024 where rows are missing that were announced; I005 where writing fails.
    fn finish(&mut self) -> Result<()>;
}

/// What the rows so far were like.
#[derive(Debug)]
pub(crate) struct Guard {
    pub(crate) count: usize,
    pub(crate) width: Option<usize>,
    announced: Option<u64>,
}

impl Guard {
    /// Begins with the names of the columns and the number of rows, where they are known.
    pub(crate) fn new(columns: Option<&[String]>, announced: Option<u64>) -> Guard {
        Guard { count: 0, width: columns.map(<[String]>::len), announced }
    }

    /// Counts a row that can be written.
    pub(crate) fn check(&mut self, row: &[f64]) -> Result<()> {
        let refuse = |code, message: String| Err(Error::new(code, message).at_index(self.count));
        let width = *self.width.get_or_insert(row.len());
        if row.len() != width {
            let message = format!("row {} has {}, not {width}", self.count, counted(row.len(), "number"));
            return refuse(Code::Core(CoreCode::P005), message);
        }
        if let Some(culprit) = row.iter().find(|x| !x.is_finite()) {
            return refuse(Code::Core(CoreCode::P002), format!("{culprit} in row {} cannot be written", self.count));
        }
        if let Some(announced) = self.announced.filter(|&announced| self.count as u64 >= announced) {
            return refuse(Code::F024, format!("row {} comes after the {announced} that were announced", self.count));
        }
        self.count += 1;
        Ok(())
    }

    /// The end: every announced row must have come.
    pub(crate) fn finish(&self) -> Result<()> {
        match self.announced {
            Some(announced) if announced != self.count as u64 => Err(Error::new(
                Code::F024,
                format!("{} of the {announced} that were announced", counted(self.count, "row")),
            )),
            _ => Ok(()),
        }
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
        count: Option<u64>,
    ) -> Result<Separated<'w>> {
        let is_row = |names: &&[String]| names.iter().all(|name| name.is_empty() || parse(name).is_ok());
        if let Some(names) = columns.filter(|names| !is_row(names)) {
            let names: Vec<String> = names.iter().map(|name| quoted(name, separator)).collect();
            writeln!(out, "{}", names.join(separator)).map_err(|e| Error::writing(&e))?;
        }
        Ok(Separated { out, separator, guard: Guard::new(columns, count), line: String::new() })
    }
}

/// A name as a field: between quotation marks where it would be read otherwise without.
fn quoted(name: &str, separator: &str) -> String {
    let name = name.replace(['\r', '\n'], " ");
    let plain = !name.is_empty() && !name.contains(|c: char| "\"#;,".contains(c) || c.is_whitespace());
    if plain || (name.is_empty() && separator != " ") { name } else { format!("\"{}\"", name.replace('"', "\"\"")) }
}

/// Appends the numbers, the separator between them.
fn joined(row: &[f64], separator: &str, line: &mut String) {
    let mut printer = Printer::new();
    for (i, &number) in row.iter().enumerate() {
        line.push_str(if i == 0 { "" } else { separator });
        line.push_str(printer.print(number));
    }
}

impl RowSink for Separated<'_> {
    fn row(&mut self, row: &[f64]) -> Result<()> {
        self.guard.check(row)?;
        self.line.clear();
        joined(row, self.separator, &mut self.line);
        self.line.push('\n');
        self.out.write_all(self.line.as_bytes()).map_err(|e| Error::writing(&e))
    }

    fn finish(&mut self) -> Result<()> {
        self.guard.finish()?;
        self.out.flush().map_err(|e| Error::writing(&e))
    }
}

/// JSON: `{"columns":[…],"rows":[[…],…]}`, or `[[…],…]` without names; one row a line.
pub(crate) struct JsonRows<'w> {
    out: &'w mut dyn Write,
    named: bool,
    guard: Guard,
    line: String,
}

impl<'w> JsonRows<'w> {
    /// Begins the document.
    pub(crate) fn begin(
        out: &'w mut dyn Write,
        columns: Option<&[String]>,
        count: Option<u64>,
    ) -> Result<JsonRows<'w>> {
        match columns {
            Some(names) => {
                let names: Vec<String> =
                    names.iter().map(|name| serde_json::Value::from(name.as_str()).to_string()).collect();
                write!(out, "{{\"columns\":[{}],\"rows\":[", names.join(",")).map_err(|e| Error::writing(&e))?;
            }
            None => write!(out, "[").map_err(|e| Error::writing(&e))?,
        }
        let guard = Guard::new(columns, count);
        Ok(JsonRows { out, named: columns.is_some(), guard, line: String::new() })
    }
}

impl RowSink for JsonRows<'_> {
    fn row(&mut self, row: &[f64]) -> Result<()> {
        let before = if self.guard.count == 0 { "\n[" } else { ",\n[" };
        self.guard.check(row)?;
        self.line.clear();
        self.line.push_str(before);
        joined(row, ",", &mut self.line);
        self.line.push(']');
        self.out.write_all(self.line.as_bytes()).map_err(|e| Error::writing(&e))
    }

    fn finish(&mut self) -> Result<()> {
        self.guard.finish()?;
        let end = if self.named { "]}" } else { "]" };
        writeln!(self.out, "\n{end}").and_then(|()| self.out.flush()).map_err(|e| Error::writing(&e))
    }
}
