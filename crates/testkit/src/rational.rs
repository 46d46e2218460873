//! Exact fractions as a scalar of the core.
//!
//! The core's generic code runs on [`Rational`] unchanged, so a test can compare its answer with a fraction from a book,
//! digit for digit, and the same code on floats with the exact answer.

use dashu_base::Approximation;
use dashu_int::IBig;
use dashu_ratio::RBig;
use lath::num::Scalar;
use std::cmp::Ordering;
use std::fmt;
use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub};
use std::str::FromStr;

/// A fraction in lowest terms, of any size.
///
/// ```
/// use testkit::rational::Rational;
///
/// let third: Rational = "2/6".parse().unwrap();
/// assert_eq!(third.to_string(), "1/3");
/// assert_eq!(Rational::from_f64(0.1).to_string(), "3602879701896397/36028797018963968");
/// ```
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Rational(RBig);

/// numerator/denominator.
///
/// # Panics
/// If the denominator is zero.
pub fn ratio(numerator: i64, denominator: i64) -> Rational {
    Rational::from_int(numerator) / Rational::from_int(denominator)
}

impl Rational {
    /// The float's exact value.
    ///
    /// # Panics
    /// If it is not finite.
    pub fn from_f64(x: f64) -> Rational {
        Rational(RBig::try_from(x).unwrap_or_else(|_| panic!("{x} is no fraction")))
    }

    /// The nearest float, ties to even.
    pub fn to_f64(&self) -> f64 {
        match self.0.to_f64() {
            Approximation::Exact(x) | Approximation::Inexact(x, _) => x,
        }
    }

    /// Whether a float holds it exactly.
    pub fn is_f64(&self) -> bool {
        matches!(self.0.to_f64(), Approximation::Exact(x) if x.is_finite())
    }

    /// |x|.
    pub fn abs(&self) -> Rational {
        if *self < Rational::zero() { -self.clone() } else { self.clone() }
    }

    /// xⁿ, with x⁰ = 1 also for x = 0.
    pub fn power(&self, n: usize) -> Rational {
        (0..n).fold(Rational::one(), |product, _| product * self.clone())
    }
}

impl Scalar for Rational {
    fn zero() -> Self {
        Rational(RBig::ZERO)
    }
    fn one() -> Self {
        Rational(RBig::ONE)
    }
    fn from_int(n: i64) -> Self {
        Rational(RBig::from(n))
    }
    fn is_finite(&self) -> bool {
        true
    }
}

macro_rules! operator {
    ($($trait:ident $method:ident)*) => {$(
        impl $trait for Rational {
            type Output = Rational;
            fn $method(self, other: Rational) -> Rational {
                Rational(self.0.$method(other.0))
            }
        }
    )*};
}
operator!(Add add Sub sub Mul mul Div div);

impl Neg for Rational {
    type Output = Rational;
    fn neg(self) -> Rational {
        Rational(-self.0)
    }
}

impl AddAssign for Rational {
    fn add_assign(&mut self, other: Rational) {
        self.0 += other.0;
    }
}

impl std::iter::Sum for Rational {
    fn sum<I: Iterator<Item = Rational>>(items: I) -> Rational {
        items.fold(Rational::zero(), Add::add)
    }
}

impl PartialEq<i64> for Rational {
    fn eq(&self, other: &i64) -> bool {
        self.0 == RBig::from(*other)
    }
}

impl PartialOrd<i64> for Rational {
    fn partial_cmp(&self, other: &i64) -> Option<Ordering> {
        self.0.partial_cmp(&RBig::from(*other))
    }
}

impl From<i64> for Rational {
    fn from(n: i64) -> Rational {
        Rational(RBig::from(n))
    }
}

impl fmt::Display for Rational {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(&self.0, f)
    }
}

impl fmt::Debug for Rational {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(&self.0, f)
    }
}

impl FromStr for Rational {
    type Err = String;

    /// Reads `-12`, `121/384`.
    fn from_str(text: &str) -> Result<Rational, String> {
        let integer = |part: &str| part.trim().parse::<IBig>().map_err(|_| format!("`{text}` is no fraction"));
        let (numerator, denominator) = text.split_once('/').unwrap_or((text, "1"));
        let (numerator, denominator) = (integer(numerator)?, integer(denominator)?);
        if denominator == IBig::ZERO {
            return Err(format!("`{text}` divides by zero"));
        }
        Ok(Rational(RBig::from_parts_signed(numerator, denominator)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fractions_are_read_and_printed_in_lowest_terms() {
        for (text, printed) in [("121/384", "121/384"), ("-2/6", "-1/3"), ("4/2", "2"), ("-7", "-7"), ("3/-9", "-1/3")]
        {
            assert_eq!(text.parse::<Rational>().unwrap().to_string(), printed);
        }
        for text in ["", "1/0", "a", "1/", "1.5", "1/2/3"] {
            assert!(text.parse::<Rational>().is_err(), "{text}");
        }
    }

    #[test]
    fn floats_come_and_go_without_loss() {
        for x in [0.0, 0.1, -1e300, 5e-324, 1.0 / 3.0, f64::MAX] {
            assert_eq!(Rational::from_f64(x).to_f64(), x);
            assert!(Rational::from_f64(x).is_f64());
        }
        assert!(!ratio(1, 3).is_f64());
        assert_eq!(ratio(1, 3).to_f64(), 1.0 / 3.0);
        // A tie goes to the even neighbour: 2⁵³ + 1 lies between 2⁵³ and 2⁵³ + 2.
        assert_eq!(Rational::from_int((1 << 53) + 1).to_f64(), 9_007_199_254_740_992.0);
    }
}
