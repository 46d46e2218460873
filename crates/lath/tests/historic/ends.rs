//! Ends, closing, and what lies outside.

use crate::{jet, near, refused};
use lath::curve::{BSpline, Bezier, Curve, Outside};
use lath::interpolate::{End, Ends, Parameters, bspline_closed, catmull_rom, cubic, cubic_closed, parameters};
use lath::knot::Knots;
use lath::query::{Continuity, continuity};

const SQUARE: [[f64; 2]; 4] = [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]];

/// scirs2-interpolate 0.6.5: the corner terms of the periodic system were dropped, and a natural spline came out. Through the corners of
/// a square the closed spline's slopes are 3/2 at right angles by symmetry, and the second derivatives are not zero.
#[test]
fn scirs2_periodic_spline_was_natural() {
    let curve = cubic_closed(SQUARE, vec![0.0, 1.0, 2.0, 3.0, 4.0]).unwrap();
    let exact = [[0.0, 1.5], [-1.5, 0.0], [0.0, -1.5], [1.5, 0.0]];
    for (found, exact) in curve.tangents().iter().flatten().zip(exact.iter().flatten()) {
        near(*found, *exact, 1.5);
    }
    // On the first piece x″(0) = 6(0 − 1) − 2(2·0 + (−3/2)).
    near(curve.jet(0.0, 2).unwrap()[2][0], -3.0, 3.0);
}

/// FreeCAD 9741 (and tinyspline 39 and 111, where users repeat the data five times): a periodic interpolation that was not quite
/// periodic. Here no place is special: data turned by one point give the same curve turned, and the seam is C² like any joint.
#[test]
fn freecad_9741_periodic_but_not_quite() {
    let points = [[0.0, 0.0], [2.0, 1.0], [3.0, 3.0], [1.0, 4.0], [-1.0, 2.0]];
    let turned: Vec<[f64; 2]> = (0..5).map(|i| points[(i + 1) % 5]).collect();
    let t = || (0..6).map(f64::from).collect::<Vec<f64>>();
    let (curve, other) = (cubic_closed(points, t()).unwrap(), cubic_closed(turned, t()).unwrap());
    for k in 0..40 {
        let t = f64::from(k) / 8.0;
        let (a, b) = (curve.jet((t + 1.0) % 5.0, 2).unwrap(), other.jet(t, 2).unwrap());
        a.iter().flatten().zip(b.iter().flatten()).for_each(|(a, b)| near(*a, *b, 32.0));
    }
    assert!(continuity(&curve).iter().all(|(_, order)| *order >= Continuity::Order(2)));
    let quintic = bspline_closed(points, t(), 5).unwrap();
    assert!(continuity(&quintic).iter().all(|(_, order)| *order >= Continuity::Order(4)));
}

/// cubic-splines and rsl-interpolation: periodic ends were left out, or panicked above three points. Any number from two on is closed here.
#[test]
fn rsl_interpolation_periodic_ends_above_three_points() {
    for n in 2..=9 {
        let points: Vec<[f64; 1]> = (0..n).map(|i| [f64::from(i * i % 5)]).collect();
        let curve = cubic_closed(points.clone(), (0..=n).map(f64::from).collect()).unwrap();
        let (start, end) = (jet(&curve, 0.0, 2), jet(&curve, f64::from(n), 2));
        start.iter().zip(&end).for_each(|(a, b)| near(*a, *b, 64.0));
        assert!((0..n).all(|i| curve.eval(f64::from(i)).unwrap() == points[i as usize]));
    }
}

/// ndarray-interp: periodic ends were refused when the first and the last value differ by rounding. Here cyclic ends say that the
/// derivatives agree, and leave the values alone.
#[test]
fn ndarray_interp_periodic_values_that_differ_by_rounding() {
    let values = [[0.1 + 0.2], [1.0], [-1.0], [0.3]];
    assert!(values[0] != values[3]);
    let curve = cubic(values, vec![0.0, 1.0, 2.0, 3.0], &Ends::Cyclic).unwrap();
    let (start, end) = (jet(&curve, 0.0, 2), jet(&curve, 3.0, 2));
    start[1..].iter().zip(&end[1..]).for_each(|(a, b)| near(*a, *b, 16.0));
}

/// splines 5.0.0 (and 9, 36): Catmull-Rom had no value on the first and last span, nor at the last key, even when clamped. The whole
/// domain is answered, its ends included, and beyond it by a policy.
#[test]
fn splines_36_catmull_rom_on_the_first_and_last_span() {
    let curve = catmull_rom([[0.0], [1.0], [4.0], [9.0]], vec![0.0, 1.0, 2.0, 3.0], false).unwrap();
    for k in 0..=12 {
        let t = f64::from(k) / 4.0;
        near(curve.eval(t).unwrap()[0], t * t, 9.0);
    }
    assert_eq!([-1.0, 4.0].map(|t| curve.eval_outside(t, Outside::Clamp).unwrap()), [[0.0], [9.0]]);
}

/// bspline 1.1.0: above the domain it extrapolated without a word, below it an index underflowed. Both are errors unless a policy says
/// otherwise.
#[test]
fn bspline_crate_outside_the_domain() {
    let curve = BSpline::over(vec![0.0, 0.0, 0.0, 1.0, 1.0, 1.0], 2, [[0.0], [0.0], [1.0]]).unwrap();
    for t in [-1.0, 2.0] {
        refused(curve.eval(t), "T002", None);
        assert_eq!(curve.eval_outside(t, Outside::Extrapolate).unwrap(), [t * t]);
    }
}

