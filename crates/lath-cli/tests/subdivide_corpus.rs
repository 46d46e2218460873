//! The cases of subdivision through the command line: polygons by `subdivide`, weights, leaps and schemes by `exact`.
#![allow(clippy::unwrap_used, clippy::panic)] // helpers of tests stop at the first fault

mod tool;

use serde_json::Value;
use testkit::corpus::{Entry, load};
use testkit::rational::Rational;
use tool::{Run, lath, lath_from, rows};

fn cases(kind: &str) -> Vec<Entry> {
    let found: Vec<Entry> = load("subdivide").into_iter().filter(|case| case.text("kind") == kind).collect();
    assert!(!found.is_empty());
    found
}

/// `lath subdivide` of the case's polygon with these options.
fn subdivide(case: &Entry, options: &[&str]) -> Run {
    let row = |row: &Vec<f64>| row.iter().map(f64::to_string).collect::<Vec<_>>().join(",") + "\n";
    let points: String = case.float_rows("points").iter().map(row).collect();
    let ends = match case.text_if("ends") {
        Some("kept") => &["--keep-ends"][..],
        Some("closed") => &["--closed"],
        _ => &[],
    };
    lath_from(points, [&["subdivide", "-", "--scheme", case.text("scheme")], ends, options].concat())
}

/// The options that ask for a level, or for one point of it.
fn asking(at: &Entry, limit: bool) -> Vec<String> {
    let level = at.count("level");
    let mut options = match at.text_if("index") {
        Some(index) => vec!["--only".to_owned(), format!("{level}:{index}")],
        None => vec!["--levels".to_owned(), level.to_string()],
    };
    if limit || at.text_if("target") == Some("limit") {
        options.push("--limit".to_owned());
    }
    options
}

fn same(found: &[Vec<f64>], exact: &[Vec<Rational>], size: f64, place: &str) {
    assert_eq!(found.len(), exact.len(), "{place}");
    for (x, exact) in found.iter().flatten().zip(exact.iter().flatten()) {
        assert!((x - exact.to_f64()).abs() <= 4e-14 * size, "{place}: {x}, not {exact}");
    }
}

#[test]
fn polygons_have_their_levels_limits_and_points() {
    let mut compared = 0;
    for case in cases("polygon").iter().filter(|case| !case.has("error")) {
        let size = case.float_rows("points").iter().flatten().fold(1.0, |most: f64, x| most.max(x.abs()));
        let mut ask = |at: &Entry, limit: bool, exact: &[Vec<Rational>]| {
            let options = asking(at, limit);
            let options: Vec<&str> = options.iter().map(String::as_str).collect();
            same(&rows(&subdivide(case, &options).done()), exact, size, &format!("{}: {options:?}", case.place));
            compared += 1;
        };
        case.entries("levels").iter().for_each(|at| ask(at, false, &at.rows("points")));
        case.entries("limits").iter().for_each(|at| ask(at, true, &at.rows("points")));
        case.entries("only").iter().for_each(|at| ask(at, false, &[at.numbers("point")]));
        case.entries("joints").iter().for_each(|at| ask(at, true, &[at.numbers("point")]));
    }
    assert!(compared > 75, "{compared}");
}

#[test]
fn what_is_refused_has_its_code() {
    let (mut by_data, mut by_words) = (0, Vec::new());
    for case in cases("polygon").iter().filter(|case| case.has("error")) {
        let options = if case.has("ask") { asking(&case.entry("ask"), false) } else { vec!["--levels=1".to_owned()] };
        let options: Vec<&str> = options.iter().map(String::as_str).collect();
        let run = subdivide(case, &options);
        match run.code {
            // What the words alone show to be wrong is said before any file is read, without a code.
            Some(2) => by_words.push(case.text("name").to_owned()),
            _ => {
                // A file without rows is refused before anybody asks for points.
                let empty = case.float_rows("points").is_empty();
                let code = if empty { "F001" } else { case.text("error") };
                run.fails(if code == "B001" { 5 } else { 3 }, &[code]);
                by_data += 1;
            }
        }
    }
    assert!(by_data > 15, "{by_data}");
    let words = ["mask-not-a-number", "tension-infinite", "index-negative", "index-in-science"];
    assert_eq!(by_words, words);
}

/// What `lath exact` answers as JSON.
fn exact(words: &[&str]) -> Value {
    serde_json::from_str(&lath([&["exact"], words, &["--json"]].concat()).done()).unwrap()
}

/// Fractions in an array, nested ones row after row.
fn fractions(value: &Value) -> Vec<Rational> {
    match value {
        Value::Array(items) => items.iter().flat_map(fractions).collect(),
        Value::String(text) => vec![text.parse().unwrap()],
        number => vec![Rational::from(number.as_i64().unwrap())],
    }
}

#[test]
fn groups_weigh_in_their_points_exactly() {
    let mut compared = 0;
    for case in cases("weights") {
        for at in case.entries("weights") {
            let question = if at.text("target") == "limit" { "limit" } else { "point" };
            let level = at.count("level").to_string();
            let words = [question, "--scheme", case.text("scheme"), "--level", &level, "--index", at.text("index")];
            assert_eq!(fractions(&exact(&words)["weights"]), at.numbers("weights"), "{}: {words:?}", case.place);
            compared += 1;
        }
    }
    assert!(compared > 20, "{compared}");
}

#[test]
fn triplets_and_powers_leap_as_they_do() {
    for case in cases("triplets") {
        let answer = exact(&["triplets", "--level", &case.count("level").to_string()]);
        let found: Vec<[u64; 2]> = answer["triplets"]
            .as_array()
            .unwrap()
            .iter()
            .map(|row| ["index", "from"].map(|key| row[key].as_u64().unwrap()))
            .collect();
        let wanted: Vec<[u64; 2]> =
            case.entries("triplets").iter().map(|row| ["index", "from"].map(|key| row.count(key) as u64)).collect();
        assert_eq!(found, wanted, "{}", case.place);
    }
    for case in cases("jump") {
        for at in case.entries("jumps") {
            let (from, to) = (format!("{}:{}", at.count("level"), at.text("index")), at.count("to").to_string());
            let answer = exact(&["jump", "--scheme", case.text("scheme"), "--from", &from, "--to-level", &to]);
            assert_eq!(fractions(&answer["matrix"]), at.rows("matrix").concat(), "{}: {from}", case.place);
            assert_eq!(answer["power"].as_u64(), Some(at.count("power") as u64), "{}: {from}", case.place);
            let lands = answer["to"]["index"].to_string();
            assert_eq!(lands.trim_matches('"'), at.text("lands"), "{}: {from}", case.place);
        }
    }
}

#[test]
fn schemes_have_their_matrices_exactly() {
    for case in cases("scheme") {
        let answer = exact(&["scheme", "--scheme", case.text("scheme")]);
        assert_eq!(answer["degree"].as_u64(), Some(case.count("degree") as u64), "{}", case.place);
        for (key, name) in [("local", "matrix"), ("group", "group_matrix"), ("q", "q"), ("q_inverse", "q_inverse")] {
            if case.has(key) {
                assert_eq!(fractions(&answer[name]), case.rows(key).concat(), "{}: {key}", case.place);
            }
        }
        if case.has("eigenvalues") {
            assert_eq!(fractions(&answer["eigenvalues"]), case.numbers("eigenvalues"), "{}", case.place);
        }
        for (name, mask) in ["limit", "tangent", "second"].iter().zip(case.rows("limit_masks")) {
            assert_eq!(fractions(&answer[name]), mask, "{}: {name}", case.place);
        }
    }
}
