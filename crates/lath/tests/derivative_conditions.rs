//! Interpolating B-splines with derivatives at any point: each condition holds, the knots leave the curve smooth, other systems agree.
#![allow(clippy::unwrap_used)] // helpers of tests stop at the first fault, loudly

use lath::curve::{BSpline, Curve, Hermite};
use lath::error::Code;
use lath::interpolate::{BSplineEnd, Derivative, bspline, bspline_with_derivatives};
use proptest::prelude::*;
use std::cell::Cell;
use testkit::conformance::run;

fn data(n: usize) -> (Vec<f64>, Vec<[f64; 2]>) {
    let t: Vec<f64> = (0..n).map(|i| i as f64 + 0.25 * ((i * 5 % 3) as f64)).collect();
    let points = t.iter().map(|t| [libm::sin(*t), libm::cos(0.7 * t) * t]).collect();
    (t, points)
}

const FREE: BSplineEnd<2> = BSplineEnd::NotAKnot;

fn given<const D: usize>(index: usize, order: usize, value: [f64; D]) -> Derivative<D> {
    Derivative { index, order, value }
}

/// Value and derivatives at a parameter, from the left at the domain's end.
fn jet<const D: usize>(curve: &BSpline<D>, t: f64, order: usize) -> Vec<[f64; D]> {
    curve.jet(t, order).unwrap()
}

fn close<const D: usize>(a: &[f64; D], b: &[f64; D], tolerance: f64) -> bool {
    (0..D).all(|c| (a[c] - b[c]).abs() <= tolerance)
}

#[test]
fn every_condition_holds_for_every_degree() {
    let (t, points) = data(12);
    for degree in 2..=9 {
        // All orders that there are at one point inside, some at others and at both ends.
        let mut wanted: Vec<Derivative<2>> = (1..degree).map(|k| given(5, k, [0.5, -1.0])).collect();
        wanted.extend([
            given(0, 1, [1.0, 2.0]),
            given(8, 1, [0.0, 0.0]),
            given(11, 1, [-1.0, 0.5]),
            given(2, 1, [0.3, 0.3]),
        ]);
        let curve = bspline_with_derivatives(&points, t.clone(), degree, &FREE, &FREE, &wanted).unwrap();
        assert_eq!(curve.control_points().len(), 12 + wanted.len());
        for (t, point) in t.iter().zip(&points) {
            assert!(close(&curve.eval(*t).unwrap(), point, 1e-11), "degree {degree} at {t}");
        }
        // A derivative of order k is made of differences of control points, divided by knots about a quarter apart.
        let size = curve.control_points().iter().flatten().fold(0.0, |most: f64, x| most.max(x.abs()));
        for Derivative { index, order, value } in &wanted {
            let found = jet(&curve, t[*index], *order)[*order];
            let rounding = 1e-15 * size * (0..*order).fold(1.0, |factor, _| factor * 8.0 * degree as f64);
            assert!(close(&found, value, rounding), "degree {degree}, order {order} at point {index}: {found:?}");
        }
        // All inner knots are simple: nothing of the smoothness is given up.
        let inner = &curve.knots().values()[degree + 1..curve.control_points().len()];
        assert!(inner.windows(2).all(|pair| pair[0] < pair[1]), "degree {degree}: {inner:?}");
    }
}

#[test]
fn without_derivatives_it_is_the_plain_curve_to_the_bit() {
    let (t, points) = data(12);
    for degree in 0..=7 {
        for ends in [FREE, BSplineEnd::Natural] {
            let plain = bspline(&points, t.clone(), degree, &ends, &ends).unwrap();
            assert_eq!(bspline_with_derivatives(&points, t.clone(), degree, &ends, &ends, &[]).unwrap(), plain);
        }
    }
    // Derivatives at the ends, given either way.
    for degree in 2..=7 {
        let orders: Vec<(usize, [f64; 2])> = (1..=degree / 2).map(|k| (k, [k as f64, -1.0])).collect();
        let listed: Vec<_> =
            [0, 11].iter().flat_map(|i| orders.iter().map(|(k, value)| given(*i, *k, *value))).collect();
        let by_ends = BSplineEnd::Derivatives(orders);
        let plain = bspline(&points, t.clone(), degree, &by_ends, &by_ends).unwrap();
        assert_eq!(bspline_with_derivatives(&points, t.clone(), degree, &FREE, &FREE, &listed).unwrap(), plain);
    }
}

