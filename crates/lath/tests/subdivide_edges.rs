//! The proven distance to the limit, against sampling; degenerate polygons; spheres.

#![allow(clippy::unwrap_used)] // a failing unwrap is a failing test

use lath::error::{Code, Limits};
use lath::num::Bound;
use lath::space::{distance, norm};
use lath::subdivide::{Ends, Index, Scheme, Sphere, Subdivision, Target};

const ENDS: [Ends; 3] = [Ends::Open, Ends::Kept, Ends::Closed];

fn points(count: usize, seed: usize) -> Vec<[f64; 2]> {
    let x = |i: usize| ((i * 7919 + seed * 104729 + 13) % 199) as f64 / 10.0 - 10.0;
    (0..count).map(|i| [x(i), x(3 * i + 70)]).collect()
}

fn schemes() -> Vec<Scheme> {
    let mut all: Vec<Scheme> = (1..=7).map(|p| Scheme::lane_riesenfeld(p).unwrap()).collect();
    all.push(Scheme::four_point(&(1.0 / 16.0)).unwrap());
    all.push(Scheme::four_point(&0.02).unwrap());
    all.push(Scheme::from_mask(vec![1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0, 1.0 / 3.0]).unwrap());
    all.push(Scheme::from_mask(vec![0.5, 0.75, 0.5, 0.25]).unwrap());
    all
}

/// The polyline of a level at a parameter: vertex i belongs to (i − (p − 1)/2)/2ᵏ.
fn polyline(sub: &Subdivision<2>, polygon: &[[f64; 2]], k: usize, t: f64) -> [f64; 2] {
    let x = t * f64::from(1 << k) + (sub.scheme().degree() as f64 - 1.0) / 2.0;
    let (i, u) = (x.floor() as usize, x - x.floor());
    let (a, b) = (polygon[i % polygon.len()], polygon[(i + 1) % polygon.len()]);
    if u == 0.0 { a } else { [a[0] + (b[0] - a[0]) * u, a[1] + (b[1] - a[1]) * u] }
}

#[test]
fn the_proven_distance_holds_wherever_it_is_sampled() {
    let limits = Limits::default();
    for scheme in schemes() {
        let p = scheme.degree();
        let mut tightest: f64 = 0.0;
        for ends in ENDS {
            for (n, seed) in [(p, 1), (p + 1, 2), (p + 4, 3), (p + 9, 4)] {
                let sub = Subdivision::new(scheme.clone(), points(n, seed), ends).unwrap();
                for k in 0..=4 {
                    let claimed = sub.distance(k).unwrap();
                    assert!(claimed.bound().is_proven());
                    let polygon = sub.level(k, Target::Level, &limits).unwrap();
                    let fine = k + 4;
                    let limit = sub.level(fine, Target::Limit, &limits).unwrap();
                    for (i, point) in limit.iter().enumerate() {
                        let t = i as f64 / f64::from(1 << fine);
                        let away = distance(point, &polyline(&sub, &polygon, k, t));
                        assert!(away <= claimed.inside + 1e-12, "{scheme:?} {ends:?} {n} {k} {t}: {away} {claimed:?}");
                        if claimed.inside > 1e-9 {
                            tightest = tightest.max(away / claimed.inside);
                        }
                    }
                    if ends != Ends::Closed {
                        let beyond = p / 2;
                        let (first, last) = (limit[0], limit[limit.len() - 1]);
                        for i in 0..beyond {
                            assert!(distance(&polygon[i], &first) <= claimed.ends + 1e-12);
                            assert!(distance(&polygon[polygon.len() - 1 - i], &last) <= claimed.ends + 1e-12);
                        }
                        if ends == Ends::Kept {
                            assert!(claimed.ends <= 1e-13, "{claimed:?}");
                        }
                    }
                }
            }
        }
        println!("degree {p}: the bound is reached to {tightest:.3}");
    }
}

