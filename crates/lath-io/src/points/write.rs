//! Rows going out, one by one.

use std::io::Write;

use lath::error::Code as CoreCode;

use crate::atomic::failed;
use crate::error::{Code, Error, Result};
use crate::number::shortest;

/// Where rows of numbers are pushed; made by [`crate::format::Format::rows`].
pub trait RowSink {
    /// Writes one row.
    ///
    /// # Errors
    /// P002 where a number is not finite: no format here writes NaN or infinity; I005 where writing fails.
    fn row(&mut self, row: &[f64]) -> Result<()>;

    /// Writes what belongs behind the last row, and flushes. A sink that is not finished has written an incomplete
    /// file.
    ///
    /// # Errors
    /// I005 where writing fails.
    fn finish(&mut self) -> Result<()>;
}

/// The row, if all its numbers can be written.
pub(crate) fn checked(row: &[f64], index: usize) -> Result<&[f64]> {
    match row.iter().find(|x| !x.is_finite()) {
        None => Ok(row),
        Some(culprit) => {
            let message = format!("{culprit} in row {index} cannot be written");
            Err(Error::new(Code::Core(CoreCode::P002), message).at_index(index))
        }
    }
}

/// CSV, TSV and text: rows of numbers between separators, under a line of names.
pub(crate) struct Separated<'w> {
    out: &'w mut dyn Write,
    separator: &'static str,
    rows: usize,
    line: String,
}

impl<'w> Separated<'w> {
    /// Begins the table; `separator` is one character.
    pub(crate) fn begin(
        out: &'w mut dyn Write,
        separator: &'static str,
        columns: Option<&[String]>,
    ) -> Result<Separated<'w>> {
        if let Some(names) = columns {
            let names: Vec<String> = names.iter().map(|name| quoted(name, separator)).collect();
            writeln!(out, "{}", names.join(separator)).map_err(|e| failed(&e))?;
        }
        Ok(Separated { out, separator, rows: 0, line: String::new() })
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
        let row = checked(row, self.rows)?;
        self.line.clear();
        for (i, &number) in row.iter().enumerate() {
            let separator = if i == 0 { "" } else { self.separator };
            // Writing into a String cannot fail.
            let _ = write!(self.line, "{separator}{}", shortest(number));
        }
        self.line.push('\n');
        self.out.write_all(self.line.as_bytes()).map_err(|e| failed(&e))?;
        self.rows += 1;
        Ok(())
    }

    fn finish(&mut self) -> Result<()> {
        self.out.flush().map_err(|e| failed(&e))
    }
}

/// JSON: `{"columns":[…],"rows":[[…],…]}`, or `[[…],…]` without names; one row a line.
pub(crate) struct JsonRows<'w> {
    out: &'w mut dyn Write,
    named: bool,
    rows: usize,
}

impl<'w> JsonRows<'w> {
    /// Begins the document.
    pub(crate) fn begin(out: &'w mut dyn Write, columns: Option<&[String]>) -> Result<JsonRows<'w>> {
        match columns {
            Some(names) => {
                let names: Vec<String> =
                    names.iter().map(|name| serde_json::Value::from(name.as_str()).to_string()).collect();
                write!(out, "{{\"columns\":[{}],\"rows\":[", names.join(",")).map_err(|e| failed(&e))?;
            }
            None => write!(out, "[").map_err(|e| failed(&e))?,
        }
        Ok(JsonRows { out, named: columns.is_some(), rows: 0 })
    }
}

impl RowSink for JsonRows<'_> {
    fn row(&mut self, row: &[f64]) -> Result<()> {
        let row = checked(row, self.rows)?;
        let numbers: Vec<String> = row.iter().map(|&number| shortest(number).to_string()).collect();
        let before = if self.rows == 0 { "" } else { "," };
        write!(self.out, "{before}\n[{}]", numbers.join(",")).map_err(|e| failed(&e))?;
        self.rows += 1;
        Ok(())
    }

    fn finish(&mut self) -> Result<()> {
        let end = if self.named { "]}" } else { "]" };
        writeln!(self.out, "\n{end}").and_then(|()| self.out.flush()).map_err(|e| failed(&e))
    }
}
