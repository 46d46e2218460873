//! Manners: colours and progress on a terminal only, quiet, version, completions, manual pages, targets that are links.
#![allow(clippy::unwrap_used, clippy::panic)] // a failing unwrap is a failing test

mod tool;

use tool::{Folder, lath, lath_from};

const ARCH: &str = "0,0\n1,2\n3,2\n4,0\n";
const VERBS: [&str; 11] =
    ["through", "curve", "eval", "sample", "length", "subdivide", "convert", "draw", "info", "check", "exact"];

#[test]
fn the_version_names_features_and_simd_level() {
    let version = lath(["--version"]).done();
    let lines: Vec<&str> = version.lines().collect();
    assert_eq!(lines[0], concat!("lath ", env!("CARGO_PKG_VERSION")));
    assert_eq!(lines[1..], ["features: none", "SIMD level: scalar"]);
    assert_eq!(lath(["-V"]).done(), concat!("lath ", env!("CARGO_PKG_VERSION"), "\n"));
}

#[test]
fn completions_for_every_shell() {
    for shell in ["bash", "zsh", "fish", "powershell"] {
        let script = lath(["completions", shell]).done();
        for word in VERBS.into_iter().chain(["keep-ends", "to-tolerance"]) {
            assert!(script.contains(word), "{shell}: {word}");
        }
        // PowerShell is not told the values of options.
        for word in ["centripetal", "four-point", "pchip"] {
            assert!(shell == "powershell" || script.contains(word), "{shell}: {word}");
        }
    }
    lath(["completions", "tcsh"]).fails(2, &["tcsh", "zsh"]);
    lath(["completions"]).fails(2, &["SHELL"]);
    let folder = Folder::new();
    let path = folder.path("lath.bash");
    assert_eq!(lath(["completions", "bash", "-o", &path]).done(), "");
    assert_eq!(std::fs::read_to_string(path).unwrap(), lath(["completions", "bash"]).done());
}

#[test]
fn manual_pages_for_every_verb() {
    let tool = lath(["man"]).done();
    assert!(tool.contains(".TH lath 1") && tool.contains("Exit codes") && tool.contains("lath\\-draw(1)"), "{tool}");
    for verb in VERBS {
        let page = lath(["man", verb]).done();
        assert!(page.contains(&format!(".TH lath-{verb} 1")) && page.contains("Examples:"), "{page}");
    }
    lath(["man", "drwa"]).fails(2, &["drwa", "draw"]);
    lath(["man", "draw", "--all", "."]).fails(2, &["--all"]);
    let folder = Folder::new();
    assert_eq!(lath(["man", "--all", &folder.path("")]).done(), "");
    let names = folder.names();
    for verb in VERBS {
        assert!(names.contains(&format!("lath-{verb}.1")), "{names:?}");
    }
    assert_eq!(std::fs::read_to_string(folder.path("lath.1")).unwrap(), tool);
    lath(["man", "--all", &folder.path("absent")]).fails(4, &["I001"]);
}

#[test]
fn quiet_leaves_only_failures() {
    let args = ["subdivide", "-", "--scheme", "cubic", "--to-tolerance", "0.1"];
    assert!(lath_from(ARCH, args).err.starts_with("lath: level "));
    lath_from(ARCH, args.into_iter().chain(["--quiet"])).done();
    lath_from(ARCH, ["-q"].into_iter().chain(args)).done();
    lath_from("0,0\nx,0\n", ["-q", "through", "-"]).fails(3, &["F005"]);
}

#[test]
fn mistyped_values_are_answered_with_a_similar_one() {
    for (args, words) in [
        ("through - --params chrod", ["chrod", "'chord'"]),
        ("through - --ends natrual", ["natrual", "'natural'"]),
        ("through - --start not-a-kont", ["not-a-kont", "'not-a-knot'"]),
        ("through - --ends anticylic", ["anticylic", "'anticyclic'"]),
        ("through - --kind catmulrom", ["catmulrom", "'catmull-rom'"]),
        ("curve - --kind bezeir", ["bezeir", "'bezier'"]),
        ("eval - --count 2 --outside clam", ["clam", "'clamp'"]),
        ("info - --from jsn", ["jsn", "'json'"]),
        ("subdivde - --levels 2", ["subdivde", "'subdivide'"]),
        ("draw - --drak -o x.svg", ["--drak", "'--dark'"]),
    ] {
        lath_from(ARCH, args.split(' ')).fails(2, &words);
    }
}

