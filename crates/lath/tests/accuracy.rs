//! How wrong evaluation is: E = |computed − exact| / (u · condition), swept over degrees, knots and places that look for
//! trouble, against the recursion on fractions. Promised everywhere inside the domain: E ≤ 3(p + 1) for values, E ≤ 10p for
//! derivatives.
#![allow(clippy::unwrap_used)] // a failing unwrap is a failing test

use lath::curve::{BSpline, Bezier, Curve, Hermite, Interval};
use lath::knot::{Knots, Side};
use lath::num::Scalar;
use proptest::prelude::*;
use std::cell::Cell;
use testkit::conformance::{Law, run};
use testkit::error_measure::{condition, units};
use testkit::rational::Rational;
use testkit::{generators, naive};

fn exactly(floats: &[f64]) -> Vec<Rational> {
    floats.iter().map(|x| Rational::from_f64(*x)).collect()
}

/// Ends, neighbours of the ends and a place inside of a span, each from the side of the span.
fn places(start: f64, end: f64) -> impl Iterator<Item = (f64, Side)> {
    let inside = [start, start.next_up(), start + (end - start) * 0.3, end.next_down(), end];
    let side = move |t: f64| if t == end { Side::Left } else { Side::Right };
    inside.into_iter().filter(move |t| start <= *t && *t <= end).map(move |t| (t, side(t)))
}

/// Whether floats hold a k-th derivative of degree p over a span of this length.
fn held(p: usize, length: f64, k: usize) -> bool {
    (0..k).fold(1.0, |factor, _| factor * 2.0 * p as f64 / length) < 1e300
}

/// Holds a curve of one dimension against its knots and control points.
fn measure(curve: &dyn Curve<1>, knots: &[f64], b: &[f64], worst: &Cell<f64>) -> Law {
    let (knots, b, p) = (exactly(knots), exactly(b), curve.degree());
    // A weight that underflows is off by a fixed amount, however small the sum it belongs to.
    let least = b.iter().map(Rational::abs).sum::<Rational>() * Rational::from_f64(f64::MIN_POSITIVE);
    let breaks = curve.breaks();
    // At most four spans of a curve: exactness takes its time, and other draws have other spans.
    for pair in breaks.windows(2).step_by(breaks.len() / 4 + 1) {
        let amplified = Rational::from_f64(2.0 * p as f64) / Rational::from_f64(pair[1] - pair[0]);
        for (t, side) in places(pair[0], pair[1]) {
            let order = (0..=p.min(2)).rev().find(|&k| held(p, pair[1] - pair[0], k)).unwrap_or(0);
            let mut out = vec![[0.0]; order + 1];
            curve.jet_into(t, side, &mut out);
            let at = Rational::from_f64(t);
            for (k, [found]) in out.into_iter().enumerate() {
                let exact = naive::spline(&knots, p, &b, k, &at, side);
                let condition = condition(&knots, p, &b, k, &at, side) + least.clone() * amplified.power(k);
                let off = units(found, &exact, &condition);
                let allowed = if k == 0 { 3.0 * (p + 1) as f64 } else { 10.0 * p as f64 };
                prop_assert!(off <= allowed, "degree {p}, derivative {k} at {t:e} is {off} u off");
                worst.set(worst.get().max(off));
            }
        }
    }
    Ok(())
}

fn flat(points: &[[f64; 1]]) -> Vec<f64> {
    points.iter().map(|[x]| *x).collect()
}

#[test]
fn bsplines_keep_their_accuracy_over_adversarial_knots() {
    let worst = Cell::new(0.0_f64);
    let drawn = (0usize..=10).prop_flat_map(generators::knots);
    let drawn = drawn.prop_flat_map(|knots| (generators::points::<1>(knots.functions()), Just(knots)));
    run(drawn, |(points, knots): (_, Knots)| {
        measure(&BSpline::new(knots.clone(), &points).unwrap(), knots.values(), &flat(&points), &worst)
    });
    assert!(worst.get() > 1.0, "a sweep that finds no error measures nothing: {}", worst.get());
}

