//! `lath refine`: the same curve in another description, step by step.
#![allow(clippy::unwrap_used, clippy::panic)] // a failing unwrap is a failing test

mod tool;

use serde_json::Value;
use tool::{Folder, lath_from, numbers, rows, shape};

const ARCH: &str = "0,0\n1,2\n3,2\n4,0\n6,1\n";

fn bspline() -> String {
    lath_from(ARCH, ["curve", "-", "--kind", "bspline"]).done()
}

fn bezier() -> String {
    lath_from(ARCH, ["curve", "-", "--kind", "bezier"]).done()
}

fn ring() -> String {
    lath_from("1,0\n0,1\n-1,0\n0,-1\n", ["curve", "-", "--kind", "bspline", "--closed"]).done()
}

/// The curves after these steps; what is said is handed out too.
#[track_caller]
fn refine(curve: &str, steps: &str) -> (String, String) {
    let run = lath_from(curve, ["refine", "-"].into_iter().chain(steps.split_whitespace()));
    assert_eq!(run.code, Some(0), "{run:?}");
    (String::from_utf8(run.out).unwrap(), run.err)
}

/// The same, where there is nothing to say.
#[track_caller]
fn silently(curve: &str, steps: &str) -> String {
    let (curve, said) = refine(curve, steps);
    assert_eq!(said, "");
    curve
}

fn points_at(curve: &str, at: &str) -> Vec<Vec<f64>> {
    rows(&lath_from(curve, ["eval", "-", "--at", at]).done())
}

#[track_caller]
fn same(a: &str, b: &str, at: &str) {
    let (a, b) = (points_at(a, at), points_at(b, at));
    for (a, b) in a.iter().zip(&b) {
        assert!(a.iter().zip(b).all(|(x, y)| (x - y).abs() < 1e-13), "{a:?} is not {b:?}");
    }
}

#[test]
fn knots_degrees_and_directions_leave_the_points_where_they_are() {
    let curve = bspline();
    for steps in ["--insert 1/2,3/2", "--halve 2", "--elevate 2", "--elevate 1 --insert 1/3 --halve 1", "--clamp"] {
        same(&silently(&curve, steps), &curve, "0,0.3,1,1.7,2");
    }
    let elevated = shape(&silently(&curve, "--elevate 1"));
    assert_eq!(elevated["degree"], 4);
    assert_eq!(numbers(&elevated["knots"]), [0., 0., 0., 0., 0., 1., 1., 2., 2., 2., 2., 2.]);
    let back = silently(&curve, "--reverse");
    assert_eq!(points_at(&back, "0,0.5")[1][1..], points_at(&curve, "1.5")[0][1..]);
    let unit = silently(&curve, "--domain -1,1");
    assert_eq!(points_at(&unit, "-1/2")[0][1..], points_at(&curve, "1/2")[0][1..]);
}

#[test]
fn steps_are_taken_in_their_order() {
    let curve = bspline();
    // Half of the first unit, then the domain; and the other way round.
    let first = shape(&silently(&curve, "--trim 0,1 --domain 0,2"));
    let second = shape(&silently(&curve, "--domain 0,2 --trim 0,1"));
    assert_eq!(numbers(&first["knots"]).last(), Some(&2.0));
    assert_eq!(numbers(&second["knots"]).last(), Some(&1.0));
    // The same option again.
    let twice = shape(&silently(&curve, "--insert 1/2 --elevate 1 --insert 1/2"));
    assert_eq!(numbers(&twice["knots"]).iter().filter(|t| **t == 0.5).count(), 3);
}

