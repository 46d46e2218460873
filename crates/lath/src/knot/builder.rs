//! Knot vectors by rule.

use crate::error::{Code, Count, Error, Result};
use crate::knot::vector::{Knots, check_degree};
use crate::num::Scalar;
use alloc::format;

impl<S: Scalar> Knots<S> {
    /// Uniform knots with unit spans, −p, …, n, so that the domain is [0, n − p].
    ///
    /// ```
    /// let knots = lath::knot::Knots::<f64>::uniform(4, 3)?;
    /// assert_eq!(knots.values(), [-3.0, -2.0, -1.0, 0.0, 1.0, 2.0, 3.0, 4.0]);
    /// # Ok::<(), lath::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// P001 for fewer than p + 1 functions; K006 for a degree above 1000.
    pub fn uniform(functions: usize, degree: usize) -> Result<Knots<S>> {
        check_functions(functions, degree)?;
        let knot = |i: usize| S::from_int(i as i64 - degree as i64);
        Knots::new((0..functions + degree + 1).map(knot).collect(), degree)
    }

    /// Clamped knots: the ends p + 1 times, unit spans between, domain [0, n − p]. The curve starts and ends in its
    /// first and last control point.
    ///
    /// ```
    /// let knots = lath::knot::Knots::<f64>::clamped(5, 2)?;
    /// assert_eq!(knots.values(), [0.0, 0.0, 0.0, 1.0, 2.0, 3.0, 3.0, 3.0]);
    /// # Ok::<(), lath::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`Knots::uniform`].
    pub fn clamped(functions: usize, degree: usize) -> Result<Knots<S>> {
        check_functions(functions, degree)?;
        let spans = functions - degree;
        let knot = |i: usize| S::from_int(i.saturating_sub(degree).min(spans) as i64);
        Knots::new((0..functions + degree + 1).map(knot).collect(), degree)
    }

    /// Clamped knots from data parameters, for interpolation at the parameters themselves with the not-a-knot rule:
    /// odd degree p drops the (p − 1)/2 parameters next to each end, even degree takes the middles between neighbours
    /// and drops p/2 at each end. There are as many functions as parameters.
    ///
    /// *Source.* de Boor, A Practical Guide to Splines (1978), ch. XIII.
    ///
    /// ```
    /// use lath::knot::Knots;
    ///
    /// let t = [0.0, 1.0, 2.0, 4.0, 5.0];
    /// assert_eq!(Knots::from_data(&t, 3)?.values(), [0.0, 0.0, 0.0, 0.0, 2.0, 5.0, 5.0, 5.0, 5.0]);
    /// assert_eq!(Knots::from_data(&t, 2)?.values(), [0.0, 0.0, 0.0, 1.5, 3.0, 5.0, 5.0, 5.0]);
    /// # Ok::<(), lath::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// P001 for fewer than p + 1 parameters; T003 with the index of a parameter that does not exceed its predecessor.
    pub fn from_data(parameters: &[S], degree: usize) -> Result<Knots<S>> {
        let n = parameters.len();
        check_functions(n, degree)?;
        if let Some(i) =
            (1..n).find(|&i| parameters[i].partial_cmp(&parameters[i - 1]) != Some(core::cmp::Ordering::Greater))
        {
            let message = format!("parameter {i} is {:?}, not above {:?}", parameters[i], parameters[i - 1]);
            return Err(Error::new(Code::T003, message).at(i));
        }
        // Inner knots: n − p − 1 of them, starting from the data site where the first polynomial piece may end.
        let inner = |j: usize| {
            let site = j + degree.div_ceil(2);
            match degree % 2 {
                1 => parameters[site].clone(),
                _ => (parameters[site].clone() + parameters[site + 1].clone()) / S::from_int(2),
            }
        };
        let ends = degree + 1;
        let mut values = alloc::vec![parameters[0].clone(); ends];
        values.extend((0..n - ends).map(inner));
        values.extend(core::iter::repeat_n(parameters[n - 1].clone(), ends));
        Knots::new(values, degree)
    }
}

fn check_functions(functions: usize, degree: usize) -> Result<()> {
    check_degree(degree)?;
    if functions > degree {
        return Ok(());
    }
    let message = format!("{} for degree {degree}, which takes at least {}", Count(functions, "point"), degree + 1);
    Err(Error::new(Code::P001, message))
}
