//! Antiderivatives and integrals: ∫ N_{i,p} = (t_{i+p+1} − tᵢ)/(p + 1).
//!
//! *Source.* P. W. Gaffney, The calculation of indefinite integrals of B-splines (1976); de Boor 1978, ch. X.

use crate::curve::{BSpline, Bezier};
use crate::error::{Code, Error, Result};
use crate::num::Scalar;
use crate::refine::spline::Spline;
use crate::space::Vector;
use alloc::format;
use alloc::vec::Vec;

/// A sum whose rounding does not grow with the number of terms: what each addition loses is carried along (W. Kahan 1965).
struct Sum<V> {
    sum: V,
    lost: V,
}

impl<V> Sum<V> {
    fn new<S: Scalar>() -> Sum<V>
    where
        V: Vector<S>,
    {
        Sum { sum: V::zero(), lost: V::zero() }
    }

    fn add<S: Scalar>(&mut self, factor: &S, term: &V)
    where
        V: Vector<S>,
    {
        let mut term = term.clone();
        term.scale(factor);
        term.add_scaled(&-S::one(), &self.lost);
        let mut next = self.sum.clone();
        next.add_scaled(&S::one(), &term);
        // (next − sum) − term: what the addition lost.
        let mut lost = next.clone();
        lost.add_scaled(&-S::one(), &self.sum);
        lost.add_scaled(&-S::one(), &term);
        (self.sum, self.lost) = (next, lost);
    }
}

impl<S: Scalar, V: Vector<S>> Spline<V, S> {
    /// The antiderivative that is zero at the start of the domain: of degree p + 1, open, and clamped.
    ///
    /// # Errors
    /// K006 for a degree above 1000.
    pub fn antiderivative(&self) -> Result<Spline<V, S>> {
        let spline = self.clamp()?;
        let (t_, p) = (spline.knots().values(), spline.degree());
        let mut points = Vec::with_capacity(spline.points().len() + 1);
        let mut sum = Sum::new();
        points.push(V::zero());
        for (i, point) in spline.points().iter().enumerate() {
            sum.add(&share(t_, i, p), point);
            points.push(sum.sum.clone());
        }
        let mut knots = Vec::with_capacity(t_.len() + 2);
        knots.extend(t_.first().cloned());
        knots.extend_from_slice(t_);
        knots.extend(t_.last().cloned());
        spline.alike(knots, p + 1, points)
    }

    /// The integral from one parameter of the domain to another; backwards with the other sign.
    ///
    /// # Errors
    /// T001 for a parameter that is not finite; T002 outside the domain.
    pub fn integral(&self, from: &S, to: &S) -> Result<V> {
        if from == to {
            // Refuses what the domain does not hold.
            self.check_closed(from)?;
            return Ok(V::zero());
        }
        let (a, b, sign) = if from < to { (from, to, S::one()) } else { (to, from, -S::one()) };
        let part = self.trim(a, b)?;
        let (t_, p) = (part.knots().values(), part.degree());
        let mut sum = Sum::new();
        for (i, point) in part.points().iter().enumerate() {
            sum.add(&share(t_, i, p), point);
        }
        let mut total = sum.sum;
        total.scale(&sign);
        Ok(total)
    }
}

/// ∫ N_{i,p}.
fn share<S: Scalar>(t_: &[S], i: usize, p: usize) -> S {
    (t_[i + p + 1].clone() - t_[i].clone()) / S::from_int(p as i64 + 1)
}

fn finite<const D: usize>(integral: [f64; D]) -> Result<[f64; D]> {
    match integral.iter().find(|x| !x.is_finite()) {
        None => Ok(integral),
        Some(x) => Err(Error::new(Code::P003, format!("the integral overflows: {x}"))),
    }
}

impl<const D: usize> BSpline<D> {
    /// The antiderivative that is zero at the start of the domain, a curve of degree p + 1; clamped, and open even for a closed
    /// curve.
    ///
    /// *Cost.* O(n + p²). *Error.* E ≤ 8 for each control point, against Σ|Pᵢ|(t_{i+p+1} − tᵢ)/(p + 1): the sum does not lose with
    /// its length.
    ///
    /// ```
    /// use lath::curve::{BSpline, Curve};
    ///
    /// let slope = BSpline::clamped(1, [[0.0], [2.0], [2.0]])?;
    /// let curve = slope.antiderivative()?;
    /// assert_eq!((curve.eval(0.0)?, curve.eval(1.0)?, curve.eval(2.0)?), ([0.0], [1.0], [3.0]));
    /// # Ok::<(), lath::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// K006 for a degree above 1000; P003 for values beyond 1e300.
    pub fn antiderivative(&self) -> Result<BSpline<D>> {
        BSpline::from_spline(self.to_spline().antiderivative()?)
    }

    /// The integral of the curve's coordinates from one parameter of the domain to another; backwards with the other sign.
    ///
    /// *Cost.* O(n + p²). *Error.* E ≤ 5p + 8 against the integral of Σ|Pᵢ|N_i: positive weights only, also where the interval is short.
    ///
    /// ```
    /// use lath::curve::BSpline;
    ///
    /// let hump = BSpline::clamped(2, [[0.0], [3.0], [0.0]])?;
    /// assert_eq!(hump.integral(0.0, 1.0)?, [1.0]);
    /// # Ok::<(), lath::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// T001 for a parameter that is not finite; T002 outside the domain; P003 for a sum that overflows.
    pub fn integral(&self, from: f64, to: f64) -> Result<[f64; D]> {
        finite(self.to_spline().integral(&from, &to)?)
    }
}

impl<const D: usize> Bezier<D> {
    /// The antiderivative that is zero at the start, of one degree more.
    ///
    /// ```
    /// use lath::curve::Bezier;
    ///
    /// assert_eq!(Bezier::new([[2.0], [4.0]])?.antiderivative()?.control_points(), [[0.0], [1.0], [3.0]]);
    /// # Ok::<(), lath::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// K006 for a degree above 1000; P003 for values beyond 1e300.
    pub fn antiderivative(&self) -> Result<Bezier<D>> {
        Bezier::from_spline(self.to_spline()?.antiderivative()?)
    }

    /// The integral of the curve's coordinates from one parameter of the domain to another; see [`BSpline::integral`].
    ///
    /// # Errors
    /// T001 for a parameter that is not finite; T002 outside the domain; P003 for a sum that overflows.
    pub fn integral(&self, from: f64, to: f64) -> Result<[f64; D]> {
        finite(self.to_spline()?.integral(&from, &to)?)
    }
}
