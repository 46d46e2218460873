//! Lath JSON: what reads, what is refused and where, and that nothing is lost on the way.
#![allow(clippy::unwrap_used)]

use lath::curve::{AnyCurve, Curve, Outside, PolygonEnd, UniformBSpline};
use lath::error::Limits;
use lath_io::shapes::{self, Shape};
use lath_io::source::Source;

fn read(text: &str) -> lath_io::Result<Vec<Shape>> {
    shapes::read(&Source::from_bytes("s.json", text), &Limits::default())
}

/// The one shape with these members.
fn curve(members: &str) -> AnyCurve {
    read(&format!("{{\"lath\": 1, \"shapes\": [{{{members}}}]}}")).unwrap()[0].curve().unwrap().clone()
}

fn at(curve: &AnyCurve, t: f64) -> Vec<f64> {
    let mut point = vec![0.0; curve.dimension()];
    curve.eval_into(t, Outside::Error, &mut point).unwrap();
    point
}

/// Code, pointer, line and column of what is refused; the members stand on line 2.
fn fault(members: &str) -> (String, String, u64, u64) {
    document_fault(&format!("{{\"lath\": 1, \"shapes\": [\n{{{members}}}]}}"))
}

fn document_fault(text: &str) -> (String, String, u64, u64) {
    let error = read(text).unwrap_err();
    let place = error.place();
    assert_eq!((place.source.as_deref(), error.class().exit_code()), (Some("s.json"), 3), "{error}");
    (
        error.code().as_str().into(),
        place.pointer.clone().unwrap_or_default(),
        place.line.unwrap(),
        place.column.unwrap(),
    )
}

fn expect(code: &str, pointer: &str, line: u64, column: u64) -> (String, String, u64, u64) {
    (code.into(), pointer.into(), line, column)
}

#[test]
fn uniform_curves_travel_without_knots() {
    let points = [[0.0, 1.0], [2.0, 5.0], [4.0, -1.0], [7.0, 0.0], [3.0, 3.0]];
    for curve in [
        UniformBSpline::new(3, points).unwrap(),
        UniformBSpline::closed(4, points).unwrap(),
        UniformBSpline::at_polygon(2, points, PolygonEnd::Phantom).unwrap(),
    ] {
        let text = shapes::to_string(&[Shape::from(AnyCurve::of(curve.clone()).unwrap())]).unwrap();
        assert!(text.contains("\"bspline\"") && !text.contains("knots"), "{text}");
        let back = read(&text).unwrap()[0].curve().unwrap().clone();
        assert_eq!((back.domain(), back.is_closed()), (curve.domain(), curve.is_closed()));
        for k in 0..=24 {
            let t = curve.domain().end * f64::from(k) / 24.0;
            let (found, wanted) = (at(&back, t), curve.eval(t).unwrap());
            assert!((0..2).all(|c| (found[c] - wanted[c]).abs() < 4e-15), "{found:?}, not {wanted:?} at {t}");
        }
    }
}

