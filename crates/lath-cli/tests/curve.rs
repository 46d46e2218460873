//! `lath curve`: control points, knots, closing.
#![allow(clippy::unwrap_used, clippy::panic)] // a failing unwrap is a failing test

mod tool;

use tool::{Folder, lath_from, numbers, rows, shape};

const ARCH: &str = "0,0\n1,2\n3,2\n4,0\n";

#[track_caller]
fn curve_and_eval(points: &str, curve: &str, eval: &str) -> Vec<Vec<f64>> {
    let curve = lath_from(points, ["curve", "-"].into_iter().chain(curve.split_whitespace())).done();
    rows(&lath_from(curve, ["eval", "-"].into_iter().chain(eval.split_whitespace())).done())
}

#[test]
fn a_bezier_curve_in_its_middle() {
    assert_eq!(curve_and_eval(ARCH, "--kind bezier", "--at 1/2 --derivatives 1"), [[0.5, 2.0, 1.5, 4.5, 0.0]]);
    // The clamped B-spline of as many points as degree + 1 is the same.
    assert_eq!(curve_and_eval(ARCH, "--kind bspline", "--at 1/2"), [[0.5, 2.0, 1.5]]);
    assert_eq!(curve_and_eval(ARCH, "--kind bspline --knots 0,0,0,0,1,1,1,1", "--at 1/2"), [[0.5, 2.0, 1.5]]);
    assert_eq!(curve_and_eval("7,8\n", "--kind bezier", "--at 0.3"), [[0.3, 7.0, 8.0]]);
}

#[test]
fn knots_by_rule() {
    let made = shape(&lath_from(ARCH, ["curve", "-", "--kind", "bspline", "--degree", "2"]).done());
    assert_eq!(numbers(&made["knots"]), [0.0, 0.0, 0.0, 1.0, 2.0, 2.0, 2.0]);
    let args = ["curve", "-", "--kind", "bspline", "--degree", "2", "--knots", "uniform"];
    assert_eq!(numbers(&shape(&lath_from(ARCH, args).done())["knots"]), [-2.0, -1.0, 0.0, 1.0, 2.0, 3.0, 4.0]);
    // Knots may begin with a minus sign, and be fractions.
    assert_eq!(
        curve_and_eval(ARCH, "--kind bspline --degree 1 --knots -1,-1/2,0,1/2,1,2", "--at -1/2,1")[1],
        [1.0, 4.0, 0.0]
    );
}

#[test]
fn closed_curves_start_at_the_first_joint() {
    let square = "1,0\n0,1\n-1,0\n0,-1\n";
    // t = 0: (P₀ + 4P₁ + P₂)/6, on both ends of the period.
    let seam = curve_and_eval(square, "--kind bspline --closed", "--at 0,4 --derivatives 2");
    assert!(seam[0][1].abs() < 1e-16 && (seam[0][2] - 2.0 / 3.0).abs() < 1e-15, "{seam:?}");
    assert!(seam[0][1..].iter().zip(&seam[1][1..]).all(|(a, b)| (a - b).abs() < 1e-14));
    let given = lath_from(square, ["curve", "-", "--kind", "bspline", "--closed", "--knots", "0,1,2,3,4"]).done();
    assert_eq!(given, lath_from(square, ["curve", "-", "--kind", "bspline", "--closed"]).done());
    assert_eq!(given, lath_from(square, ["curve", "-", "--kind", "bspline", "--closed", "--knots", "uniform"]).done());
    lath_from(square, ["curve", "-", "--kind", "bspline", "--closed", "--knots", "0,1,2,3"])
        .fails(3, &["K001", "one period"]);
    lath_from(square, ["curve", "-", "--kind", "bspline", "--closed", "--knots", "0,1,2,2,1"]).fails(3, &["K004"]);
    lath_from(square, ["curve", "-", "--kind", "bspline", "--closed", "--knots", "clamped"])
        .fails(2, &["clamped", "--closed"]);
    lath_from(square, ["curve", "-", "--kind", "bezier", "--closed"]).fails(3, &["C002", "Bézier", "bspline"]);
}

