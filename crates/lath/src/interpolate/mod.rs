//! F10 — a curve through data.
//!
//! Three choices make an interpolating spline, and each is a value of its own:
//! *when* the curve passes each point ([`Parameters`]), *what* happens at the ends ([`Ends`]), and which rule joins
//! the points.
//!
//! | rule | continuity | reach of a point | keeps |
//! |---|---|---|---|
//! | [`cubic`] | C² | the whole curve, fading | cubics (not-a-knot) |
//! | [`bspline`] of degree p | C^{p−1} | the whole curve, fading | polynomials of degree p (not-a-knot) |
//! | [`catmull_rom`], [`cardinal`] | C¹ | four pieces | parabolas |
//! | [`kochanek_bartels`] | C¹ or a corner, as wished | four pieces | |
//! | [`pchip`], [`steffen`] | C¹ | four pieces | rising and falling |
//! | [`akima`], [`makima`] | C¹ | six pieces | straight stretches |
//!
//! What happens at the ends of the splines that look at the whole curve:
//!
//! | ends | condition | for |
//! |---|---|---|
//! | [`End::NotAKnot`] | the first two pieces are one cubic | nothing known about the ends: reproduces cubics |
//! | [`End::Natural`] | second derivative 0 | a strip free at its end; "relaxed" |
//! | [`End::Clamped`] | first derivative given | known direction and speed |
//! | [`End::Second`] | second derivative given | known acceleration |
//! | [`Ends::Cyclic`] | slopes and second derivatives of both ends agree | one period of something; the values may differ |
//! | [`Ends::Anticyclic`] | they agree with opposite sign | half a period of something that returns mirrored |
//!
//! Start and end may have different conditions. A closed curve has none: every point is an inner point. Derivatives may be given at points
//! inside as well: [`bspline_with_derivatives`].
//! At the time of writing no other spline library offers the anticyclic ends.
//!
//! Conventions: parameters increase strictly; derivatives are for the curve's parameter, so that a clamped slope under chord
//! length is close to a unit vector.
//!
//! Local rules have one rule for their ends, said on each page.
//!
//! Deliberately absent: sorting of the data, merging of doubled points, and a default: the command line has one, the library asks.

mod akima;
mod bspline;
mod catmull_rom;
mod chords;
mod collocation;
mod cubic;
mod derivatives;
mod ends;
mod kochanek_bartels;
mod monotone;
mod parameters;

pub use akima::{akima, makima};
pub use bspline::{BSplineEnd, bspline, bspline_closed, bspline_over};
pub use catmull_rom::{cardinal, catmull_rom};
pub use cubic::{cubic, cubic_closed, slopes, slopes_closed};
pub use derivatives::{Derivative, bspline_with_derivatives};
pub use ends::{End, Ends};
pub use kochanek_bartels::{Tcb, kochanek_bartels};
pub use monotone::{pchip, steffen};
pub use parameters::{Parameters, parameters};
