//! Tension of uniform cubic B-splines: from the B-spline to the polygon of its joints.

use crate::basis::hermite::to_bernstein;
use crate::curve::bspline::BSpline;
use crate::curve::hermite::Hermite;
use crate::curve::protocol::Curve;
use crate::curve::uniform::UniformBSpline;
use crate::error::{Code, Count, Error, Result};
use crate::knot::Knots;
use alloc::format;
use alloc::vec::Vec;

impl<const D: usize> UniformBSpline<D> {
    /// The cubic under one tension s: every joint Kᵢ stays, every tangent at a joint shrinks to (1 − s)(Pᵢ₊₂ − Pᵢ)/2.
    ///
    /// s = 0 is the B-spline itself. s = 1 is the polygon of the joints, run through with a stop at each: the segment of P₀ … P₃ has the
    /// tangent (u² − u)[(P₀ − P₃) + 3(P₁ − P₂)].
    ///
    /// *Continuity.* C¹; C² for s = 0 only. For s = 1 the tangents at the joints are zero, and what is drawn has corners.
    ///
    /// *Outside [0, 1]* the formula goes on and so does the curve, as for [`cardinal`](crate::interpolate::cardinal): below 0 it bulges, above 1 it
    /// runs backwards through its joints, in loops. For 0 ≤ s ≤ 2 every segment stays in the convex hull of its four points.
    ///
    /// *Cost.* O(n). *Error.* Joints E ≤ 12, tangents a few u of the differences.
    ///
    /// *Source.* D. Salomon, Curves and Surfaces for Computer Graphics (2006), §4.15 and exercise 4.98.
    ///
    /// ```
    /// use lath::curve::{Curve, UniformBSpline};
    ///
    /// let curve = UniformBSpline::new(3, [[0.0], [6.0], [6.0], [0.0]])?;
    /// assert_eq!(curve.with_tension(0.0)?.jet(0.0, 1)?, [[5.0], [3.0]]);
    /// assert_eq!(curve.with_tension(0.5)?.jet(0.0, 1)?, [[5.0], [1.5]]);
    /// # Ok::<(), lath::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// K006 for another degree than 3; Q002 for a tension that is not finite; P003 if a tangent overflows.
    pub fn with_tension(&self, tension: f64) -> Result<Hermite<D>> {
        self.check_tension(&[tension])?;
        let count = self.segments() + usize::from(!self.is_closed());
        let joints = (0..count).map(|i| self.joint(i)).collect::<Result<Vec<_>>>()?;
        let tangents = (0..count).map(|i| self.tense(i, tension)).collect::<Result<Vec<_>>>()?;
        let make = if self.is_closed() { Hermite::closed } else { Hermite::new };
        make(self.breaks(), joints, tangents)
    }

    /// The cubic under a tension of its own in each segment: as [`with_tension`](UniformBSpline::with_tension), but the tangents of both sides of a joint
    /// shrink differently, so that no Hermite curve can hold them. It is a B-spline with triple knots at the joints, one Bézier segment
    /// between each two.
    ///
    /// *Continuity.* Where neighbouring tensions agree C¹. Where they differ the speed jumps and the direction stays (G¹) as long as both are
    /// below 1; beside a segment of tension 1 there may be a corner.
    ///
    /// *Cost, error, outside [0, 1]* as there.
    ///
    /// ```
    /// use lath::curve::{Curve, UniformBSpline};
    /// use lath::knot::Side;
    ///
    /// let curve = UniformBSpline::new(3, [[0.0], [6.0], [6.0], [0.0], [6.0]])?.with_tensions(&[0.0, 0.5])?;
    /// let (mut left, mut right) = ([[0.0]; 2], [[0.0]; 2]);
    /// curve.jet_into(1.0, Side::Left, &mut left);
    /// curve.jet_into(1.0, Side::Right, &mut right);
    /// assert_eq!((left, right), ([[5.0], [-3.0]], [[5.0], [-1.5]]));
    /// # Ok::<(), lath::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// Q004 for another number of tensions than segments; Q002 with the index of a tension that is not finite; otherwise as there.
    pub fn with_tensions(&self, tensions: &[f64]) -> Result<BSpline<D>> {
        let segments = self.segments();
        if tensions.len() != segments {
            let (tensions, segments) = (Count(tensions.len(), "tension"), Count(segments, "segment"));
            let message = format!("{tensions} for a curve of {segments}");
            return Err(Error::new(Code::Q004, message));
        }
        self.check_tension(tensions)?;
        let mut control = Vec::with_capacity(3 * segments + 1);
        for (i, tension) in tensions.iter().enumerate() {
            let (start, end) = (self.joint(i)?, self.joint(i + 1)?);
            let (leave, arrive) = (self.tense(i, *tension)?, self.tense(i + 1, *tension)?);
            let piece = to_bernstein(&start, &leave, &end, &arrive, &1.0);
            control.extend_from_slice(&piece[..3]);
        }
        let joints = self.breaks();
        if self.is_closed() {
            // The functions of the first joint's left side are those of the last segment.
            control.rotate_right(2);
            let mut period: Vec<f64> = joints[..segments].iter().flat_map(|t| [*t; 3]).collect();
            period.push(joints[segments]);
            return BSpline::closed(&period, 3, control);
        }
        control.push(self.joint(segments)?);
        let mut knots = alloc::vec![joints[0]];
        knots.extend(joints.iter().flat_map(|t| [*t; 3]));
        knots.push(joints[segments]);
        BSpline::new(Knots::new(knots, 3)?, control)
    }

    /// The tangent at joint i under a tension.
    fn tense(&self, joint: usize, tension: f64) -> Result<[f64; D]> {
        let (points, n) = (self.control_points(), self.control_points().len());
        // The open curve's last joint is made by its last three points.
        let (before, behind) = (points[joint % n], points[(joint + 2) % n]);
        let tangent: [f64; D] = core::array::from_fn(|c| (1.0 - tension) * ((behind[c] - before[c]) / 2.0));
        if tangent.iter().all(|x| x.abs() <= 1e300) {
            return Ok(tangent);
        }
        Err(Error::new(Code::P003, format!("the tangent at joint {joint} overflows: {tangent:?}")).at(joint))
    }

    fn check_tension(&self, tensions: &[f64]) -> Result<()> {
        if self.degree() != 3 {
            return Err(Error::new(
                Code::K006,
                format!("tension belongs to degree 3, not to degree {}", self.degree()),
            ));
        }
        match tensions.iter().position(|tension| !tension.is_finite()) {
            None => Ok(()),
            Some(i) => Err(Error::new(Code::Q002, format!("tension {i} is {}", tensions[i])).at(i)),
        }
    }
}
