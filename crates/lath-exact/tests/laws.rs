//! Theorems, on random knots of every multiplicity pattern; the oracle is the plain recursion over all functions.
#![allow(clippy::unwrap_used, clippy::panic)] // helpers of tests stop at the first fault, loudly

use lath::knot::{Knots, Side};
use lath::num::Scalar;
use lath_exact::answer::{
    Condition, Ends, Form, SplineEnds, at, blending, change, collocation, elevation, elevation_bezier, greville,
    insertion, interpolation, matrix,
};
use lath_exact::{Matrix, Polynomial, Rational, parse};
use testkit::naive;
use testkit::rational::Rational as Oracle;

/// A plain generator: the same numbers in every run.
struct Random(u64);

impl Random {
    fn below(&mut self, n: u64) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) % n
    }

    fn fraction(&mut self) -> Rational {
        Rational::new(self.below(41) as i64 - 20, self.below(9) as i64 + 1).unwrap()
    }

    /// Knots with these multiplicities, at increasing places.
    fn knots(&mut self, multiplicities: &[usize]) -> Vec<Rational> {
        let mut t = self.fraction();
        let mut knots = Vec::new();
        for count in multiplicities {
            t += Rational::new(self.below(12) as i64 + 1, self.below(5) as i64 + 1).unwrap();
            knots.extend(std::iter::repeat_n(t.clone(), *count));
        }
        knots
    }
}

/// Every pattern of three inner multiplicities up to degree + 1; the ends alternate between clamped and loose.
fn patterns(degree: usize) -> Vec<Vec<usize>> {
    let m = degree + 1;
    let mut all = Vec::new();
    for (turn, code) in (0..m * m * m).enumerate() {
        let inner = [code % m + 1, code / m % m + 1, code / (m * m) + 1];
        let mut pattern = if turn % 2 == 0 { vec![m] } else { vec![1; m] };
        pattern.extend(inner);
        pattern.extend(if turn % 3 == 0 { vec![1; m] } else { vec![m] });
        all.push(pattern);
    }
    all
}

fn oracle(x: &Rational) -> Oracle {
    x.to_string().parse().unwrap()
}

fn is_equal(x: &Rational, y: &Oracle) -> bool {
    x.to_string() == y.to_string()
}

/// The k-th derivative of what is left or right of t, zero beyond the support.
fn derivative(function: &lath_exact::answer::Function, t: &Rational, k: usize, side: Side) -> Rational {
    let zero = Polynomial::default();
    let mut p = function.piece(t, side).map_or(zero, |piece| piece.polynomial.clone());
    for _ in 0..k {
        p = p.derivative();
    }
    p.eval(t)
}

#[test]
fn functions_sum_to_one_and_are_as_smooth_as_multiplicity_leaves() {
    let mut random = Random(1);
    let mut count = 0;
    for degree in 0..=6 {
        for pattern in patterns(degree) {
            let knots = random.knots(&pattern);
            let answer = blending(&knots, degree, &Default::default()).unwrap();
            let (from, to) = answer.domain().unwrap();
            for piece in answer.sum().iter().filter(|piece| from <= piece.from && piece.to <= to) {
                assert_eq!(piece.polynomial, Polynomial::new(vec![Rational::one()]), "{pattern:?} of degree {degree}");
            }
            for (knot, m) in answer.multiplicities() {
                // C to the power p − m: derivatives 0 … p − m agree, and the next one does not for some function.
                let smooth = (degree + 1).saturating_sub(m);
                let jump = |f: &lath_exact::answer::Function, k: usize| {
                    derivative(f, &knot, k, Side::Left) != derivative(f, &knot, k, Side::Right)
                };
                for f in &answer.functions {
                    assert!((0..smooth).all(|k| !jump(f, k)), "N{} at {knot}, {pattern:?}", f.index);
                }
                assert!(answer.functions.iter().any(|f| jump(f, smooth)), "{knot} in {pattern:?} of degree {degree}");
            }
            count += 1;
        }
    }
    assert_eq!(count, (1..=7).map(|m: i32| m.pow(3)).sum::<i32>());
}

