//! The JSON Schemas of the repository: every document that is written validates, and what does not validate is refused.
#![allow(clippy::unwrap_used, clippy::panic)]

use lath::error::Limits;
use lath_io::source::Source;
use lath_io::{check, format, shapes};
use serde_json::{Value, json};
use testkit::schema::validate;

fn schema(name: &str) -> Value {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../schema").join(name);
    serde_json::from_slice(&std::fs::read(path).unwrap()).unwrap()
}

fn valid(root: &Value, schema: &Value, value: &Value) -> bool {
    validate(root, schema, value).is_ok()
}

/// One shape of every kind, open and closed.
fn documents() -> Vec<Value> {
    let shapes = [
        json!({"kind": "bezier", "name": "n", "points": [[0, 1], [2, 3]], "domain": [0, 2], "closed": false}),
        json!({"kind": "bspline", "degree": 1, "knots": [0, 0, 1, 1], "points": [0, 1]}),
        json!({"kind": "bspline", "degree": 2, "closed": true, "points": [[0], [1], [2]]}),
        json!({"kind": "bezier", "points": [[0, 1], [2, 3]], "weights": [1, 2]}),
        json!({"kind": "bspline", "degree": 1, "closed": true, "points": [0, 1], "weights": [0.5, 2]}),
        json!({"kind": "hermite", "parameters": [0, 1], "points": [[0], [1]], "tangents": [[1], [1]]}),
        json!({"kind": "hermite", "closed": true, "parameters": [0, 1, 2], "points": [0, 1], "tangents": [1, 1]}),
        json!({"kind": "polyline", "points": [[0, 1, 2], [3, 4, 5]]}),
        json!({"kind": "power", "breaks": [0, 1, 2], "coefficients": [[[0], [1]], [[2], [3]]]}),
        json!({"kind": "quintic-hermite", "parameters": [0, 1], "points": [0, 1], "tangents": [1, 1], "seconds": [0, 0]}),
        json!({"kind": "path", "closed": true, "pieces": [{"kind": "polyline", "points": [0, 1]}, {"kind": "bezier", "points": [1, 0]}]}),
    ];
    shapes.into_iter().map(|shape| json!({"lath": 1, "shapes": [shape]})).collect()
}

fn read(document: &Value) -> lath_io::Result<Vec<shapes::Shape>> {
    shapes::read(&Source::from_bytes("a.json", document.to_string()), &Limits::default())
}

#[test]
fn what_is_written_validates() {
    let schema = schema("lath.schema.json");
    for document in documents() {
        assert!(valid(&schema, &schema, &document), "{document}");
        let written: Value = serde_json::from_str(&shapes::to_string(&read(&document).unwrap()).unwrap()).unwrap();
        assert!(valid(&schema, &schema, &written), "{written}");
    }
    assert!(valid(&schema, &schema, &json!({"lath": 1, "shapes": []})));
}

/// Every document that differs from this one by one change, with the pointer of the value that was changed.
fn changed(document: &Value, at: &str, out: &mut Vec<(String, Value)>, rebuild: &dyn Fn(Value) -> Value) {
    for other in
        [json!(null), json!("word"), json!({}), json!([]), json!(true), json!(-1.5), json!([[]]), json!([null])]
    {
        if other != *document {
            out.push((at.to_owned(), rebuild(other)));
        }
    }
    match document {
        Value::Object(members) => {
            let mut more = members.clone();
            more.insert("unknown".to_owned(), json!(1));
            out.push((format!("{at}/unknown"), rebuild(Value::Object(more))));
            for (key, member) in members {
                let mut less = members.clone();
                less.shift_remove(key);
                out.push((at.to_owned(), rebuild(Value::Object(less))));
                let put = |value: Value| {
                    let mut with = members.clone();
                    with.insert(key.clone(), value);
                    rebuild(Value::Object(with))
                };
                changed(member, &format!("{at}/{key}"), out, &put);
            }
        }
        Value::Array(items) => {
            for (index, item) in items.iter().enumerate() {
                let put = |value: Value| {
                    let mut with = items.clone();
                    with[index] = value;
                    rebuild(Value::Array(with))
                };
                changed(item, &format!("{at}/{index}"), out, &put);
            }
        }
        _ => {}
    }
}

#[test]
fn every_violation_is_refused_with_its_pointer() {
    let schema = schema("lath.schema.json");
    let mut violations = 0;
    for document in documents() {
        let mut changes = Vec::new();
        changed(&document, "", &mut changes, &|value| value);
        for (at, changed) in changes {
            if valid(&schema, &schema, &changed) {
                continue;
            }
            violations += 1;
            let error = read(&changed).map(|_| ()).expect_err(&changed.to_string());
            if error.code().as_str() == "F021" {
                continue; // so different that it is no lath JSON at all
            }
            let pointer = error.place().pointer.clone().unwrap_or_else(|| panic!("{changed}: {error}"));
            // The place itself, what is in it, or what is around it; of an array of numbers and arrays either may be wrong.
            let list =
                at.rsplit_once('/').filter(|(_, last)| last.parse::<usize>().is_ok()).map_or(&*at, |(list, _)| list);
            let near = |a: &str, b: &str| a == b || a.strip_prefix(b).is_some_and(|rest| rest.starts_with('/'));
            assert!(
                near(&pointer, list) || near(&at, &pointer),
                "{changed}: {at} was changed, {pointer} refused: {error}"
            );
        }
    }
    assert!(violations > 1000, "{violations}");
}

#[test]
fn results_validate() {
    let report =
        check::check(&Source::from_bytes("a.csv", "1,2\n1,2\nx,3\n4,nan\n"), None, &Limits::default()).unwrap();
    let findings = schema("check.schema.json");
    assert!(valid(&findings, &findings, &serde_json::from_str(&check::to_json(&[&report])).unwrap()));
    assert!(!valid(&findings, &findings, &json!({"findings": [{"code": "W001"}]})));
    let rows = schema("eval.schema.json");
    let mut out = Vec::new();
    let mut sink = format::by_name("json").unwrap().rows(&mut out, Some(&["t".to_owned(), "x".to_owned()])).unwrap();
    sink.row(&[0.0, 1.5]).unwrap();
    sink.finish().unwrap();
    drop(sink);
    assert!(valid(&rows, &rows, &serde_json::from_slice(&out).unwrap()));
}
