//! Subdivision on fractions: every number of the textbooks, and the levels and limits of every degree against oracles that
//! never heard of blossoms.

#![allow(clippy::unwrap_used, clippy::panic)] // a failing unwrap is a failing test

use lath::error::Limits;
use lath::knot::Side;
use lath::subdivide::{Descent, Ends, Form, Index, Scheme, Subdivision, Target, ancestor, descents, groups};
use testkit::naive;
use testkit::rational::{Rational, ratio};

type Points<const D: usize> = Vec<[Rational; D]>;

/// Points that no accident makes simple.
fn points(count: usize) -> Points<2> {
    let x = |i: usize| ratio((7 * i * i + 3 * i) as i64 % 23 - 11, 1 + i as i64 % 5);
    let y = |i: usize| ratio((5 * i * i * i + i) as i64 % 17 - 8, 1 + i as i64 % 3);
    (0..count).map(|i| [x(i), y(i)]).collect()
}

fn fractions(text: &str) -> Vec<Rational> {
    text.split_whitespace().map(|word| word.parse().unwrap()).collect()
}

/// Rows divided by a common denominator.
fn rows(denominator: i64, rows: &[&[i64]]) -> Vec<Vec<Rational>> {
    rows.iter().map(|row| row.iter().map(|x| ratio(*x, denominator)).collect()).collect()
}

fn times(a: &[Vec<Rational>], b: &[Vec<Rational>]) -> Vec<Vec<Rational>> {
    let entry = |row: &[Rational], j: usize| row.iter().zip(b).map(|(x, other)| x.clone() * other[j].clone()).sum();
    a.iter().map(|row| (0..b[0].len()).map(|j| entry(row, j)).collect()).collect()
}

fn apply(a: &[Vec<Rational>], points: &[[Rational; 2]]) -> Points<2> {
    let sum = |row: &[Rational], c: usize| row.iter().zip(points).map(|(w, p)| w.clone() * p[c].clone()).sum();
    a.iter().map(|row| [sum(row, 0), sum(row, 1)]).collect()
}

fn scheme(degree: usize) -> Scheme<Rational> {
    Scheme::lane_riesenfeld(degree).unwrap()
}

fn level<const D: usize>(sub: &Subdivision<D, Rational>, k: usize, target: Target) -> Points<D> {
    sub.level(k, target, &Limits::default()).unwrap()
}

#[test]
fn s1_edges_vertices_and_counts() {
    let given = points(7);
    let sub = Subdivision::new(Scheme::cubic(), given.clone(), Ends::Open).unwrap();
    let found = level(&sub, 1, Target::Level);
    for (i, point) in found.iter().enumerate() {
        let j = i / 2;
        for c in 0..2 {
            let p = |i: usize| given[i][c].clone();
            let expected = if i % 2 == 0 {
                (p(j) + p(j + 1)) / ratio(2, 1)
            } else {
                // The middle of (edge, Pᵢ) and (Pᵢ, edge), as the construction goes.
                let (before, after) = ((p(j) + p(j + 1)) / ratio(2, 1), (p(j + 1) + p(j + 2)) / ratio(2, 1));
                let vertex = ((before + p(j + 1)) / ratio(2, 1) + (after + p(j + 1)) / ratio(2, 1)) / ratio(2, 1);
                assert_eq!(vertex, (p(j) + ratio(6, 1) * p(j + 1) + p(j + 2)) / ratio(8, 1));
                vertex
            };
            assert_eq!(point[c], expected, "point {i}");
        }
    }
    let group_matrix = rows(8, &[&[4, 4, 0, 0], &[1, 6, 1, 0], &[0, 4, 4, 0], &[0, 1, 6, 1], &[0, 0, 4, 4]]);
    assert_eq!(Scheme::<Rational>::cubic().group_matrix(), group_matrix);
    let group = Subdivision::new(Scheme::<Rational>::cubic(), given[..4].to_vec(), Ends::Open).unwrap();
    for (k, count) in [4, 5, 7, 11, 19, 35].into_iter().enumerate() {
        assert_eq!(level(&group, k, Target::Level).len(), count);
        assert_eq!(group.count(k, Target::Level).unwrap(), Index::from(count as u64));
    }
    for n in 3..8u64 {
        let sub = Subdivision::new(Scheme::<Rational>::cubic(), points(n as usize + 1), Ends::Open).unwrap();
        for k in 0..6 {
            assert_eq!(sub.count(k, Target::Level).unwrap().to_u64(), Some((1 << k) * (n - 2) + 3));
            assert_eq!(sub.count(k, Target::Limit).unwrap().to_u64(), Some((1 << k) * (n - 2) + 1));
        }
    }
    assert_eq!(groups(7, 3).collect::<Vec<_>>(), [0..4, 1..5, 2..6, 3..7]);
    assert_eq!(groups(3, 3).count(), 0);
}

