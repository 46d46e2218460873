//! JSON as the formats here need it: a tree that packs arrays of numbers, and the place of every fault.
//!
//! The grammar is serde_json's. On top of it: a key given twice is an error (serde_json would keep the last), so is
//! anything after the value, nesting beyond 32 levels, and an integer that no double holds exactly, as
//! `9007199254740993`. (Digits beyond 64 bits reach us as decimals and are rounded like every decimal.)
//!
//! A fault found in the tree is known by its JSON pointer; [`place`] finds line and column for it in the text.

mod locate;
mod members;
mod parse;
mod print;
mod rows;

pub(crate) use members::Members;
pub(crate) use parse::parse;
pub(crate) use print::print;
pub(crate) use rows::{Rows, numbers, rows};

use crate::error::Error;
use crate::source::Source;

/// A JSON value. Boxed slices, not vectors: a hostile file is nothing but small values, and each of them costs this much.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Json {
    Null,
    Bool(bool),
    Number(f64),
    Text(Box<str>),
    /// An array of nothing but numbers; the empty array too.
    Numbers(Box<[f64]>),
    Array(Box<[Json]>),
    Object(Box<[(Box<str>, Json)]>),
}

impl Json {
    /// What a message calls such a value.
    pub(crate) fn type_name(&self) -> &'static str {
        match self {
            Json::Null => "null",
            Json::Bool(_) => "a boolean",
            Json::Number(_) => "a number",
            Json::Text(_) => "a string",
            Json::Numbers(_) | Json::Array(_) => "an array",
            Json::Object(_) => "an object",
        }
    }

    /// True for an object with that member.
    pub(crate) fn has(&self, key: &str) -> bool {
        self.get(key).is_some()
    }

    /// The member of an object, to be changed.
    pub(crate) fn get_mut(&mut self, key: &str) -> Option<&mut Json> {
        match self {
            Json::Object(members) => members.iter_mut().find(|(name, _)| **name == *key).map(|(_, value)| value),
            _ => None,
        }
    }

    /// The member of an object.
    pub(crate) fn get(&self, key: &str) -> Option<&Json> {
        match self {
            Json::Object(members) => members.iter().find(|(name, _)| **name == *key).map(|(_, value)| value),
            _ => None,
        }
    }
}

/// The error with line, column and excerpt of the member its pointer names, or of the nearest one around it that is in
/// the text.
pub(crate) fn place(source: &Source, error: Error) -> Error {
    let (Ok(text), Some(pointer)) = (source.text(), error.place().pointer.clone()) else {
        return error.in_source(source.name());
    };
    let mut around = pointer.as_str();
    loop {
        match (locate::locate(text, around), around.rsplit_once('/')) {
            (Some(offset), _) => return source.fault(offset, error),
            (None, Some((outer, _))) => around = outer,
            (None, None) => return error.in_source(source.name()),
        }
    }
}

/// The pointer of a member: `~` and `/` in a key are written `~0` and `~1` (RFC 6901).
pub(crate) fn child(pointer: &str, key: &str) -> String {
    format!("{pointer}/{}", key.replace('~', "~0").replace('/', "~1"))
}
