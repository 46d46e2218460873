//! Every command in a `console` block of the manual gives what stands below it.
//!
//! A line `$ command` is run by the shell in a folder that has the repository's `testdata/figures` and nothing else; what the
//! command prints on standard output and standard error must be the lines up to the next `$`, and a line `(exit N)` its exit code.
//! The lines of one file share the folder.
#![cfg(unix)]
#![allow(clippy::unwrap_used, clippy::panic)] // a failing unwrap is a failing test

mod tool;

use std::path::Path;
use std::process::Command;
use tool::{Folder, repository};

/// The commands of a chapter with what they print.
fn transcripts(chapter: &str) -> Vec<(String, String)> {
    let mut found: Vec<(String, String)> = Vec::new();
    let mut inside = false;
    for line in chapter.lines() {
        match (line, inside) {
            ("```console", _) => inside = true,
            ("```", _) => inside = false,
            (line, true) => match (line.strip_prefix("$ "), found.last_mut()) {
                (Some(command), _) => found.push((command.to_owned(), String::new())),
                (None, Some((_, output))) => *output += &format!("{line}\n"),
                (None, None) => panic!("output before the first command: {line}"),
            },
            _ => {}
        }
    }
    found
}

/// The names of the chapters.
fn chapters() -> Vec<String> {
    let entries = std::fs::read_dir(repository("docs")).unwrap();
    let mut names: Vec<String> = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.retain(|name| name.ends_with(".md"));
    names.sort();
    names
}

#[test]
fn every_command_of_the_manual_gives_what_stands_below_it() {
    let tool = Path::new(env!("CARGO_BIN_EXE_lath")).parent().unwrap().to_owned();
    let paths = std::env::var_os("PATH").unwrap_or_default();
    let paths = std::env::join_paths([tool].into_iter().chain(std::env::split_paths(&paths))).unwrap();
    let mut commands = 0;
    for name in chapters() {
        let folder = Folder::new();
        std::fs::create_dir_all(folder.path("testdata/figures")).unwrap();
        for entry in std::fs::read_dir(repository("testdata/figures")).unwrap() {
            let entry = entry.unwrap();
            let target = format!("testdata/figures/{}", entry.file_name().to_str().unwrap());
            std::fs::copy(entry.path(), folder.path(&target)).unwrap();
        }
        let chapter = std::fs::read_to_string(repository(&format!("docs/{name}"))).unwrap();
        for (command, expected) in transcripts(&chapter) {
            // Both streams into one, as a terminal shows them.
            let mut shell = Command::new("sh");
            shell.args(["-c", &format!("( {command} ) 2>&1")]).current_dir(folder.path("")).env("PATH", &paths);
            let output = shell.env("COLUMNS", "100").output().unwrap();
            let mut printed = String::from_utf8(output.stdout).unwrap();
            match output.status.code() {
                Some(0) => {}
                code => printed += &format!("(exit {})\n", code.unwrap()),
            }
            assert_eq!(printed, expected, "docs/{name}: $ {command}");
            commands += 1;
        }
    }
    assert!(commands > 0);
}
