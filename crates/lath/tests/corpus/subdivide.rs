//! Subdivision: schemes, levels and limits, weights, leaps, on fractions and on floats.

use crate::refused;
use lath::error::{Code, Limits, Result};
use lath::num::Scalar;
use lath::subdivide::{Convergence, Ends, Form, Index, Scheme, Subdivision, Target, ancestor, descents};
use testkit::corpus::{Entry, load};
use testkit::rational::Rational;

/// A scalar that cases are replayed on.
trait Engine: Scalar {
    /// Whether it rounds nothing.
    const EXACT: bool;
    fn read(text: &str) -> Self;
    fn points(case: &Entry) -> Vec<Vec<Self>>;
    /// Holds what was found against the answer; `size` is that of the numbers which went in.
    fn holds(found: &[Self], expected: &[Rational], size: f64, place: &str);
}

impl Engine for Rational {
    const EXACT: bool = true;

    fn read(text: &str) -> Rational {
        text.parse().unwrap()
    }

    fn points(case: &Entry) -> Vec<Vec<Rational>> {
        case.rows("points")
    }

    fn holds(found: &[Rational], expected: &[Rational], _: f64, place: &str) {
        assert_eq!(found, expected, "{place}, on fractions");
    }
}

impl Engine for f64 {
    const EXACT: bool = false;

    fn read(text: &str) -> f64 {
        text.parse().unwrap_or_else(|_| Rational::read(text).to_f64())
    }

    fn points(case: &Entry) -> Vec<Vec<f64>> {
        case.float_rows("points")
    }

    fn holds(found: &[f64], expected: &[Rational], size: f64, place: &str) {
        assert_eq!(found.len(), expected.len(), "{place}");
        for (x, exact) in found.iter().zip(expected) {
            let off = (x - exact.to_f64()).abs();
            assert!(off <= 1e-14 * size.max(1.0), "{place}: {x}, not {exact}");
        }
    }
}

fn cases(kind: &str) -> Vec<Entry> {
    let found: Vec<Entry> = load("subdivide").into_iter().filter(|case| case.text("kind") == kind).collect();
    assert!(!found.is_empty());
    found
}

/// The scheme of a case, in the words of the command line.
fn scheme<S: Engine>(case: &Entry) -> Result<Scheme<S>> {
    let word = case.text("scheme");
    match word.split_once(':') {
        None if word == "chaikin" => Ok(Scheme::chaikin()),
        None if word == "cubic" => Ok(Scheme::cubic()),
        None if word == "four-point" => Scheme::four_point(&S::read("1/16")),
        Some(("degree", degree)) => Scheme::lane_riesenfeld(degree.parse().unwrap()),
        Some(("four-point", tension)) => Scheme::four_point(&S::read(tension)),
        Some(("mask", numbers)) => Scheme::from_mask(numbers.split(',').map(S::read).collect()),
        _ => panic!("{}: unknown scheme {word}", case.place),
    }
}

fn polygon<const D: usize, S: Engine>(case: &Entry) -> Result<Subdivision<D, S>> {
    let ends = match case.text_if("ends") {
        None | Some("open") => Ends::Open,
        Some("kept") => Ends::Kept,
        Some("closed") => Ends::Closed,
        Some(other) => panic!("{}: unknown ends {other}", case.place),
    };
    let points = S::points(case).into_iter().map(|row| row.try_into().unwrap());
    Subdivision::new(scheme(case)?, points, ends)
}

fn index(entry: &Entry, key: &str) -> Index {
    entry.text(key).parse().unwrap()
}

fn target(entry: &Entry) -> Target {
    match entry.text_if("target") {
        None | Some("level") => Target::Level,
        Some("limit") => Target::Limit,
        Some(other) => panic!("{}: unknown target {other}", entry.place),
    }
}

