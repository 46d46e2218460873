//! Curves by their shapes: the families on floats, the algorithms under them on fractions.

use crate::refused;
use lath::basis::rational::Functions;
use lath::basis::{bernstein, bspline, hermite};
use lath::curve::{BSpline, Bezier, Curve, Hermite, Interval, Polyline, Power, QuinticHermite};
use lath::error::Result;
use lath::knot::{Knots, Side};
use lath::num::Scalar;
use testkit::corpus::{Entry, load};
use testkit::error_measure::units;
use testkit::rational::Rational;

/// The shape's curve in D dimensions.
fn build<const D: usize>(shape: &Entry) -> Result<Box<dyn Curve<D>>> {
    let points =
        |key: &str| -> Vec<[f64; D]> { shape.float_rows(key).iter().map(|row| row[..].try_into().unwrap()).collect() };
    let closed = shape.flag("closed");
    if shape.has("weights") {
        return weighted::<D>(shape, points("points"));
    }
    Ok(match shape.text("kind") {
        "bezier" if shape.has("domain") => {
            let domain = shape.floats("domain");
            Box::new(Bezier::on(points("points"), Interval { start: domain[0], end: domain[1] })?)
        }
        "bezier" => Box::new(Bezier::new(points("points"))?),
        "bspline" => {
            let (degree, points) = (shape.count("degree"), points("points"));
            match (shape.has("knots").then(|| shape.floats("knots")), closed) {
                (Some(knots), false) => Box::new(BSpline::new(Knots::new(knots, degree)?, points)?),
                (None, false) => Box::new(BSpline::uniform(degree, points)?),
                (Some(period), true) => Box::new(BSpline::closed(&period, degree, points)?),
                (None, true) => Box::new(BSpline::closed_uniform(degree, points)?),
            }
        }
        "hermite" if closed => {
            Box::new(Hermite::closed(shape.floats("parameters"), points("points"), points("tangents"))?)
        }
        "hermite" => Box::new(Hermite::new(shape.floats("parameters"), points("points"), points("tangents"))?),
        "quintic-hermite" => {
            let (tangents, seconds) = (points("tangents"), points("seconds"));
            Box::new(QuinticHermite::new(shape.floats("parameters"), points("points"), tangents, seconds)?)
        }
        "polyline" => Box::new(Polyline::new(points("points"))?),
        "power" => {
            let pieces = shape.float_blocks("coefficients");
            let piece = |piece: &Vec<Vec<f64>>| -> Vec<[f64; D]> {
                piece.iter().map(|row| row[..].try_into().unwrap()).collect()
            };
            Box::new(Power::new(shape.floats("breaks"), pieces.iter().map(piece))?)
        }
        other => panic!("{}: unknown kind {other}", shape.place),
    })
}

/// The shape's curve with its weights.
fn weighted<const D: usize>(shape: &Entry, points: Vec<[f64; D]>) -> Result<Box<dyn Curve<D>>> {
    let weights = shape.floats("weights");
    if shape.text("kind") == "bezier" {
        let domain = if shape.has("domain") { shape.floats("domain") } else { vec![0.0, 1.0] };
        let bezier = Bezier::on(points, Interval { start: domain[0], end: domain[1] })?;
        return Ok(Box::new(bezier.weighted(weights)?));
    }
    let degree = shape.count("degree");
    let spline = match (shape.has("knots").then(|| shape.floats("knots")), shape.flag("closed")) {
        (Some(knots), false) => BSpline::new(Knots::new(knots, degree)?, points)?,
        (None, false) => BSpline::uniform(degree, points)?,
        (Some(period), true) => BSpline::closed(&period, degree, points)?,
        (None, true) => BSpline::closed_uniform(degree, points)?,
    };
    Ok(Box::new(spline.weighted(weights)?))
}

fn dimension(shape: &Entry) -> usize {
    if shape.has("coefficients") {
        shape.float_blocks("coefficients").iter().flatten().next().map_or(1, Vec::len)
    } else {
        shape.float_rows("points").first().map_or(1, Vec::len)
    }
}

