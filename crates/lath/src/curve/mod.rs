//! F5 — the [`Curve`] trait and the families, one file each.
//!
//! A curve is a function from a closed interval of the user's own parameter into D-dimensional space. Whoever can say
//! the domain, value with derivatives, and the breaks, is a [`Curve`] and gets everything above this floor: boxes, curvature,
//! flattening, pictures. Whoever is piecewise polynomial says so by handing out exact Bézier pieces, and gets it with proofs; so does
//! whoever is piecewise rational, by pieces with weights. The two are asked for apart, so that nobody takes one for the other.
//!
//! | family | defined by | continuity |
//! |---|---|---|
//! | [`Bezier`] | control points | C∞ |
//! | [`BSpline`] | knots, control points | C^{p−m} at a knot of multiplicity m |
//! | [`UniformBSpline`] | control points; unit spans, by matrix, with tension | C^{p−1} |
//! | [`RationalBezier`] | control points with weights | C∞ |
//! | [`Nurbs`] | knots, control points with weights | C^{p−m} at a knot of multiplicity m, or more |
//! | [`Hermite`] | parameters, points, tangents | C¹; C² as a cubic spline: see [`interpolate`](mod@crate::interpolate) |
//! | [`QuinticHermite`] | parameters, points, first and second derivatives | C² |
//! | [`Polyline`] | points | C⁰ |
//! | [`Power`] | breaks, coefficients of ascending powers | as given |
//! | [`Path`] | curves one after another | as they meet |
//!
//! Conventions:
//! - domains are closed; inside, a break is answered from the right, at the domain's end from the left;
//!   [`Side`](crate::knot::Side) asks for the other limit;
//! - outside the domain the caller chooses: [`Outside`];
//! - constructors check everything, evaluation checks the parameter only;
//! - derivatives are taken for the curve's own parameter.
//!
//! [`AnyCurve`] holds a curve whose dimension is known at run time, for files and other languages.
//!
//! Deliberately absent: a scalar parameter on the types (the generic algorithms are one floor below), and conversions,
//! which belong to the floor `refine`.

mod any;
mod bezier;
mod bspline;
pub mod conic;
mod denominator;
mod hermite;
mod interval;
mod nurbs;
mod path;
mod polyline;
mod power;
mod protocol;
mod quintic;
mod rational_bezier;
mod tension;
mod uniform;

pub use any::{AnyCurve, CurveBuilder, CurveVisitor, MAX_DIMENSION, pad};
pub use bezier::Bezier;
pub use bspline::BSpline;
pub use hermite::Hermite;
pub use interval::{Interval, Outside};
pub use nurbs::Nurbs;
pub use path::Path;
pub use polyline::Polyline;
pub use power::Power;
pub use protocol::{BezierPiece, Curve, RationalPiece};
pub use quintic::QuinticHermite;
pub use rational_bezier::RationalBezier;
pub use uniform::{PolygonEnd, UniformBSpline};

pub(crate) use interval::check_increasing;
