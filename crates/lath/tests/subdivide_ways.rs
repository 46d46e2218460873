//! Slice, stream, range and jump on floats: the same bits, as accurate as an evaluation, within their budgets.

#![allow(clippy::unwrap_used)] // a failing unwrap is a failing test

use core::ops::ControlFlow;
use lath::curve::Curve;
use lath::error::{Code, Limits};
use lath::subdivide::{Ends, Index, Scheme, Subdivision, Target};
use std::sync::atomic::AtomicBool;
use testkit::error_measure::units;
use testkit::naive;
use testkit::rational::{Rational, ratio};

const TARGETS: [Target; 2] = [Target::Level, Target::Limit];
const ENDS: [Ends; 3] = [Ends::Open, Ends::Kept, Ends::Closed];

/// Points with signs, sizes and zeros of both signs.
fn points(count: usize) -> Vec<[f64; 3]> {
    let x = |i: usize| ((i * 7919 + 13) % 101) as f64 / 7.0 - 6.5;
    (0..count).map(|i| [x(i), if i % 3 == 0 { -0.0 } else { -1e-3 * x(i + 50) }, 1e6 + x(2 * i)]).collect()
}

fn schemes() -> Vec<Scheme> {
    let mut all: Vec<Scheme> = [1, 2, 3, 4, 5, 6, 9, 12].iter().map(|p| Scheme::lane_riesenfeld(*p).unwrap()).collect();
    all.push(Scheme::four_point(&(1.0 / 16.0)).unwrap());
    all.push(Scheme::from_mask(vec![0.5, 0.75, 0.5, 0.25]).unwrap());
    all
}

fn bits<const D: usize>(points: &[[f64; D]]) -> Vec<u64> {
    points.iter().flatten().map(|x| x.to_bits()).collect()
}

fn streamed(sub: &Subdivision<3>, k: usize, target: Target) -> Vec<[f64; 3]> {
    let mut all = Vec::new();
    sub.stream(k, target, &Limits::default(), &mut |block| {
        assert!(!block.is_empty() && block.len() <= 1024);
        all.extend_from_slice(block);
        ControlFlow::Continue(())
    })
    .unwrap();
    all
}

#[test]
fn slice_stream_range_and_jump_give_the_same_bits() {
    for scheme in schemes() {
        for ends in ENDS {
            for n in [scheme.degree(), scheme.degree() + 2] {
                let sub = Subdivision::new(scheme.clone(), points(n), ends).unwrap();
                for target in TARGETS {
                    for k in [0, 1, 2, 3, 5, 6, 9, 10, 11, 12] {
                        let name = format!("degree {}, {ends:?}, {n} points, {target:?}, level {k}", scheme.degree());
                        let slice = sub.level(k, target, &Limits::default()).unwrap();
                        assert_eq!(bits(&slice), bits(&streamed(&sub, k, target)), "{name}");
                        let count = slice.len();
                        assert_eq!(sub.count(k, target).unwrap().to_u64(), Some(count as u64));
                        for i in [0, 1, 2, count / 3, count / 2, count.saturating_sub(3), count - 1] {
                            if i >= count {
                                continue;
                            }
                            let point = sub.point(k, target, &Index::from(i as u64)).unwrap();
                            assert_eq!(bits(&[point]), bits(&slice[i..=i]), "{name}, index {i}");
                            let size = (count - i).min(40);
                            let mut range = Vec::new();
                            sub.range(
                                k,
                                target,
                                &Index::from(i as u64),
                                size as u64,
                                &Limits::default(),
                                &mut |block| {
                                    range.extend_from_slice(block);
                                    ControlFlow::Continue(())
                                },
                            )
                            .unwrap();
                            assert_eq!(bits(&range), bits(&slice[i..i + size]), "{name}, from {i}");
                        }
                    }
                }
            }
        }
    }
}

#[test]
fn higher_levels_give_the_same_bits_too() {
    for scheme in [Scheme::cubic(), Scheme::four_point(&(1.0 / 16.0)).unwrap()] {
        let sub = Subdivision::new(scheme, points(6), Ends::Open).unwrap();
        let slice = sub.level(15, Target::Level, &Limits::default()).unwrap();
        assert_eq!(bits(&slice), bits(&streamed(&sub, 15, Target::Level)));
        for i in (0..slice.len()).step_by(997) {
            let point = sub.point(15, Target::Level, &Index::from(i as u64)).unwrap();
            assert_eq!(bits(&[point]), bits(&slice[i..=i]), "index {i}");
        }
        // A range where no whole level can be: across the boundary of two segments at level 70.
        let start = Index::from(1).shifted_up(70).minus(&Index::from(3)).unwrap();
        let mut range = Vec::new();
        sub.range(70, Target::Level, &start, 6, &Limits::default(), &mut |block| {
            range.extend_from_slice(block);
            ControlFlow::Continue(())
        })
        .unwrap();
        for (offset, point) in range.iter().enumerate() {
            let i = start.plus(&Index::from(offset as u64));
            assert_eq!(bits(&[sub.point(70, Target::Level, &i).unwrap()]), bits(&[*point]), "index {i}");
        }
    }
}

