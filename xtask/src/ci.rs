//! `cargo xtask ci`: every check that is not a test, each run to its end, so that one run tells everything.

use crate::{Outcome, bad_inputs, claims, floors, licences};
use std::path::Path;
use std::process::Command;

pub(crate) fn run(root: &Path) -> Outcome {
    let cargo = |arguments: &str, variables: &[(&str, &str)]| -> Outcome {
        let status = Command::new("cargo")
            .args(arguments.split(' '))
            .envs(variables.iter().copied())
            .current_dir(root)
            .status()
            .map_err(|error| format!("cargo {arguments}: {error}"))?;
        if status.success() { Ok(String::new()) } else { Err(format!("cargo {arguments}: failed")) }
    };
    let checks: [(&str, &dyn Fn() -> Outcome); 9] = [
        ("formatting", &|| cargo("fmt --all --check", &[])),
        ("lints", &|| cargo("clippy --workspace --all-targets --locked -- -D warnings", &[])),
        ("documentation", &|| cargo("doc --workspace --no-deps --locked", &[("RUSTDOCFLAGS", "-D warnings")])),
        ("imports", &|| cargo("test --quiet --package lath --test layers --locked", &[])),
        ("features", &|| cargo("test --quiet --package lath --lib --all-features --locked", &[])),
        ("floors", &|| floors::run(root)),
        ("licences", &|| licences::run(root)),
        ("claims", &|| claims::run(root)),
        ("bad inputs", &|| bad_inputs::run(root)),
    ];
    let mut failed = Vec::new();
    for (name, check) in checks {
        println!("── {name}");
        match check() {
            Ok(summary) if summary.is_empty() => {}
            Ok(summary) => println!("{summary}"),
            Err(faults) => {
                eprintln!("{faults}");
                failed.push(name);
            }
        }
    }
    if failed.is_empty() {
        Ok(format!("ci: {} checks passed", checks.len()))
    } else {
        Err(format!("ci: failed: {}", failed.join(", ")))
    }
}
