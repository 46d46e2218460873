//! `cargo xtask floors`: each floor of the core stands without those above it.
//!
//! The test that reads imports cannot see a method call, and an inherent method written on a high floor needs no import
//! to be called from a low one. So the crate is copied once per floor, `lib.rs` is cut off after that floor's
//! declaration, and the compiler decides. Re-exports follow the declarations in `lib.rs`, so they fall away.

use crate::{Outcome, read, read_toml};
use std::fs;
use std::path::Path;
use std::process::Command;

const CORE: &str = "crates/lath";

pub(crate) fn run(root: &Path) -> Outcome {
    let contents = read(root, &format!("{CORE}/src/lib.rs"))?;
    let manifest = manifest(root)?;
    let lock = read(root, "Cargo.lock")?;
    let floors = cuts(&contents);
    if floors.is_empty() {
        return Err(format!("{CORE}/src/lib.rs declares no floor"));
    }
    let target = root.join("target/floors");
    let mut faults = Vec::new();
    for (room, text) in &floors {
        let folder = target.join(room);
        prepare(root, &folder, &manifest, &lock, text).map_err(|error| format!("target/floors/{room}: {error}"))?;
        let output = Command::new("cargo")
            .args(["check", "--quiet", "--offline", "--lib"])
            .current_dir(&folder)
            .env("CARGO_TARGET_DIR", target.join("target"))
            .env("RUSTFLAGS", "--cap-lints=allow") // what only higher floors use is not dead
            .output()
            .map_err(|error| format!("cargo check: {error}"))?;
        if !output.status.success() {
            let reason = String::from_utf8_lossy(&output.stderr);
            faults.push(format!("{room}: does not compile without the floors above it\n{reason}"));
        }
    }
    if faults.is_empty() {
        let rooms: Vec<&str> = floors.iter().map(|(room, _)| room.as_str()).collect();
        Ok(format!("floors: each compiles without those above it: {}", rooms.join(", ")))
    } else {
        Err(faults.join("\n"))
    }
}

/// For every module that `lib.rs` declares: its name, and `lib.rs` up to and including that line.
fn cuts(contents: &str) -> Vec<(String, String)> {
    let mut cuts = Vec::new();
    let mut end = 0;
    for line in contents.split_inclusive('\n') {
        end += line.len();
        let declaration = line.trim_start_matches("pub(crate) ").trim_start_matches("pub ");
        if let Some((room, _)) = declaration.strip_prefix("mod ").and_then(|rest| rest.split_once(';')) {
            cuts.push((room.to_owned(), contents[..end].to_owned()));
        }
    }
    cuts
}

/// The core's manifest as that of a package on its own: workspace inheritance resolved, tests left out.
fn manifest(root: &Path) -> Result<String, String> {
    let core = read_toml(root, &format!("{CORE}/Cargo.toml"))?;
    let workspace = read_toml(root, "Cargo.toml")?;
    let shared = |section: &str, key: &str| workspace.get("workspace")?.get(section)?.get(key).cloned();
    let mut package = toml::Table::new();
    package.insert("name".into(), "lath".into());
    for key in ["version", "edition"] {
        package.insert(key.into(), shared("package", key).ok_or(format!("Cargo.toml: no workspace.package.{key}"))?);
    }
    let mut dependencies = toml::Table::new();
    for (name, given) in core.get("dependencies").and_then(toml::Value::as_table).into_iter().flatten() {
        let inherits = given.get("workspace").is_some();
        let resolved = if inherits { shared("dependencies", name) } else { Some(given.clone()) };
        let resolved = resolved.ok_or(format!("Cargo.toml: no workspace.dependencies.{name}"))?;
        dependencies.insert(name.clone(), resolved);
    }
    let mut alone = toml::Table::new();
    alone.insert("package".into(), package.into());
    alone.insert("dependencies".into(), dependencies.into());
    if let Some(features) = core.get("features") {
        alone.insert("features".into(), features.clone());
    }
    alone.insert("workspace".into(), toml::Table::new().into());
    toml::to_string(&alone).map_err(|error| error.to_string())
}

fn prepare(root: &Path, folder: &Path, manifest: &str, lock: &str, contents: &str) -> std::io::Result<()> {
    if folder.exists() {
        fs::remove_dir_all(folder)?;
    }
    copy(&root.join(CORE).join("src"), &folder.join("src"))?;
    fs::write(folder.join("src/lib.rs"), contents)?;
    fs::write(folder.join("Cargo.toml"), manifest)?;
    fs::write(folder.join("Cargo.lock"), lock) // the same versions; cargo drops what is not used
}

fn copy(from: &Path, to: &Path) -> std::io::Result<()> {
    fs::create_dir_all(to)?;
    for entry in fs::read_dir(from)? {
        let entry = entry?;
        let target = to.join(entry.file_name());
        if entry.file_type()?.is_dir() {
            copy(&entry.path(), &target)?;
        } else {
            fs::copy(entry.path(), target)?;
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_contents_are_cut_after_each_declaration() {
        let text = "//! Words, mod words;\nextern crate alloc;\npub mod error; // F0: faults\n// pub mod later;\nmod num;\npub use num::Sum;\n";
        let found = cuts(text);
        assert_eq!(found.iter().map(|(room, _)| room.as_str()).collect::<Vec<_>>(), ["error", "num"]);
        assert!(found[0].1.ends_with("pub mod error; // F0: faults\n"));
        assert!(found[1].1.ends_with("mod num;\n"));
    }
}
