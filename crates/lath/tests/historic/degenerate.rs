//! Points that coincide, curves that are points, numbers at the edge.

use crate::{near, refused};
use lath::basis::bspline::values;
use lath::curve::{BSpline, Bezier, Curve, Interval};
use lath::error::Limits;
use lath::interpolate::{End, Ends, Parameters, cubic, parameters};
use lath::knot::{Knots, Side};
use lath::query::{bounds, curvature, length, signed_curvature};
use lath::tessellate::flatten;

/// kurbo 0.13.1: the length of a quadratic whose points are all equal was NaN. It is 0, in any degree and place.
#[test]
fn kurbo_length_of_a_point() {
    for degree in 0..6 {
        let point = Bezier::new(vec![[0.1, 1e7]; degree + 1]).unwrap();
        assert_eq!(length(&point, 1e-9, &Limits::default()).unwrap().0, 0.0);
    }
}

/// kurbo 0.13.1: the curvature at a cusp was NaN. It has none there, and the answer says so.
#[test]
fn kurbo_curvature_at_a_cusp() {
    let cusp = Bezier::new([[0.0, 0.0], [1.0, 1.0], [0.0, 1.0], [1.0, 0.0]]).unwrap();
    assert_eq!(cusp.jet(0.5, 1).unwrap()[1], [0.0, 0.0]);
    assert_eq!(curvature(&cusp, 0.5, Side::Right), None);
    assert_eq!(signed_curvature(&cusp, 0.5, Side::Left), None);
}

/// kurbo 607: a sweep over degenerate curves found more than forty overflows, crashes and NaNs. The same sweep here: every cubic on a line
/// with control points among these, through every question, without a panic, without a number that is not finite.
#[test]
fn kurbo_607_a_sweep_of_degenerate_curves() {
    let tiny = f64::from_bits(1);
    let numbers = [0.0, -0.0, tiny, -1e-160, 1.0, 1.0 + f64::EPSILON, -1e160, 1e300];
    let limits = Limits { max_points: 200, ..Limits::default() };
    for code in 0..numbers.len().pow(4) {
        let number = |place: u32| numbers[code / numbers.len().pow(place) % numbers.len()];
        let points = [0, 1, 2, 3].map(|i| [number(i), number(3 - i)]);
        let size = points.as_flattened().iter().fold(tiny, |most: f64, x| most.max(x.abs()));
        let accuracy = (size * 1e-2).max(tiny);
        let curve = Bezier::new(points).unwrap();
        for t in [0.0, 0.25, 0.5, 1.0] {
            let point = curve.eval(t).unwrap();
            assert!(point.iter().all(|x| x.abs() <= size * (1.0 + 1e-15)), "{points:?}: {point:?}");
            assert!(curve.jet(t, 3).unwrap().iter().flatten().all(|x| x.is_finite()));
            assert!(curvature(&curve, t, Side::Right).is_none_or(f64::is_finite));
            assert!(signed_curvature(&curve, t, Side::Right).is_none_or(f64::is_finite));
        }
        let (found, bound) = bounds(&curve);
        assert!(found.lo.iter().chain(&found.hi).all(|x| x.is_finite()) && bound.value() >= 0.0, "{points:?}");
        let (found, bound) = length(&curve, accuracy, &limits).unwrap();
        assert!(found.is_finite() && found <= 6.0 * size && bound.value().is_finite(), "{points:?}: {found}");
        let sink = &mut |_: f64, p: [f64; 2]| assert!(p.iter().all(|x| x.is_finite()));
        match flatten(&curve, accuracy, &limits, sink) {
            Ok(bound) => assert!(bound.value() <= accuracy, "{points:?}"),
            Err(error) => assert!(error.is_budget(), "{points:?}: {error}"),
        }
    }
}

/// curvo 0.3.3: a curve of coinciding points divided by zero. Where parameters do not hang on distances it is a point; where they do, the
/// pair is named.
#[test]
fn curvo_all_points_coincide() {
    let points = [[2.0, 5.0]; 5];
    let t = parameters(&points, false, Parameters::Uniform).unwrap();
    let curve = cubic(points, t, &Ends::Open(End::Natural, End::Natural)).unwrap();
    assert!(curve.tangents().iter().all(|m| *m == [0.0, 0.0]));
    for rule in [Parameters::Chord, Parameters::Centripetal] {
        refused(parameters(&points, false, rule), "P004", 1);
    }
}

