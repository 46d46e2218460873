//! What everybody is asked: curves over three families of knots, and parameters that look for trouble in every span.

use crate::random::Random;

/// Parameters asked of one curve.
pub(crate) const PARAMETERS: usize = 100;

/// How the knots of a curve lie.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Family {
    /// Equal spans, open or clamped.
    Uniform,
    /// Simple knots whose distances differ by up to 1 : 2⁴⁰, from origins as far as −10⁹; open or clamped.
    Wild,
    /// Ordinary distances; inside every multiplicity from 1 to p + 1 in turn, at the ends any of them.
    Multiple,
}

impl Family {
    pub(crate) const ALL: [Family; 3] = [Family::Uniform, Family::Wild, Family::Multiple];

    pub(crate) fn name(self) -> &'static str {
        match self {
            Family::Uniform => "uniform",
            Family::Wild => "wild",
            Family::Multiple => "multiple",
        }
    }
}

/// One curve of one coordinate, and where it is asked.
pub(crate) struct Case {
    pub(crate) degree: usize,
    /// All control points + degree + 1 knots.
    pub(crate) knots: Vec<f64>,
    pub(crate) points: Vec<f64>,
    /// Inside the closed domain.
    pub(crate) parameters: Vec<f64>,
}

impl Case {
    /// The case of this number: the same on every machine, whatever was asked before.
    pub(crate) fn draw(degree: usize, family: Family, number: usize) -> Case {
        let random = &mut Random::new((degree as u64) << 48 | (family as u64) << 40 | number as u64);
        let knots = match family {
            Family::Uniform => uniform(degree, random),
            Family::Wild => wild(degree, random),
            Family::Multiple => multiple(degree, number, random),
        };
        let points = points(knots.len() - degree - 1, number, random);
        let mut case = Case { degree, knots, points, parameters: Vec::new() };
        let spans = case.spans();
        case.parameters = (0..PARAMETERS)
            .map(|_| {
                let span = spans[random.below(spans.len())];
                place(case.knots[span], case.knots[span + 1], random)
            })
            .collect();
        case
    }

    /// The spans of the domain that are not empty, each by its first knot.
    pub(crate) fn spans(&self) -> Vec<usize> {
        (self.degree..self.points.len()).filter(|&i| self.knots[i] < self.knots[i + 1]).collect()
    }

    /// The span that answers t: from the right, at the domain's end from the left.
    pub(crate) fn span(&self, t: f64) -> Option<usize> {
        self.spans().into_iter().rev().find(|&i| self.knots[i] <= t)
    }
}

/// A number from 2⁻ⁿ to 1, every power of two as likely as any other.
fn fraction(n: usize, random: &mut Random) -> f64 {
    (1.0 + random.unit()) / (2_u64 << random.below(n)) as f64
}

/// How many spans the domain has.
fn count(random: &mut Random) -> usize {
    1 + random.below(8)
}

/// The steps between neighbours one after the other; clamped by a toss, open otherwise.
fn stepped(
    degree: usize,
    start: f64,
    random: &mut Random,
    mut next: impl FnMut(usize, f64, &mut Random) -> f64,
) -> Vec<f64> {
    let (clamped, spans) = (random.below(2) == 0, count(random));
    let steps = if clamped { spans } else { spans + 2 * degree };
    let mut knots = vec![start];
    for i in 1..=steps {
        let last = knots[i - 1];
        knots.push(next(i, last, random).max(last.next_up()));
    }
    if clamped {
        let end = knots[steps];
        knots.splice(0..0, std::iter::repeat_n(start, degree));
        knots.extend(std::iter::repeat_n(end, degree));
    }
    knots
}

fn uniform(degree: usize, random: &mut Random) -> Vec<f64> {
    let length = [1.0, 0.1, 1.0 / 3.0, 1e-3][random.below(4)];
    let start = [0.0, -2.0, 0.7, 100.0][random.below(4)];
    stepped(degree, start, random, |i, _, _| start + i as f64 * length)
}

fn wild(degree: usize, random: &mut Random) -> Vec<f64> {
    let start = [0.0, -1.0, 8.0 * random.unit() - 4.0, 1e6, -1e9][random.below(5)];
    let scale = [1.0, 1e6, 1e-6][random.below(3)];
    stepped(degree, start, random, |_, last, random| last + scale * fraction(40, random))
}

fn multiple(degree: usize, number: usize, random: &mut Random) -> Vec<f64> {
    let most = degree + 1;
    let step = |random: &mut Random| 0.125 + 1.875 * random.unit();
    let mut t = 4.0 * random.unit() - 2.0;
    let mut knots = Vec::new();
    let mut add = |copies: usize, random: &mut Random| {
        knots.extend(std::iter::repeat_n(t, copies));
        t += step(random);
    };
    let (first, last) = (1 + random.below(most), 1 + random.below(most));
    (first..most).for_each(|_| add(1, random));
    add(first, random);
    let inside = count(random);
    for i in 0..inside {
        add(1 + (number + i) % most, random);
    }
    add(last, random);
    (last..most).for_each(|_| add(1, random));
    knots
}

/// By turns: of both signs; of one sign; millimetres around 10⁷; of every size from 2⁻²⁰ to 2²⁰; small whole numbers.
fn points(n: usize, number: usize, random: &mut Random) -> Vec<f64> {
    let draw = |_| match number % 5 {
        0 => 20.0 * random.unit() - 10.0,
        1 => 1.0 + random.unit(),
        2 => 1e7 + 0.1 * random.unit(),
        3 => (2.0 * random.unit() - 1.0) * 1048576.0 * fraction(40, random),
        _ => random.below(7) as f64 - 3.0,
    };
    (0..n).map(draw).collect()
}

/// Somewhere in a span, near either end by any power of two, at the ends and at their neighbours.
fn place(start: f64, end: f64, random: &mut Random) -> f64 {
    let length = end - start;
    let near = |random: &mut Random| length * fraction(52, random);
    let t = match random.below(20) {
        0..10 => start + length * random.unit(),
        10..13 => start + near(random),
        13..16 => end - near(random),
        16 => start,
        17 => end,
        18 => start.next_up(),
        _ => end.next_down(),
    };
    t.clamp(start, end)
}
