//! Operations on the knots that leave the curve unchanged, as matrices on its control points.

use crate::budget;
use crate::error::{Code, Error, Result};
use crate::line::Line;
use crate::matrix::Matrix;
use crate::rational::Rational;
use crate::weights::Weights;
use lath::basis::blossom;
use lath::error::{Code as Core, Limits};
use lath::knot::{Knots, Side};
use lath::num::Scalar;

/// The Greville abscissae: where each control point stands over the parameter line.
#[derive(Clone, Debug, PartialEq)]
pub struct Greville {
    /// The degree p.
    pub degree: usize,
    /// The knots.
    pub knots: Vec<Rational>,
    /// ξᵢ = (t_{i+1} + … + t_{i+p})/p.
    pub abscissae: Vec<Rational>,
}

/// The Greville abscissae ξᵢ = (t_{i+1} + … + t_{i+p})/p: with them as control points the curve is t itself. For degree 0,
/// where the mean is empty, the middles of the spans.
///
/// ```
/// use lath_exact::{answer::greville, parse};
///
/// let answer = greville(&parse::fractions("0,0,0,0,1,2,2,2,2")?, 3)?;
/// assert_eq!(answer.abscissae, parse::fractions("0,1/3,1,5/3,2")?);
/// # Ok::<(), lath_exact::error::Error>(())
/// ```
///
/// # Errors
/// As [`blending`](crate::answer::blending).
pub fn greville(knots: &[Rational], degree: usize) -> Result<Greville> {
    let line = Line::new(knots, degree)?;
    let mean = |i: usize| {
        let of = if degree == 0 { &knots[i..i + 2] } else { &knots[i + 1..=i + degree] };
        let sum: Rational = of.iter().cloned().sum();
        sum / Rational::from(of.len() as i64)
    };
    Ok(Greville { degree, knots: knots.to_vec(), abscissae: (0..line.functions).map(mean).collect() })
}

/// A matrix that makes the control points of the same curve over other knots.
#[derive(Clone, Debug, PartialEq)]
pub struct Refinement {
    /// What was done.
    pub kind: Refined,
    /// The degree before.
    pub degree: usize,
    /// The degree after.
    pub new_degree: usize,
    /// The knots before.
    pub knots: Vec<Rational>,
    /// The knots after.
    pub new_knots: Vec<Rational>,
    /// New control points = matrix · old control points. Every row sums to 1.
    pub matrix: Matrix,
}

/// The two refinements.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Refined {
    /// These knots were inserted.
    Inserted(Vec<Rational>),
    /// The degree was raised by so much.
    Elevated(usize),
}

/// The matrix that inserts knots inside the domain: Q = A P, the same curve with more control points.
///
/// *Idea.* The new control point j is the old polynomial's blossom at the new knots τ_{j+1} … τ_{j+p}.
///
/// *Cost.* O(p³) operations for each new control point.
///
/// ```
/// use lath_exact::{answer::insertion, parse};
///
/// let knots = parse::fractions("0,0,0,1,1,1")?;
/// let answer = insertion(&knots, 2, &parse::fractions("1/2")?, &Default::default())?;
/// assert_eq!(answer.matrix.rows()[1], parse::fractions("1/2,1/2,0")?);
/// # Ok::<(), lath_exact::error::Error>(())
/// ```
///
/// # Errors
/// As `lath::knot::Knots::new`, also for the knots after insertion (K003); T002 with the index of a new knot outside the
/// domain; B001 where the budget is exceeded.
pub fn insertion(knots: &[Rational], degree: usize, inserted: &[Rational], limits: &Limits<'_>) -> Result<Refinement> {
    let count = knots.len().saturating_add(inserted.len());
    check(limits, degree, count, knots.len(), budget::bits(knots.iter().chain(inserted)), 1)?;
    let (from, to) = Knots::new(knots.to_vec(), degree)?.domain();
    if let Some(i) = inserted.iter().position(|t| *t < from || *t > to) {
        let message = format!("new knot {i} is {}, outside [{from}, {to}]", inserted[i]);
        return Err(Error::new(Code::Core(Core::T002), message).at(i));
    }
    let mut new_knots = [knots, inserted].concat();
    new_knots.sort();
    Knots::new(new_knots.clone(), degree)?;
    let line = Line::new(knots, degree)?;
    let rows = (0..new_knots.len() - degree - 1)
        .map(|j| {
            limits.check_cancel()?;
            Ok(control_point(&line, &new_knots[j], &[&new_knots[j + 1..=j + degree]]))
        })
        .collect::<Result<Vec<_>>>()?;
    let matrix = spread(rows, line.functions);
    Ok(Refinement {
        kind: Refined::Inserted(inserted.to_vec()),
        degree,
        new_degree: degree,
        knots: knots.to_vec(),
        new_knots,
        matrix,
    })
}

