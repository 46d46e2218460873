//! Findings in tables of points.

use lath::error::{Code as CoreCode, Limits};

use crate::check::finding::Findings;
use crate::check::{Report, show};
use crate::error::{Code, Error, Result};
use crate::points::{PointTable, npy as array, text as words};
use crate::source::Source;

/// Columns of these names are parameters.
const PARAMETERS: &[&str] = &["t", "u", "time", "param", "parameter"];
/// The greatest number that the core takes, and the greatest whose square is finite.
pub(super) const SCALE: f64 = 1e300;
pub(super) const SQUARES: f64 = 1e150;
/// How much larger than their range numbers may be: beyond it, single precision tools see a single point.
const OFFSET: f64 = 1e7;

/// CSV, TSV and text: every row on its own.
pub(super) fn text(
    source: &Source,
    limits: &Limits<'_>,
    findings: &mut Findings<'_>,
    report: &mut Report,
) -> Result<()> {
    match words::read_tolerantly(source, limits, |error| findings.push(error))? {
        Some(table) => self::table(&table, findings, report),
        None => Ok(()),
    }
}

/// `.npy`: NaN and infinities row by row.
pub(super) fn npy(
    source: &Source,
    limits: &Limits<'_>,
    findings: &mut Findings<'_>,
    report: &mut Report,
) -> Result<()> {
    let table = match array::table(source, limits, false) {
        Ok((table, _)) => table,
        Err(error) => return findings.push(error),
    };
    for (index, row) in table.rows().enumerate() {
        if let Some((column, x)) = row.iter().enumerate().find(|(_, x)| !x.is_finite()) {
            findings.push(array::not_finite(index as u64, column, *x))?;
        }
    }
    self::table(&table, findings, report)
}

/// A table that could be read, in whatever format.
pub(super) fn table(table: &PointTable, findings: &mut Findings<'_>, report: &mut Report) -> Result<()> {
    report.points = Some(table.len());
    let at = |code: Code, row: usize, message: String| {
        // The table knows the place of a row; a code of the core carries the index there.
        let place = table.locate(lath::error::Error::new(CoreCode::P004, "").at(row)).place().clone();
        let error = Error::new(code, message).at_index(row);
        let error = match place.line {
            Some(line) => error.at_line(line, None),
            None => error,
        };
        match place.pointer {
            Some(pointer) => error.at_pointer(pointer),
            None => error,
        }
    };
    doubled(table, &at, findings)?;
    parameters(table, &at, findings)?;
    scale(table, &at, findings)
}

fn doubled(table: &PointTable, at: &dyn Fn(Code, usize, String) -> Error, findings: &mut Findings<'_>) -> Result<()> {
    let rows = table.len();
    let mut all = rows > 1;
    let mut pairs = Vec::new();
    for (index, (row, next)) in table.rows().zip(table.rows().skip(1)).enumerate() {
        if row == next {
            pairs.push(index + 1);
        } else {
            all = false;
        }
    }
    if all {
        return findings.push(at(Code::W006, 1, format!("all {rows} points are the same")));
    }
    for index in pairs {
        findings.push(at(Code::W005, index, format!("point {index} is the same as point {}", index - 1)))?;
    }
    match (table.row(0), table.row(rows.saturating_sub(1))) {
        (Some(first), Some(last)) if rows > 2 && first == last => {
            let message = format!("the last point, {}, is the first one again", rows - 1);
            findings.push(at(Code::W009, rows - 1, message))
        }
        _ => Ok(()),
    }
}

fn parameters(
    table: &PointTable,
    at: &dyn Fn(Code, usize, String) -> Error,
    findings: &mut Findings<'_>,
) -> Result<()> {
    let names = table.columns().unwrap_or_default();
    for (column, name) in names.iter().enumerate() {
        if !PARAMETERS.contains(&name.to_lowercase().as_str()) {
            continue;
        }
        let mut last = f64::NEG_INFINITY;
        for (index, row) in table.rows().enumerate() {
            let t = row.get(column).copied().unwrap_or(f64::NAN);
            if t < last {
                let message = format!("{name} = {} is below {}, the one before", show(t), show(last));
                findings.push(at(Code::W013, index, message))?;
            } else if t == last {
                let message = format!("{name} = {} stands in two rows that follow each other", show(t));
                findings.push(at(Code::W014, index, message))?;
            }
            last = t;
        }
    }
    Ok(())
}

fn scale(table: &PointTable, at: &dyn Fn(Code, usize, String) -> Error, findings: &mut Findings<'_>) -> Result<()> {
    let mut squares = None;
    for (index, row) in table.rows().enumerate() {
        for (column, x) in row.iter().enumerate().filter(|(_, x)| x.is_finite() && x.abs() > SQUARES) {
            if x.abs() > SCALE {
                let message = format!("column {column} of row {index} is {}", show(*x));
                findings.push(at(Code::Core(CoreCode::P003), index, message))?;
            } else if squares.is_none() {
                squares = Some((index, column, *x));
            }
        }
    }
    if let Some((index, column, x)) = squares {
        findings.push(at(Code::W016, index, format!("column {column} of row {index} is {}", show(x))))?;
    }
    for column in 0..table.width() {
        let values = || table.rows().filter_map(|row| row.get(column).copied()).filter(|x| x.is_finite());
        if let Some(message) = offset(values()) {
            findings.push(at(Code::W015, 0, format!("column {column}: {message}")))?;
        }
    }
    Ok(())
}

/// What is wrong with numbers that lie far from zero for their range; nothing for numbers that are all the same.
pub(super) fn offset(values: impl Iterator<Item = f64>) -> Option<String> {
    let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
    for x in values {
        low = if x < low { x } else { low };
        high = if x > high { x } else { high };
    }
    let largest = if high > -low { high } else { -low };
    let range = high - low;
    (range > 0.0 && largest > OFFSET * range)
        .then(|| format!("the numbers lie near {} and differ by {} only", show(largest), show(range)))
}
