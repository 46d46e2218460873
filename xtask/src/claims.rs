//! `cargo xtask claims`: what the project says it can do, held against the tests that show it.
//!
//! `testdata/claims.toml` lists claims in the project's own words, each with tests, or with commands for what no test
//! shows:
//!
//! ```toml
//! [[claim]]
//! says = "the B-spline basis of exercise 4.103 is exact"
//! tests = ["crates/lath/tests/basis_exact.rs::exercise_4_103"]
//!
//! [[claim]]
//! says = "a million points take linear time"
//! commands = [{ run = "cargo run --release …", recorded = "docs/speed.md" }]
//! ```
//!
//! A test is a file and the function's name in it; `test_source` says what is asked of it. A command must stand word for
//! word in the file that records its output.

use crate::{Outcome, named_test, read, read_toml};
use std::path::Path;

const CLAIMS: &str = "testdata/claims.toml";

pub(crate) fn run(root: &Path) -> Outcome {
    let table = read_toml(root, CLAIMS)?;
    let claims = table.get("claim").and_then(toml::Value::as_array).map(Vec::as_slice).unwrap_or_default();
    let mut faults = Vec::new();
    let (mut tests, mut commands) = (0, 0);
    for (place, claim) in claims.iter().enumerate() {
        let Some(says) = claim.get("says").and_then(toml::Value::as_str).filter(|says| !says.trim().is_empty()) else {
            faults.push(format!("{CLAIMS}: claim {place} says nothing"));
            continue;
        };
        let list = |key: &str| claim.get(key).and_then(toml::Value::as_array).map(Vec::as_slice).unwrap_or_default();
        if list("tests").is_empty() && list("commands").is_empty() {
            faults.push(format!("{says}\n    has neither test nor command"));
        }
        for test in list("tests") {
            tests += 1;
            if let Err(reason) = check_test(root, test) {
                faults.push(format!("{says}\n    {reason}"));
            }
        }
        for command in list("commands") {
            commands += 1;
            if let Err(reason) = check_command(root, command) {
                faults.push(format!("{says}\n    {reason}"));
            }
        }
    }
    if claims.is_empty() {
        faults.push(format!("{CLAIMS}: claims nothing"));
    }
    if faults.is_empty() {
        Ok(format!("claims: {} claims, shown by {tests} tests and {commands} commands", claims.len()))
    } else {
        Err(faults.join("\n"))
    }
}

fn check_test(root: &Path, test: &toml::Value) -> Result<(), String> {
    named_test::check(root, test.as_str().ok_or("a test is named by a string")?).map(|_| ())
}

fn check_command(root: &Path, command: &toml::Value) -> Result<(), String> {
    let text = |key: &str| command.get(key).and_then(toml::Value::as_str).filter(|text| !text.trim().is_empty());
    let run = text("run").ok_or("a command has `run`")?;
    let recorded = text("recorded").ok_or(format!("{run}: name the file where its output is `recorded`"))?;
    if read(root, recorded)?.contains(run) {
        Ok(())
    } else {
        Err(format!("{recorded} does not contain the command `{run}`"))
    }
}
