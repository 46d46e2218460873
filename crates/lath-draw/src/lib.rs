//! **lath-draw** makes pictures of splines that are worth printing: SVG whose curves are the curves' own Béziers, and PNG
//! that looks the same.
//!
//! ```
//! use lath::interpolate::{End, Ends, Parameters, cubic, parameters};
//! use lath_draw::figure::Figure;
//! use lath_draw::layer::{CurveLayer, PointLayer};
//!
//! let points = [[0.0, 0.0], [1.0, 2.0], [3.0, 2.0], [4.0, 0.0]];
//! let t = parameters(&points, false, Parameters::Centripetal)?;
//! let curve = cubic(&points, t, &Ends::Open(End::Natural, End::Natural))?;
//! let svg = Figure::new()
//!     .title("A strip of wood bent around four nails")
//!     .curve(CurveLayer::of(curve)?.label("natural cubic spline").comb(true))
//!     .points(PointLayer::new(2, &points.concat())?.label("nails"))
//!     .axes(true)
//!     .to_svg()?;
//! assert!(svg.contains("<path"));
//! # Ok::<(), lath::error::Error>(())
//! ```
//!
//! # What it promises
//!
//! - *True curves.* A piece of degree 1, 2 or 3 is one command `L`, `Q` or `C` of the SVG path. Higher degrees are cubics
//!   within 0.02 px, proven; curves that are not polynomial are cubics within about that, estimated. Only where dozens of
//!   pieces share a pixel are they merged. A curve that jumps is drawn with the gap.
//! - *True places.* One dimension is drawn as a graph over t, two with equal aspect, three and more in parallel
//!   projection. The centre is subtracted before scaling, so that millimetres far from the origin stay millimetres.
//! - *Honest marks.* Ticks stand at 1, 2, 5 times powers of ten and show decimals, not the rounding of a sum. Where a curvature
//!   comb is compressed, so that nose and flanks of an airfoil can both be read, the legend says from where on.
//! - *It never breaks.* No points, one point, points on a line, numbers from 1e-300 to 1e300, a million pieces: a
//!   picture or a typed [`lath::error::Error`].
//! - *The same bytes everywhere*, in SVG and PNG: letters are outlines of one bundled font, not whatever the viewer has.
//!
//! # How to read this crate
//!
//! From data to ink, each module using only those above it. [`scene`] is the seam: what is below knows curves, what is
//! above knows px.
//!
//! # Conventions
//!
//! Lengths are px of the SVG (96 to the inch), y pointing down; inside, "the plane" is the data centred and scaled to the
//! order of one, y pointing up. The weights of lines rank what they show: curves 2 px, polylines and envelopes less,
//! helpers 1 px and grey, the grid hardly there.
//!
//! # Deliberately absent
//!
//! Bars, pies, logarithmic axes and everything else of a charting library; text layout beyond one line; animation; shading
//! of surfaces (they will come with the surfaces). Whoever needs more takes [`figure::Figure::scene`] and adds to it, or
//! takes the points to a plotting library.
#![forbid(unsafe_code)]

pub mod theme; // colours and weights: taste, in one place
pub mod path; // lines and Béziers in px
pub mod font; // letters as paths
mod thin; // marks that hide one another
pub mod scene; // the display list
pub mod svg; // printed as SVG
pub mod png; // printed as PNG
pub mod ticks; // marks of an axis
mod cubics; // any degree as cubics
mod extent; // tight boxes in the plane
mod lens; // from data to the plane to px
mod trace; // curves as Bézier pieces in the plane
mod pen; // pieces to paths
mod scale; // how long a tooth is
mod comb; // curvature combs
pub mod layer; // what is shown
mod frame; // where the plot stands, and the size that suits it
mod axes; // grid and labels
mod cage; // the same in space
mod header; // title and legend
mod names; // names beside points
mod paint; // layers into the scene
mod subject; // what a figure is asked to show
mod content; // and how that becomes a picture
pub mod figure; // all of it
