//! Banded linear systems by elimination with exchange of rows.

use crate::error::{Code, Count, Error, Result};
use crate::num::Scalar;
use crate::num::banded::Banded;
use alloc::format;

/// A square matrix as [`Banded`], for systems that are neither diagonally dominant nor totally positive: rows of derivatives
/// among rows of values.
///
/// *Idea.* Partial pivoting inside the band: of the rows that still have an entry in a column, the one with the greatest comes first, among
/// equals the uppermost. The upper band grows by the lower one. Which row that is depends on nothing but the numbers, so that the order
/// of operations, and every bit, is the same everywhere.
///
/// *Cost.* O(n · lower · (lower + upper)); memory n · (2 lower + upper + 1). About twice [`Banded`] for equal bands.
///
/// *Error.* Exact over fractions. In floating point the backward error is a few u · (lower + upper) times the growth of the entries,
/// which stays near 1 in practice; rows should be scaled to one size.
///
/// *Source.* J. Wilkinson 1961; in a band as LAPACK's `gbsv`.
///
/// ```
/// use lath::num::PivotedBanded;
///
/// // [0 1; 1 0] x = [2; 3] has no pivot in the given order.
/// let mut matrix = PivotedBanded::new(2, 1, 1);
/// matrix.set(0, 1, 1.0);
/// matrix.set(1, 0, 1.0);
/// let mut x = [[2.0], [3.0]];
/// matrix.solve(&mut x)?;
/// assert_eq!(x, [[3.0], [2.0]]);
/// # Ok::<(), lath::error::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct PivotedBanded<S> {
    lower: usize,
    upper: usize,
    /// With room above for what the exchanges bring in.
    rows: Banded<S>,
}

impl<S: Scalar> PivotedBanded<S> {
    /// The zero matrix of n rows with the given numbers of diagonals beside the main one.
    pub fn new(n: usize, lower: usize, upper: usize) -> PivotedBanded<S> {
        PivotedBanded { lower, upper, rows: Banded::new(n, lower, lower.saturating_add(upper)) }
    }

    /// Sets entry (i, j). Returns false, and changes nothing, outside the band.
    pub fn set(&mut self, i: usize, j: usize, value: S) -> bool {
        j <= i.saturating_add(self.upper) && self.rows.set(i, j, value)
    }

    /// Replaces the right-hand side by the solution, all W columns at once.
    ///
    /// # Errors
    /// N001 with the column in which every pivot vanished or is not finite; P005 if the right-hand side has another number of rows.
    pub fn solve<const W: usize>(mut self, rhs: &mut [[S; W]]) -> Result<()> {
        let (n, reach) = (self.rows.size(), self.lower.saturating_add(self.upper));
        if rhs.len() != n {
            return Err(Error::new(
                Code::P005,
                format!("{} for {}", Count(rhs.len(), "right-hand side"), Count(n, "row")),
            ));
        }
        let below = |k: usize| n.min(k.saturating_add(self.lower).saturating_add(1));
        let right = |k: usize| n.min(k.saturating_add(reach).saturating_add(1));
        for k in 0..n {
            let mut best = (k, magnitude(self.rows.get(k, k)));
            for i in k + 1..below(k) {
                let size = magnitude(self.rows.get(i, k));
                if size > best.1 {
                    best = (i, size);
                }
            }
            if best.0 != k {
                for j in k..right(k) {
                    let (above, under) = (self.rows.get(k, j), self.rows.get(best.0, j));
                    self.rows.set(k, j, under);
                    self.rows.set(best.0, j, above);
                }
                rhs.swap(k, best.0);
            }
            let pivot = self.rows.get(k, k);
            if pivot.is_zero() || !pivot.is_finite() {
                return Err(Error::new(Code::N001, format!("the pivot of column {k} is {pivot:?}")).at(k));
            }
            for i in k + 1..below(k) {
                let entry = self.rows.get(i, k);
                if entry.is_zero() {
                    continue;
                }
                let factor = entry / pivot.clone();
                for j in k + 1..right(k) {
                    let rest = self.rows.get(i, j) - factor.clone() * self.rows.get(k, j);
                    self.rows.set(i, j, rest);
                }
                for c in 0..W {
                    rhs[i][c] = rhs[i][c].clone() - factor.clone() * rhs[k][c].clone();
                }
            }
        }
        for i in (0..n).rev() {
            for j in i + 1..right(i) {
                let factor = self.rows.get(i, j);
                for c in 0..W {
                    rhs[i][c] = rhs[i][c].clone() - factor.clone() * rhs[j][c].clone();
                }
            }
            let pivot = self.rows.get(i, i);
            for x in &mut rhs[i] {
                *x = x.clone() / pivot.clone();
            }
        }
        Ok(())
    }
}

fn magnitude<S: Scalar>(x: S) -> S {
    if x < S::zero() { -x } else { x }
}
