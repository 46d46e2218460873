//! `lath subdivide`: levels, the jump, the limit, spheres, and what is refused.
#![allow(clippy::unwrap_used, clippy::panic)] // a failing unwrap is a failing test

mod tool;

use tool::{Folder, lath, lath_from, rows, table};

/// One group of four.
const GROUP: &str = "x,y\n0,0\n0,8\n8,8\n8,0\n";
/// Its points far apart, so that every digit counts.
const WILD: &str = "1,-3\n7,11\n-2,5\n13,0.3\n4,-9\n";

/// The rows that `subdivide` gives.
#[track_caller]
fn points(input: &str, options: &str) -> Vec<Vec<f64>> {
    rows(&run(input, options).done())
}

fn run(input: &str, options: &str) -> tool::Run {
    lath_from(input, ["subdivide", "-"].into_iter().chain(options.split_whitespace()))
}

/// Whether two points agree but for the last bits of the larger coordinates.
#[track_caller]
fn agree(a: &[f64], b: &[f64], size: f64) {
    assert_eq!(a.len(), b.len());
    assert!(a.iter().zip(b).all(|(a, b)| (a - b).abs() <= 4.0 * f64::EPSILON * size), "{a:?} {b:?}");
}

#[test]
fn every_scheme_makes_its_points() {
    let cubic = vec![vec![0.0, 4.0], vec![1.0, 7.0], vec![4.0, 8.0], vec![7.0, 7.0], vec![8.0, 4.0]];
    assert_eq!(points(GROUP, "--scheme cubic --levels 1"), cubic);
    assert_eq!(points(GROUP, "--scheme degree:3 --levels 1"), cubic);
    assert_eq!(points(GROUP, "--scheme mask:1/8,1/2,3/4,1/2,1/8 --levels 1"), cubic);
    let corners = points(GROUP, "--scheme chaikin --levels 1");
    assert_eq!(corners, [[0.0, 2.0], [0.0, 6.0], [2.0, 8.0], [6.0, 8.0], [8.0, 6.0], [8.0, 2.0]]);
    let passing = points(GROUP, "--scheme four-point --closed --levels 1");
    for given in [[0.0, 0.0], [0.0, 8.0], [8.0, 8.0], [8.0, 0.0]] {
        assert!(passing.iter().any(|row| row[..] == given));
    }
    let flat = points(GROUP, "--scheme four-point:0 --closed --levels 1");
    assert!(flat.iter().any(|row| row[..] == [0.0, 4.0]) && flat.len() == 8);
}

#[test]
fn counts_are_those_of_the_contract() {
    let line = |n: usize| (0..n).map(|i| format!("{i},{}\n", i * i % 7)).collect::<String>();
    for (p, scheme) in [(1, "degree:1"), (2, "chaikin"), (3, "cubic"), (5, "degree:5"), (5, "four-point")] {
        for n in [p, p + 1, 9] {
            for k in 0..4u32 {
                let count =
                    |options: &str| points(&line(n), &format!("--scheme {scheme} --levels {k} {options}")).len();
                let (two, n) = (2usize.pow(k), n);
                assert_eq!(count(""), two * (n - p) + p, "{scheme} {n} {k}");
                assert_eq!(count("--limit"), two * (n - p) + 1, "{scheme} {n} {k}");
                assert_eq!((count("--closed"), count("--closed --limit")), (n * two, n * two), "{scheme} {n} {k}");
            }
        }
    }
    assert_eq!([1, 2, 3, 4].map(|k| points(GROUP, &format!("--scheme cubic --levels {k}")).len()), [5, 7, 11, 19]);
}