#[test]
fn s2_triplets_of_level_four() {
    let table = descents(4, &Limits::default()).unwrap();
    let expected: Vec<Descent> = (0..=8).map(|from| Descent { index: 2 * from, from }).collect();
    assert_eq!(table, expected);
    for k in 1..8 {
        assert_eq!(descents(k, &Limits::default()).unwrap().len(), (1 << (k - 1)) + 1);
    }
    assert!(descents(0, &Limits::default()).unwrap().is_empty());
    assert!(descents(60, &Limits::default()).unwrap_err().is_budget());
    // And the table is true: each triplet is A times the one it is said to come from.
    let sub = Subdivision::new(Scheme::<Rational>::cubic(), points(4), Ends::Open).unwrap();
    let (before, after) = (level(&sub, 3, Target::Level), level(&sub, 4, Target::Level));
    let a = rows(8, &[&[4, 4, 0], &[1, 6, 1], &[0, 4, 4]]);
    assert_eq!(sub.scheme().local_matrix(), a);
    for Descent { index, from } in table {
        let (index, from) = (index as usize, from as usize);
        assert_eq!(after[index..index + 3], apply(&a, &before[from..from + 3]));
    }
}

#[test]
fn s3_powers_of_a_leap_over_levels() {
    let cubic = Scheme::<Rational>::cubic();
    let sub = Subdivision::new(cubic.clone(), points(4), Ends::Open).unwrap();
    let all: Vec<Points<2>> = (0..=5).map(|k| level(&sub, k, Target::Level)).collect();
    for (from_level, from, to_level, index) in
        [(0, 0, 3, 0), (1, 1, 2, 2), (1, 1, 3, 4), (1, 1, 4, 8), (1, 1, 5, 16), (2, 1, 5, 8), (3, 3, 3, 3)]
    {
        let leap = cubic.leap(from_level, &Index::from(from), to_level).unwrap();
        assert_eq!((leap.power, leap.index.to_u64()), (to_level - from_level, Some(index)));
        let (from, to) = (from as usize, index as usize);
        let landed = apply(&leap.matrix, &all[from_level][from..from + 3]);
        assert_eq!(landed, all[to_level][to..to + 3]);
    }
    let up = ancestor(5, &Index::from(16));
    assert_eq!((up.level, up.index.to_u64(), up.power), (1, Some(1), 4));
    assert_eq!(ancestor(3, &Index::default()).level, 0);
    assert_eq!(ancestor(2, &Index::from(16)).index.to_u64(), Some(4));
}

#[test]
fn s4_eigenvectors_of_the_cubic_scheme() {
    let cubic = Scheme::<Rational>::cubic();
    let Form::Exact(eigen) = cubic.eigen().unwrap() else { panic!("rational eigenvalues") };
    assert_eq!(eigen.eigenvalues, fractions("1/4 1/2 1"));
    assert_eq!(eigen.q, [fractions("1 -1 1"), fractions("-1/2 0 1"), fractions("1 1 1")]);
    assert_eq!(eigen.q_inverse, [fractions("1/3 -2/3 1/3"), fractions("-1/2 0 1/2"), fractions("1/6 2/3 1/6")]);
    assert!(!eigen.is_defective());
    assert_eq!(eigen.jordan, rows(4, &[&[1, 0, 0], &[0, 2, 0], &[0, 0, 4]]));
    // Aᵏ = Q Λᵏ Q⁻¹, which tends to three rows (1, 4, 1)/6.
    for k in [1, 2, 7, 40] {
        let power = cubic.leap(0, &Index::default(), k).unwrap().matrix;
        let mut diagonal = eigen.jordan.clone();
        (0..3).for_each(|i| diagonal[i][i] = eigen.eigenvalues[i].power(k));
        assert_eq!(power, times(&times(&eigen.q, &diagonal), &eigen.q_inverse));
        if k == 40 {
            for row in power {
                for (x, limit) in row.iter().zip(fractions("1/6 2/3 1/6")) {
                    assert!((x.clone() - limit).abs() < ratio(1, 1 << 38));
                }
            }
        }
    }
    assert_eq!(cubic.limit_mask(0).unwrap(), fractions("1/6 4/6 1/6"));
    assert_eq!(cubic.limit_mask(1).unwrap(), fractions("-1/2 0 1/2"));
    assert_eq!(cubic.limit_mask(2).unwrap(), fractions("1 -2 1"));
    assert!(cubic.limit_mask(3).is_err());
}