#[cfg(unix)]
#[test]
fn targets_that_are_read_only_or_links() {
    use std::os::unix::fs::symlink;
    let folder = Folder::new();
    let locked = folder.file("locked.json", "precious");
    let mut permissions = std::fs::metadata(&locked).unwrap().permissions();
    permissions.set_readonly(true);
    std::fs::set_permissions(&locked, permissions).unwrap();
    lath_from(ARCH, ["through", "-", "-o", &locked]).fails(4, &["locked.json", "I002"]);
    assert_eq!(std::fs::read_to_string(&locked).unwrap(), "precious");
    // A link stays one, and what it leads to is replaced.
    let (real, link) = (folder.file("real.json", "old"), folder.path("link.json"));
    symlink("real.json", &link).unwrap();
    lath_from(ARCH, ["through", "-", "-o", &link]).done();
    assert!(std::fs::symlink_metadata(&link).unwrap().is_symlink());
    assert!(std::fs::read_to_string(&real).unwrap().starts_with("{\"lath\": 1"));
    // A failure leaves link and file.
    std::fs::write(&real, "old").unwrap();
    lath_from("0,0\nx,1\n", ["through", "-", "-o", &link]).fails(3, &["F005"]);
    assert_eq!(std::fs::read_to_string(&link).unwrap(), "old");
    // Links that lead nowhere make the file; those that lead in a circle are refused.
    symlink("fresh.json", folder.path("dangling.json")).unwrap();
    lath_from(ARCH, ["through", "-", "-o", &folder.path("dangling.json")]).done();
    assert!(std::fs::symlink_metadata(folder.path("fresh.json")).unwrap().is_file());
    symlink("round.json", folder.path("round.json")).unwrap();
    lath_from(ARCH, ["through", "-", "-o", &folder.path("round.json")]).fails(4, &["round.json"]);
    symlink("locked.json", folder.path("to-locked.json")).unwrap();
    lath_from(ARCH, ["through", "-", "-o", &folder.path("to-locked.json")]).fails(4, &["I002"]);
    let left = ["dangling.json", "fresh.json", "link.json", "locked.json", "real.json", "round.json", "to-locked.json"];
    assert_eq!(folder.names(), left);
}

/// What a run writes to a terminal that is its standard error.
#[cfg(target_os = "linux")]
mod terminal {
    use super::{ARCH, Folder, lath_from};
    use rustix::pty::{OpenptFlags, grantpt, openpt, ptsname, unlockpt};
    use std::fs::{File, OpenOptions};
    use std::io::Read;
    use std::process::{Command, Stdio};

    fn seen(args: &[&str], variables: &[(&str, &str)]) -> String {
        let master = openpt(OpenptFlags::RDWR | OpenptFlags::NOCTTY).unwrap();
        grantpt(&master).unwrap();
        unlockpt(&master).unwrap();
        let name = ptsname(&master, Vec::new()).unwrap().into_string().unwrap();
        let slave = OpenOptions::new().read(true).write(true).open(name).unwrap();
        let mut command = Command::new(env!("CARGO_BIN_EXE_lath"));
        command.args(args).stdin(Stdio::null()).stdout(Stdio::null()).stderr(slave);
        command.env_remove("NO_COLOR").env("TERM", "xterm").envs(variables.iter().copied());
        let mut child = command.spawn().unwrap();
        drop(command); // closes the terminal here, so that reading ends with the child
        let mut shown = Vec::new();
        let mut buffer = [0; 4096];
        let mut master = File::from(master);
        // Reading from a terminal that everybody has left is an error.
        while let Ok(n @ 1..) = master.read(&mut buffer) {
            shown.extend_from_slice(&buffer[..n]);
        }
        child.wait().unwrap();
        String::from_utf8(shown).unwrap()
    }

    #[test]
    fn colours_need_a_terminal_and_no_no_color() {
        let folder = Folder::new();
        let broken = folder.file("broken.csv", "0,0\nzero,1\n");
        for args in [&["through", &broken][..], &["thruogh", "x"]] {
            assert!(seen(args, &[]).contains("\u{1b}["), "{args:?}");
            let plain = seen(args, &[("NO_COLOR", "1")]);
            assert!(!plain.contains('\u{1b}') && !plain.is_empty(), "{plain}");
            assert!(!super::lath(args).err.contains('\u{1b}'));
        }
        assert!(seen(&["through", &broken], &[("NO_COLOR", "1")]).contains("F005"));
    }

    #[test]
    fn progress_needs_a_terminal_and_goes_away() {
        let folder = Folder::new();
        let (curve, table) = (folder.path("curve.json"), folder.path("table.csv"));
        lath_from(ARCH, ["through", "-", "-o", &curve]).done();
        let args = ["eval", &curve, "--count", "2e6", "-o", &table];
        let shown = seen(&args, &[]);
        assert!(shown.contains(" %  ") && shown.contains("of 2000000 rows"), "{shown:?}");
        assert!(shown.ends_with(&format!("\r{:60}\r", "")), "{shown:?}");
        assert_eq!(seen(&[&args[..], &["--quiet"]].concat(), &[]), "");
        let json = ["eval", &curve, "--count", "1e6", "--json"];
        assert_eq!(seen(&json, &[]), "");
        super::lath(args).done(); // no terminal, nothing on standard error
    }
}
