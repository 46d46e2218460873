//! The slopes of cubic splines, run on fractions, against an oracle that never heard of slopes.
//!
//! The oracle solves one dense system for the 4n coefficients of all pieces. Every pair of end conditions is tried over
//! intervals of very different lengths, from two points up.

#![allow(clippy::unwrap_used)] // a failing unwrap is a failing test

use lath::curve::{Curve, Interval};
use lath::error::Code;
use lath::interpolate::{End, Ends, Parameters, cubic, cubic_closed, parameters, slopes, slopes_closed};
use lath::knot::Side;
use lath::num::Scalar;
use testkit::naive;
use testkit::rational::{Rational, ratio};

/// Parameters and values that no accident makes simple.
fn data(points: usize) -> (Vec<Rational>, Vec<Rational>) {
    let t = [(0, 1), (1, 3), (2, 1), (9, 4), (100, 7), (15, 1), (31, 2)];
    let y = [(2, 1), (-1, 5), (7, 3), (7, 3), (0, 1), (-40, 9), (1, 1)];
    let take = |table: &[(i64, i64)]| table.iter().take(points).map(|&(a, b)| ratio(a, b)).collect();
    (take(&t), take(&y))
}

fn intervals(t: &[Rational]) -> Vec<Rational> {
    t.windows(2).map(|pair| pair[1].clone() - pair[0].clone()).collect()
}

fn columns(y: &[Rational]) -> Vec<[Rational; 1]> {
    y.iter().map(|y| [y.clone()]).collect()
}

/// The oracle's first derivatives at the parameters.
fn oracle(t: &[Rational], y: &[Rational], ends: &naive::Ends) -> Option<Vec<[Rational; 1]>> {
    let pieces = naive::cubic_spline(t, y, ends)?;
    Some(t.iter().map(|at| [naive::piecewise(t, &pieces, 1, at)]).collect())
}

#[test]
fn every_pair_of_end_conditions_is_exact() {
    let value = ratio(-3, 7);
    let kinds: [(End<1, Rational>, naive::End); 4] = [
        (End::Natural, naive::End::Natural),
        (End::NotAKnot, naive::End::NotAKnot),
        (End::Clamped([value.clone()]), naive::End::Clamped(value.clone())),
        (End::Second([value.clone()]), naive::End::Second(value.clone())),
    ];
    let mut compared = 0;
    for points in 3..=7 {
        let (t, y) = data(points);
        for (start, naive_start) in &kinds {
            for (end, naive_end) in &kinds {
                if points == 3 && *start == End::NotAKnot && *end == End::NotAKnot {
                    continue; // both speak of the same point: the parabola, below
                }
                let ends = naive::Ends::Open(naive_start.clone(), naive_end.clone());
                let expected = oracle(&t, &y, &ends).unwrap();
                let found = slopes(&intervals(&t), &columns(&y), &Ends::Open(start.clone(), end.clone())).unwrap();
                assert_eq!(found, expected, "{points} points, {start:?} … {end:?}");
                compared += 1;
            }
        }
    }
    assert_eq!(compared, 5 * 16 - 1);
}

#[test]
fn cyclic_and_anticyclic_ends_are_exact() {
    for points in 3..=7 {
        let (t, y) = data(points);
        let cases = [(Ends::Cyclic, naive::Ends::Cyclic), (Ends::Anticyclic, naive::Ends::Anticyclic)];
        for (ends, naive_ends) in cases {
            let found = slopes(&intervals(&t), &columns(&y), &ends).unwrap();
            assert_eq!(found, oracle(&t, &y, &naive_ends).unwrap(), "{points} points, {ends:?}");
        }
    }
}

#[test]
fn a_closed_spline_is_the_cyclic_one_over_equal_ends() {
    for points in 3..=7 {
        let (t, mut y) = data(points);
        *y.last_mut().unwrap() = y[0].clone();
        let found = slopes_closed(&intervals(&t), &columns(&y[..points - 1])).unwrap();
        let expected = oracle(&t, &y, &naive::Ends::Cyclic).unwrap();
        assert_eq!(found, expected[..points - 1], "{points} points");
    }
}

#[test]
fn few_points_take_lower_degrees() {
    let (t, y) = data(3);
    let (h, y) = (intervals(&t), columns(&y));
    let free = Ends::Open(End::NotAKnot, End::NotAKnot);
    // Two points: the straight line.
    let chord = (y[1][0].clone() - y[0][0].clone()) / h[0].clone();
    assert_eq!(slopes(&h[..1], &y[..2], &free).unwrap(), [[chord.clone()], [chord.clone()]]);
    // Three points: the parabola, whose slopes average to each chord.
    let m = slopes(&h, &y, &free).unwrap();
    for k in 0..2 {
        let chord = (y[k + 1][0].clone() - y[k][0].clone()) / h[k].clone();
        assert_eq!((m[k][0].clone() + m[k + 1][0].clone()) / ratio(2, 1), chord);
    }
    let second = |k: usize| (m[k + 1][0].clone() - m[k][0].clone()) / h[k].clone();
    assert_eq!(second(0), second(1));
    // One free end over a single interval: no third derivative.
    let m = slopes(&h[..1], &y[..2], &Ends::Open(End::Clamped([ratio(5, 1)]), End::NotAKnot)).unwrap();
    assert_eq!(m[0], [ratio(5, 1)]);
    assert_eq!((m[0][0].clone() + m[1][0].clone()) / ratio(2, 1), chord);
}

