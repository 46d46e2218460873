//! What happens at the ends of an interpolating spline.

/// The condition at one end. `S` is `f64`, or an exact fraction.
#[derive(Clone, Debug, PartialEq)]
pub enum End<const D: usize, S = f64> {
    /// Second derivative zero.
    Natural,
    /// No knot at the neighbouring point: the two pieces at this end are one cubic.
    NotAKnot,
    /// This first derivative.
    Clamped([S; D]),
    /// This second derivative.
    Second([S; D]),
}

/// The conditions at both ends.
#[derive(Clone, Debug, PartialEq)]
pub enum Ends<const D: usize, S = f64> {
    /// One for the start, one for the end.
    Open(End<D, S>, End<D, S>),
    /// P′(start) = P′(end) and P″(start) = P″(end); the values may differ.
    Cyclic,
    /// P′(start) = −P′(end) and P″(start) = −P″(end).
    Anticyclic,
}
