//! From text to tree, through serde_json's parser and a visitor of our own.

use std::collections::HashSet;
use std::fmt;
use std::hash::BuildHasher;

use lath::error::{Code as CoreCode, Limits};
use serde::de::{DeserializeSeed, Deserializer, MapAccess, SeqAccess, Visitor};
use serde_json::error::Category;

use crate::error::{Code, Error, Result};
use crate::json::Json;
use crate::source::Source;

/// No format here nests deeper than 6 levels.
const MAX_DEPTH: usize = 32;

/// The one JSON value of a source.
///
/// # Errors
/// F010 syntax, F011 text after the value, F012 nested too deep, F013 a key twice, F014 an inexact integer, P002 NaN or
/// infinity in place of a number, P003 a number too large, B001 a tree above `limits.max_bytes`; and what
/// [`Source::text`] refuses.
pub(crate) fn parse(source: &Source, limits: &Limits<'_>) -> Result<Json> {
    let text = source.text()?;
    let mut state = State { limits, bytes: text.len() as u64, fault: None };
    let mut deserializer = serde_json::Deserializer::from_str(text);
    let parsed = Node { state: &mut state, depth: 0 }.deserialize(&mut deserializer).map_err(|e| (e, false));
    parsed.and_then(|json| deserializer.end().map(|()| json).map_err(|e| (e, true))).map_err(|(error, after)| {
        let offset = offset_of(text, error.line(), error.column());
        let fault = state.fault.take().unwrap_or_else(|| syntax(text, offset, &error, after));
        let offset = match fault.code() {
            Code::F014 | Code::Core(CoreCode::P002 | CoreCode::P003) => start_of_number(text, offset),
            _ => offset,
        };
        source.fault(offset, fault)
    })
}

/// serde_json counts lines by LF and columns in bytes; this is the offset of the byte it means.
fn offset_of(text: &str, line: usize, column: usize) -> usize {
    let start = match line.checked_sub(2) {
        Some(n) => text.bytes().enumerate().filter(|&(_, b)| b == b'\n').nth(n).map_or(text.len(), |(i, _)| i + 1),
        None => 0,
    };
    let mut offset = (start + column.saturating_sub(1)).min(text.len());
    while !text.is_char_boundary(offset) {
        offset -= 1;
    }
    offset
}

/// Where the number begins that reaches to this byte, or the word in its place.
fn start_of_number(text: &str, offset: usize) -> usize {
    let belongs = |byte: &u8| byte.is_ascii_alphanumeric() || b"+-.".contains(byte);
    let before = text.as_bytes().get(..offset).unwrap_or_default();
    offset - before.iter().rev().take_while(|byte| belongs(byte)).count()
}

/// The error for what serde_json refuses, in our words where users meet it often.
fn syntax(text: &str, offset: usize, error: &serde_json::Error, after: bool) -> Error {
    if after {
        return Error::new(Code::F011, "something follows the end of the JSON value");
    }
    if error.classify() == Category::Eof {
        return Error::new(Code::F010, "the JSON ends too early")
            .remedied("Close all brackets and quotes; the file may be cut off.");
    }
    let said = error.to_string();
    let said = said.split(" at line ").next().unwrap_or_default();
    if said == "number out of range" {
        return Error::new(Code::Core(CoreCode::P003), "a number is beyond the greatest double, 1.8e308");
    }
    let word: String = text.get(offset..).unwrap_or_default().chars().take_while(|c| c.is_ascii_alphabetic()).collect();
    let before = text
        .get(..offset)
        .unwrap_or_default()
        .chars()
        .rev()
        .take_while(|c| c.is_ascii_alphabetic())
        .collect::<Vec<_>>();
    let word = before.into_iter().rev().collect::<String>() + &word;
    if ["nan", "inf", "infinity"].iter().any(|w| word.eq_ignore_ascii_case(w)) {
        return Error::new(Code::Core(CoreCode::P002), format!("\"{word}\" is not a finite number"));
    }
    Error::new(Code::F010, format!("this is not JSON: {said}"))
}

