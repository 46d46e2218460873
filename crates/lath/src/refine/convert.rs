//! From any family to another one that can hold the same curve.

use crate::curve::{BSpline, Bezier, Curve, Hermite, Interval, Power};
use crate::error::{Code, Error, Number, Result};
use crate::num::Bound;
use crate::refine::pieces::{Piece, of_curve};
use crate::refine::spline::Spline;
use crate::space::{distance, norm};
use alloc::format;
use alloc::vec::Vec;
use core::any::Any;

/// The same curve as Bézier curves, one for each of its polynomial pieces, in order.
///
/// *Error.* That of the curve's own pieces: a few convex combinations.
///
/// ```
/// use lath::curve::{Curve, Polyline};
/// use lath::refine::to_beziers;
///
/// let pieces = to_beziers(&Polyline::new([[0.0], [2.0], [1.0]])?)?;
/// assert_eq!(pieces[1].control_points(), [[2.0], [1.0]]);
/// # Ok::<(), lath::error::Error>(())
/// ```
///
/// # Errors
/// Q006 for a curve that is not piecewise polynomial.
pub fn to_beziers<const D: usize>(curve: &dyn Curve<D>) -> Result<Vec<Bezier<D>>> {
    let bezier = |piece: Piece<_>| Bezier::on(piece.points, Interval { start: piece.start, end: piece.end });
    of_curve(curve)?.into_iter().map(bezier).collect()
}

/// The same curve as a B-spline.
///
/// A B-spline comes back as it is, a Bézier curve clamped over its domain, a cubic Hermite curve over double knots; of every other
/// family the pieces' points become control points, over knots of multiplicity p where they meet and p + 1 where they do not. A
/// closed curve is opened, unless it is a B-spline: see [`BSpline::close`].
///
/// *Error.* None beyond that of the curve's own pieces, but for pieces whose degree is raised.
///
/// ```
/// use lath::curve::Hermite;
/// use lath::refine::to_bspline;
///
/// let curve = Hermite::new(vec![0.0, 1.0, 3.0], [[0.0], [1.0], [0.0]], [[3.0], [0.0], [-3.0]])?;
/// let same = to_bspline(&curve)?;
/// assert_eq!(same.knots().values(), [0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 3.0, 3.0, 3.0, 3.0]);
/// assert_eq!(same.control_points(), [[0.0], [1.0], [1.0], [1.0], [2.0], [0.0]]);
/// # Ok::<(), lath::error::Error>(())
/// ```
///
/// # Errors
/// Q006 for a curve that is not piecewise polynomial.
pub fn to_bspline<const D: usize>(curve: &dyn Curve<D>) -> Result<BSpline<D>> {
    let any = curve as &dyn Any;
    if let Some(bspline) = any.downcast_ref::<BSpline<D>>() {
        return Ok(bspline.clone());
    }
    let pieces = of_curve(curve)?;
    if any.is::<Hermite<D>>() {
        return from_smooth_cubics(&pieces);
    }
    BSpline::from_spline(Spline::from_pieces(&pieces)?)
}

/// The B-spline of cubic pieces that join with equal tangents: over double knots, without the points of the joints.
fn from_smooth_cubics<const D: usize>(pieces: &[Piece<[f64; D]>]) -> Result<BSpline<D>> {
    let (mut knots, mut points) = (Vec::new(), Vec::new());
    for (i, piece) in pieces.iter().enumerate() {
        let copies = if i == 0 { 4 } else { 2 };
        knots.extend(alloc::vec![piece.start; copies]);
        points.extend_from_slice(&piece.points[usize::from(i > 0)..piece.points.len() - 1]);
    }
    if let Some(last) = pieces.last() {
        knots.extend([last.end; 4]);
        points.extend(last.points.last());
    }
    BSpline::over(knots, 3, points)
}

/// The same curve in power form: on each piece Σ c_k (t − start)^k with c_k = C(p,k) Δᵏb₀/hᵏ.
///
/// *Error.* Each c_k to 2ᵏ⁺³ u Σ of the sizes of its differences: the form's condition, not the conversion's, decides what it is
/// worth near a piece's end.
///
/// ```
/// use lath::curve::Bezier;
/// use lath::refine::to_power;
///
/// let power = to_power(&Bezier::new([[1.0], [2.0], [5.0]])?)?;
/// assert_eq!(power.coefficients().next(), Some(&[[1.0], [2.0], [2.0]][..])); // 1 + 2t + 2t²
/// # Ok::<(), lath::error::Error>(())
/// ```
///
/// # Errors
/// Q006 for a curve that is not piecewise polynomial; P003 for coefficients beyond 1e300.
pub fn to_power<const D: usize>(curve: &dyn Curve<D>) -> Result<Power<D>> {
    let pieces = of_curve(curve)?;
    let p = pieces.iter().map(|piece| piece.points.len()).max().unwrap_or(1) - 1;
    let mut breaks: Vec<f64> = pieces.iter().map(|piece| piece.start).collect();
    breaks.extend(pieces.last().map(|piece| piece.end));
    Power::new(breaks, pieces.iter().map(|piece| coefficients(piece, p)))
}

