//! Rows 13 to 25, 62 and 63: counts, degrees, levels and tolerances.

use crate::{every_taker, near, refused};
use lath::curve::{AnyCurve, BSpline, Bezier, Curve, CurveBuilder, Hermite, Outside, Path, Polyline, Power, pad};
use lath::error::{Limits, Result};
use lath::interpolate::{BSplineEnd, End, Ends, bspline, cubic, cubic_closed};
use lath::knot::{Knots, Side};
use lath::query::length;
use lath::subdivide::{self, Index, Scheme, Subdivision, Target};
use lath::tessellate::flatten;
use std::ops::ControlFlow;

const FREE: Ends<1> = Ends::Open(End::NotAKnot, End::NotAKnot);

#[test]
fn row_13_no_points() {
    for (taker, answer) in every_taker(&[]) {
        let error = answer.expect_err(taker);
        // Where the parameters are looked at first, there are too few of those.
        let code = if ["hermite", "tangents", "closed hermite", "quintic", "seconds", "power"].contains(&taker) {
            "T004"
        } else {
            "P001"
        };
        assert_eq!(error.code().as_str(), code, "{taker}: {error}");
    }
    refused(Path::<2>::new([], false), "P001", None);
    refused(Knots::<f64>::new(vec![], 0), "K001", None);
    refused(Knots::<f64>::periodic(&[], 3), "K001", None);
}

#[test]
fn row_14_one_point() {
    let point = [[3.0, -1.0]];
    let constants: [Box<dyn Curve<2>>; 3] = [
        Box::new(Bezier::new(point).unwrap()),
        Box::new(BSpline::uniform(0, point).unwrap()),
        Box::new(BSpline::closed_uniform(3, point).unwrap()),
    ];
    for curve in constants {
        for t in [0.0, 0.3, 1.0] {
            let jet = curve.jet(t, 2).unwrap();
            near(jet[0][0], 3.0, 4.0, 3.0);
            near(jet[0][1], -1.0, 4.0, 1.0);
            assert_eq!(jet[1..], [[0.0; 2]; 2], "{}", curve.kind());
        }
    }
    refused(Polyline::new(point), "P001", None);
    refused(BSpline::uniform(1, point), "P001", None);
    refused(cubic([[3.0]], vec![0.0], &FREE), "P001", None);
    refused(cubic_closed([[3.0]], vec![0.0, 1.0]), "P001", None);
    refused(Hermite::new(vec![0.0], point, point), "T004", None);
}

#[test]
fn row_15_two_points_of_degree_3() {
    refused(BSpline::uniform(3, [[0.0], [1.0]]), "P001", None);
    refused(BSpline::over(vec![0.0, 0.0, 0.0, 1.0, 1.0, 1.0], 3, [[0.0], [1.0]]), "K001", None);
    let ends = BSplineEnd::NotAKnot;
    refused(bspline([[0.0], [1.0]], vec![0.0, 1.0], 3, &ends, &ends), "P001", None);
    // The cubic spline through two points is the line, whatever the scale.
    for scale in [1e-200, 1.0, 1e200] {
        let line = cubic([[0.0], [scale]], vec![2.0, 4.0], &FREE).unwrap();
        assert_eq!(line.jet(3.0, 2).unwrap(), [[0.5 * scale], [0.5 * scale], [0.0]]);
    }
}

#[test]
fn row_16_no_more_points_than_the_degree() {
    let points = [[0.0], [1.0], [2.0], [3.0], [4.0]];
    for degree in [5, 6, 999] {
        for error in [
            refused(BSpline::uniform(degree, points), "P001", None),
            refused(Knots::<f64>::clamped(5, degree).map(drop), "P001", None),
        ] {
            let words = [format!("5 points for degree {degree}"), format!("at least {}", degree + 1)];
            assert!(words.iter().all(|word| error.message().contains(word)), "{error}");
        }
    }
    assert!(BSpline::uniform(4, points).is_ok());
}

#[test]
fn row_17_degree_0_is_piecewise_constant() {
    let steps = BSpline::uniform(0, [[1.0], [2.0], [4.0]]).unwrap();
    assert_eq!([0.0, 0.5, 1.0, 2.5, 3.0].map(|t| steps.eval(t).unwrap()[0]), [1.0, 1.0, 2.0, 4.0, 4.0]);
    // Right-continuous inside, left-continuous at the end; the other side can be asked for.
    let mut left = [[0.0]; 2];
    steps.jet_into(1.0, Side::Left, &mut left);
    assert_eq!(left, [[1.0], [0.0]]);
    let ends = BSplineEnd::Natural;
    let through = bspline([[1.0], [2.0], [4.0]], vec![0.0, 1.0, 3.0], 0, &ends, &ends).unwrap();
    assert_eq!([0.0, 1.0, 3.0].map(|t| through.eval(t).unwrap()[0]), [1.0, 2.0, 4.0]);
}