/// What all nodes of one tree share while it is read.
struct State<'a> {
    limits: &'a Limits<'a>,
    /// What text and tree take so far, about.
    bytes: u64,
    /// The fault a visitor found; serde only carries its place.
    fault: Option<Error>,
}

impl State<'_> {
    fn count<E: serde::de::Error>(&mut self, bytes: usize) -> Result<(), E> {
        self.bytes = self.bytes.saturating_add(bytes as u64);
        match self.limits.check_bytes(self.bytes).and_then(|()| self.limits.check_cancel()) {
            Ok(()) => Ok(()),
            Err(error) => Err(self.refuse(error.into())),
        }
    }

    fn refuse<E: serde::de::Error>(&mut self, error: Error) -> E {
        self.fault = Some(error);
        E::custom("refused")
    }
}

/// One value to be read, at its depth.
struct Node<'s, 'a> {
    state: &'s mut State<'a>,
    depth: usize,
}

impl<'a> Node<'_, 'a> {
    fn inner<E: serde::de::Error>(&mut self) -> Result<Node<'_, 'a>, E> {
        if self.depth == MAX_DEPTH {
            let message = format!("brackets are nested deeper than {MAX_DEPTH} levels");
            return Err(self.state.refuse(Error::new(Code::F012, message)));
        }
        Ok(Node { state: self.state, depth: self.depth + 1 })
    }

    fn integer<E: serde::de::Error>(self, value: i128) -> Result<Json, E> {
        let nearest = value as f64;
        if nearest as i128 == value {
            return Ok(Json::Number(nearest));
        }
        let message = format!("the integer {value} is beyond 2^53 and no double holds it exactly");
        Err(self.state.refuse(Error::new(Code::F014, message)))
    }
}

impl<'de> DeserializeSeed<'de> for Node<'_, '_> {
    type Value = Json;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Json, D::Error> {
        deserializer.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for Node<'_, '_> {
    type Value = Json;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a JSON value")
    }

    fn visit_unit<E>(self) -> Result<Json, E> {
        Ok(Json::Null)
    }

    fn visit_bool<E>(self, value: bool) -> Result<Json, E> {
        Ok(Json::Bool(value))
    }

    fn visit_f64<E>(self, value: f64) -> Result<Json, E> {
        Ok(Json::Number(value))
    }

    fn visit_u64<E: serde::de::Error>(self, value: u64) -> Result<Json, E> {
        self.integer(i128::from(value))
    }

    fn visit_i64<E: serde::de::Error>(self, value: i64) -> Result<Json, E> {
        self.integer(i128::from(value))
    }

    fn visit_str<E: serde::de::Error>(self, value: &str) -> Result<Json, E> {
        self.state.count(value.len())?;
        Ok(Json::Text(value.into()))
    }

    fn visit_seq<A: SeqAccess<'de>>(mut self, mut items: A) -> Result<Json, A::Error> {
        let mut numbers = Vec::new();
        let first = loop {
            match items.next_element_seed(self.inner()?)? {
                None => return Ok(Json::Numbers(numbers.into())),
                Some(Json::Number(number)) => numbers.push(number),
                Some(other) => break other,
            }
            self.state.count(size_of::<f64>())?;
        };
        let mut values: Vec<Json> = numbers.into_iter().map(Json::Number).collect();
        self.state.count(values.len().saturating_mul(size_of::<Json>()))?;
        let mut next = Some(first);
        while let Some(value) = next {
            values.push(value);
            self.state.count(size_of::<Json>())?;
            next = items.next_element_seed(self.inner()?)?;
        }
        Ok(Json::Array(values.into()))
    }

