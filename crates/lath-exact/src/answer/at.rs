//! What each control point weighs at one parameter.

use crate::budget;
use crate::error::{Code, Error, Result};
use crate::parse::same_length;
use crate::rational::Rational;
use lath::basis::bspline;
use lath::error::{Code as Core, Limits};
use lath::knot::{Knots, Side};

/// The weights of the control points at one parameter.
#[derive(Clone, Debug, PartialEq)]
pub struct At {
    /// The knots, with their degree.
    pub knots: Knots<Rational>,
    /// The parameter.
    pub t: Rational,
    /// The side from which it was answered.
    pub side: Side,
    /// The index i of the span [tᵢ, tᵢ₊₁] that answered.
    pub span: usize,
    /// Which derivative: 0 for the point itself.
    pub derivative: usize,
    /// The index of the first control point that may weigh in, i − p.
    pub first: usize,
    /// The weights of the control points i − p … i, zeros included.
    pub weights: Vec<Rational>,
    /// The control points, if they were given.
    pub points: Option<Vec<Vec<Rational>>>,
}

impl At {
    /// The point (or derivative) of the curve; none if no control points were given.
    pub fn value(&self) -> Option<Vec<Rational>> {
        let local = self.points.as_ref()?.get(self.first..=self.span)?;
        let dimension = local.first()?.len();
        let sum = |c: usize| self.weights.iter().zip(local).map(|(weight, point)| weight * &point[c]).sum();
        Some((0..dimension).map(sum).collect())
    }

    /// The same answer for these control points.
    ///
    /// ```
    /// use lath_exact::{answer::at, parse};
    /// use lath::knot::Side;
    ///
    /// let knots = parse::fractions("0,0,0,0,1/3,2/3,1,1,1,1")?;
    /// let points = parse::rows("5,5; 10,10; 20,15; 35,15; 45,10; 50,5")?;
    /// let answer = at(&knots, 3, &"1/2".parse()?, 0, Side::Right, &Default::default())?.with_points(points)?;
    /// assert_eq!(answer.value().unwrap(), parse::fractions("55/2, 235/16")?);
    /// # Ok::<(), lath_exact::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// K001 if there are not as many points as functions; P005 if they differ in their number of coordinates.
    pub fn with_points(self, points: Vec<Vec<Rational>>) -> Result<At> {
        same_length(&points)?;
        let wanted = self.knots.functions();
        if points.len() != wanted {
            let (knots, degree) = (self.knots.values().len(), self.knots.degree());
            let message = format!("{} points; {knots} knots of degree {degree} take {wanted}", points.len());
            return Err(Error::new(Code::Core(Core::K001), message));
        }
        Ok(At { points: Some(points), ..self })
    }
}

/// The weights that the control points have at t, in the curve's point or in its derivative of an order.
///
/// `side` decides at knots: [`Side::Right`] is the default, and means the left at the end of the domain.
///
/// *Cost.* O(p²) for each order up to the derivative.
///
/// ```
/// use lath_exact::{answer::at, parse};
/// use lath::knot::Side;
///
/// let answer = at(&parse::fractions("0,1,2,3,4,5,6,7")?, 3, &"3".parse()?, 0, Side::Right, &Default::default())?;
/// assert_eq!((answer.span, answer.weights), (3, parse::fractions("1/6,2/3,1/6,0")?));
/// # Ok::<(), lath_exact::error::Error>(())
/// ```
///
/// # Errors
/// As `lath::knot::Knots::new`; T002 for a parameter outside the domain; B001 where the budget is exceeded.
pub fn at(
    knots: &[Rational],
    degree: usize,
    t: &Rational,
    derivative: usize,
    side: Side,
    limits: &Limits<'_>,
) -> Result<At> {
    let (size, order) = (degree.saturating_add(1), derivative.min(degree.saturating_add(1)));
    let bits = budget::bits(knots).max(t.bits()).saturating_mul(budget::product(&[2, size]));
    budget::check(limits, budget::product(&[4, order.saturating_add(1), size, size]), bits)?;
    let knots = Knots::new(knots.to_vec(), degree)?;
    let (from, to) = knots.domain();
    if *t < from || *t > to {
        let message = format!("t = {t} is outside [{from}, {to}]");
        return Err(Error::new(Code::Core(Core::T002), message));
    }
    let span = knots.span(t, side);
    let weights = bspline::derivatives(&knots, span, t, order).pop().unwrap_or_default();
    // What the core answered for: at the domain's ends it looks from the inside.
    let side = if *t == knots.values()[span + 1] { Side::Left } else { Side::Right };
    Ok(At { knots, t: t.clone(), side, span, derivative, first: span - degree, weights, points: None })
}
