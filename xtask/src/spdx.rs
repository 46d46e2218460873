//! Licence expressions: may a crate be used under licences from a given list alone?
//!
//! The grammar is SPDX's (annex D of the specification): `AND` binds tighter than `OR`, `WITH` tighter than both, and
//! parentheses group. The old `/` of Cargo manifests means `OR`. `A OR B` leaves the choice to us, so one allowed side
//! is enough; `A AND B` binds us to both. An exception only adds permissions to its licence, so it never refuses one.

/// Whether the expression can be satisfied by allowed licences.
///
/// An expression that does not parse is an error, never a silent no.
pub(crate) fn satisfied(expression: &str, allowed: &[String]) -> Result<bool, String> {
    let spaced = expression.replace('(', " ( ").replace(')', " ) ").replace('/', " OR ");
    let words: Vec<&str> = spaced.split_whitespace().collect();
    let mut reader = Reader { words: &words, allowed };
    let answer = reader.alternatives();
    match (answer, reader.words) {
        (Some(answer), []) => Ok(answer),
        (_, rest) => Err(format!("`{expression}` is no licence expression, from `{}` on", rest.join(" "))),
    }
}

struct Reader<'a> {
    words: &'a [&'a str],
    allowed: &'a [String],
}

impl<'a> Reader<'a> {
    fn take(&mut self, word: &str) -> bool {
        match self.words.split_first() {
            Some((first, rest)) if *first == word => {
                self.words = rest;
                true
            }
            _ => false,
        }
    }

    fn alternatives(&mut self) -> Option<bool> {
        let mut any = self.obligations()?;
        while self.take("OR") {
            any |= self.obligations()?;
        }
        Some(any)
    }

    fn obligations(&mut self) -> Option<bool> {
        let mut all = self.licence()?;
        while self.take("AND") {
            all &= self.licence()?;
        }
        Some(all)
    }

    fn licence(&mut self) -> Option<bool> {
        if self.take("(") {
            let inner = self.alternatives()?;
            return self.take(")").then_some(inner);
        }
        let name = self.name()?;
        if self.take("WITH") {
            self.name()?;
        }
        Some(self.allowed.iter().any(|licence| licence == name))
    }

    fn name(&mut self) -> Option<&'a str> {
        let (first, rest) = self.words.split_first()?;
        if matches!(*first, "(" | ")" | "OR" | "AND" | "WITH") {
            return None;
        }
        self.words = rest;
        Some(first)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ask(expression: &str) -> Result<bool, String> {
        let allowed = ["MIT", "Apache-2.0", "Unicode-3.0"].map(String::from);
        satisfied(expression, &allowed)
    }

    #[test]
    fn alternatives_need_one_and_obligations_all() {
        for (expression, answer) in [
            ("MIT", true),
            ("GPL-3.0-only", false),
            ("MIT OR GPL-3.0-only", true),
            ("MIT AND GPL-3.0-only", false),
            ("MIT OR Apache-2.0 OR LGPL-2.1-or-later", true),
            ("LGPL-2.1-or-later", false),
            ("(MIT OR Apache-2.0) AND Unicode-3.0", true),
            ("(MIT OR Apache-2.0) AND GPL-2.0-only", false),
            ("GPL-2.0-only AND MIT OR Apache-2.0", true),
            ("GPL-2.0-only AND (MIT OR Apache-2.0)", false),
            ("Apache-2.0 WITH LLVM-exception OR GPL-3.0-only", true),
            ("GPL-2.0-only WITH Classpath-exception-2.0", false),
            ("MIT/Apache-2.0", true),
            ("AGPL-3.0-only/GPL-3.0-only", false),
        ] {
            assert_eq!(ask(expression), Ok(answer), "{expression}");
        }
    }

    #[test]
    fn nonsense_is_an_error() {
        for expression in ["", "MIT OR", "OR MIT", "(MIT", "MIT)", "MIT Apache-2.0", "MIT WITH", "()", "MIT AND OR MIT"]
        {
            assert!(ask(expression).is_err(), "{expression}");
        }
    }
}
