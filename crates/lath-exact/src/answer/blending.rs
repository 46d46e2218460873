//! B-splines as polynomials, piece by piece over their whole support.

use crate::budget;
use crate::error::Result;
use crate::line::{Line, factorials};
use crate::polynomial::Polynomial;
use crate::rational::Rational;
use lath::basis::bspline;
use lath::error::Limits;
use lath::knot::Side;
use lath::num::Scalar;
use std::collections::BTreeMap;

/// All B-splines of one knot vector.
#[derive(Clone, Debug, PartialEq)]
pub struct Blending {
    /// The degree p.
    pub degree: usize,
    /// The knots.
    pub knots: Vec<Rational>,
    /// N₀, N₁, …
    pub functions: Vec<Function>,
}

/// One B-spline.
#[derive(Clone, Debug, PartialEq)]
pub struct Function {
    /// Its index i: it lives on [tᵢ, t_{i+p+1}].
    pub index: usize,
    /// Its polynomials on the spans of its support that are not empty, from left to right.
    pub pieces: Vec<Piece>,
}

/// A polynomial on one span.
#[derive(Clone, Debug, PartialEq)]
pub struct Piece {
    /// The span's left end.
    pub from: Rational,
    /// The span's right end.
    pub to: Rational,
    /// The polynomial in t itself, not in t − from.
    pub polynomial: Polynomial,
}

impl Blending {
    /// [t_p, t_n], where the functions sum to 1; none if it is empty.
    pub fn domain(&self) -> Option<(Rational, Rational)> {
        let (from, to) = (self.knots.get(self.degree)?, self.knots.get(self.functions.len())?);
        (from < to).then(|| (from.clone(), to.clone()))
    }

    /// The different knots with their multiplicities, from left to right.
    pub fn multiplicities(&self) -> Vec<(Rational, usize)> {
        let mut all: Vec<(Rational, usize)> = Vec::new();
        for knot in &self.knots {
            match all.last_mut() {
                Some((last, count)) if last == knot => *count += 1,
                _ => all.push((knot.clone(), 1)),
            }
        }
        all
    }

    /// The sum of all functions, as one more piecewise polynomial: 1 on the domain.
    pub fn sum(&self) -> Vec<Piece> {
        let mut sums: BTreeMap<&Rational, Polynomial> = BTreeMap::new();
        for piece in self.functions.iter().flat_map(|f| &f.pieces) {
            let sum = sums.entry(&piece.from).or_default();
            *sum = &*sum + &piece.polynomial;
        }
        let spans = self.knots.windows(2).filter(|pair| pair[0] < pair[1]);
        spans
            .map(|pair| {
                let polynomial = sums.remove(&pair[0]).unwrap_or_default();
                Piece { from: pair[0].clone(), to: pair[1].clone(), polynomial }
            })
            .collect()
    }
}

impl Function {
    /// The piece that answers for t from the given side; none outside the support.
    pub fn piece(&self, t: &Rational, side: Side) -> Option<&Piece> {
        self.pieces.iter().find(|piece| match side {
            Side::Right => piece.from <= *t && *t < piece.to,
            Side::Left => piece.from < *t && *t <= piece.to,
        })
    }

    /// The value at t from the given side, zero outside the support.
    pub fn eval(&self, t: &Rational, side: Side) -> Rational {
        self.piece(t, side).map_or_else(Rational::zero, |piece| piece.polynomial.eval(t))
    }
}

/// Every B-spline of the knots as polynomials on all spans of its support, also outside the domain; empty spans are left
/// out. There need be no domain: p + 2 knots are enough for a single function.
///
/// *Cost.* O(p³) operations for each span.
///
/// ```
/// use lath_exact::{answer::blending, parse};
///
/// let answer = blending(&parse::fractions("0,0,0,1,2,3,3,3")?, 2, &Default::default())?;
/// let pieces = &answer.functions[2].pieces;
/// assert_eq!(pieces[1].polynomial.to_string(), "(−2t² + 6t − 3)/2");
/// # Ok::<(), lath_exact::error::Error>(())
/// ```
///
/// # Errors
/// K001 for fewer than p + 2 knots; K003, K004, K007 with the index of the knot at fault; K006 for a degree above 1000;
/// B001 where the budget is exceeded.
pub fn blending(knots: &[Rational], degree: usize, limits: &Limits<'_>) -> Result<Blending> {
    let size = degree.saturating_add(1);
    let bits = budget::bits(knots).saturating_mul(size as u64);
    budget::check_size(limits, budget::product(&[knots.len(), size, size]), bits)?;
    budget::check(limits, budget::product(&[3, knots.len(), size, size, size]), bits)?;
    let line = Line::new(knots, degree)?;
    let (zero, factorial) = (Rational::zero(), factorials(degree));
    let mut functions: Vec<Function> =
        (0..line.functions).map(|index| Function { index, pieces: Vec::new() }).collect();
    for span in line.spans() {
        limits.check_cancel()?;
        // Taylor's formula at t = 0, where the polynomials of the span are extended to.
        let derivatives = bspline::derivatives(line.knots(), span, &zero, degree);
        let ends = &line.knots().values()[span..span + 2];
        for j in 0..=degree {
            let Some(index) = line.function(span + j - degree) else { continue };
            let coefficients = (0..=degree).map(|k| &derivatives[k][j] / &factorial[k]).collect();
            let polynomial = Polynomial::new(coefficients);
            functions[index].pieces.push(Piece { from: ends[0].clone(), to: ends[1].clone(), polynomial });
        }
    }
    Ok(Blending { degree, knots: knots.to_vec(), functions })
}
