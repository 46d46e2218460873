//! Interpolating B-splines: every degree, every end, closed, and the solvability of knots of one's own.
#![allow(clippy::unwrap_used)] // a failing unwrap is a failing test

use lath::curve::Curve;
use lath::error::Code;
use lath::interpolate::{BSplineEnd, End, Ends, bspline, bspline_closed, bspline_over, cubic, cubic_closed};
use lath::knot::{Knots, Side};

fn data(n: usize) -> (Vec<f64>, Vec<[f64; 2]>) {
    let t: Vec<f64> = (0..n).map(|i| i as f64 + 0.25 * ((i * 5 % 3) as f64)).collect();
    let points = t.iter().map(|t| [libm::sin(*t), libm::cos(0.7 * t) * t]).collect();
    (t, points)
}

fn passes<const D: usize>(curve: &dyn Curve<D>, t: &[f64], points: &[[f64; D]], tolerance: f64, name: &str) {
    for (t, point) in t.iter().zip(points) {
        let found = curve.eval(*t).unwrap();
        assert!((0..D).all(|c| (found[c] - point[c]).abs() <= tolerance), "{name} at {t}: {found:?}, not {point:?}");
    }
}

#[test]
fn every_degree_passes_through_its_points() {
    let (t, points) = data(40);
    let ends = [BSplineEnd::NotAKnot, BSplineEnd::Natural];
    for degree in 0..=30 {
        for (start, end) in [(0, 0), (0, 1), (1, 1)] {
            let outcome = bspline(&points, t.clone(), degree, &ends[start], &ends[end]);
            if degree <= 17 || end == 0 {
                passes(&outcome.unwrap(), &t, &points, 1e-12, &format!("degree {degree}"));
            } else {
                // Beyond, the points are held within 1e-10 of the greatest, or the curve is refused.
                match outcome {
                    Ok(curve) => passes(&curve, &t, &points, 4e-9, &format!("degree {degree}")),
                    Err(error) => assert_eq!(error.code(), Code::N003),
                }
            }
        }
    }
    assert_eq!(bspline(&points, t, 31, &ends[0], &ends[0]).unwrap_err().code(), Code::K006);
}

#[test]
fn end_conditions_hold() {
    let (t, points) = data(9);
    let (start, end) = (t[0], t[8]);
    for degree in 2..=7 {
        let share = degree / 2;
        let wanted: Vec<(usize, [f64; 2])> = (1..=share).map(|k| (k, [k as f64, -0.5])).collect();
        let given = BSplineEnd::Derivatives(wanted.clone());
        let curve = bspline(&points, t.clone(), degree, &given, &BSplineEnd::Natural).unwrap();
        passes(&curve, &t, &points, 1e-12, "given derivatives");
        let jet = curve.jet(start, degree).unwrap();
        for (order, value) in &wanted {
            assert!((0..2).all(|c| (jet[*order][c] - value[c]).abs() < 1e-10), "degree {degree}: {:?}", jet[*order]);
        }
        let mut last = vec![[0.0; 2]; degree + 1];
        curve.jet_into(end, Side::Left, &mut last);
        for order in degree / 2 + 1..degree / 2 + 1 + share {
            assert!(last[order].iter().all(|x| x.abs() < 1e-8), "degree {degree}, order {order}: {:?}", last[order]);
        }
        let short = BSplineEnd::Derivatives(wanted[..share - 1].to_vec());
        assert_eq!(bspline(&points, t.clone(), degree, &short, &given).unwrap_err().code(), Code::C001);
    }
}

#[test]
fn degree_three_is_the_cubic_spline() {
    let (t, points) = data(12);
    let cases = [
        (BSplineEnd::Natural, End::Natural),
        (BSplineEnd::NotAKnot, End::NotAKnot),
        (BSplineEnd::Derivatives(vec![(1, [2.0, -1.0])]), End::Clamped([2.0, -1.0])),
        (BSplineEnd::Derivatives(vec![(2, [2.0, -1.0])]), End::Second([2.0, -1.0])),
    ];
    for (start, cubic_start) in &cases {
        for (end, cubic_end) in &cases {
            let a = bspline(&points, t.clone(), 3, start, end).unwrap();
            let b = cubic(&points, t.clone(), &Ends::Open(cubic_start.clone(), cubic_end.clone())).unwrap();
            for k in 0..=200 {
                let at = t[0] + (t[11] - t[0]) * f64::from(k) / 200.0;
                passes(&a, &[at.min(t[11])], &[b.eval(at.min(t[11])).unwrap()], 1e-12, "cubic");
            }
        }
    }
}

