//! **lath-exact**: splines in fractions. Every matrix, blending function and mask of lath, without rounding.
//!
//! The core's algorithms are written over any scalar. Here they run on [`Rational`], and what comes out is what a textbook
//! prints: ⅙ [−1 3 −3 1; …], not 0.16666666666666666.
//!
//! ```
//! use lath_exact::answer::{matrix, Basis};
//! use lath_exact::print::{render, Format};
//!
//! let answer = matrix(&Basis::BSpline, 3, &Default::default())?;
//! assert_eq!(render(&answer, Format::Text)?, "\
//! Uniform B-splines of degree 3
//! P(t) = (t³, t², t, 1) · M · (P₀, P₁, P₂, P₃)ᵀ, 0 ≤ t ≤ 1
//!
//!           ⎡ −1   3  −3  1 ⎤
//! M = 1/6 × ⎢  3  −6   3  0 ⎥
//!           ⎢ −3   0   3  0 ⎥
//!           ⎣  1   4   1  0 ⎦
//! ");
//! # Ok::<(), lath_exact::error::Error>(())
//! ```
//!
//! # Where things are
//!
//! - [`answer`]: one function for each question, returning plain data. Who writes a program starts here.
//! - [`print`](mod@print): every answer as text, JSON, LaTeX, or constants for Rust, Python and C; and its derivation in steps.
//! - [`Rational`], [`Matrix`], [`Polynomial`], [`parse`]: the arithmetic below.
//!
//! Deliberately absent: a computer algebra system. There are no symbols, no roots, and no functions but polynomials.
#![forbid(unsafe_code)]

pub mod answer;
mod budget;
pub mod error;
mod explain;
mod line;
mod matrix;
pub mod parse;
mod polynomial;
pub mod print;
mod rational;
mod weights;

pub use matrix::Matrix;
pub use polynomial::Polynomial;
pub use rational::Rational;
