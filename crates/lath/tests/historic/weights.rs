//! Weights.

use crate::{near, refused};
use lath::curve::{BSpline, Curve, Nurbs, RationalBezier};
use lath::error::Limits;
use lath::query::{Continuity, continuity, length};

/// curvo 0.3.3: a weight of 0 at a control point ended in a panic, in `point_at` and in `is_closed`. Inside it is a point that has no part in the
/// curve; where it alone makes the curve it is refused, with the place.
#[test]
fn curvo_a_weight_of_zero() {
    let points = [[0.0, 0.0], [1.0, 2.0], [3.0, 2.0], [4.0, 0.0]];
    let curve = BSpline::clamped(3, points).unwrap().weighted([1.0, 0.0, 1.0, 1.0]).unwrap();
    assert!(!curve.is_closed());
    // (0 + 3·3 + 4)/(1 + 3 + 1) and (3·2)/5.
    let [x, y] = curve.eval(0.5).unwrap();
    near(x, 13.0 / 5.0, 4.0);
    near(y, 6.0 / 5.0, 2.0);
    refused(BSpline::clamped(3, points).unwrap().weighted([0.0, 1.0, 1.0, 1.0]), "R004", None);
}

/// bevy_curve 0.19: NaN and zero weights were taken. The culprit is named.
#[test]
fn bevy_curve_weights_that_are_nan_or_all_zero() {
    let spline = BSpline::clamped(3, [[0.0], [1.0], [2.0], [3.0]]).unwrap();
    refused(spline.clone().weighted([1.0, 1.0, f64::NAN, 1.0]), "R001", 2);
    refused(spline.clone().weighted([1.0, f64::INFINITY, 1.0, 1.0]), "R001", 1);
    refused(spline.clone().weighted([0.0; 4]), "R004", None);
    refused(spline.weighted([1.0; 3]), "R003", None);
}

/// Kratos 8841: weights were given and not used. A circle is round.
#[test]
fn kratos_8841_weights_that_are_ignored() {
    let quarter = RationalBezier::new([[1.0, 0.0], [1.0, 1.0], [0.0, 1.0]], [1.0, 1.0, 2.0]).unwrap();
    assert_eq!(quarter.eval(0.5).unwrap(), [0.6, 0.8]);
    assert_ne!(quarter.unweighted().eval(0.5).unwrap(), [0.6, 0.8]);
    let (found, bound) = length(&quarter, 1e-9, &Limits::default()).unwrap();
    assert!((found - std::f64::consts::FRAC_PI_2).abs() <= bound.value() && bound.value() <= 1e-9);
}

/// NURBS-Python 34: derivative formulas divided 0 by 0 over repeated knots. Those of a rational curve are one-sided there.
#[test]
fn nurbs_python_34_rational_derivatives_over_repeated_knots() {
    let circle = Nurbs::circle([0.0, 0.0], 1.0).unwrap();
    let joint = circle.breaks()[1];
    let slope = circle.jet(joint, 2).unwrap();
    // At the top the circle runs to the left, and bends down: speed √2·2/π for the angle as parameter, curvature 1.
    let speed = std::f64::consts::SQRT_2 * 2.0 / std::f64::consts::PI;
    near(slope[1][0], -speed, 1.0);
    near(slope[1][1], 0.0, 1.0);
    near(slope[2][1], -speed * speed, 1.0);
    assert_eq!(continuity(&circle)[0].1, Continuity::Order(1));
}
