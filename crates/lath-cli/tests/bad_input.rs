//! Bad points, files and shapes: exit 3 with code, culprit and remedy, nothing on standard output, never a panic.
#![allow(clippy::unwrap_used, clippy::panic)] // a failing unwrap is a failing test

mod tool;

use tool::lath_from;

#[test]
fn bad_points_are_named() {
    for (points, words) in [
        ("", &["F001"][..]),
        ("\n\n", &["F001"]),
        ("# nothing\n", &["P001"]),
        ("x,y\n", &["P001"]),
        ("0,0\nnan,1\n", &["standard input:2:1", "P002", "nan"]),
        ("0,0\n1,NaN\n", &["standard input:2:3", "P002", "NaN"]),
        ("0,0\n1,inf\n", &["standard input:2:3", "P002", "inf"]),
        ("0,0\n-Infinity,1\n", &["standard input:2:1", "P002"]),
        ("0,0\n1,1e400\n", &["standard input:2:3", "P003", "1e400"]),
        ("0,0\n1,1e305\n2,0\n", &["P003", "standard input:2"]),
        ("0,0\n1,2,3\n", &["standard input:2:5", "P005", "3 numbers"]),
        ("0,0,0\n1,2\n", &["standard input:2", "P005", "2 numbers"]),
        ("0,0\n1,\n2,2\n", &["standard input:2"]),
        ("0,0\n,1\n2,2\n", &["standard input:2:1", "F007"]),
        ("0,0\n1,abc\n", &["standard input:2:3", "F005", "abc"]),
        ("0;0\n1,5;2\n", &["standard input:2:1", "F006", "decimal comma"]),
        ("0 0\n0x10 1\n", &["standard input:2:1", "F006"]),
        ("0 0\n1.0D+3 1\n", &["standard input:2:1", "F006"]),
        ("0,0\n\"1,2\n", &["standard input:2:1", "F008"]),
        ("0,0\n1,\u{0}\n", &["standard input:2", "F002"]),
        ("[[0,0],[1]]", &["standard input:1:8", "P005"]),
        ("[[0,0],[1,null]]", &["F017"]),
        ("[[0,0],[1,9007199254740993]]", &["F014"]),
        ("[[0,0],[1,1]", &["F010"]),
        ("[]", &["P001"]),
        ("[[]]", &["P006"]),
        ("{\"lath\":1,\"shapes\":[]}", &["F021"]),
        ("1,2\n", &["P001", "not 1"]),
        ("0,0\n1,1\n1,1\n2,0\n", &["standard input:3", "P004", "points 1 and 2", "index 2"]),
    ] {
        lath_from(points, ["through", "-"]).fails(3, words);
        lath_from(points, ["through", "-", "--params", "chord"]).fails(3, words);
    }
    lath_from(b"0,0\n1,\xff\n", ["through", "-"]).fails(3, &["standard input:2:3", "F003"]);
    lath_from(b"\xff\xfe0\x00", ["through", "-"]).fails(3, &["F003", "UTF-16"]);
    // Closing and parameters.
    lath_from("0,0\n1,0\n1,1\n0,0\n0,0\n", ["through", "-", "--closed"]).fails(3, &["P004"]);
    lath_from("0,0\n0,0\n", ["through", "-", "--closed"]).fails(3, &["P001"]);
    lath_from("t,x\n0,1\n1,2\n1,3\n", ["through", "-", "--params", "column:t"])
        .fails(3, &["standard input:4", "T003", "index 2"]);
    lath_from("t,x\n0,1\n2,2\n1,3\n", ["through", "-", "--params", "column:t"]).fails(3, &["standard input:4", "T003"]);
    let close = "0,0\n1e10,0\n1e10,1e-10\n";
    lath_from(close, ["through", "-", "--params", "chord"]).fails(3, &["standard input:3", "P004", "too close"]);
    // Equal neighbours are fine where the parameter does not depend on them.
    lath_from("0,0\n1,1\n1,1\n2,0\n", ["through", "-", "--params", "uniform"]).done();
}

#[test]
fn bad_control_points_are_named() {
    lath_from("0,0\n1,1e305\n", ["curve", "-", "--kind", "bezier"]).fails(3, &["standard input:2", "P003"]);
    lath_from("0,0\n1,1\n", ["curve", "-", "--kind", "bspline"])
        .fails(3, &["P001", "2 points", "degree 3", "at least 4"]);
    lath_from("0\n".repeat(1002), ["curve", "-", "--kind", "bezier"]).fails(3, &["K006", "1002"]);
    lath_from("0 ".repeat(17), ["curve", "-", "--kind", "bezier"]).fails(3, &["P006", "17"]);
}

