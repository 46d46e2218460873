//! A scheme is its mask and the rule that applies it.

use crate::error::{Code, Count, Error, Result};
use crate::num::Scalar;
use alloc::format;
use alloc::vec::Vec;

/// The greatest degree of a Lane–Riesenfeld scheme, as of every B-spline here.
const MAX_DEGREE: usize = 1000;

/// The greatest number of mask entries a user may give: the analysis of convergence grows with its square.
const MAX_MASK: usize = 258;

/// A subdivision scheme: a mask a₀ … a_{p+1} whose entries of even index sum to 1 and those of odd index too.
///
/// One refinement of the points Pⱼ makes the points Qᵢ = Σⱼ a_{i+p−2j} Pⱼ, for all i whose formula finds all its points:
/// 2n − p of them from n (an open polygon *retreats*), or 2n from a closed polygon, whose indices are taken modulo n.
/// *p* is the degree, the number of entries less two. For Lane–Riesenfeld schemes it is that of the limit; for the
/// four-point scheme, whose limit is no spline, it is 5 and only counts.
///
/// ```
/// use lath::subdivide::Scheme;
///
/// assert_eq!(Scheme::<f64>::cubic().mask(), [0.125, 0.5, 0.75, 0.5, 0.125]);
/// assert_eq!(Scheme::<f64>::chaikin(), Scheme::lane_riesenfeld(2)?);
/// assert_eq!(Scheme::four_point(&(1.0 / 16.0))?.degree(), 5);
/// // The local matrix, which makes the p neighbours (k, 2i) from the p neighbours (k − 1, i), all times 8.
/// let rows = Scheme::<f64>::cubic().local_matrix();
/// assert_eq!(rows.concat().iter().map(|a| a * 8.0).collect::<Vec<_>>(), [4., 4., 0., 1., 6., 1., 0., 4., 4.]);
/// # Ok::<(), lath::error::Error>(())
/// ```
///
/// *Source.* G. Chaikin (1974); J. Lane and R. Riesenfeld (1980); N. Dyn, D. Levin and J. Gregory (1987).
#[derive(Clone, Debug, PartialEq)]
pub struct Scheme<S = f64> {
    mask: Vec<S>,
    /// Whether the mask is binom(p+1, i)/2ᵖ, so that the limit is a uniform B-spline.
    spline: bool,
}

impl<S: Scalar> Scheme<S> {
    /// Chaikin's corner cutting, degree 2: new points (3Pᵢ + Pᵢ₊₁)/4 and (Pᵢ + 3Pᵢ₊₁)/4.
    pub fn chaikin() -> Scheme<S> {
        Scheme { mask: binomial_mask(2), spline: true }
    }

    /// The cubic scheme: edge points (Pᵢ + Pᵢ₊₁)/2 and vertex points (Pᵢ₋₁ + 6Pᵢ + Pᵢ₊₁)/8 alternately.
    pub fn cubic() -> Scheme<S> {
        Scheme { mask: binomial_mask(3), spline: true }
    }

    /// The scheme of uniform B-splines of degree p: mask binom(p+1, i)/2ᵖ.
    ///
    /// *Error.* On floats the mask is exact up to degree 50, and within p units of its last place above.
    ///
    /// # Errors
    /// K006 for degree 0, whose limit has steps, and above 1000.
    pub fn lane_riesenfeld(degree: usize) -> Result<Scheme<S>> {
        if (1..=MAX_DEGREE).contains(&degree) {
            return Ok(Scheme { mask: binomial_mask(degree), spline: true });
        }
        Err(Error::new(Code::K006, format!("a scheme of degree {degree}; it takes 1 to {MAX_DEGREE}")))
    }

