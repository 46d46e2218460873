//! Recorded values of another system: every curve through points in `testdata/reference`, through the command line.
//!
//! Points and parameters go in as CSV with a column `t`, the sites as a file; what comes back is compared column by column
//! with what scipy computed: values of cubic splines to 1e-12 of the column's largest magnitude, all else to 1e-10.
#![allow(clippy::unwrap_used, clippy::panic)] // a failing unwrap is a failing test

mod tool;

use serde_json::Value;
use std::fmt::Write as _;
use tool::{Folder, lath, numbers, real, repository, rows, shape};

/// A set of points with sites, by the name of the file in the repository.
fn reference(name: &str) -> Value {
    serde_json::from_str(&std::fs::read_to_string(repository(&format!("testdata/reference/{name}"))).unwrap()).unwrap()
}

/// The rows of an array of arrays, or of numbers.
fn points(value: &Value) -> Vec<Vec<f64>> {
    value.as_array().unwrap().iter().map(numbers).collect()
}

/// `t,c0,c1,…` with a row for each point; text of numbers that reads back to the same bits.
fn csv(t: &[f64], points: &[Vec<f64>]) -> String {
    let mut text = "t".to_owned();
    (0..points[0].len()).for_each(|c| write!(text, ",c{c}").unwrap());
    for (t, point) in t.iter().zip(points) {
        write!(text, "\n{t:e}").unwrap();
        point.iter().for_each(|x| write!(text, ",{x:e}").unwrap());
    }
    text + "\n"
}

/// `through … | eval - --at-file … --derivatives 2`, by files.
fn evaluate(points: &str, options: &[String], sites: &[f64]) -> Vec<Vec<f64>> {
    let folder = Folder::new();
    let points = folder.file("points.csv", points);
    let sites = folder.file("sites.txt", sites.iter().map(|t| format!("{t:e}\n")).collect::<String>());
    let curve = folder.path("curve.json");
    let through = ["through", &points, "--params", "column:t", "-o", &curve].map(String::from);
    assert_eq!(lath(through.iter().chain(options)).done(), "");
    rows(&lath(["eval", &curve, "--at-file", &sites, "--derivatives", "2"]).done())
}

/// Compares the answers with `value`, `d1`, `d2`, each where it is recorded.
fn compare(name: &str, answers: &[Vec<f64>], recorded: &Value) {
    compare_to([1e-12, 1e-10, 1e-10], name, answers, recorded);
}

/// The same to other tolerances.
fn compare_to(tolerances: [f64; 3], name: &str, answers: &[Vec<f64>], recorded: &Value) {
    let mut compared = 0;
    for (order, (key, tolerance)) in ["value", "d1", "d2"].into_iter().zip(tolerances).enumerate() {
        let Some(expected) = recorded.get(key) else {
            continue;
        };
        let expected = points(expected);
        let dimension = expected[0].len();
        assert_eq!(answers.len(), expected.len(), "{name} {key}");
        for c in 0..dimension {
            let largest = expected.iter().fold(0.0, |m: f64, row| m.max(row[c].abs()));
            for (answer, expected) in answers.iter().zip(&expected) {
                let off = (answer[1 + order * dimension + c] - expected[c]).abs();
                assert!(
                    off <= tolerance * largest,
                    "{name} {key} column {c} at t = {}: off by {off:e} of {largest:e}",
                    answer[0]
                );
            }
        }
        compared += 1;
    }
    assert!(compared >= 2, "{name}: values and slopes are recorded");
}

/// The options of `through` for an entry of `interpolation.json`.
fn options(entry: &str, dimension: usize, vectors: &Value) -> Vec<String> {
    let vector = |word: &str, end: &str| {
        let numbers = numbers(&vectors[end]).iter().map(f64::to_string).collect::<Vec<_>>();
        format!("{word}:{}", numbers.join(","))
    };
    let clamped = |end| vector("clamped", end);
    let second = |end| vector("second", end);
    let zero = format!("clamped:{}", vec!["0"; dimension].join(","));
    let open = |start: String, end: String| vec!["--start".into(), start, "--end".into(), end];
    match entry {
        "cubic_natural" => vec!["--ends".into(), "natural".into()],
        "cubic_not-a-knot" => vec![],
        "cubic_clamped" => vec!["--ends".into(), zero],
        "cubic_slopes" => open(clamped("start"), clamped("end")),
        "cubic_second" => open(second("start"), second("end")),
        "cubic_slope_start_natural_end" => open(clamped("start"), "natural".into()),
        "cubic_not_a_knot_start_second_end" => open("not-a-knot".into(), second("end")),
        "cubic_periodic" => vec!["--closed".into()],
        other => panic!("no options are known for {other}"),
    }
}

