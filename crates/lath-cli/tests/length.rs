//! `lath length`: lengths with their bounds, for people and for programs.
#![allow(clippy::unwrap_used, clippy::panic)] // a failing unwrap is a failing test

mod tool;

use serde_json::{Value, json};
use tool::{Run, lath, lath_from, real};

/// A parabola from −1 to 1 of length √5 + asinh(2)/2, and the 3-4-5 triangle.
const TWO: &str = r#"{"lath": 1, "shapes": [
  {"kind": "bezier", "points": [[-1,1],[0,-1],[1,1]], "name": "arch"},
  {"kind": "polyline", "points": [[0,0],[3,0],[3,4],[0,0]]}]}"#;
const PARABOLA: f64 = 2.957_885_715_089_195;

fn one(shape: &str) -> String {
    format!(r#"{{"lath":1,"shapes":[{shape}]}}"#)
}

#[track_caller]
fn object(run: Run) -> Value {
    serde_json::from_str(&run.done()).unwrap()
}

#[test]
fn one_line_a_shape_and_the_total() {
    let text = lath_from(TWO, ["length", "-"]).done();
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!(lines.len(), 3);
    assert!(lines[0].starts_with("shape 0 \"arch\"  2.95788571") && lines[0].contains(" ± "), "{text}");
    assert!(lines[1].starts_with("shape 1         12"), "{text}");
    assert!(lines[2].starts_with("total           14.95788571"), "{text}");
    let single = lath_from(one(r#"{"kind":"bezier","points":[[0,0],[3,4]]}"#), ["length", "-"]).done();
    assert!(single.starts_with("shape 0  5") && single.lines().count() == 1, "{single}");
}

#[test]
fn the_object_has_every_bound() {
    let found = object(lath_from(TWO, ["length", "-", "--json"]));
    assert_eq!(found.as_object().unwrap().keys().collect::<Vec<_>>(), ["count", "shapes", "length", "length_bound"]);
    let (arch, triangle) = (&found["shapes"][0], &found["shapes"][1]);
    let keys: Vec<_> = arch.as_object().unwrap().keys().collect();
    assert_eq!(keys, ["index", "kind", "name", "length", "length_bound"]);
    for (object, exact) in [(arch, PARABOLA), (triangle, 12.0), (&found, 12.0 + PARABOLA)] {
        let (length, bound) = (object["length"].as_f64().unwrap(), object["length_bound"]["value"].as_f64().unwrap());
        assert!((length - exact).abs() <= bound + 1e-15 && bound <= 1e-8, "{object}");
        assert_eq!(object["length_bound"]["proven"], json!(true));
    }
}

#[test]
fn every_accuracy_is_kept_or_said_to_be_missed() {
    for digits in 1..13 {
        let accuracy = format!("1e-{digits}");
        let found = object(lath_from(TWO, ["length", "-", "--json", "--accuracy", &accuracy]));
        for (shape, exact) in [(0, PARABOLA), (1, 12.0)] {
            let shape = &found["shapes"][shape];
            let bound = shape["length_bound"]["value"].as_f64().unwrap();
            assert!(bound <= accuracy.parse().unwrap(), "{accuracy}: {shape}");
            assert!((shape["length"].as_f64().unwrap() - exact).abs() <= bound, "{accuracy}: {shape}");
        }
    }
    for accuracy in ["1e-17", "1e-300", "5e-324"] {
        let run = lath_from(TWO, ["length", "-", "--json", "--accuracy", accuracy]);
        assert_eq!(run.code, Some(0));
        assert!(run.err.contains("is not reached") && run.err.starts_with("lath: "), "{}", run.err);
        let found: Value = serde_json::from_slice(&run.out).unwrap();
        assert!(found["length_bound"]["value"].as_f64().unwrap() < 1e-13, "{found}");
        let quiet = lath_from(TWO, ["length", "-", "--quiet", "--accuracy", accuracy]);
        assert_eq!((quiet.code, quiet.err.as_str()), (Some(0), ""));
    }
    for accuracy in ["0", "-1", "nan", "inf", "much"] {
        lath_from(TWO, ["length", "-", "--accuracy", accuracy]).fails(2, &["--accuracy"]);
    }
}

#[test]
fn points_wild_weights_and_sizes_have_a_length() {
    let length = |shape: &str| object(lath_from(one(shape), ["length", "-", "--json"]))["length"].as_f64().unwrap();
    assert_eq!(length(r#"{"kind":"bezier","points":[[7,7]]}"#), 0.0);
    assert_eq!(length(r#"{"kind":"bezier","points":[[7,7],[7,7],[7,7]]}"#), 0.0);
    for size in [1e-300, 1e-9, 1e9, 1e299] {
        let found = length(&format!(r#"{{"kind":"polyline","points":[[0,0],[{},{}]]}}"#, 3.0 * size, 4.0 * size));
        assert!((found / size - 5.0).abs() < 1e-14, "{found}");
    }
    // Up and down again: the way of the value.
    assert!((length(r#"{"kind":"bezier","points":[0,1,0]}"#) - 1.0).abs() < 1e-8);
    let half = std::f64::consts::FRAC_1_SQRT_2;
    let arc = format!(r#"{{"kind":"bezier","points":[[1,0],[1,1],[0,1]],"weights":[1,{half},1]}}"#);
    assert!((length(&arc) - std::f64::consts::FRAC_PI_2).abs() < 1e-8);
    let wild = r#"{"kind":"bezier","points":[[0,0],[1,1],[2,0]],"weights":[1,1e-12,1]}"#;
    assert!((length(wild) - 2.0).abs() < 1e-6);
}

#[test]
fn files_that_hold_no_curve_are_refused() {
    lath_from(r#"{"lath":1,"shapes":[]}"#, ["length", "-"]).fails(3, &["A002", "no shapes"]);
    lath(["length", &real("iceland.csv")]).fails(3, &["iceland.csv"]);
    lath(["length", "not there.json"]).fails(4, &["not there.json"]);
    let far = r#"{"kind":"hermite","parameters":[-1e300,1e300],"points":[0,1],"tangents":[1e298,-1e298]}"#;
    lath_from(one(far), ["length", "-"]).fails(3, &["P003", "overflows"]);
}
