//! The weights of a rational piece: their check, their scale, and the pieces that they make.
//!
//! A common factor changes no rational curve, so weights are scaled by powers of two, which changes no digit: where products with points
//! are formed down to 1, where ratios are taken as far up as floats go. Weights in an ordinary range are taken as they are, and those
//! that differ by more than 2⁴⁰⁰ go by ratios alone.

use crate::basis::bernstein::{self, split_in_place};
use crate::basis::rational::{Functions, quotient_rule};
use crate::curve::protocol::RationalPiece;
use crate::error::{Code, Count, Error, Number, Result};
use crate::num::Scalar;
use crate::space::{Homogeneous, Vector, Weighted};
use alloc::borrow::Cow;
use alloc::format;
use alloc::vec::Vec;

/// 2⁻²⁰ and 2²⁰: weights between are taken as they are.
const ORDINARY: core::ops::RangeInclusive<f64> = 1.0 / 1_048_576.0..=1_048_576.0;

/// A denominator below this part of its greatest coefficient cannot be told from zero: 2⁻⁴⁰.
const POLE: f64 = 1.0 / (1u64 << 40) as f64;

/// How often a piece may be halved in the search for a pole.
const DEPTH: usize = 48;

/// How many blends the search may take for a whole curve.
const BLENDS: u64 = 1 << 30;

/// Refuses another number of weights than points (R003), weights that are not finite (R001) or out of scale (R002).
pub(crate) fn check_weights(weights: &[f64], points: usize) -> Result<()> {
    if weights.len() != points {
        return Err(Error::new(
            Code::R003,
            format!("{} for {}", Count(weights.len(), "weight"), Count(points, "point")),
        ));
    }
    for (i, weight) in weights.iter().enumerate() {
        if !weight.is_finite() {
            return Err(Error::new(Code::R001, format!("weight {i} is {weight}")).at(i));
        }
        if weight.abs() > 1e300 {
            return Err(Error::new(Code::R002, format!("weight {i} is {weight:e}")).at(i));
        }
    }
    Ok(())
}

/// Whether all weights are positive and of ordinary size.
pub(crate) fn are_plain(weights: &[f64]) -> bool {
    weights.iter().all(|weight| ORDINARY.contains(weight))
}

/// The search for poles through the pieces of one curve.
pub(crate) struct PoleSearch {
    blends: u64,
}

impl PoleSearch {
    pub(crate) fn new() -> PoleSearch {
        PoleSearch { blends: 0 }
    }

    /// Refuses a denominator that may be zero somewhere in the closed piece (R004). `ends` counts the functions that are not
    /// zero at the start, from the first, and at the end, from the last.
    pub(crate) fn check(
        &mut self,
        functions: &Functions<'_>,
        weights: &[f64],
        (start, end): (f64, f64),
        ends: (usize, usize),
    ) -> Result<()> {
        let pole = |from: f64, to: f64| {
            let (from, to) = (Number(from), Number(to));
            Err(Error::new(Code::R004, format!("the denominator cannot be told from zero in [{from}, {to}]")))
        };
        let positive = |weights: &[f64]| weights.iter().any(|weight| *weight > 0.0);
        if weights.iter().all(|weight| *weight >= 0.0) {
            // Sums of non-negative numbers: zero only where each of them is.
            return match (positive(&weights[..ends.0]), positive(&weights[weights.len() - ends.1..])) {
                (true, true) => Ok(()),
                (false, false) if !positive(weights) => pole(start, end),
                (false, _) => pole(start, start),
                (_, false) => pole(end, end),
            };
        }
        let scaled = scaled_to_one(weights);
        let mut row = functions.bernstein(&scaled.iter().map(|weight| [*weight]).collect::<Vec<_>>());
        if row.first().is_some_and(|first| first[0] < 0.0) {
            row.iter_mut().for_each(|weight| weight[0] = -weight[0]);
        }
        match self.zero(&mut row, (start, end), DEPTH) {
            Some((from, to)) => pole(from, to),
            None => Ok(()),
        }
    }

