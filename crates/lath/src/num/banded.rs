//! Banded linear systems by elimination without pivoting.

use crate::error::{Code, Count, Error, Result};
use crate::num::Scalar;
use alloc::format;
use alloc::vec::Vec;

/// A square matrix that is zero more than `lower` places below and `upper` places above the diagonal.
///
/// *Idea.* LU factorisation inside the band. Without pivoting it is stable for diagonally dominant matrices (the growth
/// factor is at most 2) and for totally positive ones (no growth at all: de Boor and Pinkus 1977, "Backward error analysis
/// for totally positive linear systems"); the systems of spline interpolation are of these kinds.
///
/// *Cost.* O(n · lower · upper) to factor, O(n · (lower + upper) · W) to solve for W columns at once; memory n · (lower + upper + 1).
///
/// *Error.* Exact over fractions. In floating point the backward error is a few u · (lower + upper) for the two kinds above.
///
/// ```
/// use lath::num::Banded;
///
/// // [2 1; 1 2] x = [3; 3]
/// let mut matrix = Banded::new(2, 1, 1);
/// for i in 0..2 {
///     matrix.set(i, i, 2.0);
///     matrix.set(i, 1 - i, 1.0);
/// }
/// let mut x = [[3.0], [3.0]];
/// matrix.factor()?.solve(&mut x)?;
/// assert_eq!(x, [[1.0], [1.0]]);
/// # Ok::<(), lath::error::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Banded<S> {
    n: usize,
    lower: usize,
    upper: usize,
    rows: Vec<S>,
}

impl<S: Scalar> Banded<S> {
    /// The zero matrix of n rows with the given numbers of diagonals beside the main one.
    pub fn new(n: usize, lower: usize, upper: usize) -> Banded<S> {
        let (lower, upper) = (lower.min(n.saturating_sub(1)), upper.min(n.saturating_sub(1)));
        Banded { n, lower, upper, rows: alloc::vec![S::zero(); n * (lower + upper + 1)] }
    }

    /// The number of rows.
    pub fn size(&self) -> usize {
        self.n
    }

    /// The place of entry (i, j) in `rows`, if it is inside the band.
    fn place(&self, i: usize, j: usize) -> Option<usize> {
        (i < self.n && j < self.n && j + self.lower >= i && j <= i + self.upper)
            .then(|| i * (self.lower + self.upper + 1) + (j + self.lower - i))
    }

    /// Sets entry (i, j). Returns false, and changes nothing, outside the band.
    pub fn set(&mut self, i: usize, j: usize, value: S) -> bool {
        match self.place(i, j) {
            Some(k) => {
                self.rows[k] = value;
                true
            }
            None => false,
        }
    }

    /// Entry (i, j); zero outside the band.
    pub fn get(&self, i: usize, j: usize) -> S {
        self.place(i, j).map_or_else(S::zero, |k| self.rows[k].clone())
    }

    /// Factors the matrix in place.
    ///
    /// # Errors
    /// N001 with the row whose pivot vanished or is not finite.
    pub fn factor(mut self) -> Result<Factored<S>> {
        let width = self.lower + self.upper + 1;
        for k in 0..self.n {
            let pivot = self.rows[k * width + self.lower].clone();
            if pivot.is_zero() || !pivot.is_finite() {
                return Err(Error::new(Code::N001, format!("the pivot of row {k} is {pivot:?}")).at(k));
            }
            for i in k + 1..self.n.min(k + self.lower + 1) {
                let at = i * width + (k + self.lower - i);
                if self.rows[at].is_zero() {
                    continue;
                }
                let factor = self.rows[at].clone() / pivot.clone();
                for j in 1..=self.upper.min(self.n - 1 - k) {
                    let above = self.rows[k * width + self.lower + j].clone();
                    self.rows[at + j] = self.rows[at + j].clone() - factor.clone() * above;
                }
                self.rows[at] = factor;
            }
        }
        Ok(Factored(self))
    }
}

/// A factored [`Banded`] matrix, ready for any number of right-hand sides.
#[derive(Clone, Debug)]
pub struct Factored<S>(Banded<S>);

impl<S: Scalar> Factored<S> {
    /// Replaces the right-hand side by the solution; all W columns in one sweep down and one up.
    ///
    /// # Errors
    /// P005 if the right-hand side has another number of rows than the matrix.
    pub fn solve<const W: usize>(&self, rhs: &mut [[S; W]]) -> Result<()> {
        let Banded { n, lower, upper, rows } = &self.0;
        if rhs.len() != *n {
            return Err(Error::new(
                Code::P005,
                format!("{} for {}", Count(rhs.len(), "right-hand side"), Count(*n, "row")),
            ));
        }
        let width = lower + upper + 1;
        for i in 0..*n {
            for j in i.saturating_sub(*lower)..i {
                subtract(rhs, i, j, &rows[i * width + (j + lower - i)]);
            }
        }
        for i in (0..*n).rev() {
            for j in i + 1..(*n).min(i + upper + 1) {
                subtract(rhs, i, j, &rows[i * width + (j + lower - i)]);
            }
            let pivot = &rows[i * width + lower];
            for x in &mut rhs[i] {
                *x = x.clone() / pivot.clone();
            }
        }
        Ok(())
    }
}

/// rhs[i] −= factor · rhs[j].
fn subtract<S: Scalar, const W: usize>(rhs: &mut [[S; W]], i: usize, j: usize, factor: &S) {
    for c in 0..W {
        rhs[i][c] = rhs[i][c].clone() - factor.clone() * rhs[j][c].clone();
    }
}