/// Runs one law of a case on fractions and on floats.
macro_rules! on_both {
    ($law:ident, $case:expr) => {{
        $law::<Rational>($case);
        $law::<f64>($case);
    }};
}

#[test]
fn schemes_have_their_matrices_and_limits() {
    for case in &cases("scheme") {
        on_both!(scheme_holds, case);
    }
}

fn scheme_holds<S: Engine>(case: &Entry) {
    let scheme: Scheme<S> = scheme(case).unwrap();
    let same = |found: &[S], key: &str| S::holds(found, &case.numbers(key), 1.0, &format!("{}: {key}", case.place));
    let matrix = |found: &[Vec<S>], key: &str| {
        assert_eq!(found.len(), case.rows(key).len(), "{}: {key}", case.place);
        S::holds(&found.concat(), &case.rows(key).concat(), 1.0, &format!("{}: {key}", case.place));
    };
    assert_eq!(scheme.degree(), case.count("degree"), "{}", case.place);
    same(scheme.mask(), "mask");
    matrix(&scheme.local_matrix(), "local");
    matrix(&scheme.group_matrix(), "group");
    let orders = case.rows("limit_masks").len();
    let masks: Vec<Vec<S>> = (0..orders).map(|order| scheme.limit_mask(order).unwrap()).collect();
    matrix(&masks, "limit_masks");
    if let Some(order) = case.count_if("no_limit") {
        assert_eq!(scheme.limit_mask(order).unwrap_err().code(), Code::S003, "{}", case.place);
    }
    if case.has("smoothness") {
        assert_eq!(scheme.smoothness(), case.count_if("smoothness"), "{}", case.place);
    }
    match scheme.convergence() {
        Convergence::NotProven => assert!(case.flag("not_proven"), "{}", case.place),
        Convergence::Proven { power, norm } => {
            let proven = case.entry("proven");
            assert_eq!(power, proven.count("power"), "{}", case.place);
            S::holds(&[norm], &[proven.number("norm")], 1.0, &case.place);
        }
    }
    if !case.has("eigenvalues") {
        return;
    }
    // Floats answer in full for splines only.
    if let Form::Exact(eigen) = scheme.eigen().unwrap() {
        same(&eigen.eigenvalues, "eigenvalues");
        let blocks: Vec<Rational> = eigen.blocks.iter().map(|size| Rational::from(*size as i64)).collect();
        assert_eq!(
            blocks,
            if case.has("blocks") { case.numbers("blocks") } else { vec![Rational::one(); blocks.len()] }
        );
        for (key, found) in [("q", &eigen.q), ("q_inverse", &eigen.q_inverse)] {
            if case.has(key) {
                matrix(found, key);
            }
        }
    } else {
        assert!(!scheme.is_spline() && !S::EXACT, "{}", case.place);
    }
}

#[test]
fn polygons_have_their_levels_limits_and_joints() {
    let mut compared = 0;
    for case in cases("polygon").iter().filter(|case| !case.has("error")) {
        compared += match case.rows("points")[0].len() {
            2 => polygon_holds::<2, Rational>(case) + polygon_holds::<2, f64>(case),
            3 => polygon_holds::<3, Rational>(case) + polygon_holds::<3, f64>(case),
            other => panic!("{}: no test in {other} dimensions", case.place),
        };
    }
    assert!(compared > 150, "{compared}");
}

