//! Bernstein polynomials and Bézier segments: J_{n,i}(u) = C(n,i) uⁱ (1−u)ⁿ⁻ⁱ.
//!
//! *Source.* P. de Casteljau 1959; G. Farin, Curves and Surfaces for CAGD (5th ed. 2002), ch. 4 and 5.

use crate::basis::scratch::Scratch;
use crate::num::Scalar;
use crate::space::Vector;
use alloc::vec::Vec;

/// The barycentric weights (1 − u, u) of t on [a, b], u = (t − a)/(b − a): [`Scalar::weights`].
pub fn weights<S: Scalar>(a: &S, b: &S, t: &S) -> (S, S) {
    S::weights(a, b, t)
}

/// All n + 1 Bernstein polynomials of degree n at u ∈ [0, 1], or outside by the same formula.
///
/// *Cost.* O(n²). *Error.* At most 3n u relative for u in [0, 1]: sums of non-negative numbers only.
///
/// ```
/// use lath::basis::bernstein::values;
///
/// assert_eq!(values(3, &0.5), [0.125, 0.375, 0.375, 0.125]);
/// ```
pub fn values<S: Scalar>(degree: usize, u: &S) -> Vec<S> {
    let mut out = alloc::vec![S::zero(); degree + 1];
    values_into((S::one() - u.clone(), u.clone()), &mut out);
    out
}

/// The same at the weights (1 − u, u) of [`weights`], into `out`, whose length is the degree and one.
pub(crate) fn values_into<S: Scalar>((complement, u): (S, S), out: &mut [S]) {
    let Some(first) = out.first_mut() else { return };
    *first = S::one();
    for r in 1..out.len() {
        // J_{r,i} = (1−u) J_{r−1,i} + u J_{r−1,i−1}
        let mut carry = S::zero();
        for value in &mut out[..r] {
            let next = u.clone() * value.clone();
            *value = complement.clone() * value.clone() + carry;
            carry = next;
        }
        out[r] = carry;
    }
}

/// The point Σ bᵢ Jᵢ at the weights (1 − u, u) of [`weights`], by de Casteljau's triangle, which overwrites `points`.
///
/// *Cost.* n(n+1)/2 blends. *Error.* E ≤ 3n for u in [0, 1] (E: error divided by u Σ|bᵢ|Jᵢ).
/// No points give zero.
pub fn eval_in_place<S: Scalar, V: Vector<S>>(points: &mut [V], (complement, u): (&S, &S)) -> V {
    for r in (1..points.len()).rev() {
        for i in 0..r {
            points[i] = points[i].blend(complement, &points[i + 1], u);
        }
    }
    points.first().map_or_else(V::zero, V::clone)
}

/// Value and derivatives at t of the Bézier segment `points` on [a, b]: `out[k]` receives the k-th derivative.
///
/// The k-th derivative is n!/(n−k)! (b−a)⁻ᵏ Σ Δᵏbᵢ J_{n−k,i}: differences first, evaluation second.
///
/// *Cost.* O(n²) for each order. *Degenerate input.* Orders above the degree are zero; no points give zero.
///
/// ```
/// use lath::basis::bernstein::jet;
///
/// let mut out = [[0.0]; 4];
/// jet(&[[1.0], [0.0], [5.0]], &0.0, &1.0, &0.5, &mut out); // 6t² − 2t + 1
/// assert_eq!(out, [[1.5], [4.0], [12.0], [0.0]]);
/// ```
pub fn jet<S: Scalar, V: Vector<S>>(points: &[V], a: &S, b: &S, t: &S, out: &mut [V]) {
    let (complement, u) = weights(a, b, t);
    let mut differences = Scratch::of(points);
    let length = b.clone() - a.clone();
    let last = out.len().saturating_sub(1);
    for (k, slot) in out.iter_mut().enumerate() {
        if k > 0 {
            // From the (k−1)-th to the k-th derivative's control points; degree of the former is n − k + 1.
            let Some(degree) = (points.len() + 1).checked_sub(k + 1).filter(|&d| d > 0) else {
                *slot = V::zero();
                continue;
            };
            let factor = S::from_int(degree as i64) / length.clone();
            let row = differences.points();
            for i in 0..degree {
                let mut step = row[i + 1].clone();
                step.add_scaled(&-S::one(), &row[i]);
                step.scale(&factor);
                row[i] = step;
            }
            differences.shorten(degree);
        }
        // The last order may spoil the differences.
        *slot = if k == last {
            eval_in_place(differences.points(), (&complement, &u))
        } else {
            eval_in_place(differences.clone().points(), (&complement, &u))
        };
    }
}

/// Splits a Bézier segment at the weights (1 − u, u): `points` becomes the left part, the right part is returned.
/// The shared point is the same in both, bit for bit.
///
/// ```
/// use lath::basis::bernstein::split_in_place;
///
/// let mut left = [[0.0], [2.0], [0.0]];
/// let right = split_in_place(&mut left, (&0.5, &0.5));
/// assert_eq!(left, [[0.0], [1.0], [1.0]]);
/// assert_eq!(right, [[1.0], [1.0], [0.0]]);
/// ```
pub fn split_in_place<S: Scalar, V: Vector<S>>(points: &mut [V], (complement, u): (&S, &S)) -> Vec<V> {
    let mut right = points.to_vec();
    let n = points.len();
    // Each round of the triangle leaves its first point in place on the left; its last goes to the right.
    for r in 1..n {
        for i in (r..n).rev() {
            points[i] = points[i - 1].blend(complement, &points[i], u);
        }
        right[n - 1 - r] = points[n - 1].clone();
    }
    right
}
