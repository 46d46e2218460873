//! Wrong values and wrong derivatives.

use crate::{jet, near};
use lath::basis::bspline::{derivatives, values};
use lath::curve::{BSpline, Bezier, Curve};
use lath::knot::{Knots, Side};
use lath::query::signed_curvature;
use lath::subdivide::{Ends, Scheme, Subdivision, Target};

/// enterpolation 0.3.0: the highest derivative that was asked for came out as zero, whatever the curve; its own test
/// used 1, 2, 3, where zero is right. The control values 1, 0, 5 are 6t² − 2t + 1, so that the second derivative is 12.
#[test]
fn enterpolation_second_derivative_of_a_quadratic() {
    let curve = Bezier::new([[1.0], [0.0], [5.0]]).unwrap();
    for order in 0..4 {
        assert_eq!(jet(&curve, 0.5, order), [1.5, 4.0, 12.0, 0.0][..=order]);
    }
}

/// enterpolation 0.3.0: of 1, 0, 5, 2 at ½ it gave −3 and 0 for the second and third derivative; they are −6 and −84.
#[test]
fn enterpolation_higher_derivatives_of_a_cubic() {
    let curve = Bezier::new([[1.0], [0.0], [5.0], [2.0]]).unwrap();
    assert_eq!(jet(&curve, 0.5, 4), [2.25, 4.5, -6.0, -84.0, 0.0]);
}

/// enterpolation 0.3.0: asking for fewer derivatives than the degree indexed beyond a slice and panicked. Any number of rows is
/// filled here, none included.
#[test]
fn enterpolation_fewer_derivatives_than_the_degree() {
    let curve = Bezier::new([[1.0], [0.0], [5.0], [2.0]]).unwrap();
    assert_eq!((jet(&curve, 0.5, 0), jet(&curve, 0.5, 1)), (vec![2.25], vec![2.25, 4.5]));
    curve.jet_into(0.5, Side::Right, &mut []);
}

/// scirs2-interpolate 0.6.5: derivatives of B-splines were nested differences with a step of 1e-7, half the truth at an end
/// and noise of 1e7 for the second. The cubic 0, 1, −2, 3 has 3 at the start, 48 for the second at the end, 72 for the third.
#[test]
fn scirs2_derivatives_by_differences() {
    let knots = Knots::new(vec![0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0], 3).unwrap();
    let curve = BSpline::new(knots, [[0.0], [1.0], [-2.0], [3.0]]).unwrap();
    assert_eq!(jet(&curve, 0.0, 3), [0.0, 3.0, -24.0, 72.0]);
    assert_eq!(jet(&curve, 1.0, 3), [3.0, 15.0, 48.0, 72.0]);
    assert_eq!(jet(&curve, 0.3, 3)[3], 72.0);
}

/// kurbo 0.13.1: a note in the source asks whether the curvature's sign is right. Here a left turn, y up, is positive, and so
/// it is for y = x², 2 at its vertex; mirrored or run backwards it changes.
#[test]
fn kurbo_sign_of_the_curvature() {
    let turn = |points: [[f64; 2]; 3]| signed_curvature(&Bezier::new(points).unwrap(), 0.5, Side::Right);
    assert_eq!(turn([[-1.0, 1.0], [0.0, -1.0], [1.0, 1.0]]), Some(2.0));
    assert_eq!(turn([[1.0, 1.0], [0.0, -1.0], [-1.0, 1.0]]), Some(-2.0));
    assert_eq!(turn([[-1.0, -1.0], [0.0, 1.0], [1.0, -1.0]]), Some(-2.0));
}

/// NURBS-Python 34: where knots are equal the formula for the derivatives' control points divides zero by zero, and they blew up.
/// x³ over knots with a double one inside has the blossoms 0, 0, 0, 2, 4, 8, and every derivative of it is finite and right.
#[test]
fn nurbs_python_34_derivatives_over_repeated_knots() {
    let knots = Knots::new(vec![0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 2.0, 2.0, 2.0, 2.0], 3).unwrap();
    let cube = BSpline::new(knots, [[0.0], [0.0], [0.0], [2.0], [4.0], [8.0]]).unwrap();
    assert_eq!(jet(&cube, 1.0, 4), [1.0, 3.0, 6.0, 6.0, 0.0]);
    assert_eq!(jet(&cube, 1.5, 3), [3.375, 6.75, 9.0, 6.0]);
}

/// NURBS-Python 180: the last parameter of the domain found no span. It belongs to the last one.
#[test]
fn nurbs_python_180_the_last_knot() {
    let knots = Knots::clamped(6, 3).unwrap();
    let curve = BSpline::new(knots, [[1.0], [2.0], [0.0], [5.0], [4.0], [7.0]]).unwrap();
    assert_eq!(curve.eval(3.0).unwrap(), [7.0]);
    // The last leg of the polygon times p over its knots' distance.
    assert_eq!(jet(&curve, 3.0, 1), [7.0, 9.0]);
}

