//! The corpus through the command line: the same cases, the same exact answers, by files and pipes.
#![allow(clippy::unwrap_used, clippy::panic)] // helpers of tests stop at the first fault

mod tool;

use testkit::corpus::{Entry, load};
use testkit::rational::Rational;
use tool::{lath_from, numbers, rows, shape};

/// A TOML value as JSON: fractions become the floats that they are.
fn json(value: &toml::Value) -> serde_json::Value {
    match value {
        toml::Value::Integer(n) => (*n).into(),
        toml::Value::Float(x) => serde_json::Number::from_f64(*x).map_or(serde_json::Value::Null, Into::into),
        toml::Value::Boolean(b) => (*b).into(),
        toml::Value::String(text) => match text.parse::<Rational>() {
            Ok(fraction) => fraction.to_f64().into(),
            Err(_) => text.as_str().into(),
        },
        toml::Value::Array(items) => items.iter().map(json).collect(),
        toml::Value::Table(table) => table.iter().map(|(key, value)| (key.clone(), json(value))).collect(),
        toml::Value::Datetime(_) => panic!("no dates in the corpus"),
    }
}

/// Compares `eval` at the case's parameters, those that ask for the default side, with the exact answers.
fn compare(case: &Entry, curve: &str) -> usize {
    let asked: Vec<Entry> = case.entries("at").into_iter().filter(|at| at.text_if("side") != Some("left")).collect();
    if asked.is_empty() {
        return 0;
    }
    let orders = (1..).take_while(|k| asked[0].has(&format!("d{k}"))).count();
    let at: Vec<String> = asked.iter().map(|at| at.float("t").to_string()).collect();
    let arguments = ["eval", "-", "--at", &at.join(","), "--derivatives", &orders.to_string()].map(str::to_owned);
    let found = rows(&lath_from(curve, arguments).done());
    assert_eq!(found.len(), asked.len(), "{}", case.place);
    let dimension = asked[0].numbers("value").len();
    let mut compared = 0;
    for k in 0..=orders {
        let key = if k == 0 { "value".to_owned() } else { format!("d{k}") };
        let exact: Vec<Vec<f64>> =
            asked.iter().map(|at| at.numbers(&key).iter().map(Rational::to_f64).collect()).collect();
        let largest = exact.iter().flatten().fold(1.0, |most: f64, x| most.max(x.abs()));
        for (row, exact) in found.iter().zip(&exact) {
            for (found, exact) in row[1 + k * dimension..][..dimension].iter().zip(exact) {
                assert!((found - exact).abs() <= 1e-12 * largest, "{}: {key} at {}: {found}", case.place, row[0]);
                compared += 1;
            }
        }
    }
    compared
}

/// What is refused, is refused with exit code 3, by its code.
fn is_refused(case: &Entry, run: tool::Run) -> bool {
    let Some(code) = case.text_if("error") else { return false };
    run.fails(3, &[code]);
    true
}

/// Whether the case holds a number that JSON and CSV cannot write.
fn unwritable(value: &toml::Value) -> bool {
    match value {
        toml::Value::Float(x) => !x.is_finite(),
        toml::Value::Array(items) => items.iter().any(unwritable),
        toml::Value::Table(table) => table.values().any(unwritable),
        _ => false,
    }
}

#[test]
fn every_curve_answers_as_a_file() {
    let (mut compared, mut refused) = (0, 0);
    for case in load("curve") {
        let shape = toml::Value::Table(case.entry("shape").table().clone());
        if unwritable(&shape) {
            continue; // JSON has no NaN; the reader's own tests have the words for it
        }
        let file = serde_json::json!({"lath": 1, "shapes": [json(&shape)]}).to_string();
        if is_refused(&case, lath_from(&file, ["eval", "-", "--at", "breaks"])) {
            refused += 1;
            continue;
        }
        compared += compare(&case, &file);
    }
    assert!(compared > 200 && refused >= 10, "{compared} numbers compared, {refused} shapes refused");
}