#[test]
fn the_header_and_the_formats() {
    assert_eq!(table(&run(GROUP, "--scheme cubic --levels 0").done()).0, ["x", "y"]);
    let five = "1 2 3 4 5\n2 3 4 5 6\n3 4 5 6 9\n";
    assert_eq!(table(&run(five, "--scheme chaikin --levels 1").done()).0, ["x0", "x1", "x2", "x3", "x4"]);
    assert_eq!(table(&run("1\n2\n4\n", "--scheme chaikin --levels 1").done()).0, ["x"]);
    assert_eq!(points("a,b,c\n1,9,2\n3,9,4\n", "--scheme degree:1 --levels 1 --columns a,c")[1], [2.0, 3.0]);
    let json: serde_json::Value = serde_json::from_str(&run(GROUP, "--scheme cubic --levels 1 --json").done()).unwrap();
    assert_eq!((&json["columns"], &json["rows"][1]), (&serde_json::json!(["x", "y"]), &serde_json::json!([1, 7])));
    let folder = Folder::new();
    let path = folder.path("level.npy");
    assert_eq!(run(GROUP, &format!("--scheme cubic --levels 6 -o {path}")).done(), "");
    let read = lath(["info", &path, "--json"]).done();
    assert!(read.contains("\"rows\":67"), "{read}");
    run(GROUP, &format!("--scheme cubic --levels 6 -o {}", folder.path("level.svg"))).fails(2, &[".svg", "--format"]);
    run(GROUP, "--scheme cubic --levels 6 --format scipy").fails(2, &["scipy"]);
}

#[test]
fn one_point_of_a_high_level_is_the_bspline() {
    let spline = lath_from(WILD, ["curve", "-", "--kind", "bspline", "--knots", "uniform"]).done();
    let curve = |t: &str| rows(&lath_from(&spline, ["eval", "-", "--at", t]).done())[0][1..].to_vec();
    // At level 60 the points of the level and of the curve differ by 2⁻¹²⁰: point i stands at t = (i − 1)/2⁶⁰.
    let jump = &points(WILD, "--scheme cubic --only 60:123456789")[0];
    agree(jump, &curve("123456788/1152921504606846976"), 13.0);
    let on_curve = &points(WILD, "--scheme cubic --limit --only 60:123456789")[0];
    agree(on_curve, &curve("123456789/1152921504606846976"), 13.0);
    // An index of 300 digits. Its decimal text reads as the nearest float, which is halved without rounding.
    for digits in ["123456789", "987654321012345678"] {
        let index: String = digits.chars().cycle().take(300).collect();
        let t = (0..1000).fold(index.parse::<f64>().unwrap(), |t, _| t * 0.5);
        assert!(t > 0.0 && t < 1.0);
        let expected = curve(&format!("{t:e}"));
        agree(&points(WILD, &format!("--scheme cubic --only 1000:{index}"))[0], &expected, 13.0);
        agree(&points(WILD, &format!("--scheme cubic --limit --only 1000:{index}"))[0], &expected, 13.0);
    }
    // The same in a whole level.
    let level = points(WILD, "--scheme cubic --levels 7");
    let limit = points(WILD, "--scheme cubic --levels 7 --limit");
    for i in [0, 1, 77, 256] {
        assert_eq!(points(WILD, &format!("--scheme cubic --only 7:{i}"))[0], level[i]);
        assert_eq!(points(WILD, &format!("--scheme cubic --only 7:{i} --limit"))[0], limit[i]);
    }
}

#[test]
fn the_limit_is_the_curve_for_every_degree() {
    for degree in 1..=4 {
        let options = ["curve", "-", "--kind", "bspline", "--knots", "uniform", "--degree", &degree.to_string()];
        let spline = lath_from(WILD, options).done();
        let rows_of = format!("{}", 8 * (5 - degree) + 1);
        let curve = rows(&lath_from(&spline, ["eval", "-", "--count", &rows_of]).done());
        let limit = points(WILD, &format!("--scheme degree:{degree} --levels 3 --limit"));
        assert_eq!(limit.len(), curve.len());
        limit.iter().zip(&curve).for_each(|(limit, curve)| agree(limit, &curve[1..], 13.0));
    }
    // (1, 121, 235, 27)/384 at t = 3/4.
    let exact = [(235.0 * 8.0 + 27.0 * 8.0) / 384.0, (121.0 * 8.0 + 235.0 * 8.0) / 384.0];
    agree(&points(GROUP, "--scheme cubic --only 3:6 --limit")[0], &exact, 8.0);
    agree(&points(GROUP, "--scheme cubic --only 1000:0 --limit")[0], &[8.0 / 6.0, 40.0 / 6.0], 8.0);
}

