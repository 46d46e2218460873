//! The laws of a curve on what is not a family of its own: uniform curves under tension, and curves through data. Each declares its
//! group of maps, and one map outside it is shown to change the curve. Closed curves have no first point.
#![allow(clippy::unwrap_used)] // helpers of tests stop at the first fault, loudly

use lath::curve::{BSpline, Curve, Hermite, PolygonEnd, UniformBSpline};
use lath::error::Result;
use lath::interpolate::{
    BSplineEnd, Derivative, End, Ends, Parameters, Tcb, akima, bspline, bspline_closed, bspline_with_derivatives,
    cardinal, catmull_rom, cubic, cubic_closed, kochanek_bartels, makima, parameters, pchip, steffen,
};
use proptest::prelude::*;
use testkit::conformance;
use testkit::conformance::Definition;
use testkit::conformance::strategies::{
    control_points, edge_spline, mild_spline, points_and_vectors, wild_control_points,
};

fn backwards<const D: usize>(points: &[[f64; D]]) -> Vec<[f64; D]> {
    points.iter().rev().copied().collect()
}

/// The same points in opposite order.
fn mirrored<const D: usize>(d: &Definition<D>) -> Definition<D> {
    Definition { points: backwards(&d.points), ..d.clone() }
}

/// Data in opposite order, the parameters negated.
fn turned<const D: usize>(d: &Definition<D>) -> Definition<D> {
    Definition { numbers: d.numbers.iter().rev().map(|t| -t).collect(), ..mirrored(d) }
}

conformance! {
    uniform_open,
    dimension: 3,
    invariance: Affine,
    edge: edge_spline::<3>(0..8),
    mild: mild_spline::<3>(0..8),
    build: |d: &Definition<3>| UniformBSpline::new(d.degree, &d.points),
    reverse: mirrored::<3>,
}

conformance! {
    uniform_closed,
    dimension: 2,
    invariance: Affine,
    edge: edge_spline::<2>(0..8),
    mild: mild_spline::<2>(0..8),
    build: |d: &Definition<2>| UniformBSpline::closed(d.degree, &d.points),
    reverse: |d: &Definition<2>| {
        let n = d.points.len();
        let points = (0..n).map(|j| d.points[(n + n * d.degree + d.degree - 1 - j) % n]).collect();
        Definition { points, ..d.clone() }
    },
}

conformance! {
    uniform_at_its_polygon,
    dimension: 2,
    invariance: Affine,
    edge: mild_spline::<2>(0..8),
    mild: mild_spline::<2>(0..8),
    build: |d: &Definition<2>| UniformBSpline::at_polygon(d.degree, &d.points, PolygonEnd::Phantom),
    reverse: mirrored::<2>,
}

conformance! {
    tension,
    dimension: 2,
    invariance: Affine,
    edge: wild_control_points::<2>(4..9),
    mild: control_points::<2>(4..9),
    build: |d: &Definition<2>| UniformBSpline::new(3, &d.points)?.with_tension(0.3),
    reverse: mirrored::<2>,
}

conformance! {
    tensions,
    dimension: 2,
    invariance: Affine,
    edge: wild_control_points::<2>(1..9),
    mild: control_points::<2>(1..9),
    build: |d: &Definition<2>| {
        let tensions: Vec<f64> = (0..d.points.len()).map(|i| [0.0, 1.0, 0.5, -0.25][i % 4]).collect();
        UniformBSpline::closed(3, &d.points)?.with_tensions(&tensions)
    },
}

/// Data over given parameters.
fn data<const D: usize>(vectors: usize, extra: usize, least: usize) -> impl Strategy<Value = Definition<D>> {
    points_and_vectors::<D>(vectors, extra, true).prop_filter("enough points", move |d| d.points.len() >= least)
}

conformance! {
    cubic_natural,
    dimension: 2,
    invariance: Affine,
    edge: data::<2>(0, 0, 2),
    mild: data::<2>(0, 0, 2),
    build: |d: &Definition<2>| cubic(&d.points, d.numbers.clone(), &Ends::Open(End::Natural, End::Natural)),
    reverse: turned::<2>,
}

conformance! {
    cubic_not_a_knot,
    dimension: 2,
    invariance: Affine,
    edge: data::<2>(0, 0, 2),
    mild: data::<2>(0, 0, 2),
    build: |d: &Definition<2>| cubic(&d.points, d.numbers.clone(), &Ends::Open(End::NotAKnot, End::NotAKnot)),
    reverse: turned::<2>,
}

conformance! {
    cubic_around,
    dimension: 2,
    invariance: Affine,
    edge: data::<2>(0, 1, 2),
    mild: data::<2>(0, 1, 2),
    build: |d: &Definition<2>| cubic_closed(&d.points, d.numbers.clone()),
}

