//! Rows that are dropped from tables.

use std::collections::HashSet;

use lath::error::{Code as CoreCode, Limits};

use crate::error::{Code, Result};
use crate::format;
use crate::json::Json;
use crate::number::counted;
use crate::points::lines::Lines;
use crate::points::{npy as array, text as words};
use crate::source::Source;
use crate::stream::Stream;

/// How many places a change lists.
const LISTED: usize = 10;

/// "dropped 2 rows that …: lines 3, 7"
fn tell(places: &[u64], what: &str, unit: &str, changes: &mut Vec<String>) {
    if places.is_empty() {
        return;
    }
    let plural = if places.len() == 1 { "" } else { "s" };
    let listed: Vec<String> = places.iter().take(LISTED).map(u64::to_string).collect();
    let more = if places.len() > LISTED { ", …" } else { "" };
    let count = counted(places.len(), "row");
    changes.push(format!("dropped {count} {what}: {unit}{plural} {}{more}", listed.join(", ")));
}

const NOT_FINITE: &str = "with NaN or infinity";
const DOUBLED: &str = "the same as the row before";

/// Lines are left out, and every other byte stays.
pub(super) fn text(source: &Source, limits: &Limits<'_>, changes: &mut Vec<String>) -> Result<Option<Vec<u8>>> {
    // What is no text is left alone, and nothing is said to have been dropped from it.
    let Ok(text) = source.text() else { return Ok(None) };
    let mut not_finite = Vec::new();
    let table = words::read_tolerantly(source, limits, |error| {
        match (error.code(), error.place().line) {
            (Code::Core(CoreCode::P002), Some(line)) => not_finite.push(line),
            _ if error.class() != crate::error::Class::Invalid => return Err(error),
            _ => {}
        }
        Ok(())
    })?;
    let Some(table) = table else { return Ok(None) };
    let pairs = table.rows().zip(table.rows().skip(1)).enumerate();
    let doubled: Vec<u64> =
        pairs.filter(|(_, (row, next))| row == next).filter_map(|(i, _)| table.line(i + 1).map(u64::from)).collect();
    tell(&not_finite, NOT_FINITE, "line", changes);
    tell(&doubled, DOUBLED, "line", changes);
    let dropped: HashSet<u64> = not_finite.into_iter().chain(doubled).collect();
    // The end of a line goes with it.
    let (mut kept, mut from, mut keep) = (String::new(), 0, true);
    let mut lines = Lines::new(Stream::of(source), limits);
    while let Some(line) = lines.next()? {
        let start = usize::try_from(line.offset).unwrap_or(text.len());
        if keep {
            kept.push_str(text.get(from..start).unwrap_or_default());
        }
        (from, keep) = (start, !dropped.contains(&line.number));
    }
    if keep {
        kept.push_str(text.get(from..).unwrap_or_default());
    }
    Ok(Some(kept.into_bytes()))
}

/// The array is written anew, as float64.
pub(super) fn npy(source: &Source, limits: &Limits<'_>, changes: &mut Vec<String>) -> Result<Option<Vec<u8>>> {
    let Ok((table, _)) = array::table(source, limits, false) else { return Ok(None) };
    let (mut not_finite, mut doubled) = (Vec::new(), Vec::new());
    let mut kept: Vec<&[f64]> = Vec::new();
    for (index, row) in table.rows().enumerate() {
        if row.iter().any(|x| !x.is_finite()) {
            not_finite.push(index as u64);
        } else if kept.last() == Some(&row) {
            doubled.push(index as u64);
        } else {
            kept.push(row);
        }
    }
    if kept.is_empty() {
        return Ok(None);
    }
    tell(&not_finite, NOT_FINITE, "row", changes);
    tell(&doubled, DOUBLED, "row", changes);
    let mut out = Vec::new();
    let mut rows = format::by_name("npy")?.rows_counted(&mut out, None, kept.len() as u64)?;
    kept.into_iter().try_for_each(|row| rows.row(row))?;
    rows.finish()?;
    drop(rows);
    Ok(Some(out))
}

/// `[[x,y],…]` and `{"columns": …, "rows": [[x,y],…]}`.
pub(super) fn json(tree: &mut Json, changes: &mut Vec<String>) {
    let rows = match tree {
        Json::Object(_) => tree.get_mut("rows"),
        array => Some(array),
    };
    let Some(Json::Array(rows)) = rows else { return };
    let is_missing = |row: &Json| {
        let number = |item: &Json| matches!(item, Json::Null | Json::Number(_));
        matches!(row, Json::Array(items) if items.iter().all(number))
    };
    let (mut missing, mut doubled) = (Vec::new(), Vec::new());
    let mut kept: Vec<Json> = Vec::new();
    for (index, row) in core::mem::take(rows).into_iter().enumerate() {
        if is_missing(&row) {
            missing.push(index as u64);
        } else if matches!(row, Json::Numbers(_)) && kept.last() == Some(&row) {
            doubled.push(index as u64);
        } else {
            kept.push(row);
        }
    }
    *rows = kept.into();
    tell(&missing, "with null for a number", "row", changes);
    tell(&doubled, DOUBLED, "row", changes);
}
