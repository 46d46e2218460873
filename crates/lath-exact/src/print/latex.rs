//! Sheets as LaTeX: formulas for amsmath, and for KaTeX.

use crate::answer::Function;
use crate::matrix::Matrix;
use crate::print::number::{Symbol, latex, sum_latex};
use crate::print::polynomial::piece_latex;
use crate::print::sheet::{Entry, Sheet};
use crate::rational::Rational;

pub(crate) fn sheet(sheet: &Sheet) -> String {
    let mut out = format!("% {}\n", sheet.title);
    for entry in &sheet.entries {
        match entry {
            Entry::Remark(text) => out.push_str(&format!("% {text}\n")),
            Entry::Functions { functions, .. } => {
                for function in functions {
                    out.push_str(&format!("\\[ {} \\]\n", cases(function)));
                }
            }
            other => out.push_str(&format!("\\[ {} \\]\n", formula(other))),
        }
    }
    out
}

fn formula(entry: &Entry) -> String {
    match entry {
        Entry::Line { latex, .. } => latex.clone(),
        Entry::Matrix { name, matrix: values, factored } => format!("{} = {}", name.latex, matrix(values, *factored)),
        Entry::Row { name, values, factored } => {
            let (factor, numbers) = factored_numbers(values, *factored);
            format!("{} = {factor}\\left({}\\right)", name.latex, numbers.join(", "))
        }
        Entry::Sum { name, letter, first, weights } => {
            let terms: Vec<_> =
                weights.iter().enumerate().map(|(i, w)| (w.clone(), Symbol::Indexed(*letter, first + i))).collect();
            format!("{} = {}", name.latex, sum_latex(&terms))
        }
        Entry::Remark(_) | Entry::Functions { .. } => String::new(),
    }
}

fn factored_numbers<'a>(
    values: impl IntoIterator<Item = &'a Rational> + Clone,
    factored: bool,
) -> (String, Vec<String>) {
    let one = Rational::from(1);
    let d = if factored { Rational::common_denominator(values.clone()) } else { one };
    let factor = if d == 1 { String::new() } else { format!("\\frac{{1}}{{{d}}} ") };
    (factor, values.into_iter().map(|x| latex(&(x * &d))).collect())
}

/// An `array`, because `pmatrix` centres its columns and stops at ten of them.
fn matrix(matrix: &Matrix, factored: bool) -> String {
    let entries: Vec<&Rational> = matrix.entries().collect();
    let (factor, numbers) = factored_numbers(entries.iter().copied(), factored);
    let rows: Vec<String> = numbers.chunks(matrix.columns().max(1)).map(|row| row.join(" & ")).collect();
    // Rows with fractions in them need room.
    let gap = if numbers.iter().any(|x| x.contains("frac")) { " \\\\[4pt] " } else { " \\\\ " };
    let columns = "r".repeat(matrix.columns());
    format!("{factor}\\left(\\begin{{array}}{{{columns}}} {} \\end{{array}}\\right)", rows.join(gap))
}

fn cases(function: &Function) -> String {
    let piece = |piece: &crate::answer::Piece| {
        let formula = piece_latex(&piece.polynomial, &piece.from, &piece.to);
        format!("{formula} & {} \\le t < {}", latex(&piece.from), latex(&piece.to))
    };
    let pieces: Vec<String> = function.pieces.iter().map(piece).collect();
    let body = if pieces.is_empty() {
        "0".to_owned()
    } else {
        format!("\\begin{{cases}} {} \\end{{cases}}", pieces.join(" \\\\[4pt] "))
    };
    format!("N_{{{}}}(t) = {body}", function.index)
}
