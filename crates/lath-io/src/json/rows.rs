//! Points in JSON: `[[x,y],…]`, or `[x,…]` in one dimension.

use lath::error::Code as CoreCode;

use crate::error::{Code, Error, Result};
use crate::json::{Json, child};
use crate::number::counted;

/// Rows of one width, one after another.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Rows {
    pub(crate) width: usize,
    pub(crate) values: Vec<f64>,
}

/// An array of numbers.
///
/// # Errors
/// F017 where it is something else, with the pointer of the culprit.
pub(crate) fn numbers(json: Json, pointer: &str) -> Result<Vec<f64>> {
    match json {
        Json::Numbers(numbers) => Ok(numbers.into()),
        Json::Array(values) => {
            let culprit = values.iter().enumerate().find(|(_, value)| !matches!(value, Json::Number(_)));
            let (index, found) = culprit.map_or((0, "an array"), |(index, value)| (index, value.type_name()));
            let error = Error::new(Code::F017, format!("item {index} is {found}, not a number"));
            Err(error.at_pointer(child(pointer, &index.to_string())).at_index(index))
        }
        other => Err(Error::new(Code::F017, format!("{} where an array of numbers is needed", other.type_name()))
            .at_pointer(pointer)),
    }
}

/// An array of points: arrays of numbers of one length, or numbers.
///
/// # Errors
/// P001 no points, P005 points of different length, P006 points without coordinates, F017 other types; each with its
/// pointer.
pub(crate) fn rows(json: Json, pointer: &str) -> Result<Rows> {
    let core = |code, message: String| Error::new(Code::Core(code), message);
    let points = match json {
        Json::Numbers(values) if values.is_empty() => {
            return Err(core(CoreCode::P001, "there are no points".into()).at_pointer(pointer));
        }
        Json::Numbers(values) => return Ok(Rows { width: 1, values: values.into() }),
        Json::Array(points) if matches!(points.first(), Some(Json::Number(_))) => {
            return numbers(Json::Array(points), pointer).map(|values| Rows { width: 1, values });
        }
        Json::Array(points) => points,
        other => {
            let message = format!("{} where an array of points [[x,y],…] is needed", other.type_name());
            return Err(Error::new(Code::F017, message).at_pointer(pointer));
        }
    };
    let mut width = None;
    let mut values = Vec::new();
    for (index, point) in points.into_iter().enumerate() {
        let here = || child(pointer, &index.to_string());
        let coordinates = match point {
            Json::Numbers(coordinates) => Vec::from(coordinates),
            Json::Array(_) => numbers(point, &here())?,
            other => {
                let message = format!("point {index} is {}, not an array of numbers", other.type_name());
                return Err(Error::new(Code::F017, message).at_pointer(here()).at_index(index));
            }
        };
        let count = coordinates.len();
        let first = *width.get_or_insert(count);
        if count == 0 {
            return Err(core(CoreCode::P006, format!("point {index} has no coordinates"))
                .at_pointer(here())
                .at_index(index));
        }
        if count != first {
            let message = format!("point {index} has {}, point 0 has {first}", counted(count, "coordinate"));
            return Err(core(CoreCode::P005, message).at_pointer(here()).at_index(index));
        }
        values.extend(coordinates);
    }
    Ok(Rows { width: width.unwrap_or(0), values })
}
