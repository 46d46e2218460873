//! Where data come from.

use crate::failure::{Failure, Result};
use clap::builder::PossibleValuesParser;
use lath::error::Limits;
use lath_io::format::{self, Content, FORMATS, Format, Opened};
use lath_io::points::PointTable;
use lath_io::source::Source;
use lath_io::stream::Stream;
use lath_io::{Code, Error};
use std::path::Path;
use std::str::FromStr;

/// How input is read, whatever it holds.
#[derive(Debug, clap::Args)]
pub(crate) struct Reading {
    /// Read as this format, whatever the extension or content says.
    #[arg(long, value_name = "FORMAT", value_parser = format_names())]
    from: Option<String>,
}

/// The formats by name, with suggestions and help from clap.
pub(crate) fn format_names() -> PossibleValuesParser {
    let value = |format: &'static Format| clap::builder::PossibleValue::new(format.name).help(format.summary);
    PossibleValuesParser::new(FORMATS.iter().map(value))
}

impl Reading {
    /// By extension or content.
    pub(crate) fn sniffed() -> Reading {
        Reading { from: None }
    }

    fn format(&self) -> Result<Option<&'static Format>> {
        Ok(self.from.as_deref().map(format::by_name).transpose()?)
    }

    /// The bytes, and the format that was asked for.
    pub(crate) fn source(&self, path: &Path, limits: &Limits<'_>) -> Result<(Source, Option<&'static Format>)> {
        Ok((Source::open(path, limits)?, self.format()?))
    }

    /// Reads points or shapes.
    pub(crate) fn read(&self, path: &Path, limits: &Limits<'_>) -> Result<(String, Content)> {
        let source = Source::open(path, limits)?;
        let content = format::read(&source, self.format()?, limits)?;
        Ok((source.name().to_owned(), content))
    }

    /// Opens points as rows that are read when they are needed, only the named columns where some are named; shapes are
    /// read at once.
    pub(crate) fn open<'a>(&self, path: &Path, names: &[&str], limits: &'a Limits<'a>) -> Result<Opened<'a>> {
        let names = (!names.is_empty()).then(|| names.iter().map(|&name| name.to_owned()).collect());
        Ok(format::open(Stream::open(path)?, self.format()?, names, limits)?)
    }

    /// Reads points or shapes; of points with named columns only these, so that the others may hold words.
    pub(crate) fn read_named(&self, path: &Path, names: &[&str], limits: &Limits<'_>) -> Result<(String, Content)> {
        let (source, format) = self.source(path, limits)?;
        let content = match named(&source, format, names, limits)? {
            Some(table) => Content::Points(table),
            None => format::read(&source, format, limits)?,
        };
        Ok((source.name().to_owned(), content))
    }

    /// Reads points; of named columns only these, so that the others may hold words.
    pub(crate) fn points_named(&self, path: &Path, names: &[&str], limits: &Limits<'_>) -> Result<PointTable> {
        let (source, format) = self.source(path, limits)?;
        match named(&source, format, names, limits)? {
            Some(table) => Ok(table),
            None => Ok(format::read_points(&source, format, limits)?),
        }
    }

    /// Reads shapes.
    pub(crate) fn shapes(&self, path: &Path, limits: &Limits<'_>) -> Result<Vec<lath_io::shapes::Shape>> {
        Ok(format::read_shapes(&Source::open(path, limits)?, self.format()?, limits)?)
    }
}

/// The named columns of points. None where there are no names, or where one is a number: it may be an index, which counts all
/// columns; and none where the source holds shapes.
fn named(
    source: &Source,
    format: Option<&'static Format>,
    names: &[&str],
    limits: &Limits<'_>,
) -> Result<Option<PointTable>> {
    if names.is_empty() || names.iter().any(|name| name.parse::<usize>().is_ok()) {
        return Ok(None);
    }
    let mut once: Vec<&str> = Vec::new();
    for name in names {
        if !once.contains(name) {
            once.push(name);
        }
    }
    match format::read_columns(source, format, &once, limits) {
        Err(error) if error.code() == Code::F021 => Ok(None),
        table => Ok(Some(table?)),
    }
}

/// The refusal of shapes where points are needed.
pub(crate) fn not_points(path: &Path) -> Failure {
    let name = if path.as_os_str() == "-" { "standard input".to_owned() } else { path.display().to_string() };
    Error::new(Code::F021, "this is lath JSON with shapes, but points are needed").in_source(&name).into()
}

/// Names of columns between commas, or their indices from 0.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Columns(pub(crate) Vec<String>);

impl FromStr for Columns {
    type Err = String;

    fn from_str(text: &str) -> Result<Columns, String> {
        let names: Vec<String> = text.split(',').map(|name| name.trim().to_owned()).collect();
        match names.iter().position(String::is_empty) {
            Some(i) => Err(format!("column {i} has no name")),
            None => Ok(Columns(names)),
        }
    }
}

/// Which columns of the points are coordinates.
#[derive(Debug, clap::Args)]
pub(crate) struct Coordinates {
    /// The columns that are coordinates, by name or by index from 0, such as x,y or 0,2.
    #[arg(long, value_name = "NAMES")]
    pub(crate) columns: Option<Columns>,
}

impl Coordinates {
    /// Their names; none where all columns are.
    pub(crate) fn names(&self) -> Vec<&str> {
        self.columns.iter().flat_map(|Columns(names)| names.iter().map(String::as_str)).collect()
    }

    /// The chosen columns of the table.
    pub(crate) fn of(&self, table: PointTable) -> Result<PointTable> {
        match &self.columns {
            Some(Columns(names)) => Ok(table.take_columns(names)?),
            None => Ok(table),
        }
    }
}

/// Refuses to read standard input twice.
pub(crate) fn check_standard_input<'a>(paths: impl IntoIterator<Item = &'a Path>) -> Result<()> {
    match paths.into_iter().filter(|path| path.as_os_str() == "-").count() {
        0 | 1 => Ok(()),
        _ => Err(Failure::usage("standard input ('-') can be read only once")),
    }
}
