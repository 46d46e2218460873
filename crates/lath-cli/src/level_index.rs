//! A place in a level as one word: `LEVEL:INDEX`.

use crate::numbers;
use lath::error::Error;
use lath::subdivide::Index;
use std::str::FromStr;

/// A level and an index of any length.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct LevelIndex {
    pub(crate) level: usize,
    pub(crate) index: Index,
}

impl FromStr for LevelIndex {
    type Err = String;

    fn from_str(text: &str) -> Result<LevelIndex, String> {
        let (level, digits) = text.split_once(':').ok_or("a level and an index are needed, such as 60:123456789")?;
        Ok(LevelIndex { level: self::level(level)?, index: index(digits)? })
    }
}

/// A level: what is too high, the library says.
pub(crate) fn level(text: &str) -> Result<usize, String> {
    Ok(usize::try_from(numbers::count(text)?).unwrap_or(usize::MAX))
}

/// An index of any length.
pub(crate) fn index(text: &str) -> Result<Index, String> {
    let digits = text.trim();
    match digits.chars().all(|digit| digit.is_ascii_digit()) && !digits.is_empty() {
        true => digits.parse().map_err(|error: Error| error.to_string()),
        false => Err(format!("\"{digits}\" is no index: decimal digits are needed")),
    }
}