#[test]
fn the_bound_of_splines_is_reached_by_parabolas() {
    // Constant second differences: the curve lies (p + 1)/24 of them above the vertices, where p is odd.
    for p in [3, 5, 7] {
        let parabola = (0..p as i32 + 6).map(|i| [f64::from(i), f64::from(i * i)]);
        let sub = Subdivision::new(Scheme::lane_riesenfeld(p).unwrap(), parabola, Ends::Open).unwrap();
        let polygon = sub.level(0, Target::Level, &Limits::default()).unwrap();
        let point = sub.point(0, Target::Limit, &Index::from(2)).unwrap();
        let away = distance(&point, &polygon[2 + (p - 1) / 2]);
        let claimed = sub.distance(0).unwrap().inside;
        assert!(away <= claimed && away > claimed * (1.0 - 1e-9), "degree {p}: {away} of {claimed}");
    }
}

#[test]
fn levels_for_a_tolerance_are_enough_and_no_more_than_the_bound_asks() {
    for scheme in schemes() {
        for ends in ENDS {
            let sub = Subdivision::new(scheme.clone(), points(scheme.degree() + 5, 7), ends).unwrap();
            let mut before = 0;
            for exponent in 0..9 {
                let tolerance = libm::pow(10.0, -f64::from(exponent));
                let k = sub.levels_for(tolerance).unwrap();
                assert!(sub.distance(k).unwrap().bound().value() <= tolerance);
                assert!(k == 0 || sub.distance(k - 1).unwrap().bound().value() > tolerance);
                assert!(k >= before);
                before = k;
            }
        }
    }
    let sub = Subdivision::new(Scheme::<f64>::cubic(), points(6, 1), Ends::Open).unwrap();
    for tolerance in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert_eq!(sub.levels_for(tolerance).unwrap_err().code(), Code::Q001);
    }
    // Below the rounding of the ends nothing can be promised.
    assert_eq!(sub.levels_for(1e-30).unwrap_err().code(), Code::S005);
    let still = Subdivision::new(Scheme::<f64>::lane_riesenfeld(1).unwrap(), points(6, 1), Ends::Open).unwrap();
    assert_eq!(still.levels_for(1e-300).unwrap(), 0);
    assert_eq!(still.distance(0).unwrap().bound(), Bound::Proven(0.0));
}

#[test]
fn polygons_of_few_points() {
    let limits = Limits::default();
    for scheme in schemes() {
        let p = scheme.degree();
        for n in 0..=4 {
            for ends in ENDS {
                let made = Subdivision::new(scheme.clone(), points(n, 5), ends);
                let least = if ends == Ends::Open { p } else { 1 };
                let sub = match made {
                    Ok(sub) => sub,
                    Err(error) => {
                        assert!(n < least, "{scheme:?} {ends:?} {n}: {error}");
                        assert_eq!(error.code(), Code::P001);
                        continue;
                    }
                };
                assert!(n >= least);
                for k in [0, 1, 2, 5, 11] {
                    for target in [Target::Level, Target::Limit] {
                        let all = sub.level(k, target, &limits).unwrap();
                        assert_eq!(all.len() as u64, sub.count(k, target).unwrap().to_u64().unwrap());
                        if ends == Ends::Closed {
                            assert_eq!(all.len(), n << k);
                        }
                        assert!(all.iter().flatten().all(|x| x.is_finite() && x.abs() <= 20.0));
                    }
                }
                assert!(sub.joint(1000, &Index::default()).is_ok());
                assert!(sub.distance(3).is_ok());
                // An open polygon of p points, level 1000: still p points.
                if ends == Ends::Open && n == p {
                    assert_eq!(sub.level(1000, Target::Level, &limits).unwrap().len(), p);
                    assert_eq!(sub.level(1000, Target::Limit, &limits).unwrap().len(), 1);
                    let away = norm(&sub.level(1000, Target::Level, &limits).unwrap()[0]);
                    let limit = norm(&sub.point(0, Target::Limit, &Index::default()).unwrap());
                    assert!((away - limit).abs() < 1e-12);
                }
            }
        }
    }
}

#[test]
fn equal_points_stay_where_they_are() {
    for scheme in schemes() {
        for ends in ENDS {
            let sub = Subdivision::new(scheme.clone(), vec![[3.5, -2.0]; scheme.degree() + 2], ends).unwrap();
            for target in [Target::Level, Target::Limit] {
                for point in sub.level(6, target, &Limits::default()).unwrap() {
                    assert!(distance(&point, &[3.5, -2.0]) <= 1e-14, "{scheme:?} {ends:?}: {point:?}");
                }
            }
            assert!(sub.distance(2).unwrap().bound().value() <= 1e-12);
            assert!(sub.levels_for(1e-12).unwrap() <= 1);
        }
    }
}

