//! The JSON objects of the tool are what their schemas say.
#![allow(clippy::unwrap_used, clippy::panic)] // a failing unwrap is a failing test

mod tool;

use serde_json::Value;
use tool::{lath, lath_from, real};

/// The few words of JSON Schema that the schemas here use.
fn check(schema: &Value, value: &Value, place: &str) {
    if let Some(types) = schema.get("type") {
        let found = match value {
            Value::Null => "null",
            Value::Bool(_) => "boolean",
            Value::Number(n) if n.is_u64() => "integer",
            Value::Number(_) => "number",
            Value::String(_) => "string",
            Value::Array(_) => "array",
            Value::Object(_) => "object",
        };
        let fits = |t: &Value| t == found || (t == "number" && found == "integer");
        assert!(
            types.as_array().map_or_else(|| fits(types), |types| types.iter().any(fits)),
            "{place} is of type {found}"
        );
    }
    let required = |schema: &Value| -> bool {
        schema["required"].as_array().is_none_or(|keys| keys.iter().all(|k| value.get(k.as_str().unwrap()).is_some()))
    };
    assert!(required(schema), "{place} lacks a member");
    if let Some(choices) = schema["oneOf"].as_array() {
        assert_eq!(choices.iter().filter(|choice| required(choice)).count(), 1, "{place}");
    }
    for (key, member) in value.as_object().into_iter().flatten() {
        let schema = schema["properties"].get(key);
        check(
            schema.unwrap_or_else(|| panic!("{place}/{key} is not in the schema")),
            member,
            &format!("{place}/{key}"),
        );
    }
    for (i, item) in value.as_array().into_iter().flatten().enumerate() {
        check(&schema["items"], item, &format!("{place}/{i}"));
    }
}

#[track_caller]
fn conforms(schema: &str, output: &str) {
    check(&serde_json::from_str(schema).unwrap(), &serde_json::from_str(output).unwrap(), "");
}

#[test]
fn every_object_conforms_to_its_schema() {
    let (eval, info) =
        (include_str!("../../../schema/eval.schema.json"), include_str!("../../../schema/info.schema.json"));
    let curve = lath(["through", &real("iceland.csv"), "--closed"]).done();
    conforms(eval, &lath_from(&curve, ["eval", "-", "--count", "7", "--derivatives", "2", "--json"]).done());
    conforms(info, &lath_from(&curve, ["info", "-", "--json"]).done());
    let named = r#"{"lath":1,"shapes":[{"kind":"bezier","points":[1,2.5],"name":"line"},{"kind":"polyline","points":[[0,0],[1,1]]}]}"#;
    conforms(info, &lath_from(named, ["info", "-", "--json"]).done());
    conforms(info, &lath_from(r#"{"lath":1,"shapes":[]}"#, ["info", "-", "--json"]).done());
    let wave = lath_from("1\n5\n3\n4\n", ["through", "-"]).done();
    conforms(info, &lath_from(wave, ["info", "-", "--json"]).done());
    for points in ["rae2822.dat", "nile_flow.csv"] {
        conforms(info, &lath(["info", &real(points), "--json"]).done());
    }
}
