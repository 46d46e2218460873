//! The verbs on rational curves.
//!
//! A rational curve is a polynomial one of homogeneous points, so every verb that works on a vector space works on it. Weights that are not
//! negative go through as [`Weighted`] points: every combination is convex in the Cartesian points too, products of points and
//! weights are never formed, and untouched points keep their bits. Weights of both signs take the [`Homogeneous`] form.
//!
//! What needs a distance (removal, reduction, joining, closing) measures homogeneous moves and says what they come to: two curves X = A/w and
//! Y = B/v over the same knots differ by X − Y = ((A − B) − X (w − v))/v; with the centre c and the radius r of a ball around X that
//! is at most (‖ΔA − cΔw‖ + r|Δw|)/min v, the greatest such value of a control point (after Tiller 1992).

use crate::curve::{BSpline, Bezier, Curve, Interval, Nurbs, RationalBezier};
use crate::error::{Code, Error, Limits, Result};
use crate::num::Bound;
use crate::refine::compatible::make_compatible;
use crate::refine::join::Joint;
use crate::refine::measure::{Measure, UNIT, check_tolerance};
use crate::refine::reduce::{check_fall, check_reached};
use crate::refine::seam::Purse;
use crate::refine::spline::Spline;
use crate::space::{Homogeneous, Vector, Weighted, distance, norm};
use alloc::format;
use alloc::vec::Vec;

/// Carries out a verb in the form that suits the weights, and makes a curve of what comes of it.
macro_rules! either_form {
    ($curve:expr, $spline:ident => $verb:expr) => {
        if has_no_negative($curve) {
            let $spline = weighted($curve)?;
            from_weighted($verb)
        } else {
            let $spline = homogeneous($curve)?;
            from_homogeneous($verb)
        }
    };
}

fn has_no_negative<const D: usize>(curve: &Nurbs<D>) -> bool {
    curve.weights().iter().all(|weight| *weight >= 0.0)
}

fn spline_of<const D: usize, V: Vector<f64>>(curve: &Nurbs<D>, points: Vec<V>) -> Result<Spline<V>> {
    match curve.period() {
        Some(period) => Spline::closed(period, curve.degree(), points),
        None => Spline::open(curve.knots().clone(), points),
    }
}

fn weighted<const D: usize>(curve: &Nurbs<D>) -> Result<Spline<Weighted<D>>> {
    let pairs = curve.control_points().iter().zip(curve.weights());
    spline_of(curve, pairs.map(|(point, weight)| Weighted { point: *point, weight: *weight }).collect())
}

fn homogeneous<const D: usize>(curve: &Nurbs<D>) -> Result<Spline<Homogeneous<D>>> {
    spline_of(curve, curve.homogeneous())
}

fn from_weighted<const D: usize>(spline: Spline<Weighted<D>>) -> Result<Nurbs<D>> {
    let points = spline.points().iter().map(|weighted| weighted.point);
    let weights = spline.points().iter().map(|weighted| weighted.weight);
    if spline.is_closed() {
        return Nurbs::closed(spline.own_knots(), spline.degree(), points, weights);
    }
    Nurbs::new(spline.knots().clone(), points, weights)
}

fn from_homogeneous<const D: usize>(spline: Spline<Homogeneous<D>>) -> Result<Nurbs<D>> {
    if spline.is_closed() {
        return Nurbs::closed_from_homogeneous(spline.own_knots(), spline.degree(), spline.points());
    }
    Nurbs::from_homogeneous(spline.knots().clone(), spline.points())
}

/// Homogeneous points with positive weights: how far the curve moves; see the top of this file.
struct Ball<const D: usize> {
    centre: [f64; D],
    /// A bound for the distance of the curve from the centre.
    radius: f64,
    /// No weight of the changed curve is below this.
    least: f64,
    /// The greatest w‖P‖ and w.
    sizes: (f64, f64),
}

