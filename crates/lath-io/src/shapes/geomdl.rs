//! What geomdl (NURBS-Python) exports as JSON: `{"shape": {"type": "curve", "count": 1, "data": [ … ]}}`.
//!
//! Curves are read, rational ones with their weights beside Cartesian points. Surfaces and volumes are refused by name until they exist
//! here. `delta` is the step at which geomdl would evaluate the curve: no part of its shape, it is left out.

use lath::curve::AnyCurve;
use lath::error::{Code as CoreCode, Limits};

use crate::error::{Code, Error, Result};
use crate::json::{self, Json, Members, child};
use crate::number::counted;
use crate::shapes::{Shape, bspline, kinds};
use crate::source::Source;

/// True for an object whose member `shape` has `data`.
pub(crate) fn recognise(tree: &Json) -> bool {
    tree.get("shape").is_some_and(|shape| shape.has("data"))
}

pub(crate) fn from_tree(source: &Source, tree: Json, limits: &Limits<'_>) -> Result<Vec<Shape>> {
    document(tree, limits).map_err(|error| json::place(source, error))
}

fn document(tree: Json, limits: &Limits<'_>) -> Result<Vec<Shape>> {
    let mut top = Members::of(tree, "")?;
    let shape = top.require("shape", "{…}")?;
    top.finish()?;
    let mut shape = Members::of(shape, "/shape")?;
    let kind = shape.optional_text("type")?.unwrap_or_default();
    let count = shape.count("count")?;
    let list = match shape.require("data", "[…]")? {
        Json::Array(list) => Vec::from(list),
        Json::Numbers(numbers) => numbers.iter().copied().map(Json::Number).collect(),
        other => {
            let message = format!("\"data\" is {}, not an array", other.type_name());
            return Err(Error::new(Code::F017, message).at_pointer("/shape/data"));
        }
    };
    shape.finish()?;
    if kind != "curve" {
        let rational = list.first().and_then(|first| first.get("rational")) == Some(&Json::Bool(true));
        let rational = if rational { "rational " } else { "" };
        return Err(Error::new(Code::F020, format!("a {rational}{kind} of geomdl is not supported yet"))
            .remedied("Give a curve.")
            .at_pointer("/shape/type"));
    }
    if count != list.len() {
        let message = format!("\"count\" is {count}, but \"data\" has {} items", list.len());
        return Err(Error::new(Code::F017, message)
            .remedied("Correct the count; the file may be cut off.")
            .at_pointer("/shape/count"));
    }
    let mut points = 0;
    let read =
        |(index, tree): (usize, Json)| curve(tree, child("/shape/data", &index.to_string()), limits, &mut points);
    list.into_iter().enumerate().map(read).collect()
}

