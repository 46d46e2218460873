//! Cubic splines through points, and the parameters by rule.

use crate::refused;
use lath::basis::{bernstein, hermite};
use lath::curve::{Curve, Hermite};
use lath::error::Result;
use lath::interpolate::{End, Ends, Parameters, cubic, cubic_closed, parameters, slopes, slopes_closed};
use lath::num::Scalar;
use testkit::corpus::{Entry, load};
use testkit::rational::Rational;

/// The ends of a case, its vectors read by `number`.
fn ends<const D: usize, S: Scalar>(case: &Entry, number: impl Fn(&Rational) -> S) -> Ends<D, S> {
    let one = |key: &str| {
        let (kind, rest) = case.text(key).split_once(':').unwrap_or((case.text(key), ""));
        let vector = || -> [S; D] {
            let numbers: Vec<S> = rest.split(',').map(|text| number(&text.parse().unwrap())).collect();
            numbers.try_into().unwrap_or_else(|_| panic!("{}: {key} has another dimension", case.place))
        };
        match kind {
            "natural" => End::Natural,
            "not-a-knot" => End::NotAKnot,
            "clamped" => End::Clamped(vector()),
            "second" => End::Second(vector()),
            other => panic!("{}: unknown condition {other}", case.place),
        }
    };
    match case.text_if("ends") {
        Some("cyclic") => Ends::Cyclic,
        Some("anticyclic") => Ends::Anticyclic,
        Some(other) => panic!("{}: unknown ends {other}", case.place),
        None => Ends::Open(one("start"), one("end")),
    }
}

fn points<const D: usize>(case: &Entry) -> Vec<[f64; D]> {
    case.float_rows("points").iter().map(|row| row[..].try_into().unwrap()).collect()
}

fn through<const D: usize>(case: &Entry) -> Result<Hermite<D>> {
    if case.flag("closed") {
        return cubic_closed(points::<D>(case), case.floats("parameters"));
    }
    cubic(points::<D>(case), case.floats("parameters"), &ends(case, Rational::to_f64))
}

fn replay<const D: usize>(case: &Entry) {
    let Some(curve) = refused(case, through::<D>(case)) else {
        return;
    };
    let close = |found: &[f64], expected: &[Rational], size: f64, what: &str| {
        for (found, expected) in found.iter().zip(expected) {
            let off = (found - expected.to_f64()).abs();
            assert!(off <= 1e-14 * size, "{}: {what} is {found}, not {expected}", case.place);
        }
    };
    let size = |rows: &[Vec<Rational>]| rows.iter().flatten().fold(1.0, |most: f64, x| most.max(x.to_f64().abs()));
    let tangents = case.rows("tangents");
    for (found, expected) in curve.tangents().iter().zip(&tangents) {
        close(found, expected, size(&tangents), "a tangent");
    }
    for (key, k) in [("value", 0), ("d1", 1), ("d2", 2)] {
        let column: Vec<Vec<Rational>> = case.entries("at").iter().map(|at| at.numbers(key)).collect();
        for (at, expected) in case.entries("at").iter().zip(&column) {
            let found = curve.jet(at.float("t"), 2).unwrap()[k];
            close(&found, expected, 16.0 * size(&column), &format!("{key} at {}", at.float("t")));
        }
    }
}

/// On fractions, one coordinate after the other: slopes at the points, values and derivatives between them.
fn exactly(case: &Entry, c: usize) {
    let column = |key: &str| -> Vec<[Rational; 1]> { case.rows(key).iter().map(|row| [row[c].clone()]).collect() };
    let (t, values, closed) = (case.numbers("parameters"), column("points"), case.flag("closed"));
    let h: Vec<Rational> = t.windows(2).map(|pair| pair[1].clone() - pair[0].clone()).collect();
    let one = |all: &Ends<1, Rational>| slopes(&h, &values, all).unwrap();
    let found = match case.rows("points")[0].len() {
        _ if closed => slopes_closed(&h, &values).unwrap(),
        1 => one(&ends::<1, _>(case, Rational::clone)),
        2 => one(&coordinate(ends::<2, _>(case, Rational::clone), c)),
        _ => one(&coordinate(ends::<3, _>(case, Rational::clone), c)),
    };
    assert_eq!(found, column("tangents"), "{}, coordinate {c}", case.place);
    for at in case.entries("at") {
        let x = at.number("t");
        let k = (0..h.len()).rev().find(|&k| t[k] <= x).unwrap();
        let next = (k + 1) % values.len();
        let piece = hermite::to_bernstein(&values[k], &found[k], &values[next], &found[next], &h[k]);
        let mut jet = vec![[Rational::zero()]; 3];
        bernstein::jet(&piece, &t[k], &t[k + 1], &x, &mut jet);
        let expected = ["value", "d1", "d2"].map(|key| [at.numbers(key)[c].clone()]);
        assert_eq!(jet, expected, "{} at {x}, coordinate {c}", case.place);
    }
}

/// The condition of one coordinate.
fn coordinate<const D: usize>(all: Ends<D, Rational>, c: usize) -> Ends<1, Rational> {
    let one = |end: End<D, Rational>| match end {
        End::Natural => End::Natural,
        End::NotAKnot => End::NotAKnot,
        End::Clamped(vector) => End::Clamped([vector[c].clone()]),
        End::Second(vector) => End::Second([vector[c].clone()]),
    };
    match all {
        Ends::Open(start, end) => Ends::Open(one(start), one(end)),
        Ends::Cyclic => Ends::Cyclic,
        Ends::Anticyclic => Ends::Anticyclic,
    }
}

fn splines() -> Vec<Entry> {
    load("interpolate").into_iter().filter(|case| !case.has("rule")).collect()
}

#[test]
fn splines_are_exact_on_fractions() {
    let mut compared = 0;
    for case in splines().iter().filter(|case| !case.has("error")) {
        for c in 0..case.rows("points")[0].len() {
            exactly(case, c);
            compared += 1;
        }
    }
    assert!(compared > 50, "{compared}");
}

#[test]
fn splines_on_floats_are_off_by_rounding() {
    for case in splines() {
        match case.float_rows("points").first().map_or(1, Vec::len) {
            1 => replay::<1>(&case),
            2 => replay::<2>(&case),
            3 => replay::<3>(&case),
            other => panic!("{}: {other} dimensions", case.place),
        }
    }
}

#[test]
fn parameters_follow_their_rule() {
    for case in load("interpolate").iter().filter(|case| case.has("rule")) {
        let rule = match case.text("rule") {
            "uniform" => Parameters::Uniform,
            "chord" => Parameters::Chord,
            "centripetal" => Parameters::Centripetal,
            other => panic!("{}: unknown rule {other}", case.place),
        };
        let closed = case.flag("closed");
        let found = match case.float_rows("points")[0].len() {
            2 => parameters(&points::<2>(case), closed, rule),
            _ => parameters(&points::<3>(case), closed, rule),
        };
        if let Some(found) = refused(case, found) {
            assert_eq!(found, case.floats("parameters"), "{}", case.place);
        }
    }
}
