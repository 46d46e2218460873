//! Derivations word for word: six golden texts in testdata/exact/explain, each read against the theory before it was recorded.
//!
//! `LATH_RECORD=1 cargo test -p lath-exact --test explain` writes them anew, to be read again.
#![allow(clippy::unwrap_used)] // helpers of tests stop at the first fault, loudly

use lath::error::Limits;
use lath::knot::Side;
use lath_exact::answer::{
    Condition, Ends, at, blending, change, elevation_bezier, greville, insertion, interpolation, jump, limit, matrix,
    point, scheme, scheme_named, triplets,
};
use lath_exact::error::Code;
use lath_exact::print::Answer;
use lath_exact::{Rational, parse};
use std::path::Path;

fn golden(name: &str, answer: &dyn Answer) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../testdata/exact/explain").join(format!("{name}.txt"));
    let text = answer.explain(&Default::default()).unwrap();
    if std::env::var_os("LATH_RECORD").is_some() {
        std::fs::write(&path, &text).unwrap();
    }
    let recorded = std::fs::read_to_string(&path).unwrap();
    for (i, (now, then)) in text.lines().zip(recorded.lines()).enumerate() {
        assert_eq!(now, then, "{name}, line {}", i + 1);
    }
    assert_eq!(text, recorded);
}

#[test]
fn weights_at_the_end_of_an_open_quadratic() {
    let knots = parse::fractions("0,0,0,1,2,3,3,3").unwrap();
    golden("at", &at(&knots, 2, &3.into(), 1, Side::Right, &Default::default()).unwrap());
}

#[test]
fn the_matrix_of_the_cubic() {
    golden("matrix", &matrix(&"bspline".parse().unwrap(), 3, &Default::default()).unwrap());
}

#[test]
fn the_cubic_scheme() {
    golden("scheme", &scheme(&scheme_named("cubic").unwrap(), &Default::default()).unwrap());
}

#[test]
fn exercise_4_100() {
    golden("limit", &limit(&scheme_named("cubic").unwrap(), 3, &6.into(), &Default::default()).unwrap());
}

#[test]
fn exercise_4_103() {
    let knots = parse::fractions("-3,-2,-1,0,1,1,1,2,3,4,5,6").unwrap();
    golden("blending", &blending(&knots, 3, &Default::default()).unwrap());
}

#[test]
fn a_natural_and_a_clamped_end() {
    let points = parse::rows("0,0; 1,2; 3,1; 4,-1").unwrap();
    let ends = Ends::Open(Condition::Natural, "clamped:1,0".parse().unwrap());
    let t = parse::fractions("0,1,3,4").unwrap();
    golden("interpolation", &interpolation(&points, Some(&t), ends, &Default::default()).unwrap());
}

