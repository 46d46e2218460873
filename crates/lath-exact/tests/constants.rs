//! Constants that compilers accept, and that hold the right doubles.
#![allow(clippy::unwrap_used, clippy::print_stderr)] // helpers of tests stop at the first fault, and say what they skip

use lath::knot::Side;
use lath_exact::answer::{
    Condition, Ends, SplineEnds, at, blending, change, collocation, elevation, elevation_bezier, greville, insertion,
    interpolation, jump, limit, matrix, point, scheme, scheme_named, triplets,
};
use lath_exact::error::Code;
use lath_exact::parse;
use lath_exact::print::{Answer, Format, Language, render};
use std::process::{Command, Stdio};

/// One answer of every kind, long fractions and large numbers among them.
fn answers() -> Vec<Box<dyn Answer>> {
    let limits = Default::default();
    let cubic = scheme_named("cubic").unwrap();
    let knots = parse::fractions("0,0,0,0,33/100,66/100,1,1,1,1").unwrap();
    let unit = (0.into(), 1.into());
    vec![
        Box::new(matrix(&"bspline".parse().unwrap(), 3, &limits).unwrap()),
        Box::new(matrix(&"bspline".parse().unwrap(), 30, &limits).unwrap()),
        Box::new(blending(&knots, 3, &limits).unwrap()),
        Box::new(at(&knots, 3, &"1/7".parse().unwrap(), 1, Side::Right, &limits).unwrap()),
        Box::new(greville(&knots, 3).unwrap()),
        Box::new(insertion(&knots, 3, &parse::fractions("1/2").unwrap(), &limits).unwrap()),
        Box::new(elevation_bezier(3, 2, &limits).unwrap()),
        Box::new(elevation(&knots, 3, 1, &limits).unwrap()),
        Box::new(change(&"power".parse().unwrap(), &"bernstein".parse().unwrap(), 5, unit, &limits).unwrap()),
        Box::new(
            interpolation(
                &parse::rows("0,0; 1,2; 3,1").unwrap(),
                None,
                Ends::Open(Condition::Natural, Condition::NotAKnot),
                &limits,
            )
            .unwrap(),
        ),
        Box::new(collocation(&parse::rows("0; 1; 4; 2").unwrap(), None, 4, SplineEnds::Closed, &limits).unwrap()),
        Box::new(scheme(&cubic, &limits).unwrap()),
        Box::new(scheme(&scheme_named("four-point").unwrap(), &limits).unwrap()),
        Box::new(limit(&cubic, 100, &"1267650600228229401496703205375".parse().unwrap(), &limits).unwrap()),
        Box::new(point(&cubic, 3, &6.into(), &limits).unwrap()),
        Box::new(jump(&cubic, (0, 1.into()), 40, &limits).unwrap()),
        Box::new(triplets(3, &limits).unwrap()),
    ]
}

/// The command, if this machine has it; else a line that says what was not tested.
fn compiler(program: &str, arguments: &[&str]) -> Option<Command> {
    let found = Command::new(program).arg("--version").stdout(Stdio::null()).stderr(Stdio::null()).status();
    if !found.is_ok_and(|status| status.success()) {
        eprintln!("skipped: {program} is not installed, so its constants are not compiled here");
        return None;
    }
    let mut command = Command::new(program);
    command.args(arguments);
    Some(command)
}

fn accepted(language: Language, extension: &str, program: &str, arguments: &[&str]) {
    let folder = tempfile::tempdir().unwrap();
    for (i, answer) in answers().iter().enumerate() {
        let Some(mut command) = compiler(program, arguments) else { return };
        let path = folder.path().join(format!("constants_{i}.{extension}"));
        let source = render(&**answer, Format::Source(language)).unwrap();
        std::fs::write(&path, &source).unwrap();
        let output = command.current_dir(folder.path()).arg(&path).output().unwrap();
        let message = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success() && message.is_empty(), "{program} on\n{source}\n{message}");
    }
}

#[test]
fn rustc_accepts_the_constants() {
    let arguments = ["--edition=2021", "--crate-type=lib", "--emit=metadata", "-D", "warnings"];
    accepted(Language::Rust, "rs", "rustc", &arguments);
}

#[test]
fn python_accepts_the_constants() {
    accepted(Language::Python, "py", "python3", &["-W", "error"]);
}

#[test]
fn cc_accepts_the_constants() {
    let arguments = ["-std=c89", "-Wall", "-Werror", "-Wno-unused-variable", "-pedantic", "-fsyntax-only"];
    accepted(Language::C, "c", "cc", &arguments);
}

/// A quotient of integers is the nearest double, and so is a decimal: read back by Python and compared.
#[test]
fn constants_are_the_nearest_doubles() {
    let answer = matrix(&"bspline".parse().unwrap(), 25, &Default::default()).unwrap();
    let source = render(&answer, Format::Source(Language::Python)).unwrap();
    let rows: Vec<f64> = source
        .lines()
        .filter(|line| line.starts_with("    ["))
        .flat_map(|line| line.trim_matches([' ', '[', ']', ',']).split(", ").map(str::to_owned).collect::<Vec<_>>())
        .map(|number| match number.split_once(" / ") {
            Some((n, d)) => n.parse::<f64>().unwrap() / d.parse::<f64>().unwrap(),
            None => number.parse().unwrap(),
        })
        .collect();
    let exact: Vec<f64> = answer.matrix.entries().map(lath_exact::Rational::to_f64).collect();
    assert_eq!(rows, exact);
}

#[test]
fn what_no_double_holds_is_refused() {
    let narrow = parse::fractions("0,1e-200,2e-200,3e-200,4e-200").unwrap();
    let answer = blending(&narrow, 3, &Default::default()).unwrap();
    for language in [Language::Rust, Language::Python, Language::C] {
        assert_eq!(render(&answer, Format::Source(language)).unwrap_err().code(), Code::X005);
    }
    assert!(render(&answer, Format::Json).unwrap().len() > 1000);
}
