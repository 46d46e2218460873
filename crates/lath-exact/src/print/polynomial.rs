//! Polynomials as a textbook writes them.

use crate::polynomial::Polynomial;
use crate::print::number::{Symbol, sum_latex, sum_text, superscript};
use crate::rational::Rational;
use lath::num::Scalar;
use std::fmt;

impl fmt::Display for Polynomial {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&sum_text(&terms(self)))
    }
}

/// Terms from the highest power down; but 1 − t, not −t + 1.
fn terms(p: &Polynomial) -> Vec<(Rational, Symbol)> {
    let mut terms: Vec<(Rational, Symbol)> =
        p.coefficients().iter().enumerate().rev().map(|(k, c)| (c.clone(), Symbol::Power(k))).collect();
    if let [constant, slope] = p.coefficients()
        && slope.is_negative()
        && *constant > 0
    {
        terms.reverse();
    }
    terms
}

/// factor · linearⁿ, n ≥ 2, with coprime integers in the linear polynomial, if that is what p is and it is no monomial.
struct Power {
    factor: Rational,
    linear: Polynomial,
    n: usize,
}

fn perfect_power(p: &Polynomial, positive_at: &Rational) -> Option<Power> {
    let n = p.degree().filter(|&n| n >= 2)?;
    let top = p.coefficient(n);
    let a = p.coefficient(n - 1) / (&top * &Rational::from(n as i64));
    if a.is_zero() {
        return None;
    }
    // The third coefficient tells most others apart, before numbers grow.
    let pairs = Rational::from((n * (n - 1) / 2) as i64);
    if p.coefficient(n - 2) != &top * &(&pairs * &(&a * &a)) {
        return None;
    }
    // p = top · (t + a)ⁿ: the origin moved to −a leaves the highest power alone.
    let rest = p.shifted(&-a.clone());
    if rest.coefficients()[..n].iter().any(|c| !c.is_zero()) {
        return None;
    }
    let d = a.denominator();
    let sign = Rational::from(if positive_at + &a < 0 { -1 } else { 1 });
    let scale = &d * &sign;
    let linear = Polynomial::new(vec![&a * &scale, scale.clone()]);
    Some(Power { factor: top / scale.power(n), linear, n })
}

/// A piece on [from, to]: `(1 − t)³/6`, the base positive on the piece, or `(11t³ − 15t² − 3t + 7)/12`.
pub(crate) fn piece_text(p: &Polynomial, from: &Rational, to: &Rational) -> String {
    let middle = (from + to) / Rational::from(2);
    let Some(Power { factor, linear, n }) = perfect_power(p, &middle) else { return p.to_string() };
    let (numerator, denominator) = (factor.numerator(), factor.denominator());
    let front = match numerator.abs() == 1 {
        true => String::new(),
        false => numerator.abs().to_string(),
    };
    let minus = if numerator.is_negative() { "−" } else { "" };
    let under = if denominator == 1 { String::new() } else { format!("/{denominator}") };
    format!("{minus}{front}({linear}){}{under}", superscript(n))
}

/// The same in LaTeX.
pub(crate) fn piece_latex(p: &Polynomial, from: &Rational, to: &Rational) -> String {
    let middle = (from + to) / Rational::from(2);
    let Some(Power { factor, linear, n }) = perfect_power(p, &middle) else { return latex(p) };
    let (numerator, denominator) = (factor.numerator(), factor.denominator());
    let front = match numerator.abs() == 1 {
        true => String::new(),
        false => numerator.abs().to_string(),
    };
    let minus = if numerator.is_negative() { "-" } else { "" };
    let above = format!("{front}({})^{{{n}}}", latex(&linear));
    if denominator == 1 { format!("{minus}{above}") } else { format!("{minus}\\frac{{{above}}}{{{denominator}}}") }
}

/// `\frac{11t^{3} - 15t^{2} - 3t + 7}{12}`.
pub(crate) fn latex(p: &Polynomial) -> String {
    sum_latex(&terms(p))
}
