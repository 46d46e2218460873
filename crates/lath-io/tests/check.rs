//! What `check` finds, where, and what `fix` mends.
#![allow(clippy::unwrap_used)]

use lath::error::Limits;
use lath_io::check::{self, Finding, Fixed, Report, Severity};
use lath_io::format;
use lath_io::source::Source;

fn source(name: &str, content: impl Into<Vec<u8>>) -> Source {
    Source::from_bytes(name, content)
}

fn report(name: &str, content: impl Into<Vec<u8>>) -> Report {
    check::check(&source(name, content), None, &Limits::default()).unwrap()
}

/// Codes with the place behind the name of the file.
fn found(name: &str, content: impl Into<Vec<u8>>) -> Vec<(&'static str, String)> {
    let place = |finding: &Finding| {
        assert!(!finding.message().is_empty() && finding.remedy().ends_with('.'), "{finding}");
        (finding.code(), finding.location().strip_prefix(name).unwrap().to_owned())
    };
    report(name, content).findings().iter().map(place).collect()
}

/// Findings about one shape whose members stand on line 2, by code and pointer below the shape.
fn of_shape(members: &str) -> Vec<(&'static str, String)> {
    let text = format!("{{\"lath\": 1, \"shapes\": [\n{{{members}}}]}}");
    let below = |(code, place): (&'static str, String)| {
        let pointer = place.split_once(" /shapes/0").unwrap().1;
        (code, pointer.to_owned())
    };
    found("a.json", text).into_iter().map(below).collect()
}

fn fix(name: &str, content: impl Into<Vec<u8>>) -> Fixed {
    check::fix(&source(name, content), None, &Limits::default()).unwrap()
}

