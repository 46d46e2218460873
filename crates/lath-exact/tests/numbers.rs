//! The numbers of the textbooks, digit by digit.
#![allow(clippy::unwrap_used)] // helpers of tests stop at the first fault, loudly

use lath::knot::Side;
use lath::subdivide::Index;
use lath_exact::answer::{
    Basis, Condition, Ends, Form, Spectrum, at, blending, change, interpolation, jump, limit, matrix, point, scheme,
    scheme_named, triplets,
};
use lath_exact::print::{Format, render};
use lath_exact::{Matrix, Polynomial, Rational, parse};

fn q(text: &str) -> Rational {
    text.parse().unwrap()
}

fn qs(text: &str) -> Vec<Rational> {
    parse::fractions(text).unwrap()
}

/// 1/denominator times rows of integers, `"1 4 1; 0 2 0"`.
fn over(denominator: i64, rows: &str) -> Matrix {
    let rows = parse::rows(rows).unwrap();
    let factor = Rational::new(1, denominator).unwrap();
    Matrix::from_rows(rows).unwrap().scaled(&factor)
}

fn basis(basis: &str, degree: usize) -> Matrix {
    matrix(&basis.parse().unwrap(), degree, &Default::default()).unwrap().matrix
}

fn index(i: u64) -> Index {
    Index::from(i)
}

#[test]
fn s2_triplets() {
    let answer = triplets(4, &Default::default()).unwrap();
    let pairs: Vec<(u64, u64)> = answer.triplets.iter().map(|d| (d.index, d.from)).collect();
    assert_eq!(pairs, [(0, 0), (2, 1), (4, 2), (6, 3), (8, 4), (10, 5), (12, 6), (14, 7), (16, 8)]);
    for level in 1..=10 {
        assert_eq!(triplets(level, &Default::default()).unwrap().triplets.len(), (1 << (level - 1)) + 1);
    }
    let cubic = scheme(&scheme_named("cubic").unwrap(), &Default::default()).unwrap();
    assert_eq!(cubic.matrix, over(8, "4 4 0; 1 6 1; 0 4 4"));
    assert_eq!(cubic.group_matrix, over(8, "4 4 0 0; 1 6 1 0; 0 4 4 0; 0 1 6 1; 0 0 4 4"));
}

#[test]
fn s3_the_jump() {
    let cubic = scheme_named("cubic").unwrap();
    let a = over(8, "4 4 0; 1 6 1; 0 4 4");
    let leap = |from, i, to| jump(&cubic, (from, index(i)), to, &Default::default()).unwrap();
    let third = leap(0, 0, 3);
    assert_eq!(third.matrix, a.product(&a).unwrap().product(&a).unwrap());
    for (to, lands) in [(2, 2), (3, 4), (4, 8), (5, 16)] {
        let leap = leap(1, 1, to);
        assert_eq!((leap.power, &leap.to), (to - 1, &(to, index(lands))));
    }
    // At level 1000, where indices leave every integer type: still exact, and the weights sum to 1.
    let far = jump(&cubic, (0, index(1)), 1000, &Default::default()).unwrap();
    assert_eq!(far.to.1, index(1).shifted_up(1000));
    for row in far.matrix.rows() {
        assert_eq!(row.iter().cloned().sum::<Rational>(), 1);
    }
    let middle = index(1).shifted_up(999);
    let half = limit(&cubic, 1000, &middle, &Default::default()).unwrap();
    assert_eq!((half.parameter, half.weights), (q("1/2"), qs("1/48,23/48,23/48,1/48")));
}

