//! Equal, not nearly equal.

use crate::splines::{Draw, Exact, assert_agree, assert_same, multiplicity, sweep, value, witnesses};
use lath::error::Code;
use lath::knot::Side;
use lath::num::Scalar;
use lath::refine::{Spline, make_compatible};
use testkit::naive;
use testkit::rational::{Rational, ratio};

fn is_zero(moved: &[Rational; 1]) -> bool {
    moved[0] == 0
}

#[test]
fn inserting_any_knots_leaves_the_curve_equal() {
    let mut inserted = 0;
    sweep(40, |draw, spline| {
        let mut at = Vec::new();
        for _ in 0..1 + draw.below(6) {
            at.push(draw.parameter(&spline));
            if spline.insert(&at).is_err() {
                at.pop(); // there p + 1 times already
            }
        }
        inserted += at.len();
        let refined = spline.insert(&at).unwrap();
        assert_eq!(refined.points().len(), spline.points().len() + at.len());
        assert_same(&refined, &spline, "insertion");
    });
    assert!(inserted > 500, "{inserted}");
}

#[test]
fn elevation_leaves_the_curve_equal() {
    sweep(24, |draw, spline| {
        let by = 1 + draw.below(3);
        let elevated = spline.elevate(by).unwrap();
        assert_eq!(elevated.degree(), spline.degree() + by);
        assert_same(&elevated, &spline, "elevation");
    });
}

#[test]
fn parts_are_the_curve_on_their_domains() {
    sweep(30, |draw, spline| {
        let (a, b) = (draw.parameter(&spline), draw.parameter(&spline));
        if a < b {
            let part = spline.trim(&a, &b).unwrap();
            assert_eq!(part.knots().domain(), (a.clone(), b.clone()));
            assert_agree(&part, &spline, "part");
            assert_eq!(multiplicity(part.knots().values(), &a), spline.degree() + 1);
            assert_eq!(multiplicity(part.knots().values(), &b), spline.degree() + 1);
        }
        let Ok((left, right)) = spline.split(&a) else {
            let (start, end) = spline.knots().domain();
            assert!(a == start || a == end);
            return;
        };
        assert_eq!((left.knots().domain().1, right.knots().domain().0), (a.clone(), a.clone()));
        assert_agree(&left, &spline, "left part");
        assert_agree(&right, &spline, "right part");
        assert_eq!(left.knots().domain().0, spline.knots().domain().0);
        assert_eq!(right.knots().domain().1, spline.knots().domain().1);
        let clamped = spline.clamp().unwrap();
        assert_same(&clamped, &spline, "clamping");
        assert_eq!(clamped.clamp().unwrap(), clamped);
    });
}

#[test]
fn split_and_joined_is_the_curve_again_with_no_knot_more() {
    let mut rejoined = 0;
    sweep(30, |draw, spline| {
        let spline = spline.clamp().unwrap();
        let t = draw.parameter(&spline);
        let Ok((left, right)) = spline.split(&t) else { return };
        match left.join(&right, &mut is_zero) {
            Ok(joined) => {
                assert_same(&joined, &spline, "joining");
                assert!(joined.points().len() <= spline.points().len());
                rejoined += 1;
            }
            // Only a jump cannot be joined.
            Err(error) => {
                assert_eq!(error.code(), Code::C004);
                assert_eq!(spline.insert(std::slice::from_ref(&t)).unwrap_err().code(), Code::K003);
            }
        }
    });
    assert!(rejoined > 90, "{rejoined}");
}

#[test]
fn what_was_inserted_is_removed_without_a_move() {
    let mut removed = 0;
    sweep(60, |draw, spline| {
        let t = draw.parameter(&spline);
        let (start, end) = spline.knots().domain();
        let Ok(refined) = spline.insert(std::slice::from_ref(&t)) else { return };
        match refined.remove(&t) {
            Ok((coarse, moved)) => {
                assert_eq!(moved, [Rational::zero()], "{spline:?} at {t}");
                assert_same(&coarse, &spline, "removal");
                assert_eq!(coarse.points().len(), spline.points().len());
                removed += 1;
            }
            Err(_) => assert!(t == start || t == end || spline.points().len() < spline.degree() + 1),
        }
    });
    assert!(removed > 200, "{removed}");
}

