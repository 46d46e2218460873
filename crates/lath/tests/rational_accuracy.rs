//! How wrong rational curves are: E = |computed − exact| / (u · condition), swept over degrees 0 to 8, knots and weights that
//! look for trouble, against the recursion and the quotient rule on fractions. Promised: E ≤ 3(p + 1) for values, E ≤ 10p for first
//! derivatives.
#![allow(clippy::unwrap_used)] // helpers of tests stop at the first fault, loudly

use lath::curve::{Bezier, Curve, Interval, Nurbs};
use lath::knot::{Knots, Side};
use lath::num::Scalar;
use proptest::collection::vec;
use proptest::prelude::*;
use std::cell::Cell;
use testkit::conformance::{Law, run};
use testkit::error_measure::units;
use testkit::rational::Rational;
use testkit::{generators, naive};

fn exactly(floats: &[f64]) -> Vec<Rational> {
    floats.iter().map(|x| Rational::from_f64(*x)).collect()
}

/// Σ aᵢ bᵢ.
fn sum(a: &[Rational], b: &[Rational]) -> Rational {
    a.iter().zip(b).map(|(a, b)| a.clone() * b.clone()).sum()
}

/// What a sweep promises of the first derivatives.
#[derive(Clone, Copy, PartialEq)]
enum Slopes {
    /// They keep 10p.
    Promised,
    /// They are not looked at.
    Free,
}

/// One span of a curve of one dimension, on fractions: its 2p + 2 knots, p + 1 points and p + 1 weights.
struct Piece {
    degree: usize,
    knots: Vec<Rational>,
    points: Vec<Rational>,
    weights: Vec<Rational>,
    /// How much a derivative enlarges what underflows.
    amplified: Rational,
}

impl Piece {
    /// Value and first derivative at t, each with its condition.
    ///
    /// The condition of the value C is K = Σ |wᵢ|(|Pᵢ| + |C|)Nᵢ / |W|. That of the derivative has the size of N′ᵢ, p/(t_{i+p} − tᵢ) N_{i,p−1} +
    /// p/(t_{i+p+1} − t_{i+1}) N_{i+1,p−1}, in place of Nᵢ, and K in place of |C|: what C is off moves the derivative by that times W′/W. What
    /// underflows is off by a fixed amount, however small the sum it belongs to.
    fn exact(&self, t: f64, side: Side) -> [(Rational, Rational); 2] {
        let (p, knots, t) = (self.degree, &self.knots, Rational::from_f64(t));
        let values = naive::bspline_row(knots, p, 0, &t, side);
        let slopes = naive::bspline_row(knots, p, 1, &t, side);
        let mut sizes = vec![Rational::zero(); p + 1];
        let lower = if p > 0 { naive::bspline_row(knots, p - 1, 0, &t, side) } else { Vec::new() };
        for (i, value) in lower.into_iter().enumerate().filter(|(_, value)| *value > 0) {
            let share = Rational::from(p as i64) * value / (knots[i + p].clone() - knots[i].clone());
            sizes[i - 1] += share.clone();
            sizes[i] += share;
        }
        let pairs = || self.points.iter().zip(&self.weights);
        let products: Vec<Rational> = pairs().map(|(point, weight)| point.clone() * weight.clone()).collect();
        let numerator = [sum(&products, &values), sum(&products, &slopes)];
        let denominator = [sum(&self.weights, &values), sum(&self.weights, &slopes)];
        let exact = naive::quotient(&numerator, &denominator);
        let size = exact[0].abs();
        let about = |size: &Rational| -> Vec<Rational> {
            pairs().map(|(point, weight)| weight.abs() * (point.abs() + size.clone())).collect()
        };
        let most = self.weights.iter().map(Rational::abs).fold(Rational::one(), |a, b| if a < b { b } else { a });
        let least = most * self.points.iter().map(|point| point.abs() + size.clone()).sum::<Rational>();
        let least = least * Rational::from_f64(f64::MIN_POSITIVE);
        let over = |condition: Rational| condition / denominator[0].abs();
        let value = over(sum(&about(&size), &values) + least.clone());
        let slope = over(sum(&about(&value), &sizes) + least * self.amplified.clone());
        [(exact[0].clone(), value), (exact[1].clone(), slope)]
    }
}