const FREE: BSplineEnd<2> = BSplineEnd::NotAKnot;

conformance! {
    bspline_through_points,
    dimension: 2,
    invariance: Affine,
    edge: data::<2>(0, 0, 5),
    mild: data::<2>(0, 0, 5),
    build: |d: &Definition<2>| bspline(&d.points, d.numbers.clone(), 4, &FREE, &FREE),
    reverse: turned::<2>,
}

conformance! {
    bspline_around,
    dimension: 2,
    invariance: Affine,
    edge: data::<2>(0, 1, 4),
    mild: data::<2>(0, 1, 4),
    build: |d: &Definition<2>| bspline_closed(&d.points, d.numbers.clone(), 3),
}

conformance! {
    bspline_with_slopes,
    dimension: 2,
    invariance: Affine,
    edge: data::<2>(1, 0, 4),
    mild: data::<2>(1, 0, 4),
    build: |d: &Definition<2>| {
        let slope = |index: usize| Derivative { index, order: 1, value: d.vectors[index] };
        bspline_with_derivatives(&d.points, d.numbers.clone(), 3, &FREE, &FREE, &[slope(1), slope(3)])
    },
}

conformance! {
    catmull_rom_through_points,
    dimension: 2,
    invariance: Affine,
    edge: data::<2>(0, 0, 2),
    mild: data::<2>(0, 0, 2),
    build: |d: &Definition<2>| catmull_rom(&d.points, d.numbers.clone(), false),
    reverse: turned::<2>,
}

conformance! {
    kochanek_bartels_around,
    dimension: 2,
    invariance: Affine,
    edge: data::<2>(0, 1, 2),
    mild: data::<2>(0, 1, 2),
    build: |d: &Definition<2>| {
        let tcb = Tcb { tension: 0.25, continuity: -0.5, bias: 0.5 };
        kochanek_bartels(&d.points, d.numbers.clone(), true, tcb)
    },
}

/// Points whose neighbours differ, around too.
fn distinct() -> impl Strategy<Value = Definition<2>> {
    control_points::<2>(3..9).prop_filter("neighbours differ", |d| {
        let n = d.points.len();
        (0..n).all(|i| lath::space::distance(&d.points[i], &d.points[(i + 1) % n]) > 1e-3)
    })
}

/// Parameters by a rule, brought to the domain [0, 1], which no similarity changes.
fn by_rule(points: &[[f64; 2]], closed: bool, rule: Parameters<'_>) -> Result<Vec<f64>> {
    let t = parameters(points, closed, rule)?;
    Ok(t.iter().map(|x| x / t[t.len() - 1]).collect())
}

conformance! {
    cubic_by_chord_length,
    dimension: 2,
    invariance: Similarity,
    edge: distinct(),
    mild: distinct(),
    build: |d: &Definition<2>| {
        let t = by_rule(&d.points, false, Parameters::Chord)?;
        cubic(&d.points, t, &Ends::Open(End::Natural, End::NotAKnot))
    },
}

conformance! {
    cubic_around_centripetal,
    dimension: 2,
    invariance: Similarity,
    edge: distinct(),
    mild: distinct(),
    build: |d: &Definition<2>| cubic_closed(&d.points, by_rule(&d.points, true, Parameters::Centripetal)?),
}

conformance! {
    catmull_rom_by_any_power,
    dimension: 2,
    invariance: Similarity,
    edge: distinct(),
    mild: distinct(),
    build: |d: &Definition<2>| catmull_rom(&d.points, by_rule(&d.points, false, Parameters::Power(0.75))?, false),
    reverse: mirrored::<2>,
}

conformance! {
    pchip_through_points,
    dimension: 2,
    invariance: PerAxis,
    edge: data::<2>(0, 0, 2),
    mild: data::<2>(0, 0, 2),
    build: |d: &Definition<2>| pchip(&d.points, d.numbers.clone(), false),
    reverse: turned::<2>,
}

conformance! {
    steffen_around,
    dimension: 2,
    invariance: PerAxis,
    edge: data::<2>(0, 1, 2),
    mild: data::<2>(0, 1, 2),
    build: |d: &Definition<2>| steffen(&d.points, d.numbers.clone(), true),
}

conformance! {
    akima_through_points,
    dimension: 2,
    invariance: PerAxis,
    edge: data::<2>(0, 0, 2),
    mild: data::<2>(0, 0, 2),
    build: |d: &Definition<2>| akima(&d.points, d.numbers.clone(), false),
    reverse: turned::<2>,
}

