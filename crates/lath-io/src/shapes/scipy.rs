//! SciPy's B-splines as JSON: `{"t": […], "c": […], "k": 3}`.
//!
//! `t` are all knots, `k` is the degree, and `c` holds n = len(t) − k − 1 coefficients: numbers in one dimension, arrays
//! of coordinates in several, one for each coefficient (as `scipy.interpolate.BSpline` has them). FITPACK
//! (`splrep`) makes `c` as long as `t` and fills it up with zeros: exactly this is taken too, and the zeros are left
//! out. The domain is [t_k, t_n] there and here.
//!
//! Going out, it is one open B-spline.

use std::io::Write;

use lath::curve::AnyCurve;
use lath::error::{Code as CoreCode, Limits};

use crate::error::{Code, Error, Result};
use crate::json::{self, Json, Members, Rows};
use crate::number::counted;
use crate::shapes::object::{Member, Object};
use crate::shapes::{Shape, bspline, kinds};
use crate::source::Source;

/// True for an object with `t`, `c` and the number `k`.
pub(crate) fn recognise(tree: &Json) -> bool {
    tree.has("t") && tree.has("c") && matches!(tree.get("k"), Some(Json::Number(_)))
}

pub(crate) fn from_tree(source: &Source, tree: Json, limits: &Limits<'_>) -> Result<Vec<Shape>> {
    document(tree, limits).map(|shape| vec![shape]).map_err(|error| json::place(source, error))
}

fn document(tree: Json, limits: &Limits<'_>) -> Result<Shape> {
    let mut members = Members::of(tree, "")?;
    let knots = members.numbers("t")?;
    let mut points = members.rows("c")?;
    let degree = members.count("k")?;
    members.finish()?;
    let found = points.values.len() / points.width;
    limits.check_points(found as u64)?;
    if let Some(wanted) = knots.len().checked_sub(degree.saturating_add(1)) {
        drop_padding(&mut points, found, wanted, knots.len());
        let left = points.values.len() / points.width;
        if left != wanted {
            let message = format!(
                "{} and degree {degree} take {}, but c has {found}",
                counted(knots.len(), "knot"),
                counted(wanted, "coefficient")
            );
            let remedy = if points.width == wanted {
                "Give one array for each coefficient: c is transposed."
            } else {
                "Give as many, or as many as knots with zeros behind, as splrep does."
            };
            return Err(Error::new(Code::Core(CoreCode::K001), message).remedied(remedy).at_pointer("/c"));
        }
    }
    let data = kinds::Data::BSpline(bspline::Data::open(degree, knots, points, None));
    let curve = AnyCurve::build(data.dimension(), &data).map_err(|core| {
        let member = match core.code() {
            CoreCode::K006 => "k",
            _ if core.is_knots() => "t",
            _ => "c",
        };
        members.refused(member, core)
    })?;
    Ok(Shape::from(curve))
}

/// Leaves out the zeros of FITPACK: `c` as long as `t`, and nothing but zeros behind the coefficients.
fn drop_padding(points: &mut Rows, found: usize, wanted: usize, knots: usize) {
    let end = wanted * points.width;
    let zeros = points.values.get(end..).is_some_and(|rest| rest.iter().all(|&x| x == 0.0));
    if found == knots && zeros {
        points.values.truncate(end);
    }
}

