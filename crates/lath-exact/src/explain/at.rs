//! Which control points weigh in at a parameter, and why: the recurrence of Cox and de Boor.

use crate::answer::At;
use crate::budget;
use crate::error::Result;
use crate::explain::Steps;
use crate::print::{Symbol, comma, derived, number_text as text, subscript, sum_text};
use crate::rational::Rational;
use lath::error::Limits;
use lath::knot::Side;

/// N₃,₂: index 3, degree 2; with marks for derivatives.
fn name(i: usize, r: usize, order: usize) -> String {
    format!("{}{},{}", derived('N', order).0, subscript(i), subscript(r))
}

pub(crate) fn at(answer: &At, limits: &Limits<'_>) -> Result<String> {
    // Each line of the triangles names a function, its two factors, and their numbers.
    let size = answer.knots.degree() + 1;
    let bits = budget::bits(answer.knots.values()).max(answer.t.bits()).saturating_mul(budget::product(&[2, size]));
    budget::check_size(limits, budget::product(&[4, size, size]), bits)?;
    budget::check(limits, budget::product(&[4, size, size]), bits)?;
    let (knots, p, span) = (answer.knots.values(), answer.knots.degree(), answer.span);
    let (t, n) = (text(&answer.t), answer.knots.functions());
    let mut steps = Steps::new(&format!("Which control points weigh in at t = {t}, and why"));

    let (from, to) = answer.knots.domain();
    steps.step(&format!("The knots are {}.", comma(knots)));
    steps.line(&format!(
        "{} knots of degree {p} carry {} − {p} − 1 = {n} functions, one for each control point P₀ … P{}.",
        knots.len(),
        knots.len(),
        subscript(n - 1)
    ));
    steps.line(&format!(
        "They sum to 1 on the domain [t{}, t{}] = [{}, {}], and t = {t} lies in it.",
        subscript(p),
        subscript(n),
        text(&from),
        text(&to)
    ));

    let (a, b) = (&knots[span], &knots[span + 1]);
    let (below, above) = match answer.side {
        Side::Right => ("≤", "<"),
        Side::Left => ("<", "≤"),
    };
    steps.step(&format!(
        "The span. t{} = {} {below} {t} {above} {} = t{}, so span {span} answers.",
        subscript(span),
        text(a),
        text(b),
        subscript(span + 1)
    ));
    if answer.side == Side::Left {
        steps.line("The parameter is the right end of this span: it is answered from the left.");
    } else if answer.t == *a {
        steps.line("The parameter is the left end of this span: spans are closed on the left and open on the right.");
    }
    steps.line(&format!(
        "N{} lives on [tᵢ, t{}] only, so on this span {} zero, and only {} in.",
        "ᵢ",
        index_plus(p + 1),
        if p == 0 {
            format!("all functions but N{} are", subscript(span))
        } else {
            format!("all functions but N{} … N{} are", subscript(answer.first), subscript(span))
        },
        if p == 0 {
            format!("P{} weighs", subscript(span))
        } else {
            format!("P{} … P{} weigh", subscript(answer.first), subscript(span))
        },
    ));

    if answer.derivative > p {
        steps.step(&format!(
            "Every function is a polynomial of degree {p} on the span; its derivative of order {} is zero.",
            answer.derivative
        ));
        return Ok(steps.finish());
    }
    let order = answer.derivative;
    steps.step("The recurrence. Nᵢ,₀ is 1 on its own span and 0 elsewhere; then, degree by degree,");
    steps
        .formula("Nᵢ,ᵣ(t) = (t − tᵢ)/(tᵢ₊ᵣ − tᵢ) · Nᵢ,ᵣ₋₁(t) + (tᵢ₊ᵣ₊₁ − t)/(tᵢ₊ᵣ₊₁ − tᵢ₊₁) · Nᵢ₊₁,ᵣ₋₁(t),   0/0 = 0.");
    steps.line("Terms with a function that is zero on this span are left out.");
    let mut row = vec![Rational::from(1)];
    steps.line("");
    steps.formula(&format!("{} = 1", name(span, 0, 0)));
    for r in 1..=p - order {
        row = degree(&mut steps, answer, r, &row);
    }
    if order > 0 {
        let times = if order == 1 { String::new() } else { format!(", {order} times") };
        steps.step(&format!("The derivative, from degree {} up{times}:", p - order));
        steps.formula("N′ᵢ,ᵣ(t) = r/(tᵢ₊ᵣ − tᵢ) · Nᵢ,ᵣ₋₁(t) − r/(tᵢ₊ᵣ₊₁ − tᵢ₊₁) · Nᵢ₊₁,ᵣ₋₁(t),   0/0 = 0.");
        steps.line("The same rule makes a derivative of any order from the derivatives of one order less.");
        for r in p - order + 1..=p {
            row = derivative(&mut steps, answer, r, r + order - p, &row);
        }
    }
    let sum: Rational = row.iter().cloned().sum();
    if order == 0 {
        steps.step(&format!("Check: the functions sum to 1. {} = {}.", plus(&row), text(&sum)));
    } else {
        steps.step(&format!("Check: the derivatives of 1 = N₀ + N₁ + … sum to 0. {} = {}.", plus(&row), text(&sum)));
    }
    let terms: Vec<_> =
        row.iter().enumerate().map(|(j, w)| (w.clone(), Symbol::Indexed('P', answer.first + j))).collect();
    steps.step(&format!("So {}({t}) = {}.", derived('P', order).0, sum_text(&terms)));
    if let (Some(value), Some(points)) = (answer.value(), &answer.points) {
        for (j, point) in points[answer.first..=span].iter().enumerate() {
            steps.formula(&format!("P{} = ({})", subscript(answer.first + j), comma(point)));
        }
        steps.line(&format!("With these points it is ({}).", comma(&value)));
    }
    Ok(steps.finish())
}