conformance! {
    makima_through_points,
    dimension: 2,
    invariance: PerAxis,
    edge: data::<2>(0, 0, 2),
    mild: data::<2>(0, 0, 2),
    build: |d: &Definition<2>| makima(&d.points, d.numbers.clone(), false),
    reverse: turned::<2>,
}

type Closed = fn(Vec<[f64; 2]>, Vec<f64>) -> Result<Box<dyn Curve<2>>>;

/// Every kind of closed curve, made of points and, where it takes them, parameters.
const CLOSED: &[(&str, Closed)] = &[
    ("cubic", |p, t| Ok(Box::new(cubic_closed(p, t)?))),
    ("bspline 1", |p, t| Ok(Box::new(bspline_closed(p, t, 1)?))),
    ("bspline 2", |p, t| Ok(Box::new(bspline_closed(p, t, 2)?))),
    ("bspline 3", |p, t| Ok(Box::new(bspline_closed(p, t, 3)?))),
    ("bspline 4", |p, t| Ok(Box::new(bspline_closed(p, t, 4)?))),
    ("bspline 5", |p, t| Ok(Box::new(bspline_closed(p, t, 5)?))),
    ("catmull-rom", |p, t| Ok(Box::new(catmull_rom(p, t, true)?))),
    ("cardinal", |p, t| Ok(Box::new(cardinal(p, t, true, 0.3)?))),
    ("kochanek-bartels", |p, t| {
        Ok(Box::new(kochanek_bartels(p, t, true, Tcb { tension: 0.1, continuity: 0.4, bias: -0.3 })?))
    }),
    ("pchip", |p, t| Ok(Box::new(pchip(p, t, true)?))),
    ("steffen", |p, t| Ok(Box::new(steffen(p, t, true)?))),
    ("akima", |p, t| Ok(Box::new(akima(p, t, true)?))),
    ("makima", |p, t| Ok(Box::new(makima(p, t, true)?))),
    ("hermite", |p, t| Ok(Box::new(Hermite::closed(t, &p, &p)?))),
    ("control points 3", |p, t| Ok(Box::new(BSpline::closed(&t, 3, p)?))),
    ("control points 4", |p, t| Ok(Box::new(BSpline::closed(&t, 4, p)?))),
    ("uniform 2", |p, _| Ok(Box::new(UniformBSpline::closed(2, p)?))),
    ("uniform 3", |p, _| Ok(Box::new(UniformBSpline::closed(3, p)?))),
    ("uniform 6", |p, _| Ok(Box::new(UniformBSpline::closed(6, p)?))),
    ("tension", |p, _| Ok(Box::new(UniformBSpline::closed(3, p)?.with_tension(0.3)?))),
    ("tensions", |p, _| {
        let tensions: Vec<f64> = p.iter().map(|p| p[0] / 8.0).collect();
        Ok(Box::new(UniformBSpline::closed(3, p)?.with_tensions(&tensions)?))
    }),
];

#[test]
fn closed_data_rotated_by_one_give_the_rotated_curve_of_every_kind() {
    let points = vec![[0.0, 0.0], [4.0, 1.0], [5.0, 5.0], [1.0, 6.0], [-2.0, 3.0], [-3.0, 1.0], [-1.0, -1.0]];
    let n = points.len();
    let mut rotated = points.clone();
    rotated.rotate_left(1);
    // Eighths, so that shifting them rounds nothing.
    for t in [[0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0], [0.0, 0.5, 1.75, 2.25, 3.5, 4.25, 5.5, 6.5]] {
        let period = t[n];
        for (name, make) in CLOSED {
            let unit = name.starts_with("uniform") || name.starts_with("tension");
            let (step, period) = if unit { (1.0, n as f64) } else { (t[1], period) };
            let shifted: Vec<f64> = (1..=n).map(|i| t[i] - t[1]).chain([t[n]]).collect();
            let (curve, turned) = (make(points.clone(), t.to_vec()).unwrap(), make(rotated.clone(), shifted).unwrap());
            let at = |curve: &dyn Curve<2>, t: f64| {
                let start = curve.domain().start;
                let t = if t >= start + period { t - period } else { t };
                curve.eval(if t < start { t + period } else { t }).unwrap()
            };
            for k in 0..64 {
                let s = period * f64::from(k) / 64.0;
                let (found, wanted) = (at(&*turned, s), at(&*curve, s + step));
                let off = (0..2).map(|c| (found[c] - wanted[c]).abs()).fold(0.0, f64::max);
                assert!(off <= 8.0 * f64::EPSILON * 6.0, "{name} at {s}: {found:?}, not {wanted:?}, off by {off:e}");
            }
        }
    }
}
