//! Any text, any knots: an answer or an error, never a panic.
#![allow(clippy::unwrap_used)] // helpers of tests stop at the first fault, loudly

use lath::knot::Side;
use lath_exact::answer::{
    Basis, Condition, Ends, Form, SplineEnds, at, blending, collocation, elevation, greville, insertion, interpolation,
    scheme, scheme_named,
};
use lath_exact::print::{Answer, Format, Language, render};
use lath_exact::{Polynomial, Rational, parse};
use proptest::prelude::*;

fn fraction() -> impl Strategy<Value = Rational> {
    (-6i64..6, 1i64..4).prop_map(|(n, d)| Rational::new(n, d).unwrap())
}

/// Mostly non-decreasing, with repetitions; now and then not.
fn knots() -> impl Strategy<Value = Vec<Rational>> {
    (prop::collection::vec(fraction(), 0..14), any::<u8>()).prop_map(|(mut knots, order)| {
        if order > 20 {
            knots.sort();
        }
        knots
    })
}

fn printed(answer: &dyn Answer) {
    for format in [Format::Text, Format::Json, Format::Latex, Format::Source(Language::Rust)] {
        assert!(render(answer, format).unwrap().ends_with('\n'));
    }
    assert!(answer.explain(&Default::default()).unwrap().ends_with('\n'));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn any_text_is_read_or_refused(text in "\\PC{0,24}|[-+−0-9./eE ,;:a-z]{0,24}") {
        let _ = parse::fraction(&text);
        let _ = parse::fractions(&text);
        let _ = parse::rows(&text);
        let _ = text.parse::<Basis>();
        let _ = text.parse::<Form>();
        let _ = text.parse::<Condition>();
        let _ = text.parse::<SplineEnds>();
        let _ = text.parse::<Format>();
        if let Ok(named) = scheme_named(&text) {
            prop_assert!(named.degree() >= 1);
        }
    }

    #[test]
    fn what_is_printed_is_read_again(n in any::<i64>(), d in 1i64..i64::MAX) {
        let x = Rational::new(n, d).unwrap();
        prop_assert_eq!(&parse::fraction(&x.to_string()).unwrap(), &x);
        prop_assert_eq!(&parse::fraction(&Polynomial::new(vec![x.clone()]).to_string()).unwrap(), &x);
        prop_assert_eq!(Rational::from_f64(x.to_f64()).unwrap().to_f64(), x.to_f64());
    }

    #[test]
    fn any_knots_are_answered_or_refused(knots in knots(), degree in 0usize..5, t in fraction(), k in 0usize..7) {
        let limits = Default::default();
        for side in [Side::Left, Side::Right] {
            if let Ok(answer) = at(&knots, degree, &t, k, side, &limits) {
                printed(&answer);
            }
        }
        if let Ok(answer) = blending(&knots, degree, &limits) {
            printed(&answer);
        }
        if let Ok(answer) = greville(&knots, degree) {
            printed(&answer);
        }
        if let Ok(answer) = insertion(&knots, degree, &[t.clone(), t], &limits) {
            printed(&answer);
        }
        if let Ok(answer) = elevation(&knots, degree, k % 3, &limits) {
            printed(&answer);
        }
    }

    #[test]
    fn any_points_are_answered_or_refused(points in prop::collection::vec(fraction(), 0..7), t in knots(), degree in 0usize..6) {
        let limits = Default::default();
        let points: Vec<Vec<Rational>> = points.into_iter().map(|x| vec![x]).collect();
        for t in [None, Some(&t[..])] {
            for ends in [Ends::Cyclic, Ends::Anticyclic, Ends::Closed, Ends::Open(Condition::Natural, Condition::NotAKnot)] {
                if let Ok(answer) = interpolation(&points, t, ends, &limits) {
                    printed(&answer);
                }
            }
            for ends in [SplineEnds::NotAKnot, SplineEnds::Natural, SplineEnds::Closed] {
                if let Ok(answer) = collocation(&points, t, degree, ends, &limits) {
                    printed(&answer);
                }
            }
        }
    }

    #[test]
    fn any_mask_is_answered_or_refused(even in prop::collection::vec(fraction(), 1..4), odd in prop::collection::vec(fraction(), 1..3)) {
        // The last of each parity makes the sums 1; the parities alternate as far as both go.
        let close = |mut part: Vec<Rational>| {
            let sum: Rational = part.iter().cloned().sum();
            part.push(Rational::from(1) - sum);
            part
        };
        let (even, odd) = (close(even), close(odd));
        let length = even.len().max(odd.len());
        let zero = Rational::from(0);
        let pick = |part: &[Rational], i: usize| part.get(i).cloned().unwrap_or_else(|| zero.clone());
        let mask: Vec<String> = (0..length).flat_map(|i| [pick(&even, i), pick(&odd, i)]).map(|x| x.to_string()).collect();
        let named = scheme_named(&format!("mask:{}", mask.join(","))).unwrap();
        printed(&scheme(&named, &Default::default()).unwrap());
    }
}
