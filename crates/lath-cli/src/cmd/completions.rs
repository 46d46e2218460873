//! `lath completions`: what shells complete, as a script of theirs.

use crate::args::Cli;
use crate::failure::Result;
use crate::output::Output;
use clap::{CommandFactory, ValueEnum};
use clap_complete::Shell;
use lath_io::Error;

/// Print the completions for a shell
///
/// The shell then completes verbs, options and their values when Tab is pressed.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Args {
    /// The shell.
    #[arg(value_enum)]
    shell: Name,
    #[command(flatten)]
    output: Output,
}

const EXAMPLES: &str = "\
Examples:
  lath completions bash -o ~/.local/share/bash-completion/completions/lath
  lath completions zsh -o ~/.zfunc/_lath
  lath completions fish -o ~/.config/fish/completions/lath.fish
  lath completions powershell >> $PROFILE";

#[derive(Clone, Copy, Debug, PartialEq, ValueEnum)]
enum Name {
    Bash,
    Zsh,
    Fish,
    #[value(name = "powershell")]
    PowerShell,
}

/// Writes the script.
pub(crate) fn run(args: &Args) -> Result<()> {
    let shell = match args.shell {
        Name::Bash => Shell::Bash,
        Name::Zsh => Shell::Zsh,
        Name::Fish => Shell::Fish,
        Name::PowerShell => Shell::PowerShell,
    };
    let mut script = Vec::new();
    clap_complete::generate(shell, &mut Cli::command(), "lath", &mut script);
    args.output.write(|out| out.write_all(&script).map_err(|error| Error::writing(&error)))
}
