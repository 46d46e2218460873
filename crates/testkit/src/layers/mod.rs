//! Reads the imports: do the floors of the core point down?
//!
//! `layers.toml` lists the floors bottom-up and the edges between the crates. [`check`] holds the sources against it and
//! answers with one sentence per fault, such as
//!
//! ```text
//! knot/span.rs:12: floor 3 (knot) imports floor 5 (curve): move the method up
//! ```
//!
//! It reads every path that starts with `crate::` or `super::`, in `use` trees and inline, also in unit tests. Because
//! the house imports from the defining module and never through the crate root, no re-export has to be resolved: the
//! first segment *is* the floor. What needs no import (an inherent method) is caught by `cargo xtask floors` instead.
//!
//! Beside the direction it refuses rooms that `layers.toml` does not know, declarations in `lib.rs` out of order or
//! without their floor's number, file names that say nothing, and files grown past [`LONGEST`] lines of code.

mod source;

use source::{Token, code_lines, paths, tokens};
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

/// No file has more lines of code than this; comments, blank lines and trailing unit tests do not count.
pub const LONGEST: usize = 700;

/// File names that name no idea.
const EMPTY_NAMES: [&str; 8] = ["utils", "util", "common", "helpers", "helper", "misc", "shared", "stuff"];

/// `layers.toml`.
#[derive(Debug)]
pub struct Layers {
    /// The floors, bottom-up.
    pub floors: Vec<Floor>,
    /// The crates of the workspace by name.
    pub crates: BTreeMap<String, Edges>,
}

/// One floor of the core.
#[derive(Debug)]
pub struct Floor {
    /// The module's name.
    pub room: String,
    /// The room is reserved, and has no module yet.
    pub planned: bool,
}

/// What a crate may depend on.
#[derive(Debug, Default)]
pub struct Edges {
    /// Crates of the workspace, at build time.
    pub imports: Vec<String>,
    /// Further crates of the workspace, for its tests only.
    pub tests: Vec<String>,
    /// Crates from outside, where that list is closed.
    pub outside: Option<Vec<String>>,
}

impl Layers {
    /// Reads the text of `layers.toml`.
    ///
    /// # Panics
    /// On anything else.
    pub fn parse(text: &str) -> Layers {
        let table: toml::Table = text.parse().expect("layers.toml is TOML");
        let floors = table["floor"].as_array().expect("[[floor]]");
        let floors = floors.iter().map(|floor| Floor {
            room: floor["room"].as_str().expect("room").to_owned(),
            planned: floor.get("planned").and_then(toml::Value::as_bool).unwrap_or(false),
        });
        let list = |edges: &toml::Value, key: &str| -> Option<Vec<String>> {
            let items = edges.get(key)?.as_array().expect("a list of crates");
            Some(items.iter().map(|name| name.as_str().expect("a crate's name").to_owned()).collect())
        };
        let crates = table["crates"].as_table().expect("[crates.…]").iter().map(|(name, edges)| {
            let edges = Edges {
                imports: list(edges, "imports").unwrap_or_default(),
                tests: list(edges, "tests").unwrap_or_default(),
                outside: list(edges, "outside"),
            };
            (name.clone(), edges)
        });
        Layers { floors: floors.collect(), crates: crates.collect() }
    }

    fn floor(&self, room: &str) -> Option<usize> {
        self.floors.iter().position(|floor| floor.room == room)
    }
}

/// Checks the sources of the core, given as (path below `src`, text). One sentence per fault, none if all is well.
pub fn check(layers: &Layers, sources: &[(String, String)]) -> Vec<String> {
    let mut faults = Vec::new();
    for (path, text) in sources {
        if path == "lib.rs" {
            check_contents(layers, text, &mut faults);
            continue;
        }
        let mut module: Vec<&str> = path.trim_end_matches(".rs").split('/').collect();
        if module.last() == Some(&"mod") {
            module.pop();
        }
        let Some(here) = layers.floor(module[0]) else {
            faults.push(format!("{path}: no floor of layers.toml is called `{}`: give the room a floor", module[0]));
            continue;
        };
        if module.len() == 1 && !text.starts_with(&format!("//! F{here} ")) {
            faults.push(format!("{path}:1: floor {here} ({}) opens with its essay, `//! F{here} — …`", module[0]));
        }
        for import in paths(&tokens(text), &module) {
            let line = import.line;
            let target = import.path.first().map_or("", String::as_str);
            match layers.floor(target) {
                Some(there) if there > here => faults.push(format!(
                    "{path}:{line}: floor {here} ({}) imports floor {there} ({target}): move the method up",
                    module[0]
                )),
                Some(_) => {}
                None => faults.push(format!(
                    "{path}:{line}: imports `{target}` from the crate root: name the module that defines it"
                )),
            }
        }
    }
    faults
}

