//! `lath check`: findings of files, their exit codes, and what is mended.
#![allow(clippy::unwrap_used, clippy::panic)] // a failing unwrap is a failing test

mod tool;

use serde_json::Value;
use tool::{Folder, Run, lath, lath_from, repository};

const BROKEN: &str = "x,y\n0,0\n1,nan\n1,2\n1,2\n3,1\n";

/// The report of a run that found errors.
#[track_caller]
fn found(run: Run) -> String {
    assert_eq!((run.code, run.err.as_str()), (Some(1), ""), "{run:?}");
    String::from_utf8(run.out).unwrap()
}

#[test]
fn all_findings_are_listed_with_their_places() {
    let report = found(lath_from(BROKEN, ["check", "-"]));
    let expected = "standard input:3:3: error P002: \"nan\" is not a finite number\n  3 | 1,nan\n    |   ^\n  Remove";
    assert!(report.starts_with(expected), "{report}");
    assert!(report.contains("standard input:5: warning W005: "), "{report}");
    assert!(report.ends_with("standard input: 1 error, 1 warning in 4 points\n"), "{report}");
    assert!(!report.contains('\u{1b}'));
}

#[test]
fn only_errors_make_the_exit_code() {
    assert_eq!(lath_from("0,0\n1,1\n2,5\n", ["check", "-"]).done(), "standard input: nothing found in 3 points\n");
    let warned = lath_from("0,0\n1,1\n1,1\n2,0\n", ["check", "-"]).done();
    assert!(warned.contains("warning W005") && warned.ends_with("1 warning in 4 points\n"), "{warned}");
    found(lath_from("0,0\nx,1\n", ["check", "-"]));
    found(lath_from("", ["check", "-"]));
    found(lath_from(b"0,0\n1,\xff\n", ["check", "-"]));
    found(lath_from(r#"{"lath":1,"shapes":[{"kind":"circle"}]}"#, ["check", "-"]));
    found(lath_from("0,0\n", ["check", "-", "--from", "json"]));
}

#[test]
fn several_files_at_once() {
    let folder = Folder::new();
    let (good, bad) = (folder.file("good.csv", "0,0\n1,1\n"), folder.file("bad.csv", BROKEN));
    let report = found(lath(["check", &good, &bad]));
    let places = [report.find("good.csv: nothing found"), report.find("bad.csv:3:3: error"), report.find("bad.csv: 1")];
    assert!(places.iter().all(Option::is_some) && places.is_sorted(), "{report}");
    let json: Value = serde_json::from_str(&found(lath(["check", &bad, &good, &bad, "--json"]))).unwrap();
    let findings = json["findings"].as_array().unwrap();
    assert_eq!(findings.len(), 4);
    assert_eq!((&findings[0]["code"], &findings[0]["severity"]), (&Value::from("P002"), &Value::from("error")));
    for finding in findings {
        let members: Vec<&String> = finding.as_object().unwrap().keys().collect();
        assert_eq!(members, ["code", "severity", "where", "message", "remedy"]);
    }
    assert_eq!(lath(["check", &good, "--json"]).done(), "{\"findings\":[]}\n");
    lath(["check", &good, &folder.path("absent.csv")]).fails(4, &["absent.csv", "I001"]);
    lath(["check"]).fails(2, &["FILES"]);
    lath(["check", "-", "-"]).fails(2, &["only once"]);
    lath_from(BROKEN, ["check", "-", "--budget", "2"]).fails(5, &["B001"]);
}

#[test]
fn what_is_safe_is_mended() {
    let folder = Folder::new();
    let bad = folder.file("bad.csv", BROKEN);
    let report = lath(["check", &bad, "--fix"]).done();
    assert!(
        report.contains("bad.csv: mended: dropped 1 row with NaN") && report.ends_with("in 3 points\n"),
        "{report}"
    );
    assert_eq!(std::fs::read_to_string(&bad).unwrap(), "x,y\n0,0\n1,2\n3,1\n");
    lath(["through", &bad]).done();
    // Nothing to mend: the file is not touched.
    let before = std::fs::metadata(&bad).unwrap().modified().unwrap();
    assert_eq!(lath(["check", &bad, "--fix"]).done().lines().count(), 1);
    assert_eq!(std::fs::metadata(&bad).unwrap().modified().unwrap(), before);
    // What cannot be mended is left and reported.
    let words = folder.file("words.csv", "0,0\n1,nan\n2,two\n");
    let report = found(lath(["check", &words, "--fix"]));
    assert!(report.contains("words.csv: mended: ") && report.contains("words.csv:2:3: error F005"), "{report}");
    assert_eq!(std::fs::read_to_string(&words).unwrap(), "0,0\n2,two\n");
    assert_eq!(folder.names(), ["bad.csv", "words.csv"]);
    lath_from(BROKEN, ["check", "-", "--fix"]).fails(2, &["--fix", "standard input"]);
}

#[test]
fn changes_are_told_beside_json() {
    let folder = Folder::new();
    let bad = folder.file("bad.csv", BROKEN);
    let run = lath(["check", &bad, "--fix", "--json"]);
    assert_eq!((run.code, run.out.as_slice()), (Some(0), &b"{\"findings\":[]}\n"[..]));
    assert!(run.err.lines().count() == 2 && run.err.contains("mended"), "{}", run.err);
    let bad = folder.file("bad.csv", BROKEN);
    lath(["check", &bad, "--fix", "--json", "--quiet"]).done();
}

#[test]
fn one_file_that_cannot_be_read_leaves_the_others() {
    let folder = Folder::new();
    let bad = folder.file("bad.csv", BROKEN);
    lath(["check", &bad, &folder.path("absent.csv"), "--fix"]).fails(4, &["absent.csv", "I001"]);
    assert_eq!(std::fs::read_to_string(&bad).unwrap(), BROKEN);
    let mut permissions = std::fs::metadata(&bad).unwrap().permissions();
    permissions.set_readonly(true);
    std::fs::set_permissions(&bad, permissions).unwrap();
    lath(["check", &bad, "--fix"]).fails(4, &["bad.csv", "I002"]);
    assert_eq!(std::fs::read_to_string(&bad).unwrap(), BROKEN);
}

#[test]
fn the_mended_file_of_the_manual_is_what_fix_makes() {
    let folder = Folder::new();
    let wing = folder.file("wing.csv", std::fs::read(repository("testdata/figures/wing.csv")).unwrap());
    lath(["check", &wing, "--fix"]).done();
    let recorded = std::fs::read_to_string(repository("testdata/figures/mended.csv")).unwrap();
    assert_eq!(std::fs::read_to_string(wing).unwrap(), recorded);
}
