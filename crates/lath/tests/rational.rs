//! Rational curves: what weights do, the exact conics, and the questions asked of them.
#![allow(clippy::unwrap_used)] // helpers of tests stop at the first fault, loudly

use lath::curve::{BSpline, Bezier, Curve, Nurbs, Path, RationalBezier};
use lath::error::{Code, Limits};
use lath::knot::{Knots, Side};
use lath::query::{Continuity, bounds, continuity, curvature, length, signed_curvature};
use lath::space::{distance, norm};
use lath::tessellate::flatten;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// The unit roundoff.
const U: f64 = f64::EPSILON / 2.0;

fn wild() -> Nurbs<2> {
    let knots = Knots::new(vec![0.0, 0.0, 0.0, 0.0, 1.0, 1.5, 3.0, 3.0, 3.0, 3.0], 3).unwrap();
    let points = [[0.0, 0.0], [2.0, 5.0], [4.0, -6.0], [-1.0, 3.0], [7.0, 1.0], [3.0, 3.0]];
    Nurbs::new(knots, points, [1.0, 8.0, 0.25, 3.0, 0.0625, 2.0]).unwrap()
}

fn samples<const D: usize>(curve: &dyn Curve<D>, count: u32) -> impl Iterator<Item = f64> {
    let domain = curve.domain();
    (0..=count).map(move |k| {
        let u = f64::from(k) / f64::from(count);
        domain.start * (1.0 - u) + domain.end * u
    })
}

#[test]
fn a_circle_stays_round_to_two_units_in_the_last_place() {
    for (center, radius) in [([0.0, 0.0], 1.0), ([0.0, 0.0], 1e-3), ([0.0, 0.0], 7e100), ([3.0, -5.0], 2.5)] {
        let circle = Nurbs::circle(center, radius).unwrap();
        // Coordinates far from zero have their own last place.
        let size = radius + norm(&center);
        for t in samples(&circle, 4096) {
            let off = (distance(&circle.eval(t).unwrap(), &center) - radius).abs();
            assert!(off <= 2.0 * f64::EPSILON * size, "{off:e} off the circle of {radius} at {t}");
        }
    }
}

#[test]
fn the_parameter_of_an_arc_is_its_angle() {
    for (start, sweep, pieces) in
        [(0.0, FRAC_PI_2, 1), (0.3, -2.0, 2), (-1.0, 1.5 * PI, 3), (2.0, -TAU, 4), (0.0, 1e-6, 1)]
    {
        let arc = Nurbs::arc([0.0, 0.0], 2.0, start, sweep).unwrap();
        assert_eq!(arc.breaks().len(), pieces + 1);
        for (i, t) in samples(&arc, 2 * pieces as u32).enumerate() {
            let angle = start + sweep * i as f64 / (2 * pieces) as f64;
            let off = distance(&arc.eval(t).unwrap(), &[2.0 * libm::cos(angle), 2.0 * libm::sin(angle)]);
            assert!(off < 4e-15, "{off:e} at the half piece {i} of {sweep}");
        }
        for t in samples(&arc, 777) {
            let angle = start + sweep.signum() * t;
            let off = distance(&arc.eval(t).unwrap(), &[2.0 * libm::cos(angle), 2.0 * libm::sin(angle)]) / 2.0;
            assert!(off < 1_f64.to_radians(), "the parameter is {off} away from the angle at {t}");
        }
    }
    for (sweep, code) in [(0.0, Code::Q003), (6.3, Code::Q003), (f64::NAN, Code::Q002)] {
        assert_eq!(Nurbs::arc([0.0, 0.0], 1.0, 0.0, sweep).unwrap_err().code(), code);
    }
    assert_eq!(Nurbs::circle([0.0, 0.0], f64::INFINITY).unwrap_err().code(), Code::P002);
}

