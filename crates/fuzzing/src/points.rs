//! Files of points: every reader, every writer, checking and mending.

use crate::small;
use lath::error::Limits;
use lath_io::Error;
use lath_io::check::{self, Severity};
use lath_io::format::{self, Content, FORMATS, Format};
use lath_io::points::PointTable;
use lath_io::source::Source;

/// What messages call the source; without an extension, so that content decides.
const NAME: &str = "any";

/// The target: the first byte chooses the format to read as and the columns, the rest is the file.
pub fn run(bytes: &[u8]) {
    let Some((options, file)) = bytes.split_first() else { return };
    let (limits, source) = (small(), Source::from_bytes(NAME, file));
    let from = FORMATS.get(usize::from(options & 7));
    match format::read(&source, from, &limits) {
        Ok(Content::Points(table)) => {
            whole(&table);
            for format in FORMATS.iter().filter(|format| format.holds_points()) {
                returns(&table, format);
            }
            chosen(&source, from, &table, &limits);
        }
        Ok(Content::Shapes(shapes)) => crate::shapes::returns(&shapes),
        Err(error) => shown(&error),
    }
    let columns: &[&str] = [&["x"][..], &["1", "0"], &["y", "x", "y"], &["x", "1"]][usize::from(options >> 3 & 3)];
    match format::read_columns(&source, from, columns, &limits) {
        Ok(table) => {
            whole(&table);
            assert_eq!(table.width(), columns.len());
        }
        Err(error) => shown(&error),
    }
    checked(&source, from, &limits);
}

/// What is promised of a table.
fn whole(table: &PointTable) {
    assert!(!table.is_empty() && table.width() > 0 && table.len() * table.width() == table.values().len());
    assert!(table.values().iter().all(|x| x.is_finite()), "{:?}", table.values());
    assert!(table.columns().is_none_or(|names| names.len() == table.width()));
}

/// What is written reads back with the same bits.
fn returns(table: &PointTable, format: &'static Format) {
    let mut bytes = Vec::new();
    let written = format.rows_counted(&mut bytes, table.columns(), table.len() as u64).and_then(|mut rows| {
        table.rows().try_for_each(|row| rows.row(row))?;
        rows.finish()
    });
    assert!(written.is_ok(), "{}: {written:?}", format.name);
    let again = format::read_points(&Source::from_bytes(NAME, bytes.clone()), Some(format), &Limits::default());
    let text = String::from_utf8_lossy(&bytes);
    match again {
        Ok(again) => {
            assert_eq!((again.len(), again.width()), (table.len(), table.width()), "{}: {text}", format.name);
            let same = again.values().iter().zip(table.values()).all(|(a, b)| a.to_bits() == b.to_bits());
            assert!(same, "{}: {text}", format.name);
        }
        Err(error) => panic!("{}: {error}: {text}", format.name),
    }
}

/// A column by its index is the column of the whole table, unless one has that name.
fn chosen(source: &Source, from: Option<&'static Format>, table: &PointTable, limits: &Limits<'_>) {
    let last = (table.width() - 1).to_string();
    if table.columns().is_some_and(|names| names.contains(&last)) {
        return;
    }
    match format::read_columns(source, from, &[&last], limits) {
        Ok(column) => {
            let wanted = table.rows().map(|row| row[row.len() - 1].to_bits());
            let found = column.values().iter().map(|x| x.to_bits());
            assert!(wanted.eq(found), "column {last}: {:?}", column.values());
        }
        Err(error) => panic!("column {last}: {error}"),
    }
    let _ = table.clone().split_parameter(&last);
}

/// Checking agrees with reading; mending ends, and leaves no more errors than there were.
pub(crate) fn checked(source: &Source, from: Option<&'static Format>, limits: &Limits<'_>) {
    let report = match check::check(source, from, limits) {
        Ok(report) => report,
        Err(error) => return assert_eq!(error.class().exit_code(), 5, "{error}"),
    };
    for finding in report.findings() {
        assert!(finding.location().starts_with(NAME) && !finding.message().is_empty(), "{finding}");
        assert!(finding.remedy().ends_with('.'), "{finding}");
    }
    let error = |finding: &check::Finding| finding.severity() == Severity::Error;
    match format::read(source, from, limits) {
        // What overflows inside a curve is found by looking at the curve.
        Ok(_) => assert!(report.findings().iter().all(|f| !error(f) || f.code() == "P003"), "{:?}", report.findings()),
        Err(refused) if refused.class().exit_code() == 3 => assert!(report.errors() > 0, "{refused}"),
        Err(_) => {}
    }
    let json: Result<serde_json::Value, _> = serde_json::from_str(&check::to_json(&[&report]));
    assert!(json.is_ok(), "{json:?}");
    let Ok(fixed) = check::fix(source, from, limits) else { return };
    assert!(fixed.report().errors() <= report.errors(), "{:?}", fixed.changes());
    let mended = Source::from_bytes(NAME, fixed.bytes());
    match check::fix(&mended, from, &Limits::default()) {
        Ok(again) => assert!(again.changes().is_empty(), "{:?} then {:?}", fixed.changes(), again.changes()),
        Err(error) => panic!("{error}"),
    }
}

/// What is promised of every refusal.
pub(crate) fn shown(error: &Error) {
    let place = error.place();
    assert_eq!(place.source.as_deref(), Some(NAME), "{error}");
    assert!(!error.message().is_empty() && error.remedy().ends_with('.'), "{error}");
    assert!(place.line != Some(0) && place.column != Some(0), "{error}");
    assert!(error.excerpt().is_none_or(|line| !line.contains(['\n', '\r']) && line.chars().count() <= 120), "{error}");
    assert!([3, 5].contains(&error.class().exit_code()), "{error}");
}
