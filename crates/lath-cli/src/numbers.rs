//! Numbers on the command line: decimal or a fraction, such as `-0.5`, `1e-3`, `1/3`.

use std::str::FromStr;

/// A number as written; words such as `nan` and `inf` are numbers here, so that the library can say what is wrong with them.
fn any(text: &str) -> Result<f64, String> {
    let plain = |text: &str| text.trim().parse::<f64>().map_err(|_| format!("\"{}\" is not a number", text.trim()));
    let Some((above, below)) = text.split_once('/') else {
        return plain(text);
    };
    let (above, below) = (plain(above)?, plain(below)?);
    if below == 0.0 {
        return Err(format!("\"{}\" divides by zero", text.trim()));
    }
    Ok(above / below)
}

/// A finite number.
pub(crate) fn finite(text: &str) -> Result<f64, String> {
    match any(text)? {
        value if value.is_finite() => Ok(value),
        value => Err(format!("\"{}\" is {value}, not a finite number", text.trim())),
    }
}

/// A finite number above 0.
pub(crate) fn positive(text: &str) -> Result<f64, String> {
    finite(text).and_then(|value| if value > 0.0 { Ok(value) } else { Err("a number above 0 is needed".into()) })
}

/// A whole number from 0, also written as `1e6`.
pub(crate) fn count(text: &str) -> Result<u64, String> {
    if let Ok(value) = text.trim().parse() {
        return Ok(value);
    }
    match any(text) {
        Ok(value) if value >= 0.0 && value.fract() == 0.0 && value <= 9_007_199_254_740_992.0 => Ok(value as u64),
        _ => Err("a whole number from 0 is needed".into()),
    }
}

/// A whole number from 1.
pub(crate) fn positive_count(text: &str) -> Result<u64, String> {
    match count(text) {
        Ok(0) | Err(_) => Err("a whole number from 1 is needed".into()),
        value => value,
    }
}

/// Numbers between commas.
pub(crate) fn list(text: &str, number: impl Fn(&str) -> Result<f64, String>) -> Result<Vec<f64>, String> {
    let one = |(i, field): (usize, &str)| match field.trim() {
        "" => Err(format!("number {i} is empty")),
        field => number(field),
    };
    text.split(',').enumerate().map(one).collect()
}

/// Finite numbers between commas, as one value of an option.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Numbers(pub(crate) Vec<f64>);

impl FromStr for Numbers {
    type Err = String;

    fn from_str(text: &str) -> Result<Numbers, String> {
        list(text, finite).map(Numbers)
    }
}

/// Knots between commas: what is wrong with them, the library says with its own codes.
pub(crate) fn knots(text: &str) -> Result<Vec<f64>, String> {
    list(text, any)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decimals_and_fractions() {
        assert_eq!(finite("-1/3"), Ok(-1.0 / 3.0));
        assert_eq!(finite(" 1e-3 "), Ok(1e-3));
        assert_eq!(finite("2.5/-0.5"), Ok(-5.0));
        assert_eq!(list("0, 1/2,-1", finite), Ok(vec![0.0, 0.5, -1.0]));
        for wrong in ["", "x", "1/0", "1/", "/2", "1/2/3", "inf", "nan", "1e999", "1,2"] {
            assert!(finite(wrong).is_err(), "{wrong}");
        }
        assert!(list("1,,2", finite).is_err() && list("1,", finite).is_err());
        assert_eq!(knots("0,inf"), Ok(vec![0.0, f64::INFINITY]));
    }

    #[test]
    fn counts_are_whole() {
        assert_eq!((count("0"), count("1e6"), count("4/2")), (Ok(0), Ok(1_000_000), Ok(2)));
        assert_eq!(count("18446744073709551615"), Ok(u64::MAX));
        for wrong in ["-1", "1.5", "x", "1e30", "nan", ""] {
            assert!(count(wrong).is_err() && positive_count(wrong).is_err(), "{wrong}");
        }
        assert!(positive_count("0").is_err());
    }
}
