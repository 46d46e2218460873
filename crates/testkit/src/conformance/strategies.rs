//! Definitions for the families that the core has, and for those that look like them.

use crate::conformance::Definition;
use crate::generators;
use proptest::prelude::*;
use std::ops::Range;

/// Control points only, so many.
pub fn control_points<const D: usize>(count: Range<usize>) -> impl Strategy<Value = Definition<D>> {
    count.prop_flat_map(|n| points(n, true)).prop_map(|points| Definition { points, ..Definition::default() })
}

/// The same with points of every scale among them.
pub fn wild_control_points<const D: usize>(count: Range<usize>) -> impl Strategy<Value = Definition<D>> {
    count.prop_flat_map(|n| points(n, false)).prop_map(|points| Definition { points, ..Definition::default() })
}

/// A definition over a domain of its own, the two `numbers`; mild domains are neither tiny nor far from 0.
pub fn with_domain<const D: usize>(
    definition: impl Strategy<Value = Definition<D>>,
    mild: bool,
) -> impl Strategy<Value = Definition<D>> {
    (definition, increasing(2, mild)).prop_map(|(definition, numbers)| Definition { numbers, ..definition })
}

/// Knots of a degree from the range, with as many control points as they carry functions.
pub fn edge_spline<const D: usize>(degree: Range<usize>) -> impl Strategy<Value = Definition<D>> {
    degree
        .prop_flat_map(generators::knots)
        .prop_flat_map(|knots| with_points(knots.degree(), knots.values().to_vec(), knots.functions(), false))
}

/// The same with mild knots.
pub fn mild_spline<const D: usize>(degree: Range<usize>) -> impl Strategy<Value = Definition<D>> {
    degree
        .prop_flat_map(generators::mild_knots)
        .prop_flat_map(|knots| with_points(knots.degree(), knots.values().to_vec(), knots.functions(), true))
}

/// One period of knots, strictly increasing, with one control point fewer; degree from the range.
pub fn closed_spline<const D: usize>(degree: Range<usize>, mild: bool) -> impl Strategy<Value = Definition<D>> {
    (degree, 2usize..9).prop_flat_map(move |(degree, count)| (Just(degree), increasing(count, mild))).prop_flat_map(
        move |(degree, period)| {
            let points = period.len() - 1;
            with_points(degree, period, points, mild)
        },
    )
}

/// Increasing parameters, and for each a point and `vectors` vectors; `extra` more parameters than points.
pub fn points_and_vectors<const D: usize>(
    vectors: usize,
    extra: usize,
    mild: bool,
) -> impl Strategy<Value = Definition<D>> {
    (2usize..8)
        .prop_flat_map(move |n| (increasing(n + extra, mild), points(n, mild), points(n * vectors, mild)))
        .prop_map(|(numbers, points, vectors)| Definition { numbers, points, vectors, ..Definition::default() })
}

fn increasing(count: usize, mild: bool) -> BoxedStrategy<Vec<f64>> {
    if mild { generators::mild_parameters(count).boxed() } else { generators::parameters(count).boxed() }
}

/// Points: mild ones of ordinary size, others of every scale.
fn points<const D: usize>(count: usize, mild: bool) -> BoxedStrategy<Vec<[f64; D]>> {
    if mild { generators::points(count).boxed() } else { generators::wild_points(count).boxed() }
}

fn with_points<const D: usize>(
    degree: usize,
    numbers: Vec<f64>,
    count: usize,
    mild: bool,
) -> impl Strategy<Value = Definition<D>> {
    points(count, mild).prop_map(move |points| Definition {
        degree,
        numbers: numbers.clone(),
        points,
        ..Definition::default()
    })
}

/// A definition with weights: mild ones between 1/8 and 8; others of all sizes that meet in one curve, zero among them, but not
/// near the start and the end, not beside each other, and not where one function is alone.
pub fn with_weights<const D: usize>(
    definition: impl Strategy<Value = Definition<D>>,
    mild: bool,
) -> impl Strategy<Value = Definition<D>> {
    let ordinary = || (-3.0f64..3.0).prop_map(f64::exp2);
    let weight = prop_oneof![6 => ordinary(), 2 => Just(1.0), 1 => Just(0.0), 1 => (923u64..1123).prop_map(|e| f64::from_bits(e << 52))];
    let weight = if mild { ordinary().boxed() } else { weight.boxed() };
    let weights = move |definition: Definition<D>| {
        let count = definition.points.len();
        (Just(definition), proptest::collection::vec(weight.clone(), count))
    };
    definition.prop_flat_map(weights).prop_map(|(definition, mut weights)| {
        let last = weights.len() - 1;
        // At an inner knot of multiplicity m, degree + 1 − m functions share the curve; one alone needs its weight.
        let (first_knot, last_knot) = (definition.numbers.first(), definition.numbers.last());
        let run = |t: &f64| definition.numbers.iter().filter(|knot| *knot == t).count();
        let inner = definition.numbers.iter().filter(|t| Some(*t) != first_knot && Some(*t) != last_knot);
        let alone = inner.map(run).max().is_some_and(|most| most >= definition.degree);
        for i in 0..=last {
            let beside = i > 0 && weights[i - 1] == 0.0;
            if weights[i] == 0.0 && (alone || beside || i <= definition.degree || i + definition.degree >= last) {
                weights[i] = 1.0;
            }
        }
        Definition { weights, ..definition }
    })
}