#[test]
fn high_degrees_keep_their_accuracy() {
    let worst = Cell::new(0.0_f64);
    for degree in [15, 20, 30] {
        let points: Vec<[f64; 1]> = (0..degree + 4).map(|i| [f64::from((i * 7 % 11) as i32 - 5) / 3.0]).collect();
        let inner = [0.0, 0.1, 0.1, 0.7, 1.0];
        let ends = |t: f64| std::iter::repeat_n(t, degree);
        let values: Vec<f64> = ends(inner[0]).chain(inner).chain(ends(inner[4])).collect();
        let knots = Knots::new(values, degree).unwrap();
        let curve = BSpline::new(knots.clone(), &points).unwrap();
        measure(&curve, knots.values(), &flat(&points), &worst).unwrap();
    }
    assert!(worst.get() > 1.0);
}

/// Where the roundings of (t − a)/(b − a) all point the same way and the last control point stands alone, every level of
/// the triangle repeats the error of the weight: found by climbing, E was 38.8 at degree 10 with the plain formula.
#[test]
fn aligned_roundings_keep_the_bound() {
    let worst = Cell::new(0.0_f64);
    for (degree, a, b, t, last) in [
        (5, -0.0057319108927635955, 0.9943820732681828, 0.02552255855943375, 1.0068054138444793),
        (7, -0.005731910892770923, 0.9943820732681928, 0.025522558559427422, 1.0068638843457747),
        (10, -0.005731910892772581, 0.9943820732681787, 0.025522558559424147, 1.0068407100792516),
    ] {
        let mut b_ = vec![0.0; degree];
        b_.push(last);
        let points: Vec<[f64; 1]> = b_.iter().map(|x| [*x]).collect();
        let values = [vec![a; degree + 1], vec![b; degree + 1]].concat();
        let (knots, control) = (exactly(&values), exactly(&b_));
        let at = Rational::from_f64(t);
        let exact = naive::spline(&knots, degree, &control, 0, &at, Side::Right);
        let condition = condition(&knots, degree, &control, 0, &at, Side::Right);
        let spline = BSpline::new(Knots::new(values, degree).unwrap(), &points).unwrap();
        let bezier = Bezier::on(&points, Interval { start: a, end: b }).unwrap();
        for curve in [&spline as &dyn Curve<1>, &bezier] {
            let off = units(curve.eval(t).unwrap()[0], &exact, &condition);
            assert!(off <= 3.0 * degree as f64, "degree {degree} is {off} u off");
            worst.set(worst.get().max(off));
        }
    }
    assert!(worst.get() > 1.0);
}

#[test]
fn weights_are_off_by_hardly_more_than_one_rounding() {
    let worst = Cell::new(0.0_f64);
    let check = |(a, b, t): (f64, f64, f64)| {
        let ends = exactly(&[a, b, t]);
        let length = ends[1].clone() - ends[0].clone();
        let (complement, weight) = f64::weights(&a, &b, &t);
        let shares = [(complement, ends[1].clone() - ends[2].clone()), (weight, ends[2].clone() - ends[0].clone())];
        for (found, part) in shares {
            let exact = part / length.clone();
            let off = units(found, &exact, &exact);
            // A weight that underflows is off by a fixed amount.
            let allowed = if found < f64::MIN_POSITIVE { 2.0 } else { 1.0 + 1e-6 };
            prop_assert!(off <= allowed, "{found:e} for {t:e} in [{a:e}, {b:e}] is {off} u off");
            worst.set(worst.get().max(off));
        }
        Ok(())
    };
    let drawn = (generators::parameters(2), prop_oneof![Just(1.0), Just(-1.0), Just(1e290), Just(-1e-280)]);
    run(drawn, |(ends, scale): (Vec<f64>, f64)| {
        let (a, b) = (ends[0] * scale, ends[1] * scale);
        let (a, b) = if a <= b { (a, b) } else { (b, a) };
        // Ends a few subnormals apart have no room inside, and their weights underflow.
        prop_assume!(b - a > f64::MIN_POSITIVE);
        for (t, _) in places(a, b) {
            check((a, b, t))?;
        }
        Ok(())
    });
    for t in [-0.3, -1e-9, 1e-9, 0.4, 0.7] {
        check((-0.7, 1.1, t)).unwrap();
    }
    assert!(worst.get() > 0.9, "only {}", worst.get());
}

