//! Bytes with a name: a file, the standard input, or anything that can be read, taken whole under a budget; a
//! [`Stream`](crate::stream::Stream) takes them piece by piece.
//!
//! Text is UTF-8. A byte-order mark is skipped; lines end with LF, CR LF or CR; NUL bytes, other encodings and empty
//! input are refused with their place. Nothing is allocated from a size that somebody claims: a file larger than the
//! budget is refused before it is read, and a stream as soon as it exceeds it.

use std::fs::{self, File};
use std::io::{self, Read};
use std::path::Path;

use lath::error::Limits;

use crate::error::{Code, Error, Result};

/// How many characters of an offending line an error shows, and how many of them before the culprit.
const EXCERPT: usize = 120;
const BEFORE: usize = 60;
/// How much is read between two looks at the budget.
const CHUNK: u64 = 1 << 20;
pub(crate) const BYTE_ORDER_MARK: &[u8] = b"\xef\xbb\xbf";

/// The bytes of one file or stream, and its name for messages.
///
/// ```
/// use lath_io::source::Source;
///
/// let source = Source::from_bytes("wing.CSV", "\u{feff}x,y\r\n0,1\r\n");
/// assert_eq!(source.text().unwrap(), "x,y\r\n0,1\r\n");
/// assert_eq!(source.name(), "wing.CSV");
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Source {
    name: String,
    bytes: Vec<u8>,
}

impl Source {
    /// Reads a file, or the standard input where the path is `-`.
    ///
    /// # Errors
    /// As [`Source::file`] and [`Source::reader`].
    pub fn open(path: impl AsRef<Path>, limits: &Limits<'_>) -> Result<Source> {
        if path.as_ref().as_os_str() == "-" { Source::standard_input(limits) } else { Source::file(path, limits) }
    }

    /// Reads the file at `path`, which may also be a pipe.
    ///
    /// # Errors
    /// I001 no such file, I002 permission denied, I003 a folder, I004 other faults of the system; B001 larger than
    /// `limits.max_bytes`.
    pub fn file(path: impl AsRef<Path>, limits: &Limits<'_>) -> Result<Source> {
        let path = path.as_ref();
        let name = path.display().to_string();
        let file = open(path).and_then(|(file, about)| {
            limits.check_bytes(about.len())?;
            Ok(file)
        });
        Source::reader(&name, file.map_err(|error| error.in_source(&name))?, limits)
    }

    /// Reads the standard input to its end.
    ///
    /// # Errors
    /// As [`Source::reader`].
    pub fn standard_input(limits: &Limits<'_>) -> Result<Source> {
        Source::reader("standard input", io::stdin().lock(), limits)
    }

    /// Reads anything to its end; `name` is what messages call it.
    ///
    /// # Errors
    /// I004 where reading fails, B001 as soon as `limits.max_bytes` are exceeded, B002 when cancelled.
    pub fn reader(name: &str, reader: impl Read, limits: &Limits<'_>) -> Result<Source> {
        let mut reader = reader;
        let mut bytes = Vec::new();
        loop {
            let got = reader
                .by_ref()
                .take(CHUNK)
                .read_to_end(&mut bytes)
                .map_err(|e| Error::from_os(&e, "reading", Code::I004).in_source(name))?;
            limits
                .check_bytes(bytes.len() as u64)
                .and_then(|()| limits.check_cancel())
                .map_err(|e| Error::from(e).in_source(name))?;
            if got == 0 {
                return Ok(Source { name: name.to_owned(), bytes });
            }
        }
    }

    /// Bytes that are in memory already.
    pub fn from_bytes(name: &str, bytes: impl Into<Vec<u8>>) -> Source {
        Source { name: name.to_owned(), bytes: bytes.into() }
    }

    /// The name for messages: the path as given, or "standard input".
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The bytes as they were read.
    #[must_use]
    pub fn bytes(&self) -> &[u8] {
        &self.bytes
    }

    /// The bytes, taken out.
    pub(crate) fn into_bytes(self) -> Vec<u8> {
        self.bytes
    }

