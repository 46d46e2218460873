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
//! A test is a file and the function's name in it. It must be there, bear `#[test]` (also inside `proptest!`), not be
//! ignored, and have a body that checks something: an assertion, or something that can panic or return an error. A law
//! stamped by `conformance!` is named by its family's name. A command must stand word for word in the file that records its output.

use crate::{Outcome, read, read_toml};
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
    let test = test.as_str().ok_or("a test is named by a string")?;
    let (file, name) = test.split_once("::").ok_or(format!("{test}: name it `file::function`"))?;
    let text = read(root, file)?;
    let name = name.rsplit("::").next().unwrap_or(name);
    test_fault(&text, name).map_or(Ok(()), |fault| Err(format!("{test}: {fault}")))
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

/// What is wrong with the test of that name in a formatted source; none if it is there, runs and checks something.
fn test_fault(text: &str, name: &str) -> Option<String> {
    let lines: Vec<&str> = text.lines().collect();
    let starts = |line: &str| {
        let line = line.trim_start().trim_start_matches("pub ");
        line.strip_prefix("fn ")
            .and_then(|rest| rest.strip_prefix(name))
            .is_some_and(|rest| rest.starts_with(['(', '<']))
    };
    let Some(start) = lines.iter().position(|line| starts(line)) else {
        let stamped = lines.iter().enumerate().any(|(i, line)| {
            let inside = line.trim_start().strip_prefix("conformance!").map(str::trim_start);
            let first =
                |text: &str| text.trim_start().split(|c: char| !c.is_alphanumeric() && c != '_').next() == Some(name);
            inside.is_some_and(|rest| {
                let rest = rest.trim_start_matches(['(', '{']);
                if rest.trim().is_empty() { lines.get(i + 1).is_some_and(|next| first(next)) } else { first(rest) }
            })
        });
        return (!stamped).then(|| "no such test".to_owned());
    };
    let attributes: Vec<&str> = lines[..start]
        .iter()
        .rev()
        .map(|line| line.trim())
        .take_while(|line| line.starts_with("#[") || line.starts_with("//"))
        .filter(|line| line.starts_with("#["))
        .collect();
    if !attributes.contains(&"#[test]") {
        return Some("lacks #[test], so it never runs".to_owned());
    }
    if attributes.iter().any(|attribute| attribute.starts_with("#[ignore") || attribute.starts_with("#[cfg")) {
        return Some("is ignored, or only compiled at times".to_owned());
    }
    // A formatted body ends at the first closing brace with the indentation of its `fn`, or on the same line.
    let indentation = lines[start].len() - lines[start].trim_start().len();
    let closing = format!("{}}}", " ".repeat(indentation));
    let closes = |line: &&str| line.trim_end() == closing || line.trim_end().ends_with("{}");
    let end = lines[start..].iter().position(closes).map_or(start, |length| start + length);
    let body = lines[start..=end].iter().map(|line| line.split("//").next().unwrap_or("")).skip(1);
    let checks = ["assert", "unwrap", "expect", "panic!", "?;", "check", "replay"];
    if body.into_iter().any(|line| checks.iter().any(|word| line.contains(word))) {
        None
    } else {
        Some("checks nothing".to_owned())
    }
}

#[cfg(test)]
mod tests {
    use super::test_fault;

    const SOURCE: &str = "\
#[test]
fn good() {
    assert_eq!(1 + 1, 2);
}

#[test]
#[ignore]
fn ignored() {
    assert!(true);
}

/// Words.
fn plain() {
    assert!(true);
}

#[test]
fn empty() {
    // assert!(false);
}

#[test]
fn hollow() {}

// fn commented() {
proptest! {
    #[test]
    fn property(x in 0..9) {
        prop_assert!(x < 9);
    }
}

conformance! {
    bezier,
    2,
}
conformance!(polyline, 3);
";

    #[test]
    fn a_test_must_be_there_run_and_check_something() {
        for name in ["good", "property", "bezier", "polyline"] {
            assert_eq!(test_fault(SOURCE, name), None, "{name}");
        }
        let fault = |name: &str| test_fault(SOURCE, name).unwrap_or_default();
        assert!(fault("ignored").contains("is ignored"));
        assert!(fault("plain").contains("lacks #[test]"));
        assert!(fault("empty").contains("checks nothing"));
        assert!(fault("hollow").contains("checks nothing"));
        for absent in ["absent", "commented", "goo", "bez"] {
            assert!(fault(absent).contains("no such test"), "{absent}");
        }
    }
}
