//! Just enough of Rust's grammar to find paths: comments, strings and character literals out, words and `::` in.

/// What is left of a source for the question "which paths does it name".
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Token {
    /// An identifier or keyword; raw identifiers without their `r#`.
    Word(String),
    /// `::`
    Colons,
    /// Any other character that is not blank.
    Mark(char),
}

/// The tokens of a source, each with its line, counted from 1.
pub(super) fn tokens(text: &str) -> Vec<(Token, usize)> {
    let chars: Vec<char> = text.chars().collect();
    let at = |i: usize| chars.get(i).copied().unwrap_or('\0');
    let (mut found, mut line, mut i) = (Vec::new(), 1, 0);
    while i < chars.len() {
        let start = i;
        match (at(i), at(i + 1)) {
            ('/', '/') => {
                while i < chars.len() && at(i) != '\n' {
                    i += 1;
                }
            }
            ('/', '*') => i = end_of_block_comment(&chars, i),
            ('r', '"' | '#') if raw_string_end(&chars, i).is_some() => i = raw_string_end(&chars, i).unwrap_or(i + 1),
            ('b', 'r') if raw_string_end(&chars, i + 1).is_some() => i = raw_string_end(&chars, i + 1).unwrap_or(i + 1),
            ('r', '#') => i += 2,
            ('"', _) => {
                i += 1;
                while i < chars.len() && at(i) != '"' {
                    i += if at(i) == '\\' { 2 } else { 1 };
                }
                i += 1;
            }
            // A character literal; otherwise a lifetime, of which only the tick is skipped.
            ('\'', '\\') => {
                i += 3;
                while i < chars.len() && at(i) != '\'' {
                    i += 1;
                }
                i += 1;
            }
            ('\'', _) => i += if at(i + 2) == '\'' { 3 } else { 1 },
            (':', ':') => {
                found.push((Token::Colons, line));
                i += 2;
            }
            (c, _) if c.is_alphabetic() || c == '_' => {
                while at(i).is_alphanumeric() || at(i) == '_' {
                    i += 1;
                }
                found.push((Token::Word(chars[start..i].iter().collect()), line));
            }
            (c, _) => {
                if !c.is_whitespace() {
                    found.push((Token::Mark(c), line));
                }
                i += 1;
            }
        }
        i = i.min(chars.len());
        line += chars[start..i].iter().filter(|c| **c == '\n').count();
    }
    found
}

fn end_of_block_comment(chars: &[char], start: usize) -> usize {
    let (mut depth, mut i) = (0, start);
    while i < chars.len() {
        match (chars[i], chars.get(i + 1)) {
            ('/', Some('*')) => (depth, i) = (depth + 1, i + 2),
            ('*', Some('/')) => (depth, i) = (depth - 1, i + 2),
            _ => i += 1,
        }
        if depth == 0 {
            break;
        }
    }
    i
}

/// Where the raw string that starts at `start` (its `r`) ends; none if there is no raw string.
fn raw_string_end(chars: &[char], start: usize) -> Option<usize> {
    let hashes = chars[start + 1..].iter().take_while(|c| **c == '#').count();
    let open = start + 1 + hashes;
    if chars.get(start) != Some(&'r') || chars.get(open) != Some(&'"') {
        return None;
    }
    let closes = |i: usize| chars[i] == '"' && chars[i + 1..].iter().take_while(|c| **c == '#').count() >= hashes;
    let end = (open + 1..chars.len()).find(|&i| closes(i))?;
    Some(end + 1 + hashes)
}

/// A path of the crate, made absolute: `knot::span::Side` for `use super::span::Side` in `knot/vector.rs`.
#[derive(Debug, PartialEq)]
pub(super) struct Import {
    /// The segments below the crate root; empty for the root itself.
    pub(super) path: Vec<String>,
    /// The line of its first segment.
    pub(super) line: usize,
}

/// Every path that starts with `crate`, `super` or `self`, in `use` trees and inline, seen from the given module.
pub(super) fn paths(tokens: &[(Token, usize)], module: &[&str]) -> Vec<Import> {
    let word = |i: usize| match tokens.get(i) {
        Some((Token::Word(word), _)) => word.as_str(),
        _ => "",
    };
    let is = |i: usize, token: &Token| tokens.get(i).is_some_and(|(other, _)| other == token);
    let mut here: Vec<String> = module.iter().map(|segment| (*segment).to_owned()).collect();
    let mut inner: Vec<usize> = Vec::new(); // the brace depths at which inline modules opened
    let (mut found, mut depth, mut i) = (Vec::new(), 0, 0);
    while i < tokens.len() {
        if is(i, &Token::Mark('{')) {
            depth += 1;
        } else if is(i, &Token::Mark('}')) {
            depth -= 1;
            if inner.last() == Some(&depth) {
                inner.pop();
                here.pop();
            }
        } else if word(i) == "mod" && !word(i + 1).is_empty() && is(i + 2, &Token::Mark('{')) {
            here.push(word(i + 1).to_owned());
            inner.push(depth);
        } else if matches!(word(i), "crate" | "super" | "self")
            && is(i + 1, &Token::Colons)
            && (i == 0 || !is(i - 1, &Token::Colons))
        {
            i = tree(tokens, i, &[], &here, &mut found);
            continue;
        }
        i += 1;
    }
    found
}

/// Reads one path or `use` tree from token `i` on, appends its leaves, and returns the index after it.
fn tree(tokens: &[(Token, usize)], mut i: usize, prefix: &[String], here: &[String], found: &mut Vec<Import>) -> usize {
    let mut path = prefix.to_vec();
    let line = tokens.get(i).map_or(0, |token| token.1);
    loop {
        match tokens.get(i).map(|token| &token.0) {
            Some(Token::Word(word)) => {
                path.push(word.clone());
                i += 1;
                if tokens.get(i).is_some_and(|token| token.0 == Token::Colons) {
                    i += 1;
                    continue;
                }
            }
            Some(Token::Mark('{')) => {
                i += 1;
                while i < tokens.len() && tokens[i].0 != Token::Mark('}') {
                    let next = tree(tokens, i, &path, here, found);
                    // A renaming (`as x`) or a comma stands between the branches.
                    i = next.max(i + 1);
                    while i < tokens.len() && !matches!(tokens[i].0, Token::Mark(',' | '}')) {
                        i += 1;
                    }
                    if i < tokens.len() && tokens[i].0 == Token::Mark(',') {
                        i += 1;
                    }
                }
                return i + 1;
            }
            Some(Token::Mark('*')) => {
                found.push(Import { path: absolute(&path, here), line });
                return i + 1;
            }
            _ => {}
        }
        found.push(Import { path: absolute(&path, here), line });
        return i;
    }
}

fn absolute(path: &[String], here: &[String]) -> Vec<String> {
    let mut base = here.to_vec();
    let mut rest = path;
    while let Some((first, others)) = rest.split_first() {
        match first.as_str() {
            "crate" => base.clear(),
            "super" => drop(base.pop()),
            "self" => {}
            _ => break,
        }
        rest = others;
    }
    base.extend(rest.iter().filter(|segment| *segment != "self").cloned());
    base
}

/// The number of lines that are neither blank nor comment, up to the unit tests that close a file.
pub(super) fn code_lines(text: &str) -> usize {
    let code = text.split("\n#[cfg(test)]\n").next().unwrap_or(text);
    code.lines().map(str::trim_start).filter(|line| !line.is_empty() && !line.starts_with("//")).count()
}
