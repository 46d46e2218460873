//! Where an axis is marked, and what stands there.
//!
//! Steps are 1, 2 or 5 times a power of ten (Heckbert, *Nice numbers for graph labels*, Graphics Gems, 1990), the
//! smallest at which the labels keep their distance. A tick is an integer multiple of its step and is kept as integers,
//! so that no label shows the rounding of 0.1 + 0.2. Where labels would be long, what they share is said once in a
//! note: a power of ten ("×10⁻⁹") or an offset ("10 000 000 +").

/// One mark of an axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Tick {
    /// Where, in the axis's own units: the number closest to the decimal that the label shows.
    pub value: f64,
    /// What stands there.
    pub label: String,
}

/// The marks of one axis.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Ticks {
    /// Increasing.
    pub ticks: Vec<Tick>,
    /// What all labels share: a factor, an offset, both.
    pub note: Option<String>,
}

/// The marks of an axis from `lo` to `hi` that is `length` px long.
///
/// `room` says how many px a label takes along the axis, its distance to the next included; `least` is the smallest
/// distance between ticks that looks well. The steps are the smallest that satisfy both, so labels never overlap; there
/// may be only one tick, or none. Ends in either order; an end that is not finite gives no ticks, equal ends give one.
///
/// ```
/// use lath_draw::ticks::ticks;
///
/// let axis = ticks(0.0, 1.0, 500.0, 90.0, |label| 7.0 * label.len() as f64);
/// let labels: Vec<&str> = axis.ticks.iter().map(|t| t.label.as_str()).collect();
/// assert_eq!(labels, ["0", "0.2", "0.4", "0.6", "0.8", "1"]);
/// ```
pub fn ticks(lo: f64, hi: f64, length: f64, least: f64, room: impl Fn(&str) -> f64) -> Ticks {
    let (lo, hi) = if lo <= hi { (lo, hi) } else { (hi, lo) };
    if !(lo.is_finite() && hi.is_finite() && length > 0.0 && least > 0.0) {
        return Ticks::default();
    }
    if lo == hi {
        return Ticks { ticks: vec![Tick { value: lo, label: shortest(lo) }], note: None };
    }
    let wanted = (hi / 2.0 - lo / 2.0) * (least / length) * 2.0;
    let mut step = Step::at_least(if wanted.is_finite() { wanted } else { f64::MAX / 8.0 });
    // Each step is at least twice the last but one: few rounds until a single label is left.
    for _ in 0..64 {
        let marks = step.marks(lo, hi);
        let Some(indices) = marks else {
            step = step.next();
            continue;
        };
        let labelled = step.label(&indices);
        let px = |value: f64| (value / 2.0 - lo / 2.0) / (hi / 2.0 - lo / 2.0) * length;
        let overlap = labelled.ticks.windows(2).any(|pair| {
            let distance = px(pair[1].value) - px(pair[0].value);
            distance < (room(&pair[0].label) + room(&pair[1].label)) / 2.0
        });
        if !overlap {
            return labelled;
        }
        step = step.next();
    }
    Ticks::default()
}

/// mantissa · 10^exponent with mantissa 1, 2 or 5.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Step {
    mantissa: i64,
    exponent: i32,
}

/// Ticks beyond this many a step would be refused: an axis has dozens.
const MOST: f64 = 1000.0;

impl Step {
    /// The smallest step that is not below x > 0 but for rounding.
    fn at_least(x: f64) -> Step {
        let text = format!("{:e}", if x > 0.0 { x } else { f64::MIN_POSITIVE });
        let (digits, exponent) = text.split_once('e').unwrap_or(("1", "0"));
        let (digits, exponent) = (digits.parse().unwrap_or(1.0), exponent.parse().unwrap_or(0));
        match digits {
            m if m <= 1.00001 => Step { mantissa: 1, exponent },
            m if m <= 2.00001 => Step { mantissa: 2, exponent },
            m if m <= 5.00001 => Step { mantissa: 5, exponent },
            _ => Step { mantissa: 1, exponent: exponent + 1 },
        }
    }

    fn next(self) -> Step {
        match self.mantissa {
            1 => Step { mantissa: 2, ..self },
            2 => Step { mantissa: 5, ..self },
            _ => Step { mantissa: 1, exponent: self.exponent + 1 },
        }
    }

