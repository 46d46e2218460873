//! F4 — functions over knots, and the blossom that explains them.
//!
//! Everything here is written over [`Scalar`](crate::num::Scalar) for the weights and
//! [`Vector`](crate::space::Vector) for the points, and so runs unchanged on exact fractions.
//!
//! - [`bernstein`]: the polynomials J_{n,i} of Bézier curves, evaluation, derivatives, splitting;
//! - [`bspline`]: the non-zero B-splines at a parameter, with derivatives of every order, and the local evaluation of a
//!   spline on one span;
//! - [`uniform`]: the same over uniform knots, by exact matrices;
//! - [`hermite`]: the blending functions F₁ … F₄ over an interval of any length;
//! - [`rational`]: quotients of any of these, with derivatives of every order;
//! - [`blossom`]: the polar form, of which the two evaluation triangles (de Casteljau, de Boor) are two readings.
//!
//! Conventions: parameters are the caller's own, on [a, b] or on the knots; both barycentric weights of a parameter are
//! formed by subtraction from the interval's ends, never as 1 − u, so that each is accurate to one rounding.
//! Derivatives are taken of the control points first and evaluated afterwards: differences of the data are exact or
//! nearly so, differences of computed values are not.
//!
//! Deliberately absent: power form, which is ill-conditioned away from its origin; it is a format for exchange, and
//! converted to at the edge.

pub mod bernstein;
pub mod blossom;
pub mod bspline;
pub mod hermite;
pub mod rational;
mod scratch;
pub mod uniform;