#[test]
fn closed_curves_of_every_degree_have_no_seam() {
    let (mut t, points) = data(10);
    t.push(t[9] + 1.5);
    for degree in 1..=9 {
        let curve = bspline_closed(&points, t.clone(), degree).unwrap();
        passes(&curve, &t[..10], &points, 1e-11, &format!("closed, degree {degree}"));
        let domain = curve.domain();
        let (mut first, mut last) = (vec![[0.0; 2]; degree], vec![[0.0; 2]; degree]);
        curve.jet_into(domain.start, Side::Right, &mut first);
        curve.jet_into(domain.end, Side::Left, &mut last);
        for k in 0..degree {
            let size = first[k].iter().fold(1.0, |m: f64, x| m.max(x.abs()));
            assert!((0..2).all(|c| (first[k][c] - last[k][c]).abs() < 1e-9 * size), "degree {degree}, order {k}");
        }
    }
    let a = bspline_closed(&points, t.clone(), 3).unwrap();
    let b = cubic_closed(&points, t.clone()).unwrap();
    for k in 0..100 {
        let at = t[0] + (t[10] - t[0]) * f64::from(k) / 100.0;
        passes(&a, &[at], &[b.eval(at).unwrap()], 1e-12, "closed cubic");
    }
}

#[test]
fn closed_data_rotated_by_one_give_the_rotated_curve() {
    let points = vec![[0.0, 0.0], [4.0, 1.0], [5.0, 5.0], [1.0, 6.0], [-2.0, 3.0], [-3.0, 1.0]];
    let mut rotated = points.clone();
    rotated.rotate_left(1);
    let t: Vec<f64> = (0..7).map(f64::from).collect();
    for degree in 1..=6 {
        let mut expected = bspline_closed(&points, t.clone(), degree).unwrap().control_points().to_vec();
        expected.rotate_left(1);
        let found = bspline_closed(&rotated, t.clone(), degree).unwrap();
        for (found, expected) in found.control_points().iter().zip(&expected) {
            let off = (0..2).map(|c| (found[c] - expected[c]).abs()).fold(0.0, f64::max);
            assert!(off <= 8.0 * f64::EPSILON * 8.0, "degree {degree}: {off:e}");
        }
    }
}

#[test]
fn knots_of_ones_own_are_held_against_schoenberg_and_whitney() {
    let knots = || Knots::new(vec![0.0, 0.0, 0.0, 1.0, 2.0, 3.0, 3.0, 3.0], 2).unwrap();
    let points = [[0.0], [1.0], [0.5], [2.0], [1.0]];
    let good = bspline_over(points, &[0.0, 0.5, 1.5, 2.5, 3.0], knots()).unwrap();
    passes(&good, &[0.0, 0.5, 1.5, 2.5, 3.0], &points, 1e-14, "own knots");
    let error = bspline_over(points, &[0.0, 0.25, 0.5, 0.75, 3.0], knots()).unwrap_err();
    assert_eq!((error.code(), error.index()), (Code::N002, Some(3)));
    assert_eq!(bspline_over(&points[..4], &[0.0, 1.0, 2.0, 3.0], knots()).unwrap_err().code(), Code::K001);
}

#[test]
fn too_few_points_are_named_with_the_number_needed() {
    let (t, points) = data(5);
    for degree in 1..=6 {
        for n in 0..=5 {
            let ends = BSplineEnd::NotAKnot;
            let outcome = bspline(&points[..n], t[..n].to_vec(), degree, &ends, &ends);
            match outcome {
                Ok(curve) => {
                    assert!(n > degree && n >= 2);
                    passes(&curve, &t[..n], &points[..n], 1e-12, "few");
                }
                Err(error) => {
                    assert!(n <= degree || n < 2, "{n} points, degree {degree}: {error}");
                    assert_eq!(error.code(), Code::P001);
                }
            }
        }
    }
}