#[test]
fn s4_joints_of_one_group() {
    let cubic = Scheme::<Rational>::cubic();
    for (k, i, weights) in [
        (0, 0, "1/6 4/6 1/6 0"),
        (0, 1, "0 1/6 4/6 1/6"),
        (1, 1, "1/48 23/48 23/48 1/48"),
        (3, 6, "1/384 121/384 235/384 27/384"),
    ] {
        assert_eq!(cubic.group_weights(k, Target::Limit, &Index::from(i)).unwrap(), fractions(weights), "({k}, {i})");
    }
    // By triplets: the mask on level k, and derivatives as 2ᵏ and 4ᵏ times the masks there.
    let given = points(4);
    let sub = Subdivision::new(cubic, given, Ends::Open).unwrap();
    for k in 0..6 {
        let polygon = level(&sub, k, Target::Level);
        for i in 0..=1 << k {
            let joint = sub.joint(k, &Index::from(i as u64)).unwrap();
            assert_eq!(joint.t, ratio(i as i64, 1 << k));
            for c in 0..2 {
                let p = |s: usize| polygon[i + s][c].clone();
                assert_eq!(joint.point[c], (p(0) + ratio(4, 1) * p(1) + p(2)) / ratio(6, 1));
                assert_eq!(joint.tangent.as_ref().unwrap()[c], ratio(1 << k, 2) * (p(2) - p(0)));
                assert_eq!(
                    joint.second.as_ref().unwrap()[c],
                    ratio(1 << (2 * k), 1) * (p(0) - ratio(2, 1) * p(1) + p(2))
                );
            }
        }
    }
}

#[test]
fn s5_masks_matrices_and_eigenvalues_of_every_degree() {
    assert_eq!(Scheme::<Rational>::chaikin().local_matrix(), rows(4, &[&[3, 1], &[1, 3]]));
    let degree_five =
        rows(32, &[&[6, 20, 6, 0, 0], &[1, 15, 15, 1, 0], &[0, 6, 20, 6, 0], &[0, 1, 15, 15, 1], &[0, 0, 6, 20, 6]]);
    assert_eq!(scheme(5).local_matrix(), degree_five);
    for p in 1..=9 {
        let lane = scheme(p);
        let mask: Vec<Rational> = (0..=p + 1).map(|i| naive::binomial(p + 1, i) / ratio(1 << p, 1)).collect();
        assert_eq!(lane.mask(), mask);
        let Form::Exact(eigen) = lane.eigen().unwrap() else { panic!("degree {p}") };
        let expected: Vec<Rational> = (0..p).rev().map(|j| ratio(1, 1 << j)).collect();
        assert_eq!(eigen.eigenvalues, expected, "degree {p}");
        assert_eq!(times(&lane.local_matrix(), &eigen.q), times(&eigen.q, &eigen.jordan));
        let identity: Vec<Vec<Rational>> =
            (0..p).map(|i| (0..p).map(|j| ratio(i64::from(i == j), 1)).collect()).collect();
        assert_eq!(times(&eigen.q, &eigen.q_inverse), identity);
        assert!(eigen.q[p - 1].iter().all(|x| *x == 1), "columns end in 1");
        // The left eigenvectors are the limit masks.
        assert_eq!(eigen.q_inverse[p - 1], lane.limit_mask(0).unwrap());
        for order in 1..p {
            let (row, mask) = (&eigen.q_inverse[p - 1 - order], lane.limit_mask(order).unwrap());
            let place = mask.iter().position(|x| *x != 0).unwrap();
            let factor = mask[place].clone() / row[place].clone();
            assert!(row.iter().zip(&mask).all(|(x, y)| x.clone() * factor.clone() == *y), "degree {p}, order {order}");
        }
        assert!(lane.limit_mask(p).is_err());
    }
    // Chaikin's cutting of corners.
    let given = points(5);
    let sub = Subdivision::new(Scheme::chaikin(), given.clone(), Ends::Open).unwrap();
    let cut = level(&sub, 1, Target::Level);
    assert_eq!(cut.len(), 8);
    for i in 0..4 {
        for c in 0..2 {
            let (a, b) = (given[i][c].clone(), given[i + 1][c].clone());
            assert_eq!(cut[2 * i][c], (ratio(3, 1) * a.clone() + b.clone()) / ratio(4, 1));
            assert_eq!(cut[2 * i + 1][c], (a + ratio(3, 1) * b) / ratio(4, 1));
        }
    }
}

