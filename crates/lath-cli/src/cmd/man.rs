//! `lath man`: the manual pages, made from the same words as the help.

use crate::args::Cli;
use crate::failure::{Failure, Result};
use crate::output::{self, Output};
use clap::{Command, CommandFactory};
use clap_mangen::Man;
use lath_io::Error;
use std::path::PathBuf;

/// Print the manual page of the tool, or of a verb
///
/// Pages are in the format of man(7); `lath man | man -l -` shows one.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Args {
    /// The verb; without one, the tool as a whole.
    verb: Option<String>,
    /// Write the pages of the tool and of all verbs into this folder, as lath.1, lath-draw.1, …
    #[arg(long, value_name = "FOLDER", conflicts_with_all = ["verb", "output"])]
    all: Option<PathBuf>,
    #[command(flatten)]
    output: Output,
}

const EXAMPLES: &str = "\
Examples:
  lath man | man -l -
  lath man draw -o lath-draw.1
  lath man --all ~/.local/share/man/man1";

/// Writes the page, or all pages.
pub(crate) fn run(args: &Args) -> Result<()> {
    let mut tool = Cli::command();
    tool.build();
    if let Some(folder) = &args.all {
        for command in std::iter::once(&tool).chain(verbs(&tool)) {
            let (name, page) = page(command)?;
            let path = folder.join(format!("{name}.1"));
            output::write(Some(&path), |out| out.write_all(&page).map_err(|error| Error::writing(&error)))?;
        }
        return Ok(());
    }
    let command = match &args.verb {
        None => &tool,
        Some(verb) => verbs(&tool).find(|command| command.get_name() == verb).ok_or_else(|| {
            let known: Vec<&str> = verbs(&tool).map(Command::get_name).collect();
            Failure::usage(format!("there is no verb '{verb}'; there are {}", known.join(", ")))
        })?,
    };
    let (_, page) = page(command)?;
    args.output.write(|out| out.write_all(&page).map_err(|error| Error::writing(&error)))
}

fn verbs(tool: &Command) -> impl Iterator<Item = &Command> {
    tool.get_subcommands().filter(|command| command.get_name() != "help")
}

/// The name of the page and its text.
fn page(command: &Command) -> Result<(String, Vec<u8>)> {
    let name = command.get_display_name().unwrap_or("lath").to_owned();
    let mut page = Vec::new();
    let source = concat!("lath ", env!("CARGO_PKG_VERSION"));
    let man = Man::new(command.clone()).title(name.clone()).source(source).manual("lath");
    man.render(&mut page).map_err(|error| Error::writing(&error))?;
    Ok((name, page))
}
