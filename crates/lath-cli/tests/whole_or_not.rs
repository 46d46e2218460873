//! Files are written whole or not at all: runs killed at any moment, writes that fail half-way, a full disk.
//!
//! When a signal arrives is left to chance, and no verdict depends on it: whatever the moment, the file is the old one, the new one,
//! or absent if it was absent.
#![cfg(unix)]
#![allow(clippy::unwrap_used, clippy::panic)] // helpers of tests stop at the first fault, loudly

mod tool;

use rustix::process::{Pid, Signal, kill_process};
use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::Instant;
use tool::{Folder, lath, real};

/// A verb that writes a file; `{}` is the folder of its inputs.
const WRITERS: [(&str, &str); 11] = [
    ("curve.json", "through {}/many.csv -o"),
    ("spline.json", "curve {}/many.csv --kind bspline -o"),
    ("picture.svg", "draw {}/wing.dat --through --comb --axes -o"),
    ("picture.png", "draw {}/wing.dat --through --axes --size 300x200 -o"),
    ("level.csv", "subdivide {}/wing.dat --scheme cubic --levels 6 -o"),
    ("level.npy", "subdivide {}/wing.dat --scheme chaikin --levels 6 -o"),
    ("table.csv", "eval {}/curve.json --count 4000 --derivatives 2 -o"),
    ("table.npy", "eval {}/curve.json --count 4000 -o"),
    ("rows.json", "eval {}/curve.json --count 4000 --format json -o"),
    ("functions.svg", "exact blending --degree 3 --knots 0,0,0,0,1,2,3,3,3,3 -o"),
    ("broken.csv", "check --fix"),
];

/// What each writer needs to read, in a folder of its own.
fn inputs() -> Folder {
    let folder = Folder::new();
    let rows: String = (0..3000).map(|i| format!("{i},{}\n", i * i % 97)).collect();
    folder.file("many.csv", rows);
    folder.file("wing.dat", fs::read(real("rae2822.dat")).unwrap());
    lath(["through", &folder.path("wing.dat"), "-o", &folder.path("curve.json")]).done();
    folder
}

/// A file that `check --fix` mends: long, so that writing it takes a while.
fn broken() -> Vec<u8> {
    (0..3000).map(|i| format!("{i},{}\n{i},nan\n", i * i % 97)).collect::<String>().into_bytes()
}

fn arguments(writer: &str, inputs: &Folder, target: &str) -> Vec<String> {
    let writer = writer.replace("{}", inputs.path("").trim_end_matches('/'));
    writer.split(' ').map(str::to_owned).chain([target.to_owned()]).collect()
}

/// The command, silent, and without anything to read.
fn command(arguments: &[String]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_lath"));
    command.args(arguments).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
    command
}

/// What stands in the file before the run.
fn before(name: &str, run: usize) -> Option<Vec<u8>> {
    match (name, run.is_multiple_of(2)) {
        ("broken.csv", _) => Some(broken()),
        (_, true) => Some(b"precious\n".to_vec()),
        (_, false) => None,
    }
}

/// Numbers without order, the same in every run of the test.
struct Chance(u64);

impl Chance {
    fn below(&mut self, n: u64) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0 % n
    }
}

/// What 200 runs came to.
#[derive(Debug, Default)]
struct Tally {
    old: usize,
    new: usize,
    absent: usize,
    litter: usize,
    interrupted: usize,
}

