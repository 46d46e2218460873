//! What holds for every curve, whatever its family.
//!
//! Tolerances are multiples of `rounding`, a few units in the last place of the largest number that defines the curve, times what the
//! law itself amplifies: a k-th derivative over a piece of length h carries (2p/h)ᵏ.

use crate::conformance::{Definition, Invariance, Law, runner};
use crate::naive;
use crate::rational::Rational;
use lath::curve::{Curve, Outside};
use lath::error::{Code, Limits};
use lath::knot::Side;
use lath::query::bounds;
use lath::space::{distance, norm};
use lath::tessellate::flatten;
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::strategy::ValueTree;

/// A Bézier piece that the curve handed out, or one gap between breaks of a curve that hands out none.
struct Piece<const D: usize> {
    start: f64,
    end: f64,
    points: Vec<[f64; D]>,
    /// One a point, of a rational piece; none of a polynomial one.
    weights: Vec<f64>,
}

impl<const D: usize> Piece<D> {
    /// Whether the piece is one polynomial.
    fn is_polynomial(&self) -> bool {
        !self.points.is_empty() && self.weights.is_empty()
    }

    /// How much a k-th derivative may amplify the size of the data: 2p/h an order, with weights (Floater 1992) their greatest ratio squared.
    fn amplified(&self, degree: usize, k: usize) -> f64 {
        let spread = self.spread() * self.spread();
        (0..k).fold(amplified(degree, self.end - self.start, k), |factor, _| factor * spread)
    }

    /// The greatest ratio of two weights; 1 for a polynomial.
    fn spread(&self) -> f64 {
        let positive = || self.weights.iter().filter(|weight| **weight > 0.0);
        let most = positive().fold(0.0, |most: f64, weight| most.max(*weight));
        if self.weights.is_empty() { 1.0 } else { most / positive().fold(most, |least, weight| least.min(*weight)) }
    }

    /// Parameters inside, halves and quarters of the piece, as far as floats have room.
    fn inside(&self) -> Vec<f64> {
        let at = [0.5, 0.25, 0.875].map(|u| self.start + (self.end - self.start) * u);
        at.into_iter().filter(|t| self.start < *t && *t < self.end).collect()
    }
}

/// The curve's pieces; without points for a family that is not piecewise polynomial.
fn pieces<const D: usize>(curve: &dyn Curve<D>) -> Vec<Piece<D>> {
    let mut found = Vec::new();
    let exact = curve.bezier_pieces(&mut |piece| {
        found.push(Piece { start: piece.start, end: piece.end, points: piece.points.to_vec(), weights: Vec::new() });
    });
    assert!(exact || found.is_empty(), "pieces were handed out, and denied");
    let rational = !exact
        && curve.rational_pieces(&mut |piece| {
            let (start, end) = (piece.start, piece.end);
            let (points, weights) = piece.points.iter().map(|point| (point.point, point.weight)).unzip();
            found.push(Piece { start, end, points, weights });
        });
    assert!(exact || rational == curve.is_rational(), "whether the pieces are rational is told in two ways");
    if !exact && !rational {
        assert!(found.is_empty(), "pieces were handed out, and denied");
        let gap = |pair: &[f64]| Piece { start: pair[0], end: pair[1], points: Vec::new(), weights: Vec::new() };
        found = curve.breaks().windows(2).map(gap).collect();
    }
    found
}

/// The size of the numbers that define the curve.
fn scale<const D: usize>(definition: &Definition<D>, curve: &dyn Curve<D>) -> f64 {
    let found = pieces(curve);
    let all = definition.points.iter().chain(found.iter().flat_map(|piece| &piece.points));
    all.flatten().fold(0.0, |most: f64, x| most.max(x.abs()))
}

/// Some units in the last place of the curve's size.
fn rounding<const D: usize>(definition: &Definition<D>, curve: &dyn Curve<D>) -> f64 {
    let degree = curve.degree() as f64;
    16.0 * (degree + 1.0) * f64::EPSILON / 2.0 * scale(definition, curve)
}

