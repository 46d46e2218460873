//! Points: rows of numbers.
//!
//! A [`PointTable`] is what every points format becomes: rows of one width, names of the columns where the file gives
//! them, and where each row stands in the file, so that whoever refuses a point later can still name its line
//! ([`PointTable::locate`]). No column is a parameter unless somebody asks for it by name
//! ([`PointTable::split_parameter`]).
//!
//! One file per format: [`text`] reads CSV, TSV and blanks-separated text alike, [`json`] reads arrays, [`npy`] those
//! of NumPy. Where a table would not fit, [`Rows`] come in one by one; going out, rows are pushed one by one into a
//! [`RowSink`]: so millions of them need no memory.

mod diagnosis;
mod fields;
pub mod json;
mod layout;
pub(crate) mod lines;
pub mod npy;
mod npy_header;
mod npy_numbers;
mod npy_rows;
mod npy_scan;
mod rows;
mod select;
mod table;
pub mod text;
mod write;

pub(crate) use npy_rows::NpyRows;
pub use rows::Rows;
pub use table::PointTable;
pub use write::RowSink;
pub(crate) use write::{JsonRows, Separated};