impl<const D: usize> Ball<D> {
    /// The ball around a curve that is within `reach` of these control points' own.
    fn around(points: &[Homogeneous<D>], reach: f64, least: f64) -> Ball<D> {
        let cartesian: Vec<[f64; D]> = points.iter().filter_map(Homogeneous::cartesian).collect();
        let larger = |most: f64, x: f64| if x > most { x } else { most };
        let side = |c: usize| {
            let (lo, hi) = cartesian.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(lo, hi), p| {
                (if p[c] < lo { p[c] } else { lo }, if p[c] > hi { p[c] } else { hi })
            });
            0.5 * lo + 0.5 * hi
        };
        let centre: [f64; D] = core::array::from_fn(side);
        let radius = cartesian.iter().map(|point| distance(&centre, point)).fold(0.0, larger) + reach;
        let sizes = (
            points.iter().map(|p| norm(&p.point)).fold(0.0, larger),
            points.iter().map(|p| p.weight).fold(0.0, larger),
        );
        // The last few units of the radius itself.
        Ball { centre, radius: radius * (1.0 + 16.0 * UNIT), least, sizes }
    }
}

impl<const D: usize> Measure<Homogeneous<D>> for Ball<D> {
    fn size(&self, moved: &Homogeneous<D>) -> f64 {
        let off: [f64; D] = core::array::from_fn(|c| moved.point[c] - self.centre[c] * moved.weight);
        (norm(&off) + self.radius * moved.weight.abs()) / self.least
    }

    fn slack(&self, degree: usize) -> f64 {
        let unit = 16.0 * (degree + 1) as f64 * UNIT;
        unit * (self.sizes.0 + (norm(&self.centre) + self.radius) * self.sizes.1) / self.least
    }

    fn near(&self, points: &[Homogeneous<D>], replaced: &[Homogeneous<D>]) -> Option<Ball<D>> {
        let (before, after) = (least(points).ok()?, least(replaced).ok()?);
        Some(Ball::around(points, 0.0, if after < before { after } else { before }))
    }
}

/// The least weight, which must be positive (R006).
fn least<const D: usize>(points: &[Homogeneous<D>]) -> Result<f64> {
    let mut least = f64::INFINITY;
    for (i, point) in points.iter().enumerate() {
        if point.weight <= 0.0 {
            return Err(Error::new(Code::R006, format!("weight {i} is {}", point.weight)).at(i));
        }
        least = if point.weight < least { point.weight } else { least };
    }
    Ok(least)
}

/// How much of the least weight must be left where ends are brought together.
const KEPT: f64 = 15.0 / 16.0;

/// Refuses a curve whose weights fell below what its bound was reckoned with (Q005).
fn check_kept<const D: usize>(points: &[Homogeneous<D>], ball: &Ball<D>) -> Result<()> {
    let least = least(points)?;
    if least >= ball.least {
        return Ok(());
    }
    Err(Error::new(Code::Q005, format!("the least weight would fall to {least}, below {KEPT} of what it was")))
}

impl<const D: usize> Nurbs<D> {
    /// The same curve with these knots added; see [`BSpline::insert_knots`].
    ///
    /// ```
    /// use lath::curve::{Curve, Nurbs};
    /// use lath::knot::Knots;
    ///
    /// let quarter = Nurbs::new(Knots::clamped(3, 2)?, [[1.0, 0.0], [1.0, 1.0], [0.0, 1.0]], [1.0, 1.0, 2.0])?;
    /// let refined = quarter.insert_knots(&[0.5])?;
    /// assert_eq!(refined.weights(), [1.0, 1.0, 1.5, 2.0]);
    /// assert_eq!(refined.control_points()[3], [0.0, 1.0]);
    /// # Ok::<(), lath::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// As there. As from every verb here, R004 for negative weights whose denominator can no longer be proven free of zeros, and R005
    /// where a new control point would lie infinitely far away, which takes weights of both signs.
    pub fn insert_knots(&self, at: &[f64]) -> Result<Nurbs<D>> {
        either_form!(self, spline => spline.insert(at)?)
    }

    /// The same curve with the middle of every span inserted, `levels` times; see [`BSpline::refine_uniformly`].
    ///
    /// # Errors
    /// As there.
    pub fn refine_uniformly(&self, levels: usize, limits: &Limits<'_>) -> Result<Nurbs<D>> {
        either_form!(self, spline => spline.insert_middles(levels, limits)?)
    }

    /// The same curve with its degree raised by `by`; see [`BSpline::elevate`].
    ///
    /// # Errors
    /// As there.
    pub fn elevate(&self, by: usize) -> Result<Nurbs<D>> {
        either_form!(self, spline => spline.elevate(by)?)
    }

