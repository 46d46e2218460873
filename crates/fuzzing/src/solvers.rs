//! Banded and cyclic systems of any entries.

use crate::tape::Tape;
use lath::num::{Banded, CyclicBanded};

/// Fills a system and solves it: an answer or an error. An answer to finite entries may overflow, and its callers look.
pub fn solve(tape: &mut Tape<'_>) {
    let (n, lower, upper) = (tape.below(9), tape.below(5), tape.below(5));
    let count = if tape.below(8) == 0 { tape.below(9) } else { n };
    let mut sides = tape.rows::<2>(count);
    if tape.flip() {
        let mut system = CyclicBanded::new(n, lower, upper);
        for row in 0..n {
            for offset in -(lower as isize)..=upper as isize {
                assert!(system.add(row, offset, tape.float()), "row {row}, offset {offset}");
            }
        }
        let _ = system.solve(&mut sides);
        return;
    }
    let mut system = Banded::new(n, lower, upper);
    for row in 0..n {
        for column in row.saturating_sub(lower)..n.min(row + upper + 1) {
            let x = tape.float();
            assert!(system.set(row, column, x), "row {row}, column {column}");
            assert_eq!(system.get(row, column).to_bits(), x.to_bits());
        }
    }
    if let Ok(factored) = system.factor() {
        let _ = factored.solve(&mut sides);
    }
}