    /// The multiples of 10^exponent at which ticks stand; none when the step is too small to count with.
    fn marks(self, lo: f64, hi: f64) -> Option<Vec<i64>> {
        let step = decimal(self.mantissa, self.exponent);
        let (first, last) = (lo / step, hi / step);
        if !(last - first <= MOST && first.abs() < 1e15 && last.abs() < 1e15) {
            return None;
        }
        // A tick that misses the end by rounding alone is on the axis.
        let (first, last) = ((first - 1e-9).ceil() as i64, (last + 1e-9).floor() as i64);
        Some((first..=last).map(|i| i * self.mantissa).collect())
    }

    /// Labels in the shortest of three styles: plain, with a common power of ten, with a common offset.
    fn label(self, multiples: &[i64]) -> Ticks {
        let e = self.exponent;
        let largest = multiples.iter().map(|n| n.unsigned_abs()).max().unwrap_or(0);
        let digits = largest.checked_ilog10().map_or(0, |d| d as i32 + 1);
        let leading = e + digits; // the largest label is below 10^leading
        let plain = e >= -4 && leading <= 7 && digits <= 7 || largest == 0;
        let offset = if plain { 0 } else { shared(multiples) };
        let rest = |n: i64| n - offset;
        let rest_digits = multiples.iter().map(|&n| rest(n).unsigned_abs()).max().unwrap_or(0);
        let rest_digits = rest_digits.checked_ilog10().map_or(0, |d| d as i32 + 1);
        let (rest_leading, rest_plain) = (e + rest_digits, e >= -4 && e + rest_digits <= 7);
        let power = if plain || rest_plain { 0 } else { rest_leading - 1 };

        let mut note = String::new();
        if offset != 0 {
            note = format!("{} +", write(offset, e));
        }
        if power != 0 {
            note = format!("{note} ×10{}", superscript(power)).trim_start().to_owned();
        }
        let ticks =
            multiples.iter().map(|&n| Tick { value: decimal(n, e), label: write(rest(n), e - power) }).collect();
        Ticks { ticks, note: if note.is_empty() { None } else { Some(note) } }
    }
}

/// The round number that all multiples share in front, 0 if they do not.
fn shared(multiples: &[i64]) -> i64 {
    let (Some(&first), Some(&last)) = (multiples.first(), multiples.last()) else { return 0 };
    if first.signum() * last.signum() <= 0 {
        return 0;
    }
    let mut unit = 10;
    while unit <= last - first {
        unit *= 10;
    }
    // The round number between the ticks, if there is one, else the next one towards zero.
    let (low, high) = if first > 0 { (first, last) } else { (-last, -first) };
    let offset = first.signum() * (high / unit * unit);
    let offset = if high / unit > low / unit { offset } else { first.signum() * (low / unit * unit) };
    // An offset worth saying saves at least four digits.
    if offset.unsigned_abs() / unit.unsigned_abs() >= 1000 { offset } else { 0 }
}

/// n · 10^exponent, correctly rounded.
fn decimal(n: i64, exponent: i32) -> f64 {
    format!("{n}e{exponent}").parse().unwrap_or(f64::NAN)
}

/// The decimal n · 10^exponent: a true minus sign, thin spaces from five digits on, no superfluous zeros.
fn write(n: i64, exponent: i32) -> String {
    if !(-12..=6).contains(&exponent) {
        let (mut n, mut exponent) = (n, exponent);
        while n != 0 && n % 10 == 0 {
            (n, exponent) = (n / 10, exponent + 1);
        }
        let text = n.to_string().replace('-', "−");
        return if n == 0 { text } else { format!("{text}×10{}", superscript(exponent)) };
    }
    let mut digits = n.unsigned_abs().to_string();
    let fraction = if exponent >= 0 {
        if n != 0 {
            digits.extend((0..exponent).map(|_| '0'));
        }
        String::new()
    } else {
        let places = exponent.unsigned_abs() as usize;
        let padded = format!("{digits:0>width$}", width = places + 1);
        let (whole, fraction) = padded.split_at(padded.len() - places);
        let fraction = fraction.trim_end_matches('0').to_owned();
        digits = whole.to_owned();
        fraction
    };
    let mut text = if n < 0 { String::from("−") } else { String::new() };
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && digits.len() > 4 && (digits.len() - i).is_multiple_of(3) {
            text.push('\u{2009}');
        }
        text.push(digit);
    }
    if !fraction.is_empty() {
        text.push('.');
        text.push_str(&fraction);
    }
    text
}

