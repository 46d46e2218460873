//! F8 — the same shape in another description.
//!
//! A curve has many descriptions: more knots, a higher degree, a shorter domain, pieces instead of one, points and tangents instead of control
//! points. Here are the verbs that lead from one to another. Most leave every point of the curve where it was; the few that cannot
//! promise that say how far points may have moved, and have proven it.
//!
//! | verb | what changes | the curve |
//! |---|---|---|
//! | [`insert_knots`](crate::curve::BSpline::insert_knots), [`refine_uniformly`](crate::curve::BSpline::refine_uniformly) | more knots | stays |
//! | [`remove_knots`](crate::curve::BSpline::remove_knots) | fewer knots | moves by at most the bound |
//! | [`elevate`](crate::curve::BSpline::elevate) | higher degree | stays |
//! | [`reduce`](crate::curve::BSpline::reduce) | lower degree | moves by at most the bound |
//! | [`split`](crate::curve::BSpline::split), [`trim`](crate::curve::BSpline::trim) | shorter domain | stays |
//! | [`join`](crate::curve::BSpline::join) | two become one | ends meet, within the bound |
//! | [`clamp`](crate::curve::BSpline::clamp), [`close`](crate::curve::BSpline::close), [`move_seam`](crate::curve::BSpline::move_seam) | its ends | stays; closing within the bound |
//! | [`reverse`](crate::curve::BSpline::reverse), [`reparametrise`](crate::curve::BSpline::reparametrise) | the parameter | points stay |
//! | [`make_compatible`](crate::curve::BSpline::make_compatible) | several get the same knots | stay |
//! | [`to_beziers`](crate::curve::BSpline::to_beziers), [`from_beziers`](crate::curve::BSpline::from_beziers) | pieces | stays |
//! | [`to_bspline`], [`to_beziers()`], [`to_power`], [`to_hermite`] | the family | stays, as far as the form's numbers can say it |
//! | [`derivative`](crate::curve::BSpline::derivative), [`antiderivative`](crate::curve::BSpline::antiderivative), [`sum`](crate::curve::BSpline::sum), [`product`](crate::curve::BSpline::product) | a new function | |
//!
//! All of them are written once, for a [`Spline`] over any scalar with control points from any vector space, and so run on fractions, on points,
//! on homogeneous points, and on the rows of a net alike. The methods of the families are thin.
//!
//! # One idea for most
//!
//! A control point over finer knots is the blossom of the curve at consecutive finer knots, and can be had from the given control points
//! at once, by as many rounds of the triangle as there are *fresh* knots among its arguments (`window.rs`). Insertion is this; cutting is
//! insertion and forgetting; a higher degree is a mean of such points, a product a mean of products of them. All that ever happens is convex
//! combination: nothing is extrapolated, nothing cancels, fifty insertions cost no more than one, and points whose knots
//! do not change keep their bits.
//!
//! # Conventions
//!
//! - A verb gives a new curve and leaves the old one alone. Parameters are kept: the part of a curve on [1, 2] has the domain [1, 2].
//! - *Closed* curves stay closed where that means something; insertion at the period's end is insertion at its start. What needs ends
//!   (cutting, antiderivatives, products) opens them at the seam; joining refuses them (C005).
//! - A distance is one between points of equal parameter, in the units of the points. A bound is proven: it is the greatest move of a control
//!   point over common knots, and what rounding may add. `tolerance` never is exceeded.
//! - Rational curves take the same verbs, see `rational.rs`; their derivatives are no curves of the same denominator, and are left to evaluation.
//!
//! # Deliberately absent
//!
//! Merging of nearly equal knots (every point stays a convex combination, however close they are), repair of ends that do not meet, refits, and
//! the change of a rational curve's parameter that is not linear.

mod compatible;
mod convert;
mod derivative;
mod elevate;
mod insert;
mod integral;
mod join;
mod measure;
mod pieces;
mod product;
mod rational;
mod reduce;
mod remove;
mod reparametrise;
mod seam;
mod spline;
mod split;
mod window;

pub use compatible::make_compatible;
pub use convert::{to_beziers, to_bspline, to_hermite, to_power};
pub use join::Joint;
pub use pieces::Piece;
pub use spline::Spline;
