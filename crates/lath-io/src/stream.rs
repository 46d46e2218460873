//! Bytes with a name that are read piece by piece, as often as needed, in constant memory.
//!
//! A [`Source`] holds a file whole; a stream holds a piece of it. Whoever must see all rows before the first is written
//! reads the stream twice. A file can be read again. What comes through a pipe cannot, and is copied while it is read:
//! the first mebibyte in memory, what follows in a temporary file without a name, which the system takes away with the
//! process. So memory stays constant, and disk space is spent only where there is no file already.

use std::fs::File;
use std::io::{self, Cursor, Read, Seek, SeekFrom, Write};
use std::path::Path;

use lath::error::Limits;
use tempfile::SpooledTempFile;

use crate::error::{Code, Error, Result};
use crate::source::{BYTE_ORDER_MARK, Source, open};

/// How much of a pipe is kept in memory before a temporary file is made.
const KEPT: usize = 1 << 20;
/// How much of a pipe is copied at a time.
const CHUNK: usize = 1 << 16;
/// How many bytes tell one format from another.
const TELLING: usize = 16;

/// The bytes of a file, a pipe or a [`Source`], read from the start as often as needed.
///
/// ```
/// use lath_io::stream::Stream;
/// use std::io::Read;
///
/// let mut stream = Stream::pipe("standard input", std::io::Cursor::new("0,1\n"));
/// for _ in 0..2 {
///     let mut text = String::new();
///     stream.read_to_string(&mut text)?;
///     assert_eq!((text.as_str(), stream.name()), ("0,1\n", "standard input"));
///     stream.rewind()?;
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct Stream<'a> {
    name: String,
    held: Held<'a>,
}