/// A number of at most `digits` significant digits for a running text.
pub(crate) fn rounded(x: f64, digits: usize) -> String {
    let text = format!("{x:.0$e}", digits.saturating_sub(1));
    let Some((mantissa, exponent)) = text.split_once('e') else { return shortest(x) };
    let places = mantissa.split_once('.').map_or(0, |(_, f)| f.len() as i32);
    let n = mantissa.replace('.', "").parse::<i64>().unwrap_or(0);
    let exponent = exponent.parse::<i32>().unwrap_or(0);
    if (-4..6).contains(&exponent) {
        write(n, exponent - places)
    } else {
        format!("{}×10{}", write(n, -places), superscript(exponent))
    }
}

/// The shortest decimal that reads back as x.
fn shortest(x: f64) -> String {
    let text = if x == 0.0 || (1e-4..1e7).contains(&x.abs()) { format!("{x}") } else { format!("{x:e}") };
    let text = match text.split_once('e') {
        Some((mantissa, exponent)) => format!("{mantissa}×10{}", superscript(exponent.parse().unwrap_or(0))),
        None => text,
    };
    text.replace('-', "−")
}

fn superscript(n: i32) -> String {
    n.to_string()
        .chars()
        .map(|c| match c {
            '-' => '⁻',
            '1' => '¹',
            '2' => '²',
            '3' => '³',
            c => char::from_u32(0x2070 + c.to_digit(10).unwrap_or(0)).unwrap_or(c),
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What a label and its note say, read back as a reader would: (offset + label × power).
    fn read(label: &str, note: Option<&str>) -> f64 {
        let plain = |text: &str| text.replace('\u{2009}', "").replace('−', "-");
        let power = |text: &str| -> i32 {
            let digit = |c| "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().position(|d| d == c).map_or("-".to_owned(), |i| i.to_string());
            text.chars().map(digit).collect::<String>().parse().unwrap()
        };
        let (offset, factor) = match note.map(|note| note.rsplit_once(" +").unwrap_or(("0", note))) {
            None => ("0", 0),
            Some((offset, factor)) => (offset, factor.trim().strip_prefix("×10").map_or(0, power)),
        };
        let (offset, raised) = offset.split_once("×10").unwrap_or((offset, "⁰"));
        let (offset, raised) = (plain(offset), power(raised));
        let (label, own) = label.split_once("×10").unwrap_or((label, "⁰"));
        let (label, factor) = (plain(label), factor + power(own));
        // Decimals add exactly as integers at the lower of their last places.
        let integer = |text: &str, raised: i32| -> (i128, i32) {
            let places = text.split_once('.').map_or(0, |(_, f)| f.len() as i32);
            (text.replace('.', "").parse().unwrap(), raised - places)
        };
        let (mut a, mut b) = (integer(&label, factor), integer(&offset, raised));
        if a.0 == 0 || b.0 == 0 {
            (a, b) = if a.0 == 0 { (b, (0, b.1)) } else { (a, (0, a.1)) };
        } else if a.1 > b.1 {
            (a, b) = (b, a);
        }
        b.0 *= 10_i128.pow((b.1 - a.1) as u32);
        format!("{}e{}", a.0 + b.0, a.1).parse().unwrap()
    }

    fn axis(lo: f64, hi: f64) -> Ticks {
        ticks(lo, hi, 800.0, 80.0, |label| 7.0 * label.chars().count() as f64 + 14.0)
    }

    fn labels(lo: f64, hi: f64) -> (Vec<String>, Option<String>) {
        let axis = axis(lo, hi);
        (axis.ticks.into_iter().map(|t| t.label).collect(), axis.note)
    }

    #[test]
    fn ordinary_axes() {
        assert_eq!(
            labels(0.0, 1.0),
            (
                ["0", "0.1", "0.2", "0.3", "0.4", "0.5", "0.6", "0.7", "0.8", "0.9", "1"].map(String::from).to_vec(),
                None
            )
        );
        assert_eq!(labels(-3.0, 3.9).0, ["−3", "−2", "−1", "0", "1", "2", "3"]);
        assert_eq!(
            labels(1871.0, 1970.0).0,
            ["1880", "1890", "1900", "1910", "1920", "1930", "1940", "1950", "1960", "1970"]
        );
        assert_eq!(
            labels(0.0, 60_000.0).0,
            ["0", "10\u{2009}000", "20\u{2009}000", "30\u{2009}000", "40\u{2009}000", "50\u{2009}000", "60\u{2009}000"]
        );
        assert_eq!(labels(0.3, 0.1), labels(0.1, 0.3));
    }

    #[test]
    fn offsets_and_powers_are_said_once() {
        let (text, note) = labels(1e7, 1e7 + 1e-3);
        assert_eq!(note.as_deref(), Some("10\u{2009}000\u{2009}000 +"));
        assert_eq!(text[..3], ["0", "0.0001", "0.0002"]);
        let (text, note) = labels(0.0, 1e-9);
        assert_eq!((text[1].as_str(), note.as_deref()), ("0.1", Some("×10⁻⁹")));
        let (text, note) = labels(-1e300, 1e300);
        assert_eq!(note.as_deref(), Some("×10³⁰⁰"));
        assert_eq!(text.first().map(String::as_str), Some("−1"));
        let (text, note) = labels(-1e9 - 5.0, -1e9);
        assert_eq!(note.as_deref(), Some("−1\u{2009}000\u{2009}000\u{2009}000 +"));
        let (around, note) = labels(1e7 - 1e-3, 1e7 + 1e-3);
        assert_eq!((around[0].as_str(), note.as_deref()), ("−0.001", Some("10\u{2009}000\u{2009}000 +")));
        assert_eq!((text[0].as_str(), text[text.len() - 1].as_str()), ("−5", "0"));
    }

    /// Over the whole range of numbers: labels are distinct, ticks increase inside the axis, nothing overlaps, and each
    /// label together with its note is the value.
    #[test]
    fn laws_at_every_scale() {
        let mut cases = vec![
            (0.0, f64::MIN_POSITIVE),
            (0.0, 5e-324),
            (-f64::MAX, f64::MAX),
            (1e16, 1e16 + 4.0),
            (1.0, 1.0 + f64::EPSILON),
        ];
        for e in (-300..=300).step_by(7) {
            let s = decimal(1, e);
            for (a, b) in [
                (0.0, 1.0),
                (-1.0, 1.0),
                (3.3, 7.1),
                (-0.7, -0.1),
                (1000.0, 1000.7),
                (1e7, 1e7 + 0.001),
                (-1e7 - 0.3, -1e7),
            ] {
                cases.push((a * s, b * s));
            }
        }
        for (lo, hi) in cases {
            for length in [1.0, 30.0, 200.0, 900.0, 16_000.0] {
                let room = |label: &str| 7.0 * label.chars().count() as f64 + 10.0;
                let axis = ticks(lo, hi, length, 50.0, room);
                let slack = (hi / 2.0 - lo / 2.0) * 1e-6 + (lo.abs() / 4.0 + hi.abs() / 4.0) * 1e-15;
                for pair in axis.ticks.windows(2) {
                    assert!(pair[0].value < pair[1].value, "{lo} {hi} {axis:?}");
                    assert_ne!(pair[0].label, pair[1].label, "{lo} {hi} {axis:?}");
                    let px = (pair[1].value / 2.0 - pair[0].value / 2.0) / (hi / 2.0 - lo / 2.0) * length;
                    assert!(px >= (room(&pair[0].label) + room(&pair[1].label)) / 2.0);
                }
                for tick in &axis.ticks {
                    assert_eq!(read(&tick.label, axis.note.as_deref()), tick.value, "{axis:?}");
                    assert!(lo - slack <= tick.value && tick.value <= hi + slack, "{lo} {hi} {axis:?}");
                    assert!(tick.label.chars().count() <= 12, "{lo} {hi} {axis:?}");
                }
                assert!(axis.ticks.len() <= 1 + (length / 50.0) as usize);
            }
        }
    }

    #[test]
    fn degenerate_axes() {
        assert_eq!(labels(2.5, 2.5).0, ["2.5"]);
        assert_eq!(labels(-1e-12, -1e-12).0, ["−1×10⁻¹²"]);
        assert!(labels(f64::NAN, 1.0).0.is_empty());
        assert!(labels(0.0, f64::INFINITY).0.is_empty());
        assert!(ticks(0.0, 1.0, 0.0, 50.0, |_| 0.0).ticks.is_empty());
    }

    #[test]
    fn running_text() {
        assert_eq!(rounded(121.36, 3), "121");
        assert_eq!(rounded(0.4249, 2), "0.42");
        assert_eq!(rounded(0.0, 2), "0");
        assert_eq!(rounded(-1234.5, 2), "−1200");
        assert_eq!(rounded(1.26e-9, 2), "1.3×10⁻⁹");
        assert_eq!(rounded(9.96, 2), "10");
    }
}
