//! The speed of a piece near the middle of an interval, and its integral with a bound.
//!
//! On an interval, written as −1 ≤ z ≤ 1, the derivative of a polynomial piece is Σ Dⱼ zʲ, and its squared length q(z) = Σ aⱼ zʲ is a polynomial
//! too. As long as Σ |aⱼ| Rʲ over j ≥ 1 stays below a₀, q has no zero for complex |z| ≤ R; then √q is analytic in the ellipse
//! of Gauss quadrature with (ρ + 1/ρ)/2 = R, at most √(2a₀) there, and the error is proven. Where the speed nearly vanishes that fails for every R > 1: at a cusp
//! there remains the bracket |∫ P′| ≤ L ≤ ∫ Σ |Dⱼ| |z|ʲ, which shrinks with the square of the interval.
//!
//! Rational pieces P = A/w have the derivative (A′w − Aw′)/w²: the same with N = A′w − Aw′, and w must stay away from zero as well.

use crate::basis::bernstein::jet;
use crate::num::gauss::{RULES, shares_missed};
use crate::space::{Homogeneous, Weighted, norm};
use alloc::vec::Vec;

/// The unit of rounding, 2⁻⁵³.
const UNIT: f64 = f64::EPSILON / 2.0;

/// Degrees above this are measured by their control polygons: derivatives about a point would be all rounding.
const MAX_DEGREE: usize = 40;

/// Weights further apart are left to the control polygons.
const WEIGHT_RATIO: f64 = 1e6;

/// The sizes of the ellipses that are tried, ρ.
const RHOS: [f64; 10] = [1.25, 1.6, 2.1, 3.0, 4.5, 8.0, 16.0, 50.0, 400.0, 1e4];

/// A Bézier piece prepared for expansions: differences are taken once, and sizes brought near 1 by a power of two.
#[derive(Debug)]
pub(crate) struct Piece<const D: usize> {
    form: Form<D>,
    scale: f64,
    /// A bound for the length of a derivative's control points, scaled; of (A′w − Aw′)'s for a rational piece.
    size: f64,
}

#[derive(Debug)]
enum Form<const D: usize> {
    /// The control points of the derivative.
    Polynomial(Vec<[f64; D]>),
    /// Homogeneous control points about the first point, and the least weight.
    Rational(Vec<Homogeneous<D>>, f64),
}

impl<const D: usize> Piece<D> {
    /// The polynomial piece of these points; none if its degree is too high.
    pub(crate) fn polynomial(points: &[[f64; D]]) -> Option<Piece<D>> {
        let degree = points.len() - 1;
        if degree > MAX_DEGREE {
            return None;
        }
        let steps = || points.windows(2).map(|side| core::array::from_fn(|c| side[1][c] - side[0][c]));
        let scale = power_of_two_above(steps().map(|step| norm::<D>(&step)));
        let factor = degree as f64 / scale;
        let slopes: Vec<[f64; D]> = steps().map(|step: [f64; D]| step.map(|x| x * factor)).collect();
        Some(Piece { form: Form::Polynomial(slopes), scale, size: degree as f64 })
    }

    /// The rational piece of these points; none if its degree is too high, or its weights too far apart or not positive.
    pub(crate) fn rational(points: &[Weighted<D>]) -> Option<Piece<D>> {
        let degree = points.len() - 1;
        let (least, most) = points.iter().fold((f64::INFINITY, 0.0), |(lo, hi): (f64, f64), p| {
            (if p.weight < lo { p.weight } else { lo }, if p.weight > hi { p.weight } else { hi })
        });
        if degree > MAX_DEGREE / 2 || !(least > 0.0 && most <= WEIGHT_RATIO * least) {
            return None;
        }
        let origin = points[0].point;
        let from_origin = |p: &Weighted<D>| core::array::from_fn(|c| p.point[c] - origin[c]);
        let scale = power_of_two_above(points.iter().map(|p| norm::<D>(&from_origin(p))));
        let homogeneous = points.iter().map(|p| {
            let weight = p.weight / most;
            Homogeneous { point: from_origin(p).map(|x| x / scale * weight), weight }
        });
        Some(Piece { form: Form::Rational(homogeneous.collect(), least / most), scale, size: degree as f64 })
    }

