//! The validated knot vector.

use crate::error::{Code, Count, Error, Result};
use crate::num::Scalar;
use alloc::format;
use alloc::vec::Vec;

/// The greatest degree: beyond it a triangle of de Boor costs more than a million operations a point, and a hostile
/// file could ask for it.
pub(crate) const MAX_DEGREE: usize = 1000;

/// A knot vector with its degree, valid by construction.
///
/// ```
/// use lath::knot::Knots;
///
/// let knots = Knots::new(vec![0.0, 0.0, 0.0, 1.0, 2.0, 3.0, 3.0, 3.0], 2)?;
/// assert_eq!(knots.functions(), 5);
/// assert_eq!(knots.domain(), (0.0, 3.0));
/// assert_eq!(knots.breaks(), [0.0, 1.0, 2.0, 3.0]);
/// # Ok::<(), lath::error::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Knots<S = f64> {
    values: Vec<S>,
    degree: usize,
}

impl<S: Scalar> Knots<S> {
    /// Takes n + p + 1 knots for n functions of degree p.
    ///
    /// *Cost.* O(knots).
    ///
    /// # Errors
    /// K006 degree above 1000; K001 fewer than 2 (p + 1) knots; K002 a knot that is not finite; K007 a knot out of scale;
    /// K004 a knot below the one before it; K003 more than p + 1 equal knots; K005 t_p = t_n. Each with the culprit's index.
    pub fn new(values: Vec<S>, degree: usize) -> Result<Knots<S>> {
        check_degree(degree)?;
        if let Some(i) = values.iter().position(|t| !t.is_finite()) {
            return Err(Error::new(Code::K002, format!("knot {i} is {:?}", values[i])).at(i));
        }
        if let Some(i) = values.iter().position(out_of_scale) {
            return Err(Error::new(Code::K007, format!("knot {i} is {:?}", values[i])).at(i));
        }
        if let Some(i) = (1..values.len()).find(|&i| values[i] < values[i - 1]) {
            let (a, b) = (&values[i - 1], &values[i]);
            return Err(Error::new(Code::K004, format!("knot {i} is {b:?}, below knot {} = {a:?}", i - 1)).at(i));
        }
        let least = 2 * (degree + 1);
        if values.len() < least {
            let count = values.len();
            return Err(Error::new(
                Code::K001,
                format!("{}, but degree {degree} needs at least {least}", Count(count, "knot")),
            ));
        }
        let mut run = 1;
        for i in 1..values.len() {
            run = if values[i] == values[i - 1] { run + 1 } else { 1 };
            if run > degree + 1 {
                let total = values.iter().filter(|t| **t == values[i]).count();
                let message = format!(
                    "the value {:?} is repeated {total} times, above degree + 1 = {}, from knot {i} on",
                    values[i],
                    degree + 1
                );
                return Err(Error::new(Code::K003, message).at(i));
            }
        }
        let functions = values.len() - degree - 1;
        if values[degree] == values[functions] {
            let t = &values[degree];
            let message = format!("knots {degree} and {functions}, the ends of the domain, are both {t:?}");
            return Err(Error::new(Code::K005, message).at(degree));
        }
        Ok(Knots { values, degree })
    }

