//! F9 — questions about a shape.
//!
//! Answers come from the curve, never from samples of it: where the curve hands out Bézier pieces, polynomial or rational, they are proven, and
//! say by how much they may be off; where it does not they are estimates and say so ([`Bound`](crate::num::Bound)).
//!
//! - [`bounds`]: the box around a curve;
//! - [`curvature`], [`signed_curvature`]: how fast the direction turns;
//! - [`continuity`]: how smoothly the pieces join;
//! - [`length`], and [`ArcLength`]: from lengths along a curve to parameters and back;
//! - [`area`]: what a closed plane curve goes around, and its centroid.
//!
//! Conventions: lengths in the units of the points, curvature in one over that unit; an undefined answer is `None`, never NaN.
//!
//! Deliberately absent for now: extrema, nearest points, intersections. Each will be a file here.

mod arc_length;
mod area;
mod bounds;
mod continuity;
mod curvature;
mod length;
mod measure;
mod speed;

pub use arc_length::ArcLength;
pub use area::{Area, area};
pub use bounds::bounds;
pub use continuity::{Continuity, continuity};
pub use curvature::{curvature, signed_curvature};
pub use length::length;
