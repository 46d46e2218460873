//! F14 — straight pieces for others: screens, cutters, printers, file formats.
//!
//! A tolerance is the greatest distance between the curve and its polyline, in the units of the points. It is kept by a
//! theorem where the curve hands out Bézier pieces, and the answer says so.
//!
//! Output goes to a sink (a closure), not into a container: nothing is stored, and the number of points is known, and
//! held against a budget, before the first one is produced.
//!
//! Deliberately absent: the fewest possible points (uniform steps in each piece are within a small factor and cost one
//! pass), and anything that looks like a mesh, which comes with surfaces.

mod flatten;
mod rational;

pub use flatten::flatten;
