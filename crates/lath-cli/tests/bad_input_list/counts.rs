//! Rows 13 to 25: counts and degrees.

use crate::tool::{Folder, lath, lath_from, numbers, rows, shape};
use crate::{document, eval, points_fail, run, shape_fails};
use std::io::Read;
use std::process::{Command, Stdio};

#[test]
fn row_13_no_points() {
    points_fail("", &["standard input", "F001"]);
    points_fail("x,y\n", &["P001"]);
    points_fail("[]", &["P001"]);
    for kind in ["bezier", "polyline"] {
        shape_fails(&format!(r#""kind": "{kind}", "points": []"#), &["P001", "/shapes/0/points"]);
    }
    shape_fails(r#""kind": "path", "pieces": []"#, &["P001", "/shapes/0/pieces"]);
}

#[test]
fn row_14_one_point() {
    for options in ["", " --closed", " --kind pchip", " --params uniform"] {
        run("1,2\n", &format!("through -{options}")).fails(3, &["P001", "not 1"]);
    }
    for constant in [r#""kind": "bezier", "points": [[1,2]]"#, r#""kind": "bspline", "degree": 0, "points": [[1,2]]"#] {
        assert_eq!(eval(constant, "--at 0,1 --derivatives 1"), [[0.0, 1.0, 2.0, 0.0, 0.0], [1.0, 1.0, 2.0, 0.0, 0.0]]);
        let picture = run(document(constant), "draw - --comb --axes -o - --format svg").done();
        assert!(picture.starts_with("<svg") && !picture.contains("NaN"), "{picture}");
    }
    shape_fails(r#""kind": "polyline", "points": [[1,2]]"#, &["P001"]);
}

#[test]
fn row_15_two_points_of_degree_3() {
    run("0,0\n1,1\n", "curve - --kind bspline").fails(3, &["P001", "2 points", "degree 3", "at least 4"]);
    run("0,0\n1,1\n", "through - --kind bspline").fails(3, &["P001", "2 points", "degree 3"]);
    let line = run("0,0\n2,4\n", "through - --params uniform").done();
    assert_eq!(rows(&run(&line, "eval - --at 1/2 --derivatives 1").done()), [[0.5, 1.0, 2.0, 2.0, 4.0]]);
}

#[test]
fn row_16_no_more_points_than_the_degree() {
    let points = "0,0\n1,1\n2,0\n3,1\n4,0\n";
    for degree in [5, 6, 999] {
        let words = ["P001", "5 points", &format!("degree {degree}"), &format!("at least {}", degree + 1)];
        run(points, &format!("curve - --kind bspline --degree {degree}")).fails(3, &words);
        run(points, &format!("curve - --kind bspline --degree {degree} --knots uniform")).fails(3, &words);
    }
    run(points, "curve - --kind bspline --degree 4").done();
    shape_fails(r#""kind": "bspline", "degree": 2, "points": [0,1]"#, &["P001", "2 points", "degree 2"]);
}

#[test]
fn row_17_degree_0_is_piecewise_constant() {
    let steps = run("1\n2\n4\n", "curve - --kind bspline --degree 0").done();
    let answer = rows(&run(&steps, "eval - --at 0,1/2,1,5/2,3").done());
    assert_eq!(answer.iter().map(|row| row[1]).collect::<Vec<_>>(), [1.0, 1.0, 2.0, 4.0, 4.0]);
    assert!(run(&steps, "draw - -o - --format svg").done().starts_with("<svg"));
}

#[test]
fn row_18_huge_and_negative_degrees() {
    let points = "0,0\n1,1\n2,0\n3,1\n";
    for degree in ["1001", "2147483648", "18446744073709551615"] {
        run(points, &format!("curve - --kind bspline --degree {degree}")).fails(3, &["K006", degree]);
        // The last is an integer that no double holds.
        let code = if degree.len() > 16 { "F014" } else { "K006" };
        shape_fails(&format!(r#""kind": "bspline", "degree": {degree}, "points": [0,1]"#), &[code]);
    }
    for degree in ["-1", "1.5", "36893488147419103232", "three"] {
        run(points, &format!("curve - --kind bspline --degree {degree}")).fails(2, &["--degree", degree]);
    }
    shape_fails(r#""kind": "bspline", "degree": -1, "points": [0,1]"#, &["F017", "/shapes/0/degree"]);
}

#[test]
fn row_19_degrees_from_21_to_100() {
    for degree in [21, 50, 100] {
        let mut points = vec!["0"; degree];
        points.push("1");
        let curve = run(points.join("\n"), "curve - --kind bezier").done();
        let half = half_to(degree);
        assert_eq!(rows(&run(&curve, "eval - --at 1/2").done()), [[0.5, half]]);
        let spline = run(points.join("\n"), &format!("curve - --kind bspline --degree {degree}")).done();
        assert_eq!(rows(&run(&spline, "eval - --at 1/2").done()), [[0.5, half]]);
    }
}

/// 2⁻ⁿ.
fn half_to(n: usize) -> f64 {
    (0..n).fold(1.0, |x, _| x * 0.5)
}

#[test]
fn row_20_binomials_beyond_all_numbers() {
    let line = |n: u32| (0..n).map(|i| format!("{i}\n")).collect::<String>();
    let curve = run(line(1001), "curve - --kind bezier").done();
    let middle = rows(&run(&curve, "eval - --at 1/2").done())[0][1];
    assert!((middle - 500.0).abs() < 1e-9, "{middle}");
    run(line(1031), "curve - --kind bezier").fails(3, &["K006", "1031 points", "above 1000"]);
}

#[test]
fn row_21_one_or_two_knots_too_few_or_too_many() {
    let points = "0,0\n1,1\n2,0\n3,1\n";
    for (knots, count) in [("0,0,0,1,1", "5 "), ("0,0,0,0,1,1,1", "7 "), ("0,0,0,0,0,1,1,1,1", "9 ")] {
        let options = format!("curve - --kind bspline --knots {knots}");
        run(points, &options).fails(3, &["K001", &format!("{count}knots"), "take 8"]);
    }
    run(points, "curve - --kind bspline --knots 0,0,0,1,1,1").fails(3, &["K001", "openNURBS", "Repeat the first"]);
    let short = r#""kind": "bspline", "degree": 1, "points": [0,1,2], "knots": [0,1,2]"#;
    shape_fails(short, &["K001", "3 knots", "two fewer", "/shapes/0/knots"]);
}

#[test]
fn row_22_a_hundred_million_points() {
    let folder = Folder::new();
    let square = folder.file("square.csv", "0,0\n6,0\n6,6\n0,6\n");
    // They are written as they are made: a reader has the first of 4 · 2²⁵ before the last is thought of.
    let mut child = Command::new(env!("CARGO_BIN_EXE_lath"))
        .args(["subdivide", &square, "--scheme", "cubic", "--closed", "--levels", "25"])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let mut head = [0; 8];
    child.stdout.take().unwrap().read_exact(&mut head).unwrap();
    assert_eq!(&head[..4], b"x,y\n");
    let output = child.wait_with_output().unwrap();
    assert_eq!((output.status.code(), output.stderr.len()), (Some(0), 0));
    let curve = folder.file("c.json", document(r#""kind": "bezier", "points": [[0,0],[1,2],[2,0]]"#));
    lath(["eval", &curve, "--count", "100000000", "--budget", "99999999"]).fails(5, &["B001", "100000000 points"]);
}

#[test]
fn row_24_mixed_and_odd_dimensions() {
    points_fail("0,0\n1,1\n2,2,2\n3,3\n", &["standard input:3:5", "P005", "3 numbers"]);
    points_fail("0,0\n1\n2,2\n3,3\n", &["standard input:2", "P005"]);
    points_fail("[[0,0],[1,1,1],[2,2],[3,3]]", &["P005"]);
    points_fail("[[],[],[],[]]", &["P006"]);
    for width in [17, 100] {
        let row = vec!["1"; width].join(",");
        let points = format!("{row}\n{}\n", row.replace('1', "2"));
        lath_from(&points, ["through", "-"]).fails(3, &["P006", &width.to_string()]);
        lath_from(&points, ["curve", "-", "--kind", "bezier"]).fails(3, &["P006", &width.to_string()]);
    }
    let sixteen = format!("{}1\n{}2\n", "1,".repeat(15), "2,".repeat(15));
    assert_eq!(numbers(&shape(&run(sixteen, "through -").done())["points"]).len(), 32);
    shape_fails(r#""kind": "bezier", "points": [[0,0],[1]]"#, &["P005", "/shapes/0/points/1"]);
}

#[test]
fn row_25_a_single_knot() {
    run("1\n", "curve - --kind bspline --degree 0 --knots 0").fails(3, &["K001", "1 knots"]);
    shape_fails(r#""kind": "bspline", "degree": 0, "points": [1], "knots": [0]"#, &["K001"]);
    shape_fails(r#""kind": "bspline", "degree": 2, "closed": true, "points": [1], "knots": [0]"#, &["K001"]);
}
