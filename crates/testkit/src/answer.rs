//! Holds an answer in fractions, as JSON, against a case of `testdata/exact/`.
//!
//! The library and the tool are asked the same questions; both answer with the same JSON, whose members a case states: exactly
//! those that it states, each wholly. `testdata/exact/README.md` describes the fields.

use crate::corpus::Entry;
use crate::rational::Rational;
use serde_json::Value as Json;
use toml::Value;

/// Compares; returns how many numbers were held against each other.
///
/// # Panics
/// At the first difference, with its place.
pub fn compare(case: &Entry, found: &Json) -> usize {
    let mut numbers = 0;
    if case.has("answer") {
        for (member, expected) in case.entry("answer").table() {
            let place = format!("{}: {member}", case.place);
            numbers += equal(&place, expected, found.get(member).unwrap_or_else(|| panic!("{place} is not there")));
        }
    }
    if case.has("none") {
        for member in case.table()["none"].as_array().into_iter().flatten() {
            let place = format!("{}: {member}", case.place);
            assert_eq!(found.get(member.as_str().unwrap()), Some(&Json::Null), "{place}");
            numbers += 1;
        }
    }
    if case.has("pieces") {
        numbers += pieces(case, found);
    }
    assert!(numbers > 0, "{}: nothing is compared", case.place);
    numbers
}

fn fraction(place: &str, found: &Json) -> Rational {
    let text = found.as_str().unwrap_or_else(|| panic!("{place}: {found} is no fraction"));
    text.parse().unwrap_or_else(|error| panic!("{place}: {error}"))
}

fn equal(place: &str, expected: &Value, found: &Json) -> usize {
    match expected {
        Value::Integer(n) if found.is_number() => assert_eq!(found.as_i64(), Some(*n), "{place}"),
        Value::Integer(n) => assert_eq!(fraction(place, found), Rational::from(*n), "{place}"),
        Value::String(text) => match text.parse::<Rational>() {
            Ok(number) => assert_eq!(fraction(place, found), number, "{place}"),
            Err(_) => assert_eq!(found.as_str(), Some(&text[..]), "{place}"),
        },
        Value::Array(items) => {
            let list = found.as_array().unwrap_or_else(|| panic!("{place}: {found} is no list"));
            assert_eq!(items.len(), list.len(), "{place}: {found}");
            let each = items.iter().zip(list).enumerate();
            return each.map(|(i, (expected, found))| equal(&format!("{place}[{i}]"), expected, found)).sum();
        }
        Value::Table(table) if table.contains_key("over") => {
            let over = Rational::from(table["over"].as_integer().unwrap());
            let what = table.get("rows").or_else(|| table.get("row")).unwrap();
            return scaled(place, &over, what, found);
        }
        Value::Table(table) => {
            let object = found.as_object().unwrap_or_else(|| panic!("{place}: {found} is no object"));
            assert!(object.keys().all(|key| table.contains_key(key)), "{place}: {found}");
            let each = table.iter().map(|(key, expected)| {
                let found = object.get(key).unwrap_or_else(|| panic!("{place}.{key} is not there"));
                equal(&format!("{place}.{key}"), expected, found)
            });
            return each.sum();
        }
        other => panic!("{place}: {other} is no answer"),
    }
    1
}

/// Integers over a common denominator, against fractions.
fn scaled(place: &str, over: &Rational, expected: &Value, found: &Json) -> usize {
    match expected {
        Value::Integer(n) => {
            assert_eq!(fraction(place, found), Rational::from(*n) / over.clone(), "{place}");
            1
        }
        Value::Array(items) => {
            let list = found.as_array().unwrap_or_else(|| panic!("{place}: {found} is no list"));
            assert_eq!(items.len(), list.len(), "{place}: {found}");
            let each = items.iter().zip(list).enumerate();
            each.map(|(i, (expected, found))| scaled(&format!("{place}[{i}]"), over, expected, found)).sum()
        }
        other => panic!("{place}: {other} is no integer"),
    }
}

/// The pieces of B-splines, and that on the spans that are named no other function lives.
fn pieces(case: &Entry, found: &Json) -> usize {
    let place = &case.place;
    let functions = found["functions"].as_array().unwrap();
    assert_eq!(functions.len(), case.count("functions"), "{place}");
    let (degree, knots) = (found["degree"].as_u64().unwrap() as usize, found["knots"].as_array().unwrap());
    let domain = [&knots[degree], &knots[functions.len()]].map(|knot| fraction(place, knot));
    assert_eq!(domain.to_vec(), case.numbers("domain"), "{place}");
    let expected = case.entries("pieces");
    let mut numbers = 0;
    for piece in &expected {
        let (from, to) = (piece.number("from"), piece.number("to"));
        let over = Rational::from(piece.count_if("over").unwrap_or(1) as i64);
        let here = |of: &&Json| fraction(place, &of["from"]) == from && fraction(place, &of["to"]) == to;
        let on_span = |function: &Json| function["pieces"].as_array().unwrap().iter().find(here).cloned();
        let index = piece.count("function");
        let made = on_span(&functions[index]).unwrap_or_else(|| panic!("{place}: N{index} is zero on [{from}, {to}]"));
        let made: Vec<Rational> = made["coefficients"].as_array().unwrap().iter().map(|c| fraction(place, c)).collect();
        let wanted: Vec<Rational> = piece.numbers("coefficients").into_iter().map(|c| c / over.clone()).collect();
        assert_eq!(made, wanted, "{place}: N{index} on [{from}, {to}]");
        numbers += wanted.len();
        let alive = functions.iter().filter(|function| on_span(function).is_some()).count();
        let named = expected.iter().filter(|other| other.number("from") == from && other.number("to") == to).count();
        assert_eq!(alive, named, "{place}: functions on [{from}, {to}]");
    }
    numbers
}
