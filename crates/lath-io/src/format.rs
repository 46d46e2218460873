//! The registry of formats, and reading whatever comes.
//!
//! A format is one [`Format`] in [`FORMATS`]: its name for `--from` and `--format`, its extensions, how its bytes are
//! recognised, and its functions. Whoever adds one writes one file and one line here. Which format a source has is
//! decided in this order: the one asked for; the one its extension belongs to; the first in the registry that
//! recognises its content. Text recognises everything, and so comes last.
//!
//! A format tells how bytes are arranged, not what they mean: JSON may hold points or shapes, and [`Content`] says
//! which.

use std::io::Write;
use std::path::Path;

use lath::error::Limits;

use crate::error::{Code, Error, Result};
use crate::json::{self, Json};
use crate::points::{self, JsonRows, NpyRows, PointTable, RowSink, Rows, Separated, npy};
use crate::shapes::{self, Shape, geomdl, scipy};
use crate::source::Source;
use crate::stream::Stream;

/// What a file holds.
#[derive(Clone, Debug)]
pub enum Content {
    /// Rows of numbers.
    Points(PointTable),
    /// Curves, from lath JSON.
    Shapes(Vec<Shape>),
}

/// What a stream holds.
#[derive(Debug)]
pub enum Opened<'a> {
    /// Rows of numbers, read as they are needed.
    Rows(Rows<'a>),
    /// Curves, from lath JSON.
    Shapes(Vec<Shape>),
}

/// Begins a table: the names above the rows, and how many rows will come, where that is known.
type Begin = for<'w> fn(&'w mut dyn Write, Option<&[String]>, Option<u64>) -> Result<Box<dyn RowSink + 'w>>;

/// Reads a source; of a table the named columns only, where some are named.
type Read = fn(&Source, Option<&[&str]>, &Limits<'_>) -> Result<Content>;

/// Opens a stream of rows; of the named columns only, where some are named.
type Open = for<'a> fn(Stream<'a>, Option<Vec<String>>, &'a Limits<'a>) -> Result<Rows<'a>>;

type WriteShapes = fn(&mut dyn Write, &[Shape]) -> Result<()>;

/// One format of the registry.
#[derive(Debug)]
pub struct Format {
    /// Its name on the command line.
    pub name: &'static str,
    /// The extensions that mean it, in lower case and without dots.
    pub extensions: &'static [&'static str],
    /// What it is, in a few words.
    pub summary: &'static str,
    recognise: fn(&[u8]) -> bool,
    read: Read,
    /// None where nothing is known before the whole is read.
    open: Option<Open>,
    rows: Option<Begin>,
    /// The number of rows stands before them.
    counts: bool,
    shapes: Option<WriteShapes>,
}

/// All formats, in the order in which content is tried.
pub static FORMATS: &[Format] = &[
    Format {
        name: "json",
        extensions: &["json"],
        summary: "JSON: arrays of points, or shapes as lath JSON",
        recognise: |bytes| matches!(bytes.first(), Some(b'{' | b'[')),
        read: read_json,
        open: None,
        rows: Some(|out, columns, count| Ok(Box::new(JsonRows::begin(out, columns, count)?))),
        counts: false,
        shapes: Some(shapes::write),
    },
    Format {
        name: "csv",
        extensions: &["csv"],
        summary: "comma-separated rows under a line of names; semicolons, tabs and blanks are read too",
        recognise: |_| false,
        read: read_text,
        open: Some(|stream, columns, limits| Rows::text(stream, columns, limits)),
        rows: Some(|out, columns, count| Ok(Box::new(Separated::begin(out, ",", columns, count)?))),
        counts: false,
        shapes: None,
    },
    Format {
        name: "tsv",
        extensions: &["tsv"],
        summary: "tab-separated rows under a line of names",
        recognise: |_| false,
        read: read_text,
        open: Some(|stream, columns, limits| Rows::text(stream, columns, limits)),
        rows: Some(|out, columns, count| Ok(Box::new(Separated::begin(out, "\t", columns, count)?))),
        counts: false,
        shapes: None,
    },
    Format {
        name: "npy",
        extensions: &["npy"],
        summary: "NumPy's arrays: float64, one row a point; narrower numbers are read too",
        recognise: |bytes| bytes.starts_with(npy::MAGIC),
        read: |source, columns, limits| npy::read(source, limits).and_then(|table| choose(table, columns)),
        open: Some(|stream, columns, limits| Rows::array(stream, columns, limits)),
        rows: Some(|out, columns, count| NpyRows::begin(out, columns, count)),
        counts: true,
        shapes: None,
    },
    Format {
        name: "scipy",
        extensions: &[],
        summary: "a B-spline of SciPy as JSON, {\"t\":[…],\"c\":[…],\"k\":3}",
        recognise: |_| false,
        read: read_json,
        open: None,
        rows: None,
        counts: false,
        shapes: Some(scipy::write),
    },
    Format {
        name: "text",
        extensions: &["txt", "dat", "xy"],
        summary: "rows of numbers between blanks, under a title or a line of names",
        recognise: |_| true,
        read: read_text,
        open: Some(|stream, columns, limits| Rows::text(stream, columns, limits)),
        rows: Some(|out, columns, count| Ok(Box::new(Separated::begin(out, " ", columns, count)?))),
        counts: false,
        shapes: None,
    },
];

