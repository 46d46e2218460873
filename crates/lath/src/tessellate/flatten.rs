//! Curves to polylines within a tolerance.

use crate::basis::bernstein;
use crate::curve::Curve;
use crate::error::{Code, Error, Limits, Number, Result};
use crate::knot::Side;
use crate::num::Bound;
use crate::space::{distance, norm};
use crate::tessellate::rational::parts;
use alloc::format;
use alloc::vec::Vec;

/// Sends to `sink` points (t, P(t)) of the curve, in order, whose polyline stays within `tolerance` of the curve; returns the
/// bound that was reached. Both ends of the domain are among them. At a break with a jump both limits are sent, at the same t.
///
/// *Idea.* A piece of degree p with control points b that is cut into N equal steps stays within
/// p(p−1)/8 · max|b_{i+2} − 2b_{i+1} + bᵢ| / N² of its chords, at equal parameters and so also as point sets.
/// The smallest such N is taken (Wang 1984; Filip, Magedson and Markot 1986). Rational pieces have a bound of the same kind, in
/// homogeneous form (Zheng and Sederberg 2000), and are halved where their parameter runs unevenly.
///
/// *Cost.* One evaluation a point; about √(curvature · length² / tolerance) points.
///
/// *Error.* [`Bound::Proven`] for piecewise polynomial and rational curves, up to the rounding of the points themselves. Other curves get
/// steps that pass a midpoint test: [`Bound::Estimate`].
///
/// ```
/// use lath::{curve::Bezier, error::Limits, tessellate::flatten};
///
/// let arch = Bezier::new([[0.0, 0.0], [1.0, 2.0], [2.0, 0.0]])?;
/// let mut points = Vec::new();
/// let bound = flatten(&arch, 0.01, &Limits::default(), &mut |_t, point| points.push(point))?;
/// assert_eq!(points.len(), 11);
/// assert!(bound.is_proven() && bound.value() <= 0.01);
/// # Ok::<(), lath::error::Error>(())
/// ```
///
/// # Errors
/// Q001 for a tolerance that is not positive and finite; before the first point P003 for a piece whose control points overflow, and
/// B001 if there would be more points than the budget; B002 when cancelled.
pub fn flatten<const D: usize>(
    curve: &dyn Curve<D>,
    tolerance: f64,
    limits: &Limits<'_>,
    sink: &mut dyn FnMut(f64, [f64; D]),
) -> Result<Bound> {
    if !(tolerance > 0.0 && tolerance.is_finite()) {
        return Err(Error::new(Code::Q001, format!("the tolerance is {}", Number(tolerance))));
    }
    // Rounded parameters must not go back over each other.
    let mut at = f64::NEG_INFINITY;
    let sink = &mut |t: f64, point: [f64; D]| {
        if t > at {
            at = t;
        }
        sink(at, point);
    };
    let mut total = 1.0;
    let mut overflows = None;
    let mut look = |start: f64, points: &mut dyn Iterator<Item = [f64; D]>| {
        for point in points {
            if point.iter().any(|x| !x.is_finite()) {
                overflows.get_or_insert(start);
            }
        }
    };
    let exact = curve.bezier_pieces(&mut |piece| {
        look(piece.start, &mut piece.points.iter().copied());
        total += steps(piece.points, tolerance).0 + 1.0;
    });
    let rational =
        !exact && curve.rational_pieces(&mut |piece| look(piece.start, &mut piece.points.iter().map(|w| w.point)));
    if let Some(t) = overflows {
        return Err(Error::new(Code::P003, format!("the piece from t = {} on overflows", Number(t))));
    }
    if !exact && !rational {
        return by_midpoints(curve, tolerance, limits, sink);
    }
    if !exact {
        return by_parts(curve, tolerance, limits, sink);
    }
    // Beyond 2^64 the cast saturates, and is refused like any other excess.
    limits.check_points(total as u64)?;
    let mut reached = 0.0;
    let mut last: Option<[f64; D]> = None;
    let mut scratch = Vec::new();
    let mut outcome = Ok(());
    curve.bezier_pieces(&mut |piece| {
        if outcome.is_ok() {
            outcome = limits.check_cancel();
        }
        let (Ok(()), Some(first), Some(end)) = (&outcome, piece.points.first(), piece.points.last()) else {
            return;
        };
        let (count, deviation) = steps(piece.points, tolerance);
        if deviation > reached {
            reached = deviation;
        }
        // A joint is sent once, unless the curve jumps there by more than its rounding.
        let rounding = 16.0 * f64::EPSILON * piece.points.len() as f64 * norm(first);
        if last.is_none_or(|point| distance(&point, first) > rounding) {
            sink(piece.start, *first);
        }
        for k in 1..count as u64 {
            let u = k as f64 / count;
            scratch.clear();
            scratch.extend_from_slice(piece.points);
            let point = bernstein::eval_in_place(&mut scratch, (&(1.0 - u), &u));
            sink(parameter((piece.start, piece.end), u), point);
        }
        sink(piece.end, *end);
        last = Some(*end);
    });
    outcome.map(|()| Bound::Proven(reached))
}

