//! How fast the direction of a curve turns.

use crate::curve::Curve;
use crate::knot::Side;
use crate::space::norm;

/// The curvature κ = |P′ × P″| / |P′|³ ≥ 0 at t, in any dimension; 0 on a straight line, 1/r on a circle of radius r.
///
/// Computed as the length of the part of P″ across the tangent, divided by |P′|².
///
/// *Degenerate input.* `None` where the tangent vanishes or the result is not finite. In one dimension it is 0.
/// Outside the domain the end pieces continue.
///
/// ```
/// use lath::{curve::Bezier, knot::Side, query::curvature};
///
/// let parabola = Bezier::new([[-1.0, 1.0], [0.0, -1.0], [1.0, 1.0]])?; // y = x²
/// assert_eq!(curvature(&parabola, 0.5, Side::Right), Some(2.0));
/// # Ok::<(), lath::error::Error>(())
/// ```
pub fn curvature<const D: usize>(curve: &dyn Curve<D>, t: f64, side: Side) -> Option<f64> {
    let (direction, speed, second) = turning(curve, t, side)?;
    let along = (0..D).fold(0.0, |sum, c| sum + direction[c] * second[c]);
    let across: [f64; D] = core::array::from_fn(|c| second[c] - along * direction[c]);
    Some(norm(&across) / speed / speed).filter(|k| k.is_finite())
}

/// The signed curvature of a plane curve at t: positive where it turns left (counter-clockwise, y up).
///
/// *Degenerate input.* `None` where the tangent vanishes or the result is not finite.
///
/// ```
/// use lath::{curve::Bezier, knot::Side, query::signed_curvature};
///
/// let arch = Bezier::new([[-1.0, -1.0], [0.0, 1.0], [1.0, -1.0]])?; // y = −x²
/// assert_eq!(signed_curvature(&arch, 0.5, Side::Right), Some(-2.0));
/// # Ok::<(), lath::error::Error>(())
/// ```
pub fn signed_curvature(curve: &dyn Curve<2>, t: f64, side: Side) -> Option<f64> {
    let ([x, y], speed, second) = turning(curve, t, side)?;
    Some((x * second[1] - y * second[0]) / speed / speed).filter(|k| k.is_finite())
}

/// Unit tangent, speed and second derivative; none where the speed is zero.
fn turning<const D: usize>(curve: &dyn Curve<D>, t: f64, side: Side) -> Option<([f64; D], f64, [f64; D])> {
    let mut jet = [[0.0; D]; 3];
    curve.jet_into(t, side, &mut jet);
    let speed = norm(&jet[1]);
    (speed > 0.0).then(|| (jet[1].map(|x| x / speed), speed, jet[2]))
}