    /// The parts below and above t; see [`BSpline::split`].
    ///
    /// # Errors
    /// As there.
    pub fn split(&self, t: f64) -> Result<(Nurbs<D>, Nurbs<D>)> {
        let left = either_form!(self, spline => spline.split(&t)?.0)?;
        let right = either_form!(self, spline => spline.split(&t)?.1)?;
        Ok((left, right))
    }

    /// The part on an interval of the domain; see [`BSpline::trim`].
    ///
    /// # Errors
    /// As there.
    pub fn trim(&self, part: Interval) -> Result<Nurbs<D>> {
        either_form!(self, spline => spline.trim(&part.start, &part.end)?)
    }

    /// The same curve open and clamped; see [`BSpline::clamp`].
    ///
    /// # Errors
    /// None that a valid curve can meet.
    pub fn clamp(&self) -> Result<Nurbs<D>> {
        either_form!(self, spline => spline.clamp()?)
    }

    /// The same points over another domain; see [`BSpline::reparametrise`].
    ///
    /// # Errors
    /// As there.
    pub fn reparametrise(&self, domain: Interval) -> Result<Nurbs<D>> {
        either_form!(self, spline => spline.reparametrise(&domain.start, &domain.end)?)
    }

    /// The same curve from its end to its start; see [`BSpline::reverse`].
    ///
    /// # Errors
    /// As there.
    pub fn reverse(&self) -> Result<Nurbs<D>> {
        either_form!(self, spline => spline.reverse()?)
    }

    /// The same closed curve with its seam at t; see [`BSpline::move_seam`].
    ///
    /// # Errors
    /// As there.
    pub fn move_seam(&self, t: f64) -> Result<Nurbs<D>> {
        either_form!(self, spline => spline.move_seam(&t)?)
    }

    /// The same curves over one knot vector; see [`BSpline::make_compatible`].
    ///
    /// # Errors
    /// As there.
    pub fn make_compatible(curves: &[Nurbs<D>]) -> Result<Vec<Nurbs<D>>> {
        if curves.iter().all(has_no_negative) {
            let splines: Vec<_> = curves.iter().map(weighted).collect::<Result<_>>()?;
            return make_compatible(&splines)?.into_iter().map(from_weighted).collect();
        }
        let splines: Vec<_> = curves.iter().map(homogeneous).collect::<Result<_>>()?;
        make_compatible(&splines)?.into_iter().map(from_homogeneous).collect()
    }

    /// The rational Bézier curves that this curve consists of, one a span; see [`BSpline::to_beziers`].
    ///
    /// ```
    /// use lath::curve::Nurbs;
    /// use lath::knot::Knots;
    ///
    /// let curve = Nurbs::new(Knots::clamped(3, 1)?, [[0.0], [2.0], [3.0]], [1.0, 2.0, 1.0])?;
    /// assert_eq!(curve.to_beziers()?[1].weights(), [2.0, 1.0]);
    /// # Ok::<(), lath::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// None that a valid curve can meet.
    pub fn to_beziers(&self) -> Result<Vec<RationalBezier<D>>> {
        if has_no_negative(self) {
            let pieces = weighted(self)?.pieces()?.into_iter();
            let bezier = |piece: crate::refine::Piece<Weighted<D>>| {
                let domain = Interval { start: piece.start, end: piece.end };
                let weights: Vec<f64> = piece.points.iter().map(|point| point.weight).collect();
                RationalBezier::on(piece.points.iter().map(|point| point.point), weights, domain)
            };
            return pieces.map(bezier).collect();
        }
        let pieces = homogeneous(self)?.pieces()?.into_iter();
        pieces
            .map(|piece| {
                RationalBezier::from_homogeneous(&piece.points, Interval { start: piece.start, end: piece.end })
            })
            .collect()
    }