    /// The interpolatory four-point scheme: old points stay, new ones are (½ + w)(Pᵢ + Pᵢ₊₁) − w(Pᵢ₋₁ + Pᵢ₊₂).
    ///
    /// w = 1/16 is the classic choice, exact for cubics; w = 0 draws the polygon.
    ///
    /// # Errors
    /// S002 for a tension that is not finite.
    ///
    /// *Source.* N. Dyn, D. Levin, J. Gregory, A 4-point interpolatory subdivision scheme for curve design (1987).
    pub fn four_point(tension: &S) -> Result<Scheme<S>> {
        if !tension.is_finite() {
            return Err(Error::new(Code::S002, format!("the tension of the four-point scheme is {tension:?}")));
        }
        let (w, zero) = (tension.clone(), S::zero());
        let inner = S::one() / S::from_int(2) + w.clone();
        Scheme::from_mask(alloc::vec![-w.clone(), zero.clone(), inner.clone(), S::one(), inner, zero, -w])
    }

    /// The scheme of a mask of the user's own. A mask of m entries counts as degree m − 2; zeros at its ends count as entries.
    /// A mask equal to that of a Lane–Riesenfeld scheme is one.
    ///
    /// ```
    /// use lath::error::Code;
    /// use lath::subdivide::Scheme;
    ///
    /// assert_eq!(Scheme::from_mask(vec![0.25, 0.75, 0.75, 0.25])?, Scheme::chaikin());
    /// let error = Scheme::from_mask(vec![0.25, 0.75, 0.5, 0.25]).unwrap_err();
    /// assert_eq!(error.code(), Code::S001);
    /// # Ok::<(), lath::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// S002 for fewer than 3 or more than 258 entries, or one that is not finite; S001 unless the entries of even index and
    /// those of odd index each sum to 1: exactly on fractions, within the rounding of the sum on floats.
    pub fn from_mask(mask: Vec<S>) -> Result<Scheme<S>> {
        if !(3..=MAX_MASK).contains(&mask.len()) {
            let message = format!("a mask of {}; it takes 3 to {MAX_MASK}", Count(mask.len(), "number"));
            return Err(Error::new(Code::S002, message));
        }
        if let Some(i) = mask.iter().position(|a| !a.is_finite()) {
            return Err(Error::new(Code::S002, format!("number {i} of the mask is {:?}", mask[i])).at(i));
        }
        for (parity, name) in ["even", "odd"].into_iter().enumerate() {
            let sum = mask.iter().skip(parity).step_by(2).fold(S::zero(), |sum, a| sum + a.clone());
            if !negligible(&(sum.clone() - S::one()), &mask) {
                let message = format!("the numbers of {name} index sum to {sum:?}");
                return Err(Error::new(Code::S001, message));
            }
        }
        let degree = mask.len() - 2;
        let spline = mask == binomial_mask(degree);
        Ok(Scheme { mask, spline })
    }

    /// The mask a₀ … a_{p+1}.
    pub fn mask(&self) -> &[S] {
        &self.mask
    }

    /// The degree p: the number of mask entries less two.
    pub fn degree(&self) -> usize {
        self.mask.len() - 2
    }

    /// Whether this is a Lane–Riesenfeld scheme: the limit is then a uniform B-spline of degree [`Scheme::degree`].
    pub fn is_spline(&self) -> bool {
        self.spline
    }

    /// The weight of the old point j in the new point i: a_{i+p−2j}, zero outside the mask.
    pub fn weight(&self, i: usize, j: usize) -> S {
        let entry = (i + self.degree()).checked_sub(2 * j).and_then(|place| self.mask.get(place));
        entry.map_or_else(S::zero, S::clone)
    }

    /// The local matrix A, p × p: p neighbours (k, 2i) … are A times the p neighbours (k − 1, i) …: for
    /// cubics ⅛ [4 4 0; 1 6 1; 0 4 4].
    pub fn local_matrix(&self) -> Vec<Vec<S>> {
        self.matrix(self.degree(), self.degree())
    }

