//! B-splines from the recurrence, degree by degree, as polynomials.

use crate::answer::Blending;
use crate::budget;
use crate::error::Result;
use crate::explain::Steps;
use crate::polynomial::Polynomial;
use crate::print::{comma, number_text as text, piece_text, subscript};
use crate::rational::Rational;
use lath::error::Limits;

/// The polynomials of one function: one for each span of its support.
type Row = Vec<Polynomial>;

pub(crate) fn blending(answer: &Blending, limits: &Limits<'_>) -> Result<String> {
    // All functions of all degrees, where the answer has those of the last: p/3 times as much to write.
    let size = answer.degree + 1;
    let bits = budget::bits(&answer.knots).saturating_mul(size as u64);
    budget::check_size(limits, budget::product(&[answer.knots.len(), size, size, size]) / 2, bits)?;
    budget::check(limits, budget::product(&[4, answer.knots.len(), size, size, size]), bits)?;
    let (knots, p) = (&answer.knots, answer.degree);
    let mut steps = Steps::new(&format!("The B-splines of degree {p} on the knots {}", comma(knots)));
    spans(&mut steps, answer);

    steps.step("The recurrence. Nᵢ,₀ is 1 on its own span and 0 elsewhere; then, degree by degree,");
    steps
        .formula("Nᵢ,ᵣ(t) = (t − tᵢ)/(tᵢ₊ᵣ − tᵢ) · Nᵢ,ᵣ₋₁(t) + (tᵢ₊ᵣ₊₁ − t)/(tᵢ₊ᵣ₊₁ − tᵢ₊₁) · Nᵢ₊₁,ᵣ₋₁(t),   0/0 = 0.");
    steps.line("A function whose support is a single value is zero, and its factor is 0/0: the term is left out.");

    // Row i of degree r: the function's polynomials on the spans i … i + r, its support; empty spans hold zero.
    let one = Polynomial::new(vec![Rational::from(1)]);
    let mut below: Vec<Row> = knots
        .windows(2)
        .map(|pair| vec![if pair[0] < pair[1] { one.clone() } else { Polynomial::default() }])
        .collect();
    steps.step("Degree 0.");
    for (i, _) in below.iter().enumerate() {
        let (a, b) = (&knots[i], &knots[i + 1]);
        if a < b {
            steps.formula(&format!("N{},₀ = 1   for {} ≤ t < {}", subscript(i), text(a), text(b)));
        } else {
            steps.formula(&format!("N{},₀ = 0   the span from {} to {} is empty", subscript(i), text(a), text(b)));
        }
    }
    for r in 1..=p {
        steps.step(&format!("Degree {r}."));
        limits.check_cancel()?;
        let made: Vec<Row> = (0..knots.len() - r - 1).map(|i| function(&mut steps, knots, i, r, &below)).collect();
        below = made;
    }
    smoothness(&mut steps, answer);
    match answer.domain() {
        Some((from, to)) => {
            steps.step(&format!("Check: on the domain [{}, {}] the functions sum to 1.", text(&from), text(&to)))
        }
        None => steps.step("There is no domain: nowhere do these functions sum to 1."),
    }
    if let Some((from, to)) = answer.domain() {
        for piece in answer.sum().iter().filter(|piece| from <= piece.from && piece.to <= to) {
            steps.formula(&format!(
                "for {} ≤ t < {} the sum is {}",
                text(&piece.from),
                text(&piece.to),
                piece.polynomial
            ));
        }
    }
    Ok(steps.finish())
}

