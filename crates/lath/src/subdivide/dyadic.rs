//! Indices of any length: at level 1000 they leave every integer type.

use crate::error::{Code, Error, Result};
use crate::num::Scalar;
use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec::Vec;
use core::cmp::Ordering;
use core::fmt;
use core::str::FromStr;

/// Beyond this many digits a text is refused: no level has such an index, and reading costs the square of the length.
const MAX_DIGITS: usize = 10_000;

/// The index of a point in its level, an unsigned integer of any length: read from decimal digits or from bits.
///
/// An index i of level k is the dyadic parameter i/2ᵏ; its bits say which way to go at each of the k refinements.
///
/// ```
/// use lath::subdivide::Index;
///
/// let i: Index = "1267650600228229401496703205377".parse()?; // 2¹⁰⁰ + 1
/// assert_eq!(i.bit_length(), 101);
/// assert_eq!(i, Index::from_bits(i.to_bits()));
/// assert_eq!(i.to_string(), "1267650600228229401496703205377");
/// assert_eq!(Index::from(6).to_bits(), [true, true, false]);
/// # Ok::<(), lath::error::Error>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
pub struct Index {
    /// Least significant first, without leading zeros.
    words: Vec<u32>,
}

impl From<u64> for Index {
    fn from(n: u64) -> Index {
        Index::trimmed(alloc::vec![n as u32, (n >> 32) as u32])
    }
}

impl Index {
    fn trimmed(mut words: Vec<u32>) -> Index {
        while words.last() == Some(&0) {
            words.pop();
        }
        Index { words }
    }

    /// From bits, the most significant first.
    pub fn from_bits(bits: impl IntoIterator<Item = bool>) -> Index {
        let bits: Vec<bool> = bits.into_iter().collect();
        let mut words = alloc::vec![0u32; bits.len().div_ceil(32)];
        for (place, bit) in bits.iter().rev().enumerate() {
            words[place / 32] |= u32::from(*bit) << (place % 32);
        }
        Index::trimmed(words)
    }

    /// The bits, the most significant first, which is 1; none for zero.
    pub fn to_bits(&self) -> Vec<bool> {
        (0..self.bit_length()).rev().map(|place| self.bit(place)).collect()
    }

    /// The number of bits without leading zeros.
    pub fn bit_length(&self) -> usize {
        self.words.last().map_or(0, |top| 32 * self.words.len() - top.leading_zeros() as usize)
    }

    /// The bit of the given weight, 0 for the least significant.
    pub fn bit(&self, place: usize) -> bool {
        self.words.get(place / 32).is_some_and(|word| word >> (place % 32) & 1 == 1)
    }

    /// How many zero bits end it: so many levels above, the same place has the index self/2^zeros. 0 for zero.
    pub fn trailing_zeros(&self) -> usize {
        let Some(first) = self.words.iter().position(|word| *word != 0) else { return 0 };
        32 * first + self.words[first].trailing_zeros() as usize
    }

    /// The integer, if it is below 2⁶⁴.
    pub fn to_u64(&self) -> Option<u64> {
        match self.words[..] {
            [] => Some(0),
            [low] => Some(u64::from(low)),
            [low, high] => Some(u64::from(high) << 32 | u64::from(low)),
            _ => None,
        }
    }

    /// The integer, or the greatest u64 if it is above: for budgets.
    pub(crate) fn saturated(&self) -> u64 {
        self.to_u64().unwrap_or(u64::MAX)
    }

    /// self · 2^places.
    pub fn shifted_up(&self, places: usize) -> Index {
        let (whole, part) = (places / 32, places % 32);
        let mut words = alloc::vec![0; whole];
        let mut carry = 0u64;
        for word in &self.words {
            let shifted = u64::from(*word) << part | carry;
            words.push(shifted as u32);
            carry = shifted >> 32;
        }
        words.push(carry as u32);
        Index::trimmed(words)
    }

