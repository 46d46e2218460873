//! `cargo xtask bad-inputs`: what breaks spline code elsewhere, and the test that shows what lath answers.
//!
//! `testdata/bad-inputs.toml` has one row for each of 74 inputs:
//!
//! ```toml
//! [[row]]
//! number = 26
//! input = "knots that decrease"
//! answer = "E" # E typed error, V valid, B budget, W a warning of `check`; several are written "E V"
//! applies = true
//! code = "K004" # several are written "K004 T003"
//! library = "crates/lath/tests/bad_input/knots.rs::decreasing_knots"
//! tool = "crates/lath-cli/tests/bad_input_list/knots.rs::decreasing_knots"
//!
//! [[row]]
//! number = 37
//! input = "predicates whose products underflow"
//! answer = "V"
//! applies = "not yet: predicates"
//! ```
//!
//! A row that applies names a test through the library (or a list of them, where crates share the row) and one through the command
//! line, or says in `without_tool` why no command line meets it. An answer that is an error, a budget or a warning has a code, and one of the tests names it.

use crate::{Outcome, named_test, read_toml, test_source};
use std::fmt::Write;
use std::path::Path;

const ROWS: &str = "testdata/bad-inputs.toml";
const COUNT: usize = 74;

pub(crate) fn run(root: &Path) -> Outcome {
    let table = read_toml(root, ROWS)?;
    let rows = table.get("row").and_then(toml::Value::as_array).map(Vec::as_slice).unwrap_or_default();
    let mut faults = numbering(rows);
    let mut print = String::new();
    let mut applying = 0;
    for row in rows {
        let row = Row(row);
        let number = row.number();
        match row.check(root) {
            Ok(true) => applying += 1,
            Ok(false) => {}
            Err(fault) => faults.push(format!("{ROWS}: row {number}: {fault}")),
        }
        let shown = if row.applies() == Some(true) { "applies" } else { row.text("applies").unwrap_or("?") };
        let _ = writeln!(
            print,
            "{number:>2}  {:<5}  {:<29}  {shown}\n    {}",
            row.text("answer").unwrap_or("?"),
            row.text("code").unwrap_or("-"),
            row.text("input").unwrap_or("?")
        );
        for test in row.library().iter().chain(&row.text("tool")) {
            let _ = writeln!(print, "    {test}");
        }
        if let Some(reason) = row.text("without_tool") {
            let _ = writeln!(print, "    not through the command line: {reason}");
        }
    }
    print!("{print}");
    if faults.is_empty() {
        Ok(format!("bad-inputs: {COUNT} rows: {applying} apply, {} not yet", rows.len() - applying))
    } else {
        Err(faults.join("\n"))
    }
}

/// The rows must be 1, 2, … 74.
fn numbering(rows: &[toml::Value]) -> Vec<String> {
    let numbers: Vec<i64> = rows.iter().map(|row| Row(row).number()).collect();
    let missing = (1..=COUNT as i64).filter(|number| !numbers.contains(number));
    let mut faults: Vec<String> = missing.map(|number| format!("{ROWS}: row {number} is missing")).collect();
    if faults.is_empty() && !numbers.iter().copied().eq(1..=COUNT as i64) {
        faults.push(format!("{ROWS}: the rows are not 1 to {COUNT}, in order and each once"));
    }
    faults
}

/// One row of the list.
struct Row<'a>(&'a toml::Value);

