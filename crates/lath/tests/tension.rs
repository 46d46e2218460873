//! Tension of uniform cubics: what it keeps, both ends of its range, segment by segment, the circle of the textbook.
#![allow(clippy::unwrap_used)] // helpers of tests stop at the first fault, loudly

use lath::basis::{bernstein, hermite};
use lath::curve::{Curve, PolygonEnd, UniformBSpline};
use lath::error::Code;
use lath::knot::Side;
use lath::num::Scalar;
use testkit::rational::{Rational, ratio};

const POLYGON: [[f64; 2]; 7] = [[0.0, 0.0], [2.0, 5.0], [5.0, 4.0], [6.0, -1.0], [9.0, 0.0], [9.0, 6.0], [4.0, 8.0]];

fn jet<const D: usize>(curve: &dyn Curve<D>, t: f64, side: Side) -> [[f64; D]; 3] {
    let mut out = [[0.0; D]; 3];
    curve.jet_into(t, side, &mut out);
    out
}

fn near<const D: usize>(a: &[f64; D], b: &[f64; D]) -> bool {
    (0..D).all(|c| (a[c] - b[c]).abs() < 1e-13)
}

/// The first derivative by u of the segment of four numbers under tension s, by Hermite's functions on fractions.
fn tangent(p: &[Rational; 4], s: &Rational, u: &Rational) -> Rational {
    let weighted = |shares: [i64; 4], over: i64| -> Rational {
        shares.iter().zip(p).map(|(share, p)| ratio(*share, over) * p.clone()).sum()
    };
    let rest = Rational::one() - s.clone();
    let data = [
        weighted([1, 4, 1, 0], 6),
        weighted([0, 1, 4, 1], 6),
        rest.clone() * weighted([-1, 0, 1, 0], 2),
        rest * weighted([0, -1, 0, 1], 2),
    ];
    hermite::blending(u, &Rational::one())[1].iter().zip(&data).map(|(f, x)| f.clone() * x.clone()).sum()
}

#[test]
fn on_fractions_tension_1_has_the_tangent_of_the_exercise_and_tension_0_is_the_bspline() {
    let p = [3, -7, 2, 11].map(Rational::from);
    for u in [0, 1, 2, 3, 5, 7].map(|k| ratio(k, 5)) {
        // (t² − t)[(P₀ − P₃) + 3(P₁ − P₂)]
        let bracket = p[0].clone() - p[3].clone() + Rational::from(3) * (p[1].clone() - p[2].clone());
        assert_eq!(tangent(&p, &Rational::one(), &u), (u.power(2) - u.clone()) * bracket, "u = {u}");
        // The quadratic B-spline of the differences.
        let basis = lath::basis::uniform::UniformBasis::<Rational>::new(3).unwrap();
        let points = p.clone().map(|x| [x]);
        let mut out = [[Rational::zero()], [Rational::zero()]];
        let (complement, weight) = bernstein::weights(&Rational::zero(), &Rational::one(), &u);
        basis.jet(&points, (&complement, &weight), &mut out);
        assert_eq!(tangent(&p, &Rational::zero(), &u), out[1][0], "u = {u}");
    }
}

#[test]
fn tension_keeps_the_joints_and_shrinks_the_tangents() {
    let (open, closed) = (UniformBSpline::new(3, POLYGON).unwrap(), UniformBSpline::closed(3, POLYGON).unwrap());
    let at_ends = UniformBSpline::at_polygon(3, POLYGON, PolygonEnd::Phantom).unwrap();
    for curve in [&open, &closed, &at_ends] {
        let last = curve.segments();
        for s in [0.0, 0.25, 0.5, 0.75, 1.0, -1.0, 1.5] {
            let tense = curve.with_tension(s).unwrap();
            let pieces = curve.with_tensions(&vec![s; last]).unwrap();
            assert_eq!((tense.is_closed(), pieces.is_closed()), (curve.is_closed(), curve.is_closed()));
            assert_eq!((tense.domain(), pieces.domain()), (curve.domain(), curve.domain()));
            for i in 0..=last {
                let t = i as f64;
                for side in [Side::Left, Side::Right] {
                    let (plain, tense, pieces) = (jet(curve, t, side), jet(&tense, t, side), jet(&pieces, t, side));
                    let wanted = plain[1].map(|x| (1.0 - s) * x);
                    assert!(near(&tense[0], &plain[0]) && near(&tense[1], &wanted), "s = {s} at {t}: {tense:?}");
                    assert!(near(&pieces[0], &plain[0]) && near(&pieces[1], &wanted), "s = {s} at {t}: {pieces:?}");
                }
            }
            for k in 0..=10 * last {
                let t = k as f64 / 10.0;
                let (a, b) = (tense.eval(t).unwrap(), pieces.eval(t).unwrap());
                assert!(near(&a, &b), "s = {s} at {t}: {a:?}, as pieces {b:?}");
                if s == 0.0 {
                    assert!(near(&a, &curve.eval(t).unwrap()), "no tension is the B-spline");
                }
                // Full tension: on the chord between two joints.
                if s == 1.0 && k % 10 != 0 {
                    let i = k / 10;
                    let (from, to) = (curve.joint(i).unwrap(), curve.joint(i + 1).unwrap());
                    let across = (to[0] - from[0]) * (a[1] - from[1]) - (to[1] - from[1]) * (a[0] - from[0]);
                    assert!(across.abs() < 1e-12, "{a:?} is off the chord from {from:?} to {to:?}");
                }
            }
        }
    }
}