    /// Whether every number is finite.
    pub(crate) fn is_finite(&self) -> bool {
        match &self.form {
            Form::Polynomial(slopes) => slopes.iter().all(|d| d.iter().all(|x| x.is_finite())),
            Form::Rational(points, _) => points.iter().all(|p| p.point.iter().all(|x| x.is_finite())),
        }
    }

    /// The speed on [lo, hi] ⊂ [0, 1].
    pub(crate) fn expand(&self, lo: f64, hi: f64) -> Expansion<D> {
        let (middle, half) = (0.5 * lo + 0.5 * hi, 0.5 * hi - 0.5 * lo);
        // (1 + 2·half)^(p−1): how much the coefficients may exceed the values.
        let growth = |degree: usize| (0..degree).fold(1.0, |product, _| product * (1.0 + 2.0 * half));
        match &self.form {
            Form::Polynomial(slopes) => {
                let mut slopes_about = alloc::vec![[0.0; D]; slopes.len()];
                jet(slopes, &0.0, &1.0, &middle, &mut slopes_about);
                let mut factor = half;
                for (j, slope) in slopes_about.iter_mut().enumerate() {
                    *slope = slope.map(|x| x * factor);
                    factor = factor * half / (j + 1) as f64;
                }
                // 4n for a derivative, 2 for the differences, and 2n + 6 for the sum and its length.
                let degree = slopes.len();
                let rounding = (6 * degree + 8) as f64 * UNIT * self.size * growth(degree) * (2.0 * half);
                Expansion {
                    slopes: slopes_about,
                    weights: Vec::new(),
                    least_weight: 1.0,
                    scale: self.scale,
                    rounding: rounding * self.scale,
                }
            }
            Form::Rational(points, least_weight) => {
                let degree = points.len() - 1;
                let mut about = points.clone();
                jet(points, &0.0, &1.0, &middle, &mut about);
                let mut factor = 1.0;
                for (j, point) in about.iter_mut().enumerate() {
                    *point = Homogeneous { point: point.point.map(|x| x * factor), weight: point.weight * factor };
                    factor = factor * half / (j + 1) as f64;
                }
                // A′w − Aw′: the coefficient of z^k gathers (i − j) Aᵢ wⱼ with i + j = k + 1; the highest cancels.
                let mut slopes = alloc::vec![[0.0; D]; (2 * degree).saturating_sub(1)];
                for (i, a) in about.iter().enumerate() {
                    for (j, w) in about.iter().enumerate().filter(|(j, _)| *j != i) {
                        let factor = (i as f64 - j as f64) * w.weight;
                        for c in 0..D {
                            slopes[i + j - 1][c] += factor * a.point[c];
                        }
                    }
                }
                let rounding = 40.0 * (degree + 2) as f64 * UNIT * self.size * growth(2 * degree) * half;
                let weights = about.iter().map(|point| point.weight).collect();
                Expansion {
                    slopes,
                    weights,
                    least_weight: *least_weight,
                    scale: self.scale,
                    rounding: rounding * self.scale,
                }
            }
        }
    }
}

/// The least power of two above all these sizes; 1 where there is none.
fn power_of_two_above(sizes: impl Iterator<Item = f64>) -> f64 {
    let most = sizes.fold(0.0, |most: f64, size| if size > most { size } else { most });
    if most == 0.0 || !most.is_finite() {
        return 1.0;
    }
    let exponent = libm::frexp(most).1;
    libm::ldexp(1.0, exponent.clamp(-1020, 1020))
}

/// The derivative of a piece about the middle of an interval, −1 ≤ z ≤ 1.
#[derive(Clone, Debug)]
pub(crate) struct Expansion<const D: usize> {
    /// The coefficients of zʲ in the derivative, times w² for a rational piece.
    slopes: Vec<[f64; D]>,
    /// The coefficients of the denominator; none for a polynomial piece.
    weights: Vec<f64>,
    /// A number below the denominator on the whole interval.
    least_weight: f64,
    scale: f64,
    /// What rounding may add to the integral over the interval.
    pub(crate) rounding: f64,
}

