//! Whatever the bytes are: a value or an error, never a panic, and errors that can be shown.
#![allow(clippy::unwrap_used, clippy::panic)] // a failing unwrap is a failing test

use lath::error::Limits;
use lath_io::check::{self, Severity};
use lath_io::format::{self, Content, FORMATS, Format, Opened};
use lath_io::points::PointTable;
use lath_io::source::Source;
use lath_io::stream::Stream;
use lath_io::{Class, Error, points, shapes};
use proptest::prelude::*;

/// Reads the bytes in every way there is, and checks what holds for every answer.
fn read_all_ways(bytes: &[u8]) {
    let limits = Limits { max_points: 1000, max_bytes: 100_000, cancel: None };
    let source = Source::from_bytes("any", bytes);
    for format in FORMATS.iter().map(Some).chain([None]) {
        match format::read(&source, format, &limits) {
            Ok(Content::Points(table)) => {
                assert!(!table.is_empty() && table.len() * table.width() == table.values().len());
                assert!(table.values().iter().all(|x| x.is_finite()));
                assert!(table.columns().is_none_or(|names| names.len() == table.width()));
                let _ = table.take_columns(&["0", "x"]);
                let _ = table.split_parameter("0");
                let same = |(a, b): (&f64, &[f64])| a.to_bits() == b[0].to_bits();
                let named = table.columns().is_some_and(|names| names.iter().any(|name| name == "0"));
                match format::read_columns(&source, format, &["0"], &limits) {
                    // Where words may stand beside it, a title that begins with a number is a row, of another length.
                    Err(error) => assert!(error.code().as_str() == "P005" && table.title().is_some(), "{error}"),
                    Ok(chosen) if chosen.len() == table.len() => {
                        assert!(named || chosen.values().iter().zip(table.rows()).all(same));
                    }
                    Ok(chosen) => assert!(chosen.len() == table.len() + 1 && table.title().is_some()),
                }
                rows_are_those_of(&table, bytes, format, &limits);
            }
            Ok(Content::Shapes(read)) => {
                let text = shapes::to_string(&read).unwrap();
                let again = shapes::read(&Source::from_bytes("again", text.as_str()), &Limits::default()).unwrap();
                assert_eq!(shapes::to_string(&again).unwrap(), text);
            }
            Err(error) => {
                can_be_shown(&error);
                // A stream has no budget of bytes.
                if error.class() == Class::Invalid {
                    stream_stops_as(&error, bytes, format, &limits);
                }
            }
        }
    }
    for columns in [&["0"][..], &["x", "1"], &["a"], &[]] {
        let _ = format::read_columns(&source, None, columns, &limits).map_err(|error| can_be_shown(&error));
    }
    check_all_ways(&source, &limits);
    let _ = points::json::read(&source, &limits).map_err(|error| can_be_shown(&error));
    let _ = shapes::read(&source, &limits).map_err(|error| can_be_shown(&error));
}

/// The stream, read from a pipe twice, has the rows of the table.
fn rows_are_those_of(table: &PointTable, bytes: &[u8], format: Option<&'static Format>, limits: &Limits<'_>) {
    let Ok(Opened::Rows(mut rows)) = format::open(Stream::pipe("any", bytes), format, None, limits) else {
        panic!("a table of {} rows is no stream", table.len());
    };
    for _ in 0..2 {
        for row in table.rows() {
            assert!(rows.next_row().unwrap().unwrap().iter().zip(row).all(|(a, b)| a.to_bits() == b.to_bits()));
        }
        assert_eq!(rows.next_row().unwrap(), None);
        assert_eq!(rows.columns(), table.columns());
        rows.rewind().unwrap();
    }
}

