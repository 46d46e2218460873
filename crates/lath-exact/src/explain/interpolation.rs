//! The system of the cubic spline, with its numbers.

use crate::answer::{Condition, Ends, Interpolation};
use crate::budget;
use crate::error::Result;
use crate::explain::Steps;
use crate::print::{Symbol, comma, number_text as text, subscript, sum_text};
use crate::rational::Rational;
use lath::error::Limits;
use std::collections::BTreeMap;

/// One equation between tangents: Σ coefficient · m_index = right, one number a coordinate.
pub(crate) struct Equation {
    pub(crate) why: String,
    pub(crate) terms: Vec<(Rational, usize)>,
    pub(crate) right: Vec<Rational>,
}

pub(crate) fn interpolation(answer: &Interpolation, limits: &Limits<'_>) -> Result<String> {
    let rows = answer.tangents.iter().chain(&answer.control_points).chain(&answer.points).flatten();
    let bits = budget::bits(rows.chain(&answer.knots));
    let row = answer.points.first().map_or(0, Vec::len) + 3;
    budget::check_size(limits, budget::product(&[4, answer.knots.len(), row]), bits)?;
    budget::check(limits, budget::product(&[20, answer.knots.len(), row]), bits)?;
    let (t, n) = (&answer.parameters, answer.points.len());
    let h = intervals(t);
    let mut steps = Steps::new(&format!("The cubic spline through {n} points, ends: {}", answer.ends));

    steps.step("What is given: the points and their parameters,");
    for (i, point) in answer.points.iter().enumerate() {
        steps.formula(&format!("P{} = ({})   at t{} = {}", subscript(i), comma(point), subscript(i), text(&t[i])));
    }
    if answer.ends == Ends::Closed {
        steps.formula(&format!("P₀ again   at t{} = {}", subscript(n), text(&t[n])));
    }
    let lengths: Vec<String> = h.iter().enumerate().map(|(k, h)| format!("h{} = {}", subscript(k), text(h))).collect();
    steps.line(&format!("so the intervals are {}.", lengths.join(", ")));

    steps.step("What is wanted: the tangents mᵢ = P′(tᵢ). With them piece k, for u = (t − tₖ)/hₖ from 0 to 1, is");
    steps.formula("P(u) = F₁ Pₖ + F₂ Pₖ₊₁ + F₃ mₖ + F₄ mₖ₊₁,");
    steps.formula("F₁ = 2u³ − 3u² + 1, F₂ = −2u³ + 3u², F₃ = u(u² − 2u + 1) hₖ, F₄ = u(u² − u) hₖ.");
    steps.line("Points and tangents agree where pieces meet; the second derivatives do too if, at every inner point,");
    steps.formula("hᵢ mᵢ₋₁ + 2(hᵢ₋₁ + hᵢ) mᵢ + hᵢ₋₁ mᵢ₊₁ = 3/(hᵢ₋₁ hᵢ) [hᵢ₋₁² (Pᵢ₊₁ − Pᵢ) + hᵢ² (Pᵢ − Pᵢ₋₁)].");

    steps.step("The system, with these numbers:");
    let equations = equations(answer);
    for equation in &equations {
        let terms: Vec<_> = equation.terms.iter().map(|(c, i)| (c.clone(), Symbol::Indexed('m', *i))).collect();
        steps.formula(&format!("{} = ({})   {}", sum_text(&terms), comma(&equation.right), equation.why));
    }

    steps.step("Its solution:");
    for (i, m) in answer.tangents.iter().enumerate() {
        steps.formula(&format!("m{} = ({})", subscript(i), comma(m)));
    }

    steps.step("The same curve as a B-spline. Three more knots on each side give every piece its four control points:");
    steps.formula(&format!("knots {}", comma(&answer.knots)));
    steps.line("Control point i is the blossom of a piece at the knots i + 1, i + 2, i + 3:");
    for (i, point) in answer.control_points.iter().enumerate() {
        let of: Vec<String> = answer.knots[i + 1..i + 4].iter().map(text).collect();
        steps.formula(&format!("C{} = b({}) = ({})", subscript(i), of.join(", "), comma(point)));
    }
    if h.iter().all(|length| *length == h[0]) {
        steps.line(
            "The intervals are equal, so each given point is (Cᵢ + 4Cᵢ₊₁ + Cᵢ₊₂)/6 of three neighbours: check it.",
        );
    }
    Ok(steps.finish())
}

