//! Numbers as text, both ways.
//!
//! Reading: decimal notation, `-1.5`, `+.5`, `6.02e23`; the nearest double, never rounded twice. Words for infinity and
//! NaN and what overflows are refused, and the notations people really meet (decimal comma, hexadecimal, `1.0D+3`,
//! grouped digits, a typographic minus) are recognised, so that the message can say what to write instead.
//!
//! Writing: the shortest digits that read back to the same bits, of two equally near the even ones; an exponent below
//! 1e-5 and from 1e16 on. The sign of zero is kept.

use core::fmt;

use lath::error::Code as CoreCode;

use crate::error::{Code, Error};

/// Why a field is not a number that can be used.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Refusal {
    Empty,
    NotFinite,
    TooLarge,
    DecimalComma,
    Hexadecimal,
    FortranExponent,
    GroupedDigits,
    TypographicMinus,
    Word,
}

/// The number that `field` is, blanks around it allowed for.
pub(crate) fn parse(field: &str) -> Result<f64, Refusal> {
    let field = field.trim();
    match field.parse::<f64>() {
        Ok(value) if value.is_finite() => Ok(value),
        Ok(_) if field.bytes().any(|b| b.is_ascii_digit()) => Err(Refusal::TooLarge),
        Ok(_) => Err(Refusal::NotFinite),
        Err(_) => Err(notation(field)),
    }
}

/// Which notation a field has that is not a number here.
fn notation(field: &str) -> Refusal {
    let digits = field.bytes().any(|b| b.is_ascii_digit());
    let reads = |text: String| digits && text.parse::<f64>().is_ok();
    let unsigned = field.trim_start_matches(['+', '-']);
    let hexadecimal =
        |rest: &str| !rest.is_empty() && rest.bytes().all(|b| b.is_ascii_hexdigit() || b".pP+-".contains(&b));
    if field.is_empty() {
        Refusal::Empty
    } else if unsigned.strip_prefix("0x").or_else(|| unsigned.strip_prefix("0X")).is_some_and(hexadecimal) {
        Refusal::Hexadecimal
    } else if field.matches(',').count() == 1 && reads(field.replace(',', ".")) {
        Refusal::DecimalComma
    } else if reads(field.replace(['d', 'D'], "e")) {
        Refusal::FortranExponent
    } else if reads(field.replace(['_', '\''], "")) || (has_thousands(field) && reads(field.replace(',', ""))) {
        Refusal::GroupedDigits
    } else if reads(field.replace(['\u{2212}', '\u{2013}'], "-")) {
        Refusal::TypographicMinus
    } else {
        Refusal::Word
    }
}

/// True for commas between groups of three digits, `1,234,567.5`.
fn has_thousands(field: &str) -> bool {
    let whole = field.split('.').next().unwrap_or(field);
    let mut groups = whole.split(',').skip(1).peekable();
    groups.peek().is_some() && groups.all(|group| group.len() == 3)
}

impl Refusal {
    /// True for what somebody meant as a number, in whatever notation.
    pub(crate) fn is_meant_as_number(self) -> bool {
        !matches!(self, Refusal::Empty | Refusal::Word)
    }

    /// The error about this field.
    pub(crate) fn error(self, field: &str) -> Error {
        let shown: String = field.trim().chars().take(40).collect();
        let core = |code, message| Error::new(Code::Core(code), message);
        match self {
            Refusal::Empty => Error::new(Code::F007, "a field is empty"),
            Refusal::NotFinite => core(CoreCode::P002, format!("\"{shown}\" is not a finite number")),
            Refusal::TooLarge => core(CoreCode::P003, format!("{shown} is beyond the greatest double, 1.8e308")),
            Refusal::DecimalComma => Error::new(Code::F006, format!("\"{shown}\" has a decimal comma"))
                .remedied("Write decimal points; commas separate columns."),
            Refusal::Hexadecimal => Error::new(Code::F006, format!("\"{shown}\" is hexadecimal")),
            Refusal::FortranExponent => Error::new(Code::F006, format!("\"{shown}\" has the exponent letter D"))
                .remedied("Write the exponent with e."),
            Refusal::GroupedDigits => Error::new(Code::F006, format!("\"{shown}\" has grouped digits"))
                .remedied("Write the digits without separators."),
            Refusal::TypographicMinus => Error::new(Code::F006, format!("\"{shown}\" has a typographic minus sign"))
                .remedied("Write the minus sign as - (U+002D)."),
            Refusal::Word => Error::new(Code::F005, format!("\"{shown}\" is not a number")),
        }
    }
}