fn jet<const D: usize>(curve: &dyn Curve<D>, t: f64, side: Side, order: usize) -> Vec<[f64; D]> {
    let mut out = vec![[0.0; D]; order + 1];
    curve.jet_into(t, side, &mut out);
    out
}

/// Exactly: the k-th derivative of a piece's Bézier polynomial at t.
fn exact<const D: usize>(piece: &Piece<D>, k: usize, t: f64) -> [f64; D] {
    let (a, b, t) = (Rational::from_f64(piece.start), Rational::from_f64(piece.end), Rational::from_f64(t));
    let weights: Vec<Rational> = piece.weights.iter().map(|weight| Rational::from_f64(*weight)).collect();
    std::array::from_fn(|c| {
        let column: Vec<Rational> = piece.points.iter().map(|point| Rational::from_f64(point[c])).collect();
        if weights.is_empty() {
            return naive::bezier(&column, (&a, &b), k, &t).to_f64();
        }
        let weighted: Vec<Rational> = column.iter().zip(&weights).map(|(x, w)| x.clone() * w.clone()).collect();
        let derivatives = |row: &[Rational]| (0..=k).map(|i| naive::bezier(row, (&a, &b), i, &t)).collect::<Vec<_>>();
        naive::quotient(&derivatives(&weighted), &derivatives(&weights))[k].to_f64()
    })
}

/// (2p/h)ᵏ: how much a k-th derivative over a length h may amplify the size of the data.
fn amplified(degree: usize, h: f64, k: usize) -> f64 {
    (0..k).fold(1.0, |factor, _| factor * 2.0 * degree.max(1) as f64 / h)
}

/// The greatest order up to 3 and the degree whose derivative a float can hold on a piece: over 1e-200 a third cannot be.
fn held_order<const D: usize>(definition: &Definition<D>, curve: &dyn Curve<D>, piece: &Piece<D>) -> usize {
    let (degree, size) = (curve.degree(), scale(definition, curve).max(1.0));
    let held = |k: &usize| size * piece.amplified(degree, *k) < 1e303;
    (0..=degree.min(3)).rev().find(held).unwrap_or(0)
}

/// The domain is an interval, its ends are answered, and the breaks span it.
pub fn any_domain_is_kept<const D: usize>(definition: &Definition<D>, curve: &dyn Curve<D>) -> Law {
    let domain = curve.domain();
    prop_assert!(domain.start.is_finite() && domain.end.is_finite() && domain.start < domain.end, "{domain:?}");
    let breaks = curve.breaks();
    prop_assert_eq!((breaks.first(), breaks.last()), (Some(&domain.start), Some(&domain.end)));
    prop_assert!(breaks.windows(2).all(|pair| pair[0] < pair[1]), "breaks {breaks:?}");
    prop_assert_eq!(curve.eval(domain.start).unwrap(), jet(curve, domain.start, Side::Right, 0)[0]);
    prop_assert_eq!(curve.eval(domain.end).unwrap(), jet(curve, domain.end, Side::Left, 0)[0]);
    for t in [domain.start.next_down(), domain.end.next_up()] {
        prop_assert_eq!(curve.eval(t).unwrap_err().code(), Code::T002);
        prop_assert_eq!(curve.jet(t, 1).unwrap_err().code(), Code::T002);
    }
    if curve.is_closed() && curve.degree() > 0 {
        let (first, last) = (curve.eval(domain.start).unwrap(), curve.eval(domain.end).unwrap());
        // What stands before the seam and after it is the same up to the rounding of a shift by one period.
        let shift = 2.0 * f64::EPSILON * (domain.start.abs() + domain.end.abs() + domain.length());
        let shortest = breaks.windows(2).fold(f64::MAX, |least, pair| least.min(pair[1] - pair[0]));
        let blur = curve.degree() as f64 * shift / shortest * scale(definition, curve);
        let off = distance(&first, &last);
        prop_assert!(off <= rounding(definition, curve) + blur, "{first:?} and {last:?} do not close");
    }
    prop_assert!(!curve.kind().is_empty());
    Ok(())
}