    /// The text without its byte-order mark.
    ///
    /// # Errors
    /// F001 where there is nothing but blanks, F002 at a NUL byte, F003 at bytes that are not UTF-8.
    pub fn text(&self) -> Result<&str> {
        if self.bytes.starts_with(b"\xff\xfe") || self.bytes.starts_with(b"\xfe\xff") {
            return Err(Error::new(Code::F003, "the text is encoded as UTF-16").in_source(&self.name));
        }
        let bytes = self.bytes.strip_prefix(BYTE_ORDER_MARK).unwrap_or(&self.bytes);
        let (valid, fault) = match core::str::from_utf8(bytes) {
            Ok(text) => (text, None),
            Err(e) => (
                bytes.get(..e.valid_up_to()).and_then(|b| core::str::from_utf8(b).ok()).unwrap_or(""),
                Some(e.valid_up_to()),
            ),
        };
        if let Some(offset) = valid.find('\0') {
            let error = Error::new(Code::F002, "a NUL byte, which no text contains");
            return Err(self.fault(offset, error));
        }
        if let Some(offset) = fault {
            let byte = bytes.get(offset).copied().unwrap_or(0);
            return Err(self.fault(offset, Error::new(Code::F003, format!("the byte 0x{byte:02X} is not UTF-8 here"))));
        }
        if valid.trim().is_empty() {
            return Err(Error::new(Code::F001, "the input is empty").in_source(&self.name));
        }
        Ok(valid)
    }

    /// The error placed at a byte of the text: name, line, column and excerpt. Offsets do not count a byte-order mark.
    pub(crate) fn fault(&self, offset: usize, error: Error) -> Error {
        let bytes = self.bytes.strip_prefix(BYTE_ORDER_MARK).unwrap_or(&self.bytes);
        let (line, start) = line_of(bytes, offset);
        in_line(error, line, bytes.get(start..).unwrap_or(&[]), offset - start).in_source(&self.name)
    }
}

/// A file that is no folder, with what the system says about it.
pub(crate) fn open(path: &Path) -> Result<(File, fs::Metadata)> {
    let about = fs::metadata(path).map_err(|e| Error::from_os(&e, "opening", Code::I004))?;
    if about.is_dir() {
        return Err(Error::new(Code::I003, "this is a folder, not a file"));
    }
    Ok((File::open(path).map_err(|e| Error::from_os(&e, "opening", Code::I004))?, about))
}

/// The error placed at a byte of a line: its number, column and excerpt. `text` begins with the line and may go on
/// behind it; the line alone decides how long this takes.
pub(crate) fn in_line(error: Error, number: u64, text: &[u8], offset: usize) -> Error {
    let before = text.get(..offset).unwrap_or(&[]);
    let behind = text.get(offset..).unwrap_or(&[]);
    let end = behind.iter().position(|&b| b == b'\n' || b == b'\r').unwrap_or(behind.len());
    let column = characters(before) + 1;
    // A character has at most 4 bytes; what is cut through at the far ends is not shown.
    let near = String::from_utf8_lossy(before.get(before.len().saturating_sub(4 * BEFORE)..).unwrap_or(&[]));
    let skipped = near.chars().count().saturating_sub(BEFORE);
    let left: String = near.chars().skip(skipped).collect();
    let right = String::from_utf8_lossy(behind.get(..end.min(4 * EXCERPT)).unwrap_or(&[]));
    let caret = left.chars().count() as u64 + 1;
    let shown = left.chars().chain(right.chars()).take(EXCERPT);
    let shown: String = shown.map(|c| if c.is_control() && c != '\t' { '\u{fffd}' } else { c }).collect();
    error.at_line(number, Some(column)).showing(shown, caret)
}

/// The line that holds the byte at `offset`, from 1, and the offset where it starts.
fn line_of(bytes: &[u8], offset: usize) -> (u64, usize) {
    let mut line = 1;
    let mut start = 0;
    for (i, &byte) in bytes.iter().enumerate().take(offset) {
        let ends = byte == b'\n' || (byte == b'\r' && bytes.get(i + 1) != Some(&b'\n'));
        if ends {
            line += 1;
            start = i + 1;
        }
    }
    (line, start)
}