    /// The whole part of self / 2^places: the index of the point that this one descends from, so many levels before.
    pub fn shifted_down(&self, places: usize) -> Index {
        let (whole, part) = (places / 32, places % 32);
        let words = self.words.get(whole..).unwrap_or(&[]);
        let word = |i: usize| {
            let high = words.get(i + 1).copied().unwrap_or(0);
            ((u64::from(high) << 32 | u64::from(words[i])) >> part) as u32
        };
        Index::trimmed((0..words.len()).map(word).collect())
    }

    /// self mod 2^places.
    pub fn low_bits(&self, places: usize) -> Index {
        let (whole, part) = (places / 32, places % 32);
        let mut words: Vec<u32> = self.words.iter().take(whole + usize::from(part > 0)).copied().collect();
        if part > 0 && words.len() > whole {
            words[whole] &= (1 << part) - 1;
        }
        Index::trimmed(words)
    }

    /// self + n.
    pub fn plus(&self, n: &Index) -> Index {
        let mut carry = 0u64;
        let mut words = Vec::with_capacity(self.words.len().max(n.words.len()) + 1);
        for i in 0..self.words.len().max(n.words.len()) {
            let word = |index: &Index| u64::from(index.words.get(i).copied().unwrap_or(0));
            let sum = word(self) + word(n) + carry;
            words.push(sum as u32);
            carry = sum >> 32;
        }
        words.push(carry as u32);
        Index::trimmed(words)
    }

    /// self − n, if it is not negative.
    pub fn minus(&self, n: &Index) -> Option<Index> {
        if *self < *n {
            return None;
        }
        let mut borrow = 0i64;
        let mut words = Vec::with_capacity(self.words.len());
        for i in 0..self.words.len() {
            let rest = i64::from(self.words[i]) - i64::from(n.words.get(i).copied().unwrap_or(0)) + borrow;
            words.push(rest as u32);
            borrow = rest >> 32;
        }
        Some(Index::trimmed(words))
    }

    /// self / 2^level as a scalar: the parameter of this index. Exact on fractions, within one unit of the last place on
    /// floats, exact there too if it has at most 53 bits.
    ///
    /// ```
    /// assert_eq!(lath::subdivide::Index::from(6).parameter::<f64>(3), 0.75);
    /// ```
    pub fn parameter<S: Scalar>(&self, level: usize) -> S {
        // From the small end: each rounding is divided away by the next division. Whole words first, then the rest.
        let base = S::from_int(1 << 32);
        let (whole, part) = (level / 32, level % 32);
        let mut sum = S::zero();
        for i in 0..whole {
            sum = (sum + S::from_int(i64::from(self.words.get(i).copied().unwrap_or(0)))) / base.clone();
        }
        let mut factor = S::one();
        for word in self.words.get(whole..).unwrap_or(&[]) {
            sum = sum + factor.clone() * S::from_int(i64::from(*word));
            factor = factor * base.clone();
        }
        sum / S::from_int(1 << part)
    }
}

impl PartialOrd for Index {
    fn partial_cmp(&self, other: &Index) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Index {
    fn cmp(&self, other: &Index) -> Ordering {
        let length = self.words.len().cmp(&other.words.len());
        length.then_with(|| self.words.iter().rev().cmp(other.words.iter().rev()))
    }
}

impl FromStr for Index {
    type Err = Error;

