//! What every verb promises: exit codes, streams, files whole or not at all.
#![allow(clippy::unwrap_used, clippy::panic)] // a failing unwrap is a failing test

mod tool;

use std::io::Read;
use std::process::{Command, Stdio};
use tool::{Folder, lath, lath_from, real};

const ARCH: &str = "0,0\n1,2\n3,2\n4,0\n";

#[test]
fn help_and_version_succeed_on_standard_output() {
    let help = lath(["--help"]).done();
    for word in ["through", "curve", "eval", "subdivide", "draw", "info", "Exit codes", "130"] {
        assert!(help.contains(word), "{word}");
    }
    assert!(lath(["--version"]).done().starts_with(concat!("lath ", env!("CARGO_PKG_VERSION"), "\n")));
    for verb in ["through", "curve", "eval", "subdivide", "convert", "draw", "info", "check", "exact"] {
        let help = lath([verb, "--help"]).done();
        assert!(help.contains("Examples:\n  lath ") && help.contains(&format!("Usage: lath {verb}")), "{help}");
        assert!(lath([verb, "-h"]).done().contains("Examples:"));
    }
    let ends = lath(["through", "--help"]).done().split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(ends.contains("no other tool offers"));
}

#[test]
fn a_wrong_command_line_is_exit_2() {
    lath::<&str>([]).fails(2, &["Usage: lath"]);
    lath(["thruogh", "x"]).fails(2, &["thruogh", "'through'"]);
    lath(["eval", "x", "--cuont", "3"]).fails(2, &["--cuont", "'--count'"]);
    lath(["through"]).fails(2, &["POINTS"]);
    lath(["through", "x", "y"]).fails(2, &["y"]);
    lath(["info", "x", "--from", "xls"]).fails(2, &["xls", "csv"]);
    lath(["info", "x", "--budget", "-1"]).fails(2, &["--budget"]);
    // Files are not even looked at.
    lath(["eval", "absent.json", "--count", "0"]).fails(2, &["--count"]);
    lath(["curve", "absent.csv", "--kind", "bezier", "--degree", "3"]).fails(2, &["Usage: lath curve"]);
}

