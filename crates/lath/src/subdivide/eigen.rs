//! The eigen-analysis of a scheme's local matrix: A = Q J Q⁻¹.

use crate::error::{Code, Error, Result};
use crate::num::Scalar;
use crate::subdivide::jordan::chains;
use crate::subdivide::matrix::{Matrix, inverse};
use crate::subdivide::roots::{characteristic, estimated_roots, rational_roots};
use crate::subdivide::scheme::{Scheme, is_exact};
use alloc::format;
use alloc::vec::Vec;

/// The greatest degree whose eigenvectors are looked for: on fractions it takes about a second.
const MAX_SIZE: usize = 32;

/// A = Q J Q⁻¹ for the local matrix A of a scheme.
#[derive(Clone, Debug, PartialEq)]
pub struct Eigen<S = f64> {
    /// The eigenvalues in the order of Q's columns, ascending, each as often as it occurs.
    pub eigenvalues: Vec<S>,
    /// The sizes of the Jordan blocks, in the same order; all 1 if A is diagonalizable.
    pub blocks: Vec<usize>,
    /// Columns are eigenvectors, then generalized ones within a block; each eigenvector ends in 1 where it can.
    pub q: Vec<Vec<S>>,
    /// The inverse of Q: its rows are left eigenvectors, at the ends of their blocks.
    pub q_inverse: Vec<Vec<S>>,
    /// J: the eigenvalues on the diagonal, and 1 above it within a block.
    pub jordan: Vec<Vec<S>>,
}

impl<S: Scalar> Eigen<S> {
    /// Whether the matrix is defective: it has no basis of eigenvectors.
    pub fn is_defective(&self) -> bool {
        self.blocks.iter().any(|size| *size > 1)
    }
}

/// What is known of a local matrix.
#[derive(Clone, Debug, PartialEq)]
pub enum Form<S = f64> {
    /// All eigenvalues are rational: the decomposition, exact on fractions.
    Exact(Eigen<S>),
    /// Some eigenvalue is not rational, or the scalar rounds: estimates [real, imaginary] of all, ascending by their real part.
    Numeric(Vec<[f64; 2]>),
}

impl<S: Scalar> Scheme<S> {
    /// The eigenvalues and eigenvectors of the local matrix, or its Jordan form if there are too few eigenvectors.
    ///
    /// On fractions the answer is exact whenever all eigenvalues are rational. On floats it is given for Lane–Riesenfeld
    /// schemes, whose eigenvalues 1, ½, …, 2¹⁻ᵖ are known; others get estimates of their eigenvalues.
    ///
    /// *Cost.* O(p⁴) for Lane–Riesenfeld schemes, O(p⁵) for others.
    ///
    /// ```
    /// use lath::subdivide::{Form, Scheme};
    ///
    /// let Form::Exact(eigen) = Scheme::<f64>::cubic().eigen()? else { panic!() };
    /// assert_eq!(eigen.eigenvalues, [0.25, 0.5, 1.0]);
    /// assert_eq!(eigen.q, [[1.0, -1.0, 1.0], [-0.5, 0.0, 1.0], [1.0, 1.0, 1.0]]);
    /// # Ok::<(), lath::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// S002 for a degree above 32; P003 for a mask so large that floats cannot hold its characteristic polynomial.
    pub fn eigen(&self) -> Result<Form<S>> {
        let p = self.degree();
        if p > MAX_SIZE {
            return Err(Error::new(Code::S002, format!("the eigen-analysis of degree {p}; it stops at {MAX_SIZE}")));
        }
        let a = self.local_matrix();
        if self.is_spline() {
            let halves = |j: usize| (0..j).fold(S::one(), |x, _| x / S::from_int(2));
            let known: Vec<(S, usize)> = (0..p).rev().map(|j| (halves(j), 1)).collect();
            let estimate = || (0..p).rev().map(|j| [libm::ldexp(1.0, -(j as i32)), 0.0]).collect();
            return Ok(decomposed(&a, &known).map_or_else(|| Form::Numeric(estimate()), Form::Exact));
        }
        let (polynomial, exact) = (characteristic(&a), is_exact::<S>());
        if exact {
            let roots = rational_roots(&polynomial);
            let sorted = roots.map(|mut roots| {
                roots.sort_by(|x, y| x.0.partial_cmp(&y.0).unwrap_or(core::cmp::Ordering::Equal));
                roots
            });
            if let Some(eigen) = sorted.and_then(|roots| decomposed(&a, &roots)) {
                return Ok(Form::Exact(eigen));
            }
        }
        let mut estimates = estimated_roots(&polynomial, exact);
        if estimates.iter().flatten().any(|x| !x.is_finite()) {
            return Err(Error::new(Code::P003, "the mask's numbers are too large for its eigenvalues to be estimated"));
        }
        estimates.sort_by(|x, y| x[0].total_cmp(&y[0]).then(x[1].total_cmp(&y[1])));
        Ok(Form::Numeric(estimates))
    }
}

/// Q, J and Q⁻¹ from the eigenvalues with their multiplicities; none if rounding hides the eigenvectors.
fn decomposed<S: Scalar>(a: &Matrix<S>, roots: &[(S, usize)]) -> Option<Eigen<S>> {
    let n = a.len();
    let (mut columns, mut eigenvalues, mut blocks) = (Vec::new(), Vec::new(), Vec::new());
    for (root, multiplicity) in roots {
        for chain in chains(a, root, *multiplicity) {
            blocks.push(chain.len());
            eigenvalues.extend(core::iter::repeat_n(root.clone(), chain.len()));
            columns.extend(chain);
        }
    }
    if columns.len() != n {
        return None;
    }
    let q: Matrix<S> = (0..n).map(|i| columns.iter().map(|v: &Vec<S>| v[i].clone()).collect()).collect();
    let q_inverse = inverse(&q)?;
    let mut jordan = alloc::vec![alloc::vec![S::zero(); n]; n];
    let mut start = 0;
    for size in &blocks {
        for i in start..start + size {
            jordan[i][i] = eigenvalues[i].clone();
            if i > start {
                jordan[i - 1][i] = S::one();
            }
        }
        start += size;
    }
    Some(Eigen { eigenvalues, blocks, q, q_inverse, jordan })
}
