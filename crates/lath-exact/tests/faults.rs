//! What is wrong is named, and what would not answer is refused before it begins.
#![allow(clippy::unwrap_used, clippy::panic)] // helpers of tests stop at the first fault, loudly

use lath::error::{Code as Core, Limits};
use lath::knot::Side;
use lath_exact::answer::{
    Basis, Condition, Ends, Form, at, blending, change, elevation, elevation_bezier, greville, insertion,
    interpolation, jump, limit, matrix, point, scheme, scheme_named, triplets,
};
use lath_exact::error::{Class, Code, Error};
use lath_exact::parse::{fractions, rows};
use lath_exact::print::Format;
use std::sync::atomic::AtomicBool;

fn core<T: std::fmt::Debug>(result: Result<T, Error>) -> (Core, Option<usize>) {
    let error = result.unwrap_err();
    match error.code() {
        Code::Core(code) => (code, error.index()),
        other => panic!("{other:?}: {error}"),
    }
}

fn own<T: std::fmt::Debug>(result: Result<T, Error>) -> Code {
    result.unwrap_err().code()
}

#[test]
fn knots_are_named_by_their_own_index() {
    let limits = Limits::default();
    let knots = |text: &str| fractions(text).unwrap();
    let blend = |text: &str, degree| core(blending(&knots(text), degree, &limits));
    assert_eq!(blend("0,2,1,3", 2), (Core::K004, Some(2)));
    assert_eq!(blend("0,1,1,1,1,2", 2), (Core::K003, Some(4)));
    assert_eq!(blend("0,1,2", 2), (Core::K001, None));
    assert_eq!(blend("0,1,2,1e301", 2), (Core::K007, Some(3)));
    assert_eq!(core(blending(&[], 0, &limits)), (Core::K001, None));
    assert_eq!(core(greville(&knots("1,0,2"), 1)), (Core::K004, Some(1)));
    let weigh =
        |text: &str, degree, t: &str| core(at(&knots(text), degree, &t.parse().unwrap(), 0, Side::Right, &limits));
    assert_eq!(weigh("0,0,2,1", 1, "0"), (Core::K004, Some(3)));
    assert_eq!(weigh("0,0,1,1", 1, "3/2"), (Core::T002, None));
    assert_eq!(weigh("0,1,1,2", 1, "1"), (Core::K005, Some(1)));
    let answer = at(&knots("0,0,1,1"), 1, &0.into(), 0, Side::Right, &limits).unwrap();
    assert_eq!(core(answer.with_points(rows("0;1;2").unwrap())), (Core::K001, None));
    assert_eq!(core(insertion(&knots("0,0,1,1"), 1, &knots("1/2,2"), &limits)), (Core::T002, Some(1)));
    assert_eq!(core(insertion(&knots("0,0,1,1"), 1, &knots("1"), &limits)).0, Core::K003);
    assert_eq!(core(elevation(&knots("0,1,1,2"), 1, 1, &limits)).0, Core::K005);
}

#[test]
fn an_empty_domain_is_allowed_where_functions_are_asked_for() {
    let limits = Limits::default();
    let answer = blending(&fractions("0,1,3").unwrap(), 1, &limits).unwrap();
    assert_eq!((answer.functions.len(), answer.domain()), (1, None));
    assert_eq!(answer.functions[0].pieces[1].polynomial.to_string(), "(3 − t)/2");
    let answer = blending(&fractions("0,1,1,2").unwrap(), 1, &limits).unwrap();
    assert_eq!(answer.domain(), None);
    // A function all of whose knots but one agree; and degree 0.
    let answer = blending(&fractions("0,0,0,1").unwrap(), 2, &limits).unwrap();
    assert_eq!(answer.functions[0].pieces.len(), 1);
    let answer = blending(&fractions("0,1").unwrap(), 0, &limits).unwrap();
    assert_eq!(answer.sum()[0].polynomial.to_string(), "1");
}

#[test]
fn names_and_conditions_are_read_or_refused() {
    let limits = Limits::default();
    assert_eq!(own("splines".parse::<Basis>()), Code::X003);
    assert_eq!(own("cardinal:1/0".parse::<Basis>()), Code::X002);
    assert_eq!(own(matrix(&Basis::Hermite, 4, &limits)), Code::X004);
    assert_eq!(matrix(&Basis::Hermite, 4, &limits).unwrap_err().class(), Class::Usage);
    assert_eq!(own("xml".parse::<Format>()), Code::X003);
    for name in ["", "degree", "degree:x", "degree:-1", "cubic:1", "mask"] {
        assert_eq!(own(scheme_named(name)), Code::X003, "{name}");
    }
    assert_eq!(core(scheme_named("degree:0")).0, Core::K006);
    assert_eq!(core(scheme_named("mask:1,2,3")).0, Core::S001);
    assert_eq!(own(scheme_named("four-point:1/0")), Code::X002);
    assert_eq!(own("relaxed".parse::<Condition>()), Code::X003);
    assert_eq!(own("clamped:1,a".parse::<Condition>()), Code::X001);
    for text in ["natural", "not-a-knot", "clamped:1,-1/2", "second:0"] {
        assert_eq!(text.parse::<Condition>().unwrap().to_string(), text);
    }
    for text in ["bspline", "bezier", "hermite", "catmull-rom", "cardinal:-1/3"] {
        assert_eq!(text.parse::<Basis>().unwrap().to_string(), text);
    }
    for text in ["bernstein", "power", "hermite", "bspline", "bspline:0,0,1,1"] {
        assert_eq!(text.parse::<Form>().unwrap().to_string(), text);
    }
    assert_eq!(own("monomial".parse::<Form>()), Code::X003);
    let between = |form: Form, a: &str, b: &str, degree| {
        own(change(&form, &Form::Power, degree, (a.parse().unwrap(), b.parse().unwrap()), &limits))
    };
    assert_eq!(between(Form::Bernstein, "1", "1", 2), Code::X006);
    assert_eq!(between(Form::Hermite, "0", "1", 2), Code::X004);
    let span = Form::Span(fractions("0,0,1,2,2").unwrap());
    assert_eq!(between(span.clone(), "1/2", "3/2", 1), Code::X007);
    assert_eq!(between(span, "-1", "0", 1), Code::X007);
}

