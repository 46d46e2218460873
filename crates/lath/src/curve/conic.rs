//! Circles, ellipses, parabolas and hyperbolas, exactly, as rational quadratics.
//!
//! A conic is the image of the unit circle, the parabola (t, t²) or the unit hyperbola under an affine map: a centre and two vectors place it in
//! the plane or in space, in any dimension. Its pieces are rational quadratics in standard form, weights 1, w, 1, whose middle
//! control point is where the end tangents meet: w = cos h for an arc of the angle 2h, cosh h for a hyperbola, 1 for a parabola.
//!
//! Arcs are cut into equal pieces of at most a quarter turn. The parameter is the angle from the start of the arc: exactly at the joints
//! and midway between them, elsewhere within a degree. Pieces join with equal derivatives, C¹ in that parameter, and bend on as the conic does.
//!
//! *Error.* The curve is the conic up to the rounding of its control points and of w, about one unit in the last place.
//!
//! *Source.* E. T. Lee, The rational Bézier representation for conics (1987); L. Piegl and W. Tiller, The NURBS Book (2nd ed. 1997), ch. 7.
//!
//! Deliberately absent: a whole circle as one piece of higher degree, and weights 1, 1, 2, which would make the circle exact in
//! fractions at the price of an uneven parameter.

use crate::curve::Nurbs;
use crate::error::{Code, Error, Number, Result};
use crate::knot::Knots;
use alloc::format;
use alloc::vec::Vec;
use core::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_2, TAU};

