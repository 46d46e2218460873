//! `lath through`: parameters, ends, closing, slopes, columns.
#![allow(clippy::unwrap_used, clippy::panic)] // a failing unwrap is a failing test

mod tool;

use tool::{Folder, lath, lath_from, numbers, real, rows, shape, table};

const ARCH: &str = "x,y\n0,0\n1,2\n3,2\n4,0\n";

/// The rows that `eval` gives for the curve that `through` makes of the points.
#[track_caller]
fn through_and_eval(points: &str, through: &str, eval: &str) -> Vec<Vec<f64>> {
    let curve = lath_from(points, ["through", "-"].into_iter().chain(through.split_whitespace())).done();
    rows(&lath_from(curve, ["eval", "-"].into_iter().chain(eval.split_whitespace())).done())
}

#[test]
fn an_airfoil_is_passed_at_every_point() {
    let curve = lath(["through", &real("rae2822.dat")]).done();
    let made = shape(&curve);
    assert_eq!((made["kind"].as_str(), numbers(&made["parameters"]).len()), (Some("hermite"), 129));
    let at_breaks = rows(&lath_from(&curve, ["eval", "-", "--at", "breaks"]).done());
    let given = std::fs::read_to_string(real("rae2822.dat")).unwrap();
    let given: Vec<Vec<f64>> =
        given.lines().skip(1).map(|line| line.split_whitespace().map(|x| x.parse().unwrap()).collect()).collect();
    assert_eq!(at_breaks.len(), given.len());
    for (row, point) in at_breaks.iter().zip(&given) {
        assert_eq!(row[1..], point[..]);
    }
}

#[test]
fn parameters_follow_the_rule() {
    let points = "0,0\n3,4\n3,0\n";
    let t =
        |rule: &[&str]| numbers(&shape(&lath_from(points, [&["through", "-"], rule].concat()).done())["parameters"]);
    assert_eq!(t(&["--params", "uniform"]), [0.0, 1.0, 2.0]);
    assert_eq!(t(&["--params", "chord"]), [0.0, 5.0, 9.0]);
    let centripetal = [0.0, 5.0_f64.sqrt(), 5.0_f64.sqrt() + 2.0];
    assert_eq!(t(&["--params", "centripetal"]), centripetal);
    assert_eq!(t(&[]), centripetal);
    assert_eq!(t(&["--params", "chord", "--closed"]), [0.0, 5.0, 9.0, 12.0]);
    // One dimension: uniform unless asked otherwise.
    let line = |rule: &[&str]| {
        numbers(&shape(&lath_from("1\n5\n6\n", [&["through", "-"], rule].concat()).done())["parameters"])
    };
    assert_eq!((line(&[]), line(&["--params", "chord"])), (vec![0.0, 1.0, 2.0], vec![0.0, 4.0, 5.0]));
}

#[test]
fn any_power_of_the_sides_may_be_the_parameter() {
    let points = "0,0\n3,4\n3,0\n";
    let curve = |args: &str| lath_from(points, ["through", "-"].into_iter().chain(args.split(' ')));
    let t = |args: &str| numbers(&shape(&curve(args).done())["parameters"]);
    for (alpha, rule) in [("0", "uniform"), ("1/2", "centripetal"), ("1", "chord")] {
        for kind in ["cubic", "catmull-rom", "catmull-rom --closed"] {
            let by = |params: &str| curve(&format!("--params {params} --kind {kind}")).done();
            assert_eq!(by(&format!("alpha:{alpha}")), by(rule), "{kind}");
        }
    }
    assert_eq!(t("--params alpha:2"), [0.0, 25.0, 41.0]);
    assert_eq!(t("--params alpha:2 --closed --kind catmull-rom"), [0.0, 25.0, 41.0, 50.0]);
    let quarter = t("--params alpha:1/4");
    assert!((quarter[1] - 5.0_f64.sqrt().sqrt()).abs() < 1e-15, "{quarter:?}");
    // Equal neighbours are no matter where sides do not count.
    let twice = "0,0\n1,1\n1,1\n";
    lath_from(twice, ["through", "-", "--params", "alpha:0"]).done();
    lath_from(twice, ["through", "-", "--params", "alpha:0.1"]).fails(3, &["P004", "standard input:3"]);
    lath_from("0\n1e200\n", ["through", "-", "--params", "alpha:2"]).fails(3, &["P003"]);
    for (wrong, words) in
        [("alpha", "missing"), ("alpha:", "not a number"), ("alpha:-1", "from 0"), ("alpha:nan", "finite")]
    {
        curve(&format!("--params {wrong}")).fails(2, &["--params", words]);
    }
}

