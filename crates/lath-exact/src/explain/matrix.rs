//! Where the matrix of a basis comes from.

use crate::answer::{Basis, BasisMatrix};
use crate::budget;
use crate::error::Result;
use crate::explain::Steps;
use crate::matrix::Matrix;
use crate::polynomial::Polynomial;
use crate::print::{matrix_lines, number_text as text, subscript, superscript};
use crate::rational::Rational;
use lath::error::Limits;

pub(crate) fn matrix(answer: &BasisMatrix, limits: &Limits<'_>) -> Result<String> {
    // The functions of every degree up to the last.
    let size = answer.degree + 1;
    let bits = budget::product(&[2, size, size.ilog2() as usize + 1]);
    budget::check_size(limits, budget::product(&[size, size, size]), bits / 2)?;
    budget::check(limits, budget::product(&[4, size, size, size]), bits)?;
    Ok(match &answer.basis {
        Basis::BSpline => bspline(answer),
        Basis::Bezier => bezier(answer),
        Basis::Hermite => hermite(answer),
        Basis::CatmullRom => cardinal(answer, &Rational::from(0)),
        Basis::Cardinal(tension) => cardinal(answer, tension),
    })
}

fn polynomial(coefficients: &[i64]) -> Polynomial {
    Polynomial::new(coefficients.iter().map(|c| Rational::from(*c)).collect())
}

fn bspline(answer: &BasisMatrix) -> String {
    let n = answer.degree;
    let mut steps = Steps::new(&format!("The matrix of uniform B-splines of degree {n}"));
    steps.step("Take the integers as knots, tⱼ = j, and the segment 0 ≤ t ≤ 1.");
    if n == 0 {
        steps.line("N₀ of degree 0 lives on [0, 1]: on the segment it alone is not zero.");
    } else {
        steps.line(&format!(
            "Nᵢ of degree {n} lives on [i, i + {}]: on the segment only N₋{} … N₀ are not zero,",
            n + 1,
            subscript(n)
        ));
        steps.line(&format!(
            "one for each of the {} control points. We count them from the left as B₀ … B{}.",
            n + 1,
            subscript(n)
        ));
    }
    steps.step("The recurrence. All knot differences of degree r are r, so on the segment");
    steps.formula("Nᵢ,ᵣ = ((t − i) Nᵢ,ᵣ₋₁ + (i + r + 1 − t) Nᵢ₊₁,ᵣ₋₁)/r.");
    steps.line("");
    steps.formula("N₀,₀ = 1");
    let mut row = vec![polynomial(&[1])];
    for r in 1..=n {
        let next = |j: usize| {
            let i = j as i64 - r as i64;
            let left = j.checked_sub(1).map(|place| &polynomial(&[-i, 1]) * &row[place]).unwrap_or_default();
            let right = row.get(j).map(|below| &polynomial(&[i + r as i64 + 1, -1]) * below).unwrap_or_default();
            (&left + &right).scaled(&(Rational::from(1) / Rational::from(r as i64)))
        };
        let made: Vec<Polynomial> = (0..=r).map(next).collect();
        row = made;
        steps.line("");
        for (j, p) in row.iter().enumerate() {
            let i = r - j;
            let index = if i == 0 { subscript(0) } else { format!("₋{}", subscript(i)) };
            steps.formula(&format!("N{index},{} = {p}", subscript(r)));
        }
    }
    steps.step("Column j of M holds the coefficients of Bⱼ, the highest power first:");
    steps.line("");
    steps.formulas(&matrix_lines("M", &answer.matrix, true));
    check(&mut steps, answer);
    steps.finish()
}

fn bezier(answer: &BasisMatrix) -> String {
    let n = answer.degree;
    let mut steps = Steps::new(&format!("The matrix of Bézier curves of degree {n}"));
    steps.step("The blending functions are the Bernstein polynomials");
    steps.formula("Jₙ,ᵢ(t) = C(n, i) tⁱ (1 − t)ⁿ⁻ⁱ:");
    steps.line(&format!("the terms of (t + (1 − t)){} = 1. Multiplied out,", superscript(n)));
    let (t, rest) = (polynomial(&[0, 1]), polynomial(&[1, -1]));
    let mut choose = Rational::from(1);
    for i in 0..=n {
        let product = (0..n).fold(polynomial(&[1]), |product, k| &product * if k < i { &t } else { &rest });
        let factor = if choose == 1 { String::new() } else { text(&choose) };
        let rise = if i == 0 { String::new() } else { format!("t{}", superscript(i)) };
        let fall = if i == n { String::new() } else { format!("(1 − t){}", superscript(n - i)) };
        let shown = factor + &rise + &fall;
        let shown = if shown.is_empty() { "1".to_owned() } else { shown };
        let expanded = product.scaled(&choose).to_string();
        let again = if expanded == shown { String::new() } else { format!(" = {expanded}") };
        steps.formula(&format!("J{},{} = {shown}{again}", subscript(n), subscript(i)));
        choose = choose * Rational::from((n - i) as i64) / Rational::from(i as i64 + 1);
    }
    steps.step("Column i of M holds the coefficients of Jₙ,ᵢ, the highest power first:");
    steps.line("");
    steps.formulas(&matrix_lines("M", &answer.matrix, true));
    check(&mut steps, answer);
    steps.finish()
}

