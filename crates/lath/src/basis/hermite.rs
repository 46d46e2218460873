//! The cubic Hermite blending functions over an interval of length h, as a function of u ∈ [0, 1]:
//!
//! F₁ = 2u³ − 3u² + 1, F₂ = −2u³ + 3u², F₃ = u(u² − 2u + 1) h, F₄ = u(u² − u) h,
//!
//! so that P(u) = F₁P₀ + F₂P₁ + F₃P′₀ + F₄P′₁ with derivatives P′ taken for the parameter t = t₀ + u h.
//!
//! *Source.* D. F. Rogers and J. A. Adams, Mathematical Elements for Computer Graphics, ch. 5.

use crate::num::Scalar;

/// F₁ … F₄ and their derivatives with respect to t (not u): `[k][i]` is the k-th derivative of F_{i+1}.
///
/// ```
/// use lath::basis::hermite::blending;
///
/// let rows = blending(&0.5, &2.0);
/// assert_eq!(rows[0], [0.5, 0.5, 0.25, -0.25]);
/// assert_eq!(rows[1], [-0.75, 0.75, -0.25, -0.25]);
/// ```
pub fn blending<S: Scalar>(u: &S, h: &S) -> [[S; 4]; 4] {
    let n = S::from_int;
    let (u, h) = (u.clone(), h.clone());
    let c = S::one() - u.clone();
    let uc = u.clone() * c.clone();
    // Products of u and 1 − u keep small values accurate: F₁ = (1−u)²(1+2u), F₂ = u²(3−2u), F₃ = u(1−u)²h, F₄ = −u²(1−u)h.
    let f2 = u.clone() * u.clone() * (n(3) - n(2) * u.clone());
    let f1 = c.clone() * c.clone() * (n(1) + n(2) * u.clone());
    let f3 = uc.clone() * c.clone() * h.clone();
    let f4 = -(uc.clone() * u.clone() * h.clone());
    let slope = n(6) * uc / h.clone();
    let d3 = c.clone() * (n(1) - n(3) * u.clone());
    let d4 = u.clone() * (n(3) * u.clone() - n(2));
    let bend = n(6) * (n(2) * u.clone() - n(1)) / (h.clone() * h.clone());
    let e3 = (n(6) * u.clone() - n(4)) / h.clone();
    let e4 = (n(6) * u - n(2)) / h.clone();
    let (jerk, twist) = (n(12) / (h.clone() * h.clone() * h.clone()), n(6) / (h.clone() * h));
    [
        [f1, f2, f3, f4],
        [-slope.clone(), slope, d3, d4],
        [bend.clone(), -bend, e3, e4],
        [jerk.clone(), -jerk, twist.clone(), twist],
    ]
}

/// The Bernstein points of a cubic with end points p₀, p₁ and end derivatives m₀, m₁ over an interval of length h:
/// p₀, p₀ + h m₀/3, p₁ − h m₁/3, p₁.
///
/// ```
/// use lath::basis::hermite::to_bernstein;
///
/// assert_eq!(to_bernstein(&[0.0], &[3.0], &[3.0], &[0.0], &1.0), [[0.0], [1.0], [3.0], [3.0]]);
/// ```
pub fn to_bernstein<S: Scalar, const D: usize>(
    p0: &[S; D],
    m0: &[S; D],
    p1: &[S; D],
    m1: &[S; D],
    h: &S,
) -> [[S; D]; 4] {
    let third = |m: &S| m.clone() * h.clone() / S::from_int(3);
    [
        p0.clone(),
        core::array::from_fn(|c| p0[c].clone() + third(&m0[c])),
        core::array::from_fn(|c| p1[c].clone() - third(&m1[c])),
        p1.clone(),
    ]
}
