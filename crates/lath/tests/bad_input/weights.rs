//! Rows 53 to 56: weights.

use crate::refused;
use lath::curve::{BSpline, Bezier, Curve, RationalBezier};
use lath::error::{Limits, Result};
use lath::query::{bounds, length};
use lath::space::norm;

const ARCH: [[f64; 2]; 3] = [[0.0, 0.0], [1.0, 2.0], [2.0, 0.0]];

fn arch(weights: [f64; 3]) -> Result<RationalBezier<2>> {
    RationalBezier::new(ARCH, weights)
}

#[test]
fn row_53_a_weight_of_zero() {
    let flat = arch([1.0, 0.0, 1.0]).unwrap();
    assert_eq!([0.0, 0.5, 1.0].map(|t| flat.eval(t).unwrap()), [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0]]);
    assert_eq!(flat.jet(0.0, 1).unwrap()[1], [0.0, 0.0]);
    let error = refused(arch([0.0, 1.0, 1.0]), "R004", None);
    assert!(error.message().contains("[0, 0]"), "{error}");
    // Where one function is alone at a knot inside.
    let knots = vec![0.0, 0.0, 0.0, 1.0, 1.0, 2.0, 2.0, 2.0];
    let spline = BSpline::over(knots, 2, [[0.0], [1.0], [2.0], [3.0], [4.0]]).unwrap();
    let error = refused(spline.clone().weighted([1.0, 1.0, 0.0, 1.0, 1.0]), "R004", None);
    assert!(error.message().contains("[1, 1]"), "{error}");
    assert_eq!(spline.weighted([1.0, 0.0, 1.0, 0.0, 1.0]).unwrap().eval(1.0).unwrap(), [2.0]);
}

#[test]
fn row_54_a_negative_weight() {
    let outside = arch([1.0, -0.5, 1.0]).unwrap();
    assert_eq!(outside.eval(0.5).unwrap(), [1.0, -2.0]);
    // The box and the length of what leaves its hull are proven all the same.
    let (found, bound) = bounds(&outside);
    assert!(bound.is_proven() && (found.lo[1] + 2.0).abs() < 1e-10, "{found:?}");
    let (found, bound) = length(&outside, 1e-6, &Limits::default()).unwrap();
    let steps: f64 = (0..10_000)
        .map(|k| {
            let at = |k: i32| outside.eval(f64::from(k) / 1e4).unwrap();
            let (a, b) = (at(k), at(k + 1));
            norm(&[b[0] - a[0], b[1] - a[1]])
        })
        .sum();
    assert!(bound.is_proven() && (found - steps).abs() < 1e-5, "{found} {steps}");
    assert_eq!(
        arch([-1.0, -2.0, -1.0]).unwrap().eval(0.25).unwrap(),
        arch([1.0, 2.0, 1.0]).unwrap().eval(0.25).unwrap()
    );
}

#[test]
fn row_55_weights_whose_denominator_vanishes() {
    refused(arch([0.0; 3]), "R004", None);
    // (1 − 2u)², twice beside 1/2, and once: a polynomial of both signs.
    refused(arch([1.0, -1.0, 1.0]), "R004", None);
    refused(arch([1.0, -3.0, 1.0]), "R004", None);
    refused(arch([1.0, 0.0, -1.0]), "R004", None);
    // A pole in one span of many names it.
    let spline = BSpline::clamped(2, (0..12).map(|i| [f64::from(i)])).unwrap();
    let mut weights = vec![1.0; 12];
    weights[6] = -2.0;
    let error = refused(spline.weighted(weights), "R004", None);
    assert!(error.message().contains("in [4, 4]") || error.message().contains("in [5"), "{error}");
    // High degree ends all the same.
    let wild = (0..400).map(|i| if i % 2 == 0 { 1.0 } else { -0.999_999 });
    refused(Bezier::new(vec![[0.0]; 400]).unwrap().weighted(wild), "R004", None);
}

#[test]
fn row_56_weights_from_1e_300_to_1e300() {
    for weights in [[1e-300; 3], [1e300; 3], [5e-324; 3]] {
        let (found, plain) = (arch(weights).unwrap(), Bezier::new(ARCH).unwrap());
        for t in [0.0, 0.3, 0.5, 1.0] {
            let (a, b) = (found.jet(t, 2).unwrap(), plain.jet(t, 2).unwrap());
            assert!(a.as_flattened().iter().zip(b.as_flattened()).all(|(x, y)| (x - y).abs() < 1e-14), "{a:?} {b:?}");
        }
    }
    let mixed = arch([1e-300, 1.0, 1e300]).unwrap();
    // At u = 1e-150 the shares are 1e-300, 2e-150, 1: the third point has all; at 1e-300 they are 1, 2 and 1.
    let [x, y] = mixed.eval(1e-150).unwrap();
    assert!(x == 2.0 && (y / 4e-150 - 1.0).abs() < 1e-14, "{x} {y:e}");
    let middle = mixed.eval(1e-300).unwrap();
    assert!((middle[0] - 1.0).abs() < 1e-14 && (middle[1] - 1.0).abs() < 1e-14, "{middle:?}");
    let (found, bound) = bounds(&mixed);
    assert!(bound.is_proven() && (found.hi[1] - 1.0).abs() < 1e-3 && found.hi[1] >= 1.0 - 1e-12, "{found:?} {bound:?}");
}