#[test]
fn ends_are_kept_or_closed() {
    let kept = points(WILD, "--scheme cubic --levels 5 --keep-ends");
    agree(&kept[0], &[1.0, -3.0], 3.0);
    agree(&kept[kept.len() - 1], &[4.0, -9.0], 9.0);
    let limit = points(WILD, "--scheme cubic --levels 2 --keep-ends --limit");
    agree(&limit[0], &[1.0, -3.0], 3.0);
    agree(&limit[limit.len() - 1], &[4.0, -9.0], 9.0);
    // The first row of a closed polygon is that of an open one.
    assert_eq!(points(WILD, "--scheme cubic --levels 3 --closed")[0], points(WILD, "--scheme cubic --levels 3")[0]);
    run(WILD, "--scheme cubic --levels 3 --closed --keep-ends").fails(2, &["--closed", "--keep-ends"]);
}

#[test]
fn few_points_and_equal_points() {
    for n in 0..=4 {
        let input: String = (0..n).map(|i| format!("{i},{i}\n")).collect();
        for (p, scheme) in [(1, "degree:1"), (2, "chaikin"), (3, "cubic"), (4, "degree:4"), (5, "four-point")] {
            let open = run(&input, &format!("--scheme {scheme} --levels 2"));
            let closed = run(&input, &format!("--scheme {scheme} --levels 2 --closed"));
            let kept = run(&input, &format!("--scheme {scheme} --levels 2 --keep-ends"));
            if n == 0 {
                [open, closed, kept].into_iter().for_each(|run| run.fails(3, &["F001"]));
                continue;
            }
            assert_eq!(rows(&closed.done()).len(), 4 * n);
            assert!(!rows(&kept.done()).is_empty());
            match n < p {
                true => open.fails(
                    3,
                    &["P001", &format!(": {n} point{} for a scheme", if n == 1 { "" } else { "s" }), "standard input"],
                ),
                false => assert_eq!(rows(&open.done()).len(), 4 * (n - p) + p),
            }
        }
    }
    // One corner of a closed polygon stays where it is; two make a way there and back.
    assert!(points("3,4\n", "--scheme cubic --levels 3 --closed").iter().all(|row| row[..] == [3.0, 4.0]));
    let two = points("0,0\n4,0\n", "--scheme cubic --levels 1 --closed");
    assert_eq!(two, [[2.0, 0.0], [3.0, 0.0], [2.0, 0.0], [1.0, 0.0]]);
    let same = "0.1,7\n".repeat(6);
    for options in ["--levels 4", "--levels 4 --limit", "--levels 4 --closed", "--only 900:5", "--only 900:5 --limit"] {
        for scheme in ["chaikin", "cubic", "degree:5", "four-point"] {
            for row in points(&same, &format!("--scheme {scheme} {options}")) {
                agree(&row, &[0.1, 7.0], 7.0);
            }
        }
    }
    lath_from("# nothing\n", ["subdivide", "-", "--scheme", "cubic", "--levels", "1", "--closed"]).fails(3, &["P001"]);
}

#[test]
fn as_many_levels_as_a_tolerance_needs() {
    let part = "0,0\n40,0\n40,25\n0,25\n";
    let options = "--scheme cubic --closed --to-tolerance 0.01";
    let told = run(part, options);
    assert_eq!((told.code, told.err.contains("level 5 is proven to lie within 0.00")), (Some(0), true), "{told:?}");
    let quiet = points(part, &format!("{options} --quiet"));
    assert_eq!(quiet, points(part, "--scheme cubic --closed --levels 5"));
    assert!(run(part, &format!("{options} --json")).done().starts_with("{\"columns\""));
    for bad in ["0", "-1", "nan", "inf", "x"] {
        run(part, &format!("--scheme cubic --to-tolerance {bad}")).fails(2, &["--to-tolerance"]);
    }
    run(part, "--scheme cubic --to-tolerance 1e-300").fails(3, &["S005", "--to-tolerance"]);
    run(part, "--scheme mask:2,-1,-1,2 --closed --to-tolerance 1").fails(3, &["S003", "--scheme"]);
}