#[test]
fn uniform_curves_reach_the_ends_of_their_polygon() {
    let repeat = "--kind bspline --at-polygon repeat";
    let phantom = "--kind bspline --at-polygon phantom";
    // Straight along the first side as t³/6, without speed; with the speed P₁ − P₀ and not bent.
    assert_eq!(curve_and_eval(ARCH, repeat, "--at 0 --derivatives 2"), [[0.0; 7]]);
    let row = &curve_and_eval(ARCH, repeat, "--at 1/2")[0];
    assert!((row[1] - 1.0 / 48.0).abs() < 1e-16 && (row[2] - 2.0 / 48.0).abs() < 1e-16, "{row:?}");
    assert_eq!(curve_and_eval(ARCH, phantom, "--at 0 --derivatives 2"), [[0.0, 0.0, 0.0, 1.0, 2.0, 0.0, 0.0]]);
    assert_eq!(curve_and_eval(ARCH, phantom, "--at 3 --derivatives 2"), [[3.0, 4.0, 0.0, 1.0, -2.0, 0.0, 0.0]]);
    let made = shape(&lath_from(ARCH, ["curve", "-"].into_iter().chain(phantom.split(' '))).done());
    assert_eq!(numbers(&made["points"]), [-1.0, -2.0, 0.0, 0.0, 1.0, 2.0, 3.0, 2.0, 4.0, 0.0, 5.0, -2.0]);
    assert!(made.get("knots").is_none(), "{made}");
    for degree in 0..=7 {
        for end in [repeat, phantom] {
            let curve = lath_from(
                ARCH,
                ["curve", "-"].into_iter().chain(end.split(' ')).chain(["--degree", &degree.to_string()]),
            );
            if degree == 7 && end == phantom {
                assert_eq!(curve.code, Some(0), "{curve:?}");
            }
            let ends = rows(&lath_from(curve.done(), ["eval", "-", "--count", "2"]).done());
            let near = |row: &[f64], point: [f64; 2]| (0..2).all(|c| (row[c + 1] - point[c]).abs() < 1e-14);
            assert!(near(&ends[0], [0.0, 0.0]) && near(&ends[1], [4.0, 0.0]), "degree {degree}, {end}: {ends:?}");
        }
    }
    let with = |args: &str| lath_from(ARCH, ["curve", "-", "--kind", "bspline"].into_iter().chain(args.split(' ')));
    with("--degree 9 --at-polygon phantom").fails(3, &["P001", "4 points", "mirror 5"]);
    with("--degree 31 --at-polygon repeat").fails(3, &["K006", "31"]);
    lath_from("0,0\n", ["curve", "-", "--kind", "bspline", "--at-polygon", "phantom"]).fails(3, &["P001"]);
    with("--at-polygon phantom --closed").fails(2, &["--at-polygon", "--closed"]);
    with("--at-polygon phantom --knots clamped").fails(2, &["--at-polygon", "uniform knots"]);
    with("--at-polygon phantom --knots 0,1,2,3,4,5,6,7").fails(2, &["--at-polygon", "uniform knots"]);
    with("--at-polygon mirror").fails(2, &["mirror", "phantom"]);
    lath_from(ARCH, ["curve", "-", "--kind", "bezier", "--at-polygon", "repeat"]).fails(2, &["--at-polygon"]);
}

