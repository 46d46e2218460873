//! One number of an `.npy` file: its dtype, and what its bytes mean.

use crate::error::Result;
use crate::points::npy_header::{shown, wrong};

/// How one number is stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Number {
    /// `f`, `i` or `u`.
    letter: char,
    /// In bytes.
    pub(crate) size: usize,
    big: bool,
}

impl Number {
    /// As the header says.
    ///
    /// # Errors
    /// F025 for a dtype that is not read.
    pub(crate) fn of(descr: &str) -> Result<Number> {
        let mut rest = descr.chars();
        let order = rest.next();
        let letter = rest.next();
        let size = match (letter, rest.as_str()) {
            (Some('f'), "4" | "8") | (Some('i' | 'u'), "1" | "2" | "4" | "8") => rest.as_str().parse().ok(),
            _ => None,
        };
        match (order, letter, size) {
            (Some(order @ ('<' | '>' | '|')), Some(letter), Some(size)) if order != '|' || size == 1 => {
                Ok(Number { letter, size, big: order == '>' })
            }
            _ => Err(wrong(format!("the numbers are of dtype {:?}, which is not read", shown(descr)))
                .remedied("Save the array as float64: numpy.save(file, array.astype('float64')).")),
        }
    }

    /// True for what is written here as well.
    pub(crate) fn is_float64(self) -> bool {
        self.letter == 'f' && self.size == 8
    }

    /// The number in these bytes; none for an integer that no double holds.
    pub(crate) fn read(self, stored: &[u8]) -> Option<f64> {
        let mut bytes = [0; 8];
        // Little-endian, at the start of eight bytes.
        if self.big {
            bytes.iter_mut().zip(stored.iter().rev()).for_each(|(byte, from)| *byte = *from);
        } else {
            bytes.iter_mut().zip(stored).for_each(|(byte, from)| *byte = *from);
        }
        let unsigned = u64::from_le_bytes(bytes);
        let unused = 64 - 8 * self.size as u32;
        match (self.letter, self.size) {
            ('f', 8) => Some(f64::from_bits(unsigned)),
            ('f', _) => Some(f64::from(f32::from_bits(unsigned as u32))),
            ('u', _) => Some(unsigned as f64).filter(|x| *x as u128 == u128::from(unsigned)),
            _ => {
                // Shifted up and down again, which carries the sign along.
                let signed = (unsigned << unused) as i64 >> unused;
                Some(signed as f64).filter(|x| *x as i128 == i128::from(signed))
            }
        }
    }
}
