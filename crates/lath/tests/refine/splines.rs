//! Splines over fractions with every pattern of multiplicities, and the question whether two are the same curve.

use lath::knot::{Knots, Side};
use lath::refine::Spline;
use testkit::naive;
use testkit::rational::{Rational, ratio};

/// A spline over fractions in one dimension.
pub(crate) type Exact = Spline<[Rational; 1], Rational>;

/// Numbers that no accident makes simple, the same in every run: a linear congruential generator.
pub(crate) struct Draw(u64);

impl Draw {
    pub(crate) fn new(seed: u64) -> Draw {
        Draw(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) ^ 0x1234_5678_9ABC_DEF1)
    }

    /// A whole number below `bound`.
    pub(crate) fn below(&mut self, bound: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((self.0 >> 33) % bound as u64) as usize
    }

    /// A fraction with a small denominator.
    pub(crate) fn fraction(&mut self) -> Rational {
        ratio(self.below(41) as i64 - 20, self.below(7) as i64 + 1)
    }

    /// A step between different knots; now and then a very short one.
    fn step(&mut self) -> Rational {
        if self.below(6) == 0 { ratio(1, 1_000_000) } else { ratio(self.below(9) as i64 + 1, self.below(4) as i64 + 1) }
    }

    pub(crate) fn points(&mut self, count: usize) -> Vec<[Rational; 1]> {
        (0..count).map(|_| [self.fraction()]).collect()
    }

    /// Knots with random multiplicities up to `most`, `count` of them.
    fn knots(&mut self, count: usize, most: usize) -> Vec<Rational> {
        let mut t = self.fraction();
        let mut knots = Vec::new();
        while knots.len() < count {
            let copies = 1 + self.below(most);
            knots.extend(std::iter::repeat_n(t.clone(), copies.min(count - knots.len())));
            t += self.step();
        }
        knots
    }

    /// An open spline: clamped at an end or not, breaks in the middle now and then.
    pub(crate) fn open(&mut self, degree: usize) -> Exact {
        loop {
            let most = 1 + self.below(degree + 1);
            let spans = 1 + self.below(5);
            let mut knots = self.knots(2 * degree + 1 + spans, most);
            for (clamp, from, to) in
                [(self.below(2) == 0, 0, degree), (self.below(2) == 0, degree + spans, 2 * degree + spans)]
            {
                if clamp {
                    let value = if from == 0 { knots[degree].clone() } else { knots[degree + spans].clone() };
                    (from..=to).for_each(|i| knots[i] = value.clone());
                }
            }
            if let Ok(knots) = Knots::new(knots, degree) {
                let points = self.points(knots.functions());
                return Spline::open(knots, points).unwrap();
            }
        }
    }

    /// A closed spline, of few points too.
    pub(crate) fn closed(&mut self, degree: usize) -> Exact {
        loop {
            let most = 1 + self.below(degree + 1);
            let n = 1 + self.below(degree + 5);
            let period = self.knots(n + 1, most);
            let points = self.points(n);
            if let Ok(spline) = Spline::closed(&period, degree, points) {
                return spline;
            }
        }
    }

    /// A parameter of the domain: a knot, an end, or none of them.
    pub(crate) fn parameter(&mut self, spline: &Exact) -> Rational {
        let (start, end) = spline.knots().domain();
        let breaks = spline.knots().breaks();
        match self.below(5) {
            0 => start,
            1 => end,
            2 => breaks[self.below(breaks.len())].clone(),
            _ => {
                let share = ratio(self.below(98) as i64 + 1, 99);
                start.clone() + share * (end - start)
            }
        }
    }
}

/// The value at t, by the recursion over all functions.
pub(crate) fn value(spline: &Exact, t: &Rational) -> Rational {
    let open = spline.unroll();
    let b: Vec<Rational> = open.points().iter().map(|[x]| x.clone()).collect();
    naive::spline(open.knots().values(), open.degree(), &b, 0, t, Side::Right)
}

/// Parameters that decide whether two piecewise polynomials of at most this degree agree on the domain of the first.
pub(crate) fn witnesses(breaks: &[&[Rational]], degree: usize) -> Vec<Rational> {
    let mut all: Vec<Rational> = breaks.concat();
    all.sort();
    all.dedup();
    let inside = |pair: &[Rational]| -> Vec<Rational> {
        let (a, b) = (pair[0].clone(), pair[1].clone());
        let place = |k: usize| a.clone() + (b.clone() - a.clone()) * ratio(k as i64 + 1, degree as i64 + 2);
        (0..=degree).map(place).collect()
    };
    all.windows(2).flat_map(inside).collect()
}

/// Whether two splines are the same function on the same domain: equal on every span at degree + 1 places.
#[track_caller]
pub(crate) fn assert_same(found: &Exact, given: &Exact, what: &str) {
    assert_eq!(found.knots().domain(), given.knots().domain(), "{what}");
    let degree = found.degree().max(given.degree());
    for t in witnesses(&[&found.knots().breaks(), &given.knots().breaks()], degree) {
        assert_eq!(value(found, &t), value(given, &t), "{what} at {t}: {given:?} became {found:?}");
    }
}

/// Whether a part is the whole on the part's domain.
#[track_caller]
pub(crate) fn assert_agree(part: &Exact, whole: &Exact, what: &str) {
    let (start, end) = part.knots().domain();
    let inside: Vec<Rational> = whole.knots().breaks().into_iter().filter(|t| start < *t && *t < end).collect();
    for t in witnesses(&[&part.knots().breaks(), &inside], whole.degree()) {
        assert_eq!(value(part, &t), value(whole, &t), "{what} at {t}: {whole:?} became {part:?}");
    }
}

/// Every degree from 0 to 7, open and closed, `rounds` draws each.
pub(crate) fn sweep(rounds: u64, mut each: impl FnMut(&mut Draw, Exact)) {
    for degree in 0..=7 {
        for seed in 0..rounds {
            let mut draw = Draw::new(seed * 64 + degree as u64);
            let spline = if seed % 3 == 2 { draw.closed(degree) } else { draw.open(degree) };
            each(&mut draw, spline);
        }
    }
}

/// The multiplicities of a knot vector's values.
pub(crate) fn multiplicity(knots: &[Rational], t: &Rational) -> usize {
    knots.iter().filter(|knot| *knot == t).count()
}
