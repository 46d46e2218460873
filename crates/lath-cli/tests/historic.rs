//! Defects of other libraries that a file or a command line can meet, each with its input and the right answer.
//!
//! A test is named after the project, the number of its report where there is one, and what went wrong there; what it says about
//! a project is about the version or the report named, and may be mended by now.
#![allow(clippy::unwrap_used, clippy::panic)] // a failing unwrap is a failing test

mod tool;

use tool::{Folder, lath, lath_from, numbers, rows, shape};

const ARCH: &str = "0,0\n1,2\n3,2\n4,0\n";

#[track_caller]
fn refused(document: &str, words: &[&str]) {
    for verb in [&["info", "-"][..], &["eval", "-", "--count", "3"], &["draw", "-", "-o", "-"]] {
        lath_from(document, verb).fails(3, words);
    }
}

/// lyon 414: a NaN coordinate ended in a panic that named something else. Its line and column are named.
#[test]
fn lyon_414_nan_coordinate() {
    lath_from("0,0\n1,NaN\n2,0\n", ["through", "-"]).fails(3, &["standard input:2:3", "P002", "NaN"]);
    lath_from("0,0\n1,NaN\n2,0\n", ["draw", "-", "-o", "-"]).fails(3, &["standard input:2:3", "P002"]);
}

/// splines 5.0.0: keys that a file held out of order stayed so, and every search among them was wrong. The culprit is named.
#[test]
fn splines_keys_out_of_order_in_a_file() {
    let keys = r#"{"lath": 1, "shapes": [{"kind": "hermite", "parameters": [0,2,1], "points": [0,1,2], "tangents": [0,0,0]}]}"#;
    refused(keys, &["T003", "/shapes/0/parameters/2"]);
}

/// Kratos 8841 and x3dom 1060: weights were read and not used. Here they count wherever a curve is looked at.
#[test]
fn kratos_8841_weights_that_are_ignored() {
    let weighted = r#"{"lath": 1, "shapes": [{"kind": "bezier", "points": [[0,0],[1,1],[2,0]], "weights": [1,5,1]}]}"#;
    let middle = rows(&lath_from(weighted, ["eval", "-", "--at", "1/2"]).done());
    // (0 + 10·1 + 2)/(1 + 10 + 1) and 10/12.
    assert!((middle[0][1] - 1.0).abs() < 1e-15 && (middle[0][2] - 10.0 / 12.0).abs() < 1e-15, "{middle:?}");
    let told = |verb: &[&str], words: &[&str]| {
        let text = lath_from(weighted, verb.iter().copied()).done();
        assert!(words.iter().all(|word| text.contains(word)), "{text}");
    };
    told(&["info", "-"], &["rational   yes", "[0, 0.83333"]);
    told(&["info", "-", "--json"], &["\"rational\":true"]);
    let plain = weighted.replace("[1,5,1]", "[1,1,1]");
    let picture = |document: &str| lath_from(document, ["draw", "-", "-o", "-", "--format", "svg"]).done();
    assert_ne!(picture(weighted), picture(&plain));
}

/// plyfile 90, dot_vox 40 and others: memory was taken for as many rows as a header announces. Rows are counted against the bytes that
/// are there.
#[test]
fn plyfile_90_a_header_that_announces_too_much() {
    let folder = Folder::new();
    let header = b"{'descr': '<f8', 'fortran_order': False, 'shape': (1099511627776, 2), }\n";
    let length = u16::try_from(header.len()).unwrap().to_le_bytes();
    let path = folder.file("a.npy", [b"\x93NUMPY\x01\x00", &length[..], header, &[0; 64]].concat());
    lath(["through", &path]).fails(3, &["a.npy", "F025"]);
}

/// ndarray-interp: a closing point that differs from the first by rounding was an error. It is one more point here, and an equal one is the
/// closing point; both curves are whole.
#[test]
fn ndarray_interp_a_closing_point_off_by_rounding() {
    let closed = |last: &str| {
        let points = format!("0.3,0\n1,0\n1,1\n{last},0\n");
        let args = ["through", "-", "--closed", "--params", "uniform"];
        numbers(&shape(&lath_from(points, args).done())["parameters"]).len() - 1
    };
    assert_eq!((closed("0.3"), closed("0.30000000000000004")), (3, 4));
}

