//! Banded and cyclic systems, on fractions: what was multiplied comes back, exactly.

use lath::error::Code;
use lath::num::{Banded, CyclicBanded, PivotedBanded, Scalar};
use testkit::rational::{Rational, ratio};

/// A fraction that depends on both indices in no simple way.
fn entry(i: usize, j: usize) -> Rational {
    ratio(((i * 7 + j * 13) % 11) as i64 - 5, ((i + 2 * j) % 4) as i64 + 1)
}

#[test]
fn a_banded_system_gives_back_what_was_multiplied() {
    for n in 1..9 {
        for (lower, upper) in [(0, 0), (1, 1), (2, 1), (0, 3), (3, 3)] {
            let mut matrix = Banded::new(n, lower, upper);
            let x: Vec<[Rational; 2]> = (0..n).map(|i| [entry(i, 1), entry(2, i)]).collect();
            let mut rhs = vec![[Rational::zero(), Rational::zero()]; n];
            for i in 0..n {
                for j in i.saturating_sub(lower)..n.min(i + upper + 1) {
                    let a = if i == j { ratio(40, 1) } else { entry(i, j) };
                    assert!(matrix.set(i, j, a.clone()));
                    for c in 0..2 {
                        rhs[i][c] += a.clone() * x[j][c].clone();
                    }
                }
            }
            matrix.factor().unwrap().solve(&mut rhs).unwrap();
            assert_eq!(rhs, x, "n = {n}, band ({lower}, {upper})");
        }
    }
}

#[test]
fn a_pivoted_system_needs_no_diagonal() {
    for n in 1..9 {
        for (lower, upper) in [(0, 0), (1, 1), (2, 1), (1, 3), (3, 3)] {
            let mut matrix = PivotedBanded::new(n, lower, upper);
            let mut plain = Banded::new(n, lower, upper);
            let x: Vec<[Rational; 2]> = (0..n).map(|i| [entry(i, 1), entry(2, i)]).collect();
            let mut rhs = vec![[Rational::zero(), Rational::zero()]; n];
            for i in 0..n {
                for j in i.saturating_sub(lower)..n.min(i + upper + 1) {
                    // Rows change places in pairs: nothing on the diagonal, unless alone.
                    let alone = lower == 0 || upper == 0 || i == n - 1 && n % 2 == 1;
                    let strong = if alone { j == i } else { j == i ^ 1 };
                    let a = if strong {
                        ratio(40, 1)
                    } else if i == j {
                        Rational::zero()
                    } else {
                        entry(i, j)
                    };
                    assert!(matrix.set(i, j, a.clone()) && plain.set(i, j, a.clone()));
                    for c in 0..2 {
                        rhs[i][c] += a.clone() * x[j][c].clone();
                    }
                }
            }
            assert_eq!(plain.factor().is_err(), n > 1 && lower > 0 && upper > 0, "a test of exchange needs zeros");
            matrix.solve(&mut rhs).unwrap();
            assert_eq!(rhs, x, "n = {n}, band ({lower}, {upper})");
        }
    }
    let singular = PivotedBanded::<f64>::new(3, 1, 1);
    let error = singular.clone().solve(&mut [[1.0]; 3]).unwrap_err();
    assert_eq!((error.code(), error.index()), (Code::N001, Some(0)));
    assert_eq!(singular.solve(&mut [[1.0]; 2]).unwrap_err().code(), Code::P005);
    let mut one = PivotedBanded::new(4, 1, 1);
    assert!(!one.set(0, 2, 1.0) && !one.set(2, 0, 1.0) && one.set(0, 1, 1.0));
    assert!(one.set(0, 0, f64::NAN));
    assert_eq!(one.solve(&mut [[1.0]; 4]).unwrap_err().code(), Code::N001);
}

#[test]
fn a_cyclic_system_gives_back_what_was_multiplied() {
    // From n = 1, where the band meets itself on both sides, up.
    for n in 1..10 {
        for (lower, upper) in [(1, 1), (2, 1), (1, 3), (2, 2)] {
            let mut matrix = CyclicBanded::new(n, lower, upper);
            let x: Vec<[Rational; 1]> = (0..n).map(|i| [entry(i, 3)]).collect();
            let mut rhs = vec![[Rational::zero()]; n];
            for i in 0..n {
                for offset in -(lower as isize)..=upper as isize {
                    let j = (i as isize + offset).rem_euclid(n as isize) as usize;
                    let a = if offset == 0 { ratio(60, 1) } else { entry(i, (offset + 9) as usize) };
                    assert!(matrix.add(i, offset, a.clone()));
                    rhs[i][0] += a * x[j][0].clone();
                }
            }
            matrix.solve(&mut rhs).unwrap();
            assert_eq!(rhs, x, "n = {n}, band ({lower}, {upper})");
        }
    }
}

#[test]
fn singular_systems_and_wrong_sizes_are_refused() {
    let error = Banded::<f64>::new(3, 1, 1).factor().unwrap_err();
    assert_eq!((error.code(), error.index()), (Code::N001, Some(0)));
    let mut nan = Banded::new(1, 0, 0);
    nan.set(0, 0, f64::NAN);
    assert_eq!(nan.factor().unwrap_err().code(), Code::N001);
    let mut one = Banded::new(1, 0, 0);
    one.set(0, 0, 1.0);
    assert!(!one.set(0, 1, 1.0));
    assert_eq!(one.factor().unwrap().solve(&mut [[1.0], [2.0]]).unwrap_err().code(), Code::P005);
    let mut cyclic = CyclicBanded::<f64>::new(2, 1, 1);
    assert!(!cyclic.add(2, 0, 1.0));
    assert_eq!(cyclic.clone().solve(&mut [[1.0]]).unwrap_err().code(), Code::P005);
    assert_eq!(cyclic.solve(&mut [[1.0], [1.0]]).unwrap_err().code(), Code::N001);
}
