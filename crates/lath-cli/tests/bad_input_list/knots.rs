//! Rows 26 to 35: knots, and where a curve is asked.

use crate::tool::{numbers, rows, shape};
use crate::{document, eval, run, shape_fails, warned};

/// A B-spline of control points on a line.
fn spline(degree: usize, knots: &str, points: &str) -> String {
    format!(r#""kind": "bspline", "degree": {degree}, "knots": [{knots}], "points": [{points}]"#)
}

#[test]
fn row_26_decreasing_knots() {
    let words = ["K004", "knot 4", "0.25", "index 4"];
    run("0\n1\n2\n3\n", "curve - --kind bspline --knots 0,0,0,0.5,0.25,1,1,1").fails(3, &words);
    shape_fails(&spline(1, "0,0,2,1,1", "0,1,2"), &["K004", "/shapes/0/knots/3"]);
}

#[test]
fn row_27_all_knots_equal() {
    run("0\n1\n", "curve - --kind bspline --degree 1 --knots 1,1,1,1").fails(3, &["K003", "4 times"]);
    shape_fails(&spline(3, "5,5,5,5,5,5,5,5", "0,1,2,3"), &["K003", "8 times", "/shapes/0/knots"]);
    shape_fails(&spline(1, "0,1,1,2", "0,1"), &["K005"]);
}

#[test]
fn row_28_multiplicity() {
    shape_fails(&spline(1, "0,0,1,1,1,2,2", "0,1,2,3,4"), &["K003", "3 times", "/shapes/0/knots/4"]);
    let broken = spline(1, "0,0,1,1,2,2", "0,1,5,6");
    assert_eq!(eval(&broken, "--at 1/2,1,3/2"), [[0.5, 0.5], [1.0, 5.0], [1.5, 5.5]]);
    // The gap is no line in the picture.
    assert!(run(document(&broken), "draw - -o - --format svg").done().matches('M').count() >= 2);
}

#[test]
fn row_29_nearly_equal_knots() {
    // The line from 0 to 3 over knots of which two are one step apart.
    let line = spline(1, "0,0,1,1.0000000000000002,3,3", "0,1,1.0000000000000002,3");
    for row in eval(&line, "--at 0,0.999,1,1.0000000000000002,1.5,3") {
        assert!((row[0] - row[1]).abs() <= 1e-15, "{row:?}");
    }
    assert_eq!(warned(document(&line)), ["W001"]);
}

#[test]
fn row_30_spans_of_very_different_length() {
    let line = spline(1, "0,0,1,1e12,1e12", "0,1,1e12");
    assert_eq!(eval(&line, "--at 1/4,1,7.5e11"), [[0.25, 0.25], [1.0, 1.0], [7.5e11, 7.5e11]]);
    let curve = run("0,0\n1,1\n1e12,0\n", "through - --params chord").done();
    let breaks = rows(&run(&curve, "eval - --at breaks").done());
    assert_eq!(breaks.iter().map(|row| row[1]).collect::<Vec<_>>(), [0.0, 1.0, 1e12]);
    assert_eq!(warned(document(&spline(1, "0,0,1,1e9,1e9", "0,1,1e9"))), ["W002"]);
    assert_eq!(warned(document(&spline(1, "0,0,1,1000,1000", "0,1,1000"))), [""; 0]);
}

#[test]
fn row_31_unclamped_and_half_clamped_knots() {
    let uniform = r#""kind": "bspline", "degree": 3, "points": [0,6,0,6,12]"#;
    assert_eq!(eval(uniform, "--at 0,2"), [[0.0, 4.0], [2.0, 6.0]]);
    for t in ["-1", "3", "5"] {
        run(document(uniform), &format!("eval - --at {t}")).fails(3, &["T002", &format!("t = {t}"), "[0, 2]"]);
    }
    assert_eq!(eval(&spline(2, "0,0,0,1,2,3", "5,1,3"), "--at 0,1"), [[0.0, 5.0], [1.0, 2.0]]);
    let made = shape(&run("0\n6\n0\n6\n", "curve - --kind bspline --knots uniform").done());
    assert_eq!(numbers(&made["knots"]), [-3.0, -2.0, -1.0, 0.0, 1.0, 2.0, 3.0, 4.0]);
}

#[test]
fn row_32_at_a_knot_and_one_ulp_beside() {
    let bent = spline(1, "0,0,1,2,3,3", "0,1,4,2");
    let slopes: Vec<f64> =
        eval(&bent, "--at 0,0.9999999999999999,1,2,3 --derivatives 1").iter().map(|row| row[2]).collect();
    assert_eq!(slopes, [1.0, 1.0, 3.0, -2.0, -2.0]);
    for t in ["3.0000000000000004", "-5e-324"] {
        run(document(&bent), &format!("eval - --at {t}")).fails(3, &["T002", "[0, 3]"]);
    }
}

#[test]
fn row_33_outside_is_a_policy() {
    let square = spline(2, "0,0,0,2,2,2", "0,0,4");
    let at = |policy: &str| eval(&square, &format!("--at -1,3 --outside {policy}"));
    assert_eq!(at("clamp"), [[-1.0, 0.0], [3.0, 4.0]]);
    assert_eq!(at("extrapolate"), [[-1.0, 1.0], [3.0, 9.0]]);
    assert_eq!(at("periodic"), [[-1.0, 1.0], [3.0, 1.0]]);
    run(document(&square), "eval - --at 0,3").fails(3, &["T002", "t = 3", "index 1"]);
    run(document(&square), "eval - --at 3 --outside wrap").fails(2, &["wrap", "periodic"]);
    run(document(&square), "eval - --at 1e300 --outside extrapolate").fails(3, &["P003", "overflows"]);
}

#[test]
fn row_34_a_seam_that_nearly_meets() {
    let path = |end: &str| {
        let points = format!("[[0,0],[1,0],[1,1],[{end},0]]");
        format!(r#""kind": "path", "closed": true, "pieces": [{{"kind": "polyline", "points": {points}}}]"#)
    };
    shape_fails(&path("1e-12"), &["C002", "1e-12"]);
    assert_eq!(eval(&path("0"), "--at 0,3,6"), [[0.0, 0.0, 0.0], [3.0, 0.0, 0.0], [6.0, 0.0, 0.0]]);
    // A last point that nearly repeats the first is one more point, not the closing one, and not lost.
    let nearly = run("0,0\n1,0\n1,1\n1e-9,0\n", "through - --closed --params uniform").done();
    assert_eq!(numbers(&shape(&nearly)["parameters"]).len(), 5);
    let open = |y: &str| document(&format!(r#""kind": "polyline", "points": [[0,0],[1,0],[1,1],[0,{y}]]"#));
    assert_eq!((warned(open("1e-9")), warned(open("0")).len()), (vec!["W007".to_owned()], 0));
}

#[test]
fn row_35_spans_without_length_in_derivatives() {
    // t³ with a double, t with a full knot inside.
    let cube = spline(3, "0,0,0,0,1,1,2,2,2,2", "0,0,0,2,4,8");
    let exact = [[0.5, 0.125, 0.75, 3.0, 6.0, 0.0], [1.0, 1.0, 3.0, 6.0, 6.0, 0.0], [2.0, 8.0, 12.0, 12.0, 6.0, 0.0]];
    assert_eq!(eval(&cube, "--at 1/2,1,2 --derivatives 4"), exact);
    let full = spline(2, "0,0,0,1,1,1,2,2,2", "0,0.5,1,1,1.5,2");
    assert_eq!(eval(&full, "--at 1/2,1,2 --derivatives 1"), [[0.5, 0.5, 1.0], [1.0, 1.0, 1.0], [2.0, 2.0, 1.0]]);
}