#[test]
fn what_moves_points_says_by_how_much() {
    let curve = bspline();
    let (coarse, said) = refine(&curve, "--insert 1/2,3/2 --remove 1e-9");
    assert_eq!(numbers(&shape(&coarse)["knots"]), numbers(&shape(&curve)["knots"]));
    assert!(said.starts_with("lath: 2 knots removed, points moved by at most "), "{said}");
    let (lower, said) = refine(&curve, "--elevate 2 --reduce 2 --tolerance 1e-9");
    assert_eq!(shape(&lower)["degree"], 3);
    assert!(said.starts_with("lath: degree lowered by 2, points moved by at most "), "{said}");
    let (same, said) = refine(&curve, "--remove 1e-9");
    assert_eq!((same, said.as_str()), (curve.clone(), "lath: 0 knots removed, no point has moved\n"));
    // Quietly, if asked.
    assert_eq!(lath_from(&curve, ["refine", "-", "--quiet", "--reduce", "1"]).err, "");
    lath_from(&curve, ["refine", "-", "--reduce", "1", "--tolerance", "0.01"])
        .fails(3, &["Q005", "0.57", "above 0.01"]);
}

#[test]
fn parts_are_two_curves_and_join_to_one() {
    let parts = silently(&bezier(), "--split 1/4");
    let document: Value = serde_json::from_str(&parts).unwrap();
    let kinds: Vec<&str> = document["shapes"].as_array().unwrap().iter().map(|s| s["kind"].as_str().unwrap()).collect();
    assert_eq!(kinds, ["bezier", "bezier"]);
    let (whole, said) = refine(&parts, "--join 1e-9");
    assert!(said.contains("joined at t = 0.25, as one polynomial, points moved by at most"), "{said}");
    same(&whole, &bezier(), "0,0.1,0.25,0.8,1");
    // Both parts take the steps that follow.
    let ends: Value = serde_json::from_str(&silently(&bezier(), "--split 1/4 --elevate 1 --reverse")).unwrap();
    assert_eq!(ends["shapes"][1]["points"].as_array().unwrap().len(), 6);
    let apart = "0,0\n1,1\n".to_owned();
    let line = lath_from(&apart, ["curve", "-", "--kind", "bezier"]).done();
    let one: Value = serde_json::from_str(&line).unwrap();
    let two = serde_json::json!({"lath": 1, "shapes": [one["shapes"][0], one["shapes"][0]]}).to_string();
    lath_from(two, ["refine", "-", "--join", "1e-3"]).fails(3, &["C004", "1e-3"]);
}

#[test]
fn closed_curves_turn_open_and_close() {
    let ring = ring();
    let turned = silently(&ring, "--seam 1.5");
    assert_eq!(shape(&turned)["closed"], true);
    same(&turned, &ring, "1.5,2,3.5,4");
    let open = silently(&ring, "--clamp");
    assert_eq!(shape(&open)["closed"], Value::Null);
    same(&open, &ring, "0,1.2,4");
    let (again, said) = refine(&open, "--close 1e-9");
    assert_eq!(shape(&again)["points"].as_array().unwrap().len(), 4);
    assert!(said.starts_with("lath: closed, "), "{said}");
    lath_from(bspline(), ["refine", "-", "--close", "1e-3"]).fails(3, &["C004"]);
    lath_from(bspline(), ["refine", "-", "--seam", "1"]).fails(3, &["C005"]);
}

#[test]
fn other_families_become_bsplines() {
    let through = lath_from(ARCH, ["through", "-"]).done();
    assert_eq!(shape(&through)["kind"], "hermite");
    let finer = silently(&through, "--insert 0.5");
    assert_eq!(shape(&finer)["kind"], "bspline");
    same(&finer, &through, "0.1,0.5,2");
    // Derivative and antiderivative undo each other, but for the start.
    let curve = bspline();
    let round = silently(&curve, "--antiderivative --derivative");
    same(&round, &curve, "0,0.3,1,2");
}

