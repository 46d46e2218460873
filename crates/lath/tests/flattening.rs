//! Flattening keeps its word: at every tolerance, measured by dense sampling that knows nothing of the proof.

#![allow(clippy::unwrap_used)] // a failing unwrap is a failing test

use lath::curve::{BSpline, Bezier, Curve, Hermite, Interval, Polyline};
use lath::error::{Code, Limits};
use lath::knot::{Knots, Side};
use lath::num::Bound;
use lath::space::{distance, norm};
use lath::tessellate::flatten;
use std::sync::atomic::AtomicBool;

fn polyline<const D: usize>(curve: &dyn Curve<D>, tolerance: f64) -> (Vec<(f64, [f64; D])>, Bound) {
    let mut points = Vec::new();
    let bound = flatten(curve, tolerance, &Limits::default(), &mut |t, point| points.push((t, point))).unwrap();
    (points, bound)
}

/// The distance of a point from a segment.
fn off<const D: usize>(point: &[f64; D], a: &[f64; D], b: &[f64; D]) -> f64 {
    let along: [f64; D] = std::array::from_fn(|c| b[c] - a[c]);
    let length = norm(&along);
    let dot = (0..D).map(|c| (point[c] - a[c]) * along[c]).sum::<f64>();
    let u = if length > 0.0 { (dot / length / length).clamp(0.0, 1.0) } else { 0.0 };
    distance(point, &std::array::from_fn(|c| a[c] + u * along[c]))
}

/// The greatest distance of sampled curve points from the chord that covers their parameter.
fn deviation<const D: usize>(curve: &dyn Curve<D>, points: &[(f64, [f64; D])]) -> f64 {
    let mut worst: f64 = 0.0;
    for pair in points.windows(2).filter(|pair| pair[0].0 < pair[1].0) {
        for k in 1..16 {
            let t = pair[0].0 + (pair[1].0 - pair[0].0) * f64::from(k) / 16.0;
            let mut point = [[0.0; D]];
            curve.jet_into(t, Side::Right, &mut point);
            worst = worst.max(off(&point[0], &pair[0].1, &pair[1].1));
        }
    }
    worst
}

fn wild() -> Bezier<2> {
    Bezier::new([[0.0, 0.0], [9.0, 3.0], [-7.0, 4.0], [2.0, -8.0], [5.0, 5.0], [1.0, 0.0]]).unwrap()
}

#[test]
fn the_tolerance_is_kept_over_twelve_decades() {
    let closed =
        BSpline::closed_uniform(3, [[0.0, -1.5, 0.0], [1.5, 0.0, 1.0], [0.0, 1.5, 0.0], [-1.5, 0.0, 2.0]]).unwrap();
    let mut tolerance = 10.0;
    while tolerance > 1e-9 {
        let (points, bound) = polyline(&wild(), tolerance);
        let worst = deviation(&wild(), &points);
        assert!(bound.is_proven() && bound.value() <= tolerance, "{bound:?}");
        assert!(worst <= bound.value() * (1.0 + 1e-9) + 1e-14, "{worst:e} against {bound:?}");
        let (points, bound) = polyline(&closed, tolerance);
        assert!(bound.is_proven() && deviation(&closed, &points) <= bound.value() + 1e-14);
        assert_eq!(points.first().unwrap().1, closed.eval(0.0).unwrap());
        tolerance /= 3.7;
    }
}

#[test]
fn the_bound_is_not_wasteful() {
    // For a parabola the bound is the deviation itself.
    let parabola = Bezier::new([[0.0, 0.0], [1.0, 2.0], [2.0, 0.0]]).unwrap();
    let (points, bound) = polyline(&parabola, 1e-4);
    let worst = deviation(&parabola, &points);
    assert!(worst > 0.98 * bound.value(), "{worst:e} against {bound:?}");
}

#[test]
fn straight_and_degenerate_curves_need_few_points() {
    let line = Bezier::new([[0.0, 0.0], [1.0, 1.0], [2.0, 2.0], [3.0, 3.0]]).unwrap();
    assert_eq!(polyline(&line, 1e-12).0.len(), 2);
    let point = Bezier::new([[4.0, 4.0]; 4]).unwrap();
    assert_eq!(polyline(&point, 1e-300).0, [(0.0, [4.0, 4.0]), (1.0, [4.0, 4.0])]);
    let polygon = Polyline::new([[0.0], [1.0], [0.0]]).unwrap();
    assert_eq!(polyline(&polygon, 1e-6).0, [(0.0, [0.0]), (1.0, [1.0]), (2.0, [0.0])]);
    let constant = Bezier::new([[1.0]]).unwrap();
    assert_eq!(polyline(&constant, 1.0).0, [(0.0, [1.0]), (1.0, [1.0])]);
}