    /// The curve without as many knots as the tolerance allows, and the distance that was reached; see
    /// [`BSpline::remove_knots`].
    ///
    /// *Error.* The bound is proven: moves of homogeneous points, measured as distances of the stretch of the curve that they act on.
    ///
    /// # Errors
    /// Q001 unless the tolerance is a positive finite number; R006 with the index of a weight that is not positive.
    pub fn remove_knots(&self, tolerance: f64) -> Result<(Nurbs<D>, Bound)> {
        check_tolerance(tolerance)?;
        let spline = homogeneous(self)?;
        let ball = Ball::around(spline.points(), 0.0, least(spline.points())?);
        let (thinned, reached) = spline.thin(tolerance - self.divided(&ball), &ball)?;
        if thinned.points().len() == spline.points().len() {
            return Ok((self.clone(), Bound::Proven(0.0)));
        }
        Ok((from_homogeneous(thinned)?, Bound::Proven(reached + self.divided(&ball))))
    }

    /// What the division by the weights adds to a distance.
    fn divided(&self, ball: &Ball<D>) -> f64 {
        4.0 * UNIT * (norm(&ball.centre) + ball.radius)
    }

    /// A curve with its degree lowered by `by` near this one, and the distance that was reached; see [`BSpline::reduce`].
    ///
    /// The nearest in homogeneous coordinates; the bound is for the curve itself.
    ///
    /// # Errors
    /// As there; R006 with the index of a weight that is not positive, before or after.
    pub fn reduce(&self, by: usize, tolerance: Option<f64>) -> Result<(Nurbs<D>, Bound)> {
        tolerance.map_or(Ok(()), check_tolerance)?;
        check_fall(self.degree(), by)?;
        let (mut spline, mut reached) = (homogeneous(self)?, 0.0);
        for _ in 0..by {
            least(spline.points())?;
            let (lower, left) = spline.reduce()?;
            let ball = Ball::around(spline.points(), 0.0, least(lower.points())?);
            let off = left.iter().map(|rest| ball.size(rest)).fold(0.0, |most: f64, x| if x > most { x } else { most });
            reached = reached + off + ball.slack(spline.degree()) + self.divided(&ball);
            spline = lower;
        }
        Ok((from_homogeneous(spline)?, check_reached(reached, tolerance)?))
    }

    /// This open curve followed by another one; see [`BSpline::join`]. The weights of the other are scaled together, so that both have
    /// the same weight at the joint.
    ///
    /// # Errors
    /// As there; R006 with the index of a weight that is not positive.
    pub fn join(&self, other: &Nurbs<D>, tolerance: f64) -> Result<(Nurbs<D>, Joint)> {
        check_tolerance(tolerance)?;
        let (a, mut b) = (homogeneous(self)?, homogeneous(other)?);
        let (t, first) = (a.knots().domain().1, b.knots().domain().0);
        if !a.is_closed() && !b.is_closed() {
            let end = a.clamp_ends(None, Some(&t))?.into_points().pop();
            let start = b.clamp_ends(Some(&first), None)?.into_points().into_iter().next();
            if let (Some(end), Some(start)) = (end, start) {
                let factor = end.weight / start.weight;
                let scale = |point: &Homogeneous<D>| {
                    let mut point = *point;
                    point.scale(&factor);
                    point
                };
                let points = b.points().iter().map(scale).collect();
                b = Spline::open(b.knots().clone(), points)?;
            }
        }
        let all = [a.points(), b.points()].concat();
        let ball = Ball::around(&all, tolerance, KEPT * least(&all)?);
        let mut purse = Purse {
            tolerance: tolerance - self.divided(&ball),
            spent: 0.0,
            met: false,
            measure: &ball,
            degree: self.degree().max(other.degree()),
        };
        let joined = a.join(&b, &mut |moved| purse.pays(moved))?;
        check_kept(joined.points(), &ball)?;
        let bound = Bound::Proven(purse.spent + self.divided(&ball));
        let multiplicity = joined.multiplicity(&t);
        Ok((from_homogeneous(joined)?, Joint { t, multiplicity, bound }))
    }

    /// The closed curve of an open one whose ends meet within the tolerance, with their weights; see [`BSpline::close`].
    ///
    /// # Errors
    /// As there; R006 with the index of a weight that is not positive.
    pub fn close(&self, tolerance: f64) -> Result<(Nurbs<D>, Bound)> {
        check_tolerance(tolerance)?;
        let spline = homogeneous(self)?;
        let ball = Ball::around(spline.points(), tolerance, KEPT * least(spline.points())?);
        let mut purse = Purse {
            tolerance: tolerance - self.divided(&ball),
            spent: 0.0,
            met: false,
            measure: &ball,
            degree: self.degree(),
        };
        let closed = spline.close(&mut |moved| purse.pays(moved))?;
        check_kept(closed.points(), &ball)?;
        let bound = Bound::Proven(purse.spent + self.divided(&ball));
        Ok((from_homogeneous(closed)?, bound))
    }
}