#[test]
fn s4_the_limit() {
    let cubic = scheme(&scheme_named("cubic").unwrap(), &Default::default()).unwrap();
    let Spectrum::Exact(a) = &cubic.spectrum else { panic!("rational") };
    assert_eq!(a.eigenvalues, qs("1/4,1/2,1"));
    assert_eq!(a.q, Matrix::from_rows(parse::rows("1 -1 1; -1/2 0 1; 1 1 1").unwrap()).unwrap());
    assert_eq!(a.q_inverse, over(6, "2 -4 2; -3 0 3; 1 4 1"));
    assert!(!a.is_defective());
    assert_eq!(cubic.limit, Some(qs("1/6,4/6,1/6")));
    assert_eq!(cubic.tangent, Some(qs("-1/2,0,1/2")));
    assert_eq!(cubic.second, Some(qs("1,-2,1")));
    let checks = [
        (0, 0, "1/6,4/6,1/6,0"),
        (0, 1, "0,1/6,4/6,1/6"),
        (1, 1, "1/48,23/48,23/48,1/48"),
        (3, 6, "1/384,121/384,235/384,27/384"),
    ];
    for (level, i, weights) in checks {
        let answer = limit(&cubic.scheme, level, &index(i), &Default::default()).unwrap();
        assert_eq!(answer.weights, qs(weights), "({level}, {i})");
    }
}

#[test]
fn s5_every_degree() {
    let chaikin = scheme(&scheme_named("chaikin").unwrap(), &Default::default()).unwrap();
    assert_eq!(chaikin.matrix, over(4, "3 1; 1 3"));
    let quintic = scheme(&scheme_named("degree:5").unwrap(), &Default::default()).unwrap();
    let rows = "6 20 6 0 0; 1 15 15 1 0; 0 6 20 6 0; 0 1 15 15 1; 0 0 6 20 6";
    assert_eq!(quintic.matrix, over(32, rows));
    for degree in 1..=12 {
        let answer = scheme(&scheme_named(&format!("degree:{degree}")).unwrap(), &Default::default()).unwrap();
        let Spectrum::Exact(a) = &answer.spectrum else { panic!("degree {degree}") };
        let halves: Vec<Rational> = (0..degree).rev().map(|j| q("1/2").power(j)).collect();
        assert_eq!(a.eigenvalues, halves, "degree {degree}");
        let product = a.q.product(&a.jordan).unwrap().product(&a.q_inverse).unwrap();
        assert_eq!(product, answer.matrix, "degree {degree}");
        // The masks are what they promise: 1 on constants, slope 1 on lines, 2 on parabolas.
        let moment = |mask: &[Rational], k: usize| -> Rational {
            mask.iter().enumerate().map(|(j, w)| w.clone() * Rational::from(j as i64).power(k)).sum()
        };
        assert_eq!(moment(answer.limit.as_ref().unwrap(), 0), 1);
        assert_eq!((answer.tangent.is_some(), answer.second.is_some()), (degree > 1, degree > 2));
        if let Some(tangent) = &answer.tangent {
            assert_eq!((moment(tangent, 0), moment(tangent, 1)), (q("0"), q("1")));
        }
        if let Some(second) = &answer.second {
            assert_eq!((moment(second, 0), moment(second, 1), moment(second, 2)), (q("0"), q("0"), q("2")));
        }
    }
    let four = scheme(&scheme_named("four-point").unwrap(), &Default::default()).unwrap();
    let Spectrum::Exact(a) = &four.spectrum else { panic!("rational") };
    assert_eq!(a.eigenvalues, qs("1/8,1/4,1/4,1/2,1"));
    assert_eq!(a.blocks, [1, 2, 1, 1]);
    assert!(a.is_defective() && four.second.is_none());
    assert_eq!(a.q.product(&a.jordan).unwrap().product(&a.q_inverse).unwrap(), four.matrix);
    assert_eq!(a.q.product(&a.q_inverse).unwrap(), Matrix::identity(5));
    assert_eq!(four.tangent, Some(qs("1/12,-8/12,0,8/12,-1/12")));
}