/// The rows of `at`: t, side, and the exact value and derivatives.
fn rows(case: &Entry) -> Vec<(Entry, Side, Vec<Vec<Rational>>)> {
    let row = |at: Entry| {
        let side = if at.text_if("side") == Some("left") { Side::Left } else { Side::Right };
        let derivatives = (1..).map(|k| format!("d{k}")).take_while(|key| at.has(key)).map(|key| at.numbers(&key));
        let jet = std::iter::once(at.numbers("value")).chain(derivatives).collect();
        (at, side, jet)
    };
    case.entries("at").into_iter().map(row).collect()
}

fn replay<const D: usize>(case: &Entry) -> usize {
    let shape = case.entry("shape");
    let Some(curve) = refused(case, build::<D>(&shape)) else {
        return 0;
    };
    let domain = curve.domain();
    if case.has("domain") {
        assert_eq!(case.floats("domain"), [domain.start, domain.end], "{}", case.place);
    }
    assert_eq!((curve.kind(), curve.is_closed()), (shape.text("kind"), shape.flag("closed")), "{}", case.place);
    // Rounding is measured by the pieces: the size of their points, and 2p/h for each derivative.
    let (mut size, mut shortest) = (0.0, f64::MAX);
    let polynomial = curve.bezier_pieces(&mut |piece| {
        size = piece.points.iter().flatten().fold(size, |most: f64, x| most.max(x.abs()));
        shortest = shortest.min(piece.end - piece.start);
    });
    let rational = curve.rational_pieces(&mut |piece| {
        size = piece.points.iter().flat_map(|point| &point.point).fold(size, |most: f64, x| most.max(x.abs()));
        shortest = shortest.min(piece.end - piece.start);
    });
    assert!(polynomial != rational && rational == shape.has("weights"), "{}", case.place);
    // Weights in the corpus differ by some dozens at most between neighbours.
    let amplified = if rational { 8.0 } else { 2.0 };
    let degree = curve.degree().max(1) as f64;
    let mut compared = 0;
    for (at, side, expected) in rows(case) {
        let t = at.float("t");
        let mut out = vec![[0.0; D]; expected.len()];
        curve.jet_into(t, side, &mut out);
        let mut condition = Rational::from_f64(size);
        for (k, (found, expected)) in out.iter().zip(&expected).enumerate() {
            for c in 0..D {
                let place = format!("{} at {t} from {side:?}, derivative {k}, coordinate {c}", case.place);
                if case.flag("exact") {
                    assert_eq!(Rational::from_f64(found[c]), expected[c], "{place}");
                }
                let off = units(found[c], &expected[c], &condition);
                assert!(off <= 10.0 * degree, "{place}: {} is {off} u off {}", found[c], expected[c]);
                compared += 1;
            }
            condition = condition * Rational::from_f64(amplified * degree / shortest);
        }
        if side == Side::Right || t == domain.end {
            assert_eq!(curve.eval(t).unwrap(), out[0], "{}", case.place);
            assert_eq!(curve.jet(t, expected.len() - 1).unwrap(), out, "{}", case.place);
        }
    }
    compared
}

#[test]
fn every_family_answers_its_cases() {
    let mut compared = 0;
    for case in load("curve") {
        compared += match dimension(&case.entry("shape")) {
            1 => replay::<1>(&case),
            2 => replay::<2>(&case),
            3 => replay::<3>(&case),
            other => panic!("{}: {other} dimensions", case.place),
        };
    }
    assert!(compared > 600, "{compared}");
}

/// One coordinate of the points, as the core's vectors of one fraction.
fn column(rows: &[Vec<Rational>], c: usize) -> Vec<[Rational; 1]> {
    rows.iter().map(|row| [row[c].clone()]).collect()
}

/// The span of increasing parameters that answers for t.
fn interval(parameters: &[Rational], t: &Rational, side: Side) -> usize {
    let inside = |k: &usize| if side == Side::Right { parameters[*k] <= *t } else { parameters[*k] < *t };
    (0..parameters.len() - 1).rev().find(inside).unwrap_or(0)
}