#[test]
fn normalised_intervals_give_the_rows_1_4_1() {
    // S10: with all intervals 1, inner rows 1 4 1 and right sides 3 (P_{k+2} − P_k).
    let y: Vec<[Rational; 2]> =
        [(0, 0), (1, 3), (2, -1), (5, 2), (4, 4)].map(|(a, b)| [ratio(a, 1), ratio(b, 1)]).to_vec();
    let h = vec![Rational::one(); 4];
    let slope = |a, b| [ratio(a, 1), ratio(b, 1)];
    let m = slopes(&h, &y, &Ends::Open(End::Clamped(slope(1, 1)), End::Clamped(slope(0, -2)))).unwrap();
    assert_eq!((&m[0], &m[4]), (&slope(1, 1), &slope(0, -2)));
    for k in 0..3 {
        for c in 0..2 {
            let row = m[k][c].clone() + ratio(4, 1) * m[k + 1][c].clone() + m[k + 2][c].clone();
            assert_eq!(row, ratio(3, 1) * (y[k + 2][c].clone() - y[k][c].clone()));
        }
    }
}

#[test]
fn floats_agree_with_fractions() {
    let (t, y) = data(7);
    let (tf, yf): (Vec<f64>, Vec<f64>) =
        (t.iter().map(Rational::to_f64).collect(), y.iter().map(Rational::to_f64).collect());
    let (t, y): (Vec<Rational>, Vec<Rational>) =
        (tf.iter().map(|x| Rational::from_f64(*x)).collect(), yf.iter().map(|x| Rational::from_f64(*x)).collect());
    for ends in [Ends::Open(End::NotAKnot, End::Natural), Ends::Cyclic, Ends::Anticyclic] {
        let exact_ends = match ends {
            Ends::Open(..) => Ends::Open(End::NotAKnot, End::Natural),
            Ends::Cyclic => Ends::Cyclic,
            Ends::Anticyclic => Ends::Anticyclic,
        };
        let exact = slopes(&intervals(&t), &columns(&y), &exact_ends).unwrap();
        let largest = exact.iter().map(|m| m[0].abs().to_f64()).fold(0.0, f64::max);
        let points: Vec<[f64; 1]> = yf.iter().map(|y| [*y]).collect();
        let curve = cubic(points, tf.clone(), &ends).unwrap();
        for (found, exact) in curve.tangents().iter().zip(&exact) {
            let error = (found[0] - exact[0].to_f64()).abs();
            assert!(error <= 8.0 * f64::EPSILON * largest, "{ends:?}: {error:e}");
        }
    }
}

#[test]
fn the_anticyclic_equations_hold_on_a_real_outline() {
    // Half an airfoil, nose to tail, in the plane.
    let points = [[0.0, 0.0], [0.0125, 0.0195], [0.1, 0.047], [0.4, 0.06], [0.8, 0.02], [1.0, 0.001]];
    let t = parameters(&points, false, Parameters::Centripetal).unwrap();
    let curve = cubic(points, t, &Ends::Anticyclic).unwrap();
    let Interval { start, end } = curve.domain();
    let (mut first, mut last) = ([[0.0; 2]; 3], [[0.0; 2]; 3]);
    curve.jet_into(start, Side::Right, &mut first);
    curve.jet_into(end, Side::Left, &mut last);
    for k in 1..3 {
        let scale = first[k].iter().chain(&last[k]).fold(0.0, |m: f64, x| m.max(x.abs()));
        for c in 0..2 {
            assert!((first[k][c] + last[k][c]).abs() <= 1e-12 * scale, "{first:?} {last:?}");
        }
    }
}

#[test]
fn bad_data_is_refused_by_name() {
    let free = || Ends::Open(End::NotAKnot, End::NotAKnot);
    let fault = |points: Vec<[f64; 1]>, t: Vec<f64>, ends: &Ends<1>| {
        let error = cubic(points, t, ends).unwrap_err();
        (error.code(), error.index())
    };
    let y = || vec![[0.0], [1.0], [0.0]];
    assert_eq!(fault(vec![[0.0]], vec![0.0], &free()), (Code::P001, None));
    assert_eq!(fault(y(), vec![0.0, 1.0], &free()), (Code::T004, None));
    assert_eq!(fault(y(), vec![0.0, 1.0, 1.0], &free()), (Code::T003, Some(2)));
    assert_eq!(fault(y(), vec![0.0, f64::NAN, 1.0], &free()), (Code::T001, Some(1)));
    assert_eq!(fault(vec![[0.0], [f64::INFINITY], [0.0]], vec![0.0, 1.0, 2.0], &free()), (Code::P002, Some(1)));
    assert_eq!(fault(y(), vec![0.0, 1e-310, 1.0], &free()), (Code::P003, Some(0)));
    let clamped = Ends::Open(End::Clamped([f64::NAN]), End::Natural);
    assert_eq!(fault(y(), vec![0.0, 1.0, 2.0], &clamped).0, Code::P002);
    assert_eq!(cubic_closed([[0.0], [1.0]], vec![0.0, 1.0]).unwrap_err().code(), Code::T004);
    assert_eq!(cubic_closed([[0.0]], vec![0.0, 1.0]).unwrap_err().code(), Code::P001);
}
