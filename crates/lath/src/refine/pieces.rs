//! To Bézier pieces and back.

use crate::curve::{BSpline, Bezier, Curve, Interval};
use crate::error::{Code, Error, Result};
use crate::knot::Knots;
use crate::num::Scalar;
use crate::refine::spline::Spline;
use crate::space::Vector;
use alloc::format;
use alloc::vec::Vec;

/// A polynomial over an interval by its Bernstein points.
#[derive(Clone, Debug, PartialEq)]
pub struct Piece<V, S = f64> {
    /// Where it starts.
    pub start: S,
    /// Where it ends.
    pub end: S,
    /// Its control points, one more than its degree.
    pub points: Vec<V>,
}

impl<S: Scalar, V: Vector<S>> Spline<V, S> {
    /// The spans of the domain that are not empty, in order, each by its Bernstein points; where the spline does not jump, neighbours
    /// share theirs bit for bit.
    ///
    /// *Cost.* O(p³) blends a piece over simple knots. *Error.* E ≤ 5p, measured below 8 to degree 5: each point at once from the given ones.
    ///
    /// # Errors
    /// None that a valid spline can meet.
    pub fn pieces(&self) -> Result<Vec<Piece<V, S>>> {
        let (p, breaks) = (self.degree(), self.knots().breaks());
        let spline = self.unroll().up_to(&breaks.iter().collect::<Vec<_>>())?;
        let u = spline.knots().values();
        let piece = |pair: &[S]| {
            // The point over the last p copies of the piece's start is its first.
            let first = u.partition_point(|knot| *knot <= pair[0]) - p - 1;
            let points = spline.points()[first..first + p + 1].to_vec();
            Piece { start: pair[0].clone(), end: pair[1].clone(), points }
        };
        Ok(breaks.windows(2).map(piece).collect())
    }
}

impl<S: Scalar, V: Vector<S> + PartialEq> Spline<V, S> {
    /// The open spline of pieces one after another, each starting at the parameter where the one before it ends; all are elevated to
    /// the greatest degree p. A joint is a knot of multiplicity p where the points are equal, and p + 1 where the curve jumps.
    ///
    /// *Error.* None for pieces of one degree: their points are the spline's.
    ///
    /// # Errors
    /// P001 for no pieces, or with the index of a piece without points; T003 with the index of a piece that starts elsewhere; otherwise
    /// as [`Knots::new`].
    pub fn from_pieces(pieces: &[Piece<V, S>]) -> Result<Spline<V, S>> {
        let degree = pieces.iter().map(|piece| piece.points.len()).max().unwrap_or(0);
        let Some(p) = degree.checked_sub(1) else {
            return Err(Error::new(Code::P001, "0 pieces; a curve takes at least 1"));
        };
        let (mut knots, mut points): (Vec<S>, Vec<V>) = (Vec::new(), Vec::new());
        for (i, piece) in pieces.iter().enumerate() {
            if piece.points.is_empty() {
                return Err(Error::new(Code::P001, format!("piece {i} has no points")).at(i));
            }
            let elevated = piece.to_spline()?.elevate(p + 1 - piece.points.len())?;
            match knots.last() {
                None => knots.extend(alloc::vec![piece.start.clone(); p + 1]),
                Some(end) if *end != piece.start => {
                    let message =
                        format!("piece {i} starts at {:?}, but the one before it ends at {end:?}", piece.start);
                    return Err(Error::new(Code::T003, message).at(i));
                }
                // The knots of the joint are there already, p + 1 of them.
                Some(_) if p > 0 && points.last() == elevated.points().first() => {
                    knots.pop();
                    points.pop();
                }
                Some(_) => {}
            }
            knots.extend(alloc::vec![piece.end.clone(); p + 1]);
            points.extend(elevated.into_points());
        }
        Spline::open(Knots::new(knots, p)?, points)
    }
}

