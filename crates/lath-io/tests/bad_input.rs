//! The inputs that break spline code, through the readers and `check`: those rows of `testdata/bad-inputs.toml` that only files
//! can hold, and the warnings about what is valid.
#![allow(clippy::unwrap_used, clippy::panic)] // a failing unwrap is a failing test

use lath::error::Limits;
use lath_io::check;
use lath_io::format;
use lath_io::points::PointTable;
use lath_io::source::Source;
use lath_io::{Error, Result, atomic, shapes};

fn points(bytes: impl Into<Vec<u8>>) -> Result<PointTable> {
    format::read_points(&Source::from_bytes("a", bytes), None, &Limits::default())
}

/// An answer that must be refused with this code, at this line and column.
#[track_caller]
fn refused<T>(answer: Result<T>, code: &str, place: impl Into<Option<(u64, u64)>>) -> Error {
    let error = answer.map(|_| "read").unwrap_err();
    let found = error.place().line.zip(error.place().column);
    assert_eq!((error.code().as_str(), found), (code, place.into()), "{error}");
    assert!(!error.message().is_empty() && error.remedy().ends_with('.'), "{error}");
    error
}

fn document(members: &str) -> Source {
    Source::from_bytes("a.json", format!("{{\"lath\": 1, \"shapes\": [{{{members}}}]}}"))
}

/// The codes that `check` finds about a shape, or about points.
fn found(source: &Source) -> Vec<&'static str> {
    let report = check::check(source, None, &Limits::default()).unwrap();
    assert!(report.findings().iter().all(|finding| finding.remedy().ends_with('.')));
    report.findings().iter().map(check::Finding::code).collect()
}

#[test]
fn row_09_small_detail_far_from_zero() {
    assert_eq!(found(&Source::from_bytes("a.csv", "10000000.001,0\n10000000.002,1\n")), ["W015"]);
    assert_eq!(found(&Source::from_bytes("a.csv", "100.001,0\n100.002,1\n")), [""; 0]);
}

#[test]
fn row_10_integers_that_no_double_holds() {
    for integer in ["9007199254740993", "-9007199254740993", "18446744073709551615"] {
        let error = points(format!("[[0,0],[1,{integer}]]")).unwrap_err();
        assert_eq!((error.code().as_str(), error.place().line), ("F014", Some(1)), "{error}");
        assert!(error.message().contains(integer), "{error}");
    }
    let even = points("[[9007199254740994, -9007199254740992], [9.007199254740993e15, 0]]").unwrap();
    assert_eq!(even.values(), [9_007_199_254_740_994.0, -9_007_199_254_740_992.0, 9_007_199_254_740_992.0, 0.0]);
}

#[test]
fn row_12_other_notations() {
    refused(points("0;0\n1,5;2\n"), "F006", (2, 1));
    refused(points("0 0\n0x1p3 1\n"), "F006", (2, 1));
    refused(points("0 0\n1.0D+3 1\n"), "F006", (2, 1));
    refused(points("0,0\n1_000,1\n"), "F006", (2, 1));
    refused(points("0,0\n1e400,1\n"), "P003", (2, 1));
    refused(points("[[0,0],[1e400,1]]"), "P003", (1, 9));
    refused(points("[[0,0],[+1,1]]"), "F010", (1, 9));
    assert_eq!(points("+1,-0\n.5,5.\n1e-400,1E+2\n").unwrap().values(), [1.0, -0.0, 0.5, 5.0, 0.0, 100.0]);
}

#[test]
fn row_29_nearly_equal_knots() {
    let spline = r#""kind": "bspline", "degree": 1, "knots": [0,0,1,1.0000000000000002,2,2], "points": [0,1,0,1]"#;
    assert_eq!(found(&document(spline)), ["W001"]);
    assert_eq!(shapes::read(&document(spline), &Limits::default()).unwrap().len(), 1);
}