#[test]
fn a_whole_circle_meets_itself_with_its_first_derivative() {
    for circle in [Nurbs::circle([1.0, 2.0], 3.0).unwrap(), Nurbs::arc([1.0, 2.0], 3.0, 0.1, -TAU).unwrap()] {
        let (first, last) = (circle.jet(0.0, 1).unwrap(), circle.jet(TAU, 1).unwrap());
        assert_eq!(first[0], last[0]);
        assert!(distance(&first[1], &last[1]) < 1e-14);
        let joints = continuity(&circle);
        assert!(joints.len() == 3 && joints.iter().all(|(_, joint)| *joint == Continuity::Order(1)), "{joints:?}");
    }
}

#[test]
fn conics_satisfy_their_equations() {
    let ellipse = Nurbs::ellipse([1.0, 0.0], [3.0, 0.0], [0.0, 0.5]).unwrap();
    for t in samples(&ellipse, 100) {
        let [x, y] = ellipse.eval(t).unwrap();
        assert!(((x - 1.0) * (x - 1.0) / 9.0 + 4.0 * y * y - 1.0).abs() < 4e-15);
    }
    let hyperbola = Nurbs::hyperbola([0.0, 0.0], [2.0, 0.0], [0.0, 1.0], -1.5, 2.0).unwrap();
    for t in samples(&hyperbola, 100) {
        let [x, y] = hyperbola.eval(t).unwrap();
        assert!((x * x / 4.0 - y * y - 1.0).abs() < 1e-14 * (1.0 + y * y));
    }
    let middle = hyperbola.eval(0.25).unwrap();
    assert!(distance(&middle, &[2.0 * libm::cosh(0.25), libm::sinh(0.25)]) < 2e-15);
    let parabola = Nurbs::parabola([1.0, 1.0, 1.0], [1.0, 0.0, 2.0], [0.0, 0.5, 0.0], -3.0, 5.0).unwrap();
    for t in samples(&parabola, 64) {
        let exact = [1.0 + t, 1.0 + 0.5 * t * t, 1.0 + 2.0 * t];
        assert!(distance(&parabola.eval(t).unwrap(), &exact) < 2e-14);
    }
    // A circle in space: the curvature is one over the radius everywhere, and the plane is kept.
    let tilted = Nurbs::ellipse([5.0, 6.0, 7.0], [2.0, 0.0, 0.0], [0.0, 1.2, 1.6]).unwrap();
    for t in samples(&tilted, 50) {
        let p = tilted.eval(t).unwrap();
        assert!((distance(&p, &[5.0, 6.0, 7.0]) - 2.0).abs() < 1e-14);
        assert!((0.8 * (p[1] - 6.0) - 0.6 * (p[2] - 7.0)).abs() < 1e-14);
        assert!((curvature(&tilted, t, Side::Right).unwrap() - 0.5).abs() < 1e-13);
    }
}

#[test]
fn curvature_of_a_circle_has_its_sign() {
    let left = Nurbs::arc([0.0, 0.0], 4.0, 0.0, 3.0).unwrap();
    let right = Nurbs::arc([0.0, 0.0], 4.0, 0.0, -3.0).unwrap();
    for t in [0.0, 0.4, 1.7, 3.0] {
        assert!((signed_curvature(&left, t, Side::Right).unwrap() - 0.25).abs() < 1e-14);
        assert!((signed_curvature(&right, t, Side::Right).unwrap() + 0.25).abs() < 1e-14);
    }
}