#[test]
fn points_stay_on_their_sphere() {
    let corners = "1,0,0\n0,1,0\n0,0,1\n0,-1,0\n";
    let net = points(corners, "--scheme cubic --sphere 0,0,0,1 --levels 4 --closed");
    assert_eq!(net.len(), 64);
    assert!(net.iter().all(|p| (p.iter().map(|x| x * x).sum::<f64>() - 1.0).abs() < 1e-14));
    assert_eq!(points(corners, "--scheme cubic --sphere 0,0,0,1 --only 4:7 --closed")[0], net[7]);
    let arc = points("2,1\n1,2\n", "--scheme degree:1 --sphere 1,1,1 --levels 1");
    agree(&arc[1], &[1.0 + 0.5f64.sqrt(), 1.0 + 0.5f64.sqrt()], 2.0);
    run(corners, "--scheme four-point --sphere 0,0,0,1 --levels 1").fails(3, &["S002", "--scheme", "degree:P"]);
    run(corners, "--scheme cubic --sphere 0,0,1 --levels 1").fails(3, &["P005", "2 coordinates"]);
    run(corners, "--scheme cubic --sphere 0,0,0,2 --levels 1").fails(3, &["S008", "standard input:1"]);
    run("1,0\n-1,0\n0,1\n", "--scheme cubic --sphere 0,0,1 --levels 1").fails(3, &["S007", "antipodal"]);
    run(corners, "--scheme cubic --sphere 0,0,0,1 --levels 60").fails(5, &["B001"]);
    for (options, word) in [("--levels 1 --limit", "--limit"), ("--to-tolerance 1", "--to-tolerance")] {
        run(corners, &format!("--scheme cubic --sphere 0,0,0,1 {options}")).fails(2, &["--sphere", word]);
    }
    for ball in ["0,0,0,-1", "0,0,0,0", "1", "0,0,x,1", "0,0,,1"] {
        run(corners, &format!("--scheme cubic --levels 1 --sphere {ball}")).fails(2, &["--sphere"]);
    }
}

#[test]
fn what_does_not_fit_the_budget_is_refused_at_once() {
    for options in ["--levels 31", "--levels 1000", "--levels 1000 --limit", "--levels 1000 --closed"] {
        run(GROUP, &format!("--scheme cubic {options}")).fails(5, &["B001", "budget"]);
        run(GROUP, &format!("--scheme chaikin {options} --closed").replace("--closed --closed", "--closed"))
            .fails(5, &["B001", "budget"]);
    }
    run(GROUP, "--scheme cubic --levels 3 --budget 10").fails(5, &["B001", "11 points", "budget of 10"]);
    assert_eq!(points(GROUP, "--scheme cubic --levels 3 --budget 11").len(), 11);
    let folder = Folder::new();
    let path = folder.path("level.csv");
    run(GROUP, &format!("--scheme cubic --levels 40 -o {path}")).fails(5, &["B001"]);
    assert!(folder.names().is_empty());
    lath(["subdivide", &folder.path("absent.csv"), "--scheme", "cubic", "--levels", "1"]).fails(4, &["I001"]);
}