/// sympy 8474 and 12618: with repeated knots the basis functions had gaps, or were wrong beside them. Over 0, 0, 0, 1, 1, 2, 2, 2 the
/// five quadratic ones are known: at ½ they are ¼, ½, ¼, 0, 0; at 1 the third is 1 from both sides.
#[test]
fn sympy_12618_basis_over_repeated_knots() {
    let knots = Knots::new(vec![0.0, 0.0, 0.0, 1.0, 1.0, 2.0, 2.0, 2.0], 2).unwrap();
    let at = |t: f64, side: Side| {
        let span = knots.span(&t, side);
        let mut all = [0.0; 5];
        all[span - 2..=span].copy_from_slice(&values(&knots, span, &t));
        all
    };
    assert_eq!(at(0.5, Side::Right), [0.25, 0.5, 0.25, 0.0, 0.0]);
    assert_eq!(at(1.5, Side::Right), [0.0, 0.0, 0.25, 0.5, 0.25]);
    assert_eq!([at(1.0, Side::Left), at(1.0, Side::Right)], [[0.0, 0.0, 1.0, 0.0, 0.0]; 2]);
}

/// scipy 4343: degrees above 20 crashed the compiled code. At degree 25 the Bernstein polynomials over one span are exact at ½:
/// C(25, i)/2²⁵.
#[test]
fn scipy_4343_degrees_above_20() {
    let knots = Knots::clamped(26, 25).unwrap();
    let found = values(&knots, 25, &0.5);
    let mut binomial = 1.0;
    for (i, value) in found.iter().enumerate() {
        near(*value * libm::ldexp(1.0, 25), binomial, binomial);
        binomial = binomial * (25 - i) as f64 / (i + 1) as f64;
    }
    assert!(derivatives(&knots, 25, &0.5, 25).iter().flatten().all(|d| d.is_finite()));
}

/// splinosaurus 0.2.2: knots were integers, and the search for the span mixed knots with indices. Over 0, ¼, 1 the quadratic 1, 2, 4, 8
/// at ¼ is the mean of its two middle points by distance: 2·¾ + 4·¼.
#[test]
fn splinosaurus_knots_that_are_no_integers() {
    let knots = Knots::new(vec![0.0, 0.0, 0.0, 0.25, 1.0, 1.0, 1.0], 2).unwrap();
    let curve = BSpline::new(knots, [[1.0], [2.0], [4.0], [8.0]]).unwrap();
    assert_eq!([0.0, 0.25, 1.0].map(|t| curve.eval(t).unwrap()[0]), [1.0, 2.5, 8.0]);
}

/// truck-geometry 0.5.0 (truck 105): the domain of knots that are not clamped was their whole range, where the functions do not sum
/// to 1. It is [t_p, t_n], and there they do.
#[test]
fn truck_105_the_domain_of_unclamped_knots() {
    let curve = BSpline::uniform(3, [[1.0]; 5]).unwrap();
    assert_eq!((curve.knots().values()[0], curve.knots().values()[8]), (-3.0, 5.0));
    assert_eq!((curve.domain().start, curve.domain().end), (0.0, 2.0));
    for k in 0..=16 {
        near(curve.eval(f64::from(k) / 8.0).unwrap()[0], 1.0, 1.0);
    }
    assert_eq!([-0.5, 2.5].map(|t| curve.eval(t).unwrap_err().code().as_str()), ["T002"; 2]);
}

/// OpenSubdiv 1030: second derivatives of the limit were zero where tables were uniform. The cubic scheme's are P₀ − 2P₁ + P₂.
#[test]
fn opensubdiv_1030_second_derivatives_of_the_limit() {
    let scheme = Scheme::<f64>::cubic();
    assert_eq!(scheme.limit_mask(2).unwrap(), [1.0, -2.0, 1.0]);
    let polygon = [[0.0], [1.0], [4.0], [9.0], [16.0]];
    let curve = Subdivision::new(scheme, polygon, Ends::Open).unwrap().curve().unwrap();
    for t in [0.0, 0.5, 1.0, 2.0] {
        near(jet(&curve, t, 2)[2], 2.0, 16.0);
    }
}

/// geo 0.33.1: its Chaikin keeps the ends of an open line and cuts beside them, which is no B-spline at its ends. The open rule retreats
/// to quarters and tends to the quadratic B-spline; who wants the ends kept counts them twice, and gets one that starts there.
#[test]
fn geo_chaikin_of_an_open_line() {
    let line = || [[0.0], [4.0], [0.0]];
    let level =
        |ends| Subdivision::new(Scheme::chaikin(), line(), ends).unwrap().level(1, Target::Level, &<_>::default());
    assert_eq!(level(Ends::Open).unwrap(), [[1.0], [3.0], [3.0], [1.0]]);
    let limit = Subdivision::new(Scheme::<f64>::chaikin(), line(), Ends::Open).unwrap().curve().unwrap();
    assert_eq!([0.0, 0.5, 1.0].map(|t| limit.eval(t).unwrap()[0]), [2.0, 3.0, 2.0]);
    let kept = Subdivision::new(Scheme::<f64>::chaikin(), line(), Ends::Kept).unwrap().curve().unwrap();
    assert_eq!((kept.eval(0.0).unwrap(), kept.eval(kept.domain().end).unwrap()), ([0.0], [0.0]));
}
