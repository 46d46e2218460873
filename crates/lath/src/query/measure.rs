//! A curve cut into stretches whose lengths are known.

use crate::basis::bernstein::split_in_place;
use crate::curve::Curve;
use crate::error::{Code, Error, Limits, Result};
use crate::knot::Side;
use crate::query::length::check_accuracy;
use crate::query::speed::{Expansion, Piece};
use crate::space::{Weighted, distance};
use alloc::collections::BinaryHeap;
use alloc::vec::Vec;
use core::cmp::Ordering;

/// A stretch of a curve with its length.
#[derive(Debug)]
pub(crate) struct Stretch<const D: usize> {
    /// The parameters of its ends.
    pub(crate) start: f64,
    pub(crate) end: f64,
    pub(crate) length: f64,
    /// How far that may be off.
    pub(crate) error: f64,
    /// How the length grows along the stretch, and the rule that measured it; without, evenly.
    pub(crate) growth: Option<(Expansion<D>, usize)>,
}

/// The stretches of a curve in order, and whether their errors are proven; together they should be at most `accuracy`.
pub(crate) fn measure<const D: usize>(
    curve: &dyn Curve<D>,
    accuracy: f64,
    limits: &Limits<'_>,
) -> Result<(Vec<Stretch<D>>, bool)> {
    check_accuracy(accuracy)?;
    let (mut pieces, mut parts) = (Vec::new(), Vec::new());
    let mut add = |form: Option<Piece<D>>, hull: &dyn Fn() -> Vec<Weighted<D>>, start: f64, end: f64| {
        let shape = if form.is_some() { Shape::Form } else { Shape::Hull(hull()) };
        parts.push(Part::new(pieces.len(), (0.0, 1.0), shape));
        pieces.push(Whole { start, end, form });
    };
    let exact = curve.bezier_pieces(&mut |piece| {
        let hull = || piece.points.iter().map(|point| Weighted { point: *point, weight: 1.0 }).collect();
        add(Piece::polynomial(piece.points), &hull, piece.start, piece.end);
    }) || curve.rational_pieces(&mut |piece| {
        add(Piece::rational(piece.points), &|| piece.points.to_vec(), piece.start, piece.end);
    });
    if !exact {
        return Ok((by_steps(curve), false));
    }
    if pieces.iter().any(|piece| piece.form.as_ref().is_some_and(|form| !form.is_finite())) {
        return Err(Error::new(Code::P003, "the length overflows"));
    }
    Work { pieces, accuracy, domain: curve.domain().length(), total: 0.0, settled: Vec::new() }.run(parts, limits)
}

/// A piece of the curve, prepared if its speed can be expanded.
struct Whole<const D: usize> {
    start: f64,
    end: f64,
    form: Option<Piece<D>>,
}

/// Part of a piece, from lo to hi in [0, 1].
struct Part<const D: usize> {
    piece: usize,
    lo: f64,
    hi: f64,
    shape: Shape<D>,
    length: f64,
    error: f64,
    growth: Option<(Expansion<D>, usize)>,
}

enum Shape<const D: usize> {
    /// The piece's prepared form knows it.
    Form,
    /// The control points of the part.
    Hull(Vec<Weighted<D>>),
}

impl<const D: usize> Part<D> {
    fn new(piece: usize, (lo, hi): (f64, f64), shape: Shape<D>) -> Part<D> {
        Part { piece, lo, hi, shape, length: 0.0, error: 0.0, growth: None }
    }
}

/// The part that may be off most comes first; among equals, the one further on.
impl<const D: usize> Ord for Part<D> {
    fn cmp(&self, other: &Self) -> Ordering {
        let place = |part: &Self| (part.piece, part.lo);
        self.error.total_cmp(&other.error).then(place(self).partial_cmp(&place(other)).unwrap_or(Ordering::Equal))
    }
}