impl<const D: usize> Expansion<D> {
    /// |dP/dz|, scaled back.
    pub(crate) fn speed(&self, z: f64) -> f64 {
        let mut sum = [0.0; D];
        for slope in self.slopes.iter().rev() {
            for c in 0..D {
                sum[c] = sum[c] * z + slope[c];
            }
        }
        let w = self.weights.iter().rev().fold(0.0, |w, weight| w * z + weight);
        let speed = norm(&sum) * self.scale;
        if self.weights.is_empty() { speed } else { speed / (w * w) }
    }

    /// The length from a to b, within [−1, 1], by the rule of that number.
    pub(crate) fn integrate(&self, a: f64, b: f64, rule: usize) -> f64 {
        RULES[rule].integrate(a, b, |z| self.speed(z))
    }

    /// The cheapest rule that misses at most `share`, or the best one, with what it misses at most; none where nothing is known.
    pub(crate) fn rule(&self, share: f64) -> Option<(usize, f64)> {
        let squares = self.squares();
        let a0 = *squares.first()?;
        if squares[1..].iter().all(|a| *a == 0.0) && self.weights.len() <= 1 {
            return Some((0, 0.0));
        }
        let mut best = [f64::INFINITY; 4];
        for rho in RHOS {
            let reach = 0.5 * (rho + 1.0 / rho);
            let around = rest(&squares, reach);
            let w0 =
                self.weights.first().copied().unwrap_or(1.0) - self.weights.get(1..).map_or(0.0, |w| rest_of(w, reach));
            // With room for the rounding of these few sums.
            if !(around < 0.999 * a0 && w0 > 0.0) {
                break;
            }
            let most = libm::sqrt(a0 + around) * 1.001 / (w0 * w0) * self.scale;
            for (best, missed) in best.iter_mut().zip(shares_missed(rho)) {
                if most * missed < *best {
                    *best = most * missed;
                }
            }
        }
        let rule = best.iter().position(|missed| *missed <= share).unwrap_or(3);
        best[rule].is_finite().then_some((rule, best[rule]))
    }

    /// Two numbers between which the length lies: the chord, and the sum of what each coefficient can do.
    pub(crate) fn bracket(&self) -> (f64, f64) {
        let share = |j: usize| 2.0 / (j + 1) as f64;
        let above = self.slopes.iter().enumerate().fold(0.0, |sum, (j, slope)| sum + share(j) * norm(slope));
        if self.weights.is_empty() {
            let mut chord = [0.0; D];
            for (j, slope) in self.slopes.iter().enumerate().step_by(2) {
                for c in 0..D {
                    chord[c] += share(j) * slope[c];
                }
            }
            return (norm(&chord) * self.scale, above * self.scale);
        }
        // The chord of a rational piece is not needed: zero is below.
        (0.0, above / (self.least_weight * self.least_weight) * self.scale)
    }

    /// The coefficients of the squared length of the slope.
    fn squares(&self) -> Vec<f64> {
        let count = self.slopes.len();
        let mut squares = alloc::vec![0.0; (2 * count).saturating_sub(1)];
        for (i, a) in self.slopes.iter().enumerate() {
            for (j, b) in self.slopes.iter().enumerate() {
                squares[i + j] += a.iter().zip(b).fold(0.0, |sum, (x, y)| sum + x * y);
            }
        }
        squares
    }
}

/// Σ |aⱼ| Rʲ over j ≥ 1.
fn rest(coefficients: &[f64], reach: f64) -> f64 {
    coefficients.get(1..).map_or(0.0, |rest| rest_of(rest, reach))
}

/// Σ |aⱼ| Rʲ⁺¹ over j ≥ 0.
fn rest_of(coefficients: &[f64], reach: f64) -> f64 {
    coefficients.iter().rev().fold(0.0, |sum, a| (sum + a.abs()) * reach)
}