    /// Takes one period, n + 1 knots, of a closed curve with n control points, and extends it by p knots on both sides:
    /// the knots of the open curve through the same points followed by the first p of them, with domain [first, last].
    ///
    /// ```
    /// use lath::knot::Knots;
    ///
    /// let knots = Knots::periodic(&[0.0, 1.0, 2.5, 4.0], 2)?;
    /// assert_eq!(knots.values(), [-3.0, -1.5, 0.0, 1.0, 2.5, 4.0, 5.0, 6.5]);
    /// assert_eq!(knots.domain(), (0.0, 4.0));
    /// # Ok::<(), lath::error::Error>(())
    /// ```
    ///
    /// *Error.* The knots outside the period are shifted by it and rounded: spans as short as some ulps of the domain change by as
    /// much, and a curve over them closes only so well.
    ///
    /// # Errors
    /// As [`Knots::new`]; indices are those of the period.
    pub fn periodic(period: &[S], degree: usize) -> Result<Knots<S>> {
        check_degree(degree)?;
        let Some(n) = period.len().checked_sub(1).filter(|&n| n > 0) else {
            let message = format!("a period of {}; it takes at least 2", Count(period.len(), "knot"));
            return Err(Error::new(Code::K001, message));
        };
        // Checked as piecewise constants first, so that a fault is reported at the place where the caller wrote it.
        if let Some(i) = period.iter().position(|t| !t.is_finite()) {
            return Err(Error::new(Code::K002, format!("knot {i} is {:?}", period[i])).at(i));
        }
        if let Some(i) = (1..=n).find(|&i| period[i] < period[i - 1]) {
            return Err(Error::new(Code::K004, format!("knot {i} is below knot {}", i - 1)).at(i));
        }
        let length = period[n].clone() - period[0].clone();
        let knot = |m: usize| {
            // Place m of the extended vector is place m − p of the period, which repeats every n places.
            let (turns, place) = if m >= degree {
                (((m - degree) / n) as i64, (m - degree) % n)
            } else {
                let back = degree - m;
                (-(back.div_ceil(n) as i64), (n - back % n) % n)
            };
            match turns {
                0 => period[place].clone(), // to the bit
                _ => period[place].clone() + S::from_int(turns) * length.clone(),
            }
        };
        let mut values: Vec<S> = (0..n + 2 * degree + 1).map(knot).collect();
        values[degree + n] = period[n].clone();
        // A shift by the period rounds, and may bring knots a few ulps apart out of order.
        for i in degree + n + 1..values.len() {
            if values[i] < values[i - 1] {
                values[i] = values[i - 1].clone();
            }
        }
        for i in (0..degree).rev() {
            if values[i] > values[i + 1] {
                values[i] = values[i + 1].clone();
            }
        }
        let knots = Knots::new(values, degree);
        // In the extended vector the culprit stands `degree` places further right.
        knots.map_err(|error| match error.index() {
            Some(index) => error.at(index.saturating_sub(degree) % (n + 1)),
            None => error,
        })
    }

    /// All knots, t₀ … t_{n+p}.
    pub fn values(&self) -> &[S] {
        &self.values
    }

    /// The degree p.
    pub fn degree(&self) -> usize {
        self.degree
    }

    /// The number n of B-splines, and so of control points.
    pub fn functions(&self) -> usize {
        self.values.len() - self.degree - 1
    }

    /// [t_p, t_n]: where the B-splines sum to 1.
    pub fn domain(&self) -> (S, S) {
        (self.values[self.degree].clone(), self.values[self.functions()].clone())
    }

    /// The distinct knots of the domain, increasing.
    pub fn breaks(&self) -> Vec<S> {
        let mut breaks = self.values[self.degree..=self.functions()].to_vec();
        breaks.dedup();
        breaks
    }

    /// How often the value t occurs among all knots; 0 where there is no knot.
    pub fn multiplicity(&self, t: &S) -> usize {
        self.values.iter().filter(|knot| *knot == t).count()
    }

    /// Refuses another number of control points than functions (K001), naming the two-knots-fewer convention when the
    /// numbers fit it.
    pub(crate) fn check_points(&self, points: usize) -> Result<()> {
        check_count(self.values.len(), self.degree, points)
    }
}

/// Refuses a knot count that does not fit the points; see [`Knots::check_points`].
pub(crate) fn check_count(knots: usize, degree: usize, points: usize) -> Result<()> {
    let wanted = points + degree + 1;
    if knots == wanted {
        return Ok(());
    }
    let hint = if knots + 2 == wanted {
        "; two fewer looks like the convention without the superfluous first and last knot: repeat both"
    } else {
        ""
    };
    let message = format!(
        "{} for {} of degree {degree}, which take {wanted}{hint}",
        Count(knots, "knot"),
        Count(points, "point")
    );
    Err(Error::new(Code::K001, message))
}

/// Refuses another number of knots than the n + 1 of one period for n points (K001).
pub(crate) fn check_period(knots: usize, points: usize) -> Result<()> {
    if knots == points + 1 {
        return Ok(());
    }
    let message = format!(
        "{} for a closed curve of {}, which takes {}: one period",
        Count(knots, "knot"),
        Count(points, "point"),
        points + 1
    );
    Err(Error::new(Code::K001, message))
}