#[test]
fn derivatives_may_be_given_at_any_point_of_a_bspline() {
    let spline = "--params uniform --kind bspline";
    let slope = format!("{spline} --derivative 1:1:-1,1/2 --derivative 3:1:2,0");
    let answer = through_and_eval(ARCH, &slope, "--at 0,1,2,3 --derivatives 1");
    for (row, point) in answer.iter().zip([[0.0, 0.0], [1.0, 2.0], [3.0, 2.0], [4.0, 0.0]]) {
        assert!((row[1] - point[0]).abs() + (row[2] - point[1]).abs() < 1e-14, "{answer:?}");
    }
    let near = |row: &[f64], slope: [f64; 2]| (row[3] - slope[0]).abs() + (row[4] - slope[1]).abs() < 1e-13;
    assert!(near(&answer[1], [-1.0, 0.5]) && near(&answer[3], [2.0, 0.0]), "{answer:?}");
    let made = shape(&lath_from(ARCH, ["through", "-"].into_iter().chain(slope.split(' '))).done());
    assert_eq!(numbers(&made["points"]).len(), 2 * (4 + 2));
    // With ends of their own, of any degree, orders up to one below it.
    let both = format!("{spline} --degree 4 --ends natural --derivative 2:1:0,0 --derivative 2:3:1,1");
    let answer = through_and_eval(ARCH, &both, "--at 2 --derivatives 3");
    assert!(near(&answer[0], [0.0, 0.0]), "{answer:?}");
    assert!((answer[0][7] - 1.0).abs() + (answer[0][8] - 1.0).abs() < 1e-11, "{answer:?}");
    // At the ends they are what clamped ends are.
    let clamped = lath_from(ARCH, format!("through - {spline} --start clamped:1,2").split(' ')).done();
    assert_eq!(lath_from(ARCH, format!("through - {spline} --derivative 0:1:1,2").split(' ')).done(), clamped);
    let refused = |options: &str, code: i32, words: &[&str]| {
        lath_from(ARCH, format!("through - {options}").split(' ')).fails(code, words);
    };
    refused(&format!("{spline} --derivative 4:1:0,0"), 3, &["C003", "point 4 of 4", "--derivative"]);
    refused(&format!("{spline} --derivative 1:3:0,0"), 3, &["C003", "order 3", "degree 3"]);
    refused(&format!("{spline} --derivative 1:0:0,0"), 3, &["C003", "order 0"]);
    refused(&format!("{spline} --derivative 1:1:0,0 --derivative 1:1:0,0"), 3, &["C003", "order 1 at point 1"]);
    refused(&format!("{spline} --start clamped:1,1 --derivative 0:1:0,0"), 3, &["C003", "point 0"]);
    refused(&format!("{spline} --derivative 1:1:0"), 3, &["P005", "1 number,"]);
    refused(&format!("{spline} --derivative 1:1"), 2, &["INDEX:ORDER:X,Y"]);
    refused(&format!("{spline} --derivative 1:1:up"), 2, &["up", "not a number"]);
    refused(&format!("{spline} --derivative -1:1:0,0"), 2, &["whole number"]);
    refused("--derivative 1:1:0,0", 2, &["--derivative", "bspline"]);
    refused("--kind bspline --closed --derivative 1:1:0,0", 2, &["--derivative", "--closed"]);
    let picture = format!("draw - -o - --through {slope}");
    assert!(lath_from(ARCH, picture.split(' ')).done().contains("</svg>"));
}

