//! The limit: joints, derivatives, and the curve itself.
//!
//! The p neighbours (k, i) … (k, i + p − 1) go through the local matrix A over and over, and so tend to one point: their
//! sum with the weights of A's left eigenvector for the eigenvalue 1. It is the curve's point at t = i/2ᵏ. The same for the
//! derivative scheme on differences gives the tangent (in A: the left eigenvector for ½), and once more the second derivative
//! (for ¼): exact where they exist. For cubics (1, 4, 1)/6, 2ᵏ(−1, 0, 1)/2 and 4ᵏ(1, −2, 1).
//!
//! Differences are taken of the polygon that was given. Those of a high level would be all rounding.

use crate::curve::BSpline;
use crate::error::{Code, Error, Result};
use crate::num::Scalar;
use crate::subdivide::dyadic::Index;
use crate::subdivide::mask::{Rows, Target};
use crate::subdivide::matrix::null_space;
use crate::subdivide::polygon::{Ends, Subdivision};
use crate::subdivide::scheme::{Scheme, magnitude};
use alloc::format;
use alloc::vec::Vec;

/// The curve at one dyadic parameter.
#[derive(Clone, Debug, PartialEq)]
pub struct Joint<const D: usize, S = f64> {
    /// The parameter i/2ᵏ, in units of segments from the first joint.
    pub t: S,
    /// The curve's point.
    pub point: [S; D],
    /// The first derivative; none where the scheme is not proven to have one.
    pub tangent: Option<[S; D]>,
    /// The second derivative; none where the scheme is not proven to have one.
    pub second: Option<[S; D]>,
}

impl<S: Scalar> Scheme<S> {
    /// The weights that p neighbours of a level have in the limit's point (`order` 0), or in its derivative of an order times
    /// 2^{−k·order}: the left eigenvectors of the local matrix for 1, ½, ¼, …
    ///
    /// ```
    /// use lath::subdivide::Scheme;
    ///
    /// let cubic = Scheme::<f64>::cubic();
    /// assert_eq!(cubic.limit_mask(0)?, [1.0 / 6.0, 2.0 / 3.0, 1.0 / 6.0]);
    /// assert_eq!(cubic.limit_mask(1)?, [-0.5, 0.0, 0.5]);
    /// assert_eq!(cubic.limit_mask(2)?, [1.0, -2.0, 1.0]);
    /// assert!(cubic.limit_mask(3).is_err()); // the third derivative jumps at joints
    /// # Ok::<(), lath::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// S003 where the scheme is not proven to have limits with continuous derivatives of this order.
    pub fn limit_mask(&self, order: usize) -> Result<Vec<S>> {
        let mut scheme = self.clone();
        for _ in 0..order {
            scheme = scheme.derivative()?;
        }
        let mut mask = scheme.joint_mask()?;
        // Weights of differences become weights of points.
        for _ in 0..order {
            let mut points = alloc::vec![S::zero(); mask.len() + 1];
            for (i, w) in mask.iter().enumerate() {
                points[i] = points[i].clone() - w.clone();
                points[i + 1] = points[i + 1].clone() + w.clone();
            }
            mask = points;
        }
        Ok(mask)
    }

    /// The left eigenvector of the local matrix for the eigenvalue 1, with sum 1.
    fn joint_mask(&self) -> Result<Vec<S>> {
        let p = self.degree();
        if self.is_spline() {
            let rows = Rows::spline(self, 0, Target::Limit, 1);
            let mut scratch = Vec::new();
            return Ok(rows.rows(&Index::default(), 1, &mut scratch)[..p].to_vec());
        }
        if !self.convergence().is_proven() {
            return Err(Error::new(Code::S003, format!("convergence of the mask of {} numbers is not proven", p + 2)));
        }
        // Columns of A − 1 as rows: the null space of the transpose.
        let one = |i: usize, j: usize| if i == j { S::one() } else { S::zero() };
        let transposed = (0..p).map(|j| (0..p).map(|i| self.weight(i, j) - one(i, j)).collect()).collect();
        let sum = |v: &[S]| v.iter().fold(S::zero(), |sum, w| sum + w.clone());
        match &null_space(transposed)[..] {
            [vector] if !sum(vector).is_zero() => {
                let total = sum(vector);
                Ok(vector.iter().map(|w| w.clone() / total.clone()).collect())
            }
            _ => self.iterated_mask(),
        }
    }

