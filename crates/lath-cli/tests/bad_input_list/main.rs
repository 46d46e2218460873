//! The inputs that break spline code, through the command line: the rows of `testdata/bad-inputs.toml`, one test each, by theme.
#![allow(clippy::unwrap_used, clippy::panic)] // a failing unwrap is a failing test

#[path = "../tool/mod.rs"]
mod tool;

mod counts;
mod files;
mod geometry;
mod knots;
mod numbers;
mod subdivision;
mod weights;

use tool::{Run, lath_from};

/// Runs the tool with this on standard input and these words as arguments.
pub(crate) fn run(input: impl AsRef<[u8]>, words: &str) -> Run {
    lath_from(input, words.split_whitespace())
}

/// Points through every verb that takes them: each must refuse them with exit 3 and these words.
#[track_caller]
pub(crate) fn points_fail(points: &str, words: &[&str]) {
    for verb in ["through -", "through - --closed", "curve - --kind bezier", "curve - --kind bspline", "info -"] {
        run(points, verb).fails(3, words);
    }
    run(points, "draw - -o - --format svg").fails(3, words);
}

/// One shape with these members, as a document.
pub(crate) fn document(members: &str) -> String {
    format!("{{\"lath\": 1, \"shapes\": [{{{members}}}]}}")
}

/// A shape through every verb that takes one: each must refuse it with exit 3 and these words.
#[track_caller]
pub(crate) fn shape_fails(members: &str, words: &[&str]) {
    for verb in ["info -", "eval - --count 3", "draw - -o - --format svg"] {
        run(document(members), verb).fails(3, words);
    }
}

/// The rows of the shape at the sites that these options name.
#[track_caller]
pub(crate) fn eval(members: &str, options: &str) -> Vec<Vec<f64>> {
    tool::rows(&run(document(members), &format!("eval - {options}")).done())
}

/// The codes of what `check` says about this input: warnings and notes, and nothing that is refused.
#[track_caller]
pub(crate) fn warned(input: impl AsRef<[u8]>) -> Vec<String> {
    let report: serde_json::Value = serde_json::from_str(&run(input, "check - --json").done()).unwrap();
    let code = |finding: &serde_json::Value| {
        assert_ne!(finding["severity"], "error", "{finding}");
        finding["code"].as_str().unwrap().to_owned()
    };
    report["findings"].as_array().unwrap().iter().map(code).collect()
}
