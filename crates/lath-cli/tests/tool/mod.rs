//! Running the tool as a stranger would, and looking at what comes out.
#![allow(dead_code, reason = "each test uses its own part")]
#![allow(clippy::unwrap_used, reason = "a test that cannot run has failed")]

use std::ffi::OsStr;
use std::io::Write;
use std::path::Path;
use std::process::{Command, Stdio};

/// What a run left behind.
#[derive(Debug)]
pub(crate) struct Run {
    pub(crate) code: Option<i32>,
    pub(crate) out: Vec<u8>,
    pub(crate) err: String,
}

/// Runs `lath` with nothing on standard input.
pub(crate) fn lath<A: AsRef<OsStr>>(args: impl IntoIterator<Item = A>) -> Run {
    lath_from("", args)
}

/// Runs `lath` with this on standard input.
pub(crate) fn lath_from<A: AsRef<OsStr>>(input: impl AsRef<[u8]>, args: impl IntoIterator<Item = A>) -> Run {
    let mut child = Command::new(env!("CARGO_BIN_EXE_lath"))
        .args(args)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let mut stdin = child.stdin.take().unwrap();
    let input = input.as_ref().to_vec();
    // Whoever fails early does not read to the end, and is right.
    let feeder = std::thread::spawn(move || drop(stdin.write_all(&input)));
    let output = child.wait_with_output().unwrap();
    feeder.join().unwrap();
    let err = String::from_utf8(output.stderr).unwrap();
    Run { code: output.status.code(), out: output.stdout, err }
}

impl Run {
    /// The standard output of a run that did what it should, silently.
    #[track_caller]
    pub(crate) fn done(self) -> String {
        assert_eq!((self.code, self.err.as_str()), (Some(0), ""), "{self:?}");
        String::from_utf8(self.out).unwrap()
    }

    /// A run that failed properly: with this exit code, these words, and nothing on standard output.
    #[track_caller]
    pub(crate) fn fails(self, code: i32, words: &[&str]) {
        assert_eq!((self.code, self.out.len()), (Some(code), 0), "{self:?}");
        assert!(!self.err.contains("panicked"), "{}", self.err);
        for word in words {
            assert!(self.err.contains(word), "no {word:?} in: {}", self.err);
        }
        if code != 2 {
            assert!(self.err.starts_with("lath: ") && self.err.contains("\nRemedy: "), "{}", self.err);
        }
    }
}

/// A file of the repository's measured points.
pub(crate) fn real(name: &str) -> String {
    repository(&format!("testdata/real/{name}"))
}

/// A file of the repository.
pub(crate) fn repository(path: &str) -> String {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(path).to_str().unwrap().to_owned()
}

/// A folder that goes away with the test.
pub(crate) struct Folder(tempfile::TempDir);

impl Folder {
    pub(crate) fn new() -> Folder {
        Folder(tempfile::tempdir().unwrap())
    }

    /// The path of a file in it, whether there or not.
    pub(crate) fn path(&self, name: &str) -> String {
        self.0.path().join(name).to_str().unwrap().to_owned()
    }

    /// A file in it with this content.
    pub(crate) fn file(&self, name: &str, content: impl AsRef<[u8]>) -> String {
        let path = self.path(name);
        std::fs::write(&path, content).unwrap();
        path
    }

    /// The names of the files in it.
    pub(crate) fn names(&self) -> Vec<String> {
        let entries = std::fs::read_dir(self.0.path()).unwrap();
        let mut names: Vec<String> = entries.map(|e| e.unwrap().file_name().into_string().unwrap()).collect();
        names.sort();
        names
    }
}

/// The header and the rows of a CSV table.
pub(crate) fn table(csv: &str) -> (Vec<String>, Vec<Vec<f64>>) {
    let mut lines = csv.lines();
    let header = lines.next().unwrap().split(',').map(str::to_owned).collect();
    let number = |field: &str| field.parse().unwrap();
    (header, lines.map(|line| line.split(',').map(number).collect()).collect())
}

/// The rows of a CSV table.
pub(crate) fn rows(csv: &str) -> Vec<Vec<f64>> {
    table(csv).1
}

/// The members of the first shape of lath JSON.
pub(crate) fn shape(json: &str) -> serde_json::Value {
    let document: serde_json::Value = serde_json::from_str(json).unwrap();
    assert_eq!(document["lath"], 1);
    document["shapes"][0].clone()
}

/// The numbers of a JSON array, nested ones row after row.
pub(crate) fn numbers(value: &serde_json::Value) -> Vec<f64> {
    match value {
        serde_json::Value::Array(items) => items.iter().flat_map(numbers).collect(),
        number => vec![number.as_f64().unwrap()],
    }
}
