//! Cubic splines through points, with every end condition.
//!
//! *Source.* Rogers and Adams, Mathematical Elements for Computer Graphics, ch. 5; de Boor, A Practical Guide to Splines
//! (1978), ch. IV; the anticyclic ends as in Rogers and Adams, P′₁(0) = −P′ₙ(tₙ) and P″₁(0) = −P″ₙ(tₙ).
//!
//! The unknowns are the slopes. With h the intervals and δ the chords' slopes, C² at the inner point i reads
//!
//! λ m_{i−1} + 2 mᵢ + μ m_{i+1} = 3 (λ δ_{i−1} + μ δᵢ),  λ = hᵢ/(h_{i−1} + hᵢ),  μ = h_{i−1}/(h_{i−1} + hᵢ):
//!
//! the textbook's row divided by h_{i−1} + hᵢ, so that every row has the same scale and nothing overflows early.

use crate::curve::{Hermite, check_increasing};
use crate::error::{Code, Count, Error, Result};
use crate::interpolate::ends::{End, Ends};
use crate::num::{Banded, CyclicBanded, Scalar};
use crate::space::{IntoPoint, collect};
use alloc::format;
use alloc::vec::Vec;

/// The cubic spline through the points at the given parameters.
///
/// *Cost.* O(n) time and memory, all coordinates in one sweep. *Error.* The system is diagonally dominant (not-a-knot after
/// one elimination step): the slopes carry a few u of the largest slope.
///
/// *Invariance:* affine for given parameters.
///
/// *Degenerate input.* Two points with not-a-knot ends give the straight line, three the parabola; one not-a-knot end
/// over a single interval makes the third derivative zero. Coinciding points are allowed at different parameters.
///
/// ```
/// use lath::curve::Curve;
/// use lath::interpolate::{cubic, End, Ends};
///
/// // Not-a-knot ends reproduce a cubic: here t³.
/// let t = vec![0.0, 1.0, 2.0, 4.0];
/// let curve = cubic([[0.0], [1.0], [8.0], [64.0]], t, &Ends::Open(End::NotAKnot, End::NotAKnot))?;
/// assert_eq!(curve.eval(3.0)?, [27.0]);
/// # Ok::<(), lath::error::Error>(())
/// ```
///
/// # Errors
/// P001 for fewer than two points; P002 and P003 for coordinates; T001, T003, T004, T005 for parameters; P003 if the slopes
/// overflow.
pub fn cubic<const D: usize>(
    points: impl IntoIterator<Item = impl IntoPoint<D>>,
    parameters: Vec<f64>,
    ends: &Ends<D>,
) -> Result<Hermite<D>> {
    let points = checked(points, &parameters, 0)?;
    if let Ends::Open(start, end) = ends {
        for end in [start, end] {
            if let End::Clamped(vector) | End::Second(vector) = end {
                collect([vector])?;
            }
        }
    }
    let tangents = slopes(&intervals(&parameters), &points, ends)?;
    Hermite::checked(parameters, points, finite(tangents)?, 0)
}

/// The closed cubic spline through the points: one more parameter than points, C² everywhere.
///
/// *Cost, error, invariance* as [`cubic`].
///
/// ```
/// use lath::curve::Curve;
/// use lath::interpolate::cubic_closed;
///
/// let curve = cubic_closed([[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]], vec![0.0, 1.0, 2.0, 3.0, 4.0])?;
/// assert_eq!(curve.jet(0.0, 1)?, curve.jet(4.0, 1)?);
/// # Ok::<(), lath::error::Error>(())
/// ```
///
/// # Errors
/// As [`cubic`].
pub fn cubic_closed<const D: usize>(
    points: impl IntoIterator<Item = impl IntoPoint<D>>,
    parameters: Vec<f64>,
) -> Result<Hermite<D>> {
    let points = checked(points, &parameters, 1)?;
    let tangents = slopes_closed(&intervals(&parameters), &points)?;
    Hermite::checked(parameters, points, finite(tangents)?, 1)
}

fn checked<const D: usize>(
    points: impl IntoIterator<Item = impl IntoPoint<D>>,
    parameters: &[f64],
    extra: usize,
) -> Result<Vec<[f64; D]>> {
    let points = collect(points)?;
    if points.len() < 2 {
        return Err(Error::new(Code::P001, format!("a curve takes at least 2 points, not {}", points.len())));
    }
    if parameters.len() != points.len() + extra {
        let message = format!("{} for {}", Count(parameters.len(), "parameter"), Count(points.len(), "point"));
        return Err(Error::new(Code::T004, message));
    }
    check_increasing(parameters)?;
    Ok(points)
}

