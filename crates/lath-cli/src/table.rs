//! Tables of numbers as results: their format, and the names of their columns.

use crate::failure::{Failure, Result};
use crate::input::format_names;
use crate::output::{Output, extension};
use lath_io::format::{self, Format};
use std::path::Path;

/// The options that say how a table is written.
#[derive(Debug, clap::Args)]
pub(crate) struct TableFormat {
    /// The format of the table (default: by the extension of the output, else csv).
    #[arg(long, value_name = "FORMAT", value_parser = format_names())]
    format: Option<String>,
    /// The same as --format json: {"columns":[…],"rows":[[…],…]}.
    #[arg(long, conflicts_with = "format")]
    json: bool,
}

impl TableFormat {
    /// Whether the table is for a program.
    pub(crate) fn is_json(&self) -> bool {
        self.json || self.format.as_deref() == Some("json")
    }

    /// As asked for, else by the extension of the output, else CSV.
    pub(crate) fn choose(&self, output: &Output) -> Result<&'static Format> {
        self.choose_for(output.file())
    }

    /// As asked for, else by the extension of this file, else CSV.
    pub(crate) fn choose_for(&self, file: Option<&Path>) -> Result<&'static Format> {
        let by_name = |name: &str| Ok(format::by_name(name)?);
        let chosen = match (&self.format, self.json, extension(file)) {
            (Some(name), ..) => by_name(name),
            (None, true, _) => by_name("json"),
            (None, false, None) => by_name("csv"),
            (None, false, Some(extension)) => format::by_extension(&extension).ok_or_else(|| {
                Failure::usage(format!("no table format has the extension '.{extension}': choose one with '--format'"))
            }),
        }?;
        match chosen.holds_points() {
            true => Ok(chosen),
            false => Err(Failure::usage(format!("the format '{}' holds no table", chosen.name))),
        }
    }
}

/// x, y, z; x0, x1, … beyond three.
pub(crate) fn axis_names(dimension: usize) -> Vec<String> {
    match dimension {
        0..=3 => ["x", "y", "z"].iter().take(dimension).map(|&axis| axis.to_owned()).collect(),
        _ => (0..dimension).map(|i| format!("x{i}")).collect(),
    }
}
