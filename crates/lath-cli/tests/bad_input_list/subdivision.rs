//! Rows 62 and 63: levels and tolerances.

use crate::run;
use crate::tool::rows;

const POLYGON: &str = "0,0\n1,0\n0,0\n2,0\n";

#[test]
fn row_62_levels_10_to_60_and_beyond() {
    let chaikin = |options: &str| run(POLYGON, &format!("subdivide - --scheme chaikin {options}"));
    assert_eq!(rows(&chaikin("--levels 10").done()).len(), 2 * 1024 + 2);
    for level in ["20", "60", "1000"] {
        chaikin(&format!("--levels {level} --budget 1e6")).fails(5, &["B001"]);
    }
    chaikin("--levels 40").fails(5, &["B001", "standard input"]);
    for level in ["1001", "18446744073709551615"] {
        chaikin(&format!("--levels {level}")).fails(3, &["S005", level]);
    }
    chaikin("--levels -1").fails(2, &["--levels"]);
    // One point of a level that nobody could store: at t = 1 the limit is the middle of points 1 and 2.
    let index = format!("1000:{}", power_of_two(1000));
    assert_eq!(rows(&chaikin(&format!("--only {index} --limit")).done()), [[0.5, 0.0]]);
}

/// 2ⁿ in decimal digits.
fn power_of_two(n: u32) -> String {
    let mut digits = vec![1];
    for _ in 0..n {
        let mut carry = 0;
        for digit in &mut digits {
            let twice = 2 * *digit + carry;
            (*digit, carry) = (twice % 10, twice / 10);
        }
        if carry > 0 {
            digits.push(carry);
        }
    }
    digits.iter().rev().map(u32::to_string).collect()
}

#[test]
fn row_63_tolerances_that_are_none() {
    let to = |tolerance: &str| run(POLYGON, &format!("subdivide - --scheme cubic --quiet --to-tolerance {tolerance}"));
    for tolerance in ["0", "-0", "-1", "nan", "inf", "1/0"] {
        to(tolerance).fails(2, &["--to-tolerance"]);
    }
    // Beyond the budget, and beyond what any level is proven to reach.
    to("1e-12 --budget 1000").fails(5, &["B001"]);
    to("1e-300").fails(3, &["S005", "1e-300"]);
    // Larger than the polygon: it is good enough as it is.
    assert_eq!(rows(&to("1e9").done()), [[0.0, 0.0], [1.0, 0.0], [0.0, 0.0], [2.0, 0.0]]);
}