#[test]
fn padding_with_zero_coordinates_changes_no_bit() {
    let narrow = Subdivision::new(Scheme::<f64>::cubic(), points(5), Ends::Closed).unwrap();
    let wide = points(5).into_iter().map(|[x, y, z]| [x, y, z, 0.0]);
    let wide = Subdivision::new(Scheme::<f64>::cubic(), wide, Ends::Closed).unwrap();
    let limits = Limits::default();
    let wide: Vec<[f64; 3]> =
        wide.level(7, Target::Level, &limits).unwrap().into_iter().map(|[x, y, z, _]| [x, y, z]).collect();
    assert_eq!(bits(&narrow.level(7, Target::Level, &limits).unwrap()), bits(&wide));
}

#[test]
fn the_error_is_that_of_an_evaluation_at_every_level() {
    let mut worst = Vec::new();
    for p in (1..=12).chain([20]) {
        let (float, exact) =
            (Scheme::<f64>::lane_riesenfeld(p).unwrap(), Scheme::<Rational>::lane_riesenfeld(p).unwrap());
        let b: Vec<f64> = (0..=p).map(|i| ((i * i * 37 + 11) % 64) as f64 / 3.0 - 10.0).collect();
        let sub = Subdivision::new(float, b.iter().map(|x| [*x]), Ends::Open).unwrap();
        let mut most: f64 = 0.0;
        for (k, steps) in [
            (1, 1u64),
            (2, 1),
            (3, 1),
            (4, 1),
            (5, 3),
            (6, 5),
            (7, 9),
            (8, 23),
            (13, 1009),
            (20, 131071),
            (31, 276524237),
        ] {
            for target in TARGETS {
                for i in (0..1u64 << k).step_by(steps as usize).take(12).chain([(1 << k) - 1]) {
                    let index = Index::from(i);
                    let weights = exact.group_weights(k, target, &index).unwrap();
                    let terms = weights.iter().zip(&b).map(|(w, x)| w.clone() * Rational::from_f64(*x));
                    let value: Rational = terms.clone().sum();
                    let condition: Rational = terms.map(|term| term.abs()).sum();
                    let [found] = sub.point(k, target, &index).unwrap();
                    most = most.max(units(found, &value, &condition));
                }
            }
        }
        worst.push((p, most));
    }
    println!("degree, E: {worst:?}");
    for (p, most) in worst {
        assert!(most <= 3.0 * (p + 1) as f64, "degree {p}: E = {most}");
    }
}

#[test]
fn the_jump_to_level_1000_is_the_curve_to_the_last_bits() {
    let uniform =
        |n: usize, p: usize| -> Vec<Rational> { (0..n + p + 1).map(|i| ratio(i as i64 - p as i64, 1)).collect() };
    let digits = "1234567890".repeat(30); // 300 digits
    for (k, index) in [(60, "123456789"), (1000, digits.as_str())] {
        let t = index.parse::<Rational>().unwrap() / ratio(2, 1).power(k);
        let index: Index = index.parse().unwrap();
        for p in 1..=7 {
            let b: Vec<f64> = (0..p + 4).map(|i| ((i * i * 29 + 5) % 32) as f64 / 7.0 - 2.0).collect();
            let exact: Vec<Rational> = b.iter().map(|x| Rational::from_f64(*x)).collect();
            let sub =
                Subdivision::new(Scheme::lane_riesenfeld(p).unwrap(), b.iter().map(|x| [*x]), Ends::Open).unwrap();
            let knots = uniform(b.len(), p);
            let side = lath::knot::Side::Right;
            let value = naive::spline(&knots, p, &exact, 0, &t, side);
            let condition: Rational =
                (0..b.len()).map(|i| exact[i].abs() * naive::bspline(&knots, p, i, &t, side)).sum();
            // The points of so high a level are the curve, but for p halves of its last steps.
            for target in TARGETS {
                let [found] = sub.point(k, target, &index).unwrap();
                let error = units(found, &value, &condition);
                assert!(error <= 3.0 * (p + 1) as f64, "degree {p}, level {k}, {target:?}: E = {error}");
            }
            let [curve] = sub.curve().unwrap().eval(t.to_f64()).unwrap();
            let [found] = sub.point(k, Target::Limit, &index).unwrap();
            assert!((curve - found).abs() <= 16.0 * f64::EPSILON * (1.0 + found.abs()), "degree {p}, level {k}");
        }
    }
}