#[test]
fn s6_uniform_matrices() {
    assert_eq!(basis("bspline", 1), over(1, "-1 1; 1 0"));
    assert_eq!(basis("bspline", 2), over(2, "1 -2 1; -2 2 0; 1 1 0"));
    assert_eq!(basis("bspline", 3), over(6, "-1 3 -3 1; 3 -6 3 0; -3 0 3 0; 1 4 1 0"));
    let four = "1 -4 6 -4 1; -4 12 -12 4 0; 6 -6 -6 6 0; -4 -12 12 4 0; 1 11 11 1 0";
    assert_eq!(basis("bspline", 4), over(24, four));
    let five =
        "-1 5 -10 10 -5 1; 5 -20 30 -20 5 0; -10 20 0 -20 10 0; 10 20 -60 20 10 0; -5 -50 0 50 5 0; 1 26 66 26 1 0";
    assert_eq!(basis("bspline", 5), over(120, five));
}

/// The curve's own polynomials of exercise 4.102, as combinations of functions.
#[test]
fn s9_open_quadratic_tangents() {
    let answer = blending(&qs("0,0,0,1,2,3,3,3"), 2, &Default::default()).unwrap();
    let expected = [
        (0, vec![(0, "-2,2"), (1, "2,-3"), (2, "0,1")]),
        (1, vec![(1, "-2,1"), (2, "3,-2"), (3, "-1,1")]),
        (2, vec![(2, "-3,1"), (3, "7,-3"), (4, "-4,2")]),
    ];
    for (from, functions) in expected {
        for (i, coefficients) in functions {
            let piece = answer.functions[i].piece(&Rational::from(from), Side::Right).unwrap();
            assert_eq!(piece.polynomial.derivative(), Polynomial::new(qs(coefficients)), "N{i} on {from}");
        }
    }
}

#[test]
fn s9_triple_knot() {
    let answer = blending(&qs("-3,-2,-1,0,1,1,1,2,3,4,5,6"), 3, &Default::default()).unwrap();
    assert_eq!((answer.functions.len(), answer.domain()), (8, Some((q("0"), q("3")))));
    let text = render(&answer, Format::Text).unwrap();
    let printed = [
        "(1 − t)³/6                     0 ≤ t < 1",
        "(11t³ − 15t² − 3t + 7)/12      0 ≤ t < 1",
        "(−7t³ + 3t² + 3t + 1)/4        0 ≤ t < 1",
        "N₃(t) = t³                             0 ≤ t < 1",
        "(2 − t)³                       1 ≤ t < 2",
        "N₄(t) = (7t³ − 39t² + 69t − 37)/4      1 ≤ t < 2",
        "N₅(t) = (−11t³ + 51t² − 69t + 29)/12   1 ≤ t < 2",
        "N₆(t) = (t − 1)³/6                     1 ≤ t < 2",
        "(3 − t)³/4                     2 ≤ t < 3",
        "(7t³ − 57t² + 147t − 115)/12   2 ≤ t < 3",
        "(−3t³ + 21t² − 45t + 31)/6     2 ≤ t < 3",
        "N₇(t) = (t − 2)³/6                     2 ≤ t < 3",
    ];
    for line in printed {
        assert!(text.contains(line), "{line}\n{text}");
    }
    // Shifted knots shift the functions.
    let shift = q("7/3");
    let moved: Vec<Rational> = answer.knots.iter().map(|knot| knot + &shift).collect();
    let moved = blending(&moved, 3, &Default::default()).unwrap();
    for (a, b) in answer.functions.iter().zip(&moved.functions) {
        for (a, b) in a.pieces.iter().zip(&b.pieces) {
            assert_eq!(a.polynomial, b.polynomial.shifted(&shift));
        }
    }
}

