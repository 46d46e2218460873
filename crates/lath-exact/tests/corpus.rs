//! Every case of `testdata/exact/` asked of the library. The tool replays the same cases.
#![allow(clippy::unwrap_used, clippy::panic)] // helpers of tests stop at the first fault, loudly

use lath::knot::Side;
use lath_exact::answer::{
    Basis, Condition, Ends, Form, at, blending, change, collocation, elevation, elevation_bezier, greville, insertion,
    interpolation, jump, limit, matrix, point, scheme, scheme_named, triplets,
};
use lath_exact::parse::{fraction, fractions, rows};
use lath_exact::print::Answer;
use std::collections::BTreeSet;
use testkit::answer::compare;
use testkit::corpus::{Entry, load};

/// The question of a case, asked of the library.
fn answer(ask: &Entry) -> Box<dyn Answer> {
    let limits = Default::default();
    let list = |key: &str| fractions(ask.text(key)).unwrap();
    let degree = || ask.count("degree");
    let named = || match ask.text_if("scheme") {
        Some(name) => scheme_named(name).unwrap(),
        None => scheme_named(&format!("degree:{}", degree())).unwrap(),
    };
    // An index beyond every integer type is a text.
    let index = || match ask.text_if("index") {
        Some(digits) => digits.parse().unwrap(),
        None => (ask.count("index") as u64).into(),
    };
    match ask.text("question") {
        "matrix" => {
            let basis: Basis = ask.text("basis").parse().unwrap();
            Box::new(matrix(&basis, ask.count_if("degree").unwrap_or(3), &limits).unwrap())
        }
        "blending" => Box::new(blending(&list("knots"), degree(), &limits).unwrap()),
        "scheme" => Box::new(scheme(&named(), &limits).unwrap()),
        "point" => Box::new(point(&named(), ask.count("level"), &index(), &limits).unwrap()),
        "limit" => Box::new(limit(&named(), ask.count("level"), &index(), &limits).unwrap()),
        "jump" => {
            let (level, index) = ask.text("from").split_once(':').unwrap();
            let from = (level.parse().unwrap(), index.parse().unwrap());
            Box::new(jump(&named(), from, ask.count("to_level"), &limits).unwrap())
        }
        "triplets" => Box::new(triplets(ask.count("level"), &limits).unwrap()),
        "at" => {
            let side = if ask.text_if("side") == Some("left") { Side::Left } else { Side::Right };
            let (t, order) = (fraction(ask.text("t")).unwrap(), ask.count_if("derivative").unwrap_or(0));
            let answer = at(&list("knots"), degree(), &t, order, side, &limits).unwrap();
            Box::new(match ask.text_if("points") {
                Some(points) => answer.with_points(rows(points).unwrap()).unwrap(),
                None => answer,
            })
        }
        "greville" => Box::new(greville(&list("knots"), degree()).unwrap()),
        "insertion" => Box::new(insertion(&list("knots"), degree(), &list("insert"), &limits).unwrap()),
        "elevation" => {
            let by = ask.count_if("by").unwrap_or(1);
            Box::new(match ask.has("knots") {
                true => elevation(&list("knots"), degree(), by, &limits).unwrap(),
                false => elevation_bezier(degree(), by, &limits).unwrap(),
            })
        }
        "change" => {
            let form = |key: &str| -> Form { ask.text(key).parse().unwrap() };
            let interval = fractions(ask.text_if("interval").unwrap_or("0,1")).unwrap();
            let (interval, degree) = ((interval[0].clone(), interval[1].clone()), ask.count_if("degree").unwrap_or(3));
            Box::new(change(&form("from"), &form("to"), degree, interval, &limits).unwrap())
        }
        "interpolation" => {
            let points = rows(ask.text("points")).unwrap();
            let parameters = ask.text_if("params").map(|text| fractions(text).unwrap());
            let parameters = parameters.as_deref();
            if ask.has("degree") {
                let ends = if ask.flag("closed") { "closed" } else { ask.text_if("ends").unwrap_or("not-a-knot") };
                return Box::new(collocation(&points, parameters, degree(), ends.parse().unwrap(), &limits).unwrap());
            }
            let one = |key: &str| -> Condition {
                ask.text_if(key).or(ask.text_if("ends")).unwrap_or("not-a-knot").parse().unwrap()
            };
            let ends = match ask.text_if("ends") {
                _ if ask.flag("closed") => Ends::Closed,
                Some("cyclic") => Ends::Cyclic,
                Some("anticyclic") => Ends::Anticyclic,
                _ => Ends::Open(one("start"), one("end")),
            };
            Box::new(interpolation(&points, parameters, ends, &limits).unwrap())
        }
        other => panic!("{}: no question {other}", ask.place),
    }
}

#[test]
fn every_case_is_answered() {
    let (mut cases, mut numbers, mut questions) = (0, 0, BTreeSet::new());
    for case in load("exact") {
        let ask = case.entry("ask");
        let answer = answer(&ask);
        questions.insert(ask.text("question").to_owned());
        numbers += compare(&case, &serde_json::from_str(&answer.json()).unwrap());
        let steps = answer.explain(&Default::default()).unwrap();
        for line in case.table().get("explains").and_then(toml::Value::as_array).into_iter().flatten() {
            let line = line.as_str().unwrap();
            assert!(steps.contains(line), "{}: no line {line}\n{steps}", case.place);
        }
        cases += 1;
    }
    assert_eq!(questions.len(), 13, "{questions:?}");
    assert!(cases >= 60 && numbers >= 700, "{cases} cases, {numbers} numbers");
}