impl Format {
    /// True where rows of numbers can be written.
    #[must_use]
    pub fn holds_points(&self) -> bool {
        self.rows.is_some()
    }

    /// True where rows are written in constant memory only if their number is told before ([`Format::rows_counted`]).
    #[must_use]
    pub fn counts_rows(&self) -> bool {
        self.counts
    }

    /// True where shapes can be written.
    #[must_use]
    pub fn holds_shapes(&self) -> bool {
        self.shapes.is_some()
    }

    /// Begins a table of rows in this format: `columns` are the names above them, where there are any.
    ///
    /// The rows go out as they come, in constant memory; but `npy` begins with their number, and so keeps them (8 bytes
    /// a number) until the end. [`Format::rows_counted`] does not.
    ///
    /// ```
    /// use lath_io::format;
    ///
    /// let mut out = Vec::new();
    /// let mut rows = format::by_name("csv")?.rows(&mut out, Some(&["t".to_owned(), "x".to_owned()]))?;
    /// rows.row(&[0.0, 0.5])?;
    /// rows.row(&[1.0, 1e-9])?;
    /// rows.finish()?;
    /// drop(rows);
    /// assert_eq!(out, b"t,x\n0,0.5\n1,1e-9\n");
    /// # Ok::<(), lath_io::Error>(())
    /// ```
    ///
    /// # Errors
    /// F023 for a format that holds no points; I005 where writing fails.
    pub fn rows<'w>(&self, out: &'w mut dyn Write, columns: Option<&[String]>) -> Result<Box<dyn RowSink + 'w>> {
        self.rows.ok_or_else(|| self.holds_no("points"))?(out, columns, None)
    }

    /// Begins a table of exactly `count` rows: every format then writes in constant memory, and refuses another number
    /// of rows with F024.
    ///
    /// ```
    /// use lath_io::format;
    ///
    /// let mut out = Vec::new();
    /// let mut rows = format::by_name("npy")?.rows_counted(&mut out, None, 2)?;
    /// rows.row(&[0.0, 0.5])?;
    /// assert_eq!(rows.finish().unwrap_err().code().as_str(), "F024");
    /// # Ok::<(), lath_io::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`Format::rows`].
    pub fn rows_counted<'w>(
        &self,
        out: &'w mut dyn Write,
        columns: Option<&[String]>,
        count: u64,
    ) -> Result<Box<dyn RowSink + 'w>> {
        self.rows.ok_or_else(|| self.holds_no("points"))?(out, columns, Some(count))
    }

    /// Writes shapes: as lath JSON, or one open B-spline as SciPy's `t`, `c` and `k`.
    ///
    /// # Errors
    /// F023 for a format that holds no shapes, or not these; as [`shapes::write`].
    pub fn write_shapes(&self, out: &mut dyn Write, shapes: &[Shape]) -> Result<()> {
        self.shapes.ok_or_else(|| self.holds_no("shapes"))?(out, shapes)
    }

    fn holds_no(&self, what: &str) -> Error {
        let able: Vec<&str> = FORMATS
            .iter()
            .filter(|format| if what == "points" { format.holds_points() } else { format.holds_shapes() })
            .map(|format| format.name)
            .collect();
        Error::new(Code::F023, format!("the format {} holds no {what}", self.name))
            .remedied(format!("Formats that do are {}.", able.join(", ")))
    }
}