impl<const D: usize> RationalBezier<D> {
    /// The same curve over the ends of its domain as knots.
    ///
    /// *Error.* None.
    ///
    /// # Errors
    /// None that a valid curve can meet.
    pub fn to_nurbs(&self) -> Result<Nurbs<D>> {
        let spline = self.unweighted().to_spline()?;
        Nurbs::new(spline.knots().clone(), self.control_points(), self.weights().iter().copied())
    }

    /// The curve of one span.
    fn from_nurbs(curve: &Nurbs<D>) -> Result<RationalBezier<D>> {
        RationalBezier::on(curve.control_points(), curve.weights().iter().copied(), curve.domain())
    }

    /// The same curve with its degree raised by `by`; see [`Bezier::elevate`].
    ///
    /// ```
    /// use lath::curve::RationalBezier;
    ///
    /// let quarter = RationalBezier::new([[1.0, 0.0], [1.0, 1.0], [0.0, 1.0]], [1.0, 1.0, 2.0])?;
    /// assert_eq!(quarter.elevate(1)?.control_points()[1], [1.0, 2.0 / 3.0]);
    /// # Ok::<(), lath::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// As there.
    pub fn elevate(&self, by: usize) -> Result<RationalBezier<D>> {
        RationalBezier::from_nurbs(&self.to_nurbs()?.elevate(by)?)
    }

    /// A curve of lower degree near this one, and the distance that was reached; see [`Nurbs::reduce`].
    ///
    /// # Errors
    /// As there.
    pub fn reduce(&self, by: usize, tolerance: Option<f64>) -> Result<(RationalBezier<D>, Bound)> {
        let (curve, bound) = self.to_nurbs()?.reduce(by, tolerance)?;
        Ok((RationalBezier::from_nurbs(&curve)?, bound))
    }

    /// The parts below and above t; see [`Bezier::split`].
    ///
    /// # Errors
    /// As there.
    pub fn split(&self, t: f64) -> Result<(RationalBezier<D>, RationalBezier<D>)> {
        let (left, right) = self.to_nurbs()?.split(t)?;
        Ok((RationalBezier::from_nurbs(&left)?, RationalBezier::from_nurbs(&right)?))
    }

    /// The part on an interval of the domain; see [`Bezier::trim`].
    ///
    /// # Errors
    /// As there.
    pub fn trim(&self, part: Interval) -> Result<RationalBezier<D>> {
        RationalBezier::from_nurbs(&self.to_nurbs()?.trim(part)?)
    }

    /// The same points over another domain; see [`Bezier::reparametrise`].
    ///
    /// # Errors
    /// As there.
    pub fn reparametrise(&self, domain: Interval) -> Result<RationalBezier<D>> {
        RationalBezier::on(self.control_points(), self.weights().iter().copied(), domain)
    }

    /// The same curve from its end to its start; see [`Bezier::reverse`].
    ///
    /// # Errors
    /// None that a valid curve can meet.
    pub fn reverse(&self) -> Result<RationalBezier<D>> {
        let weights: Vec<f64> = self.weights().iter().rev().copied().collect();
        RationalBezier::on(self.control_points().iter().rev(), weights, self.domain())
    }
}

impl<const D: usize> BSpline<D> {
    /// The rational curve with weights of 1: the same curve.
    ///
    /// # Errors
    /// None that a valid curve can meet.
    pub fn to_nurbs(&self) -> Result<Nurbs<D>> {
        self.clone().weighted(alloc::vec![1.0; self.control_points().len()])
    }
}

impl<const D: usize> Bezier<D> {
    /// The same curve over the ends of its domain as knots.
    ///
    /// *Error.* None.
    ///
    /// # Errors
    /// None that a valid curve can meet.
    pub fn to_bspline(&self) -> Result<BSpline<D>> {
        BSpline::from_spline(self.to_spline()?)
    }
}
