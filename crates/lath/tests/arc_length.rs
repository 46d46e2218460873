//! Lengths beside values of 60 digits, and lengths turned into parameters.
#![allow(clippy::unwrap_used)] // helpers of tests stop at the first fault, loudly

use lath::curve::{BSpline, Bezier, Curve, Path, RationalBezier};
use lath::error::{Code, Limits};
use lath::query::{ArcLength, length};
use lath::space::distance;
use testkit::corpus::{Entry, load};

/// The case's curve, in space.
fn build(case: &Entry) -> Box<dyn Curve<3>> {
    let points: Vec<[f64; 3]> =
        case.float_rows("points").iter().map(|row| [row[0], row[1], row.get(2).copied().unwrap_or(0.0)]).collect();
    if case.has("weights") {
        return Box::new(RationalBezier::new(points, case.floats("weights")).unwrap());
    }
    Box::new(Bezier::new(points).unwrap())
}

#[test]
fn lengths_are_as_accurate_as_asked() {
    for case in load("query") {
        let exact: f64 = case.text("length").parse().unwrap();
        let curve = build(&case);
        for k in 0..=12 {
            let accuracy = libm::pow(10.0, -f64::from(k));
            let (found, bound) = length(&*curve, accuracy, &Limits::default()).unwrap();
            assert!(bound.is_proven() && bound.value() <= accuracy, "{}: {bound:?}", case.place);
            assert!((found - exact).abs() <= bound.value(), "{}: {found} at {accuracy}", case.place);
        }
    }
}

#[test]
fn a_cusp_takes_few_more_stretches() {
    // (t², t³) from −1 to 1: 2 (13√13 − 8)/27, by its Bernstein points.
    let cusp = Bezier::new([[1.0, -1.0], [-1.0 / 3.0, 1.0], [-1.0 / 3.0, -1.0], [1.0, 1.0]]).unwrap();
    let exact = 2.0 * (13.0 * 13.0_f64.sqrt() - 8.0) / 27.0;
    let budget = Limits { max_points: 300, ..Limits::default() };
    let (found, bound) = length(&cusp, 1e-12, &budget).unwrap();
    assert!(bound.value() <= 1e-12 && (found - exact).abs() <= 1e-12, "{found} {bound:?}");
    // An accuracy that rounding forbids ends all the same, with the bound that was reached.
    let (found, bound) = length(&cusp, 1e-300, &budget).unwrap();
    assert!(bound.value() <= 1e-12 && (found - exact).abs() <= bound.value(), "{found} {bound:?}");
    // A smooth curve takes fewer still.
    let arch = Bezier::new([[0.0, 0.0], [1.0, 2.0], [3.0, 3.0], [4.0, 0.0]]).unwrap();
    let few = Limits { max_points: 12, ..Limits::default() };
    assert!(length(&arch, 1e-12, &few).unwrap().1.value() <= 1e-12);
}

#[test]
fn scales_and_places_change_nothing() {
    let points = [[0.0, 0.0], [1.0, 2.0], [3.0, 3.0], [4.0, 0.0]];
    let exact = 5.829_927_224_626_644;
    for scale in [1e-280, 1e-100, 1e-3, 1e6, 1e100, 1e280] {
        let scaled = Bezier::new(points.map(|p| p.map(|x| x * scale))).unwrap();
        let (found, bound) = length(&scaled, 1e-12 * scale, &Limits::default()).unwrap();
        assert!((found / scale - exact).abs() <= 1e-12 && bound.value() <= 1e-12 * scale, "{scale:e}");
    }
    // Map coordinates: what the points lose by standing far out is not the measure's fault, and a millimetre of 2⁻¹⁰ is held exactly.
    let far = Bezier::new(points.map(|[x, y]| [x / 1024.0 + 4e6, y / 1024.0 + 5e6])).unwrap();
    let (found, _) = length(&far, 1e-15, &Limits::default()).unwrap();
    assert!((found * 1024.0 - exact).abs() <= 1e-12);
}

#[test]
fn extreme_weights_and_degrees_are_bracketed() {
    let light = RationalBezier::new([[0.0, 0.0], [3.0, 4.0], [6.0, 8.0]], [1.0, 1e-250, 1.0]).unwrap();
    let (found, bound) = length(&light, 1e-6, &Limits::default()).unwrap();
    assert!((found - 10.0).abs() <= bound.value() + 1e-12 && bound.value() <= 1e-6, "{found} {bound:?}");
    // A parabola given by 61 points.
    let n = 60.0;
    let points =
        (0..=60).map(f64::from).map(|i| [2.0 * i / n - 1.0, 1.0 - 4.0 * i / n + 4.0 * i * (i - 1.0) / (n * (n - 1.0))]);
    let high = Bezier::new(points).unwrap();
    let exact = 5.0_f64.sqrt() + libm::asinh(2.0) / 2.0;
    let (found, bound) = length(&high, 1e-6, &Limits::default()).unwrap();
    assert!(bound.is_proven() && bound.value() <= 1e-6 && (found - exact).abs() <= bound.value(), "{found} {bound:?}");
}