/// The format of that name, or with that extension.
///
/// # Errors
/// F004, listing the names there are.
pub fn by_name(name: &str) -> Result<&'static Format> {
    FORMATS.iter().find(|format| format.name == name).or_else(|| by_extension(name)).ok_or_else(|| {
        let names: Vec<&str> = FORMATS.iter().map(|format| format.name).collect();
        Error::new(Code::F004, format!("there is no format \"{name}\""))
            .remedied(format!("The formats are {}.", names.join(", ")))
    })
}

/// The format that an extension (in any case, without its dot) belongs to.
#[must_use]
pub fn by_extension(extension: &str) -> Option<&'static Format> {
    let extension = extension.to_ascii_lowercase();
    FORMATS.iter().find(|format| format.extensions.contains(&extension.as_str()))
}

/// The format that the extension of a path belongs to.
#[must_use]
pub fn of_path(path: &Path) -> Option<&'static Format> {
    path.extension().and_then(|extension| extension.to_str()).and_then(by_extension)
}

/// The format of a source: `from` where it is given, else by extension, else by content.
///
/// # Errors
/// F004 where the content is recognised as something that no format here reads.
pub fn of_source(source: &Source, from: Option<&'static Format>) -> Result<&'static Format> {
    match from.or_else(|| of_path(Path::new(source.name()))) {
        Some(format) => Ok(format),
        None => sniff(&Stream::of(source).beginning()?).map_err(|error| error.in_source(source.name())),
    }
}

/// The format that begins with these bytes, without a byte-order mark and blanks before them.
fn sniff(beginning: &[u8]) -> Result<&'static Format> {
    for (start, what) in FOREIGN {
        if beginning.starts_with(start) {
            let error = Error::new(Code::F004, format!("this looks like {what}"));
            return Err(error.remedied("Give points as text or JSON, or shapes as lath JSON."));
        }
    }
    FORMATS
        .iter()
        .find(|format| (format.recognise)(beginning))
        .ok_or_else(|| Error::new(Code::F004, "no format recognises this"))
}

/// Beginnings that are certainly none of ours.
const FOREIGN: &[(&[u8], &str)] = &[
    (b"\x89PNG", "a PNG picture"),
    (b"%PDF", "PDF"),
    (b"PK\x03\x04", "a zip archive"),
    (b"\x1f\x8b", "gzip-compressed data"),
    (b"<", "XML, SVG or HTML"),
];

/// Reads a source in whatever format it has.
///
/// # Errors
/// As the format's own reader; F004 where no format reads it.
pub fn read(source: &Source, from: Option<&'static Format>, limits: &Limits<'_>) -> Result<Content> {
    (of_source(source, from)?.read)(source, None, limits)
}

/// Opens a stream in whatever format it has: points are then read row by row, in constant memory but for JSON; shapes
/// are read at once. Of points only these `columns`, named or by index from 0 as in [`read_columns`].
///
/// ```
/// use lath::error::Limits;
/// use lath_io::format::{self, Opened};
/// use lath_io::source::Source;
/// use lath_io::stream::Stream;
///
/// let source = Source::from_bytes("log.csv", "date,x\n2020-01-01,1.5\n2020-01-02,2.5\n");
/// let (wanted, limits) = (vec!["x".to_owned()], Limits::default());
/// let Opened::Rows(mut rows) = format::open(Stream::of(&source), None, Some(wanted), &limits)? else { panic!("shapes") };
/// assert_eq!(rows.next_row()?, Some(&[1.5][..]));
/// assert_eq!(rows.next_row()?, Some(&[2.5][..]));
/// assert_eq!(rows.next_row()?, None);
/// # Ok::<(), lath_io::Error>(())
/// ```
///
/// # Errors
/// F004 where no format reads it, I004 where reading fails, and what the header of an `.npy` file is refused for; all
/// else where the rows are read. Formats without streams, and shapes, as [`read`] and [`read_columns`].
pub fn open<'a>(
    mut stream: Stream<'a>,
    from: Option<&'static Format>,
    columns: Option<Vec<String>>,
    limits: &'a Limits<'a>,
) -> Result<Opened<'a>> {
    let format = match from.or_else(|| of_path(Path::new(stream.name()))) {
        Some(format) => format,
        None => sniff(&stream.beginning()?).map_err(|error| error.in_source(stream.name()))?,
    };
    if let Some(open) = format.open {
        return open(stream, columns, limits).map(Opened::Rows);
    }
    let source = stream.into_source(limits)?;
    let columns: Option<Vec<&str>> = columns.as_ref().map(|names| names.iter().map(String::as_str).collect());
    Ok(match (format.read)(&source, columns.as_deref(), limits)? {
        Content::Points(table) => Opened::Rows(Rows::table(table)),
        Content::Shapes(shapes) => Opened::Shapes(shapes),
    })
}

