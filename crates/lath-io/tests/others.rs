//! What NumPy, SciPy and geomdl write.
#![allow(clippy::unwrap_used)]

use std::path::PathBuf;

use lath::curve::Outside;
use lath::error::Limits;
use lath_io::{format, source::Source};

fn source(name: &str) -> Source {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../testdata").join(name);
    Source::open(path, &Limits::default()).unwrap()
}

#[test]
fn arrays_of_numpy_are_read_with_the_same_bits() {
    let rows = [0.1, -0.0, 1e300, 5e-324, 1.0 / 3.0, -2.5];
    let bits = |values: &[f64]| values.iter().map(|x| x.to_bits()).collect::<Vec<_>>();
    let table =
        |name: &str| format::read_points(&source(&format!("npy/{name}.npy")), None, &Limits::default()).unwrap();
    for name in ["c-order", "fortran-order", "big-endian", "version-2", "version-3"] {
        let t = table(name);
        assert_eq!((t.width(), t.columns(), bits(t.values())), (3, None, bits(&rows)), "{name}");
    }
    assert_eq!((table("one-dimension").width(), table("one-dimension").values()), (1, &[-0.0, 1.0 / 3.0][..]));
    let narrow = [-0.0, 1e300, 1.0 / 3.0, -2.5].map(|x: f64| f64::from(x as f32));
    assert_eq!(table("float32").values(), [narrow[0], narrow[2]]);
    assert_eq!(table("int64").values(), [1.0, -2.0, 9007199254740992.0, -9007199254740992.0]);
    assert_eq!(table("uint8").values(), [0.0, 255.0]);
}

#[test]
fn arrays_that_are_no_points_are_refused_by_name() {
    let cases = [
        ("complex", "F025", "the numbers are of dtype \"<c16\", which is not read"),
        ("records", "F025", "the rows are records of named fields, not plain numbers"),
        ("text", "F025", "the numbers are of dtype \"<U1\", which is not read"),
        ("nan", "P002", "column 1 of row 0 is NaN"),
        ("empty", "P001", "the array has no rows"),
        ("cube", "F025", "the array has 3 dimensions, not 1 or 2"),
    ];
    for (name, code, message) in cases {
        let error = format::read(&source(&format!("npy/{name}.npy")), None, &Limits::default()).unwrap_err();
        assert_eq!((error.code().as_str(), error.message()), (code, message), "{name}");
    }
}

#[test]
fn curves_of_scipy_are_the_same_curves() {
    for (name, degree, dimension) in [("splrep", 3, 1), ("space", 4, 3)] {
        let limits = Limits::default();
        let shapes = format::read_shapes(&source(&format!("scipy/{name}.json")), None, &limits).unwrap();
        let curve = shapes[0].curve().unwrap();
        assert_eq!((shapes.len(), curve.degree(), curve.dimension()), (1, degree, dimension));
        let text = source(&format!("scipy/{name}.values.json"));
        let answers: serde_json::Value = serde_json::from_slice(text.bytes()).unwrap();
        for (t, values) in answers["at"].as_array().unwrap().iter().zip(answers["values"].as_array().unwrap()) {
            let mut point = vec![0.0; dimension];
            curve.eval_into(t.as_f64().unwrap(), Outside::Error, &mut point).unwrap();
            for (found, expected) in point.iter().zip(values.as_array().unwrap()) {
                assert!((found - expected.as_f64().unwrap()).abs() < 1e-12, "{name} at {t}");
            }
        }
    }
}

#[test]
fn geomdl_exports_are_read_or_refused_by_name() {
    let shapes = format::read_shapes(&source("geomdl/curve.json"), None, &Limits::default()).unwrap();
    let curve = shapes[0].curve().unwrap();
    assert_eq!((shapes[0].kind(), curve.degree(), curve.dimension(), curve.breaks().len()), ("bspline", 3, 3, 8));
    let mut end = [0.0; 3];
    curve.eval_into(1.0, Outside::Error, &mut end).unwrap();
    assert_eq!(end, [5.0, 15.0, 30.0]);
    let error = format::read(&source("geomdl/torus.json"), None, &Limits::default()).unwrap_err();
    assert_eq!(error.message(), "a rational surface of geomdl is not supported yet");
    assert_eq!((error.code().as_str(), error.place().pointer.as_deref()), ("F020", Some("/shape/type")));
}
