//! Every case of `testdata/exact/` from the command line, digit by digit; its JSON against the schema; and the laws that hold
//! beyond the printed numbers, by formulas of their own.
#![allow(clippy::unwrap_used, clippy::panic, clippy::print_stderr)] // helpers of tests stop at the first fault, loudly

mod tool;

use serde_json::Value;
use std::collections::BTreeSet;
use std::process::Command;
use testkit::answer::compare;
use testkit::corpus::{Entry, load};
use testkit::rational::{Rational, ratio};
use testkit::schema::validate;
use tool::{Folder, lath};

/// The words of the command line that ask a case's question.
fn words(ask: &Entry) -> Vec<String> {
    let mut words = vec!["exact".to_owned(), ask.text("question").to_owned()];
    for (key, value) in ask.table().iter().filter(|(key, _)| *key != "question") {
        let option = format!("--{}", key.replace('_', "-"));
        match value {
            toml::Value::Boolean(true) => words.push(option),
            toml::Value::String(text) => words.extend([option, text.clone()]),
            other => words.extend([option, other.to_string()]),
        }
    }
    words
}

fn ask(words: &[String]) -> Value {
    serde_json::from_str(&lath(words.iter().map(String::as_str).chain(["--json"])).done()).unwrap()
}

/// The answer to a question in words without blanks.
fn answer(words: &str) -> Value {
    ask(&format!("exact {words}").split(' ').map(str::to_owned).collect::<Vec<_>>())
}

fn number(value: &Value) -> Rational {
    value.as_str().unwrap().parse().unwrap()
}

fn row(value: &Value) -> Vec<Rational> {
    value.as_array().unwrap().iter().map(number).collect()
}

fn matrix(value: &Value) -> Vec<Vec<Rational>> {
    value.as_array().unwrap().iter().map(row).collect()
}

fn sum(values: impl Iterator<Item = Rational>) -> Rational {
    values.fold(ratio(0, 1), |sum, x| sum + x)
}

fn product(a: &[Vec<Rational>], b: &[Vec<Rational>]) -> Vec<Vec<Rational>> {
    let entry = |row: &[Rational], j: usize| sum(row.iter().zip(b).map(|(x, other)| x.clone() * other[j].clone()));
    a.iter().map(|row| (0..b[0].len()).map(|j| entry(row, j)).collect()).collect()
}

#[test]
fn every_case_from_the_command_line() {
    let schema = schema();
    let (mut cases, mut numbers, mut questions) = (0, 0, BTreeSet::new());
    for case in load("exact") {
        let asked = case.entry("ask");
        let (question, words) = (asked.text("question"), words(&asked));
        let found = ask(&words);
        numbers += compare(&case, &found);
        // The object is what the schema says of this question, and of no other but its twin.
        for choice in [&schema["$defs"][question], &schema] {
            validate(&schema, choice, &found).unwrap_or_else(|fault| panic!("{}: {fault}\n{found}", case.place));
        }
        for line in case.table().get("explains").and_then(toml::Value::as_array).into_iter().flatten() {
            let steps = lath(words.iter().map(String::as_str).chain(["--explain"])).done();
            assert!(steps.contains(line.as_str().unwrap()), "{}: no line {line}\n{steps}", case.place);
        }
        questions.insert(question.to_owned());
        cases += 1;
    }
    assert_eq!(questions.len(), 13, "{questions:?}");
    assert!(cases >= 60 && numbers >= 800, "{cases} cases, {numbers} numbers");
}

fn schema() -> Value {
    serde_json::from_str(include_str!("../../../schema/exact.schema.json")).unwrap()
}