/// The uniform knots −p, …, whose domain starts at 0.
fn uniform(functions: usize, p: usize) -> Vec<Rational> {
    (0..functions + p + 1).map(|i| ratio(i as i64 - p as i64, 1)).collect()
}

/// Value and two derivatives of the oracle's spline.
fn oracle(knots: &[Rational], p: usize, b: &[Rational], t: &Rational) -> [Option<Rational>; 3] {
    let side = naive::default_side(knots, p, t);
    [0, 1, 2].map(|order| (order < p || order == 0).then(|| naive::spline(knots, p, b, order, t, side)))
}

#[test]
fn joints_are_the_curve_with_its_derivatives() {
    let mut compared = 0;
    for p in 1..=9 {
        let b: Vec<Rational> = points(p + 1).into_iter().map(|[x, _]| x).collect();
        let sub = Subdivision::new(scheme(p), b.iter().map(|x| [x.clone()]), Ends::Open).unwrap();
        let knots = uniform(p + 1, p);
        let expected: Vec<_> = (0..=64).map(|i| oracle(&knots, p, &b, &ratio(i, 64))).collect();
        for k in 0..=6 {
            for i in 0..=1 << k {
                let joint = sub.joint(k, &Index::from(i)).unwrap();
                let [point, tangent, second] = &expected[(i as usize) << (6 - k)];
                assert_eq!(Some(&joint.point[0]), point.as_ref(), "degree {p}, ({k}, {i})");
                assert_eq!(joint.tangent.map(|[x]| x), *tangent, "degree {p}, ({k}, {i})");
                assert_eq!(joint.second.map(|[x]| x), *second, "degree {p}, ({k}, {i})");
                compared += 1;
            }
        }
    }
    assert_eq!(compared, 9 * (127 + 7));
}

#[test]
fn closed_and_kept_limits_are_the_curve() {
    for p in 1..=5 {
        for n in 1..=6 {
            let b: Vec<Rational> = points(n).into_iter().map(|[_, y]| y).collect();
            for ends in [Ends::Closed, Ends::Kept] {
                let sub = Subdivision::new(scheme(p), b.iter().map(|x| [x.clone()]), ends).unwrap();
                let whole: Vec<Rational> = match ends {
                    Ends::Closed => (0..n + p).map(|i| b[i % n].clone()).collect(),
                    _ => {
                        let (first, last) = (vec![b[0].clone(); p - 1], vec![b[n - 1].clone(); p - 1]);
                        [first, b.clone(), last].concat()
                    }
                };
                let knots = uniform(whole.len(), p);
                let found = level(&sub, 2, Target::Limit);
                let spans = whole.len() - p;
                assert_eq!(found.len(), if ends == Ends::Closed { 4 * n } else { 4 * spans + 1 });
                for (i, [x]) in found.iter().enumerate() {
                    let t = ratio(i as i64, 4);
                    if spans == 0 {
                        assert_eq!(*x, b[0]); // kept ends of one point
                        continue;
                    }
                    let expected = naive::spline(&knots, p, &whole, 0, &t, naive::default_side(&knots, p, &t));
                    assert_eq!(*x, expected, "degree {p}, {n} points, {ends:?}, t = {t}");
                }
                if ends == Ends::Kept {
                    assert_eq!((&found[0][0], &found[found.len() - 1][0]), (&b[0], &b[n - 1]));
                }
            }
        }
    }
}

