//! The laws of a curve on every family; see `testkit::conformance`. A new family adds one invocation.
#![allow(clippy::unwrap_used)] // helpers of tests stop at the first fault, loudly

use lath::curve::{
    BSpline, Bezier, Curve, Hermite, Interval, Nurbs, Path, Polyline, Power, QuinticHermite, RationalBezier,
};
use lath::knot::Knots;
use testkit::conformance;
use testkit::conformance::Definition;
use testkit::conformance::strategies::{
    closed_spline, control_points, edge_spline, mild_spline, points_and_vectors, wild_control_points, with_domain,
    with_weights,
};

/// The numbers of a curve that runs backwards.
fn negated(numbers: &[f64]) -> Vec<f64> {
    numbers.iter().rev().map(|t| -t).collect()
}

fn backwards<const D: usize>(points: &[[f64; D]]) -> Vec<[f64; D]> {
    points.iter().rev().copied().collect()
}

/// A closed sequence backwards: the first stays, where the seam is.
fn around<const D: usize>(points: &[[f64; D]]) -> Vec<[f64; D]> {
    let n = points.len();
    (0..n).map(|i| points[(n - i) % n]).collect()
}

fn opposite<const D: usize>(vectors: Vec<[f64; D]>) -> Vec<[f64; D]> {
    vectors.into_iter().map(|v| v.map(|x| -x)).collect()
}

conformance! {
    bezier,
    dimension: 2,
    invariance: Affine,
    edge: with_domain(wild_control_points::<2>(1..12), false),
    mild: with_domain(control_points::<2>(2..9), true),
    build: |d: &Definition<2>| Bezier::on(&d.points, Interval { start: d.numbers[0], end: d.numbers[1] }),
    reverse: |d: &Definition<2>| Definition { numbers: negated(&d.numbers), points: backwards(&d.points), ..d.clone() },
}

conformance! {
    bspline_open,
    dimension: 3,
    invariance: Affine,
    edge: edge_spline::<3>(0..8),
    mild: mild_spline::<3>(0..8),
    build: |d: &Definition<3>| BSpline::new(Knots::new(d.numbers.clone(), d.degree)?, &d.points),
    reverse: |d: &Definition<3>| Definition { numbers: negated(&d.numbers), points: backwards(&d.points), ..d.clone() },
}

conformance! {
    bspline_closed,
    dimension: 2,
    invariance: Affine,
    edge: closed_spline::<2>(1..8, false),
    mild: closed_spline::<2>(1..8, true),
    build: |d: &Definition<2>| BSpline::closed(&d.numbers, d.degree, &d.points),
    reverse: |d: &Definition<2>| {
        let n = d.points.len();
        let points = (0..n).map(|j| d.points[(n + d.degree - 1 - j) % n]).collect();
        Definition { numbers: negated(&d.numbers), points, ..d.clone() }
    },
}

/// A definition that runs backwards, weights and all.
fn mirrored<const D: usize>(d: &Definition<D>) -> Definition<D> {
    let weights = d.weights.iter().rev().copied().collect();
    Definition { numbers: negated(&d.numbers), points: backwards(&d.points), weights, ..d.clone() }
}

conformance! {
    bezier_rational,
    dimension: 2,
    invariance: Projective,
    edge: with_weights(with_domain(wild_control_points::<2>(1..12), false), false),
    mild: with_weights(with_domain(control_points::<2>(2..9), true), true),
    build: |d: &Definition<2>| {
        let domain = Interval { start: d.numbers[0], end: d.numbers[1] };
        RationalBezier::on(&d.points, d.weights.clone(), domain)
    },
    reverse: mirrored::<2>,
}

conformance! {
    bspline_rational,
    dimension: 3,
    invariance: Projective,
    edge: with_weights(edge_spline::<3>(0..8), false),
    mild: with_weights(mild_spline::<3>(0..8), true),
    build: |d: &Definition<3>| Nurbs::new(Knots::new(d.numbers.clone(), d.degree)?, &d.points, d.weights.clone()),
    reverse: mirrored::<3>,
}