    /// The same by iteration v ← v A, for floats that hide the eigenvector from elimination: long masks have weights far
    /// below the rounding of others.
    fn iterated_mask(&self) -> Result<Vec<S>> {
        let p = self.degree();
        let close = S::one() / S::from_int(1 << 53);
        let mut v = alloc::vec![S::one() / S::from_int(p as i64); p];
        for _ in 0..2000 {
            let weight = |j: usize| (0..p).fold(S::zero(), |sum, i| sum + v[i].clone() * self.weight(i, j));
            let next: Vec<S> = (0..p).map(weight).collect();
            let still = v.iter().zip(&next).all(|(a, b)| magnitude(&(a.clone() - b.clone())) <= close);
            v = next;
            if still {
                return Ok(v);
            }
        }
        Err(Error::new(Code::S003, "the local matrix has no single eigenvector for 1"))
    }
}

impl<const D: usize, S: Scalar> Subdivision<D, S> {
    /// The subdivision of the derivative: its limit is the derivative of this one's limit by t, at every order that exists.
    ///
    /// ```
    /// use lath::subdivide::{Ends, Scheme, Subdivision, Target};
    ///
    /// let square = [[0.0, 0.0], [6.0, 0.0], [6.0, 6.0], [0.0, 6.0]];
    /// let curve = Subdivision::new(Scheme::cubic(), square, Ends::Closed)?;
    /// let tangent = curve.derivative()?.point(1, Target::Limit, &1.into())?; // at t = ½
    /// assert_eq!(tangent, [0.0, 4.5]);
    /// # Ok::<(), lath::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// S003 if the scheme has no derivative scheme, or that scheme is not proven to converge.
    pub fn derivative(&self) -> Result<Subdivision<D, S>> {
        let scheme = self.scheme().derivative()?;
        if !scheme.is_spline() && !scheme.convergence().is_proven() {
            let message = format!("the derivative scheme of degree {} is not proven to converge", scheme.degree());
            return Err(Error::new(Code::S003, message));
        }
        let points = self.control_points();
        let count = if self.is_closed() { points.len() } else { points.len() - 1 };
        let difference = |i: usize| {
            let (a, b) = (&points[i], &points[(i + 1) % points.len()]);
            core::array::from_fn(|c| b[c].clone() - a[c].clone())
        };
        Ok(Subdivision::padded(scheme, (0..count).map(difference).collect(), self.ends()))
    }

    /// The joint to which the p neighbours (k, i) … (k, i + p − 1) tend: the curve at t = i/2ᵏ with its first two
    /// derivatives by t, where they exist.
    ///
    /// *Cost.* As three calls of [`Subdivision::point`]. *Error.* As there, for the differences of the given points.
    ///
    /// ```
    /// use lath::subdivide::{Ends, Scheme, Subdivision};
    ///
    /// let points = [[0.0], [6.0], [0.0], [0.0]];
    /// let joint = Subdivision::new(Scheme::cubic(), points, Ends::Open)?.joint(0, &0.into())?;
    /// assert_eq!((joint.point, joint.tangent, joint.second), ([4.0], Some([0.0]), Some([-12.0])));
    /// # Ok::<(), lath::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`Subdivision::point`] for the limit.
    pub fn joint(&self, level: usize, index: &Index) -> Result<Joint<D, S>> {
        let point = self.point(level, Target::Limit, index)?;
        let derived = self.derivative().ok();
        let twice = derived.as_ref().and_then(|derived| derived.derivative().ok());
        let at = |derived: Option<Subdivision<D, S>>| {
            derived.map(|derived| derived.point(level, Target::Limit, index)).transpose()
        };
        Ok(Joint { t: index.parameter(level), point, tangent: at(derived)?, second: at(twice)? })
    }
}

impl<const D: usize> Subdivision<D> {
    /// The limit as a B-spline curve over uniform knots, with the same parameter: domain [0, spans].
    ///
    /// ```
    /// use lath::curve::Curve;
    /// use lath::subdivide::{Ends, Scheme, Subdivision, Target};
    ///
    /// let corners = [[1.5, 0.0], [0.0, 1.5], [-1.5, 0.0], [0.0, -1.5]];
    /// let scheme = Subdivision::new(Scheme::cubic(), corners, Ends::Closed)?;
    /// let curve = scheme.curve()?;
    /// assert_eq!(curve.eval(0.75)?, scheme.point(2, Target::Limit, &3.into())?);
    /// # Ok::<(), lath::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// S004 for schemes that are not Lane–Riesenfeld; P001 for an open polygon of p points, whose limit is a single joint.
    pub fn curve(&self) -> Result<BSpline<D>> {
        let degree = self.scheme().degree();
        if !self.scheme().is_spline() {
            let message = format!("the limit of a mask of {} numbers that are no binomial coefficients", degree + 2);
            return Err(Error::new(Code::S004, message));
        }
        match self.ends() {
            Ends::Closed => BSpline::closed_uniform(degree, self.control_points()),
            Ends::Open | Ends::Kept => BSpline::uniform(degree, self.control_points()),
        }
    }
}