/// Schemes of every kind, on fractions.
fn schemes() -> Vec<Scheme<Rational>> {
    let mut all: Vec<Scheme<Rational>> = (1..=7).map(scheme).collect();
    all.push(Scheme::four_point(&ratio(1, 16)).unwrap());
    all.push(Scheme::four_point(&ratio(1, 12)).unwrap());
    all.push(Scheme::from_mask(fractions("1/3 2/3 2/3 1/3")).unwrap());
    all.push(Scheme::from_mask(fractions("1/2 3/4 1/2 1/4")).unwrap()); // crooked
    all
}

#[test]
fn every_level_is_what_passes_make_of_it() {
    for scheme in schemes() {
        for ends in [Ends::Open, Ends::Kept, Ends::Closed] {
            let p = scheme.degree();
            for n in [1, 2, p, p + 3] {
                if ends == Ends::Open && n < p {
                    continue;
                }
                let sub = Subdivision::new(scheme.clone(), points(n), ends).unwrap();
                let mut by_passes = sub.clone();
                for k in 0..=4 {
                    assert_eq!(
                        level(&sub, k, Target::Level),
                        by_passes.control_points(),
                        "{scheme:?} {ends:?} {n} {k}"
                    );
                    by_passes = by_passes.refined().unwrap();
                }
            }
        }
    }
}

#[test]
fn several_leaps_are_what_passes_make_of_them() {
    let line: Vec<[Rational; 1]> = points(6).into_iter().map(|[x, _]| [x]).collect();
    for ends in [Ends::Open, Ends::Closed] {
        let sub = Subdivision::new(Scheme::four_point(&ratio(1, 16)).unwrap(), line.clone(), ends).unwrap();
        let mut by_passes = sub.clone();
        (0..11).for_each(|_| by_passes = by_passes.refined().unwrap());
        assert_eq!(level(&sub, 11, Target::Level), by_passes.control_points());
        // And the limit interpolates: the point of level 0 with index i + 2 belongs to t = i.
        assert_eq!(sub.point(11, Target::Limit, &Index::from(1 << 11)).unwrap(), line[3]);
        // Every point of level 11 lies on the limit, two vertices further along.
        let limit = level(&sub, 11, Target::Limit);
        assert!(limit.iter().zip(&by_passes.control_points()[2..]).all(|(a, b)| a == b));
    }
}

#[test]
fn the_jump_is_what_a_walk_down_the_bits_makes_of_it() {
    for scheme in schemes() {
        let p = scheme.degree();
        let given = points(p + 4);
        let sub = Subdivision::new(scheme.clone(), given.clone(), Ends::Open).unwrap();
        for (k, index) in [
            (60, "123456789"),
            (60, "4611686018427387903"),
            (33, "8589934593"),
            (41, "0"),
            (75, "151115727451828646838272"),
        ] {
            let index: Index = index.parse().unwrap();
            let q = index.shifted_down(k).to_u64().unwrap() as usize;
            let mut window = given[q..(q + p + 1).min(given.len())].to_vec();
            for place in (0..k).rev() {
                let finer = Subdivision::new(scheme.clone(), window, Ends::Open).unwrap().refined().unwrap();
                let from = usize::from(index.bit(place));
                let points = finer.control_points();
                window = points[from..(from + p + 1).min(points.len())].to_vec();
                if window.len() < p {
                    break;
                }
            }
            assert_eq!(sub.point(k, Target::Level, &index).unwrap(), window[0], "{scheme:?} {k}:{index}");
        }
    }
}

#[test]
fn the_limit_at_level_1000_is_the_curve() {
    let digits = "9".repeat(300);
    let index: Index = digits.parse().unwrap();
    let t = digits.parse::<Rational>().unwrap() / ratio(2, 1).power(1000);
    for p in 1..=6 {
        let b: Vec<Rational> = points(p + 2).into_iter().map(|[x, _]| x).collect();
        let sub = Subdivision::new(scheme(p), b.iter().map(|x| [x.clone()]), Ends::Open).unwrap();
        let [x] = sub.point(1000, Target::Limit, &index).unwrap();
        assert_eq!(x, naive::spline(&uniform(p + 2, p), p, &b, 0, &t, Side::Right), "degree {p}");
    }
}
