//! Rows going out as NumPy's `.npy`: version 1.0, float64, little-endian, C order, one row a point.
//!
//! The header comes first and tells the number of rows. Where that was announced, rows go out as they come; where it
//! was not, they wait in memory, because what is written to need not be a file in which one could go back.

use std::io::Write;

use crate::error::{Error, Result};
use crate::points::npy_header::MAGIC;
use crate::points::write::{Guard, RowSink};

/// The sink; names of columns have no place in the format and are dropped.
pub(crate) struct NpyRows<'w> {
    out: &'w mut dyn Write,
    guard: Guard,
    /// The rows so far, where their number is not known.
    kept: Option<Vec<f64>>,
    announced: u64,
    begun: bool,
}

impl<'w> NpyRows<'w> {
    pub(crate) fn begin(
        out: &'w mut dyn Write,
        columns: Option<&[String]>,
        count: Option<u64>,
    ) -> Result<Box<dyn RowSink + 'w>> {
        let kept = count.is_none().then(Vec::new);
        let guard = Guard::new(columns, count);
        Ok(Box::new(NpyRows { out, guard, kept, announced: count.unwrap_or(0), begun: false }))
    }

    fn header(&mut self, rows: u64) -> Result<()> {
        if self.begun {
            return Ok(());
        }
        self.begun = true;
        self.out.write_all(&header(rows, self.guard.width.unwrap_or(1))).map_err(|e| Error::writing(&e))
    }
}

/// Magic, version and the dictionary, filled up with blanks to a multiple of 64 bytes.
fn header(rows: u64, width: usize) -> Vec<u8> {
    let mut text = format!("{{'descr': '<f8', 'fortran_order': False, 'shape': ({rows}, {width}), }}");
    let start = MAGIC.len() + 4;
    let blanks = (start + text.len() + 1).next_multiple_of(64) - (start + text.len() + 1);
    text.extend(core::iter::repeat_n(' ', blanks));
    text.push('\n');
    // Two numbers of 20 digits at most: the length fits.
    let length = (text.len() as u16).to_le_bytes();
    [MAGIC, &[1, 0], &length, text.as_bytes()].concat()
}

/// How many numbers are turned into bytes at a time.
const AT_ONCE: usize = 64;

fn put(out: &mut dyn Write, numbers: &[f64]) -> Result<()> {
    let mut bytes = [[0; 8]; AT_ONCE];
    for chunk in numbers.chunks(AT_ONCE) {
        bytes.iter_mut().zip(chunk).for_each(|(place, number)| *place = number.to_le_bytes());
        let bytes = bytes.get(..chunk.len()).unwrap_or_default().as_flattened();
        out.write_all(bytes).map_err(|e| Error::writing(&e))?;
    }
    Ok(())
}

impl RowSink for NpyRows<'_> {
    fn row(&mut self, row: &[f64]) -> Result<()> {
        self.guard.check(row)?;
        if let Some(kept) = &mut self.kept {
            kept.extend_from_slice(row);
            return Ok(());
        }
        self.header(self.announced)?;
        put(self.out, row)
    }

    fn finish(&mut self) -> Result<()> {
        self.guard.finish()?;
        self.header(self.guard.count as u64)?;
        if let Some(kept) = self.kept.take() {
            put(self.out, &kept)?;
        }
        self.out.flush().map_err(|e| Error::writing(&e))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn written(rows: &[[f64; 2]], count: Option<u64>) -> Result<Vec<u8>> {
        let mut out = Vec::new();
        let mut sink = NpyRows::begin(&mut out, None, count)?;
        rows.iter().try_for_each(|row| sink.row(row))?;
        sink.finish()?;
        drop(sink);
        Ok(out)
    }

    #[test]
    fn announced_and_kept_rows_give_the_same_bytes() {
        let rows = [[0.1, -0.0], [5e-324, 1e300], [1.0, 2.0]];
        let kept = written(&rows, None).unwrap();
        assert_eq!(written(&rows, Some(3)).unwrap(), kept);
        assert_eq!((kept.len(), &kept[..10]), (128 + 48, &b"\x93NUMPY\x01\x00\x76\x00"[..]));
        assert!(kept[10..].starts_with(b"{'descr': '<f8', 'fortran_order': False, 'shape': (3, 2), }  "));
        assert_eq!((kept[127], &kept[128..136]), (b'\n', &0.1_f64.to_le_bytes()[..]));
    }

    #[test]
    fn another_number_of_rows_is_refused() {
        for count in [2, 4] {
            assert_eq!(written(&[[0.0; 2]; 3], Some(count)).unwrap_err().code().as_str(), "F024");
        }
        assert_eq!(written(&[], Some(0)).unwrap(), written(&[], None).unwrap());
    }
}