/// openNURBS leaves out the first and the last knot, and its guide has a page about these superfluous knots; other libraries take such
/// files for broken, or for another degree. The convention is named, with what to do.
#[test]
fn opennurbs_superfluous_knots() {
    lath_from(ARCH, ["curve", "-", "--kind", "bspline", "--knots", "0,0,0,1,1,1"])
        .fails(3, &["K001", "6 knots", "openNURBS", "Repeat the first and the last knot"]);
}

/// bspline 1.1.0 and curvo 0.3.3: knots out of order were sorted without a word.
#[test]
fn bspline_crate_and_curvo_sorted_the_knots() {
    lath_from(ARCH, ["curve", "-", "--kind", "bspline", "--knots", "0,0,0,0.5,0.25,1,1,1"])
        .fails(3, &["K004", "index 4"]);
}

/// bevy_curve 0.20.1: no points wanted gave one point of NaN. No points are no answer.
#[test]
fn bevy_curve_a_count_of_0() {
    let curve = lath_from(ARCH, ["curve", "-", "--kind", "bezier"]).done();
    lath_from(&curve, ["eval", "-", "--count", "0"]).fails(2, &["--count"]);
    assert_eq!(rows(&lath_from(&curve, ["eval", "-", "--count", "1"]).done()), [[0.0, 0.0, 0.0]]);
}

/// scipy 7589: the same point given twice ended in an internal error. Its line is named; with uniform parameters it is a halt.
#[test]
fn scipy_7589_points_given_twice() {
    let twice = "0,0\n1,1\n1,1\n2,0\n";
    lath_from(twice, ["through", "-"]).fails(3, &["standard input:3", "P004", "points 1 and 2"]);
    let curve = lath_from(twice, ["through", "-", "--params", "uniform"]).done();
    assert_eq!(rows(&lath_from(curve, ["eval", "-", "--at", "1,2"]).done()), [[1.0, 1.0, 1.0], [2.0, 1.0, 1.0]]);
}

/// scipy 16448: evaluation outside the domain was taken for a wrong result. It is an error that names the domain, and a choice.
#[test]
fn scipy_16448_extrapolation_taken_for_a_result() {
    let spline =
        r#"{"lath": 1, "shapes": [{"kind": "bspline", "degree": 3, "knots": [0,1,2,3,4,5,6,7], "points": [0,6,6,0]}]}"#;
    assert_eq!(rows(&lath_from(spline, ["eval", "-", "--at", "3,4"]).done()), [[3.0, 5.0], [4.0, 5.0]]);
    lath_from(spline, ["eval", "-", "--at", "0"]).fails(3, &["T002", "t = 0", "[3, 4]"]);
}

/// casadi 2202: two points crashed. They give the line.
#[test]
fn casadi_2202_two_points() {
    let line = lath_from("1,1\n4,5\n", ["through", "-", "--params", "chord"]).done();
    let middle = &rows(&lath_from(line, ["eval", "-", "--at", "5/2"]).done())[0];
    assert!(middle[1..].iter().zip([2.5, 3.0]).all(|(a, b)| (a - b).abs() < 1e-15), "{middle:?}");
}

/// three.js 28117: a flat curve in space gave NaN. It is drawn, with its curvature, from any side.
#[test]
fn threejs_28117_a_flat_curve_in_space() {
    let curve = lath_from("0,0,5\n1,2,5\n3,2,5\n4,0,5\n", ["through", "-"]).done();
    for view in ["0,90", "30,20", "90,0"] {
        let picture = lath_from(&curve, ["draw", "-", "--comb", "--axes", "--view", view, "-o", "-"]).done();
        assert!(picture.starts_with("<svg") && !picture.contains("NaN") && !picture.contains("inf"), "{view}");
    }
}
