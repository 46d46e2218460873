//! The interpolants that look at their neighbours only: what each keeps, few points, closed curves.
#![allow(clippy::unwrap_used)] // a failing unwrap is a failing test

use lath::curve::{Curve, Hermite};
use lath::error::{Code, Result};
use lath::interpolate::{Tcb, akima, cardinal, catmull_rom, kochanek_bartels, makima, pchip, steffen};
use proptest::prelude::*;

type Rule<const D: usize> = fn(Vec<[f64; D]>, Vec<f64>, bool) -> Result<Hermite<D>>;

fn rules<const D: usize>() -> [(&'static str, Rule<D>); 6] {
    [
        ("catmull-rom", |p, t, c| catmull_rom(p, t, c)),
        ("cardinal", |p, t, c| cardinal(p, t, c, 0.3)),
        ("pchip", |p, t, c| pchip(p, t, c)),
        ("steffen", |p, t, c| steffen(p, t, c)),
        ("akima", |p, t, c| akima(p, t, c)),
        ("makima", |p, t, c| makima(p, t, c)),
    ]
}

fn uniform(n: usize) -> Vec<f64> {
    (0..n).map(|i| i as f64).collect()
}

#[test]
fn every_rule_passes_through_its_points_open_and_closed() {
    let points = [[0.0, 1.0], [2.0, 3.0], [3.0, -1.0], [3.5, -1.0], [9.0, 0.0]];
    let t = vec![0.0, 0.5, 2.0, 3.0, 4.5, 6.0];
    for (name, rule) in rules::<2>() {
        let open = rule(points.to_vec(), t[..5].to_vec(), false).unwrap();
        let closed = rule(points.to_vec(), t.clone(), true).unwrap();
        for (point, t) in points.iter().zip(&t) {
            assert_eq!((open.eval(*t).unwrap(), closed.eval(*t).unwrap()), (*point, *point), "{name} at {t}");
        }
        assert!(closed.is_closed() && closed.eval(6.0).unwrap() == points[0], "{name}");
    }
}

#[test]
fn few_points_equal_points_and_straight_points() {
    for (name, rule) in rules::<1>() {
        assert_eq!(rule(vec![[1.0]], vec![0.0], false).unwrap_err().code(), Code::P001, "{name}");
        assert_eq!(rule(vec![], vec![], false).unwrap_err().code(), Code::P001, "{name}");
        let still = rule(vec![[7.0]; 4], uniform(4), false).unwrap();
        assert!(still.tangents().iter().all(|m| *m == [0.0]), "{name}");
        let there_and_back = rule(vec![[0.0], [1.0]], uniform(3), true).unwrap();
        assert_eq!(there_and_back.eval(2.0).unwrap(), [0.0], "{name}");
        if name != "cardinal" {
            let line = rule(vec![[1.0], [3.0]], vec![0.0, 4.0], false).unwrap();
            assert_eq!(line.tangents(), [[0.5], [0.5]], "{name}");
            let line = rule((0..5).map(|i| [2.0 * f64::from(i)]).collect(), uniform(5), false).unwrap();
            assert!(line.tangents().iter().all(|m| (m[0] - 2.0).abs() <= 4.0 * f64::EPSILON), "{name}: {line:?}");
        }
    }
}

#[test]
fn closed_data_rotated_by_one_give_the_rotated_curve() {
    let points = vec![[0.0, 0.0], [4.0, 1.0], [5.0, 5.0], [1.0, 6.0], [-2.0, 3.0]];
    let mut rotated = points.clone();
    rotated.rotate_left(1);
    for (name, rule) in rules::<2>() {
        let mut expected = rule(points.clone(), uniform(6), true).unwrap().tangents().to_vec();
        expected.rotate_left(1);
        assert_eq!(rule(rotated.clone(), uniform(6), true).unwrap().tangents(), expected, "{name}");
    }
}

#[test]
fn catmull_rom_reproduces_parabolas_over_uneven_parameters() {
    let t = vec![-1.0, 0.0, 0.5, 3.0, 4.0];
    let curve = catmull_rom(t.iter().map(|t| [t * t - 3.0 * t]), t.clone(), false).unwrap();
    for (t, m) in t.iter().zip(curve.tangents()) {
        assert!((m[0] - (2.0 * t - 3.0)).abs() < 1e-14);
    }
    // Tension 1 stops at every point.
    let polygon = cardinal([[0.0], [5.0], [2.0]], uniform(3), false, 1.0).unwrap();
    assert_eq!(polygon.tangents(), [[0.0]; 3]);
    assert_eq!(cardinal([[0.0], [5.0]], uniform(2), false, f64::NAN).unwrap_err().code(), Code::Q002);
}

#[test]
fn a_spike_reaches_akimas_neighbours_only() {
    let mut points = vec![[0.0]; 11];
    points[5] = [1.0];
    let curve = akima(points, uniform(11), false).unwrap();
    let moved: Vec<usize> = (0..11).filter(|i| curve.tangents()[*i] != [0.0]).collect();
    assert!(moved.iter().all(|i| (4..=6).contains(i)), "{moved:?}");
}

#[test]
fn kochanek_bartels_has_catmull_rom_inside() {
    let points = [[0.0, 1.0], [2.0, 3.0], [3.0, -1.0], [5.0, 0.0]];
    let plain = kochanek_bartels(points, uniform(4), false, Tcb::default()).unwrap();
    let expected = catmull_rom(points, uniform(4), false).unwrap();
    for k in 0..=30 {
        let t = f64::from(k) / 10.0;
        let (a, b) = (plain.eval(t).unwrap(), expected.eval(t).unwrap());
        assert!((0..2).all(|c| (a[c] - b[c]).abs() < 1e-14), "t = {t}");
    }
    let closed = kochanek_bartels(points, uniform(5), true, Tcb { bias: 0.5, ..Tcb::default() }).unwrap();
    assert_eq!(closed.eval(0.0).unwrap(), closed.eval(4.0).unwrap());
    let bad = Tcb { continuity: f64::INFINITY, ..Tcb::default() };
    assert_eq!(kochanek_bartels(points, uniform(4), false, bad).unwrap_err().code(), Code::Q002);
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 512, rng_seed: proptest::test_runner::RngSeed::Fixed(6), ..ProptestConfig::default() })]

    /// Where the data do not fall, the curve does not fall.
    #[test]
    fn monotone_rules_keep_the_shape(
        steps in prop::collection::vec((prop_oneof![Just(0.0), 0.0..10.0, 1e-12..1e-9, 1e6..1e9], 1e-3..1e3), 1..12),
    ) {
        let (mut y, mut t) = (vec![[0.0]], vec![0.0]);
        for (rise, run) in steps {
            y.push([y[y.len() - 1][0] + rise]);
            t.push(t[t.len() - 1] + run);
        }
        for rule in [rules::<1>()[2].1, rules::<1>()[3].1] {
            let curve = rule(y.clone(), t.clone(), false).unwrap();
            let mut last = f64::NEG_INFINITY;
            for pair in t.windows(2) {
                for k in 0..=20 {
                    let at = pair[0] + (pair[1] - pair[0]) * f64::from(k) / 20.0;
                    let value = curve.eval(at.min(pair[1])).unwrap()[0];
                    prop_assert!(value >= last - 8.0 * f64::EPSILON * last.abs(), "{value} after {last} at {at}");
                    last = last.max(value);
                }
            }
        }
    }

    /// Scaling an axis, and moving it, is scaling and moving the curve: by powers of two, to the bit.
    #[test]
    fn rules_scale_by_powers_of_two_exactly(
        values in prop::collection::vec(-1e3..1e3_f64, 2..9), power in -40..40_i32,
    ) {
        let scale = libm::ldexp(1.0, power);
        let plain: Vec<[f64; 1]> = values.iter().map(|y| [*y]).collect();
        let scaled: Vec<[f64; 1]> = values.iter().map(|y| [*y * scale]).collect();
        for (name, rule) in rules::<1>() {
            let a = rule(plain.clone(), uniform(values.len()), false).unwrap();
            let b = rule(scaled.clone(), uniform(values.len()), false).unwrap();
            for (a, b) in a.tangents().iter().zip(b.tangents()) {
                prop_assert_eq!(a[0] * scale, b[0], "{}", name);
            }
        }
    }
}