#[test]
fn a_column_can_be_the_parameter() {
    let curve = lath(["through", &real("nile_flow.csv"), "--params", "column:year"]).done();
    let (header, answer) = table(&lath_from(&curve, ["eval", "-", "--at", "1871,1970"]).done());
    assert_eq!(header, ["t", "x"]);
    assert_eq!(answer, [[1871.0, 1120.0], [1970.0, 740.0]]);
    // By index, from a file without names; the other columns are coordinates.
    let made = shape(&lath_from("0 5 1\n1 7 2\n2 9 4\n", ["through", "-", "--params", "column:2"]).done());
    assert_eq!(numbers(&made["parameters"]), [1.0, 2.0, 4.0]);
    assert_eq!(numbers(&made["points"]), [0.0, 5.0, 1.0, 7.0, 2.0, 9.0]);
}

#[test]
fn columns_are_chosen_by_name_or_index() {
    let file = "name,x,t,y\n9,0,1,5\n9,1,2,6\n9,2,4,8\n";
    let points = |args: &[&str]| numbers(&shape(&lath_from(file, [&["through", "-"], args].concat()).done())["points"]);
    assert_eq!(points(&["--columns", "x,y"]), [0.0, 5.0, 1.0, 6.0, 2.0, 8.0]);
    assert_eq!(points(&["--columns", "3,1"]), [5.0, 0.0, 6.0, 1.0, 8.0, 2.0]);
    assert_eq!(points(&["--columns", "t,x,y", "--params", "column:t"]), [0.0, 5.0, 1.0, 6.0, 2.0, 8.0]);
    assert_eq!(points(&["--columns", "y", "--params", "column:t"]), [5.0, 6.0, 8.0]);
    lath_from(file, ["through", "-", "--columns", "x,z"]).fails(3, &["F009", "\"z\"", "\"name\""]);
    lath_from(file, ["through", "-", "--params", "column:w"]).fails(3, &["F009", "\"w\""]);
    lath_from("t\n1\n2\n", ["through", "-", "--params", "column:t"]).fails(3, &["F009", "coordinates"]);
    lath_from("a,a\n1,2\n2,3\n", ["through", "-", "--columns", "a"]).fails(3, &["F022"]);
}

#[test]
fn columns_beside_the_chosen_ones_may_hold_words() {
    let log = "day,t,x,y\n2020-01-01,0,1,5\n2020-01-02,1,2,6\n2020-01-04,3,4,8\n";
    let chosen = ["--columns", "x,y", "--params", "column:t"];
    let made = shape(&lath_from(log, ["through", "-"].into_iter().chain(chosen)).done());
    assert_eq!(numbers(&made["points"]), [1.0, 5.0, 2.0, 6.0, 4.0, 8.0]);
    assert_eq!(numbers(&made["parameters"]), [0.0, 1.0, 3.0]);
    lath_from(log, ["draw", "-", "-o", "-", "--through"].into_iter().chain(chosen)).done();
    lath_from(log, ["draw", "-", "-o", "-", "--columns", "x,y"]).done();
    lath_from(log, ["curve", "-", "--kind", "bezier", "--columns", "x,y"]).done();
    let level = lath_from(log, ["subdivide", "-", "--scheme", "chaikin", "--levels", "1", "--columns", "y,x"]).done();
    assert_eq!(rows(&level)[0], [5.25, 1.25]);
    lath_from(log, ["through", "-"]).fails(3, &["standard input:2:1", "F00"]);
    lath_from(log, ["through", "-", "--columns", "x,day"]).fails(3, &["standard input:2:1"]);
    // Shapes have no columns: beside points they are drawn as they are.
    let curve = lath_from(ARCH, ["through", "-"]).done();
    lath_from(curve, ["draw", "-", "-o", "-", "--columns", "x,y"]).done();
}

