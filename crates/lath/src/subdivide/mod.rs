//! F13 — curves by subdivision: every level, the jump, and the limit.
//!
//! A [`Scheme`] is a mask and the rule that applies it: Chaikin's corner cutting, the cubic scheme of edge and vertex points,
//! Lane–Riesenfeld of any degree, the interpolatory four-point scheme, or a mask of the user's own. Applied to a polygon again and
//! again ([`Subdivision`]) it makes levels of twice as many points each, which tend to a curve. Three facts make the floor:
//!
//! - *The jump.* A point of level k is a sum of p + 1 of the given points, with weights that its index alone decides. No level
//!   between is ever needed, whether one point of level 1000 is wanted, a range, a stream, or a whole level.
//! - *The limit is known.* p neighbours of any level tend to a point of the curve that one left eigenvector of a small
//!   matrix gives; its derivatives follow from the derivative schemes. For Lane–Riesenfeld it is a B-spline, and handed out as one.
//! - *The distance is proven.* How far a level lies from its limit has a bound, so "how many levels?" has an answer.
//!
//! Who teaches finds the parts as data: [`groups`] of p + 1 points, [`descents`] (which tuple makes which), the matrices of a
//! scheme, powers of A ([`Scheme::leap`]), its eigenvalues and eigenvectors, or its Jordan form ([`Scheme::eigen`]).
//!
//! # Conventions
//!
//! - n points of an open polygon have levels of 2ᵏ(n − p) + p points; a mask of m numbers counts as degree p = m − 2. The new
//!   point i is Σⱼ a_{i+p−2j} Pⱼ. Closed polygons follow the same rule with indices modulo n·2ᵏ, the first row the same.
//! - The parameter of the limit is t = i/2ᵏ in units of segments, 0 at the first joint: for cubics (P₀ + 4P₁ + P₂)/6. There
//!   are 2ᵏ(n − p) + 1 such points ([`Target::Limit`]), n·2ᵏ of a closed curve.
//! - Levels go to 1000, indices are [`Index`]es of any length.
//! - Slice, stream, range and single point give the same bits.
//! - Everything but bounds and spheres runs on any [`Scalar`](crate::num::Scalar), fractions included.
//!
//! # Who should read on
//!
//! How a point is reached: `mask.rs`; why whole levels are evaluated and not refined by passes: `level.rs`; how the distance
//! is proven: `bound.rs`.
//!
//! Deliberately absent: surfaces (a later file each), schemes whose rule changes from level to level or along the polygon, and
//! masks that change the number of points by another factor than two.

mod bound;
mod convergence;
mod dyadic;
mod eigen;
mod group;
mod jordan;
mod level;
mod limit;
mod mask;
mod matrix;
mod polygon;
mod roots;
mod scheme;
mod sphere;
mod stream;

pub use bound::Distance;
pub use convergence::Convergence;
pub use dyadic::Index;
pub use eigen::{Eigen, Form};
pub use group::{Ancestor, Descent, Leap, ancestor, descents, groups};
pub use limit::Joint;
pub use mask::Target;
pub use polygon::{Ends, MAX_LEVEL, Subdivision};
pub use scheme::Scheme;
pub use sphere::Sphere;
