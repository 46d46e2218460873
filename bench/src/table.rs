//! The table, in Markdown.

use crate::comparison::{Comparison, Outcome};
use std::time::Duration;

const HEAD: [&str; 8] =
    ["workload", "who", "least", "median", "ns a point", "peak bytes a point", "÷ lath", "differs by"];

/// All comparisons, one row for each contender; `÷ lath` is its least time over lath's.
pub(crate) fn markdown(all: &[Comparison]) -> String {
    let mut rows = vec![HEAD.map(str::to_owned)];
    for comparison in all {
        let ours = comparison.rows.first().and_then(|row| match &row.outcome {
            Outcome::Timed { times, .. } => Some(times.least.as_secs_f64()),
            _ => None,
        });
        for (place, row) in comparison.rows.iter().enumerate() {
            let workload = if place == 0 { comparison.workload.clone() } else { String::new() };
            let none = || "–".to_owned();
            let n = comparison.points as f64;
            let cells = match &row.outcome {
                Outcome::Timed { times, peak, difference } => {
                    let least = times.least.as_secs_f64();
                    [
                        milliseconds(times.least),
                        milliseconds(times.median),
                        format!("{:.1}", least * 1e9 / n),
                        peak.map_or_else(none, |bytes| memory(bytes, n)),
                        ours.map_or_else(none, |ours| format!("{:.2}", least / ours)),
                        difference.map_or_else(none, |difference| format!("{difference:.0e}")),
                    ]
                }
                Outcome::Differs(by) => ["differs".to_owned(), none(), none(), none(), none(), format!("**{by:.0e}**")],
                Outcome::Failed(reason) => [format!("failed: {reason}"), none(), none(), none(), none(), none()],
            };
            let [least, median, each, peak, ratio, difference] = cells;
            rows.push([workload, row.name.to_owned(), least, median, each, peak, ratio, difference]);
        }
    }
    layout(&rows)
}

fn milliseconds(time: Duration) -> String {
    let ms = time.as_secs_f64() * 1e3;
    if ms < 10.0 { format!("{ms:.3} ms") } else { format!("{ms:.1} ms") }
}

/// Bytes a point; where that is less than one, the bytes themselves.
fn memory(bytes: usize, n: f64) -> String {
    let each = bytes as f64 / n;
    if each < 1.0 { format!("{bytes} in all") } else { format!("{each:.0}") }
}

/// Padded cells, numbers to the right, and the rule below the head.
fn layout(rows: &[[String; HEAD.len()]]) -> String {
    let width = |column: usize| rows.iter().map(|row| row[column].chars().count()).max().unwrap_or(0);
    let widths: [usize; HEAD.len()] = std::array::from_fn(width);
    let mut out = String::new();
    for (place, row) in rows.iter().enumerate() {
        for (column, (cell, width)) in row.iter().zip(widths).enumerate() {
            out += &if column < 2 { format!("| {cell:<width$} ") } else { format!("| {cell:>width$} ") };
        }
        out += "|\n";
        if place == 0 {
            for (column, width) in widths.into_iter().enumerate() {
                let end = if column < 2 { '-' } else { ':' };
                out += &format!("|{}{end}", "-".repeat(width + 1));
            }
            out += "|\n";
        }
    }
    out
}