/// Says how many answers were compared.
fn polygon_holds<const D: usize, S: Engine>(case: &Entry) -> usize {
    let sub: Subdivision<D, S> = polygon(case).unwrap();
    let size = case.rows("points").iter().flatten().fold(1.0, |most: f64, x| most.max(x.to_f64().abs()));
    let mut compared = 0;
    let mut same = |found: &[S], expected: &[Rational], what: &str| {
        S::holds(found, expected, 4.0 * size, &format!("{}: {what}", case.place));
        compared += 1;
    };
    for (key, target) in [("levels", Target::Level), ("limits", Target::Limit)] {
        for at in case.entries(key) {
            let level = at.count("level");
            let found = sub.level(level, target, &Limits::default()).unwrap();
            let what = format!("{key} {level}");
            assert_eq!(sub.count(level, target).unwrap().to_u64(), Some(found.len() as u64), "{}: {what}", case.place);
            same(found.as_flattened(), &at.rows("points").concat(), &what);
        }
    }
    for at in case.entries("joints") {
        let joint = sub.joint(at.count("level"), &index(&at, "index")).unwrap();
        same(&[joint.t], &[at.number("t")], "a joint's parameter");
        same(&joint.point, &at.numbers("point"), "a joint's point");
        for (found, key) in [(joint.tangent, "tangent"), (joint.second, "second")] {
            assert_eq!(found.is_some(), at.has(key), "{}: {key}", case.place);
            if let Some(found) = found {
                same(&found, &at.numbers(key), key);
            }
        }
    }
    for at in case.entries("only") {
        let found = sub.point(at.count("level"), target(&at), &index(&at, "index")).unwrap();
        same(&found, &at.numbers("point"), at.text("index"));
    }
    compared
}

#[test]
fn groups_weigh_in_their_points() {
    for case in &cases("weights") {
        on_both!(weights_hold, case);
    }
}

fn weights_hold<S: Engine>(case: &Entry) {
    let scheme: Scheme<S> = scheme(case).unwrap();
    for at in case.entries("weights") {
        let found = scheme.group_weights(at.count("level"), target(&at), &index(&at, "index")).unwrap();
        S::holds(&found, &at.numbers("weights"), 1.0, &format!("{}: {}", case.place, at.text("index")));
    }
}

#[test]
fn triplets_come_from_triplets() {
    for case in cases("triplets") {
        let found = descents(case.count("level"), &Limits::default()).unwrap();
        let found: Vec<(u64, u64)> = found.iter().map(|descent| (descent.index, descent.from)).collect();
        let expected = case.entries("triplets");
        let expected: Vec<(u64, u64)> =
            expected.iter().map(|row| (row.count("index") as u64, row.count("from") as u64)).collect();
        assert_eq!(found, expected, "{}", case.place);
    }
}

#[test]
fn powers_leap_over_levels() {
    for case in &cases("jump") {
        on_both!(jump_holds, case);
        for at in case.entries("ancestors") {
            let found = ancestor(at.count("level"), &index(&at, "index"));
            let expected = (at.count("from"), index(&at, "at"), at.count("power"));
            assert_eq!((found.level, found.index, found.power), expected, "{}", case.place);
        }
    }
}

fn jump_holds<S: Engine>(case: &Entry) {
    let scheme: Scheme<S> = scheme(case).unwrap();
    for at in case.entries("jumps") {
        let leap = scheme.leap(at.count("level"), &index(&at, "index"), at.count("to")).unwrap();
        assert_eq!((leap.power, leap.index), (at.count("power"), index(&at, "lands")), "{}", case.place);
        S::holds(&leap.matrix.concat(), &at.rows("matrix").concat(), 1.0, &case.place);
    }
}

#[test]
fn bad_schemes_polygons_and_questions_are_refused() {
    let mut refusals = 0;
    for case in cases("polygon").iter().filter(|case| case.has("error")) {
        assert!(refused(case, asked(case)).is_none());
        refusals += 1;
    }
    assert!(refusals > 20, "{refusals}");
}

/// What becomes of the polygon, or of the question about it.
fn asked(case: &Entry) -> Result<()> {
    let sub: Subdivision<2> = polygon(case)?;
    if !case.has("ask") {
        return Ok(());
    }
    let ask = case.entry("ask");
    if ask.has("index") {
        return sub.point(ask.count("level"), target(&ask), &ask.text("index").parse()?).map(|_| ());
    }
    sub.level(ask.count("level"), target(&ask), &Limits::default()).map(|_| ())
}
