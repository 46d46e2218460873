//! Rows 1 to 12: numbers.

use crate::tool::{Folder, lath, lath_from, numbers, repository, rows, shape};
use crate::{document, eval, points_fail, run, shape_fails, warned};

#[test]
fn row_01_nan_coordinate() {
    for nan in ["nan", "NaN", "-nan", "NAN"] {
        points_fail(&format!("0,0\n1,1\n2,{nan}\n3,0\n"), &["standard input:3:3", "P002", nan]);
    }
    points_fail("[[0,0],[1,NaN]]", &["standard input:1:11", "P002"]);
    lath(["through", &repository("testdata/npy/nan.npy")]).fails(3, &["nan.npy", "P002", "row 0"]);
}

#[test]
fn row_02_infinite_coordinate() {
    for infinite in ["inf", "-Infinity", "Inf"] {
        points_fail(&format!("0,0\n{infinite},1\n2,0\n3,0\n"), &["standard input:2:1", "P002", infinite]);
    }
    shape_fails(r#""kind": "bezier", "points": [[0,0],[Infinity,1]]"#, &["standard input:1:61", "P002"]);
}

#[test]
fn row_03_parameter_that_is_no_number() {
    let line = document(r#""kind": "bezier", "points": [[0,0],[1,1]]"#);
    for t in ["nan", "inf", "-inf", "0,nan"] {
        run(&line, &format!("eval - --at {t}")).fails(2, &["--at", "not a finite number"]);
    }
    let folder = Folder::new();
    let sites = folder.file("t.csv", "t\n0\nnan\n");
    lath_from(&line, ["eval", "-", "--at-file", &sites]).fails(3, &["t.csv:3:1", "P002", "nan"]);
}

#[test]
fn row_04_knot_that_is_no_number() {
    let points = "0,0\n1,2\n3,2\n4,0\n";
    run(points, "curve - --kind bspline --knots 0,0,0,nan,1,1,1,1").fails(3, &["K002", "knot 3", "NaN", "index 3"]);
    run(points, "curve - --kind bspline --knots 0,0,0,0,1,1,1,-inf").fails(3, &["K002", "knot 7"]);
    shape_fails(r#""kind": "bspline", "degree": 1, "points": [0,1], "knots": [0,0,NaN,1]"#, &["P002", "NaN"]);
    shape_fails(r#""kind": "hermite", "parameters": [0,Infinity], "points": [0,1], "tangents": [0,0]"#, &["P002"]);
}

#[test]
fn row_05_negative_zero_is_zero() {
    let curve = run("1\n2\n4\n", "curve - --kind bspline --degree 2 --knots 0,-0,0,1,1,1").done();
    assert_eq!(rows(&run(&curve, "eval - --at -0,0,1/2").done()), [[0.0, 1.0], [0.0, 1.0], [0.5, 2.25]]);
    run("t,x\n-0,1\n0,2\n", "through - --params column:t").fails(3, &["T003", "standard input:3"]);
}

#[test]
fn row_06_subnormal_numbers() {
    let middle = eval(r#""kind": "bezier", "points": [1e-323, 2e-323, 3e-323]"#, "--at 1/2");
    assert_eq!(middle, [[0.5, 2e-323]]);
    let curve = run("0,0\n3e-320,4e-320\n", "through - --params chord").done();
    assert_eq!(numbers(&shape(&curve)["parameters"]), [0.0, 5e-320]);
    // The slope between two such knots is beyond all numbers.
    let steep = document(r#""kind": "bspline", "degree": 1, "points": [0,8], "knots": [0,0,4e-323,4e-323]"#);
    assert_eq!(rows(&run(&steep, "eval - --at 2e-323").done()), [[2e-323, 4.0]]);
    run(&steep, "eval - --at 0 --derivatives 1").fails(3, &["P003", "derivative of order 1"]);
}

#[test]
fn row_07_squares_that_overflow_or_underflow() {
    for scale in ["e-300", "e-150", "e150", "e290"] {
        let points = format!("0,0\n3{scale},4{scale}\n3{scale},0\n");
        let curve = run(&points, "through - --params chord --closed").done();
        let parameters = numbers(&shape(&curve)["parameters"]);
        let exact = [5.0, 9.0, 12.0].map(|t: f64| format!("{t}{scale}").parse::<f64>().unwrap());
        let same = parameters[1..].iter().zip(exact).all(|(t, exact)| (t / exact - 1.0).abs() < 1e-15);
        assert!(parameters[0] == 0.0 && same, "{parameters:?}");
        let picture = run(&curve, "draw - --comb --axes -o - --format svg").done();
        assert!(picture.starts_with("<svg") && !picture.contains("NaN") && !picture.contains("inf"), "{picture}");
    }
}

#[test]
fn row_08_coordinates_whose_differences_overflow() {
    for huge in ["1.7976931348623157e308", "-1e301"] {
        let points = format!("0,0\n{huge},1\n2,0\n3,1\n");
        for verb in ["through -", "through - --params uniform", "curve - --kind bezier", "curve - --kind bspline"] {
            run(&points, verb).fails(3, &["standard input:2", "P003"]);
        }
        shape_fails(&format!(r#""kind": "polyline", "points": [[0,0],[{huge},0]]"#), &["P003", "/shapes/0/points/1"]);
    }
}

#[test]
fn row_09_small_detail_far_from_zero() {
    let far = |k: i32| 1e7 + f64::from(k * k) / 1024.0;
    let points: String = (0..5).map(|k| format!("{}\n", far(k))).collect();
    let curve = run(points, "through - --params uniform").done();
    let answer = rows(&run(&curve, "eval - --at 3/2 --derivatives 2").done());
    let exact = [1.5, 1e7 + 2.25 / 1024.0, 3.0 / 1024.0, 2.0 / 1024.0];
    assert!((answer[0][1] - exact[1]).abs() <= 4e-9, "{answer:?}");
    assert!(answer[0][2..].iter().zip(&exact[2..]).all(|(a, b)| (a - b).abs() < 1e-15), "{answer:?}");
    assert_eq!(warned("10000000.001,0\n10000000.002,1\n"), ["W015"]);
    assert_eq!(warned("100.001,0\n100.002,1\n"), [""; 0]);
}

#[test]
fn row_10_integers_that_no_double_holds() {
    points_fail("[[0,0],[1,9007199254740993]]", &["standard input:1", "F014", "9007199254740993"]);
    shape_fails(r#""kind": "bezier", "points": [0, 9007199254740993]"#, &["F014", "9007199254740993"]);
    run("[[0,0],[1,9.007199254740993e15]]", "through -").done();
}

#[test]
fn row_11_single_precision_is_widened_and_nothing_else() {
    let curve = lath(["through", &repository("testdata/npy/float32.npy"), "--params", "uniform"]).done();
    // What −0 and 1/3 are in single precision, with all digits of the double.
    assert_eq!(numbers(&shape(&curve)["points"]), [0.0, f64::from(1.0_f32 / 3.0)]);
}

#[test]
fn row_12_other_notations() {
    points_fail("0;0\n1,5;2\n2;0\n3;0\n", &["standard input:2:1", "F006", "decimal comma"]);
    points_fail("0 0\n0x1p3 1\n2 0\n3 1\n", &["standard input:2:1", "F006", "hexadecimal"]);
    points_fail("0,0\n1,1e400\n2,0\n3,1\n", &["standard input:2:3", "P003", "1e400"]);
    points_fail("0,0\n1,1_000\n2,0\n3,1\n", &["standard input:2:3", "F006"]);
    let plus = run("+0,0\n+1.5,+1e1\n", "through - --params uniform").done();
    assert_eq!(numbers(&shape(&plus)["points"]), [0.0, 0.0, 1.5, 10.0]);
}
