//! How wrong a float is, in units that mean something: E = |computed − exact| / (u · condition), u = 2⁻⁵³.
//!
//! The condition is Σ|bᵢ||wᵢ|, the size of what was added up. An E of a few says that the answer is as good as the
//! data's own last digit allows, however much cancelled; a relative error says nothing near a zero.

use crate::naive::bspline;
use crate::rational::Rational;
use lath::knot::Side;
use lath::num::Scalar;

/// E = |computed − exact| / (2⁻⁵³ · condition). Where the condition is 0 the answer must be exact: E is 0 or infinite.
pub fn units(computed: f64, exact: &Rational, condition: &Rational) -> f64 {
    if !computed.is_finite() {
        return f64::INFINITY;
    }
    let error = (Rational::from_f64(computed) - exact.clone()).abs();
    if error == 0 {
        return 0.0;
    }
    if *condition == 0 {
        return f64::INFINITY;
    }
    (error / condition.clone() * Rational::from(1 << 53)).to_f64()
}

/// The condition Σ|bᵢ|N_{i,p}(t) of a spline's value.
pub fn value_condition(knots: &[Rational], p: usize, b: &[Rational], t: &Rational, side: Side) -> Rational {
    (0..b.len()).map(|i| b[i].abs() * bspline(knots, p, i, t, side)).sum()
}

/// The condition of the k-th derivative: the value's condition of the k-th difference curve, whose control points are
/// built from |bᵢ| with sums in place of differences.
///
/// c⁰ᵢ = |bᵢ|, cᵏᵢ = r (cᵏ⁻¹ᵢ + cᵏ⁻¹ᵢ₋₁)/(t_{i+r} − tᵢ) for r = p − k + 1: what rounding can be blamed on the data.
pub fn derivative_condition(
    knots: &[Rational],
    p: usize,
    b: &[Rational],
    k: usize,
    t: &Rational,
    side: Side,
) -> Rational {
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
    (0..sums.len()).map(|i| sums[i].clone() * bspline(knots, p - k, i + k, t, side)).sum()
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
        assert_eq!(units(1.0, &exact, &Rational::zero()), f64::INFINITY);
    }

    #[test]
    fn the_condition_of_a_slope_adds_what_the_slope_subtracts() {
        // A line from 1 to 3 over [0, 2]: slope 1, made of 3/2 and −1/2.
        let knots: Vec<Rational> = [0, 0, 2, 2].map(Rational::from).to_vec();
        let b = [Rational::from(1), Rational::from(3)];
        assert_eq!(derivative_condition(&knots, 1, &b, 1, &Rational::one(), Side::Right), 2);
    }
}
