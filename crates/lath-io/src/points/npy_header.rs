//! The header of an `.npy` file: a Python dictionary of three members.
//!
//! `{'descr': '<f8', 'fortran_order': False, 'shape': (3, 2), }`, behind eight bytes of magic and version and the
//! length of the text: two bytes in version 1, four in versions 2 and 3.

use crate::error::{Code, Error, Result};

/// The bytes that begin every `.npy` file.
pub(crate) const MAGIC: &[u8] = b"\x93NUMPY";

/// What a header says.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Header {
    /// The dtype, `<f8`.
    pub(crate) descr: String,
    pub(crate) fortran: bool,
    pub(crate) shape: Vec<u64>,
    /// Where the numbers begin, in bytes.
    pub(crate) data: u64,
}

/// How many bytes tell where a header ends: magic, version, and a length of four bytes.
pub(crate) const PREFIX: usize = 12;

/// Where the text of the header begins, and where it ends and the numbers begin, as the first [`PREFIX`] bytes say.
///
/// # Errors
/// F025 for what does not begin as an `.npy` file, is cut off, or is not of versions 1 to 3.
pub(crate) fn extent(bytes: &[u8]) -> Result<(usize, u64)> {
    let rest = bytes.strip_prefix(MAGIC).ok_or_else(|| wrong("the file does not begin as .npy files do"))?;
    let (&[major, minor], rest) = rest.split_first_chunk::<2>().ok_or_else(cut)?;
    let (length, bytes) = match major {
        1 => (rest.first_chunk().map(|length| u32::from(u16::from_le_bytes(*length))), 2),
        2 | 3 => (rest.first_chunk().map(|length| u32::from_le_bytes(*length)), 4),
        _ => return Err(wrong(format!("version {major}.{minor} of .npy is not known; there are 1.0, 2.0 and 3.0"))),
    };
    let start = MAGIC.len() + 2 + bytes;
    Ok((start, start as u64 + u64::from(length.ok_or_else(cut)?)))
}

/// Reads the header at the start of `bytes`.
///
/// # Errors
/// F025 for everything that is no header, is cut off, or is not of versions 1 to 3.
pub(crate) fn read(bytes: &[u8]) -> Result<Header> {
    let (start, end) = extent(bytes)?;
    let text = usize::try_from(end).ok().and_then(|end| bytes.get(start..end)).ok_or_else(cut)?;
    // Versions 1 and 2 are Latin-1, but whatever is not ASCII stands in names of fields, which are refused anyway.
    let text = core::str::from_utf8(text).map_err(|_| wrong("the header is not text"))?;
    let (descr, fortran, shape) = dictionary(text)?;
    Ok(Header { descr, fortran, shape, data: end })
}

fn cut() -> Error {
    wrong("the file ends inside its header").remedied("The file is cut off: save or copy it again.")
}

/// An error about the file as a whole.
pub(crate) fn wrong(message: impl Into<String>) -> Error {
    Error::new(Code::F025, message)
}

fn dictionary(text: &str) -> Result<(String, bool, Vec<u64>)> {
    let mut words = Words { rest: text };
    let (mut descr, mut fortran, mut shape) = (None, None, None);
    words.expect('{')?;
    while !words.take('}') {
        let key = words.quoted()?;
        words.expect(':')?;
        let repeated = match key {
            "descr" if words.peek() == Some('[') => {
                return Err(wrong("the rows are records of named fields, not plain numbers")
                    .remedied("Save one array of float64, with one row a point."));
            }
            "descr" => descr.replace(words.quoted()?.to_owned()).is_some(),
            "fortran_order" => fortran.replace(words.boolean()?).is_some(),
            "shape" => shape.replace(words.tuple()?).is_some(),
            _ => return Err(wrong(format!("the header has the unknown member {:?}", shown(key)))),
        };
        if repeated {
            return Err(wrong(format!("the header has the member {key:?} twice")));
        }
        if !words.take(',') && words.peek() != Some('}') {
            return Err(words.fault("a comma"));
        }
    }
    if !words.rest.trim().is_empty() {
        return Err(words.fault("the end of the header"));
    }
    match (descr, fortran, shape) {
        (Some(descr), Some(fortran), Some(shape)) => Ok((descr, fortran, shape)),
        (None, _, _) => Err(wrong("the header has no member \"descr\"")),
        (_, None, _) => Err(wrong("the header has no member \"fortran_order\"")),
        (_, _, None) => Err(wrong("the header has no member \"shape\"")),
    }
}

/// The beginning of a text, for a message.
pub(crate) fn shown(text: &str) -> String {
    text.chars().take(40).collect()
}

/// The header's text, taken word by word.
struct Words<'a> {
    rest: &'a str,
}

impl<'a> Words<'a> {
    fn peek(&mut self) -> Option<char> {
        self.rest = self.rest.trim_start();
        self.rest.chars().next()
    }

    fn take(&mut self, wanted: char) -> bool {
        let there = self.peek() == Some(wanted);
        if there {
            self.rest = &self.rest[wanted.len_utf8()..];
        }
        there
    }

    fn expect(&mut self, wanted: char) -> Result<()> {
        if self.take(wanted) { Ok(()) } else { Err(self.fault(&format!("`{wanted}`"))) }
    }

    /// A string without escapes.
    fn quoted(&mut self) -> Result<&'a str> {
        let mark = match self.peek() {
            Some(mark @ ('\'' | '"')) => mark,
            _ => return Err(self.fault("a quoted word")),
        };
        let inner = &self.rest[1..];
        let Some(length) = inner.find(mark) else { return Err(self.fault("the end of a quotation")) };
        self.rest = &inner[length + 1..];
        Ok(&inner[..length])
    }

    fn boolean(&mut self) -> Result<bool> {
        self.peek();
        for (word, value) in [("True", true), ("False", false)] {
            if let Some(rest) = self.rest.strip_prefix(word) {
                self.rest = rest;
                return Ok(value);
            }
        }
        Err(self.fault("True or False"))
    }

    /// Whole numbers in parentheses, of which NumPy allows 64.
    fn tuple(&mut self) -> Result<Vec<u64>> {
        self.expect('(')?;
        let mut numbers = Vec::new();
        while !self.take(')') {
            self.peek();
            let length = self.rest.find(|c: char| !c.is_ascii_digit()).unwrap_or(self.rest.len());
            let digits = &self.rest[..length];
            if digits.is_empty() || numbers.len() == 64 {
                return Err(self.fault("a whole number from 0"));
            }
            let number =
                digits.parse().map_err(|_| wrong(format!("the shape has the huge number {}", shown(digits))))?;
            numbers.push(number);
            self.rest = &self.rest[length..];
            if !self.take(',') && self.peek() != Some(')') {
                return Err(self.fault("a comma"));
            }
        }
        Ok(numbers)
    }

    fn fault(&self, wanted: &str) -> Error {
        let found = shown(self.rest.trim_end());
        let found = if found.is_empty() { "its end".to_owned() } else { format!("{found:?}") };
        wrong(format!("the header has {found} where {wanted} is needed"))
    }
}
