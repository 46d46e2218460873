//! Rows 26 to 35: knots, and where a curve is asked.

use crate::{near, refused};
use lath::basis::bspline::{derivatives, values};
use lath::curve::{BSpline, Bezier, Curve, Outside, Path, Polyline};
use lath::knot::{Knots, Side};
use lath::query::{Continuity, continuity};

fn next_up(t: f64) -> f64 {
    f64::from_bits(t.to_bits() + 1)
}

/// All functions of the span are non-negative and sum to 1.
#[track_caller]
fn partition_of_unity(knots: &Knots, t: f64) {
    let functions = values(knots, knots.span(&t, Side::Right), &t);
    assert!(functions.iter().all(|b| *b >= 0.0), "{functions:?} at {t:e}");
    near(functions.iter().sum(), 1.0, 6.0 * (knots.degree() as f64 + 1.0), 1.0);
}

#[test]
fn row_26_decreasing_knots() {
    let error = refused(Knots::new(vec![0.0, 0.0, 2.0, 1.0, 3.0, 3.0], 1), "K004", 3);
    assert!(error.message().contains("knot 3 is 1.0, below knot 2 = 2.0"), "{error}");
    refused(BSpline::over(vec![1.0, 1.0, 0.0, 0.0], 1, [[0.0], [1.0]]), "K004", 2);
    refused(Knots::periodic(&[0.0, 2.0, 1.0], 3), "K004", 2);
}

#[test]
fn row_27_all_knots_equal() {
    for degree in [0, 1, 3, 10] {
        refused(Knots::new(vec![0.5; 2 * degree + 2], degree), "K003", degree + 1);
    }
    // Few enough to be no repetition too many, and still no domain.
    refused(Knots::new(vec![0.0, 1.0, 1.0, 2.0], 1), "K005", 1);
    assert!(Knots::periodic(&[2.0; 5], 3).unwrap_err().is_knots());
}

#[test]
fn row_28_multiplicity() {
    refused(Knots::new(vec![0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0, 2.0, 2.0, 2.0], 2), "K003", 6);
    // degree + 1 inside is a break, and both sides of it can be asked for.
    let knots = Knots::new(vec![0.0, 0.0, 1.0, 1.0, 2.0, 2.0], 1).unwrap();
    let broken = BSpline::new(knots, [[0.0], [1.0], [5.0], [6.0]]).unwrap();
    let at = |side| {
        let mut jet = [[0.0]; 2];
        broken.jet_into(1.0, side, &mut jet);
        jet
    };
    assert_eq!((at(Side::Left), at(Side::Right)), ([[1.0], [1.0]], [[5.0], [1.0]]));
    assert_eq!(broken.eval(1.0).unwrap(), [5.0]);
    assert_eq!(continuity(&broken), [(1.0, Continuity::Jump)]);
}

#[test]
fn row_29_nearly_equal_knots() {
    let gap = f64::EPSILON;
    for degree in 1..=5 {
        let mut values = vec![0.0; degree + 1];
        values.extend([1.0, 1.0 + gap, 1.0 + 2.0 * gap]);
        values.extend(vec![2.0; degree + 1]);
        let knots = Knots::new(values, degree).unwrap();
        for t in [0.0, 0.5, 1.0 - gap / 2.0, 1.0, 1.0 + gap, 1.0 + 2.0 * gap, 1.0 + 3.0 * gap, 1.5, 2.0] {
            partition_of_unity(&knots, t);
        }
        // The line through the means of the knots stays the line.
        let mean = |i: usize| [knots.values()[i + 1..=i + degree].iter().sum::<f64>() / degree as f64];
        let line = BSpline::new(knots.clone(), (0..knots.functions()).map(mean)).unwrap();
        for t in [0.25, 1.0, 1.0 + gap, 1.75] {
            near(line.eval(t).unwrap()[0], t, 8.0 * (degree as f64 + 1.0), 2.0);
        }
    }
}

#[test]
fn row_30_spans_of_very_different_length() {
    for ratio in [1e6, 1e12, 1e15, 1e150] {
        let knots = Knots::new(vec![0.0, 0.0, 0.0, 0.0, 1.0, ratio, ratio, ratio, ratio], 3).unwrap();
        for t in [0.0, 1e-3, 0.5, 1.0, 2.0, ratio / 2.0, ratio] {
            partition_of_unity(&knots, t);
        }
        let mean =
            |i: usize| [(knots.values()[i + 1] / 3.0 + knots.values()[i + 2] / 3.0) + knots.values()[i + 3] / 3.0];
        let line = BSpline::new(knots.clone(), (0..5).map(mean)).unwrap();
        for t in [0.25, 1.0, 0.75 * ratio] {
            // The control points of the first span reach to ratio, and so may its rounding.
            near(line.eval(t).unwrap()[0], t, 16.0, t.max(1.0));
        }
    }
}

#[test]
fn row_31_unclamped_and_half_clamped_knots() {
    let points = [[0.0], [6.0], [0.0], [6.0], [12.0]];
    let uniform = BSpline::uniform(3, points).unwrap();
    let domain = uniform.domain();
    assert_eq!((domain.start, domain.end), (0.0, 2.0));
    // The first joint is (P₀ + 4P₁ + P₂)/6 and the last (P₂ + 4P₃ + P₄)/6; knots beyond are no domain.
    assert_eq!((uniform.eval(0.0).unwrap(), uniform.eval(2.0).unwrap()), ([4.0], [6.0]));
    for t in [-1.0, -3.0, 2.5, 5.0] {
        let error = refused(uniform.eval(t), "T002", None);
        assert!(error.message().contains("[0, 2]"), "{error}");
    }
    let half = BSpline::over(vec![0.0, 0.0, 0.0, 1.0, 2.0, 3.0], 2, [[5.0], [1.0], [3.0]]).unwrap();
    assert_eq!((half.domain().end, half.eval(0.0).unwrap(), half.eval(1.0).unwrap()), (1.0, [5.0], [2.0]));
    let closed = BSpline::closed_uniform(3, points).unwrap();
    assert_eq!((closed.domain().end, closed.eval(0.0).unwrap()), (5.0, [4.0]));
}