    /// An interval where the Bernstein polynomial cannot be shown to exceed [`POLE`].
    fn zero(&mut self, row: &mut [[f64; 1]], (start, end): (f64, f64), depth: usize) -> Option<(f64, f64)> {
        let low = |weight: &[f64; 1]| weight[0] <= POLE;
        if !row.iter().any(low) {
            return None;
        }
        if row.first().is_some_and(low) {
            return Some((start, start));
        }
        if row.last().is_some_and(low) {
            return Some((end, end));
        }
        self.blends = self.blends.saturating_add((row.len() * row.len()) as u64);
        let middle = start / 2.0 + end / 2.0;
        if depth == 0 || self.blends > BLENDS || !(start < middle && middle < end) {
            return Some((start, end));
        }
        let mut right = split_in_place(row, (&0.5, &0.5));
        self.zero(row, (start, middle), depth - 1).or_else(|| self.zero(&mut right, (middle, end), depth - 1))
    }
}

/// The exponent of the greatest weight; none where all are zero.
fn exponent(weights: &[f64]) -> Option<i32> {
    let most = weights.iter().fold(0.0, |most: f64, weight| if weight.abs() > most { weight.abs() } else { most });
    (most > 0.0).then(|| libm::frexp(most).1)
}

/// The weights times the power of two that makes the greatest of them 2^`to`, or nearly so.
fn scaled(weights: &[f64], to: i32) -> Vec<f64> {
    let shift = exponent(weights).map_or(0, |exponent| to - exponent);
    weights.iter().map(|weight| libm::ldexp(*weight, shift)).collect()
}

fn scaled_to_one(weights: &[f64]) -> Vec<f64> {
    scaled(weights, 0)
}

/// As far up as sums of a thousand of them allow: 1e300 and 1e-300 stand beside each other.
fn scaled_up(weights: &[f64]) -> Vec<f64> {
    scaled(weights, 1000)
}

/// Whether the smallest weight would be lost beside the greatest once the latter is 1.
fn is_wide(weights: &[f64]) -> bool {
    let least = weights.iter().filter(|weight| **weight > 0.0).fold(f64::INFINITY, |a, b| if *b < a { *b } else { a });
    let lost = |most: i32| libm::frexp(least).1 < most - 400;
    weights.iter().all(|weight| *weight >= 0.0) && least.is_finite() && exponent(weights).is_some_and(lost)
}

/// Value and derivatives of a rational piece at t, whatever the scale of its weights; `plain` if that is known to be ordinary.
pub(crate) fn jet<const D: usize>(
    functions: &Functions<'_>,
    points: &[[f64; D]],
    weights: &[f64],
    (plain, ends): (bool, (f64, f64)),
    t: f64,
    out: &mut [[f64; D]],
) {
    if plain {
        return functions.rational_jet(points, weights, &t, out);
    }
    if is_wide(weights) {
        wide_jet(&functions.bernstein(&weighted(points, &scaled_up(weights))), ends, t, out);
    } else {
        functions.rational_jet(points, &scaled_to_one(weights), &t, out);
    }
}

/// Value and derivatives where weights differ by more than products can hold: the longer part of the piece beside t, cut off by
/// ratios of weights, starts in the value, and has its k-th derivative there from its first k + 1 points and weights alone.
fn wide_jet<const D: usize>(piece: &[Weighted<D>], (start, end): (f64, f64), t: f64, out: &mut [[f64; D]]) {
    let Some((value, derivatives)) = out.split_first_mut() else { return };
    let (complement, u) = bernstein::weights(&start, &end, &t);
    let mut left = piece.to_vec();
    let right = split_in_place(&mut left, (&complement, &u));
    let (near, length) = if u < 0.5 {
        (right, end - t)
    } else {
        left.reverse();
        (left, start - t)
    };
    let degree = near.len().saturating_sub(1);
    let Some(first) = near.first().copied() else { return };
    *value = first.point;
    // Relative to the first weight and point; what is too heavy to be held makes its own derivatives infinite, and no others.
    let mut row: Vec<Homogeneous<D>> = near
        .iter()
        .take(derivatives.len() + 1)
        .map(|item| {
            let weight = item.weight / first.weight;
            Homogeneous { point: core::array::from_fn(|c| weight * (item.point[c] - first.point[c])), weight }
        })
        .collect();
    let mut jet = alloc::vec![Homogeneous::zero(); derivatives.len() + 1];
    let mut factor = 1.0;
    for k in 0..jet.len().min(degree + 1) {
        if k > 0 {
            factor = factor * (degree + 1 - k) as f64 / length;
            for i in 0..row.len() - k {
                let before = row[i];
                row[i] = row[i + 1];
                row[i].add_scaled(&-1.0, &before);
            }
        }
        jet[k] = row[0];
        jet[k].scale(&factor);
    }
    quotient_rule(&jet, derivatives);
}

