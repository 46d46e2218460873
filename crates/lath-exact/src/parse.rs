//! Reading fractions, with an error that names the culprit.

use crate::error::{Code, Error, Result};
use crate::rational::Rational;
use dashu_int::{IBig, UBig};

/// The longest text of one number: reading digits costs the square of their number.
const MAX_LENGTH: usize = 10_000;

/// The greatest exponent of a decimal, in magnitude.
const MAX_EXPONENT: i64 = 10_000;

/// Reads an integer, a fraction or a decimal: `-12`, `121/384`, `-0.25`, `1.5e-3`, also `0.5/3`. The minus sign may be typographic
/// (`−`), as in this crate's own text.
///
/// ```
/// use lath_exact::parse::fraction;
///
/// assert_eq!(fraction("-0.25")?.to_string(), "-1/4");
/// assert_eq!(fraction("10/14")?.to_string(), "5/7");
/// # Ok::<(), lath_exact::error::Error>(())
/// ```
///
/// # Errors
/// X001 for anything else, or more than 10 000 characters, or an exponent beyond 10 000; X002 for a zero denominator.
pub fn fraction(text: &str) -> Result<Rational> {
    named(text, "")
}

/// Reads fractions separated by commas or blanks.
///
/// ```
/// let knots = lath_exact::parse::fractions("0, 0, 1/3, 0.5, 1, 1")?;
/// assert_eq!(knots[2].to_string(), "1/3");
/// # Ok::<(), lath_exact::error::Error>(())
/// ```
///
/// # Errors
/// As [`fraction`], with the index of the number at fault; X001 for an empty list or an empty place between commas.
pub fn fractions(text: &str) -> Result<Vec<Rational>> {
    let read = |(i, part): (usize, &str)| named(part, &format!("number {i}, ")).map_err(|error| error.at(i));
    let text = text.trim();
    if text.contains(',') || text.is_empty() {
        return text.split(',').enumerate().map(read).collect();
    }
    text.split_whitespace().enumerate().map(read).collect()
}

/// Reads rows of fractions separated by semicolons: `5,5; 10,10` are two points of the plane.
///
/// # Errors
/// As [`fractions`], with the index of the row at fault; P005 if the rows differ in length.
pub fn rows(text: &str) -> Result<Vec<Vec<Rational>>> {
    let read = |(i, row): (usize, &str)| {
        let in_row = |error: Error| Error::new(error.code(), format!("row {i}: {}", error.message())).at(i);
        fractions(row).map_err(in_row)
    };
    let rows: Vec<Vec<Rational>> = text.split(';').enumerate().map(read).collect::<Result<_>>()?;
    same_length(&rows)?;
    Ok(rows)
}

/// Refuses rows of different length (P005).
pub(crate) fn same_length(rows: &[Vec<Rational>]) -> Result<()> {
    let Some(first) = rows.first() else { return Ok(()) };
    match rows.iter().position(|row| row.len() != first.len()) {
        None => Ok(()),
        Some(i) => {
            let message = format!("row {i} has {} numbers, row 0 has {}", rows[i].len(), first.len());
            Err(Error::new(Code::Core(lath::error::Code::P005), message).at(i))
        }
    }
}

fn named(text: &str, place: &str) -> Result<Rational> {
    let text = text.trim();
    let refused = |reason: &str| {
        let shown: String = text.chars().take(40).collect();
        let dots = if shown.len() < text.len() { "…" } else { "" };
        let comma = if place.is_empty() { "" } else { "," };
        format!("{place}`{shown}{dots}`{comma} {reason}")
    };
    if text.len() > MAX_LENGTH {
        return Err(Error::new(Code::X001, refused(&format!("is longer than {MAX_LENGTH} characters"))));
    }
    let (upper, lower) = text.split_once('/').unwrap_or((text, "1"));
    let (Some(upper), Some(lower)) = (decimal(upper), decimal(lower)) else {
        return Err(Error::new(Code::X001, refused("is not a fraction")));
    };
    if lower == 0 {
        return Err(Error::new(Code::X002, refused("divides by zero")));
    }
    Ok(upper / lower)
}

