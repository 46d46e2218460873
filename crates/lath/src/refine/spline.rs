//! What every verb works on: knots with control points of any kind.

use crate::curve::{BSpline, Bezier, Curve, Interval};
use crate::error::Result;
use crate::knot::{Knots, check_period};
use crate::num::Scalar;
use crate::space::Vector;
use alloc::vec::Vec;

/// A spline Σ Pᵢ N_{i,p} over any scalar, with control points from any vector space: points, homogeneous points, fractions, the rows
/// of a net.
///
/// All verbs of this floor are written for it; the methods of the curve families hand their knots and points to it.
///
/// *Open:* as many points as functions. *Closed:* n points over n + 1 knots of one period, which are extended by p on both sides;
/// point i + n is point i.
///
/// ```
/// use lath::knot::Knots;
/// use lath::refine::Spline;
///
/// let spline = Spline::open(Knots::clamped(3, 2)?, vec![[0.0], [2.0], [0.0]])?;
/// let refined = spline.insert(&[0.5])?;
/// assert_eq!(refined.points(), [[0.0], [1.0], [1.0], [0.0]]);
/// # Ok::<(), lath::error::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Spline<V, S = f64> {
    knots: Knots<S>,
    points: Vec<V>,
    closed: bool,
}

impl<S: Scalar, V: Vector<S>> Spline<V, S> {
    /// The open spline of these control points.
    ///
    /// # Errors
    /// K001 if there are not as many points as functions.
    pub fn open(knots: Knots<S>, points: Vec<V>) -> Result<Spline<V, S>> {
        knots.check_points(points.len())?;
        Ok(Spline { knots, points, closed: false })
    }

    /// The closed spline of n control points over n + 1 knots of one period.
    ///
    /// # Errors
    /// K001 if there are not n + 1 knots; otherwise as [`Knots::periodic`].
    pub fn closed(period: &[S], degree: usize, points: Vec<V>) -> Result<Spline<V, S>> {
        check_period(period.len(), points.len())?;
        Ok(Spline { knots: Knots::periodic(period, degree)?, points, closed: true })
    }

    /// Another spline with the same ends, open or closed as this one; `knots` are those of one period if it is closed.
    pub(crate) fn alike(&self, knots: Vec<S>, degree: usize, points: Vec<V>) -> Result<Spline<V, S>> {
        if self.closed {
            Spline::closed(&knots, degree, points)
        } else {
            Spline::open(Knots::new(knots, degree)?, points)
        }
    }

    /// The knots; of a closed spline, one period extended by p knots on both sides.
    pub fn knots(&self) -> &Knots<S> {
        &self.knots
    }

    /// The control points, each once.
    pub fn points(&self) -> &[V] {
        &self.points
    }

    /// The control points, given away.
    pub fn into_points(self) -> Vec<V> {
        self.points
    }

    /// Whether the spline returns into itself.
    pub fn is_closed(&self) -> bool {
        self.closed
    }

    /// The degree p.
    pub fn degree(&self) -> usize {
        self.knots.degree()
    }

    /// The knots that define the spline: all of an open one, the n + 1 of one period of a closed one.
    pub fn own_knots(&self) -> &[S] {
        let p = self.knots.degree();
        let all = self.knots.values();
        if self.closed { &all[p..=p + self.points.len()] } else { all }
    }

    /// Control point i; of a closed spline modulo their number.
    pub(crate) fn point(&self, i: isize) -> &V {
        // An open spline is only asked for points it has.
        &self.points[i.rem_euclid(self.points.len() as isize) as usize]
    }

    /// The open spline over the extended knots of a closed one: the same curve, unclamped, its first p points repeated at the end.
    ///
    /// An open spline comes back as it is.
    ///
    /// *Error.* None: no number changes.
    pub fn unroll(&self) -> Spline<V, S> {
        let count = self.knots.functions() as isize;
        let points = (0..count).map(|i| self.point(i).clone()).collect();
        Spline { knots: self.knots.clone(), points, closed: false }
    }
}

impl<const D: usize> BSpline<D> {
    /// Knots and points, to be worked on.
    pub(crate) fn to_spline(&self) -> Spline<[f64; D]> {
        let (knots, points) = (self.knots().clone(), self.control_points().to_vec());
        Spline { knots, points, closed: self.is_closed() }
    }

    /// The curve of what came of it.
    pub(crate) fn from_spline(spline: Spline<[f64; D]>) -> Result<BSpline<D>> {
        if spline.closed {
            let degree = spline.degree();
            return BSpline::closed(spline.own_knots(), degree, &spline.points);
        }
        BSpline::new(spline.knots, spline.points)
    }
}

impl<const D: usize> Bezier<D> {
    /// The spline over both ends of the domain, each degree + 1 times.
    pub(crate) fn to_spline(&self) -> Result<Spline<[f64; D]>> {
        let (points, Interval { start, end }) = (self.control_points().to_vec(), self.domain());
        let mut knots = alloc::vec![start; points.len()];
        knots.extend(alloc::vec![end; points.len()]);
        Spline::open(Knots::new(knots, points.len() - 1)?, points)
    }

    /// The curve of a spline of one span, clamped at both ends.
    pub(crate) fn from_spline(spline: Spline<[f64; D]>) -> Result<Bezier<D>> {
        let (start, end) = spline.knots.domain();
        Bezier::on(spline.points, Interval { start, end })
    }
}