#[test]
fn coordinates_are_checked() {
    let fault = |x: f64| {
        let error = Subdivision::new(Scheme::cubic(), [[0.0], [1.0], [2.0], [x]], Ends::Open).unwrap_err();
        (error.code(), error.index())
    };
    assert_eq!(fault(f64::NAN), (Code::P002, Some(3)));
    assert_eq!(fault(f64::NEG_INFINITY), (Code::P002, Some(3)));
    assert_eq!(fault(1e301), (Code::P003, Some(3)));
    let huge = Subdivision::new(Scheme::cubic(), [[1e300], [-1e300], [1e300], [-1e300]], Ends::Open).unwrap();
    for i in 0..7 {
        assert!(huge.point(2, Target::Level, &Index::from(i)).unwrap()[0].is_finite());
    }
    let joint = huge.joint(3, &Index::from(4)).unwrap();
    assert!(joint.tangent.unwrap()[0].is_finite() && joint.second.unwrap()[0].is_finite());
}

#[test]
fn the_closed_cubic_of_the_unit_circle() {
    let corners = [[1.5, 0.0], [0.0, 1.5], [-1.5, 0.0], [0.0, -1.5]];
    let sub = Subdivision::new(Scheme::cubic(), corners, Ends::Closed).unwrap();
    let limit = sub.level(1, Target::Limit, &Limits::default()).unwrap();
    assert_eq!(limit.len(), 8);
    for (i, point) in limit.iter().enumerate() {
        let radius = if i % 2 == 0 { 1.0 } else { 33.0 * libm::sqrt(2.0) / 48.0 };
        assert!((norm(point) - radius).abs() < 1e-15, "{point:?}");
    }
}

#[test]
fn spheres_keep_their_points() {
    let centre = [10.0, -3.0, 2.0];
    let on = |x: f64, y: f64, z: f64| {
        let length = norm(&[x, y, z]);
        [centre[0] + 2.5 * x / length, centre[1] + 2.5 * y / length, centre[2] + 2.5 * z / length]
    };
    let given = [on(1.0, 0.2, 0.0), on(0.3, 1.0, 0.4), on(-1.0, 0.5, 0.9), on(0.1, -0.3, 1.0), on(1.0, -1.0, 0.2)];
    for degree in 1..=5 {
        for ends in ENDS {
            let sphere = Sphere::new(centre, 2.5, degree, given, ends).unwrap();
            for k in 0..=6 {
                let all = sphere.level(k, &Limits::default()).unwrap();
                assert_eq!(all.len() as u64, sphere.count(k).unwrap().to_u64().unwrap());
                for (i, point) in all.iter().enumerate() {
                    assert!((distance(point, &centre) - 2.5).abs() < 1e-14);
                    assert_eq!(sphere.point(k, &Index::from(i as u64)).unwrap(), *point, "{degree} {ends:?} {k} {i}");
                }
                let error = sphere.point(k, &Index::from(all.len() as u64)).unwrap_err();
                assert_eq!(error.code(), Code::S006);
            }
        }
    }
}

#[test]
fn arcs_are_halved() {
    // Degree 1 on a circle: 2ᵏ equal arcs between neighbours.
    let circle =
        Sphere::new([0.0, 0.0], 1.0, 1, [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]], Ends::Closed).unwrap();
    let all = circle.level(5, &Limits::default()).unwrap();
    assert_eq!(all.len(), 128);
    for (i, [x, y]) in all.iter().enumerate() {
        let angle = i as f64 * core::f64::consts::PI / 64.0;
        assert!((x - libm::cos(angle)).abs() < 1e-15 && (y - libm::sin(angle)).abs() < 1e-15, "point {i}");
    }
}

