//! Lines of arguments that a fuzzer found worth keeping, run again as a stranger would.
#![allow(clippy::unwrap_used)] // helpers of tests stop at the first fault, loudly

mod tool;

use fuzzing::LONGEST;
use fuzzing::arguments::{FILES, judge, line};
use std::fs;
use std::path::PathBuf;
use std::process::{Command, Stdio};
use tool::{Folder, repository};

/// The files of a folder of `fuzz`, in order; none where there is no folder.
fn files(kept: &str) -> Vec<PathBuf> {
    let entries = fs::read_dir(repository(&format!("fuzz/{kept}/arguments"))).into_iter().flatten();
    let mut found: Vec<PathBuf> = entries.map(|entry| entry.unwrap().path()).collect();
    found.sort();
    found
}

/// Runs every line in a folder of its own, and says how many there were.
fn replay(kept: &str) -> usize {
    let inputs = files(kept);
    for input in &inputs {
        let bytes = fs::read(input).unwrap();
        assert!(bytes.len() <= LONGEST, "{} is too long to be kept", input.display());
        let arguments = line(&bytes).unwrap();
        let folder = Folder::new();
        for (name, text) in FILES {
            folder.file(name, text);
        }
        let output = Command::new(env!("CARGO_BIN_EXE_lath"))
            .args(&arguments)
            .current_dir(folder.path(""))
            .stdin(Stdio::null())
            .output()
            .unwrap();
        let err = String::from_utf8_lossy(&output.stderr);
        judge(output.status.code(), Some((&output.stdout, &err)));
    }
    inputs.len()
}

#[test]
fn every_crash_stays_mended() {
    replay("regressions");
}

#[test]
fn every_kept_line_ends_as_the_contract_says() {
    assert!(replay("corpus") >= 50, "the corpus is lost");
}
