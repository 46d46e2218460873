//! Fractions, indices and sums of terms, in text and in LaTeX.

use crate::rational::Rational;
use lath::num::Scalar;

/// A fraction with a typographic minus: `−1/6`.
pub(crate) fn text(x: &Rational) -> String {
    x.to_string().replace('-', "−")
}

/// `-\frac{1}{6}`.
pub(crate) fn latex(x: &Rational) -> String {
    let sign = if x.is_negative() { "-" } else { "" };
    let x = x.abs();
    if x.is_integer() {
        format!("{sign}{x}")
    } else {
        format!("{sign}\\frac{{{}}}{{{}}}", x.numerator(), x.denominator())
    }
}

fn digits(n: usize, of: [char; 10]) -> String {
    n.to_string().bytes().filter_map(|byte| of.get(usize::from(byte.wrapping_sub(b'0')))).collect()
}

/// `P₁₂`'s index.
pub(crate) fn subscript(n: usize) -> String {
    digits(n, ['₀', '₁', '₂', '₃', '₄', '₅', '₆', '₇', '₈', '₉'])
}

/// `t¹²`'s exponent; nothing for 1.
pub(crate) fn superscript(n: usize) -> String {
    if n == 1 {
        return String::new();
    }
    digits(n, ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'])
}

/// An exponent that is shown whatever it is.
pub(crate) fn exponent(n: usize) -> String {
    if n == 1 { "¹".to_owned() } else { superscript(n) }
}

/// What a coefficient multiplies.
#[derive(Clone, Debug)]
pub(crate) enum Symbol {
    /// tᵏ; 1 for k = 0.
    Power(usize),
    /// A letter with an index: P₃, m₀.
    Indexed(char, usize),
}

impl Symbol {
    pub(crate) fn text(&self) -> String {
        match self {
            Symbol::Power(0) => String::new(),
            Symbol::Power(k) => format!("t{}", superscript(*k)),
            Symbol::Indexed(letter, i) => format!("{letter}{}", subscript(*i)),
        }
    }

    pub(crate) fn latex(&self) -> String {
        match self {
            Symbol::Power(0) => String::new(),
            Symbol::Power(1) => "t".to_owned(),
            Symbol::Power(k) => format!("t^{{{k}}}"),
            Symbol::Indexed(letter, i) => format!("{letter}_{{{i}}}"),
        }
    }
}

/// The common denominator, the integer sum over it, and whether that sum has several terms.
fn parts(terms: &[(Rational, Symbol)], minus: &str, write: impl Fn(&Symbol) -> String) -> (Rational, String, bool) {
    let denominator = Rational::common_denominator(terms.iter().map(|(c, _)| c));
    let mut sum = String::new();
    let mut count = 0;
    for (c, symbol) in terms.iter().filter(|(c, _)| !c.is_zero()) {
        let n = c * &denominator;
        match (count, n.is_negative()) {
            (0, true) => sum.push_str(minus),
            (0, false) => {}
            (_, true) => sum.push_str(&format!(" {minus} ")),
            (_, false) => sum.push_str(" + "),
        }
        let (n, symbol) = (n.abs(), write(symbol));
        if n != 1 || symbol.is_empty() {
            sum.push_str(&n.to_string());
        }
        sum.push_str(&symbol);
        count += 1;
    }
    if count == 0 {
        sum.push('0');
    }
    (denominator, sum, count > 1)
}

/// `(11t³ − 15t² − 3t + 7)/12`, `(P₀ + 4P₁ + P₂)/6`.
pub(crate) fn sum_text(terms: &[(Rational, Symbol)]) -> String {
    match parts(terms, "−", Symbol::text) {
        (d, sum, _) if d == 1 => sum,
        (d, sum, true) => format!("({sum})/{d}"),
        (d, sum, false) => format!("{sum}/{d}"),
    }
}

/// `\frac{P_{0} + 4P_{1} + P_{2}}{6}`.
pub(crate) fn sum_latex(terms: &[(Rational, Symbol)]) -> String {
    let (d, sum, several) = parts(terms, "-", Symbol::latex);
    if d == 1 {
        return sum;
    }
    match sum.strip_prefix('-').filter(|_| !several) {
        Some(rest) => format!("-\\frac{{{rest}}}{{{d}}}"),
        None => format!("\\frac{{{sum}}}{{{d}}}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parse::fractions;

    fn points(text: &str) -> Vec<(Rational, Symbol)> {
        fractions(text).unwrap().into_iter().enumerate().map(|(i, c)| (c, Symbol::Indexed('P', i))).collect()
    }

    #[test]
    fn sums_stand_over_one_denominator() {
        assert_eq!(sum_text(&points("1/384,121/384,235/384,9/128")), "(P₀ + 121P₁ + 235P₂ + 27P₃)/384");
        assert_eq!(sum_text(&points("-1,0,1")), "−P₀ + P₂");
        assert_eq!(sum_text(&points("0,-5/6")), "−5P₁/6");
        assert_eq!(sum_text(&points("0,0")), "0");
        assert_eq!(sum_latex(&points("1/6,2/3,1/6")), "\\frac{P_{0} + 4P_{1} + P_{2}}{6}");
        assert_eq!(sum_latex(&points("0,-5/6")), "-\\frac{5P_{1}}{6}");
    }

    #[test]
    fn numbers_and_indices() {
        assert_eq!(text(&Rational::new(-1, 6).unwrap()), "−1/6");
        assert_eq!(latex(&Rational::new(-1, 6).unwrap()), "-\\frac{1}{6}");
        assert_eq!(latex(&Rational::from(-3)), "-3");
        assert_eq!((subscript(120), superscript(13), superscript(1)), ("₁₂₀".into(), "¹³".into(), String::new()));
    }
}
