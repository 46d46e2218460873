//! Uniform B-splines by matrix: the printed matrices, the same curve as over knots, both ways to the polygon's ends, multiple points.
#![allow(clippy::unwrap_used)] // helpers of tests stop at the first fault, loudly

use lath::basis::bernstein::weights;
use lath::basis::uniform::{MAX_DEGREE, UniformBasis, power_matrix};
use lath::basis::{blossom, bspline};
use lath::curve::{Curve, PolygonEnd, UniformBSpline};
use lath::error::Code;
use lath::knot::{Knots, Side};
use lath::num::Scalar;
use testkit::error_measure::{condition, units};
use testkit::naive;
use testkit::rational::{Rational, ratio};

/// m_ij as the book prints it, row i to the power n − i: (1/n!) C(n,i) Σ_{k=j..n} (n−k)ⁱ (−1)^{k−j} C(n+1, k−j), 0⁰ = 1.
fn printed(n: usize) -> Vec<Vec<Rational>> {
    let factorial: Rational = (1..=n as i64).fold(Rational::one(), |product, k| product * Rational::from(k));
    let entry = |i: usize, j: usize| -> Rational {
        let term = |k: usize| {
            let sign = if (k - j).is_multiple_of(2) { Rational::one() } else { -Rational::one() };
            Rational::from((n - k) as i64).power(i) * sign * naive::binomial(n + 1, k - j)
        };
        naive::binomial(n, i) * (j..=n).map(term).sum::<Rational>() / factorial.clone()
    };
    (0..=n).map(|i| (0..=n).map(|j| entry(i, j)).collect()).collect()
}

#[test]
fn the_power_matrix_is_the_printed_one() {
    let whole = |rows: &[&[i64]], over: i64| -> Vec<Vec<Rational>> {
        rows.iter().map(|row| row.iter().map(|x| ratio(*x, over)).collect()).collect()
    };
    let books = [
        whole(&[&[-1, 1], &[1, 0]], 1),
        whole(&[&[1, -2, 1], &[-2, 2, 0], &[1, 1, 0]], 2),
        whole(&[&[-1, 3, -3, 1], &[3, -6, 3, 0], &[-3, 0, 3, 0], &[1, 4, 1, 0]], 6),
        whole(
            &[&[1, -4, 6, -4, 1], &[-4, 12, -12, 4, 0], &[6, -6, -6, 6, 0], &[-4, -12, 12, 4, 0], &[1, 11, 11, 1, 0]],
            24,
        ),
        whole(
            &[
                &[-1, 5, -10, 10, -5, 1],
                &[5, -20, 30, -20, 5, 0],
                &[-10, 20, 0, -20, 10, 0],
                &[10, 20, -60, 20, 10, 0],
                &[-5, -50, 0, 50, 5, 0],
                &[1, 26, 66, 26, 1, 0],
            ],
            120,
        ),
    ];
    for (degree, book) in (1..).zip(books) {
        assert_eq!(power_matrix::<Rational>(degree).unwrap(), book, "degree {degree}");
    }
    for degree in 0..=MAX_DEGREE {
        assert_eq!(power_matrix::<Rational>(degree).unwrap(), printed(degree), "degree {degree}");
    }
}

/// Some points without a pattern.
fn data(n: usize) -> Vec<i64> {
    (0..n as i64).map(|i| (i * i * 7 + i * 3) % 23 - 11).collect()
}