#[test]
fn every_end_condition_holds() {
    let ends = |options: &str| {
        let answer = through_and_eval(ARCH, &format!("--params uniform {options}"), "--at 0,3 --derivatives 3");
        let third = through_and_eval(ARCH, &format!("--params uniform {options}"), "--at 0.5,1.5,2.5 --derivatives 3");
        (answer[0].clone(), answer[1].clone(), third)
    };
    let close = |a: &[f64], b: &[f64]| a.iter().zip(b).all(|(a, b)| (a - b).abs() <= 1e-14 * b.abs().max(1.0));
    // Columns: t, x, y, x_1, y_1, x_2, y_2, x_3, y_3.
    let (first, last, _) = ends("--ends natural");
    assert!(close(&first[5..7], &[0.0, 0.0]) && close(&last[5..7], &[0.0, 0.0]));
    let (first, last, _) = ends("--start clamped:-1,1/2 --end second:0,-3");
    assert!(close(&first[3..5], &[-1.0, 0.5]) && close(&last[5..7], &[0.0, -3.0]));
    let (first, last, _) = ends("--ends second:1,2");
    assert!(close(&first[5..7], &[1.0, 2.0]) && close(&last[5..7], &[1.0, 2.0]));
    let (_, _, third) = ends("");
    assert!(close(&third[0][7..9], &third[1][7..9]) && close(&third[1][7..9], &third[2][7..9]));
    let (_, _, third) = ends("--start not-a-knot --end natural");
    assert!(close(&third[0][7..9], &third[1][7..9]));
    let (first, last, _) = ends("--ends cyclic");
    assert!(close(&first[3..7], &last[3..7]));
    let (first, last, _) = ends("--ends anticyclic");
    let mirrored: Vec<f64> = last[3..7].iter().map(|x| -x).collect();
    assert!(close(&first[3..7], &mirrored));
}

#[test]
fn few_points_give_line_and_parabola() {
    let line = through_and_eval("0,0\n2,1\n", "--params uniform", "--at 0.5 --derivatives 2");
    assert_eq!(line[0][..5], [0.5, 1.0, 0.5, 2.0, 1.0]);
    assert!(line[0][5..].iter().all(|x| x.abs() < 1e-14), "{line:?}");
    let parabola = through_and_eval("0\n1\n4\n", "", "--at 0.5,1.5 --derivatives 1");
    let exact = [[0.5, 0.25, 1.0], [1.5, 2.25, 3.0]];
    assert!(parabola.iter().flatten().zip(exact.iter().flatten()).all(|(a, b)| (a - b).abs() < 1e-14), "{parabola:?}");
}

#[test]
fn closed_curves_take_a_repeated_closing_point() {
    let square = "1,0\n0,1\n-1,0\n0,-1\n";
    let open = lath_from(square, ["through", "-", "--closed"]).done();
    let repeated = lath_from(format!("{square}1,0\n"), ["through", "-", "--closed"]).done();
    assert_eq!(open, repeated);
    let made = shape(&open);
    assert_eq!((made["closed"].as_bool(), numbers(&made["points"]).len()), (Some(true), 8));
    // Smooth over the seam: both ends of the domain have the same derivatives.
    let ends = rows(&lath_from(&open, ["eval", "-", "--count", "2", "--derivatives", "2"]).done());
    assert!(ends[0][1..].iter().zip(&ends[1][1..]).all(|(a, b)| (a - b).abs() < 1e-14), "{ends:?}");
    let iceland = shape(&lath(["through", &real("iceland.csv"), "--closed"]).done());
    assert_eq!(numbers(&iceland["parameters"]).len(), numbers(&iceland["points"]).len() / 2 + 1);
}

#[test]
fn closed_over_given_parameters() {
    let curve = |points: &str, args: &[&str]| {
        lath_from(points, [&["through", "-", "--closed", "--params", "column:t"], args].concat())
    };
    let repeated = curve("t,x\n0,1\n1,5\n3,2\n4,1\n", &[]).done();
    assert_eq!(numbers(&shape(&repeated)["parameters"]), [0.0, 1.0, 3.0, 4.0]);
    assert_eq!(curve("t,x\n0,1\n1,5\n3,2\n", &["--period", "4"]).done(), repeated);
    assert_eq!(curve("t,x\n0,1\n1,5\n3,2\n4,1\n", &["--period", "8/2"]).done(), repeated);
    curve("t,x\n0,1\n1,5\n3,2\n", &[]).fails(3, &["T004", "--period"]);
    curve("t,x\n0,1\n1,5\n3,2\n", &["--period", "3"]).fails(3, &["T003", "longer period"]);
    curve("t,x\n0,1\n1,5\n3,2\n4,1\n", &["--period", "5"]).fails(3, &["T004", "closing point"]);
    lath_from(ARCH, ["through", "-", "--period", "4"]).fails(2, &["--closed"]);
    lath(["through", "absent.csv", "--closed", "--period", "4"]).fails(2, &["--params column:NAME"]);
    let args = ["through", "-", "--closed", "--period", "4", "--params", "uniform"];
    lath_from(ARCH, args).fails(2, &["--params column:NAME"]);
    curve("t,x\n0,1\n1,5\n", &["--period", "-1"]).fails(2, &["above 0"]);
}