/// Points and weights side by side.
pub(crate) fn weighted<const D: usize, S: Scalar>(points: &[[S; D]], weights: &[S]) -> Vec<Weighted<D, S>> {
    let pairs = points.iter().zip(weights);
    pairs.map(|(point, weight)| Weighted { point: point.clone(), weight: weight.clone() }).collect()
}

/// Points and weights as homogeneous points; scaled by a power of two where weights are out of the ordinary, so that the
/// products stay finite.
pub(crate) fn homogeneous<const D: usize>(points: &[[f64; D]], weights: &[f64]) -> Vec<Homogeneous<D>> {
    let weights = if are_plain(weights) { Cow::Borrowed(weights) } else { Cow::Owned(scaled_to_one(weights)) };
    weighted(points, &weights).into_iter().map(Homogeneous::from).collect()
}

/// Homogeneous points as Cartesian ones with their weights.
///
/// # Errors
/// R005 with the index of a point of weight zero that is not zero itself.
pub(crate) fn cartesian<const D: usize>(points: &[Homogeneous<D>]) -> Result<(Vec<[f64; D]>, Vec<f64>)> {
    let mut out = (Vec::with_capacity(points.len()), Vec::with_capacity(points.len()));
    for (i, point) in points.iter().enumerate() {
        let place = match point.cartesian() {
            Some(place) => place,
            None if point.point == [0.0; D] => [0.0; D],
            None => {
                let message = format!("control point {i} has weight zero and the direction {:?}", point.point);
                return Err(Error::new(Code::R005, message).at(i));
            }
        };
        out.0.push(place);
        out.1.push(point.weight);
    }
    Ok(out)
}

/// Hands out one piece; halved until no weight is negative, where some are.
pub(crate) fn visit_piece<const D: usize>(
    functions: &Functions<'_>,
    points: &[[f64; D]],
    weights: &[f64],
    (start, end): (f64, f64),
    visit: &mut dyn FnMut(RationalPiece<'_, D>),
) {
    if weights.iter().all(|weight| *weight >= 0.0) {
        let weights = if are_plain(weights) { Cow::Borrowed(weights) } else { Cow::Owned(scaled_up(weights)) };
        let points = functions.bernstein(&weighted(points, &weights));
        return visit(RationalPiece { start, end, points: &points });
    }
    let mut row = functions.bernstein(&homogeneous(points, weights));
    if row.first().is_some_and(|first| first.weight < 0.0) {
        row.iter_mut().for_each(|point| point.scale(&-1.0));
    }
    halve(row, (start, end), DEPTH, visit);
}

fn halve<const D: usize>(
    mut row: Vec<Homogeneous<D>>,
    (start, end): (f64, f64),
    depth: usize,
    visit: &mut dyn FnMut(RationalPiece<'_, D>),
) {
    let middle = start / 2.0 + end / 2.0;
    if row.iter().any(|point| point.weight <= 0.0) && depth > 0 && start < middle && middle < end {
        let right = split_in_place(&mut row, (&0.5, &0.5));
        halve(row, (start, middle), depth - 1, visit);
        return halve(right, (middle, end), depth - 1, visit);
    }
    let place =
        |point: &Homogeneous<D>| Weighted { point: point.cartesian().unwrap_or(point.point), weight: point.weight };
    let points: Vec<Weighted<D>> = row.iter().map(place).collect();
    visit(RationalPiece { start, end, points: &points });
}
