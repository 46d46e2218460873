//! The JSON object of one shape, on its way out.

use std::fmt::Write as _;

use lath::error::Code as CoreCode;

use crate::error::{Code, Error, Result};
use crate::number::shortest;

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
}

impl Member {
    /// The first `dimension` coordinates of each point.
    pub(crate) fn points<const D: usize>(points: &[[f64; D]], dimension: usize) -> Member {
        Member::Rows(dimension, points.iter().flat_map(|point| point.iter().take(dimension).copied()).collect())
    }
}

impl Object {
    pub(crate) fn push(&mut self, key: &'static str, member: Member) {
        self.0.push((key, member));
    }

    pub(crate) fn extend(&mut self, other: Object) {
        self.0.extend(other.0);
    }

    /// Appends the object, indented by two blanks.
    ///
    /// # Errors
    /// P002 for a number that is not finite.
    pub(crate) fn print(&self, out: &mut String) -> Result<()> {
        out.push_str("  {");
        for (index, (key, member)) in self.0.iter().enumerate() {
            let comma = if index == 0 { "" } else { "," };
            // Writing into a String cannot fail.
            let _ = write!(out, "{comma}\n    \"{key}\": ");
            match member {
                Member::Text(text) => out.push_str(&serde_json::Value::from(text.as_str()).to_string()),
                Member::Whole(number) => out.push_str(&number.to_string()),
                Member::Flag(flag) => out.push_str(&flag.to_string()),
                Member::Numbers(numbers) => list(numbers, key, out)?,
                Member::Rows(width, values) => {
                    out.push('[');
                    for (row, numbers) in values.chunks((*width).max(1)).enumerate() {
                        out.push_str(if row == 0 { "\n      " } else { ",\n      " });
                        list(numbers, key, out)?;
                    }
                    out.push_str("\n    ]");
                }
            }
        }
        out.push_str("\n  }");
        Ok(())
    }
}

fn list(numbers: &[f64], key: &str, out: &mut String) -> Result<()> {
    out.push('[');
    for (index, &number) in numbers.iter().enumerate() {
        if !number.is_finite() {
            return Err(Error::new(Code::Core(CoreCode::P002), format!("{number} in \"{key}\" cannot be written")));
        }
        let comma = if index == 0 { "" } else { ", " };
        let _ = write!(out, "{comma}{}", shortest(number));
    }
    out.push(']');
    Ok(())
}