fn intervals(parameters: &[f64]) -> Vec<f64> {
    parameters.windows(2).map(|pair| pair[1] - pair[0]).collect()
}

/// Slopes that overflowed are the fault of the scale, and must not become a curve of NaN.
fn finite<const D: usize>(tangents: Vec<[f64; D]>) -> Result<Vec<[f64; D]>> {
    match tangents.iter().position(|m| !m.iter().all(|x| x.abs() <= 1e300)) {
        None => Ok(tangents),
        Some(i) => Err(Error::new(Code::P003, format!("the slope at point {i} overflows: {:?}", tangents[i])).at(i)),
    }
}

/// The slopes of the cubic spline over the given intervals, one fewer than points; over floats or fractions.
///
/// ```
/// use lath::interpolate::{slopes, End, Ends};
///
/// let m = slopes(&[1.0, 1.0], &[[0.0], [1.0], [0.0]], &Ends::Open(End::Clamped([0.0]), End::Clamped([0.0])))?;
/// assert_eq!(m, [[0.0], [0.0], [0.0]]);
/// # Ok::<(), lath::error::Error>(())
/// ```
///
/// # Errors
/// T004 if there are not as many intervals as gaps; P001 for fewer than two points; N001 if an interval is zero or the
/// system singular.
pub fn slopes<S: Scalar, const D: usize>(h: &[S], points: &[[S; D]], ends: &Ends<D, S>) -> Result<Vec<[S; D]>> {
    let n = h.len();
    check_intervals(h, points.len(), n + 1)?;
    let chord = |k: usize| chord(&points[k], &points[k + 1], &h[k]);
    let (start, end) = match ends {
        Ends::Open(start, end) => (start, end),
        Ends::Cyclic | Ends::Anticyclic => {
            let sign = if matches!(ends, Ends::Cyclic) { S::one() } else { -S::one() };
            let mut m = slopes_cyclic(h, chord, &sign)?;
            m.push(core::array::from_fn(|c| sign.clone() * m[0][c].clone()));
            return Ok(m);
        }
    };
    let mut matrix = Banded::new(n + 1, 1, 1);
    let mut m = Vec::with_capacity(n + 1);
    // Both ends say "not a knot" of the same inner point, or of none: then lower degrees serve them.
    let shared = n <= 2 && (start, end) == (&End::NotAKnot, &End::NotAKnot);
    let inner = (n > 1).then(|| (&h[1], chord(1)));
    let (own, next, rhs) = end_row(start, &S::one(), &h[0], &chord(0), inner, shared);
    matrix.set(0, 0, own);
    matrix.set(0, 1, next);
    m.push(rhs);
    let mut before = chord(0);
    for i in 1..n {
        let (lambda, mu) = ratios(&h[i - 1], &h[i]);
        let after = chord(i);
        matrix.set(i, i - 1, lambda.clone());
        matrix.set(i, i, S::from_int(2));
        matrix.set(i, i + 1, mu.clone());
        m.push(core::array::from_fn(|c| three(&lambda, &before[c], &mu, &after[c])));
        before = after;
    }
    let inner = (n > 1).then(|| (&h[n - 2], chord(n - 2)));
    let (own, next, rhs) = end_row(end, &-S::one(), &h[n - 1], &chord(n - 1), inner, shared);
    matrix.set(n, n, own);
    matrix.set(n, n - 1, next);
    m.push(rhs);
    matrix.factor()?.solve(&mut m)?;
    Ok(m)
}

/// The slopes of the closed cubic spline: as many intervals as points, the last one back to the first point.
///
/// # Errors
/// As [`slopes`].
pub fn slopes_closed<S: Scalar, const D: usize>(h: &[S], points: &[[S; D]]) -> Result<Vec<[S; D]>> {
    check_intervals(h, points.len(), h.len())?;
    let chord = |k: usize| chord(&points[k], &points[if k + 1 < points.len() { k + 1 } else { 0 }], &h[k]);
    slopes_cyclic(h, chord, &S::one())
}

