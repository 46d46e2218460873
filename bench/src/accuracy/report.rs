//! The tables, in Markdown.

use super::input::Family;
use super::oracle::ORDERS;
use super::tally::{Record, Tally};
use super::{Who, bound};

const TITLES: [&str; ORDERS] = ["Values", "First derivatives", "Second derivatives"];

/// A table for values and for each derivative: in each cell the largest and the mean E.
pub(crate) fn markdown(record: &Record, who: &[Who], degrees: &[usize]) -> String {
    let mut out = String::new();
    for (order, title) in TITLES.iter().enumerate() {
        let mut rows = vec![["degree", "knots", "bound"].map(str::to_owned).to_vec()];
        rows[0].extend(who.iter().map(|who| who.name.clone()));
        for &degree in degrees {
            for family in Family::ALL {
                let mut row = vec![degree.to_string(), family.name().to_owned(), bound(degree, order).to_string()];
                let tallies = record.joined(degree, family, who.len());
                row.extend(who.iter().zip(tallies).map(|(who, tallies)| cell(who, order, &tallies[order])));
                rows.push(row);
            }
        }
        out += &format!("\n### {title}\n\n{}", layout(&rows));
    }
    out
}

/// Largest / mean, and what is missing.
fn cell(who: &Who, order: usize, tally: &Tally) -> String {
    if order >= who.orders {
        return "—".to_owned();
    }
    let asked = tally.answers + tally.none + tally.refused;
    let mut cell = match (tally.answers, asked) {
        (_, 0) => return "not asked".to_owned(),
        (0, _) if tally.refused == asked => return "refused".to_owned(),
        (0, _) => return "no number".to_owned(),
        (answers, _) => format!("{} / {}", short(tally.largest), short(tally.sum / answers as f64)),
    };
    let mut missing = |count: u64, what: &str| {
        if count > 0 {
            cell += &format!(", {} {what}", share(count, asked));
        }
    };
    missing(tally.refused, "refused");
    missing(tally.none, "no number");
    cell
}

fn short(x: f64) -> String {
    if x < 1e-3 && x > 0.0 || x >= 1e4 {
        format!("{x:.0e}")
    } else if x < 1.0 {
        format!("{x:.2}")
    } else if x < 100.0 {
        format!("{x:.1}")
    } else {
        format!("{x:.0}")
    }
}

/// A part of the whole, rounded, but never to nothing nor to everything.
fn share(part: u64, whole: u64) -> String {
    let percent = 100.0 * part as f64 / whole as f64;
    if percent < 0.1 { format!("{part} of {whole}") } else { format!("{percent:.1} %") }
}

/// Padded cells, the first two to the left, and the rule below the head.
fn layout(rows: &[Vec<String>]) -> String {
    let width = |column: usize| rows.iter().map(|row| row[column].chars().count()).max().unwrap_or(0);
    let mut out = String::new();
    for (place, row) in rows.iter().enumerate() {
        for (column, cell) in row.iter().enumerate() {
            let width = width(column);
            out += &if column == 1 { format!("| {cell:<width$} ") } else { format!("| {cell:>width$} ") };
        }
        out += "|\n";
        if place == 0 {
            for column in 0..row.len() {
                out += &format!("|{}{}", "-".repeat(width(column) + 1), if column == 1 { '-' } else { ':' });
            }
            out += "|\n";
        }
    }
    out
}