#[test]
fn a_removal_moves_no_point_of_the_curve_farther_than_it_says() {
    let mut changed = 0;
    sweep(15, |_, spline| {
        for t in spline.knots().breaks() {
            let Ok((coarse, moved)) = spline.remove(&t) else { continue };
            let [bound] = moved.map(|x| x.abs());
            for at in witnesses(&[&spline.knots().breaks()], spline.degree() + 1) {
                let off = (value(&coarse, &at) - value(&spline, &at)).abs();
                assert!(off <= bound, "{off} is above {bound} at {at}: {spline:?}");
            }
            changed += usize::from(bound > 0);
        }
    });
    assert!(changed > 80, "{changed}");
}

#[test]
fn closed_curves_open_close_and_turn() {
    let mut kept = 0;
    for degree in 0..=7 {
        for seed in 0..16 {
            let mut draw = Draw::new(seed * 8 + degree as u64);
            let ring = draw.closed(degree);
            let open = ring.clamp().unwrap();
            assert_same(&open, &ring, "opening");
            match open.close(&mut is_zero) {
                Ok(again) => {
                    assert!(again.is_closed());
                    assert_same(&again, &ring, "closing");
                    kept += usize::from(again.points().len() == ring.points().len());
                }
                Err(error) => assert_eq!(error.code(), Code::C004),
            }
            let t = draw.parameter(&ring);
            let turned = ring.move_seam(&t).unwrap();
            let (start, end) = ring.knots().domain();
            let period = end.clone() - start;
            for at in witnesses(&[&turned.knots().breaks(), std::slice::from_ref(&end)], degree) {
                let back = if at > end { at.clone() - period.clone() } else { at.clone() };
                assert_eq!(value(&turned, &at), value(&ring, &back), "{ring:?} turned to {t}");
            }
        }
    }
    assert!(kept > 30, "{kept}");
}

#[test]
fn reversed_and_reparametrised_curves_answer_at_the_image_of_t() {
    sweep(15, |draw, spline| {
        let back = spline.reverse().unwrap();
        let (start, end) = spline.knots().domain();
        assert_eq!(back.knots().domain(), (start.clone(), end.clone()));
        for t in witnesses(&[&spline.knots().breaks()], spline.degree()) {
            let image = start.clone() + end.clone() - t.clone();
            assert_eq!(value(&back, &image), value(&spline, &t), "{spline:?}");
        }
        assert_eq!(back.reverse().unwrap(), spline);
        let (a, length) = (draw.fraction(), ratio(draw.below(9) as i64 + 1, 7));
        let other = spline.reparametrise(&a, &(a.clone() + length.clone())).unwrap();
        for t in witnesses(&[&spline.knots().breaks()], spline.degree()) {
            let image = a.clone() + (t.clone() - start.clone()) / (end.clone() - start.clone()) * length.clone();
            assert_eq!(value(&other, &image), value(&spline, &t));
        }
    });
}

#[test]
fn compatible_curves_share_their_knots() {
    for degree in 0..=5 {
        for seed in 0..10 {
            let mut draw = Draw::new(seed * 8 + degree as u64);
            let closed = seed % 2 == 1;
            let given: Vec<Exact> = [degree, draw.below(4), draw.below(6)]
                .map(|p| if closed { draw.closed(p) } else { draw.open(p) })
                .into_iter()
                .collect();
            let (start, end) = given[0].knots().domain();
            let all = make_compatible(&given).unwrap();
            for (found, given) in all.iter().zip(&given) {
                assert_eq!(found.knots(), all[0].knots());
                assert_same(found, &given.reparametrise(&start, &end).unwrap(), "compatible");
            }
        }
    }
}

/// The derivative by the recursion over all functions.
fn derivative(spline: &Exact, t: &Rational) -> Rational {
    let open = spline.unroll();
    let b: Vec<Rational> = open.points().iter().map(|[x]| x.clone()).collect();
    naive::spline(open.knots().values(), open.degree(), &b, 1, t, Side::Right)
}

#[test]
fn derivatives_are_those_of_the_recursion() {
    sweep(30, |_, spline| {
        let slope = spline.derivative().unwrap();
        assert_eq!((slope.degree(), slope.is_closed()), (spline.degree().saturating_sub(1), spline.is_closed()));
        assert_eq!(slope.knots().domain(), spline.knots().domain());
        for t in witnesses(&[&spline.knots().breaks()], spline.degree()) {
            assert_eq!(value(&slope, &t), derivative(&spline, &t), "{spline:?} at {t}");
        }
    });
}