/// Shapes of answers that no textbook prints: estimates, no spectrum at all, indices beyond 2⁵³, one-sided and zero weights.
#[test]
fn rare_answers_conform_to_the_schema() {
    let schema = schema();
    for words in [
        "scheme --scheme four-point:1/32",
        "scheme --scheme mask:0,1,1,0",
        "scheme --degree 1",
        "point --degree 2 --level 900 --index 123456789012345678901234567890",
        "limit --scheme four-point --level 60 --index 9007199254740993",
        "jump --scheme chaikin --from 3:5 --to-level 3",
        "triplets --level 0",
        "at --degree 3 --knots 0,1,2,3,4,5,6,7 --t 4 --derivative 9",
        "at --degree 0 --knots 0,1,2 --t 1 --side left",
        "blending --degree 2 --knots 0,0,0,1,2",
        "blending --degree 0 --knots 0,1",
        "matrix --basis cardinal:-1/2",
        "change --from bspline:0,1,2,3 --to power --degree 1 --interval 1,2",
        "elevation --degree 0 --by 3",
        "interpolation --points 0;1;4;2 --start clamped:1/2",
        "interpolation --points 0,0;1,1;4,2 --ends anticyclic",
        "interpolation --points 0;1;4;2;1 --degree 5 --ends natural",
    ] {
        let found = answer(words);
        let question = words.split(' ').next().unwrap();
        for choice in [&schema["$defs"][question], &schema] {
            validate(&schema, choice, &found).unwrap_or_else(|fault| panic!("{words}: {fault}\n{found}"));
        }
    }
}

/// A schema that lets everything pass would prove nothing.
#[test]
fn the_schema_refuses_what_is_no_answer() {
    let schema = schema();
    let fault = |value: &Value| validate(&schema, &schema, value).is_err();
    let good = answer("limit --degree 3 --level 3 --index 6");
    assert!(!fault(&good));
    let spoilt = |key: &str, value: Value| {
        let mut object = good.clone();
        object[key] = value;
        object
    };
    assert!(fault(&spoilt("weights", serde_json::json!([0.5, 0.5]))), "numbers that are no text");
    assert!(fault(&spoilt("weights", serde_json::json!(["0.5"]))), "texts that are no fraction");
    assert!(fault(&spoilt("index", serde_json::json!(-1))) && fault(&spoilt("level", serde_json::json!("3"))));
    assert!(fault(&spoilt("note", serde_json::json!("1"))), "a member too many");
    for key in good.as_object().unwrap().keys() {
        let mut object = good.clone();
        object.as_object_mut().unwrap().remove(key);
        assert!(fault(&object), "without {key}");
    }
}

/// Every case once more as constants: one file for each language, whose compiler takes it without a word.
#[test]
fn compilers_accept_the_constants_of_every_case() {
    let mut files = [String::new(), String::new(), String::new()];
    for (i, case) in load("exact").iter().enumerate() {
        let words = words(&case.entry("ask"));
        let constants = |format| lath(words.iter().map(String::as_str).chain(["--format", format])).done();
        files[0] += &format!("pub mod case_{i} {{\n{}}}\n", constants("rust"));
        files[1] += &constants("python");
        files[2] += &format!("void case_{i}(void) {{\n{}}}\n", constants("c"));
    }
    let folder = Folder::new();
    let compilers: [(&str, &str, &[&str]); 3] = [
        ("rustc", "cases.rs", &["--edition=2021", "--crate-type=lib", "--emit=metadata", "-D", "warnings"]),
        ("python3", "cases.py", &["-W", "error"]),
        ("cc", "cases.c", &["-std=c89", "-Wall", "-Werror", "-Wno-unused-variable", "-pedantic", "-fsyntax-only"]),
    ];
    for ((program, name, arguments), text) in compilers.into_iter().zip(&files) {
        let path = folder.file(name, text);
        let output = Command::new(program).args(arguments).arg(&path).current_dir(folder.path("")).output();
        let Ok(output) = output else {
            eprintln!("skipped: {program} is not installed, so its constants are not compiled here");
            continue;
        };
        let message = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success() && message.is_empty(), "{program}: {message}");
    }
}

