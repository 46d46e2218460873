//! F2 — where points live.
//!
//! A point is an array `[f64; D]`; no type of another crate appears in a signature, because the field agrees on none.
//! Whatever turns into such an array ([`IntoPoint`]: arrays of `f64` or `f32`, references to them, and behind
//! the features `mint05`, `glam034`, `nalgebra035` the points of those crates) is taken by every
//! constructor.
//!
//! Algorithms that only combine points linearly are written over [`Vector`]: zero, and add a multiple. That is all that
//! evaluation, refinement and subdivision need, so they run on points, on homogeneous points and on exact fractions alike.
//!
//! A point with a weight has two forms: [`Homogeneous`] for what is linear, [`Weighted`] for control points and files.
//!
//! Lengths are computed with scaling by a power of two ([`norm`]), so that coordinates near 1e±150 neither overflow nor
//! vanish; in the ordinary range the scaling changes no bit.
//!
//! Deliberately absent: units, coordinate systems of maps, and an origin that means anything.

mod bounds;
mod homogeneous;
mod interop;
mod point;
mod vector;

pub use bounds::Bounds;
pub use homogeneous::{Homogeneous, Weighted};
pub use point::{IntoPoint, distance, norm};
pub(crate) use point::{check_point, collect};
pub use vector::Vector;