#[test]
fn every_kind_is_read() {
    let c = curve(r#""kind": "bezier", "points": [[0,0],[1,2],[2,0]], "domain": [2, 4], "closed": false"#);
    assert_eq!((c.kind(), c.dimension(), c.degree(), at(&c, 3.0)), ("bezier", 2, 2, vec![1.0, 1.0]));
    let c = curve(r#""kind": "bspline", "degree": 1, "points": [0, 4, 2]"#);
    assert_eq!((c.dimension(), at(&c, 0.5)), (1, vec![2.0]));
    let c = curve(r#""kind": "bspline", "degree": 2, "knots": [0,0,0,1,1,1], "points": [[0],[1],[0]]"#);
    assert_eq!(at(&c, 0.5), [0.5]);
    let c = curve(r#""kind": "bspline", "degree": 3, "closed": true, "points": [[0,6],[6,0],[0,-6],[-6,0]]"#);
    assert_eq!((c.is_closed(), at(&c, 0.0)), (true, vec![4.0, 0.0]));
    let c = curve(r#""kind": "bspline", "degree": 1, "closed": true, "knots": [0,1,3], "points": [[0],[4]]"#);
    assert_eq!((c.domain().end, at(&c, 2.0)), (3.0, vec![2.0]));
    let c = curve(r#""kind": "hermite", "parameters": [0,1], "points": [[0],[1]], "tangents": [[0],[0]]"#);
    assert_eq!(at(&c, 0.5), [0.5]);
    let c = curve(
        r#""kind": "hermite", "closed": true, "parameters": [0,1,2], "points": [[0],[1]], "tangents": [[0],[0]]"#,
    );
    assert_eq!((c.is_closed(), at(&c, 1.5)), (true, vec![0.5]));
    let c = curve(r#""kind": "polyline", "points": [[0,0,0,0,0],[2,2,2,2,2]]"#);
    assert_eq!((c.dimension(), at(&c, 0.5)), (5, vec![1.0; 5]));
    let c = curve(r#""kind": "power", "breaks": [0, 1, 2], "coefficients": [[1, 2], [[3], [4]]]"#);
    assert_eq!((c.kind(), c.degree(), at(&c, 1.5)), ("power", 1, vec![5.0]));
    let c = curve(
        r#""kind": "quintic-hermite", "parameters": [0,2], "points": [0,1], "tangents": [0,0], "seconds": [0,0]"#,
    );
    assert_eq!((c.degree(), at(&c, 1.0)), (5, vec![0.5]));
    let c = curve(
        r#""kind": "path", "pieces": [{"kind": "polyline", "points": [0,4]}, {"kind": "bezier", "points": [4,8]}]"#,
    );
    assert_eq!((c.domain().end, at(&c, 1.5)), (2.0, vec![6.0]));
}

#[test]
fn every_kind_keeps_its_bits() {
    let third = 1.0 / 3.0;
    let documents = [
        format!(r#""kind": "bezier", "name": "a \"b\"\n", "points": [[{third}, 5e-324], [-0.0, 1e300]], "domain": [0.1, {third}]"#),
        r#""kind": "bspline", "degree": 2, "knots": [0, 0.1, 0.2, 0.30000000000000004, 1e15, 2e15], "points": [[0.1], [2], [3]]"#.into(),
        r#""kind": "bspline", "degree": 3, "closed": true, "knots": [0.1, 0.2, 0.7, 1.1], "points": [[0.1, 1], [2, 3], [3, 7]]"#.into(),
        r#""kind": "hermite", "parameters": [0.1, 0.7], "points": [[1, 2, 3], [4, 5, 6.6]], "tangents": [[1e-7, 0, 0], [0, -0.0, 0]]"#.into(),
        r#""kind": "hermite", "closed": true, "parameters": [0, 0.1, 1e16], "points": [[1], [2]], "tangents": [[0.1], [0.2]]"#.into(),
        r#""kind": "power", "breaks": [0.1, 0.2, 0.7], "coefficients": [[[0.1, 1], [2, 0.3], [-0.0, 1e-9]], [[1, 1], [1, 1], [0.7, 1]]]"#.into(),
        r#""kind": "power", "breaks": [0, 1], "coefficients": [[0.1, 0.2, 0.3]]"#.into(),
        r#""kind": "quintic-hermite", "parameters": [0.1, 0.7], "points": [[0.1], [1]], "tangents": [[0.3], [1e-7]], "seconds": [[5e-324], [0.7]]"#.into(),
        r#""kind": "path", "closed": true, "pieces": [
            {"kind": "bezier", "points": [[0, 0], [0.1, 2], [2, 0]], "domain": [0.1, 0.7]},
            {"kind": "path", "pieces": [{"kind": "polyline", "points": [[2, 0], [3, 0.3]]}, {"kind": "polyline", "points": [[3, 0.3], [0, 0]]}]}
        ]"#.into(),
        r#""kind": "polyline", "points": [[1, 2, 3, 4, 5, 6, 7], [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7]]"#.into(),
    ];
    for members in documents {
        let shapes = read(&format!("{{\"lath\": 1, \"shapes\": [{{{members}}}]}}")).unwrap();
        let text = shapes::to_string(&shapes).unwrap();
        let again = read(&text).unwrap();
        assert_eq!(shapes::to_string(&again).unwrap(), text);
        assert_eq!(again[0].name(), shapes[0].name());
        let (a, b) = (shapes[0].curve().unwrap(), again[0].curve().unwrap());
        let domain = a.domain();
        assert_eq!(
            (domain, a.breaks(), a.degree(), a.is_closed()),
            (b.domain(), b.breaks(), b.degree(), b.is_closed())
        );
        for i in 0..=8 {
            let t = domain.start + (domain.end - domain.start) * f64::from(i) / 8.0;
            let bits = |c: &AnyCurve| at(c, t).into_iter().map(f64::to_bits).collect::<Vec<_>>();
            assert_eq!(bits(a), bits(b), "{members} at {t}");
        }
    }
}

#[test]
fn numbers_come_back_as_they_were_written() {
    let numbers = "[0.1, 5e-324, -0, 1e300, 0.30000000000000004, 9007199254740994, 1e16, 0.00001, 9.9e-6]";
    let text = format!("{{\"lath\": 1, \"shapes\": [{{\"kind\": \"polyline\", \"points\": [{numbers}, {numbers}]}}]}}");
    assert!(shapes::to_string(&read(&text).unwrap()).unwrap().contains(numbers));
}

#[test]
fn the_document_is_checked() {
    assert_eq!(document_fault("{\"lath\": 2, \"shapes\": []}"), expect("F018", "/lath", 1, 10));
    assert_eq!(document_fault("{\"lath\": \"1\", \"shapes\": []}"), expect("F018", "/lath", 1, 10));
    assert_eq!(document_fault("{\"shapes\": []}"), expect("F015", "", 1, 1));
    assert_eq!(document_fault("{\"lath\": 1}"), expect("F015", "", 1, 1));
    assert_eq!(document_fault("{\"lath\": 1, \"shapes\": {}}"), expect("F017", "/shapes", 1, 23));
    assert_eq!(document_fault("{\"lath\": 1, \"shapes\": [7]}"), expect("F017", "/shapes/0", 1, 24));
    assert_eq!(document_fault("{\"lath\": 1, \"shapes\": [], \"units\": \"mm\"}"), expect("F016", "/units", 1, 36));
    assert_eq!(document_fault("{\"lath\": 1,\n \"lath\": 1, \"shapes\": []}").0, "F013");
    assert_eq!(document_fault("{\"lath\": 1, \"shapes\": []} x").0, "F011");
    assert_eq!(read("[[1,2]]").unwrap_err().code().as_str(), "F021");
    assert_eq!(read("{\"a\":1}").unwrap_err().code().as_str(), "F021");
    assert!(read("{\"lath\": 1, \"shapes\": []}").unwrap().is_empty());
}

#[test]
fn kinds_are_checked() {
    assert_eq!(fault(r#""points": [[1,2]]"#), expect("F015", "/shapes/0", 2, 1));
    assert_eq!(fault(r#""kind": "nurbs""#), expect("F019", "/shapes/0/kind", 2, 10));
    assert_eq!(fault(r#""kind": 3"#), expect("F017", "/shapes/0/kind", 2, 10));
    for pending in ["bezier-surface", "bspline-surface"] {
        assert_eq!(fault(&format!("\"kind\": \"{pending}\"")), expect("F020", "/shapes/0/kind", 2, 10));
    }
    assert_eq!(
        fault(r#""kind": "bezier", "points": [0,1], "weights": [1]"#),
        expect("R003", "/shapes/0/weights", 2, 48)
    );
    let error = read(r#"{"lath": 1, "shapes": [{"kind": "nurbs"}]}"#).unwrap_err();
    assert_eq!(
        error.remedy(),
        "The kinds are \"bezier\", \"bspline\", \"hermite\", \"path\", \"polyline\", \"power\", \"quintic-hermite\"."
    );
}

#[test]
fn members_are_checked() {
    let cases = [
        (r#""kind": "bezier""#, expect("F015", "/shapes/0", 2, 1)),
        (r#""kind": "bezier", "points": [[0,0],[1]]"#, expect("P005", "/shapes/0/points/1", 2, 37)),
        (r#""kind": "bezier", "points": [[0,0],[1,"a"]]"#, expect("F017", "/shapes/0/points/1/1", 2, 40)),
        (r#""kind": "bezier", "points": [[0,0],1]"#, expect("F017", "/shapes/0/points/1", 2, 37)),
        (r#""kind": "bezier", "points": []"#, expect("P001", "/shapes/0/points", 2, 30)),
        (r#""kind": "bezier", "points": [[]]"#, expect("P006", "/shapes/0/points/0", 2, 31)),
        (r#""kind": "bezier", "points": 7"#, expect("F017", "/shapes/0/points", 2, 30)),
        (r#""kind": "bezier", "points": [[0]], "closed": true"#, expect("C002", "/shapes/0/closed", 2, 47)),
        (r#""kind": "bezier", "points": [[0]], "closed": 1"#, expect("F017", "/shapes/0/closed", 2, 47)),
        (r#""kind": "bezier", "points": [[0]], "domain": [0]"#, expect("F017", "/shapes/0/domain", 2, 47)),
        (r#""kind": "bezier", "points": [[0]], "domain": [1, 0]"#, expect("T003", "/shapes/0/domain/1", 2, 51)),
        (r#""kind": "bezier", "points": [[0]], "domain": [0, 1e305]"#, expect("T005", "/shapes/0/domain/1", 2, 51)),
        (r#""kind": "bezier", "points": [[0],[1e305]]"#, expect("P003", "/shapes/0/points/1", 2, 35)),
        (r#""kind": "bezier", "points": [[0]], "knots": [0]"#, expect("F016", "/shapes/0/knots", 2, 46)),
        (r#""kind": "bezier", "points": [[0]], "name": 4"#, expect("F017", "/shapes/0/name", 2, 45)),
        (r#""kind": "polyline", "points": [[0]]"#, expect("P001", "/shapes/0/points", 2, 32)),
        (r#""kind": "polyline", "points": [0,1], "closed": true"#, expect("C002", "/shapes/0/closed", 2, 49)),
        (r#""kind": "hermite", "parameters": [0,1], "points": [0,1]"#, expect("F015", "/shapes/0", 2, 1)),
        (
            r#""kind": "hermite", "parameters": [1,1], "points": [0,1], "tangents": [0,1]"#,
            expect("T003", "/shapes/0/parameters/1", 2, 38),
        ),
        (
            r#""kind": "hermite", "parameters": [1], "points": [0,1], "tangents": [0,1]"#,
            expect("T004", "/shapes/0/parameters", 2, 35),
        ),
        (
            r#""kind": "hermite", "parameters": [0,1], "points": [0,1], "tangents": [0]"#,
            expect("P005", "/shapes/0/tangents", 2, 71),
        ),
        (
            r#""kind": "hermite", "parameters": [0,1], "points": [0,1], "tangents": [[0,1],[0,1]]"#,
            expect("P005", "/shapes/0/tangents", 2, 71),
        ),
        (
            r#""kind": "hermite", "parameters": [0,1], "points": [0,1], "tangents": [0,1e301]"#,
            expect("P003", "/shapes/0/tangents/1", 2, 74),
        ),
        (
            r#""kind": "hermite", "parameters": [0,1e301], "points": [0,1], "tangents": [0,1]"#,
            expect("T005", "/shapes/0/parameters/1", 2, 38),
        ),
    ];
    for (members, expected) in cases {
        assert_eq!(fault(members), expected, "{members}");
    }
}

#[test]
fn power_and_paths_are_checked() {
    let cases = [
        (r#""kind": "power", "breaks": [0,1]"#, ("F015", "/shapes/0")),
        (r#""kind": "power", "breaks": [0,1], "coefficients": []"#, ("P001", "/shapes/0/coefficients")),
        (r#""kind": "power", "breaks": [0,1], "coefficients": [1]"#, ("F017", "/shapes/0/coefficients/0")),
        (r#""kind": "power", "breaks": [0,1], "coefficients": 1"#, ("F017", "/shapes/0/coefficients")),
        (r#""kind": "power", "breaks": [0,1], "coefficients": [[]]"#, ("P001", "/shapes/0/coefficients/0")),
        (r#""kind": "power", "breaks": [0,1,2], "coefficients": [[1],[1,2]]"#, ("P005", "/shapes/0/coefficients/1")),
        (
            r#""kind": "power", "breaks": [0,1,2], "coefficients": [[[1]],[[1,2]]]"#,
            ("P005", "/shapes/0/coefficients/1"),
        ),
        (r#""kind": "power", "breaks": [0,1,1], "coefficients": [[1],[2]]"#, ("T003", "/shapes/0/breaks/2")),
        (r#""kind": "power", "breaks": [0,1], "coefficients": [[1],[2]]"#, ("T004", "/shapes/0/breaks")),
        (r#""kind": "power", "breaks": [0,1], "coefficients": [[1e301]]"#, ("P003", "/shapes/0/coefficients/0")),
        (r#""kind": "path""#, ("F015", "/shapes/0")),
        (r#""kind": "path", "pieces": []"#, ("P001", "/shapes/0/pieces")),
        (r#""kind": "path", "pieces": 7"#, ("F017", "/shapes/0/pieces")),
        (r#""kind": "path", "pieces": [7]"#, ("F017", "/shapes/0/pieces/0")),
        (r#""kind": "path", "pieces": [{"kind": "nurbs"}]"#, ("F019", "/shapes/0/pieces/0/kind")),
        (
            r#""kind": "path", "pieces": [{"kind": "polyline", "points": [[0],[1e305]]}]"#,
            ("P003", "/shapes/0/pieces/0/points/1"),
        ),
        (
            r#""kind": "path", "pieces": [{"kind": "polyline", "name": "n", "points": [0,1]}]"#,
            ("F016", "/shapes/0/pieces/0/name"),
        ),
        (
            r#""kind": "path", "pieces": [{"kind": "polyline", "points": [0,1]}, {"kind": "polyline", "points": [[0,1],[1,2]]}]"#,
            ("P005", "/shapes/0/pieces/1"),
        ),
        (
            r#""kind": "path", "closed": true, "pieces": [{"kind": "polyline", "points": [0,1]}]"#,
            ("C002", "/shapes/0/closed"),
        ),
        (
            r#""kind": "path", "pieces": [{"kind": "bezier", "domain": [1e200,1e201], "points": [0,1]}, {"kind": "polyline", "points": [0,1]}]"#,
            ("T005", "/shapes/0/pieces/1"),
        ),
        (
            r#""kind": "quintic-hermite", "parameters": [0,1], "points": [0,1], "tangents": [0,1], "seconds": [0,1e301]"#,
            ("P003", "/shapes/0/seconds/1"),
        ),
    ];
    for (members, expected) in cases {
        let (code, pointer, line, _) = fault(members);
        assert_eq!(((&*code, &*pointer), line >= 2), (expected, true), "{members}");
    }
    let mut deep = r#"{"kind": "polyline", "points": [0, 1]}"#.to_owned();
    for level in 0..40 {
        deep = format!(r#"{{"kind": "path", "pieces": [{deep}]}}"#);
        let read = read(&format!(r#"{{"lath": 1, "shapes": [{deep}]}}"#));
        assert_eq!(
            read.map(|_| "read").unwrap_or_else(|e| e.code().as_str()),
            if level < 14 { "read" } else { "F012" }
        );
    }
}

#[test]
fn splines_are_checked() {
    let cases = [
        (r#""kind": "bspline", "points": [0,1]"#, expect("F015", "/shapes/0", 2, 1)),
        (r#""kind": "bspline", "points": [0,1], "degree": 1.5"#, expect("F017", "/shapes/0/degree", 2, 48)),
        (r#""kind": "bspline", "points": [0,1], "degree": -1"#, expect("F017", "/shapes/0/degree", 2, 48)),
        (r#""kind": "bspline", "points": [0,1], "degree": "3""#, expect("F017", "/shapes/0/degree", 2, 48)),
        (r#""kind": "bspline", "points": [0,1], "degree": 3"#, expect("P001", "/shapes/0/points", 2, 31)),
        (
            r#""kind": "bspline", "points": [0,1], "degree": 4000000000000000"#,
            expect("K006", "/shapes/0/degree", 2, 48),
        ),
        (
            r#""kind": "bspline", "points": [0,1], "degree": 67, "closed": true"#,
            expect("K006", "/shapes/0/degree", 2, 48),
        ),
        (
            r#""kind": "bspline", "points": [0,1], "degree": 1, "knots": [0,1,0,1]"#,
            expect("K004", "/shapes/0/knots/2", 2, 65),
        ),
        (
            r#""kind": "bspline", "points": [0,1], "degree": 1, "knots": [0,1,2]"#,
            expect("K001", "/shapes/0/knots", 2, 60),
        ),
        (
            r#""kind": "bspline", "points": [0,1], "degree": 1, "knots": [0,1,2,3,4]"#,
            expect("K001", "/shapes/0/knots", 2, 60),
        ),
        (
            r#""kind": "bspline", "points": [0,1,2], "degree": 1, "knots": [0,0,0,1,1]"#,
            expect("K003", "/shapes/0/knots/2", 2, 67),
        ),
        (
            r#""kind": "bspline", "points": [0,1], "degree": 1, "knots": [0,1,1,2]"#,
            expect("K005", "/shapes/0/knots/1", 2, 63),
        ),
        (
            r#""kind": "bspline", "points": [0,1], "degree": 1, "closed": true, "knots": [0,1]"#,
            expect("K001", "/shapes/0/knots", 2, 76),
        ),
        (
            r#""kind": "bspline", "points": [0,1], "degree": 1, "closed": true, "knots": [0,2,1]"#,
            expect("K004", "/shapes/0/knots/2", 2, 81),
        ),
        (r#""kind": "bspline", "points": [0,1e301], "degree": 1"#, expect("P003", "/shapes/0/points/1", 2, 34)),
        (
            r#""kind": "bspline", "points": [[1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17]], "degree": 0"#,
            expect("P006", "/shapes/0/points", 2, 31),
        ),
    ];
    for (members, expected) in cases {
        assert_eq!(fault(members), expected, "{members}");
    }
}

#[test]
fn the_budget_counts_the_points_of_all_shapes() {
    let shape = r#"{"kind": "polyline", "points": [0, 1, 2]}"#;
    let source = Source::from_bytes("s.json", format!("{{\"lath\": 1, \"shapes\": [{shape}, {shape}]}}"));
    let code = |max_points| {
        let read = shapes::read(&source, &Limits { max_points, ..Limits::default() });
        read.map(|shapes| shapes.len()).map_err(|error| (error.code().as_str(), error.class().exit_code()))
    };
    assert_eq!(code(5), Err(("B001", 5)));
    assert_eq!(code(6), Ok(2));
}
