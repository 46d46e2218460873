//! Dense matrices of fractions.

use crate::rational::Rational;
use lath::num::Scalar;

/// A matrix of fractions, by rows.
///
/// ```
/// use lath_exact::Matrix;
///
/// let a = Matrix::from_ints(&[&[2, 1], &[1, 1]]);
/// assert_eq!(a.product(&a.inverse().unwrap()).unwrap(), Matrix::identity(2));
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Matrix {
    rows: Vec<Vec<Rational>>,
    columns: usize,
}

impl Matrix {
    /// From rows of equal length; none if they differ.
    pub fn from_rows(rows: Vec<Vec<Rational>>) -> Option<Matrix> {
        let columns = rows.first().map_or(0, Vec::len);
        rows.iter().all(|row| row.len() == columns).then_some(Matrix { rows, columns })
    }

    /// Entry (i, j) is `entry(i, j)`.
    pub fn from_fn(rows: usize, columns: usize, mut entry: impl FnMut(usize, usize) -> Rational) -> Matrix {
        let row = |i: usize| (0..columns).map(|j| entry(i, j)).collect();
        Matrix { rows: (0..rows).map(row).collect(), columns }
    }

    /// From integers; short rows are filled with zeros.
    pub fn from_ints(rows: &[&[i64]]) -> Matrix {
        let columns = rows.iter().map(|row| row.len()).max().unwrap_or(0);
        Matrix::from_fn(rows.len(), columns, |i, j| Rational::from(rows[i].get(j).copied().unwrap_or(0)))
    }

    /// Ones on the diagonal.
    pub fn identity(n: usize) -> Matrix {
        Matrix::from_fn(n, n, |i, j| Rational::from(i64::from(i == j)))
    }

    /// The rows.
    pub fn rows(&self) -> &[Vec<Rational>] {
        &self.rows
    }

    /// The number of columns.
    pub fn columns(&self) -> usize {
        self.columns
    }

    /// All entries, row by row.
    pub fn entries(&self) -> impl Iterator<Item = &Rational> {
        self.rows.iter().flatten()
    }

    /// The matrix with rows and columns exchanged.
    pub fn transposed(&self) -> Matrix {
        Matrix::from_fn(self.columns, self.rows.len(), |i, j| self.rows[j][i].clone())
    }

    /// Every entry times the factor.
    pub fn scaled(&self, factor: &Rational) -> Matrix {
        Matrix::from_fn(self.rows.len(), self.columns, |i, j| &self.rows[i][j] * factor)
    }

    /// self · other; none if the sizes do not fit.
    pub fn product(&self, other: &Matrix) -> Option<Matrix> {
        (self.columns == other.rows.len()).then(|| {
            Matrix::from_fn(self.rows.len(), other.columns, |i, j| {
                let terms = self.rows[i].iter().zip(&other.rows);
                terms.filter(|(a, row)| !a.is_zero() && !row[j].is_zero()).map(|(a, row)| a * &row[j]).sum()
            })
        })
    }

    /// self · vector; none if the sizes do not fit.
    pub fn applied(&self, vector: &[Rational]) -> Option<Vec<Rational>> {
        let dot = |row: &Vec<Rational>| row.iter().zip(vector).map(|(a, x)| a * x).sum();
        (self.columns == vector.len()).then(|| self.rows.iter().map(dot).collect())
    }

    /// The number of independent rows.
    pub fn rank(&self) -> usize {
        let mut rows = self.rows.clone();
        eliminate(&mut rows, self.columns)
    }

    /// The inverse; none if the matrix is not square or is singular.
    ///
    /// *Cost.* O(n³) operations on fractions whose digits grow with n.
    pub fn inverse(&self) -> Option<Matrix> {
        let n = self.columns;
        if self.rows.len() != n {
            return None;
        }
        let unit = Matrix::identity(n);
        let mut rows: Vec<Vec<Rational>> =
            self.rows.iter().zip(unit.rows).map(|(row, unit)| [row.clone(), unit].concat()).collect();
        (eliminate(&mut rows, n) == n).then(|| {
            let rows = rows.into_iter().map(|mut row| row.split_off(n)).collect();
            Matrix { rows, columns: n }
        })
    }
}

/// Gauss–Jordan elimination in the first `columns` columns; the number of pivots. Among the possible pivots the shortest is
/// taken: fractions do not round, but they grow.
fn eliminate(rows: &mut [Vec<Rational>], columns: usize) -> usize {
    let mut done = 0;
    for column in 0..columns {
        let candidates = (done..rows.len()).filter(|&i| !rows[i][column].is_zero());
        let Some(best) = candidates.min_by_key(|&i| rows[i][column].bits()) else { continue };
        rows.swap(done, best);
        let pivot = rows[done][column].clone();
        for x in &mut rows[done] {
            *x = &*x / &pivot;
        }
        let row = rows[done].clone();
        for (i, other) in rows.iter_mut().enumerate() {
            if i == done || other[column].is_zero() {
                continue;
            }
            let factor = other[column].clone();
            for (x, y) in other.iter_mut().zip(&row).filter(|(_, y)| !y.is_zero()) {
                *x = &*x - &(&factor * y);
            }
        }
        done += 1;
    }
    done
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn products_inverses_and_ranks() {
        let a = Matrix::from_ints(&[&[0, 2, 1], &[1, 1, 0], &[3, 0, 1]]);
        let inverse = a.inverse().unwrap();
        assert_eq!(a.product(&inverse).unwrap(), Matrix::identity(3));
        assert_eq!(inverse.product(&a).unwrap(), Matrix::identity(3));
        assert_eq!(a.rank(), 3);
        let singular = Matrix::from_ints(&[&[1, 2, 3], &[4, 5, 6], &[7, 8, 9]]);
        assert!(singular.inverse().is_none());
        assert_eq!(singular.rank(), 2);
        assert_eq!(Matrix::from_ints(&[&[0, 0], &[0, 0]]).rank(), 0);
        let wide = Matrix::from_ints(&[&[1, 2, 3], &[2, 4, 7]]);
        assert_eq!((wide.rank(), wide.transposed().rank()), (2, 2));
        assert!(wide.inverse().is_none() && wide.product(&wide).is_none());
        assert_eq!(wide.applied(&[1.into(), 1.into(), 1.into()]).unwrap(), [Rational::from(6), Rational::from(13)]);
        assert!(Matrix::from_rows(vec![vec![1.into()], vec![]]).is_none());
    }
}