/// A parameter that is no number is an error under every policy; every other one gets a finite answer.
pub fn any_parameter_is_answered_or_refused<const D: usize>(definition: &Definition<D>, curve: &dyn Curve<D>) -> Law {
    for t in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for outside in [Outside::Error, Outside::Clamp, Outside::Extrapolate, Outside::Periodic] {
            prop_assert_eq!(curve.eval_outside(t, outside).unwrap_err().code(), Code::T001);
        }
        prop_assert_eq!(curve.jet(t, 2).unwrap_err().code(), Code::T001);
    }
    let end = curve.domain().end;
    for piece in pieces(curve) {
        // A break is answered by the piece after it.
        let last = (piece.end == end).then_some(end);
        for t in piece.inside().into_iter().chain([piece.start]).chain(last) {
            let order = held_order(definition, curve, &piece);
            let values = curve.jet(t, order).unwrap();
            prop_assert_eq!(values.len(), order + 1);
            prop_assert!(values.iter().flatten().all(|x| x.is_finite()), "{values:?} at {t}");
            prop_assert_eq!(curve.eval(t).unwrap(), values[0]);
        }
    }
    Ok(())
}

/// At a break the left limit is the end of the piece before, the right limit the start of the piece after, and the value
/// is the right one, except at the end of the domain.
pub fn any_side_of_a_break_is_its_piece<const D: usize>(definition: &Definition<D>, curve: &dyn Curve<D>) -> Law {
    let found = pieces(curve);
    let rounding = rounding(definition, curve);
    for (i, piece) in found.iter().enumerate() {
        let (degree, order) = (curve.degree(), held_order(definition, curve, piece));
        for (t, side) in [(piece.start, Side::Right), (piece.end, Side::Left)] {
            let limits = jet(curve, t, side, order);
            for (k, limit) in limits.iter().enumerate().filter(|_| !piece.points.is_empty()) {
                let expected = exact(piece, k, t);
                let tolerance = rounding * piece.amplified(degree, k);
                let off = distance(limit, &expected);
                prop_assert!(off <= tolerance, "derivative {k} at {t} from {side:?}: {limit:?}, not {expected:?}");
            }
            let answered = side == Side::Right || i + 1 == found.len();
            if answered {
                prop_assert_eq!(curve.eval(t).unwrap(), limits[0]);
            }
        }
    }
    Ok(())
}

/// The pieces cover the domain in order without gaps, have the curve's degree at most, and are the curve.
pub fn any_piece_is_the_curve<const D: usize>(definition: &Definition<D>, curve: &dyn Curve<D>) -> Law {
    let found = pieces(curve);
    let domain = curve.domain();
    prop_assert_eq!(found.first().map(|piece| piece.start), Some(domain.start));
    prop_assert_eq!(found.last().map(|piece| piece.end), Some(domain.end));
    prop_assert!(found.windows(2).all(|pair| pair[0].end == pair[1].start), "gaps between the pieces");
    let edges: Vec<f64> = found.iter().map(|piece| piece.start).chain([domain.end]).collect();
    prop_assert_eq!(edges, curve.breaks());
    let rounding = rounding(definition, curve);
    for piece in found.iter().filter(|piece| !piece.points.is_empty()) {
        prop_assert!(piece.points.len() <= curve.degree() + 1);
        for t in piece.inside() {
            for (k, value) in jet(curve, t, Side::Right, held_order(definition, curve, piece)).iter().enumerate() {
                let expected = exact(piece, k, t);
                let tolerance = rounding * piece.amplified(curve.degree(), k);
                prop_assert!(
                    distance(value, &expected) <= tolerance,
                    "derivative {k} at {t}: {value:?}, not {expected:?}"
                );
            }
        }
    }
    Ok(())
}