#[test]
fn on_fractions_it_is_the_bspline_over_uniform_knots() {
    for degree in 0..=MAX_DEGREE {
        let basis = UniformBasis::<Rational>::new(degree).unwrap();
        let points: Vec<[Rational; 1]> = data(degree + 1).into_iter().map(|x| [Rational::from(x)]).collect();
        let knots = Knots::<Rational>::uniform(degree + 1, degree).unwrap();
        let orders = if degree < 12 { degree + 2 } else { 3 };
        for u in [ratio(0, 1), ratio(1, 3), ratio(1, 1), ratio(-5, 4)] {
            let mut by_knots = vec![[Rational::zero()]; orders];
            bspline::jet(&knots, degree, &points, &u, &mut by_knots);
            let mut by_matrix = by_knots.clone();
            let (complement, weight) = weights(&ratio(0, 1), &ratio(1, 1), &u);
            basis.jet(&points, (&complement, &weight), &mut by_matrix);
            assert_eq!(by_matrix, by_knots, "degree {degree} at {u}");
            // The same by powers.
            let matrix = power_matrix::<Rational>(degree).unwrap();
            let powers = (0..=degree).map(|row| u.power(degree - row));
            let row_value = |row: &Vec<Rational>| -> Rational {
                row.iter().zip(&points).map(|(m, [x])| m.clone() * x.clone()).sum()
            };
            let sum: Rational = powers.zip(&matrix).map(|(power, row)| power * row_value(row)).sum();
            assert_eq!(sum, by_knots[0][0], "degree {degree} at {u}");
        }
        let pieces = blossom::span_to_bernstein(&knots, degree, &points);
        assert_eq!(basis.bernstein_points(&points), pieces, "degree {degree}");
        let joint: Rational = basis.joint().iter().zip(&points).map(|(w, [x])| w.clone() * x.clone()).sum();
        assert_eq!(joint, pieces[0][0], "degree {degree}");
    }
}

#[test]
fn on_floats_it_keeps_the_accuracy_of_bsplines() {
    let (mut values, mut derivatives) = (0.0_f64, 0.0_f64);
    let mut shares = 0.0_f64;
    for degree in 0..=MAX_DEGREE {
        let n = degree + 3;
        // Alternating signs for cancellation, sizes from 1 to a million.
        let b: Vec<f64> = data(n).iter().enumerate().map(|(i, x)| *x as f64 / 3.0 * [1.0, -1e6, 7.0][i % 3]).collect();
        let curve = UniformBSpline::new(degree, b.iter().map(|x| [*x])).unwrap();
        let knots: Vec<Rational> = Knots::<Rational>::uniform(n, degree).unwrap().values().to_vec();
        let exact: Vec<Rational> = b.iter().map(|x| Rational::from_f64(*x)).collect();
        let places = [0.0, 1e-9, 0.3, 0.999_999_9, 1.0_f64.next_down(), 1.0, 1.7, 2.25, 3.0_f64.next_down(), 3.0];
        // Exactness takes its time at high degrees: there every third place, another one for each degree.
        let (first, step) = if degree > 12 { (degree % 3, 3) } else { (0, 1) };
        for t in places.into_iter().skip(first).step_by(step) {
            let side = if t == 3.0 { Side::Left } else { Side::Right };
            let mut out = [[0.0]; 3];
            curve.jet_into(t, side, &mut out);
            let at = Rational::from_f64(t);
            for (k, [found]) in out.into_iter().enumerate().take(degree + 1) {
                let wanted = naive::spline(&knots, degree, &exact, k, &at, side);
                let off = units(found, &wanted, &condition(&knots, degree, &exact, k, &at, side));
                let (allowed, worst) = match k {
                    0 => (3.0 * (degree + 1) as f64, &mut values),
                    _ => (10.0 * degree as f64, &mut derivatives),
                };
                assert!(off <= allowed, "degree {degree}, derivative {k} at {t}: {off} u");
                *worst = worst.max(off);
                shares = shares.max(off / allowed);
            }
        }
    }
    println!("worst: values {values} u, derivatives {derivatives} u, {shares} of what is allowed");
    assert!(values > 1.0 && derivatives > 1.0, "a sweep that finds no error measures nothing");
}

