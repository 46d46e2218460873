//! Several curves over the same knots, so that they can be added, blended, or become rows of a net.

use crate::curve::BSpline;
use crate::error::{Code, Error, Result};
use crate::num::Scalar;
use crate::refine::spline::Spline;
use crate::space::Vector;
use alloc::vec::Vec;

/// The same splines over one knot vector: of the greatest degree, over the domain of the first, with every knot that one of them has.
///
/// Open ones are clamped. Knots are the same only if they are equal: two that are nearly equal both stay, and every point remains a convex
/// combination of the given ones, however close they are.
///
/// *Cost.* Elevation and insertion of each. *Error.* As they have.
///
/// # Errors
/// C005 with the index of a spline that is closed where the first is open, or the other way; T005 where a change of the domain moves a knot
/// onto its neighbour.
///
/// ```
/// use lath::knot::Knots;
/// use lath::refine::{Spline, make_compatible};
///
/// let line = Spline::open(Knots::clamped(2, 1)?, vec![[0.0], [4.0]])?;
/// let bow = Spline::open(Knots::clamped(4, 2)?, vec![[0.0], [1.0], [1.0], [0.0]])?;
/// let both = make_compatible(&[line, bow])?;
/// assert_eq!(both[0].knots(), both[1].knots());
/// assert_eq!(both[0].knots().values(), [0.0, 0.0, 0.0, 0.5, 1.0, 1.0, 1.0]);
/// assert_eq!(both[0].points(), [[0.0], [1.0], [3.0], [4.0]]);
/// # Ok::<(), lath::error::Error>(())
/// ```
pub fn make_compatible<S: Scalar, V: Vector<S>>(splines: &[Spline<V, S>]) -> Result<Vec<Spline<V, S>>> {
    let Some(first) = splines.first() else { return Ok(Vec::new()) };
    let (start, end) = first.knots().domain();
    let degree = splines.iter().map(Spline::degree).max().unwrap_or(0);
    let mut all = Vec::with_capacity(splines.len());
    for (i, spline) in splines.iter().enumerate() {
        if spline.is_closed() != first.is_closed() {
            return Err(Error::new(Code::C005, "an open curve and a closed one cannot share their knots").at(i));
        }
        let spline = if spline.is_closed() { spline.canonical()? } else { spline.clamp()? };
        all.push(spline.reparametrise(&start, &end)?.elevate(degree - spline.degree())?);
    }
    // The union of all knots, each as often as it occurs in any of them.
    let mut union: Vec<S> = Vec::new();
    for spline in &all {
        union = merged(&union, spline.own_knots());
    }
    all.into_iter().map(|spline| spline.insert(&missing(&union, spline.own_knots()))).collect()
}

/// Two increasing lists as one, each value as often as the list that has it most often.
pub(crate) fn merged<S: Scalar>(a: &[S], b: &[S]) -> Vec<S> {
    let mut all = Vec::with_capacity(a.len() + b.len());
    let (mut i, mut j) = (0, 0);
    while i < a.len() || j < b.len() {
        match (a.get(i), b.get(j)) {
            (Some(x), Some(y)) if x == y => {
                all.push(x.clone());
                (i, j) = (i + 1, j + 1);
            }
            (Some(x), y) if y.is_none_or(|y| x < y) => {
                all.push(x.clone());
                i += 1;
            }
            (_, Some(y)) => {
                all.push(y.clone());
                j += 1;
            }
            _ => break,
        }
    }
    all
}

/// What `all` has beyond `own`.
pub(crate) fn missing<S: Scalar>(all: &[S], own: &[S]) -> Vec<S> {
    let mut rest = own.iter().peekable();
    all.iter().filter(|t| rest.next_if(|own| own == t).is_none()).cloned().collect()
}

impl<const D: usize> BSpline<D> {
    /// The same curves over one knot vector: of the greatest degree, over the domain of the first, with every knot that one of them
    /// has. Open curves are clamped.
    ///
    /// Two knots that are nearly equal both stay: points remain convex combinations of the given ones, however close they are.
    ///
    /// ```
    /// use lath::curve::BSpline;
    ///
    /// let line = BSpline::clamped(1, [[0.0], [4.0]])?;
    /// let bow = BSpline::clamped(2, [[0.0], [1.0], [1.0], [0.0]])?;
    /// let both = BSpline::make_compatible(&[line, bow])?;
    /// assert_eq!(both[0].knots(), both[1].knots());
    /// # Ok::<(), lath::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// C005 with the index of a curve that is closed where the first is open, or the other way; T005 where a change of the domain moves a
    /// knot onto its neighbour.
    pub fn make_compatible(curves: &[BSpline<D>]) -> Result<Vec<BSpline<D>>> {
        let splines: Vec<_> = curves.iter().map(BSpline::to_spline).collect();
        make_compatible(&splines)?.into_iter().map(BSpline::from_spline).collect()
    }
}