#[test]
fn every_cubic_of_the_interpolation_file() {
    let mut entries = 0;
    for set in reference("interpolation.json")["sets"].as_array().unwrap() {
        let (t, y, query) = (numbers(&set["t"]), points(&set["y"]), numbers(&set["query"]));
        let results = set["results"].as_object().unwrap();
        for (entry, recorded) in results.iter().filter(|(entry, _)| entry.starts_with("cubic_")) {
            let options = options(entry, y[0].len(), &results.get("end_vectors").cloned().unwrap_or(Value::Null));
            let name = format!("{} {entry}", set["name"]);
            compare(&name, &evaluate(&csv(&t, &y), &options, &query), recorded);
            entries += 1;
        }
    }
    assert_eq!(entries, 22);
}

/// The options for an entry that is no cubic spline.
fn kind(entry: &str) -> Vec<String> {
    let words = |words: &str| words.split(' ').map(str::to_owned).collect::<Vec<_>>();
    match entry.split_once("_k") {
        Some(("bspline", degree)) => words(&format!("--kind bspline --degree {degree}")),
        Some(("bspline_periodic", degree)) => words(&format!("--kind bspline --degree {degree} --closed")),
        _ => words(&format!("--kind {entry}")),
    }
}

#[test]
fn every_other_kind_of_the_interpolation_file() {
    let mut entries = Vec::new();
    for set in reference("interpolation.json")["sets"].as_array().unwrap() {
        let (t, y, query) = (numbers(&set["t"]), points(&set["y"]), numbers(&set["query"]));
        for (entry, recorded) in set["results"].as_object().unwrap() {
            if entry.starts_with("cubic_") || entry == "end_vectors" {
                continue;
            }
            let name = format!("{} {entry}", set["name"]);
            compare_to([1e-10; 3], &name, &evaluate(&csv(&t, &y), &kind(entry), &query), recorded);
            entries.push(entry.clone());
        }
    }
    let count = |entry: &str| entries.iter().filter(|found| found.starts_with(entry)).count();
    assert_eq!(["pchip", "akima", "makima", "bspline_k", "bspline_periodic_k"].map(count), [3, 3, 3, 18, 2]);
    assert_eq!(entries.len(), 29);
}

#[test]
fn knots_and_control_points_of_interpolating_bsplines() {
    let mut compared = 0;
    for set in reference("interpolation.json")["sets"].as_array().unwrap() {
        let (t, y) = (numbers(&set["t"]), points(&set["y"]));
        for (entry, recorded) in set["results"].as_object().unwrap().iter().filter(|(_, r)| r["knots"].is_array()) {
            let through = ["through", "-", "--params", "column:t"].map(String::from);
            let made = shape(&tool::lath_from(csv(&t, &y), through.iter().chain(&kind(entry))).done());
            for (member, key) in [("knots", "knots"), ("points", "coefficients")] {
                let (own, theirs) = (numbers(&made[member]), numbers(&recorded[key]));
                assert_eq!(own.len(), theirs.len(), "{} {entry} {key}", set["name"]);
                let largest = theirs.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
                let off = own.iter().zip(&theirs).fold(0.0, |m: f64, (a, b)| m.max((a - b).abs()));
                assert!(off <= 1e-10 * largest, "{} {entry} {key}: off by {off:e} of {largest:e}", set["name"]);
                compared += 1;
            }
        }
    }
    assert_eq!(compared, 36);
}

#[test]
fn every_cubic_of_the_nile_file() {
    let nile = reference("nile_interpolation.json");
    let query = numbers(&nile["query"]);
    let series = std::fs::read_to_string(real("nile_flow.csv")).unwrap();
    let (year, mut volume): (Vec<f64>, Vec<Vec<f64>>) = rows(&series).iter().map(|row| (row[0], vec![row[1]])).unzip();
    for (entry, options) in
        [("natural", "--ends natural"), ("not_a_knot", "--ends not-a-knot"), ("clamped_0_0", "--ends clamped:0")]
    {
        let options: Vec<String> = options.split(' ').map(str::to_owned).collect();
        compare(entry, &evaluate(&csv(&year, &volume), &options, &query), &nile["results"][entry]);
    }
    let last = volume.len() - 1;
    volume[last] = volume[0].clone();
    let entry = "periodic_last_y_set_to_first";
    compare(entry, &evaluate(&csv(&year, &volume), &["--closed".to_owned()], &query), &nile["results"][entry]);
}

