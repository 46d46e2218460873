//! `cargo xtask licences`: the dependencies, their licences and their number.
//!
//! Reads what cargo knows offline, for all platforms, and the lock file. The lists are in `xtask/licences.toml`.

use crate::{Outcome, read_toml, spdx};
use serde_json::Value;
use std::collections::BTreeMap;
use std::path::Path;
use std::process::Command;

const LISTS: &str = "xtask/licences.toml";

pub(crate) fn run(root: &Path) -> Outcome {
    let lists = read_toml(root, LISTS)?;
    let allowed = lists.get("allowed").and_then(toml::Value::as_array).map(Vec::as_slice).unwrap_or_default();
    let allowed: Vec<String> = allowed.iter().filter_map(toml::Value::as_str).map(String::from).collect();
    let reasons: BTreeMap<String, String> = lists
        .get("duplicates")
        .and_then(toml::Value::as_table)
        .map(|table| {
            table.iter().map(|(name, reason)| (name.clone(), reason.as_str().unwrap_or("").to_owned())).collect()
        })
        .unwrap_or_default();

    let packages = packages(root)?;
    let mut faults = unlicensed(&packages, &allowed);
    let locked = read_toml(root, "Cargo.lock")?;
    faults.extend(duplicates(&locked, &reasons));
    if faults.is_empty() {
        Ok(format!("licences: {} packages, all allowed; no duplicate without a reason", packages.len()))
    } else {
        Err(faults.join("\n"))
    }
}

/// Name, version and licence expression of every package, as cargo lists them.
fn packages(root: &Path) -> Result<Vec<(String, String, Option<String>)>, String> {
    let output = Command::new("cargo")
        .args(["metadata", "--offline", "--locked", "--format-version", "1"])
        .current_dir(root)
        .output()
        .map_err(|error| format!("cargo metadata: {error}"))?;
    if !output.status.success() {
        let reason = String::from_utf8_lossy(&output.stderr);
        return Err(format!("cargo metadata cannot answer offline; run `cargo fetch` once.\n{reason}"));
    }
    let metadata: Value = serde_json::from_slice(&output.stdout).map_err(|error| format!("cargo metadata: {error}"))?;
    let listed = metadata["packages"].as_array().ok_or("cargo metadata lists no packages")?;
    let text = |package: &Value, key: &str| package[key].as_str().map(String::from);
    Ok(listed
        .iter()
        .map(|package| {
            let name = text(package, "name").unwrap_or_default();
            (name, text(package, "version").unwrap_or_default(), text(package, "license"))
        })
        .collect())
}

fn unlicensed(packages: &[(String, String, Option<String>)], allowed: &[String]) -> Vec<String> {
    let mut faults = Vec::new();
    for (name, version, licence) in packages {
        let Some(licence) = licence else {
            faults.push(format!("{name} {version}: states no licence"));
            continue;
        };
        match spdx::satisfied(licence, allowed) {
            Ok(true) => {}
            Ok(false) => faults.push(format!("{name} {version}: `{licence}` is not allowed by {LISTS}")),
            Err(reason) => faults.push(format!("{name} {version}: {reason}")),
        }
    }
    faults
}

fn duplicates(lock: &toml::Table, reasons: &BTreeMap<String, String>) -> Vec<String> {
    let mut versions: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
    for package in lock.get("package").and_then(toml::Value::as_array).into_iter().flatten() {
        let text = |key: &str| package.get(key).and_then(toml::Value::as_str).unwrap_or("");
        versions.entry(text("name")).or_default().push(text("version"));
    }
    versions.retain(|_, found| found.len() > 1);
    let mut faults = Vec::new();
    for (name, found) in &versions {
        if reasons.get(*name).is_none_or(|reason| reason.trim().is_empty()) {
            faults.push(format!(
                "{name}: versions {} are all in Cargo.lock; agree on one (`cargo tree -i {name}`), or give the reason in {LISTS}",
                found.join(" and ")
            ));
        }
    }
    for name in reasons.keys().filter(|name| !versions.contains_key(name.as_str())) {
        faults.push(format!("{LISTS}: {name} comes in one version now; take its line out"));
    }
    faults
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_licence_outside_the_list_is_refused() {
        let package = |licence: Option<&str>| [("x".to_owned(), "1.0.0".to_owned(), licence.map(String::from))];
        let allowed = ["MIT".to_owned()];
        assert!(unlicensed(&package(Some("MIT OR GPL-3.0-only")), &allowed).is_empty());
        assert_eq!(unlicensed(&package(Some("GPL-3.0-only")), &allowed).len(), 1);
        assert_eq!(unlicensed(&package(None), &allowed), ["x 1.0.0: states no licence"]);
    }

    #[test]
    fn duplicates_need_a_reason_and_reasons_a_duplicate() {
        let lock = |versions: &[&str]| {
            let packages: Vec<String> =
                versions.iter().map(|v| format!("[[package]]\nname = \"x\"\nversion = \"{v}\"\n")).collect();
            packages.concat().parse::<toml::Table>().unwrap()
        };
        let reasons = BTreeMap::from([("x".to_owned(), "forced by y".to_owned())]);
        let blank = BTreeMap::from([("x".to_owned(), " ".to_owned())]);
        assert_eq!(duplicates(&lock(&["1.0.0"]), &BTreeMap::new()), [""; 0]);
        assert_eq!(duplicates(&lock(&["1.0.0", "2.0.0"]), &reasons), [""; 0]);
        assert!(duplicates(&lock(&["1.0.0", "2.0.0"]), &BTreeMap::new())[0].contains("1.0.0 and 2.0.0"));
        assert_eq!(duplicates(&lock(&["1.0.0", "2.0.0"]), &blank).len(), 1);
        assert!(duplicates(&lock(&["1.0.0"]), &reasons)[0].contains("take its line out"));
    }
}
