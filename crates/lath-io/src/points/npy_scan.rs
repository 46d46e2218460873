//! The rows of an `.npy` file, one by one.
//!
//! A block of rows is in memory at a time. In C order a block lies together; in Fortran order each column is gone to on
//! its own, and a block has rows enough to make that worth it.

use lath::error::{Code as CoreCode, Limits};

use crate::error::{Code, Error, Result};
use crate::number::counted;
use crate::points::npy_header::{Header, PREFIX, extent, read as read_header, wrong};
use crate::points::npy_numbers::Number;
use crate::stream::Stream;

/// The numbers of a block, about, and the rows that it has at least in Fortran order.
const BLOCK: usize = 1 << 13;
const ROWS: usize = 64;

/// The rows of a stream, from its start.
#[derive(Debug)]
pub(crate) struct Scan<'a> {
    stream: Stream<'a>,
    limits: &'a Limits<'a>,
    pub(crate) number: Number,
    fortran: bool,
    pub(crate) rows: u64,
    pub(crate) width: usize,
    /// Where the numbers begin, in bytes.
    data: u64,
    /// The bytes of the rows `first..first + held`, in the order of the file.
    block: Vec<u8>,
    first: u64,
    held: usize,
    /// The rows handed out.
    at: u64,
}

impl<'a> Scan<'a> {
    /// Reads the header.
    ///
    /// # Errors
    /// F025 what is no `.npy`, is cut off or too long, or has another dtype or shape; P001 no rows, P006 no columns;
    /// B001 above the budget of points.
    pub(crate) fn new(mut stream: Stream<'a>, limits: &'a Limits<'a>) -> Result<Scan<'a>> {
        let name = stream.name().to_owned();
        let header = header(&mut stream, limits).map_err(|error| error.in_source(&name))?;
        Scan::behind(header, stream, limits).map_err(|error| error.in_source(&name))
    }

    fn behind(header: Header, mut stream: Stream<'a>, limits: &'a Limits<'a>) -> Result<Scan<'a>> {
        let number = Number::of(&header.descr)?;
        let (rows, width) = match header.shape[..] {
            [rows] => (rows, 1),
            [rows, width] => (rows, width),
            _ => {
                return Err(wrong(format!("the array has {}, not 1 or 2", counted(header.shape.len(), "dimension")))
                    .remedied("Save an array of shape (n, m), one row a point."));
            }
        };
        let data = header.data;
        let claimed = rows.checked_mul(width).and_then(|count| count.checked_mul(number.size as u64));
        if !stream.is_counted() {
            // What follows is not known yet: no more is copied than the budget allows.
            limits.check_points(rows)?;
        }
        let enough = claimed.and_then(|claimed| claimed.checked_add(data)?.checked_add(1)).unwrap_or(0);
        let there = stream.length(enough)?.saturating_sub(data);
        if claimed != Some(there) {
            let claimed =
                claimed.map_or("more bytes than can be counted".to_owned(), |claimed| format!("{claimed} bytes"));
            let more = if stream.is_counted() { "" } else { " or more" };
            let message =
                format!("the shape ({rows}, {width}) of {} takes {claimed}, but {there}{more} follow", header.descr);
            return Err(wrong(message).remedied("The file is cut off or damaged: save or copy it again."));
        }
        if rows == 0 {
            return Err(Error::new(Code::Core(CoreCode::P001), "the array has no rows"));
        }
        if width == 0 {
            return Err(Error::new(Code::Core(CoreCode::P006), "the array has no columns"));
        }
        limits.check_points(rows)?;
        // The bytes of a row are there, but they may be more than can be held.
        limits.check_bytes(width.saturating_mul(8 * ROWS as u64).min(there))?;
        let width = usize::try_from(width).unwrap_or(usize::MAX);
        let fortran = header.fortran;
        Ok(Scan { stream, limits, number, fortran, rows, width, data, block: Vec::new(), first: 0, held: 0, at: 0 })
    }

    /// The name of the stream.
    pub(crate) fn name(&self) -> &str {
        self.stream.name()
    }

    /// The same rows from the first on.
    pub(crate) fn rewind(&mut self) {
        (self.first, self.held, self.at) = (0, 0, 0);
    }

    /// Appends the numbers of the next row, finite or not; false behind the last row.
    ///
    /// # Errors
    /// F014 an integer that no double holds; F025 where the file became shorter meanwhile; I004 where reading fails.
    pub(crate) fn row(&mut self, values: &mut Vec<f64>) -> Result<bool> {
        if self.at == self.rows {
            return Ok(false);
        }
        if self.at - self.first >= self.held as u64 {
            self.load()?;
        }
        let row = (self.at - self.first) as usize;
        let size = self.number.size;
        for column in 0..self.width {
            let place = if self.fortran { column * self.held + row } else { row * self.width + column };
            let stored = self.block.get(place * size..(place + 1) * size).unwrap_or_default();
            values.push(self.number.read(stored).ok_or_else(|| {
                let row = self.at;
                let message = format!(
                    "the integer in column {column} of row {row} is beyond 2^53 and no double holds it exactly"
                );
                Error::new(Code::F014, message)
                    .remedied("Save the array as float64, if rounding is meant.")
                    .at_index(row as usize)
                    .in_source(self.stream.name())
            })?);
        }
        self.at += 1;
        Ok(true)
    }

    /// Reads the block that begins with the next row.
    fn load(&mut self) -> Result<()> {
        self.limits.check_cancel().map_err(|error| Error::from(error).in_source(self.stream.name()))?;
        let least = if self.fortran { ROWS } else { 1 };
        let wanted = (BLOCK / self.width).max(least) as u64;
        let left = self.rows - self.at;
        self.first = self.at;
        self.held = if left < wanted { left as usize } else { wanted as usize };
        let size = self.number.size;
        self.block.resize(self.held * self.width * size, 0);
        let pieces = if self.fortran { self.width } else { 1 };
        let length = self.block.len() / pieces;
        for piece in 0..pieces {
            let row = if self.fortran { piece as u64 * self.rows + self.first } else { self.first * self.width as u64 };
            self.stream.go_to(self.data + row * size as u64)?;
            let part = self.block.get_mut(piece * length..(piece + 1) * length).unwrap_or_default();
            if self.stream.fill(part)? < length {
                return Err(wrong("the file became shorter while it was read").in_source(self.stream.name()));
            }
        }
        Ok(())
    }
}

/// The header at the start of a stream.
fn header(stream: &mut Stream<'_>, limits: &Limits<'_>) -> Result<Header> {
    stream.rewind()?;
    let mut bytes = vec![0; PREFIX];
    let start = stream.fill(&mut bytes)?;
    bytes.truncate(start);
    let (_, end) = extent(&bytes)?;
    // No more than is there, and than may be held.
    let there = stream.length(end)?;
    let end = if there < end { there } else { end };
    limits.check_bytes(end)?;
    bytes.resize(usize::try_from(end).unwrap_or(start).max(start), 0);
    let got = stream.fill(bytes.get_mut(start..).unwrap_or_default())?;
    bytes.truncate(start + got);
    read_header(&bytes)
}

/// The error about a number that is NaN or infinite.
pub(crate) fn not_finite(row: u64, column: usize, number: f64) -> Error {
    let message = format!("column {column} of row {row} is {number}");
    Error::new(Code::Core(CoreCode::P002), message).at_index(usize::try_from(row).unwrap_or(usize::MAX))
}