#[derive(Debug)]
enum Held<'a> {
    Memory(Cursor<&'a [u8]>),
    File(File),
    Pipe(Box<Pipe<'a>>),
}

impl<'a> Stream<'a> {
    /// Opens a file, or the standard input where the path is `-`. Nothing is read yet.
    ///
    /// # Errors
    /// I001 no such file, I002 permission denied, I003 a folder, I004 other faults of the system.
    pub fn open(path: impl AsRef<Path>) -> Result<Stream<'a>> {
        let path = path.as_ref();
        if path.as_os_str() == "-" {
            return Ok(Stream::pipe("standard input", io::stdin()));
        }
        let name = path.display().to_string();
        let (file, about) = open(path).map_err(|error| error.in_source(&name))?;
        if about.is_file() { Ok(Stream { name, held: Held::File(file) }) } else { Ok(Stream::pipe(&name, file)) }
    }

    /// Whatever can be read only once; `name` is what messages call it.
    pub fn pipe(name: &str, reader: impl Read + 'a) -> Stream<'a> {
        let copy = tempfile::spooled_tempfile(KEPT);
        let pipe = Pipe { reader: Box::new(reader), copy, at: 0, copied: 0, ended: false };
        Stream { name: name.to_owned(), held: Held::Pipe(Box::new(pipe)) }
    }

    /// Bytes that are in memory already.
    #[must_use]
    pub fn of(source: &'a Source) -> Stream<'a> {
        Stream { name: source.name().to_owned(), held: Held::Memory(Cursor::new(source.bytes())) }
    }

    /// The name for messages: the path as given, or "standard input".
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Goes back to the start.
    ///
    /// # Errors
    /// I004 where the system refuses.
    pub fn rewind(&mut self) -> Result<()> {
        self.go_to(0)
    }

    /// Goes to a byte, which must have been read or lie in a file.
    pub(crate) fn go_to(&mut self, offset: u64) -> Result<()> {
        match &mut self.held {
            Held::Memory(bytes) => bytes.seek(SeekFrom::Start(offset)),
            Held::File(file) => file.seek(SeekFrom::Start(offset)),
            Held::Pipe(pipe) => pipe.go_to(offset),
        }
        .map(|_| ())
        .map_err(|error| self.fault(&error))
    }

    /// Reads into the buffer until it is full or the input ends; returns how much came.
    pub(crate) fn fill(&mut self, buffer: &mut [u8]) -> Result<usize> {
        let mut filled = 0;
        while let Some(rest) = buffer.get_mut(filled..).filter(|rest| !rest.is_empty()) {
            match self.read(rest) {
                Ok(0) => break,
                Ok(got) => filled += got,
                Err(error) if error.kind() == io::ErrorKind::Interrupted => {}
                Err(error) => return Err(self.fault(&error)),
            }
        }
        Ok(filled)
    }

    /// How many bytes there are. Of a pipe no more are counted than needed to know whether there are `enough`.
    pub(crate) fn length(&mut self, enough: u64) -> Result<u64> {
        match &mut self.held {
            Held::Memory(bytes) => Ok(bytes.get_ref().len() as u64),
            Held::File(file) => file.metadata().map(|about| about.len()),
            Held::Pipe(pipe) => pipe.pull(enough),
        }
        .map_err(|error| self.fault(&error))
    }

    /// True where [`Stream::length`] counts all bytes: always but for a pipe that has not been read to its end.
    pub(crate) fn is_counted(&self) -> bool {
        !matches!(&self.held, Held::Pipe(pipe) if !pipe.ended)
    }

    /// The first bytes behind a byte-order mark and blanks: what tells one format from another. The stream is at its
    /// start again.
    pub(crate) fn beginning(&mut self) -> Result<Vec<u8>> {
        let mut start = vec![0; BYTE_ORDER_MARK.len()];
        let got = self.fill(&mut start)?;
        start.truncate(got);
        if start.starts_with(BYTE_ORDER_MARK) {
            start.clear();
        }
        let mut block = [0; 512];
        while start.trim_ascii_start().len() < TELLING {
            let got = self.fill(&mut block)?;
            start = [start.trim_ascii_start(), block.get(..got).unwrap_or_default()].concat();
            if got == 0 {
                break;
            }
        }
        self.rewind()?;
        Ok(start.trim_ascii_start().to_vec())
    }

    /// All bytes, from the start, where a format cannot be read piece by piece.
    ///
    /// # Errors
    /// I004 where reading fails, B001 as soon as `limits.max_bytes` are exceeded, B002 when cancelled.
    pub fn into_source(mut self, limits: &Limits<'_>) -> Result<Source> {
        self.rewind()?;
        let name = self.name.clone();
        match self.held {
            // Nobody will read it again: what has been copied, then the rest.
            Held::Pipe(pipe) => Source::reader(&name, (*pipe).remaining(), limits),
            Held::File(file) => {
                let length = file.metadata().map_or(0, |about| about.len());
                limits.check_bytes(length).map_err(|error| Error::from(error).in_source(&name))?;
                Source::reader(&name, file, limits)
            }
            Held::Memory(bytes) => Source::reader(&name, bytes, limits),
        }
    }

    fn fault(&self, error: &io::Error) -> Error {
        Error::from_os(error, "reading", Code::I004).in_source(&self.name)
    }
}

impl Read for Stream<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        match &mut self.held {
            Held::Memory(bytes) => bytes.read(buffer),
            Held::File(file) => file.read(buffer),
            Held::Pipe(pipe) => pipe.read(buffer),
        }
    }
}

/// What can be read only once, and a copy of what has been read.
struct Pipe<'a> {
    reader: Box<dyn Read + 'a>,
    copy: SpooledTempFile,
    /// Where the next byte is read, and the place of the copy's cursor: at most `copied`.
    at: u64,
    copied: u64,
    ended: bool,
}

impl core::fmt::Debug for Pipe<'_> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(f, "Pipe {{ at: {}, copied: {} }}", self.at, self.copied)
    }
}

impl<'a> Pipe<'a> {
    /// What has been copied from its cursor on, then what has not been read.
    fn remaining(self) -> impl Read + 'a {
        self.copy.chain(self.reader)
    }

    fn go_to(&mut self, offset: u64) -> io::Result<u64> {
        self.at = self.copy.seek(SeekFrom::Start(offset))?;
        Ok(self.at)
    }

    /// Copies until there are `enough` bytes and a block more, or the input ends, and goes back to where it was.
    fn pull(&mut self, enough: u64) -> io::Result<u64> {
        let back = self.at;
        self.go_to(self.copied)?;
        let mut block = vec![0; CHUNK];
        while self.copied < enough.saturating_add(CHUNK as u64) && !self.ended {
            match self.read(&mut block) {
                Err(error) if error.kind() != io::ErrorKind::Interrupted => return Err(error),
                _ => {}
            }
        }
        self.go_to(back)?;
        Ok(self.copied)
    }
}