    /// The matrix of one group, (p + 2) × (p + 1): p + 1 points become the p + 2 points of the next level that they make.
    pub fn group_matrix(&self) -> Vec<Vec<S>> {
        self.matrix(self.degree() + 2, self.degree() + 1)
    }

    fn matrix(&self, rows: usize, columns: usize) -> Vec<Vec<S>> {
        (0..rows).map(|i| (0..columns).map(|j| self.weight(i, j)).collect()).collect()
    }

    /// The scheme of the derivative: applied to the differences Pᵢ₊₁ − Pᵢ it makes those of the next level times two, and so
    /// tends to the derivative of the limit. Its mask is that of 2a(z)/(1+z); its degree is p − 1.
    ///
    /// ```
    /// use lath::subdivide::Scheme;
    ///
    /// assert_eq!(Scheme::<f64>::cubic().derivative()?, Scheme::chaikin());
    /// # Ok::<(), lath::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// S003 if there is none: for degree 1, and where 2a(z)/(1+z) is no affine scheme.
    pub fn derivative(&self) -> Result<Scheme<S>> {
        let degree = self.degree();
        if degree < 2 {
            return Err(Error::new(Code::S003, "a scheme of degree 1 has no derivative scheme"));
        }
        if self.spline {
            return Scheme::lane_riesenfeld(degree - 1);
        }
        let quotient = divided(&self.mask, &self.mask);
        let doubled = quotient.into_iter().flatten().map(|a| S::from_int(2) * a).collect();
        let scheme = Scheme::from_mask(doubled);
        scheme.map_err(|_| Error::new(Code::S003, "linear data leave the scheme's limits without a common derivative"))
    }
}

/// binom(p+1, i)/2ᵖ, by p halvings of sums of neighbours.
fn binomial_mask<S: Scalar>(degree: usize) -> Vec<S> {
    // Pascal's triangle in integers, then one power of two: the same bits as halving every row, since halving never rounds
    // between 2⁻¹⁰⁰⁰ and binom(1001, 500) < 2¹⁰⁰¹; and on fractions, integers need no reducing.
    let mut mask = alloc::vec![S::one(), S::one()];
    for _ in 0..degree {
        let mut next = alloc::vec![S::one()];
        next.extend(mask.windows(2).map(|pair| pair[0].clone() + pair[1].clone()));
        next.push(S::one());
        mask = next;
    }
    let half = S::one() / S::from_int(2);
    let scale = (0..degree).fold(S::one(), |scale, _| scale * half.clone());
    mask.into_iter().map(|a| a * scale.clone()).collect()
}

/// The coefficients of symbol(z)/(1 + z), if the division leaves nothing; `scale` says what rounding may leave.
pub(crate) fn divided<S: Scalar>(symbol: &[S], scale: &[S]) -> Option<Vec<S>> {
    let mut rest = S::zero();
    let mut quotient = Vec::with_capacity(symbol.len());
    for a in symbol {
        rest = a.clone() - rest;
        quotient.push(rest.clone());
    }
    let remainder = quotient.pop()?;
    negligible(&remainder, scale).then_some(quotient)
}

/// Whether x is what rounding may leave of a zero that was summed from `terms`: nothing on fractions.
pub(crate) fn negligible<S: Scalar>(x: &S, terms: &[S]) -> bool {
    if x.is_zero() || is_exact::<S>() {
        return x.is_zero();
    }
    let size = terms.iter().fold(S::one(), |sum, a| sum + magnitude(a));
    magnitude(x) <= size * S::from_int(4 * terms.len() as i64) / S::from_int(1 << 53)
}

/// |x|.
pub(crate) fn magnitude<S: Scalar>(x: &S) -> S {
    if *x < S::zero() { -x.clone() } else { x.clone() }
}

/// Whether the arithmetic of S rounds nothing, as far as 2⁶⁰ + 1 can tell.
pub(crate) fn is_exact<S: Scalar>() -> bool {
    let big = S::from_int(1 << 60);
    (big.clone() + S::one()) - big == S::one()
}