#[test]
fn slopes_at_every_point_over_even_parameters_give_even_knots() {
    // Two conditions a point: knots at the quarters next to each point, half a step apart.
    let t: Vec<f64> = (0..6).map(f64::from).collect();
    let points: Vec<[f64; 2]> = t.iter().map(|t| [*t, t * t]).collect();
    let slopes: Vec<_> = (0..6).map(|i| given(i, 1, [1.0, 2.0 * i as f64])).collect();
    let curve = bspline_with_derivatives(points, t, 3, &FREE, &FREE, &slopes).unwrap();
    assert_eq!(curve.knots().values()[4..12], [0.75, 1.25, 1.75, 2.25, 2.75, 3.25, 3.75, 4.25]);
    // The parabola itself.
    for k in 0..=50 {
        let t = f64::from(k) / 10.0;
        assert!(close(&curve.eval(t).unwrap(), &[t, t * t], 1e-13));
    }
}

#[test]
fn polynomials_come_back() {
    let t = vec![-1.0, 0.5, 1.0, 3.0];
    let value = |t: f64, k: usize| match k {
        0 => t * t * t * t * t - 2.0 * t * t,
        1 => 5.0 * t * t * t * t - 4.0 * t,
        2 => 20.0 * t * t * t - 4.0,
        _ => 60.0 * t * t,
    };
    for which in [[(1, 1), (2, 1)], [(1, 1), (1, 2)], [(0, 1), (3, 2)], [(2, 2), (2, 3)], [(3, 1), (0, 3)]] {
        let wanted = which.map(|(i, k)| given(i, k, [value(t[i], k)]));
        let points: Vec<[f64; 1]> = t.iter().map(|t| [value(*t, 0)]).collect();
        let (free, t) = (BSplineEnd::NotAKnot, t.clone());
        let curve = bspline_with_derivatives(points, t, 5, &free, &free, &wanted).unwrap();
        for k in 0..=16 {
            let t = -1.0 + f64::from(k) / 4.0;
            let found = jet(&curve, t, 2);
            for (k, [x]) in found.iter().enumerate() {
                assert!((x - value(t, k)).abs() < 1e-10, "{which:?}: derivative {k} at {t} is {x}");
            }
        }
    }
}

#[test]
fn cubics_with_double_conditions_everywhere_follow_the_hermite_curve() {
    // Degree 3 over 2n conditions is C², the Hermite curve C¹: both have the slopes, and agree at the points.
    let (t, points) = data(8);
    let tangents: Vec<[f64; 2]> =
        t.iter().map(|t| [libm::cos(*t), libm::cos(0.7 * t) - 0.7 * t * libm::sin(0.7 * t)]).collect();
    let wanted: Vec<_> = tangents.iter().enumerate().map(|(i, m)| given(i, 1, *m)).collect();
    let curve = bspline_with_derivatives(&points, t.clone(), 3, &FREE, &FREE, &wanted).unwrap();
    let hermite = Hermite::new(t.clone(), &points, &tangents).unwrap();
    for i in 0..8 {
        let (a, b) = (jet(&curve, t[i], 1), hermite.jet(t[i], 1).unwrap());
        assert!(close(&a[0], &b[0], 1e-13) && close(&a[1], &b[1], 1e-12));
    }
    for k in 0..=100 {
        let at = t[0] + (t[7] - t[0]) * f64::from(k) / 100.0;
        assert!(close(&curve.eval(at).unwrap(), &hermite.eval(at).unwrap(), 0.05), "{at}");
    }
}

#[test]
fn high_degrees_hold_or_are_refused() {
    let (t, points) = data(40);
    let mut refused = Vec::new();
    for degree in 2..=30 {
        let powers = BSplineEnd::Derivatives((1..=degree / 2).map(|k| (k, [0.5, -0.5])).collect());
        for (name, ends) in [("natural", BSplineEnd::Natural), ("given", powers)] {
            match bspline(&points, t.clone(), degree, &ends, &ends) {
                Ok(curve) => {
                    // The greatest condition is 39 or so.
                    for (t, point) in t.iter().zip(&points) {
                        assert!(close(&curve.eval(*t).unwrap(), point, 4e-9), "degree {degree}, {name} at {t}");
                    }
                }
                Err(error) => {
                    assert_eq!(error.code(), Code::N003, "degree {degree}, {name}");
                    refused.push((degree, name));
                }
            }
        }
    }
    // Natural ends hold up to degree 21, for odd degrees up to 25; slopes that do not fit the data up to 18.
    let holds = |degree: usize, name| match name {
        "natural" => degree <= 21 || (degree % 2 == 1 && degree <= 25),
        _ => degree <= 18,
    };
    assert!(!refused.iter().any(|(degree, name)| holds(*degree, *name)), "{refused:?}");
    assert!(refused.contains(&(30, "natural")) && refused.contains(&(30, "given")));
}