/// The box holds every sample, up to the rounding of evaluation.
pub fn any_box_holds_the_curve<const D: usize>(definition: &Definition<D>, curve: &dyn Curve<D>) -> Law {
    let (found, bound) = bounds(curve);
    let slack = rounding(definition, curve) + if bound.is_proven() { 0.0 } else { bound.value() };
    for piece in pieces(curve) {
        for t in piece.inside().into_iter().chain([piece.start, piece.end]) {
            let point = curve.eval(t).unwrap();
            let inside = (0..D).all(|c| found.lo[c] - slack <= point[c] && point[c] <= found.hi[c] + slack);
            prop_assert!(inside, "{point:?} at {t} is outside {found:?}");
        }
    }
    Ok(())
}

/// In every direction no point of a piece lies beyond the piece's control points.
pub fn any_hull_holds_the_curve<const D: usize>(definition: &Definition<D>, curve: &dyn Curve<D>) -> Law {
    let along = |direction: &[f64; D], point: &[f64; D]| -> f64 { (0..D).map(|c| direction[c] * point[c]).sum() };
    let rounding = 4.0 * D as f64 * rounding(definition, curve);
    for piece in pieces(curve).iter().filter(|piece| !piece.points.is_empty()) {
        for turn in 0..8 {
            // Directions that are spread, not random: the law is about pieces, which are.
            let direction: [f64; D] = std::array::from_fn(|c| f64::from((turn * 5 + c as i32 * 3) % 8 - 4) / 4.0);
            let most = piece.points.iter().fold(f64::MIN, |most, point| most.max(along(&direction, point)));
            for t in piece.inside() {
                let reached = along(&direction, &curve.eval(t).unwrap());
                prop_assert!(reached <= most + rounding, "{reached} beyond {most} at {t} along {direction:?}");
            }
        }
    }
    Ok(())
}

/// Each derivative is the limit of differences of the one before; beyond the degree of a polynomial they vanish.
pub fn derivatives_are_derivatives<const D: usize>(definition: &Definition<D>, curve: &dyn Curve<D>) -> Law {
    let degree = curve.degree();
    let rounding = rounding(definition, curve);
    for piece in pieces(curve) {
        let h = piece.end - piece.start;
        let step = h / 1024.0;
        let order = degree.clamp(1, 3);
        // A central difference over 2⁻⁹ of a piece: off by its square times the second derivative after, which Markov's
        // inequality bounds by (2p²/h)² of the greatest derivative on the piece.
        let p = degree.max(1) as f64;
        for t in piece.inside() {
            let (before, here, after) = (
                jet(curve, t - step, Side::Right, order),
                jet(curve, t, Side::Right, order),
                jet(curve, t + step, Side::Right, order),
            );
            for k in 1..=order {
                let difference: [f64; D] = std::array::from_fn(|c| (after[k - 1][c] - before[k - 1][c]) / (2.0 * step));
                let (size, spread) = (scale(definition, curve) * piece.amplified(degree, k), piece.spread());
                let tolerance = 4.0 * p * p * p * p * spread * spread * size / (1 << 20) as f64
                    + 1024.0 * rounding * piece.amplified(degree, k);
                let off = distance(&difference, &here[k]);
                prop_assert!(off <= tolerance, "derivative {k} at {t}: {:?}, differences say {difference:?}", here[k]);
            }
            if piece.is_polynomial() {
                let beyond = jet(curve, t, Side::Right, degree + 2);
                prop_assert!(beyond[degree + 1..].iter().flatten().all(|x| *x == 0.0), "beyond the degree at {t}");
            }
        }
    }
    Ok(())
}