/// The stream stops at the same fault as the table.
fn stream_stops_as(error: &Error, bytes: &[u8], format: Option<&'static Format>, limits: &Limits<'_>) {
    let stopped = match format::open(Stream::pipe("any", bytes), format, None, limits) {
        Ok(Opened::Rows(mut rows)) => loop {
            match rows.next_row() {
                Ok(Some(_)) => {}
                Ok(None) => panic!("a stream without fault, but: {error}"),
                Err(stopped) => break stopped,
            }
        },
        Ok(Opened::Shapes(shapes)) => panic!("{} shapes, but: {error}", shapes.len()),
        Err(stopped) => stopped,
    };
    assert_eq!(stopped.to_string(), error.to_string());
}

/// Checks and mends: what is mended once needs no more mending, and the readers agree with the report.
fn check_all_ways(source: &Source, limits: &Limits<'_>) {
    let report = match check::check(source, None, limits) {
        Ok(report) => report,
        Err(error) => return assert_eq!(error.class().exit_code(), 5),
    };
    for finding in report.findings() {
        assert!(finding.location().starts_with("any") && !finding.message().is_empty(), "{finding}");
        assert!(finding.remedy().ends_with('.'), "{finding}");
    }
    match format::read(source, None, limits) {
        Ok(_) => assert!(report.findings().iter().all(|f| f.severity() != Severity::Error || f.code() == "P003")),
        Err(error) if error.class().exit_code() == 3 => assert!(report.errors() > 0, "{error}"),
        Err(_) => {}
    }
    if let Ok(fixed) = check::fix(source, None, limits) {
        let mended = Source::from_bytes("any", fixed.bytes());
        let again = check::fix(&mended, None, &Limits::default()).unwrap();
        assert!(again.changes().is_empty(), "{:?} then {:?}", fixed.changes(), again.changes());
        assert!(fixed.report().errors() <= report.errors(), "{:?}", fixed.changes());
    }
}

fn can_be_shown(error: &Error) {
    assert_eq!(error.place().source.as_deref(), Some("any"), "{error}");
    assert!(!error.message().is_empty() && error.remedy().ends_with('.'), "{error}");
    assert!(error.place().line.is_none_or(|line| line > 0) && error.place().column.is_none_or(|column| column > 0));
    assert!(error.excerpt().is_none_or(|line| !line.contains(['\n', '\r']) && line.chars().count() <= 120));
    assert!([3, 5].contains(&error.class().exit_code()));
}

/// Lath JSON with one place changed.
fn nearly_shapes() -> impl Strategy<Value = Vec<u8>> {
    let documents = [
        r#"{"lath":1,"shapes":[{"kind":"bezier","points":[[0,0],[1,2],[2,0]],"domain":[0,2]}]}"#,
        r#"{"lath":1,"shapes":[{"kind":"bspline","degree":2,"knots":[0,0,0,1,1,1],"points":[[0],[1],[2]]}]}"#,
        r#"{"lath":1,"shapes":[{"kind":"bspline","degree":3,"closed":true,"points":[[0,1],[1,2],[2,3]]}]}"#,
        r#"{"lath":1,"shapes":[{"kind":"hermite","parameters":[0,1],"points":[[0],[1]],"tangents":[[1],[1]]}]}"#,
        r#"{"lath":1,"shapes":[{"kind":"polyline","name":"n","points":[[0,0,0],[1,1,1]]}]}"#,
        r#"{"lath":1,"shapes":[{"kind":"power","breaks":[0,1,2],"coefficients":[[[0],[1]],[[2],[3]]]}]}"#,
        r#"{"lath":1,"shapes":[{"kind":"path","closed":true,"pieces":[{"kind":"polyline","points":[0,1,0]}]}]}"#,
        r#"{"lath":1,"shapes":[{"kind":"quintic-hermite","parameters":[0,1],"points":[0,1],"tangents":[1,1],"seconds":[0,0]}]}"#,
        r#"{"lath":1,"shapes":[{"kind":"bspline","degree":2,"knots":[0,0,1,1],"points":[[0,0],[1,1],[1,1]],"weights":[2,2,2]}]}"#,
        r#"{"lath":1,"shapes":[{"kind":"hermite","closed":true,"parameters":[0,1,2],"points":[0,1,0],"tangents":[1,1,1]}]}"#,
        r#"{"columns":["t","x"],"rows":[[0,1],[0,1],[null,2],[3,1e200]]}"#,
        r#"{"t":[0,0,0,1,1,1],"c":[0,1,2,0,0,0],"k":2}"#,
        r#"{"shape":{"type":"curve","count":1,"data":[{"rational":false,"dimension":1,"degree":1,"knotvector":[0,0,1,1],"control_points":{"points":[[0],[1]]},"delta":0.1}]}}"#,
    ];
    let piece = prop_oneof![
        Just("".to_owned()),
        "[\\[\\]{}\",:.eE0-9+-]{1,3}",
        Just("null".to_owned()),
        Just("[]".to_owned()),
        Just("1e308".to_owned()),
        Just("9e999".to_owned()),
        Just("1e15".to_owned()),
        Just("true".to_owned()),
        Just("\"points\"".to_owned()),
    ];
    (prop::sample::select(documents.to_vec()), 0..180_usize, 0..6_usize, piece).prop_map(|(text, at, length, piece)| {
        let at = at.min(text.len());
        let end = (at + length).min(text.len());
        [&text[..at], &piece, &text[end..]].concat().into_bytes()
    })
}

