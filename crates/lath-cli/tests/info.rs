//! `lath info`: curves and points, for people and for programs.
#![allow(clippy::unwrap_used, clippy::panic)] // a failing unwrap is a failing test

mod tool;

use serde_json::{Value, json};
use tool::{lath, lath_from, numbers, real};

const TWO: &str = r#"{"lath": 1, "shapes": [
  {"kind": "bezier", "points": [[0,0],[1,2],[2,0]], "name": "arch"},
  {"kind": "bspline", "degree": 2, "closed": true, "points": [[1,0,0],[0,1,0],[-1,0,5]]}]}"#;

#[test]
fn shapes_as_one_object() {
    let info: Value = serde_json::from_str(&lath_from(TWO, ["info", "-", "--json"]).done()).unwrap();
    assert_eq!(info["count"], 2);
    let (arch, ring) = (&info["shapes"][0], &info["shapes"][1]);
    let keys =
        ["index", "kind", "name", "degree", "dimension", "domain", "box", "box_bound", "closed", "rational", "breaks"];
    let more = ["continuity", "length", "length_bound"];
    assert_eq!(arch.as_object().unwrap().keys().collect::<Vec<_>>(), [&keys[..], &more].concat());
    assert_eq!((&arch["kind"], &arch["name"], &arch["degree"]), (&json!("bezier"), &json!("arch"), &json!(2)));
    assert_eq!(numbers(&arch["domain"]), [0.0, 1.0]);
    let (extent, slack) = (numbers(&arch["box"]), arch["box_bound"]["value"].as_f64().unwrap());
    let exact = [0.0, 0.0, 2.0, 1.0];
    assert!(slack < 1e-9 && extent.iter().zip(exact).all(|(a, b)| (a - b).abs() <= slack), "{extent:?} {slack:e}");
    assert_eq!(
        (&arch["box_bound"]["proven"], &arch["closed"], &arch["breaks"]),
        (&json!(true), &json!(false), &json!(2))
    );
    assert_eq!((&ring["index"], &ring["dimension"], &ring["closed"]), (&json!(1), &json!(3), &json!(true)));
    assert_eq!((numbers(&ring["domain"]), &ring["breaks"]), (vec![0.0, 3.0], &json!(4)));
    let none: Value =
        serde_json::from_str(&lath_from(r#"{"lath":1,"shapes":[]}"#, ["info", "-", "--json"]).done()).unwrap();
    assert_eq!(none, json!({"count": 0, "shapes": []}));
}

#[test]
fn points_as_one_object() {
    let info: Value = serde_json::from_str(&lath(["info", &real("rae2822.dat"), "--json"]).done()).unwrap();
    let points = &info["points"];
    assert_eq!(points.as_object().unwrap().keys().collect::<Vec<_>>(), ["rows", "columns", "names", "title", "box"]);
    assert_eq!((&points["rows"], &points["columns"], &points["names"]), (&json!(129), &json!(2), &Value::Null));
    assert_eq!(points["title"], "RAE 2822 AIRFOIL");
    assert_eq!(numbers(&points["box"]), [0.0, -0.059236, 1.0, 0.062779]);
    let info: Value = serde_json::from_str(&lath(["info", &real("nile_flow.csv"), "--json"]).done()).unwrap();
    assert_eq!((&info["points"]["names"], &info["points"]["rows"]), (&json!(["year", "volume"]), &json!(100)));
}

#[test]
fn continuity_length_and_closedness() {
    let info = |shape: &str| -> Value {
        let document = format!(r#"{{"lath":1,"shapes":[{shape}]}}"#);
        let info = lath_from(document, ["info", "-", "--json"]).done();
        serde_json::from_str::<Value>(&info).unwrap()["shapes"][0].clone()
    };
    let joins = |info: &Value| -> Vec<(f64, String)> {
        let joints = info["continuity"].as_array().unwrap().iter();
        joints.map(|j| (j["t"].as_f64().unwrap(), j["continuity"].as_str().unwrap().to_owned())).collect()
    };
    let knots = r#"{"kind":"bspline","degree":2,"knots":[0,0,0,1,2,2,3,3,3],
        "points":[[0,0],[1,2],[3,1],[4,4],[5,0],[6,1]]}"#;
    assert_eq!(joins(&info(knots)), [(1.0, "C1".to_owned()), (2.0, "C0".to_owned())]);
    let square = r#"{"kind":"bspline","degree":1,"closed":true,"points":[[0,0],[3,0],[3,4],[0,4]]}"#;
    let found = info(square);
    assert_eq!((joins(&found).len(), &found["closed"], found["length"].as_f64()), (4, &json!(true), Some(14.0)));
    let bounds = ["length_bound", "area_bound", "centroid_bound"].map(|bound| found[bound].clone());
    for bound in bounds {
        assert!(bound["proven"] == true && bound["value"].as_f64().unwrap() < 1e-13, "{found}");
    }
    assert_eq!((found["area"].as_f64(), numbers(&found["centroid"])), (Some(12.0), vec![1.5, 2.0]));
    // A parabola: √5 + asinh(2)/2.
    let found = info(r#"{"kind":"bezier","points":[[-1,1],[0,-1],[1,1]]}"#);
    let (length, bound) = (found["length"].as_f64().unwrap(), found["length_bound"]["value"].as_f64().unwrap());
    assert!((length - 2.957885715089195).abs() <= bound && bound <= 1e-6, "{length} {bound}");
    assert_eq!((joins(&found), &found["area"]), (vec![], &Value::Null));
    let graph = info(r#"{"kind":"bezier","points":[1,2.5]}"#);
    assert_eq!((&graph["length"], &graph["length_bound"]), (&Value::Null, &Value::Null));
    // A point, and sizes at both ends of what floats hold.
    for x in ["0", "1e-300", "1e299"] {
        let still = info(&format!(r#"{{"kind":"bezier","points":[[{x},0],[{x},0]]}}"#));
        assert_eq!(still["length"].as_f64(), Some(0.0), "{x}");
        let line = info(&format!(r#"{{"kind":"bezier","points":[[0,0],[{x},0]]}}"#));
        assert_eq!(line["length"].as_f64(), x.parse().ok());
    }
}

#[test]
fn text_says_how_the_pieces_join() {
    let text = |shape: &str| lath_from(format!(r#"{{"lath":1,"shapes":[{shape}]}}"#), ["info", "-"]).done();
    let spline = text(
        r#"{"kind":"bspline","degree":2,"knots":[0,0,0,1,2,3,4,4,5,5,5],"points":[[0,0],[1,2],[3,1],[4,4],[5,0],[6,1],[7,7],[8,1]]}"#,
    );
    assert!(spline.contains("  continuity C1 at 3 breaks, C0 at t = 4\n"), "{spline}");
    let arch = text(r#"{"kind":"bezier","points":[[0,0],[1,2],[2,0]]}"#);
    for line in ["  continuity one piece\n", "  box        [0, 2]\n", "  length     2.95788"] {
        assert!(arch.contains(line), "{line} in {arch}");
    }
    let corners = text(r#"{"kind":"polyline","points":[[0,0],[3,0],[3,4]]}"#);
    let ring = text(r#"{"kind":"bspline","degree":1,"closed":true,"points":[[0,0],[0,4],[3,4],[3,0]]}"#);
    assert!(ring.contains("  area       -12 ± "), "{ring}");
    assert!(corners.contains("  continuity C0 at 1 break\n") && corners.contains("  length     7 ± "), "{corners}");
}

#[test]
fn text_lines_up() {
    let text = lath_from(TWO, ["info", "-"]).done();
    let values = text.lines().filter(|line| line.starts_with("  ")).map(|line| line.split_at(13));
    for (label, value) in values {
        assert!(label.ends_with(' ') && !value.starts_with(' '), "{label}|{value}");
    }
    for line in
        ["standard input: 2 shapes", "shape 0 \"arch\"", "  degree     2", "  domain     [0, 3]", "  closed     yes"]
    {
        assert!(text.lines().any(|l| l == line), "{line} in {text}");
    }
    let text = lath(["info", &real("nile_flow.csv")]).done();
    for line in
        ["  rows       100", "  names      year, volume", "  box        [1871, 1970]", "             [456, 1370]"]
    {
        assert!(text.lines().any(|l| l == line), "{line} in {text}");
    }
}