impl Read for Pipe<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let got = if self.at < self.copied {
            self.copy.read(buffer)?
        } else if self.ended {
            0
        } else {
            let got = self.reader.read(buffer)?;
            self.ended = got == 0 && !buffer.is_empty();
            self.copy.write_all(buffer.get(..got).unwrap_or_default())?;
            self.copied += got as u64;
            got
        };
        self.at += got as u64;
        Ok(got)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A reader that gives one byte at a time.
    struct Slow<'a>(&'a [u8]);

    impl Read for Slow<'_> {
        fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
            let Some((first, rest)) = self.0.split_first() else { return Ok(0) };
            self.0 = rest;
            buffer[0] = *first;
            Ok(1)
        }
    }

    fn all(stream: &mut Stream<'_>) -> Vec<u8> {
        let mut bytes = Vec::new();
        stream.read_to_end(&mut bytes).unwrap();
        bytes
    }

    #[test]
    fn every_stream_is_read_again() {
        // More than is kept in memory of a pipe.
        let long: Vec<u8> = (0..3 * KEPT).map(|i| (i % 251) as u8).collect();
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("long");
        std::fs::write(&path, &long).unwrap();
        let source = Source::from_bytes("long", long.clone());
        for mut stream in [Stream::open(&path).unwrap(), Stream::pipe("long", &long[..]), Stream::of(&source)] {
            let mut part = vec![0; KEPT + 17];
            assert_eq!(stream.fill(&mut part).unwrap(), part.len());
            stream.rewind().unwrap();
            assert!(all(&mut stream) == long && all(&mut stream).is_empty());
            stream.go_to(KEPT as u64 + 5).unwrap();
            assert_eq!(all(&mut stream), &long[KEPT + 5..]);
            assert_eq!(stream.length(u64::MAX).unwrap(), long.len() as u64);
            assert_eq!(stream.into_source(&Limits::default()).unwrap().bytes(), long);
        }
    }

    #[test]
    fn a_pipe_is_counted_no_further_than_needed() {
        let mut endless = Stream::pipe("zeros", io::repeat(0));
        assert!((100..10_000_000).contains(&endless.length(100).unwrap()));
        let mut byte = [1];
        assert_eq!((endless.fill(&mut byte).unwrap(), byte), (1, [0]));
        let limits = Limits { max_bytes: 10, ..Limits::default() };
        assert_eq!(endless.into_source(&limits).unwrap_err().code().as_str(), "B001");
    }

    #[test]
    fn the_beginning_is_what_tells() {
        let beginning = |bytes: &[u8]| {
            let mut stream = Stream::pipe("a", Slow(bytes));
            let start = stream.beginning().unwrap();
            assert_eq!(all(&mut stream), bytes);
            start
        };
        assert_eq!(beginning(b""), b"");
        assert_eq!(beginning(b"{}"), b"{}");
        assert_eq!(beginning(b" \n"), b"");
        assert_eq!(beginning(b"\xef\xbb\xbf \r\n [1]"), b"[1]");
        assert!(beginning(&[&[b' '; 2000], &b"%PDF-1.7"[..]].concat()).starts_with(b"%PDF"));
        assert!(beginning(&[&[b' '; 510], &b"%PDF-1.7"[..]].concat()).starts_with(b"%PDF"));
    }

    #[test]
    fn folders_and_missing_files_are_named() {
        let folder = tempfile::tempdir().unwrap();
        assert_eq!(Stream::open(folder.path()).unwrap_err().code().as_str(), "I003");
        let error = Stream::open(folder.path().join("absent.csv")).unwrap_err();
        assert_eq!(error.code().as_str(), "I001");
        assert!(error.place().source.as_deref().is_some_and(|name| name.ends_with("absent.csv")));
    }
}