#[test]
fn derivatives_at_high_levels_are_not_rounding() {
    let b = [[1.0], [4.0], [-2.0], [3.0], [3.0]];
    let sub = Subdivision::new(Scheme::cubic(), b, Ends::Open).unwrap();
    let curve = sub.curve().unwrap();
    let index = Index::from(3).shifted_up(498); // t = 3/4 at level 500
    let joint = sub.joint(500, &index).unwrap();
    let jet = curve.jet(0.75, 2).unwrap();
    assert_eq!(joint.t, 0.75);
    for (found, expected) in [(joint.point, jet[0]), (joint.tangent.unwrap(), jet[1]), (joint.second.unwrap(), jet[2])]
    {
        assert!((found[0] - expected[0]).abs() <= 1e-14, "{found:?} {expected:?}");
    }
}

#[test]
fn curves_of_the_limit_agree_with_its_points() {
    for p in 1..=6 {
        for ends in ENDS {
            let sub = Subdivision::new(Scheme::lane_riesenfeld(p).unwrap(), points(p + 2), ends).unwrap();
            let curve = sub.curve().unwrap();
            assert_eq!(curve.domain().end, sub.spans() as f64);
            for (i, point) in sub.level(4, Target::Limit, &Limits::default()).unwrap().iter().enumerate() {
                let other = curve.eval(i as f64 / 16.0).unwrap();
                for c in 0..3 {
                    assert!((point[c] - other[c]).abs() <= 1e-15 * (8.0 + other[c].abs()) * (p + 1) as f64);
                }
            }
        }
    }
    let one_joint = Subdivision::new(Scheme::cubic(), points(3), Ends::Open).unwrap();
    assert_eq!(one_joint.curve().unwrap_err().code(), Code::P001);
    let other = Subdivision::new(Scheme::four_point(&0.0625).unwrap(), points(6), Ends::Open).unwrap();
    assert_eq!(other.curve().unwrap_err().code(), Code::S004);
}

#[test]
fn budgets_are_kept_before_anything_is_allocated() {
    let sub = Subdivision::new(Scheme::<f64>::cubic(), points(100), Ends::Closed).unwrap();
    for k in [30, 62, 63, 64, 999, 1000] {
        assert!(sub.level(k, Target::Level, &Limits::default()).unwrap_err().is_budget(), "level {k}");
        let mut sink = |_: &[[f64; 3]]| ControlFlow::Continue(());
        assert!(sub.stream(k, Target::Limit, &Limits::default(), &mut sink).unwrap_err().is_budget());
    }
    let limits = Limits { max_bytes: 24 * 100, ..Limits::default() };
    assert!(sub.level(0, Target::Level, &limits).is_ok());
    assert!(sub.level(1, Target::Level, &limits).unwrap_err().is_budget());
    // A stream counts points only.
    let mut count = 0;
    sub.stream(1, Target::Level, &limits, &mut |block| {
        count += block.len();
        ControlFlow::Continue(())
    })
    .unwrap();
    assert_eq!(count, 200);
    assert_eq!(sub.level(1001, Target::Level, &limits).unwrap_err().code(), Code::S005);
    let cancelled = AtomicBool::new(true);
    let limits = Limits { cancel: Some(&cancelled), ..Limits::default() };
    assert!(sub.level(3, Target::Level, &limits).unwrap_err().is_cancelled());
    let mut buffer = vec![[0.0; 3]; 7];
    let error = sub.level_into(1, Target::Level, &Limits::default(), &mut buffer).unwrap_err();
    assert_eq!(error.code(), Code::P005);
}

#[test]
fn a_sink_may_end_the_stream() {
    for scheme in [Scheme::cubic(), Scheme::four_point(&0.0625).unwrap()] {
        let sub = Subdivision::new(scheme, points(100), Ends::Closed).unwrap();
        let mut blocks = 0;
        let ended = sub.stream(24, Target::Level, &Limits::default(), &mut |_| {
            blocks += 1;
            if blocks == 3 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        });
        assert_eq!((ended, blocks), (Ok(()), 3));
    }
}

#[test]
fn indices_beyond_the_level_are_refused() {
    let sub = Subdivision::new(Scheme::<f64>::cubic(), points(4), Ends::Open).unwrap();
    for (k, target, last) in
        [(0, Target::Level, 3), (0, Target::Limit, 1), (4, Target::Level, 18), (4, Target::Limit, 16)]
    {
        assert!(sub.point(k, target, &Index::from(last)).is_ok());
        assert_eq!(sub.point(k, target, &Index::from(last + 1)).unwrap_err().code(), Code::S006);
    }
    let beyond = Index::from(1).shifted_up(1000).plus(&Index::from(3));
    assert_eq!(sub.point(1000, Target::Level, &beyond).unwrap_err().code(), Code::S006);
    assert!(sub.point(1000, Target::Level, &beyond.minus(&Index::from(1)).unwrap()).is_ok());
    assert_eq!(sub.point(1001, Target::Level, &Index::default()).unwrap_err().code(), Code::S005);
}