#[test]
fn antiderivatives_start_at_zero_do_not_jump_and_have_the_curve_as_slope() {
    sweep(20, |draw, spline| {
        let sum = spline.antiderivative().unwrap();
        let (start, end) = spline.knots().domain();
        assert_eq!((sum.degree(), sum.is_closed()), (spline.degree() + 1, false));
        assert_eq!(value(&sum, &start), 0);
        for t in witnesses(&[&spline.knots().breaks()], spline.degree()) {
            assert_eq!(derivative(&sum, &t), value(&spline, &t), "{spline:?} at {t}");
        }
        for t in spline.knots().breaks().iter().filter(|t| start < **t && **t < end) {
            assert!(multiplicity(sum.knots().values(), t) <= sum.degree());
        }
        let (a, b) = (draw.parameter(&spline), draw.parameter(&spline));
        let at = |t: &Rational| if *t == end { sum.points().last().unwrap()[0].clone() } else { value(&sum, t) };
        assert_eq!(spline.integral(&a, &b).unwrap(), [at(&b) - at(&a)], "from {a} to {b}: {spline:?}");
    });
}

#[test]
fn sums_and_products_are_those_of_the_values() {
    for (p, q) in [(0, 0), (0, 2), (1, 1), (2, 1), (3, 0), (2, 2), (3, 2), (1, 4), (3, 3), (5, 2), (4, 4)] {
        for seed in 0..8 {
            let mut draw = Draw::new(seed * 100 + 10 * p as u64 + q as u64);
            let given = if seed % 4 == 3 { draw.closed(p) } else { draw.open(p) };
            let (start, end) = given.knots().domain();
            let mut factor = if seed % 4 == 3 { draw.closed(q) } else { draw.open(q) };
            factor = factor.reparametrise(&start, &end).unwrap();
            // Breaks in common, too.
            let shared: Vec<Rational> = given.knots().breaks().into_iter().filter(|_| draw.below(2) == 0).collect();
            for t in shared {
                factor = factor.insert(std::slice::from_ref(&t)).unwrap_or(factor);
            }
            let (product, sum) = (given.product(&factor).unwrap(), given.sum(&factor).unwrap());
            assert_eq!((product.degree(), sum.degree()), (p + q, p.max(q)));
            for t in witnesses(&[&given.knots().breaks(), &factor.knots().breaks()], p + q) {
                let (a, b) = (value(&given, &t), value(&factor, &t));
                assert_eq!(value(&product, &t), a.clone() * b.clone(), "{given:?} times {factor:?} at {t}");
                assert_eq!(value(&sum, &t), a + b);
            }
        }
    }
}

#[test]
fn pieces_are_the_curve_and_give_it_back() {
    sweep(30, |_, spline| {
        let pieces = spline.pieces().unwrap();
        assert_eq!(pieces.len(), spline.knots().breaks().len() - 1);
        let again = Spline::from_pieces(&pieces).unwrap();
        assert_same(&again, &spline, "pieces");
        // Taking out what moves nothing leaves no more points than the clamped curve has.
        let mut coarse = again;
        for t in coarse.knots().breaks() {
            while let Some((next, _)) = coarse.remove(&t).ok().filter(|(_, moved)| is_zero(moved)) {
                coarse = next;
            }
        }
        assert_same(&coarse, &spline, "pieces without needless knots");
        assert!(coarse.points().len() <= spline.clamp().unwrap().points().len());
    });
}

#[test]
fn elevated_and_reduced_is_the_curve_again() {
    sweep(24, |draw, spline| {
        let by = 1 + draw.below(2);
        let mut reduced = spline.elevate(by).unwrap();
        for _ in 0..by {
            let (lower, left) = reduced.reduce().unwrap();
            assert!(left.iter().all(is_zero), "{spline:?}");
            reduced = lower;
        }
        assert_same(&reduced, &spline, "reduction");
        let open = if spline.is_closed() { spline } else { spline.clamp().unwrap() };
        assert_eq!(reduced.points().len(), open.points().len());
    });
}

#[test]
fn a_reduction_moves_no_point_of_the_curve_farther_than_it_says() {
    let mut changed = 0;
    sweep(16, |_, spline| {
        let Ok((lower, left)) = spline.reduce() else {
            assert_eq!(spline.degree(), 0);
            return;
        };
        assert_eq!(lower.degree(), spline.degree() - 1);
        let bound = left.iter().map(|[x]| x.abs()).max().unwrap();
        for t in witnesses(&[&spline.knots().breaks()], spline.degree() + 1) {
            let off = (value(&lower, &t) - value(&spline, &t)).abs();
            assert!(off <= bound, "{off} is above {bound} at {t}: {spline:?}");
        }
        changed += usize::from(bound > 0);
    });
    assert!(changed > 90, "{changed}");
}