/// Refuses degrees beyond [`MAX_DEGREE`] (K006).
pub(crate) fn check_degree(degree: usize) -> Result<()> {
    if degree <= MAX_DEGREE {
        return Ok(());
    }
    Err(Error::new(Code::K006, format!("degree {degree} is above {MAX_DEGREE}")))
}

/// Whether |t| exceeds 1e300, as a scalar of any kind can tell.
fn out_of_scale<S: Scalar>(t: &S) -> bool {
    // No f64 constant is needed, so fractions pass through the same door: 1e300 is sixteen times 1e18, and 1e12.
    let unit = S::from_int(1_000_000_000_000_000_000);
    let mut rest = if *t < S::zero() { -t.clone() } else { t.clone() };
    for _ in 0..16 {
        if rest <= unit {
            return false;
        }
        rest = rest / unit.clone();
    }
    rest > S::from_int(1_000_000_000_000)
}

#[cfg(test)]
mod tests {
    use super::*;
    use alloc::vec;

    fn code(values: Vec<f64>, degree: usize) -> (Code, Option<usize>) {
        let error = Knots::new(values, degree).unwrap_err();
        (error.code(), error.index())
    }

    #[test]
    fn every_fault_has_its_code_and_place() {
        assert_eq!(code(vec![0.0, 1.0, f64::NAN, 2.0], 1), (Code::K002, Some(2)));
        assert_eq!(code(vec![0.0, 1.0, f64::INFINITY, 2.0], 1), (Code::K002, Some(2)));
        assert_eq!(code(vec![0.0, 1e305, 1e306, 1e307], 1), (Code::K007, Some(1)));
        assert_eq!(code(vec![0.0, 0.9e300, 1.1e300, 1.2e300], 1), (Code::K007, Some(2)));
        assert_eq!(code(vec![0.0, 1.0, 0.5, 2.0], 1), (Code::K004, Some(2)));
        assert_eq!(code(vec![0.0, 1.0, 2.0], 1), (Code::K001, None));
        assert_eq!(code(vec![0.0, 1.0, 1.0, 1.0, 2.0], 1), (Code::K003, Some(3)));
        assert_eq!(code(vec![0.0, 1.0, 1.0, 2.0], 1), (Code::K005, Some(1)));
        assert_eq!(code(vec![1.0, 1.0], 0), (Code::K003, Some(1)));
        assert_eq!(code(vec![0.0, 1.0], 1001), (Code::K006, None));
    }

    #[test]
    fn zeros_of_both_signs_are_one_knot() {
        assert_eq!(Knots::new(vec![-0.0, 0.0, 1.0, 1.0], 1).unwrap().breaks().len(), 2);
        assert_eq!(code(vec![-0.0, 0.0, -0.0, 1.0, 2.0], 1), (Code::K003, Some(2)));
    }

    #[test]
    fn the_convention_with_two_knots_fewer_is_named() {
        let knots = Knots::new(vec![0.0, 0.0, 0.0, 1.0, 1.0, 1.0], 2).unwrap();
        let message = Error::message(&knots.check_points(5).unwrap_err()).contains("superfluous");
        assert!(message);
        assert!(!knots.check_points(4).unwrap_err().message().contains("superfluous"));
    }

    #[test]
    fn periods_of_spans_of_one_ulp_stay_in_order() {
        for period in [[-0.48, -0.4799999999999999, 0.65], [-0.9, 0.49999999999999994, 0.5]] {
            for degree in 0..6 {
                let knots = Knots::periodic(&period, degree).unwrap();
                assert!(knots.values().is_sorted() && knots.domain() == (period[0], period[2]));
            }
        }
    }

    #[test]
    fn a_period_shorter_than_the_degree_wraps_more_than_once() {
        let knots = Knots::periodic(&[0.0, 1.0, 3.0], 5).unwrap();
        assert_eq!(knots.values(), [-8.0, -6.0, -5.0, -3.0, -2.0, 0.0, 1.0, 3.0, 4.0, 6.0, 7.0, 9.0, 10.0]);
        let fault = Knots::periodic(&[0.0, 2.0, 1.0], 3).unwrap_err();
        assert_eq!((fault.code(), fault.index()), (Code::K004, Some(2)));
    }
}