/// The unit circle from the right, counter-clockwise: joints, and between them the corners of its square.
const SQUARE: [[f64; 2]; 9] =
    [[1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [-1.0, 1.0], [-1.0, 0.0], [-1.0, -1.0], [0.0, -1.0], [1.0, -1.0], [1.0, 0.0]];

impl Nurbs<2> {
    /// The whole circle, counter-clockwise from the right (center + (radius, 0)), on [0, 2π] in four pieces.
    ///
    /// It ends where it starts, to the bit, with equal derivatives: C¹ at its joints and over its seam. As a curve it is open, with
    /// clamped knots, as other systems have it.
    ///
    /// ```
    /// use lath::curve::{Curve, Nurbs};
    ///
    /// let circle = Nurbs::circle([1.0, 2.0], 3.0)?;
    /// let [x, y] = circle.eval(0.7)?;
    /// assert!(((x - 1.0).hypot(y - 2.0) - 3.0).abs() < 2e-15);
    /// # Ok::<(), lath::error::Error>(())
    /// ```
    ///
    /// *Degenerate input.* A radius of 0 is a point; a negative one starts on the left.
    ///
    /// # Errors
    /// P002 and P003 for the centre and the radius.
    pub fn circle(center: [f64; 2], radius: f64) -> Result<Nurbs<2>> {
        Nurbs::ellipse(center, [radius, 0.0], [0.0, radius])
    }

    /// The arc of a circle from the angle `start` (from the right, counter-clockwise, in radians) over the angle `sweep`, clockwise
    /// where that is negative; on [0, |sweep|].
    ///
    /// ```
    /// use lath::curve::{Curve, Nurbs};
    /// use std::f64::consts::PI;
    ///
    /// let arc = Nurbs::arc([0.0, 0.0], 2.0, PI / 2.0, -PI / 3.0)?;
    /// let [x, y] = arc.eval(PI / 3.0)?;
    /// assert!((x - 3.0_f64.sqrt()).abs() < 1e-15 && (y - 1.0).abs() < 1e-15);
    /// # Ok::<(), lath::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`Nurbs::elliptic_arc`].
    pub fn arc(center: [f64; 2], radius: f64, start: f64, sweep: f64) -> Result<Nurbs<2>> {
        Nurbs::elliptic_arc(center, [radius, 0.0], [0.0, radius], start, sweep)
    }
}

impl<const D: usize> Nurbs<D> {
    /// The whole ellipse center + cos θ · a + sin θ · b, 0 ≤ θ ≤ 2π, in four pieces; a circle where a and b are perpendicular and equally
    /// long.
    ///
    /// The half axes are a and b if they are perpendicular; any other two are conjugate half diameters.
    ///
    /// *Degenerate input.* Parallel vectors make a segment, run there and back.
    ///
    /// ```
    /// use lath::curve::{Curve, Nurbs};
    ///
    /// // A circle in space, across the direction (1, 1, 1).
    /// let tilted = Nurbs::ellipse([0.0; 3], [1.0, -1.0, 0.0], [1.0, 1.0, -2.0].map(|x| x / 3.0_f64.sqrt()))?;
    /// let p = tilted.eval(1.0)?;
    /// assert!((p.map(|x| x * x).iter().sum::<f64>() - 2.0).abs() < 1e-15);
    /// # Ok::<(), lath::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// P002 and P003 for coordinates.
    pub fn ellipse(center: [f64; D], a: [f64; D], b: [f64; D]) -> Result<Nurbs<D>> {
        let points = SQUARE.iter().map(|unit| placed(&center, &a, &b, unit)).collect();
        quadratics(points, FRAC_1_SQRT_2, TAU)
    }

    /// The arc center + cos θ · a + sin θ · b for θ from `start` to `start + sweep`, in radians; on [0, |sweep|].
    ///
    /// Over a whole turn, |sweep| = 2π, it ends where it starts to the bit.
    ///
    /// ```
    /// use lath::curve::{Curve, Nurbs};
    ///
    /// let arc = Nurbs::elliptic_arc([0.0, 0.0], [3.0, 0.0], [0.0, 1.0], 0.0, 1.0)?;
    /// assert_eq!(arc.degree(), 2);
    /// let [x, y] = arc.eval(0.25)?;
    /// assert!((x * x / 9.0 + y * y - 1.0).abs() < 1e-15);
    /// # Ok::<(), lath::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// Q002 for angles that are not finite, Q003 for a sweep of 0 or beyond a whole turn; P002 and P003 for coordinates.
    pub fn elliptic_arc(center: [f64; D], a: [f64; D], b: [f64; D], start: f64, sweep: f64) -> Result<Nurbs<D>> {
        check_number("start", start)?;
        check_number("sweep", sweep)?;
        if sweep == 0.0 || sweep.abs() > TAU {
            let message = format!("the sweep is {}, not between 0 and 2π, or 0 and −2π", Number(sweep));
            return Err(Error::new(Code::Q003, message));
        }
        // What exceeds whole quarters by rounding alone gets no piece of its own.
        let pieces = libm::ceil(sweep.abs() / FRAC_PI_2 - 1e-9);
        let half = sweep / pieces / 2.0;
        let weight = libm::cos(half);
        let unit = |k: usize| {
            let angle = start + half * k as f64;
            let reach = if k % 2 == 1 { weight } else { 1.0 };
            [libm::cos(angle) / reach, libm::sin(angle) / reach]
        };
        let mut points: Vec<[f64; D]> = (0..=2 * pieces as usize).map(|k| placed(&center, &a, &b, &unit(k))).collect();
        if let (true, Some(first)) = (sweep.abs() == TAU, points.first().copied()) {
            points.pop();
            points.push(first);
        }
        quadratics(points, weight, sweep.abs())
    }

    /// The arc vertex + t · a + t² · b of a parabola for t from `from` to `to`; its parameter is t.
    ///
    /// ```
    /// use lath::curve::{Curve, Nurbs};
    ///
    /// let parabola = Nurbs::parabola([0.0, 1.0], [1.0, 0.0], [0.0, 1.0], -1.0, 3.0)?;
    /// assert_eq!(parabola.eval(2.0)?, [2.0, 5.0]);
    /// # Ok::<(), lath::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// K002, K004 and K005 for `from` and `to`; P002 and P003 for coordinates.
    pub fn parabola(vertex: [f64; D], a: [f64; D], b: [f64; D], from: f64, to: f64) -> Result<Nurbs<D>> {
        // The blossom of (t, t²): the middle point has the mean and the product of the ends.
        let points = [[from, from * from], [from / 2.0 + to / 2.0, from * to], [to, to * to]];
        piece(points.map(|unit| placed(&vertex, &a, &b, &unit)), 1.0, from, to)
    }

    /// The arc center + cosh s · a + sinh s · b of one branch of a hyperbola for s from `from` to `to`; its parameter is s at both ends and
    /// midway.
    ///
    /// The branch opens towards a; its asymptotes are a + b and a − b.
    ///
    /// ```
    /// use lath::curve::{Curve, Nurbs};
    ///
    /// let branch = Nurbs::hyperbola([0.0, 0.0], [1.0, 0.0], [0.0, 1.0], -1.0, 2.0)?;
    /// let [x, y] = branch.eval(1.25)?;
    /// assert!((x * x - y * y - 1.0).abs() < 1e-14);
    /// # Ok::<(), lath::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`Nurbs::parabola`]; R002 if the arc is so long that its weight leaves the scale.
    pub fn hyperbola(center: [f64; D], a: [f64; D], b: [f64; D], from: f64, to: f64) -> Result<Nurbs<D>> {
        let (middle, half) = (from / 2.0 + to / 2.0, to / 2.0 - from / 2.0);
        let weight = libm::cosh(half);
        let unit = |s: f64, reach: f64| [libm::cosh(s) / reach, libm::sinh(s) / reach];
        let points = [unit(from, 1.0), unit(middle, weight), unit(to, 1.0)];
        piece(points.map(|unit| placed(&center, &a, &b, &unit)), weight, from, to)
    }
}

fn check_number(name: &str, x: f64) -> Result<()> {
    if x.is_finite() { Ok(()) } else { Err(Error::new(Code::Q002, format!("the angle \"{name}\" is {x}"))) }
}

/// origin + x · a + y · b.
fn placed<const D: usize>(origin: &[f64; D], a: &[f64; D], b: &[f64; D], [x, y]: &[f64; 2]) -> [f64; D] {
    core::array::from_fn(|c| origin[c] + (x * a[c] + y * b[c]))
}

/// One rational quadratic.
fn piece<const D: usize>(points: [[f64; D]; 3], weight: f64, from: f64, to: f64) -> Result<Nurbs<D>> {
    Nurbs::over(alloc::vec![from, from, from, to, to, to], 2, points, [1.0, weight, 1.0])
}

/// Rational quadratics of equal weights over [0, length]: joints and corners by turns.
fn quadratics<const D: usize>(points: Vec<[f64; D]>, weight: f64, length: f64) -> Result<Nurbs<D>> {
    let pieces = points.len() / 2;
    let knot = |i: usize| {
        let joint = (i.saturating_sub(1) / 2).min(pieces);
        if joint == pieces { length } else { length * (joint as f64 / pieces as f64) }
    };
    let knots = Knots::new((0..points.len() + 3).map(knot).collect(), 2)?;
    let weights: Vec<f64> = (0..points.len()).map(|i| if i % 2 == 1 { weight } else { 1.0 }).collect();
    Nurbs::new(knots, points, weights)
}