#[test]
fn each_segment_may_have_a_tension_of_its_own() {
    for curve in [UniformBSpline::new(3, POLYGON).unwrap(), UniformBSpline::closed(3, POLYGON).unwrap()] {
        let n = curve.segments();
        let tensions: Vec<f64> = (0..n).map(|i| [0.0, 0.5, 0.5, 0.9][i % 4]).collect();
        let mixed = curve.with_tensions(&tensions).unwrap();
        for i in 0..n {
            // Each segment is that of the curve with this tension everywhere.
            let alone = curve.with_tension(tensions[i]).unwrap();
            for u in [0.0, 0.25, 0.5, 0.75] {
                let t = i as f64 + u;
                assert!(near(&mixed.eval(t).unwrap(), &alone.eval(t).unwrap()), "segment {i} at {u}");
            }
            // At a joint the direction stays; the speed only where the tensions agree.
            let before = if i > 0 {
                i - 1
            } else if curve.is_closed() {
                n - 1
            } else {
                continue;
            };
            let from_left = if i > 0 { i as f64 } else { n as f64 };
            let (left, right) = (jet(&mixed, from_left, Side::Left)[1], jet(&mixed, i as f64, Side::Right)[1]);
            let across = left[0] * right[1] - left[1] * right[0];
            assert!(across.abs() < 1e-12 && left[0] * right[0] + left[1] * right[1] > 0.0, "joint {i}");
            assert_eq!(near(&left, &right), tensions[before] == tensions[i], "joint {i}: {left:?}, {right:?}");
        }
    }
}

#[test]
fn the_closed_cubic_almost_is_the_circle() {
    let circle = UniformBSpline::closed(3, [[0.0, -1.5], [1.5, 0.0], [0.0, 1.5], [-1.5, 0.0]]).unwrap();
    let joints = [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]];
    for (i, joint) in joints.iter().enumerate() {
        assert!(near(&circle.joint(i).unwrap(), joint));
    }
    for k in 0..=20 {
        let t = f64::from(k) / 20.0;
        // ¼(2t³ − 6t² + 4, −2t³ + 6t)
        let book = [(2.0 * t * t * t - 6.0 * t * t + 4.0) / 4.0, (6.0 * t - 2.0 * t * t * t) / 4.0];
        assert!(near(&circle.eval(t).unwrap(), &book), "t = {t}");
    }
    let radius = |s| lath::space::norm(&circle.with_tension(s).unwrap().eval(0.5).unwrap());
    assert!((radius(0.0) - 33.0 * 2.0_f64.sqrt() / 48.0).abs() < 1e-15);
    // Full tension: the square of the joints. Between, the radius falls in proportion.
    assert!((radius(1.0) - 0.5_f64.sqrt()).abs() < 1e-15);
    assert!((radius(0.5) - (radius(0.0) + radius(1.0)) / 2.0).abs() < 1e-15);
}

#[test]
fn what_is_no_tension_is_refused() {
    let curve = UniformBSpline::new(3, POLYGON).unwrap();
    for s in [f64::NAN, f64::INFINITY] {
        assert_eq!(curve.with_tension(s).unwrap_err().code(), Code::Q002);
        let error = curve.with_tensions(&[0.0, 0.5, s, 1.0]).unwrap_err();
        assert_eq!((error.code(), error.index()), (Code::Q002, Some(2)));
    }
    assert_eq!(curve.with_tensions(&[0.0; 3]).unwrap_err().code(), Code::Q004);
    assert_eq!(curve.with_tensions(&[]).unwrap_err().code(), Code::Q004);
    let quadratic = UniformBSpline::new(2, POLYGON).unwrap();
    assert_eq!(quadratic.with_tension(0.5).unwrap_err().code(), Code::K006);
    assert_eq!(quadratic.with_tensions(&[0.5; 5]).unwrap_err().code(), Code::K006);
    for s in [1e302, -1e302] {
        assert_eq!(curve.with_tension(s).unwrap_err().code(), Code::P003);
        assert_eq!(curve.with_tensions(&[s; 4]).unwrap_err().code(), Code::P003);
    }
}