#[test]
fn wrong_options_and_wrong_data() {
    for (options, words) in [
        ("", ["--scheme", "required"]),
        ("--scheme cubic", ["--levels", "--only"]),
        ("--levels 1", ["--scheme", "required"]),
        ("--scheme cubic --levels 1 --only 1:1", ["--levels", "--only"]),
        ("--scheme cubic --levels 1 --to-tolerance 1", ["--levels", "--to-tolerance"]),
        ("--scheme chaiken --levels 1", ["chaiken", "'chaikin'"]),
        ("--scheme degree --levels 1", ["degree is missing", "degree:P"]),
        ("--scheme degree:-1 --levels 1", ["degree:-1", "whole number"]),
        ("--scheme mask:1,,1 --levels 1", ["number 1", "empty"]),
        ("--scheme mask:1,nan,1 --levels 1", ["nan", "finite"]),
        ("--scheme four-point:wide --levels 1", ["wide", "not a number"]),
        ("--scheme cubic --levels -1", ["-1", "whole number"]),
        ("--scheme cubic --levels 2.5", ["2.5", "whole number"]),
        ("--scheme cubic --only 3", ["--only", "60:123456789"]),
        ("--scheme cubic --only 3:-1", ["-1", "decimal digits"]),
        ("--scheme cubic --only 3:1e3", ["1e3", "decimal digits"]),
        ("--scheme cubic --only 3:", ["--only", "decimal digits"]),
        ("--scheme cubic --only x:3", ["--only", "whole number"]),
    ] {
        run(GROUP, options).fails(2, &words);
    }
    for (options, words) in [
        ("--scheme degree:0 --levels 1", ["K006", "--scheme"]),
        ("--scheme degree:1001 --levels 1", ["K006", "--scheme"]),
        ("--scheme mask:1/4,3/4,1/2,1/4 --levels 1", ["S001", "--scheme"]),
        ("--scheme mask:1,1 --levels 1", ["S002", "--scheme"]),
        ("--scheme cubic --levels 1001", ["S005", "--levels"]),
        ("--scheme cubic --only 1001:0", ["S005", "--only"]),
        ("--scheme cubic --only 3:11", ["S006", "--only"]),
        ("--scheme cubic --only 3:9 --limit", ["S006", "--only"]),
        ("--scheme mask:2,-1,-1,2 --levels 1 --limit", ["S003", "--scheme"]),
    ] {
        run(GROUP, options).fails(3, &words);
    }
    run("0,0\nnan,1\n", "--scheme chaikin --levels 1").fails(3, &["standard input:2:1", "P002"]);
    run("0,0\n1,1e305\n", "--scheme chaikin --levels 1").fails(3, &["standard input:2", "P003"]);
    run(&"0 ".repeat(17), "--scheme chaikin --levels 1 --closed").fails(3, &["P006", "17"]);
    run(r#"{"lath":1,"shapes":[]}"#, "--scheme chaikin --levels 1").fails(3, &["F021"]);
}

#[test]
fn a_level_is_drawn_with_its_polygon_and_limit() {
    let svg = |input: &str, options: &str| {
        let args = ["draw", "-", "-o", "-"].into_iter().chain(options.split_whitespace());
        let svg = lath_from(input, args).done();
        assert!(svg.starts_with("<svg") && !svg.contains("NaN"));
        svg
    };
    let two = svg(GROUP, "--levels 2");
    assert!(two.contains("<svg") && two.len() > svg(GROUP, "--levels 1").len());
    let differ = ["--scheme chaikin", "--scheme four-point --closed", "--closed", "--keep-ends", "--axes", "--dark"];
    for options in differ {
        assert_ne!(svg(GROUP, &format!("--levels 2 {options}")), two, "{options}");
    }
    svg("1\n5\n3\n4\n", "--levels 3 --axes");
    svg("1\n5\n3\n4\n", "--levels 3 --closed --scheme four-point");
    svg("0,0,0\n1,2,0\n3,2,5\n4,0,1\n", "--levels 2");
    svg("0,0\n1,1\n2,0\n", "--levels 2"); // one joint, no curve
    svg(GROUP, "--levels 1 --scheme mask:2,-1,-1,2"); // no limit known
    for (options, code, word) in [
        ("--levels 2 --through", 2, "--through"),
        ("--scheme cubic", 2, "--levels"),
        ("--keep-ends", 2, "--levels"),
        ("--levels 2 --closed --keep-ends", 2, "--keep-ends"),
        ("--levels 2 --kind cubic", 2, "--through"),
        ("--levels x", 2, "--levels"),
        ("--levels 40", 5, "B001"),
        ("--levels 2000", 3, "S005"),
        ("--levels 2 --scheme degree:5", 3, "P001"),
    ] {
        lath_from(GROUP, ["draw", "-", "-o", "-"].into_iter().chain(options.split(' '))).fails(code, &[word]);
    }
}
