//! F3 — knot vectors: the parameter line cut into spans.
//!
//! A knot vector t₀ ≤ t₁ ≤ … ≤ t_{n+p} together with a degree p carries n B-splines N₀ … N_{n−1}; Nᵢ lives on [tᵢ, t_{i+p+1}].
//! [`Knots`] holds both and is valid by construction: finite, non-decreasing, no knot more than p + 1 times, and a domain
//! [t_p, t_n] that is not empty. Whoever holds a `Knots` need not check anything again.
//!
//! Conventions:
//! - *degree*, never order (order = degree + 1);
//! - n + p + 1 knots for n functions. The convention with two knots fewer, which leaves out the first and the last, is
//!   recognised and named in the error, never guessed;
//! - spans are closed on the left and open on the right, the last one of the domain closed on both ends; [`Side::Left`]
//!   asks for the other reading at a knot;
//! - −0.0 and 0.0 are equal, as knots and as parameters;
//! - multiplicity m at an inner knot leaves the curve C^{p−m}; m = p + 1 breaks it in two.
//!
//! Deliberately absent: sorting (a different order is a different curve), merging of nearly equal knots (1e-15 apart is
//! a span like any other), and weights.

mod builder;
mod span;
mod vector;

pub use span::Side;
pub use vector::Knots;
pub(crate) use vector::{check_count, check_degree, check_period};
