//! Marks that would hide one another, and may as well be left out.

use crate::path::Point;
use std::collections::HashSet;

/// Up to so many marks, only those on the same spot are left out.
const FEW: usize = 20_000;

/// Lets through one mark for each cell of a square grid.
pub(crate) struct Thin {
    cell: f64,
    taken: HashSet<(i64, i64)>,
}

impl Thin {
    /// For this many marks, each `size` px across: cells of a quarter px, or, in a crowd that is solid anyway, of a mark.
    pub(crate) fn new(count: usize, size: f64) -> Thin {
        Thin { cell: if count <= FEW { 0.25 } else { size }, taken: HashSet::new() }
    }

    /// Whether a mark here would be the first in its cell; never for a place that is not finite.
    pub(crate) fn lets(&mut self, p: Point) -> bool {
        let [x, y] = p.map(|x| (x / self.cell).round());
        x.is_finite() && y.is_finite() && self.taken.insert((x as i64, y as i64))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn crowds_are_thinned_and_few_are_kept() {
        let mut thin = Thin::new(3, 2.0);
        assert!(thin.lets([1.0, 1.0]) && thin.lets([1.5, 1.0]) && !thin.lets([1.01, 1.0]));
        assert!(!thin.lets([f64::NAN, 1.0]) && !thin.lets([1.0, f64::INFINITY]));
        let mut thin = Thin::new(1_000_000, 2.0);
        assert_eq!(
            (0..1_000_000).filter(|&i| thin.lets([f64::from(i % 100), f64::from(i / 100 % 100)])).count(),
            51 * 51
        );
    }
}
