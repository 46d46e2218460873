//! Derivatives at points, as words: INDEX:ORDER:X,Y,…

use crate::numbers::{count, finite, list};
use lath::error::{Code, Error};
use lath::interpolate::Derivative;
use std::str::FromStr;

/// A derivative that a B-spline is to have at one of its points.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Given {
    index: usize,
    order: usize,
    vector: Vec<f64>,
}

impl FromStr for Given {
    type Err = String;

    fn from_str(text: &str) -> Result<Given, String> {
        let parts: Vec<&str> = text.splitn(3, ':').collect();
        let [index, order, vector] = parts[..] else {
            return Err("a derivative is INDEX:ORDER:X,Y,…: the point, from 0, the order, and its value".into());
        };
        let whole = |text: &str| count(text).map(|n| usize::try_from(n).unwrap_or(usize::MAX));
        Ok(Given { index: whole(index)?, order: whole(order)?, vector: list(vector, finite)? })
    }
}

impl Given {
    /// Refuses a vector that has another number of coordinates than the points.
    pub(crate) fn check(&self, dimension: usize) -> Result<(), Error> {
        if self.vector.len() == dimension {
            return Ok(());
        }
        let (index, count) = (self.index, self.vector.len());
        let plural = if count == 1 { "" } else { "s" };
        let message = format!("the derivative at point {index} has {count} number{plural}, the points {dimension}");
        Err(Error::new(Code::P005, message))
    }

    /// The derivative for the library, padded with zeros.
    pub(crate) fn derivative<const D: usize>(&self) -> Derivative<D> {
        let value = core::array::from_fn(|c| self.vector.get(c).copied().unwrap_or(0.0));
        Derivative { index: self.index, order: self.order, value }
    }
}
