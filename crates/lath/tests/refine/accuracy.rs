//! On floats: E = |computed − exact| / (u · condition) of every control point, where the exact one comes from the same verb on fractions
//! and the condition from the verb on the points' sizes: all these verbs add up non-negative shares. Promised: E ≤ 8 to degree 5, and
//! E ≤ 12 to degree 7.

use crate::splines::Exact;
use lath::knot::Knots;
use lath::num::Scalar;
use lath::refine::Spline;
use proptest::prelude::*;
use std::cell::Cell;
use testkit::conformance::{Law, run};
use testkit::error_measure::units;
use testkit::generators;
use testkit::rational::Rational;

type Floats = Spline<[f64; 1]>;

/// The promise.
fn most(degree: usize) -> f64 {
    if degree <= 5 { 8.0 } else { 12.0 }
}

/// What is added to every condition: a weight that underflows is off by a fixed amount, however small the sum it belongs to.
fn least(spline: &Floats) -> Rational {
    let sum: Rational = spline.points().iter().map(|[x]| Rational::from_f64(x.abs() + 1.0)).sum();
    sum * Rational::from_f64(4.0 * f64::MIN_POSITIVE)
}

fn exactly(floats: &[f64]) -> Vec<Rational> {
    floats.iter().map(|x| Rational::from_f64(*x)).collect()
}

/// The spline over fractions, and the one of its points' sizes.
fn exact(spline: &Floats) -> (Exact, Exact) {
    let points: Vec<[Rational; 1]> = spline.points().iter().map(|[x]| [Rational::from_f64(*x)]).collect();
    let sizes = points.iter().map(|[x]| [x.abs()]).collect();
    let own = exactly(spline.own_knots());
    if spline.is_closed() {
        let closed = |points| Spline::closed(&own, spline.degree(), points).unwrap();
        return (closed(points), closed(sizes));
    }
    let open = |points| Spline::open(Knots::new(own.clone(), spline.degree()).unwrap(), points).unwrap();
    (open(points), open(sizes))
}

/// Holds every control point against the exact one and its condition.
fn compare(what: &str, found: &Floats, exact: &Exact, sizes: &Exact, worst: &Cell<f64>) -> Law {
    prop_assert_eq!(found.points().len(), exact.points().len(), "{}", what);
    for (i, [x]) in found.points().iter().enumerate() {
        let off = units(*x, &exact.points()[i][0], &(sizes.points()[i][0].clone() + least(found)));
        prop_assert!(off <= most(found.degree()), "{what}: point {i} is {off} u off: {found:?}");
        worst.set(worst.get().max(off));
    }
    Ok(())
}

/// Open splines over adversarial knots, and places in their domains.
fn drawn() -> impl Strategy<Value = (Floats, Vec<f64>)> {
    let knots = (0usize..=7).prop_flat_map(generators::knots);
    let spline = knots.prop_flat_map(|knots| {
        let points = generators::points::<1>(knots.functions());
        (points, Just(knots)).prop_map(|(points, knots)| Spline::open(knots, points).unwrap())
    });
    (spline, proptest::collection::vec(0.0..1.0, 1..8)).prop_map(|(spline, shares)| {
        let (a, b) = spline.knots().domain();
        let places = shares.into_iter().map(|share: f64| (a + (b - a) * share).clamp(a, b)).collect();
        (spline, places)
    })
}

#[test]
fn insertion_keeps_its_accuracy_however_many_knots_come_at_once() {
    let worst = Cell::new(0.0_f64);
    run(drawn(), |(spline, at)| {
        let Ok(found) = spline.insert(&at) else { return Ok(()) };
        let ((exact, sizes), at) = (exact(&spline), exactly(&at));
        compare("insertion", &found, &exact.insert(&at).unwrap(), &sizes.insert(&at).unwrap(), &worst)
    });
    assert!(worst.get() > 1.0, "a sweep that finds no error measures nothing: {}", worst.get());
}

#[test]
fn elevation_keeps_its_accuracy() {
    let worst = Cell::new(0.0_f64);
    run(drawn(), |(spline, _)| {
        let (exact, sizes) = exact(&spline);
        let found = spline.elevate(1).unwrap();
        compare("elevation", &found, &exact.elevate(1).unwrap(), &sizes.elevate(1).unwrap(), &worst)
    });
    assert!(worst.get() > 1.0, "{}", worst.get());
}