#[test]
fn parameters_of_an_airfoil() {
    let file = reference("interpolation.json");
    for (set, rule) in [("rae2822 chord length", "chord"), ("rae2822 centripetal", "centripetal")] {
        let set = file["sets"].as_array().unwrap().iter().find(|s| s["name"] == set).unwrap();
        let curve = lath(["through", &real("rae2822.dat"), "--params", rule]).done();
        let (own, theirs) = (numbers(&shape(&curve)["parameters"]), numbers(&set["t"]));
        assert_eq!(own.len(), theirs.len());
        for (own, theirs) in own.iter().zip(&theirs) {
            assert!((own - theirs).abs() <= 1e-14 * theirs, "{rule}: {own:e} and {theirs:e}");
        }
        // With the tool's own parameters the recorded values come out as well.
        let folder = Folder::new();
        let sites = folder.file("t.txt", numbers(&set["query"]).iter().map(|t| format!("{t:e}\n")).collect::<String>());
        let curve = folder.file("curve.json", curve);
        let eval = ["eval", &curve, "--at-file", &sites, "--derivatives", "2", "--outside", "clamp"];
        compare(rule, &rows(&lath(eval).done()), &set["results"]["cubic_not-a-knot"]);
    }
}

#[test]
fn anticyclic_ends_are_opposite() {
    let half: String = (0..=12).map(|i| format!("{},{}\n", i * i, 7 - i % 5)).collect();
    let folder = Folder::new();
    for points in [folder.file("half.csv", half), real("rae2822.dat"), real("naca2412.dat")] {
        for rule in ["uniform", "chord", "centripetal"] {
            let curve = folder.path("curve.json");
            lath(["through", &points, "--params", rule, "--ends", "anticyclic", "-o", &curve]).done();
            let name = format!("{points} {rule}");
            opposite_in_the_file(&name, &shape(&std::fs::read_to_string(&curve).unwrap()));
            let all = rows(&lath(["eval", &curve, "--at", "breaks", "--derivatives", "2"]).done());
            let (first, last) = (&all[0], &all[all.len() - 1]);
            // Columns: t, x, y, x_1, y_1, x_2, y_2.
            for c in 3..7 {
                let largest = all.iter().fold(0.0, |m: f64, row| m.max(row[c].abs()));
                let off = (first[c] + last[c]).abs();
                // Over spans of 6e-4, differences of points near 1 leave fewer digits to second derivatives.
                let tolerance = if c >= 5 && rule == "chord" { 1e-10 } else { 1e-12 };
                assert!(off <= tolerance * largest, "{name} column {c}: off by {off:e} of {largest:e}");
            }
        }
    }
}

/// Both equations from the slopes themselves: m₀ = −mₙ, and (6δ − 4m₀ − 2m₁)/h at the start opposite to its mirror image at
/// the end.
fn opposite_in_the_file(name: &str, hermite: &Value) {
    let t = numbers(&hermite["parameters"]);
    let (p, m) = (points(&hermite["points"]), points(&hermite["tangents"]));
    let n = t.len() - 1;
    for c in 0..2 {
        let largest = |k: f64| m.iter().fold(0.0, |most: f64, row| most.max(k * row[c].abs()));
        let second = |i: usize, j: usize| {
            let h = t[j] - t[i];
            (6.0 * (p[j][c] - p[i][c]) / h - 4.0 * m[i][c] - 2.0 * m[j][c]) / h
        };
        let (start, end) = (second(0, 1), second(n, n - 1));
        assert!((m[0][c] + m[n][c]).abs() <= 1e-12 * largest(1.0), "{name}: slopes {:e} {:e}", m[0][c], m[n][c]);
        let scale = largest(6.0) / (t[1] - t[0]).min(t[n] - t[n - 1]);
        assert!((start + end).abs() <= 1e-12 * scale, "{name}: second derivatives {start:e} {end:e}");
    }
}

#[test]
fn the_pipe_agrees_with_the_files() {
    let nile = real("nile_flow.csv");
    let curve = lath(["through", &nile, "--params", "column:year", "--ends", "natural"]).done();
    let piped = tool::lath_from(&curve, ["eval", "-", "--at", "1900.5,1950"]).done();
    let folder = Folder::new();
    let path = folder.path("curve.json");
    lath(["through", &nile, "--params", "column:year", "--ends", "natural", "-o", &path]).done();
    assert_eq!(lath(["eval", &path, "--at", "1900.5,1950"]).done(), piped);
}