/// Ends, neighbours of the ends and places inside, each from the side of the span.
fn places(start: f64, end: f64) -> impl Iterator<Item = (f64, Side)> {
    let inside = [start, start.next_up(), start + (end - start) * 0.3, end.next_down(), end];
    let side = move |t: f64| if t == end { Side::Left } else { Side::Right };
    inside.into_iter().filter(move |t| start <= *t && *t <= end).map(move |t| (t, side(t)))
}

/// Holds a curve against its knots, control points and weights.
fn measure(
    curve: &dyn Curve<1>,
    (knots, points, weights): (&[f64], &[f64], &[f64]),
    promised: Slopes,
    worst: &[Cell<f64>; 2],
) -> Law {
    let p = curve.degree();
    let breaks = curve.breaks();
    // At most two spans of a curve: exactness takes its time, and other draws have other spans.
    for pair in breaks.windows(2).step_by(breaks.len() / 2 + 1) {
        let amplified = 2.0 * p as f64 / (pair[1] - pair[0]);
        let span = knots.iter().rposition(|knot| *knot <= pair[0]).unwrap();
        let piece = Piece {
            degree: p,
            knots: exactly(&knots[span - p..span + p + 2]),
            points: exactly(&points[span - p..=span]),
            weights: exactly(&weights[span - p..=span]),
            amplified: Rational::from_f64(amplified.min(1e300)),
        };
        // Floats hold no slope over a span of a few subnormals.
        let orders = if amplified < 1e250 && promised == Slopes::Promised { 2 } else { 1 };
        for (t, side) in places(pair[0], pair[1]) {
            let mut out = [[0.0]; 2];
            curve.jet_into(t, side, &mut out[..orders]);
            for (k, (exact, condition)) in piece.exact(t, side).into_iter().enumerate().take(orders) {
                let off = units(out[k][0], &exact, &condition);
                let allowed = if k == 0 { 3.0 * (p + 1) as f64 } else { 10.0 * p as f64 };
                prop_assert!(off <= allowed, "degree {p}, derivative {k} at {t:e} is {off} u off");
                worst[k].set(worst[k].get().max(off));
            }
        }
    }
    Ok(())
}

/// 10ˣ.
fn power_of_ten(exponents: std::ops::Range<f64>) -> impl Strategy<Value = f64> {
    exponents.prop_map(|x| libm::pow(10.0, x))
}

/// Weights that are equal, random, spread over 24 decades, equal but for one light or heavy, or positive but for one.
fn weights(n: usize) -> impl Strategy<Value = Vec<f64>> {
    let but_one = |i: usize, other: f64| {
        move |mut weights: Vec<f64>| {
            weights[i] *= other;
            weights
        }
    };
    let one = (0..n, prop_oneof![power_of_ten(-12.0..-1.0), power_of_ten(1.0..12.0)]);
    let negative = (0..n, -0.5..-0.01, vec(0.125..8.0, n));
    prop_oneof![
        power_of_ten(-3.0..3.0).prop_map(move |weight| vec![weight; n]),
        vec(0.125..8.0, n),
        vec(power_of_ten(-12.0..12.0), n),
        one.prop_map(move |(i, other)| but_one(i, other)(vec![1.0; n])),
        negative.prop_map(move |(i, other, weights)| but_one(i, other)(weights)),
    ]
}

/// Points of ordinary size, one that is not zero, or all far from zero.
fn points(n: usize) -> impl Strategy<Value = Vec<f64>> {
    let alone = (0..n, 0.5..2.0).prop_map(move |(i, x)| (0..n).map(|j| if i == j { x } else { 0.0 }).collect());
    prop_oneof![
        3 => generators::points::<1>(n).prop_map(|points| points.concat()),
        2 => alone,
        1 => vec(1e6..1e6 + 1.0, n),
    ]
}

fn flat(points: &[f64]) -> Vec<[f64; 1]> {
    points.iter().map(|x| [*x]).collect()
}

/// Sweeps over curves with such knots. Weights whose denominator is refused are no curve.
fn sweep(knots: impl Strategy<Value = Knots>) {
    let worst = [Cell::new(0.0_f64), Cell::new(0.0)];
    let drawn = knots.prop_flat_map(|knots| (points(knots.functions()), weights(knots.functions()), Just(knots)));
    run(drawn, |(points, weights, knots)| match Nurbs::new(knots.clone(), flat(&points), weights.clone()) {
        Ok(curve) => measure(&curve, (knots.values(), &points, &weights), Slopes::Promised, &worst),
        Err(error) => {
            prop_assert!(weights.iter().any(|weight| *weight < 0.0), "{error}");
            Ok(())
        }
    });
    assert!(worst.iter().all(|worst| worst.get() > 1.0), "a sweep that finds no error measures nothing: {worst:?}");
}