#[test]
fn what_cannot_be_met_is_named() {
    let (t, points) = data(6);
    let fault = |degree, wanted: &[Derivative<2>]| {
        let error = bspline_with_derivatives(&points, t.clone(), degree, &FREE, &FREE, wanted).unwrap_err();
        (error.code(), error.index())
    };
    let good = given(1, 1, [1.0, 1.0]);
    assert_eq!(fault(3, &[good, given(6, 1, [0.0; 2])]), (Code::C003, Some(1)));
    assert_eq!(fault(3, &[good, good]), (Code::C003, Some(1)));
    assert_eq!(fault(3, &[given(1, 3, [0.0; 2])]), (Code::C003, Some(0)));
    assert_eq!(fault(3, &[given(1, 0, [0.0; 2])]), (Code::C003, Some(0)));
    assert_eq!(fault(1, &[good]), (Code::C003, Some(0)));
    assert_eq!(fault(0, &[good]), (Code::C003, Some(0)));
    assert_eq!(fault(3, &[good, given(2, 1, [f64::NAN, 0.0])]), (Code::P002, Some(1)));
    assert_eq!(fault(3, &[given(2, 1, [1e301, 0.0])]), (Code::P003, Some(0)));
    assert_eq!(fault(7, &[good]), (Code::P001, None));
    let natural = BSplineEnd::Natural;
    let error = bspline_with_derivatives(&points, t.clone(), 3, &natural, &natural, &[given(0, 2, [0.0; 2])]);
    assert_eq!(error.unwrap_err().code(), Code::C003);
    // A condition of its own may stand in for points: two points and two slopes are a cubic.
    let slopes = [given(0, 1, [1.0, 0.0]), given(1, 1, [0.0, 1.0])];
    let curve = bspline_with_derivatives(&points[..2], t[..2].to_vec(), 3, &FREE, &FREE, &slopes).unwrap();
    assert_eq!(curve.knots().values().len(), 8);
}

/// Orders without a gap are always solvable, wherever they are given and however uneven the parameters; knots and conditions
/// interlace as Schoenberg and Whitney ask.
#[test]
fn conditions_without_gaps_are_met_on_any_parameters() {
    let steps = prop::collection::vec((1e-2..1.0_f64, -1.0..1.0_f64, 0usize..8), 8..14);
    let (met, refused) = (Cell::new(0), Cell::new(0));
    run((2usize..8, steps), |(degree, steps)| {
        let mut t = vec![0.0];
        for (step, ..) in &steps[1..] {
            t.push(t[t.len() - 1] + step);
        }
        let points: Vec<[f64; 1]> = steps.iter().map(|(_, y, _)| [*y]).collect();
        let orders = |i: usize| steps[i].2 % degree;
        let wanted: Vec<Derivative<1>> =
            (0..t.len()).flat_map(|i| (1..=orders(i)).map(move |k| given(i, k, [0.0]))).collect();
        let free = BSplineEnd::NotAKnot;
        let curve = match bspline_with_derivatives(&points, t.clone(), degree, &free, &free, &wanted) {
            Ok(curve) => curve,
            // Uneven steps may ask for control points beyond what floats can carry; nothing else is an excuse.
            Err(error) => {
                prop_assert_eq!(error.code(), Code::N003);
                refused.set(refused.get() + 1);
                return Ok(());
            }
        };
        met.set(met.get() + 1);
        for (t, [y]) in t.iter().zip(&points) {
            let [found] = curve.eval(*t).unwrap();
            prop_assert!((found - y).abs() < 1e-9, "{} instead of {} at {}", found, y, t);
        }
        let knots = curve.knots().values();
        let sites = (0..t.len()).flat_map(|i| std::iter::repeat_n(t[i], 1 + orders(i)));
        for (i, site) in sites.enumerate() {
            let clamped = site == t[0] && knots[i] == site || site == t[t.len() - 1] && knots[i + degree + 1] == site;
            prop_assert!(clamped || knots[i] < site && site < knots[i + degree + 1], "condition {} at {}", i, site);
        }
        Ok(())
    });
    println!("{} met, {} refused", met.get(), refused.get());
    assert!(met.get() > 4 * refused.get());
}