#[test]
fn two_hundred_killed_runs_leave_whole_files() {
    let inputs = inputs();
    // What each writes when nobody interferes, and how long that takes, so that signals fall into the run.
    let whole = WRITERS.map(|(name, writer)| {
        let folder = Folder::new();
        let target = folder.path(name);
        if let Some(old) = before(name, 0) {
            fs::write(&target, old).unwrap();
        }
        let begun = Instant::now();
        command(&arguments(writer, &inputs, &target)).status().unwrap();
        (fs::read(&target).unwrap(), begun.elapsed())
    });
    let (mut chance, mut tally) = (Chance(0x9E37_79B9_7F4A_7C15), Tally::default());
    for run in 0..200 {
        let at = run % WRITERS.len();
        let ((name, writer), (new, duration)) = (WRITERS[at], &whole[at]);
        let (folder, old) = (Folder::new(), before(name, run / WRITERS.len()));
        let target = folder.path(name);
        if let Some(old) = &old {
            fs::write(&target, old).unwrap();
        }
        let signal = [Signal::KILL, Signal::INT, Signal::TERM][chance.below(3) as usize];
        let wait = duration.mul_f64(chance.below(1100) as f64 / 1000.0);
        let mut child = command(&arguments(writer, &inputs, &target)).spawn().unwrap();
        std::thread::sleep(wait);
        // Whoever has ended already cannot be killed.
        let _ = kill_process(Pid::from_child(&child), signal);
        let status = child.wait().unwrap();
        let there = fs::read(&target).ok();
        let case = format!("run {run}: {name} after {signal:?} at {wait:?}, {status}");
        match (&there, &old) {
            (Some(bytes), _) if bytes == new => tally.new += 1,
            (Some(bytes), Some(old)) if bytes == old => tally.old += 1,
            (None, None) => tally.absent += 1,
            _ => panic!("{case}: {} bytes are there", there.map_or(0, |bytes| bytes.len())),
        }
        tally.interrupted += usize::from(status.code() == Some(130));
        let litter: Vec<String> = folder.names().into_iter().filter(|found| found != name).collect();
        assert!(litter.iter().all(|found| signal == Signal::KILL && found.starts_with(".lath-")), "{case}: {litter:?}");
        tally.litter += litter.len();
    }
    println!("{tally:?}");
    // Some signals are sent at once.
    assert!(tally.old + tally.absent > 0, "no signal fell into a run: {tally:?}");
}

/// Runs writers where files stop growing early, over old files and none; says how many failed.
fn all_fail_cleanly(
    writers: &[(&str, &str)],
    folder: &Path,
    inputs: &Folder,
    run: impl Fn(&[String]) -> Option<i32>,
) -> usize {
    let mut failed = 0;
    for (name, writer) in writers {
        for round in 0..2 {
            let (target, old) = (folder.join(name), before(name, round));
            if let Some(old) = &old {
                fs::write(&target, old).unwrap();
            }
            let code = run(&arguments(writer, inputs, target.to_str().unwrap()));
            match code {
                Some(4) => {
                    assert_eq!(fs::read(&target).ok(), old, "{name}");
                    failed += 1;
                }
                code => assert_eq!(code, Some(0), "{name}"),
            }
            let _ = fs::remove_file(&target);
            assert_eq!(fs::read_dir(folder).unwrap().count(), 0, "{name} leaves litter");
        }
    }
    failed
}

#[test]
fn writes_that_fail_half_way_leave_the_old_file() {
    let (inputs, folder) = (inputs(), Folder::new());
    let failed = all_fail_cleanly(&WRITERS, Path::new(&folder.path("")), &inputs, |arguments| {
        // Files may not grow beyond 8 blocks of 512 bytes; a write beyond is an error, not a signal.
        let mut shell = Command::new("sh");
        shell.args(["-c", "trap '' XFSZ; ulimit -f 8; exec \"$0\" \"$@\"", env!("CARGO_BIN_EXE_lath")]);
        shell.args(arguments).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null()).status().unwrap().code()
    });
    assert!(failed >= 18, "{failed} of 22 runs met the limit");
}

/// `cargo test -p lath-cli --test whole_or_not -- --ignored --nocapture`, as root.
#[test]
#[ignore = "mounts a file system of 64 kB, which takes root"]
fn a_full_disk_leaves_the_old_file() {
    let (inputs, folder) = (inputs(), Folder::new());
    let mount = folder.path("");
    let made = Command::new("mount").args(["-t", "tmpfs", "-o", "size=64k", "tmpfs", &mount]).status().unwrap();
    assert!(made.success(), "only root mounts");
    let outcome = std::panic::catch_unwind(|| {
        // Fill it but for one page.
        fs::write(format!("{mount}/ballast"), vec![0u8; 60 << 10]).unwrap();
        let work = format!("{mount}/work");
        fs::create_dir(&work).unwrap();
        // Without the last, whose file must be there before and is larger than the disk.
        let writers = &WRITERS[..WRITERS.len() - 1];
        all_fail_cleanly(writers, Path::new(&work), &inputs, |arguments| command(arguments).status().unwrap().code())
    });
    assert!(Command::new("umount").arg(&mount).status().unwrap().success());
    let failed = outcome.unwrap();
    println!("{failed} of 20 runs met a full disk, and left the old file or none");
    assert!(failed >= 10, "{failed} runs met the full disk");
}