#[test]
fn powers_lose_what_the_bernstein_form_keeps() {
    // Why the curve is not evaluated by M: a function that fades out towards u = 1 is there the difference of large powers, and a
    // curve that only its control point holds is lost.
    let u = 0.9;
    let (mut last, mut kept) = (0.0, 0.0_f64);
    for degree in [3, 10, 20, 30] {
        let m = power_matrix::<f64>(degree).unwrap();
        let basis = UniformBasis::<f64>::new(degree).unwrap();
        let knots = Knots::<Rational>::uniform(degree + 1, degree).unwrap();
        let exact = bspline::values(&knots, degree, &Rational::from_f64(u));
        let horner = m.iter().fold(0.0, |sum, row| sum * u + row[0]);
        let mut points = vec![[0.0]; degree + 1];
        points[0] = [1.0];
        let mut found = [[0.0]];
        basis.jet(&points, (&(1.0 - u), &u), &mut found);
        let (by_powers, by_bernstein) = (units(horner, &exact[0], &exact[0]), units(found[0][0], &exact[0], &exact[0]));
        println!("degree {degree}: {by_powers:e} u by powers, {by_bernstein} u in Bernstein form");
        assert!(by_bernstein <= 3.0 * (degree + 1) as f64, "degree {degree}: {by_bernstein}");
        assert!(by_powers > 10.0 * last, "degree {degree}: {by_powers}");
        last = by_powers;
        kept = kept.max(by_bernstein);
    }
    assert!(last > 1e12 && kept > 0.0);
}

#[test]
fn curves_agree_with_those_over_knots_open_and_closed() {
    let points: Vec<[f64; 2]> = data(14).windows(2).map(|pair| [pair[0] as f64 / 3.0, pair[1] as f64 / 7.0]).collect();
    for degree in 0..=9 {
        let closed_of_few = UniformBSpline::closed(degree, &points[..2]).unwrap();
        for curve in [
            UniformBSpline::new(degree, &points).unwrap(),
            UniformBSpline::closed(degree, &points).unwrap(),
            closed_of_few,
        ] {
            let over_knots = curve.to_bspline().unwrap();
            assert_eq!((curve.domain(), curve.breaks()), (over_knots.domain(), over_knots.breaks()));
            assert_eq!((curve.kind(), curve.is_closed()), ("bspline", over_knots.is_closed()));
            for k in 0..=8 * curve.segments() {
                let t = k as f64 / 8.0;
                for side in [Side::Left, Side::Right] {
                    let (mut a, mut b) = ([[0.0; 2]; 3], [[0.0; 2]; 3]);
                    curve.jet_into(t, side, &mut a);
                    over_knots.jet_into(t, side, &mut b);
                    let near = a.iter().flatten().zip(b.iter().flatten()).all(|(a, b)| (a - b).abs() < 2e-14);
                    assert!(near, "degree {degree} at {t} from {side:?}: {a:?}, over knots {b:?}");
                }
            }
        }
    }
}

#[test]
fn joints_of_every_degree() {
    let points: Vec<[f64; 1]> = data(9).iter().map(|x| [*x as f64]).collect();
    let p = |i: usize| points[i][0];
    let curve = |degree| UniformBSpline::new(degree, &points).unwrap();
    assert_eq!(curve(0).joint(2).unwrap(), [p(2)]);
    assert_eq!(curve(1).joint(8).unwrap(), [p(8)]);
    assert_eq!(curve(2).joint(3).unwrap(), [(p(3) + p(4)) / 2.0]);
    let near = |found: [f64; 1], wanted: f64| assert!((found[0] - wanted).abs() < 1e-14, "{found:?}, not {wanted}");
    for i in 0..=6 {
        near(curve(3).joint(i).unwrap(), (p(i) + 4.0 * p(i + 1) + p(i + 2)) / 6.0);
    }
    for i in 0..=4 {
        let sum = p(i) + 26.0 * p(i + 1) + 66.0 * p(i + 2) + 26.0 * p(i + 3) + p(i + 4);
        near(curve(5).joint(i).unwrap(), sum / 120.0);
    }
    let error = curve(3).joint(7).unwrap_err();
    assert_eq!((error.code(), error.index()), (Code::T002, Some(7)));
    let closed = UniformBSpline::closed(3, &points).unwrap();
    assert_eq!((closed.segments(), closed.joint(9).unwrap()), (9, closed.joint(0).unwrap()));
}

