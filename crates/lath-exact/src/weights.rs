//! Rows of weights as the points of a triangle: what a linear operation does to unknown control points.

use crate::rational::Rational;
use lath::num::Scalar;
use lath::space::Vector;

/// One weight for each control point; shorter rows go on with zeros.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Weights(pub(crate) Vec<Rational>);

impl Weights {
    /// The n control points themselves: each has its own weight 1.
    pub(crate) fn units(n: usize) -> Vec<Weights> {
        (0..n).map(|i| Weights((0..=i).map(|j| Rational::from(i64::from(i == j))).collect())).collect()
    }

    /// The weight of control point j.
    pub(crate) fn of(&self, j: usize) -> Rational {
        self.0.get(j).cloned().unwrap_or_else(Rational::zero)
    }
}

impl Vector<Rational> for Weights {
    fn zero() -> Self {
        Weights(Vec::new())
    }

    fn scale(&mut self, factor: &Rational) {
        for x in self.0.iter_mut().filter(|x| !x.is_zero()) {
            *x = &*x * factor;
        }
    }

    fn add_scaled(&mut self, factor: &Rational, other: &Self) {
        if self.0.len() < other.0.len() {
            self.0.resize(other.0.len(), Rational::zero());
        }
        for (x, y) in self.0.iter_mut().zip(&other.0).filter(|(_, y)| !y.is_zero()) {
            *x = &*x + &(factor * y);
        }
    }
}
