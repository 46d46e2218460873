//! How wrong a float is, in units that mean something: E = |computed − exact| / (u · condition), u = 2⁻⁵³.
//!
//! The condition is Σ|bᵢ||wᵢ|, the size of what was added up. An E of a few says that the answer is as good as the
//! data's own last digit allows, however much cancelled; a relative error says nothing near a zero.

use crate::naive::bspline_row;
use crate::rational::Rational;
use lath::knot::Side;
use lath::num::Scalar;

/// E = |computed − exact| / (2⁻⁵³ · condition).
///
/// A condition below the least normal number counts as that number: there floats have a fixed spacing, and underflow is not
/// an error of the algorithm. A condition of 0 thus asks for an exact answer, up to a last subnormal digit or two.
pub fn units(computed: f64, exact: &Rational, condition: &Rational) -> f64 {
    if !computed.is_finite() {
        return f64::INFINITY;
    }
    let error = (Rational::from_f64(computed) - exact.clone()).abs();
    let least = Rational::from_f64(f64::MIN_POSITIVE);
    let condition = if *condition < least { least } else { condition.clone() };
    (error / condition * Rational::from(1 << 53)).to_f64()
}

/// The condition of the k-th derivative of a spline; for k = 0, its value, this is Σ|bᵢ|N_{i,p}(t).
///
/// The k-th derivative is a spline of degree p − k whose control points are differences of the data. Its condition is that
/// spline's, with sums in place of differences, cᵏᵢ = r (cᵏ⁻¹ᵢ + cᵏ⁻¹ᵢ₋₁)/(t_{i+r} − tᵢ) with r = p − k + 1 and c⁰ᵢ = |bᵢ|: the size of what
/// was added up. (Σ|bᵢ||Nᵢ⁽ᵏ⁾| would be smaller, and vanishes where a derivative of every function does; no way of
/// evaluating from control points is small against it.)
pub fn condition(knots: &[Rational], p: usize, b: &[Rational], k: usize, t: &Rational, side: Side) -> Rational {
    let mut sums: Vec<Rational> = b.iter().map(Rational::abs).collect();
    for r in (p + 1 - k..=p).rev() {
        // Of the sums before, entry i belongs to function i + (p − r) of degree r.
        let offset = p - r;
        sums = (1..sums.len())
            .map(|i| {
                let length = knots[i + offset + r].clone() - knots[i + offset].clone();
                let sum = sums[i].clone() + sums[i - 1].clone();
                if length == 0 { Rational::zero() } else { Rational::from(r as i64) * sum / length }
            })
            .collect();
    }
    let row = bspline_row(knots, p - k, 0, t, side);
    sums.iter().zip(&row[k..]).map(|(sum, value)| sum.clone() * value.clone()).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rational::ratio;

    #[test]
    fn half_a_unit_in_the_last_place_is_one() {
        let exact = Rational::one() + ratio(1, 1 << 53);
        assert_eq!(units(1.0, &exact, &Rational::one()), 1.0);
        assert_eq!(units(1.0, &Rational::one(), &Rational::zero()), 0.0);
        assert_eq!(units(f64::NAN, &exact, &exact), f64::INFINITY);
        assert!(units(1.0, &exact, &Rational::zero()) > 1e290);
        assert_eq!(units(5e-324, &Rational::zero(), &Rational::zero()), 2.0);
    }

    #[test]
    fn the_condition_of_a_slope_adds_what_the_slope_subtracts() {
        // A line from 1 to 3 over [0, 2]: slope 1, made of 3/2 and −1/2.
        let knots: Vec<Rational> = [0, 0, 2, 2].map(Rational::from).to_vec();
        let b = [Rational::from(1), Rational::from(3)];
        assert_eq!(condition(&knots, 1, &b, 1, &Rational::one(), Side::Right), 2);
    }
}
