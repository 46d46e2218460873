//! Derivations in steps: what a teacher would write on the board, with this question's numbers in it.
//!
//! A derivation does not repeat the computation of the answer: it goes the textbook's way and arrives at the same numbers, and
//! the tests hold the two against each other. Where the textbook's way is the long one, as for blending functions of a high degree
//! on many knots, so is the derivation: each begins with a budget of its own.

mod at;
mod blending;
mod collocation;
mod interpolation;
mod level;
mod matrix;
mod refine;
mod scheme;

pub(crate) use at::at;
pub(crate) use blending::blending;
pub(crate) use collocation::collocation;
pub(crate) use interpolation::interpolation;
pub(crate) use level::{jump, point, triplets};
pub(crate) use matrix::matrix;
pub(crate) use refine::{change, greville, refinement};
pub(crate) use scheme::scheme;

/// Numbered steps, with lines below them.
pub(crate) struct Steps {
    text: String,
    count: usize,
}

impl Steps {
    pub(crate) fn new(title: &str) -> Steps {
        Steps { text: format!("{title}\n"), count: 0 }
    }

    /// The next step's first line.
    pub(crate) fn step(&mut self, text: &str) {
        self.count += 1;
        self.text.push_str(&format!("\n{}. {text}\n", self.count));
    }

    /// A line that belongs to the step.
    pub(crate) fn line(&mut self, text: &str) {
        self.text.push_str(format!("   {text}").trim_end());
        self.text.push('\n');
    }

    /// A formula.
    pub(crate) fn formula(&mut self, text: &str) {
        self.line(&format!("   {text}"));
    }

    /// Several lines of a formula.
    pub(crate) fn formulas(&mut self, lines: &[String]) {
        for line in lines {
            self.formula(line);
        }
    }

    pub(crate) fn finish(self) -> String {
        self.text
    }
}
