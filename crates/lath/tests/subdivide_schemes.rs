//! Schemes that are no splines: four points, masks of users, their eigen-analysis, and what is proven about them.

#![allow(clippy::unwrap_used, clippy::panic)] // a failing unwrap is a failing test

use lath::error::{Code, Limits};
use lath::subdivide::{Convergence, Ends, Form, Index, Scheme, Subdivision, Target};
use testkit::rational::{Rational, ratio};

fn fractions(text: &str) -> Vec<Rational> {
    text.split_whitespace().map(|word| word.parse().unwrap()).collect()
}

fn times(a: &[Vec<Rational>], b: &[Vec<Rational>]) -> Vec<Vec<Rational>> {
    let entry = |row: &[Rational], j: usize| row.iter().zip(b).map(|(x, other)| x.clone() * other[j].clone()).sum();
    a.iter().map(|row| (0..b[0].len()).map(|j| entry(row, j)).collect()).collect()
}

fn four_point(n: i64, d: i64) -> Scheme<Rational> {
    Scheme::four_point(&ratio(n, d)).unwrap()
}

#[test]
fn the_four_point_scheme_is_defective() {
    let scheme = four_point(1, 16);
    assert_eq!(scheme.mask(), fractions("-1/16 0 9/16 1 9/16 0 -1/16"));
    let Form::Exact(eigen) = scheme.eigen().unwrap() else { panic!("rational eigenvalues") };
    assert_eq!(eigen.eigenvalues, fractions("1/8 1/4 1/4 1/2 1"));
    assert_eq!(eigen.blocks, [1, 2, 1, 1]);
    assert!(eigen.is_defective());
    assert_eq!(times(&scheme.local_matrix(), &eigen.q), times(&eigen.q, &eigen.jordan));
    let identity: Vec<Vec<Rational>> = (0..5).map(|i| (0..5).map(|j| ratio(i64::from(i == j), 1)).collect()).collect();
    assert_eq!(times(&eigen.q, &eigen.q_inverse), identity);
    assert_eq!(eigen.jordan[1], fractions("0 1/4 1 0 0"));
    // Value, derivative, and no second derivative.
    assert_eq!(scheme.limit_mask(0).unwrap(), fractions("0 0 1 0 0"));
    assert_eq!(scheme.limit_mask(1).unwrap(), fractions("1/12 -8/12 0 8/12 -1/12"));
    assert_eq!(scheme.limit_mask(2).unwrap_err().code(), Code::S003);
    assert_eq!(scheme.smoothness(), Some(1));
}

#[test]
fn the_four_point_scheme_reproduces_cubics() {
    let cubic =
        |x: Rational| ((ratio(2, 1) * x.clone() - ratio(3, 1)) * x.clone() + ratio(1, 2)) * x.clone() - ratio(7, 1);
    let slope = |x: Rational| (ratio(6, 1) * x.clone() - ratio(6, 1)) * x.clone() + ratio(1, 2);
    let points = (0..8).map(|i| [cubic(ratio(i, 1))]);
    let sub = Subdivision::new(four_point(1, 16), points, Ends::Open).unwrap();
    // The first joint belongs to the third point.
    for k in 0..=4 {
        for i in 0..=3 << k {
            let joint = sub.joint(k, &Index::from(i)).unwrap();
            let x = joint.t.clone() + ratio(2, 1);
            assert_eq!(joint.point, [cubic(x.clone())]);
            assert_eq!(joint.tangent, Some([slope(x)]));
            assert_eq!(joint.second, None);
        }
    }
}