#[test]
fn row_30_spans_of_very_different_length() {
    let last = |end: &str| {
        let knots = format!("[0,0,1,{end},{end}]");
        found(&document(&format!(r#""kind": "bspline", "degree": 1, "knots": {knots}, "points": [0,1,0]"#)))
    };
    assert_eq!(last("1e9"), ["W002"]);
    // Still further apart, the two that are close look like one that was meant.
    assert_eq!(last("1e12"), ["W001"]);
    assert_eq!(last("1000"), [""; 0]);
}

#[test]
fn row_34_a_seam_that_nearly_meets() {
    assert_eq!(found(&document(r#""kind": "polyline", "points": [[0,0],[1,0],[1,1],[0,1e-9]]"#)), ["W007"]);
    assert_eq!(found(&document(r#""kind": "polyline", "points": [[0,0],[1,0],[1,1],[0,0]]"#)), [""; 0]);
    let closed =
        r#""kind": "path", "closed": true, "pieces": [{"kind": "polyline", "points": [[0,0],[1,0],[0,1e-9]]}]"#;
    refused(shapes::read(&document(closed), &Limits::default()), "C002", (1, 51));
}

#[test]
fn row_42_control_points_that_coincide_at_an_end() {
    let bezier = |points: &str| found(&document(&format!(r#""kind": "bezier", "points": [{points}]"#)));
    assert_eq!(bezier("[0,0],[0,0],[3,2],[4,0]"), ["W010", "W005"]);
    assert_eq!(bezier("[0,0],[0,0],[0,0],[4,0]"), ["W010", "W005", "W005"]);
}

#[test]
fn row_43_cusps_and_curves_that_double_back() {
    for points in ["[0,0],[1,1],[0,1],[1,0]", "[0,0],[1,0],[0,0]"] {
        assert_eq!(found(&document(&format!(r#""kind": "bezier", "points": [{points}]"#))), ["W011"]);
    }
    assert_eq!(found(&document(r#""kind": "bezier", "points": [[0,0],[1,2],[3,2],[4,0]]"#)), [""; 0]);
}

#[test]
fn row_57_weights_are_never_ignored() {
    let limits = Limits::default();
    let middle = |members: &str| {
        let shapes = shapes::read(&document(members), &limits).unwrap();
        let (curve, mut point) = (shapes[0].curve().unwrap(), [0.0]);
        let domain = curve.domain();
        curve.eval_into(0.5 * (domain.start + domain.end), lath::curve::Outside::Error, &mut point).unwrap();
        assert!(curve.is_rational());
        // What is written says the same.
        let again = shapes::read(&Source::from_bytes("a.json", shapes::to_string(&shapes).unwrap()), &limits).unwrap();
        assert_eq!(shapes::to_string(&again).unwrap(), shapes::to_string(&shapes).unwrap());
        point[0]
    };
    assert_eq!(middle(r#""kind": "bezier", "points": [0,1], "weights": [1,3]"#), 0.75);
    assert_eq!(middle(r#""kind": "bspline", "degree": 1, "points": [0,1,4], "weights": [1,3,3]"#), 1.0);
    assert_eq!(
        middle(r#""kind": "bspline", "degree": 1, "knots": [0,0,1,1], "points": [0,1], "weights": [1,3]"#),
        0.75
    );
    assert_eq!(
        middle(r#""kind": "bspline", "degree": 2, "closed": true, "points": [0,8,0,0], "weights": [1,3,1,1]"#),
        0.0
    );
    assert_eq!(middle(r#""kind": "path", "pieces": [{"kind": "bezier", "points": [0,1], "weights": [1,3]}]"#), 0.75);
    for other in [
        r#""kind": "hermite", "parameters": [0,1], "points": [0,1], "tangents": [0,1]"#,
        r#""kind": "polyline", "points": [0,1]"#,
        r#""kind": "power", "breaks": [0,1], "coefficients": [[1]]"#,
    ] {
        let error = shapes::read(&document(&format!("{other}, \"weights\": [1,1]")), &limits).unwrap_err();
        assert_eq!((error.code().as_str(), error.place().pointer.as_deref()), ("F016", Some("/shapes/0/weights")));
    }
}

#[test]
fn row_66_files_that_are_cut_or_garbled() {
    refused(points(""), "F001", None);
    refused(points("\u{feff}"), "F001", None);
    refused(points("0,0\n1,\0\n"), "F002", (2, 3));
    refused(points(b"0,0\n1,\xff\n"), "F003", (2, 3));
    refused(points(b"\xff\xfe0\x00"), "F003", None);
    refused(points("[[0,0],[1,1]"), "F010", (1, 12));
    refused(points("0,0\n\"1,2\n"), "F008", (2, 1));
    refused(points("<svg/>"), "F004", None);
    refused(points("PK\u{3}\u{4}"), "F004", None);
    // A mark of the encoding and any end of line are no fault.
    assert_eq!(points("\u{feff}0,1\r\n2,3\r\n").unwrap().values(), [0.0, 1.0, 2.0, 3.0]);
    assert_eq!(points("0 1\r2 3").unwrap().values(), [0.0, 1.0, 2.0, 3.0]);
    // An endless file is given up at the budget, whatever its name says.
    let limits = Limits { max_bytes: 1000, ..Limits::default() };
    let error = Source::reader("endless", std::io::repeat(b'1'), &limits).unwrap_err();
    assert_eq!((error.code().as_str(), error.class().exit_code()), ("B001", 5));
}

#[test]
fn row_67_json_made_to_break_parsers() {
    let deep = 1_000_000;
    for open in ["[", "{\"a\":", "[[0,0],"] {
        assert_eq!(points(open.repeat(deep)).unwrap_err().code().as_str(), "F012");
    }
    refused(points(format!("{}{}", "[".repeat(deep), "]".repeat(deep))), "F012", (1, 33));
    assert_eq!(points("{\"x\":[1],\"x\":[2]}").unwrap_err().code().as_str(), "F013");
    refused(points("[[0,0],[1,1]] x"), "F011", (1, 15));
    refused(points("[[0,0],[1,1]][]"), "F011", (1, 14));
    assert_eq!(points(format!("[[0,1{}]]", "0".repeat(400))).unwrap_err().code().as_str(), "P003");
    assert_eq!(points(format!("[[0,0.{}1]]", "0".repeat(400))).unwrap().values(), [0.0, 0.0]);
}

/// An `.npy` file of version 1 with this shape and that many bytes of numbers.
fn npy(shape: &str, bytes: usize) -> Vec<u8> {
    let header = format!("{{'descr': '<f8', 'fortran_order': False, 'shape': {shape}, }}\n");
    let length = u16::try_from(header.len()).unwrap().to_le_bytes();
    [b"\x93NUMPY\x01\x00", &length[..], header.as_bytes(), &vec![0; bytes]].concat()
}

#[test]
fn row_69_counts_beyond_the_data() {
    assert_eq!(points(npy("(2, 2)", 32)).unwrap().len(), 2);
    for (shape, bytes) in [("(2, 2)", 31), ("(2, 2)", 0), ("(1000000, 3)", 8), ("(1125899906842624, 2)", 16)] {
        let error = points(npy(shape, bytes)).unwrap_err();
        assert!(["F025", "B001"].contains(&error.code().as_str()), "{shape}: {error}");
    }
    // Products beyond 2⁶⁴, and a header longer than the file.
    for shape in ["(18446744073709551615, 2)", "(9223372036854775808, 2)", "(4294967296, 4294967296)", "(-1, 2)"] {
        let error = points(npy(shape, 16)).unwrap_err();
        assert!(["F025", "B001", "P006"].contains(&error.code().as_str()), "{shape}: {error}");
    }
    refused(points(b"\x93NUMPY\x02\x00\xff\xff\xff\xff{".to_vec()), "F025", None);
}

#[test]
fn row_74_paths_that_cannot_be_written() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    refused(atomic::write_bytes(folder.path(), b"new"), "I003", None);
    refused(atomic::write_bytes(at("no/such/file"), b"new"), "I001", None);
    std::fs::write(at("old"), "old").unwrap();
    // Whatever fails half-way leaves the old file, and nothing beside it.
    let failing = atomic::write(at("old"), |out| {
        out.write_all(b"half of the new").map_err(|error| Error::writing(&error))?;
        Err(Error::writing(&std::io::Error::other("the disk is full")))
    });
    refused(failing, "I005", None);
    assert_eq!(std::fs::read(at("old")).unwrap(), b"old");
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1);
    let mut locked = std::fs::metadata(at("old")).unwrap().permissions();
    locked.set_readonly(true);
    std::fs::set_permissions(at("old"), locked).unwrap();
    refused(atomic::write_bytes(at("old"), b"new"), "I002", None);
    assert_eq!(std::fs::read(at("old")).unwrap(), b"old");
    // A link stays one, and what it leads to is replaced.
    #[cfg(unix)]
    {
        std::fs::write(at("target"), "old").unwrap();
        std::os::unix::fs::symlink("target", at("link")).unwrap();
        atomic::write_bytes(at("link"), b"new").unwrap();
        assert!(std::fs::symlink_metadata(at("link")).unwrap().is_symlink());
        assert_eq!(std::fs::read(at("target")).unwrap(), b"new");
        std::os::unix::fs::symlink("round", at("round")).unwrap();
        assert!(atomic::write_bytes(at("round"), b"new").is_err());
    }
}