fn intervals(t: &[Rational]) -> Vec<Rational> {
    t.windows(2).map(|pair| &pair[1] - &pair[0]).collect()
}

/// The textbook's system: as many equations as tangents, and it is the one that was solved, row by row up to a factor.
pub(crate) fn equations(answer: &Interpolation) -> Vec<Equation> {
    let h = intervals(&answer.parameters);
    let (n, pieces) = (answer.points.len(), h.len());
    let chord = |k: usize| -> Vec<Rational> {
        let (a, b) = (&answer.points[k], &answer.points[(k + 1) % n]);
        a.iter().zip(b).map(|(a, b)| (b - a) / h[k].clone()).collect()
    };
    // 3 (a · δ_k + b · δ_l)
    let three = |a: &Rational, k: usize, b: &Rational, l: usize| -> Vec<Rational> {
        chord(k).iter().zip(chord(l)).map(|(x, y)| Rational::from(3) * (a * x + b * &y)).collect()
    };
    let two = Rational::from(2);
    let joint = |before: usize, i: usize, sign: &Rational, names: [usize; 3], why: String| {
        let (left, right) = (&h[before], &h[i]);
        let all = [(right * sign, names[0]), (&two * &(left + right), names[1]), (left.clone(), names[2])];
        Equation { why, terms: merged(all), right: three(&(right * sign), before, left, i) }
    };
    let one = Rational::from(1);
    let inner = |i: usize| {
        joint(i - 1, i, &one, [i - 1, i, (i + 1) % n], format!("second derivatives agree at P{}", subscript(i)))
    };
    let mut all = Vec::new();
    match &answer.ends {
        Ends::Closed => {
            let seam = "second derivatives agree at P₀, where the curve closes".to_owned();
            all.push(joint(pieces - 1, 0, &one, [n - 1, 0, 1 % n], seam));
            all.extend((1..n).map(inner));
        }
        Ends::Cyclic | Ends::Anticyclic => {
            let cyclic = answer.ends == Ends::Cyclic;
            let sign = Rational::from(if cyclic { 1 } else { -1 });
            let (how, m) = if cyclic { ("agree", -1) } else { ("are opposite", 1) };
            let seam =
                joint(pieces - 1, 0, &sign, [pieces - 1, 0, 1], format!("second derivatives {how} at both ends"));
            all.push(seam);
            all.extend((1..pieces).map(inner));
            let tie = Equation {
                why: format!("first derivatives {how} at both ends"),
                terms: vec![(Rational::from(m), 0), (one.clone(), n - 1)],
                right: vec![Rational::from(0); answer.points[0].len()],
            };
            all.push(tie);
        }
        Ends::Open(start, end) => {
            let shared = pieces <= 2 && (start, end) == (&Condition::NotAKnot, &Condition::NotAKnot);
            all.push(end_equation(start, &h, chord, true, shared));
            all.extend((1..pieces).map(inner));
            all.push(end_equation(end, &h, chord, false, shared));
        }
    }
    all
}

/// Terms of one tangent added up, in the order of the tangents: where the system closes, two of a row may be the same.
fn merged(terms: [(Rational, usize); 3]) -> Vec<(Rational, usize)> {
    let mut sum: BTreeMap<usize, Rational> = BTreeMap::new();
    for (c, i) in terms {
        *sum.entry(i).or_insert_with(|| Rational::from(0)) += c;
    }
    sum.into_iter().map(|(i, c)| (c, i)).collect()
}