#[test]
fn row_18_huge_degrees() {
    for degree in [1001, 1 << 31, usize::MAX] {
        refused(Knots::<f64>::new(vec![0.0, 1.0], degree), "K006", None);
        refused(Knots::<f64>::uniform(4, degree), "K006", None);
        refused(Knots::periodic(&[0.0, 1.0], degree), "K006", None);
        refused(BSpline::uniform(degree, [[0.0], [1.0]]), "K006", None);
        refused(BSpline::over(vec![0.0, 1.0], degree, [[0.0]]), "K006", None);
        refused(BSpline::closed_uniform(degree, [[0.0], [1.0]]), "K006", None);
        refused(Scheme::<f64>::lane_riesenfeld(degree), "K006", None);
        let ends = BSplineEnd::NotAKnot;
        refused(bspline([[0.0], [1.0]], vec![0.0, 1.0], degree, &ends, &ends), "K006", None);
    }
    refused(Power::new(vec![0.0, 1.0], [vec![[0.0]; 1002]]), "K006", None);
}

#[test]
fn row_19_degrees_from_21_to_100() {
    for degree in [21, 50, 100] {
        // uⁿ at ½ is 2⁻ⁿ; n multiplications by one half are exact.
        let mut points = vec![[0.0]; degree + 1];
        points[degree] = [1.0];
        let power = Bezier::new(points).unwrap();
        assert_eq!(power.eval(0.5).unwrap(), [libm::ldexp(1.0, -(degree as i32))]);
        // Control points at the means of p neighbouring knots give the parameter itself.
        let n = degree + 5;
        let mean = |i: usize| [i as f64 - degree as f64 + (degree as f64 + 1.0) / 2.0];
        let identity = BSpline::uniform(degree, (0..n).map(mean)).unwrap();
        let scale = degree as f64;
        for k in 0..=40 {
            let t = f64::from(k) / 8.0;
            near(identity.eval(t).unwrap()[0], t, 3.0 * (scale + 1.0), scale);
        }
    }
}

#[test]
fn row_20_binomials_beyond_all_numbers() {
    // C(1030, 515) > 1.8e308. Degree 1000 is evaluated by convex combinations, above it is refused.
    let line = Bezier::new((0..=1000).map(|i| [f64::from(i)])).unwrap();
    for t in [0.0, 0.25, 0.5, 1.0] {
        near(line.eval(t).unwrap()[0], 1000.0 * t, 3000.0, 1000.0);
    }
    let error = refused(Bezier::new((0..=1001).map(|i| [f64::from(i)])), "K006", None);
    assert!(error.message().contains("1002 points make degree 1001"), "{error}");
}

#[test]
fn row_21_one_or_two_knots_too_few_or_too_many() {
    let points = [[0.0], [1.0], [2.0], [3.0]];
    for count in [5, 6, 7, 9, 10] {
        let knots = (0..count).map(f64::from).collect();
        let error = refused(BSpline::over(knots, 3, points), "K001", None);
        assert!(error.message().starts_with(&format!("{count} knots for 4 points of degree 3")), "{error}");
        let hint = error.message().contains("without the superfluous first and last knot");
        assert_eq!(hint, count == 6, "{error}");
    }
    refused(BSpline::closed(&[0.0, 1.0, 2.0], 3, points), "K001", None);
}

#[test]
fn row_22_a_hundred_million_points() {
    let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    let curve = Subdivision::new(Scheme::cubic(), square, subdivide::Ends::Closed).unwrap();
    let level = 25; // 4 · 2²⁵ = 134217728 points
    assert_eq!(curve.count(level, Target::Level).unwrap().to_u64(), Some(134_217_728));
    // They come in blocks, the first at once; who has enough says so.
    let mut first = Vec::new();
    let take = &mut |block: &[[f64; 2]]| {
        first.extend_from_slice(block);
        ControlFlow::Break(())
    };
    curve.stream(level, Target::Level, &Limits::default(), take).unwrap();
    assert_eq!((first.len(), first[7]), (1024, curve.point(level, Target::Level, &Index::from(7)).unwrap()));
    // The last three without those before them; and a smaller budget is refused before the first.
    let mut last = 0;
    let end = Index::from(134_217_725);
    let count = &mut |block: &[[f64; 2]]| {
        last += block.len();
        ControlFlow::Continue(())
    };
    curve.range(level, Target::Level, &end, 3, &Limits::default(), count).unwrap();
    assert_eq!(last, 3);
    let few = Limits { max_points: 100_000_000, ..Limits::default() };
    let never = &mut |_: &[[f64; 2]]| -> ControlFlow<()> { panic!("a block beyond the budget") };
    refused(curve.stream(level, Target::Level, &few, never), "B001", None);
    let small = Limits { max_bytes: 1 << 20, ..Limits::default() };
    refused(curve.level(level, Target::Level, &small), "B001", None);
}

