//! `lath convert`: points from one format to another, and what is constant about it.
#![allow(clippy::unwrap_used, clippy::panic)] // a failing unwrap is a failing test

mod tool;

use tool::{Folder, lath, lath_from, real};

const NAMED: &str = "t,\"x 1\"\n0.1,-0\n1e300,5e-324\n";

#[test]
fn every_format_becomes_every_other() {
    let folder = Folder::new();
    let formats = ["csv", "tsv", "txt", "json", "npy"];
    let first = folder.file("first.csv", NAMED);
    for from in formats {
        let a = folder.path(&format!("a.{from}"));
        assert_eq!(lath(["convert", &first, &a]).done(), "");
        for to in formats {
            let b = folder.path(&format!("b.{to}"));
            assert_eq!(lath(["convert", &a, &b]).done(), "");
            let back = lath(["convert", &b, "-"]).done();
            // .npy has no place for names.
            let expected = if [from, to].contains(&"npy") { "0.1,-0\n1e300,5e-324\n" } else { NAMED };
            assert_eq!(back, expected, "{from} to {to}");
        }
    }
    let json = "{\"columns\":[\"t\",\"x 1\"],\"rows\":[\n[0.1,-0],\n[1e300,5e-324]\n]}\n";
    assert_eq!(lath_from(NAMED, ["convert", "-", "-", "--json"]).done(), json);
}

#[test]
fn columns_are_chosen_as_elsewhere() {
    let log = "date,x,y\n2020-01-01,0,1.5\n2020-01-02,1,2.5\n";
    assert_eq!(lath_from(log, ["convert", "-", "-", "--columns", "y,x"]).done(), "y,x\n1.5,0\n2.5,1\n");
    assert_eq!(lath_from(log, ["convert", "-", "-", "--columns", "2"]).done(), "y\n1.5\n2.5\n");
    lath_from(log, ["convert", "-", "-", "--columns", "z"]).fails(3, &["F009", "\"z\""]);
    lath_from(log, ["convert", "-", "-"]).fails(3, &["standard input:2:1", "F005"]);
    let airfoil = lath(["convert", &real("rae2822.dat"), "-", "--format", "tsv"]).done();
    assert_eq!(airfoil.lines().next(), Some("1\t0"));
}

#[test]
fn nothing_is_written_when_the_last_row_is_wrong() {
    let rows = "1,2\n".repeat(100_000) + "3\n";
    lath_from(&rows, ["convert", "-", "-"]).fails(3, &["standard input:100001", "P005"]);
    let folder = Folder::new();
    let old = folder.file("old.csv", "precious");
    lath_from(&rows, ["convert", "-", &old]).fails(3, &["standard input:100001", "P005"]);
    lath_from(&rows, ["convert", "-", &folder.path("new.npy")]).fails(3, &["standard input:100001", "P005"]);
    assert_eq!((std::fs::read_to_string(&old).unwrap().as_str(), folder.names()), ("precious", vec!["old.csv".into()]));
    lath_from("", ["convert", "-", "-"]).fails(3, &["F001"]);
    lath_from("1,2\n3,4\n5,6\n", ["convert", "-", "-", "--budget", "2"]).fails(5, &["B001"]);
    lath(["convert", &folder.path("absent.csv"), "-"]).fails(4, &["I001"]);
    lath_from(NAMED, ["convert", "-", &folder.path("x.svg")]).fails(2, &[".svg", "--format"]);
    lath_from(NAMED, ["convert", "-", "-", "--format", "scipy"]).fails(2, &["scipy", "holds no table"]);
    lath_from(r#"{"lath": 1, "shapes": []}"#, ["convert", "-", "-"]).fails(3, &["standard input", "F021"]);
}

#[test]
fn a_file_can_replace_itself() {
    let folder = Folder::new();
    let same = folder.file("same.txt", "# two\n1 2\n3 4\n");
    assert_eq!(lath(["convert", &same, &same]).done(), "");
    assert_eq!(std::fs::read_to_string(&same).unwrap(), "1 2\n3 4\n");
}

/// A run whose address space is limited, in KiB.
#[cfg(target_os = "linux")]
fn limited(kib: u64, arguments: &[&str]) -> std::process::Output {
    let command = format!("ulimit -v {kib}; exec \"$@\"");
    let tool = ["-c", &command, "sh", env!("CARGO_BIN_EXE_lath")];
    std::process::Command::new("sh").args(tool).args(arguments).output().unwrap()
}

#[cfg(target_os = "linux")]
#[test]
fn a_hundred_times_the_rows_take_no_more_memory() {
    /// What the system maps more or less of from run to run; the rows of the longer run take ten times as much.
    const SLACK: u64 = 1024;
    let folder = Folder::new();
    let curve = folder.file("c.json", r#"{"lath": 1, "shapes": [{"kind": "bezier", "points": [[0,0],[1,2],[2,0]]}]}"#);
    let numbers = |count: u64| (0..count).map(|i| format!("{}\n", i as f64 / count as f64)).collect::<String>();
    let (few, many) = (folder.file("few.txt", numbers(6_000)), folder.file("many.txt", numbers(600_000)));
    let (short, long) = (folder.path("few.npy"), folder.path("many.npy"));
    let pairs: [(&[&str], &[&str]); 4] = [
        (&["eval", &curve, "--at-file", &few, "-o", &short], &["eval", &curve, "--at-file", &many, "-o", &long]),
        (&["eval", &curve, "--at-file", &few], &["eval", &curve, "--at-file", &many]),
        (&["eval", &curve, "--count", "6000"], &["eval", &curve, "--count", "600000"]),
        (&["convert", &short, "/dev/null"], &["convert", &long, "/dev/null"]),
    ];
    for (small, large) in pairs {
        // The least that the small run needs.
        let (mut low, mut high) = (1 << 10, 1 << 20);
        assert!(limited(high, small).status.success(), "{small:?}");
        while high - low > 256 {
            let middle = u64::midpoint(low, high);
            if limited(middle, small).status.success() { high = middle } else { low = middle }
        }
        let run = limited(high + SLACK, large);
        assert!(run.status.success(), "{large:?} in {high} KiB: {}", String::from_utf8_lossy(&run.stderr));
    }
}
