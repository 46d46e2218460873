//! Every formula of the manual is what its command writes today.
//!
//! A line `<!-- lath exact … --format latex -->` in a chapter is run by the shell, and may be a pipeline; the formulas that it
//! writes between `\[` and `\]` must be the `$$` blocks that follow, one for one. A `$$` block without a command fails.
//! `LATH_RECORD=1 cargo test -p lath-cli --test formulas` writes the blocks anew, to be read again; `docs/formulas.mjs` renders them.
#![cfg(unix)]
#![allow(clippy::unwrap_used, clippy::panic)] // a failing unwrap is a failing test

mod tool;

use std::path::Path;
use std::process::Command;
use tool::repository;

/// The formulas that a command writes.
fn written(command: &str) -> Vec<String> {
    let tool = Path::new(env!("CARGO_BIN_EXE_lath")).parent().unwrap().to_owned();
    let paths = std::env::var_os("PATH").unwrap_or_default();
    let paths = std::env::join_paths([tool].into_iter().chain(std::env::split_paths(&paths))).unwrap();
    let output = Command::new("sh").args(["-c", command]).env("PATH", paths).output().unwrap();
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success() && errors.is_empty(), "{command}: {errors}");
    let text = String::from_utf8(output.stdout).unwrap();
    let formulas = text.lines().filter_map(|line| line.strip_prefix("\\[ ")?.strip_suffix(" \\]"));
    formulas.map(str::to_owned).collect()
}

/// The chapter with every formula as its command writes it now, and how many there are.
fn renewed(name: &str, chapter: &str) -> (String, usize) {
    let (mut renewed, mut count) = (String::new(), 0);
    let mut lines = chapter.lines().peekable();
    while let Some(line) = lines.next() {
        assert!(line != "$$", "{name}: a formula without a command, after\n{renewed}");
        renewed += &format!("{line}\n");
        let command = line.strip_prefix("<!-- lath exact ").and_then(|rest| rest.strip_suffix(" -->"));
        let Some(command) = command.map(|rest| format!("lath exact {rest}")) else { continue };
        let formulas = written(&command);
        assert!(!formulas.is_empty(), "{name}: {command} writes no formula");
        // What stands there now goes: the blocks, and the blank lines around them.
        while lines.next_if(|line| line.is_empty()).is_some() || lines.peek() == Some(&"$$") {
            if lines.next_if_eq(&"$$").is_some() {
                while lines.next().is_some_and(|line| line != "$$") {}
            }
        }
        for formula in &formulas {
            renewed += &format!("\n$$\n{formula}\n$$\n");
        }
        renewed += if lines.peek().is_some() { "\n" } else { "" };
        count += formulas.len();
    }
    (renewed, count)
}

#[test]
fn every_formula_of_the_manual_is_what_its_command_writes() {
    let mut count = 0;
    for entry in std::fs::read_dir(repository("docs")).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_none_or(|extension| extension != "md") {
            continue;
        }
        let (name, chapter) = (path.display().to_string(), std::fs::read_to_string(&path).unwrap());
        let (now, formulas) = renewed(&name, &chapter);
        if std::env::var_os("LATH_RECORD").is_some() {
            std::fs::write(&path, &now).unwrap();
            continue;
        }
        for (i, (now, then)) in now.lines().zip(chapter.lines()).enumerate() {
            assert_eq!(now, then, "{name}, line {}", i + 1);
        }
        assert_eq!(now, chapter, "{name}");
        count += formulas;
    }
    assert!(count >= 40 || std::env::var_os("LATH_RECORD").is_some(), "{count} formulas");
}
