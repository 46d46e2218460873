//! The only automation of the project, in Rust so that it runs wherever the library builds.
//!
//! `.ci/run` calls it and nothing else beside cargo; whatever the project checks or generates is a command here, one per
//! file. Every command works offline once `cargo fetch` has run, reads nothing outside the checkout, and answers with
//! sentences that say what to do.
#![allow(clippy::print_stdout, clippy::print_stderr)] // talking is its job

mod bad_inputs;
mod ci;
mod claims;
mod floors;
mod gallery;
mod licences;
mod named_test;
mod spdx;
mod test_source;

use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// What a command ends with: faults to be printed, one a line.
type Outcome = Result<String, String>;

const HELP: &str = "\
cargo xtask <command>

  ci         all checks below, and formatting, lints and documentation: what .ci/run calls
  bad-inputs every input of testdata/bad-inputs.toml that breaks spline code has its tests, or says what must exist first
  claims     every claim of testdata/claims.toml has a test that can run, or a recorded command
  floors     the core compiles cut off above each of its floors
  gallery    draws the pictures of the documentation anew, or the figures named behind it, and writes the gallery's page
  licences   every dependency's licence is allowed, and no crate comes in two versions without a reason
  help       this text
";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let root = root();
    let outcome = match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        ["ci"] => ci::run(&root),
        ["bad-inputs"] => bad_inputs::run(&root),
        ["claims"] => claims::run(&root),
        ["floors"] => floors::run(&root),
        ["licences"] => licences::run(&root),
        ["gallery", ref names @ ..] => gallery::run(&root, names),
        ["help" | "--help" | "-h"] | [] => {
            print!("{HELP}");
            return ExitCode::SUCCESS;
        }
        _ => {
            eprint!("unknown command: {}\n\n{HELP}", arguments.join(" "));
            return ExitCode::from(2);
        }
    };
    match outcome {
        Ok(summary) => {
            println!("{summary}");
            ExitCode::SUCCESS
        }
        Err(faults) => {
            eprintln!("{faults}");
            ExitCode::FAILURE
        }
    }
}

/// The root of the checkout.
fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().map_or_else(PathBuf::new, Path::to_path_buf)
}

/// Reads a file of the checkout.
fn read(root: &Path, path: &str) -> Result<String, String> {
    std::fs::read_to_string(root.join(path)).map_err(|error| format!("{path}: {error}"))
}

/// Reads a TOML file of the checkout.
fn read_toml(root: &Path, path: &str) -> Result<toml::Table, String> {
    read(root, path)?.parse().map_err(|error| format!("{path}: {error}"))
}
