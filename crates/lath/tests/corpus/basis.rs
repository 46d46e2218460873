//! Basis functions against their polynomials.

use crate::{between, derivative, polynomial};
use lath::basis::{bernstein, bspline, hermite};
use lath::knot::{Knots, Side};
use lath::num::Scalar;
use testkit::corpus::{Entry, load};
use testkit::error_measure::units;
use testkit::naive;
use testkit::rational::{Rational, ratio};

fn cases(kind: &str) -> Vec<Entry> {
    let found: Vec<Entry> = load("basis").into_iter().filter(|case| case.text("kind") == kind).collect();
    assert!(!found.is_empty());
    found
}

/// Calls back with every function's pieces inside the domain: (knots, span, function, from, to, coefficients, derivative).
fn pieces(mut visit: impl FnMut(&Entry, &Knots<Rational>, usize, usize, &[Rational; 2], &[Rational], usize)) {
    for case in cases("bspline") {
        let knots = Knots::new(case.numbers("knots"), case.count("degree")).unwrap();
        let order = case.count_if("derivative").unwrap_or(0);
        let (start, end) = knots.domain();
        for function in case.entries("functions") {
            for piece in function.entries("pieces") {
                let ends = [piece.number("from"), piece.number("to")];
                if start <= ends[0] && ends[1] <= end {
                    let span = knots.span(&ends[0], Side::Right);
                    assert_eq!(knots.values()[span..span + 2], ends, "{}", case.place);
                    visit(&case, &knots, span, function.count("index"), &ends, &piece.numbers("coefficients"), order);
                }
            }
        }
    }
}

#[test]
fn bsplines_are_their_polynomials_exactly() {
    let mut compared = 0;
    pieces(|case, knots, span, index, [from, to], coefficients, order| {
        let degree = knots.degree();
        for t in between(from, to) {
            let place = format!("{}: N{index} at {t}", case.place);
            let expected = polynomial(coefficients, &t);
            let rows = bspline::derivatives(knots, span, &t, degree + 1);
            assert_eq!(rows[order][index + degree - span], expected, "{place}");
            if order == 0 {
                assert_eq!(bspline::values(knots, span, &t)[index + degree - span], expected, "{place}");
            }
            let mut coefficients = coefficients.to_vec();
            for (k, row) in rows.iter().enumerate().skip(order) {
                assert_eq!(row[index + degree - span], polynomial(&coefficients, &t), "{place}, derivative {k}");
                coefficients = derivative(&coefficients);
            }
            compared += 1;
        }
    });
    assert!(compared > 700, "{compared}");
}

#[test]
fn the_oracle_agrees_with_the_polynomials() {
    pieces(|case, knots, _, index, [from, to], coefficients, order| {
        for t in between(from, to) {
            let side = if t == *to { Side::Left } else { Side::Right };
            let found = naive::bspline_derivative(knots.values(), knots.degree(), index, order, &t, side);
            assert_eq!(found, polynomial(coefficients, &t), "{}: N{index} at {t}", case.place);
        }
    });
}

#[test]
fn bsplines_on_floats_are_off_by_a_few_roundings() {
    let mut worst: f64 = 0.0;
    pieces(|case, knots, span, index, [from, to], coefficients, order| {
        if order > 0 {
            return;
        }
        let degree = knots.degree();
        let floats = Knots::new(case.floats("knots"), degree).unwrap();
        for t in between(from, to).into_iter().filter(Rational::is_f64) {
            let found = bspline::values(&floats, span, &t.to_f64())[index + degree - span];
            let expected = polynomial(coefficients, &t);
            // Sums of non-negative numbers only: the error is small relative to the value itself.
            let off = units(found, &expected, &expected);
            assert!(off <= 5.0 * degree as f64, "{}: N{index} at {t} is {off} u off", case.place);
            worst = worst.max(off);
        }
    });
    assert!(worst > 0.0, "some function is not a float");
}

#[test]
fn functions_outside_a_span_are_zero_and_those_inside_sum_to_one() {
    for case in cases("bspline").iter().filter(|case| !case.has("derivative")) {
        let knots = Knots::new(case.numbers("knots"), case.count("degree")).unwrap();
        let breaks = knots.breaks();
        for pair in breaks.windows(2) {
            for t in between(&pair[0], &pair[1]) {
                let side = naive::default_side(knots.values(), knots.degree(), &t);
                let span = knots.span(&t, side);
                let values = bspline::values(&knots, span, &t);
                assert_eq!(values.iter().cloned().sum::<Rational>(), 1, "{} at {t}", case.place);
                for index in 0..knots.functions() {
                    let place = (index + knots.degree()).checked_sub(span).and_then(|j| values.get(j));
                    let found = place.cloned().unwrap_or_else(Rational::zero);
                    assert!(found >= 0);
                    assert_eq!(
                        found,
                        naive::bspline(knots.values(), knots.degree(), index, &t, side),
                        "{}",
                        case.place
                    );
                }
            }
        }
    }
}

