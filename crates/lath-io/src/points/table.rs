//! The table that every points format becomes.

use lath::error::Code as CoreCode;

use crate::error::{Code, Error, Result};
use crate::json::child;
use crate::number::counted;

/// Rows of numbers of one width, with what the file says about them.
///
/// ```
/// use lath::error::Limits;
/// use lath_io::{format, source::Source};
///
/// let source = Source::from_bytes("nile.csv", "year,volume\n1871,1120\n1872,1160\n");
/// let table = format::read_points(&source, None, &Limits::default())?;
/// assert_eq!((table.len(), table.width()), (2, 2));
/// let (year, volume) = table.split_parameter("year")?;
/// assert_eq!(year, [1871.0, 1872.0]);
/// assert_eq!(volume.values(), [1120.0, 1160.0]);
/// # Ok::<(), lath_io::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct PointTable {
    pub(crate) source: Option<String>,
    pub(crate) title: Option<String>,
    pub(crate) columns: Option<Vec<String>>,
    pub(crate) width: usize,
    pub(crate) values: Vec<f64>,
    pub(crate) rows_at: RowsAt,
}

/// Where the rows stand in their file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum RowsAt {
    /// The line of each row, from 1.
    Lines(Vec<u32>),
    /// Row i is item i of the JSON array with this pointer.
    Items(String),
    /// There is no file, or a row has no one place in it.
    Nowhere,
}

impl PointTable {
    /// A table that comes from no file.
    ///
    /// # Errors
    /// P001 no rows, P005 values that do not fill the last row or names that do not match the columns, P006 no columns.
    pub fn new(columns: Option<Vec<String>>, width: usize, values: Vec<f64>) -> Result<PointTable> {
        let core = |code, message: String| Err(Error::new(Code::Core(code), message));
        if width == 0 {
            return core(CoreCode::P006, "a row without columns".into());
        }
        if values.is_empty() {
            return core(CoreCode::P001, "there are no rows".into());
        }
        if !values.len().is_multiple_of(width) {
            return core(
                CoreCode::P005,
                format!("rows of {width} cannot be made of {}", counted(values.len(), "number")),
            );
        }
        match &columns {
            Some(names) if names.len() != width => {
                core(CoreCode::P005, format!("{} for {}", counted(names.len(), "name"), counted(width, "column")))
            }
            _ => Ok(PointTable { source: None, title: None, columns, width, values, rows_at: RowsAt::Nowhere }),
        }
    }

    /// The name of the file or stream.
    #[must_use]
    pub fn source(&self) -> Option<&str> {
        self.source.as_deref()
    }

    /// A first line that is not a row of column names: `RAE 2822 AIRFOIL`.
    #[must_use]
    pub fn title(&self) -> Option<&str> {
        self.title.as_deref()
    }

    /// The names of the columns, where the file gives them.
    #[must_use]
    pub fn columns(&self) -> Option<&[String]> {
        self.columns.as_deref()
    }

    /// The numbers in a row: at least 1.
    #[must_use]
    pub fn width(&self) -> usize {
        self.width
    }

    /// The number of rows.
    #[must_use]
    pub fn len(&self) -> usize {
        self.values.len().checked_div(self.width).unwrap_or(0)
    }

    /// True where there are no rows; no reader returns such a table.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.values.is_empty()
    }

    /// All numbers, row after row.
    #[must_use]
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// The row at `index`.
    #[must_use]
    pub fn row(&self, index: usize) -> Option<&[f64]> {
        let start = index.checked_mul(self.width)?;
        self.values.get(start..start.checked_add(self.width)?)
    }

    /// The rows in order.
    pub fn rows(&self) -> impl ExactSizeIterator<Item = &[f64]> {
        self.values.chunks_exact(self.width.max(1))
    }

    /// The line of the file where a row stands, from 1; none for JSON.
    #[must_use]
    pub fn line(&self, row: usize) -> Option<u32> {
        match &self.rows_at {
            RowsAt::Lines(lines) => lines.get(row).copied(),
            _ => None,
        }
    }

    /// What the core refused about these points, their parameters or weights, with the name of the file and the place of the
    /// row.
    ///
    /// ```
    /// use lath::error::{Code, Limits};
    /// use lath_io::{format, source::Source};
    ///
    /// let source = Source::from_bytes("twice.txt", "# two\n0 0\n\n0 0\n");
    /// let table = format::read_points(&source, None, &Limits::default())?;
    /// let refused = lath::error::Error::new(Code::P004, "points 0 and 1 coincide").at(1);
    /// assert!(table.locate(refused).to_string().starts_with("twice.txt:4: P004: points 0 and 1 coincide (index 1)."));
    /// # Ok::<(), lath_io::Error>(())
    /// ```
    #[must_use]
    pub fn locate(&self, refused: lath::error::Error) -> Error {
        let row = refused.index().filter(|_| refused.is_points() || refused.is_parameter() || refused.is_weights());
        let mut error = Error::from(refused);
        if let Some(name) = &self.source {
            error = error.in_source(name);
        }
        match (&self.rows_at, row) {
            (RowsAt::Lines(lines), Some(row)) => match lines.get(row) {
                Some(&line) => error.at_line(u64::from(line), None),
                None => error,
            },
            (RowsAt::Items(pointer), Some(row)) if row < self.len() => {
                error.at_pointer(child(pointer, &row.to_string()))
            }
            _ => error,
        }
    }
}