fn curve(tree: Json, pointer: String, limits: &Limits<'_>, total: &mut u64) -> Result<Shape> {
    let mut members = Members::of(tree, pointer)?;
    if members.optional_text("type")?.is_some_and(|kind| kind != "spline") {
        return Err(Error::new(Code::F020, "only splines of geomdl are supported")
            .remedied("Give a spline.")
            .at_pointer(members.pointer("type")));
    }
    let rational = members.flag("rational")?;
    let name = members.optional_text("name")?;
    let _ = (members.take("id"), members.take("delta"));
    let dimension = members.count("dimension")?;
    let degree = members.count("degree")?;
    let knots = members.numbers("knotvector")?;
    let mut control =
        Members::of(members.require("control_points", "{\"points\": […]}")?, members.pointer("control_points"))?;
    let points = control.rows("points")?;
    let weights = match control.optional_numbers("weights")? {
        // Without weights all of them are 1.
        None if rational => Some(vec![1.0; points.values.len() / points.width.max(1)]),
        weights => weights,
    };
    control.finish()?;
    members.finish()?;
    if points.width != dimension {
        let message =
            format!("\"dimension\" is {dimension}, but the points have {}", counted(points.width, "coordinate"));
        return Err(Error::new(Code::Core(CoreCode::P005), message).at_pointer(members.pointer("dimension")));
    }
    *total = total.saturating_add((points.values.len() / points.width) as u64);
    limits.check_points(*total)?;
    let data = kinds::Data::BSpline(bspline::Data::open(degree, knots, points, weights));
    let curve = AnyCurve::build(data.dimension(), &data).map_err(|core| match core.code() {
        CoreCode::K006 => members.refused("degree", core),
        _ if core.is_knots() => members.refused("knotvector", core),
        _ if core.is_weights() => control.refused("weights", core),
        _ => control.refused("points", core),
    })?;
    let shape = Shape::from(curve);
    Ok(match name {
        Some(name) => shape.named(name),
        None => shape,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::format;

    fn read(text: &str) -> Result<Vec<Shape>> {
        format::read_shapes(&Source::from_bytes("a.json", text), None, &Limits::default())
    }

    const POINTS: &str = r#""control_points": {"points": [[0,0],[1,2]]}"#;

    fn one(members: &str) -> String {
        format!(r#"{{"shape": {{"type": "curve", "count": 1, "data": [{{"type": "spline", {members}}}]}}}}"#)
    }

    fn fault(text: &str) -> (&'static str, String) {
        let error = read(text).unwrap_err();
        assert!(error.place().line.is_some());
        (error.code().as_str(), error.place().pointer.clone().unwrap())
    }

    #[test]
    fn a_curve_is_read() {
        let text = one(&format!(
            r#""rational": false, "dimension": 2, "degree": 1, "knotvector": [0,0,1,1], "name": "n", "delta": 0.01, {POINTS}"#
        ));
        let shapes = read(&text).unwrap();
        assert_eq!((shapes.len(), shapes[0].kind(), shapes[0].name()), (1, "bspline", Some("n")));
    }

    #[test]
    fn a_rational_curve_is_read_with_its_weights() {
        let rest = r#""dimension": 2, "degree": 1, "knotvector": [0,0,1,1]"#;
        let weighted = r#""control_points": {"points": [[0,0],[1,2]], "weights": [1, 3]}"#;
        for (members, middle) in
            [(format!("{rest}, {weighted}"), [0.75, 1.5]), (format!("{rest}, {POINTS}"), [0.5, 1.0])]
        {
            let shapes = read(&one(&format!(r#""rational": true, {members}"#))).unwrap();
            let (curve, mut point) = (shapes[0].curve().unwrap(), [0.0; 2]);
            curve.eval_into(0.5, lath::curve::Outside::Error, &mut point).unwrap();
            assert_eq!((curve.is_rational(), point), (true, middle));
        }
    }

    #[test]
    fn what_is_not_supported_is_named() {
        let surface = r#"{"shape": {"type": "surface", "count": 1, "data": [{"rational": true}]}}"#;
        let error = read(surface).unwrap_err();
        assert_eq!(error.message(), "a rational surface of geomdl is not supported yet");
        assert_eq!(fault(surface), ("F020", "/shape/type".into()));
        let at = |member: &str| format!("/shape/data/0/{member}");
        let rest = r#""dimension": 2, "degree": 1, "knotvector": [0,0,1,1]"#;
        let weights = |list: &str| format!(r#""control_points": {{"points": [[0,0],[1,2]], "weights": {list}}}"#);
        let at_weights = |index: &str| at(&format!("control_points/weights{index}"));
        assert_eq!(fault(&one(&format!("{rest}, {}", weights("[1, 1, 1]")))), ("R003", at_weights("")));
        assert_eq!(fault(&one(&format!("{rest}, {}", weights("[1, 1e301]")))), ("R002", at_weights("/1")));
        assert_eq!(fault(&one(&format!("{rest}, {}", weights("[1, -1]")))), ("R004", at_weights("")));
        assert_eq!(fault(&one(&format!(r#"{rest}, "trims": [], {POINTS}"#))), ("F016", at("trims")));
        let wrong = r#""dimension": 3, "degree": 1, "knotvector": [0,0,1,1]"#;
        assert_eq!(fault(&one(&format!("{wrong}, {POINTS}"))), ("P005", at("dimension")));
        let wrong = r#""dimension": 2, "degree": 1, "knotvector": [0,1,0,1]"#;
        assert_eq!(fault(&one(&format!("{wrong}, {POINTS}"))), ("K004", at("knotvector/2")));
        assert_eq!(fault(r#"{"shape": {"type": "curve", "count": 2, "data": []}}"#), ("F017", "/shape/count".into()));
        assert_eq!(fault(r#"{"shape": {"type": "curve", "count": 1, "data": 3}}"#), ("F017", "/shape/data".into()));
    }
}