/// The jet at t by the core's generic algorithms; none for a family that is made of another's.
fn on_fractions(shape: &Entry, t: &Rational, side: Side, c: usize, orders: usize) -> Option<Vec<[Rational; 1]>> {
    let mut out = vec![[Rational::zero()]; orders];
    let weights = shape.has("weights").then(|| shape.numbers("weights"));
    match shape.text("kind") {
        "bezier" => {
            let domain =
                if shape.has("domain") { shape.numbers("domain") } else { vec![Rational::zero(), Rational::one()] };
            let points = column(&shape.rows("points"), c);
            match weights {
                None => bernstein::jet(&points, &domain[0], &domain[1], t, &mut out),
                Some(weights) => {
                    let functions = Functions::Bernstein { start: &domain[0], end: &domain[1] };
                    functions.rational_jet(&points, &weights, t, &mut out);
                }
            }
        }
        "bspline" => {
            let (degree, points) = (shape.count("degree"), shape.rows("points"));
            let n = points.len();
            let knots = match (shape.has("knots").then(|| shape.numbers("knots")), shape.flag("closed")) {
                (Some(knots), false) => Knots::new(knots, degree),
                (None, false) => Knots::uniform(n, degree),
                (Some(period), true) => Knots::periodic(&period, degree),
                (None, true) => Knots::periodic(&(0..=n as i64).map(Rational::from).collect::<Vec<_>>(), degree),
            };
            let knots = knots.unwrap();
            let span = knots.span(t, side);
            let local: Vec<Vec<Rational>> = (span - degree..=span).map(|i| points[i % n].clone()).collect();
            match weights {
                None => bspline::jet(&knots, span, &column(&local, c), t, &mut out),
                Some(weights) => {
                    let weights: Vec<Rational> = (span - degree..=span).map(|i| weights[i % n].clone()).collect();
                    let functions = Functions::Splines { knots: &knots, span };
                    functions.rational_jet(&column(&local, c), &weights, t, &mut out);
                }
            }
        }
        "hermite" => {
            let (parameters, points, tangents) =
                (shape.numbers("parameters"), shape.rows("points"), shape.rows("tangents"));
            let k = interval(&parameters, t, side);
            let next = (k + 1) % points.len();
            let (a, b) = (&parameters[k], &parameters[k + 1]);
            let h = b.clone() - a.clone();
            let at = |rows: &[Vec<Rational>], i: usize| [rows[i][c].clone()];
            let piece =
                hermite::to_bernstein(&at(&points, k), &at(&tangents, k), &at(&points, next), &at(&tangents, next), &h);
            bernstein::jet(&piece, a, b, t, &mut out);
            // The same by the blending functions.
            let rows = hermite::blending(&((t.clone() - a.clone()) / h.clone()), &h);
            for (row, value) in rows.iter().zip(&out) {
                let data = [at(&points, k), at(&points, next), at(&tangents, k), at(&tangents, next)];
                let sum: Rational = row.iter().zip(&data).map(|(f, [x])| f.clone() * x.clone()).sum();
                assert_eq!(sum, value[0], "{}", shape.place);
            }
        }
        _ => return None,
    }
    Some(out)
}

#[test]
fn the_algorithms_are_exact_on_fractions() {
    let mut compared = 0;
    for case in load("curve").iter().filter(|case| !case.has("error")) {
        let shape = case.entry("shape");
        for (at, side, expected) in rows(case) {
            for c in 0..dimension(&shape) {
                let Some(found) = on_fractions(&shape, &at.number("t"), side, c, expected.len()) else {
                    continue;
                };
                let found: Vec<Rational> = found.into_iter().map(|[x]| x).collect();
                let expected: Vec<Rational> = expected.iter().map(|row| row[c].clone()).collect();
                assert_eq!(found, expected, "{} at {} from {side:?}", case.place, at.number("t"));
                compared += 1;
            }
        }
    }
    assert!(compared > 200, "{compared}");
}