#[test]
fn both_ways_to_the_ends_of_the_polygon_for_every_degree() {
    let polygon: Vec<[f64; 2]> = data(40).windows(2).map(|pair| [pair[0] as f64, pair[1] as f64]).collect();
    let (first, last) = (polygon[0], polygon[polygon.len() - 1]);
    let near = |a: [f64; 2], b: [f64; 2]| (0..2).all(|c| (a[c] - b[c]).abs() < 1e-12);
    for degree in 0..=MAX_DEGREE {
        for end in [PolygonEnd::Repeat, PolygonEnd::Phantom] {
            let curve = UniformBSpline::at_polygon(degree, &polygon, end).unwrap();
            let place = format!("degree {degree}, {end:?}");
            let domain = curve.domain();
            assert!(near(curve.eval(domain.start).unwrap(), first), "{place}");
            assert!(near(curve.eval(domain.end).unwrap(), last), "{place}");
            let (mut start, mut finish) = (vec![[0.0; 2]; degree.max(1)], vec![[0.0; 2]; degree.max(1)]);
            curve.jet_into(domain.start, Side::Right, &mut start);
            curve.jet_into(domain.end, Side::Left, &mut finish);
            // Derivatives below the degree, those that are continuous: none at a repeated end, none of even order at a phantom one.
            let step = if end == PolygonEnd::Repeat { 1 } else { 2 };
            for k in (1..degree).filter(|k| k % step == 0) {
                let size = f64::from(1 << k.min(20)) * 1e-11;
                let still = start[k].iter().chain(&finish[k]).all(|x| x.abs() < size);
                assert!(still, "{place}, derivative {k}: {:?} {:?}", start[k], finish[k]);
            }
            if end == PolygonEnd::Phantom && degree >= 3 {
                assert!(start[1].iter().any(|x| x.abs() > 0.01), "{place} starts without a speed");
            }
        }
    }
    // The curve is odd about its end: f(−t) = 2P₀ − f(t), the first segments continued by the mirrored polygon.
    for degree in 1..=9 {
        let mut doubled: Vec<[f64; 2]> =
            polygon.iter().rev().map(|p| core::array::from_fn(|c| 2.0 * first[c] - p[c])).collect();
        if degree % 2 == 1 {
            doubled.pop();
        }
        doubled.extend_from_slice(&polygon);
        let whole = UniformBSpline::new(degree, &doubled).unwrap();
        let half = UniformBSpline::at_polygon(degree, &polygon, PolygonEnd::Phantom).unwrap();
        let middle = whole.domain().end / 2.0;
        for t in [0.25, 1.5, 6.75] {
            let (forth, back) = (whole.eval(middle + t).unwrap(), whole.eval(middle - t).unwrap());
            assert!(near(half.eval(t).unwrap(), forth), "degree {degree} at {t}");
            assert!(near(core::array::from_fn(|c| 2.0 * first[c] - back[c]), forth), "degree {degree} at {t}");
        }
    }
    // By hand: the first segment runs along the first side as uᵖ/p!.
    let repeated = UniformBSpline::at_polygon(3, [[0.0], [6.0], [7.0]], PolygonEnd::Repeat).unwrap();
    assert_eq!(repeated.control_points(), [[0.0], [0.0], [0.0], [6.0], [7.0], [7.0], [7.0]]);
    assert_eq!(repeated.eval(0.5).unwrap(), [0.125]);
    let phantom = UniformBSpline::at_polygon(3, [[0.0], [6.0], [7.0]], PolygonEnd::Phantom).unwrap();
    assert_eq!(phantom.control_points(), [[-6.0], [0.0], [6.0], [7.0], [8.0]]);
    let quartic = UniformBSpline::at_polygon(4, [[0.0], [6.0], [7.0]], PolygonEnd::Phantom).unwrap();
    assert_eq!(quartic.control_points(), [[-6.0], [0.0], [0.0], [6.0], [7.0], [7.0], [8.0]]);
    let square = UniformBSpline::at_polygon(2, [[0.0], [6.0]], PolygonEnd::Phantom).unwrap();
    assert_eq!(square, UniformBSpline::at_polygon(2, [[0.0], [6.0]], PolygonEnd::Repeat).unwrap());
}