/// Outside the domain: refused, clamped to the end, continued by the end piece's own derivatives, or repeated.
pub fn outside_follows_the_policy<const D: usize>(definition: &Definition<D>, curve: &dyn Curve<D>) -> Law {
    let domain = curve.domain();
    let found = pieces(curve);
    let (first, last) = (&found[0], &found[found.len() - 1]);
    let rounding = rounding(definition, curve);
    for (piece, end, side, sign) in [(first, domain.start, Side::Right, -1.0), (last, domain.end, Side::Left, 1.0)] {
        let h = piece.end - piece.start;
        let t = end + sign * 0.25 * h;
        prop_assert_eq!(curve.eval_outside(t, Outside::Error).unwrap_err().code(), Code::T002);
        prop_assert_eq!(curve.eval_outside(t, Outside::Clamp).unwrap(), curve.eval(end).unwrap());
        let value = || curve.eval_outside(t, Outside::Extrapolate);
        if let Some(nearest) = piece.weights.iter().copied().reduce(f64::min).filter(|least| *least > 0.0) {
            // A quotient goes on until its denominator vanishes.
            let exactly: Vec<Rational> = piece.weights.iter().map(|w| Rational::from_f64(*w)).collect();
            let ends = (&Rational::from_f64(piece.start), &Rational::from_f64(piece.end));
            let denominator = naive::bezier(&exactly, ends, 0, &Rational::from_f64(t)).to_f64();
            if denominator > 0.25 * nearest {
                let (value, expected) = (value().unwrap(), exact(piece, 0, t));
                let growth = (0..=curve.degree()).fold(4.0 * piece.spread(), |growth, _| growth * 4.0);
                let off = distance(&value, &expected);
                let size = norm(&expected) / scale(definition, curve).max(1e-300);
                prop_assert!(off <= rounding * growth * (1.0 + size), "{value:?} at {t}, not {expected:?}");
            }
        }
        if piece.is_polynomial() {
            // A polynomial is its own Taylor series, here at the end of the domain.
            let derivatives = jet(curve, end, side, curve.degree());
            let mut expected = [0.0; D];
            let mut power = 1.0;
            for (k, derivative) in derivatives.iter().enumerate() {
                (0..D).for_each(|c| expected[c] += derivative[c] * power);
                power *= (t - end) / (k + 1) as f64;
            }
            let value = value().unwrap();
            let growth = (0..=curve.degree()).fold(1.0, |growth, _| growth * 2.0);
            let tolerance = 16.0 * rounding * growth * growth;
            prop_assert!(
                distance(&value, &expected) <= tolerance,
                "{value:?} at {t}, the piece goes on to {expected:?}"
            );
        }
    }
    for piece in &found {
        let middle = piece.start + 0.5 * (piece.end - piece.start);
        for turns in [-3.0, -1.0, 1.0, 2.0] {
            // The parameter itself is rounded on its way out and back.
            let t = middle + turns * domain.length();
            let blur = 8.0 * f64::EPSILON * (t.abs() + domain.length() + middle.abs());
            let speed = scale(definition, curve) * piece.amplified(curve.degree(), 1);
            let (value, expected) = (curve.eval_outside(t, Outside::Periodic).unwrap(), curve.eval(middle).unwrap());
            let off = distance(&value, &expected);
            prop_assert!(off <= rounding + blur * speed, "{value:?} at {t}, but {expected:?} at {middle}");
        }
    }
    Ok(())
}

