//! From the mask to the limit: the local matrix, its eigenvectors, and what their powers leave.

use crate::answer::{Decomposition, SchemeAnswer, Spectrum};
use crate::budget;
use crate::error::Result;
use crate::explain::Steps;
use crate::print::{Symbol, comma, matrix_lines, number_text as text, subscript, sum_text, superscript, vector_line};
use crate::rational::Rational;
use lath::error::Limits;

fn points(weights: &[Rational]) -> String {
    let terms: Vec<_> = weights.iter().enumerate().map(|(j, w)| (w.clone(), Symbol::Indexed('P', j))).collect();
    sum_text(&terms)
}

pub(crate) fn scheme(answer: &SchemeAnswer, limits: &Limits<'_>) -> Result<String> {
    let p = answer.scheme.degree();
    let bits = match &answer.spectrum {
        Spectrum::Exact(a) => budget::bits(a.q.entries().chain(a.q_inverse.entries()).chain(answer.matrix.entries())),
        Spectrum::Numeric(_) | Spectrum::Unknown => budget::bits(answer.matrix.entries()),
    };
    budget::check_size(limits, budget::product(&[8, p + 2, p + 2]), bits)?;
    budget::check(limits, budget::product(&[p, p, p]), bits)?;
    let (scheme, p) = (&answer.scheme, answer.scheme.degree());
    let mut steps = Steps::new(&format!("Subdivision of degree {p}: from the mask to the limit"));

    steps.step(&format!("The mask a₀ … a{} and the rule.", subscript(p + 1)));
    steps.formula(&vector_line("a", scheme.mask(), true));
    if scheme.is_spline() {
        steps.line(&format!(
            "These are the binomial coefficients C({}, i) over 2{}: Lane and Riesenfeld's scheme.",
            p + 1,
            superscript(p)
        ));
    }
    steps.line(&format!(
        "The new point i is Qᵢ = Σⱼ a_{{i+{p}−2j}} Pⱼ: even and odd new points take every other number of the mask,"
    ));
    steps.line("which sum to 1 each. For the points P₀, P₁, …:");
    for (i, row) in answer.group_matrix.rows().iter().enumerate() {
        steps.formula(&format!("Q{} = {}", subscript(i), points(row)));
    }

    steps.step(&format!(
        "The local matrix. {p} neighbours, P₀ … P{}, determine the {p} neighbours Q₀ … Q{}: Q = A P,",
        subscript(p - 1),
        subscript(p - 1)
    ));
    steps.line(
        "and these determine as many neighbours of the next level by the same A, at the same place of the curve.",
    );
    steps.line("");
    steps.formulas(&matrix_lines("A", &answer.matrix, true));
    steps.line("");
    steps.line("So the neighbours after k levels are Aᵏ P, and as k grows they all tend to one point of the curve.");

    match &answer.spectrum {
        Spectrum::Exact(a) => eigenvectors(&mut steps, answer, a),
        Spectrum::Numeric(_) => {
            steps.step("The eigenvalues of A are not all rational: there is no exact diagonal form.")
        }
        Spectrum::Unknown => steps.step("A is too large for its eigenvalues to be looked for."),
    }
    masks(&mut steps, answer);
    Ok(steps.finish())
}

