//! E of any answer, from exact polynomials.
//!
//! On a span the spline is a polynomial in x = t − a, a the span's first knot. Its coefficients are found once, in
//! fractions, by de Boor's triangle carried out on polynomials, and brought to one denominator M. A parameter is a float,
//! so x = X/2ˢ, and the value is an integer over M·2^(s·degree): Horner's rule on integers, without a single division. The
//! answer is a float too, so the difference is again an integer. Nothing is rounded until that difference is divided by
//! the condition.
//!
//! The condition Σ|cᵢ|Nᵢ(t) is a sum of non-negative numbers; doubles hold it to some 10⁻¹⁴ of itself, which changes E
//! in its fourteenth digit.
//!
//! The definition itself, with all functions by their recursion on fractions, is in `testkit`: [`agrees`] holds this
//! oracle against it.

use super::input::Case;
use crate::Result;
use dashu_int::IBig;
use dashu_int::ops::{Abs, BitTest};
use lath::knot::Side;
use lath_exact::{Polynomial, Rational};
use testkit::{error_measure, naive, rational};

/// Value, first and second derivative.
pub(crate) const ORDERS: usize = 3;

pub(crate) struct Oracle<'a> {
    case: &'a Case,
    /// By the span's first knot, filled when first asked for.
    pieces: Vec<Option<[Piece; ORDERS]>>,
    /// `[k][i]`: what the control points of the k-th derivative are made of, in absolute values.
    sums: [Vec<f64>; ORDERS],
}

impl<'a> Oracle<'a> {
    pub(crate) fn new(case: &'a Case) -> Oracle<'a> {
        let mut sums = [const { Vec::new() }; ORDERS];
        sums[0] = case.points.iter().map(|b| b.abs()).collect();
        for k in 1..ORDERS.min(case.degree + 1) {
            let r = case.degree + 1 - k; // the degree of this derivative, plus one
            let before = &sums[k - 1];
            sums[k] = (1..before.len())
                .map(|i| {
                    let length = case.knots[i + k - 1 + r] - case.knots[i + k - 1];
                    if length == 0.0 { 0.0 } else { r as f64 * ((before[i] + before[i - 1]) / length) }
                })
                .collect();
        }
        Oracle { case, pieces: (0..case.points.len()).map(|_| None).collect(), sums }
    }

    /// E of the answer `found` for the k-th derivative at t, where the span's polynomial is asked; infinite if it is no
    /// number.
    pub(crate) fn units(&mut self, span: usize, t: f64, k: usize, found: f64) -> Result<f64> {
        if !found.is_finite() {
            return Ok(f64::INFINITY);
        }
        let condition = self.condition(span, t, k);
        if self.pieces[span].is_none() {
            self.pieces[span] = Some(pieces(self.case, span)?);
        }
        let pieces = self.pieces[span].as_ref().ok_or("no pieces")?;
        Ok(pieces[k].off(Dyadic::new(t).minus(Dyadic::new(self.case.knots[span])), found, condition))
    }

    /// The condition as `testkit::error_measure` defines it, with what underflows accounted for as the sweep of the
    /// library's own tests does: a weight that underflows is off by a fixed amount.
    fn condition(&self, span: usize, t: f64, k: usize) -> f64 {
        let (p, knots) = (self.case.degree, &self.case.knots);
        let amplified = 2.0 * p as f64 / (knots[span + 1] - knots[span]);
        let least = (0..k).fold(self.sums[0].iter().sum::<f64>() * f64::MIN_POSITIVE, |least, _| least * amplified);
        let sum = if k > p { 0.0 } else { blended(&self.sums[k][span - p..=span - k], knots, span, t) };
        (sum + least).max(f64::MIN_POSITIVE)
    }
}

/// de Boor's triangle on numbers that are not negative, within the span.
fn blended(c: &[f64], knots: &[f64], span: usize, t: f64) -> f64 {
    let (mut d, q) = (c.to_vec(), c.len() - 1);
    for r in 1..=q {
        for j in (r..=q).rev() {
            let (start, end) = (knots[span + j - q], knots[span + 1 + j - r]);
            d[j] = ((end - t) * d[j - 1] + (t - start) * d[j]) / (end - start);
        }
    }
    d[q]
}

/// The span's polynomial and its derivatives.
fn pieces(case: &Case, span: usize) -> Result<[Piece; ORDERS]> {
    let (p, a) = (case.degree, exactly(case.knots[span])?);
    let mut d = Vec::new();
    for b in &case.points[span - p..=span] {
        d.push(Polynomial::new(vec![exactly(*b)?]));
    }
    for r in 1..=p {
        for j in (r..=p).rev() {
            let (start, end) = (exactly(case.knots[span + j - p])?, exactly(case.knots[span + 1 + j - r])?);
            let length = &end - &start;
            let weight = Polynomial::new(vec![&(&a - &start) / &length, &Rational::from(1) / &length]);
            d[j] = &d[j - 1] + &(&weight * &(&d[j] - &d[j - 1]));
        }
    }
    let value = &d[p];
    let first = value.derivative();
    Ok([Piece::new(value)?, Piece::new(&first)?, Piece::new(&first.derivative())?])
}

fn exactly(x: f64) -> Result<Rational> {
    Rational::from_f64(x).ok_or_else(|| format!("{x} is no fraction").into())
}

/// A polynomial with fractions as coefficients, over one denominator.
struct Piece {
    /// Of ascending powers; empty for zero.
    numerators: Vec<IBig>,
    denominator: IBig,
}

impl Piece {
    fn new(polynomial: &Polynomial) -> Result<Piece> {
        let common = Rational::common_denominator(polynomial.coefficients());
        // Digits are the way from one crate's integers to the other's: once for each span.
        let integer = |x: &Rational| -> Result<IBig> { Ok(x.to_string().parse()?) };
        let numerators = polynomial.coefficients().iter().map(|c| integer(&(c * &common))).collect::<Result<_>>()?;
        Ok(Piece { numerators, denominator: integer(&common)? })
    }