#[test]
fn bad_steps_are_refused() {
    let curve = bspline();
    for (steps, words) in [
        ("", &["no step"][..]),
        ("--tolerance 1 --clamp", &["--tolerance", "--reduce"]),
        ("--elevate 0", &["--elevate"]),
        ("--elevate -1", &["--elevate"]),
        ("--trim 1", &["--trim", "two numbers"]),
        ("--insert nan", &["--insert"]),
        ("--remove 0", &["--remove"]),
        ("--remove -1", &["--remove"]),
        ("--elevat 1", &["--elevat"]),
    ] {
        lath_from(&curve, ["refine", "-"].into_iter().chain(steps.split_whitespace())).fails(2, words);
    }
    for (steps, words) in [
        ("--insert 7", &["T002", "[0.0, 2.0]"][..]),
        ("--insert 1,1,1,1", &["K003", "degree + 1"]),
        ("--trim 1,1/2", &["T003"]),
        ("--trim -1,1", &["T002"]),
        ("--split 0", &["T002"]),
        ("--elevate 998", &["K006"]),
        ("--reduce 4", &["K006"]),
        ("--domain 1,0", &["T003"]),
        ("--domain 1e300,1.1e300", &["K007"]),
    ] {
        lath_from(&curve, ["refine", "-"].into_iter().chain(steps.split_whitespace())).fails(3, words);
    }
    lath_from(&curve, ["refine", "-", "--halve", "40"]).fails(5, &["B001"]);
    lath_from(&curve, ["refine", "-", "--halve", "3", "--budget", "10"]).fails(5, &["B001"]);
    lath_from("{\"lath\": 1, \"shapes\": []}", ["refine", "-", "--clamp"]).fails(3, &["A002"]);
    let folder = Folder::new();
    let file = folder.file("curve.json", &curve);
    let out = folder.path("finer.csv");
    tool::lath(["refine", &file, "--halve", "1", "-o", &out]).fails(2, &["csv"]);
}

#[test]
fn curves_are_converted_to_every_form_that_holds_them() {
    let curve = bspline();
    let folder = Folder::new();
    let input = folder.file("curve.json", &curve);
    let convert = |form: &str| {
        let run = tool::lath(["convert", &input, "-", "--to", form]);
        assert_eq!(run.code, Some(0), "{run:?}");
        (String::from_utf8(run.out).unwrap(), run.err)
    };
    let (pieces, said) = convert("bezier");
    let pieces: Value = serde_json::from_str(&pieces).unwrap();
    assert_eq!((pieces["shapes"].as_array().unwrap().len(), said.as_str()), (2, ""));
    assert_eq!(numbers(&pieces["shapes"][1]["domain"]), [1.0, 2.0]);
    let (power, said) = convert("power");
    assert_eq!((shape(&power)["kind"].as_str(), said.as_str()), (Some("power"), ""));
    same(&power, &curve, "0,0.3,1,1.7,2");
    let (hermite, said) = convert("hermite");
    assert!(said.starts_with("lath: tangents on both sides agree within "), "{said}");
    same(&hermite, &curve, "0,0.3,1,1.7,2");
    // And back: the knots are double ones, until those that nothing needs are removed.
    let back = lath_from(&hermite, ["convert", "-", "-", "--to", "bspline"]).done();
    let (back, _) = refine(&back, "--remove 1e-9");
    assert_eq!(numbers(&shape(&back)["knots"]), numbers(&shape(&curve)["knots"]));
    let quartic = silently(&curve, "--elevate 1");
    lath_from(&quartic, ["convert", "-", "-", "--to", "hermite"]).fails(3, &["Q006", "degree 4"]);
    let corner = lath_from("0,0\n1,1\n2,0\n", ["curve", "-", "--kind", "bspline", "--degree", "1"]).done();
    lath_from(&corner, ["convert", "-", "-", "--to", "hermite"]).fails(3, &["Q006", "one tangent at t = 1"]);
    tool::lath(["convert", &input, &folder.path("out.csv"), "--to", "power"]).fails(2, &["csv"]);
    tool::lath(["convert", &input, "-", "--to", "nurbs"]).fails(2, &["bezier", "bspline"]);
}