/// A = Q Λ Q⁻¹, and its powers tend to equal rows: the limit mask, for every degree; with the Jordan form for the four-point scheme.
#[test]
fn the_decomposition_is_the_local_matrix() {
    let options = (1..=12).map(|p| format!("--degree {p}")).chain(["--scheme four-point".to_owned()]);
    for options in options {
        let found = answer(&format!("scheme {options}"));
        let (q, inverse, a) = (matrix(&found["q"]), matrix(&found["q_inverse"]), matrix(&found["matrix"]));
        let size = a.len();
        let zero = || ratio(0, 1);
        let identity: Vec<Vec<Rational>> =
            (0..size).map(|i| (0..size).map(|j| ratio(i64::from(i == j), 1)).collect()).collect();
        assert_eq!(product(&q, &inverse), identity, "{options}");
        let eigenvalues = row(&found["eigenvalues"]);
        let middle = match found.get("jordan") {
            Some(jordan) => matrix(jordan),
            None => {
                let entry = |i: usize, j: usize| if i == j { eigenvalues[i].clone() } else { zero() };
                (0..size).map(|i| (0..size).map(|j| entry(i, j)).collect()).collect()
            }
        };
        assert_eq!(product(&product(&q, &middle), &inverse), a, "{options}");
        if options.starts_with("--degree") {
            let halves: Vec<Rational> = (0..size).rev().map(|k| ratio(1, 1 << k)).collect();
            assert_eq!(eigenvalues, halves, "{options}");
        }
        // A^∞: only the eigenvalue 1 is left, the last column of Q times the last row of Q⁻¹.
        let limit = row(&found["limit"]);
        for line in &q {
            let left: Vec<Rational> = inverse[size - 1].iter().map(|x| line[size - 1].clone() * x.clone()).collect();
            assert_eq!(left, limit, "{options}");
        }
    }
}

/// A jump over m levels is the product of m jumps over one, also from far away.
#[test]
fn a_jump_is_a_power() {
    for p in [2, 3, 5] {
        let one = matrix(&answer(&format!("scheme --degree {p}"))["matrix"]);
        let mut power = one.clone();
        for m in 1..=12 {
            let found = answer(&format!("jump --degree {p} --from 988:7 --to-level {}", 988 + m));
            assert_eq!(matrix(&found["matrix"]), power, "degree {p}, {m} levels");
            power = product(&power, &one);
        }
    }
}

fn choose(n: i128, k: i128) -> i128 {
    (0..k).fold(1, |product, i| product * (n - i) / (i + 1))
}

/// m_ij = C(n, i) Σ_{k=j..n} (n − k)ⁱ (−1)^{k−j} C(n + 1, k − j), over n!, with 0⁰ = 1.
fn uniform(n: i128, i: i128, j: i128) -> i128 {
    let terms = (j..=n).map(|k| {
        let power = (0..i).fold(1, |power, _| power * (n - k));
        let sign = if (k - j) % 2 == 0 { 1 } else { -1 };
        sign * power * choose(n + 1, k - j)
    });
    choose(n, i) * terms.sum::<i128>()
}

/// Degrees 1 to 20 by the closed formula of the textbook, and by the law that the functions sum to 1: so does the last row, and
/// every other sums to 0.
#[test]
fn uniform_matrices_follow_the_closed_formula() {
    for n in 1..=20_i128 {
        let factorial: i128 = (1..=n).product();
        let rows = matrix(&answer(&format!("matrix --basis bspline --degree {n}"))["rows"]);
        assert_eq!(rows.len() as i128, n + 1);
        for (i, row) in rows.iter().enumerate() {
            assert_eq!(row.len() as i128, n + 1);
            for (j, found) in row.iter().enumerate() {
                let expected: Rational = format!("{}/{factorial}", uniform(n, i as i128, j as i128)).parse().unwrap();
                assert_eq!(*found, expected, "degree {n}, row {i}, column {j}");
            }
            assert_eq!(sum(row.iter().cloned()), ratio(i64::from(i as i128 == n), 1), "degree {n}, row {i}");
        }
    }
}

