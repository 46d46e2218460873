//! Sheets as constants for programs.
//!
//! A fraction of integers that doubles hold is written as their quotient, `-1.0 / 6.0`, which every language rounds to the
//! nearest double. Longer fractions are written as the shortest decimal that reads back as the nearest double, with the
//! fraction itself left to the other formats.

use crate::answer::Function;
use crate::error::{Code, Error, Result};
use crate::print::sheet::{Entry, Sheet};
use crate::rational::Rational;

/// A language that constants are written in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Language {
    /// `pub const M: [[f64; 4]; 4] = […];`
    Rust,
    /// `M = [[…], …]`
    Python,
    /// `static const double M[4][4] = {…};`, C89 and later, C++.
    C,
}

pub(crate) fn sheet(sheet: &Sheet, language: Language) -> Result<String> {
    let mut out = String::new();
    let comment = |out: &mut String, text: &str| match language {
        Language::Rust => out.push_str(&format!("// {text}\n")),
        Language::Python => out.push_str(&format!("# {text}\n")),
        Language::C => out.push_str(&format!("/* {} */\n", text.replace("*/", "* /"))),
    };
    comment(&mut out, &sheet.title);
    for entry in &sheet.entries {
        match entry {
            Entry::Line { text, .. } | Entry::Remark(text) => comment(&mut out, text),
            Entry::Matrix { name, matrix, .. } => {
                out.push_str(&table(language, &name.constant, matrix.rows(), matrix.columns())?);
            }
            Entry::Row { name, values, .. } => out.push_str(&row(language, &name.constant, values)?),
            Entry::Sum { name, first, weights, .. } => {
                out.push_str(&integers(language, &format!("{}_FIRST", name.constant), None, &[*first]));
                out.push_str(&row(language, &name.constant, weights)?);
            }
            Entry::Functions { functions, degree } => {
                comment(&mut out, "piece j of function PIECE_FUNCTION[j], from PIECE_FROM[j] to PIECE_TO[j]:");
                comment(&mut out, "the sum of PIECE_COEFFICIENTS[j][k] times t to the power k");
                out.push_str(&pieces(language, functions, *degree)?);
            }
        }
    }
    Ok(out)
}

/// `-1.0 / 6.0`, `0.5`, `3.0`.
fn number(x: &Rational) -> Result<String> {
    let exact = x.as_doubles().map(|(n, d)| if d == 1.0 { format!("{n:?}") } else { format!("{n:?} / {d:?}") });
    if let Some(text) = exact {
        return Ok(text);
    }
    let nearest = x.to_f64();
    if nearest.is_finite() {
        return Ok(format!("{nearest:?}"));
    }
    let digits = x.to_string();
    let shown: String = digits.chars().take(40).collect();
    Err(Error::new(Code::X005, format!("{shown}… is beyond every double")))
}

/// The numbers between the language's brackets.
fn list(language: Language, values: &[Rational]) -> Result<String> {
    let numbers = values.iter().map(number).collect::<Result<Vec<_>>>()?;
    Ok(bracketed(language, &numbers.join(", ")))
}

fn bracketed(language: Language, inside: &str) -> String {
    match language {
        Language::Rust | Language::Python => format!("[{inside}]"),
        Language::C => format!("{{{inside}}}"),
    }
}

fn row(language: Language, name: &str, values: &[Rational]) -> Result<String> {
    let (n, list) = (values.len(), list(language, values)?);
    Ok(match language {
        Language::Rust => format!("pub const {name}: [f64; {n}] = {list};\n"),
        Language::Python => format!("{name} = {list}\n"),
        Language::C => format!("static const double {name}[{n}] = {list};\n"),
    })
}

fn table(language: Language, name: &str, rows: &[Vec<Rational>], columns: usize) -> Result<String> {
    let lines = rows.iter().map(|row| Ok(format!("    {},\n", list(language, row)?))).collect::<Result<String>>()?;
    let n = rows.len();
    Ok(match language {
        Language::Rust => format!("pub const {name}: [[f64; {columns}]; {n}] = [\n{lines}];\n"),
        Language::Python => format!("{name} = [\n{lines}]\n"),
        Language::C => format!("static const double {name}[{n}][{columns}] = {{\n{lines}}};\n"),
    })
}

/// Indices: a list of so many, or one number.
fn integers(language: Language, name: &str, length: Option<usize>, values: &[usize]) -> String {
    let numbers: Vec<String> = values.iter().map(usize::to_string).collect();
    let joined = numbers.join(", ");
    match (language, length) {
        (Language::Rust, None) => format!("pub const {name}: usize = {joined};\n"),
        (Language::Python, None) => format!("{name} = {joined}\n"),
        (Language::C, None) => format!("enum {{ {name} = {joined} }};\n"),
        (Language::Rust, Some(n)) => format!("pub const {name}: [usize; {n}] = [{joined}];\n"),
        (Language::Python, Some(_)) => format!("{name} = [{joined}]\n"),
        (Language::C, Some(n)) => format!("static const int {name}[{n}] = {{{joined}}};\n"),
    }
}

/// All pieces of all functions, one after the other: whose, from where to where, and their coefficients of ascending powers.
fn pieces(language: Language, functions: &[Function], degree: usize) -> Result<String> {
    let all: Vec<(usize, &crate::answer::Piece)> =
        functions.iter().flat_map(|f| f.pieces.iter().map(move |piece| (f.index, piece))).collect();
    let of: Vec<usize> = all.iter().map(|(index, _)| *index).collect();
    let from: Vec<Rational> = all.iter().map(|(_, piece)| piece.from.clone()).collect();
    let to: Vec<Rational> = all.iter().map(|(_, piece)| piece.to.clone()).collect();
    let coefficients: Vec<Vec<Rational>> = all.iter().map(|(_, piece)| piece.polynomial.padded(degree)).collect();
    let mut out = integers(language, "PIECE_FUNCTION", Some(of.len()), &of);
    out.push_str(&row(language, "PIECE_FROM", &from)?);
    out.push_str(&row(language, "PIECE_TO", &to)?);
    out.push_str(&table(language, "PIECE_COEFFICIENTS", &coefficients, degree + 1)?);
    Ok(out)
}
