//! One function for each question, each returning plain data.
//!
//! | question | function | answer |
//! |---|---|---|
//! | the matrix of a basis | [`matrix`] | [`BasisMatrix`] |
//! | B-splines as polynomials | [`blending`] | [`Blending`] |
//! | weights at a parameter | [`at`] | [`At`] |
//! | where control points stand | [`greville`] | [`Greville`] |
//! | inserting knots, raising the degree | [`insertion`], [`elevation`], [`elevation_bezier`] | [`Refinement`] |
//! | from one basis to another | [`change`] | [`Change`] |
//! | a cubic spline through points | [`interpolation`] | [`Interpolation`] |
//! | a B-spline of any degree through points | [`collocation`] | [`Collocation`] |
//! | a subdivision scheme | [`scheme`] | [`SchemeAnswer`] |
//! | a point of a level, or of the limit | [`point`], [`limit`] | [`Point`] |
//! | from level to level | [`jump`], [`triplets`] | [`Jump`], [`Triplets`] |
//!
//! Conventions are the core's: *degree*, never order; indices from 0; n + p + 1 knots; spans closed on the left. Parameters and knots
//! are fractions, and so is every answer. All take a budget and refuse, before they begin, what would not end (B001).

mod at;
mod basis;
mod blending;
mod change;
mod collocation;
mod interpolation;
mod knots;
mod scheme;

pub use at::{At, at};
pub use basis::{Basis, BasisMatrix, matrix};
pub use blending::{Blending, Function, Piece, blending};
pub use change::{Change, Form, change};
pub use collocation::{Collocation, Equation, SplineEnds, collocation};
pub use interpolation::{Condition, Ends, Interpolation, interpolation};
pub use knots::{Greville, Refined, Refinement, elevation, elevation_bezier, greville, insertion};
pub use scheme::{
    Decomposition, Jump, Point, SchemeAnswer, Spectrum, Triplets, jump, limit, point, scheme, scheme_named, triplets,
};