/// An integer or a decimal, with an exponent or without.
fn decimal(text: &str) -> Option<Rational> {
    let text = text.trim();
    let (mantissa, exponent) = match text.split_once(['e', 'E']) {
        Some((mantissa, exponent)) => (mantissa, integer(exponent)?),
        None => (text, 0),
    };
    let (negative, digits) = signed(mantissa);
    let (whole, places) = digits.split_once('.').unwrap_or((digits, ""));
    if whole.len() + places.len() == 0 || exponent.abs() > MAX_EXPONENT {
        return None;
    }
    let mut all = String::with_capacity(digits.len());
    for part in [whole, places] {
        if !part.bytes().all(|byte| byte.is_ascii_digit()) {
            return None;
        }
        all.push_str(part);
    }
    let number: UBig = all.parse().ok()?;
    let number = if negative { -IBig::from(number) } else { IBig::from(number) };
    let shift = exponent - places.len() as i64;
    let ten = UBig::from(10u8).pow(shift.unsigned_abs() as usize);
    Some(if shift < 0 {
        Rational::from_parts(number, ten)
    } else {
        Rational::from_parts(number * IBig::from(ten), UBig::ONE)
    })
}

fn integer(text: &str) -> Option<i64> {
    let (negative, digits) = signed(text);
    let fits = !digits.is_empty() && digits.len() < 9 && digits.bytes().all(|byte| byte.is_ascii_digit());
    let value: i64 = fits.then(|| digits.parse().ok())??;
    Some(if negative { -value } else { value })
}

/// The sign, true for minus, and what follows it.
fn signed(text: &str) -> (bool, &str) {
    match text.strip_prefix(['-', '−']) {
        Some(rest) => (true, rest),
        None => (false, text.strip_prefix('+').unwrap_or(text)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fractions_are_read_and_printed_in_lowest_terms() {
        let cases = [
            ("121/384", "121/384"),
            ("-2/6", "-1/3"),
            (" 4 / 2 ", "2"),
            ("−7", "-7"),
            ("3/-9", "-1/3"),
            ("+.5", "1/2"),
            ("5.", "5"),
            ("-0.25", "-1/4"),
            ("1.5e-3", "3/2000"),
            ("2E2", "200"),
            ("0.5/1.5", "1/3"),
            ("-0", "0"),
            ("00012", "12"),
        ];
        for (text, printed) in cases {
            assert_eq!(fraction(text).unwrap().to_string(), printed, "{text}");
        }
    }

    #[test]
    fn what_is_no_fraction_is_named() {
        for text in [
            "", " ", "a", "1/", "/2", "1/2/3", ".", "-", "--1", "1e", "1e1.5", "0x10", "1_000", "nan", "inf", "½",
            "1 2",
        ] {
            assert_eq!(fraction(text).unwrap_err().code(), Code::X001, "{text}");
        }
        for text in ["1/0", "0/0", "1/0.0", "1/-0"] {
            let error = fraction(text).unwrap_err();
            assert_eq!(error.code(), Code::X002);
            assert_eq!(error.message(), format!("`{text}` divides by zero"));
        }
        for text in ["1e10001", "1e-10001", "1e99999999999999999999", &"9".repeat(10_001)] {
            assert_eq!(fraction(text).unwrap_err().code(), Code::X001);
        }
    }

    #[test]
    fn lists_and_rows() {
        assert_eq!(fractions("0 1/2  3").unwrap().len(), 3);
        let error = fractions("0, 1, , 2").unwrap_err();
        assert_eq!((error.code(), error.index()), (Code::X001, Some(2)));
        assert_eq!(fractions("").unwrap_err().index(), Some(0));
        assert_eq!(rows("5,5; 10,10").unwrap().len(), 2);
        assert_eq!(rows("5,5; 10").unwrap_err().code(), Code::Core(lath::error::Code::P005));
        assert_eq!(rows("5,5; 1/0,2").unwrap_err().index(), Some(1));
    }
}