#[test]
fn equal_weights_are_the_polynomial_curve_and_a_common_factor_is_none() {
    let weighted = wild();
    let plain = weighted.unweighted();
    for factor in [1.0, 0.3, 7e-290, 5e299, -2.0] {
        let equal = plain.clone().weighted(vec![factor; 6]).unwrap();
        assert!(equal.is_rational() && !plain.is_rational());
        let scaled = plain.clone().weighted(weighted.weights().iter().map(|w| w * factor / 8.0)).unwrap();
        for t in samples(plain, 60) {
            let (a, b) = (equal.jet(t, 3).unwrap(), plain.jet(t, 3).unwrap());
            for (k, (a, b)) in a.iter().zip(&b).enumerate() {
                assert!(distance(a, b) <= 100.0 * U * [10.0, 100.0, 1e3, 1e4][k], "derivative {k} at {t}: {a:?} {b:?}");
            }
            let (a, b) = (scaled.jet(t, 2).unwrap(), weighted.jet(t, 2).unwrap());
            for (a, b) in a.iter().zip(&b) {
                assert!(distance(a, b) <= 1e-11 * (1.0 + norm(b)), "factor {factor} at {t}: {a:?} {b:?}");
            }
        }
    }
    // A power of two changes no bit.
    let doubled = plain.clone().weighted(weighted.weights().iter().map(|w| w * 1024.0)).unwrap();
    assert!(samples(plain, 60).all(|t| doubled.jet(t, 2).unwrap() == weighted.jet(t, 2).unwrap()));
}

#[test]
fn a_heavier_point_pulls() {
    let points = [[0.0, 0.0], [1.0, 2.0], [2.0, 0.0]];
    let mut before = 0.0;
    for weight in [0.0, 0.1, 1.0, 10.0, 1e6, 1e300] {
        let [_, y] = RationalBezier::new(points, [1.0, weight, 1.0]).unwrap().eval(0.5).unwrap();
        // 2 w/(1 + w) in the middle.
        assert!((y - 2.0 * weight / (1.0 + weight)).abs() < 1e-15 && y >= before, "{y} at {weight}");
        before = y;
    }
}

#[test]
fn ends_are_control_points_to_the_bit() {
    let curve = wild();
    assert_eq!((curve.eval(0.0).unwrap(), curve.eval(3.0).unwrap()), ([0.0, 0.0], [3.0, 3.0]));
    let thirds = RationalBezier::new([[0.1, 1.0 / 3.0], [2.0, 2.0], [1e7 + 0.1, 0.7]], [0.1, 0.3, 1.0 / 3.0]).unwrap();
    assert_eq!(thirds.eval(0.0).unwrap(), [0.1, 1.0 / 3.0]);
    assert_eq!(thirds.eval(1.0).unwrap(), [1e7 + 0.1, 0.7]);
}

#[test]
fn detail_far_from_the_origin_is_kept() {
    // The same arc at the origin and at 2^40, whose points are exact there.
    let far = 1_099_511_627_776.0;
    let near = RationalBezier::new([[1.0, 0.0], [1.0, 1.0], [0.0, 1.0]], [1.0, 1.0, 2.0]).unwrap();
    let points: Vec<[f64; 2]> = near.control_points().iter().map(|p| p.map(|x| x + far)).collect();
    let moved = RationalBezier::new(points, [1.0, 1.0, 2.0]).unwrap();
    for t in samples(&near, 40) {
        let (here, there) = (near.jet(t, 2).unwrap(), moved.jet(t, 2).unwrap());
        // The last place of the coordinate is 2⁻¹², and the derivatives see the value's rounding.
        assert!(distance(&there[0].map(|x| x - far), &here[0]) < 1.0 / 4096.0);
        assert!(distance(&there[1], &here[1]) < 1e-3 && distance(&there[2], &here[2]) < 1e-2);
    }
    assert!(near.eval(0.5).unwrap() == [0.6, 0.8]);
}

#[test]
fn boxes_are_proven_and_tight() {
    let circle = Nurbs::circle([1.0, 2.0], 3.0).unwrap();
    let (found, bound) = bounds(&circle);
    assert!(bound.is_proven() && bound.value() < 1e-11, "{bound:?}");
    for (lo, hi, center) in [(found.lo[0], found.hi[0], 1.0), (found.lo[1], found.hi[1], 2.0)] {
        assert!((lo - (center - 3.0)).abs() < 1e-11 && (hi - (center + 3.0)).abs() < 1e-11, "{found:?}");
    }
    // Not at a joint: the tops of an ellipse on its side.
    let tilted = Nurbs::ellipse([0.0, 0.0], [3.0, 4.0], [-4.0, 3.0]).unwrap();
    let (found, bound) = bounds(&tilted);
    assert!(bound.is_proven() && (found.hi[0] - 5.0).abs() < 1e-10 && found.hi[0] >= 5.0 - 1e-14, "{found:?}");
    let wild = wild();
    let (found, bound) = bounds(&wild);
    let top = samples(&wild, 100_000).map(|t| wild.eval(t).unwrap()[1]).fold(f64::MIN, f64::max);
    assert!(bound.is_proven() && found.hi[1] >= top && found.hi[1] - top < 1e-6, "{found:?} {top}");
}

