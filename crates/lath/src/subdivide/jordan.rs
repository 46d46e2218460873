//! The Jordan form of a small matrix whose eigenvalues are known exactly.

use crate::num::Scalar;
use crate::subdivide::matrix::{Matrix, applied, null_space, product, rank, shifted};
use alloc::vec::Vec;

/// The chains of generalized eigenvectors for one eigenvalue, each from the eigenvector up: (A − μ) v_{i+1} = v_i. The
/// eigenvector ends in 1 where it can, the others in 0 there. Longest chains first.
pub(crate) fn chains<S: Scalar>(a: &Matrix<S>, eigenvalue: &S, multiplicity: usize) -> Vec<Vec<Vec<S>>> {
    let n = shifted(a, eigenvalue);
    if multiplicity == 1 {
        let mut single: Vec<Vec<Vec<S>>> = null_space(n).into_iter().map(|v| alloc::vec![v]).collect();
        single.iter_mut().for_each(|chain| normalize(chain));
        return single;
    }
    // kernels[j] spans what (A − μ)ʲ sends to zero.
    let mut kernels: Vec<Vec<Vec<S>>> = alloc::vec![Vec::new()];
    let mut power = n.clone();
    loop {
        let kernel = null_space(power.clone());
        let grown = kernel.len() > kernels[kernels.len() - 1].len();
        if !grown {
            break;
        }
        let full = kernel.len() >= multiplicity;
        kernels.push(kernel);
        if full {
            break;
        }
        power = product(&power, &n);
    }
    let mut found: Vec<Vec<Vec<S>>> = Vec::new();
    for height in (1..kernels.len()).rev() {
        let mut taken: Vec<Vec<S>> = kernels[height - 1].clone();
        taken.extend(found.iter().map(|chain| chain[height - 1].clone()));
        let mut size = rank(taken.clone());
        for candidate in &kernels[height] {
            taken.push(candidate.clone());
            let next = rank(taken.clone());
            if next == size {
                taken.pop();
                continue;
            }
            size = next;
            let mut chain = alloc::vec![candidate.clone()];
            for _ in 1..height {
                let below = applied(&n, &chain[chain.len() - 1]);
                chain.push(below);
            }
            chain.reverse(); // the eigenvector first
            found.push(chain);
        }
    }
    found.iter_mut().for_each(|chain| normalize(chain));
    found
}

/// Scales a chain so that its eigenvector ends in 1, and clears that place in the others.
fn normalize<S: Scalar>(chain: &mut [Vec<S>]) {
    let Some(place) = chain.first().and_then(|v| v.iter().rposition(|x| !x.is_zero())) else { return };
    let scale = chain[0][place].clone();
    for v in chain.iter_mut() {
        v.iter_mut().for_each(|x| *x = x.clone() / scale.clone());
    }
    // Adding a shifted copy of the chain to itself keeps it a chain.
    for from in 1..chain.len() {
        let excess = chain[from][place].clone();
        for i in (from..chain.len()).rev() {
            let lower = chain[i - from].clone();
            for (x, y) in chain[i].iter_mut().zip(&lower) {
                *x = x.clone() - excess.clone() * y.clone();
            }
        }
    }
}
