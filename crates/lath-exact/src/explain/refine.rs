//! Knots inserted, degrees raised, bases changed: by blossoms.

use crate::answer::{Change, Form, Greville, Refined, Refinement};
use crate::budget;
use crate::error::Result;
use crate::explain::Steps;
use crate::print::{Symbol, comma, matrix_lines, number_text as text, subscript, sum_text};
use lath::error::Limits;

pub(crate) fn greville(answer: &Greville, limits: &Limits<'_>) -> Result<String> {
    let bits = budget::bits(&answer.knots);
    budget::check_size(limits, budget::product(&[answer.knots.len(), answer.degree + 2]), bits)?;
    let p = answer.degree;
    let mut steps = Steps::new("The Greville abscissae: where the control points stand");
    steps.step("If every control point stands over its abscissa, Pᵢ = ξᵢ, the curve is t itself.");
    steps.line(&format!(
        "The blossom of t has the arguments' mean for its value, and Pᵢ is the blossom at the {p} knots after tᵢ:"
    ));
    steps.formula("ξᵢ = (tᵢ₊₁ + … + tᵢ₊ₚ)/p.");
    for (i, x) in answer.abscissae.iter().enumerate() {
        if p == 0 {
            steps.formula(&format!("ξ{} = {}, the middle of the span", subscript(i), text(x)));
        } else {
            let of = comma(&answer.knots[i + 1..=i + p]).replace(", ", " + ").replace("+ −", "− ");
            steps.formula(&format!("ξ{} = ({of})/{p} = {}", subscript(i), text(x)));
        }
    }
    Ok(steps.finish())
}

pub(crate) fn refinement(answer: &Refinement, limits: &Limits<'_>) -> Result<String> {
    let (rows, columns) = (answer.matrix.rows().len(), answer.matrix.columns());
    let bits = budget::bits(answer.matrix.entries().chain(&answer.new_knots));
    budget::check_size(limits, budget::product(&[2, rows + 2, columns + answer.new_degree + 2]), bits)?;
    let (p, q) = (answer.degree, answer.new_degree);
    let title = match &answer.kind {
        Refined::Inserted(knots) => format!("Inserting {} into a spline of degree {p}", comma(knots)),
        Refined::Elevated(_) => format!("Raising the degree from {p} to {q}"),
    };
    let mut steps = Steps::new(&title);
    steps.step("The knots before and after:");
    steps.formula(&format!("before: {}", comma(&answer.knots)));
    steps.formula(&format!("after:  {}", comma(&answer.new_knots)));
    match &answer.kind {
        Refined::Inserted(_) => {
            steps.step(&format!("Control point j is the curve's blossom at the {p} knots after the j-th. The curve stays, so its blossom stays:"));
            steps.line("the new control points are the old blossom at the new knots.");
        }
        Refined::Elevated(_) => {
            steps.step("Every knot of the domain is repeated once more for each degree, so that the smoothness stays what it is.");
            steps.line("The blossom of one argument more is the mean of the old blossoms that leave one argument out:");
            steps.formula("B(u₁, …, uₚ₊₁) = (b(u₂, …, uₚ₊₁) + b(u₁, u₃, …) + … + b(u₁, …, uₚ))/(p + 1).");
        }
    }
    steps.step("New control points from old ones:");
    for (j, row) in answer.matrix.rows().iter().enumerate() {
        let terms: Vec<_> = row.iter().enumerate().map(|(i, w)| (w.clone(), Symbol::Indexed('P', i))).collect();
        let at = comma(&answer.new_knots[j + 1..=j + q]);
        steps.formula(&format!("Q{} = B({at}) = {}", subscript(j), sum_text(&terms)));
    }
    steps.step("As a matrix, Q = A P:");
    steps.line("");
    steps.formulas(&matrix_lines("A", &answer.matrix, true));
    Ok(steps.finish())
}

pub(crate) fn change(answer: &Change, limits: &Limits<'_>) -> Result<String> {
    let size = answer.degree + 1;
    budget::check_size(limits, budget::product(&[size, size]), budget::bits(answer.matrix.entries()))?;
    let (a, b) = (text(&answer.interval.0), text(&answer.interval.1));
    let mut steps =
        Steps::new(&format!("From {} to {}, degree {}, on [{a}, {b}]", answer.from, answer.to, answer.degree));
    steps.step(&format!("Each basis has a matrix whose columns are its functions in powers of t − {a}:"));
    steps.line("B for the one we come from, D for the one we go to.");
    for form in [&answer.from, &answer.to] {
        steps.formula(&match form {
            Form::Bernstein => format!("bernstein: C(n, i) uⁱ (1 − u)ⁿ⁻ⁱ with u = (t − {a})/({b} − {a})"),
            Form::Power => format!("power: 1, t − {a}, (t − {a})², …, whose matrix is the identity"),
            Form::Hermite => format!("hermite: F₁ … F₄ on the values and derivatives at {a} and {b}"),
            Form::BSpline => format!("bspline: the B-splines over uniform knots of which {a} and {b} are neighbours"),
            Form::Span(knots) => format!("bspline: the B-splines over {} that are not zero there", comma(knots)),
        });
    }
    steps.step("The polynomial is the same: B · (before) = D · (after). So (after) = D⁻¹ B · (before), and C = D⁻¹ B:");
    steps.line("");
    steps.formulas(&matrix_lines("C", &answer.matrix, true));
    Ok(steps.finish())
}