#[test]
fn s10_hermite_and_the_normalised_system() {
    assert_eq!(basis("hermite", 3), over(1, "2 -2 1 1; -3 3 -2 -1; 0 0 1 0; 1 0 0 0"));
    let functions = matrix(&Basis::Hermite, 3, &Default::default()).unwrap().functions();
    let expected = ["2t³ − 3t² + 1", "−2t³ + 3t²", "t³ − 2t² + t", "t³ − t²"];
    assert_eq!(functions.iter().map(ToString::to_string).collect::<Vec<_>>(), expected);
    // On an interval of length h, the third and fourth carry h: here from tangents to the power form on [0, 2].
    let answer = change(&Form::Hermite, &Form::Power, 3, (q("0"), q("2")), &Default::default()).unwrap();
    assert_eq!(answer.matrix, over(4, "4 0 0 0; 0 0 4 0; -3 3 -4 -2; 1 -1 1 1"));
    // The inner rows 1 4 1 with 3 (P_{k+2} − P_k), clamped: four points, slopes 0 at both ends.
    let zero = Ends::Open(Condition::Clamped(qs("0")), Condition::Clamped(qs("0")));
    let answer = interpolation(&parse::rows("0;1;3;4").unwrap(), None, zero, &Default::default()).unwrap();
    assert_eq!(answer.tangents, parse::rows("0;9/5;9/5;0").unwrap());
}

#[test]
fn s11_bezier() {
    assert_eq!(basis("bezier", 3), over(1, "-1 3 -3 1; 3 -6 3 0; -3 3 0 0; 1 0 0 0"));
    assert_eq!(basis("catmull-rom", 3), over(2, "-1 3 -3 1; 2 -5 4 -1; -1 0 1 0; 0 2 0 0"));
    assert_eq!(basis("cardinal:0", 3), basis("catmull-rom", 3));
}

#[test]
fn s7_and_s8_joints_of_a_closed_cubic() {
    // The closed cubic whose joints lie on the unit circle has the control points (3/2, 0) … in turn.
    let circle = parse::rows("1,0; 0,1; -1,0; 0,-1").unwrap();
    let answer = interpolation(&circle, None, Ends::Closed, &Default::default()).unwrap();
    assert_eq!(answer.control_points, parse::rows("0,-3/2; 3/2,0; 0,3/2; -3/2,0").unwrap());
    let n = answer.control_points.len();
    for i in 0..n {
        for c in 0..2 {
            let p = |j: usize| answer.control_points[j % n][c].clone();
            let joint = (p(i) + Rational::from(4) * p(i + 1) + p(i + 2)) / Rational::from(6);
            assert_eq!(joint, circle[i][c]);
        }
    }
    // The segment from (1, 0) to (0, 1) is ¼(2t³ − 6t² + 4, −2t³ + 6t).
    let segment = basis("bspline", 3).product(&Matrix::from_rows(answer.control_points).unwrap()).unwrap();
    assert_eq!(segment, over(4, "2 -2; -6 0; 0 6; 4 0"));
}

#[test]
fn points_that_another_library_gets_wrong() {
    let points = parse::rows("5,5; 10,10; 20,15; 35,15; 45,10; 50,5").unwrap();
    let cases = [("1/3,2/3", "55/2,235/16"), ("33/100,66/100", "4459803800/161321193,2370082930/161321193")];
    for (inner, value) in cases {
        let knots = qs(&format!("0,0,0,0,{inner},1,1,1,1"));
        let answer = at(&knots, 3, &q("1/2"), 0, Side::Right, &Default::default()).unwrap();
        assert_eq!(answer.with_points(points.clone()).unwrap().value().unwrap(), qs(value));
    }
}

#[test]
fn a_point_of_a_level_and_its_parameter() {
    let cubic = scheme_named("cubic").unwrap();
    let answer = point(&cubic, 2, &index(3), &Default::default()).unwrap();
    assert_eq!((answer.weights, answer.parameter), (qs("1/64,31/64,31/64,1/64"), q("3/4")));
    // All points of a level, against the group matrix applied level by level.
    let mut all = Matrix::identity(4);
    for level in 0..4usize {
        for (i, row) in all.rows().iter().enumerate() {
            let answer = point(&cubic, level, &index(i as u64), &Default::default()).unwrap();
            assert_eq!(&answer.weights, row, "level {level}, index {i}");
        }
        let count = all.rows().len();
        let next = Matrix::from_fn(2 * count - 3, count, |i, j| cubic.weight(i, j));
        all = next.product(&all).unwrap();
    }
}
