//! Findings in the members of a shape, also of one that cannot be built.

use lath::error::Code as CoreCode;

use crate::check::knots::{self, Spline};
use crate::check::show;
use crate::check::table::{SCALE, SQUARES, offset};
use crate::error::{Code, Error, Result};
use crate::json::{Json, child};

/// Weights whose ratio is greater are told.
const LOPSIDED: f64 = 1e6;

/// Where findings go.
pub(super) type Push<'p> = dyn FnMut(Error) -> Result<()> + 'p;

/// Looks at the shape at `pointer`; what is of the wrong type is left to the reader.
pub(super) fn check(shape: &Json, pointer: &str, push: &mut Push<'_>) -> Result<()> {
    if let Some(Json::Array(pieces)) = shape.get("pieces") {
        let pointer = child(pointer, "pieces");
        for (index, piece) in pieces.iter().enumerate() {
            check(piece, &child(&pointer, &index.to_string()), push)?;
        }
    }
    let closed = shape.get("closed") == Some(&Json::Bool(true));
    for name in ["points", "tangents", "seconds"] {
        if let Some(values) = shape.get(name) {
            points(values, &child(pointer, name), name == "points", closed, push)?;
        }
    }
    if let Some(Json::Numbers(values)) = shape.get("weights") {
        weights(values, shape.get("points").and_then(length), &child(pointer, "weights"), push)?;
    }
    for name in ["parameters", "breaks", "domain"] {
        if let Some(Json::Numbers(values)) = shape.get(name) {
            parameters(values, &child(pointer, name), push)?;
        }
    }
    if shape.get("kind") == Some(&Json::Text("bspline".into()))
        && let (Some(degree), Some(count)) = (whole(shape.get("degree")), shape.get("points").and_then(length))
    {
        let knots = match shape.get("knots") {
            Some(Json::Numbers(knots)) => Some(&knots[..]),
            None => None,
            Some(_) => return Ok(()),
        };
        knots::check(&Spline { degree, points: count, knots, closed }, pointer, push)?;
    }
    Ok(())
}

/// A whole number that can be a degree.
pub(super) fn whole(json: Option<&Json>) -> Option<usize> {
    match json {
        Some(Json::Number(x)) if (0.0..=1000.0).contains(x) && x.fract() == 0.0 => Some(*x as usize),
        _ => None,
    }
}

/// The number of items of an array.
pub(super) fn length(json: &Json) -> Option<usize> {
    match json {
        Json::Numbers(items) => Some(items.len()),
        Json::Array(items) => Some(items.len()),
        _ => None,
    }
}

/// Coordinates of a point; none for something else.
fn coordinates(json: &Json, index: usize) -> Option<&[f64]> {
    match json {
        Json::Numbers(values) => values.get(index..=index),
        Json::Array(items) => match items.get(index) {
            Some(Json::Numbers(point)) => Some(point),
            _ => None,
        },
        _ => None,
    }
}

fn points(values: &Json, pointer: &str, places: bool, closed: bool, push: &mut Push<'_>) -> Result<()> {
    let count = length(values).unwrap_or(0);
    let at = |code: Code, index: usize, message: String| {
        Error::new(code, message).at_pointer(child(pointer, &index.to_string())).at_index(index)
    };
    let mut squares = None;
    let (mut doubled, mut known) = (Vec::new(), 0);
    for index in 0..count {
        let Some(point) = coordinates(values, index) else { continue };
        known += 1;
        for x in point.iter().filter(|x| x.abs() > SQUARES) {
            if x.abs() > SCALE {
                push(at(Code::Core(CoreCode::P003), index, format!("a coordinate of point {index} is {}", show(*x))))?;
            } else if squares.is_none() {
                squares = Some((index, *x));
            }
        }
        if index > 0 && coordinates(values, index - 1) == Some(point) {
            doubled.push(index);
        }
    }
    if let Some((index, x)) = squares {
        push(at(Code::W016, index, format!("a coordinate of point {index} is {}", show(x))))?;
    }
    if !places {
        return Ok(());
    }
    if known == count && count > 1 && doubled.len() + 1 == count {
        return push(Error::new(Code::W006, format!("all {count} points are the same")).at_pointer(pointer));
    }
    for index in doubled {
        push(at(Code::W005, index, format!("point {index} is the same as point {}", index - 1)))?;
    }
    if closed && count > 2 && coordinates(values, 0).is_some_and(|first| coordinates(values, count - 1) == Some(first))
    {
        push(at(Code::W008, count - 1, "the last point is the first one again".to_owned()))?;
    }
    let width = coordinates(values, 0).map_or(0, <[f64]>::len);
    for axis in 0..width {
        let axis_values = (0..count).filter_map(|index| coordinates(values, index)?.get(axis).copied());
        if let Some(message) = offset(axis_values) {
            push(Error::new(Code::W015, format!("coordinate {axis}: {message}")).at_pointer(pointer))?;
        }
    }
    Ok(())
}

fn weights(values: &[f64], points: Option<usize>, pointer: &str, push: &mut Push<'_>) -> Result<()> {
    if let Some(points) = points.filter(|points| *points != values.len()) {
        let message = format!("{} weights for {points} points", values.len());
        push(Error::new(Code::Core(CoreCode::R003), message).at_pointer(pointer))?;
    }
    let at = |code: Code, index: usize, message: String| {
        Error::new(code, message).at_pointer(child(pointer, &index.to_string())).at_index(index)
    };
    let (mut least, mut most) = (f64::INFINITY, 0.0);
    for (index, &weight) in values.iter().enumerate() {
        let message = format!("weight {index} is {}", show(weight));
        if weight.abs() > SCALE {
            push(at(Code::Core(CoreCode::R002), index, message))?;
        } else if weight <= 0.0 {
            push(at(Code::W018, index, message))?;
        } else {
            least = if weight < least { weight } else { least };
            most = if weight > most { weight } else { most };
        }
    }
    if most / least > LOPSIDED {
        let message = format!("the weights go from {} to {}", show(least), show(most));
        push(Error::new(Code::W019, message).at_pointer(pointer))?;
    }
    Ok(())
}

fn parameters(values: &[f64], pointer: &str, push: &mut Push<'_>) -> Result<()> {
    let at = |code, index: usize, message: String| {
        Error::new(Code::Core(code), message).at_pointer(child(pointer, &index.to_string())).at_index(index)
    };
    for (index, &t) in values.iter().enumerate() {
        if t.abs() > SCALE {
            push(at(CoreCode::T005, index, format!("parameter {index} is {}", show(t))))?;
        }
        if let Some(&before) = index.checked_sub(1).and_then(|before| values.get(before))
            && t <= before
        {
            let message = format!("parameter {index} is {}, not above {}", show(t), show(before));
            push(at(CoreCode::T003, index, message))?;
        }
    }
    Ok(())
}