#[test]
fn files_that_cannot_be_used_are_exit_4() {
    let folder = Folder::new();
    let absent = folder.path("absent.csv");
    for verb in ["through", "info"] {
        lath([verb, &absent]).fails(4, &["absent.csv", "I001"]);
    }
    lath(["info", &folder.path("")]).fails(4, &["I003", "folder"]);
    lath_from(ARCH, ["through", "-", "-o", &folder.path("no/such/curve.json")]).fails(4, &["curve.json", "I001"]);
    std::fs::create_dir(folder.path("taken.json")).unwrap();
    lath_from(ARCH, ["through", "-", "-o", &folder.path("taken.json")]).fails(4, &["I003"]);
    assert_eq!(folder.names(), ["taken.json"]);
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_device_is_exit_4() {
    for args in [&["through", "-"][..], &["info", "-"], &["draw", "-", "-o", "-"], &["--help"]] {
        let full = std::fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
        let mut child = Command::new(env!("CARGO_BIN_EXE_lath"))
            .args(args)
            .stdin(Stdio::piped())
            .stdout(full)
            .stderr(Stdio::null())
            .spawn()
            .unwrap();
        std::io::Write::write_all(&mut child.stdin.take().unwrap(), ARCH.as_bytes()).ok();
        assert_eq!(child.wait().unwrap().code(), Some(4), "{args:?}");
    }
}

#[test]
fn a_budget_that_is_exceeded_is_exit_5() {
    let curve = lath_from(ARCH, ["through", "-", "--budget", "4"]).done();
    lath_from(ARCH, ["through", "-", "--budget", "3"]).fails(5, &["B001", "budget of 3", "standard input"]);
    lath_from(&curve, ["eval", "-", "--count", "11", "--budget", "10"]).fails(5, &["B001", "11 points"]);
    lath_from(&curve, ["eval", "-", "--count", "18446744073709551615"]).fails(5, &["B001"]);
    lath_from(&curve, ["eval", "-", "--at", "0", "--derivatives", "18446744073709551615"]).fails(5, &["B001", "bytes"]);
    lath_from(&curve, ["--budget", "1e1", "eval", "-", "--count", "10"]).done();
}

#[test]
fn a_reader_that_goes_away_is_no_failure() {
    let folder = Folder::new();
    let curve = folder.path("curve.json");
    lath_from(ARCH, ["through", "-", "-o", &curve]).done();
    for args in [&["eval", &curve, "--count", "1000000"][..], &["eval", &curve, "--count", "1000000", "--json"]] {
        let mut child = Command::new(env!("CARGO_BIN_EXE_lath"))
            .args(args)
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        let mut head = [0; 16];
        child.stdout.take().unwrap().read_exact(&mut head).unwrap();
        let output = child.wait_with_output().unwrap();
        assert_eq!((output.status.code(), output.stderr.len()), (Some(0), 0), "{args:?}");
    }
}

#[test]
fn a_failure_leaves_the_old_file() {
    let folder = Folder::new();
    let path = folder.file("curve.json", "precious");
    lath_from("0,0\n0,0\n", ["through", "-", "-o", &path]).fails(3, &["P004"]);
    lath_from("0,0\nx,0\n", ["through", "-", "-o", &path]).fails(3, &["F005"]);
    assert_eq!(std::fs::read_to_string(&path).unwrap(), "precious");
    lath_from(ARCH, ["through", "-", "-o", &path]).done();
    assert!(std::fs::read_to_string(&path).unwrap().starts_with("{\"lath\": 1"));
    assert_eq!(folder.names(), ["curve.json"]);
}

#[cfg(unix)]
#[test]
fn an_interruption_is_exit_130_and_leaves_the_old_file() {
    let folder = Folder::new();
    let curve = folder.path("curve.json");
    lath_from(ARCH, ["through", "-", "-o", &curve]).done();
    let table = folder.file("table.csv", "precious");
    let mut child = Command::new(env!("CARGO_BIN_EXE_lath"))
        .args(["eval", &curve, "--count", "3e6", "--derivatives", "2", "-o", &table])
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    // It has begun to write as soon as there is a third file.
    while folder.names().len() < 3 {
        assert!(child.try_wait().unwrap().is_none(), "it has ended already");
        std::thread::sleep(std::time::Duration::from_millis(2));
    }
    let kill = format!("kill -INT {}", child.id());
    assert!(Command::new("sh").args(["-c", &kill]).status().unwrap().success());
    let output = child.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(130));
    let err = String::from_utf8(output.stderr).unwrap();
    assert!(err.contains("table.csv: B002: interrupted"), "{err}");
    assert_eq!(folder.names(), ["curve.json", "table.csv"]);
    assert_eq!(std::fs::read_to_string(&table).unwrap(), "precious");
}

#[test]
fn dash_is_standard_input_and_output() {
    let points = std::fs::read_to_string(real("rae2822.dat")).unwrap();
    let piped = lath_from(&points, ["through", "-"]).done();
    assert_eq!(piped, lath(["through", &real("rae2822.dat")]).done());
    assert_eq!(piped, lath_from(&points, ["through", "-", "-o", "-"]).done());
    let five = lath_from(&piped, ["eval", "-", "--count", "5"]).done();
    assert_eq!(five.lines().count(), 6);
}

#[test]
fn the_format_is_sniffed_or_said() {
    let folder = Folder::new();
    let json = folder.file("points.dat", "[[0,0],\n[1,1],\n[2,0]]");
    lath(["through", &json]).fails(3, &["points.dat:2:1", "F005"]);
    let sniffed = lath_from("[[0,0],[1,1],[2,0]]", ["through", "-"]).done();
    assert_eq!(lath(["through", &json, "--from", "json"]).done(), sniffed);
    assert_eq!(lath(["through", &folder.file("points.unknown", "[[0,0],[1,1],[2,0]]")]).done(), sniffed);
    lath_from("<svg/>", ["info", "-"]).fails(3, &["F004", "SVG"]);
}

#[test]
fn errors_show_the_line_and_a_caret() {
    let run = lath_from("x,y\n0,0\n1,zero\n", ["through", "-"]);
    let expected = "lath: standard input:3:3: F005: \"zero\" is not a number\n  3 | 1,zero\n    |   ^\nRemedy: ";
    assert!(run.err.starts_with(expected), "{}", run.err);
    assert!(!run.err.contains('\u{1b}'));
    run.fails(3, &[]);
    let tabs = lath_from("0\t0\n1\tzero\n", ["through", "-"]);
    assert!(tabs.err.contains("  2 | 1\tzero\n    |  \t^\n"), "{}", tabs.err);
}
