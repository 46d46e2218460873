//! Sheets as text in a fixed-width font.

use crate::answer::Function;
use crate::matrix::Matrix;
use crate::print::number::{Symbol, subscript, sum_text, text};
use crate::print::polynomial::piece_text;
use crate::print::sheet::{Entry, Sheet};
use crate::rational::Rational;

pub(crate) fn sheet(sheet: &Sheet) -> String {
    let mut out = sheet.title.clone() + "\n";
    let mut before_tall = false;
    for (i, entry) in sheet.entries.iter().enumerate() {
        let lines = lines(entry);
        let tall = lines.len() > 1;
        // A blank line around what takes several lines.
        if tall || (before_tall && i > 0) {
            out.push('\n');
        }
        before_tall = tall;
        for line in lines {
            out.push_str(line.trim_end());
            out.push('\n');
        }
    }
    out
}

fn lines(entry: &Entry) -> Vec<String> {
    match entry {
        Entry::Line { text, .. } | Entry::Remark(text) => vec![text.clone()],
        Entry::Matrix { name, matrix, factored } => matrix_lines(&name.text, matrix, *factored),
        Entry::Row { name, values, factored } => vec![vector_line(&name.text, values, *factored)],
        Entry::Sum { name, letter, first, weights } => {
            let terms: Vec<_> =
                weights.iter().enumerate().map(|(i, w)| (w.clone(), Symbol::Indexed(*letter, first + i))).collect();
            vec![format!("{} = {}", name.text, sum_text(&terms))]
        }
        Entry::Functions { functions, .. } => function_lines(functions),
    }
}

/// `M = 1/6 × ⎡ … ⎤`: the name and the common denominator before the middle row.
pub(crate) fn matrix_lines(name: &str, matrix: &Matrix, factored: bool) -> Vec<String> {
    let rows = matrix.rows();
    let denominator = if factored { Rational::common_denominator(matrix.entries()) } else { Rational::from(1) };
    let cells: Vec<Vec<String>> =
        rows.iter().map(|row| row.iter().map(|x| text(&(x * &denominator))).collect()).collect();
    let width = |j: usize| cells.iter().map(|row| row[j].chars().count()).max().unwrap_or(0);
    let widths: Vec<usize> = (0..matrix.columns()).map(width).collect();
    let equals = if name.is_empty() { String::new() } else { format!("{name} = ") };
    let prefix = if denominator == 1 { equals } else { format!("{equals}1/{denominator} × ") };
    let indent = " ".repeat(prefix.chars().count());
    let (last, middle) = (rows.len().saturating_sub(1), rows.len().saturating_sub(1) / 2);
    let line = |(i, row): (usize, &Vec<String>)| {
        let (open, close) = match i {
            _ if last == 0 => ('[', ']'),
            0 => ('⎡', '⎤'),
            _ if i == last => ('⎣', '⎦'),
            _ => ('⎢', '⎥'),
        };
        let numbers: Vec<String> = row.iter().zip(&widths).map(|(x, width)| right(x, *width)).collect();
        format!("{}{open} {} {close}", if i == middle { &prefix } else { &indent }, numbers.join("  "))
    };
    cells.iter().enumerate().map(line).collect()
}

/// Aligned to the right; `format!` would count bytes of the minus sign as it counts characters, so this spells it out.
fn right(text: &str, width: usize) -> String {
    " ".repeat(width.saturating_sub(text.chars().count())) + text
}

/// `limit = 1/6 × (1, 4, 1)`.
pub(crate) fn vector_line(name: &str, values: &[Rational], factored: bool) -> String {
    let denominator = if factored { Rational::common_denominator(values) } else { Rational::from(1) };
    let numbers: Vec<String> = values.iter().map(|x| text(&(x * &denominator))).collect();
    let factor = if denominator == 1 { String::new() } else { format!("1/{denominator} × ") };
    format!("{name} = {factor}({})", numbers.join(", "))
}

fn function_lines(functions: &[Function]) -> Vec<String> {
    let mut rows: Vec<[String; 3]> = Vec::new();
    for function in functions {
        for (i, piece) in function.pieces.iter().enumerate() {
            let name = if i == 0 { format!("N{}(t) = ", subscript(function.index)) } else { String::new() };
            let formula = piece_text(&piece.polynomial, &piece.from, &piece.to);
            rows.push([name, formula, format!("{} ≤ t < {}", text(&piece.from), text(&piece.to))]);
        }
        if function.pieces.is_empty() {
            rows.push([format!("N{}(t) = ", subscript(function.index)), "0".into(), "no span".into()]);
        }
    }
    let width = |c: usize| rows.iter().map(|row| row[c].chars().count()).max().unwrap_or(0);
    let (names, formulas) = (width(0), width(1));
    let left = |text: &str, width: usize| text.to_owned() + &" ".repeat(width.saturating_sub(text.chars().count()));
    rows.iter()
        .map(|[name, formula, span]| format!("{}{}   {span}", left(name, names), left(formula, formulas)))
        .collect()
}
