//! From tree to text: for files that were changed and must stay what else they are.

use crate::json::Json;
use crate::number::shortest;

/// The tree as text: a member a line, a point a line.
pub(crate) fn print(json: &Json) -> String {
    let mut out = String::new();
    value(json, 0, &mut out);
    out.push('\n');
    out
}

fn value(json: &Json, depth: usize, out: &mut String) {
    match json {
        Json::Null => out.push_str("null"),
        Json::Bool(value) => out.push_str(&value.to_string()),
        Json::Number(number) => number_to(*number, out),
        Json::Text(text) => quoted(text, out),
        Json::Numbers(numbers) => {
            out.push('[');
            for (index, &number) in numbers.iter().enumerate() {
                out.push_str(if index == 0 { "" } else { ", " });
                number_to(number, out);
            }
            out.push(']');
        }
        Json::Array(items) => list(('[', ']'), items, depth, out, |item, out| value(item, depth + 1, out)),
        Json::Object(members) => list(('{', '}'), members, depth, out, |(key, member), out| {
            quoted(key, out);
            out.push_str(": ");
            value(member, depth + 1, out);
        }),
    }
}

fn number_to(number: f64, out: &mut String) {
    use core::fmt::Write as _;
    // Writing into a String cannot fail.
    let _ = write!(out, "{}", shortest(number));
}

fn list<T>(brackets: (char, char), items: &[T], depth: usize, out: &mut String, print: impl Fn(&T, &mut String)) {
    let new_line = |depth: usize, out: &mut String| {
        out.push('\n');
        out.extend(core::iter::repeat_n("  ", depth));
    };
    out.push(brackets.0);
    for (index, item) in items.iter().enumerate() {
        out.push_str(if index == 0 { "" } else { "," });
        new_line(depth + 1, out);
        print(item, out);
    }
    if !items.is_empty() {
        new_line(depth, out);
    }
    out.push(brackets.1);
}

fn quoted(text: &str, out: &mut String) {
    out.push_str(&serde_json::Value::from(text).to_string());
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::json::parse;
    use crate::source::Source;
    use lath::error::Limits;

    #[test]
    fn what_is_printed_reads_back() {
        let text =
            r#"{"a\"/": [1, -0, 1e300, 5e-324], "b": [[0.1], []], "c": [1, null, true, "x\n"], "d": {}, "e": "é"}"#;
        let read = |text: &str| parse(&Source::from_bytes("a", text), &Limits::default()).unwrap();
        let tree = read(text);
        assert_eq!(read(&print(&tree)), tree);
        assert_eq!(print(&read("[[1,2],[3]]")), "[\n  [1, 2],\n  [3]\n]\n");
    }
}
