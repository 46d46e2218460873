//! None to four points, equal, collinear and doubled ones, for every kind of curve, open and closed: the right curve, or exit 3 with
//! its code. One table says which.
#![allow(clippy::unwrap_used, clippy::panic)] // helpers of tests stop at the first fault

mod tool;

use tool::{lath_from, rows};

/// Kinds through points, and how many points each takes, open and closed.
const THROUGH: &[(&str, usize, usize)] = &[
    ("cubic", 2, 2),
    ("cubic --ends natural", 2, 0),
    ("cubic --ends cyclic", 2, 0),
    ("cubic --ends anticyclic", 2, 0),
    ("bspline --degree 0", 2, 2),
    ("bspline --degree 1", 2, 2),
    ("bspline --degree 2", 3, 2),
    ("bspline --degree 3", 4, 2),
    ("bspline --degree 3 --ends natural", 2, 0),
    ("bspline --degree 4", 5, 2),
    ("catmull-rom", 2, 2),
    ("cardinal:1/2", 2, 2),
    ("kochanek-bartels:0,1/2,0", 2, 2),
    ("pchip", 2, 2),
    ("akima", 2, 2),
    ("makima", 2, 2),
    ("steffen", 2, 2),
];

/// Kinds from control points, and how many points each takes; 0 where it cannot be.
const CONTROL: &[(&str, usize, usize)] = &[
    ("bezier", 1, 0),
    ("bspline", 4, 1),
    ("bspline --degree 0", 1, 1),
    ("bspline --degree 1", 2, 1),
    ("bspline --degree 4", 5, 1),
    ("bspline --knots uniform", 4, 1),
    ("bspline --tension 1/2", 4, 1),
    ("bspline --at-polygon repeat", 1, 0),
    ("bspline --at-polygon phantom", 2, 0),
    ("bspline --at-polygon phantom --degree 4", 2, 0),
];

const POINTS: [[f64; 2]; 4] = [[0.0, 0.0], [3.0, 4.0], [3.0, 0.0], [-1.0, 2.0]];

fn csv(points: &[[f64; 2]]) -> String {
    points.iter().map(|[x, y]| format!("{x},{y}\n")).collect()
}

/// The points of the curve at 25 places.
#[track_caller]
fn sampled(curve: &str) -> Vec<[f64; 2]> {
    let found = rows(&lath_from(curve, ["eval", "-", "--count", "25"]).done());
    found.iter().map(|row| [row[1], row[2]]).collect()
}

fn arguments(verb: &str, kind: &str, more: &str) -> Vec<String> {
    [verb, "-", "--kind"].into_iter().chain(kind.split(' ')).chain(more.split_whitespace()).map(str::to_owned).collect()
}

/// Every way to make a curve: verb, kind, further options, and the number of points that it takes.
fn ways() -> impl Iterator<Item = (&'static str, &'static str, String, usize)> {
    let through = THROUGH.iter().flat_map(|(kind, open, closed)| {
        let ways = ["--params uniform", "--params chord"];
        let both = [("", *open), (" --closed", *closed)].into_iter().filter(|(_, least)| *least > 0);
        both.flat_map(move |(more, least)| ways.map(|way| ("through", *kind, format!("{way}{more}"), least)))
    });
    let control = CONTROL.iter().flat_map(|(kind, open, closed)| {
        let both = [("", *open), ("--closed", *closed)].into_iter().filter(|(_, least)| *least > 0);
        both.map(move |(more, least)| ("curve", *kind, more.to_owned(), least))
    });
    through.chain(control)
}

#[test]
fn none_to_four_points() {
    let (mut made, mut refused) = (0, 0);
    for (verb, kind, more, least) in ways() {
        for n in 0..=4 {
            let points = &POINTS[..n];
            let run = lath_from(csv(points), arguments(verb, kind, &more));
            let place = format!("{verb} {kind} {more} of {n} points");
            if n < least {
                run.fails(3, &[if n == 0 { "F001" } else { "P001" }]);
                refused += 1;
                continue;
            }
            let curve = run.done();
            let found = sampled(&curve);
            assert!(found.iter().flatten().all(|x| x.is_finite() && x.abs() < 40.0), "{place}: {found:?}");
            if verb == "through" {
                // It passes every point at its parameter.
                let t: Vec<String> = match more.contains("chord") {
                    false => (0..n).map(|i| i.to_string()).collect(),
                    true => ["0", "5", "9"].iter().take(n).map(|t| (*t).to_owned()).collect(),
                };
                let passed = rows(&lath_from(&curve, ["eval", "-", "--at", &t.join(",")]).done());
                for (row, point) in passed.iter().zip(points) {
                    let off = (row[1] - point[0]).abs() + (row[2] - point[1]).abs();
                    assert!(off < 1e-13, "{place}: {row:?}, not {point:?}");
                }
            }
            made += 1;
        }
    }
    assert!(made > 150 && refused > 100, "{made} made, {refused} refused");
}

#[test]
fn equal_collinear_and_doubled_points() {
    let line: Vec<[f64; 2]> = [0.0, 1.0, 3.0, 4.0, 8.0, 9.0].iter().map(|x| [*x, 2.0 * x - 1.0]).collect();
    let doubled = [[0.0, 0.0], [1.0, 2.0], [1.0, 2.0], [3.0, 1.0], [4.0, 4.0], [0.0, 5.0]];
    for (verb, kind, more, _) in ways() {
        let place = format!("{verb} {kind} {more}");
        let run = |points: &[[f64; 2]]| lath_from(csv(points), arguments(verb, kind, &more));
        let chord = more.contains("chord");
        // All equal: the curve that stays, or, where lengths are parameters, the second point is named. Closed, the last one closes.
        let equal = run(&[[2.0, 7.0]; 6]);
        if chord {
            equal.fails(3, &["P004", "standard input:2"]);
        } else {
            for [x, y] in sampled(&equal.done()) {
                assert!((x - 2.0).abs() + (y - 7.0).abs() < 1e-13, "{place}: {x}, {y}");
            }
        }
        // Collinear: the curve is on the line, overshooting or not.
        for [x, y] in sampled(&run(&line).done()) {
            assert!((y - (2.0 * x - 1.0)).abs() < 1e-12, "{place}: {x}, {y} is off the line");
        }
        let twice = run(&doubled);
        if chord {
            twice.fails(3, &["P004", "standard input:3"]);
        } else {
            assert!(sampled(&twice.done()).iter().flatten().all(|x| x.is_finite()), "{place}");
        }
    }
}

#[test]
fn kinds_that_cannot_be_closed_say_so() {
    lath_from(csv(&POINTS), ["curve", "-", "--kind", "bezier", "--closed"]).fails(3, &["C002"]);
    for end in ["repeat", "phantom"] {
        lath_from(csv(&POINTS), ["curve", "-", "--kind", "bspline", "--closed", "--at-polygon", end])
            .fails(2, &["--closed"]);
    }
    for ends in ["natural", "cyclic", "anticyclic"] {
        lath_from(csv(&POINTS), ["through", "-", "--closed", "--ends", ends]).fails(2, &["--closed"]);
    }
}
