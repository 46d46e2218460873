//! Banded systems that close around the corner, by bordering.

use crate::error::{Code, Count, Error, Result};
use crate::num::Scalar;
use crate::num::banded::Banded;
use alloc::format;
use alloc::vec::Vec;

/// A square matrix whose band wraps around: column indices are taken modulo n.
///
/// *Idea.* Bordering. With k = max(lower, upper), the last k rows and columns are set apart; what remains is [`Banded`].
/// Its solution for the k border columns gives a k × k system for the last unknowns (the Schur complement, solved with
/// partial pivoting), and those give the rest.
///
/// *Cost.* O(n k (lower + upper)): linear in n. Memory O(n k).
///
/// ```
/// use lath::num::CyclicBanded;
///
/// // Each row 1 4 1, wrapped around: the slopes of a closed cubic spline.
/// let mut matrix = CyclicBanded::new(4, 1, 1);
/// for i in 0..4 {
///     for (offset, value) in [(-1, 1.0), (0, 4.0), (1, 1.0)] {
///         matrix.add(i, offset, value);
///     }
/// }
/// let mut x = [[3.0], [0.0], [-3.0], [0.0]];
/// matrix.solve(&mut x)?;
/// assert!((x[0][0] - 0.75).abs() < 1e-15 && x[1][0].abs() < 1e-15);
/// # Ok::<(), lath::error::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct CyclicBanded<S> {
    n: usize,
    /// The number of bordering rows and columns.
    k: usize,
    inner: Banded<S>,
    /// Border columns, each of n − k entries.
    columns: Vec<Vec<[S; 1]>>,
    /// Border rows, each of n entries: the last k are the corner.
    rows: Vec<Vec<S>>,
}

impl<S: Scalar> CyclicBanded<S> {
    /// The zero matrix of n rows with the given numbers of diagonals beside the main one.
    pub fn new(n: usize, lower: usize, upper: usize) -> CyclicBanded<S> {
        let k = lower.max(upper).min(n);
        CyclicBanded {
            n,
            k,
            inner: Banded::new(n - k, lower, upper),
            columns: alloc::vec![alloc::vec![[S::zero()]; n - k]; k],
            rows: alloc::vec![alloc::vec![S::zero(); n]; k],
        }
    }

    /// Adds to entry (row, row + offset modulo n). Where the band is so wide that it meets itself, both shares count.
    ///
    /// Returns false, and changes nothing, for a row or an offset beyond the matrix.
    pub fn add(&mut self, row: usize, offset: isize, value: S) -> bool {
        if row >= self.n {
            return false;
        }
        let column = (row as isize + offset).rem_euclid(self.n as isize) as usize;
        let inner = self.n - self.k;
        let slot = if row >= inner {
            &mut self.rows[row - inner][column]
        } else if column >= inner {
            &mut self.columns[column - inner][row][0]
        } else {
            let sum = self.inner.get(row, column) + value;
            return self.inner.set(row, column, sum);
        };
        *slot = slot.clone() + value;
        true
    }

    /// Replaces the right-hand side by the solution, all W columns at once.
    ///
    /// # Errors
    /// N001 if the matrix is singular; P005 if the right-hand side has another number of rows.
    pub fn solve<const W: usize>(self, rhs: &mut [[S; W]]) -> Result<()> {
        let (n, k, inner) = (self.n, self.k, self.n - self.k);
        if rhs.len() != n {
            return Err(Error::new(
                Code::P005,
                format!("{} for {}", Count(rhs.len(), "right-hand side"), Count(n, "row")),
            ));
        }
        let (head, tail) = rhs.split_at_mut(inner);
        let factored = self.inner.factor()?;
        factored.solve(head)?;
        let mut columns = self.columns;
        for column in &mut columns {
            factored.solve(column)?;
        }
        // Schur complement: corner − row · columns, and its right-hand side.
        let mut corner = alloc::vec![alloc::vec![S::zero(); k]; k];
        for i in 0..k {
            let row = &self.rows[i];
            corner[i].clone_from_slice(&row[inner..]);
            for m in 0..inner {
                if row[m].is_zero() {
                    continue;
                }
                for j in 0..k {
                    corner[i][j] = corner[i][j].clone() - row[m].clone() * columns[j][m][0].clone();
                }
                for c in 0..W {
                    tail[i][c] = tail[i][c].clone() - row[m].clone() * head[m][c].clone();
                }
            }
        }
        solve_dense(&mut corner, tail)?;
        for (j, column) in columns.iter().enumerate() {
            for m in 0..inner {
                for c in 0..W {
                    head[m][c] = head[m][c].clone() - column[m][0].clone() * tail[j][c].clone();
                }
            }
        }
        Ok(())
    }
}

/// Gauss elimination with partial pivoting, for the few unknowns of a corner.
fn solve_dense<S: Scalar, const W: usize>(matrix: &mut [Vec<S>], rhs: &mut [[S; W]]) -> Result<()> {
    let k = matrix.len();
    let magnitude = |x: &S| {
        if *x < S::zero() { -x.clone() } else { x.clone() }
    };
    for p in 0..k {
        let mut best = p;
        for i in p + 1..k {
            if magnitude(&matrix[i][p]) > magnitude(&matrix[best][p]) {
                best = i;
            }
        }
        matrix.swap(p, best);
        rhs.swap(p, best);
        let pivot = matrix[p][p].clone();
        if pivot.is_zero() || !pivot.is_finite() {
            return Err(Error::new(Code::N001, format!("the corner's pivot {p} is {pivot:?}")).at(p));
        }
        for i in (0..k).filter(|&i| i != p) {
            let factor = matrix[i][p].clone() / pivot.clone();
            for j in p..k {
                matrix[i][j] = matrix[i][j].clone() - factor.clone() * matrix[p][j].clone();
            }
            for c in 0..W {
                rhs[i][c] = rhs[i][c].clone() - factor.clone() * rhs[p][c].clone();
            }
        }
    }
    for p in 0..k {
        for c in 0..W {
            rhs[p][c] = rhs[p][c].clone() / matrix[p][p].clone();
        }
    }
    Ok(())
}
