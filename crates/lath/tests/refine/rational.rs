//! Rational curves through the same verbs.

use lath::curve::{BSpline, Curve, Interval, Nurbs, RationalBezier};
use lath::knot::{Knots, Side};
use lath::num::Scalar;
use lath::refine::Spline;
use lath::space::Homogeneous;
use testkit::rational::{Rational, ratio};

/// The unit circle in four quarters, each a conic with weights 1, √½, 1.
fn circle() -> Nurbs<2> {
    let h = 0.5_f64.sqrt();
    let points = [
        [1.0, 0.0],
        [1.0, 1.0],
        [0.0, 1.0],
        [-1.0, 1.0],
        [-1.0, 0.0],
        [-1.0, -1.0],
        [0.0, -1.0],
        [1.0, -1.0],
        [1.0, 0.0],
    ];
    let knots = vec![0.0, 0.0, 0.0, 1.0, 1.0, 2.0, 2.0, 3.0, 3.0, 4.0, 4.0, 4.0];
    Nurbs::over(knots, 2, points, [1.0, h, 1.0, h, 1.0, h, 1.0, h, 1.0]).unwrap()
}

/// How far from the unit circle the curve is, in ulps of 1.
fn roundness(curve: &dyn Curve<2>) -> f64 {
    let Interval { start, end } = curve.domain();
    let place = |k: i32| start + (end - start) * f64::from(k) / 2000.0;
    let off = |t: f64| {
        let mut point = [[0.0; 2]];
        curve.jet_into(t, Side::Right, &mut point);
        let [[x, y]] = point;
        // x² + y² − 1 on fractions, so that nothing but the point is measured.
        let (x, y) = (Rational::from_f64(x), Rational::from_f64(y));
        (x.power(2) + y.power(2) - Rational::one()).abs().to_f64() / 2.0 / f64::EPSILON
    };
    (0..=2000).map(place).map(off).fold(0.0, f64::max)
}

#[test]
fn a_circle_stays_round_through_ten_elevations_and_fifty_insertions() {
    let mut curve = circle();
    for _ in 0..10 {
        curve = curve.elevate(1).unwrap();
    }
    assert_eq!(curve.degree(), 12);
    assert!(roundness(&curve) <= 16.0, "{} ulps after elevation", roundness(&curve));
    for k in 0..50 {
        let t = 4.0 * f64::from(k * 37 % 50) / 50.0 + 0.0317;
        curve = curve.insert_knots(&[t]).unwrap();
    }
    assert!(roundness(&curve) <= 16.0, "{} ulps after all", roundness(&curve));
    // All fifty at once cost no more than one.
    let at: Vec<f64> = (0..50).map(|k| 4.0 * f64::from(k) / 50.0 + 0.0317).collect();
    let once = circle().insert_knots(&at).unwrap();
    assert!(roundness(&once) <= 4.0, "{} ulps", roundness(&once));
}

#[test]
fn a_circle_on_fractions_is_exactly_round_whatever_is_done_to_it() {
    // A quarter: (1 − t², 2t)/(1 + t²).
    let point = |x: i64, y: i64, w: i64| Homogeneous { point: [ratio(x, 1), ratio(y, 1)], weight: ratio(w, 1) };
    let quarter: Spline<Homogeneous<2, Rational>, Rational> =
        Spline::open(Knots::clamped(3, 2).unwrap(), vec![point(1, 0, 1), point(1, 1, 1), point(0, 2, 2)]).unwrap();
    let changed = quarter.insert(&[ratio(1, 3), ratio(1, 3), ratio(4, 7)]).unwrap().elevate(3).unwrap();
    let changed = changed.trim(&ratio(1, 10), &ratio(9, 10)).unwrap().reverse().unwrap();
    for piece in changed.pieces().unwrap() {
        let n = piece.points.len() - 1;
        // x² + y² − w², as a polynomial of degree 2n, is zero if it is at 2n + 1 places.
        for k in 0..=2 * n {
            let u = ratio(k as i64, 2 * n as i64);
            let sum = |value: &dyn Fn(&Homogeneous<2, Rational>) -> Rational| -> Rational {
                let term = |(i, p): (usize, &Homogeneous<2, Rational>)| testkit::naive::bernstein(n, i, &u) * value(p);
                piece.points.iter().enumerate().map(term).sum()
            };
            let (x, y, w) = (sum(&|p| p.point[0].clone()), sum(&|p| p.point[1].clone()), sum(&|p| p.weight.clone()));
            assert_eq!(x.power(2) + y.power(2), w.power(2));
            assert!(w > 0);
        }
    }
}

