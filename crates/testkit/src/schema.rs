//! JSON Schema, as far as the schemas of the repository use it.
//!
//! A validator that skips what it does not know lets everything pass. This one knows a few keywords, and panics on any
//! other; patterns are compared by their text with the few that there are.
//!
//! *Source.* JSON Schema, draft 2020-12.

use serde_json::Value;

/// Whether the value is what the schema says; `root` is the document in which `$ref` is looked up.
///
/// # Errors
/// The place of the fault, as a JSON pointer, and what is wrong there.
///
/// # Panics
/// If the schema uses a keyword, a type or a pattern that this validator does not know.
pub fn validate(root: &Value, schema: &Value, value: &Value) -> Result<(), String> {
    at("", root, schema, value)
}

fn at(place: &str, root: &Value, schema: &Value, value: &Value) -> Result<(), String> {
    let rules = schema.as_object().unwrap_or_else(|| panic!("a schema that is no object: {schema}"));
    for (keyword, rule) in rules {
        if !holds(place, root, schema, value, keyword, rule)? {
            return Err(format!("{place}: {keyword} {rule} does not fit {value}"));
        }
    }
    Ok(())
}

fn holds(
    place: &str,
    root: &Value,
    schema: &Value,
    value: &Value,
    keyword: &str,
    rule: &Value,
) -> Result<bool, String> {
    let schemas = || rule.as_array().unwrap().iter();
    let count = || usize::try_from(rule.as_u64().unwrap()).unwrap();
    Ok(match keyword {
        "$schema" | "$defs" | "title" | "description" => true,
        "$ref" => {
            let pointer = rule.as_str().unwrap().strip_prefix('#').unwrap();
            at(place, root, root.pointer(pointer).unwrap_or_else(|| panic!("no {pointer}")), value)?;
            true
        }
        "type" => match rule {
            Value::Array(types) => types.iter().any(|name| is(name, value)),
            name => is(name, value),
        },
        "const" => value == rule,
        "enum" => schemas().any(|choice| choice == value),
        "pattern" => value.as_str().is_none_or(|text| matches(rule.as_str().unwrap(), text)),
        "minimum" => value.as_f64().is_none_or(|x| x >= rule.as_f64().unwrap()),
        "maximum" => value.as_f64().is_none_or(|x| x <= rule.as_f64().unwrap()),
        "minItems" => value.as_array().is_none_or(|items| items.len() >= count()),
        "maxItems" => value.as_array().is_none_or(|items| items.len() <= count()),
        "items" => {
            for (i, item) in value.as_array().into_iter().flatten().enumerate() {
                at(&format!("{place}/{i}"), root, rule, item)?;
            }
            true
        }
        "required" => match value.as_object() {
            Some(object) => schemas().all(|key| object.contains_key(key.as_str().unwrap())),
            None => true,
        },
        "properties" => {
            for (key, member) in value.as_object().into_iter().flatten() {
                if let Some(schema) = rule.get(key) {
                    at(&format!("{place}/{key}"), root, schema, member)?;
                }
            }
            true
        }
        "additionalProperties" => {
            let named = |key: &String| schema.get("properties").is_some_and(|named| named.get(key).is_some());
            let more = value.as_object().into_iter().flatten().filter(|(key, _)| !named(key));
            match rule {
                Value::Bool(allowed) => *allowed || more.count() == 0,
                schema => {
                    for (key, member) in more {
                        at(&format!("{place}/{key}"), root, schema, member)?;
                    }
                    true
                }
            }
        }
        "propertyNames" => {
            for key in value.as_object().into_iter().flatten().map(|(key, _)| key) {
                at(&format!("{place}/{key}"), root, rule, &Value::String(key.clone()))?;
            }
            true
        }
        "oneOf" => schemas().filter(|schema| at(place, root, schema, value).is_ok()).count() == 1,
        "anyOf" => schemas().any(|schema| at(place, root, schema, value).is_ok()),
        "allOf" => {
            for schema in schemas() {
                at(place, root, schema, value)?;
            }
            true
        }
        "not" => at(place, root, rule, value).is_err(),
        other => panic!("the validator does not know {other}"),
    })
}

fn is(name: &Value, value: &Value) -> bool {
    match name.as_str().unwrap() {
        "null" => value.is_null(),
        "object" => value.is_object(),
        "array" => value.is_array(),
        "string" => value.is_string(),
        "boolean" => value.is_boolean(),
        "number" => value.is_number(),
        "integer" => value.as_f64().is_some_and(|x| x.fract() == 0.0),
        other => panic!("type {other}"),
    }
}

fn matches(pattern: &str, text: &str) -> bool {
    let digits = |text: &str| !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
    match pattern {
        "^[0-9]+$" => digits(text),
        "^-?[0-9]+(/[0-9]+)?$" => {
            let (numerator, denominator) = text.split_once('/').unwrap_or((text, "1"));
            digits(numerator.strip_prefix('-').unwrap_or(numerator)) && digits(denominator)
        }
        other => panic!("pattern {other}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn a_fault_is_found_and_placed() {
        let root = json!({
            "$defs": {"fraction": {"type": "string", "pattern": "^-?[0-9]+(/[0-9]+)?$"}},
            "type": "object",
            "required": ["rows"],
            "properties": {"rows": {"type": "array", "items": {"$ref": "#/$defs/fraction"}}, "n": {"type": ["integer", "null"]}},
            "additionalProperties": false,
        });
        let fault = |value: Value| validate(&root, &root, &value).unwrap_err();
        assert_eq!(validate(&root, &root, &json!({"rows": ["1", "-2/3"], "n": null})), Ok(()));
        assert!(fault(json!({"rows": ["1", "0.5"]})).starts_with("/rows/1: pattern"));
        assert!(fault(json!({"rows": [1]})).starts_with("/rows/0: "));
        assert!(fault(json!({"n": 1})).starts_with(": required"));
        assert!(fault(json!({"rows": [], "m": 1})).starts_with(": additionalProperties"));
        assert!(fault(json!({"rows": [], "n": 1.5})).starts_with("/n: type"));
    }

    #[test]
    #[should_panic(expected = "the validator does not know multipleOf")]
    fn what_is_unknown_is_not_passed_over() {
        let schema = json!({"multipleOf": 2});
        let _ = validate(&schema, &schema, &json!(3));
    }
}