#[test]
fn tension_from_the_bspline_to_the_polygon_of_its_joints() {
    const CIRCLE: &str = "0,-3/2\n3/2,0\n0,3/2\n-3/2,0\n";
    let circle = &CIRCLE.replace("3/2", "1.5");
    let middle = |options: &str| {
        let row = curve_and_eval(circle, &format!("--kind bspline --closed {options}"), "--at 1/2")[0].clone();
        lath::space::norm(&[row[1], row[2]])
    };
    let book = 33.0 * 2.0_f64.sqrt() / 48.0;
    for none in ["", "--tension 0", "--tension 0,0,0,0", "--knots uniform --tension 0"] {
        assert!((middle(none) - book).abs() < 2e-16, "{none}: {}", middle(none));
    }
    assert!((middle("--tension 1") - 0.5_f64.sqrt()).abs() < 2e-16);
    assert!((middle("--tension 1,0,0,0") - 0.5_f64.sqrt()).abs() < 2e-16);
    assert!((middle("--tension 0,1,1,1") - book).abs() < 2e-16);
    // One tension gives a Hermite curve, several a B-spline whose knots are triple; both closed.
    let made = |options: &str| {
        let args = ["curve", "-", "--kind", "bspline", "--closed"].into_iter().chain(options.split(' '));
        shape(&lath_from(circle, args).done())
    };
    let one = made("--tension 1/2");
    assert_eq!((one["kind"].as_str(), one["closed"].as_bool()), (Some("hermite"), Some(true)));
    assert_eq!(numbers(&one["tangents"])[..4], [0.0, 0.75, -0.75, 0.0]);
    let each = made("--tension 0,1/2,1/2,1");
    assert_eq!((each["kind"].as_str(), each["closed"].as_bool()), (Some("bspline"), Some(true)));
    assert_eq!(numbers(&each["knots"]), [0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 2.0, 2.0, 2.0, 3.0, 3.0, 3.0, 4.0]);
    // At the joint between 0 and ½ the speed halves, the direction stays.
    let text = lath_from(circle, "curve - --kind bspline --closed --tension 0,1/2,1/2,1".split(' ')).done();
    let side = |side: &str| {
        rows(&lath_from(&text, ["eval", "-", "--at", "1", "--derivatives", "1", "--side", side]).done())[0].clone()
    };
    assert_eq!(side("left")[3..], [-1.5, 0.0]);
    assert_eq!(side("right")[3..], [-0.75, 0.0]);
    // Open: together with the ends of the polygon.
    let open = curve_and_eval(ARCH, "--kind bspline --at-polygon phantom --tension 1", "--at 0,1/2,3 --derivatives 1");
    assert_eq!((&open[0][1..], &open[2][1..]), (&[0.0; 4][..], &[4.0, 0.0, 0.0, 0.0][..]));
    let with = |args: &str| lath_from(ARCH, ["curve", "-", "--kind", "bspline"].into_iter().chain(args.split(' ')));
    with("--tension 0,1").fails(3, &["Q004", "2 tensions", "1 segment"]);
    with("--tension soft").fails(2, &["--tension", "soft"]);
    with("--tension nan").fails(2, &["--tension", "finite"]);
    with("--tension 1 --degree 4").fails(2, &["--tension", "degree 3"]);
    with("--tension 1 --knots clamped").fails(2, &["--tension", "uniform"]);
    with("--tension -1").done();
    lath_from(ARCH, ["curve", "-", "--kind", "bezier", "--tension", "1"]).fails(2, &["--tension", "bspline"]);
    lath_from("0,0\n1,1\n2,0\n", ["curve", "-", "--kind", "bspline", "--tension", "1"]).fails(3, &["P001"]);
}

#[test]
fn bad_knots_are_named() {
    for (knots, words) in [
        ("0,0,0,0,1,1,1", &["K001", "7 knots", "4 points", "take 8"][..]),
        ("0,0,0,1,1,1", &["K001", "6 knots", "openNURBS", "Repeat the first and the last knot"]),
        ("0,0,0,0,1,1,1,1,1", &["K001", "9 knots"]),
        ("0,0,0,0.5,0.25,1,1,1", &["K004", "knot 4", "0.25", "index 4"]),
        ("0,0,0,nan,1,1,1,1", &["K002", "knot 3", "NaN"]),
        ("0,0,0,0,1,1,1,inf", &["K002", "knot 7", "inf"]),
        ("0,0,0,0,0,1,1,1", &["K003", "5 times", "degree + 1 = 4"]),
        ("0,1,2,3,3,3,3,4", &["K005", "knots 3 and 4"]),
        ("0,0,0,0,1e302,1e302,1e302,1e302", &["K007", "knot 4"]),
    ] {
        lath_from(ARCH, ["curve", "-", "--kind", "bspline", "--knots", knots]).fails(3, words);
    }
    for knots in ["", "0,,1", "0,1/0,2", "even", "0;1;2"] {
        lath_from(ARCH, ["curve", "-", "--kind", "bspline", "--knots", knots]).fails(2, &["--knots"]);
    }
}

#[test]
fn degrees_out_of_range() {
    lath_from(ARCH, ["curve", "-", "--kind", "bspline", "--degree", "4"])
        .fails(3, &["P001", "4 points", "degree 4", "at least 5"]);
    let args = ["curve", "-", "--kind", "bspline", "--degree", "4", "--knots", "0,1,2,3,4,5,6,7,8"];
    lath_from(ARCH, args).fails(3, &["P001", "4 points", "at least 5"]);
    for degree in ["2147483648", "18446744073709551615"] {
        lath_from(ARCH, ["curve", "-", "--kind", "bspline", "--degree", degree]).fails(3, &["K006", degree]);
        let args = ["curve", "-", "--kind", "bspline", "--degree", degree, "--knots", "0,1,2"];
        lath_from(ARCH, args).fails(3, &["K006", degree]);
        lath_from(ARCH, ["curve", "-", "--kind", "bspline", "--closed", "--degree", degree])
            .fails(3, &["K006", degree]);
    }
    for degree in ["-1", "1.5", "three"] {
        lath_from(ARCH, ["curve", "-", "--kind", "bspline", "--degree", degree]).fails(2, &["--degree", degree]);
    }
    assert_eq!(curve_and_eval(ARCH, "--kind bspline --degree 0", "--at 1.5"), [[1.5, 1.0, 2.0]]);
}

