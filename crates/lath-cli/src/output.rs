//! Where results go: standard output, or a file that is written whole or not at all.

use crate::failure::{Failure, Result};
use crate::interruption::{Interruptible, Interruption};
use lath::error::{Code, Error};
use lath_io::atomic;
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

/// The target of a verb whose results are text.
#[derive(Debug, clap::Args)]
pub(crate) struct Output {
    /// Write to this file, replacing it (default: standard output, also `-`).
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

impl Output {
    /// The file, unless it is standard output.
    pub(crate) fn file(&self) -> Option<&Path> {
        file(self.output.as_deref())
    }

    /// Whether the results are kept back as a whole where writing fails.
    pub(crate) fn is_whole(&self) -> bool {
        is_whole(self.file())
    }

    /// Lets `fill` write the results.
    pub(crate) fn write(&self, fill: impl FnOnce(&mut dyn Write) -> lath_io::Result<()>) -> Result<()> {
        write(self.file(), fill)
    }
}

/// The path, unless it is `-`.
pub(crate) fn file(path: Option<&Path>) -> Option<&Path> {
    path.filter(|path| path.as_os_str() != "-")
}

/// Whether what is written to the file, or to standard output where there is none, is kept back as a whole where writing
/// fails. Elsewhere everything is looked at before the first row is written.
pub(crate) fn is_whole(file: Option<&Path>) -> bool {
    file.is_some_and(atomic::replaces)
}

/// The extension of the file in lower case, where it has one.
pub(crate) fn extension(path: Option<&Path>) -> Option<String> {
    Some(path?.extension()?.to_string_lossy().to_lowercase())
}

/// Lets `fill` write to the file, or to standard output where there is none.
pub(crate) fn write(file: Option<&Path>, fill: impl FnOnce(&mut dyn Write) -> lath_io::Result<()>) -> Result<()> {
    if let Some(path) = file {
        let interruption = Interruption::watch();
        let written = atomic::write(path, |out| fill(&mut Interruptible { out, interruption: &interruption }));
        return match written {
            Err(_) if interruption.happened() => {
                let error = Error::new(Code::B002, "interrupted; the file is as it was");
                Err(lath_io::Error::from(error).in_source(&path.display().to_string()).into())
            }
            written => Ok(written?),
        };
    }
    let mut out = BufWriter::with_capacity(1 << 16, io::stdout().lock());
    fill(&mut out).map_err(named)?;
    out.flush().map_err(|error| named(lath_io::Error::writing(&error)).into())
}

fn named(error: lath_io::Error) -> lath_io::Error {
    error.in_source("standard output")
}

/// What is written to a file must be what its extension promises.
pub(crate) fn check_extension(file: Option<&Path>, known: &[&str], remedy: &str) -> Result<()> {
    match extension(file) {
        Some(extension) if !known.contains(&extension.as_str()) => {
            Err(Failure::usage(format!("the extension '.{extension}' does not fit what is written: {remedy}")))
        }
        _ => Ok(()),
    }
}