#[test]
fn bezier_curves_keep_their_accuracy_over_any_domain() {
    let worst = Cell::new(0.0_f64);
    let drawn = (1usize..14).prop_flat_map(|n| (generators::points::<1>(n), generators::parameters(2)));
    run(drawn, |(points, ends)| {
        let curve = Bezier::on(&points, Interval { start: ends[0], end: ends[1] }).unwrap();
        // Bernstein polynomials are B-splines over the ends alone.
        let knots = [vec![ends[0]; points.len()], vec![ends[1]; points.len()]].concat();
        measure(&curve, &knots, &flat(&points), &worst)
    });
    assert!(worst.get() > 1.0);
}

#[test]
fn hermite_curves_keep_their_accuracy() {
    let worst = Cell::new(0.0_f64);
    let drawn = (2usize..7)
        .prop_flat_map(|n| (generators::points::<1>(n), generators::points::<1>(n), generators::parameters(n)));
    run(drawn, |(points, tangents, parameters)| {
        let curve = Hermite::new(parameters.clone(), &points, &tangents).unwrap();
        let (p, m, t) = (exactly(&flat(&points)), exactly(&flat(&tangents)), exactly(&parameters));
        for i in 0..points.len() - 1 {
            let h = t[i + 1].clone() - t[i].clone();
            let third = |m: &Rational| m.clone() * h.clone() / Rational::from(3);
            let (before, after) = (third(&m[i]), third(&m[i + 1]));
            let b = [p[i].clone(), p[i].clone() + before.clone(), p[i + 1].clone() - after.clone(), p[i + 1].clone()];
            let sizes = [p[i].abs(), p[i].abs() + before.abs(), p[i + 1].abs() + after.abs(), p[i + 1].abs()];
            for (at, side) in places(parameters[i], parameters[i + 1]) {
                let mut out = [[0.0]];
                curve.jet_into(at, side, &mut out);
                let ends = (&t[i], &t[i + 1]);
                let at = Rational::from_f64(at);
                let off = units(out[0][0], &naive::bezier(&b, ends, 0, &at), &naive::bezier(&sizes, ends, 0, &at));
                prop_assert!(off <= 12.0, "segment {i} at {at:?} is {off} u off");
                worst.set(worst.get().max(off));
            }
        }
        Ok(())
    });
    assert!(worst.get() > 1.0);
}

#[test]
fn extrapolation_far_outside_is_what_it_costs_and_no_nan() {
    let curve = Bezier::new([[1.0], [2.0], [-1.0], [4.0]]).unwrap();
    for t in [-1e3, -1.0, 2.0, 1e3] {
        let exact = naive::bezier(
            &exactly(&[1.0, 2.0, -1.0, 4.0]),
            (&Rational::zero(), &Rational::one()),
            0,
            &Rational::from_f64(t),
        );
        let mut out = [[0.0]];
        curve.jet_into(t, Side::Right, &mut out);
        // Outside the weights alternate in sign: their sizes are the condition.
        let sizes: Rational =
            (0..=3).map(|i| naive::bernstein(3, i, &Rational::from_f64(t)).abs() * Rational::from(4)).sum();
        assert!(units(out[0][0], &exact, &sizes) <= 12.0, "at {t}: {} not {exact}", out[0][0]);
    }
}
