//! The dimension of the points, known at run time, as the constant that the library's generic types want.

use lath::error::{Code, Error};

/// Work that is the same in every dimension.
pub(crate) trait InDimension {
    /// What comes of it.
    type Output;

    /// Does the work with points of D coordinates: those beyond the data's own are zero, and change no bit of the others.
    fn run<const D: usize>(self) -> Self::Output;
}

/// Runs the work in the smallest dimension that holds the data.
///
/// # Errors
/// P006 for dimension 0 or above 16.
pub(crate) fn in_dimension<W: InDimension>(dimension: usize, work: W) -> Result<W::Output, Error> {
    Ok(match dimension {
        1 => work.run::<1>(),
        2 => work.run::<2>(),
        3 => work.run::<3>(),
        4 => work.run::<4>(),
        5..=8 => work.run::<8>(),
        9..=16 => work.run::<16>(),
        _ => return Err(Error::new(Code::P006, format!("points of {dimension} coordinates"))),
    })
}
