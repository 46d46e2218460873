//! Input that was taken, and ended in a panic, a loop, NaN or another curve.

use crate::refused;
use lath::curve::{BSpline, Bezier, Curve, Hermite, Outside, Polyline};
use lath::error::Limits;
use lath::interpolate::{Parameters, cubic_closed, parameters, pchip};
use lath::knot::{Knots, Side};
use lath::query::length;
use lath::subdivide::{Ends, Scheme, Subdivision, Target};
use lath::tessellate::flatten;

/// lyon 414: a NaN coordinate travelled far and ended in a panic that named something else. It is refused at the door, by its index.
#[test]
fn lyon_414_nan_coordinate() {
    refused(Bezier::new([[0.0, 0.0], [1.0, f64::NAN], [2.0, 0.0]]), "P002", 1);
    refused(Polyline::new([[0.0, 0.0], [1.0, 0.0], [f64::NAN, 0.0]]), "P002", 2);
}

/// rasterize 11 and truck-geometry 0.5.0: NaN in a curve made flattening halve for ever. No curve of the library holds one; a curve of the
/// user's own that does is flattened to an end all the same.
#[test]
fn rasterize_11_nan_in_a_curve() {
    #[derive(Debug)]
    struct Hole;
    impl Curve<1> for Hole {
        fn kind(&self) -> &'static str {
            "hole"
        }
        fn degree(&self) -> usize {
            1
        }
        fn domain(&self) -> lath::curve::Interval {
            lath::curve::Interval { start: 0.0, end: 1.0 }
        }
        fn jet_into(&self, t: f64, _side: Side, out: &mut [[f64; 1]]) {
            out.fill([if t < 0.5 { t } else { f64::NAN }]);
        }
    }
    let limits = Limits { max_points: 10_000, ..Limits::default() };
    let mut count = 0;
    let outcome = flatten(&Hole, 1e-6, &limits, &mut |_, _| count += 1);
    assert!(count <= 10_000 && outcome.map_or_else(|error| error.is_budget(), |bound| !bound.is_proven()));
    refused(Hole.eval(0.75), "P003", None);
}

/// spliny: evaluation at NaN ran past the knots; splines 5.0.0: it panicked in a comparison. It is an error, whatever the policy.
#[test]
fn spliny_and_splines_evaluation_at_nan() {
    let curve = BSpline::uniform(2, [[0.0], [1.0], [0.0], [2.0]]).unwrap();
    for outside in [Outside::Error, Outside::Clamp, Outside::Extrapolate, Outside::Periodic] {
        refused(curve.eval_outside(f64::NAN, outside), "T001", None);
    }
}

/// splines 5.0.0: two keys at one time divided zero by zero and gave NaN; scipy 4304 and 22704 as well. The second is named.
#[test]
fn splines_two_keys_at_one_time() {
    let keys = [[0.0], [1.0], [2.0]];
    refused(Hermite::new(vec![0.0, 1.0, 1.0], keys, keys), "T003", 2);
    refused(pchip(keys, vec![0.0, 1.0, 1.0], false), "T003", 2);
}

/// bspline 1.1.0 and curvo 0.3.3: knots out of order were sorted without a word, which is another curve. The culprit is named.
#[test]
fn bspline_crate_and_curvo_sorted_the_knots() {
    refused(Knots::new(vec![0.0, 0.0, 2.0, 1.0, 3.0, 3.0], 1), "K004", 3);
}

/// enterpolation: the usual n + p + 1 knots were taken by another convention, so that the degree changed without an error. The degree is said,
/// and a count that does not fit it is refused, with the other convention by name.
#[test]
fn enterpolation_the_convention_of_knots_chose_the_degree() {
    let points = || [[0.0], [1.0], [2.0], [3.0]];
    assert_eq!(BSpline::over(vec![0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0], 3, points()).unwrap().degree(), 3);
    let short = BSpline::over(vec![0.0, 0.0, 0.0, 1.0, 1.0, 1.0], 3, points());
    assert!(short.clone().unwrap_err().message().contains("superfluous first and last knot"));
    refused(short, "K001", None);
}

/// bevy_curve 0.20.1 took NaN among knots, curvo 0.3.3 and bspline 1.1.0 panicked on it.
#[test]
fn bevy_curve_nan_among_the_knots() {
    refused(Knots::new(vec![0.0, 0.0, f64::NAN, 1.0, 1.0], 1), "K002", 2);
    refused(Knots::periodic(&[0.0, f64::NAN, 1.0], 1), "K002", 1);
}

