//! Rows 1 to 12: numbers.

use crate::{every_taker, near, refused};
use lath::basis::bspline::values;
use lath::curve::{BSpline, Bezier, Curve, Interval, Outside};
use lath::error::Limits;
use lath::interpolate::{End, Ends, Parameters, cubic, parameters};
use lath::knot::{Knots, Side};
use lath::query::{curvature, length, signed_curvature};
use lath::space::IntoPoint;

/// Points of which the third has this coordinate.
fn with(x: f64) -> [[f64; 2]; 5] {
    [[0.0, 0.0], [1.0, 2.0], [2.0, x], [3.0, 1.0], [4.0, 4.0]]
}

#[track_caller]
fn all_refuse(points: &[[f64; 2]], code: &str, index: usize) {
    for (taker, answer) in every_taker(points) {
        let error = answer.expect_err(taker);
        assert_eq!((error.code().as_str(), error.index()), (code, Some(index)), "{taker}: {error}");
    }
    assert!(every_taker(&with(0.5)).iter().all(|(_, answer)| answer.is_ok()));
}

#[test]
fn row_01_nan_coordinate() {
    all_refuse(&with(f64::NAN), "P002", 2);
    let slope = Ends::Open(End::Clamped([f64::NAN]), End::Natural);
    refused(cubic([[0.0], [1.0]], vec![0.0, 1.0], &slope), "P002", 0);
}

#[test]
fn row_02_infinite_coordinate() {
    all_refuse(&with(f64::INFINITY), "P002", 2);
    all_refuse(&with(f64::NEG_INFINITY), "P002", 2);
}

#[test]
fn row_03_parameter_that_is_no_number() {
    let curve = BSpline::uniform(3, with(0.0)).unwrap();
    for t in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        refused(curve.eval(t), "T001", None);
        refused(curve.jet(t, 2), "T001", None);
        for outside in [Outside::Error, Outside::Clamp, Outside::Extrapolate, Outside::Periodic] {
            refused(curve.eval_outside(t, outside), "T001", None);
        }
    }
    // The unchecked work-horse passes NaN on, and questions have no answer.
    let mut jet = [[0.0; 2]; 3];
    curve.jet_into(f64::NAN, Side::Right, &mut jet);
    assert!(jet[0].iter().all(|x| x.is_nan()), "{jet:?}");
    assert_eq!(curvature(&curve, f64::NAN, Side::Right), None);
    assert_eq!(signed_curvature(&curve, f64::NAN, Side::Left), None);
}

#[test]
fn row_04_knot_that_is_no_number() {
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        refused(Knots::new(vec![0.0, 0.0, bad, 1.0, 1.0], 1), "K002", 2);
        refused(Knots::periodic(&[0.0, bad, 2.0], 2), "K002", 1);
        refused(BSpline::over(vec![0.0, 0.0, 1.0, bad], 1, [[0.0], [1.0]]), "K002", 3);
        refused(Bezier::on([[0.0]], Interval { start: 0.0, end: bad }), "T001", 1);
        refused(parameters(&with(0.0), false, Parameters::Given(&[0.0, 1.0, 2.0, bad, 4.0])), "T001", 3);
    }
}

#[test]
fn row_05_negative_zero_is_zero() {
    let points = [[1.0], [2.0], [4.0]];
    let mixed = BSpline::new(Knots::new(vec![0.0, -0.0, 0.0, 1.0, 1.0, 1.0], 2).unwrap(), points).unwrap();
    assert_eq!((mixed.knots().multiplicity(&0.0), mixed.knots().breaks().len()), (3, 2));
    for (zero, t) in [(0.0, 0.0), (-0.0, 0.0), (0.25, 0.25)] {
        assert_eq!(mixed.eval(zero).unwrap(), Bezier::new(points).unwrap().eval(t).unwrap());
    }
    refused(parameters(&[[0.0], [1.0]], false, Parameters::Given(&[-0.0, 0.0])), "T003", 1);
}

#[test]
fn row_06_subnormal_numbers() {
    let tiny = f64::from_bits(1);
    let curve = Bezier::new([[tiny * 2.0], [tiny * 4.0], [tiny * 6.0]]).unwrap();
    assert_eq!(curve.eval(0.5).unwrap(), [tiny * 4.0]);
    assert_eq!(parameters(&[[0.0], [tiny * 7.0]], false, Parameters::Chord).unwrap(), [0.0, tiny * 7.0]);
    // Knots a few subnormals apart: the line from 0 to 8 over 8 steps is exact at every one of them.
    let line = BSpline::over(vec![0.0, 0.0, tiny * 8.0, tiny * 8.0], 1, [[0.0], [8.0]]).unwrap();
    let knots = Knots::new([0.0, 0.0, 0.0, 3.0, 8.0, 8.0, 8.0].map(|k| k * tiny).to_vec(), 2).unwrap();
    for k in 0..=8 {
        let t = tiny * f64::from(k);
        assert_eq!(line.eval(t).unwrap(), [f64::from(k)]);
        let functions = values(&knots, knots.span(&t, Side::Right), &t);
        assert!(functions.iter().all(|b| *b >= 0.0), "{functions:?}");
        near(functions.iter().sum(), 1.0, 16.0, 1.0);
    }
    // Its slope, 1/tiny, is beyond all numbers, and is refused rather than infinite.
    refused(line.jet(0.0, 1), "P003", None);
}

