//! Rows 66 to 74: files that are cut or hostile, and paths.

use crate::tool::{Folder, lath, lath_from};
use crate::{document, points_fail, run};
use std::process::{Command, Stdio};

#[test]
fn row_66_files_that_are_cut_or_garbled() {
    points_fail("", &["F001"]);
    points_fail("0,0\n1,\u{0}\n2,0\n3,1\n", &["standard input:2", "F002"]);
    points_fail("[[0,0],[1,1]", &["F010"]);
    lath_from(b"0,0\n1,\xff\n", ["through", "-"]).fails(3, &["standard input:2:3", "F003"]);
    lath_from(b"\xff\xfe0\x00", ["through", "-"]).fails(3, &["F003", "UTF-16"]);
    points_fail("<svg/>", &["F004", "SVG"]);
    points_fail("PK\u{3}\u{4}", &["F004", "zip"]);
    let plain = run("x,y\n0,0\n1,1\n", "through -").done();
    assert_eq!(run("\u{feff}x,y\r\n0,0\r\n1,1\r\n", "through -").done(), plain);
    let folder = Folder::new();
    let wrong = folder.file("points.json", "0,0\n1,1\n");
    lath(["through", &wrong]).fails(3, &["points.json:1", "F01"]);
    lath(["through", &folder.path("absent.csv")]).fails(4, &["absent.csv", "I001"]);
}

#[test]
fn row_67_json_made_to_break_parsers() {
    let deep = 1_000_000;
    points_fail(&"[".repeat(deep), &["F012"]);
    lath_from(format!("{}{}", "[".repeat(deep), "]".repeat(deep)), ["info", "-"])
        .fails(3, &["F012", "standard input:1"]);
    lath_from("{\"a\":".repeat(deep), ["info", "-"]).fails(3, &["F012"]);
    run(r#"{"lath": 1, "lath": 1, "shapes": []}"#, "info -").fails(3, &["F013", "lath"]);
    run(format!("{} x", document(r#""kind": "bezier", "points": [0]"#)), "info -").fails(3, &["F011"]);
    points_fail(&format!("[[0,1{}]]", "0".repeat(400)), &["P003"]);
}

#[test]
fn row_69_counts_beyond_the_data() {
    let folder = Folder::new();
    for shape in ["(3, 2)", "(1000000000, 3)", "(18446744073709551615, 2)", "(4294967296, 4294967296)", "(-1, 2)"] {
        let header = format!("{{'descr': '<f8', 'fortran_order': False, 'shape': {shape}, }}\n");
        let length = u16::try_from(header.len()).unwrap().to_le_bytes();
        let bytes = [b"\x93NUMPY\x01\x00", &length[..], header.as_bytes(), &[0; 32]].concat();
        let path = folder.file("a.npy", bytes);
        lath(["through", &path]).fails(3, &["a.npy", "F025"]);
    }
}

#[test]
fn row_74_paths_that_cannot_be_written() {
    let arch = "0,0\n1,2\n3,2\n4,0\n";
    let folder = Folder::new();
    let to = |path: &str| lath_from(arch, ["through", "-", "-o", path]);
    std::fs::create_dir(folder.path("taken.json")).unwrap();
    to(&folder.path("taken.json")).fails(4, &["taken.json", "I003", "folder"]);
    to(&folder.path("no/such/curve.json")).fails(4, &["curve.json", "I001"]);
    // The same file in and out: read to its end, then replaced as a whole; or left alone.
    let same = folder.file("same.json", document(r#""kind": "bezier", "points": [[0,0],[1,2]]"#));
    lath(["through", &same, "-o", &same]).fails(3, &["same.json", "F021"]);
    assert!(std::fs::read_to_string(&same).unwrap().contains("bezier"));
    let points = folder.file("points.json", "[[0,0],[1,2],[2,0]]");
    assert_eq!(lath(["through", &points, "-o", &points]).done(), "");
    assert!(std::fs::read_to_string(&points).unwrap().starts_with("{\"lath\": 1"));
    assert_eq!(folder.names(), ["points.json", "same.json", "taken.json"]);
    let locked = folder.file("locked.json", "precious");
    let mut permissions = std::fs::metadata(&locked).unwrap().permissions();
    permissions.set_readonly(true);
    std::fs::set_permissions(&locked, permissions).unwrap();
    to(&locked).fails(4, &["locked.json", "I002"]);
    assert_eq!(std::fs::read_to_string(&locked).unwrap(), "precious");
    #[cfg(target_os = "linux")]
    {
        to("/dev/full").fails(4, &["I005"]);
        let child = Command::new(env!("CARGO_BIN_EXE_lath"))
            .args(["--help"])
            .stdout(std::fs::OpenOptions::new().write(true).open("/dev/full").unwrap())
            .stderr(Stdio::null())
            .spawn();
        assert_eq!(child.unwrap().wait().unwrap().code(), Some(4));
    }
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink("points.json", folder.path("link.json")).unwrap();
        assert_eq!(to(&folder.path("link.json")).done(), "");
        assert!(std::fs::symlink_metadata(folder.path("link.json")).unwrap().is_symlink());
        assert!(std::fs::read_to_string(&points).unwrap().contains("hermite"));
    }
}
