//! The program `lath`: the library `lath_cli`, run on the arguments of the process.
#![forbid(unsafe_code)]

use std::process::ExitCode;

fn main() -> ExitCode {
    ExitCode::from(lath_cli::run(std::env::args_os()))
}