#[test]
fn given_slopes_are_kept() {
    let file = "t,x,y,dx,dy\n0,0,0,1,2\n2,1,1,-1,1/2\n";
    lath_from(file, ["through", "-"]).fails(3, &["standard input:3:10", "F005"]); // fractions are for the command line
    let file = "t,x,y,dx,dy\n0,0,0,1,2\n2,1,1,-1,0.5\n";
    let made = shape(&lath_from(file, ["through", "-", "--params", "column:t", "--tangents", "dx,dy"]).done());
    assert_eq!(numbers(&made["parameters"]), [0.0, 2.0]);
    assert_eq!(numbers(&made["points"]), [0.0, 0.0, 1.0, 1.0]);
    assert_eq!(numbers(&made["tangents"]), [1.0, 2.0, -1.0, 0.5]);
    lath_from(file, ["through", "-", "--tangents", "dx"]).fails(3, &["P005", "slopes"]);
    let closed = "0 0 1 1\n1 0 1 1\n0 0 1 1\n";
    let args = ["through", "-", "--closed", "--tangents", "2,3"];
    assert_eq!(numbers(&shape(&lath_from(closed, args).done())["tangents"]), [1.0, 1.0, 1.0, 1.0]);
    lath_from("0 0 1 1\n1 0 1 1\n0 0 1 2\n", args).fails(3, &["C001", "another slope", "standard input:3"]);
}

#[test]
fn conflicting_options_are_a_wrong_command_line() {
    for (args, words) in [
        ("--closed --start natural", ["--closed", "--start"]),
        ("--closed --ends natural", ["--closed", "--ends"]),
        ("--ends natural --start natural", ["--ends", "--start"]),
        ("--ends natural --end natural", ["--ends", "--end"]),
        ("--tangents 0,1 --ends natural", ["--tangents", "--ends"]),
        ("--tangents 0,1 --start natural", ["--tangents", "--start"]),
        ("--kind bezier", ["bezier", "pchip"]),
        ("--kind phcip", ["phcip", "'pchip'"]),
        ("--kind cubic,pchip", ["several kinds", "lath draw --through"]),
        ("--kind cubic,", ["kind", "missing"]),
        ("--kind cardinal:soft", ["soft", "not a number"]),
        ("--kind steffen:1", ["steffen", "no number"]),
        ("--kind kochanek-bartels:1,2", ["kochanek-bartels", "three numbers"]),
        ("--kind kochanek-bartels:a,b,c", ["kochanek-bartels", "not a number"]),
        ("--kind cubic --tangents 0,1", ["--kind", "--tangents"]),
        ("--degree 3", ["--degree", "--kind bspline"]),
        ("--kind pchip --degree 3", ["--degree", "--kind bspline"]),
        ("--kind bspline --degree 2.5", ["2.5", "whole number"]),
        ("--kind bspline --degree -1", ["-1", "whole number"]),
        ("--kind akima --ends natural", ["akima", "cubic and bspline"]),
        ("--kind catmull-rom --start natural", ["catmull-rom", "cubic and bspline"]),
        ("--kind bspline --ends cyclic", ["cyclic", "--closed"]),
        ("--kind bspline --degree 5 --ends clamped:0,1", ["clamped", "degree 5 takes 2"]),
        ("--kind bspline --degree 1 --end clamped:0,1", ["clamped", "degree 1 takes 0"]),
        ("--kind bspline --degree 2 --start second:0,1", ["second", "degree 2"]),
        ("--params speed", ["speed", "centripetal"]),
        ("--params column:", ["column:", "centripetal"]),
        ("--ends free", ["free", "anticyclic"]),
        ("--start cyclic", ["cyclic", "not-a-knot"]),
        ("--start clamped:1,", ["clamped:1,", "empty"]),
        ("--start clamped:one", ["one", "not a number"]),
        ("--start clamped:nan,0", ["nan", "finite"]),
        ("--columns x,,y", ["column 1", "name"]),
    ] {
        lath_from(ARCH, ["through", "-"].into_iter().chain(args.split(' '))).fails(2, &words);
    }
    // But a vector of another dimension is a matter of the data.
    lath_from(ARCH, ["through", "-", "--start", "clamped:1"]).fails(3, &["P005", "clamped", "2 coordinates"]);
    lath_from(ARCH, ["through", "-", "--ends", "second:1,2,3"]).fails(3, &["P005", "second", "3 numbers"]);
}