/// Reads these columns of a table, named or by index from 0, in the order given. What the other columns hold does not
/// matter: they may be dates or words.
///
/// ```
/// use lath::error::Limits;
/// use lath_io::{format, source::Source};
///
/// let source = Source::from_bytes("log.csv", "date,x,y\n2020-01-01,0,1.5\n2020-01-02,1,2.5\n");
/// let table = format::read_columns(&source, None, &["x", "y"], &Limits::default())?;
/// assert_eq!(table.values(), [0.0, 1.5, 1.0, 2.5]);
/// # Ok::<(), lath_io::Error>(())
/// ```
///
/// # Errors
/// As [`read_points`]; F009 a column that is not there, F022 a name that two columns have.
pub fn read_columns<S: AsRef<str>>(
    source: &Source,
    from: Option<&'static Format>,
    columns: &[S],
    limits: &Limits<'_>,
) -> Result<PointTable> {
    let columns: Vec<&str> = columns.iter().map(AsRef::as_ref).collect();
    points_of(source, (of_source(source, from)?.read)(source, Some(&columns), limits)?)
}

/// Reads points, in whatever format they have.
///
/// # Errors
/// As [`read`]; F021 where the source holds shapes.
pub fn read_points(source: &Source, from: Option<&'static Format>, limits: &Limits<'_>) -> Result<PointTable> {
    points_of(source, read(source, from, limits)?)
}

fn points_of(source: &Source, content: Content) -> Result<PointTable> {
    match content {
        Content::Points(table) => Ok(table),
        Content::Shapes(_) => {
            Err(Error::new(Code::F021, "this is lath JSON with shapes, but points are needed").in_source(source.name()))
        }
    }
}

/// Reads shapes.
///
/// # Errors
/// As [`read`]; F021 where the source holds points.
pub fn read_shapes(source: &Source, from: Option<&'static Format>, limits: &Limits<'_>) -> Result<Vec<Shape>> {
    match read(source, from, limits)? {
        Content::Shapes(shapes) => Ok(shapes),
        Content::Points(_) => {
            let error = Error::new(Code::F021, "these are points, but shapes are needed");
            Err(error.remedied("Make a curve of them first, with `through` or `curve`.").in_source(source.name()))
        }
    }
}

fn read_text(source: &Source, columns: Option<&[&str]>, limits: &Limits<'_>) -> Result<Content> {
    points::text::read_chosen(source, columns, limits).map(Content::Points)
}

fn choose(table: PointTable, columns: Option<&[&str]>) -> Result<Content> {
    match columns {
        None => Ok(Content::Points(table)),
        Some(columns) => table.take_columns(columns).map(Content::Points),
    }
}

fn read_json(source: &Source, columns: Option<&[&str]>, limits: &Limits<'_>) -> Result<Content> {
    let tree = json::parse(source, limits)?;
    match DIALECTS.iter().find(|dialect| (dialect.recognise)(&tree)) {
        Some(dialect) => (dialect.read)(source, tree, limits).map(Content::Shapes),
        None => points::json::from_tree(source, tree, columns, limits).map(Content::Points),
    }
}