/// An .npy file with bytes changed, and cut off or lengthened.
fn nearly_npy() -> impl Strategy<Value = Vec<u8>> {
    let mut whole = Vec::new();
    let mut rows = format::by_name("npy").unwrap().rows(&mut whole, None).unwrap();
    rows.row(&[1.0, 2.0]).unwrap();
    rows.row(&[3.0, 4.0]).unwrap();
    rows.finish().unwrap();
    drop(rows);
    let change = (0..whole.len(), prop_oneof![any::<u8>(), prop::sample::select(b"0192(),'<>fiu8 T".to_vec())]);
    (prop::collection::vec(change, 0..4), 0..200_usize).prop_map(move |(changes, length)| {
        let mut bytes = whole.clone();
        changes.into_iter().for_each(|(at, byte)| bytes[at] = byte);
        if length < 180 {
            bytes.resize(length.max(bytes.len() - 20), 0);
        }
        bytes
    })
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn any_bytes(bytes in prop::collection::vec(any::<u8>(), 0..300)) {
        read_all_ways(&bytes);
    }

    #[test]
    fn nearly_tables(text in "[0-9,;.\t\r\n \"#eExX+a\u{e9}\u{feff}\u{2212}-]{0,120}") {
        read_all_ways(text.as_bytes());
    }

    #[test]
    fn nearly_json(text in "[\\[\\]{},:\"\\\\ \n0-9.eE+a-]{0,80}") {
        read_all_ways(text.as_bytes());
    }

    #[test]
    fn changed_shapes(bytes in nearly_shapes()) {
        read_all_ways(&bytes);
    }

    #[test]
    fn changed_npy(bytes in nearly_npy()) {
        read_all_ways(&bytes);
    }

    #[test]
    fn any_number_reads_back(bits in any::<u64>()) {
        let x = f64::from_bits(bits);
        prop_assume!(x.is_finite());
        for format in FORMATS.iter().filter(|format| format.holds_points()) {
            let mut out = Vec::new();
            let mut rows = format.rows(&mut out, None).unwrap();
            rows.row(&[x, -x]).unwrap();
            rows.finish().unwrap();
            drop(rows);
            let table = format::read_points(&Source::from_bytes("any", out), Some(format), &Limits::default()).unwrap();
            prop_assert_eq!(table.values()[0].to_bits(), x.to_bits());
            prop_assert_eq!(table.values()[1].to_bits(), (-x).to_bits());
        }
    }
}
