//! Words that options take: listed in the help and to the shells, and suggested where one is mistyped.

use clap::builder::{PossibleValue, StringValueParser, TypedValueParser};
use clap::{Arg, Command};
use std::ffi::OsStr;

/// A word with its explanation.
pub(crate) type Word = (&'static str, &'static str);

/// The parser of an option whose value begins with one of some words, such as `cardinal` or `cardinal:1/2`.
#[derive(Clone, Copy)]
pub(crate) struct Words<T> {
    pub(crate) known: &'static [Word],
    pub(crate) parse: fn(&str) -> Result<T, String>,
}

impl<T: Clone + Send + Sync + 'static> TypedValueParser for Words<T> {
    type Value = T;

    fn parse_ref(&self, command: &Command, arg: Option<&Arg>, value: &OsStr) -> Result<T, clap::Error> {
        let parse = self.parse;
        StringValueParser::new().try_map(move |text: String| parse(&text)).parse_ref(command, arg, value)
    }

    fn possible_values(&self) -> Option<Box<dyn Iterator<Item = PossibleValue> + '_>> {
        Some(Box::new(self.known.iter().map(|(word, help)| PossibleValue::new(*word).help(*help))))
    }
}

/// What to say about a word that is none of the known ones.
pub(crate) fn unknown(what: &str, word: &str, known: &[Word]) -> String {
    let names = known.iter().map(|(name, _)| *name);
    let nearest = names.clone().map(|name| (distance(word, name), name)).min();
    match nearest {
        Some((steps, name)) if steps <= 1 + name.len() / 4 => {
            format!("\"{word}\" is no {what}; a similar one is '{name}'")
        }
        _ => format!("\"{word}\" is no {what}; there are {}", names.collect::<Vec<_>>().join(", ")),
    }
}

/// How many letters must be put in, left out, replaced or swapped with the next to make one word of the other.
fn distance(a: &str, b: &str) -> usize {
    let (a, b): (Vec<char>, Vec<char>) = (a.chars().take(64).collect(), b.chars().collect());
    let mut rows = vec![vec![0; b.len() + 1]; a.len() + 1];
    for i in 0..=a.len() {
        for j in 0..=b.len() {
            rows[i][j] = match (i, j) {
                (i, 0) => i,
                (0, j) => j,
                _ => {
                    let replaced = rows[i - 1][j - 1] + usize::from(a[i - 1] != b[j - 1]);
                    let least = replaced.min(rows[i - 1][j] + 1).min(rows[i][j - 1] + 1);
                    let swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
                    if swapped { least.min(rows[i - 2][j - 2] + 1) } else { least }
                }
            };
        }
    }
    rows[a.len()][b.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn similar_words_are_suggested() {
        const KNOWN: &[Word] = &[("pchip", ""), ("catmull-rom", ""), ("cubic", "")];
        assert_eq!((distance("phcip", "pchip"), distance("", "abc"), distance("abc", "abd")), (1, 3, 1));
        assert!(unknown("kind", "phcip", KNOWN).ends_with("'pchip'"));
        assert!(unknown("kind", "catmulrom", KNOWN).ends_with("'catmull-rom'"));
        assert!(unknown("kind", "bezier", KNOWN).ends_with("there are pchip, catmull-rom, cubic"));
    }
}