/// What JSON with shapes in it may be.
struct Dialect {
    recognise: fn(&Json) -> bool,
    read: fn(&Source, Json, &Limits<'_>) -> Result<Vec<Shape>>,
}

const DIALECTS: &[Dialect] = &[
    Dialect { recognise: shapes::recognise, read: shapes::from_tree },
    Dialect { recognise: geomdl::recognise, read: geomdl::from_tree },
    Dialect { recognise: scipy::recognise, read: scipy::from_tree },
];

#[cfg(test)]
mod tests {
    use super::*;

    fn name(source: &str, content: &str) -> &'static str {
        match of_source(&Source::from_bytes(source, content), None) {
            Ok(format) => format.name,
            Err(error) => error.code().as_str(),
        }
    }

    #[test]
    fn formats_are_found_by_name_extension_and_content() {
        assert_eq!((by_name("tsv").unwrap().name, by_name("txt").unwrap().name), ("tsv", "text"));
        let error = by_name("xls").unwrap_err();
        assert_eq!(
            error.to_string(),
            "F004: there is no format \"xls\". The formats are json, csv, tsv, npy, scipy, text."
        );
        assert_eq!(by_extension("DAT").unwrap().name, "text");
        assert!(by_extension("png").is_none());
        assert_eq!(name("a.csv", "[1]"), "csv");
        assert_eq!(name("standard input", "\u{feff} \n [1]"), "json");
        assert_eq!(name("standard input", "x y"), "text");
        assert_eq!(name("data", "{}"), "json");
        assert_eq!(name("a.svg", "<svg/>"), "F004");
    }

    #[test]
    fn points_and_shapes_are_told_apart() {
        let limits = Limits::default();
        let points = Source::from_bytes("p.json", "[[1,2]]");
        let shapes = Source::from_bytes("s.json", "{\"lath\":1,\"shapes\":[]}");
        assert!(matches!(read(&points, None, &limits), Ok(Content::Points(_))));
        assert!(matches!(read(&shapes, None, &limits), Ok(Content::Shapes(s)) if s.is_empty()));
        assert_eq!(read_points(&shapes, None, &limits).unwrap_err().code().as_str(), "F021");
        assert_eq!(read_shapes(&points, None, &limits).unwrap_err().code().as_str(), "F021");
    }

    #[test]
    fn rows_written_in_every_format_read_back() {
        let names = ["t", "x 1", "a,b;\"#"].map(String::from);
        let values = [0.1, -0.0, 1e300, 5e-324, 9007199254740994.0, 1e16, -1.5, 1.0 / 3.0, 1e-7];
        for format in FORMATS.iter().filter(|format| format.holds_points()) {
            for columns in [None, Some(&names[..])] {
                let mut out = Vec::new();
                let mut rows = format.rows(&mut out, columns).unwrap();
                values.chunks(3).for_each(|row| rows.row(row).unwrap());
                rows.finish().unwrap();
                drop(rows);
                let source = Source::from_bytes(&format!("a.{}", format.extensions[0]), out);
                let table = read_points(&source, None, &Limits::default()).unwrap();
                let columns = columns.filter(|_| format.name != "npy"); // which has no place for names
                assert_eq!(table.columns(), columns, "{}", format.name);
                assert!(table.values().iter().zip(values).all(|(a, b)| a.to_bits() == b.to_bits()), "{}", format.name);
            }
        }
    }

    #[test]
    fn names_that_would_read_as_a_row_are_left_out() {
        let mut out = Vec::new();
        by_name("csv")
            .unwrap()
            .rows(&mut out, Some(&["0".to_owned(), "1".to_owned()]))
            .unwrap()
            .row(&[2.0, 3.0])
            .unwrap();
        assert_eq!(out, b"2,3\n");
    }

    #[test]
    fn what_is_not_finite_is_never_written() {
        for format in FORMATS.iter().filter(|format| format.holds_points()) {
            let mut out = Vec::new();
            let mut rows = format.rows(&mut out, None).unwrap();
            rows.row(&[1.0]).unwrap();
            let error = rows.row(&[f64::NAN]).unwrap_err();
            assert_eq!((error.code().as_str(), error.place().index), ("P002", Some(1)));
            assert_eq!(rows.row(&[f64::NEG_INFINITY]).unwrap_err().code().as_str(), "P002");
            assert_eq!(rows.row(&[1.0, 2.0]).unwrap_err().code().as_str(), "P005");
        }
    }
}