#[test]
fn options_that_do_not_belong() {
    lath_from(ARCH, ["curve", "-"]).fails(2, &["--kind"]);
    lath_from(ARCH, ["curve", "-", "--kind", "cubic"]).fails(2, &["bezier", "bspline"]);
    lath_from(ARCH, ["curve", "-", "--kind", "bezier", "--degree", "3"]).fails(2, &["--degree", "bspline"]);
    lath_from(ARCH, ["curve", "-", "--kind", "bezier", "--knots", "uniform"]).fails(2, &["--knots", "bspline"]);
    lath_from(ARCH, ["curve", "-", "--kind", "bspline", "--weights", "w"]).fails(2, &["--weights", "column:NAME"]);
    lath_from(ARCH, ["curve", "-", "--kind", "bspline", "--weights", "column:w"]).fails(3, &["F009", "\"w\""]);
    let both = ["curve", "-", "--kind", "bspline", "--weights", "column:0", "--tension", "0"];
    lath_from(ARCH, both).fails(2, &["--weights", "--tension"]);
    let folder = Folder::new();
    lath_from(ARCH, ["curve", "-", "--kind", "bezier", "-o", &folder.path("a.svg")]).fails(2, &[".svg"]);
    assert!(folder.names().is_empty());
}

#[test]
fn columns_are_chosen() {
    let made =
        shape(&lath_from("a,b,c\n1,2,3\n4,5,6\n", ["curve", "-", "--kind", "bezier", "--columns", "c,a"]).done());
    assert_eq!(numbers(&made["points"]), [3.0, 1.0, 6.0, 4.0]);
}

#[test]
fn weights_stand_in_a_column() {
    const QUARTER: &str = "x,w,y,note\n1,1,0,start\n1,1,1,corner\n0,2,1,end\n";
    let args = |text: &str, options: &str| {
        let words = format!("curve - --kind {options}");
        lath_from(text, words.split_whitespace()).done()
    };
    let bare = &QUARTER.replace(",note", "").replace(",start", "").replace(",corner", "").replace(",end", "");
    let expected = args(bare, "bezier --weights column:w");
    assert_eq!(args(QUARTER, "bezier --columns x,y --weights column:w"), expected);
    assert_eq!(args(bare, "bezier --weights column:1"), expected);
    assert_eq!(args(bare, "bezier --columns 0,2 --weights column:1"), expected);
    assert_eq!(
        (numbers(&shape(&expected)["weights"]), &shape(&expected)["kind"]),
        (vec![1.0, 1.0, 2.0], &"bezier".into())
    );
    let middle = |curve: &str| rows(&lath_from(curve, ["eval", "-", "--at", "1/2"]).done())[0].clone();
    assert_eq!(middle(&expected), [0.5, 0.6, 0.8]);
    // The same as a B-spline, clamped, over given knots; and closed.
    for options in ["bspline --degree 2", "bspline --degree 2 --knots 0,0,0,1,1,1"] {
        assert_eq!(middle(&args(bare, &format!("{options} --weights column:w"))), [0.5, 0.6, 0.8], "{options}");
    }
    let closed = args("0,-1.5,1\n1.5,0,2\n0,1.5,1\n-1.5,0,0.5\n", "bspline --closed --weights column:2");
    let first = rows(&lath_from(&closed, ["eval", "-", "--at", "0"]).done())[0].clone();
    // (w₀P₀ + 4w₁P₁ + w₂P₂)/(w₀ + 4w₁ + w₂).
    assert!((first[1] - 1.2).abs() < 1e-15 && first[2].abs() < 1e-15, "{first:?}");
    let run = |text: &str| lath_from(text, ["curve", "-", "--kind", "bezier", "--weights", "column:w"]);
    run("x,w\n0,1\n1,-1\n2,1\n").fails(3, &["R004", "[0.5, 0.5]"]);
    run("x,w\n0,1\n1,1e301\n2,1\n").fails(3, &["R002", "standard input:3"]);
}
