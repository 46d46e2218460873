//! The matrix of a basis: (tⁿ, …, t, 1) · M · (control points).

use crate::budget;
use crate::error::{Code, Error, Result};
use crate::line::factorials;
use crate::matrix::Matrix;
use crate::polynomial::Polynomial;
use crate::rational::Rational;
use lath::basis::{bspline, hermite};
use lath::error::Limits;
use lath::knot::{Knots, Side};
use lath::num::Scalar;
use std::fmt;
use std::str::FromStr;

/// A way to make one polynomial piece of control points.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Basis {
    /// Uniform B-splines, any degree: Pᵢ(t) of the points Pᵢ₋₁ … Pᵢ₊ₙ₋₁.
    BSpline,
    /// Bernstein polynomials, any degree.
    Bezier,
    /// F₁ … F₄ on the points P_k, P_{k+1} and the derivatives P′_k, P′_{k+1}; degree 3.
    Hermite,
    /// Cubic through P_k and P_{k+1}, with the tangents (P_{k+1} − P_{k−1})/2 and (P_{k+2} − P_k)/2; degree 3.
    CatmullRom,
    /// The same with tangents shortened to (1 − T) of that; T = 0 is Catmull–Rom.
    Cardinal(Rational),
}

impl Basis {
    /// The only degree it has; none if any will do.
    pub fn fixed_degree(&self) -> Option<usize> {
        match self {
            Basis::BSpline | Basis::Bezier => None,
            Basis::Hermite | Basis::CatmullRom | Basis::Cardinal(_) => Some(3),
        }
    }
}

impl fmt::Display for Basis {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Basis::BSpline => f.write_str("bspline"),
            Basis::Bezier => f.write_str("bezier"),
            Basis::Hermite => f.write_str("hermite"),
            Basis::CatmullRom => f.write_str("catmull-rom"),
            Basis::Cardinal(tension) => write!(f, "cardinal:{tension}"),
        }
    }
}

impl FromStr for Basis {
    type Err = Error;

    /// Reads `bspline`, `bezier`, `hermite`, `catmull-rom` or `cardinal:1/2`.
    fn from_str(text: &str) -> Result<Basis> {
        match text.split_once(':') {
            Some(("cardinal", tension)) => Ok(Basis::Cardinal(tension.parse()?)),
            None if text == "bspline" => Ok(Basis::BSpline),
            None if text == "bezier" => Ok(Basis::Bezier),
            None if text == "hermite" => Ok(Basis::Hermite),
            None if text == "catmull-rom" => Ok(Basis::CatmullRom),
            _ => {
                let message = format!("no basis `{text}`; there are bspline, bezier, hermite, catmull-rom, cardinal:T");
                Err(Error::new(Code::X003, message))
            }
        }
    }
}

/// The matrix of a basis.
#[derive(Clone, Debug, PartialEq)]
pub struct BasisMatrix {
    /// The basis.
    pub basis: Basis,
    /// Its degree n.
    pub degree: usize,
    /// M: rows belong to tⁿ, …, t, 1, columns to the control points.
    pub matrix: Matrix,
}

impl BasisMatrix {
    /// The blending functions: column j of M as a polynomial on [0, 1].
    pub fn functions(&self) -> Vec<Polynomial> {
        let column = |j: usize| self.matrix.rows().iter().rev().map(|row| row[j].clone()).collect();
        (0..self.matrix.columns()).map(|j| Polynomial::new(column(j))).collect()
    }
}

/// The matrix of a basis of the given degree.
///
/// *Cost.* O(n³) operations, on fractions of O(n log n) bits.
///
/// ```
/// use lath_exact::answer::{matrix, Basis};
/// use lath_exact::Matrix;
///
/// let bezier = matrix(&Basis::Bezier, 3, &Default::default())?;
/// assert_eq!(bezier.matrix, Matrix::from_ints(&[&[-1, 3, -3, 1], &[3, -6, 3, 0], &[-3, 3, 0, 0], &[1, 0, 0, 0]]));
/// # Ok::<(), lath_exact::error::Error>(())
/// ```
///
/// # Errors
/// X004 for a degree that the basis does not have; B001 where the budget is exceeded.
pub fn matrix(basis: &Basis, degree: usize, limits: &Limits<'_>) -> Result<BasisMatrix> {
    if let Some(only) = basis.fixed_degree().filter(|&only| only != degree) {
        return Err(Error::new(Code::X004, format!("{basis} has degree {only}, not {degree}")));
    }
    let size = degree.saturating_add(1);
    let bits = budget::product(&[2, size, 64 - size.leading_zeros() as usize]);
    budget::check_size(limits, budget::product(&[size, size]), bits)?;
    budget::check(limits, budget::product(&[2, size, size, size]), bits)?;
    let matrix = match basis {
        Basis::BSpline => of_span(&Knots::uniform(size, degree)?),
        // Bernstein polynomials are the B-splines of a single span with clamped knots.
        Basis::Bezier => of_span(&Knots::clamped(size, degree)?),
        Basis::Hermite => hermite_matrix(),
        Basis::CatmullRom => cardinal_matrix(&Rational::zero()),
        Basis::Cardinal(tension) => cardinal_matrix(tension),
    };
    Ok(BasisMatrix { basis: basis.clone(), degree, matrix })
}

/// Row k from below is the k-th derivative of all functions at 0, divided by k!.
fn of_span(knots: &Knots<Rational>) -> Matrix {
    let (zero, degree) = (Rational::zero(), knots.degree());
    let span = knots.span(&zero, Side::Right);
    taylor(&bspline::derivatives(knots, span, &zero, degree))
}

/// From k-th derivatives at 0 as row k: divided by k!, the highest power first.
fn taylor(derivatives: &[Vec<Rational>]) -> Matrix {
    let factorial = factorials(derivatives.len());
    let top = derivatives.len().saturating_sub(1);
    let columns = derivatives.first().map_or(0, Vec::len);
    Matrix::from_fn(derivatives.len(), columns, |i, j| &derivatives[top - i][j] / &factorial[top - i])
}

pub(crate) fn hermite_matrix() -> Matrix {
    let rows = hermite::blending(&Rational::zero(), &Rational::one());
    taylor(&rows.map(|row| row.to_vec()))
}

/// Hermite's matrix on the end points and tangents that four points give.
fn cardinal_matrix(tension: &Rational) -> Matrix {
    let (zero, one) = (Rational::zero(), Rational::one());
    let half = (&one - tension) / Rational::from(2);
    let mut data = Matrix::from_ints(&[&[0, 1, 0, 0], &[0, 0, 1, 0]]).rows().to_vec();
    data.push(vec![-half.clone(), zero.clone(), half.clone(), zero.clone()]);
    data.push(vec![zero.clone(), -half.clone(), zero, half]);
    let hermite = hermite_matrix();
    Matrix::from_fn(4, 4, |i, j| (0..4).map(|k| &hermite.rows()[i][k] * &data[k][j]).sum())
}
