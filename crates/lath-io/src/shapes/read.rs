//! Reading lath JSON.

use lath::curve::AnyCurve;
use lath::error::Limits;

use crate::error::{Code, Error, Result};
use crate::json::{self, Json, Members, child};
use crate::shapes::Shape;
use crate::shapes::kinds;
use crate::source::Source;

/// Reads lath JSON. The list of shapes may be empty.
///
/// ```
/// use lath::error::Limits;
/// use lath_io::{shapes, source::Source};
///
/// let text = r#"{"lath": 1, "shapes": [{"kind": "bezier", "name": "arch", "points": [[0,0],[1,2],[2,0]]}]}"#;
/// let shapes = shapes::read(&Source::from_bytes("arch.json", text), &Limits::default())?;
/// assert_eq!((shapes[0].name(), shapes[0].kind()), (Some("arch"), "bezier"));
/// # Ok::<(), lath_io::Error>(())
/// ```
///
/// # Errors
/// F010 to F014 what is no JSON here; F015 to F017 members missing, unknown or of the wrong type; F018 another version;
/// F019 no such kind; F020 a kind that this version does not hold; F021 JSON without `"lath"`; the core's
/// codes for what it refuses. Each with JSON pointer, line and column. B001 above the budget.
pub fn read(source: &Source, limits: &Limits<'_>) -> Result<Vec<Shape>> {
    let tree = json::parse(source, limits)?;
    if recognise(&tree) {
        return from_tree(source, tree, limits);
    }
    let error = Error::new(Code::F021, "this JSON is not lath JSON: it has no member \"lath\"");
    Err(error.remedied("Write {\"lath\": 1, \"shapes\": […]}.").in_source(source.name()))
}

/// True for what means to be lath JSON, with its version or without.
pub(crate) fn recognise(tree: &Json) -> bool {
    ["lath", "shapes", "kind"].iter().any(|key| tree.has(key))
}

pub(crate) fn from_tree(source: &Source, tree: Json, limits: &Limits<'_>) -> Result<Vec<Shape>> {
    document(tree, limits).map_err(|error| json::place(source, error))
}

fn document(tree: Json, limits: &Limits<'_>) -> Result<Vec<Shape>> {
    let mut points = 0;
    list(tree)?.into_iter().enumerate().map(|(index, tree)| shape(index, tree, limits, &mut points)).collect()
}

/// The list of shapes in a document, none of them looked at yet.
pub(crate) fn list(tree: Json) -> Result<Vec<Json>> {
    let mut members = Members::of(tree, "")?;
    match members.require("lath", "1, the version of the format")? {
        Json::Number(1.0) => {}
        other => {
            let found = match other {
                Json::Number(version) => format!("version {version}"),
                other => other.type_name().to_owned(),
            };
            return Err(Error::new(Code::F018, format!("\"lath\" is {found}; this program knows version 1"))
                .at_pointer("/lath"));
        }
    }
    let list = match members.require("shapes", "[…], the list of shapes")? {
        Json::Array(list) => Vec::from(list),
        Json::Numbers(numbers) => numbers.iter().copied().map(Json::Number).collect(),
        other => {
            let message = format!("\"shapes\" is {}, not an array", other.type_name());
            return Err(Error::new(Code::F017, message).at_pointer("/shapes"));
        }
    };
    members.finish()?;
    Ok(list)
}

/// One shape; `points` is the running number of points in the file.
pub(crate) fn shape(index: usize, tree: Json, limits: &Limits<'_>, points: &mut u64) -> Result<Shape> {
    *points = points.saturating_add(points_of(&tree));
    limits.check_points(*points)?;
    limits.check_cancel()?;
    let mut members = Members::of(tree, child("/shapes", &index.to_string()))?;
    let name = members.optional_text("name")?;
    let data = kinds::read(&mut members)?;
    let curve = AnyCurve::build(data.dimension(), &data).map_err(|core| data.refused(&members, core))?;
    members.finish()?;
    Ok(Shape { name, curve })
}

fn points_of(shape: &Json) -> u64 {
    if let Some(Json::Array(pieces)) = shape.get("pieces") {
        return pieces.iter().map(points_of).fold(0, u64::saturating_add);
    }
    match shape.get("points").or(shape.get("coefficients")) {
        Some(Json::Array(points)) => points.len() as u64,
        Some(Json::Numbers(points)) => points.len() as u64,
        _ => 0,
    }
}
