//! Reads `testdata/`: inputs and exact answers in a language-neutral form.
//!
//! The same cases drive the library, the command line and every other language, so nothing here is Rust's: a case is a
//! TOML table, numbers are integers, floats or fractions in quotes (`"121/384"`). `testdata/README.md` describes the
//! fields. [`load`] hands out the cases of one floor; an [`Entry`] reads numbers exactly, and says where it stands when a
//! file is at fault.
//!
//! Inputs are read with [`Entry::floats`] where floats are tested and with [`Entry::numbers`] where fractions are; both see the
//! same number, because an input that a float cannot hold is refused. Answers are read with [`Entry::numbers`] only.

use crate::rational::Rational;
use std::fs;
use std::path::{Path, PathBuf};
use toml::{Table, Value};

/// A case, or a table inside a case.
#[derive(Clone, Debug)]
pub struct Entry {
    /// Where it stands, for messages: the file and the case's name.
    pub place: String,
    table: Table,
}

/// The folder `testdata/`.
pub fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../testdata")
}

/// Every case of `testdata/<floor>/*.toml`, in the order of the files' names.
///
/// # Panics
/// If the folder holds no case, or a case lacks its name or source.
pub fn load(floor: &str) -> Vec<Entry> {
    let folder = folder().join(floor);
    let listing = fs::read_dir(&folder).unwrap_or_else(|error| panic!("testdata/{floor}: {error}"));
    let mut paths: Vec<PathBuf> = listing.map(|entry| entry.unwrap().path()).collect();
    paths.retain(|path| path.extension().is_some_and(|extension| extension == "toml"));
    paths.sort();
    let mut cases = Vec::new();
    for path in paths {
        let file = format!("{floor}/{}", path.file_name().unwrap().to_string_lossy());
        cases.extend(parse(&file, &fs::read_to_string(&path).unwrap()));
    }
    assert!(!cases.is_empty(), "testdata/{floor} holds no case");
    cases
}

/// The cases of one file's text.
fn parse(file: &str, text: &str) -> Vec<Entry> {
    let table: Table = text.parse().unwrap_or_else(|error| panic!("{file}: {error}"));
    let cases = Entry { place: file.to_owned(), table }.entries("case");
    let named = cases.into_iter().map(|case| {
        let place = format!("{file}: {}", case.text("name"));
        assert!(!case.text("source").trim().is_empty(), "{place}: names no source");
        Entry { place, ..case }
    });
    named.collect()
}

impl Entry {
    /// Whether the field is there.
    pub fn has(&self, key: &str) -> bool {
        self.table.contains_key(key)
    }

    /// All fields, for those who translate a case into another language.
    pub fn table(&self) -> &Table {
        &self.table
    }

    fn get(&self, key: &str) -> &Value {
        self.table.get(key).unwrap_or_else(|| panic!("{}: lacks `{key}`", self.place))
    }

    fn array(&self, key: &str) -> &[Value] {
        self.get(key).as_array().unwrap_or_else(|| panic!("{}: `{key}` is no list", self.place))
    }

    /// A text.
    pub fn text(&self, key: &str) -> &str {
        self.get(key).as_str().unwrap_or_else(|| panic!("{}: `{key}` is no text", self.place))
    }

    /// A text, or none where the field is absent or no text.
    pub fn text_if(&self, key: &str) -> Option<&str> {
        self.table.get(key).and_then(Value::as_str)
    }

    /// A truth value; false where it is absent.
    pub fn flag(&self, key: &str) -> bool {
        self.table.get(key).is_some_and(|value| {
            value.as_bool().unwrap_or_else(|| panic!("{}: `{key}` is neither true nor false", self.place))
        })
    }

    /// A count or an index.
    pub fn count(&self, key: &str) -> usize {
        let whole = self.get(key).as_integer().and_then(|n| usize::try_from(n).ok());
        whole.unwrap_or_else(|| panic!("{}: `{key}` is no count", self.place))
    }

    /// A count or an index, or none where the field is absent.
    pub fn count_if(&self, key: &str) -> Option<usize> {
        self.has(key).then(|| self.count(key))
    }

    /// An exact number.
    pub fn number(&self, key: &str) -> Rational {
        self.exact(self.get(key))
    }

    /// A list of exact numbers.
    pub fn numbers(&self, key: &str) -> Vec<Rational> {
        self.array(key).iter().map(|value| self.exact(value)).collect()
    }