/// Bernstein's matrix by its own closed formula: the coefficient of tᵏ in C(n, j) tʲ (1 − t)ⁿ⁻ʲ.
#[test]
fn bezier_matrices_follow_the_closed_formula() {
    for n in 1..=20_i128 {
        let rows = matrix(&answer(&format!("matrix --basis bezier --degree {n}"))["rows"]);
        for (i, row) in rows.iter().enumerate() {
            let k = n - i as i128;
            for (j, found) in row.iter().enumerate() {
                let j = j as i128;
                let sign = if (k - j) % 2 == 0 { 1 } else { -1 };
                let expected = if j > k { 0 } else { sign * choose(n, j) * choose(n - j, k - j) };
                assert_eq!(found.to_string(), expected.to_string(), "degree {n}, power {k}, function {j}");
            }
        }
    }
}

/// The textbook's row at every inner point, and the equation of each end, on intervals between 1/3 and 7.
#[test]
fn tangents_satisfy_the_rows_and_the_ends() {
    let (points, parameters) = ("0,1;1,-2;3,1/2;4,4;2,2;-1,0", "0,1/3,2,9,10,21/2");
    let p: Vec<Vec<Rational>> =
        points.split(';').map(|point| point.split(',').map(|x| x.parse().unwrap()).collect()).collect();
    let t: Vec<Rational> = parameters.split(',').map(|x| x.parse().unwrap()).collect();
    let h: Vec<Rational> = t.windows(2).map(|pair| pair[1].clone() - pair[0].clone()).collect();
    let n = p.len();
    let int = |k: i64| ratio(k, 1);
    for ends in ["natural", "not-a-knot", "clamped:2/3,-1", "second:5,1/7", "cyclic", "anticyclic"] {
        let found = answer(&format!("interpolation --points {points} --params {parameters} --ends {ends}"));
        let m = matrix(&found["tangents"]);
        for c in 0..2 {
            let (y, m) = (|i: usize| p[i][c].clone(), |i: usize| m[i][c].clone());
            for k in 0..n - 2 {
                let (a, b) = (h[k].clone(), h[k + 1].clone());
                let left = b.clone() * m(k) + int(2) * (a.clone() + b.clone()) * m(k + 1) + a.clone() * m(k + 2);
                let chords = a.clone() * a.clone() * (y(k + 2) - y(k + 1)) + b.clone() * b.clone() * (y(k + 1) - y(k));
                assert_eq!(left, int(3) / (a * b) * chords, "{ends}, row {k}");
            }
            // P″ at both ends of piece k, and its P‴, from F₁ … F₄.
            let second = |k: usize, end: bool| {
                let rise = int(6) * (y(k + 1) - y(k)) / (h[k].clone() * h[k].clone());
                match end {
                    false => rise - (int(4) * m(k) + int(2) * m(k + 1)) / h[k].clone(),
                    true => (int(2) * m(k) + int(4) * m(k + 1)) / h[k].clone() - rise,
                }
            };
            let third = |k: usize| (second(k, true) - second(k, false)) / h[k].clone();
            let (first, last) = (second(0, false), second(n - 2, true));
            match ends {
                "natural" => assert_eq!((first, last), (int(0), int(0))),
                "not-a-knot" => assert_eq!((third(0), third(n - 3)), (third(1), third(n - 2))),
                "clamped:2/3,-1" => assert_eq!((m(0), m(n - 1)), ([ratio(2, 3), int(-1)][c].clone(), m(0))),
                "second:5,1/7" => assert_eq!((first.clone(), last), ([int(5), ratio(1, 7)][c].clone(), first)),
                "cyclic" => assert_eq!((m(0), first), (m(n - 1), last)),
                _ => assert_eq!((m(0), first), (int(0) - m(n - 1), int(0) - last)),
            }
        }
    }
}