impl Row<'_> {
    fn text(&self, key: &str) -> Option<&str> {
        self.0.get(key).and_then(toml::Value::as_str).filter(|text| !text.trim().is_empty())
    }

    /// The tests through the library.
    fn library(&self) -> Vec<&str> {
        match self.0.get("library") {
            Some(toml::Value::Array(tests)) => tests.iter().filter_map(toml::Value::as_str).collect(),
            _ => self.text("library").into_iter().collect(),
        }
    }

    fn number(&self) -> i64 {
        self.0.get("number").and_then(toml::Value::as_integer).unwrap_or(0)
    }

    fn applies(&self) -> Option<bool> {
        self.0.get("applies").and_then(toml::Value::as_bool)
    }

    /// Whether the row applies, if all is as it should be.
    fn check(&self, root: &Path) -> Result<bool, String> {
        self.text("input").ok_or("says no input")?;
        let answer = self.text("answer").ok_or("has no answer")?;
        if !answer.split(' ').all(|letter| ["E", "V", "B", "W"].contains(&letter)) {
            return Err(format!("the answer {answer:?} is not of E, V, B and W"));
        }
        if self.applies() != Some(true) {
            let reason = self.text("applies").and_then(|text| text.strip_prefix("not yet: "));
            return match reason {
                Some(_) if self.library().is_empty() && self.text("tool").is_none() => Ok(false),
                Some(_) => Err("does not apply yet, and names a test all the same".to_owned()),
                None => Err("applies = true, or \"not yet: \" and what must exist first".to_owned()),
            };
        }
        let mut tests = self.library();
        if tests.is_empty() {
            return Err("applies and has no test through the library".to_owned());
        }
        match (self.text("tool"), self.text("without_tool")) {
            (Some(tool), None) => tests.push(tool),
            (None, Some(_)) => {}
            _ => return Err("applies and has no test through the command line, nor says why".to_owned()),
        }
        let tests = tests.into_iter().map(|test| named_test::check(root, test)).collect::<Result<Vec<_>, _>>()?;
        let codes: Vec<&str> = self.text("code").map(|codes| codes.split(' ').collect()).unwrap_or_default();
        if codes.is_empty() && answer != "V" {
            return Err(format!("the answer {answer:?} has a code"));
        }
        let says = |(text, name): &(String, String), code: &str| test_source::says(text, name, code);
        if let Some(code) = codes.iter().find(|code| !tests.iter().any(|test| says(test, code))) {
            return Err(format!("none of its tests names the code {code}"));
        }
        // What is only warned of must reach whoever asks on the command line.
        let tool = tests.last().filter(|_| self.text("tool").is_some());
        match codes.iter().find(|code| code.starts_with('W') && tool.is_some_and(|test| !says(test, code))) {
            Some(code) => Err(format!("the test through the command line does not name the warning {code}")),
            None => Ok(true),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Row, numbering};
    use std::path::Path;

    fn fault(row: &str) -> String {
        let row: toml::Value = toml::Value::Table(row.parse().unwrap());
        // Paths are those of this crate.
        Row(&row).check(Path::new(env!("CARGO_MANIFEST_DIR"))).map_or_else(|fault| fault, |applies| applies.to_string())
    }

    #[test]
    fn rows_that_show_nothing_are_seen() {
        let good = "number = 1\ninput = \"x\"\nanswer = \"E\"\n";
        let test = "\"src/bad_inputs.rs::rows_that_show_nothing_are_seen\"";
        let applying = format!("{good}applies = true\nlibrary = {test}\n");
        assert_eq!(fault(&format!("{applying}tool = {test}\ncode = \"K004\"")), "true");
        assert_eq!(fault(&format!("{applying}without_tool = \"no verb\"\ncode = \"K004\"")), "true");
        assert_eq!(fault(&format!("{good}applies = \"not yet: surfaces\"")), "false");
        let absent = format!("{good}applies = true\nlibrary = \"src/bad_inputs.rs::absent\"\ntool = {test}\n");
        for (row, reason) in [
            (good.to_owned(), "not yet"),
            (format!("{good}applies = false"), "not yet"),
            (format!("{good}applies = \"later\""), "not yet"),
            (format!("{good}applies = \"not yet: x\"\nlibrary = {test}"), "all the same"),
            (format!("{good}applies = true"), "through the library"),
            (applying.clone(), "command line"),
            (format!("{applying}tool = {test}\nwithout_tool = \"x\""), "command line"),
            (format!("{applying}tool = {test}"), "has a code"),
            (format!("{applying}tool = {test}\ncode = \"K\u{30}\u{30}9\""), "names the code"),
            (absent, "no such test"),
            (good.replace('E', "X"), "not of E"),
            ("number = 1\nanswer = \"E\"".to_owned(), "no input"),
        ] {
            assert!(fault(&row).contains(reason), "{row}: {}", fault(&row));
        }
    }

    #[test]
    fn rows_are_counted() {
        let rows = |numbers: &[i64]| -> Vec<toml::Value> {
            let row = |n: &i64| toml::Value::Table(format!("number = {n}").parse().unwrap());
            numbers.iter().map(row).collect()
        };
        let all: Vec<i64> = (1..=74).collect();
        assert!(numbering(&rows(&all)).is_empty());
        assert_eq!(numbering(&rows(&all[..73])).len(), 1);
        assert_eq!(numbering(&rows(&[&all[..], &[74]].concat())).len(), 1);
        assert_eq!(numbering(&rows(&[])).len(), 74);
    }
}
