//! The derivative of a spline as a spline.

use crate::curve::{BSpline, Bezier};
use crate::error::Result;
use crate::num::Scalar;
use crate::refine::spline::Spline;
use crate::space::Vector;
use alloc::vec::Vec;

impl<S: Scalar, V: Vector<S>> Spline<V, S> {
    /// The derivative: Qᵢ = p (P_{i+1} − Pᵢ)/(t_{i+p+1} − t_{i+1}), of degree p − 1 over the same domain.
    ///
    /// Where the spline jumps, the derivative is that of both sides. Of degree 0 it is zero.
    ///
    /// *Error.* E ≤ 4 for each point, against p (|P_{i+1}| + |Pᵢ|)/(t_{i+p+1} − t_{i+1}).
    ///
    /// # Errors
    /// None that a valid spline can meet.
    pub fn derivative(&self) -> Result<Spline<V, S>> {
        let spline = self.canonical()?;
        let (t_, p, n) = (spline.knots().values(), spline.degree(), spline.points().len());
        if p == 0 {
            return spline.alike(spline.own_knots().to_vec(), 0, alloc::vec![V::zero(); n]);
        }
        let steps = if spline.is_closed() { n } else { n - 1 };
        let mut points = Vec::with_capacity(steps);
        // The first and last knot of an open spline are no longer needed.
        let own = spline.own_knots();
        let mut knots: Vec<Option<&S>> = if spline.is_closed() {
            own.iter().map(Some).collect()
        } else {
            own[1..own.len() - 1].iter().map(Some).collect()
        };
        let offset = if spline.is_closed() { p } else { 1 };
        for i in 0..steps {
            let length = t_[i + p + 1].clone() - t_[i + 1].clone();
            if length.is_zero() {
                // p + 1 equal knots: a jump, which the derivative leaves out with one of the knots.
                knots[i + p + 1 - offset] = None;
                continue;
            }
            let mut step = spline.point(i as isize + 1).clone();
            step.add_scaled(&-S::one(), spline.point(i as isize));
            step.scale(&(S::from_int(p as i64) / length));
            points.push(step);
        }
        spline.alike(knots.into_iter().flatten().cloned().collect(), p - 1, points)
    }
}

impl<const D: usize> BSpline<D> {
    /// The derivative for the parameter, a curve of degree p − 1 over the same domain; zero for degree 0.
    ///
    /// Where the curve jumps, the derivative is that of both sides. The derivative of a closed curve is closed.
    ///
    /// *Cost.* O(n). *Error.* Each control point to 4 u (|P_{i+1}| + |Pᵢ|) p/(t_{i+p+1} − t_{i+1}): differences of the data.
    ///
    /// *Source.* de Boor 1978, ch. X.
    ///
    /// ```
    /// use lath::curve::{BSpline, Curve};
    ///
    /// let curve = BSpline::clamped(2, [[0.0, 0.0], [2.0, 4.0], [4.0, 0.0]])?;
    /// assert_eq!(curve.derivative()?.control_points(), [[4.0, 8.0], [4.0, -8.0]]);
    /// # Ok::<(), lath::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// P003 for derivatives beyond 1e300.
    pub fn derivative(&self) -> Result<BSpline<D>> {
        BSpline::from_spline(self.to_spline().derivative()?)
    }
}

impl<const D: usize> Bezier<D> {
    /// The derivative for the parameter, of one degree less; zero for degree 0.
    ///
    /// ```
    /// use lath::curve::Bezier;
    ///
    /// assert_eq!(Bezier::new([[0.0], [2.0], [0.0]])?.derivative()?.control_points(), [[4.0], [-4.0]]);
    /// # Ok::<(), lath::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// P003 for derivatives beyond 1e300.
    pub fn derivative(&self) -> Result<Bezier<D>> {
        Bezier::from_spline(self.to_spline()?.derivative()?)
    }
}
