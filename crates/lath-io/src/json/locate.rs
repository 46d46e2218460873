//! Where in the text a member is.
//!
//! serde_json tells no places of values. Faults are rare and files are read once, so the place is looked up when an
//! error needs it: a walk over text that is known to be JSON.

/// The offset of the value that `pointer` names in `text`, which must be valid JSON.
pub(crate) fn locate(text: &str, pointer: &str) -> Option<usize> {
    let mut walk = Walk { text, at: 0 };
    walk.blanks();
    for token in pointer.split('/').skip(1) {
        let key = token.replace("~1", "/").replace("~0", "~");
        match walk.peek()? {
            b'{' => walk.enter_member(&key)?,
            b'[' => walk.enter_item(key.parse().ok()?)?,
            _ => return None,
        }
    }
    Some(walk.at)
}

struct Walk<'a> {
    text: &'a str,
    at: usize,
}

impl Walk<'_> {
    fn peek(&self) -> Option<u8> {
        self.text.as_bytes().get(self.at).copied()
    }

    fn blanks(&mut self) {
        while self.peek().is_some_and(|b| b.is_ascii_whitespace()) {
            self.at += 1;
        }
    }

    /// Over one byte of punctuation and the blanks behind it.
    fn over(&mut self) {
        self.at += 1;
        self.blanks();
    }

    fn enter_member(&mut self, key: &str) -> Option<()> {
        self.over();
        while self.peek()? == b'"' {
            let start = self.at;
            self.skip_string()?;
            let name: String = serde_json::from_str(self.text.get(start..self.at)?).ok()?;
            self.blanks();
            self.over(); // the colon
            if name == key {
                return Some(());
            }
            self.skip_value()?;
            self.over(); // a comma, or the end of the object
        }
        None
    }

    fn enter_item(&mut self, index: usize) -> Option<()> {
        self.over();
        for _ in 0..index {
            self.skip_value()?;
            if self.peek()? != b',' {
                return None;
            }
            self.over();
        }
        (self.peek()? != b']').then_some(())
    }

    /// Over a string, to the byte behind its closing quote.
    fn skip_string(&mut self) -> Option<()> {
        self.at += 1;
        loop {
            match self.peek()? {
                b'"' => break,
                b'\\' => self.at += 2,
                _ => self.at += 1,
            }
        }
        self.at += 1;
        Some(())
    }

    /// Over a value and the blanks behind it.
    fn skip_value(&mut self) -> Option<()> {
        let mut depth = 0_usize;
        loop {
            match self.peek()? {
                b'"' => self.skip_string()?,
                b'[' | b'{' => {
                    depth += 1;
                    self.at += 1;
                }
                b']' | b'}' => {
                    depth = depth.checked_sub(1)?;
                    self.at += 1;
                }
                _ if depth > 0 => self.at += 1,
                _ => {
                    while !matches!(self.peek(), None | Some(b',' | b']' | b'}' | b' ' | b'\t' | b'\n' | b'\r')) {
                        self.at += 1;
                    }
                }
            }
            if depth == 0 {
                self.blanks();
                return Some(());
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::locate;

    #[test]
    fn pointers_lead_to_their_values() {
        let text = r#" {"a": [10, {"x": "]\"}", "b/~c": [true, null, "é"]}, [ ] ], "d" : -1e3 }"#;
        let at = |pointer| locate(text, pointer).map(|i| &text[i..]);
        assert!(at("").unwrap().starts_with("{\"a\""));
        assert!(at("/a/0").unwrap().starts_with("10,"));
        assert!(at("/a/1/x").unwrap().starts_with("\"]"));
        assert!(at("/a/1/b~1~0c/2").unwrap().starts_with("\"é\""));
        assert!(at("/a/2").unwrap().starts_with("[ ]"));
        assert!(at("/d").unwrap().starts_with("-1e3"));
        for absent in ["/b", "/a/3", "/a/2/0", "/a/x", "/d/0", "/a/1/y"] {
            assert_eq!(at(absent), None, "{absent}");
        }
    }

    #[test]
    fn text_that_is_not_json_is_harmless() {
        for text in ["", "{", "[", "{\"a", "{\"a\"", "[1", "[1,", "{\"a\\", "]", "[}]"] {
            for pointer in ["", "/a", "/0", "/1", "/1/2"] {
                let _ = locate(text, pointer);
            }
        }
    }
}