impl<const D: usize> PartialOrd for Part<D> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl<const D: usize> PartialEq for Part<D> {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl<const D: usize> Eq for Part<D> {}

struct Work<const D: usize> {
    pieces: Vec<Whole<D>>,
    accuracy: f64,
    domain: f64,
    /// An upper bound of the length.
    total: f64,
    settled: Vec<Part<D>>,
}

impl<const D: usize> Work<D> {
    /// Halves the part with the greatest error until none is above its share.
    fn run(mut self, mut parts: Vec<Part<D>>, limits: &Limits<'_>) -> Result<(Vec<Stretch<D>>, bool)> {
        let mut brackets = Vec::with_capacity(parts.len());
        for part in &mut parts {
            let bracket = self.bracket(part);
            self.total += if bracket.1.is_finite() { bracket.1 } else { 0.0 };
            brackets.push(bracket);
        }
        // What is asked for below the rounding of the whole would halve for ever, and find nothing.
        let least = self.total * f64::EPSILON;
        self.accuracy = if self.accuracy > least { self.accuracy } else { least };
        let mut open = BinaryHeap::new();
        for (part, bracket) in parts.into_iter().zip(brackets) {
            limits.check_cancel()?;
            self.settle(part, bracket, &mut open);
        }
        let mut halvings = 0;
        while halvings < limits.max_points {
            let Some(part) = open.pop() else { break };
            let middle = 0.5 * part.lo + 0.5 * part.hi;
            // Nothing is left to halve, or the number that ends the work was never one.
            if part.hi - part.lo < 1e-15 || part.error.is_nan() {
                self.settled.push(part);
                continue;
            }
            halvings += 1;
            limits.check_cancel()?;
            let (left, right) = match part.shape {
                Shape::Form => (Shape::Form, Shape::Form),
                Shape::Hull(mut points) => {
                    let right = split_in_place(&mut points, (&0.5, &0.5));
                    (Shape::Hull(points), Shape::Hull(right))
                }
            };
            for (interval, shape) in [((part.lo, middle), left), ((middle, part.hi), right)] {
                let mut half = Part::new(part.piece, interval, shape);
                let bracket = self.bracket(&mut half);
                self.settle(half, bracket, &mut open);
            }
        }
        self.settled.extend(open);
        self.settled.sort_by(|a, b| (a.piece, a.lo).partial_cmp(&(b.piece, b.lo)).unwrap_or(Ordering::Equal));
        let pieces = self.pieces;
        let stretch = |part: Part<D>| {
            let whole = &pieces[part.piece];
            let at = |u: f64| whole.start * (1.0 - u) + whole.end * u;
            Stretch {
                start: at(part.lo),
                end: at(part.hi),
                length: part.length,
                error: part.error,
                growth: part.growth,
            }
        };
        Ok((self.settled.into_iter().map(stretch).collect(), true))
    }

    /// Measures a part, whose length lies between two numbers, and puts it where it belongs.
    fn settle(&mut self, mut part: Part<D>, (below, above): (f64, f64), open: &mut BinaryHeap<Part<D>>) {
        let whole = &self.pieces[part.piece];
        let along = (part.hi - part.lo) * ((whole.end - whole.start) / self.domain);
        let weight = if above < self.total { above / self.total } else { 0.0 };
        let share = self.accuracy * (0.45 * weight + 0.45 * along);
        (part.length, part.error) = (0.5 * below + 0.5 * above, 0.5 * above - 0.5 * below);
        let mut rounding = 0.0;
        if let Some((expansion, kept)) = &mut part.growth {
            rounding = expansion.rounding;
            if let Some((rule, missed)) = expansion.rule(share).filter(|(_, missed)| *missed < part.error) {
                *kept = rule;
                (part.length, part.error) = (expansion.integrate(-1.0, 1.0, rule), missed);
            } else if part.error <= share {
                part.growth = None;
            }
        }
        let done = part.error <= share;
        part.error += rounding;
        // Halving does not help against rounding, but for the growth of high degrees over long intervals.
        let short = part.hi - part.lo < 0.1;
        if done && (short || rounding <= share) || part.error == 0.0 {
            self.settled.push(part)
        } else {
            open.push(part)
        }
    }

    /// Two numbers with the length between them.
    fn bracket(&self, part: &mut Part<D>) -> (f64, f64) {
        match (&part.shape, &self.pieces[part.piece].form) {
            (Shape::Form, Some(form)) => {
                let expansion = form.expand(part.lo, part.hi);
                let bracket = expansion.bracket();
                part.growth = Some((expansion, 3));
                bracket
            }
            (Shape::Form, None) => (0.0, f64::INFINITY),
            (Shape::Hull(points), _) => polygon(points),
        }
    }
}

/// The chord and the control polygon of a piece whose weights are not negative: it diminishes variation, and by Crofton's formula a length is
/// a mean of crossings. A point without weight has no part in it.
fn polygon<const D: usize>(points: &[Weighted<D>]) -> (f64, f64) {
    let (Some(first), Some(last)) = (points.first(), points.last()) else { return (0.0, 0.0) };
    let (mut polygon, mut corner) = (0.0, first);
    for point in points[1..].iter().filter(|point| point.weight > 0.0) {
        polygon += distance(&corner.point, &point.point);
        corner = point;
    }
    (distance(&first.point, &last.point), polygon)
}

/// Equal steps, each as long as its chord, and what half as many steps would have missed.
fn by_steps<const D: usize>(curve: &dyn Curve<D>) -> Vec<Stretch<D>> {
    const STEPS: u32 = 256;
    let mut stretches = Vec::new();
    for pair in curve.breaks().windows(2) {
        let parameter = |k: u32| {
            let u = f64::from(k) / f64::from(STEPS);
            pair[0] * (1.0 - u) + pair[1] * u
        };
        let at = |k: u32| {
            let side = if k == STEPS { Side::Left } else { Side::Right };
            let mut point = [[0.0; D]];
            curve.jet_into(parameter(k), side, &mut point);
            point[0]
        };
        for k in (0..STEPS).step_by(2) {
            let (a, b, c) = (at(k), at(k + 1), at(k + 2));
            let missed = distance(&a, &b) + distance(&b, &c) - distance(&a, &c);
            for (j, length) in [(k, distance(&a, &b)), (k + 1, distance(&b, &c))] {
                let (start, end) = (parameter(j), parameter(j + 1));
                stretches.push(Stretch { start, end, length, error: 0.5 * missed, growth: None });
            }
        }
    }
    stretches
}
