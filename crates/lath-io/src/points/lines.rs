//! The lines of a text, one by one, with the faults of its encoding.
//!
//! Text is UTF-8. A byte-order mark is skipped; lines end with LF, CR LF or CR; NUL bytes and other encodings are
//! refused with their place. Memory: the longest line.

use lath::error::Limits;

use crate::error::{Code, Error, Result};
use crate::source::{BYTE_ORDER_MARK, in_line};
use crate::stream::Stream;

/// How much is read at a time, at first.
const BLOCK: usize = 1 << 16;

/// One line of a text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Line<'a> {
    /// From 1.
    pub(crate) number: u64,
    /// Where it starts in the text, in bytes behind a byte-order mark.
    pub(crate) offset: u64,
    /// The line without its end.
    pub(crate) text: &'a str,
}

impl Line<'_> {
    /// The error placed at a byte of the line.
    pub(crate) fn fault(&self, offset: usize, error: Error) -> Error {
        in_line(error, self.number, self.text.as_bytes(), offset)
    }
}

/// The lines of a stream, from where it is.
#[derive(Debug)]
pub(crate) struct Lines<'a> {
    stream: Stream<'a>,
    limits: &'a Limits<'a>,
    buffer: Vec<u8>,
    /// The part of the buffer that has been read and not handed out.
    from: usize,
    to: usize,
    /// The lines handed out, and where the next one starts in the text.
    number: u64,
    offset: u64,
    begun: bool,
    ended: bool,
    /// The last line ended with CR: an LF behind it belongs to the same end.
    after_cr: bool,
}

impl<'a> Lines<'a> {
    pub(crate) fn new(stream: Stream<'a>, limits: &'a Limits<'a>) -> Lines<'a> {
        let buffer = vec![0; BLOCK];
        Lines {
            stream,
            limits,
            buffer,
            from: 0,
            to: 0,
            number: 0,
            offset: 0,
            begun: false,
            ended: false,
            after_cr: false,
        }
    }

    /// The name of the stream.
    pub(crate) fn name(&self) -> &str {
        self.stream.name()
    }

    /// The same lines from the first on.
    pub(crate) fn rewind(&mut self) -> Result<()> {
        self.stream.rewind()?;
        (self.from, self.to, self.number, self.offset) = (0, 0, 0, 0);
        (self.begun, self.ended, self.after_cr) = (false, false, false);
        Ok(())
    }

    /// The next line; none at the end, and none behind an error.
    ///
    /// # Errors
    /// F002 at a NUL byte, F003 at bytes that are not UTF-8, I004 where reading fails, B001 for a line longer than
    /// `limits.max_bytes`.
    pub(crate) fn next(&mut self) -> Result<Option<Line<'_>>> {
        if self.ended {
            return Ok(None);
        }
        let place = self.cut();
        self.ended = !matches!(place, Ok(Some(_)));
        let Some((start, end, stop)) = place? else { return Ok(None) };
        let bytes = self.buffer.get(start..end).unwrap_or_default();
        let (number, offset) = (self.number, self.offset);
        self.offset = offset + (end - start) as u64 + u64::from(stop.is_some());
        match (core::str::from_utf8(bytes), stop) {
            (Ok(text), None | Some(b'\n' | b'\r')) => Ok(Some(Line { number, offset, text })),
            (text, _) => {
                self.ended = true;
                let rest = self.buffer.get(start..self.to).unwrap_or_default();
                let (at, error) = match text {
                    Ok(text) => (text.len(), Error::new(Code::F002, "a NUL byte, which no text contains")),
                    Err(fault) => {
                        let at = fault.valid_up_to();
                        let byte = bytes.get(at).copied().unwrap_or(0);
                        (at, Error::new(Code::F003, format!("the byte 0x{byte:02X} is not UTF-8 here")))
                    }
                };
                Err(in_line(error, number, rest, at).in_source(self.stream.name()))
            }
        }
    }

    /// Where the next line stands in the buffer, and the byte behind it, which is read as well.
    fn cut(&mut self) -> Result<Option<(usize, usize, Option<u8>)>> {
        if !self.begun {
            self.begin()?;
        }
        if self.after_cr && (self.from < self.to || self.read()?) && self.buffer.get(self.from) == Some(&b'\n') {
            self.from += 1;
            self.offset += 1;
        }
        let mut searched = 0;
        let stop = loop {
            let unread = self.buffer.get(self.from + searched..self.to).unwrap_or_default();
            match unread.iter().position(|byte| matches!(byte, b'\n' | b'\r' | 0)) {
                Some(at) => {
                    searched += at;
                    break self.buffer.get(self.from + searched).copied();
                }
                None => {
                    searched += unread.len();
                    if !self.read()? {
                        break None;
                    }
                }
            }
        };
        if stop.is_none() && searched == 0 {
            return Ok(None);
        }
        let (start, end) = (self.from, self.from + searched);
        self.from = end + usize::from(stop.is_some());
        self.number += 1;
        self.after_cr = stop == Some(b'\r');
        Ok(Some((start, end, stop)))
    }

