//! Rows 53 to 57: weights.

use crate::{document, eval, run, shape_fails};

const ARCH: &str = r#""kind": "bezier", "points": [[0,0],[1,2],[2,0]]"#;

fn arch(weights: &str) -> String {
    format!("{ARCH}, \"weights\": [{weights}]")
}

#[test]
fn row_53_a_weight_of_zero() {
    assert_eq!(eval(&arch("1,0,1"), "--at 0,1/2,1"), [[0.0, 0.0, 0.0], [0.5, 1.0, 0.0], [1.0, 2.0, 0.0]]);
    shape_fails(&arch("0,1,1"), &["R004", "/shapes/0/weights", "[0, 0]"]);
    shape_fails(&arch("1,1,0"), &["R004", "[1, 1]"]);
    let column = "0,0,1\n1,2,0\n2,0,0\n";
    run(column, "curve - --kind bezier --weights column:2").fails(3, &["R004", "standard input"]);
}

#[test]
fn row_54_a_negative_weight() {
    // The denominator is 1 − 3u(1 − u) ≥ 1/4.
    assert_eq!(eval(&arch("1,-0.5,1"), "--at 1/2"), [[0.5, 1.0, -2.0]]);
    shape_fails(&arch("1,-1.0000001,1"), &["R004", "weights"]);
    let told = run(document(&arch("1,-0.5,1")), "check -").done();
    assert!(told.contains("W018"), "{told}");
}

#[test]
fn row_55_weights_whose_denominator_vanishes() {
    for weights in ["0,0,0", "1,-1,1", "1,-3,1", "-1,0,1", "1,1,-1e-9"] {
        shape_fails(&arch(weights), &["R004", "/shapes/0/weights", "denominator"]);
    }
}

#[test]
fn row_56_weights_from_1e_300_to_1e300() {
    for weights in ["1e-300,1e-300,1e-300", "1e300,1e300,1e300"] {
        let middle = eval(&arch(weights), "--at 1/2 --derivatives 1")[0].clone();
        assert!(middle.iter().zip([0.5, 1.0, 1.0, 2.0, 0.0]).all(|(x, y)| (x - y).abs() < 1e-15), "{middle:?}");
    }
    for weights in ["1e-300,1,1e300", "1e300,1e-300,1e300", "1e-300,1e300,1e-300"] {
        let ends = eval(&arch(weights), "--at 0,1");
        assert_eq!(ends, [[0.0, 0.0, 0.0], [1.0, 2.0, 0.0]], "{weights}");
        let told = run(document(&arch(weights)), "info -").done();
        assert!(told.contains("length") && !told.contains("NaN") && !told.contains("inf"), "{told}");
        let picture = run(document(&arch(weights)), "draw - --comb --polygon -o - --format svg").done();
        assert!(picture.starts_with("<svg") && !picture.contains("NaN") && !picture.contains("inf"), "{picture}");
    }
}

#[test]
fn row_57_weights_are_never_ignored() {
    // (0 + 4 + 2)/(1 + 4 + 1) and (0 + 8 + 0)/6: weights 1, 2, 1.
    let middle = eval(&arch("1,2,1"), "--at 1/2")[0].clone();
    assert!((middle[1] - 1.0).abs() < 1e-15 && (middle[2] - 4.0 / 3.0).abs() < 1e-15, "{middle:?}");
    assert_eq!(eval(r#""kind": "bspline", "degree": 1, "points": [0,1], "weights": [1,3]"#, "--at 1/2"), [[0.5, 0.75]]);
    shape_fails(r#""kind": "polyline", "points": [[0,0],[1,1]], "weights": [1,2]"#, &["F016", "/shapes/0/weights"]);
    shape_fails(&arch("1,2"), &["R003", "/shapes/0/weights", "2 weights for 3 points"]);
    let made = run("0,0,1\n1,2,2\n2,0,1\n", "curve - --kind bezier --weights column:2").done();
    assert!(made.contains(r#""weights": [1, 2, 1]"#), "{made}");
}