#[test]
fn shifting_the_knots_shifts_the_functions() {
    let shift = ratio(-22, 7);
    pieces(|case, knots, span, _, [from, to], _, _| {
        let moved = knots.values().iter().map(|t| t.clone() + shift.clone()).collect();
        let moved = Knots::new(moved, knots.degree()).unwrap();
        for t in between(from, to) {
            let there = t.clone() + shift.clone();
            assert_eq!(bspline::values(knots, span, &t), bspline::values(&moved, span, &there), "{}", case.place);
        }
    });
}

#[test]
fn bernstein_polynomials_are_exact() {
    for case in cases("bernstein") {
        let degree = case.count("degree");
        for u in between(&ratio(-1, 1), &ratio(2, 1)) {
            let values = bernstein::values(degree, &u);
            assert_eq!(values.iter().cloned().sum::<Rational>(), 1);
            for function in case.entries("functions") {
                let (index, coefficients) = (function.count("index"), function.numbers("coefficients"));
                assert_eq!(values[index], polynomial(&coefficients, &u), "{}: J{index} at {u}", case.place);
                assert_eq!(values[index], naive::bernstein(degree, index, &u), "{}: J{index} at {u}", case.place);
            }
        }
    }
}

#[test]
fn bernstein_polynomials_on_floats_are_off_by_a_few_roundings() {
    for case in cases("bernstein") {
        let degree = case.count("degree");
        for k in 0..=64 {
            let u = f64::from(k) / 64.0;
            let exact = Rational::from_f64(u);
            for (index, value) in bernstein::values(degree, &u).into_iter().enumerate() {
                let expected = naive::bernstein(degree, index, &exact);
                let off = units(value, &expected, &expected);
                assert!(off <= 3.0 * degree as f64, "{}: J{index} at {u} is {off} u off", case.place);
            }
        }
    }
}

#[test]
fn hermite_functions_and_their_derivatives_are_exact() {
    for case in cases("hermite") {
        let h = case.number("interval");
        for u in between(&ratio(0, 1), &ratio(1, 1)) {
            let rows = hermite::blending(&u, &h);
            for function in case.entries("functions") {
                let (index, mut coefficients) = (function.count("index"), function.numbers("coefficients"));
                for (k, row) in rows.iter().enumerate() {
                    // Derivatives are for t = u h: each order divides by h.
                    let expected = polynomial(&coefficients, &u) / h.power(k);
                    assert_eq!(row[index], expected, "{}: F{} at {u}, derivative {k}", case.place, index + 1);
                    coefficients = derivative(&coefficients);
                }
            }
        }
    }
}

/// Row by row a matrix holds the power coefficients of the basis functions, which are their derivatives at 0 over k!.
#[test]
fn matrices_hold_the_power_coefficients() {
    let one = Rational::one();
    for case in cases("matrix") {
        let (degree, rows) = (case.count("degree"), case.rows("rows"));
        assert_eq!(case.text("powers"), "descending");
        let derivatives: Vec<Vec<Rational>> = match case.text("basis") {
            "bspline" => {
                let knots = Knots::uniform(degree + 1, degree).unwrap();
                bspline::derivatives(&knots, degree, &Rational::zero(), degree)
            }
            // Functions one by one: a control polygon that is 1 in one place.
            "bezier" => {
                let unit = |i: usize| (0..=degree).map(|j| [Rational::from(i64::from(i == j))]).collect::<Vec<_>>();
                let jets = (0..=degree).map(|i| {
                    let mut out = vec![[Rational::zero()]; degree + 1];
                    bernstein::jet(&unit(i), &Rational::zero(), &one, &Rational::zero(), &mut out);
                    out
                });
                let jets: Vec<_> = jets.collect();
                (0..=degree).map(|k| jets.iter().map(|jet| jet[k][0].clone()).collect()).collect()
            }
            "hermite" => hermite::blending(&Rational::zero(), &one).map(Vec::from).to_vec(),
            other => panic!("{}: unknown basis {other}", case.place),
        };
        for (k, row) in derivatives.iter().enumerate() {
            let factorial = (1..=k as i64).fold(Rational::one(), |product, i| product * Rational::from(i));
            let coefficients: Vec<Rational> = row.iter().map(|d| d.clone() / factorial.clone()).collect();
            assert_eq!(coefficients, rows[degree - k], "{}: row of t^{k}", case.place);
        }
    }
}