/// The box is not larger than it says: samples come near each of its faces.
pub fn box_is_tight<const D: usize>(definition: &Definition<D>, curve: &dyn Curve<D>) -> Law {
    const SAMPLES: i32 = 64;
    let (found, bound) = bounds(curve);
    let (mut lo, mut hi) = ([f64::MAX; D], [f64::MIN; D]);
    for piece in pieces(curve) {
        for k in 0..=SAMPLES {
            let t = piece.start + (piece.end - piece.start) * (f64::from(k) / f64::from(SAMPLES));
            // Both limits at the ends of a piece, for a curve may jump there.
            let side = if k == SAMPLES { Side::Left } else { Side::Right };
            let point = jet(curve, t, side, 0)[0];
            (0..D).for_each(|c| (lo[c], hi[c]) = (lo[c].min(point[c]), hi[c].max(point[c])));
        }
    }
    // Between samples the curve may rise by an eighth of the squared step times its second derivative.
    let p = curve.degree().max(1) as f64;
    let step = 1.0 / f64::from(SAMPLES);
    let bent = pieces(curve)
        .iter()
        .fold(1.0, |most: f64, piece| most.max(piece.amplified(1, 2) / amplified(1, piece.end - piece.start, 2)));
    let unseen = step * step / 8.0 * 4.0 * p * p * p * p * bent * scale(definition, curve);
    let allowed = unseen + bound.value() + rounding(definition, curve);
    for c in 0..D {
        let near = found.hi[c] - hi[c] <= allowed && lo[c] - found.lo[c] <= allowed;
        prop_assert!(near, "axis {c}: {found:?}, but samples reach {lo:?} … {hi:?}");
    }
    Ok(())
}

/// For a geometric series of tolerances: the polyline runs from end to end in order, stays within the tolerance, says so, and
/// is refused by a budget that it exceeds.
pub fn flattening_stays_within_tolerance<const D: usize>(definition: &Definition<D>, curve: &dyn Curve<D>) -> Law {
    let domain = curve.domain();
    let size = scale(definition, curve).max(1.0);
    let rounding = rounding(definition, curve);
    for exponent in [1, 4, 7, 10, 14] {
        let tolerance = size / f64::from(1 << exponent);
        let mut line: Vec<(f64, [f64; D])> = Vec::new();
        let bound = flatten(curve, tolerance, &Limits::default(), &mut |t, point| line.push((t, point))).unwrap();
        prop_assert!(bound.value() <= tolerance, "{bound:?} above {tolerance}");
        prop_assert!(line.windows(2).all(|pair| pair[0].0 <= pair[1].0), "parameters go back");
        prop_assert_eq!((line[0].0, line[line.len() - 1].0), (domain.start, domain.end));
        for pair in line.windows(2).filter(|pair| pair[0].0 < pair[1].0) {
            for u in [0.25, 0.5, 0.75] {
                let t = pair[0].0 * (1.0 - u) + pair[1].0 * u;
                let off = off_segment(&curve.eval(t).unwrap(), &pair[0].1, &pair[1].1);
                prop_assert!(off <= tolerance + rounding, "{off:e} off at {t} with tolerance {tolerance:e}");
            }
        }
        let short = Limits { max_points: line.len() as u64 / 2, ..Limits::default() };
        let refusal = flatten(curve, tolerance, &short, &mut |_, _| {}).unwrap_err();
        prop_assert!(refusal.is_budget(), "{refusal}");
    }
    for tolerance in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let refusal = flatten(curve, tolerance, &Limits::default(), &mut |_, _| {}).unwrap_err();
        prop_assert_eq!(refusal.code(), Code::Q001);
    }
    Ok(())
}

/// The distance of a point from a segment.
fn off_segment<const D: usize>(point: &[f64; D], a: &[f64; D], b: &[f64; D]) -> f64 {
    let along: [f64; D] = std::array::from_fn(|c| b[c] - a[c]);
    let length = norm(&along);
    let dot: f64 = (0..D).map(|c| (point[c] - a[c]) * along[c]).sum();
    let u = if length > 0.0 { (dot / length / length).clamp(0.0, 1.0) } else { 0.0 };
    distance(point, &std::array::from_fn(|c| a[c] + u * along[c]))
}

