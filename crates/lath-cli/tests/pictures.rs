//! The pictures of the documentation are what the tool draws today, byte for byte.
#![allow(clippy::unwrap_used)] // a failing unwrap is a failing test

use std::path::Path;
use std::process::Command;

#[test]
fn every_recorded_picture_is_what_its_command_draws() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let list: toml::Table =
        std::fs::read_to_string(root.join("testdata/figures/pictures.toml")).unwrap().parse().unwrap();
    let pictures = list["picture"].as_array().unwrap();
    assert!(!pictures.is_empty());
    for picture in pictures {
        let file = picture["file"].as_str().unwrap();
        let arguments = picture["command"].as_array().unwrap().iter().map(|argument| argument.as_str().unwrap());
        let output = Command::new(env!("CARGO_BIN_EXE_lath"))
            .current_dir(&root)
            .args(arguments)
            .args(["-o", "-", "--format", "svg"])
            .output()
            .unwrap();
        assert!(output.status.success(), "{file}: {}", String::from_utf8_lossy(&output.stderr));
        let recorded = std::fs::read(root.join(file)).unwrap_or_default();
        assert!(
            output.stdout == recorded,
            "{file} differs from what its command draws; `cargo xtask pictures` draws it anew"
        );
    }
}