#[track_caller]
fn assert_found(found: Vec<(&'static str, String)>, expected: &[(&str, &str)]) {
    let found: Vec<(&str, &str)> = found.iter().map(|(code, place)| (*code, place.as_str())).collect();
    assert_eq!(found, expected);
}

#[test]
fn every_row_of_a_table_is_looked_at() {
    let text = "t,x\n0,1\n0,2\n-1,abc\n-1,nan\n-1,3\n-1,3\n1,2,3\n1,,\n1e301,1e200\n";
    let expected = [
        ("W014", ":3"),
        ("F005", ":4:4"),
        ("P002", ":5:4"),
        ("W013", ":6"),
        ("W005", ":7"),
        ("W014", ":7"),
        ("P005", ":8:5"),
        ("F007", ":9:3"),
        ("P003", ":10"),
        ("W016", ":10"),
    ];
    assert_found(found("a.csv", text), &expected);
    assert_found(found("a.csv", "1,2\n1,2\n1,2\n"), &[("W006", ":2")]);
    assert_found(found("a.csv", "0,0\n1,2\n0,0\n"), &[("W009", ":3")]);
    assert_found(found("a.csv", "10000000.001,0\n10000000.002,1\n"), &[("W015", ":1")]);
    assert_found(found("a.csv", ""), &[("F001", "")]);
    assert_found(found("a.csv", "title\n"), &[("P001", "")]);
    assert_found(found("a.csv", "1,2\n\u{0}\n"), &[("F002", ":2:1")]);
    assert_found(found("a.csv", "x,y\n0,0\n1,2\n"), &[]);
}

#[test]
fn json_and_npy_tables_too() {
    assert_found(found("a.json", "[[0,0],\n[1,2],\n[1,2]]"), &[("W005", ":3:1 /2")]);
    assert_found(found("a.json", "{\"t\":[1,0],\"x\":[2,3]}"), &[("W013", " row 1")]);
    assert_found(found("a.json", "[[0,0],[1]]"), &[("P005", ":1:8 /1")]);
    assert_found(found("a.json", "[[0,0],"), &[("F010", ":1:7")]);
    assert_found(found("a.json", "{\"lath\":1,\"shapes\":[]}"), &[("W017", ":1:20 /shapes")]);
    assert_found(found("a.json", "{\"lath\":2,\"shapes\":[]}"), &[("F018", ":1:9 /lath")]);
    assert_found(found("a.svg", "<svg/>"), &[("F004", "")]);
    let mut bytes = Vec::new();
    let mut rows = format::by_name("npy").unwrap().rows(&mut bytes, None).unwrap();
    [[1.0, 2.0], [1.0, 2.0], [3.0, 4.0]].iter().for_each(|row| rows.row(row).unwrap());
    rows.finish().unwrap();
    drop(rows);
    let end = bytes.len();
    bytes[end - 8..].copy_from_slice(&f64::INFINITY.to_le_bytes());
    assert_found(found("a.npy", bytes.clone()), &[("P002", " row 2"), ("W005", " row 1")]);
    let fixed = fix("a.npy", bytes);
    assert_eq!(
        fixed.changes(),
        ["dropped 1 row with NaN or infinity: row 2", "dropped 1 row the same as the row before: row 1"]
    );
    assert_eq!(fixed.report().points(), Some(1));
}

#[test]
fn knots_are_looked_at_one_by_one() {
    let spline = |degree: usize, knots: &str, points: &str| {
        of_shape(&format!(r#""kind": "bspline", "degree": {degree}, "knots": [{knots}], "points": [{points}]"#))
    };
    assert_found(spline(2, "0,0,0,1,1,1", "0,1,0"), &[]);
    assert_found(spline(2, "0,0,1,1", "0,1,0"), &[("K001", "/knots")]);
    assert_found(spline(2, "0,0,0,1,1", "0,1,0"), &[("K001", "/knots")]);
    assert_found(spline(1, "0,2,1,3,2", "0,1,0"), &[("K004", "/knots/2"), ("K004", "/knots/4")]);
    assert_found(spline(1, "0,0,0,1,1", "0,1,0"), &[("K003", "/knots/2")]);
    assert_found(spline(1, "0,0,1,1", "0,1"), &[]);
    assert_found(spline(1, "0,1,1,2", "0,1"), &[("W004", "/knots/0"), ("K005", "/knots/1"), ("W004", "/knots/3")]);
    assert_found(
        spline(1, "0,0,1e301,1e302", "0,1").into_iter().filter(|f| f.0 == "K007").collect(),
        &[("K007", "/knots/2"), ("K007", "/knots/3")],
    );
    assert_found(spline(1, "0,0,1,1.0000000000001,2,2", "0,1,0,1"), &[("W001", "/knots/3")]);
    assert_found(spline(1, "0,0,1,1.0000001,2,2", "0,1,0,1"), &[("W002", "/knots/3")]);
    assert_found(spline(1, "0,0,1,1,2,2", "0,1,1,0"), &[("W003", "/knots/2"), ("W005", "/points/2")]);
    assert_found(of_shape(r#""kind": "bspline", "degree": 1, "points": [0,1]"#), &[("W004", "")]);
    let few =
        report("a.json", r#"{"lath":1,"shapes":[{"kind":"bspline","degree":2,"knots":[0,0,1,1],"points":[0,1,0]}]}"#);
    assert!(few.findings()[0].message().contains("openNURBS"));
    assert_eq!((few.errors(), few.warnings(), few.notes(), few.shapes(), few.points()), (1, 0, 0, Some(1), Some(3)));
    let closed = r#""kind": "bspline", "degree": 1, "closed": true, "knots": [0,1,2], "points": [0,1,0]"#;
    assert_found(of_shape(closed), &[("K001", "/knots"), ("W008", "/points/2")]);
}

#[test]
fn points_weights_and_parameters_are_looked_at() {
    let flat = r#""kind": "polyline", "points": [[1,1],[1,1]]"#;
    assert_found(of_shape(flat), &[("W006", "/points")]);
    let far = r#""kind": "polyline", "points": [[1e9,0],[1000000001,0]]"#;
    assert_found(of_shape(far), &[("W015", "/points")]);
    let large = r#""kind": "polyline", "points": [[1e200,0],[1e301,0],[0,1e302]]"#;
    assert_found(of_shape(large), &[("W016", "/points/0"), ("P003", "/points/1"), ("P003", "/points/2")]);
    let spline = |weights: &str| {
        of_shape(&format!(
            r#""kind": "bspline", "degree": 2, "knots": [0,0,0,1,1,1], "points": [[0,0],[1,1],[2,0]], "weights": [{weights}]"#
        ))
    };
    assert_found(spline("1,2,1"), &[]);
    assert_found(spline("1,2"), &[("R003", "/weights")]);
    assert_found(spline("1,-1e301,1"), &[("R002", "/weights/1")]);
    assert_found(spline("1,-0.5,1"), &[("W018", "/weights/1")]);
    assert_found(spline("1,0,1"), &[("W010", ""), ("W010", ""), ("W018", "/weights/1")]);
    assert_found(spline("1,-1,1"), &[("R004", "/weights"), ("W018", "/weights/1")]);
    assert_found(spline("0,1,1"), &[("R004", "/weights"), ("W018", "/weights/0")]);
    assert_found(spline("1,1e7,1"), &[("W019", "/weights")]);
    assert_found(of_shape(r#""kind": "polyline", "points": [0,1], "weights": [1,1]"#), &[("F016", "/weights")]);
    let hermite =
        r#""kind": "hermite", "parameters": [0,0,-1], "points": [[0],[1],[2]], "tangents": [[1],[1],[1e301]]"#;
    assert_found(of_shape(hermite), &[("T003", "/parameters/1"), ("T003", "/parameters/2"), ("P003", "/tangents/2")]);
    let power = r#""kind": "power", "breaks": [0,1e301], "coefficients": [[1]]"#;
    assert_found(of_shape(power), &[("T005", "/breaks/1")]);
    assert_found(of_shape(r#""kind": "nurbs""#), &[("F019", "/kind")]);
    let path = r#""kind": "path", "pieces": [{"kind": "polyline", "points": [[0,0],[0,0],[1,1]]}]"#;
    assert_found(of_shape(path), &[("W012", ""), ("W005", "/pieces/0/points/1")]);
}

#[test]
fn curves_are_looked_at() {
    let bezier = |points: &str| of_shape(&format!(r#""kind": "bezier", "points": [{points}]"#));
    assert_found(bezier("[0,0],[1,2],[3,2],[4,0]"), &[]);
    assert_found(bezier("[0,0],[0,0],[3,2],[4,0]"), &[("W010", ""), ("W005", "/points/1")]);
    assert_found(bezier("[0,0],[3,2],[4,0],[4,0]"), &[("W010", ""), ("W005", "/points/3")]);
    // A cusp at t = 1/2, and a line that doubles back at t = 1/2.
    assert_found(bezier("[0,0],[1,1],[0,1],[1,0]"), &[("W011", "")]);
    assert_found(bezier("[0,0],[1,1],[0,0]"), &[("W011", "")]);
    // A loop and an inflection have no cusp.
    assert_found(bezier("[0,0],[3,1],[-2,1],[1,0]"), &[]);
    assert_found(bezier("[0,0],[1,1],[2,-1],[3,0]"), &[]);
    // A function may stand still.
    assert_found(bezier("[0],[1],[0]"), &[]);
    let message = |points: &str| {
        let text = format!(r#"{{"lath":1,"shapes":[{{"kind":"bezier","points":[{points}]}}]}}"#);
        report("a.json", text).findings()[0].message().to_owned()
    };
    assert!(message("[0,0],[1,1],[0,1],[1,0]").starts_with("near t = 0.5"));
    let jump = r#""kind": "power", "breaks": [0,1,2], "coefficients": [[[0,0],[1,1]],[[2,2],[1,1]]]"#;
    assert_found(of_shape(jump), &[("W007", "")]);
    let path = r#""kind": "path", "pieces": [{"kind": "polyline", "points": [[0,0],[1,1]]}, {"kind": "polyline", "points": [[1,1.5],[2,0]]}]"#;
    assert_found(of_shape(path), &[("W007", "")]);
    let nearly = r#""kind": "polyline", "points": [[0,0],[1,0],[1,1],[0,1e-9]]"#;
    assert_found(of_shape(nearly), &[("W007", "")]);
}

#[test]
fn at_most_twenty_of_a_code_are_listed() {
    let report = report("a.csv", "x,y\n".to_owned() + &"0,0\n1,1\n1,1\n".repeat(50));
    assert_eq!(report.findings().len(), 21);
    assert_eq!(report.findings()[20].message(), "30 more: neighbouring points coincide");
}

#[test]
fn only_the_content_is_a_finding() {
    let limits = Limits { max_points: 1, ..Limits::default() };
    let error = check::check(&source("a.csv", "1,2\n3,4\n"), None, &limits).unwrap_err();
    assert_eq!(error.class().exit_code(), 5);
    let error = check::check(
        &source("a.json", "{\"lath\":1,\"shapes\":[{\"kind\":\"bezier\",\"points\":[0,1]}]}"),
        None,
        &limits,
    );
    assert_eq!(error.unwrap_err().class().exit_code(), 5);
}

#[test]
fn tables_are_mended() {
    let fixed = fix("a.csv", "x,y # names\r\n0,0\r\n1,nan\r\n# kept\r\n0,0\r\n2,2");
    assert_eq!(
        fixed.changes(),
        ["dropped 1 row with NaN or infinity: line 3", "dropped 1 row the same as the row before: line 5"]
    );
    assert_eq!(fixed.bytes(), b"x,y # names\r\n0,0\r\n# kept\r\n2,2");
    let fixed = fix("a.json", "{\"columns\": [\"x\"], \"rows\": [[1], [null], [2], [2]]}");
    assert_eq!(fixed.bytes(), b"{\n  \"columns\": [\n    \"x\"\n  ],\n  \"rows\": [\n    [1],\n    [2]\n  ]\n}\n");
    let good = "x,y\n0,0\n1,1\n";
    let fixed = fix("a.csv", good);
    assert!(fixed.changes().is_empty() && fixed.bytes() == good.as_bytes());
    let hopeless = fix("a.csv", "1,2\nx,3\n");
    assert_eq!((hopeless.changes().len(), hopeless.report().errors()), (0, 1));
}

/// The shape with these members, mended; what was changed; and how many errors are left.
fn mend(members: &str) -> (String, Vec<String>, usize) {
    let fixed = fix("a.json", format!("{{\"lath\": 1, \"shapes\": [{{{members}}}]}}"));
    (String::from_utf8(fixed.bytes().to_vec()).unwrap(), fixed.changes().to_vec(), fixed.report().errors())
}

#[test]
fn shapes_are_mended() {
    let cases = [
        (r#""kind": "bspline", "degree": 2, "knots": [0,0,1,1], "points": [0,1,0]"#, r#""knots": [0, 0, 0, 1, 1, 1]"#),
        (
            r#""kind": "bspline", "degree": 1, "knots": [0,0,0.30000000000000004,0.3,1,1], "points": [0,1,0,1]"#,
            r#""knots": [0, 0, 0.30000000000000004, 0.30000000000000004, 1, 1]"#,
        ),
        (r#""kind": "bspline", "degree": 1, "knots": [0,0,0,0,1,1,1], "points": [0,1]"#, r#""knots": [0, 0, 1, 1]"#),
        (
            r#""kind": "bspline", "degree": 1, "closed": true, "knots": [0,1,2], "points": [0,1,0], "weights": [2,1,2]"#,
            r#""weights": [2, 1]"#,
        ),
        (
            r#""kind": "bspline", "degree": 1, "closed": true, "knots": [0,1,2], "points": [[0],[1],[0]]"#,
            "\"points\": [\n        [0],\n        [1]\n      ]",
        ),
        (
            r#""kind": "hermite", "closed": true, "parameters": [0,1,2], "points": [0,1,0], "tangents": [1,0,1]"#,
            r#""tangents": [1, 0]"#,
        ),
        (
            r#""kind": "path", "pieces": [{"kind": "bspline", "degree": 1, "knots": [0,1], "points": [0,1]}]"#,
            r#""knots": [0, 0, 1, 1]"#,
        ),
    ];
    for (members, expected) in cases {
        let (text, changes, errors) = mend(members);
        assert!(text.contains(expected), "{text}");
        assert_eq!((changes.len(), errors), (1, 0), "{members}: {changes:?}");
    }
}

#[test]
fn what_is_not_safe_stays() {
    for members in [
        r#""kind": "bspline", "degree": 1, "knots": [0,1,0.5,2], "points": [0,1]"#,
        r#""kind": "bspline", "degree": 1, "knots": [0,0,0,1,1], "points": [0,1,2]"#,
        r#""kind": "bezier", "weights": [2,1,2], "points": [0,1]"#,
        r#""kind": "bezier", "weights": [0,0], "points": [0,1]"#,
        r#""kind": "bspline", "degree": 1, "closed": true, "knots": [0,1,2], "points": [0,1,0], "weights": [2,1,3]"#,
        r#""kind": "hermite", "closed": true, "parameters": [0,1,2], "points": [0,1,0], "tangents": [1,0,2]"#,
    ] {
        let (_, changes, errors) = mend(members);
        assert!(changes.is_empty() && errors > 0, "{members}: {changes:?}");
    }
    // Valid, though a closed curve repeats its first point: without it the curve would be another.
    let (_, changes, errors) = mend(r#""kind": "bspline", "degree": 2, "closed": true, "points": [0,1,0]"#);
    assert_eq!((changes.len(), errors), (0, 0));
}

#[test]
fn what_is_no_text_is_not_mended() {
    let source = Source::from_bytes("a.csv", &b"0,0\n1,1\n1,1\n2,\xff\n"[..]);
    let fixed = check::fix(&source, None, &Limits::default()).unwrap();
    assert!(fixed.changes().is_empty() && fixed.report().errors() > 0, "{:?}", fixed.changes());
    assert_eq!(fixed.bytes(), source.bytes());
}

#[test]
fn a_file_that_would_have_more_errors_afterwards_is_left_alone() {
    // Without its first row every other row would be of another length than the first one left.
    let text = "0,nan\n\"],\"rows\":[0024\n0\n0,5\n0.2,1\n0.5,2\n1,0\n";
    let source = Source::from_bytes("a.csv", text);
    let (before, fixed) = (report("a.csv", text), check::fix(&source, None, &Limits::default()).unwrap());
    assert!(fixed.report().errors() <= before.errors(), "{:?}", fixed.report().findings());
    assert!(fixed.changes().is_empty() && fixed.bytes() == source.bytes(), "{:?}", fixed.changes());
}

#[test]
fn mending_goes_on_until_nothing_is_left_to_mend() {
    // Without its first row the second one is the first, and of the length of the others.
    let source = Source::from_bytes("a.csv", "0,nan\ninf\n5\n6\n1,2\n");
    let fixed = check::fix(&source, None, &Limits::default()).unwrap();
    let dropped = "dropped 1 row with NaN or infinity: line 1";
    assert_eq!(fixed.changes(), [dropped.to_owned(), format!("then {dropped}")]);
    assert_eq!((fixed.bytes(), fixed.report().errors()), (&b"5\n6\n1,2\n"[..], 1));
    // A file that is not mended after many rounds is left alone.
    let steps = |last: &str| (1..40).map(|i| format!("{}{last}\n", "0,".repeat(40 - i))).collect::<String>();
    let source = Source::from_bytes("a.csv", steps("nan") + &steps("1"));
    let fixed = check::fix(&source, None, &Limits::default()).unwrap();
    assert!(fixed.changes().is_empty() && fixed.bytes() == source.bytes(), "{:?}", fixed.changes());
}

#[test]
fn reports_become_json() {
    let first = report("a.csv", "0,0\n\"a\"\"\\\",1\n");
    let text = check::to_json(&[&first, &report("b.csv", "1\n2\n")]);
    let json: serde_json::Value = serde_json::from_str(&text).unwrap();
    let findings = json["findings"].as_array().unwrap();
    assert_eq!(findings.len(), 1);
    assert_eq!((&findings[0]["code"], &findings[0]["severity"]), (&"F005".into(), &"error".into()));
    assert_eq!(findings[0]["where"], "a.csv:2:2");
    assert!(first.findings()[0].to_string().starts_with("a.csv:2:2: error F005: "));
}

#[test]
fn the_manual_lists_every_code() {
    let mut table = String::from("| code | severity | what | remedy |\n|---|---|---|---|\n");
    for entry in check::codes() {
        table += &format!("| {} | {} | {} | {} |\n", entry.code, entry.severity, entry.summary, entry.remedy);
    }
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/CHECK.md");
    let manual = std::fs::read_to_string(path).unwrap();
    assert!(manual.contains(&table), "docs/CHECK.md must contain this table:\n{table}");
    assert!(check::codes().any(|entry| entry.severity == Severity::Note));
}