    /// |found − value at x| / (2⁻⁵³ · condition).
    fn off(&self, x: Dyadic, found: f64, condition: f64) -> f64 {
        // x = X/2ˢ.
        let (x, s) =
            if x.exponent > 0 { (x.integer << x.exponent as usize, 0) } else { (x.integer, -x.exponent as usize) };
        let mut shift = 0; // the value is sum / (M · 2^shift)
        let mut sum = IBig::ZERO;
        for (place, c) in self.numerators.iter().rev().enumerate() {
            if place > 0 {
                shift += s;
                sum *= &x;
            }
            sum += c << shift;
        }
        let found = Dyadic::new(found);
        let exponent = shift as i64 + found.exponent;
        let answer = found.integer * &self.denominator;
        let difference =
            if exponent >= 0 { (answer << exponent as usize) - sum } else { answer - (sum << -exponent as usize) };
        let over = shift as i64 + exponent.min(0).abs();
        // Mantissas and exponents apart, for neither integer need fit a double.
        let ((a, i), (b, j)) = (rounded(&difference), rounded(&self.denominator));
        let condition = Dyadic::new(condition);
        let (c, k) = rounded(&condition.integer);
        two_to(a / b / c, i - j - k - condition.exponent - over + 53)
    }
}

/// x · 2ᵉ, infinite or 0 beyond the doubles.
fn two_to(x: f64, e: i64) -> f64 {
    let power = |e: i64| f64::from_bits(((e + 1023) as u64) << 52);
    let half = e.clamp(-2000, 2000) / 2;
    x * power(half) * power(e.clamp(-2000, 2000) - half)
}

/// |n| as m · 2ᵉ with m within 2⁻⁶² of itself.
fn rounded(n: &IBig) -> (f64, i64) {
    let n = n.clone().abs();
    let drop = n.bit_len().saturating_sub(63);
    let top = i64::try_from(n >> drop).unwrap_or(i64::MAX);
    (top as f64, drop as i64)
}

/// integer · 2^exponent, the integer odd or 0.
struct Dyadic {
    integer: IBig,
    exponent: i64,
}

impl Dyadic {
    fn new(x: f64) -> Dyadic {
        let bits = x.to_bits();
        let (raw, fraction) = ((bits >> 52 & 0x7ff) as i64, (bits & ((1 << 52) - 1)) as i64);
        let (mantissa, exponent) = if raw == 0 { (fraction, -1074) } else { (fraction | 1 << 52, raw - 1075) };
        let mantissa = if x.is_sign_negative() { -mantissa } else { mantissa };
        Dyadic::reduced(IBig::from(mantissa), exponent)
    }

    fn reduced(integer: IBig, exponent: i64) -> Dyadic {
        match integer.trailing_zeros() {
            None => Dyadic { integer, exponent: 0 },
            Some(zeros) => Dyadic { integer: integer >> zeros, exponent: exponent + zeros as i64 },
        }
    }

    fn minus(self, other: Dyadic) -> Dyadic {
        let exponent = self.exponent.min(other.exponent);
        let at = |x: Dyadic| x.integer << (x.exponent - exponent) as usize;
        Dyadic::reduced(at(self) - at(other), exponent)
    }
}

/// Holds the oracle against the definition at some parameters of a case; the number of answers compared.
///
/// The answer whose E is measured is the exact one rounded to a double, moved by some units in the last place, so that
/// both small and large errors are met.
///
/// # Errors
/// If an E differs by more than 10⁻⁹ of itself.
pub(crate) fn agrees(case: &Case, parameters: usize) -> Result<usize> {
    let exactly = |floats: &[f64]| floats.iter().map(|x| rational::Rational::from_f64(*x)).collect::<Vec<_>>();
    let (knots, points, p) = (exactly(&case.knots), exactly(&case.points), case.degree);
    let mut oracle = Oracle::new(case);
    let mut compared = 0;
    for (place, &t) in case.parameters.iter().take(parameters).enumerate() {
        let span = case.span(t).ok_or("a parameter outside the domain")?;
        let side = if t == case.knots[span + 1] { Side::Left } else { Side::Right };
        let at = rational::Rational::from_f64(t);
        let amplified = rational::Rational::from_f64(2.0 * p as f64) / (knots[span + 1].clone() - knots[span].clone());
        let least = points.iter().map(|b| b.abs()).sum::<rational::Rational>()
            * rational::Rational::from_f64(f64::MIN_POSITIVE);
        for k in 0..ORDERS.min(p + 1) {
            let exact = naive::spline(&knots, p, &points, k, &at, side);
            let condition =
                error_measure::condition(&knots, p, &points, k, &at, side) + least.clone() * amplified.power(k);
            let found = exact.to_f64() * (1.0 + (place * 7 % 100) as f64 * f64::EPSILON);
            let (here, there) = (oracle.units(span, t, k, found)?, error_measure::units(found, &exact, &condition));
            if (here - there).abs() > 1e-9 * there {
                return Err(format!(
                    "degree {p}, derivative {k} at {t:e}: the oracle says {here}, the definition {there}"
                )
                .into());
            }
            compared += 1;
        }
    }
    Ok(compared)
}
