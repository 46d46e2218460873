//! Insertion, removal, elevation, reduction, cutting: verbs that should not have moved the curve.

use crate::{near, refused};
use lath::curve::{BSpline, Bezier, Curve, Interval, Nurbs};
use lath::error::Limits;
use lath::query::length;
use lath::refine::Spline;
use lath::space::distance;

/// How far two curves are apart at parameters all over the domain of the first.
fn apart<const D: usize>(a: &dyn Curve<D>, b: &dyn Curve<D>) -> f64 {
    let Interval { start, end } = a.domain();
    let place = |k: i32| if k == 500 { end } else { start + (end - start) * f64::from(k) / 500.0 };
    let off = |t: f64| distance(&a.eval(t).unwrap(), &b.eval(t).unwrap());
    (0..=500).map(place).map(off).fold(0.0, f64::max)
}

/// geomdl 125: a rational quadratic with a joint of multiplicity 2 changed its shape when its degree was raised.
#[test]
fn geomdl_125_elevation_changed_the_curve() {
    let points = [
        [821.51962938, -677.395551576, 3.5410634089],
        [873.5806602364927, -682.3571637856359, 88.77621736805291],
        [879.1302220964927, -582.5406209926358, 91.19699162172292],
        [879.1656602459713, -581.9032177447318, 91.21245004565435],
        [879.196849813, -581.265461848, 91.2209560929],
    ];
    let knots = vec![0.0, 0.0, 0.0, 0.5, 0.5, 1.0, 1.0, 1.0];
    let weights = [1.0, std::f64::consts::FRAC_1_SQRT_2, 1.0, 0.9999796117372515, 1.0];
    let curve = Nurbs::over(knots, 2, points, weights).unwrap();
    for by in 1..=4 {
        let elevated = curve.elevate(by).unwrap();
        assert_eq!((elevated.degree(), elevated.control_points().len()), (2 + by, 5 + 2 * by));
        assert!(apart(&curve, &elevated) < 1e-12, "{}", apart(&curve, &elevated));
        assert_eq!(elevated.control_points()[0], points[0]);
    }
}

/// igakit 1: a valid quadratic over (0, 0, 0, ½, 1, 1, 1) could not be elevated for some users.
#[test]
fn igakit_1_elevation_of_a_plain_quadratic() {
    let curve = BSpline::over(vec![0.0, 0.0, 0.0, 0.5, 1.0, 1.0, 1.0], 2, [[0.0], [4.0], [0.0], [8.0]]).unwrap();
    for by in [1, 2] {
        assert!(apart(&curve, &curve.elevate(by).unwrap()) < 1e-14);
    }
}

/// geomdl 135: a knot put in and taken out again left another curve.
#[test]
fn geomdl_135_removal_changed_the_curve() {
    let curve = BSpline::clamped(2, [[0.0, 0.0, 0.0], [1.0, 1.0, 0.0], [2.0, 0.0, 0.0]]).unwrap();
    let inserted = curve.insert_knots(&[0.5]).unwrap();
    let (removed, bound) = inserted.remove_knots(1e-12).unwrap();
    assert_eq!((removed.knots(), removed.control_points()), (curve.knots(), curve.control_points()));
    assert!(bound.value() < 1e-13);
}

/// geomdl 153: points on a line came back with one of them lost, after a knot had been put in and taken out.
#[test]
fn geomdl_153_a_point_was_lost() {
    let points = [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0].map(|x| [x, x]);
    let knots = vec![0.0, 0.0, 0.0, 0.2, 0.4, 0.6, 0.8, 1.0, 1.0, 1.0];
    let curve = BSpline::over(knots.clone(), 2, points).unwrap();
    let inserted = curve.insert_knots(&[0.5]).unwrap();
    assert!(apart(&curve, &inserted) < 1e-14);
    for (found, exact) in inserted.control_points().iter().zip([0.0, 1.0, 2.0, 2.75, 3.25, 4.0, 5.0, 6.0]) {
        near(found[0], exact, 6.0);
    }
    let spline = Spline::open(inserted.knots().clone(), inserted.control_points().to_vec()).unwrap();
    let (removed, moved) = spline.remove(&0.5).unwrap();
    assert_eq!((removed.knots().values(), removed.points().len()), (&knots[..], 7));
    near(distance(&moved, &[0.0; 2]), 0.0, 6.0);
    for (found, exact) in removed.points().iter().zip(points) {
        near(found[0], exact[0], 6.0);
    }
    // Without being told which, two more may go: on [0.4, 0.6] the curve is one with its neighbours.
    let (fewer, _) = inserted.remove_knots(1e-12).unwrap();
    assert_eq!(fewer.knots().breaks(), [0.0, 0.2, 0.8, 1.0]);
    assert!(apart(&fewer, &curve) < 1e-12);
}