#[test]
fn irrational_eigenvalues_are_estimated_and_say_so() {
    // (1 ± √(1 − 16w))/4 and 2w beside 1 and ½: complex for w = 1/8, irrational for w = 1/32.
    for (scheme, expected) in [
        (four_point(1, 8), [[0.25, -0.25], [0.25, 0.0], [0.25, 0.25], [0.5, 0.0], [1.0, 0.0]]),
        (
            four_point(1, 32),
            [
                [0.0625, 0.0],
                [(1.0 - 0.5f64.sqrt()) / 4.0, 0.0],
                [(1.0 + 0.5f64.sqrt()) / 4.0, 0.0],
                [0.5, 0.0],
                [1.0, 0.0],
            ],
        ),
    ] {
        let Form::Numeric(found) = scheme.eigen().unwrap() else { panic!("estimates") };
        assert_eq!(found.len(), 5);
        for want in expected {
            let near = |have: &&[f64; 2]| (have[0] - want[0]).abs() + (have[1] - want[1]).abs() < 1e-9;
            assert!(found.iter().any(|have| near(&have)), "{want:?} in {found:?}");
        }
    }
    let Form::Numeric(found) = Scheme::four_point(&0.0625).unwrap().eigen().unwrap() else { panic!("floats round") };
    assert!((found[4][0] - 1.0).abs() < 1e-9);
    let large = Scheme::<f64>::lane_riesenfeld(33).unwrap();
    assert_eq!(large.eigen().unwrap_err().code(), Code::S002);
}

#[test]
fn convergence_is_proven_or_not() {
    for p in [1, 2, 3, 10, 1000] {
        let scheme = Scheme::<f64>::lane_riesenfeld(p).unwrap();
        assert_eq!(scheme.smoothness(), Some(p - 1));
        if p < 20 {
            assert_eq!(scheme.convergence(), Convergence::Proven { power: 1, norm: 0.5 });
        }
    }
    // The classic range of tensions: 0 < w < 1/8 gives C¹; the proof reaches far into it.
    for (w, smoothness) in [(0.0, Some(0)), (0.03, Some(1)), (1.0 / 16.0, Some(1)), (0.09, Some(1)), (1.0, None)] {
        assert_eq!(Scheme::four_point(&w).unwrap().smoothness(), smoothness, "w = {w}");
    }
    // A mask of degree 2 that only moves the points: never smooth, and not proven.
    let mover = Scheme::from_mask(vec![0.0, 1.0, 1.0, 0.0]).unwrap();
    assert_eq!((mover.convergence(), mover.smoothness()), (Convergence::NotProven, None));
    let sub = Subdivision::new(mover, [[0.0], [1.0], [5.0]], Ends::Open).unwrap();
    assert!(sub.level(5, Target::Level, &Limits::default()).is_ok());
    assert_eq!(sub.level(5, Target::Limit, &Limits::default()).unwrap_err().code(), Code::S003);
    assert_eq!(sub.joint(5, &Index::default()).unwrap_err().code(), Code::S003);
    assert_eq!(sub.distance(5).unwrap_err().code(), Code::S003);
    assert_eq!(sub.levels_for(0.1).unwrap_err().code(), Code::S003);
}

#[test]
fn masks_are_checked() {
    let code = |mask: Vec<f64>| Scheme::from_mask(mask).unwrap_err();
    assert_eq!(code(vec![]).code(), Code::S002);
    assert_eq!(code(vec![1.0, 1.0]).code(), Code::S002);
    assert_eq!(code(vec![0.1; 259]).code(), Code::S002);
    assert_eq!((code(vec![0.5, f64::NAN, 0.5]).code(), code(vec![0.5, f64::NAN, 0.5]).index()), (Code::S002, Some(1)));
    assert_eq!(code(vec![0.5, 1.0, 0.6]).code(), Code::S001);
    assert_eq!(code(vec![0.5, 0.9, 0.5]).code(), Code::S001);
    assert_eq!(Scheme::four_point(&f64::INFINITY).unwrap_err().code(), Code::S002);
    for degree in [0, 1001] {
        assert_eq!(Scheme::<f64>::lane_riesenfeld(degree).unwrap_err().code(), Code::K006);
    }
    // Thirds are no floats, and yet sum to 1 as far as floats can tell; on fractions the sum is exact.
    assert!(Scheme::from_mask(vec![1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0, 1.0 / 3.0]).is_ok());
    assert!(Scheme::from_mask(fractions("1/3 2/3 2/3 1/3")).is_ok());
    assert_eq!(Scheme::from_mask(fractions("1/3 2/3 2/3 333333333333/1000000000000")).unwrap_err().code(), Code::S001);
    // A binomial mask is recognised, whoever gives it.
    let known = Scheme::from_mask(fractions("1/16 5/16 10/16 10/16 5/16 1/16")).unwrap();
    assert!(known.is_spline());
    assert_eq!(known, Scheme::lane_riesenfeld(4).unwrap());
}