/// The cyclic system: row i joins interval i − 1 to interval i, row 0 the last to the first, with the sign that the
/// quantities of the last piece take when they pass the seam.
fn slopes_cyclic<S: Scalar, const D: usize>(h: &[S], chord: impl Fn(usize) -> [S; D], sign: &S) -> Result<Vec<[S; D]>> {
    let n = h.len();
    let mut matrix = CyclicBanded::new(n, 1, 1);
    let mut m: Vec<[S; D]> = Vec::with_capacity(n);
    let mut before: [S; D] = chord(n - 1).map(|x| sign.clone() * x);
    for i in 0..n {
        let (lambda, mu) = ratios(if i > 0 { &h[i - 1] } else { &h[n - 1] }, &h[i]);
        let after = chord(i);
        m.push(core::array::from_fn(|c| three(&lambda, &before[c], &mu, &after[c])));
        before = after;
        matrix.add(i, -1, if i == 0 { sign.clone() * lambda } else { lambda });
        matrix.add(i, 0, S::from_int(2));
        matrix.add(i, 1, if i + 1 == n { sign.clone() * mu } else { mu });
    }
    matrix.solve(&mut m)?;
    Ok(m)
}

/// The row of one end: coefficients of its own slope and of its neighbour's, and the right-hand side.
///
/// `direction` is 1 at the start and −1 at the end, where the parameter runs the other way; `h`, `chord` belong to
/// the end's own interval, `inner` to the next one, if there is one.
fn end_row<S: Scalar, const D: usize>(
    end: &End<D, S>,
    direction: &S,
    h: &S,
    chord: &[S; D],
    inner: Option<(&S, [S; D])>,
    shared: bool,
) -> (S, S, [S; D]) {
    let n = S::from_int;
    let triple = || chord.clone().map(|x| n(3) * x);
    match (end, inner) {
        (End::Clamped(slope), _) => (n(1), n(0), slope.clone()),
        (End::Natural, _) => (n(2), n(1), triple()),
        (End::Second(second), _) => {
            let half = direction.clone() * h.clone() / n(2);
            let mut rhs = triple();
            for c in 0..D {
                rhs[c] = rhs[c].clone() - half.clone() * second[c].clone();
            }
            (n(2), n(1), rhs)
        }
        // Two points: the straight line.
        (End::NotAKnot, None) if shared => (n(1), n(0), chord.clone()),
        // One interval, or both ends at one inner point: no third derivative here.
        (End::NotAKnot, inner) if shared || inner.is_none() => (n(1), n(1), chord.clone().map(|x| n(2) * x)),
        (End::NotAKnot, Some((next, slope))) => {
            // Equal third derivatives at the inner point, with its C² row subtracted.
            let (lambda, mu) = ratios(h, next);
            let own = lambda.clone() * (n(2) + mu.clone());
            let far = mu.clone() * mu;
            let rhs = core::array::from_fn(|c| own.clone() * chord[c].clone() + far.clone() * slope[c].clone());
            (lambda, n(1), rhs)
        }
        (End::NotAKnot, None) => (n(1), n(1), chord.clone().map(|x| n(2) * x)),
    }
}

/// λ = right/(left + right) and μ = left/(left + right).
fn ratios<S: Scalar>(left: &S, right: &S) -> (S, S) {
    let sum = left.clone() + right.clone();
    (right.clone() / sum.clone(), left.clone() / sum)
}

/// 3 (λ a + μ b).
fn three<S: Scalar>(lambda: &S, a: &S, mu: &S, b: &S) -> S {
    S::from_int(3) * (lambda.clone() * a.clone() + mu.clone() * b.clone())
}

/// The slope of a chord.
fn chord<S: Scalar, const D: usize>(a: &[S; D], b: &[S; D], h: &S) -> [S; D] {
    core::array::from_fn(|c| (b[c].clone() - a[c].clone()) / h.clone())
}

fn check_intervals<S: Scalar>(h: &[S], points: usize, wanted: usize) -> Result<()> {
    if points < 2 {
        return Err(Error::new(Code::P001, format!("a curve takes at least 2 points, not {points}")));
    }
    if points != wanted {
        return Err(Error::new(Code::T004, format!("{} for {}", Count(h.len(), "interval"), Count(points, "point"))));
    }
    match h.iter().position(|h| h.is_zero()) {
        Some(i) => Err(Error::new(Code::N001, format!("interval {i} is zero")).at(i)),
        None => Ok(()),
    }
}