#[test]
fn functions_are_those_of_the_plain_recursion() {
    let mut random = Random(2);
    for degree in 0..=6 {
        for pattern in patterns(degree).into_iter().step_by(1 + degree) {
            let knots = random.knots(&pattern);
            let answer = blending(&knots, degree, &Default::default()).unwrap();
            let plain: Vec<Oracle> = knots.iter().map(oracle).collect();
            for pair in knots.windows(2).filter(|pair| pair[0] < pair[1]) {
                let inside = (&pair[0] * &Rational::from(2) + pair[1].clone()) / Rational::from(3);
                for (t, side) in [(&pair[0], Side::Right), (&inside, Side::Right), (&pair[1], Side::Left)] {
                    for k in [0, 1, degree] {
                        let row = naive::bspline_row(&plain, degree, k, &oracle(t), side);
                        for (f, expected) in answer.functions.iter().zip(&row) {
                            let value = derivative(f, t, k, side);
                            assert!(is_equal(&value, expected), "N{} at {t}: {value}, not {expected}", f.index);
                        }
                    }
                }
            }
        }
    }
}

#[test]
fn weights_are_the_functions_at_the_parameter() {
    let mut random = Random(3);
    for degree in 0..=5 {
        for pattern in patterns(degree).into_iter().step_by(7) {
            let knots = random.knots(&pattern);
            let functions = blending(&knots, degree, &Default::default()).unwrap().functions;
            let valid = Knots::new(knots.clone(), degree).unwrap();
            let (from, to) = valid.domain();
            for part in 0..=6 {
                let t = &from + &(&(&to - &from) * &Rational::new(part, 6).unwrap());
                for k in 0..=degree + 2 {
                    let answer = at(&knots, degree, &t, k, Side::Right, &Default::default()).unwrap();
                    assert_eq!(answer.side == Side::Left, t == to);
                    assert_eq!(answer.weights.len(), degree + 1);
                    for f in &functions {
                        let place = f.index.checked_sub(answer.first);
                        let weight = place.and_then(|j| answer.weights.get(j)).cloned().unwrap_or_else(Rational::zero);
                        assert_eq!(weight, derivative(f, &t, k, answer.side), "N{} at {t}, order {k}", f.index);
                    }
                }
            }
        }
    }
}

#[test]
fn matrices_of_degrees_to_twenty() {
    for degree in 1..=20usize {
        for basis in ["bspline", "bezier"] {
            let answer = matrix(&basis.parse().unwrap(), degree, &Default::default()).unwrap();
            for (i, row) in answer.matrix.rows().iter().enumerate() {
                let sum: Rational = row.iter().cloned().sum();
                assert_eq!(sum, i64::from(i == degree), "{basis} of degree {degree}, row {i}");
            }
        }
        // m_ij = (1/n!) C(n,i) Σ_{k=j..n} (n−k)ⁱ (−1)^{k−j} C(n+1, k−j), with 0⁰ = 1; row i belongs to t^{n−i}.
        let answer = matrix(&"bspline".parse().unwrap(), degree, &Default::default()).unwrap();
        let factorial: Oracle = (1..=degree).fold(Oracle::one(), |f, k| f * Oracle::from(k as i64));
        for i in 0..=degree {
            for j in 0..=degree {
                let sum: Oracle = (j..=degree)
                    .map(|k| {
                        let sign = if (k - j) % 2 == 0 { 1 } else { -1 };
                        Oracle::from(sign)
                            * Oracle::from((degree - k) as i64).power(i)
                            * naive::binomial(degree + 1, k - j)
                    })
                    .sum();
                let expected = naive::binomial(degree, i) * sum / factorial.clone();
                assert!(is_equal(&answer.matrix.rows()[i][j], &expected), "degree {degree}, entry ({i}, {j})");
            }
        }
    }
}

/// The curve of some control points, on all spans of the domain, as polynomials.
fn curve(knots: &[Rational], degree: usize, points: &[Rational]) -> Vec<(Rational, Rational, Polynomial)> {
    let answer = blending(knots, degree, &Default::default()).unwrap();
    let (from, to) = answer.domain().unwrap();
    let mut breaks: Vec<Rational> = knots.iter().filter(|t| from <= **t && **t <= to).cloned().collect();
    breaks.dedup();
    let polynomial = |t: &Rational| {
        answer.functions.iter().fold(Polynomial::default(), |sum, f| match f.piece(t, Side::Right) {
            Some(piece) => &sum + &piece.polynomial.scaled(&points[f.index]),
            None => sum,
        })
    };
    breaks.windows(2).map(|pair| (pair[0].clone(), pair[1].clone(), polynomial(&pair[0]))).collect()
}

fn assert_same_curve(before: &[(Rational, Rational, Polynomial)], after: &[(Rational, Rational, Polynomial)]) {
    assert_eq!((&before[0].0, &before[before.len() - 1].1), (&after[0].0, &after[after.len() - 1].1), "domain");
    for (from, to, polynomial) in after {
        let (.., expected) = before.iter().find(|(a, b, _)| a <= from && to <= b).unwrap();
        assert_eq!(polynomial, expected, "on [{from}, {to}]");
    }
}