    /// A list of lists of exact numbers.
    pub fn rows(&self, key: &str) -> Vec<Vec<Rational>> {
        self.lists(key).map(|row| row.iter().map(|value| self.exact(value)).collect()).collect()
    }

    /// An input for floats: it must be a float's exact value, or a NaN or infinity.
    pub fn float(&self, key: &str) -> f64 {
        self.binary(self.get(key))
    }

    /// A list of inputs for floats.
    pub fn floats(&self, key: &str) -> Vec<f64> {
        self.array(key).iter().map(|value| self.binary(value)).collect()
    }

    /// A list of lists of inputs for floats.
    pub fn float_rows(&self, key: &str) -> Vec<Vec<f64>> {
        self.lists(key).map(|row| row.iter().map(|value| self.binary(value)).collect()).collect()
    }

    /// A list of lists of lists of inputs for floats.
    pub fn float_blocks(&self, key: &str) -> Vec<Vec<Vec<f64>>> {
        let row = |row: &Value| -> Vec<f64> {
            let numbers = row.as_array().unwrap_or_else(|| panic!("{}: `{key}` holds no lists of lists", self.place));
            numbers.iter().map(|value| self.binary(value)).collect()
        };
        self.lists(key).map(|block| block.iter().map(row).collect()).collect()
    }

    /// A list of tables; empty where it is absent.
    pub fn entries(&self, key: &str) -> Vec<Entry> {
        if !self.has(key) {
            return Vec::new();
        }
        let table = |value: &Value| {
            value.as_table().unwrap_or_else(|| panic!("{}: `{key}` holds no tables", self.place)).clone()
        };
        self.array(key).iter().map(|value| Entry { place: self.place.clone(), table: table(value) }).collect()
    }

    /// A table.
    pub fn entry(&self, key: &str) -> Entry {
        let table = self.get(key).as_table().unwrap_or_else(|| panic!("{}: `{key}` is no table", self.place)).clone();
        Entry { place: self.place.clone(), table }
    }

    fn lists(&self, key: &str) -> impl Iterator<Item = &Vec<Value>> {
        self.array(key)
            .iter()
            .map(move |row| row.as_array().unwrap_or_else(|| panic!("{}: `{key}` holds no lists", self.place)))
    }

    fn exact(&self, value: &Value) -> Rational {
        match value {
            Value::Integer(n) => Rational::from(*n),
            Value::Float(x) if x.is_finite() => Rational::from_f64(*x),
            Value::String(text) => text.parse().unwrap_or_else(|error| panic!("{}: {error}", self.place)),
            _ => panic!("{}: {value} is no number", self.place),
        }
    }

    fn binary(&self, value: &Value) -> f64 {
        match value {
            Value::Float(x) => *x,
            _ => {
                let exact = self.exact(value);
                assert!(exact.is_f64(), "{}: the input {exact} is not exact as a float", self.place);
                exact.to_f64()
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rational::ratio;

    const TEXT: &str = r#"
        [[case]]
        name = "one"
        source = "made up"
        points = [[1, 0.5], ["3/4", nan]]
        exact = [1, 0.5, "1/3"]
        at = [{ t = "1/2", closed = true }]
    "#;

    #[test]
    fn numbers_are_exact_however_they_are_written() {
        let case = &parse("made/up.toml", TEXT)[0];
        assert_eq!(case.numbers("exact"), [ratio(1, 1), ratio(1, 2), ratio(1, 3)]);
        assert_eq!(case.float_rows("points")[0], [1.0, 0.5]);
        assert!(case.float_rows("points")[1][1].is_nan());
        let at = &case.entries("at")[0];
        assert_eq!((at.float("t"), at.flag("closed"), at.flag("open")), (0.5, true, false));
        assert_eq!((case.entries("absent").len(), case.count_if("absent")), (0, None));
        assert_eq!(case.place, "made/up.toml: one");
    }

    #[test]
    #[should_panic(expected = "made/up.toml: one: the input 1/3 is not exact as a float")]
    fn an_input_that_no_float_holds_is_refused() {
        parse("made/up.toml", TEXT)[0].floats("exact");
    }

    #[test]
    #[should_panic(expected = "made/up.toml: one: lacks `knots`")]
    fn a_missing_field_is_named() {
        parse("made/up.toml", TEXT)[0].numbers("knots");
    }
}