#[test]
fn interpolation_names_its_faults() {
    let limits = Limits::default();
    let natural = Ends::Open(Condition::Natural, Condition::Natural);
    let through = |points: &str, t: Option<&str>, ends: Ends| {
        let t = t.map(|t| fractions(t).unwrap());
        core(interpolation(&rows(points).unwrap(), t.as_deref(), ends, &limits))
    };
    assert_eq!(through("0", None, natural.clone()).0, Core::P001);
    assert_eq!(through("0;1", Some("0,0"), natural.clone()), (Core::T003, Some(1)));
    assert_eq!(through("0;1", Some("0,1,2"), natural).0, Core::T004);
    assert_eq!(through("0;1", Some("0,1"), Ends::Closed).0, Core::T004);
    let clamped = Ends::Open(Condition::Clamped(fractions("1,2").unwrap()), Condition::Natural);
    assert_eq!(through("0;1", None, clamped).0, Core::P005);
    let ragged = vec![fractions("0,1").unwrap(), fractions("0").unwrap()];
    assert_eq!(core(interpolation(&ragged, None, Ends::Cyclic, &limits)), (Core::P005, Some(1)));
}

#[test]
fn levels_and_indices() {
    let limits = Limits::default();
    let cubic = scheme_named("cubic").unwrap();
    assert_eq!(core(point(&cubic, 2, &7.into(), &limits)).0, Core::S006);
    assert_eq!(core(limit(&cubic, 2, &5.into(), &limits)).0, Core::S006);
    assert_eq!(core(point(&cubic, 1001, &0.into(), &limits)).0, Core::S005);
    assert_eq!(core(jump(&cubic, (3, 0.into()), 2, &limits)).0, Core::S005);
    assert_eq!(core(jump(&cubic, (0, 0.into()), usize::MAX, &limits)).0, Core::S005);
    assert_eq!(core(triplets(1001, &limits)).0, Core::S005);
    assert!(triplets(0, &limits).unwrap().triplets.is_empty());
    let wild = scheme_named("four-point:2").unwrap();
    assert_eq!(core(limit(&wild, 2, &1.into(), &limits)).0, Core::S003);
    assert!(scheme(&wild, &limits).unwrap().limit.is_none());
}

#[test]
fn what_would_not_answer_is_refused() {
    let limits = Limits::default();
    let budget = |result: Result<(), Error>| {
        let error = result.unwrap_err();
        assert_eq!((error.code(), error.class()), (Code::Core(Core::B001), Class::Budget), "{error}");
    };
    let many = |count: i64| -> Vec<lath_exact::Rational> { (0..count).map(Into::into).collect() };
    budget(matrix(&Basis::BSpline, 500, &limits).map(drop));
    budget(matrix(&Basis::Bezier, usize::MAX, &limits).map(drop));
    budget(blending(&many(3000), 100, &limits).map(drop));
    budget(blending(&many(10), usize::MAX, &limits).map(drop));
    budget(at(&many(2100), 1000, &1010.into(), 400, Side::Right, &limits).map(drop));
    budget(insertion(&many(200_000), 3, &many(100_000), &limits).map(drop));
    budget(elevation(&many(100), 3, 1000, &limits).map(drop));
    budget(elevation(&many(100), 3, usize::MAX, &limits).map(drop));
    budget(elevation_bezier(usize::MAX, 1, &limits).map(drop));
    budget(change(&Form::Power, &Form::Bernstein, usize::MAX, (0.into(), 1.into()), &limits).map(drop));
    budget(scheme(&scheme_named("degree:300").unwrap(), &limits).map(drop));
    budget(limit(&scheme_named("degree:900").unwrap(), 1000, &1.into(), &limits).map(drop));
    budget(jump(&scheme_named("degree:300").unwrap(), (0, 0.into()), 1000, &limits).map(drop));
    budget(triplets(60, &limits).map(drop));
    let points: Vec<Vec<lath_exact::Rational>> = many(20_000).into_iter().map(|x| vec![x]).collect();
    let natural = Ends::Open(Condition::Natural, Condition::Natural);
    budget(interpolation(&points, None, natural, &limits).map(drop));
    // Less is refused with a smaller budget.
    let small = Limits { max_points: 1000, ..Limits::default() };
    budget(matrix(&Basis::BSpline, 3, &small).map(drop));
    // An order beyond the degree costs nothing, whatever it is.
    assert!(at(&many(8), 3, &3.into(), usize::MAX, Side::Right, &limits).unwrap().weights.iter().all(|w| *w == 0));
}

#[test]
fn work_can_be_cancelled() {
    let stop = AtomicBool::new(true);
    let limits = Limits { cancel: Some(&stop), ..Limits::default() };
    let error = matrix(&Basis::BSpline, 3, &limits).unwrap_err();
    assert_eq!((error.code(), error.class()), (Code::Core(Core::B002), Class::Cancelled));
}
