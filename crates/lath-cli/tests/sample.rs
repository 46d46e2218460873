//! `lath sample`: equal distances along a curve.
#![allow(clippy::unwrap_used, clippy::panic)] // a failing unwrap is a failing test

mod tool;

use tool::{Folder, lath_from, rows, table};

/// x = 8t³: half of the way is far from t = ½.
const SLOW: &str = r#"{"lath":1,"shapes":[{"kind":"bezier","points":[[0,0],[0,0],[0,0],[8,0]]}]}"#;
/// The 3-4-5 triangle, closed, t = 0, 1, 2, 3.
const TRIANGLE: &str =
    r#"{"lath":1,"shapes":[{"kind":"bspline","degree":1,"closed":true,"points":[[0,0],[3,0],[3,4]]}]}"#;

#[track_caller]
fn sample(input: &str, args: &str) -> Vec<Vec<f64>> {
    rows(&lath_from(input, ["sample", "-"].into_iter().chain(args.split_whitespace())).done())
}

/// The rows, and what is said beside them.
#[track_caller]
fn spoken(input: &str, args: &str) -> (Vec<Vec<f64>>, String) {
    let run = lath_from(input, ["sample", "-"].into_iter().chain(args.split_whitespace()));
    assert_eq!(run.code, Some(0), "{}", run.err);
    (rows(&String::from_utf8(run.out).unwrap()), run.err)
}

#[test]
fn points_are_equally_far_along_the_curve() {
    let found = sample(SLOW, "--count 9");
    assert_eq!((found.len(), &found[0][..], found[8][0], &found[8][2..]), (9, &[0.0; 4][..], 1.0, &[8.0, 0.0][..]));
    for (i, row) in found.iter().enumerate() {
        let s = i as f64;
        // The usual accuracy is 1e-9 of the box, which is 8 wide.
        assert!((row[1] - s).abs() <= 8e-9 && (row[2] - s).abs() <= 2.0 * 8e-9, "{row:?}");
        assert!((8.0 * row[0] * row[0] * row[0] - s).abs() <= 2.0 * 8e-9, "{row:?}");
    }
    assert_eq!(sample(SLOW, "--count 1"), [[0.0; 4]]);
    let fine = sample(SLOW, "--count 5 --accuracy 1e-12");
    assert!(fine.iter().enumerate().all(|(i, row)| (row[2] - 2.0 * i as f64).abs() < 1e-11), "{fine:?}");
    let (header, _) = table(&lath_from(SLOW, ["sample", "-", "--count", "2"]).done());
    assert_eq!(header, ["t", "s", "x", "y"]);
}

#[test]
fn spacing_ends_where_the_next_step_would_not_fit() {
    let (found, said) = spoken(TRIANGLE, "--spacing 5");
    assert_eq!(found.iter().map(|row| row[1]).collect::<Vec<_>>(), [0.0, 5.0, 10.0]);
    assert!((found[1][2] - 3.0).abs() < 1e-8 && (found[1][3] - 2.0).abs() < 1e-8, "{found:?}");
    assert_eq!(said, "lath: 2 of 12 remain after the last point\n");
    // A step that falls on the end ends there, also where D is no binary fraction.
    let found = sample(TRIANGLE, "--spacing 0.1");
    assert_eq!((found.len(), found[120][0], found[120][1]), (121, 3.0, 12.0));
    let (found, said) = spoken(TRIANGLE, "--spacing 100");
    assert_eq!((found.len(), said.as_str()), (1, "lath: 12 of 12 remain after the last point\n"));
    let (_, quiet) = spoken(TRIANGLE, "--spacing 100 --quiet");
    assert_eq!(quiet, "");
}

#[test]
fn the_last_point_of_a_closed_curve_is_the_first() {
    let found = sample(TRIANGLE, "--count 13");
    assert_eq!((found[0][0], found[12][0], found[12][1]), (0.0, 3.0, 12.0));
    assert_eq!(found[0][2..], found[12][2..]);
    let closed = lath_from("1,0\n0,1\n-1,0\n0,-1\n", ["through", "-", "--closed"]).done();
    let found = sample(&closed, "--count 101");
    assert_eq!(found[0][2..], found[100][2..]);
    let chord = |p: &[Vec<f64>]| lath::space::norm(&[p[1][2] - p[0][2], p[1][3] - p[0][3]]);
    let steps: Vec<f64> = found.windows(2).map(chord).collect();
    let mean = steps.iter().sum::<f64>() / 100.0;
    assert!(steps.iter().all(|step| (step / mean - 1.0).abs() < 1e-3), "{steps:?}");
}

#[test]
fn a_point_is_sampled_where_it_is() {
    let point = r#"{"lath":1,"shapes":[{"kind":"bezier","points":[[7,7],[7,7],[7,7]]}]}"#;
    let found = sample(point, "--count 3");
    assert!(found.len() == 3 && found.iter().all(|row| row[1..] == [0.0, 7.0, 7.0]), "{found:?}");
    assert_eq!(sample(point, "--spacing 1"), [[0.0, 0.0, 7.0, 7.0]]);
}

#[test]
fn numbers_out_of_range_are_refused() {
    for spacing in ["0", "-1", "nan", "inf", "wide"] {
        lath_from(SLOW, ["sample", "-", "--spacing", spacing]).fails(2, &["--spacing"]);
    }
    for count in ["0", "-3", "2.5"] {
        lath_from(SLOW, ["sample", "-", "--count", count]).fails(2, &["--count"]);
    }
    lath_from(SLOW, ["sample", "-"]).fails(2, &["--spacing", "--count"]);
    lath_from(SLOW, ["sample", "-", "--count", "2", "--spacing", "1"]).fails(2, &["--spacing", "--count"]);
    lath_from(SLOW, ["sample", "-", "--accuracy", "0", "--count", "2"]).fails(2, &["--accuracy"]);
    lath_from(SLOW, ["sample", "-", "--spacing", "1e-300"]).fails(5, &["B001"]);
    lath_from(SLOW, ["sample", "-", "--count", "1e12"]).fails(5, &["B001"]);
    lath_from(SLOW, ["sample", "-", "--count", "11", "--budget", "10"]).fails(5, &["B001"]);
}

#[test]
fn several_shapes_need_a_choice_and_every_table_format_is_written() {
    let two = r#"{"lath":1,"shapes":[{"kind":"polyline","points":[[0,0],[4,0]],"name":"flat"},
        {"kind":"bezier","points":[[0,0,0],[0,0,2]]}]}"#;
    lath_from(two, ["sample", "-", "--count", "2"]).fails(3, &["A001", "0 polyline \"flat\", 1 bezier", "--shape"]);
    lath_from(two, ["sample", "-", "--count", "2", "--shape", "2"]).fails(3, &["A002", "no shape 2"]);
    let csv = lath_from(two, ["sample", "-", "--count", "2", "--shape", "1"]).done();
    assert_eq!(csv, "t,s,x,y,z\n0,0,0,0,0\n1,2,0,0,2\n");
    let json = lath_from(two, ["sample", "-", "--count", "2", "--shape", "0", "--json"]).done();
    let json: serde_json::Value = serde_json::from_str(&json).unwrap();
    assert_eq!(json["columns"], serde_json::json!(["t", "s", "x", "y"]));
    let folder = Folder::new();
    for name in ["points.npy", "points.tsv", "points.json"] {
        let path = folder.path(name);
        lath_from(two, ["sample", "-", "--count", "5", "--shape", "0", "-o", &path]).done();
        assert!(std::fs::metadata(&path).unwrap().len() > 20, "{name}");
    }
    assert_eq!(folder.names().len(), 3);
}