#[test]
fn row_07_squares_that_overflow_or_underflow() {
    // y = x² on [−1, 1]: curvature 2 at the vertex, length √5 + asinh(2)/2; powers of two scale without rounding.
    let exact = 5_f64.sqrt() + libm::asinh(2.0) / 2.0;
    for exponent in [-900, -500, 0, 500, 900] {
        let scale = libm::ldexp(1.0, exponent);
        let curve = Bezier::new([[-1.0, 1.0], [0.0, -1.0], [1.0, 1.0]].map(|p| p.map(|x| x * scale))).unwrap();
        assert_eq!(curvature(&curve, 0.5, Side::Right), Some(2.0 / scale));
        assert_eq!(signed_curvature(&curve, 0.5, Side::Right), Some(2.0 / scale));
        let (found, bound) = length(&curve, 1e-6 * scale, &Limits::default()).unwrap();
        assert!(bound.is_proven() && bound.value() <= 1e-6 * scale);
        assert!((found / scale - exact).abs() <= 1e-6, "{found}");
        let square = [[0.0, 0.0], [scale, 0.0], [scale, scale], [0.0, scale]];
        assert_eq!(parameters(&square, true, Parameters::Chord).unwrap(), [0.0, 1.0, 2.0, 3.0, 4.0].map(|t| t * scale));
    }
}

#[test]
fn row_08_coordinates_whose_differences_overflow() {
    for x in [f64::MAX, -f64::MAX, 1e308, 1.1e300] {
        all_refuse(&with(x), "P003", 2);
    }
    assert!(Bezier::new(with(1e300)).is_ok());
    // What overflows although the input is in scale is refused with the same code.
    let steep = Ends::Open(End::NotAKnot, End::NotAKnot);
    refused(cubic([[0.0], [1e300], [0.0]], vec![0.0, 1e-10, 1.0], &steep), "P003", 0);
    let curve = Bezier::on([[-1e300], [1e300]], Interval { start: 0.0, end: 1e-10 }).unwrap();
    assert_eq!(curve.eval(0.0).unwrap(), [-1e300]);
    refused(curve.jet(0.0, 1), "P003", None);
}

#[test]
fn row_09_small_detail_far_from_zero() {
    // Detail of 2⁻¹⁰ at 10⁷: every number is exact, and so is the curve.
    let far = |x: f64| 1e7 + x / 1024.0;
    let curve = Bezier::new([far(0.0), far(1.0), far(0.0)].map(|x| [x])).unwrap();
    assert_eq!(curve.jet(0.5, 2).unwrap(), [[far(0.5)], [0.0], [-4.0 / 1024.0]]);
    // Through points of a parabola: y = k² / 1024, its derivatives not spoiled by the offset.
    let points = [0.0, 1.0, 4.0, 9.0, 16.0].map(|x| [far(x)]);
    let t = (0..5).map(f64::from).collect();
    let curve = cubic(points, t, &Ends::Open(End::NotAKnot, End::NotAKnot)).unwrap();
    let jet = curve.jet(1.5, 2).unwrap();
    near(jet[0][0], far(2.25), 4.0, 1e7);
    near(jet[1][0], 3.0 / 1024.0, 64.0, 1.0 / 64.0);
    near(jet[2][0], 2.0 / 1024.0, 64.0, 1.0 / 64.0);
}

#[test]
fn row_11_single_precision_is_widened_and_nothing_else() {
    let narrow = [[0.1_f32, 16_777_217.0], [1e-45, 3.4e38]];
    assert_eq!(narrow[0].into_point(), [f64::from(0.1_f32), 16_777_216.0]);
    let curve = Bezier::new(narrow).unwrap();
    let wide = narrow.map(|p| p.map(f64::from));
    assert_eq!(curve.control_points(), wide);
    // The same bits as from the widened points, and not those of arithmetic in single precision.
    let at = curve.eval(0.3).unwrap();
    assert_eq!(at, Bezier::new(wide).unwrap().eval(0.3).unwrap());
    assert!(at[0] != f64::from(at[0] as f32), "{at:?}");
}
