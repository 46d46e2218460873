//! The whole parameter line: knots whose every span counts, also those outside the domain.
//!
//! B-splines live on all of [t₀, t_{n+p}], the core's `Knots` answers inside [t_p, t_n] only, where the functions sum to 1. With
//! p + 1 knots more on each side, the whole support of the given functions lies inside the domain of the longer vector. The
//! functions that the additional knots bring along are left out again.

use crate::error::{Code, Error, Result};
use crate::rational::Rational;
use lath::error::Code as Core;
use lath::knot::Knots;
use lath::num::Scalar;

/// Knots, with p + 1 more on each side.
#[derive(Clone, Debug)]
pub(crate) struct Line {
    knots: Knots<Rational>,
    /// How many knots were added on each side.
    pub(crate) pad: usize,
    /// How many functions the given knots carry.
    pub(crate) functions: usize,
}

impl Line {
    /// At least p + 2 knots; the domain may be empty.
    ///
    /// # Errors
    /// K001, K003, K004, K006, K007 with the index of the given knot.
    pub(crate) fn new(values: &[Rational], degree: usize) -> Result<Line> {
        let fault = |code: Core, message: String| Error::new(Code::Core(code), message);
        let (Some(first), Some(last)) = (values.first(), values.last()) else {
            return Err(fault(Core::K001, "no knots".to_owned()));
        };
        if degree > 1000 {
            return Err(fault(Core::K006, format!("degree {degree} is above 1000")));
        }
        let functions = values.len().checked_sub(degree + 1).filter(|&n| n > 0);
        let Some(functions) = functions else {
            let message = format!("{} knots; a function of degree {degree} lives on {}", values.len(), degree + 2);
            return Err(fault(Core::K001, message));
        };
        if let Some(i) = (1..values.len()).find(|&i| values[i] < values[i - 1]) {
            let message = format!("knot {i} is {}, below knot {} = {}", values[i], i - 1, values[i - 1]);
            return Err(fault(Core::K004, message).at(i));
        }
        if let Some(i) = (degree + 1..values.len()).find(|&i| values[i] == values[i - degree - 1]) {
            let message = format!("the value {} is repeated more than degree + 1 = {} times", values[i], degree + 1);
            return Err(fault(Core::K003, message).at(i));
        }
        let pad = degree + 1;
        let step = |i: usize| Rational::from(i as i64);
        let mut all: Vec<Rational> = (0..pad).map(|i| first - &step(pad - i)).collect();
        all.extend_from_slice(values);
        all.extend((1..=pad).map(|i| last + &step(i)));
        let knots = Knots::new(all, degree).map_err(|error| {
            let index = error.index().map(|i| i.saturating_sub(pad).min(values.len() - 1));
            let error = Error::from(error);
            index.map_or(error.clone(), |i| error.at(i))
        })?;
        Ok(Line { knots, pad, functions })
    }

    /// The longer vector.
    pub(crate) fn knots(&self) -> &Knots<Rational> {
        &self.knots
    }

    /// The spans of the given knots that are not empty, by their place in the longer vector.
    pub(crate) fn spans(&self) -> impl Iterator<Item = usize> {
        let values = self.knots.values();
        (self.pad..values.len() - self.pad - 1).filter(|&i| values[i] < values[i + 1])
    }

    /// The given function that stands at a place of the longer vector.
    pub(crate) fn function(&self, place: usize) -> Option<usize> {
        place.checked_sub(self.pad).filter(|&i| i < self.functions)
    }
}

/// k! for k = 0 … n, as the denominators of Taylor's formula.
pub(crate) fn factorials(n: usize) -> Vec<Rational> {
    let mut all = vec![Rational::one()];
    for k in 1..=n {
        all.push(&all[k - 1] * &Rational::from(k as i64));
    }
    all
}