/// The matrix that raises the degree by `by`: Q = A P, the same curve on the same domain. Every knot of the domain is repeated
/// `by` times more; where the knots are not clamped, those outside the new domain that are no longer needed are left out.
///
/// For a Bézier curve of degree p give the knots (0, …, 0, 1, …, 1), or use [`elevation_bezier`].
///
/// *Idea.* The blossom of p + 1 arguments is the mean of the p + 1 blossoms of p arguments that leave one out.
///
/// # Errors
/// As `lath::knot::Knots::new`; B001 where the budget is exceeded.
pub fn elevation(knots: &[Rational], degree: usize, by: usize, limits: &Limits<'_>) -> Result<Refinement> {
    let top = degree.saturating_add(by);
    let count = knots.len().saturating_mul(by.saturating_add(1));
    check(limits, top, count, count, budget::bits(knots), by.saturating_mul(top))?;
    Knots::new(knots.to_vec(), degree)?;
    let (mut now, mut matrix) = (knots.to_vec(), Matrix::identity(knots.len() - degree - 1));
    for p in degree..top {
        limits.check_cancel()?;
        let line = Line::new(&now, p)?;
        let raised = raised(&now, p);
        let row = |j: usize| {
            let arguments = &raised[j + 1..=j + p + 1];
            let without = |skip: usize| [&arguments[..skip], &arguments[skip + 1..]].concat();
            let sets: Vec<Vec<Rational>> = (0..=p).map(without).collect();
            control_point(&line, &raised[j], &sets.iter().map(Vec::as_slice).collect::<Vec<_>>())
        };
        let step = spread((0..raised.len() - p - 2).map(row).collect(), line.functions);
        matrix = step.product(&matrix).unwrap_or(step);
        now = raised;
    }
    Ok(Refinement {
        kind: Refined::Elevated(by),
        degree,
        new_degree: top,
        knots: knots.to_vec(),
        new_knots: now,
        matrix,
    })
}

/// The matrix that raises the degree of a Bézier curve: Qⱼ = j/(p+1) Pⱼ₋₁ + (1 − j/(p+1)) Pⱼ for one degree.
///
/// ```
/// use lath_exact::{answer::elevation_bezier, parse};
///
/// let answer = elevation_bezier(2, 1, &Default::default())?;
/// assert_eq!(answer.matrix.rows()[1], parse::fractions("1/3,2/3,0")?);
/// # Ok::<(), lath_exact::error::Error>(())
/// ```
///
/// # Errors
/// K006 for a degree above 1000; B001 where the budget is exceeded.
pub fn elevation_bezier(degree: usize, by: usize, limits: &Limits<'_>) -> Result<Refinement> {
    let top = degree.saturating_add(by);
    check(limits, top, top, top, 1, by.saturating_mul(top))?;
    elevation(Knots::clamped(degree + 1, degree)?.values(), degree, by, limits)
}

fn check(limits: &Limits<'_>, degree: usize, rows: usize, columns: usize, bits: u64, rounds: usize) -> Result<()> {
    let size = degree.saturating_add(1);
    let bits = bits.saturating_mul(budget::product(&[2, size]));
    budget::check_size(limits, budget::product(&[rows, columns]), bits)?;
    budget::check(limits, budget::product(&[rows, size, size, size, rounds.max(1)]), bits)
}

/// The mean of the blossoms at some sets of arguments, of the span that begins at or before `start`: the index of the
/// first control point, and the weights from it on.
fn control_point(line: &Line, start: &Rational, sets: &[&[Rational]]) -> (usize, Vec<Rational>) {
    let (knots, degree) = (line.knots(), line.knots().degree());
    let span = knots.span(start, Side::Right);
    let units = Weights::units(degree + 1);
    let mut sum = vec![Rational::zero(); degree + 1];
    for arguments in sets {
        let weights = blossom::bspline(knots, span, &units, arguments);
        for (j, x) in sum.iter_mut().enumerate() {
            *x += weights.of(j);
        }
    }
    let count = Rational::from(sets.len() as i64);
    (span - degree, sum.into_iter().map(|x| x / count.clone()).collect())
}

/// Local rows as rows of a matrix over all given functions.
fn spread(rows: Vec<(usize, Vec<Rational>)>, columns: usize) -> Matrix {
    // A local row begins at a place of the longer vector; its weights of functions that were not given are zero.
    let pad = rows.first().map_or(0, |(_, weights)| weights.len());
    Matrix::from_fn(rows.len(), columns, |i, j| {
        let (first, weights) = &rows[i];
        (j + pad).checked_sub(*first).and_then(|place| weights.get(place)).cloned().unwrap_or_else(Rational::zero)
    })
}

/// Every different knot once more, cut to what degree p + 1 needs on the same domain.
fn raised(knots: &[Rational], p: usize) -> Vec<Rational> {
    let mut all = Vec::with_capacity(2 * knots.len());
    for (i, knot) in knots.iter().enumerate() {
        all.push(knot.clone());
        if knots.get(i + 1) != Some(knot) {
            all.push(knot.clone());
        }
    }
    let (from, to) = (&knots[p], &knots[knots.len() - p - 1]);
    let last_start = all.partition_point(|knot| knot <= from) - 1;
    let first_end = all.partition_point(|knot| knot < to);
    let keep = last_start.saturating_sub(p + 1)..(first_end + p + 2).min(all.len());
    all[keep].to_vec()
}