/// scipy 16448: who evaluates knots that are not clamped over their whole range takes the extrapolation for a wrong result. The domain
/// is named in the error.
#[test]
fn scipy_16448_extrapolation_taken_for_a_result() {
    let curve = BSpline::over((0..8).map(f64::from).collect(), 3, [[0.0], [6.0], [6.0], [0.0]]).unwrap();
    assert_eq!([3.0, 4.0].map(|t| curve.eval(t).unwrap()), [[5.0]; 2]);
    let error = curve.eval(1.0).unwrap_err();
    assert!(error.code().as_str() == "T002" && error.message().contains("[3, 4]"), "{error}");
}

/// scipy 25381: the side of steps of degree 0 was not said. Right-continuous, and left-continuous at the end.
#[test]
fn scipy_25381_the_side_of_a_step() {
    let steps = BSpline::uniform(0, [[1.0], [2.0]]).unwrap();
    assert_eq!([0.0, 1.0, 2.0].map(|t| steps.eval(t).unwrap()), [[1.0], [2.0], [2.0]]);
}

/// casadi 2202 and 2547: two points crashed, or gave NaN. They give the line.
#[test]
fn casadi_2547_two_points() {
    let t = parameters(&[[1.0, 1.0], [4.0, 5.0]], false, Parameters::Chord).unwrap();
    assert_eq!(t, [0.0, 5.0]);
    let line = cubic([[1.0, 1.0], [4.0, 5.0]], t, &Ends::Open(End::NotAKnot, End::NotAKnot)).unwrap();
    let jet = line.jet(2.5, 2).unwrap();
    jet.iter().flatten().zip([2.5, 3.0, 0.6, 0.8, 0.0, 0.0]).for_each(|(a, b)| near(*a, b, 4.0));
}

/// BSplineKit 70: each end wanted a condition of its own. Clamped with slope 1 and natural over 0, 1, 0: the inner and last slopes follow from
/// 1 + 4m₁ + m₂ = 0 and m₁ + 2m₂ = −3 as 1/7 and −11/7.
#[test]
fn bsplinekit_70_another_condition_at_each_end() {
    let ends = Ends::Open(End::Clamped([1.0]), End::Natural);
    let curve = cubic([[0.0], [1.0], [0.0]], vec![0.0, 1.0, 2.0], &ends).unwrap();
    curve.tangents().iter().zip([1.0, 1.0 / 7.0, -11.0 / 7.0]).for_each(|(m, exact)| near(m[0], exact, 1.0));
}

/// NURBS-Python 26: knots by adding up a step were one too few or one too many. Here they are counted, and integers.
#[test]
fn nurbs_python_26_knots_by_accumulation() {
    for degree in 1..=7 {
        for n in degree + 1..=60 {
            let knots = Knots::<f64>::clamped(n, degree).unwrap();
            assert_eq!((knots.values().len(), knots.functions()), (n + degree + 1, n));
            assert_eq!(knots.domain(), (0.0, (n - degree) as f64));
        }
    }
}

/// NURBS-Python 120: the knots of curves through points leaned towards zero, and so did a hump. Parameters that are mirrored give knots
/// that are mirrored.
#[test]
fn nurbs_python_120_knots_that_lean() {
    let t = [0.0, 1.0, 3.0, 4.0, 8.0, 9.0, 16.0];
    let mirrored: Vec<f64> = t.iter().rev().map(|t| 16.0 - t).collect();
    for degree in 1..=6 {
        let knots = Knots::from_data(&t, degree).unwrap();
        let other = Knots::from_data(&mirrored, degree).unwrap();
        assert!(knots.values().iter().rev().map(|t| 16.0 - t).eq(other.values().iter().copied()), "degree {degree}");
    }
}

/// splinepy 298: knots down to C⁻¹ were wanted and refused. A knot of multiplicity p + 1 inside breaks the curve, and both ends of the gap
/// are on it.
#[test]
fn splinepy_298_a_knot_that_breaks_the_curve() {
    let knots = Knots::new(vec![0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 2.0, 2.0, 2.0], 2).unwrap();
    let curve = BSpline::new(knots, [[0.0], [1.0], [0.0], [5.0], [6.0], [5.0]]).unwrap();
    assert_eq!(continuity(&curve), [(1.0, Continuity::Jump)]);
    assert_eq!([0.5, 1.0, 1.5].map(|t| curve.eval(t).unwrap()), [[0.5], [5.0], [5.5]]);
}

/// sverchok 3529: questions at the very ends of a domain failed. Ends that no double hits by adding a length are ends all the same.
#[test]
fn sverchok_3529_the_ends_of_the_domain() {
    let domain = lath::curve::Interval { start: 0.1, end: 0.7 };
    let curve = Bezier::on([[3.0], [1.0], [4.0]], domain).unwrap();
    assert_eq!([0.1, 0.7].map(|t| curve.eval(t).unwrap()), [[3.0], [4.0]]);
    refused(curve.eval(f64::from_bits(0.7_f64.to_bits() + 1)), "T002", None);
}
