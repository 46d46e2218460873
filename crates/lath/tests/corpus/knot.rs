//! Knot vectors: taken or refused, their spans and their builders.

use crate::refused;
use lath::error::Result;
use lath::knot::{Knots, Side};
use lath::num::Scalar;
use testkit::corpus::{Entry, load};
use testkit::rational::Rational;

fn built<S: Scalar>(case: &Entry, read: impl Fn(&str) -> Vec<S>) -> Result<Knots<S>> {
    let degree = case.count("degree");
    match case.text("builder") {
        "uniform" => Knots::uniform(case.count("functions"), degree),
        "clamped" => Knots::clamped(case.count("functions"), degree),
        "periodic" => Knots::periodic(&read("period"), degree),
        "from-data" => Knots::from_data(&read("parameters"), degree),
        other => panic!("{}: unknown builder {other}", case.place),
    }
}

#[test]
fn bad_knots_are_refused_with_code_and_culprit() {
    let mut refusals = 0;
    for case in load("knot").iter().filter(|case| case.has("error") && !case.has("builder")) {
        refused(case, Knots::new(case.floats("knots"), case.count("degree")));
        refusals += 1;
    }
    assert!(refusals >= 15, "{refusals}");
}

#[test]
fn spans_at_and_beside_knots_are_those_of_the_definition() {
    for case in load("knot").iter().filter(|case| case.has("spans")) {
        let floats = Knots::new(case.floats("knots"), case.count("degree")).unwrap();
        let fractions = Knots::new(case.numbers("knots"), case.count("degree")).unwrap();
        assert_eq!(floats.functions(), case.count("functions"), "{}", case.place);
        let domain = case.numbers("domain");
        assert_eq!(fractions.domain(), (domain[0].clone(), domain[1].clone()), "{}", case.place);
        assert_eq!(fractions.breaks(), case.numbers("breaks"), "{}", case.place);
        assert_eq!(floats.breaks(), case.floats("breaks"), "{}", case.place);
        for at in case.entries("spans") {
            for (side, key) in [(Side::Left, "left"), (Side::Right, "right")] {
                let (float, fraction) = (at.float("t"), at.number("t"));
                let place = format!("{} at {fraction} from the {key}", case.place);
                assert_eq!(floats.span(&float, side), at.count(key), "{place}");
                assert_eq!(fractions.span(&fraction, side), at.count(key), "{place}, on fractions");
            }
        }
        for at in case.entries("multiplicities") {
            assert_eq!(floats.multiplicity(&at.float("t")), at.count("is"), "{}", case.place);
            assert_eq!(fractions.multiplicity(&at.number("t")), at.count("is"), "{}", case.place);
        }
    }
}

#[test]
fn builders_follow_their_rules() {
    for case in load("knot").iter().filter(|case| case.has("builder")) {
        if let Some(knots) = refused(case, built(case, |key| case.floats(key))) {
            assert_eq!(knots.values(), case.floats("knots"), "{}", case.place);
            let exact: Knots<Rational> = built(case, |key| case.numbers(key)).unwrap();
            assert_eq!(exact.values(), case.numbers("knots"), "{}, on fractions", case.place);
        }
    }
}
