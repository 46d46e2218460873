//! Numbers of things in messages.

use core::fmt;

/// So many of something, by its word in the singular: "1 point", "2 points".
pub(crate) struct Count(pub(crate) usize, pub(crate) &'static str);

impl fmt::Display for Count {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Count(number, word) = self;
        write!(f, "{number} {word}{}", if *number == 1 { "" } else { "s" })
    }
}

#[cfg(test)]
mod tests {
    use super::Count;
    use alloc::string::ToString;

    #[test]
    fn one_is_singular() {
        assert_eq!([0, 1, 2].map(|n| Count(n, "point").to_string()), ["0 points", "1 point", "2 points"]);
    }
}
