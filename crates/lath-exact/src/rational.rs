//! Fractions of any size, as a scalar of the core.

use dashu_base::{Approximation, BitTest};
use dashu_int::{IBig, UBig};
use dashu_ratio::RBig;
use lath::num::Scalar;
use std::cmp::Ordering;
use std::fmt;
use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub};
use std::str::FromStr;

/// A fraction in lowest terms, of any size.
///
/// It implements the core's [`Scalar`], so that every generic algorithm of lath runs on it unchanged and answers without
/// rounding. Like any field it must not be divided by zero; nothing in this crate does.
///
/// ```
/// use lath_exact::Rational;
///
/// let third: Rational = "2/6".parse()?;
/// assert_eq!(third.to_string(), "1/3");
/// assert_eq!((third.clone() + third).to_string(), "2/3");
/// assert_eq!(Rational::from_f64(0.1).unwrap().to_string(), "3602879701896397/36028797018963968");
/// # Ok::<(), lath_exact::error::Error>(())
/// ```
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Rational(RBig);

impl Rational {
    /// numerator/denominator; none if the denominator is zero.
    pub fn new(numerator: i64, denominator: i64) -> Option<Rational> {
        (denominator != 0).then(|| Rational::from_int(numerator) / Rational::from_int(denominator))
    }

    /// From a numerator and a denominator that is not zero.
    pub(crate) fn from_parts(numerator: IBig, denominator: UBig) -> Rational {
        Rational(RBig::from_parts(numerator, denominator))
    }

    /// The float's exact value; none if it is not finite.
    pub fn from_f64(x: f64) -> Option<Rational> {
        RBig::try_from(x).ok().map(Rational)
    }

    /// The nearest double, ties to even; infinite beyond the doubles.
    pub fn to_f64(&self) -> f64 {
        match self.0.to_f64() {
            Approximation::Exact(x) | Approximation::Inexact(x, _) => x,
        }
    }

    /// |x|.
    pub fn abs(&self) -> Rational {
        if self.is_negative() { -self.clone() } else { self.clone() }
    }

    /// Whether it is below zero.
    pub fn is_negative(&self) -> bool {
        *self.0.numerator() < IBig::ZERO
    }

    /// Whether its denominator is 1.
    pub fn is_integer(&self) -> bool {
        self.0.is_int()
    }

    /// xⁿ, with x⁰ = 1 also for x = 0.
    pub fn power(&self, n: usize) -> Rational {
        Rational(RBig::from_parts(self.0.numerator().pow(n), self.0.denominator().pow(n)))
    }

    /// The numerator of the fraction in lowest terms; it carries the sign.
    pub fn numerator(&self) -> Rational {
        Rational(RBig::from(self.0.numerator().clone()))
    }

    /// The denominator of the fraction in lowest terms, positive.
    pub fn denominator(&self) -> Rational {
        Rational(RBig::from(self.0.denominator().clone()))
    }

    /// How many bits numerator and denominator take together.
    pub(crate) fn bits(&self) -> u64 {
        (self.0.numerator().bit_len() + self.0.denominator().bit_len()) as u64
    }

    /// Numerator and denominator as doubles, if both are integers that a double holds exactly.
    pub(crate) fn as_doubles(&self) -> Option<(f64, f64)> {
        let (n, d) = (i64::try_from(self.0.numerator()).ok()?, i64::try_from(self.0.denominator()).ok()?);
        let fits = n.unsigned_abs() <= 1 << 53 && d <= 1 << 53;
        fits.then_some((n as f64, d as f64))
    }

    /// The least positive number that makes integers of all the given fractions: the least common multiple of their denominators.
    ///
    /// ```
    /// use lath_exact::{parse, Rational};
    ///
    /// assert_eq!(Rational::common_denominator(&parse::fractions("1/6, -3/4, 2")?).to_string(), "12");
    /// # Ok::<(), lath_exact::error::Error>(())
    /// ```
    pub fn common_denominator<'a>(values: impl IntoIterator<Item = &'a Rational>) -> Rational {
        use dashu_base::Gcd;
        let mut multiple = UBig::ONE;
        for value in values {
            let d = value.0.denominator();
            if *d != UBig::ONE && !(&multiple % d).is_zero() {
                multiple = &multiple / (&multiple).gcd(d) * d;
            }
        }
        Rational(RBig::from(multiple))
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
    fn is_zero(&self) -> bool {
        self.0.is_zero()
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
        impl $trait<&Rational> for &Rational {
            type Output = Rational;
            fn $method(self, other: &Rational) -> Rational {
                Rational((&self.0).$method(&other.0))
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

impl From<i64> for Rational {
    fn from(n: i64) -> Rational {
        Rational(RBig::from(n))
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
    type Err = crate::error::Error;

    fn from_str(text: &str) -> Result<Rational, Self::Err> {
        crate::parse::fraction(text)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn floats_come_and_go_without_loss() {
        for x in [0.0, 0.1, -1e300, 5e-324, 1.0 / 3.0, f64::MAX] {
            assert_eq!(Rational::from_f64(x).unwrap().to_f64(), x);
        }
        assert!(Rational::from_f64(f64::NAN).is_none() && Rational::from_f64(f64::INFINITY).is_none());
        assert_eq!(Rational::new(1, 3).unwrap().to_f64(), 1.0 / 3.0);
        assert_eq!(Rational::from((1 << 53) + 1).to_f64(), 9_007_199_254_740_992.0);
        assert!(Rational::new(1, 0).is_none());
    }

    #[test]
    fn the_sign_sits_in_the_numerator() {
        let x = Rational::new(3, -9).unwrap();
        assert_eq!((x.numerator(), x.denominator()), (Rational::from(-1), Rational::from(3)));
        assert!(x.is_negative() && !x.is_integer() && x.abs() == Rational::new(1, 3).unwrap());
        assert_eq!(x.power(0), 1);
        assert_eq!(x.power(3).to_string(), "-1/27");
        assert_eq!(Rational::zero().power(0), 1);
    }

    #[test]
    fn common_denominators() {
        let values = crate::parse::fractions("1/6,1/4,-2").unwrap();
        assert_eq!(Rational::common_denominator(&values), 12);
        assert_eq!(Rational::common_denominator(&[]), 1);
    }
}
