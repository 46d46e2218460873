//! Numbers in messages.

use core::fmt;

/// A number as people write it: with an exponent where the digits alone would be a long row of zeros.
pub(crate) struct Number(pub(crate) f64);

impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let size = self.0.abs();
        if size == 0.0 || (1e-5..1e16).contains(&size) || !size.is_finite() {
            write!(f, "{}", self.0)
        } else {
            write!(f, "{:e}", self.0)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Number;
    use alloc::format;

    #[test]
    fn digits_stay_few() {
        let cases = [(0.0, "0"), (-1.5, "-1.5"), (1e15, "1000000000000000"), (1e300, "1e300"), (-5e-324, "-5e-324")];
        for (x, text) in cases {
            assert_eq!(format!("{}", Number(x)), text);
        }
        assert_eq!(format!("{} {}", Number(f64::NAN), Number(f64::INFINITY)), "NaN inf");
    }
}