/// Steps for a piecewise rational curve.
fn by_parts<const D: usize>(
    curve: &dyn Curve<D>,
    tolerance: f64,
    limits: &Limits<'_>,
    sink: &mut dyn FnMut(f64, [f64; D]),
) -> Result<Bound> {
    let (mut total, mut reached): (f64, f64) = (1.0, 0.0);
    let mut outcome = Ok(());
    curve.rational_pieces(&mut |piece| {
        total += 1.0;
        if outcome.is_ok() {
            outcome = limits.check_cancel();
        }
        let _ = outcome.is_ok()
            && parts(&piece, tolerance, &mut |part| {
                total += part.steps;
                if part.deviation > reached {
                    reached = part.deviation;
                }
                outcome = limits.check_points(total as u64);
                outcome.is_ok()
            });
    });
    outcome?;
    let mut last: Option<[f64; D]> = None;
    let mut outcome = Ok(());
    curve.rational_pieces(&mut |piece| {
        if outcome.is_ok() {
            outcome = limits.check_cancel();
        }
        let (Ok(()), Some(first)) = (&outcome, piece.points.first()) else { return };
        let rounding = 16.0 * f64::EPSILON * piece.points.len() as f64 * norm(&first.point);
        if last.is_none_or(|point| distance(&point, &first.point) > rounding) {
            sink(piece.start, first.point);
        }
        let mut send = |(u, point): (f64, [f64; D])| {
            sink(parameter((piece.start, piece.end), u), point);
        };
        parts(&piece, tolerance, &mut |part| {
            (1..part.steps as u64).for_each(|k| send(part.at(k)));
            send(part.last());
            true
        });
        last = piece.points.last().map(|point| point.point);
    });
    outcome.map(|()| Bound::Proven(reached))
}

/// The parameter of a piece at u, inside the piece however it is rounded.
fn parameter((start, end): (f64, f64), u: f64) -> f64 {
    let t = start * (1.0 - u) + end * u;
    if t < start {
        start
    } else if t > end || u == 1.0 {
        end
    } else {
        t
    }
}

/// The number of equal steps for a Bézier piece, and the deviation they leave.
fn steps<const D: usize>(points: &[[f64; D]], tolerance: f64) -> (f64, f64) {
    let degree = points.len() as f64 - 1.0;
    let bend = points.windows(3).fold(0.0, |most: f64, b| {
        let second = norm::<D>(&core::array::from_fn(|c| (b[2][c] - b[1][c]) - (b[1][c] - b[0][c])));
        if second > most { second } else { most }
    });
    let whole = degree * (degree - 1.0) / 8.0 * bend;
    if whole <= tolerance {
        return (1.0, whole);
    }
    let count = libm::ceil(libm::sqrt(whole / tolerance));
    (count, whole / count / count)
}

/// Steps for a curve that is not polynomial: each is halved until its middle and quarters lie within the tolerance.
fn by_midpoints<const D: usize>(
    curve: &dyn Curve<D>,
    tolerance: f64,
    limits: &Limits<'_>,
    sink: &mut dyn FnMut(f64, [f64; D]),
) -> Result<Bound> {
    const START: u32 = 8;
    let at = |t: f64, side| {
        let mut out = [[0.0; D]];
        curve.jet_into(t, side, &mut out);
        out[0]
    };
    let mut count: u64 = 1;
    for (i, pair) in curve.breaks().windows(2).enumerate() {
        let (a, b) = (pair[0], pair[1]);
        if i == 0 {
            sink(a, at(a, Side::Right));
        }
        for k in 0..START {
            let edge = |k: u32| a + (b - a) * (f64::from(k) / f64::from(START));
            // Right ends still to be reached and how often their step was halved, the nearest on top.
            let mut ends = alloc::vec![(if k + 1 == START { b } else { edge(k + 1) }, 0)];
            let mut from = (edge(k), at(edge(k), Side::Right));
            while let Some(&(t, depth)) = ends.last() {
                let to = at(t, if t == b { Side::Left } else { Side::Right });
                let middle = from.0 + (t - from.0) * 0.5;
                let off = [0.25, 0.5, 0.75].into_iter().any(|u| {
                    let point = at(from.0 + (t - from.0) * u, Side::Right);
                    distance(&point, &core::array::from_fn(|c| from.1[c] + (to[c] - from.1[c]) * u)) > tolerance
                });
                if off && depth < 40 && from.0 < middle && middle < t {
                    if let Some(end) = ends.last_mut() {
                        end.1 = depth + 1;
                    }
                    ends.push((middle, depth + 1));
                    continue;
                }
                count += 1;
                limits.check_points(count)?;
                limits.check_cancel()?;
                sink(t, to);
                from = (t, to);
                ends.pop();
            }
        }
    }
    Ok(Bound::Estimate(tolerance))
}