/// So many of something, by its word in the singular.
///
/// ```
/// use lath_io::number::counted;
///
/// assert_eq!([counted(1, "point"), counted(2, "point")], ["1 point", "2 points"]);
/// ```
#[must_use]
pub fn counted(number: usize, word: &str) -> String {
    format!("{number} {word}{}", if number == 1 { "" } else { "s" })
}

/// The shortest text that reads back to the same bits.
///
/// Infinities and NaN have none: they print as Rust prints them, and every writer of this crate refuses them before it
/// gets here.
///
/// ```
/// use lath_io::number::shortest;
///
/// let text = |x: f64| shortest(x).to_string();
/// assert_eq!([text(0.1), text(-0.0), text(1871.0), text(1e-5)], ["0.1", "-0", "1871", "0.00001"]);
/// assert_eq!([text(9.9e-6), text(1e16), text(5e-324)], ["9.9e-6", "1e16", "5e-324"]);
/// ```
#[must_use]
pub fn shortest(value: f64) -> impl fmt::Display + fmt::Debug + Copy {
    Shortest(value)
}

#[derive(Clone, Copy, Debug)]
struct Shortest(f64);

impl fmt::Display for Shortest {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.0.is_finite() { f.write_str(Printer::new().print(self.0)) } else { write!(f, "{}", self.0) }
    }
}

/// Finite numbers as text, one after the other: the texts of [`shortest`], fast.
pub(crate) struct Printer {
    digits: zmij::Buffer,
    /// "-0.00001" and 16 digits more, or 16 digits with zeros behind them.
    text: [u8; 32],
}

impl Printer {
    pub(crate) fn new() -> Printer {
        Printer { digits: zmij::Buffer::new(), text: [0; 32] }
    }

    /// The text of a finite number.
    pub(crate) fn print(&mut self, value: f64) -> &str {
        let magnitude = value.abs();
        let ordinary = magnitude == 0.0 || (1e-5..1e16).contains(&magnitude);
        let digits = self.digits.format_finite(value);
        // Whoever finds the shortest digits finds these; but zmij writes 1.0 and 1e+16, and places the point by other rules.
        let exponent = digits.bytes().position(|byte| byte == b'e');
        match exponent {
            None if ordinary => digits.strip_suffix(".0").unwrap_or(digits),
            Some(at) if !ordinary && digits.as_bytes().get(at + 1) == Some(&b'-') => digits,
            _ => placed(digits, ordinary, &mut self.text),
        }
    }
}