/// x ↦ (Ax + b)/(c·x + d); with c = 0 and d = 1 an affine map.
#[derive(Clone, Debug)]
pub struct Map<const D: usize> {
    matrix: [[f64; D]; D],
    offset: [f64; D],
    row: [f64; D],
    corner: f64,
}

impl<const D: usize> Map<D> {
    fn vector(&self, v: &[f64; D]) -> [f64; D] {
        std::array::from_fn(|i| (0..D).map(|j| self.matrix[i][j] * v[j]).sum())
    }

    /// c·x + d, by which a weight grows.
    fn weight(&self, p: &[f64; D]) -> f64 {
        (0..D).map(|j| self.row[j] * p[j]).sum::<f64>() + self.corner
    }

    fn point(&self, p: &[f64; D]) -> [f64; D] {
        let (turned, weight) = (self.vector(p), self.weight(p));
        std::array::from_fn(|i| (turned[i] + self.offset[i]) / weight)
    }

    fn definition(&self, definition: &Definition<D>) -> Definition<D> {
        let weights = definition.weights.iter().zip(&definition.points);
        Definition {
            points: definition.points.iter().map(|p| self.point(p)).collect(),
            vectors: definition.vectors.iter().map(|v| self.vector(v)).collect(),
            weights: weights.map(|(w, p)| w * self.weight(p)).collect(),
            ..definition.clone()
        }
    }
}

/// Random maps of a group.
pub fn maps<const D: usize>(invariance: Invariance) -> impl Strategy<Value = Map<D>> {
    (vec(-2.0f64..2.0, D * D), vec(-5.0f64..5.0, D)).prop_map(move |(entries, offset)| {
        let unit = |i: usize, j: usize| if i == j { 1.0 } else { 0.0 };
        let matrix = match invariance {
            Invariance::Affine | Invariance::Projective => {
                std::array::from_fn(|i| std::array::from_fn(|j| entries[i * D + j]))
            }
            Invariance::PerAxis => std::array::from_fn(|i| std::array::from_fn(|j| unit(i, j) * entries[i])),
            // A reflection I − 2vvᵀ/|v|², scaled: every similarity is made of such.
            Invariance::Similarity => {
                let v: [f64; D] = std::array::from_fn(|i| entries[i]);
                let square = v.iter().map(|x| x * x).sum::<f64>().max(1e-3);
                let factor = 1.5 + entries[D - 1] / 2.0;
                std::array::from_fn(|i| std::array::from_fn(|j| factor * (unit(i, j) - 2.0 * v[i] * v[j] / square)))
            }
        };
        let (row, corner) = match invariance {
            // Points of size 10 stay on one side of the plane that goes to infinity; all weights grow by the factor, too.
            Invariance::Projective => {
                let factor = 2.0 + entries[0];
                let factor = if factor > 0.25 { factor } else { 0.25 };
                (std::array::from_fn(|j| 0.01 * factor * offset[(j + 1) % D] / D as f64), factor)
            }
            _ => ([0.0; D], 1.0),
        };
        Map { matrix, offset: std::array::from_fn(|i| offset[i]), row, corner }
    })
}

/// Some parameters of the domain: the middle of each piece and both ends.
fn samples<const D: usize>(curve: &dyn Curve<D>) -> Vec<f64> {
    let domain = curve.domain();
    let middles = pieces(curve).into_iter().flat_map(|piece| piece.inside()).collect::<Vec<f64>>();
    [domain.start].into_iter().chain(middles).chain([domain.end]).collect()
}

