//! Bytes as decisions and numbers.
//!
//! A decoder for fuzzers wants two things of its bytes: a small change of them is a small change of what they say, and what they
//! say is often troublesome. So every number begins with a byte that chooses a sort: small quarters (which meet each other
//! often), the edges of the range, the last number moved by a few units in the last place, a few bits at any exponent, any
//! 64 bits. Behind the end of the tape stand zeros, so that every decoding ends.

/// Numbers that have broken something somewhere.
const EDGES: [f64; 24] = [
    0.0,
    -0.0,
    5e-324,
    -5e-324,
    f64::MIN_POSITIVE,
    f64::EPSILON,
    1e-300,
    -1e-300,
    1e-150,
    1e-12,
    0.1,
    1.0 / 3.0,
    1.0 - f64::EPSILON / 2.0,
    1.0 + f64::EPSILON,
    1e15 + 0.3,
    9007199254740993.0,
    1e150,
    -1e150,
    1e300,
    -1e300,
    f64::MAX,
    f64::INFINITY,
    f64::NEG_INFINITY,
    f64::NAN,
];

/// A tape of bytes, read from its start.
#[derive(Clone, Copy, Debug)]
pub struct Tape<'a> {
    bytes: &'a [u8],
    last: f64,
}

impl<'a> Tape<'a> {
    /// The tape at its start.
    #[must_use]
    pub fn new(bytes: &'a [u8]) -> Tape<'a> {
        Tape { bytes, last: 0.0 }
    }

    /// True where everything has been read.
    #[must_use]
    pub fn is_at_end(&self) -> bool {
        self.bytes.is_empty()
    }

    /// The next byte, or 0.
    pub fn byte(&mut self) -> u8 {
        let Some((first, rest)) = self.bytes.split_first() else { return 0 };
        self.bytes = rest;
        *first
    }

    /// A number below `n`, for n from 1 to 256.
    pub fn below(&mut self, n: usize) -> usize {
        usize::from(self.byte()) % n
    }

    /// Yes or no.
    pub fn flip(&mut self) -> bool {
        self.byte() & 1 == 1
    }

    /// Any double, the troublesome ones often.
    pub fn float(&mut self) -> f64 {
        let sort = self.byte();
        self.last = match sort {
            0..=167 => (f64::from(sort) - 64.0) / 4.0,
            168..=207 => EDGES[usize::from(sort - 168) % EDGES.len()],
            208..=223 => (208..=sort).fold(self.last, |x, _| x.next_up()),
            224..=231 => (224..=sort).fold(self.last, |x, _| x.next_down()),
            232..=247 => {
                // A few bits at any exponent; of the sort one bit is the sign.
                let (fraction, exponent) = (u64::from(self.byte()), u64::from(self.byte()));
                f64::from_bits((u64::from(sort) & 1) << 63 | (exponent << 55 | fraction << 47) & !(1 << 63))
            }
            248..=255 => f64::from_bits(u64::from_le_bytes(std::array::from_fn(|_| self.byte()))),
        };
        self.last
    }

    /// A double that is not NaN nor infinite.
    pub fn finite(&mut self) -> f64 {
        let x = self.float();
        if x.is_finite() { x } else { 1.0 }
    }

    /// `n` points.
    pub fn rows<const D: usize>(&mut self, n: usize) -> Vec<[f64; D]> {
        (0..n).map(|_| std::array::from_fn(|_| self.float())).collect()
    }

    /// `n` weights: mostly positive, seldom zero, seldom any number at all.
    pub fn weights(&mut self, n: usize) -> Vec<f64> {
        let weight = |tape: &mut Self| match tape.byte() {
            0..=15 => 0.0,
            16..=47 => tape.float(),
            sort => f64::from(sort - 47) / 16.0,
        };
        (0..n).map(|_| weight(self)).collect()
    }

    /// `n` numbers, mostly increasing: each is a step above the one before, seldom none, seldom any number at all.
    pub fn increasing(&mut self, n: usize) -> Vec<f64> {
        let mut t: f64 = if self.flip() { self.float() } else { 0.0 };
        (0..n)
            .map(|_| {
                let here = t;
                let sort = self.byte();
                t = match sort {
                    0..=31 => t,
                    32..=127 => t + f64::from(sort - 31) / 4.0,
                    128..=159 => (128..=sort & !3).fold(t, |t, _| t.next_up()),
                    160..=191 => t + f64::from(sort - 159) * 1e-12,
                    192..=215 => t + f64::from_bits(u64::from(self.byte()) << 55),
                    216..=235 => t + self.finite().abs(),
                    _ => self.float(),
                };
                here
            })
            .collect()
    }
}