/// `ᵢ₊₄`.
fn index_plus(n: usize) -> String {
    format!("ᵢ₊{}", subscript(n))
}

fn plus(values: &[Rational]) -> String {
    let mut sum = String::new();
    for (i, x) in values.iter().enumerate() {
        match (i, x.is_negative()) {
            (0, _) => sum.push_str(&text(x)),
            (_, true) => sum.push_str(&format!(" − {}", text(&x.abs()))),
            (_, false) => sum.push_str(&format!(" + {}", text(x))),
        }
    }
    sum
}

/// The functions of degree r from those of degree r − 1, each on a line.
fn degree(steps: &mut Steps, answer: &At, r: usize, below: &[Rational]) -> Vec<Rational> {
    let (knots, span, t) = (answer.knots.values(), answer.span, &answer.t);
    let mut row = Vec::with_capacity(r + 1);
    steps.line("");
    for j in 0..=r {
        let i = span - r + j;
        let (mut formula, mut numbers, mut value) = (Vec::new(), Vec::new(), Rational::from(0));
        // N_{i,r−1} is alive unless i is the first, N_{i+1,r−1} unless it is the last.
        if j > 0 {
            let factor = (t - &knots[i]) / (&knots[i + r] - &knots[i]);
            formula.push(format!(
                "(t − t{})/(t{} − t{}) · {}",
                subscript(i),
                subscript(i + r),
                subscript(i),
                name(i, r - 1, 0)
            ));
            numbers.push(format!("{} · {}", text(&factor), text(&below[j - 1])));
            value += &factor * &below[j - 1];
        }
        if j < r {
            let (e, f) = (i + r + 1, i + 1);
            let factor = (&knots[e] - t) / (&knots[e] - &knots[f]);
            formula.push(format!(
                "(t{} − t)/(t{} − t{}) · {}",
                subscript(e),
                subscript(e),
                subscript(f),
                name(i + 1, r - 1, 0)
            ));
            numbers.push(format!("{} · {}", text(&factor), text(&below[j])));
            value += &factor * &below[j];
        }
        let note = empty(knots, i, r, j);
        steps.formula(&format!(
            "{} = {} = {} = {}{note}",
            name(i, r, 0),
            formula.join(" + "),
            numbers.join(" + "),
            text(&value)
        ));
        row.push(value);
    }
    row
}

/// The derivatives of degree r from those of degree r − 1.
fn derivative(steps: &mut Steps, answer: &At, r: usize, order: usize, below: &[Rational]) -> Vec<Rational> {
    let (knots, span) = (answer.knots.values(), answer.span);
    let mut row = Vec::with_capacity(r + 1);
    steps.line("");
    for j in 0..=r {
        let i = span - r + j;
        let (mut formula, mut value) = (String::new(), Rational::from(0));
        let rate = |e: usize, f: usize| Rational::from(r as i64) / (&knots[e] - &knots[f]);
        if j > 0 {
            let factor = rate(i + r, i);
            formula.push_str(&format!("{} · {}", text(&factor), bracketed(&below[j - 1])));
            value += &factor * &below[j - 1];
        }
        if j < r {
            let factor = rate(i + r + 1, i + 1);
            formula.push_str(if j > 0 { " − " } else { "−" });
            formula.push_str(&format!("{} · {}", text(&factor), bracketed(&below[j])));
            value += -(&factor * &below[j]);
        }
        let note = empty(knots, i, r, j);
        steps.formula(&format!("{} = {formula} = {}{note}", name(i, r, order), text(&value)));
        row.push(value);
    }
    row
}

fn bracketed(x: &Rational) -> String {
    if x.is_negative() { format!("({})", text(x)) } else { text(x) }
}

/// Names the zero-over-zero cases among the terms that were left out.
fn empty(knots: &[Rational], i: usize, r: usize, j: usize) -> String {
    let (mut from, mut to) = (i, i + r);
    let left = j == 0 && knots[from] == knots[to];
    if !left {
        (from, to) = (i + 1, i + r + 1);
        if j != r || knots[from] != knots[to] {
            return String::new();
        }
    }
    let (a, b) = (subscript(from), subscript(to));
    let which = if left { "first" } else { "second" };
    format!("   [the {which} term is 0/0 = 0: t{a} = t{b}]")
}
