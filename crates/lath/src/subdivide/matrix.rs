//! The little linear algebra of local matrices: products, powers, null spaces, inverses.
//!
//! Exact on fractions. On floats a pivot counts as zero when it is rounding beside the matrix's largest entry.

use crate::num::Scalar;
use crate::subdivide::scheme::{is_exact, magnitude};
use alloc::vec::Vec;

/// A dense matrix by rows.
pub(crate) type Matrix<S> = Vec<Vec<S>>;

pub(crate) fn identity<S: Scalar>(n: usize) -> Matrix<S> {
    (0..n).map(|i| (0..n).map(|j| if i == j { S::one() } else { S::zero() }).collect()).collect()
}

pub(crate) fn product<S: Scalar>(a: &Matrix<S>, b: &Matrix<S>) -> Matrix<S> {
    let columns = b.first().map_or(0, Vec::len);
    let entry =
        |row: &[S], j: usize| row.iter().zip(b).fold(S::zero(), |sum, (x, other)| sum + x.clone() * other[j].clone());
    a.iter().map(|row| (0..columns).map(|j| entry(row, j)).collect()).collect()
}

/// A · v.
pub(crate) fn applied<S: Scalar>(a: &Matrix<S>, v: &[S]) -> Vec<S> {
    a.iter().map(|row| row.iter().zip(v).fold(S::zero(), |sum, (x, y)| sum + x.clone() * y.clone())).collect()
}

/// Aᵐ by repeated squaring.
pub(crate) fn power<S: Scalar>(a: &Matrix<S>, mut exponent: usize) -> Matrix<S> {
    let (mut square, mut result) = (a.clone(), identity(a.len()));
    while exponent > 0 {
        if exponent & 1 == 1 {
            result = product(&result, &square);
        }
        exponent >>= 1;
        if exponent > 0 {
            square = product(&square, &square);
        }
    }
    result
}

/// A − μ.
pub(crate) fn shifted<S: Scalar>(a: &Matrix<S>, eigenvalue: &S) -> Matrix<S> {
    let mut a = a.clone();
    for (i, row) in a.iter_mut().enumerate() {
        row[i] = row[i].clone() - eigenvalue.clone();
    }
    a
}

/// Gauss–Jordan elimination with the largest pivot of each column; the columns that have a pivot.
fn eliminate<S: Scalar>(a: &mut Matrix<S>, columns: usize) -> Vec<usize> {
    let largest = a.iter().flatten().fold(S::zero(), |most, x| if magnitude(x) > most { magnitude(x) } else { most });
    let slack = if is_exact::<S>() { S::zero() } else { largest / S::from_int(1 << 40) };
    let mut pivots: Vec<usize> = Vec::new();
    for column in 0..columns {
        let done = pivots.len();
        let Some(best) = (done..a.len()).fold(None, |best: Option<usize>, i| match best {
            Some(b) if magnitude(&a[b][column]) >= magnitude(&a[i][column]) => Some(b),
            _ => Some(i),
        }) else {
            break;
        };
        if magnitude(&a[best][column]) <= slack {
            continue;
        }
        a.swap(done, best);
        let pivot = a[done][column].clone();
        a[done].iter_mut().for_each(|x| *x = x.clone() / pivot.clone());
        let row = a[done].clone();
        for (i, other) in a.iter_mut().enumerate() {
            if i != done && !other[column].is_zero() {
                let factor = other[column].clone();
                for (x, y) in other.iter_mut().zip(&row) {
                    *x = x.clone() - factor.clone() * y.clone();
                }
            }
        }
        pivots.push(column);
    }
    pivots
}

/// A basis of the vectors that A sends to zero; each basis vector has a 1 in the last of its own places.
pub(crate) fn null_space<S: Scalar>(mut a: Matrix<S>) -> Vec<Vec<S>> {
    let n = a.first().map_or(0, Vec::len);
    let pivots = eliminate(&mut a, n);
    let free = (0..n).filter(|column| !pivots.contains(column));
    let vector = |column: usize| {
        let mut v = alloc::vec![S::zero(); n];
        v[column] = S::one();
        for (row, pivot) in pivots.iter().enumerate() {
            v[*pivot] = -a[row][column].clone();
        }
        v
    };
    free.map(vector).collect()
}

/// The number of independent rows.
pub(crate) fn rank<S: Scalar>(mut a: Matrix<S>) -> usize {
    let n = a.first().map_or(0, Vec::len);
    eliminate(&mut a, n).len()
}

/// A⁻¹; none if A is singular.
pub(crate) fn inverse<S: Scalar>(a: &Matrix<S>) -> Option<Matrix<S>> {
    let n = a.len();
    let mut wide: Matrix<S> = a.iter().zip(identity(n)).map(|(row, unit)| [row.clone(), unit].concat()).collect();
    (eliminate(&mut wide, n).len() == n).then(|| wide.into_iter().map(|row| row[n..].to_vec()).collect())
}
