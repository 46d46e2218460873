//! A point of a level or of the limit from the original group: one small matrix for each bit of its index.

use crate::answer::{Jump, Point, Triplets};
use crate::budget;
use crate::error::Result;
use crate::explain::Steps;
use crate::matrix::Matrix;
use crate::print::{Symbol, comma, exponent, matrix_lines, number_text as text, subscript, sum_text};
use crate::rational::Rational;
use lath::error::Limits;
use lath::num::Scalar;
use lath::subdivide::{Index, Scheme, Target, ancestor};

/// Levels beyond this many are not shown one by one.
const SHOWN: usize = 16;

fn points(letter: char, weights: &[Rational]) -> String {
    let terms: Vec<_> = weights.iter().enumerate().map(|(j, w)| (w.clone(), Symbol::Indexed(letter, j))).collect();
    sum_text(&terms)
}

/// The matrix that makes the p + 1 points 2i + bit … of a level from the p + 1 points i … of the level before.
fn halving(scheme: &Scheme<Rational>, bit: bool) -> Matrix {
    let size = scheme.degree() + 1;
    Matrix::from_fn(size, size, |i, j| scheme.weight(i + usize::from(bit), j))
}

pub(crate) fn point(answer: &Point, limits: &Limits<'_>) -> Result<String> {
    let (size, shown) = (answer.scheme.degree() + 1, if answer.level > SHOWN { 0 } else { answer.level });
    let bits = budget::bits(answer.scheme.mask()).saturating_mul(shown as u64 + 1);
    budget::check_size(limits, budget::product(&[shown + 2, size, size]), bits)?;
    budget::check(limits, budget::product(&[shown, size, size, size]), bits)?;
    let (p, k, i) = (answer.scheme.degree(), answer.level, &answer.index);
    let limit = answer.target == Target::Limit;
    let title = if limit {
        format!(
            "The limit at index {i} of level {k}, t = {}, by the points P₀ … P{}",
            text(&answer.parameter),
            subscript(p)
        )
    } else {
        format!("Point {i} of level {k}, by the points P₀ … P{}", subscript(p))
    };
    let mut steps = Steps::new(&title);
    steps.step(&format!(
        "The group. {} neighbours P₀ … P{} of level 0 make one segment of the curve, and 2ᵏ + {p} points of level k.",
        p + 1,
        subscript(p)
    ));
    let whole = Index::from(1).shifted_up(k);
    if limit {
        steps.line(&format!(
            "The index i = {i} of level {k} belongs to the parameter t = i/2ᵏ = {} of the segment, 0 ≤ t ≤ 1.",
            text(&answer.parameter)
        ));
    }
    if *i >= whole {
        // Beyond the bits of one segment: the last points of the group.
        steps.step(&format!(
            "The index {i} is not below 2{} = {whole}: the point lies at the end of the group.",
            exponent(k)
        ));
        steps.line(&format!("It is reached through the last of the points, in the segment that would follow, where the weight of P{} is 0.", subscript(p + 1)));
        result(&mut steps, answer);
        return Ok(steps.finish());
    }
    let bits: String = (0..k).rev().map(|place| if i.bit(place) { '1' } else { '0' }).collect();
    let shown = if bits.is_empty() { "none".to_owned() } else { bits.clone() };
    steps.step(&match k {
        1 => format!("The way. The binary digit of {i}: {shown}."),
        _ => format!("The way. The {k} binary digits of {i}, the first refinement first: {shown}."),
    });
    steps.line(&format!(
        "At each refinement the {} points from index j make those from index 2j (digit 0) or 2j + 1 (digit 1):",
        p + 1
    ));
    for (bit, name) in [(false, "A₀"), (true, "A₁")] {
        if bits.contains(if bit { '1' } else { '0' }) {
            steps.line("");
            steps.formulas(&matrix_lines(name, &halving(&answer.scheme, bit), true));
        }
    }
    if k > SHOWN {
        steps.step(&format!(
            "The product of {k} such matrices, of which only the first row (or its limit) is wanted, gives the weights."
        ));
        result(&mut steps, answer);
        return Ok(steps.finish());
    }
    let mut all = Matrix::identity(p + 1);
    steps.step("Level by level, the points in terms of the original ones:");
    for level in 1..=k {
        all = halving(&answer.scheme, i.bit(k - level)).product(&all).unwrap_or(all);
        let first = i.shifted_down(k - level);
        let digit = u8::from(i.bit(k - level));
        steps.line("");
        steps.line(&format!("Level {level}, from index {first}, digit {digit}:"));
        for (c, row) in all.rows().iter().take(if limit || level < k { p + 1 } else { 1 }).enumerate() {
            steps.formula(&format!("P({level}, {}) = {}", first.plus(&Index::from(c as u64)), points('P', row)));
        }
    }
    if k == 0 {
        steps.line("None: level 0 is given.");
    }
    if limit {
        let mask = answer.scheme.limit_mask(0).unwrap_or_default();
        let local: Vec<_> = mask.iter().enumerate().map(|(j, w)| (w.clone(), Symbol::Indexed('Q', j))).collect();
        steps.step(&format!("The limit. The {p} neighbours Q₀ = P({k}, {i}), Q₁, … tend to {},", sum_text(&local)));
        steps.line("by the left eigenvector of the local matrix for the eigenvalue 1.");
        let neighbours = Matrix::from_fn(1, p, |_, j| mask[j].clone());
        let rows = Matrix::from_fn(p, p + 1, |r, j| all.rows()[r][j].clone());
        if let Some(product) = neighbours.product(&rows) {
            steps.formula(&points('P', &product.rows()[0]));
        }
    }
    result(&mut steps, answer);
    Ok(steps.finish())
}

