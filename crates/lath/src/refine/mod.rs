//! F8 — the same shape in another description.
mod compatible;
mod convert;
mod derivative;
mod elevate;
mod insert;
mod integral;
mod join;
mod measure;
mod pieces;
mod product;
mod reduce;
mod remove;
mod reparametrise;
mod seam;
mod spline;
mod split;
mod window;

pub use compatible::make_compatible;
pub use convert::{to_beziers, to_bspline, to_hermite, to_power};
pub use join::Joint;
pub use pieces::Piece;
pub use spline::Spline;