impl<S: Scalar, V: Vector<S>> Piece<V, S> {
    /// The spline of this piece alone.
    pub(crate) fn to_spline(&self) -> Result<Spline<V, S>> {
        let mut knots = alloc::vec![self.start.clone(); self.points.len()];
        knots.extend(alloc::vec![self.end.clone(); self.points.len()]);
        Spline::open(Knots::new(knots, self.points.len().saturating_sub(1))?, self.points.clone())
    }
}

/// The pieces of any curve that is piecewise polynomial.
///
/// # Errors
/// Q006 for a curve that is not, or is rational.
pub(crate) fn of_curve<const D: usize>(curve: &dyn Curve<D>) -> Result<Vec<Piece<[f64; D]>>> {
    let mut pieces = Vec::new();
    let exact = curve.bezier_pieces(&mut |piece| {
        pieces.push(Piece { start: piece.start, end: piece.end, points: piece.points.to_vec() });
    });
    if exact {
        return Ok(pieces);
    }
    let why = if curve.is_rational() { "is rational" } else { "does not consist of polynomials" };
    Err(Error::new(Code::Q006, format!("the {} {why}", curve.kind())))
}

impl<const D: usize> BSpline<D> {
    /// The Bézier curves that this curve consists of, one a span, in order, each on its own part of the domain.
    ///
    /// *Cost.* O(p³) a piece over simple knots. *Error.* E ≤ 5p, measured below 8 to degree 5: convex combinations. Neighbours share their point
    /// bit for bit unless the curve jumps.
    ///
    /// *Source.* Boehm 1980.
    ///
    /// ```
    /// use lath::curve::BSpline;
    ///
    /// let pieces = BSpline::clamped(2, [[0.0], [2.0], [4.0], [0.0]])?.to_beziers()?;
    /// assert_eq!(pieces[0].control_points(), [[0.0], [2.0], [3.0]]);
    /// assert_eq!(pieces[1].control_points(), [[3.0], [4.0], [0.0]]);
    /// # Ok::<(), lath::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// None that a valid curve can meet.
    pub fn to_beziers(&self) -> Result<Vec<Bezier<D>>> {
        let pieces = self.to_spline().pieces()?;
        let bezier = |piece: Piece<_>| Bezier::on(piece.points, Interval { start: piece.start, end: piece.end });
        pieces.into_iter().map(bezier).collect()
    }

    /// The curve of Bézier curves one after another, each starting at the parameter where the one before it ends, and elevated to
    /// the greatest degree. Their control points are the curve's, bit for bit, where the degree is the same; a joint is a knot
    /// of multiplicity p, and p + 1 where the curve jumps. [`BSpline::remove_knots`] finds out what smoothness there is.
    ///
    /// ```
    /// use lath::curve::{BSpline, Bezier, Interval};
    ///
    /// let first = Bezier::on([[0.0], [2.0], [3.0]], Interval { start: 0.0, end: 1.0 })?;
    /// let second = Bezier::on([[3.0], [4.0], [0.0]], Interval { start: 1.0, end: 2.0 })?;
    /// let curve = BSpline::from_beziers(&[first, second])?;
    /// assert_eq!(curve.knots().values(), [0.0, 0.0, 0.0, 1.0, 1.0, 2.0, 2.0, 2.0]);
    /// assert_eq!(curve.remove_knots(1e-12)?.0.control_points(), [[0.0], [2.0], [4.0], [0.0]]);
    /// # Ok::<(), lath::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// P001 for no curves; T003 with the index of one that starts elsewhere.
    pub fn from_beziers(curves: &[Bezier<D>]) -> Result<BSpline<D>> {
        let piece = |curve: &Bezier<D>| {
            let Interval { start, end } = curve.domain();
            Piece { start, end, points: curve.control_points().to_vec() }
        };
        BSpline::from_spline(Spline::from_pieces(&curves.iter().map(piece).collect::<Vec<_>>())?)
    }
}
