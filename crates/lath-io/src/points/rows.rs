//! Rows coming in, one by one.

use lath::error::Limits;

use crate::error::{Error, Result};
use crate::points::select::choose;
use crate::points::table::PointTable;
use crate::points::{npy_scan, text};
use crate::stream::Stream;

/// Rows of numbers that are read as they are needed, as often as needed; made by [`crate::format::open`].
///
/// Of text and `.npy` only a piece is in memory, however many rows there are; JSON is held whole.
///
/// ```
/// use lath::error::Limits;
/// use lath_io::format::{self, Opened};
/// use lath_io::stream::Stream;
///
/// let limits = Limits::default();
/// let stream = Stream::pipe("standard input", std::io::Cursor::new("x,y\n0,1\n2,3\n"));
/// let Opened::Rows(mut rows) = format::open(stream, None, None, &limits)? else { panic!("shapes") };
/// let mut sum = 0.0;
/// while let Some(row) = rows.next_row()? {
///     sum += row.iter().sum::<f64>();
/// }
/// assert_eq!((sum, rows.count(), rows.columns()), (6.0, 2, Some(&["x".to_owned(), "y".to_owned()][..])));
/// rows.rewind()?;
/// assert_eq!(rows.next_row()?, Some(&[0.0, 1.0][..]));
/// # Ok::<(), lath_io::Error>(())
/// ```
#[derive(Debug)]
pub struct Rows<'a> {
    held: Held<'a>,
    columns: Option<Vec<String>>,
    row: Vec<f64>,
    /// The line of the row, where the file has lines.
    line: Option<u64>,
    count: u64,
}

#[derive(Debug)]
enum Held<'a> {
    Text(Box<text::Scan<'a>>),
    Array(Box<npy_scan::Scan<'a>>, Option<Vec<usize>>),
    Table(Box<PointTable>),
}

impl<'a> Rows<'a> {
    fn new(held: Held<'a>, columns: Option<Vec<String>>) -> Rows<'a> {
        Rows { held, columns, row: Vec::new(), line: None, count: 0 }
    }

    /// The rows of CSV, TSV or blanks-separated text.
    pub(crate) fn text(stream: Stream<'a>, wanted: Option<Vec<String>>, limits: &'a Limits<'a>) -> Result<Rows<'a>> {
        Ok(Rows::new(Held::Text(Box::new(text::Scan::new(stream, wanted, limits))), None))
    }

    /// The rows of an `.npy` file.
    pub(crate) fn array(stream: Stream<'a>, wanted: Option<Vec<String>>, limits: &'a Limits<'a>) -> Result<Rows<'a>> {
        let scan = npy_scan::Scan::new(stream, limits)?;
        let picks = wanted.map(|wanted| choose(None, scan.width, &wanted)).transpose();
        let picks = picks.map_err(|error| error.in_source(scan.name()))?;
        Ok(Rows::new(Held::Array(Box::new(scan), picks), None))
    }

    /// The rows of a table that is in memory.
    pub(crate) fn table(table: PointTable) -> Rows<'a> {
        let columns = table.columns().map(<[String]>::to_vec);
        Rows::new(Held::Table(Box::new(table)), columns)
    }

    /// The next row; none behind the last.
    ///
    /// # Errors
    /// As the format's own reader. There are no rows behind an error.
    pub fn next_row(&mut self) -> Result<Option<&[f64]>> {
        self.row.clear();
        let there = match &mut self.held {
            Held::Text(scan) => {
                self.line = scan.row(&mut self.row)?;
                if self.count == 0 {
                    self.columns = scan.layout.as_ref().and_then(|layout| layout.names_read());
                }
                self.line.is_some()
            }
            Held::Array(scan, picks) => {
                let there = scan.row(&mut self.row)?;
                if let Some((column, x)) = self.row.iter().enumerate().find(|(_, x)| !x.is_finite()) {
                    return Err(npy_scan::not_finite(self.count, column, *x).in_source(scan.name()));
                }
                if let Some(picks) = picks.as_ref().filter(|_| there) {
                    self.row = picks.iter().filter_map(|&pick| self.row.get(pick).copied()).collect();
                }
                there
            }
            Held::Table(table) => {
                let row = usize::try_from(self.count).ok().and_then(|count| table.row(count));
                self.row.extend_from_slice(row.unwrap_or_default());
                row.is_some()
            }
        };
        self.count += u64::from(there);
        Ok(there.then_some(&self.row[..]))
    }

    /// Goes back before the first row.
    ///
    /// # Errors
    /// I004 where the system refuses.
    pub fn rewind(&mut self) -> Result<()> {
        (self.line, self.count) = (None, 0);
        match &mut self.held {
            Held::Text(scan) => scan.rewind()?,
            Held::Array(scan, _) => scan.rewind(),
            Held::Table(_) => {}
        }
        Ok(())
    }

    /// The names of the columns, where the file gives them: in text they are known from the first row on.
    #[must_use]
    pub fn columns(&self) -> Option<&[String]> {
        self.columns.as_deref()
    }

    /// How many rows have been read since the start.
    #[must_use]
    pub fn count(&self) -> u64 {
        self.count
    }

    /// The name of the file or stream.
    #[must_use]
    pub fn source(&self) -> Option<&str> {
        match &self.held {
            Held::Text(scan) => Some(scan.name()),
            Held::Array(scan, _) => Some(scan.name()),
            Held::Table(table) => table.source(),
        }
    }

    /// What was refused about the row that was read last, with its place.
    #[must_use]
    pub fn locate(&self, refused: lath::error::Error) -> Error {
        let index = usize::try_from(self.count.saturating_sub(1)).unwrap_or(usize::MAX);
        let refused = refused.at(index);
        if let Held::Table(table) = &self.held {
            return table.locate(refused);
        }
        let error = Error::from(refused);
        let error = match self.source() {
            Some(name) => error.in_source(name),
            None => error,
        };
        match self.line {
            Some(line) => error.at_line(line, None),
            None => error,
        }
    }
}