fn eigenvectors(steps: &mut Steps, answer: &SchemeAnswer, a: &Decomposition) {
    let columns = a.q.transposed();
    steps.step(&format!("The eigenvalues, the roots λ of det(A − λ) = 0: {}.", comma(&a.eigenvalues)));
    steps.line("Each solves (A − λ) v = 0 with a vector v, scaled to end in 1 where it can:");
    let mut place = 0;
    for size in &a.blocks {
        let lambda = &a.eigenvalues[place];
        let v = &columns.rows()[place];
        steps.formula(&format!(
            "λ = {}:  v = ({}),  A v = ({})",
            text(lambda),
            comma(v),
            comma(&answer.matrix.applied(v).unwrap_or_default())
        ));
        for extra in place + 1..place + size {
            let (w, before) = (&columns.rows()[extra], &columns.rows()[extra - 1]);
            let image = answer.matrix.applied(w).unwrap_or_default();
            steps.formula(&format!(
                "      no second eigenvector, but w = ({}) with A w = ({})",
                comma(w),
                comma(&image)
            ));
            steps.formula(&format!("      = {} w + ({})", text(lambda), comma(before)));
        }
        place += size;
    }

    let (form, middle) = if a.is_defective() { ("J", "J") } else { ("Λ", "Λ") };
    steps.step(&format!("With these vectors as the columns of Q, A = Q {middle} Q⁻¹."));
    steps.line("");
    steps.formulas(&matrix_lines("Q", &a.q, false));
    steps.line("");
    steps.formulas(&matrix_lines("Q⁻¹", &a.q_inverse, true));
    if a.is_defective() {
        steps.line("");
        steps.formulas(&matrix_lines("J", &a.jordan, false));
        steps.line("");
        steps.line(
            "A has too few eigenvectors for a diagonal form; J has a 1 above the diagonal where w stands in for one.",
        );
    }

    let below = a.eigenvalues.iter().rev().skip(1).all(|x| x.abs() < 1);
    let top = a.eigenvalues.last().is_some_and(|x| *x == 1);
    if !(below && top) {
        return;
    }
    steps.step(&format!(
        "The powers. Aᵏ = Q {form}ᵏ Q⁻¹, and all eigenvalues but 1 are below 1 in magnitude: their powers vanish."
    ));
    let last = columns.rows().last().map(|v| comma(v)).unwrap_or_default();
    steps.line(&format!("What is left of Q {form}ᵏ Q⁻¹ is the last column of Q, ({last}), times the last row of Q⁻¹:"));
    if let Some(row) = a.q_inverse.rows().last() {
        let p = answer.scheme.degree();
        let limit = crate::matrix::Matrix::from_fn(p, p, |_, j| row[j].clone());
        steps.line("");
        steps.formulas(&matrix_lines("A^∞", &limit, true));
        steps.line("");
        steps.line("All its rows are equal: all neighbours tend to the same point.");
    }
}

fn masks(steps: &mut Steps, answer: &SchemeAnswer) {
    match &answer.limit {
        Some(limit) => {
            steps.step("The limit. With the weights of that row, the left eigenvector for 1, which sum to 1, the neighbours tend to");
            steps.formula(&points(limit));
        }
        None => steps.step("The limit: convergence of this scheme is not proven."),
    }
    match &answer.tangent {
        Some(tangent) => {
            steps.step("The tangent. Neighbours are half as far apart at each level: differences shrink with ½, and the left eigenvector for ½,");
            steps.line("scaled so that points on a line at distance 1 (Pⱼ = j) get the slope 1, gives it. At level k, 2ᵏ times");
            steps.formula(&points(tangent));
        }
        None => steps.step("The tangent: none is proven to exist."),
    }
    match &answer.second {
        Some(second) => {
            steps.step(
                "The second derivative. Second differences shrink with ¼, and the left eigenvector for ¼, scaled so that",
            );
            steps.line("points on a parabola (Pⱼ = j²) get the second derivative 2, gives it. At level k, 4ᵏ times");
            steps.formula(&points(second));
        }
        None => no_second(steps, answer),
    }
}

fn no_second(steps: &mut Steps, answer: &SchemeAnswer) {
    let quarter = Rational::from(1) / Rational::from(4);
    let defect = match &answer.spectrum {
        Spectrum::Exact(a) => {
            let mut place = 0;
            a.blocks.iter().any(|size| {
                place += size;
                *size > 1 && a.eigenvalues[place - size] == quarter
            })
        }
        _ => false,
    };
    if defect {
        steps.step("The second derivative: there is none. The eigenvalue ¼ lacks an eigenvector, and the power of its block is");
        steps.formula("[¼ 1; 0 ¼]ᵏ = [4⁻ᵏ k·4¹⁻ᵏ; 0 4⁻ᵏ]:");
        steps.line("times 4ᵏ, its corner grows like 4k. Second differences do not settle.");
    } else if answer.scheme.degree() < 3 && answer.scheme.is_spline() {
        steps.step(
            "The second derivative: there is none. The curve is made of pieces whose second derivatives do not agree.",
        );
    } else {
        steps.step("The second derivative: none is proven to exist.");
    }
}
