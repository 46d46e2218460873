//! Proptest strategies that love the edge: repeated knots, values a few ulps apart, spans of 1 : 1e12, points of every scale.
//!
//! A uniform random number almost never meets the case that breaks a spline. Here each step between neighbours is drawn
//! from a bag of troublesome ones, so that a few dozen cases meet all of them.

use lath::knot::Knots;
use proptest::collection::vec;
use proptest::prelude::*;

/// How far the next knot or parameter lies from the one before.
#[derive(Clone, Copy, Debug)]
enum Step {
    /// Not at all: a repetition.
    Repeat,
    /// The nearest floats above.
    Ulps(u8),
    /// An ordinary distance.
    Ordinary(f64),
    /// Twelve decades below the ordinary.
    Tiny(f64),
}

fn step() -> impl Strategy<Value = Step> {
    prop_oneof![
        2 => Just(Step::Repeat),
        1 => (1u8..4).prop_map(Step::Ulps),
        5 => (0.125f64..2.0).prop_map(Step::Ordinary),
        2 => (1.0f64..8.0).prop_map(|x| Step::Tiny(x * 1e-12)),
    ]
}

/// The value a step above `t`.
fn advance(t: f64, step: Step) -> f64 {
    match step {
        Step::Repeat => t,
        Step::Ulps(n) => (0..n).fold(t, |t, _| t.next_up()),
        Step::Ordinary(x) | Step::Tiny(x) => t + x,
    }
}

/// Where a sequence starts: mostly at 0, sometimes where floats are coarse.
fn origin() -> impl Strategy<Value = f64> {
    prop_oneof![3 => Just(0.0), 1 => Just(-1.0), 1 => -4.0f64..4.0, 1 => Just(1e6)]
}

/// Strictly increasing parameters, `count` of them.
pub fn parameters(count: usize) -> impl Strategy<Value = Vec<f64>> {
    (origin(), vec(step(), count.saturating_sub(1))).prop_map(|(start, steps)| {
        let mut t = vec![start];
        for step in steps {
            let last = t[t.len() - 1];
            let next = advance(last, step);
            t.push(if next > last { next } else { last.next_up() });
        }
        t
    })
}

/// Strictly increasing parameters whose intervals differ by no more than a thousand, for laws with a tolerance.
pub fn mild_parameters(count: usize) -> impl Strategy<Value = Vec<f64>> {
    (-4.0f64..4.0, vec(0.01f64..10.0, count.saturating_sub(1))).prop_map(|(start, steps)| {
        let mut t = vec![start];
        for step in steps {
            t.push(t[t.len() - 1] + step);
        }
        t
    })
}

/// How the ends of a knot vector look.
#[derive(Clone, Copy, Debug)]
enum EndKnots {
    /// Whatever the steps give.
    Open,
    /// Repeated degree + 1 times.
    Clamped,
    /// Repeated a few times, but not degree + 1.
    Half,
}

fn end_knots() -> impl Strategy<Value = EndKnots> {
    prop_oneof![Just(EndKnots::Open), Just(EndKnots::Clamped), Just(EndKnots::Half)]
}

/// Valid knots of the given degree: open, clamped or half-clamped at either end, multiplicities up to degree + 1 inside,
/// neighbours a few ulps apart, spans of 1 : 1e12.
pub fn knots(degree: usize) -> impl Strategy<Value = Knots> {
    let spans = degree + 1..degree + 7;
    (origin(), vec(step(), 2 * degree + 1..=2 * degree + 1), vec(step(), spans), end_knots(), end_knots(), 0..=degree)
        .prop_filter_map("a valid knot vector", move |(start, outer, inner, first, last, some)| {
            let outer = &mut outer.into_iter();
            let mut steps: Vec<Step> = match first {
                EndKnots::Open => outer.take(degree).collect(),
                EndKnots::Clamped => vec![Step::Repeat; degree],
                EndKnots::Half => {
                    (0..degree).map(|i| if i < some { Step::Repeat } else { Step::Ordinary(1.0) }).collect()
                }
            };
            steps.extend(inner);
            match last {
                EndKnots::Open => steps.extend(outer.take(degree)),
                EndKnots::Clamped => steps.extend(vec![Step::Repeat; degree]),
                EndKnots::Half => {
                    steps.extend((0..degree).map(|i| if i >= some { Step::Repeat } else { Step::Ordinary(1.0) }));
                }
            }
            let mut values = vec![start];
            for step in steps {
                values.push(advance(values[values.len() - 1], step));
            }
            // One more repetition than allowed is the constructor's to refuse; here it becomes an ordinary step.
            let mut run = 1;
            let mut shift = 0.0;
            for i in 1..values.len() {
                values[i] += shift;
                run = if values[i] > values[i - 1] { 1 } else { run + 1 };
                if run > degree + 1 {
                    values[i] += 0.5;
                    shift += 0.5;
                    run = 1;
                }
            }
            Knots::new(values, degree).ok()
        })
}

