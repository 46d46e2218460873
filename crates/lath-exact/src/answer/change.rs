//! Changing between bases of the polynomials on one interval.

use crate::answer::basis::hermite_matrix;
use crate::budget;
use crate::error::{Code, Error, Result};
use crate::line::factorials;
use crate::matrix::Matrix;
use crate::rational::Rational;
use lath::basis::bspline;
use lath::error::Limits;
use lath::knot::{Knots, Side};
use lath::num::Scalar;
use std::fmt;
use std::str::FromStr;

/// A basis of the polynomials of one degree on an interval [a, b].
#[derive(Clone, Debug, PartialEq)]
pub enum Form {
    /// Control points of a Bézier curve on [a, b].
    Bernstein,
    /// Coefficients of 1, (t − a), (t − a)², …
    Power,
    /// Values at a and b, then derivatives at a and b; degree 3.
    Hermite,
    /// The p + 1 control points that weigh in on [a, b], over uniform knots of which a and b are neighbours.
    BSpline,
    /// The same over these knots; [a, b] lies in one span of their domain.
    Span(Vec<Rational>),
}

impl fmt::Display for Form {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Form::Bernstein => f.write_str("bernstein"),
            Form::Power => f.write_str("power"),
            Form::Hermite => f.write_str("hermite"),
            Form::BSpline => f.write_str("bspline"),
            Form::Span(knots) => {
                let knots: Vec<String> = knots.iter().map(ToString::to_string).collect();
                write!(f, "bspline:{}", knots.join(","))
            }
        }
    }
}

impl FromStr for Form {
    type Err = Error;

    /// Reads `bernstein`, `power`, `hermite`, `bspline`, or `bspline:` with the knots.
    fn from_str(text: &str) -> Result<Form> {
        match text.split_once(':') {
            Some(("bspline", knots)) => Ok(Form::Span(crate::parse::fractions(knots)?)),
            None if text == "bernstein" || text == "bezier" => Ok(Form::Bernstein),
            None if text == "power" => Ok(Form::Power),
            None if text == "hermite" => Ok(Form::Hermite),
            None if text == "bspline" => Ok(Form::BSpline),
            _ => {
                let message = format!("no basis `{text}`; there are bernstein, power, hermite, bspline, bspline:KNOTS");
                Err(Error::new(Code::X003, message))
            }
        }
    }
}

/// A change of basis on one interval.
#[derive(Clone, Debug, PartialEq)]
pub struct Change {
    /// From these coefficients …
    pub from: Form,
    /// … to these.
    pub to: Form,
    /// The degree.
    pub degree: usize,
    /// The interval [a, b].
    pub interval: (Rational, Rational),
    /// Coefficients in `to` = matrix · coefficients in `from`.
    pub matrix: Matrix,
}

/// The matrix from one basis to another, for polynomials of the given degree on an interval.
///
/// *Idea.* Each basis has a matrix B whose columns are its functions in powers of t − a; the change is B_to⁻¹ B_from.
///
/// ```
/// use lath_exact::answer::{change, Form};
/// use lath_exact::Matrix;
///
/// let unit = ("0".parse()?, "1".parse()?);
/// let answer = change(&Form::Power, &Form::Bernstein, 2, unit, &Default::default())?;
/// assert_eq!(answer.matrix.scaled(&"2".parse()?), Matrix::from_ints(&[&[2, 0, 0], &[2, 1, 0], &[2, 2, 2]]));
/// # Ok::<(), lath_exact::error::Error>(())
/// ```
///
/// # Errors
/// X004 for Hermite with another degree than 3; X006 for an interval that is empty or reversed; X007 for one that is not in
/// one span of the knots; as `lath::knot::Knots::new` for the knots; B001 where the budget is exceeded.
pub fn change(
    from: &Form,
    to: &Form,
    degree: usize,
    interval: (Rational, Rational),
    limits: &Limits<'_>,
) -> Result<Change> {
    let (a, b) = &interval;
    if a >= b {
        return Err(Error::new(Code::X006, format!("the interval [{a}, {b}]")));
    }
    let size = degree.saturating_add(1);
    let lengths = [from, to].into_iter().map(|form| match form {
        Form::Span(knots) => budget::bits(knots),
        _ => 1,
    });
    let longest = lengths.max().unwrap_or(1).max(a.bits()).max(b.bits());
    let bits = longest.saturating_mul(budget::product(&[2, size])).saturating_add(budget::product(&[2, size, 10]));
    budget::check_size(limits, budget::product(&[size, size]), bits)?;
    budget::check(limits, budget::product(&[4, size, size, size]), bits)?;
    let (before, after) = (functions(from, degree, a, b)?, functions(to, degree, a, b)?);
    let matrix = after.inverse().and_then(|inverse| inverse.product(&before));
    let singular = || Error::new(Code::Core(lath::error::Code::N001), format!("the basis {to} is singular"));
    Ok(Change { from: from.clone(), to: to.clone(), degree, matrix: matrix.ok_or_else(singular)?, interval })
}

/// Column j holds the coefficients of function j in ascending powers of t − a.
fn functions(form: &Form, degree: usize, a: &Rational, b: &Rational) -> Result<Matrix> {
    let size = degree + 1;
    match form {
        Form::Power => Ok(Matrix::identity(size)),
        Form::Bernstein => {
            let knots = [vec![a.clone(); size], vec![b.clone(); size]].concat();
            of_span(&Knots::new(knots, degree)?, a)
        }
        Form::BSpline => {
            let length = b - a;
            let knot = |i: usize| a + &(&length * &Rational::from(i as i64 - degree as i64));
            of_span(&Knots::new((0..2 * size).map(knot).collect(), degree)?, a)
        }
        Form::Span(values) => {
            let knots = Knots::new(values.clone(), degree)?;
            let (from, to) = knots.domain();
            let span = knots.span(a, Side::Right);
            if *a < from || *b > to || *b > knots.values()[span + 1] {
                let ends = &knots.values()[span..span + 2];
                let message = format!("[{a}, {b}] beside the span [{}, {}]", ends[0], ends[1]);
                return Err(Error::new(Code::X007, message));
            }
            of_span(&knots, a)
        }
        Form::Hermite if degree != 3 => Err(Error::new(Code::X004, format!("hermite has degree 3, not {degree}"))),
        Form::Hermite => {
            // F₁ … F₄ in u = (t − a)/h; derivatives by t are those by u over h, so F₃ and F₄ carry a factor h.
            let (h, unit) = (b - a, hermite_matrix());
            let entry = |k: usize, j: usize| {
                let scale = if j < 2 { Rational::one() } else { h.clone() };
                &(&unit.rows()[3 - k][j] * &scale) / &h.power(k)
            };
            Ok(Matrix::from_fn(4, 4, entry))
        }
    }
}

/// The functions of the span that begins at or before a, by Taylor's formula at a.
fn of_span(knots: &Knots<Rational>, a: &Rational) -> Result<Matrix> {
    let degree = knots.degree();
    let rows = bspline::derivatives(knots, knots.span(a, Side::Right), a, degree);
    let factorial = factorials(degree);
    Ok(Matrix::from_fn(degree + 1, degree + 1, |k, j| &rows[k][j] / &factorial[k]))
}