#[test]
fn limits_of_a_user_s_mask() {
    // (1/3, 2/3, 2/3, 1/3): corner cutting in thirds. Continuous, and proven so.
    let scheme = Scheme::from_mask(fractions("1/3 2/3 2/3 1/3")).unwrap();
    assert!(scheme.convergence().is_proven());
    let mask = scheme.limit_mask(0).unwrap();
    assert_eq!(mask, fractions("1/2 1/2"));
    // The joint mask is a left eigenvector: the limit of (k + 1, 2i) is that of (k, i).
    let crooked = Scheme::from_mask(fractions("1/2 3/4 1/2 1/4")).unwrap();
    for scheme in [scheme, crooked, four_point(1, 20)] {
        let mask = scheme.limit_mask(0).unwrap();
        assert_eq!(times(std::slice::from_ref(&mask), &scheme.local_matrix()), [mask]);
        let points = (0..9).map(|i| [ratio(i * i % 7, 3)]);
        let sub = Subdivision::new(scheme.clone(), points, Ends::Closed).unwrap();
        for i in 0..18 {
            let here = sub.point(1, Target::Limit, &Index::from(i)).unwrap();
            assert_eq!(here, sub.point(3, Target::Limit, &Index::from(4 * i)).unwrap());
            assert_eq!(here, sub.refined().unwrap().point(0, Target::Limit, &Index::from(i)).unwrap());
        }
    }
}

#[test]
fn long_masks_have_limits_too() {
    // A box of 258 equal numbers: its joint mask falls off far below the rounding of its middle.
    let scheme = Scheme::from_mask(vec![2.0 / 258.0; 258]).unwrap();
    let mask = scheme.limit_mask(0).unwrap();
    assert!((mask.iter().sum::<f64>() - 1.0).abs() < 1e-13);
    assert!((0..128).all(|i| (mask[i] - mask[255 - i]).abs() < 1e-15 && mask[i] > -1e-16));
    let line = (0..300).map(|i| [f64::from(i)]);
    let sub = Subdivision::new(scheme, line, Ends::Open).unwrap();
    let [x] = sub.point(20, Target::Limit, &Index::from(1).shifted_up(20)).unwrap();
    assert!((x - 128.5).abs() < 1e-10, "{x}"); // symmetric weights about the middle of P₁ … P₂₅₆
}

#[test]
fn masks_that_blow_up_are_stopped_before_they_do() {
    let wild = Scheme::from_mask(vec![-50.0, 60.0, 51.0, -59.0]).unwrap();
    let sub = Subdivision::new(wild, [[1.0], [2.0], [0.0], [-1.0]], Ends::Open).unwrap();
    let point = sub.point(60, Target::Level, &Index::from(12345)).unwrap();
    assert!(point[0].is_finite());
    assert_eq!(sub.point(1000, Target::Level, &Index::default()).unwrap_err().code(), Code::P003);
    let four =
        Subdivision::new(Scheme::four_point(&0.0625).unwrap(), (0..6).map(|i| [f64::from(i)]), Ends::Open).unwrap();
    let [x] = four.point(1000, Target::Level, &Index::from(1).shifted_up(999)).unwrap();
    assert!((x - 2.5).abs() < 1e-12);
}
