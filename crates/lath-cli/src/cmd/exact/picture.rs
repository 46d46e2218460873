//! Blending functions as curves over t.

use lath::curve::Power;
use lath::error::Result;
use lath_draw::figure::Figure;
use lath_draw::layer::{CurveLayer, PointLayer, indexed};
use lath_exact::answer::{Basis, BasisMatrix, Blending, Piece};
use lath_exact::{Polynomial, Rational};

/// The blending functions of a basis on [0, 1], as textbooks draw them.
pub(crate) fn basis(answer: &BasisMatrix) -> Result<Figure> {
    let (zero, one) = (Rational::from(0), Rational::from(1));
    let (letter, first) = match answer.basis {
        Basis::Hermite => ('F', 1),
        Basis::Bezier => ('J', 0),
        Basis::BSpline | Basis::CatmullRom | Basis::Cardinal(_) => ('N', 0),
    };
    let mut figure = Figure::new().axes(true).size(960.0, 600.0).density(2.0).axis_names(["t", ""]);
    for (i, polynomial) in answer.functions().into_iter().enumerate() {
        let piece = Piece { from: zero.clone(), to: one.clone(), polynomial };
        figure = figure.curve(layer(&[piece], answer.degree)?.label(indexed(letter, first + i)));
    }
    Ok(figure)
}

/// B-splines over their whole supports, their sum, and the knots below them, each as often as it is repeated.
pub(crate) fn blending(answer: &Blending) -> Result<Figure> {
    let mut figure = Figure::new().axes(true).size(960.0, 600.0).density(2.0).axis_names(["t", ""]);
    for function in answer.functions.iter().filter(|function| !function.pieces.is_empty()) {
        figure = figure.curve(layer(&function.pieces, answer.degree)?.label(indexed('N', function.index)));
    }
    let sum = answer.sum();
    if !sum.is_empty() {
        let grey = lath_draw::theme::Color::new(0x88, 0x88, 0x88);
        figure = figure.curve(layer(&sum, answer.degree)?.label("sum").color(grey));
    }
    /// How far the dots of one knot stand below each other.
    const STEP: f64 = 0.045;
    let (mut t, mut heights) = (Vec::new(), Vec::new());
    for (knot, multiplicity) in answer.multiplicities() {
        for row in 1..=multiplicity {
            t.push(knot.to_f64());
            heights.push(-STEP * row as f64);
        }
    }
    Ok(figure.points(PointLayer::graph(&t, &heights)?.label("knots")))
}

/// Neighbouring polynomials as one curve.
fn layer(pieces: &[Piece], degree: usize) -> Result<CurveLayer> {
    let mut breaks: Vec<f64> = pieces.iter().map(|piece| piece.from.to_f64()).collect();
    breaks.extend(pieces.last().map(|piece| piece.to.to_f64()));
    let local = |piece: &Piece| -> Vec<[f64; 1]> {
        let shifted: Polynomial = piece.polynomial.shifted(&piece.from);
        (0..=degree).map(|k| [shifted.coefficient(k).to_f64()]).collect()
    };
    CurveLayer::of(Power::new(breaks, pieces.iter().map(local))?)
}
