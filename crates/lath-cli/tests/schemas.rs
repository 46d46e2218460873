//! The JSON objects of the tool are what their schemas say.
#![allow(clippy::unwrap_used, clippy::panic)] // a failing unwrap is a failing test

mod tool;

use serde_json::Value;
use testkit::schema::validate;
use tool::{lath, lath_from, real};

#[track_caller]
fn conforms(schema: &str, output: &str) {
    let (schema, output): (Value, Value) =
        (serde_json::from_str(schema).unwrap(), serde_json::from_str(output).unwrap());
    validate(&schema, &schema, &output).unwrap_or_else(|fault| panic!("{fault}\n{output}"));
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
    let length = include_str!("../../../schema/length.schema.json");
    for shapes in [&curve, named] {
        conforms(length, &lath_from(shapes, ["length", "-", "--json"]).done());
    }
    conforms(eval, &lath_from(&curve, ["sample", "-", "--count", "4", "--json"]).done());
    let wave = lath_from("1\n5\n3\n4\n", ["through", "-"]).done();
    conforms(info, &lath_from(wave, ["info", "-", "--json"]).done());
    for points in ["rae2822.dat", "nile_flow.csv"] {
        conforms(info, &lath(["info", &real(points), "--json"]).done());
    }
}
