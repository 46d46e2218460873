//! Reads a formatted test source: is the test there, does it run, does it check anything?
//!
//! A test is a function that bears `#[test]` (also inside `proptest!`), is neither ignored nor compiled at times only, and
//! asserts something: itself, or through a function that does, in its own file or beside it. Laws stamped by
//! `conformance!` are found by their family's name. The sources are formatted (`cargo fmt --check` says so), therefore lines and their
//! indentation tell where a function begins and ends, and no grammar is needed.

use std::collections::BTreeSet;

/// What makes a line a check.
const CHECKS: [&str; 5] = ["assert", "panic!(", ".unwrap()", ".expect(", "unwrap_err()"];

/// What is wrong with the test of that name; none if it is there, runs and checks something.
pub(crate) fn fault(text: &str, helpers: &[String], name: &str) -> Option<String> {
    let Some(test) = functions(text).into_iter().find(|function| function.name == name) else {
        let stamped = families(text).any(|family| family == name);
        return (!stamped).then(|| "no such test".to_owned());
    };
    if !test.attributes.contains(&"#[test]") {
        return Some("lacks #[test], so it never runs".to_owned());
    }
    if test.attributes.iter().any(|attribute| attribute.starts_with("#[ignore") || attribute.starts_with("#[cfg")) {
        return Some("is ignored, or only compiled at times".to_owned());
    }
    let all: Vec<Function> = helpers.iter().map(String::as_str).chain([text]).flat_map(functions).collect();
    (!checks(&test, &checking(&all))).then(|| "checks nothing".to_owned())
}

/// Whether the function of that name says the word, outside comments.
pub(crate) fn says(text: &str, name: &str, word: &str) -> bool {
    let said = |function: Function<'_>| function.name == name && function.body.iter().any(|line| line.contains(word));
    functions(text).into_iter().any(said)
}

struct Function<'a> {
    name: &'a str,
    attributes: Vec<&'a str>,
    /// The lines between the braces, without comments.
    body: Vec<&'a str>,
}

/// All functions of a source.
fn functions(text: &str) -> Vec<Function<'_>> {
    let lines: Vec<&str> = text.lines().collect();
    let mut found = Vec::new();
    for (start, line) in lines.iter().enumerate() {
        let words = line.trim_start().trim_start_matches("pub(crate) ").trim_start_matches("pub ");
        let Some(name) = words.strip_prefix("fn ").and_then(|rest| rest.split(['(', '<']).next()) else {
            continue;
        };
        let above = lines[..start].iter().rev().map(|line| line.trim());
        let attributes = above.take_while(|line| line.starts_with("#[") || line.starts_with("//"));
        // The body ends at the first closing brace with the indentation of its `fn`, or on the same line.
        let indentation = line.len() - line.trim_start().len();
        let closing = format!("{}}}", " ".repeat(indentation));
        let closes = |line: &&str| line.trim_end() == closing || line.trim_end().ends_with("{}");
        let end = lines[start..].iter().position(closes).map_or(start, |length| start + length);
        found.push(Function {
            name,
            attributes: attributes.filter(|line| line.starts_with("#[")).collect(),
            body: lines[start..end].iter().skip(1).map(|line| line.split("//").next().unwrap_or("")).collect(),
        });
    }
    found
}

/// The names of all functions that check something, themselves or through another of them.
fn checking<'a>(functions: &[Function<'a>]) -> BTreeSet<&'a str> {
    let mut known = BTreeSet::new();
    loop {
        let more: BTreeSet<&str> =
            functions.iter().filter(|function| checks(function, &known)).map(|f| f.name).collect();
        if more == known {
            return known;
        }
        known = more;
    }
}

/// Whether a body asserts, or calls a function that does.
fn checks(function: &Function<'_>, known: &BTreeSet<&str>) -> bool {
    let calls = |line: &str| {
        let mut words = line.split('(').map(|before| before.rsplit(|c: char| !c.is_alphanumeric() && c != '_').next());
        words.any(|word| word.is_some_and(|word| known.contains(word)))
    };
    function.body.iter().any(|line| CHECKS.iter().any(|word| line.contains(word)) || calls(line))
}

/// The families of the `conformance!` invocations of a source.
fn families(text: &str) -> impl Iterator<Item = &str> {
    text.split("conformance!").skip(1).filter_map(|rest| {
        let rest = rest.trim_start().strip_prefix(['(', '{'])?;
        rest.trim_start().split(|c: char| !c.is_alphanumeric() && c != '_').next()
    })
}

#[cfg(test)]
mod tests {
    use super::{fault, says};

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

#[test]
fn idle() {
    let x = compute(3);
}

#[test]
fn through_a_helper() {
    through(3);
}

#[test]
fn through_a_method() {
    run().fails(3);
}

fn through(x: i32) {
    plain();
}

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
testkit::conformance!(polyline, 3);
";
    const HELPERS: &str = "\
impl Run {
    pub(crate) fn fails(self, code: i32) {
        assert_eq!(self.code, code);
    }
}
";

    #[test]
    fn a_test_must_be_there_run_and_check_something() {
        let fault = |name: &str| fault(SOURCE, &[HELPERS.to_owned()], name);
        for name in ["good", "property", "bezier", "polyline", "through_a_helper", "through_a_method"] {
            assert_eq!(fault(name), None, "{name}");
        }
        for (name, reason) in [
            ("ignored", "is ignored"),
            ("plain", "lacks #[test]"),
            ("empty", "checks nothing"),
            ("hollow", "checks nothing"),
            ("idle", "checks nothing"),
            ("absent", "no such test"),
            ("commented", "no such test"),
            ("goo", "no such test"),
            ("bez", "no such test"),
        ] {
            assert!(fault(name).is_some_and(|found| found.contains(reason)), "{name}: {:?}", fault(name));
        }
    }

    #[test]
    fn words_are_looked_for_in_one_function_without_its_comments() {
        assert!(says(SOURCE, "good", "1 + 1") && says(SOURCE, "property", "x < 9"));
        assert!(!says(SOURCE, "empty", "false") && !says(SOURCE, "idle", "1 + 1") && !says(SOURCE, "absent", ""));
    }
}