#[test]
fn every_derivation_arrives_at_its_answer() {
    let limits = Default::default();
    let knots = parse::fractions("0,0,0,0,1/3,2/3,1,1,1,1").unwrap();
    let half = "1/2".parse().unwrap();
    let points = parse::rows("5,5; 10,10; 20,15; 35,15; 45,10; 50,5").unwrap();
    let weighted = at(&knots, 3, &half, 0, Side::Right, &limits).unwrap().with_points(points).unwrap();
    assert!(weighted.explain(&limits).unwrap().ends_with("With these points it is (55/2, 235/16).\n"));
    // The order of a derivative climbs with the degree; above the degree nothing is left.
    for order in 0..=5 {
        let answer = at(&knots, 3, &half, order, Side::Right, &limits).unwrap();
        let text = answer.explain(&Default::default()).unwrap();
        assert!(text.contains(if order > 3 { "is zero" } else { "So P" }), "{text}");
        let weights = lath_exact::print::render(&answer, lath_exact::print::Format::Text).unwrap();
        let sum = weights.lines().last().unwrap().split(" = ").nth(1).unwrap();
        assert!(order > 3 || text.contains(&format!(" = {sum}.")), "{text}\n{sum}");
    }
    for degree in 0..=6 {
        for basis in ["bspline", "bezier"] {
            let answer = matrix(&basis.parse().unwrap(), degree, &limits).unwrap();
            let text = answer.explain(&Default::default()).unwrap();
            // The derivation's own polynomials are the columns.
            for p in answer.functions() {
                assert!(text.contains(&format!("= {p}\n")), "{p}\n{text}");
            }
        }
    }
    for basis in ["hermite", "catmull-rom", "cardinal:1/2"] {
        assert!(matrix(&basis.parse().unwrap(), 3, &limits).unwrap().explain(&limits).unwrap().contains("D⁻¹ = "));
    }
    let four = scheme(&scheme_named("four-point").unwrap(), &limits).unwrap();
    assert!(four.explain(&limits).unwrap().contains("The second derivative: there is none."));
    let odd = scheme(&scheme_named("four-point:1/32").unwrap(), &limits).unwrap();
    assert!(odd.explain(&limits).unwrap().contains("not all rational"));
    let cubic = scheme_named("cubic").unwrap();
    for (level, index) in [(0, 0), (1, 4), (2, 5), (20, 77)] {
        let answer = point(&cubic, level, &index.into(), &limits).unwrap();
        assert!(
            answer.explain(&Default::default()).unwrap().contains("and sum to 1."),
            "{}",
            answer.explain(&Default::default()).unwrap()
        );
    }
    let leap = jump(&cubic, (1, 1.into()), 5, &limits).unwrap();
    assert!(leap.explain(&limits).unwrap().contains("1 · 2⁴ = 16"));
    assert!(triplets(4, &limits).unwrap().explain(&limits).unwrap().contains("index 16 from index 8"));
    assert!(greville(&knots, 3).unwrap().explain(&limits).unwrap().contains("ξ₁ = (0 + 0 + 1/3)/3 = 1/9"));
    let refined = insertion(&knots, 3, &[half], &limits).unwrap();
    assert!(
        refined.explain(&limits).unwrap().contains("Q₃ = B(1/3, 1/2, 2/3) = (P₂ + P₃)/2"),
        "{}",
        refined.explain(&limits).unwrap()
    );
    assert!(
        elevation_bezier(2, 1, &limits).unwrap().explain(&limits).unwrap().contains("Q₁ = B(0, 0, 1) = (P₀ + 2P₁)/3")
    );
    let unit = (0.into(), 1.into());
    assert!(
        change(&"power".parse().unwrap(), &"hermite".parse().unwrap(), 3, unit, &limits)
            .unwrap()
            .explain(&limits)
            .unwrap()
            .contains("D⁻¹ B")
    );
}

/// A derivation has a budget of its own: there are answers without one.
#[test]
fn what_would_run_on_is_refused_before_it_begins() {
    let refused = |answer: &dyn Answer, max_points: u64| {
        let limits = Limits { max_points, ..Limits::default() };
        assert_eq!(answer.explain(&limits).unwrap_err().code(), Code::Core(lath::error::Code::B001));
        assert!(answer.explain(&Limits { max_points: max_points * 10_000, ..limits }).is_ok());
    };
    let limits = Limits::default();
    let knots: Vec<Rational> = (0..40).map(Rational::from).collect();
    refused(&blending(&knots, 8, &limits).unwrap(), 100_000);
    refused(&matrix(&"bspline".parse().unwrap(), 20, &limits).unwrap(), 10_000);
    refused(&limit(&scheme_named("degree:9").unwrap(), 16, &7.into(), &limits).unwrap(), 10_000);
    refused(&scheme(&scheme_named("degree:9").unwrap(), &limits).unwrap(), 1_000);
    refused(&at(&knots, 8, &20.into(), 0, Side::Right, &limits).unwrap(), 1_000);
    // The weights of degree 100 at level 16 take a moment, the sixteen matrices of the way there would take a minute.
    let far = limit(&scheme_named("degree:100").unwrap(), 16, &5.into(), &limits).unwrap();
    assert_eq!(far.explain(&limits).unwrap_err().code(), Code::Core(lath::error::Code::B001));
}
