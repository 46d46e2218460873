//! How far an approximate answer may be from the truth.

/// The error of an approximate answer: proven, or an estimate that says so.
///
/// ```
/// use lath::num::Bound;
///
/// assert_eq!(Bound::Proven(0.01).value(), 0.01);
/// assert!(!Bound::Estimate(0.01).is_proven());
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Bound {
    /// The true error is at most this.
    Proven(f64),
    /// The error is believed to be about this; nothing is promised.
    Estimate(f64),
}

impl Bound {
    /// The number, whatever it is worth.
    pub fn value(self) -> f64 {
        match self {
            Bound::Proven(value) | Bound::Estimate(value) => value,
        }
    }

    /// Whether the number is a theorem.
    pub fn is_proven(self) -> bool {
        matches!(self, Bound::Proven(_))
    }
}