/// geomcore: two data points closer than 1e-7 were refused, whatever the unit. Closeness is relative here: a curve of the size of 1e-9 is as
/// good as any.
#[test]
fn geomcore_an_absolute_threshold() {
    let points = [[0.0, 0.0], [3e-9, 4e-9], [6e-9, 0.0]];
    let t = parameters(&points, false, Parameters::Chord).unwrap();
    near(t[1], 5e-9, 5e-9);
    let curve = cubic(points, t.clone(), &Ends::Open(End::NotAKnot, End::NotAKnot)).unwrap();
    assert!((0..3).all(|i| curve.eval(t[i]).unwrap() == points[i]));
}

/// geomcore: derivatives up to order 0 panicked. They are the point.
#[test]
fn geomcore_derivatives_of_order_0() {
    let curve = BSpline::uniform(2, [[0.0], [2.0], [4.0]]).unwrap();
    assert_eq!(curve.jet(0.5, 0).unwrap(), [[2.0]]);
}

/// sverchok 5296: knots that are nearly equal made curves explode. Two knots one step apart keep the basis non-negative, its sum 1, and
/// the line a line.
#[test]
fn sverchok_5296_nearly_equal_knots() {
    let next = 1.0 + f64::EPSILON;
    let knots = Knots::new(vec![0.0, 0.0, 0.0, 0.0, 1.0, next, 2.0, 2.0, 2.0, 2.0], 3).unwrap();
    for t in [0.5, 1.0, next, 1.5] {
        let functions = values(&knots, knots.span(&t, Side::Right), &t);
        assert!(functions.iter().all(|b| *b >= 0.0), "{functions:?}");
        near(functions.iter().sum(), 1.0, 1.0);
    }
    let mean = |i: usize| [knots.values()[i + 1..i + 4].iter().sum::<f64>() / 3.0];
    let line = BSpline::new(knots.clone(), (0..6).map(mean)).unwrap();
    [0.5, 1.0, next, 1.5].into_iter().for_each(|t| near(line.eval(t).unwrap()[0], t, 2.0));
}

/// lyon 140: maps a thousand kilometres from their origin lost the detail. A hump of 2⁻¹⁰ at 10⁷ is exact.
#[test]
fn lyon_140_detail_far_from_the_origin() {
    let far = |x: f64, y: f64| [1e7 + x / 1024.0, -1e7 + y / 1024.0];
    let hump = Bezier::new([far(0.0, 0.0), far(1.0, 2.0), far(2.0, 0.0)]).unwrap();
    assert_eq!(hump.eval(0.5).unwrap(), far(1.0, 1.0));
    assert_eq!(hump.jet(0.5, 1).unwrap()[1], [2.0 / 1024.0, 0.0]);
    // κ = |y″|/|x′|² with x′ = 2/1024 and y″ = −8/1024.
    assert_eq!(signed_curvature(&hump, 0.5, Side::Right), Some(-2048.0));
}

/// robust 19: exact signs turned to NaN near 1e±150, where squares leave the range of doubles. Lengths and curvatures there are those of the
/// unit size, scaled.
#[test]
fn robust_19_squares_out_of_range() {
    for exponent in [-1000, -600, 600, 980] {
        let scale = libm::ldexp(1.0, exponent);
        let side = Bezier::on([[0.0, 0.0], [3.0 * scale, 4.0 * scale]], Interval { start: 0.0, end: 1.0 }).unwrap();
        assert_eq!(length(&side, scale, &Limits::default()).unwrap().0, 5.0 * scale);
        let turn = [[-1.0, 1.0], [0.0, -1.0], [1.0, 1.0]].map(|p| p.map(|x| x * scale));
        assert_eq!(curvature(&Bezier::new(turn).unwrap(), 0.5, Side::Right), Some(2.0 / scale));
    }
}
