//! F8 — the same shape in another description.
mod compatible;
mod elevate;
mod insert;
mod join;
mod measure;
mod remove;
mod reparametrise;
mod seam;
mod spline;
mod split;
mod window;

pub use compatible::make_compatible;
pub use join::Joint;
pub use spline::Spline;