#[test]
fn insertion_and_elevation_leave_the_curve() {
    let mut random = Random(4);
    for degree in 0..=4 {
        for pattern in patterns(degree).into_iter().step_by(3) {
            let knots = random.knots(&pattern);
            let points: Vec<Rational> = (0..knots.len() - degree - 1).map(|_| random.fraction()).collect();
            let before = curve(&knots, degree, &points);
            let (from, to) = (&before[0].0, &before[before.len() - 1].1);
            let inside = |part: i64| from + &(&(to - from) * &Rational::new(part, 7).unwrap());
            let inserted = [inside(2), inside(5), inside(3)];
            let fits = |t: &Rational| knots.iter().filter(|knot| *knot == t).count() <= degree;
            if inserted.iter().all(fits) {
                let answer = insertion(&knots, degree, &inserted, &Default::default()).unwrap();
                let after = answer.matrix.applied(&points).unwrap();
                assert_same_curve(&before, &curve(&answer.new_knots, degree, &after));
            }
            for by in 0..=2 {
                let answer = elevation(&knots, degree, by, &Default::default()).unwrap();
                assert_eq!(answer.new_degree, degree + by);
                let after = answer.matrix.applied(&points).unwrap();
                assert_same_curve(&before, &curve(&answer.new_knots, degree + by, &after));
            }
        }
    }
    let answer = elevation_bezier(3, 1, &Default::default()).unwrap();
    assert_eq!(
        answer.matrix.scaled(&Rational::from(4)),
        Matrix::from_ints(&[&[4, 0, 0, 0], &[1, 3, 0, 0], &[0, 2, 2, 0], &[0, 0, 3, 1], &[0, 0, 0, 4],])
    );
}

#[test]
fn greville_abscissae_reproduce_the_parameter() {
    let mut random = Random(5);
    for degree in 1..=6 {
        for pattern in patterns(degree).into_iter().step_by(11) {
            let knots = random.knots(&pattern);
            let abscissae = greville(&knots, degree).unwrap().abscissae;
            for (.., polynomial) in curve(&knots, degree, &abscissae) {
                assert_eq!(polynomial, Polynomial::new(vec![Rational::zero(), Rational::one()]));
            }
        }
    }
}

#[test]
fn changes_of_basis_compose() {
    let interval = (Rational::new(-1, 2).unwrap(), Rational::new(5, 3).unwrap());
    let knots = parse::fractions("-3,-2,-2,-1/2,2,3,3,5").unwrap();
    let forms = [Form::Bernstein, Form::Power, Form::Hermite, Form::BSpline, Form::Span(knots)];
    let between = |a: &Form, b: &Form| change(a, b, 3, interval.clone(), &Default::default()).unwrap().matrix;
    for a in &forms {
        assert_eq!(between(a, a), Matrix::identity(4));
        for b in &forms {
            assert_eq!(between(a, b).product(&between(b, a)).unwrap(), Matrix::identity(4), "{a} and {b}");
            for c in &forms {
                assert_eq!(between(b, c).product(&between(a, b)).unwrap(), between(a, c), "{a}, {b}, {c}");
            }
        }
    }
}

