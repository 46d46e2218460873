//! **lath** turns points into curves, and answers questions about them: exactly, fast, and without ever breaking.
//!
//! A lath is the thin strip of wood that draughtsmen bent around weights to draw a fair curve: the first spline.
//!
//! ```
//! use lath::curve::Curve;
//! use lath::interpolate::{cubic, parameters, End, Ends, Parameters};
//!
//! let points = [[0.0, 0.0], [1.0, 2.0], [3.0, 2.0], [4.0, 0.0]];
//! let t = parameters(&points, false, Parameters::Centripetal)?;
//! let curve = cubic(&points, t, &Ends::Open(End::NotAKnot, End::NotAKnot))?;
//! assert_eq!(curve.eval(0.0)?, [0.0, 0.0]);
//! # Ok::<(), lath::error::Error>(())
//! ```
//!
//! # How to read this crate
//!
//! The modules are floors. Each imports only from the floors above it in the list below, by the defining module's path,
//! and opens with an essay that says what it is for and what it leaves out. Types are declared low and receive their
//! verbs from higher floors, so that one page shows all that can be done with a type.
//!
//! # Three promises
//!
//! 1. *It never breaks.* Any input gives a right answer or a typed [`error::Error`] that names what is wrong.
//! 2. *It knows its error.* Every approximate answer carries a [`num::Bound`], or says that it is an estimate.
//! 3. *The same bits everywhere.* Only `+ − × ÷ √` in a fixed order: no fused operations, no platform's own functions.
#![no_std]
#![forbid(unsafe_code)]
extern crate alloc;

pub mod error; // F0: what can go wrong, and the budgets that keep it from going on for ever
pub mod num; // F1: scalars and the linear systems over them
pub mod space; // F2: where points live
pub mod knot; // F3: knot vectors
pub mod basis; // F4: functions over knots, and the blossom that explains them
pub mod curve; // F5: the Curve trait and the families, one file each
pub mod refine; // F8: the same shape in another description
pub mod query; // F9: questions about a shape
pub mod interpolate; // F10: a curve through data
pub mod subdivide; // F13: schemes, levels, the jump and the limit
pub mod tessellate; // F14: straight pieces for others