#[test]
fn uniform_knots() {
    sweep((0usize..=8, 1usize..5).prop_map(|(p, spans)| Knots::uniform(p + spans, p).unwrap()));
}

#[test]
fn wild_knots() {
    sweep((0usize..=8).prop_flat_map(generators::knots));
}

#[test]
fn multiple_knots() {
    sweep((0usize..=8).prop_flat_map(generators::mild_knots));
}

#[test]
fn bezier_curves() {
    let worst = [Cell::new(0.0_f64), Cell::new(0.0)];
    let drawn = (1usize..=9).prop_flat_map(|n| (points(n), weights(n), generators::parameters(2)));
    run(drawn, |(points, weights, ends)| {
        let knots = [vec![ends[0]; points.len()], vec![ends[1]; points.len()]].concat();
        let bezier = Bezier::on(flat(&points), Interval { start: ends[0], end: ends[1] }).unwrap();
        bezier
            .weighted(weights.clone())
            .map_or(Ok(()), |curve| measure(&curve, (&knots, &points, &weights), Slopes::Promised, &worst))
    });
    assert!(worst.iter().all(|worst| worst.get() > 1.0), "{worst:?}");
}

/// The worst that is known: weights that give every point the same share at t, and the point about which the sum is taken
/// far greater than the sum.
#[test]
fn shares_of_one_size_keep_the_bound() {
    let worst = [Cell::new(0.0_f64), Cell::new(0.0)];
    let drawn = (1usize..=8).prop_flat_map(|p| {
        (-1.0..0.0, 1.0..2.0, 0.0..1.0, 0..=p, 1.0..1.1, prop_oneof![Just(0.0), Just(1.0)])
            .prop_map(move |drawn| (p, drawn))
    });
    run(drawn, |(p, (a, b, u, most, heavier, cancelled))| {
        let t: f64 = a + (b - a) * u;
        let knots = [vec![a; p + 1], vec![b; p + 1]].concat();
        let row = naive::bspline_row(&exactly(&knots), p, 0, &Rational::from_f64(t), Side::Right);
        let mut weights: Vec<f64> = row.iter().map(|value| 1.0 / value.to_f64()).collect();
        prop_assume!(weights.iter().all(|weight| weight.is_finite()));
        weights[most] *= heavier;
        let mut points = vec![-cancelled * heavier / p as f64; p + 1];
        points[most] = heavier;
        let curve =
            Bezier::on(flat(&points), Interval { start: a, end: b }).unwrap().weighted(weights.clone()).unwrap();
        let piece = Piece {
            degree: p,
            knots: exactly(&knots),
            points: exactly(&points),
            weights: exactly(&weights),
            amplified: Rational::one(),
        };
        let mut out = [[0.0]; 2];
        curve.jet_into(t, Side::Right, &mut out);
        for (k, (exact, condition)) in piece.exact(t, Side::Right).into_iter().enumerate() {
            let off = units(out[k][0], &exact, &condition);
            let allowed = if k == 0 { 3.0 * (p + 1) as f64 } else { 10.0 * p as f64 };
            prop_assert!(off <= allowed, "degree {p}, derivative {k} at {t:e} is {off} u off");
            worst[k].set(worst[k].get().max(off));
        }
        Ok(())
    });
    assert!(worst.iter().all(|worst| worst.get() > 3.0), "{worst:?}");
}

/// Weights over 500 decades go by their ratios on the Bézier points of a span: values keep the bound; slopes do not, where the span
/// is short beside its neighbours.
#[test]
fn weights_of_every_size() {
    let worst = [Cell::new(0.0_f64), Cell::new(0.0)];
    let drawn = (1usize..=8).prop_flat_map(generators::knots).prop_flat_map(|knots| {
        (points(knots.functions()), vec(power_of_ten(-250.0..250.0), knots.functions()), Just(knots))
    });
    run(drawn, |(points, weights, knots)| {
        let curve = Nurbs::new(knots.clone(), flat(&points), weights.clone()).unwrap();
        measure(&curve, (knots.values(), &points, &weights), Slopes::Free, &worst)
    });
    assert!(worst[0].get() > 1.0, "{worst:?}");
}
