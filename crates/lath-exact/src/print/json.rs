//! JSON, written by hand: seven kinds of value and no input.

use crate::matrix::Matrix;
use crate::rational::Rational;

/// A JSON value.
pub(crate) enum Json {
    Null,
    Number(u64),
    Text(String),
    List(Vec<Json>),
    Object(Vec<(String, Json)>),
}

/// An object of these members, in this order.
pub(crate) fn object<const N: usize>(members: [(&str, Json); N]) -> Json {
    Json::Object(members.into_iter().map(|(key, value)| (key.to_owned(), value)).collect())
}

impl Json {
    pub(crate) fn count(n: usize) -> Json {
        Json::Number(n as u64)
    }

    pub(crate) fn fraction(x: &Rational) -> Json {
        Json::Text(x.to_string())
    }

    pub(crate) fn fractions(values: &[Rational]) -> Json {
        Json::List(values.iter().map(Json::fraction).collect())
    }

    pub(crate) fn optional(values: Option<&[Rational]>) -> Json {
        values.map_or(Json::Null, Json::fractions)
    }

    pub(crate) fn rows(rows: &[Vec<Rational>]) -> Json {
        Json::List(rows.iter().map(|row| Json::fractions(row)).collect())
    }

    pub(crate) fn matrix(matrix: &Matrix) -> Json {
        Json::rows(matrix.rows())
    }

    pub(crate) fn write(&self, out: &mut String) {
        match self {
            Json::Null => out.push_str("null"),
            Json::Number(n) => out.push_str(&n.to_string()),
            Json::Text(text) => string(text, out),
            Json::List(items) => {
                out.push('[');
                for (i, item) in items.iter().enumerate() {
                    if i > 0 {
                        out.push(',');
                    }
                    item.write(out);
                }
                out.push(']');
            }
            Json::Object(members) => {
                out.push('{');
                for (i, (key, value)) in members.iter().enumerate() {
                    if i > 0 {
                        out.push(',');
                    }
                    string(key, out);
                    out.push(':');
                    value.write(out);
                }
                out.push('}');
            }
        }
    }

    pub(crate) fn print(&self) -> String {
        let mut out = String::new();
        self.write(&mut out);
        out
    }
}

fn string(text: &str, out: &mut String) {
    out.push('"');
    for c in text.chars() {
        match c {
            '"' => out.push_str("\\\""),
            '\\' => out.push_str("\\\\"),
            c if c < ' ' => out.push_str(&format!("\\u{:04x}", c as u32)),
            c => out.push(c),
        }
    }
    out.push('"');
}