#[test]
fn ends_that_cannot_be_reached_are_refused() {
    let fault = |degree, points: &[[f64; 1]], end| {
        let error = UniformBSpline::at_polygon(degree, points, end).unwrap_err();
        (error.code(), error.index())
    };
    let (phantom, repeat) = (PolygonEnd::Phantom, PolygonEnd::Repeat);
    assert_eq!(fault(3, &[[0.0]], phantom), (Code::P001, None));
    assert_eq!(fault(5, &[[0.0], [1.0]], phantom), (Code::P001, None));
    assert_eq!(fault(4, &[[0.0]], phantom), (Code::P001, None));
    assert_eq!(fault(3, &[], phantom), (Code::P001, None));
    assert_eq!(fault(3, &[], repeat), (Code::P001, None));
    assert_eq!(fault(31, &[[0.0], [1.0]], repeat), (Code::K006, None));
    assert_eq!(fault(3, &[[1e300], [-1e300], [0.0]], phantom), (Code::P003, Some(0)));
    assert_eq!(fault(3, &[[0.0], [-1e300], [1e300]], phantom), (Code::P003, Some(2)));
    assert_eq!(fault(3, &[[0.0], [f64::NAN], [0.0]], phantom), (Code::P002, Some(1)));
    // One point given often enough is a curve that stays there.
    let still = UniformBSpline::at_polygon(3, [[5.0]], repeat).unwrap().eval(1.0).unwrap();
    assert!((still[0] - 5.0).abs() < 4e-15, "{still:?}");
    let few = UniformBSpline::new(3, [[0.0], [1.0], [2.0]]).unwrap_err();
    assert_eq!(few.code(), Code::P001);
    assert_eq!(UniformBSpline::<2>::closed(3, [] as [[f64; 2]; 0]).unwrap_err().code(), Code::P001);
    assert_eq!(UniformBSpline::closed(31, [[0.0]]).unwrap_err().code(), Code::K006);
}

#[test]
fn multiple_points_pull_the_curve() {
    let polygon = |times: usize| {
        let corner = std::iter::repeat_n([3.0, 3.0], times);
        let points = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0]].into_iter().chain(corner);
        points.chain([[4.0, 0.0], [5.0, 0.0], [6.0, 0.0]]).collect::<Vec<[f64; 2]>>()
    };
    let top = |times| {
        let curve = UniformBSpline::new(3, polygon(times)).unwrap();
        let steps = 64 * curve.segments();
        let height = |k: usize| curve.eval(k as f64 / 64.0).unwrap()[1];
        (0..=steps).map(height).fold(0.0, |most: f64, y| if y > most { y } else { most })
    };
    // Once 2/3 of the height, twice 23/24 between the joints, three times the point itself.
    assert!((top(1) - 2.0).abs() < 1e-14 && (top(2) - 23.0 / 8.0).abs() < 1e-14, "{} {}", top(1), top(2));
    assert_eq!(top(3), 3.0);
    // Twice: the curve is flat there, its second derivative along the sides' mean is smaller than once.
    let bend = |times, t| UniformBSpline::new(3, polygon(times)).unwrap().jet(t, 2).unwrap()[2][1].abs();
    assert_eq!((bend(1, 2.0), bend(2, 2.5)), (6.0, 3.0));
    // Three times: straight pieces on both sides, and a stop.
    let curve = UniformBSpline::new(3, polygon(3)).unwrap();
    let [point, speed, second]: [[f64; 2]; 3] = curve.jet(3.0, 2).unwrap().try_into().unwrap();
    assert_eq!((point, speed, second), ([3.0, 3.0], [0.0, 0.0], [0.0, 0.0]));
    for t in [2.25, 2.5, 2.75] {
        let [x, y] = curve.eval(t).unwrap();
        assert!((y - 3.0 * (x - 2.0)).abs() < 1e-14, "{x}, {y} is off the line from (2, 0) to (3, 3)");
    }
}