fn spans(steps: &mut Steps, answer: &Blending) {
    let (knots, p, n) = (&answer.knots, answer.degree, answer.functions.len());
    steps.step(&format!(
        "The knots t₀ … t{}: {} knots of degree {p} carry {} − {p} − 1 = {n} function{}.",
        subscript(knots.len() - 1),
        knots.len(),
        knots.len(),
        if n == 1 { "" } else { "s" }
    ));
    let repeated: Vec<String> = answer
        .multiplicities()
        .iter()
        .filter(|(_, count)| *count > 1)
        .map(|(knot, count)| format!("{} ({count} times)", text(knot)))
        .collect();
    if !repeated.is_empty() {
        steps.line(&format!("Repeated: {}.", repeated.join(", ")));
    }
    let empty = knots.windows(2).filter(|pair| pair[0] == pair[1]).count();
    steps.line(&format!(
        "Of the {} spans {} empty.",
        knots.len() - 1,
        match empty {
            0 => "none is".to_owned(),
            1 => "1 is".to_owned(),
            _ => format!("{empty} are"),
        }
    ));
    if let Some((from, to)) = answer.domain() {
        steps.line(&format!(
            "The domain is [t{}, t{}] = [{}, {}].",
            subscript(p),
            subscript(n),
            text(&from),
            text(&to)
        ));
    }
    let lives = match n {
        1 => format!("N₀ lives on [t₀, t{}].", subscript(p + 1)),
        _ => format!("Each Nᵢ, i = 0 … {}, lives on [tᵢ, tᵢ₊{}].", n - 1, subscript(p + 1)),
    };
    steps.line(&lives);
}

/// One function of degree r, on a line for its recurrence and one for each of its pieces.
fn function(steps: &mut Steps, knots: &[Rational], i: usize, r: usize, below: &[Row]) -> Row {
    let (mut terms, mut row) = (Vec::new(), vec![Polynomial::default(); r + 1]);
    let mut notes = Vec::new();
    let mut add = |from: usize, to: usize, rising: bool, function: usize| {
        let length = &knots[to] - &knots[from];
        if length == 0 {
            notes.push(format!("t{} = t{}: 0/0 = 0", subscript(from), subscript(to)));
            return;
        }
        let origin = if rising { &knots[from] } else { &knots[to] };
        let sign = Rational::from(if rising { 1 } else { -1 });
        let numerator = Polynomial::new(vec![-(origin * &sign), sign]);
        let bare = rising && *origin == 0;
        let above = if bare { numerator.to_string() } else { format!("({numerator})") };
        let shown = if length == 1 { format!("{above} · ") } else { format!("{above}/{} · ", over(&length)) };
        terms.push(format!("{shown}N{},{}", subscript(function), subscript(r - 1)));
        let factor = numerator.scaled(&(Rational::from(1) / length));
        // Both functions of one degree less live on spans of this one's support, the second from its second span on.
        for (sum, below) in row[function - i..].iter_mut().zip(&below[function]) {
            *sum = &*sum + &(&factor * below);
        }
    };
    add(i, i + r, true, i);
    add(i + 1, i + r + 1, false, i + 1);
    let note = if notes.is_empty() { String::new() } else { format!("   [{}]", notes.join("; ")) };
    let right = if terms.is_empty() { "0".to_owned() } else { terms.join(" + ") };
    steps.formula(&format!("N{},{} = {right}{note}", subscript(i), subscript(r)));
    for (s, piece) in (i..).zip(&row).filter(|(s, _)| knots[*s] < knots[*s + 1]) {
        let (a, b) = (&knots[s], &knots[s + 1]);
        steps.formula(&format!("   = {}   for {} ≤ t < {}", piece_text(piece, a, b), text(a), text(b)));
    }
    row
}

/// A length below a fraction's line.
fn over(length: &Rational) -> String {
    if length.is_integer() { text(length) } else { format!("({})", text(length)) }
}

fn smoothness(steps: &mut Steps, answer: &Blending) {
    let p = answer.degree;
    steps.step(&format!("Smoothness. At a knot of multiplicity m at least {p} − m derivatives are continuous:"));
    for (knot, count) in answer.multiplicities() {
        let shown = match (p + 1).checked_sub(count) {
            Some(0) | None => "the functions may jump".to_owned(),
            Some(1) => "continuous".to_owned(),
            Some(k) => format!("{} continuous derivative{}", k - 1, if k == 2 { "" } else { "s" }),
        };
        steps.formula(&format!("t = {}, m = {count}: {shown}", text(&knot)));
    }
}