#[test]
fn spheres_refuse_what_has_no_answer() {
    let fault = |radius: f64, points: &[[f64; 2]], ends| {
        let error = Sphere::new([0.0, 0.0], radius, 1, points, ends).unwrap_err();
        (error.code(), error.index())
    };
    let (a, b, c) = ([1.0, 0.0], [0.0, 1.0], [-1.0, 0.0]);
    assert_eq!(fault(1.0, &[a, c], Ends::Open), (Code::S007, Some(0)));
    assert_eq!(fault(1.0, &[b, a, c], Ends::Open), (Code::S007, Some(1)));
    assert_eq!(fault(1.0, &[a, b, c], Ends::Closed), (Code::S007, Some(2)));
    assert!(Sphere::new([0.0, 0.0], 1.0, 1, [a, b, c], Ends::Open).is_ok());
    assert_eq!(fault(1.0, &[a, [0.5, 0.0]], Ends::Open), (Code::S008, Some(1)));
    assert_eq!(fault(1.0, &[a, [0.0, 0.0]], Ends::Open), (Code::S008, Some(1)));
    for radius in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert_eq!(fault(radius, &[a], Ends::Open).0, Code::S008);
    }
    assert_eq!(fault(1.0, &[[f64::NAN, 0.0]], Ends::Open), (Code::P002, Some(0)));
    assert_eq!(fault(1.0, &[], Ends::Closed).0, Code::P001);
    let arc = Sphere::new([0.0, 0.0], 1.0, 3, [a, b, c], Ends::Kept).unwrap();
    assert!(arc.level(40, &Limits::default()).unwrap_err().is_budget());
    assert_eq!(arc.level(1001, &Limits::default()).unwrap_err().code(), Code::S005);
    assert!(arc.point(1000, &Index::default()).is_ok());
}

#[test]
fn any_mask_gets_an_answer_or_a_typed_error() {
    // A small generator of its own, so that the cases are the same everywhere.
    let mut state = 0x9e37_79b9_7f4a_7c15u64;
    let mut draw = |range: u64| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) % range
    };
    let limits = Limits { max_points: 20_000, ..Limits::default() };
    let (mut answers, mut refusals) = (0, 0);
    for case in 0..300 {
        let size = [1.0, 1.0, 10.0, 1e150][draw(4) as usize];
        let mut mask: Vec<f64> = (0..3 + draw(9)).map(|_| (draw(2001) as f64 / 1000.0 - 1.0) * size).collect();
        // Whatever the rest, the first two numbers make both sums 1.
        for parity in 0..2 {
            let rest: f64 = mask.iter().skip(parity + 2).step_by(2).sum();
            mask[parity] = 1.0 - rest;
        }
        let scheme = Scheme::from_mask(mask).unwrap();
        let ends = ENDS[draw(3) as usize];
        let n = draw(12) as usize;
        let (level, place) = (draw(14) as usize, draw(1000));
        let Ok(sub) = Subdivision::new(scheme.clone(), points(n, case), ends) else {
            assert!(n < scheme.degree().max(1));
            continue;
        };
        let mut judge = |point: Result<[f64; 2], lath::error::Error>| match point {
            Ok(point) => {
                assert!(point.iter().all(|x| x.is_finite()), "{scheme:?}: {point:?}");
                answers += 1;
            }
            Err(error) => {
                assert!([Code::S003, Code::S006, Code::P003, Code::B001].contains(&error.code()), "{error}");
                refusals += 1;
            }
        };
        for target in [Target::Level, Target::Limit] {
            judge(sub.level(level, target, &limits).map(|all| all[all.len() / 2]));
            judge(sub.point(level, target, &Index::from(place)));
            judge(sub.point(1000, target, &Index::from(place).shifted_up(980)));
        }
        judge(sub.joint(level, &Index::from(place)).map(|joint| joint.tangent.unwrap_or(joint.point)));
        judge(sub.distance(level).map(|distance| [distance.bound().value(), 0.0]));
        judge(scheme.leap(0, &Index::from(place), 1000).map(|leap| [leap.matrix[0][0], 0.0]));
        assert!(scheme.eigen().is_ok_and(|_| true) || size > 1.0);
        let _ = (scheme.smoothness(), sub.levels_for(0.01), sub.refined().is_ok());
    }
    assert!(answers > 500 && refusals > 500, "{answers} answers, {refusals} refusals");
}