/// The condition at one end; at the end of the curve it reads backwards.
fn end_equation(
    condition: &Condition,
    h: &[Rational],
    chord: impl Fn(usize) -> Vec<Rational>,
    start: bool,
    shared: bool,
) -> Equation {
    let pieces = h.len();
    let (own, next, beyond) = if start { (0, 1, 2) } else { (pieces, pieces - 1, pieces.saturating_sub(2)) };
    let (k, l) = if start { (0, 1) } else { (pieces - 1, pieces.saturating_sub(2)) };
    let place = if start { "start" } else { "end" };
    let int = Rational::from;
    let times = |factor: Rational| -> Vec<Rational> { chord(k).iter().map(|x| &factor * x).collect() };
    match condition {
        Condition::Clamped(vector) => Equation {
            why: format!("the tangent at the {place} is given"),
            terms: vec![(int(1), own)],
            right: vector.clone(),
        },
        Condition::Natural => Equation {
            why: format!("second derivative 0 at the {place}"),
            terms: vec![(int(2), own), (int(1), next)],
            right: times(int(3)),
        },
        Condition::Second(vector) => {
            let half = &h[k] / &int(if start { -2 } else { 2 });
            Equation {
                why: format!("the second derivative at the {place} is given"),
                terms: vec![(int(2), own), (int(1), next)],
                right: times(int(3)).iter().zip(vector).map(|(x, s)| x + &(&half * s)).collect(),
            }
        }
        Condition::NotAKnot if shared && pieces == 1 => {
            Equation { why: "two points: a straight line".to_owned(), terms: vec![(int(1), own)], right: times(int(1)) }
        }
        Condition::NotAKnot if shared || pieces == 1 => Equation {
            why: format!("no third derivative at the {place}: the piece is a parabola"),
            terms: vec![(int(1), own), (int(1), next)],
            right: times(int(2)),
        },
        Condition::NotAKnot => {
            // Third derivatives, (m₀ + m₁ − 2δ₀)/h₀², agree at the neighbouring point.
            let (near, far) = (&h[k] * &h[k], &h[l] * &h[l]);
            let right = chord(k).iter().zip(chord(l)).map(|(x, y)| int(2) * (&far * x - &near * &y)).collect();
            Equation {
                why: format!("third derivatives agree next to the {place}"),
                terms: vec![(far.clone(), own), (&far - &near, next), (-near, beyond)],
                right,
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::answer::interpolation as solve;
    use crate::parse::rows;

    #[test]
    fn the_solution_satisfies_the_textbook_system() {
        let vector = |text: &str| rows(text).unwrap().remove(0);
        let conditions = [
            Condition::Natural,
            Condition::NotAKnot,
            Condition::Clamped(vector("1/3,-2")),
            Condition::Second(vector("5,1/7")),
        ];
        let mut ends = vec![Ends::Cyclic, Ends::Anticyclic, Ends::Closed];
        for start in &conditions {
            for end in &conditions {
                ends.push(Ends::Open(start.clone(), end.clone()));
            }
        }
        let points = rows("0,0; 1,2; 3,-1/2; 4,7; 2,2").unwrap();
        let t = vector("0,1,3/2,4,5,13/2");
        let mut solved = 0;
        for count in 2..=5 {
            for ends in &ends {
                let closed = usize::from(*ends == Ends::Closed);
                let answer = solve(&points[..count], Some(&t[..count + closed]), ends.clone(), &Default::default());
                let Ok(answer) = answer else { continue }; // some are singular
                solved += 1;
                let equations = equations(&answer);
                assert_eq!(equations.len(), count, "{ends} {count}");
                for equation in equations {
                    for c in 0..2 {
                        let left: Rational = equation.terms.iter().map(|(a, i)| a * &answer.tangents[*i][c]).sum();
                        assert_eq!(left, equation.right[c], "{ends}, {count} points: {}", equation.why);
                    }
                }
            }
        }
        assert!(solved > 70, "{solved}");
    }
}
