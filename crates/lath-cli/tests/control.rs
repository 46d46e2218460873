//! The textbook's curves from control points, their numbers by the command line; the corpus in `control/` by files and pipes.
#![allow(clippy::unwrap_used, clippy::panic)] // helpers of tests stop at the first fault

mod tool;

use testkit::corpus::{Entry, load};
use testkit::rational::Rational;
use tool::{Run, lath_from, numbers, rows, shape};

fn csv(rows: &[Vec<f64>]) -> String {
    let line = |row: &Vec<f64>| row.iter().map(f64::to_string).collect::<Vec<_>>().join(",") + "\n";
    rows.iter().map(line).collect()
}

/// `lath curve` on the case's points, with its options.
fn made(case: &Entry) -> Run {
    let mut arguments: Vec<String> = ["curve", "-", "--kind", "bspline", "--degree"].map(str::to_owned).into();
    arguments.push(case.count("degree").to_string());
    let bare = !case.has("tension") && !case.has("at-polygon");
    if case.flag("closed") {
        arguments.push("--closed".into());
    } else if bare {
        arguments.extend(["--knots".into(), "uniform".into()]);
    }
    if case.has("tension") {
        // In fractions, as people write them.
        let tensions: Vec<String> = case.numbers("tension").iter().map(Rational::to_string).collect();
        arguments.extend(["--tension".into(), tensions.join(",")]);
    }
    if let Some(end) = case.text_if("at-polygon") {
        arguments.extend(["--at-polygon".into(), end.into()]);
    }
    lath_from(csv(&case.float_rows("points")), arguments)
}

#[test]
fn every_case_from_control_points_through_the_pipe() {
    let (mut compared, mut refused) = (0, 0);
    for case in load("control") {
        if let Some(code) = case.text_if("error") {
            made(&case).fails(3, &[code]);
            refused += 1;
            continue;
        }
        let curve = made(&case).done();
        for side in ["left", "right"] {
            let asked: Vec<Entry> =
                case.entries("at").into_iter().filter(|at| at.text_if("side").unwrap_or("right") == side).collect();
            if asked.is_empty() {
                continue;
            }
            let orders = (1..).take_while(|k| asked[0].has(&format!("d{k}"))).count();
            let at: Vec<String> = asked.iter().map(|at| at.number("t").to_string()).collect();
            let orders_text = orders.to_string();
            let question = ["eval", "-", "--at", &at.join(","), "--derivatives", &orders_text, "--side", side];
            let found = rows(&lath_from(&curve, question.map(str::to_owned)).done());
            for (row, at) in found.iter().zip(&asked) {
                let keys = std::iter::once("value".to_owned()).chain((1..=orders).map(|k| format!("d{k}")));
                let exact: Vec<f64> = keys.flat_map(|key| at.numbers(&key)).map(|x| x.to_f64()).collect();
                assert_eq!(row.len(), exact.len() + 1, "{}", case.place);
                for (found, exact) in row[1..].iter().zip(&exact) {
                    assert!((found - exact).abs() <= 1e-12, "{} at {}: {found}, not {exact}", case.place, row[0]);
                    compared += 1;
                }
            }
        }
    }
    assert!(compared > 600 && refused >= 5, "{compared} numbers compared, {refused} refused");
}

/// Solves A x = b for a few unknowns, by elimination with exchange of rows.
fn solve(mut a: Vec<Vec<f64>>, mut b: Vec<Vec<f64>>) -> Vec<Vec<f64>> {
    let n = a.len();
    for k in 0..n {
        let best = (k..n).max_by(|i, j| a[*i][k].abs().total_cmp(&a[*j][k].abs())).unwrap();
        a.swap(k, best);
        b.swap(k, best);
        for i in (0..n).filter(|i| *i != k) {
            let factor = a[i][k] / a[k][k];
            let (row, side) = (a[k].clone(), b[k].clone());
            a[i].iter_mut().zip(row).for_each(|(x, y)| *x -= factor * y);
            b[i].iter_mut().zip(side).for_each(|(x, y)| *x -= factor * y);
        }
    }
    (0..n).map(|k| b[k].iter().map(|x| x / a[k][k]).collect()).collect()
}

