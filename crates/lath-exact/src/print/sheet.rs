//! What an answer consists of, whatever it is written in.

use crate::answer::Function;
use crate::matrix::Matrix;
use crate::rational::Rational;

/// A title, and the formulas below it.
#[derive(Clone, Debug)]
pub struct Sheet {
    pub(crate) title: String,
    pub(crate) entries: Vec<Entry>,
}

/// What a formula is called, in each notation.
#[derive(Clone, Debug)]
pub(crate) struct Name {
    pub(crate) text: String,
    pub(crate) latex: String,
    /// In upper case with underscores, for source code.
    pub(crate) constant: String,
}

impl Name {
    pub(crate) fn new(text: impl Into<String>, latex: impl Into<String>, constant: impl Into<String>) -> Name {
        Name { text: text.into(), latex: latex.into(), constant: constant.into() }
    }
}

/// One formula.
#[derive(Clone, Debug)]
pub(crate) enum Entry {
    /// A formula that holds no constants.
    Line { text: String, latex: String },
    /// Prose: a comment in LaTeX and source code.
    Remark(String),
    /// A matrix, its common denominator before it if `factored`.
    Matrix { name: Name, matrix: Matrix, factored: bool },
    /// A row of numbers, its common denominator before it if `factored`.
    Row { name: Name, values: Vec<Rational>, factored: bool },
    /// Σ weight · P_index; `constant` names the weights, which begin at index `first`.
    Sum { name: Name, letter: char, first: usize, weights: Vec<Rational> },
    /// Piecewise polynomials, padded to one degree in source code.
    Functions { functions: Vec<Function>, degree: usize },
}

impl Sheet {
    pub(crate) fn new(title: impl Into<String>) -> Sheet {
        Sheet { title: title.into(), entries: Vec::new() }
    }

    pub(crate) fn line(mut self, text: impl Into<String>, latex: impl Into<String>) -> Sheet {
        self.entries.push(Entry::Line { text: text.into(), latex: latex.into() });
        self
    }

    pub(crate) fn remark(mut self, text: impl Into<String>) -> Sheet {
        self.entries.push(Entry::Remark(text.into()));
        self
    }

    pub(crate) fn matrix(mut self, name: Name, matrix: &Matrix) -> Sheet {
        self.entries.push(Entry::Matrix { name, matrix: matrix.clone(), factored: true });
        self
    }

    /// A matrix whose fractions stay in place.
    pub(crate) fn plain_matrix(mut self, name: Name, matrix: &Matrix) -> Sheet {
        self.entries.push(Entry::Matrix { name, matrix: matrix.clone(), factored: false });
        self
    }

    pub(crate) fn row(mut self, name: Name, values: &[Rational]) -> Sheet {
        self.entries.push(Entry::Row { name, values: values.to_vec(), factored: true });
        self
    }

    /// A row whose fractions stay in place.
    pub(crate) fn plain_row(mut self, name: Name, values: &[Rational]) -> Sheet {
        self.entries.push(Entry::Row { name, values: values.to_vec(), factored: false });
        self
    }

    pub(crate) fn sum(mut self, name: Name, letter: char, first: usize, weights: &[Rational]) -> Sheet {
        self.entries.push(Entry::Sum { name, letter, first, weights: weights.to_vec() });
        self
    }

    pub(crate) fn functions(mut self, functions: &[Function], degree: usize) -> Sheet {
        self.entries.push(Entry::Functions { functions: functions.to_vec(), degree });
        self
    }
}