#[test]
fn cut_joined_elevated_and_reduced_the_circle_comes_back() {
    let given = circle();
    let (left, right) = given.split(1.3).unwrap();
    let (joined, joint) = left.join(&right, 1e-12).unwrap();
    assert_eq!((joint.t, joint.multiplicity), (1.3, 0));
    assert!(joint.bound.is_proven() && joint.bound.value() < 1e-13);
    assert_eq!(joined.knots(), given.knots());
    assert!(roundness(&joined) < 8.0);
    let (lower, bound) = given.elevate(2).unwrap().reduce(2, Some(1e-12)).unwrap();
    assert_eq!(lower.knots(), given.knots());
    assert!(bound.value() < 1e-13 && roundness(&lower) < 8.0, "{bound:?}, {}", roundness(&lower));
    let (coarse, bound) = given.insert_knots(&[0.2, 0.7, 2.5, 2.5]).unwrap().remove_knots(1e-12).unwrap();
    assert_eq!(coarse.knots(), given.knots());
    assert!(bound.value() < 1e-13 && roundness(&coarse) < 8.0, "{bound:?}");
    // Weights of another size at the joint: those of the second part are scaled.
    let scaled = right.weights().iter().map(|w| w * 7.0).collect::<Vec<_>>();
    let right = BSpline::new(right.knots().clone(), right.control_points()).unwrap().weighted(scaled).unwrap();
    assert_eq!(left.join(&right, 1e-12).unwrap().1.multiplicity, 0);
    let (ring, _) = given.close(1e-12).unwrap();
    assert!(ring.is_closed() && ring.control_points().len() == 8 && roundness(&ring) < 4.0);
    assert!(roundness(&ring.move_seam(2.7).unwrap()) < 8.0);
    assert!(roundness(&ring.clamp().unwrap().reverse().unwrap()) < 8.0);
}

#[test]
fn what_is_removed_from_a_rational_curve_moves_it_no_farther_than_the_bound() {
    // A wavy curve with weights of 1 : 50.
    let points: Vec<[f64; 2]> = (0..40).map(|i| [f64::from(i), f64::from(i * i % 7) * 0.2]).collect();
    let weights: Vec<f64> = (0..40).map(|i| 1.0 + f64::from(i) * 1.25).collect();
    let given = BSpline::clamped(3, points).unwrap().weighted(weights).unwrap();
    let mut gone = Vec::new();
    for tolerance in [1e-9, 1e-3, 1e-1, 1.0, 10.0] {
        let (coarse, bound) = given.remove_knots(tolerance).unwrap();
        assert!(bound.is_proven() && bound.value() <= tolerance);
        let most = (0..=4000).map(|k| f64::from(k) / 4000.0 * 37.0).map(|t| {
            let (a, b) = (given.eval(t).unwrap(), coarse.eval(t).unwrap());
            lath::space::distance(&a, &b)
        });
        let most = most.fold(0.0, f64::max);
        assert!(most <= bound.value(), "{most} is above {bound:?}");
        gone.push(40 - coarse.control_points().len());
        for by in 1..=2 {
            let (lower, bound) = given.reduce(by, None).unwrap();
            let off = |t: f64| lath::space::distance(&given.eval(t).unwrap(), &lower.eval(t).unwrap());
            let most = (0..=2000).map(|k| off(f64::from(k) / 2000.0 * 37.0)).fold(0.0, f64::max);
            assert!(most > 0.0 && most <= bound.value(), "{most} is above {bound:?}");
        }
    }
    assert!(gone.is_sorted() && gone[0] < gone[3] && gone[3] < gone[4], "{gone:?}");
}

#[test]
fn weights_of_every_size_and_sign_pass_through() {
    let points = [[0.0, 0.0], [1.0, 2.0], [3.0, 0.0]];
    for weights in [[1e-300, 1.0, 1e300], [1.0, 0.0, 1.0], [1.0, -0.3, 1.0], [-1.0, -2.0, -1.0]] {
        let curve = RationalBezier::new(points, weights).unwrap();
        let same = |changed: &dyn Curve<2>, what: &str| {
            for t in [0.0, 0.1, 0.25, 0.5, 0.9, 1.0] {
                if changed.domain().contains(t) {
                    let (a, b) = (changed.eval(t).unwrap(), curve.eval(t).unwrap());
                    assert!(lath::space::distance(&a, &b) < 1e-14, "{what}, {weights:?}: {a:?} at {t}, not {b:?}");
                }
            }
        };
        same(&curve.elevate(2).unwrap(), "elevated");
        let (left, right) = curve.split(0.25).unwrap();
        same(&left, "left");
        same(&right, "right");
        same(&curve.to_nurbs().unwrap().insert_knots(&[0.5, 0.1]).unwrap(), "inserted");
        same(&curve.reverse().unwrap().reverse().unwrap(), "reversed");
    }
    // A distance needs positive weights.
    let curve = RationalBezier::new(points, [1.0, -0.5, 1.0]).unwrap().to_nurbs().unwrap();
    let refused = |code: &str, index: Option<usize>, error: lath::error::Error| {
        assert_eq!((error.code().as_str(), error.index()), (code, index));
    };
    // (1 − 4/2 + 1)/6: the middle point of degree 4 lies infinitely far away.
    refused("R005", Some(2), curve.elevate(2).unwrap_err());
    refused("R006", Some(1), curve.remove_knots(0.1).unwrap_err());
    refused("R006", Some(1), curve.reduce(1, None).unwrap_err());
}
