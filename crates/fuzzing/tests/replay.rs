//! Every kept input of the fuzz targets, run again: what was found once stays found.
#![allow(clippy::unwrap_used)] // helpers of tests stop at the first fault, loudly

use fuzzing::{LONGEST, TARGETS, Target};
use std::fs;
use std::panic::catch_unwind;
use std::path::{Path, PathBuf};

fn folder(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fuzz").join(name)
}

/// The files of a folder, in order; none where there is no folder.
fn files(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).into_iter().flatten();
    let mut found: Vec<PathBuf> = entries.map(|entry| entry.unwrap().path()).collect();
    found.sort();
    found
}

/// Runs all inputs of a target, and names those that broke a promise.
fn replay(kept: &str, target: &str, run: Target) -> usize {
    let inputs = files(&folder(kept).join(target));
    let mut culprits = Vec::new();
    for input in &inputs {
        let bytes = fs::read(input).unwrap();
        assert!(bytes.len() <= LONGEST, "{} is too long to be kept", input.display());
        if catch_unwind(|| run(&bytes)).is_err() {
            culprits.push(input);
        }
    }
    assert!(culprits.is_empty(), "{target}: {culprits:#?}");
    inputs.len()
}

#[test]
fn every_crash_stays_mended() {
    for (target, run) in TARGETS {
        replay("regressions", target, run);
    }
}

#[test]
fn every_kept_input_is_answered_or_refused() {
    for (target, run) in TARGETS {
        assert!(replay("corpus", target, run) >= 50, "the corpus of {target} is lost");
    }
}