    /// Reads decimal digits and nothing else.
    ///
    /// # Errors
    /// S006 with the place of the first character that is no digit; S006 for no digit, or more than 10,000 of them.
    fn from_str(text: &str) -> Result<Index> {
        if let Some(place) = text.bytes().position(|byte| !byte.is_ascii_digit()) {
            return Err(Error::new(Code::S006, format!("character {place} of the index is no digit")).at(place));
        }
        let digits = text.trim_start_matches('0');
        if text.is_empty() || digits.len() > MAX_DIGITS {
            return Err(Error::new(Code::S006, format!("an index of {} digits", text.len())));
        }
        let mut words: Vec<u32> = Vec::new();
        for chunk in digits.as_bytes().chunks(9) {
            let mut carry = chunk.iter().fold(0, |n, digit| 10 * n + u64::from(digit - b'0'));
            let factor = chunk.iter().fold(1u64, |n, _| 10 * n);
            for word in &mut words {
                let product = u64::from(*word) * factor + carry;
                *word = product as u32;
                carry = product >> 32;
            }
            words.push(carry as u32);
        }
        Ok(Index::trimmed(words))
    }
}

impl fmt::Display for Index {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut words = self.words.clone();
        let mut groups: Vec<String> = Vec::new();
        while !words.is_empty() {
            let mut rest = 0u64;
            for word in words.iter_mut().rev() {
                let part = rest << 32 | u64::from(*word);
                *word = (part / 1_000_000_000) as u32;
                rest = part % 1_000_000_000;
            }
            while words.last() == Some(&0) {
                words.pop();
            }
            groups.push(if words.is_empty() { rest.to_string() } else { format!("{rest:09}") });
        }
        if groups.is_empty() {
            groups.push(String::from("0"));
        }
        groups.reverse();
        f.pad_integral(true, "", &groups.concat())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Index {
        text.parse().unwrap()
    }

    #[test]
    fn digits_come_and_go() {
        for text in ["0", "7", "4294967295", "4294967296", "1000000000", "18446744073709551616", &"9".repeat(300)] {
            assert_eq!(read(text).to_string(), text);
        }
        assert_eq!(read("000123"), Index::from(123));
        assert_eq!(read("0").to_bits(), []);
        for text in ["", "-1", "1.5", "1e3", " 1", "٣"] {
            assert_eq!(text.parse::<Index>().unwrap_err().code(), Code::S006, "{text}");
        }
        assert_eq!("1".repeat(10_001).parse::<Index>().unwrap_err().code(), Code::S006);
    }

    #[test]
    fn arithmetic_agrees_with_machine_integers() {
        let numbers = [0u64, 1, 2, 3, 0xffff_ffff, 0x1_0000_0000, 0x1_0000_0001, u64::MAX >> 1, 0xdead_beef_0000_0000];
        for a in numbers {
            let big = Index::from(a);
            assert_eq!(big.trailing_zeros(), if a == 0 { 0 } else { a.trailing_zeros() as usize });
            assert_eq!(big.bit_length(), 64 - a.leading_zeros() as usize);
            for shift in [0, 1, 31, 32, 33, 63] {
                assert_eq!(big.shifted_down(shift).to_u64(), Some(a >> shift), "{a} >> {shift}");
                assert_eq!(big.low_bits(shift).to_u64(), Some(a & ((1 << shift) - 1)), "{a} mod 2^{shift}");
                assert_eq!(big.shifted_up(shift).shifted_down(shift), big);
            }
            for b in numbers {
                assert_eq!(big.cmp(&Index::from(b)), a.cmp(&b));
                assert_eq!(big.minus(&Index::from(b)), a.checked_sub(b).map(Index::from));
                assert_eq!(big.plus(&Index::from(b)).minus(&Index::from(b)), Some(big.clone()));
            }
        }
    }

    #[test]
    fn parameters_of_many_bits_are_the_nearest_floats() {
        assert_eq!(Index::from(1).shifted_up(999).parameter::<f64>(1000), 0.5);
        assert_eq!(Index::from(1).parameter::<f64>(1000), libm::ldexp(1.0, -1000));
        let third = Index::from_bits((0..999).map(|i| i % 2 == 0));
        assert_eq!(third.parameter::<f64>(1000), 1.0 / 3.0);
        assert_eq!(Index::from(3).shifted_up(40).parameter::<f64>(33), 384.0);
    }
}
