//! Groups and tuples as data: who makes whom.
//!
//! A group is p + 1 neighbours of level 0; it makes one segment of the curve, and 2ᵏ + p points of level k. A tuple is p
//! neighbours (for cubics a *triplet*); each tuple at an even index comes from the one tuple at half that index of the level
//! before, through the local matrix A. So Aᵐ leaps over m levels, as far as the index ends in zero bits.

use crate::error::{Code, Error, Limits, Result};
use crate::num::Scalar;
use crate::subdivide::dyadic::Index;
use crate::subdivide::mask::{Rows, Target};
use crate::subdivide::matrix::power;
use crate::subdivide::polygon::{Ends, MAX_LEVEL, Subdivision};
use crate::subdivide::scheme::Scheme;
use alloc::format;
use alloc::vec::Vec;
use core::ops::Range;

/// The groups of p + 1 neighbours of an open polygon of n points, as ranges of indices: the i-th makes the i-th segment.
///
/// ```
/// let groups: Vec<_> = lath::subdivide::groups(6, 3).collect();
/// assert_eq!(groups, [0..4, 1..5, 2..6]);
/// ```
pub fn groups(points: usize, degree: usize) -> impl Iterator<Item = Range<usize>> {
    (0..points.saturating_sub(degree)).map(move |i| i..i + degree + 1)
}

/// A tuple of p neighbours of level k and the tuple of level k − 1 that makes it; both by the index of their first point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Descent {
    /// The first index of the tuple, even.
    pub index: u64,
    /// The first index of the tuple of the level before: half of it.
    pub from: u64,
}

/// Which tuple of level k − 1 makes each tuple of level k at an even index, for one group: 2ᵏ⁻¹ + 1 of them, none for level 0.
///
/// ```
/// use lath::{error::Limits, subdivide::{Descent, descents}};
///
/// let table = descents(4, &Limits::default())?;
/// assert_eq!(table.len(), 9);
/// assert_eq!(table[8], Descent { index: 16, from: 8 });
/// # Ok::<(), lath::error::Error>(())
/// ```
///
/// # Errors
/// S005 for a level above 1000; B001 if there are more than the budget.
pub fn descents(level: usize, limits: &Limits<'_>) -> Result<Vec<Descent>> {
    if level > MAX_LEVEL {
        return Err(Error::new(Code::S005, format!("level {level} is above {MAX_LEVEL}")));
    }
    if level == 0 {
        return Ok(Vec::new());
    }
    let count = Index::from(1).shifted_up(level - 1).saturated().saturating_add(1);
    limits.check_points(count)?;
    limits.check_bytes(count.saturating_mul(size_of::<Descent>() as u64))?;
    Ok((0..count).map(|from| Descent { index: 2 * from, from }).collect())
}

/// How a tuple of p neighbours leaps over levels: the tuple (to level, index) is `matrix` = Aᵐ times the tuple it comes from.
#[derive(Clone, Debug, PartialEq)]
pub struct Leap<S = f64> {
    /// The power m: the number of levels.
    pub power: usize,
    /// Where the tuple lands: the index of its first point.
    pub index: Index,
    /// Aᵐ.
    pub matrix: Vec<Vec<S>>,
}

/// The tuple of level k from which a tuple of a higher level descends by even indices alone.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Ancestor {
    /// The level of the ancestor.
    pub level: usize,
    /// The index of its first point.
    pub index: Index,
    /// How many levels lie between: the power of A.
    pub power: usize,
}

/// The highest ancestor of a tuple: as many levels up as its index ends in zero bits, but not above level 0.
///
/// ```
/// use lath::subdivide::ancestor;
///
/// let found = ancestor(5, &16.into()); // P⁵ at 16, 17, 18 = A⁴ P¹ at 1, 2, 3
/// assert_eq!((found.level, found.index, found.power), (1, 1.into(), 4));
/// ```
pub fn ancestor(level: usize, index: &Index) -> Ancestor {
    let power = if *index == Index::default() { level } else { index.trailing_zeros().min(level) };
    Ancestor { level: level - power, index: index.shifted_down(power), power }
}

impl<S: Scalar> Scheme<S> {
    /// The leap of the tuple at `index` from one level to a higher one: P³₀₁₂ = A³ P⁰₀₁₂.
    ///
    /// *Cost.* O(p³ log m).
    ///
    /// ```
    /// use lath::subdivide::Scheme;
    ///
    /// let leap = Scheme::<f64>::cubic().leap(1, &1.into(), 5)?;
    /// assert_eq!((leap.power, leap.index.to_u64()), (4, Some(16)));
    /// # Ok::<(), lath::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// S005 if the second level is above 1000, or below the first; P003 if floats cannot hold the power of a wild mask.
    pub fn leap(&self, from_level: usize, index: &Index, to_level: usize) -> Result<Leap<S>> {
        if to_level > MAX_LEVEL {
            return Err(Error::new(Code::S005, format!("level {to_level} is above {MAX_LEVEL}")));
        }
        let Some(exponent) = to_level.checked_sub(from_level) else {
            let message = format!("a leap from level {from_level} down to level {to_level}");
            return Err(Error::new(Code::S005, message));
        };
        let matrix = power(&self.local_matrix(), exponent);
        if matrix.iter().flatten().any(|x| !x.is_finite()) {
            let message = format!("the power {exponent} of the local matrix leaves the range of floats");
            return Err(Error::new(Code::P003, message));
        }
        Ok(Leap { power: exponent, index: index.shifted_up(exponent), matrix })
    }

    /// The weights that the p + 1 points of one group have in the point i of level k (see
    /// [`Target`](crate::subdivide::Target)), 0 ≤ i < 2ᵏ + p, or 0 ≤ i ≤ 2ᵏ for the limit.
    ///
    /// ```
    /// use lath::subdivide::{Scheme, Target};
    ///
    /// let weights = Scheme::<f64>::cubic().group_weights(1, Target::Limit, &1.into())?;
    /// assert_eq!(weights, [1.0 / 48.0, 23.0 / 48.0, 23.0 / 48.0, 1.0 / 48.0]);
    /// # Ok::<(), lath::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`Subdivision::point`].
    pub fn group_weights(&self, level: usize, target: Target, index: &Index) -> Result<Vec<S>> {
        let p = self.degree();
        let unit = |i: usize| (0..=p).map(move |j| [if i == j { S::one() } else { S::zero() }]);
        let group = |i: usize| Subdivision::new(self.clone(), unit(i), Ends::Open);
        let first = group(0)?.point(level, target, index)?; // checks level and index
        if !self.is_spline() {
            let rest = (1..=p).map(|i| group(i)?.point(level, target, index).map(|[w]| w));
            return core::iter::once(Ok(first).map(|[w]| w)).chain(rest).collect();
        }
        // One row holds the weights of all points from q on.
        let q = index.shifted_down(level).saturated() as usize;
        let (rows, mut scratch) = (Rows::spline(self, level, target, 1), Vec::new());
        let row = rows.rows(&index.low_bits(level), 1, &mut scratch);
        let mut weights = alloc::vec![S::zero(); q.min(p + 1)];
        weights.extend(row.iter().take(p + 1 - q.min(p + 1)).cloned());
        Ok(weights)
    }
}
