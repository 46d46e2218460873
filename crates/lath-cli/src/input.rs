//! Where data come from.

use crate::failure::{Failure, Result};
use clap::builder::PossibleValuesParser;
use lath::error::Limits;
use lath_io::format::{self, Content, FORMATS, Format};
use lath_io::points::PointTable;
use lath_io::source::Source;
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

    /// Reads points.
    pub(crate) fn points(&self, path: &Path, limits: &Limits<'_>) -> Result<PointTable> {
        Ok(format::read_points(&Source::open(path, limits)?, self.format()?, limits)?)
    }

    /// Reads shapes.
    pub(crate) fn shapes(&self, path: &Path, limits: &Limits<'_>) -> Result<Vec<lath_io::shapes::Shape>> {
        Ok(format::read_shapes(&Source::open(path, limits)?, self.format()?, limits)?)
    }
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