/// Rows of zeros of any dimension.
struct Rows(usize);

impl CurveBuilder for Rows {
    fn build<const D: usize>(self) -> Result<Box<dyn Curve<D>>> {
        Ok(Box::new(Bezier::new(pad::<D>(&vec![0.5; 3 * self.0], self.0))?))
    }
}

#[test]
fn row_24_mixed_and_odd_dimensions() {
    for dimension in [0, 17, 100] {
        refused(AnyCurve::build(dimension, Rows(dimension)), "P006", None);
    }
    for dimension in 1..=16 {
        let curve = AnyCurve::build(dimension, Rows(dimension)).unwrap();
        let mut point = [7.0; 17];
        curve.eval_into(0.5, Outside::Error, &mut point).unwrap();
        let filled = point.iter().filter(|x| **x == 0.5).count();
        assert_eq!((curve.dimension(), filled, point[dimension]), (dimension, dimension, 7.0));
        refused(curve.eval_into(0.5, Outside::Error, &mut point[..dimension - 1]), "P005", None);
    }
    refused(AnyCurve::of(Bezier::new([[0.0; 5]]).unwrap()), "P006", None);
    refused(Power::new(vec![0.0, 1.0, 2.0], [vec![[0.0]], vec![[0.0], [1.0]]]), "P005", 1);
    refused(Hermite::new(vec![0.0, 1.0], [[0.0], [1.0]], [[0.0]]), "P005", None);
}

#[test]
fn row_25_a_single_knot() {
    refused(Knots::new(vec![0.0], 0), "K001", None);
    refused(Knots::periodic(&[0.0], 0), "K001", None);
    refused(BSpline::over(vec![0.0], 0, [[1.0]]), "K001", None);
    refused(BSpline::<1>::over(vec![0.0], 0, [[0.0; 1]; 0]), "K001", None);
}

#[test]
fn row_62_levels_10_to_60_and_beyond() {
    let curve = Subdivision::new(Scheme::<f64>::chaikin(), [[0.0], [1.0], [0.0]], subdivide::Ends::Open).unwrap();
    let limits = Limits { max_points: 1 << 20, ..Limits::default() };
    assert_eq!(curve.level(10, Target::Level, &limits).unwrap().len(), 1026);
    for level in [20, 31, 60, 64, 1000] {
        // One segment and two points more: 2ᵏ + 2 > 2²⁰.
        refused(curve.level(level, Target::Level, &limits), "B001", None);
    }
    refused(curve.level(40, Target::Level, &Limits::default()), "B001", None);
    for level in [1001, usize::MAX] {
        refused(curve.level(level, Target::Level, &limits), "S005", None);
        refused(curve.count(level, Target::Limit), "S005", None);
    }
    // A single point of a level that nobody could store: at t = ½ the limit of 0, 1, 0 is (0 + 6 + 0)/8.
    let middle = Index::from(1).shifted_up(999);
    assert_eq!(curve.point(1000, Target::Limit, &middle).unwrap(), [0.75]);
}

#[test]
fn row_63_tolerances_that_are_none() {
    let arch = Bezier::new([[0.0, 0.0], [1.0, 2.0], [2.0, 0.0]]).unwrap();
    let limits = Limits::default();
    let flat = |tolerance: f64| {
        let mut points = Vec::new();
        flatten(&arch, tolerance, &limits, &mut |_, point| points.push(point)).map(|bound| (points, bound))
    };
    let polygon =
        Subdivision::new(Scheme::<f64>::cubic(), [[0.0], [1.0], [0.0], [2.0]], subdivide::Ends::Open).unwrap();
    for tolerance in [0.0, -0.0, -1.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        refused(flat(tolerance), "Q001", None);
        refused(length(&arch, tolerance, &limits), "Q001", None);
        refused(polygon.levels_for(tolerance), "Q001", None);
    }
    // Possible, but beyond every budget: refused before the first point.
    for tolerance in [f64::from_bits(1), 1e-300, 1e-30] {
        refused(flat(tolerance), "B001", None);
    }
    let few = Limits { max_points: 1000, ..limits };
    let (_, bound) = length(&arch, 1e-300, &few).unwrap();
    assert!(bound.value() > 1e-300 && bound.value() < 1.0, "the bound tells: {bound:?}");
    // Larger than the curve: both ends, and a bound that holds.
    let (points, bound) = flat(1e9).unwrap();
    assert_eq!((points, bound.value()), (vec![[0.0, 0.0], [2.0, 0.0]], 1.0));
}