/// The coefficients of one piece, with zeros up to degree p.
fn coefficients<const D: usize>(piece: &Piece<[f64; D]>, p: usize) -> Vec<[f64; D]> {
    let (n, h) = (piece.points.len() - 1, piece.end - piece.start);
    let (mut differences, mut factor) = (piece.points.clone(), 1.0);
    let mut row = Vec::with_capacity(p + 1);
    for k in 0..=n {
        if k > 0 {
            factor = factor * (n + 1 - k) as f64 / k as f64 / h;
            for i in 0..=n - k {
                differences[i] = core::array::from_fn(|c| differences[i + 1][c] - differences[i][c]);
            }
        }
        row.push(differences[0].map(|x| x * factor));
    }
    row.resize(p + 1, [0.0; D]);
    row
}

/// The same curve by points and tangents, where it is cubic at most and C¹, and the distance that rounding has put between them.
///
/// The tangent at a break is the mean of both sides'. A closed curve stays closed.
///
/// *Error.* The bound is proven: the greatest move of a Bernstein point, and what rounding may add. `tolerance` is how far tangents may
/// disagree, as a distance of Bernstein points.
///
/// ```
/// use lath::curve::BSpline;
/// use lath::refine::to_hermite;
///
/// let ring = BSpline::closed_uniform(3, [[0.0, -1.5], [1.5, 0.0], [0.0, 1.5], [-1.5, 0.0]])?;
/// let (curve, _) = to_hermite(&ring, 1e-12)?;
/// assert_eq!(curve.points(), [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]]);
/// assert_eq!(curve.tangents()[0], [0.0, 1.5]);
/// # Ok::<(), lath::error::Error>(())
/// ```
///
/// # Errors
/// Q006 for a curve that is not piecewise polynomial, of higher degree, or not C¹ within the tolerance, with the index of the break;
/// Q001 unless the tolerance is a positive finite number.
pub fn to_hermite<const D: usize>(curve: &dyn Curve<D>, tolerance: f64) -> Result<(Hermite<D>, Bound)> {
    crate::refine::measure::check_tolerance(tolerance)?;
    let given = of_curve(curve)?;
    let degree = given.iter().map(|piece| piece.points.len()).max().unwrap_or(1) - 1;
    if degree > 3 {
        return Err(Error::new(Code::Q006, format!("degree {degree} is above the 3 of a Hermite curve")));
    }
    let mut pieces = Vec::with_capacity(given.len());
    for piece in &given {
        let points = piece.to_spline()?.elevate(4 - piece.points.len())?.into_points();
        pieces.push(Piece { start: piece.start, end: piece.end, points });
    }
    // Slope at the start and the end of a piece.
    let slope = |piece: &Piece<[f64; D]>, i: usize| -> [f64; D] {
        core::array::from_fn(|c| 3.0 * ((piece.points[i + 1][c] - piece.points[i][c]) / (piece.end - piece.start)))
    };
    let (count, closed) = (pieces.len(), curve.is_closed());
    let (mut parameters, mut points, mut tangents) = (Vec::new(), Vec::new(), Vec::new());
    for i in 0..=count {
        let after = if i < count { pieces.get(i) } else { pieces.first().filter(|_| closed) };
        let before = if i > 0 { pieces.get(i - 1) } else { pieces.last().filter(|_| closed) };
        parameters.push(if i < count { pieces[i].start } else { pieces[count - 1].end });
        if closed && i == count {
            break;
        }
        let half = |a: [f64; D], b: [f64; D]| core::array::from_fn(|c| 0.5 * a[c] + 0.5 * b[c]);
        match (before, after) {
            (Some(before), Some(after)) => {
                points.push(half(before.points[3], after.points[0]));
                tangents.push(half(slope(before, 2), slope(after, 0)));
            }
            (Some(piece), None) => {
                points.push(piece.points[3]);
                tangents.push(slope(piece, 2));
            }
            (None, Some(piece)) => {
                points.push(piece.points[0]);
                tangents.push(slope(piece, 0));
            }
            (None, None) => {}
        }
    }
    // What Bernstein points the tangents stand for, and how far they are from those that were given.
    let (mut reached, mut size) = (0.0, 0.0);
    for (i, piece) in pieces.iter().enumerate() {
        let next = if i + 1 < points.len() { i + 1 } else { 0 };
        let third = (piece.end - piece.start) / 3.0;
        let inner = |sign: f64, k: usize| core::array::from_fn(|c| points[k][c] + sign * (tangents[k][c] * third));
        let found = [points[i], inner(1.0, i), inner(-1.0, next), points[next]];
        for (k, (found, given)) in found.iter().zip(&piece.points).enumerate() {
            let off = distance(found, given);
            if off > tolerance {
                let t = Number(if k < 2 { piece.start } else { piece.end });
                let message = format!("the pieces do not join with one tangent at t = {t}: {off:e} apart");
                return Err(Error::new(Code::Q006, message).at(i + usize::from(k > 1)));
            }
            reached = if off > reached { off } else { reached };
            size = if norm(given) > size { norm(given) } else { size };
        }
    }
    let curve = if closed {
        Hermite::closed(parameters, points, tangents)?
    } else {
        Hermite::new(parameters, points, tangents)?
    };
    Ok((curve, Bound::Proven(reached + 32.0 * f64::EPSILON * size)))
}