#[test]
fn cutting_keeps_its_accuracy() {
    let worst = Cell::new(0.0_f64);
    run(drawn(), |(spline, at)| {
        let (exact, sizes) = exact(&spline);
        let ends = |a: f64, b: f64| if a < b { Some((a, b)) } else { None };
        if let Some((a, b)) = ends(at[0], at[at.len() - 1]) {
            let found = spline.trim(&a, &b).unwrap();
            let (a, b) = (Rational::from_f64(a), Rational::from_f64(b));
            compare("part", &found, &exact.trim(&a, &b).unwrap(), &sizes.trim(&a, &b).unwrap(), &worst)?;
        }
        if let Ok((left, right)) = spline.split(&at[0]) {
            let t = Rational::from_f64(at[0]);
            let (exact, sizes) = (exact.split(&t).unwrap(), sizes.split(&t).unwrap());
            compare("left part", &left, &exact.0, &sizes.0, &worst)?;
            compare("right part", &right, &exact.1, &sizes.1, &worst)?;
            let jumps = spline.knots().multiplicity(&at[0]) > spline.degree();
            prop_assert!(jumps || left.points().last() == right.points().first());
        }
        Ok(())
    });
    assert!(worst.get() > 1.0, "{}", worst.get());
}

#[test]
fn pieces_keep_their_accuracy() {
    let worst = Cell::new(0.0_f64);
    run(drawn(), |(spline, _)| {
        let (exact, sizes) = exact(&spline);
        for ((found, exact), sizes) in
            spline.pieces().unwrap().iter().zip(exact.pieces().unwrap()).zip(sizes.pieces().unwrap())
        {
            for (k, [x]) in found.points.iter().enumerate() {
                let off = units(*x, &exact.points[k][0], &(sizes.points[k][0].clone() + least(&spline)));
                prop_assert!(off <= most(spline.degree()), "point {k} of a piece is {off} u off: {spline:?}");
                worst.set(worst.get().max(off));
            }
        }
        Ok(())
    });
    assert!(worst.get() > 1.0, "{}", worst.get());
}

#[test]
fn integrals_keep_their_accuracy_over_intervals_of_any_length() {
    let worst = Cell::new(0.0_f64);
    run(drawn(), |(spline, at)| {
        let ((exact, sizes), (a, b)) = (exact(&spline), (at[0], at[at.len() - 1]));
        let [found] = spline.integral(&a, &b).unwrap();
        let (a, b) = (Rational::from_f64(a), Rational::from_f64(b));
        let [exact] = exact.integral(&a, &b).unwrap();
        let [size] = sizes.integral(&a, &b).unwrap();
        let off = units(found, &exact, &(size.abs() + least(&spline)));
        prop_assert!(off <= most(spline.degree()), "the integral is {off} u off: {spline:?}");
        worst.set(worst.get().max(off));
        Ok(())
    });
    assert!(worst.get() > 1.0, "{}", worst.get());
}

#[test]
fn derivatives_and_antiderivatives_keep_their_accuracy() {
    let worst = Cell::new(0.0_f64);
    run(drawn(), |(spline, _)| {
        let (exact, sizes) = exact(&spline);
        let found = spline.antiderivative().unwrap();
        compare("antiderivative", &found, &exact.antiderivative().unwrap(), &sizes.antiderivative().unwrap(), &worst)?;
        // Neighbours have opposite signs in a difference: the sizes alternate, so that it becomes a sum.
        let alternate = sizes.points().iter().enumerate();
        let points = alternate.map(|(i, [x])| [if i % 2 == 0 { x.clone() } else { -x.clone() }]).collect();
        let sums = Spline::open(exact.knots().clone(), points).unwrap().derivative().unwrap();
        let points = sums.points().iter().map(|[x]| [x.abs()]).collect();
        let sums = Spline::open(sums.knots().clone(), points).unwrap();
        let found = spline.derivative().unwrap();
        if found.points().iter().any(|[x]| !x.is_finite()) {
            // Only spans of a few subnormal steps are too short for a derivative.
            let spans = spline.knots().breaks();
            prop_assert!(spans.windows(2).any(|pair| pair[1] - pair[0] < 1e-300), "{spline:?}");
            return Ok(());
        }
        compare("derivative", &found, &exact.derivative().unwrap(), &sums, &worst)
    });
    assert!(worst.get() > 1.0, "{}", worst.get());
}