#[test]
fn lengths_of_arcs_are_their_angles() {
    for e in 1..10 {
        let accuracy = libm::pow(10.0, -f64::from(e));
        let circle = Nurbs::circle([1.0, 2.0], 3.0).unwrap();
        let (found, bound) = length(&circle, accuracy, &Limits::default()).unwrap();
        assert!(bound.is_proven() && bound.value() <= accuracy, "{bound:?}");
        assert!((found - 3.0 * TAU).abs() <= bound.value() + 1e-12, "{found} at {accuracy}");
    }
    // Weights change the parameter of a straight line, not its length; a point without weight has no part.
    let line = RationalBezier::new([[0.0, 0.0], [30.0, 40.0], [3.0, 4.0]], [5.0, 0.0, 1.0]).unwrap();
    let (found, bound) = length(&line, 1e-9, &Limits::default()).unwrap();
    assert!((found - 5.0).abs() <= bound.value() + 1e-14 && bound.value() <= 1e-9, "{found} {bound:?}");
}

/// The distance of a point from a segment.
fn off<const D: usize>(point: &[f64; D], a: &[f64; D], b: &[f64; D]) -> f64 {
    let along: [f64; D] = std::array::from_fn(|c| b[c] - a[c]);
    let length = norm(&along);
    let dot = (0..D).map(|c| (point[c] - a[c]) * along[c]).sum::<f64>();
    let u = if length > 0.0 { (dot / length / length).clamp(0.0, 1.0) } else { 0.0 };
    distance(point, &std::array::from_fn(|c| a[c] + u * along[c]))
}

#[test]
fn flattening_keeps_every_tolerance() {
    let curves = [wild(), Nurbs::circle([0.0, 0.0], 1.0).unwrap()];
    for curve in &curves {
        let mut tolerance = 1.0;
        while tolerance > 1e-9 {
            let mut line = Vec::new();
            let bound = flatten(curve, tolerance, &Limits::default(), &mut |t, point| line.push((t, point))).unwrap();
            assert!(bound.is_proven() && bound.value() <= tolerance, "{bound:?}");
            for pair in line.windows(2) {
                // Every point that is sent lies on the curve at its parameter.
                assert!(distance(&curve.eval(pair[0].0).unwrap(), &pair[0].1) < 1e-13, "{pair:?}");
                for k in 1..8 {
                    let t = pair[0].0 + (pair[1].0 - pair[0].0) * f64::from(k) / 8.0;
                    let off = off(&curve.eval(t).unwrap(), &pair[0].1, &pair[1].1);
                    assert!(off <= bound.value() + 1e-14, "{off:e} at {t} with {tolerance:e}");
                }
            }
            tolerance /= 7.3;
        }
    }
    // Not wasteful: chords of a circle deviate by 1 − cos(π/n), which takes 71 of them for a thousandth.
    let mut count = 0;
    flatten(&curves[1], 1e-3, &Limits::default(), &mut |_, _| count += 1).unwrap();
    assert!((71..=3 * 71).contains(&count), "{count}");
}

