//! The formats of lath: how points and shapes come out of files, and how they go back in.
//!
//! The core knows numbers; people have files. Between them stands this crate: it reads CSV, TSV, text and JSON into a
//! [`points::PointTable`], lath JSON into [`shapes::Shape`]s, and writes both so that reading back gives the same bits.
//! NumPy's arrays and the curves of other systems come and go as well.
//! Every fault is one [`Error`] with a stable code, the file, the line and column or the JSON pointer, and a remedy.
//!
//! # Conventions
//!
//! - Nothing in a file is ever ignored: a member nobody knows, a key given twice, a number that does not fit is
//!   refused.
//! - Nothing is allocated from a count that a file claims; what is read is measured against [`lath::error::Limits`].
//! - Lines and columns count from 1, indices from 0. Columns count characters.
//! - One file a format, and one line for it in the registry ([`format::FORMATS`]); one file a kind of shape, and one
//!   line for it in the registry of kinds (in [`shapes`]).
//!
//! Pictures are written by lath-draw, pages of results by the tool; both use [`atomic`] to write files whole or not at
//! all.
//!
//! ```
//! use lath::error::Limits;
//! use lath_io::{format, source::Source};
//!
//! let source = Source::from_bytes("wing.dat", " A WING SECTION\n1.0 0.0\n0.5 0.1\n0.0 0.0\n");
//! let table = format::read_points(&source, None, &Limits::default())?;
//! assert_eq!((table.title(), table.len(), table.width()), (Some("A WING SECTION"), 3, 2));
//! # Ok::<(), lath_io::Error>(())
//! ```

pub mod error; // what can go wrong between bytes and numbers
pub mod number; // one number as text
pub mod source; // bytes with a name, held whole
pub mod stream; // bytes with a name, piece by piece
mod json; // JSON as a tree with places
pub mod points; // rows of numbers
pub mod shapes; // lath JSON
pub mod format; // the registry, and reading whatever comes
pub mod check; // what is wrong with a file, all of it
pub mod atomic; // files whole or not at all

pub use error::{Class, Code, Error, Place, Result};