    /// What stands before the first line.
    fn begin(&mut self) -> Result<()> {
        self.begun = true;
        while self.to < BYTE_ORDER_MARK.len() && self.read()? {}
        let start = self.buffer.get(..self.to).unwrap_or_default();
        if start.starts_with(b"\xff\xfe") || start.starts_with(b"\xfe\xff") {
            return Err(Error::new(Code::F003, "the text is encoded as UTF-16").in_source(self.stream.name()));
        }
        if start.starts_with(BYTE_ORDER_MARK) {
            self.from = BYTE_ORDER_MARK.len();
        }
        Ok(())
    }

    /// Reads more behind what is unread, which goes to the start of the buffer; false at the end of the stream.
    fn read(&mut self) -> Result<bool> {
        self.buffer.copy_within(self.from..self.to, 0);
        (self.from, self.to) = (0, self.to - self.from);
        if self.to == self.buffer.len() {
            let longer = 2 * self.buffer.len();
            self.limits
                .check_bytes(longer as u64)
                .map_err(|error| Error::from(error).in_source(self.stream.name()).at_line(self.number + 1, None))?;
            self.buffer.resize(longer, 0);
        }
        let got = self.stream.fill(self.buffer.get_mut(self.to..).unwrap_or_default())?;
        self.to += got;
        Ok(got > 0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::source::Source;

    fn all(bytes: &[u8]) -> Result<Vec<(u64, u64, String)>> {
        let limits = Limits::default();
        let mut lines = Lines::new(Stream::pipe("a.csv", bytes), &limits);
        let mut found = Vec::new();
        while let Some(line) = lines.next()? {
            found.push((line.number, line.offset, line.text.to_owned()));
        }
        assert_eq!(lines.next().unwrap(), None);
        Ok(found)
    }

    #[test]
    fn lines_end_in_three_ways() {
        let numbered = all(b"\xef\xbb\xbfa\r\nb\rc\n\nd").unwrap();
        let expected = [(1, 0, "a"), (2, 3, "b"), (3, 5, "c"), (4, 7, ""), (5, 8, "d")];
        assert_eq!(numbered, expected.map(|(number, offset, text)| (number, offset, text.to_owned())));
        assert!(all(b"").unwrap().is_empty());
        // Also where the ends of lines fall on the ends of blocks.
        let long = |length: usize| "x".repeat(BLOCK + length - 3);
        let mut texts = ["\n", "\r", "\r\n", "\r\r\n", "\n\r", "a\r\r\nb", "\n\n\r\r"].map(str::to_owned).to_vec();
        texts.extend((0..8).map(|i| format!("{}\r\n{}\n\r{}", long(i), long(0), long(1))));
        for text in texts {
            let plain: Vec<_> = text.replace("\r\n", "\n").replace('\r', "\n").lines().map(String::from).collect();
            let found = all(text.as_bytes()).unwrap();
            assert!(found.iter().map(|line| &line.2).eq(&plain), "{:?}", text.get(..20));
            let end = |line: &(u64, u64, String)| text.get(line.1 as usize..).is_some_and(|t| t.starts_with(&line.2));
            assert!(found.iter().all(end));
        }
    }

    #[test]
    fn what_is_not_text_is_refused_with_its_place() {
        let fault = |bytes: &[u8]| {
            let error = all(bytes).unwrap_err();
            assert_eq!(error.place().source.as_deref(), Some("a.csv"));
            (error.code().as_str(), error.place().line, error.place().column)
        };
        assert_eq!(fault(b"1,2\r\n3,\x004\n"), ("F002", Some(2), Some(3)));
        assert_eq!(fault(b"x\r\xc3\xa9\xef\xbf\xbd\xe9\n"), ("F003", Some(2), Some(3)));
        assert_eq!(fault(b"\xff\xfe1\x00,\x00"), ("F003", None, None));
        assert_eq!(fault(b"\xef\xbb\xbf1\xff"), ("F003", Some(1), Some(2)));
        assert_eq!(fault(b"1\x00\xff"), ("F002", Some(1), Some(2)));
        assert_eq!(fault(b"1\xff\x00"), ("F003", Some(1), Some(2)));
        assert_eq!(fault(b"1\xe2\x82"), ("F003", Some(1), Some(2)));
    }

    #[test]
    fn a_line_has_a_budget_and_lines_have_none() {
        let limits = Limits { max_bytes: 1 << 20, ..Limits::default() };
        let endless = |piece: &'static [u8]| std::io::Read::chain(piece, std::io::repeat(b'1'));
        let mut lines = Lines::new(Stream::pipe("a", endless(b"0\n")), &limits);
        assert_eq!(lines.next().unwrap().map(|line| line.text.len()), Some(1));
        let error = lines.next().unwrap_err();
        assert_eq!((error.code().as_str(), error.place().line), ("B001", Some(2)));
        let text = Source::from_bytes("a", "123\n".repeat(1 << 19));
        let mut lines = Lines::new(Stream::of(&text), &limits);
        let mut count = 0;
        while lines.next().unwrap().is_some() {
            count += 1;
        }
        assert_eq!((count, lines.buffer.len()), (1 << 19, BLOCK));
    }
}
