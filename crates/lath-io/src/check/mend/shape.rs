//! Members of a shape that are mended.

use crate::check::knots::{Spline, runs};
use crate::check::members::{length, whole};
use crate::json::Json;

/// By how many units in the last place knots may decrease and still be meant as equal.
const NOISE: f64 = 4.0;

/// Mends the shape at `pointer`, and those in it.
pub(super) fn mend(shape: &mut Json, pointer: &str, changes: &mut Vec<String>) {
    if let Some(Json::Array(pieces)) = shape.get_mut("pieces") {
        for (index, piece) in pieces.iter_mut().enumerate() {
            mend(piece, &format!("{pointer}/pieces/{index}"), changes);
        }
    }
    closing_point(shape, pointer, changes);
    if shape.get("kind") == Some(&Json::Text("bspline".into())) {
        knots(shape, pointer, changes);
    }
}

/// Drops the last point of a closed shape where it is the first one again, and the knots or parameters count one less.
fn closing_point(shape: &mut Json, pointer: &str, changes: &mut Vec<String>) {
    if shape.get("closed") != Some(&Json::Bool(true)) {
        return;
    }
    let count = |shape: &Json, key| shape.get(key).and_then(length);
    let Some(points) = count(shape, "points") else { return };
    let repeats = |shape: &Json, key| match shape.get(key) {
        Some(Json::Array(points)) => points.len() > 1 && points.first() == points.last(),
        Some(Json::Numbers(points)) => points.len() > 1 && points.first() == points.last(),
        _ => false,
    };
    let members: &[&str] = match shape.get("kind") {
        Some(Json::Text(kind)) if &**kind == "bspline" && count(shape, "knots") == Some(points) => {
            if shape.has("weights") { &["points", "weights"] } else { &["points"] }
        }
        Some(Json::Text(kind)) if &**kind == "hermite" && count(shape, "parameters") == Some(points) => {
            &["points", "tangents"]
        }
        _ => return,
    };
    if !members.iter().all(|key| repeats(shape, key) && count(shape, key) == Some(points)) {
        return;
    }
    for key in members {
        match shape.get_mut(key) {
            Some(Json::Array(points)) => drop_last(points),
            Some(Json::Numbers(points)) => drop_last(points),
            _ => {}
        }
    }
    changes.push(format!(
        "{pointer}/points: dropped the last point, the first one again: a closed shape returns by itself"
    ));
}

fn drop_last<T>(items: &mut Box<[T]>) {
    let mut all = core::mem::take(items).into_vec();
    all.pop();
    *items = all.into();
}

fn knots(shape: &mut Json, pointer: &str, changes: &mut Vec<String>) {
    let (Some(degree), Some(points)) = (whole(shape.get("degree")), shape.get("points").and_then(length)) else {
        return;
    };
    let closed = shape.get("closed") == Some(&Json::Bool(true));
    let Some(Json::Numbers(knots)) = shape.get_mut("knots") else { return };
    let wanted = Spline { degree, points, knots: None, closed }.wanted();
    let mut mended = knots.to_vec();
    let mut tell = |what: String| changes.push(format!("{pointer}/knots: {what}"));
    let raised = level(&mut mended);
    if raised > 0 {
        tell(format!("made {raised} of them equal to the one before, below which rounding had put them"));
    }
    if mended.is_sorted() {
        // Where the ends stand degree + 1 times already, it is others that are missing.
        let once_more = runs(&mended).iter().all(|(start, count)| {
            let at_end = *start == 0 || start + count == mended.len();
            !at_end || *count <= degree
        });
        if !closed && mended.len() + 2 == wanted && degree > 0 && !mended.is_empty() && once_more {
            let (first, last) = (mended[0], mended[mended.len() - 1]);
            mended.insert(0, first);
            mended.push(last);
            tell("repeated the first and the last knot once more, which were left out".to_owned());
        }
        let excess: usize = runs(&mended).iter().map(|(_, count)| count.saturating_sub(degree + 1)).sum();
        if excess > 0 && mended.len() == wanted + excess {
            let most = degree + 1;
            let before = core::mem::take(&mut mended);
            for (start, count) in runs(&before) {
                mended.extend(core::iter::repeat_n(before[start], count.min(most)));
            }
            tell(format!("removed {excess} of them, repeated more than degree + 1 = {most} times"));
        }
    }
    *knots = mended.into();
}

/// Raises knots that lie a few units in the last place below the one before; the number of them.
fn level(knots: &mut [f64]) -> usize {
    let mut raised = 0;
    for index in 1..knots.len() {
        let (before, knot) = (knots[index - 1], knots[index]);
        let size = if before.abs() > knot.abs() { before.abs() } else { knot.abs() };
        if knot < before && before - knot <= NOISE * f64::EPSILON * size {
            knots[index] = before;
            raised += 1;
        }
    }
    raised
}