/// The number of characters in UTF-8 bytes: all bytes but the continuations.
fn characters(bytes: &[u8]) -> u64 {
    bytes.iter().filter(|&&b| b & 0xC0 != 0x80).count() as u64
}

#[cfg(test)]
mod tests {
    use super::*;

    fn text_fault(bytes: &[u8]) -> (String, Option<u64>, Option<u64>) {
        let source = Source::from_bytes("a.csv", bytes);
        let error = source.text().unwrap_err();
        assert_eq!(error.place().source.as_deref(), Some("a.csv"));
        (error.code().as_str().to_owned(), error.place().line, error.place().column)
    }

    #[test]
    fn what_is_not_text_is_refused_with_its_place() {
        assert_eq!(text_fault(b""), ("F001".into(), None, None));
        assert_eq!(text_fault(b"\xef\xbb\xbf"), ("F001".into(), None, None));
        assert_eq!(text_fault(b" \r\n\t\n"), ("F001".into(), None, None));
        assert_eq!(text_fault(b"1,2\r\n3,\x004\n"), ("F002".into(), Some(2), Some(3)));
        assert_eq!(
            text_fault("x\ré\u{fffd}".as_bytes().iter().copied().chain([0xE9, b'\n']).collect::<Vec<_>>().as_slice()),
            ("F003".into(), Some(2), Some(3))
        );
        assert_eq!(text_fault(b"\xff\xfe1\x00,\x00"), ("F003".into(), None, None));
        assert_eq!(text_fault(b"\xef\xbb\xbf1\xff"), ("F003".into(), Some(1), Some(2)));
        assert_eq!(text_fault(b"1\x00\xff"), ("F002".into(), Some(1), Some(2)));
    }

    #[test]
    fn faults_show_their_line() {
        let source = Source::from_bytes("f", "one\r\ntwo \u{e9} x\r\n");
        let error = source.fault(12, Error::new(Code::F005, "here"));
        assert_eq!(
            (error.place().line, error.place().column, error.excerpt()),
            (Some(2), Some(7), Some("two \u{e9} x"))
        );
        assert_eq!(
            error.to_string(),
            "f:2:7: F005: here. Correct the field, or begin the line with # to make it a comment."
        );
        assert_eq!(error.caret(), Some(7));
        // An offset beyond the end is harmless.
        assert_eq!(source.fault(999, Error::new(Code::F005, "here")).place().line, Some(3));
    }

    #[test]
    fn long_lines_are_shown_around_the_culprit() {
        let line = "\u{e9}".repeat(1000) + "X" + &"\u{e9}".repeat(1000);
        let error = Source::from_bytes("f", line.as_str()).fault(2000, Error::new(Code::F005, "here"));
        let excerpt = error.excerpt().unwrap();
        assert_eq!((error.place().column, error.caret(), excerpt.chars().count()), (Some(1001), Some(61), 120));
        assert_eq!(excerpt.chars().nth(60), Some('X'));
    }

    #[test]
    fn the_budget_holds_for_files_and_streams() {
        let limits = Limits { max_bytes: 10, ..Limits::default() };
        let error = Source::reader("standard input", io::repeat(b'1'), &limits).unwrap_err();
        assert_eq!((error.code().as_str(), error.class().exit_code()), ("B001", 5));
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("long.txt");
        fs::write(&path, "12345678901").unwrap();
        let error = Source::file(&path, &limits).unwrap_err();
        assert_eq!((error.code().as_str(), error.place().source.as_deref()), ("B001", path.to_str()));
        assert_eq!(Source::file(&path, &Limits::default()).unwrap().bytes(), b"12345678901");
    }

    #[test]
    fn folders_and_missing_files_are_named() {
        let folder = tempfile::tempdir().unwrap();
        let error = Source::open(folder.path(), &Limits::default()).unwrap_err();
        assert_eq!((error.code().as_str(), error.class().exit_code()), ("I003", 4));
        let error = Source::open(folder.path().join("absent.csv"), &Limits::default()).unwrap_err();
        assert_eq!((error.code().as_str(), error.class().exit_code()), ("I001", 4));
    }
}