/// Lengths and parameters of a curve lead to each other, in order, with exact ends.
fn round_trips<const D: usize>(curve: &dyn Curve<D>, slowest: f64) {
    let accuracy = 1e-12;
    let along = ArcLength::new(curve, accuracy, &Limits::default()).unwrap();
    let domain = curve.domain();
    assert_eq!((along.length_to(domain.start).unwrap(), along.length_to(domain.end).unwrap()), (0.0, along.length()));
    assert_eq!(
        (along.parameter_at(0.0).unwrap(), along.parameter_at(along.length()).unwrap()),
        (domain.start, domain.end)
    );
    let mut last = domain.start;
    for k in 0..=1000 {
        let s = along.length() * (f64::from(k) / 1000.0);
        let t = along.parameter_at(s).unwrap();
        assert!(t >= last && domain.contains(t), "{s}");
        assert!((along.length_to(t).unwrap() - s).abs() <= 1e-13 * along.length() + slowest, "{s} {t}");
        last = t;
    }
}

#[test]
fn lengths_and_parameters_lead_to_each_other() {
    for case in load("query") {
        round_trips(&*build(&case), 1e-14);
    }
    let points = (0..40).map(f64::from).map(|i| [i, libm::sin(i * i)]);
    round_trips(&BSpline::closed_uniform(3, points).unwrap(), 1e-13);
    round_trips(
        &BSpline::clamped(2, [[0.0, 0.0], [0.0, 0.0], [0.0, 0.0], [5.0, 1.0], [5.0, 1.0], [9.0, 0.0]]).unwrap(),
        1e-13,
    );
}

#[test]
fn equal_steps_are_equal() {
    for case in load("query") {
        let curve = build(&case);
        let along = ArcLength::new(&*curve, 1e-13, &Limits::default()).unwrap();
        let t = along.equal_steps(201, &Limits::default()).unwrap();
        let mut pieces = Vec::new();
        for pair in t.windows(2) {
            // Measured afresh on each step, by a polyline too fine to matter: chords of 1/4096 of a step.
            let at = |u: f64| curve.eval(pair[0] * (1.0 - u) + pair[1] * u).unwrap();
            let fine: f64 = (0..4096).map(f64::from).map(|k| distance(&at(k / 4096.0), &at((k + 1.0) / 4096.0))).sum();
            pieces.push(fine);
        }
        let mean = along.length() / 200.0;
        for (k, piece) in pieces.iter().enumerate() {
            assert!(
                (piece - mean).abs() <= 1e-8 * mean + 1e-10 * along.length(),
                "{}: step {k}: {piece} {mean}",
                case.place
            );
        }
    }
}

#[test]
fn curves_that_stand_still_and_jump() {
    let point = Bezier::new([[7.0, 7.0]; 3]).unwrap();
    let along = ArcLength::new(&point, 1e-9, &Limits::default()).unwrap();
    assert_eq!((along.length(), along.parameter_at(0.0).unwrap(), along.length_to(0.3).unwrap()), (0.0, 0.0, 0.0));
    // Degree 0 jumps from value to value: nothing is travelled.
    let steps = BSpline::uniform(0, [[0.0], [5.0], [1.0]]).unwrap();
    assert_eq!(ArcLength::new(&steps, 1e-9, &Limits::default()).unwrap().length(), 0.0);
    let line = || Bezier::new([[0.0], [1.0]]).unwrap();
    let path =
        Path::new([Box::new(line()) as Box<dyn Curve<1>>, Box::new(Bezier::new([[1.0], [3.0]]).unwrap())], false);
    let path = path.unwrap();
    let along = ArcLength::new(&path, 1e-9, &Limits::default()).unwrap();
    assert!((path.eval(along.parameter_at(2.0).unwrap()).unwrap()[0] - 2.0).abs() < 1e-12);
}

#[test]
fn distances_that_are_not_on_the_curve() {
    let line = Bezier::new([[0.0, 0.0], [3.0, 4.0]]).unwrap();
    let along = ArcLength::new(&line, 1e-9, &Limits::default()).unwrap();
    let code = |distance: f64| along.parameter_at(distance).unwrap_err().code();
    assert_eq!((code(-1e-9), code(5.1), code(f64::NAN)), (Code::Q007, Code::Q007, Code::T001));
    assert_eq!(along.length_to(1.5).unwrap_err().code(), Code::T002);
    assert_eq!(ArcLength::new(&line, f64::NAN, &Limits::default()).unwrap_err().code(), Code::Q001);
    let few = Limits { max_points: 10, ..Limits::default() };
    assert_eq!(along.equal_steps(11, &few).unwrap_err().code(), Code::B001);
    assert_eq!(along.equal_steps(1, &few).unwrap(), [0.0]);
    assert!(along.equal_steps(0, &few).unwrap().is_empty());
}
