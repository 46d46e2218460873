//! The JSON object of one shape, on its way out.

use std::fmt::Write as _;

use lath::error::Code as CoreCode;

use crate::error::{Code, Error, Result};
use crate::number::Printer;

/// The members that define a shape, in the order of writing.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Object(Vec<(&'static str, Member)>);

/// The value of one member.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Member {
    Text(String),
    Whole(usize),
    Flag(bool),
    Numbers(Vec<f64>),
    /// Rows of a width, one after another.
    Rows(usize, Vec<f64>),
    /// Several of the above.
    Blocks(Vec<Member>),
    Objects(Vec<Object>),
}

impl Member {
    /// The first `dimension` coordinates of each point.
    pub(crate) fn points<const D: usize>(points: &[[f64; D]], dimension: usize) -> Member {
        Member::Rows(dimension, points.iter().flat_map(|point| point.iter().take(dimension).copied()).collect())
    }
}

impl Object {
    /// The object of a shape: its kind, its name where it has one, and what defines it.
    pub(crate) fn of_kind(kind: &'static str, name: Option<&str>, body: Object) -> Object {
        let mut object = Object::default();
        object.push("kind", Member::Text(kind.to_owned()));
        if let Some(name) = name {
            object.push("name", Member::Text(name.to_owned()));
        }
        object.0.extend(body.0);
        object
    }

    pub(crate) fn into_members(self) -> Vec<(&'static str, Member)> {
        self.0
    }

    pub(crate) fn push(&mut self, key: &'static str, member: Member) {
        self.0.push((key, member));
    }

    /// Appends the object, indented by `depth` steps of two blanks.
    ///
    /// # Errors
    /// P002 for a number that is not finite.
    pub(crate) fn print(&self, depth: usize, out: &mut String) -> Result<()> {
        out.push('{');
        for (index, (key, member)) in self.0.iter().enumerate() {
            out.push_str(if index == 0 { "" } else { "," });
            new_line(depth + 1, out);
            // Writing into a String cannot fail.
            let _ = write!(out, "\"{key}\": ");
            member.print(key, depth + 1, out)?;
        }
        new_line(depth, out);
        out.push('}');
        Ok(())
    }
}

impl Member {
    fn print(&self, key: &str, depth: usize, out: &mut String) -> Result<()> {
        match self {
            Member::Text(text) => out.push_str(&serde_json::Value::from(text.as_str()).to_string()),
            Member::Whole(number) => out.push_str(&number.to_string()),
            Member::Flag(flag) => out.push_str(&flag.to_string()),
            Member::Numbers(numbers) => list(numbers, key, out)?,
            Member::Rows(width, values) => {
                items(values.chunks((*width).max(1)), depth, out, |numbers, out| list(numbers, key, out))?;
            }
            Member::Blocks(blocks) => items(blocks, depth, out, |block, out| block.print(key, depth + 1, out))?,
            Member::Objects(objects) => items(objects, depth, out, |object, out| object.print(depth + 1, out))?,
        }
        Ok(())
    }
}

/// An array with one item a line.
fn items<T>(
    items: impl IntoIterator<Item = T>,
    depth: usize,
    out: &mut String,
    print: impl Fn(T, &mut String) -> Result<()>,
) -> Result<()> {
    out.push('[');
    for (index, item) in items.into_iter().enumerate() {
        out.push_str(if index == 0 { "" } else { "," });
        new_line(depth + 1, out);
        print(item, out)?;
    }
    new_line(depth, out);
    out.push(']');
    Ok(())
}

fn new_line(depth: usize, out: &mut String) {
    out.push('\n');
    out.extend(core::iter::repeat_n("  ", depth));
}

fn list(numbers: &[f64], key: &str, out: &mut String) -> Result<()> {
    let mut printer = Printer::new();
    out.push('[');
    for (index, &number) in numbers.iter().enumerate() {
        if !number.is_finite() {
            return Err(Error::new(Code::Core(CoreCode::P002), format!("{number} in \"{key}\" cannot be written")));
        }
        out.push_str(if index == 0 { "" } else { ", " });
        out.push_str(printer.print(number));
    }
    out.push(']');
    Ok(())
}
