//! Polynomials in one variable with fractions as coefficients.

use crate::rational::Rational;
use lath::num::Scalar;
use std::ops::{Add, Mul, Neg, Sub};

/// c₀ + c₁t + c₂t² + …, without zeros at its upper end.
///
/// Its [`Display`](std::fmt::Display) writes it as a textbook does, over one denominator.
///
/// ```
/// use lath_exact::{parse, Polynomial};
///
/// let p = Polynomial::new(parse::fractions("7/12, -1/4, -5/4, 11/12")?);
/// assert_eq!(p.to_string(), "(11t³ − 15t² − 3t + 7)/12");
/// assert_eq!(p.derivative().to_string(), "(11t² − 10t − 1)/4");
/// # Ok::<(), lath_exact::error::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq, Default)]
pub struct Polynomial {
    coefficients: Vec<Rational>,
}

impl Polynomial {
    /// From coefficients of ascending powers.
    pub fn new(mut coefficients: Vec<Rational>) -> Polynomial {
        while coefficients.last().is_some_and(Scalar::is_zero) {
            coefficients.pop();
        }
        Polynomial { coefficients }
    }

    /// The coefficients of ascending powers; none for the zero polynomial.
    pub fn coefficients(&self) -> &[Rational] {
        &self.coefficients
    }

    /// The coefficient of tᵏ, zero above the degree.
    pub fn coefficient(&self, k: usize) -> Rational {
        self.coefficients.get(k).cloned().unwrap_or_else(Rational::zero)
    }

    /// The coefficients of t⁰ … tⁿ, as many zeros at the end as it takes.
    pub fn padded(&self, n: usize) -> Vec<Rational> {
        (0..=n).map(|k| self.coefficient(k)).collect()
    }

    /// The greatest power with a coefficient other than zero; none for the zero polynomial.
    pub fn degree(&self) -> Option<usize> {
        self.coefficients.len().checked_sub(1)
    }

    /// Whether it is zero everywhere.
    pub fn is_zero(&self) -> bool {
        self.coefficients.is_empty()
    }

    /// The value at t, by Horner's rule.
    pub fn eval(&self, t: &Rational) -> Rational {
        self.coefficients.iter().rev().fold(Rational::zero(), |sum, c| &(&sum * t) + c)
    }

    /// The first derivative.
    pub fn derivative(&self) -> Polynomial {
        let terms = self.coefficients.iter().enumerate().skip(1);
        Polynomial::new(terms.map(|(k, c)| c * &Rational::from(k as i64)).collect())
    }

    /// Every coefficient times the factor.
    pub fn scaled(&self, factor: &Rational) -> Polynomial {
        Polynomial::new(self.coefficients.iter().map(|c| c * factor).collect())
    }

    /// The polynomial t ↦ self(inner(t)).
    pub fn compose(&self, inner: &Polynomial) -> Polynomial {
        let constant = |c: &Rational| Polynomial::new(vec![c.clone()]);
        self.coefficients.iter().rev().fold(Polynomial::default(), |sum, c| &(&sum * inner) + &constant(c))
    }

    /// The polynomial t ↦ self(t + a): the same curve with its origin moved to a.
    pub fn shifted(&self, a: &Rational) -> Polynomial {
        // Synthetic division by t − a, again and again.
        let mut c = self.coefficients.clone();
        for start in 0..c.len() {
            for k in (start..c.len().saturating_sub(1)).rev() {
                c[k] = &c[k] + &(&c[k + 1] * a);
            }
        }
        Polynomial::new(c)
    }
}

impl Add<&Polynomial> for &Polynomial {
    type Output = Polynomial;
    fn add(self, other: &Polynomial) -> Polynomial {
        let n = self.coefficients.len().max(other.coefficients.len());
        Polynomial::new((0..n).map(|k| self.coefficient(k) + other.coefficient(k)).collect())
    }
}

impl Neg for &Polynomial {
    type Output = Polynomial;
    fn neg(self) -> Polynomial {
        Polynomial::new(self.coefficients.iter().map(|c| -c.clone()).collect())
    }
}

impl Sub<&Polynomial> for &Polynomial {
    type Output = Polynomial;
    fn sub(self, other: &Polynomial) -> Polynomial {
        self + &-other
    }
}

impl Mul<&Polynomial> for &Polynomial {
    type Output = Polynomial;
    fn mul(self, other: &Polynomial) -> Polynomial {
        let mut product =
            vec![Rational::zero(); (self.coefficients.len() + other.coefficients.len()).saturating_sub(1)];
        for (i, a) in self.coefficients.iter().enumerate() {
            for (j, b) in other.coefficients.iter().enumerate() {
                product[i + j] += a * b;
            }
        }
        Polynomial::new(product)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parse::fractions;

    fn polynomial(text: &str) -> Polynomial {
        Polynomial::new(fractions(text).unwrap())
    }

    #[test]
    fn arithmetic() {
        let (p, q) = (polynomial("1,2,3"), polynomial("-1,0,-3"));
        assert_eq!(&p + &q, polynomial("0,2"));
        assert_eq!(&p - &p, Polynomial::default());
        assert_eq!(&p * &q, polynomial("-1,-2,-6,-6,-9"));
        assert!((&p * &Polynomial::default()).is_zero());
        assert_eq!(p.derivative(), polynomial("2,6"));
        assert!(polynomial("5").derivative().is_zero());
        assert_eq!(p.eval(&Rational::from(2)), 17);
        assert_eq!((p.degree(), Polynomial::default().degree()), (Some(2), None));
        assert_eq!(Polynomial::default().eval(&Rational::from(9)), 0);
    }

    #[test]
    fn a_shift_is_a_composition() {
        let p = polynomial("7/12,-1/4,-5/4,11/12");
        let a = Rational::new(-2, 3).unwrap();
        let moved = p.compose(&Polynomial::new(vec![a.clone(), Rational::one()]));
        assert_eq!(p.shifted(&a), moved);
        assert_eq!(moved.eval(&Rational::one()), p.eval(&Rational::new(1, 3).unwrap()));
        assert_eq!(moved.shifted(&-a), p);
    }
}