#[test]
fn bad_shapes_are_named() {
    let shape = |members: &str| format!("{{\"lath\": 1, \"shapes\": [\n{{{members}}}]}}");
    for (members, words) in [
        (r#""kind":"circle","points":[[0,0]]"#, &["F019", "circle", "standard input:2"][..]),
        (r#""kind":"bezier""#, &["F015", "points"]),
        (r#""kind":"bezier","points":[[0,0],[1,1]],"colour":"red""#, &["F016", "colour"]),
        (r#""kind":"bezier","points":[[0,0],[1,1]],"weights":[1,2,1]"#, &["R003", "weights"]),
        (r#""kind":"polyline","points":[[0,0],[1,1]],"weights":[1,2]"#, &["F016", "weights"]),
        (r#""kind":"bezier","points":[[0,0],[1,1]],"closed":true"#, &["C002"]),
        (r#""kind":"bezier","points":[[0,0],[1,1]],"domain":[1,0]"#, &["T003"]),
        (r#""kind":"bspline","degree":2,"points":[[0,0],[1,1]]"#, &["P001"]),
        (r#""kind":"bspline","degree":1,"points":[[0,0],[1,1]],"knots":[0,0,1]"#, &["K001", "3 knots"]),
        (r#""kind":"bspline","degree":2,"points":[0,1,2],"knots":[0,0,1,1]"#, &["K001"]),
        (r#""kind":"bspline","degree":1,"points":[0,1,2],"knots":[0,0,2,1,1]"#, &["K004"]),
        (r#""kind":"bspline","degree":1,"points":[0,1,2],"knots":[0,0,0,1,1]"#, &["K003"]),
        (r#""kind":"bspline","degree":-1,"points":[0,1,2]"#, &["degree"]),
        (r#""kind":"hermite","parameters":[0,1],"points":[0,1],"tangents":[0]"#, &["P005"]),
        (r#""kind":"hermite","parameters":[0,0],"points":[0,1],"tangents":[0,1]"#, &["T003"]),
        (r#""kind":"hermite","parameters":[0,1,2],"points":[0,1],"tangents":[0,1]"#, &["T004"]),
        (r#""kind":"polyline","points":[[0,0]]"#, &["P001"]),
    ] {
        for verb in [&["info", "-"][..], &["eval", "-", "--count", "3"], &["draw", "-", "-o", "-"]] {
            lath_from(shape(members), verb).fails(3, words);
        }
    }
    lath_from(r#"{"lath": 2, "shapes": []}"#, ["info", "-"]).fails(3, &["F018"]);
    lath_from(format!("{}{}", "[".repeat(100_000), "]".repeat(100_000)), ["info", "-"]).fails(3, &["F012"]);
}

#[test]
fn huge_and_tiny_numbers_are_no_trouble() {
    for scale in ["e-300", "e-150", "e150", "e290"] {
        let points = format!("0,0\n1{scale},2{scale}\n3{scale},2{scale}\n4{scale},0\n");
        let curve = lath_from(points, ["through", "-", "--params", "chord"]).done();
        let rows = tool::rows(&lath_from(curve, ["eval", "-", "--count", "9"]).done());
        assert!(rows.iter().flatten().all(|x| x.is_finite()), "{scale}");
    }
}

#[test]
fn any_bytes_are_answered() {
    // A deterministic stream of bytes that look like input often enough to get past the first checks.
    let alphabet = b"0123456789.,;-+eE \n\t\"[]{}:#xNaInf\xff\x00";
    let mut state = 0x9E37_79B9_7F4A_7C15_u64;
    let mut next = || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        state
    };
    for round in 0..60 {
        let bytes: Vec<u8> = (0..next() % 80).map(|_| alphabet[(next() % alphabet.len() as u64) as usize]).collect();
        for verb in [&["through", "-"][..], &["info", "-"], &["curve", "-", "--kind", "bspline", "--degree", "1"]] {
            let run = lath_from(&bytes, verb);
            assert!(!run.err.contains("panicked"), "round {round}: {bytes:?}: {}", run.err);
            match run.code {
                Some(0) => assert_eq!(run.err, ""),
                _ => run.fails(3, &[]),
            }
        }
    }
}
