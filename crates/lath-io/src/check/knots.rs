//! Findings in knot vectors, also in those that cannot be used.

use lath::error::Code as CoreCode;

use crate::check::members::Push;
use crate::check::show;
use crate::check::table::SCALE;
use crate::error::{Code, Error, Result};
use crate::json::child;
use crate::number::counted;

/// Knots closer than this part of the whole are nearly equal.
const NEAR: f64 = 1e-12;
/// A span shorter than this part of the longest is told.
const UNEVEN: f64 = 1e-6;

/// What a B-spline says of itself.
pub(super) struct Spline<'a> {
    pub(super) degree: usize,
    /// The number of its points.
    pub(super) points: usize,
    pub(super) knots: Option<&'a [f64]>,
    pub(super) closed: bool,
}

impl Spline<'_> {
    /// The number of knots that it takes.
    pub(super) fn wanted(&self) -> usize {
        if self.closed { self.points + 1 } else { self.points + self.degree + 1 }
    }
}

/// Runs of equal knots: where each begins, and how long it is.
pub(super) fn runs(knots: &[f64]) -> Vec<(usize, usize)> {
    let mut runs: Vec<(usize, usize)> = Vec::new();
    for (index, knot) in knots.iter().enumerate() {
        match runs.last_mut() {
            Some((start, count)) if knots[*start] == *knot => *count += 1,
            _ => runs.push((index, 1)),
        }
    }
    runs
}

pub(super) fn check(spline: &Spline<'_>, pointer: &str, push: &mut Push<'_>) -> Result<()> {
    let Some(knots) = spline.knots else {
        if !spline.closed && spline.degree > 0 {
            let message = "without knots they are uniform, and the curve does not reach its end points";
            push(Error::new(Code::W004, message).at_pointer(pointer))?;
        }
        return Ok(());
    };
    let pointer = child(pointer, "knots");
    count(spline, knots.len(), &pointer, push)?;
    let at = |code: Code, index: usize, message: String| {
        Error::new(code, message).at_pointer(child(&pointer, &index.to_string())).at_index(index)
    };
    let mut sorted = true;
    for (index, &knot) in knots.iter().enumerate() {
        if knot.abs() > SCALE {
            push(at(Code::Core(CoreCode::K007), index, format!("knot {index} is {}", show(knot))))?;
        }
        if let Some(&before) = index.checked_sub(1).and_then(|before| knots.get(before))
            && knot < before
        {
            sorted = false;
            let message = format!("knot {index} is {}, below the one before, {}", show(knot), show(before));
            push(at(Code::Core(CoreCode::K004), index, message))?;
        }
    }
    if sorted { multiplicities(spline, knots, &at, push) } else { Ok(()) }
}

fn count(spline: &Spline<'_>, found: usize, pointer: &str, push: &mut Push<'_>) -> Result<()> {
    let wanted = spline.wanted();
    if found == wanted {
        return Ok(());
    }
    let Spline { degree, points, .. } = spline;
    let error = if spline.closed {
        let message = format!(
            "{} for a closed curve of {}, which takes {wanted}: one period",
            counted(found, "knot"),
            counted(*points, "point")
        );
        Error::new(Code::Core(CoreCode::K001), message)
    } else if found + 2 == wanted {
        let message = format!(
            "{found} knots for {points} points of degree {degree}: two fewer than {wanted}, the convention that leaves out \
             the superfluous first and last knot, as openNURBS does"
        );
        Error::new(Code::Core(CoreCode::K001), message).remedied("Repeat the first and the last knot once more.")
    } else {
        let message = format!(
            "{} for {} of degree {degree}, which take {wanted}",
            counted(found, "knot"),
            counted(*points, "point")
        );
        Error::new(Code::Core(CoreCode::K001), message)
    };
    push(error.at_pointer(pointer))
}

fn multiplicities(
    spline: &Spline<'_>,
    knots: &[f64],
    at: &dyn Fn(Code, usize, String) -> Error,
    push: &mut Push<'_>,
) -> Result<()> {
    // Where the number is wrong, nobody knows which knots are inside and which are the ends.
    let (runs, most, fits) = (runs(knots), spline.degree + 1, knots.len() == spline.wanted());
    for &(start, count) in &runs {
        let knot = show(knots[start]);
        let inside = start > spline.degree && start + count < knots.len().saturating_sub(spline.degree);
        if count > most {
            let message = format!("the knot {knot} stands {count} times, more than degree + 1 = {most}");
            push(at(Code::Core(CoreCode::K003), start + most, message))?;
        } else if fits && count == most && (inside || spline.closed) && spline.degree > 0 {
            push(at(Code::W003, start, format!("the knot {knot} stands degree + 1 = {most} times inside")))?;
        }
    }
    if let (true, [(_, first), .., (start, last)]) = (fits && !spline.closed, &runs[..]) {
        for (count, index, end) in [(*first, 0, "start"), (*last, *start, "end")] {
            if count < most && spline.degree > 0 {
                let message = format!("the {end} knot stands {count} times, not degree + 1 = {most}");
                push(at(Code::W004, index, message))?;
            }
        }
    }
    spans(knots, &runs, at, push)
}

fn spans(
    knots: &[f64],
    runs: &[(usize, usize)],
    at: &dyn Fn(Code, usize, String) -> Error,
    push: &mut Push<'_>,
) -> Result<()> {
    let (Some(first), Some(last)) = (knots.first(), knots.last()) else { return Ok(()) };
    let whole = last - first;
    let (mut shortest, mut longest): (Option<(f64, usize)>, f64) = (None, 0.0);
    for pair in runs.windows(2) {
        let (Some(&(before, _)), Some(&(index, _))) = (pair.first(), pair.last()) else { continue };
        let span = knots[index] - knots[before];
        longest = if span > longest { span } else { longest };
        if span <= NEAR * whole {
            let message =
                format!("the knots {} and {} differ by {}", show(knots[before]), show(knots[index]), show(span));
            push(at(Code::W001, index, message))?;
        } else if shortest.is_none_or(|(least, _)| span < least) {
            shortest = Some((span, index));
        }
    }
    match shortest {
        Some((span, index)) if span < UNEVEN * longest => {
            let message = format!("the span before knot {index} is {}, the longest {}", show(span), show(longest));
            push(at(Code::W002, index, message))
        }
        _ => Ok(()),
    }
}