/// The same digits with the point where it belongs: in ordinary notation, or behind the first digit with an exponent.
fn placed<'a>(digits: &str, ordinary: bool, text: &'a mut [u8; 32]) -> &'a str {
    let (sign, digits) = digits.strip_prefix('-').map_or(("", digits), |rest| ("-", rest));
    let (digits, exponent) = digits.split_once('e').unwrap_or((digits, "0"));
    let (whole, fraction) = digits.split_once('.').unwrap_or((digits, ""));
    let exponent: i32 = exponent.parse().unwrap_or(0);
    let all = || whole.bytes().chain(fraction.bytes());
    let leading = all().take_while(|&digit| digit == b'0').count();
    let trailing = all().rev().take_while(|&digit| digit == b'0').count();
    let count = (whole.len() + fraction.len()).saturating_sub(leading + trailing);
    // The number is 0.ddd… · 10^point.
    let point = whole.len() as i32 + exponent - leading as i32;
    let mut length = 0;
    let mut push = |byte: u8| {
        if let Some(place) = text.get_mut(length) {
            *place = byte;
            length += 1;
        }
    };
    sign.bytes().for_each(&mut push);
    if ordinary && point <= 0 {
        b"0.".iter().copied().for_each(&mut push);
        (point..0).for_each(|_| push(b'0'));
    }
    let before = if ordinary { point } else { 1 };
    for (i, digit) in all().skip(leading).take(count).enumerate() {
        if i as i32 == before && i > 0 {
            push(b'.');
        }
        push(digit);
    }
    if ordinary {
        (count as i32..point).for_each(|_| push(b'0'));
    } else {
        push(b'e');
        (point - 1).to_string().bytes().for_each(&mut push);
    }
    core::str::from_utf8(text.get(..length).unwrap_or_default()).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decimal_notation_is_read() {
        let cases =
            [("1", 1.0), (" +1.5 ", 1.5), ("-.5", -0.5), ("1.", 1.0), ("1e5", 1e5), ("1.E+5", 1e5), ("1e-400", 0.0)];
        for (text, value) in cases {
            assert_eq!(parse(text), Ok(value), "{text}");
        }
        assert!(parse("-0").is_ok_and(f64::is_sign_negative));
        assert_eq!(parse("9007199254740993"), Ok(9007199254740992.0)); // text is rounded to the nearest double
    }

    #[test]
    fn other_notations_are_recognised() {
        let cases = [
            ("", Refusal::Empty, "F007"),
            ("nan", Refusal::NotFinite, "P002"),
            ("-Infinity", Refusal::NotFinite, "P002"),
            ("1e400", Refusal::TooLarge, "P003"),
            ("1,5", Refusal::DecimalComma, "F006"),
            ("-1,5e3", Refusal::DecimalComma, "F006"),
            ("0x1F", Refusal::Hexadecimal, "F006"),
            ("-0x1.8p3", Refusal::Hexadecimal, "F006"),
            ("1.0D+03", Refusal::FortranExponent, "F006"),
            ("1_000", Refusal::GroupedDigits, "F006"),
            ("1'234'567.5", Refusal::GroupedDigits, "F006"),
            ("1,234,567", Refusal::GroupedDigits, "F006"),
            ("\u{2212}1.5", Refusal::TypographicMinus, "F006"),
            ("x", Refusal::Word, "F005"),
            ("1,2,3", Refusal::Word, "F005"),
            ("D", Refusal::Word, "F005"),
            ("1/3", Refusal::Word, "F005"),
            ("--1", Refusal::Word, "F005"),
            ("0x", Refusal::Word, "F005"),
            ("1e", Refusal::Word, "F005"),
            ("1 2", Refusal::Word, "F005"),
        ];
        for (text, refusal, code) in cases {
            assert_eq!(parse(text), Err(refusal), "{text}");
            assert_eq!(refusal.error(text).code().as_str(), code, "{text}");
        }
    }

    #[test]
    fn shortest_reads_back() {
        let values =
            [0.0, -0.0, 0.1, 1e15, 123456789.125, 9.999e15, 1e16, 1e300, -2.5e-7, f64::MIN_POSITIVE, f64::MAX, 5e-324];
        for value in values {
            let text = shortest(value).to_string();
            assert_eq!(parse(&text).map(f64::to_bits), Ok(value.to_bits()), "{text}");
            assert!(text.len() < 26, "{text}");
        }
    }

    #[test]
    fn shortest_is_what_the_standard_library_prints() {
        let (mut bits, mut ties) = (0x9E37_79B9_7F4A_7C15_u64, 0);
        let mut values: Vec<f64> =
            (-330..310).flat_map(|k| [format!("1e{k}"), format!("-1.5e{k}")]).map(|t| t.parse().unwrap()).collect();
        for i in 0..40_000_u32 {
            bits = bits.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            let any = f64::from_bits(bits);
            let near = (bits >> 11) as f64 * 1e-12 - 4000.0;
            values.extend([any, near, f64::from(i) - 20_000.0, f64::from(i) / 64.0, f64::from(i) * 1e-9]);
        }
        for value in values.into_iter().filter(|x| x.is_finite()) {
            let magnitude = value.abs();
            let ordinary = magnitude == 0.0 || (1e-5..1e16).contains(&magnitude);
            let text = if ordinary { format!("{value}") } else { format!("{value:e}") };
            let found = shortest(value).to_string();
            if found != text {
                // Two texts as short and as near: here the even digit, there the greater one.
                let last = |text: &str| text.bytes().last().unwrap();
                assert!(found.parse() == Ok(value) && last(&found).is_multiple_of(2), "{found}, not {text}");
                assert_eq!((found.len(), &found[..found.len() - 1]), (text.len(), &text[..text.len() - 1]));
                ties += 1;
            }
        }
        assert!((1..100).contains(&ties), "{ties} ties");
        assert_eq!(shortest(f64::NEG_INFINITY).to_string(), "-inf");
    }
}