const KINDS: [&str; 9] =
    ["cubic", "bspline", "bspline --degree 2", "catmull-rom", "cardinal:1/2", "pchip", "akima", "makima", "steffen"];

#[test]
fn every_kind_passes_every_point() {
    for kind in KINDS {
        let open = format!("--params uniform --kind {kind}");
        let answer = through_and_eval(ARCH, &open, "--at 0,1,2,3");
        let given = [[0.0, 0.0], [1.0, 2.0], [3.0, 2.0], [4.0, 0.0]];
        for (row, point) in answer.iter().zip(given) {
            assert!((row[1] - point[0]).abs() + (row[2] - point[1]).abs() < 1e-14, "{kind}: {answer:?}");
        }
        let closed = through_and_eval(ARCH, &format!("{open} --closed"), "--at 0,1,2,3,4 --derivatives 1");
        for (row, point) in closed.iter().zip(given.iter().cycle()) {
            assert!((row[1] - point[0]).abs() + (row[2] - point[1]).abs() < 1e-14, "{kind}: {closed:?}");
        }
        assert!(closed[0][1..].iter().zip(&closed[4][1..]).all(|(a, b)| (a - b).abs() < 1e-14), "{kind}: {closed:?}");
    }
}

#[test]
fn few_and_equal_points_for_every_kind() {
    let repeated = "1,1\n1,1\n1,1\n1,1\n1,1\n";
    for kind in KINDS {
        let args: Vec<&str> = ["through", "-", "--kind"].into_iter().chain(kind.split(' ')).collect();
        let with = |more: &[&'static str]| args.iter().copied().chain(more.iter().copied()).collect::<Vec<_>>();
        for more in [&[][..], &["--closed"]] {
            lath_from("", with(more)).fails(3, &["F001"]);
            lath_from("1,1\n", with(more)).fails(3, &["P001"]);
            lath_from(repeated, with(more)).fails(3, &["P004", "standard input:2"]);
        }
        let still = lath_from(repeated, with(&["--params", "uniform"])).done();
        let answer = rows(&lath_from(still, ["eval", "-", "--count", "9", "--derivatives", "1"]).done());
        assert!(answer.iter().all(|row| row[1..].iter().zip([1.0, 1.0, 0.0, 0.0]).all(|(a, b)| (a - b).abs() < 1e-14)));
        let line = lath_from("0,0\n1,2\n", with(&[]));
        match kind {
            "bspline" | "bspline --degree 2" => line.fails(3, &["P001", "2 points for degree"]),
            _ => {
                assert!((rows(&lath_from(line.done(), ["eval", "-", "--count", "3"]).done())[1][2] - 1.0).abs() < 1e-14)
            }
        }
    }
    lath_from(ARCH, ["through", "-", "--kind", "bspline", "--degree", "31"]).fails(3, &["K006", "31"]);
}

#[test]
fn bsplines_of_any_degree() {
    let made = shape(&lath_from(ARCH, ["through", "-", "--kind", "bspline", "--params", "uniform"]).done());
    assert_eq!((made["kind"].as_str(), made["degree"].as_u64()), (Some("bspline"), Some(3)));
    assert_eq!(numbers(&made["knots"]), [0.0, 0.0, 0.0, 0.0, 3.0, 3.0, 3.0, 3.0]);
    let ends = |options: &str| {
        through_and_eval(ARCH, &format!("--params uniform --kind bspline {options}"), "--at 0,3 --derivatives 2")
    };
    let close = |a: &[f64], b: [f64; 2]| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-13);
    let natural = ends("--ends natural");
    assert!(close(&natural[0][5..7], [0.0, 0.0]) && close(&natural[1][5..7], [0.0, 0.0]), "{natural:?}");
    let given = ends("--start clamped:1,5 --end second:-1,1/2");
    assert!(close(&given[0][3..5], [1.0, 5.0]) && close(&given[1][5..7], [-1.0, 0.5]), "{given:?}");
    let square = ends("--degree 2 --start clamped:1,5 --end not-a-knot");
    assert!(close(&square[0][3..5], [1.0, 5.0]), "{square:?}");
    // The cubic B-spline is the cubic spline.
    for both in ["natural", "not-a-knot", "clamped:1,-1", "second:2,3"] {
        let cubic = through_and_eval(ARCH, &format!("--params uniform --ends {both}"), "--count 10 --derivatives 2");
        let options = format!("--params uniform --kind bspline --ends {both}");
        let spline = through_and_eval(ARCH, &options, "--count 10 --derivatives 2");
        assert!(cubic.iter().flatten().zip(spline.iter().flatten()).all(|(a, b)| (a - b).abs() < 1e-12), "{both}");
    }
}

