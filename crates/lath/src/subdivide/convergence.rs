//! Does a scheme converge, and to curves how smooth?
//!
//! Differences of neighbours are refined by a scheme of their own, with the mask q of a(z)/(1 + z). The scheme converges if
//! some power of that difference scheme shrinks: the norm of its L-th power is the greatest sum of |q^{(L)}| over the
//! entries of one residue modulo 2ᴸ. Likewise the limits are Cʳ if the r-th derivative scheme converges.
//!
//! *Source.* N. Dyn, Subdivision schemes in computer-aided geometric design (1992), theorems 3.2 and 3.4.

use crate::num::Scalar;
use crate::subdivide::scheme::{Scheme, divided, is_exact, magnitude};
use alloc::vec::Vec;

/// The highest power of the difference scheme that is tried.
const MAX_POWER: usize = 12;

/// Whether a scheme converges to continuous curves from every polygon.
#[derive(Clone, Debug, PartialEq)]
pub enum Convergence<S = f64> {
    /// A theorem: this power of the difference scheme has this norm, below 1.
    Proven {
        /// The power L.
        power: usize,
        /// The norm of the L-th power.
        norm: S,
    },
    /// No power up to the twelfth has a norm below 1. The scheme may still converge, or not.
    NotProven,
}

impl<S> Convergence<S> {
    /// Whether convergence is a theorem.
    pub fn is_proven(&self) -> bool {
        matches!(self, Convergence::Proven { .. })
    }
}

impl<S: Scalar> Scheme<S> {
    /// Whether the scheme converges: *proven* when some power L ≤ 12 of the difference scheme has norm below 1.
    ///
    /// *Cost.* O(p² 2ᴸ). *Error.* On floats the norm must stay below 1 by 2⁻³², far more than its rounding; a mask
    /// whose entries were rounded is taken for the one that it was rounded from.
    ///
    /// ```
    /// use lath::subdivide::{Convergence, Scheme};
    ///
    /// assert_eq!(Scheme::<f64>::cubic().convergence(), Convergence::Proven { power: 1, norm: 0.5 });
    /// assert!(Scheme::four_point(&(1.0 / 16.0))?.convergence().is_proven());
    /// assert_eq!(Scheme::four_point(&2.0)?.convergence(), Convergence::NotProven);
    /// # Ok::<(), lath::error::Error>(())
    /// ```
    pub fn convergence(&self) -> Convergence<S> {
        let Some(differences) = divided(self.mask(), self.mask()) else { return Convergence::NotProven };
        let margin = if is_exact::<S>() { S::zero() } else { S::one() / S::from_int(1 << 32) };
        let mut proof = Convergence::NotProven;
        powers(&differences, MAX_POWER, |power, norm| {
            let shrinks = norm.clone() + margin.clone() < S::one();
            if shrinks {
                proof = Convergence::Proven { power, norm };
            }
            !shrinks
        });
        proof
    }

    /// The greatest r for which the limits are proven to be r times continuously differentiable, by the derivative
    /// schemes; none if even convergence is not proven. Smoother limits are not excluded, except for splines.
    ///
    /// ```
    /// use lath::subdivide::Scheme;
    ///
    /// assert_eq!(Scheme::<f64>::cubic().smoothness(), Some(2));
    /// assert_eq!(Scheme::four_point(&(1.0 / 16.0))?.smoothness(), Some(1));
    /// # Ok::<(), lath::error::Error>(())
    /// ```
    pub fn smoothness(&self) -> Option<usize> {
        if self.is_spline() {
            return Some(self.degree() - 1);
        }
        let mut proven = None;
        let mut scheme = self.clone();
        while scheme.convergence().is_proven() {
            proven = Some(proven.map_or(0, |r| r + 1));
            match scheme.derivative() {
                Ok(derivative) => scheme = derivative,
                Err(_) => break,
            }
        }
        proven
    }

    /// The norms of the scheme's own powers 1 … `most`: how much each can enlarge a polygon.
    pub(crate) fn norms(&self, most: usize) -> Vec<S> {
        norms(self.mask(), most)
    }
}

/// The norms of the powers 1 … `most` of a mask; fewer if floats cannot hold them all.
pub(crate) fn norms<S: Scalar>(mask: &[S], most: usize) -> Vec<S> {
    let mut found = Vec::with_capacity(most);
    powers(mask, most, |_, norm| {
        found.push(norm);
        true
    });
    found
}

/// Visits the norms of the powers of a mask, until it is told to stop or floats cannot hold them.
fn powers<S: Scalar>(mask: &[S], most: usize, mut visit: impl FnMut(usize, S) -> bool) {
    let mut power = alloc::vec![S::one()];
    for exponent in 1..=most {
        // The mask of the power is q(z) q(z²) … : the one before with its indices doubled, times the mask.
        let mut next = alloc::vec![S::zero(); 2 * (power.len() - 1) + mask.len()];
        for (i, a) in power.iter().enumerate() {
            for (j, b) in mask.iter().enumerate() {
                next[2 * i + j] = next[2 * i + j].clone() + a.clone() * b.clone();
            }
        }
        power = next;
        if power.iter().any(|a| !a.is_finite()) {
            return; // sums of what overflowed would compare with nothing
        }
        let step = 1usize << exponent;
        let sum =
            |residue: usize| power.iter().skip(residue).step_by(step).fold(S::zero(), |sum, a| sum + magnitude(a));
        let norm = (0..step).map(sum).fold(S::zero(), |most, sum| if sum > most { sum } else { most });
        if !visit(exponent, norm) {
            return;
        }
    }
}