#[test]
fn both_sides_of_a_jump_are_sent() {
    // Degree 1 with a double inner knot: two segments that do not meet.
    let knots = Knots::new(vec![0.0, 0.0, 1.0, 1.0, 2.0, 2.0], 1).unwrap();
    let curve = BSpline::new(knots, [[0.0], [1.0], [5.0], [6.0]]).unwrap();
    assert_eq!(polyline(&curve, 0.1).0, [(0.0, [0.0]), (1.0, [1.0]), (1.0, [5.0]), (2.0, [6.0])]);
    // Degree 0: steps.
    let curve = BSpline::new(Knots::new(vec![0.0, 1.0, 3.0], 0).unwrap(), [[2.0], [7.0]]).unwrap();
    assert_eq!(polyline(&curve, 0.1).0, [(0.0, [2.0]), (1.0, [2.0]), (1.0, [7.0]), (3.0, [7.0])]);
}

#[test]
fn tolerances_that_mean_nothing_are_refused() {
    for tolerance in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let error = flatten(&wild(), tolerance, &Limits::default(), &mut |_, _| {}).unwrap_err();
        assert_eq!(error.code(), Code::Q001);
    }
}

#[test]
fn a_budget_is_refused_before_the_first_point() {
    let mut sent = 0;
    let error = flatten(&wild(), 1e-300, &Limits::default(), &mut |_, _| sent += 1).unwrap_err();
    assert_eq!((error.code(), sent), (Code::B001, 0));
    let few = Limits { max_points: 20, ..Limits::default() };
    assert!(flatten(&wild(), 1e-6, &few, &mut |_, _| sent += 1).unwrap_err().is_budget());
    assert_eq!(sent, 0);
    let stop = AtomicBool::new(true);
    let stopped = Limits { cancel: Some(&stop), ..Limits::default() };
    assert!(flatten(&wild(), 1e-3, &stopped, &mut |_, _| sent += 1).unwrap_err().is_cancelled());
    assert_eq!(sent, 0);
}

/// A circle by sine and cosine: not polynomial, so nothing is proven.
#[derive(Debug)]
struct Circle;

impl Curve<2> for Circle {
    fn kind(&self) -> &'static str {
        "circle"
    }
    fn degree(&self) -> usize {
        0
    }
    fn domain(&self) -> Interval {
        Interval { start: 0.0, end: 6.25 }
    }
    fn jet_into(&self, t: f64, _side: Side, out: &mut [[f64; 2]]) {
        let (s, c) = (libm::sin(t), libm::cos(t));
        for (k, slot) in out.iter_mut().enumerate() {
            *slot = [[c, s], [-s, c], [-c, -s], [s, -c]][k % 4];
        }
    }
}

#[test]
fn a_curve_that_cannot_prove_anything_gets_an_estimate() {
    for tolerance in [1e-1, 1e-3, 1e-6] {
        let (points, bound) = polyline(&Circle, tolerance);
        assert_eq!(bound, Bound::Estimate(tolerance));
        assert!(deviation(&Circle, &points) <= tolerance);
        assert_eq!((points[0].0, points[points.len() - 1].0), (0.0, 6.25));
    }
    let (bounds, bound) = lath::query::bounds(&Circle);
    assert!(!bound.is_proven());
    assert!(bounds.hi[0] == 1.0 && bounds.lo[0] < -0.999);
    let curvature = lath::query::signed_curvature(&Circle, 1.0, Side::Right).unwrap();
    assert!((curvature - 1.0).abs() < 1e-15);
}

#[test]
fn a_hermite_curve_at_a_distance_keeps_its_detail() {
    // Map coordinates: 1e7 off the origin, with detail of a thousandth.
    let far = |x: f64, y: f64| [1e7 + x, 5e6 + y];
    let points = [far(0.0, 0.0), far(1e-3, 2e-3), far(3e-3, 0.0)];
    let curve = Hermite::new(vec![0.0, 1.0, 2.0], points, [[1e-3, 2e-3], [1e-3, 0.0], [2e-3, -2e-3]]).unwrap();
    let (flat, bound) = polyline(&curve, 1e-6);
    assert!(bound.is_proven() && flat.len() < 80, "{}", flat.len());
    assert!(deviation(&curve, &flat) <= 1e-6 + 4e-9); // the rounding of coordinates of 1e7
}

#[test]
fn pieces_that_overflow_are_refused_before_the_first_point() {
    let wild = Hermite::new(vec![-1e300, 1e300], [[0.0], [1.0]], [[1e298], [-1e298]]).unwrap();
    let mut sent = 0;
    let refused = flatten(&wild, 1.0, &Limits::default(), &mut |_, _| sent += 1);
    assert_eq!((refused.unwrap_err().code(), sent), (Code::P003, 0));
}

#[test]
fn rounded_parameters_never_go_back() {
    // At 1 − 2⁻⁵³ the sum of the shares of both ends is rounded above the end, here for one of the steps.
    for end in [1.0f64.next_up(), -5.75, 2.0, 1e15 + 0.5] {
        for start in [end - 1e-9, end.next_down().next_down().next_down(), end - 1.0] {
            if start == end {
                continue;
            }
            let bend = Bezier::on([[0.0], [1.0], [0.0]], Interval { start, end }).unwrap();
            let t: Vec<f64> = polyline(&bend, 1e-4).0.into_iter().map(|(t, _)| t).collect();
            assert!(t.is_sorted() && t[0] == start && t[t.len() - 1] == end, "{start:?} to {end:?}");
        }
    }
}