/// Writes one open B-spline.
///
/// # Errors
/// F023 another number of shapes, another kind, or a closed curve; I005 where writing fails.
pub(crate) fn write(out: &mut dyn Write, shapes: &[Shape]) -> Result<()> {
    let refuse = |message: String| Error::new(Code::F023, message);
    let [shape] = shapes else {
        return Err(
            refuse(format!("the format scipy holds one curve, not {}", shapes.len())).remedied("Choose one shape.")
        );
    };
    let curve = &shape.curve;
    if shape.kind() != "bspline" || curve.is_closed() {
        let closed = if curve.is_closed() { "closed " } else { "" };
        return Err(refuse(format!("the format scipy holds open bsplines, not a {closed}{}", shape.kind()))
            .remedied("Convert the shape to an open bspline."));
    }
    let body = kinds::write(curve).map(|(_, body)| body).unwrap_or_default();
    let mut text = String::new();
    let mut object = Object::default();
    for (key, member) in body.into_members() {
        match (key, member) {
            ("knots", knots) => object.push("t", knots),
            ("points", Member::Rows(1, values)) => object.push("c", Member::Numbers(values)),
            ("points", points) => object.push("c", points),
            ("degree", degree) => object.push("k", degree),
            _ => {}
        }
    }
    object.print(0, &mut text)?;
    text.push('\n');
    out.write_all(text.as_bytes()).and_then(|()| out.flush()).map_err(|e| Error::writing(&e))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::format;

    fn read(text: &str) -> Result<Vec<Shape>> {
        format::read_shapes(&Source::from_bytes("a.json", text), None, &Limits::default())
    }

    fn written(text: &str) -> String {
        let mut out = Vec::new();
        format::by_name("scipy").unwrap().write_shapes(&mut out, &read(text).unwrap()).unwrap();
        String::from_utf8(out).unwrap()
    }

    fn fault(text: &str) -> (&'static str, String) {
        let error = read(text).unwrap_err();
        assert!(error.place().line.is_some());
        (error.code().as_str(), error.place().pointer.clone().unwrap())
    }

    #[test]
    fn coefficients_padded_by_fitpack_are_taken() {
        let plain = r#"{"t": [0,0,0,1,1,1], "c": [1,2,4], "k": 2}"#;
        let padded = r#"{"t": [0,0,0,1,1,1], "c": [1,2,4,0,0,-0.0], "k": 2}"#;
        assert_eq!(written(padded), written(plain));
        assert_eq!(written(&written(plain)), written(plain));
        assert_eq!(written(plain), "{\n  \"k\": 2,\n  \"t\": [0, 0, 0, 1, 1, 1],\n  \"c\": [1, 2, 4]\n}\n");
        let plane = r#"{"k": 1, "t": [0,0,1,1], "c": [[1,2],[3,4]]}"#;
        assert_eq!(read(plane).unwrap()[0].curve().unwrap().dimension(), 2);
        assert_eq!(written(&written(plane)), written(plane));
    }

    #[test]
    fn faults_have_their_member() {
        assert_eq!(fault(r#"{"t": [0,0,0,1,1,1], "c": [1,2,4,0,0,1], "k": 2}"#), ("K001", "/c".into()));
        assert_eq!(fault(r#"{"t": [0,0,0,1,1,1], "c": [1,2,4,0], "k": 2}"#), ("K001", "/c".into()));
        assert_eq!(fault(r#"{"t": [0,0], "c": [1], "k": 2}"#), ("K001", "/t".into()));
        assert_eq!(fault(r#"{"t": [0,1,0,1], "c": [1,2], "k": 1}"#), ("K004", "/t/2".into()));
        assert_eq!(fault(r#"{"t": [0,0,1,1], "c": [1,2], "k": 1.5}"#), ("F017", "/k".into()));
        assert_eq!(fault(r#"{"t": [0,0,1,1], "c": [1,null], "k": 1}"#), ("F017", "/c/1".into()));
        assert_eq!(
            fault(r#"{"t": [0,0,1,1], "c": [1,2], "k": 1, "extrapolate": true}"#),
            ("F016", "/extrapolate".into())
        );
        let error = read(r#"{"t": [0,0,0,1,1,1], "c": [[1,2,4],[1,2,4]], "k": 2}"#).unwrap_err();
        assert_eq!(
            (error.code().as_str(), error.remedy()),
            ("K001", "Give one array for each coefficient: c is transposed.")
        );
    }

    #[test]
    fn other_shapes_are_not_written() {
        let code = |text: &str| {
            let scipy = format::by_name("scipy").unwrap();
            scipy.write_shapes(&mut Vec::new(), &read(text).unwrap()).unwrap_err().code().as_str()
        };
        assert_eq!(code(r#"{"lath": 1, "shapes": []}"#), "F023");
        assert_eq!(code(r#"{"lath": 1, "shapes": [{"kind": "polyline", "points": [1, 2]}]}"#), "F023");
        let closed = r#"{"lath": 1, "shapes": [{"kind": "bspline", "degree": 1, "closed": true, "points": [1, 2]}]}"#;
        assert_eq!(code(closed), "F023");
        let csv = format::by_name("csv").unwrap();
        assert_eq!(csv.write_shapes(&mut Vec::new(), &[]).unwrap_err().code().as_str(), "F023");
    }
}
