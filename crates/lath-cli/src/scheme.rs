//! Subdivision schemes as words: `chaikin`, `cubic`, `degree:P`, `four-point:W`, `mask:a,b,…`.

use crate::numbers::{count, finite, list};
use crate::words::{Word, Words, unknown};
use lath::subdivide::Scheme;

/// What `--scheme` takes.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum SchemeWord {
    Chaikin,
    Cubic,
    Degree(u64),
    FourPoint(f64),
    Mask(Vec<f64>),
}

const KNOWN: &[Word] = &[
    ("chaikin", "Cuts corners at a quarter and three quarters of each side; degree 2"),
    ("cubic", "Edge points and vertex points; degree 3"),
    ("degree", "Lane and Riesenfeld's scheme of any degree, degree:P"),
    ("four-point", "Passes through the points; four-point:W with a tension W (default 1/16)"),
    ("mask", "A mask of your own, mask:a,b,…; the numbers of even and of odd index each sum to 1"),
];

/// The parser of `--scheme`.
pub(crate) const SCHEMES: Words<SchemeWord> = Words { known: KNOWN, parse };

fn parse(text: &str) -> Result<SchemeWord, String> {
    let (name, value) = match text.split_once(':') {
        Some((name, value)) => (name.trim(), Some(value)),
        None => (text.trim(), None),
    };
    match (name, value) {
        ("chaikin", None) => Ok(SchemeWord::Chaikin),
        ("cubic", None) => Ok(SchemeWord::Cubic),
        ("degree", Some(degree)) => count(degree).map(SchemeWord::Degree),
        ("degree", None) => Err("the degree is missing: degree:P".into()),
        ("four-point", tension) => Ok(SchemeWord::FourPoint(tension.map_or(Ok(1.0 / 16.0), finite)?)),
        ("mask", Some(mask)) => list(mask, finite).map(SchemeWord::Mask),
        ("mask", None) => Err("the numbers are missing: mask:a,b,…".into()),
        ("chaikin" | "cubic", Some(value)) => Err(format!("{name} takes no number, but \"{value}\" follows it")),
        _ => Err(unknown("scheme", name, KNOWN)),
    }
}

impl SchemeWord {
    /// The scheme.
    ///
    /// # Errors
    /// K006 for the degree, S001 and S002 for the mask.
    pub(crate) fn scheme(&self) -> Result<Scheme, lath_io::Error> {
        let scheme = match self {
            SchemeWord::Chaikin => Ok(Scheme::chaikin()),
            SchemeWord::Cubic => Ok(Scheme::cubic()),
            SchemeWord::Degree(degree) => Scheme::lane_riesenfeld(usize::try_from(*degree).unwrap_or(usize::MAX)),
            SchemeWord::FourPoint(tension) => Scheme::four_point(tension),
            SchemeWord::Mask(mask) => Scheme::from_mask(mask.clone()),
        };
        scheme.map_err(|error| lath_io::Error::from(error).in_source("--scheme"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn schemes_as_words() {
        assert_eq!(parse("degree:5"), Ok(SchemeWord::Degree(5)));
        assert_eq!(parse("four-point"), Ok(SchemeWord::FourPoint(0.0625)));
        assert_eq!(parse("four-point:-1/8"), Ok(SchemeWord::FourPoint(-0.125)));
        assert_eq!(parse("mask:1/4,3/4,3/4,1/4"), Ok(SchemeWord::Mask(vec![0.25, 0.75, 0.75, 0.25])));
        for wrong in ["", "degree", "degree:", "degree:-1", "mask", "mask:1,,1", "cubic:3", "chaiken", "four-point:x"] {
            assert!(parse(wrong).is_err(), "{wrong}");
        }
        assert!(parse("chaiken").is_err_and(|message| message.contains("'chaikin'")));
    }
}
