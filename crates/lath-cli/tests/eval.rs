//! `lath eval`: sites, derivatives, formats, what lies outside.
#![allow(clippy::unwrap_used, clippy::panic)] // a failing unwrap is a failing test

mod tool;

use tool::{Folder, lath, lath_from, rows, table};

const PARABOLA: &str = r#"{"lath": 1, "shapes": [{"kind": "bezier", "points": [[0,0],[1,2],[2,0]]}]}"#;
const TWO: &str = r#"{"lath": 1, "shapes": [
  {"kind": "polyline", "points": [[0,0],[4,0],[4,2]], "name": "bent"},
  {"kind": "bezier", "points": [1,3], "domain": [-1,1]}]}"#;

#[track_caller]
fn eval(input: &str, args: &str) -> String {
    lath_from(input, ["eval", "-"].into_iter().chain(args.split_whitespace())).done()
}

#[test]
fn columns_are_t_point_derivatives() {
    assert_eq!(eval(PARABOLA, "--at 0,1/2,1"), "t,x,y\n0,0,0\n0.5,1,1\n1,2,0\n");
    assert_eq!(eval(PARABOLA, "--at 0.5 --derivatives 3"), "t,x,y,x_1,y_1,x_2,y_2,x_3,y_3\n0.5,1,1,2,0,0,-8,0,0\n");
    assert_eq!(eval(TWO, "--shape 1 --at 0 --derivatives 1"), "t,x,x_1\n0,2,1\n");
    let (header, _) =
        table(&eval(r#"{"lath":1,"shapes":[{"kind":"bezier","points":[[1,2,3]]}]}"#, "--at 0 --derivatives 1"));
    assert_eq!(header, ["t", "x", "y", "z", "x_1", "y_1", "z_1"]);
    let (header, _) =
        table(&eval(r#"{"lath":1,"shapes":[{"kind":"bezier","points":[[1,2,3,4]]}]}"#, "--at 0 --derivatives 1"));
    assert_eq!(header, ["t", "x0", "x1", "x2", "x3", "x0_1", "x1_1", "x2_1", "x3_1"]);
}

#[test]
fn counts_end_exactly() {
    let t = |args: &str| rows(&eval(PARABOLA, args)).iter().map(|row| row[0]).collect::<Vec<_>>();
    assert_eq!(t("--count 5"), [0.0, 0.25, 0.5, 0.75, 1.0]);
    assert_eq!(t("--count 1"), [0.0]);
    assert_eq!(t("--count 1e3").len(), 1000);
    for count in ["0", "-3", "2.5", "many"] {
        lath_from(PARABOLA, ["eval", "-", "--count", count]).fails(2, &["--count", "from 1"]);
    }
    let thirds = r#"{"lath":1,"shapes":[{"kind":"bezier","points":[0,1],"domain":[0.1,0.7]}]}"#;
    let last = rows(&eval(thirds, "--count 4"));
    assert_eq!((last[0][0], last[3][0]), (0.1, 0.7));
}

#[test]
fn breaks_and_files_give_the_sites() {
    assert_eq!(eval(TWO, "--shape 0 --at breaks"), "t,x,y\n0,0,0\n1,4,0\n2,4,2\n");
    let folder = Folder::new();
    let shapes = folder.file("parabola.json", PARABOLA);
    let expected = "t,x,y\n1,2,0\n0,0,0\n0.5,1,1\n";
    for (name, content) in [("t.csv", "t\n1\n0\n0.5\n"), ("t.txt", "# sites\n1\n0\n\n0.5"), ("t.json", "[1,0,0.5]")] {
        let sites = folder.file(name, content);
        assert_eq!(lath(["eval", &shapes, "--at-file", &sites]).done(), expected, "{name}");
        assert_eq!(lath_from(content, ["eval", &shapes, "--at-file", "-"]).done(), expected, "{name}");
    }
    let sites = folder.file("late.csv", "t\n0\n1\n\n3\n4\n");
    lath(["eval", &shapes, "--at-file", &sites]).fails(3, &["late.csv:5: ", "T002", "t = 3", "[0, 1]"]);
    let sites = folder.file("wide.csv", "0,1\n1,2\n");
    lath(["eval", &shapes, "--at-file", &sites]).fails(3, &["wide.csv", "P005", "rows of 2", "one column"]);
    lath_from(PARABOLA, ["eval", "-", "--at-file", "-"]).fails(2, &["only once"]);
}

#[test]
fn outside_is_a_choice() {
    let outside = |policy: &[&str]| lath_from(PARABOLA, [&["eval", "-", "--at", "0,1.5,-1/2"], policy].concat());
    outside(&[]).fails(3, &["T002", "t = 1.5", "[0, 1]", "index 1", "extrapolate"]);
    outside(&["--outside", "error"]).fails(3, &["T002", "t = 1.5"]);
    assert_eq!(rows(&outside(&["--outside", "clamp"]).done())[1..], [[1.5, 2.0, 0.0], [-0.5, 0.0, 0.0]]);
    assert_eq!(rows(&outside(&["--outside", "extrapolate"]).done())[1..], [[1.5, 3.0, -3.0], [-0.5, -1.0, -3.0]]);
    assert_eq!(rows(&outside(&["--outside", "periodic"]).done())[1..], [[1.5, 1.0, 1.0], [-0.5, 1.0, 1.0]]);
    outside(&["--outside", "wrap"]).fails(2, &["wrap", "periodic"]);
    // Closed curves are periodic unless told otherwise.
    let closed = lath_from("1,0\n0,1\n-1,0\n0,-1\n", ["through", "-", "--closed", "--params", "uniform"]).done();
    assert_eq!(rows(&eval(&closed, "--at 1,5,-3")).iter().map(|row| row[2]).collect::<Vec<_>>(), [1.0, 1.0, 1.0]);
    lath_from(&closed, ["eval", "-", "--at", "5", "--outside", "error"]).fails(3, &["T002"]);
}

#[test]
fn what_cannot_be_written_is_found_before_writing() {
    let huge = r#"{"lath":1,"shapes":[{"kind":"bezier","points":[0,1e300],"domain":[0,1e-10]}]}"#;
    lath_from(huge, ["eval", "-", "--at", "0,1e-10", "--derivatives", "1"])
        .fails(3, &["P003", "derivative of order 1"]);
    lath_from(huge, ["eval", "-", "--at", "0,1", "--outside", "extrapolate"])
        .fails(3, &["P003", "overflows at t = 1", "index 1"]);
}

#[test]
fn several_shapes_need_a_choice() {
    lath_from(TWO, ["eval", "-", "--count", "2"])
        .fails(3, &["A001", "2 shapes", "0 polyline \"bent\"", "1 bezier", "--shape"]);
    lath_from(TWO, ["eval", "-", "--count", "2", "--shape", "2"]).fails(3, &["A002", "shape 2", "1 bezier"]);
    lath_from(TWO, ["eval", "-", "--count", "2", "--shape", "-1"]).fails(2, &["--shape"]);
    lath_from(r#"{"lath":1,"shapes":[]}"#, ["eval", "-", "--count", "2"]).fails(3, &["A002", "no shapes"]);
    lath_from("0,0\n1,1\n", ["eval", "-", "--count", "2"]).fails(3, &["F021", "through"]);
}

#[test]
fn tables_in_every_format() {
    assert_eq!(eval(PARABOLA, "--at 1/2 --format tsv"), "t\tx\ty\n0.5\t1\t1\n");
    assert_eq!(eval(PARABOLA, "--at 1/2 --format text"), "t x y\n0.5 1 1\n");
    let json: serde_json::Value = serde_json::from_str(&eval(PARABOLA, "--at 0,1/2 --json")).unwrap();
    assert_eq!(json.as_object().unwrap().keys().collect::<Vec<_>>(), ["columns", "rows"]);
    assert_eq!(json["columns"], serde_json::json!(["t", "x", "y"]));
    assert_eq!(tool::numbers(&json["rows"]), [0.0, 0.0, 0.0, 0.5, 1.0, 1.0]);
    assert_eq!(eval(PARABOLA, "--at 0,1/2 --json"), eval(PARABOLA, "--at 0,1/2 --format json"));
    let folder = Folder::new();
    for (name, start) in [("a.tsv", "t\tx\ty"), ("a.txt", "t x y"), ("a.json", "{\"columns\""), ("a", "t,x,y")] {
        let path = folder.path(name);
        assert_eq!(lath_from(PARABOLA, ["eval", "-", "--count", "3", "-o", &path]).done(), "");
        assert!(std::fs::read_to_string(path).unwrap().starts_with(start), "{name}");
    }
    lath_from(PARABOLA, ["eval", "-", "--count", "3", "-o", &folder.path("a.xlsx")]).fails(2, &[".xlsx", "--format"]);
    lath_from(PARABOLA, ["eval", "-", "--count", "3", "--json", "--format", "csv"]).fails(2, &["--json", "--format"]);
    // What comes out goes in again.
    assert_eq!(
        rows(&eval(PARABOLA, "--count 3")),
        rows(&lath_from(eval(PARABOLA, "--count 3"), ["through", "-", "--params", "column:t"]).done().pipe_eval())
    );
}

trait PipeEval {
    fn pipe_eval(self) -> String;
}

impl PipeEval for String {
    /// The curve at its breaks.
    fn pipe_eval(self) -> String {
        eval(&self, "--at breaks")
    }
}

#[test]
fn a_break_has_two_sides() {
    let corner = r#"{"lath":1,"shapes":[{"kind":"polyline","points":[[0,0],[3,0],[3,4]]}]}"#;
    let slope = |curve: &str, options: &str| rows(&eval(curve, &format!("--derivatives 1 {options}")))[0][3..].to_vec();
    assert_eq!(slope(corner, "--at 1 --side left"), [3.0, 0.0]);
    assert_eq!(slope(corner, "--at 1 --side right"), [0.0, 4.0]);
    assert_eq!(slope(corner, "--at 1"), [0.0, 4.0]);
    // At the ends of an open curve there is only one side.
    assert_eq!(slope(corner, "--at 0 --side left"), [3.0, 0.0]);
    assert_eq!(slope(corner, "--at 2 --side right"), [0.0, 4.0]);
    let ring = r#"{"lath":1,"shapes":[{"kind":"bspline","degree":1,"closed":true,"points":[[0,0],[3,0],[3,4]]}]}"#;
    assert_eq!(slope(ring, "--at 0 --side left"), [-3.0, -4.0]);
    assert_eq!(slope(ring, "--at 0 --side right"), [3.0, 0.0]);
    // Values, where the curve jumps.
    let jump = r#"{"lath":1,"shapes":[{"kind":"bspline","degree":1,"knots":[0,0,1,1,2,2],"points":[0,1,5,6]}]}"#;
    assert_eq!(rows(&eval(jump, "--at 1 --side left"))[0][1], 1.0);
    assert_eq!(rows(&eval(jump, "--at 1"))[0][1], 5.0);
    lath_from(corner, ["eval", "-", "--at", "1", "--side", "lfet"]).fails(2, &["--side", "'left'"]);
}

#[test]
fn exactly_one_way_to_say_where() {
    lath_from(PARABOLA, ["eval", "-"]).fails(2, &["--at", "--count", "--at-file"]);
    lath_from(PARABOLA, ["eval", "-", "--at", "0", "--count", "2"]).fails(2, &["--at", "--count"]);
    for at in ["", "0,", "zero", "nan", "1/0", "0;1"] {
        lath_from(PARABOLA, ["eval", "-", "--at", at]).fails(2, &["--at"]);
    }
}
