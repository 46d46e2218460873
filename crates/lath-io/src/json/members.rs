//! The members of one JSON object, taken one by one; what nobody takes is an error.

use crate::error::{Code, Error, Result};
use crate::json::{Json, Rows, child, numbers, rows};

/// An object being read. Every member is taken by the reader that knows it; [`Members::finish`] refuses what is left,
/// so that nothing in a file is ever ignored.
#[derive(Debug)]
pub(crate) struct Members {
    pointer: String,
    entries: Vec<(Box<str>, Json)>,
    /// The keys asked for so far, for the message about one that was not.
    known: Vec<&'static str>,
    /// Those of them that were there.
    present: Vec<&'static str>,
}

impl Members {
    /// The members of the object at `pointer`.
    ///
    /// # Errors
    /// F017 where it is no object.
    pub(crate) fn of(json: Json, pointer: impl Into<String>) -> Result<Members> {
        let pointer = pointer.into();
        match json {
            Json::Object(entries) => {
                Ok(Members { pointer, entries: entries.into(), known: Vec::new(), present: Vec::new() })
            }
            other => {
                Err(Error::new(Code::F017, format!("{} where an object is needed", other.type_name()))
                    .at_pointer(pointer))
            }
        }
    }

    /// The pointer of one of its members.
    pub(crate) fn pointer(&self, key: &str) -> String {
        child(&self.pointer, key)
    }

    /// Takes a member that may be absent.
    pub(crate) fn take(&mut self, key: &'static str) -> Option<Json> {
        self.known.push(key);
        let index = self.entries.iter().position(|(name, _)| **name == *key)?;
        self.present.push(key);
        Some(self.entries.remove(index).1)
    }

    /// Takes a member that must be there; `what` describes it: `"points": [[x,y],…]`.
    pub(crate) fn require(&mut self, key: &'static str, what: &str) -> Result<Json> {
        self.take(key).ok_or_else(|| {
            let error = Error::new(Code::F015, format!("the member \"{key}\" is missing"));
            error.remedied(format!("Add \"{key}\": {what}.")).at_pointer(self.pointer.as_str())
        })
    }

    /// Takes an array of points.
    pub(crate) fn rows(&mut self, key: &'static str) -> Result<Rows> {
        let value = self.require(key, "[[x,y],…]")?;
        rows(value, &self.pointer(key))
    }

    /// Takes an array of numbers.
    pub(crate) fn numbers(&mut self, key: &'static str) -> Result<Vec<f64>> {
        let value = self.require(key, "[a,b,…]")?;
        numbers(value, &self.pointer(key))
    }

    /// Takes an array of numbers that may be absent.
    pub(crate) fn optional_numbers(&mut self, key: &'static str) -> Result<Option<Vec<f64>>> {
        let pointer = self.pointer(key);
        self.take(key).map(|value| numbers(value, &pointer)).transpose()
    }

    /// Takes a whole number from 0.
    pub(crate) fn count(&mut self, key: &'static str) -> Result<usize> {
        match self.require(key, "a whole number")? {
            // Integers up to 2^53 are exact in a double.
            Json::Number(x) if (0.0..=9007199254740992.0).contains(&x) && x.fract() == 0.0 => Ok(x as usize),
            Json::Number(x) => Err(self.wrong(key, &x.to_string())),
            other => Err(self.wrong(key, other.type_name())),
        }
    }

    fn wrong(&self, key: &str, found: &str) -> Error {
        Error::new(Code::F017, format!("\"{key}\" is {found}, not a whole number from 0")).at_pointer(self.pointer(key))
    }

    /// Takes a boolean; an absent one is false.
    pub(crate) fn flag(&mut self, key: &'static str) -> Result<bool> {
        match self.take(key) {
            None => Ok(false),
            Some(Json::Bool(value)) => Ok(value),
            Some(other) => {
                let message = format!("\"{key}\" is {}, not true or false", other.type_name());
                Err(Error::new(Code::F017, message).at_pointer(self.pointer(key)))
            }
        }
    }

    /// Takes a string that may be absent.
    pub(crate) fn optional_text(&mut self, key: &'static str) -> Result<Option<String>> {
        match self.take(key) {
            None => Ok(None),
            Some(Json::Text(text)) => Ok(Some(text.into())),
            Some(other) => {
                let message = format!("\"{key}\" is {}, not a string", other.type_name());
                Err(Error::new(Code::F017, message).at_pointer(self.pointer(key)))
            }
        }
    }

    /// The end of the object.
    ///
    /// # Errors
    /// F016 where a member is left that nobody took.
    pub(crate) fn finish(&self) -> Result<()> {
        let Some((key, _)) = self.entries.first() else { return Ok(()) };
        let known: Vec<String> = self.known.iter().map(|key| format!("\"{key}\"")).collect();
        let error = Error::new(Code::F016, format!("the member \"{key}\" means nothing here"));
        Err(error.remedied(format!("Remove it; the members are {}.", known.join(", "))).at_pointer(self.pointer(key)))
    }

    /// What the core refused, at this member and the index the core names, or at the object where the member is not
    /// given.
    pub(crate) fn refused(&self, member: &'static str, core: lath::error::Error) -> Error {
        let mut pointer = self.pointer.clone();
        if self.present.contains(&member) {
            pointer = child(&pointer, member);
            if let Some(index) = core.index() {
                pointer = child(&pointer, &index.to_string());
            }
        }
        Error::from(core).at_pointer(pointer)
    }
}