#[test]
fn row_32_at_a_knot_and_one_ulp_beside() {
    // Slopes 1, 3, −2 between the knots 0, 1, 2, 3.
    let bent = BSpline::over(vec![0.0, 0.0, 1.0, 2.0, 3.0, 3.0], 1, [[0.0], [1.0], [4.0], [2.0]]).unwrap();
    let slope = |t: f64, side: Side| {
        let mut jet = [[0.0]; 2];
        bent.jet_into(t, side, &mut jet);
        jet[1][0]
    };
    assert_eq!(
        [0.0, 1.0, 2.0, 3.0].map(|t| bent.jet(t, 1).unwrap()),
        [[[0.0], [1.0]], [[1.0], [3.0]], [[4.0], [-2.0]], [[2.0], [-2.0]]]
    );
    assert_eq!([0.0, 1.0, 2.0, 3.0].map(|t| slope(t, Side::Left)), [1.0, 1.0, 3.0, -2.0]);
    let below = f64::from_bits(1.0_f64.to_bits() - 1);
    assert_eq!([below, next_up(1.0)].map(|t| slope(t, Side::Right)), [1.0, 3.0]);
    // One step outside is outside.
    for t in [next_up(3.0), -f64::from_bits(1)] {
        refused(bent.eval(t), "T002", None);
        assert!(bent.eval_outside(t, Outside::Clamp).is_ok());
    }
    assert_eq!(bent.eval(-0.0).unwrap(), [0.0]);
}

#[test]
fn row_33_outside_is_a_policy() {
    // y = t² on [0, 2].
    let curve = BSpline::over(vec![0.0, 0.0, 0.0, 2.0, 2.0, 2.0], 2, [[0.0], [0.0], [4.0]]).unwrap();
    for t in [-1.0, 3.0, 1e300] {
        refused(curve.eval(t), "T002", None);
        refused(curve.eval_outside(t, Outside::Error), "T002", None);
    }
    let at = |t, outside| curve.eval_outside(t, outside).unwrap()[0];
    assert_eq!([-1.0, 3.0, 1e300].map(|t| at(t, Outside::Clamp)), [0.0, 4.0, 4.0]);
    assert_eq!([-1.0, 3.0, 100.0].map(|t| at(t, Outside::Extrapolate)), [1.0, 9.0, 10_000.0]);
    assert_eq!([-1.0, 3.0, 5.0, -0.5].map(|t| at(t, Outside::Periodic)), [1.0, 1.0, 1.0, 2.25]);
    // The square of 1e300 is beyond all numbers: refused, not infinite.
    refused(curve.eval_outside(1e300, Outside::Extrapolate), "P003", None);
    assert!(curve.eval_outside(1e300, Outside::Periodic).is_ok());
}

#[test]
fn row_34_a_seam_that_nearly_meets() {
    let path = |end: f64| {
        let arch = Bezier::new([[0.0, 0.0], [1.0, 2.0], [2.0, 0.0]]).unwrap();
        let base = Polyline::new([[2.0, 0.0], [end, 0.0]]).unwrap();
        Path::new([Box::new(arch) as Box<dyn Curve<2>>, Box::new(base)], true)
    };
    let error = refused(path(1e-12), "C002", None);
    assert!(error.message().contains("1e-12"), "{error}");
    assert!(path(0.0).unwrap().is_closed());
    // Closed splines have no second copy of the seam that could differ.
    let ring = BSpline::closed_uniform(3, [[0.0, -1.5], [1.5, 0.0], [0.0, 1.5], [-1.5, 0.0]]).unwrap();
    assert_eq!(continuity(&ring)[0], (0.0, Continuity::Order(2)));
}

#[test]
fn row_35_spans_without_length_in_derivatives() {
    // Where two knots are equal, textbooks divide zero by zero; the derivatives sum to zero all the same.
    for multiplicity in 1..=4 {
        let mut values = vec![0.0; 4];
        values.extend(vec![1.0; multiplicity]);
        values.extend([2.0; 4]);
        let knots = Knots::new(values, 3).unwrap();
        for t in [0.0, 0.5, 1.0, 1.5, 2.0] {
            for side in [Side::Left, Side::Right] {
                let rows = derivatives(&knots, knots.span(&t, side), &t, 5);
                for (order, row) in rows.iter().enumerate().skip(1) {
                    assert!(row.iter().all(|x| x.is_finite()), "{rows:?}");
                    near(row.iter().sum(), 0.0, 64.0, 48.0);
                    assert!(order <= 3 || row.iter().all(|x| *x == 0.0));
                }
            }
        }
    }
    // t³ on both sides of a double knot: control points 0, 0, 0, 2, 4, 8 by the blossom t₁t₂t₃.
    let knots = Knots::new(vec![0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 2.0, 2.0, 2.0, 2.0], 3).unwrap();
    let cube = BSpline::new(knots, [[0.0], [0.0], [0.0], [2.0], [4.0], [8.0]]).unwrap();
    for (t, exact) in [(0.5, [0.125, 0.75, 3.0, 6.0]), (1.0, [1.0, 3.0, 6.0, 6.0]), (2.0, [8.0, 12.0, 12.0, 6.0])] {
        assert_eq!(cube.jet(t, 3).unwrap().concat(), exact);
    }
}
