//! The house keeps its order: imports point down, names say something, files stay small, crates depend as agreed.
//! What each check refuses is shown in the unit tests of `testkit::layers`.
#![allow(clippy::unwrap_used)] // helpers of tests stop at the first fault, loudly

use std::fs;
use std::path::{Path, PathBuf};
use testkit::layers::{Layers, check, check_files, check_manifest, sources};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn layers() -> Layers {
    Layers::parse(&fs::read_to_string(root().join("layers.toml")).unwrap())
}

/// The folders of all crates, the automation among them.
fn crates() -> Vec<PathBuf> {
    let mut folders: Vec<PathBuf> =
        fs::read_dir(root().join("crates")).unwrap().map(|entry| entry.unwrap().path()).collect();
    folders.push(root().join("xtask"));
    folders.retain(|folder| folder.join("Cargo.toml").exists());
    folders
}

#[test]
fn imports_point_down() {
    let faults = check(&layers(), &sources(&root().join("crates/lath/src")));
    assert!(faults.is_empty(), "\n{}\n", faults.join("\n"));
}

#[test]
fn names_say_something_and_files_stay_small() {
    for folder in crates() {
        let faults = check_files(&sources(&folder));
        assert!(faults.is_empty(), "\n{}: {}\n", folder.display(), faults.join("\n"));
    }
}

#[test]
fn crates_depend_as_agreed() {
    let layers = layers();
    for folder in crates() {
        let faults = check_manifest(&layers, &fs::read_to_string(folder.join("Cargo.toml")).unwrap());
        assert!(faults.is_empty(), "\n{}\n", faults.join("\n"));
    }
}
