//! F1 — scalars, and the linear systems over them. No geometry.
//!
//! Algorithms of the floors below `curve` are written over [`Scalar`], so that the same code runs on `f64` and on exact
//! fractions: the product, the oracle and the exact mode are one text. `Scalar` asks for arithmetic and order only;
//! square roots belong to the places that need them and stay in `f64`.
//!
//! The systems of spline interpolation are banded. [`Banded`] solves them without pivoting, which is right for
//! the two kinds that occur: diagonally dominant ones (cubic splines in slopes) and totally positive ones (B-spline
//! collocation; de Boor and Pinkus 1977). Rows of derivatives are neither, and go to [`PivotedBanded`]. [`CyclicBanded`] closes the band around the corner, for closed curves.
//!
//! Deliberately absent: dense linear algebra beyond the few unknowns of a corner, complex numbers, and tolerances:
//! what "close" means is said by the caller.

mod banded;
mod bound;
mod cyclic;
pub(crate) mod gauss;
mod pivoted;
mod scalar;
mod weights;

pub use banded::Banded;
pub use bound::Bound;
pub use cyclic::CyclicBanded;
pub use pivoted::PivotedBanded;
pub use scalar::Scalar;
