//! The system of an interpolating B-spline of any degree, with its numbers.

use crate::answer::{Collocation, SplineEnds};
use crate::budget;
use crate::error::Result;
use crate::explain::Steps;
use crate::print::{Symbol, comma, derived, number_text as text, subscript, sum_text};
use lath::error::Limits;

pub(crate) fn collocation(answer: &Collocation, limits: &Limits<'_>) -> Result<String> {
    let rows = answer.points.iter().chain(&answer.control_points).flatten();
    let bits = budget::bits(rows.chain(&answer.knots).chain(answer.equations.iter().flat_map(|e| &e.weights)));
    let row = answer.degree + 2 * answer.points.first().map_or(0, Vec::len) + 2;
    budget::check_size(limits, budget::product(&[answer.points.len() + answer.equations.len(), row]), bits)?;
    let (p, n) = (answer.degree, answer.control_points.len());
    let mut steps = Steps::new(&format!(
        "The B-spline of degree {p} through {} points, ends: {}",
        answer.points.len(),
        answer.ends
    ));
    steps.step(match p % 2 {
        1 => "The degree is odd: the knots stand at the parameters of the points.",
        _ => "The degree is even: the knots stand in the middles between the parameters, the points inside the spans.",
    });
    match answer.ends {
        SplineEnds::NotAKnot => steps.line(&format!(
            "The {} next to each end are left out, the ends repeated {} times: as many functions as points.",
            p / 2,
            p + 1
        )),
        SplineEnds::Natural => steps.line(&format!("The ends are repeated {} times.", p + 1)),
        SplineEnds::Closed => steps.line("The period is repeated on both sides: as many functions as points go round."),
    }
    steps.formula(&format!("knots {}", comma(&answer.knots)));
    steps.step("The functions at each parameter weigh the control points; that is one equation a condition:");
    for equation in &answer.equations {
        let terms: Vec<_> = equation
            .weights
            .iter()
            .enumerate()
            .map(|(k, w)| (w.clone(), Symbol::Indexed('C', (equation.first + k) % n)))
            .collect();
        let left = format!("{}({})", derived('P', equation.order).0, text(&equation.t));
        steps.formula(&format!("{left} = {} = ({})", sum_text(&terms), comma(&equation.right)));
    }
    steps.step("Solved:");
    for (i, point) in answer.control_points.iter().enumerate() {
        steps.formula(&format!("C{} = ({})", subscript(i), comma(point)));
    }
    Ok(steps.finish())
}