    fn visit_map<A: MapAccess<'de>>(mut self, mut entries: A) -> Result<Json, A::Error> {
        // Hashes instead of keys: half the memory; where two agree, the keys themselves decide.
        let mut seen = HashSet::new();
        let mut members: Vec<(Box<str>, Json)> = Vec::new();
        while let Some(key) = entries.next_key::<String>()? {
            self.state.count(key.len() + size_of::<(Box<str>, Json)>() + 2 * size_of::<u64>())?;
            let fresh = seen.insert(seen.hasher().hash_one(&key));
            if !fresh && members.iter().any(|(name, _)| **name == *key) {
                return Err(self
                    .state
                    .refuse(Error::new(Code::F013, format!("the key \"{key}\" is given twice in one object"))));
            }
            let value = entries.next_value_seed(self.inner()?)?;
            members.push((key.into(), value));
        }
        Ok(Json::Object(members.into()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<Json> {
        parse(&Source::from_bytes("a.json", text), &Limits::default())
    }

    fn fault(text: &str) -> (&'static str, u64, u64) {
        let error = read(text).unwrap_err();
        assert_eq!(error.place().source.as_deref(), Some("a.json"));
        (error.code().as_str(), error.place().line.unwrap(), error.place().column.unwrap())
    }

    #[test]
    fn arrays_of_numbers_are_packed() {
        assert_eq!(read("[1, -2.5, 1e3]").unwrap(), Json::Numbers(vec![1.0, -2.5, 1000.0].into()));
        assert_eq!(read("[]").unwrap(), Json::Numbers(vec![].into()));
        assert_eq!(
            read("[1, true, 2]").unwrap(),
            Json::Array(vec![Json::Number(1.0), Json::Bool(true), Json::Number(2.0)].into())
        );
        assert_eq!(read("{\"a\": [[1]], \"b\": null}").unwrap().type_name(), "an object");
        assert!(matches!(read("-0").unwrap(), Json::Number(z) if z == 0.0 && z.is_sign_negative()));
    }

    #[test]
    fn faults_have_code_line_and_column() {
        assert_eq!(fault("[1,\n 2,,3]"), ("F010", 2, 4));
        assert_eq!(fault("[1,\n 2"), ("F010", 2, 2));
        assert_eq!(fault("{\"a\": 1,\n \"b\": 2,\n \"a\": 3}"), ("F013", 3, 4));
        assert_eq!(fault("[1]\n[2]"), ("F011", 2, 1));
        assert_eq!(fault("[1, 1e400]"), ("P003", 1, 5));
        assert_eq!(fault("[1, -1.5e400]"), ("P003", 1, 5));
        assert_eq!(fault("[1, NaN]"), ("P002", 1, 5));
        assert_eq!(fault("[1,\n-Infinity]"), ("P002", 2, 1));
        assert_eq!(fault("[1, Infinity]"), ("P002", 1, 5));
        assert_eq!(fault("[1,\n 9007199254740993]"), ("F014", 2, 2));
        assert_eq!(fault("{\"a\":-9007199254740993}"), ("F014", 1, 6));
        assert_eq!(fault("[18446744073709551615]").0, "F014");
        assert_eq!(fault("[-9223372036854775807]").0, "F014");
        assert_eq!(fault("[0x10]").0, "F010");
        assert_eq!(fault("[01]").0, "F010");
        assert_eq!(fault("{'a': 1}").0, "F010");
    }

    #[test]
    fn exact_integers_beyond_2_53_pass() {
        let exact = [9007199254740992.0, 1152921504606846976.0, -9223372036854775808.0];
        assert_eq!(
            read("[9007199254740992, 1152921504606846976, -9223372036854775808]").unwrap(),
            Json::Numbers(exact.into())
        );
    }

    #[test]
    fn depth_and_size_are_bounded() {
        let deep = |n: usize| "[".repeat(n) + &"]".repeat(n);
        assert!(read(&deep(32)).is_ok());
        assert_eq!(fault(&deep(34)).0, "F012");
        assert_eq!(fault(&"[".repeat(1_000_000)).0, "F012");
        assert_eq!(fault(&"{\"a\":".repeat(100_000)).0, "F012");
        let limits = Limits { max_bytes: 1000, ..Limits::default() };
        let error =
            parse(&Source::from_bytes("a.json", "[0,".to_owned() + &"0,".repeat(200) + "0]"), &limits).unwrap_err();
        assert_eq!(error.code().as_str(), "B001");
    }
}