#[test]
fn interpolation_is_the_dense_system_and_its_own_control_points() {
    let t = parse::fractions("0,1,3/2,4,5").unwrap();
    let points = parse::rows("0;2;-1/3;5;1").unwrap();
    let conditions = [
        (Condition::Natural, naive::End::Natural),
        (Condition::NotAKnot, naive::End::NotAKnot),
        (Condition::Clamped(parse::fractions("7/2").unwrap()), naive::End::Clamped("7/2".parse().unwrap())),
        (Condition::Second(parse::fractions("-3").unwrap()), naive::End::Second("-3".parse().unwrap())),
    ];
    let mut cases = vec![(Ends::Cyclic, naive::Ends::Cyclic), (Ends::Anticyclic, naive::Ends::Anticyclic)];
    for (start, slow_start) in &conditions {
        for (end, slow_end) in &conditions {
            let slow = naive::Ends::Open(slow_start.clone(), slow_end.clone());
            cases.push((Ends::Open(start.clone(), end.clone()), slow));
        }
    }
    let times: Vec<Oracle> = t.iter().map(oracle).collect();
    let values: Vec<Oracle> = points.iter().map(|p| oracle(&p[0])).collect();
    for (ends, slow) in cases {
        let answer = interpolation(&points, Some(&t), ends.clone(), &Default::default()).unwrap();
        let pieces = naive::cubic_spline(&times, &values, &slow).unwrap();
        for (i, m) in answer.tangents.iter().enumerate() {
            let expected = naive::piecewise(&times, &pieces, 1, &times[i]);
            assert!(is_equal(&m[0], &expected), "{ends}: m{i} = {}, not {expected}", m[0]);
        }
        let column: Vec<Rational> = answer.control_points.iter().map(|p| p[0].clone()).collect();
        let spline = curve(&answer.knots, 3, &column);
        assert_eq!(spline.len(), 4);
        for ((from, _, polynomial), expected) in spline.iter().zip(&pieces) {
            // The oracle's coefficients are of powers of t − from.
            for (k, expected) in expected.iter().enumerate() {
                assert!(is_equal(&polynomial.shifted(from).coefficient(k), expected), "{ends}, from {from}");
            }
        }
    }
    // Closed: as the cyclic spline whose last point is its first.
    let parameters = parse::fractions("0,1,3/2,4,5,11/2").unwrap();
    let closed = interpolation(&points, Some(&parameters), Ends::Closed, &Default::default()).unwrap();
    let mut around = points.clone();
    around.push(points[0].clone());
    let cyclic = interpolation(&around, Some(&parameters), Ends::Cyclic, &Default::default()).unwrap();
    assert_eq!(closed.tangents[..], cyclic.tangents[..5]);
    let n = closed.control_points.len();
    let column: Vec<Rational> = (0..n + 3).map(|i| closed.control_points[i % n][0].clone()).collect();
    for (from, to, polynomial) in curve(&closed.knots, 3, &column) {
        let i = parameters.iter().position(|t| *t == from).unwrap();
        assert_eq!(
            (polynomial.eval(&from), polynomial.derivative().eval(&from)),
            (around[i][0].clone(), cyclic.tangents[i][0].clone())
        );
        assert_eq!(polynomial.eval(&to), around[i + 1][0]);
    }
}

#[test]
fn splines_of_any_degree_pass_their_points() {
    let mut random = Random(6);
    for degree in 1..=6usize {
        for n in [degree + 1, degree + 2, 9] {
            for ends in [SplineEnds::NotAKnot, SplineEnds::Natural, SplineEnds::Closed] {
                let closed = usize::from(ends == SplineEnds::Closed);
                let t = random.knots(&vec![1; n + closed]);
                let points: Vec<Vec<Rational>> = (0..n).map(|_| vec![random.fraction()]).collect();
                let answer = collocation(&points, Some(&t), degree, ends, &Default::default());
                let answer = answer.unwrap_or_else(|error| panic!("{ends}, degree {degree}, {n} points: {error}"));
                let m = answer.control_points.len();
                let count = answer.knots.len() - degree - 1;
                let column: Vec<Rational> = (0..count).map(|i| answer.control_points[i % m][0].clone()).collect();
                let pieces = curve(&answer.knots, degree, &column);
                let value = |t: &Rational, order: usize| {
                    let (.., p) = pieces.iter().find(|(from, to, _)| from <= t && t <= to).unwrap();
                    (0..order).fold(p.clone(), |p, _| p.derivative()).eval(t)
                };
                for (t, point) in t.iter().zip(&points) {
                    assert_eq!(value(t, 0), point[0], "{ends}, degree {degree}");
                }
                if ends == SplineEnds::Natural {
                    // The derivatives from order (p + 1)/2 on vanish at the ends, p/2 of them.
                    for order in (degree + 2) / 2..(degree + 2) / 2 + degree / 2 {
                        assert_eq!(
                            (value(&t[0], order), value(&t[n - 1], order)),
                            (Rational::zero(), Rational::zero())
                        );
                    }
                }
                for equation in &answer.equations {
                    assert!(
                        lath_exact::print::Answer::explain(&answer, &Default::default())
                            .unwrap()
                            .contains(&format!("({})", equation.t).replace('-', "−"))
                    );
                }
            }
        }
    }
    // Degree 3 is the cubic spline by slopes.
    let points = parse::rows("0;2;-1/3;5;1").unwrap();
    let ends = Ends::Open(Condition::NotAKnot, Condition::NotAKnot);
    let slopes = interpolation(&points, None, ends, &Default::default()).unwrap();
    let answer = collocation(&points, None, 3, SplineEnds::NotAKnot, &Default::default()).unwrap();
    let column = |rows: &[Vec<Rational>]| -> Vec<Rational> { rows.iter().map(|row| row[0].clone()).collect() };
    let by_slopes = curve(&slopes.knots, 3, &column(&slopes.control_points));
    assert_same_curve(&curve(&answer.knots, 3, &column(&answer.control_points)), &by_slopes);
}
