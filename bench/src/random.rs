//! Random numbers that are the same on every machine.

/// SplitMix64 (G. Steele, D. Lea, C. Flood 2014).
pub(crate) struct Random(u64);

impl Random {
    pub(crate) fn new(seed: u64) -> Random {
        Random(seed)
    }

    /// Uniform in [0, 1), a multiple of 2⁻⁵³.
    pub(crate) fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// One of 0, 1, …, n − 1.
    pub(crate) fn below(&mut self, n: usize) -> usize {
        (self.unit() * n as f64) as usize
    }

    /// n points of a random walk in space, each coordinate of a step uniform in [−1, 1).
    pub(crate) fn walk(&mut self, n: usize) -> Vec<[f64; 3]> {
        let mut at = [0.0; 3];
        let mut step = || {
            at = at.map(|x| x + 2.0 * self.unit() - 1.0);
            at
        };
        (0..n).map(|_| step()).collect()
    }
}