#[test]
fn tension_goes_from_the_curve_to_the_polygon() {
    let middle = |kind: &str| through_and_eval(ARCH, &format!("--params uniform --kind {kind}"), "--at 3/2")[0].clone();
    assert_eq!(middle("cardinal"), middle("catmull-rom"));
    assert_eq!(middle("cardinal:0"), [1.5, 2.0, 2.25]);
    assert_eq!(middle("cardinal:1/2"), [1.5, 2.0, 2.125]);
    assert_eq!(middle("cardinal:1"), [1.5, 2.0, 2.0]);
    assert_eq!(middle("kochanek-bartels"), middle("catmull-rom"));
    assert_eq!(middle("kochanek-bartels:1/2,0,0"), middle("cardinal:1/2"));
    assert_eq!(middle("kochanek-bartels:0,-1,0"), [1.5, 2.0, 2.0]); // inner tangents along the chords: the polygon
}

#[test]
fn any_points_format_and_dimension() {
    let json = lath_from("[[0,0],[1,2],[3,2],[4,0]]", ["through", "-"]).done();
    assert_eq!(json, lath_from(ARCH, ["through", "-"]).done());
    assert_eq!(json, lath_from(ARCH.replace(',', "\t"), ["through", "-", "--from", "tsv"]).done());
    let five: String = (0..4).map(|i| format!("{i} 0 {} 1 {}\n", i * i, -i)).collect();
    let (header, answer) =
        table(&lath_from(lath_from(five, ["through", "-"]).done(), ["eval", "-", "--count", "2"]).done());
    assert_eq!(header, ["t", "x0", "x1", "x2", "x3", "x4"]);
    assert_eq!(answer[1][1..], [3.0, 0.0, 9.0, 1.0, -3.0]);
    let wide = format!("{}0\n{}1\n", "0 ".repeat(16), "1 ".repeat(16));
    lath_from(wide, ["through", "-"]).fails(3, &["P006", "17"]);
    let folder = Folder::new();
    let path = folder.path("curve.json");
    assert_eq!(lath_from(ARCH, ["through", "-", "-o", &path]).done(), "");
    assert_eq!(std::fs::read_to_string(path).unwrap(), json);
    lath_from(ARCH, ["through", "-", "-o", &folder.path("curve.csv")]).fails(2, &[".csv", ".json"]);
    assert_eq!(folder.names(), ["curve.json"]);
}