/// gbs PR 61: a knot put in p times was not taken out p times. Every multiplicity comes back, cubic and quintic.
#[test]
fn gbs_61_removal_stopped_early() {
    for degree in [3, 5] {
        let points = (0..degree + 4).map(|i| [i as f64, (i * i % 5) as f64]);
        let curve = BSpline::clamped(degree, points).unwrap();
        for copies in 1..=degree {
            let inserted = curve.insert_knots(&vec![1.25; copies]).unwrap();
            let (removed, _) = inserted.remove_knots(1e-11).unwrap();
            assert_eq!(removed.knots(), curve.knots(), "{copies} copies");
            assert!(apart(&removed, &curve) < 1e-13);
        }
    }
}

/// geomdl 136: a Bézier curve of degree 5 was lowered to 4 with inner points left where they were, and no error said. The ends stay, the rest is
/// the nearest, and the bound is kept.
#[test]
fn geomdl_136_reduction_left_points_alone() {
    let points = [[-5.0, 0.0], [-7.0, 2.0], [-3.0, 5.0], [2.0, 6.0], [5.0, 3.0], [3.0, 0.0]];
    let curve = Bezier::new(points).unwrap();
    let (lower, bound) = curve.reduce(1, None).unwrap();
    let found = lower.control_points();
    assert_eq!((found.len(), found[0], found[4]), (5, points[0], points[5]));
    assert!(found[1..4].iter().all(|point| !points.contains(point)));
    let off = apart(&curve, &lower);
    assert!(off > 0.0 && off <= bound.value() && bound.value() < 1.0, "{off} of {bound:?}");
    // And a curve that is of degree 4 comes back.
    let (again, bound) = lower.elevate(1).unwrap().reduce(1, Some(1e-12)).unwrap();
    assert!(bound.value() < 1e-12 && apart(&again, &lower) < 1e-13);
}

/// geomdl 158: a knot at the right end of an unclamped curve gave a doubled point.
#[test]
fn geomdl_158_insertion_at_the_right_end_of_unclamped_knots() {
    let points = [[0.0, 0.0, 0.0], [1.0, 1.0, 0.0], [2.0, 1.0, 0.0], [3.0, 0.0, 0.0]];
    let knots: Vec<f64> = (0..=6).map(f64::from).collect();
    let curve = BSpline::over(knots, 2, points).unwrap();
    let inserted = curve.insert_knots(&[4.0]).unwrap();
    let expected = [[0.0, 0.0, 0.0], [1.0, 1.0, 0.0], [2.0, 1.0, 0.0], [2.5, 0.5, 0.0], [3.0, 0.0, 0.0]];
    assert_eq!(inserted.control_points(), expected);
    assert_eq!((inserted.domain(), apart(&curve, &inserted)), (curve.domain(), 0.0));
    // The left end, and between.
    for t in [2.0, 2.5, 3.0, 3.999] {
        assert!(apart(&curve, &curve.insert_knots(&[t]).unwrap()) < 1e-15);
    }
}

/// scirs2-interpolate 0.6.5: derivatives by nested differences (1.5 for 3, −7.5e7 for 48, 3469 for 72), and an elevation that was off by 0.6.
#[test]
fn scirs2_derivatives_and_elevation_of_a_cubic() {
    let curve = BSpline::clamped(3, [[0.0], [1.0], [-2.0], [3.0]]).unwrap();
    let first = curve.derivative().unwrap();
    let second = first.derivative().unwrap();
    let third = second.derivative().unwrap();
    assert_eq!(first.eval(0.0).unwrap(), [3.0]);
    assert_eq!(second.eval(1.0).unwrap(), [48.0]);
    assert_eq!(third.eval(0.3).unwrap(), [72.0]);
    assert_eq!(third.derivative().unwrap().eval(0.3).unwrap(), [0.0]);
    assert!(apart(&curve, &curve.elevate(3).unwrap()) < 1e-14);
}