fn result(steps: &mut Steps, answer: &Point) {
    let sum: Rational = answer.weights.iter().cloned().sum();
    steps.step(&format!("So the weights are {}, and sum to {}.", comma(&answer.weights), text(&sum)));
    let missing: Vec<String> = answer
        .weights
        .iter()
        .enumerate()
        .filter(|(_, w)| w.is_zero())
        .map(|(j, _)| format!("P{}", subscript(j)))
        .collect();
    if !missing.is_empty() {
        steps.line(&format!("No weight falls on {}.", missing.join(", ")));
    }
    if answer.scheme.is_spline() && answer.target == Target::Limit {
        let degree = answer.scheme.degree();
        steps.line(&format!("They are the uniform B-splines of degree {degree} at t = {}.", text(&answer.parameter)));
    }
}

pub(crate) fn jump(answer: &Jump, limits: &Limits<'_>) -> Result<String> {
    let bits = budget::bits(answer.matrix.entries().chain(answer.scheme.mask()));
    let p = answer.scheme.degree();
    budget::check_size(limits, budget::product(&[2, p, p]), bits)?;
    let p = answer.scheme.degree();
    let ((from, i), (to, j)) = (&answer.from, &answer.to);
    let mut steps = Steps::new(&format!("From level {from}, index {i}, to level {to}"));
    steps.step(&format!(
        "{p} neighbours from index i determine {p} neighbours from index 2i of the next level, by the local matrix:"
    ));
    steps.line("");
    let rows = answer.scheme.local_matrix();
    let local = Matrix::from_fn(p, p, |i, j| rows[i][j].clone());
    steps.formulas(&matrix_lines("A", &local, true));
    steps.step(&format!(
        "From level {from} to level {to} that happens {} times: the index is doubled as often.",
        answer.power
    ));
    steps.formula(&format!("{i} · 2{} = {j}", exponent(answer.power)));
    let found = ancestor(*to, j);
    if found.level < *from {
        steps.line(&format!(
            "(The index ends in more zeros: already level {}, index {}, would do.)",
            found.level, found.index
        ));
    }
    steps.step("So the power of A leaps over the levels between:");
    steps.line("");
    steps.formulas(&matrix_lines(&format!("A{}", exponent(answer.power)), &answer.matrix, true));
    Ok(steps.finish())
}

pub(crate) fn triplets(answer: &Triplets, limits: &Limits<'_>) -> Result<String> {
    limits.check_bytes(budget::product(&[64, answer.triplets.len()]))?;
    let k = answer.level;
    let mut steps = Steps::new(&format!("The triplets of level {k}"));
    steps.step("Three neighbours j, j + 1, j + 2 of a level make the three neighbours 2j, 2j + 1, 2j + 2 of the next:");
    steps.line("an edge point, a vertex point and an edge point.");
    steps.line("");
    let local = Scheme::<Rational>::cubic().local_matrix();
    steps.formulas(&matrix_lines("A", &Matrix::from_fn(3, 3, |i, j| local[i][j].clone()), true));
    if k == 0 {
        steps.step("Level 0 is given.");
        return Ok(steps.finish());
    }
    let count = answer.triplets.len();
    steps.step(&format!("One group of four points has {} points at level {}, so {count} triplets there: as many at level {k}, at even indices.", count + 2, k - 1));
    for d in &answer.triplets {
        steps.formula(&format!("index {} from index {}", d.index, d.from));
    }
    Ok(steps.finish())
}