/// curvo 0.3.3: degree 0 underflowed, no points panicked. Degree 0 is a curve of steps, no points are an error.
#[test]
fn curvo_degree_0_and_no_points() {
    assert_eq!(BSpline::uniform(0, [[7.0]]).unwrap().eval(0.5).unwrap(), [7.0]);
    refused(BSpline::<2>::uniform(0, [[0.0; 2]; 0]), "P001", None);
    refused(cubic_closed::<2>([[0.0; 2]; 0], vec![0.0]), "P001", None);
}

/// kurbo 0.13.1: a tolerance of 0 asked for the greatest integer of segments, an accuracy of 0 shifted beyond the width of a number;
/// lyon_geom 1.0.20 looked at tolerances in debug builds only; polylabel-rs 70 looped below 0. All are refused.
#[test]
fn kurbo_lyon_and_polylabel_70_tolerance_0() {
    let arch = Bezier::new([[0.0, 0.0], [1.0, 2.0], [2.0, 0.0]]).unwrap();
    for tolerance in [0.0, -0.0, -1.0, f64::NAN] {
        refused(flatten(&arch, tolerance, &Limits::default(), &mut |_, _| ()), "Q001", None);
        refused(length(&arch, tolerance, &Limits::default()), "Q001", None);
    }
    // As small as a double can be: beyond any budget, said before the first point.
    let never = &mut |_: f64, _: [f64; 2]| panic!("a point beyond the budget");
    refused(flatten(&arch, f64::from_bits(1), &Limits::default(), never), "B001", None);
}

/// scipy 7589: points given twice ended a fit by chord length in an internal error; csaps 39 is alike. The pair is named.
#[test]
fn scipy_7589_points_given_twice() {
    let points = [[0.0, 0.0], [1.0, 1.0], [2.0, 0.0], [2.0, 0.0]];
    refused(parameters(&points, false, Parameters::Chord), "P004", 3);
}

/// scipy 24192: a basis element over a single knot was not refused in plain words. One knot carries nothing.
#[test]
fn scipy_24192_a_single_knot() {
    refused(Knots::new(vec![0.0], 0), "K001", None);
}

/// scipy 23545: a degree of 73 was more than the code behind could take. 73 is a degree like any other, and 2³¹ is not.
#[test]
fn scipy_23545_degree_73() {
    let mut points = vec![[0.0]; 74];
    points[73] = [1.0];
    let curve = BSpline::new(Knots::clamped(74, 73).unwrap(), points).unwrap();
    assert_eq!(curve.eval(0.5).unwrap(), [libm::ldexp(1.0, -73)]);
    refused(Knots::<f64>::clamped(1 << 40, 1 << 31), "K006", None);
}

/// NURBS-Python 53: too few points for the degree failed far from the cause. Both numbers are in the message.
#[test]
fn nurbs_python_53_too_few_points_for_the_degree() {
    let error = BSpline::uniform(4, [[0.0], [1.0], [2.0]]).unwrap_err();
    assert!(error.message().contains("3 points for degree 4") && error.message().contains("at least 5"), "{error}");
    refused(BSpline::uniform(4, [[0.0], [1.0], [2.0]]), "P001", None);
}

/// ifc-lite 4980: a recursion of 2^degree calls, fed by a hostile file. The triangle has p² / 2 steps, and degrees end at 1000.
#[test]
fn ifc_lite_4980_two_to_the_degree() {
    let mut points = vec![[0.0]; 1001];
    points[0] = [1.0];
    let curve = BSpline::new(Knots::clamped(1001, 1000).unwrap(), points).unwrap();
    assert_eq!(curve.eval(0.5).unwrap(), [libm::ldexp(1.0, -1000)]);
    refused(Knots::<f64>::clamped(1002, 1001), "K006", None);
}

/// par 6 and LuxCore 373: a few more levels of subdivision took all memory. What a level would hold is counted first.
#[test]
fn par_6_levels_beyond_memory() {
    let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    let curve = Subdivision::new(Scheme::chaikin(), square, Ends::Closed).unwrap();
    for level in [33, 60, 63, 64, 1000] {
        refused(curve.level(level, Target::Level, &Limits::default()), "B001", None);
    }
    refused(curve.level(1001, Target::Level, &Limits::default()), "S005", None);
}