/// truck-geometry PR 105: an unclamped curve was said to live on all its knots, where the functions do not sum to 1. Its domain is [t_p, t_n], and
/// neither cutting nor inserting leaves it.
#[test]
fn truck_105_domain_of_an_unclamped_curve() {
    let curve = BSpline::uniform(3, [[1.0]; 6]).unwrap();
    assert_eq!(curve.knots().values()[0], -3.0);
    assert_eq!(curve.domain(), Interval { start: 0.0, end: 3.0 });
    let clamped = curve.clamp().unwrap();
    assert_eq!(clamped.domain(), curve.domain());
    assert!(clamped.control_points().iter().all(|point| *point == [1.0]));
    refused(curve.insert_knots(&[-1.0]), "T002", 0);
    refused(curve.trim(Interval { start: 0.0, end: 4.0 }), "T002", 1);
    refused(curve.split(3.0), "T002", None);
}

/// Splipy 188: the length of a strongly bent cubic was off by a tenth. Elevated, cut, or in pieces, it is as long as it was.
#[test]
fn splipy_188_length_does_not_hang_on_the_description() {
    let curve = BSpline::clamped(3, [[0.0, 0.0], [10.0, 0.0], [-9.0, 1.0], [1.0, 1.0], [0.0, 9.0]]).unwrap();
    let measure = |curve: &dyn Curve<2>| length(curve, 1e-9, &Limits::default()).unwrap().0;
    let whole = measure(&curve);
    let (left, right) = curve.split(0.7).unwrap();
    let pieces = curve.to_beziers().unwrap();
    for found in [
        measure(&curve.elevate(2).unwrap()),
        measure(&left) + measure(&right),
        pieces.iter().map(|piece| measure(piece)).sum(),
    ] {
        assert!((found - whole).abs() < 4e-9, "{found} is not {whole}");
    }
}

/// sverchok 4469 and 4722: a part of a periodic curve came out clamped at one end only, and jumped where it ended at the end of the domain.
#[test]
fn sverchok_4469_half_clamped_parts_of_periodic_curves() {
    let points = [[4.0, 0.0], [0.0, 3.0], [-5.0, 1.0], [-2.0, -4.0], [3.0, -2.0]];
    let ring = BSpline::closed_uniform(3, points).unwrap();
    // The same curve, unclamped, as users build it: the first three points again at the end.
    let wrapped = BSpline::uniform(3, points.into_iter().chain(points[..3].iter().copied())).unwrap();
    for (start, end) in [(0.0, 5.0), (2.5, 5.0), (0.0, 2.25), (1.0, 4.999_999)] {
        for curve in [&ring, &wrapped] {
            let part = curve.trim(Interval { start, end }).unwrap();
            assert_eq!((part.knots().multiplicity(&start), part.knots().multiplicity(&end)), (4, 4));
            assert!(apart(&part, &ring) < 1e-14);
            assert_eq!(part.control_points().last(), Some(&part.eval(end).unwrap()));
        }
    }
    let open = wrapped.clamp().unwrap();
    let (first, last) = (open.control_points()[0], open.control_points()[open.control_points().len() - 1]);
    assert!(distance(&first, &last) < 1e-15);
    assert_eq!(open.close(1e-12).unwrap().0.control_points().len(), 5);
}

/// sverchok 5296: curves whose knots nearly agree exploded when they were brought to the same knots. Points remain between those that were
/// given, and the curves where they were.
#[test]
fn sverchok_5296_nearly_equal_knots_of_two_curves() {
    let with = |inner: f64| {
        let knots = vec![0.0, 0.0, 0.0, 0.0, inner, 1.0, 1.0, 1.0, 1.0];
        BSpline::over(knots, 3, [[0.0, 0.0], [1.0, 2.0], [2.0, -2.0], [3.0, 2.0], [4.0, 0.0]]).unwrap()
    };
    let mut given = vec![with(0.5), with(0.5 + f64::EPSILON), with(0.5 + 1e-12), with(0.5 + 1e-7)];
    given.push(given[0].elevate(1).unwrap());
    let all = BSpline::make_compatible(&given).unwrap();
    for (found, given) in all.iter().zip(&given) {
        assert_eq!(found.knots(), all[0].knots());
        assert!(apart(found, given) < 1e-14);
        for [x, y] in found.control_points() {
            assert!((0.0..=4.0).contains(x) && (-2.0..=2.0).contains(y), "({x}, {y})");
        }
    }
}