/// Knots whose spans differ by no more than a thousand, multiplicities up to `degree` inside, for laws with a tolerance.
pub fn mild_knots(degree: usize) -> impl Strategy<Value = Knots> {
    let steps = vec(prop_oneof![1 => Just(0.0), 3 => 0.01f64..10.0], 2 * degree + 2..2 * degree + 8);
    (steps, any::<bool>(), any::<bool>()).prop_filter_map("a valid knot vector", move |(mut steps, first, last)| {
        let count = steps.len();
        for (i, step) in steps.iter_mut().enumerate() {
            if first && i < degree || last && i >= count - degree {
                *step = 0.0;
            }
        }
        let mut values = vec![0.0];
        let mut run = 1;
        for step in steps {
            let t = values[values.len() - 1];
            let inside = values.len() > degree && values.len() < count - degree;
            let most = if inside { degree.max(1) } else { degree + 1 };
            let step = if step == 0.0 && run >= most { 1.0 } else { step };
            run = if step == 0.0 { run + 1 } else { 1 };
            values.push(t + step);
        }
        Knots::new(values, degree).ok()
    })
}

/// A coordinate of ordinary size; small whole numbers among them, because coincidences live there.
pub fn coordinate() -> impl Strategy<Value = f64> {
    prop_oneof![3 => -10.0f64..10.0, 1 => (-3i32..4).prop_map(f64::from)]
}

/// A coordinate of any scale that constructors take.
pub fn any_scale() -> impl Strategy<Value = f64> {
    let wide =
        (-1.0f64..1.0, prop_oneof![Just(1e-300), Just(1e-150), Just(1e-12), Just(1e12), Just(1e150), Just(1e300)]);
    prop_oneof![3 => coordinate(), 1 => wide.prop_map(|(x, scale)| x * scale), 1 => Just(0.0), 1 => Just(-0.0)]
}

/// Points of ordinary size; a few of them coincide.
pub fn points<const D: usize>(count: usize) -> impl Strategy<Value = Vec<[f64; D]>> {
    drawn_from(coordinate().boxed(), count)
}

/// Points of ordinary size in most draws, of every scale at once in some.
pub fn wild_points<const D: usize>(count: usize) -> impl Strategy<Value = Vec<[f64; D]>> {
    prop_oneof![3 => drawn_from(coordinate().boxed(), count), 1 => drawn_from(any_scale().boxed(), count)]
}

fn drawn_from<const D: usize>(coordinate: BoxedStrategy<f64>, count: usize) -> impl Strategy<Value = Vec<[f64; D]>> {
    vec((vec(coordinate, D), 0u8..8), count).prop_map(|drawn| {
        let mut points: Vec<[f64; D]> = Vec::with_capacity(drawn.len());
        for (point, chance) in drawn {
            let point = std::array::from_fn(|c| point[c]);
            points.push(if chance == 0 { points.last().copied().unwrap_or(point) } else { point });
        }
        points
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::strategy::ValueTree;
    use proptest::test_runner::TestRunner;

    /// The generators are worth something only if they meet the edge: count what 400 draws contain.
    #[test]
    fn a_few_hundred_draws_meet_every_edge() {
        let mut runner = TestRunner::deterministic();
        let (mut repeated, mut broken, mut close, mut uneven, mut clamped, mut half) = (0, 0, 0, 0, 0, 0);
        for round in 0..400 {
            let degree = round % 8;
            let drawn = knots(degree).new_tree(&mut runner).unwrap().current();
            let (values, (start, end)) = (drawn.values(), drawn.domain());
            let inner: Vec<f64> = values.iter().copied().filter(|t| start < *t && *t < end).collect();
            repeated += usize::from(inner.windows(2).any(|w| w[0] == w[1]));
            broken += usize::from(degree > 0 && inner.iter().any(|t| drawn.multiplicity(t) == degree + 1));
            let spans: Vec<f64> = values.windows(2).map(|w| w[1] - w[0]).filter(|h| *h > 0.0).collect();
            close += usize::from(values.windows(2).any(|w| w[0] < w[1] && w[1] <= w[0].next_up().next_up()));
            let ratio = spans.iter().fold(0.0, |m: f64, h| m.max(*h)) / spans.iter().fold(f64::MAX, |m, h| m.min(*h));
            uneven += usize::from(ratio > 1e11);
            clamped += usize::from(degree > 0 && drawn.multiplicity(&start) == degree + 1);
            half += usize::from(degree > 1 && (2..=degree).contains(&drawn.multiplicity(&start)));
        }
        let met = [repeated, broken, close, uneven, clamped, half];
        assert!(met.iter().all(|count| *count >= 8), "{met:?}");
    }

    #[test]
    fn parameters_increase() {
        let mut runner = TestRunner::deterministic();
        for _ in 0..100 {
            let t = parameters(20).new_tree(&mut runner).unwrap().current();
            assert!(t.windows(2).all(|w| w[0] < w[1]), "{t:?}");
        }
    }
}