conformance! {
    bspline_rational_closed,
    dimension: 2,
    invariance: Projective,
    edge: with_weights(closed_spline::<2>(1..8, false), false),
    mild: with_weights(closed_spline::<2>(1..8, true), true),
    build: |d: &Definition<2>| Nurbs::closed(&d.numbers, d.degree, &d.points, d.weights.clone()),
    reverse: |d: &Definition<2>| {
        let n = d.points.len();
        let places = (0..n).map(|j| (n + d.degree - 1 - j) % n);
        let (points, weights) = places.map(|j| (d.points[j], d.weights[j])).unzip();
        Definition { numbers: negated(&d.numbers), points, weights, ..d.clone() }
    },
}

conformance! {
    hermite_open,
    dimension: 2,
    invariance: Affine,
    edge: points_and_vectors::<2>(1, 0, false),
    mild: points_and_vectors::<2>(1, 0, true),
    build: |d: &Definition<2>| Hermite::new(d.numbers.clone(), &d.points, &d.vectors),
    reverse: |d: &Definition<2>| Definition {
        numbers: negated(&d.numbers),
        points: backwards(&d.points),
        vectors: opposite(backwards(&d.vectors)),
        ..d.clone()
    },
}

conformance! {
    hermite_closed,
    dimension: 2,
    invariance: Affine,
    edge: points_and_vectors::<2>(1, 1, false),
    mild: points_and_vectors::<2>(1, 1, true),
    build: |d: &Definition<2>| Hermite::closed(d.numbers.clone(), &d.points, &d.vectors),
    reverse: |d: &Definition<2>| Definition {
        numbers: negated(&d.numbers),
        points: around(&d.points),
        vectors: opposite(around(&d.vectors)),
        ..d.clone()
    },
}

conformance! {
    polyline,
    dimension: 4,
    invariance: Affine,
    edge: wild_control_points::<4>(2..9),
    mild: control_points::<4>(2..9),
    build: |d: &Definition<4>| Polyline::new(&d.points),
    reverse: |d: &Definition<4>| Definition { points: backwards(&d.points), ..d.clone() },
}

/// First derivatives, then second ones.
fn halves<const D: usize>(vectors: &[[f64; D]]) -> (&[[f64; D]], &[[f64; D]]) {
    vectors.split_at(vectors.len() / 2)
}

conformance! {
    quintic_hermite,
    dimension: 2,
    invariance: Affine,
    edge: points_and_vectors::<2>(2, 0, false),
    mild: points_and_vectors::<2>(2, 0, true),
    build: |d: &Definition<2>| {
        let (first, second) = halves(&d.vectors);
        QuinticHermite::new(d.numbers.clone(), &d.points, first, second)
    },
    reverse: |d: &Definition<2>| {
        let (first, second) = halves(&d.vectors);
        let vectors = [opposite(backwards(first)), backwards(second)].concat();
        Definition { numbers: negated(&d.numbers), points: backwards(&d.points), vectors, ..d.clone() }
    },
}

conformance! {
    power,
    dimension: 2,
    invariance: Affine,
    edge: points_and_vectors::<2>(3, 1, false),
    mild: points_and_vectors::<2>(3, 1, true),
    build: |d: &Definition<2>| {
        // Each piece starts in its point; three vectors are its coefficients above the constant.
        let pieces = d.points.iter().zip(d.vectors.chunks(3)).map(|(point, vectors)| {
            let mut piece = vec![*point];
            piece.extend_from_slice(vectors);
            piece
        });
        Power::new(d.numbers.clone(), pieces)
    },
}

conformance! {
    path,
    dimension: 2,
    invariance: Affine,
    edge: control_points::<2>(3..9),
    mild: control_points::<2>(3..9),
    build: |d: &Definition<2>| {
        // All points as a polyline, then back to the first by an arch over the second.
        let (first, last) = (d.points[0], d.points[d.points.len() - 1]);
        let there = Polyline::new(&d.points)?;
        let back = Bezier::new([last, d.points[1], first])?;
        Path::new([Box::new(there) as Box<dyn Curve<2>>, Box::new(back)], true)
    },
}