#[test]
fn interpolating_cubics_are_the_control_points_of_the_textbook() {
    // n + 1 points K, n + 3 control points: (Pᵢ₋₁ + 4Pᵢ + Pᵢ₊₁)/6 = Kᵢ and two ends, here without second derivative.
    let points = [[0.0, 0.0], [2.0, 3.0], [5.0, 1.0], [6.0, -2.0], [9.0, 0.0]].map(|p| p.to_vec());
    let n = points.len();
    let mut a = vec![vec![0.0; n + 2]; n + 2];
    let mut b = vec![vec![0.0, 0.0]; n + 2];
    for (i, point) in points.iter().enumerate() {
        (a[i][i], a[i][i + 1], a[i][i + 2]) = (1.0 / 6.0, 4.0 / 6.0, 1.0 / 6.0);
        b[i].clone_from(point);
    }
    for (row, first) in [(n, 0), (n + 1, n - 1)] {
        (a[row][first], a[row][first + 1], a[row][first + 2]) = (1.0, -2.0, 1.0);
    }
    let control = solve(a, b);
    let values = |curve: String| rows(&lath_from(curve, ["eval", "-", "--count", "33", "--derivatives", "2"]).done());
    let by_hand = values(lath_from(csv(&control), "curve - --kind bspline --knots uniform".split(' ')).done());
    for kind in ["--kind bspline", "--kind cubic"] {
        let arguments = format!("through - --params uniform --ends natural {kind}");
        let found = values(lath_from(csv(&points), arguments.split(' ')).done());
        assert!(found.iter().flatten().zip(by_hand.iter().flatten()).all(|(a, b)| (a - b).abs() < 1e-13), "{kind}");
    }
    // Closed, from the cyclic system: the curve starts at K₀, the first joint of P₋₁, P₀, P₁.
    let mut a = vec![vec![0.0; n]; n];
    for i in 0..n {
        for (j, share) in [(n - 1, 1.0), (0, 4.0), (1, 1.0)] {
            a[i][(i + j) % n] += share / 6.0;
        }
    }
    let mut control = solve(a, points.to_vec());
    control.rotate_right(1);
    let by_hand = values(lath_from(csv(&control), "curve - --kind bspline --closed".split(' ')).done());
    let found = lath_from(csv(&points), "through - --params uniform --kind bspline --closed".split(' ')).done();
    assert!(values(found).iter().flatten().zip(by_hand.iter().flatten()).all(|(a, b)| (a - b).abs() < 1e-13));
}

#[test]
fn knots_of_interpolating_bsplines_follow_the_rule() {
    // Odd degree: the parameters less the first and last (p + 1)/2; even degree: the middles less the first and last p/2.
    let data = "t,x\n0,1\n1,3\n2.5,2\n3,0\n4.5,5\n6,1\n7,2\n";
    let t = [0.0, 1.0, 2.5, 3.0, 4.5, 6.0, 7.0];
    for p in 1..=6 {
        let arguments = format!("through - --params column:t --kind bspline --degree {p}");
        let found = numbers(&shape(&lath_from(data, arguments.split(' ')).done())["knots"]);
        let sites: Vec<f64> = match p % 2 {
            1 => t.to_vec(),
            _ => t.windows(2).map(|pair| (pair[0] + pair[1]) / 2.0).collect(),
        };
        let drop: usize = if p % 2 == 1 { usize::div_ceil(p, 2) } else { p / 2 };
        let inner = sites[drop..sites.len() - drop].iter().copied();
        let ends = |t: f64| std::iter::repeat_n(t, p + 1);
        assert_eq!(found, ends(0.0).chain(inner).chain(ends(7.0)).collect::<Vec<f64>>(), "degree {p}");
    }
    // An even number of points, even degree, closed: singular with knots at the points, not with knots between them.
    for p in [2, 4, 6] {
        let arguments = format!("through - --params uniform --kind bspline --closed --degree {p}");
        let curve = lath_from("1,0\n0,1\n-1,0\n0,-1\n", arguments.split(' ')).done();
        assert_eq!(numbers(&shape(&curve)["knots"])[..2], [-0.5, 0.5]);
        let row = rows(&lath_from(curve, ["eval", "-", "--at", "1"]).done())[0].clone();
        assert!(row[1].abs() < 1e-15 && (row[2] - 1.0).abs() < 1e-15, "degree {p}: {row:?}");
    }
}

#[test]
fn the_open_quadratic_has_the_tangents_of_exercise_4_102() {
    let p = [[0.0, 0.0], [1.0, 2.0], [3.0, 2.0], [4.0, 0.0], [6.0, 1.0]];
    let points = csv(&p.map(|p| p.to_vec()));
    // Clamped knots are (0,0,0,1,2,3,3,3).
    let curve = lath_from(points, "curve - --kind bspline --degree 2".split(' ')).done();
    assert_eq!(numbers(&shape(&curve)["knots"]), [0.0, 0.0, 0.0, 1.0, 2.0, 3.0, 3.0, 3.0]);
    let found = rows(&lath_from(curve, "eval - --at 1/4,1/2,5/4,3/2,9/4,3 --derivatives 1".split(' ')).done());
    for row in found {
        let t = row[0];
        let shares = match t {
            t if t < 1.0 => [2.0 * (t - 1.0), 2.0 - 3.0 * t, t, 0.0, 0.0],
            t if t < 2.0 => [0.0, t - 2.0, 3.0 - 2.0 * t, t - 1.0, 0.0],
            _ => [0.0, 0.0, t - 3.0, 7.0 - 3.0 * t, 2.0 * (t - 2.0)],
        };
        for c in 0..2 {
            let tangent: f64 = shares.iter().zip(&p).map(|(share, p)| share * p[c]).sum();
            assert!((row[3 + c] - tangent).abs() < 1e-14, "at {t}: {row:?}, not {tangent}");
        }
    }
}