#[test]
fn flattening_bends_where_the_weights_say() {
    // A weight of 1e12 makes the curve run along its polygon at almost all parameters: few points all the same.
    for weights in [[1.0, 1e12, 1.0], [1e-300, 1.0, 1e300], [1.0, 0.0, 1.0], [1e300, 1e-300, 1e-300]] {
        let curve = RationalBezier::new([[0.0, 0.0], [1.0, 2.0], [2.0, 0.0]], weights).unwrap();
        let mut line = Vec::new();
        let bound = flatten(&curve, 1e-4, &Limits::default(), &mut |_, point| line.push(point)).unwrap();
        assert!(bound.is_proven() && line.len() < 400, "{} points for {weights:?}", line.len());
        for t in samples(&curve, 500) {
            let point = curve.eval(t).unwrap();
            let nearest = line.windows(2).map(|pair| off(&point, &pair[0], &pair[1])).fold(f64::MAX, f64::min);
            assert!(nearest <= 1e-4, "{nearest} off at {t} with {weights:?}");
        }
    }
    let curve = wild();
    let few = Limits { max_points: 20, ..Limits::default() };
    assert!(flatten(&curve, 1e-9, &few, &mut |_, _| {}).unwrap_err().is_budget());
}

#[test]
fn a_path_of_both_sorts_hands_out_rational_pieces() {
    let arc = Nurbs::arc([0.0, 0.0], 1.0, 0.0, FRAC_PI_2).unwrap();
    let line = Bezier::new([arc.eval(FRAC_PI_2).unwrap(), [-1.0, 1.0]]).unwrap();
    let path = Path::new([Box::new(arc) as Box<dyn Curve<2>>, Box::new(line)], false).unwrap();
    assert!(path.is_rational() && !path.bezier_pieces(&mut |_| unreachable!("pieces were handed out, and denied")));
    let mut degrees = Vec::new();
    assert!(path.rational_pieces(&mut |piece| degrees.push(piece.points.len() - 1)));
    assert_eq!(degrees, [2, 1]);
    let (found, bound) = length(&path, 1e-9, &Limits::default()).unwrap();
    assert!((found - FRAC_PI_2 - 1.0).abs() < 1e-8 && bound.is_proven());
}

#[test]
fn continuity_sees_through_the_weights() {
    // One quarter circle cut in two at u = 1/2 by hand: the joint is no break, in this parameter.
    let knots = Knots::new(vec![0.0, 0.0, 0.0, 0.5, 0.5, 1.0, 1.0, 1.0], 2).unwrap();
    let halves = |points: [[f64; 2]; 5], weights: [f64; 5]| Nurbs::new(knots.clone(), points, weights).unwrap();
    let cut = halves([[1.0, 0.0], [1.0, 0.5], [0.6, 0.8], [1.0 / 3.0, 1.0], [0.0, 1.0]], [1.0, 1.0, 1.25, 1.5, 2.0]);
    assert_eq!(continuity(&cut), [(0.5, Continuity::Smooth)]);
    // The same points with another weight at the joint's neighbour: the direction is kept, the speed is not.
    let uneven = halves([[1.0, 0.0], [1.0, 0.5], [0.6, 0.8], [1.0 / 3.0, 1.0], [0.0, 1.0]], [1.0, 1.0, 1.25, 3.0, 2.0]);
    assert_eq!(continuity(&uneven), [(0.5, Continuity::Order(0))]);
}

#[test]
fn closed_curves_close_with_their_weights() {
    let points = [[0.0, -1.5], [1.5, 0.0], [0.0, 1.5], [-1.5, 0.0]];
    let curve = BSpline::closed_uniform(3, points).unwrap().weighted([1.0, 2.0, 1.0, 0.5]).unwrap();
    let (first, last) = (curve.jet(0.0, 2).unwrap(), curve.jet(4.0, 2).unwrap());
    assert!(first.iter().zip(&last).all(|(a, b)| distance(a, b) < 1e-13), "{first:?} {last:?}");
    assert_eq!(continuity(&curve)[0], (0.0, Continuity::Order(2)));
    // (w₀P₀ + 4w₁P₁ + w₂P₂)/(w₀ + 4w₁ + w₂) at the first joint.
    assert!(distance(&first[0], &[1.2, 0.0]) < 1e-15, "{first:?}");
}