#[test]
fn products_keep_their_accuracy() {
    let worst = Cell::new(0.0_f64);
    let drawn = (0usize..=4, 0usize..=3).prop_flat_map(|(p, q)| (generators::knots(p), 0..=q));
    let drawn = drawn.prop_flat_map(|(knots, q)| {
        (generators::points::<1>(knots.functions()), generators::points::<1>(q + 3), Just(knots), Just(q))
    });
    run(drawn, |(points, factor, knots, q)| {
        let given = Spline::open(knots, points).unwrap();
        let (start, end) = given.knots().domain();
        let middle = given.knots().breaks()[given.knots().breaks().len() / 2];
        let count = factor.len() - q - 1;
        let inner = if middle < end { middle } else { start + (end - start) * 0.5 };
        let ends = |t: f64| std::iter::repeat_n(t, q + 1);
        let own: Vec<f64> = ends(start).chain(std::iter::repeat_n(inner, count)).chain(ends(end)).collect();
        let Ok(knots) = Knots::new(own[..factor.len() + q + 1].to_vec(), q) else { return Ok(()) };
        if knots.domain() != (start, end) {
            return Ok(());
        }
        let factor = Spline::open(knots, factor).unwrap();
        let found = given.product(&factor).unwrap();
        let ((f, f_sizes), (g, g_sizes)) = (exact(&given), exact(&factor));
        compare("product", &found, &f.product(&g).unwrap(), &f_sizes.product(&g_sizes).unwrap(), &worst)
    });
    assert!(worst.get() > 1.0, "{}", worst.get());
}

/// Below this, of the points' size, everything that should come back does.
const BACK: f64 = 256.0 * f64::EPSILON;

#[test]
fn there_and_back_is_the_same_curve() {
    let drawn = (1usize..=5).prop_flat_map(generators::mild_knots);
    let drawn = drawn.prop_flat_map(|knots| (generators::points::<1>(knots.functions()), Just(knots)));
    run(drawn, |(points, knots)| {
        let spline = Spline::open(knots, points).unwrap().clamp().unwrap();
        let (a, b) = spline.knots().domain();
        let size = spline.points().iter().fold(1.0, |most: f64, [x]| most.max(x.abs()));
        let near = |found: &Floats, what: &str| -> Law {
            prop_assert_eq!(found.knots().values(), spline.knots().values(), "{}", what);
            for ([x], [y]) in found.points().iter().zip(spline.points()) {
                prop_assert!((x - y).abs() <= BACK * size, "{what}: {x} became {y} in {spline:?}");
            }
            Ok(())
        };
        let t = a + (b - a) * 0.37;
        let small = |moved: &[f64; 1]| moved[0].abs() <= BACK * size;
        if spline.knots().multiplicity(&t) == 0 {
            let (coarse, moved) = spline.insert(&[t]).unwrap().remove(&t).unwrap();
            prop_assert!(small(&moved), "{moved:?}");
            near(&coarse, "inserted and removed")?;
            let (left, right) = spline.split(&t).unwrap();
            near(&left.join(&right, &mut |moved| small(moved)).unwrap(), "split and joined")?;
        }
        let (lower, left) = spline.elevate(1).unwrap().reduce().unwrap();
        prop_assert!(left.iter().all(small), "{left:?}");
        near(&lower, "elevated and reduced")?;
        let twice = spline.reverse().unwrap().reverse().unwrap();
        prop_assert_eq!(twice.points(), spline.points());
        Ok(())
    });
}

#[test]
fn zero_is_a_value_like_any_other() {
    let flat = Spline::open(Knots::clamped(4, 3).unwrap(), vec![[0.0]; 4]).unwrap();
    assert!(flat.insert(&[0.25, 0.75]).unwrap().elevate(2).unwrap().points().iter().all(|[x]| x.is_zero()));
}