#[test]
fn every_interpolant_answers_through_the_pipe() {
    let (mut compared, mut refused) = (0, 0);
    for case in load("interpolate") {
        if case.has("rule") {
            continue; // below
        }
        let points = case.float_rows("points");
        let parameters = case.floats("parameters");
        let table = |parameters: &[f64]| {
            let header: Vec<String> = (0..points.first().map_or(1, Vec::len)).map(|c| format!("c{c}")).collect();
            let mut text = format!("t,{}\n", header.join(","));
            for (t, point) in parameters.iter().zip(&points) {
                let fields: Vec<String> = std::iter::once(t).chain(point).map(f64::to_string).collect();
                text += &format!("{}\n", fields.join(","));
            }
            text
        };
        let mut arguments = vec!["through".to_owned(), "-".to_owned(), "--params".to_owned(), "column:t".to_owned()];
        if case.flag("closed") {
            let period = parameters.last().zip(parameters.first()).map_or(1.0, |(last, first)| last - first);
            arguments.extend(["--closed".to_owned(), "--period".to_owned(), period.to_string()]);
        }
        for key in ["start", "end", "ends"] {
            if let Some(condition) = case.text_if(key) {
                arguments.extend([format!("--{key}"), condition.to_owned()]);
            }
        }
        // A table cannot have more parameters than points, nor fewer.
        let extra = usize::from(case.flag("closed"));
        if parameters.len() != points.len() + extra || points.is_empty() {
            continue;
        }
        let run = lath_from(table(&parameters), &arguments);
        if parameters.iter().any(|t| !t.is_finite()) {
            run.fails(3, &["P002", ":"]); // in a table it is refused where it stands, whatever its column is for
            refused += 1;
            continue;
        }
        if is_refused(&case, run) {
            refused += 1;
            continue;
        }
        let curve = lath_from(table(&parameters), &arguments).done();
        let exact: Vec<f64> = case.rows("tangents").iter().flatten().map(Rational::to_f64).collect();
        let largest = exact.iter().fold(1.0, |most: f64, x| most.max(x.abs()));
        for (found, exact) in numbers(&shape(&curve)["tangents"]).iter().zip(&exact) {
            assert!((found - exact).abs() <= 1e-13 * largest, "{}: tangent {found}, not {exact}", case.place);
        }
        compared += compare(&case, &curve);
    }
    assert!(compared > 200 && refused >= 4, "{compared} numbers compared, {refused} refused");
}

#[test]
fn parameters_follow_their_rule_through_the_tool() {
    let (mut compared, mut refused) = (0, 0);
    for case in load("interpolate").into_iter().filter(|case| case.has("rule") && !case.has("given")) {
        let points = case.float_rows("points");
        // By the contract a repeated first point is the closing point of a closed curve, and no fault.
        if points.len() < 2 || (case.flag("closed") && points.first() == points.last()) {
            continue;
        }
        let text: String =
            points.iter().map(|row| row.iter().map(f64::to_string).collect::<Vec<_>>().join(",") + "\n").collect();
        let mut arguments = vec!["through", "-", "--params", case.text("rule")];
        if case.flag("closed") {
            arguments.push("--closed");
        }
        let run = lath_from(&text, &arguments);
        if is_refused(&case, run) {
            refused += 1;
            continue;
        }
        let found = numbers(&shape(&lath_from(&text, &arguments).done())["parameters"]);
        let exact: Vec<f64> = case.numbers("parameters").iter().map(Rational::to_f64).collect();
        assert_eq!(found.len(), exact.len(), "{}", case.place);
        for (found, exact) in found.iter().zip(exact) {
            assert!((found - exact).abs() <= 1e-14 * exact.abs(), "{}: {found}, not {exact}", case.place);
            compared += 1;
        }
    }
    assert!(compared > 10 && refused >= 1, "{compared} parameters compared, {refused} refused");
}
