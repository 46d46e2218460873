//! Rows 38 to 43: points that coincide, data out of order, curves that halt and turn back.

use crate::tool::rows;
use crate::{document, eval, run, warned};

const SAME: &str = "3,4\n3,4\n3,4\n3,4\n";

#[track_caller]
fn drawn(members: &str) {
    let picture = run(document(members), "draw - --comb --axes --polygon -o - --format svg").done();
    assert!(picture.starts_with("<svg") && !picture.contains("NaN") && !picture.contains("inf"), "{picture}");
}

#[test]
fn row_38_neighbours_that_coincide() {
    for options in ["", " --params chord", " --params centripetal", " --kind akima", " --closed"] {
        run("0,0\n1,1\n1,1\n2,0\n", &format!("through -{options}"))
            .fails(3, &["standard input:3", "P004", "points 1 and 2", "index 2"]);
    }
    run("0,0\n1e10,0\n1e10,1e-7\n", "through - --params chord").fails(3, &["standard input:3", "P004", "too close"]);
    run("0,0\n1,1\n1,1\n2,0\n", "through - --params uniform").done();
}

#[test]
fn row_39_all_points_identical() {
    run(SAME, "through -").fails(3, &["standard input:2", "P004"]);
    for verb in ["through - --params uniform", "curve - --kind bezier", "curve - --kind bspline"] {
        let curve = run(SAME, verb).done();
        for row in rows(&run(&curve, "eval - --count 7 --derivatives 2").done()) {
            assert!(row[1..].iter().zip([3.0, 4.0, 0.0, 0.0]).all(|(x, exact)| (x - exact).abs() < 1e-14), "{row:?}");
        }
        assert!(run(&curve, "info -").done().contains("box"));
        assert!(!run(&curve, "draw - --comb -o - --format svg").done().contains("NaN"));
    }
}

#[test]
fn row_40_two_values_at_one_parameter() {
    for kind in ["cubic", "pchip", "akima", "makima", "steffen", "catmull-rom", "bspline"] {
        run("t,x\n0,1\n1,2\n1,3\n2,4\n3,5\n", &format!("through - --params column:t --kind {kind}"))
            .fails(3, &["standard input:4", "T003", "index 2"]);
    }
}

#[test]
fn row_41_parameters_out_of_order() {
    for kind in ["cubic", "pchip", "akima", "steffen", "bspline"] {
        run("t,x\n0,1\n2,2\n1,3\n3,4\n4,5\n", &format!("through - --params column:t --kind {kind}"))
            .fails(3, &["standard input:4", "T003", "Sort the rows"]);
    }
}

#[test]
fn row_42_control_points_that_coincide_at_an_end() {
    let curve = |points: &str| format!(r#""kind": "bezier", "points": [{points}]"#);
    let two = curve("[0,0],[0,0],[1,1],[1,1]");
    assert_eq!(eval(&two, "--at 0,1/2 --derivatives 1"), [[0.0, 0.0, 0.0, 0.0, 0.0], [0.5, 0.5, 0.5, 1.5, 1.5]]);
    let three = curve("[0,0],[0,0],[0,0],[1,1]");
    assert_eq!(eval(&three, "--at 1/2"), [[0.5, 0.125, 0.125]]);
    for members in [&two, &three] {
        drawn(members);
    }
    assert_eq!(warned(document(&two)), ["W010", "W010", "W005", "W005"]);
    assert_eq!(warned(document(&three)), ["W010", "W005", "W005"]);
}

#[test]
fn row_43_cusps_and_curves_that_double_back() {
    let cusp = r#""kind": "bezier", "points": [[0,0],[1,1],[0,1],[1,0]]"#;
    assert_eq!(eval(cusp, "--at 1/2 --derivatives 1"), [[0.5, 0.5, 0.75, 0.0, 0.0]]);
    let back = r#""kind": "bezier", "points": [[0,0],[1,0],[0,0]]"#;
    assert_eq!(eval(back, "--at 1/2,1 --derivatives 1"), [[0.5, 0.5, 0.0, 0.0, 0.0], [1.0, 0.0, 0.0, -2.0, 0.0]]);
    assert_eq!((warned(document(cusp)), warned(document(back))), (vec!["W011".to_owned()], vec!["W011".to_owned()]));
    for members in [cusp, back, r#""kind": "bezier", "points": [[0,0],[1,2],[2,4],[3,6]]"#] {
        drawn(members);
    }
}