/// The curve of the mapped definition is the map of the curve.
pub fn invariance<const D: usize, C: Curve<D>>(
    definition: &Definition<D>,
    map: &Map<D>,
    build: impl Fn(&Definition<D>) -> C,
) -> Law {
    let curve = build(definition);
    let mapped_definition = map.definition(definition);
    let mapped = build(&mapped_definition);
    // The map's own rounding, of products with entries up to 2 and sums of D + 1 terms; rounded weights move the points of the mapped curve.
    let spread = pieces(&curve).iter().fold(1.0, |most: f64, piece| most.max(piece.spread()));
    let tolerance =
        spread * 4.0 * (D + 1) as f64 * (rounding(definition, &curve) + rounding(&mapped_definition, &mapped))
            + 64.0 * f64::EPSILON;
    for t in samples(&curve) {
        let (found, expected) = (mapped.eval(t).unwrap(), map.point(&curve.eval(t).unwrap()));
        prop_assert!(distance(&found, &expected) <= tolerance, "{found:?} at {t}, the mapped curve has {expected:?}");
    }
    Ok(())
}

/// One map outside the group changes the curve: the declaration is not too modest.
///
/// Outside the affine and the projective maps a bent one is taken, outside the similarities a shear, outside the maps per axis a rotation.
///
/// # Panics
/// If no draw is changed by it.
pub fn invariance_ends<const D: usize, C: Curve<D>>(
    strategy: impl Strategy<Value = Definition<D>>,
    invariance: Invariance,
    build: impl Fn(&Definition<D>) -> C,
) {
    let unit = |i: usize, j: usize| if i == j { 1.0 } else { 0.0 };
    let shear = |i: usize, j: usize| unit(i, j) + if j == i + 1 { 2.0 } else { 0.0 };
    let turn = |i: usize, j: usize| if i == j { 0.8 } else { 0.6 * if i < j { -1.0 } else { 1.0 } };
    let entry = |i: usize, j: usize| match invariance {
        Invariance::Affine | Invariance::Projective => unit(i, j),
        Invariance::Similarity => shear(i, j),
        Invariance::PerAxis => turn(i, j),
    };
    let matrix = std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j)));
    let linear = Map { matrix, offset: [0.0; D], row: [0.0; D], corner: 1.0 };
    let map = |point: &[f64; D]| match invariance {
        Invariance::Affine | Invariance::Projective => point.map(|x| x + 0.125 * x * x),
        _ => linear.point(point),
    };
    let mut runner = runner();
    for _ in 0..64 {
        let definition = strategy.new_tree(&mut runner).unwrap().current();
        let curve = build(&definition);
        let points = definition.points.iter().map(map).collect();
        let changed = build(&Definition { points, ..linear.definition(&definition) });
        let size = scale(&definition, &curve).max(1.0);
        let differs = |t| distance(&changed.eval(t).unwrap(), &map(&curve.eval(t).unwrap())) > 1e-3 * size;
        if samples(&curve).into_iter().any(differs) {
            return;
        }
    }
    panic!("no draw is changed by a map outside {invariance:?}: declare the larger group");
}

/// The reversed definition is the same curve run backwards.
pub fn reversal<const D: usize>(definition: &Definition<D>, curve: &dyn Curve<D>, reversed: &dyn Curve<D>) -> Law {
    let (domain, mirrored) = (curve.domain(), reversed.domain());
    let drift = (domain.length() - mirrored.length()).abs();
    prop_assert!(
        drift <= 8.0 * f64::EPSILON * (domain.length() + domain.start.abs()),
        "{domain:?} became {mirrored:?}"
    );
    let rounding = rounding(definition, curve);
    for piece in pieces(curve) {
        for t in piece.inside() {
            // The parameter is rounded on its way; the curve moves with its speed.
            let s = mirrored.start + (domain.end - t);
            let blur = 8.0 * f64::EPSILON * (domain.start.abs() + domain.end.abs() + mirrored.end.abs());
            let speed = scale(definition, curve) * piece.amplified(curve.degree(), 1);
            let (forth, back) = (curve.eval(t).unwrap(), reversed.eval(s.clamp(mirrored.start, mirrored.end)).unwrap());
            prop_assert!(
                distance(&forth, &back) <= rounding + blur * speed,
                "{forth:?} at {t}, backwards {back:?} at {s}"
            );
        }
    }
    Ok(())
}
