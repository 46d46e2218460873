//! `cargo xtask pictures`: draws every picture of the documentation anew, by the commands recorded beside it.
//!
//! A test of the tool compares; this only draws. Look at each changed picture at full size before it is committed.

use crate::{Outcome, read_toml};
use std::path::Path;
use std::process::Command;

pub(crate) fn run(root: &Path) -> Outcome {
    const LIST: &str = "testdata/figures/pictures.toml";
    let list = read_toml(root, LIST)?;
    let pictures = list.get("picture").and_then(toml::Value::as_array).ok_or(format!("{LIST}: no [[picture]]"))?;
    let mut faults = Vec::new();
    for picture in pictures {
        let file =
            picture.get("file").and_then(toml::Value::as_str).ok_or(format!("{LIST}: a picture without file"))?;
        let words = picture.get("command").and_then(toml::Value::as_array).ok_or(format!("{file}: no command"))?;
        let status = Command::new("cargo")
            .args(["run", "--quiet", "--release", "--package", "lath-cli", "--"])
            .args(words.iter().filter_map(toml::Value::as_str))
            .args(["-o", file])
            .current_dir(root)
            .status()
            .map_err(|error| format!("cargo: {error}"))?;
        if !status.success() {
            faults.push(format!("{file}: its command failed"));
        }
    }
    if faults.is_empty() { Ok(format!("{} pictures drawn", pictures.len())) } else { Err(faults.join("\n")) }
}