/// `lib.rs`: every floor that exists, in order, each with its number in a comment.
fn check_contents(layers: &Layers, text: &str, faults: &mut Vec<String>) {
    let mut next = 0;
    let mut declared = Vec::new();
    let tokens = tokens(text);
    for (i, token) in tokens.iter().enumerate() {
        let (Token::Word(word), Some((Token::Word(room), line))) = (&token.0, tokens.get(i + 1)) else {
            continue;
        };
        if word != "mod" {
            continue;
        }
        let Some(floor) = layers.floor(room) else {
            faults.push(format!("lib.rs:{line}: no floor of layers.toml is called `{room}`: give the room a floor"));
            continue;
        };
        if floor < next {
            faults.push(format!("lib.rs:{line}: floor {floor} ({room}) is declared too late: the order is bottom-up"));
        }
        if layers.floors[floor].planned {
            faults.push(format!("layers.toml: floor {floor} ({room}) exists now: remove `planned`"));
        }
        let comment =
            text.lines().nth(line - 1).and_then(|line| line.split_once("//")).map_or("", |(_, note)| note.trim());
        if !comment.starts_with(&format!("F{floor}: ")) {
            faults.push(format!("lib.rs:{line}: the line of `{room}` ends in `// F{floor}: …`, what the floor is for"));
        }
        next = next.max(floor + 1);
        declared.push(floor);
    }
    for (floor, Floor { room, planned }) in layers.floors.iter().enumerate() {
        if !planned && !declared.contains(&floor) {
            faults.push(format!(
                "lib.rs: floor {floor} ({room}) is not declared, and layers.toml does not call it planned"
            ));
        }
    }
}

/// Checks the names and the lengths of source files of any crate.
pub fn check_files(sources: &[(String, String)]) -> Vec<String> {
    let mut faults = Vec::new();
    for (path, text) in sources {
        if let Some(name) = path.trim_end_matches(".rs").split('/').find(|name| EMPTY_NAMES.contains(name)) {
            faults.push(format!("{path}: `{name}` says nothing; name the idea"));
        }
        let lines = code_lines(text);
        if lines > LONGEST {
            faults.push(format!("{path}: {lines} lines of code, above {LONGEST}: two ideas, two files"));
        }
    }
    faults
}

/// Checks a crate's manifest against its edges.
pub fn check_manifest(layers: &Layers, manifest: &str) -> Vec<String> {
    let table: toml::Table = manifest.parse().expect("Cargo.toml is TOML");
    let name = table["package"]["name"].as_str().expect("a crate has a name");
    let Some(edges) = layers.crates.get(name) else {
        return vec![format!("layers.toml: crate {name} is missing from [crates]")];
    };
    let mut faults = Vec::new();
    let sections = ["dependencies", "build-dependencies", "dev-dependencies"];
    for section in sections {
        let Some(dependencies) = table.get(section).and_then(toml::Value::as_table) else {
            continue;
        };
        let tests = section == "dev-dependencies";
        for dependency in dependencies.keys() {
            if layers.crates.contains_key(dependency) {
                if !(edges.imports.contains(dependency) || tests && edges.tests.contains(dependency)) {
                    faults.push(format!("{name}: depends on {dependency}, an edge that layers.toml does not have"));
                }
            } else if !tests && edges.outside.as_ref().is_some_and(|list| !list.contains(dependency)) {
                faults.push(format!("{name}: depends on {dependency}, which is not on its list in layers.toml"));
            }
        }
    }
    faults
}

/// Every `.rs` file below a folder as (path below it, text), in the order of their names.
pub fn sources(folder: &Path) -> Vec<(String, String)> {
    let mut found = Vec::new();
    let mut open = vec![folder.to_path_buf()];
    while let Some(folder_here) = open.pop() {
        for entry in fs::read_dir(&folder_here).expect("a readable folder") {
            let path = entry.expect("a readable entry").path();
            if path.is_dir() {
                open.push(path);
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                let below = path.strip_prefix(folder).expect("found below the folder");
                let name = below.to_str().expect("a name in UTF-8").replace('\\', "/");
                found.push((name, fs::read_to_string(&path).expect("a source file in UTF-8")));
            }
        }
    }
    found.sort();
    found
}

#[cfg(test)]
mod tests;