/// The matrix whose rows are the four data as functions of the coefficients of t³, t², t, 1.
fn data() -> Matrix {
    Matrix::from_ints(&[&[0, 0, 0, 1], &[1, 1, 1, 1], &[0, 0, 1, 0], &[3, 2, 1, 0]])
}

fn hermite_steps(steps: &mut Steps) -> Matrix {
    steps.step("A cubic P(t) = a t³ + b t² + c t + d is fixed by four data: its ends and its end tangents.");
    steps.formula("P(0) = d");
    steps.formula("P(1) = a + b + c + d");
    steps.formula("P′(0) = c");
    steps.formula("P′(1) = 3a + 2b + c");
    steps.line("As a matrix, (P₀, P₁, P′₀, P′₁)ᵀ = D · (a, b, c, d)ᵀ with");
    steps.line("");
    steps.formulas(&matrix_lines("D", &data(), true));
    let inverse = data().inverse().unwrap_or_else(|| Matrix::identity(4));
    steps.step("The coefficients from the data: the inverse.");
    steps.line("");
    steps.formulas(&matrix_lines("D⁻¹", &inverse, true));
    inverse
}

fn hermite(answer: &BasisMatrix) -> String {
    let mut steps = Steps::new("The matrix of cubic Hermite curves");
    hermite_steps(&mut steps);
    steps.step("This is M. Its columns are the blending functions:");
    for (j, (p, of)) in answer.functions().iter().zip(["P₀", "P₁", "P′₀", "P′₁"]).enumerate() {
        steps.formula(&format!("F{} = {p}, which multiplies {of}", subscript(j + 1)));
    }
    steps.step("Check: F₁ is 1 at t = 0 and F₂ is 1 at t = 1, all other values there are 0.");
    steps.line("F₃ has slope 1 at t = 0 and F₄ at t = 1, all other slopes there are 0. And F₁ + F₂ = 1.");
    steps.finish()
}

fn cardinal(answer: &BasisMatrix, tension: &Rational) -> String {
    let s = (Rational::from(1) - tension.clone()) / Rational::from(2);
    let title = if *tension == 0 {
        "Catmull–Rom splines".to_owned()
    } else {
        format!("cardinal splines of tension {}", text(tension))
    };
    let mut steps = Steps::new(&format!("The matrix of {title}"));
    hermite_steps(&mut steps);
    steps.step("The segment runs from P₁ to P₂; its end tangents are parallel to the chords over the neighbours:");
    steps.formula(&format!("P′(0) = s (P₂ − P₀), P′(1) = s (P₃ − P₁), s = (1 − {})/2 = {}.", text(tension), text(&s)));
    let minus = -s.clone();
    let zero = Rational::from(0);
    let rows = [
        [0, 1, 0, 0].map(Rational::from).to_vec(),
        [0, 0, 1, 0].map(Rational::from).to_vec(),
        vec![minus.clone(), zero.clone(), s.clone(), zero.clone()],
        vec![zero.clone(), minus, zero, s],
    ];
    let ends = Matrix::from_fn(4, 4, |i, j| rows[i][j].clone());
    steps.line("As a matrix, (P(0), P(1), P′(0), P′(1))ᵀ = E · (P₀, P₁, P₂, P₃)ᵀ with");
    steps.line("");
    steps.formulas(&matrix_lines("E", &ends, true));
    steps.step("M = D⁻¹ · E:");
    steps.line("");
    steps.formulas(&matrix_lines("M", &answer.matrix, true));
    check(&mut steps, answer);
    steps.finish()
}

/// The functions sum to 1: so does the last row, and every other one sums to 0.
fn check(steps: &mut Steps, answer: &BasisMatrix) {
    let sums: Vec<String> =
        answer.matrix.rows().iter().map(|row| text(&row.iter().cloned().sum::<Rational>())).collect();
    steps.step(&format!("Check: the functions sum to 1 for every t, so the rows of M sum to {}.", sums.join(", ")));
}
