//! Tests named by their file and function, `crates/lath/tests/bad_input.rs::nan`: is the test there, and does it show anything?

use crate::{read, test_source};
use std::path::Path;

/// The named test's source and its function's name; refused if the test is missing, ignored or empty.
pub(crate) fn check(root: &Path, test: &str) -> Result<(String, String), String> {
    let (file, name) = test.split_once("::").ok_or(format!("{test}: name it `file::function`"))?;
    let text = read(root, file)?;
    let name = name.rsplit("::").next().unwrap_or(name);
    let helpers = helpers(&root.join(file)).map_err(|error| format!("{file}: {error}"))?;
    match test_source::fault(&text, &helpers, name) {
        Some(fault) => Err(format!("{test}: {fault}")),
        None => Ok((text, name.to_owned())),
    }
}

/// The sources beside a test, where its helpers are: those of its crate's folder `tests`, or of its own.
fn helpers(test: &Path) -> std::io::Result<Vec<String>> {
    let tests = test.ancestors().find(|folder| folder.ends_with("tests")).or(test.parent());
    let mut texts = Vec::new();
    let mut open: Vec<_> = tests.map(Path::to_path_buf).into_iter().collect();
    while let Some(folder) = open.pop() {
        for entry in std::fs::read_dir(folder)? {
            let path = entry?.path();
            if path.is_dir() {
                open.push(path);
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                texts.push(std::fs::read_to_string(path)?);
            }
        }
    }
    Ok(texts)
}
