//! The pictures of the documentation are what the tool draws today, byte for byte, SVG and PNG.
#![allow(clippy::unwrap_used)] // a failing unwrap is a failing test

mod tool;

use std::path::Path;
use std::process::Command;
use std::sync::Mutex;
use tool::{Folder, repository};

/// A recorded file, and the commands that draw it: what the last one prints.
struct Job {
    commands: Vec<Vec<String>>,
    files: Vec<(String, Vec<&'static str>)>,
}

fn words(list: &toml::Value) -> Vec<String> {
    list.as_array().unwrap().iter().map(|word| word.as_str().unwrap().to_owned()).collect()
}

/// Every picture of the list; a figure of the gallery is four.
fn jobs() -> Vec<Job> {
    let list: toml::Table =
        std::fs::read_to_string(repository("testdata/figures/pictures.toml")).unwrap().parse().unwrap();
    let mut jobs = Vec::new();
    for picture in list["picture"].as_array().unwrap() {
        let file = picture["file"].as_str().unwrap().to_owned();
        jobs.push(Job { commands: vec![words(&picture["command"])], files: vec![(file, vec!["--format", "svg"])] });
    }
    for section in list["section"].as_array().unwrap() {
        for figure in section["figure"].as_array().unwrap() {
            let file = |end: &str| format!("docs/gallery/{}{end}", figure["name"].as_str().unwrap());
            let files = vec![
                (file(".svg"), vec!["--format", "svg"]),
                (file("-dark.svg"), vec!["--format", "svg", "--dark"]),
                (file(".png"), vec!["--format", "png", "--density", "0.85"]),
                (file("-dark.png"), vec!["--format", "png", "--density", "0.85", "--dark"]),
            ];
            jobs.push(Job { commands: figure["commands"].as_array().unwrap().iter().map(words).collect(), files });
        }
    }
    jobs
}

/// Runs the tool in a folder; what it prints.
fn run(folder: &Folder, command: &[String], more: &[&str]) -> Vec<u8> {
    let mut lath = Command::new(env!("CARGO_BIN_EXE_lath"));
    let output = lath.current_dir(folder.path("")).args(command).args(more).output().unwrap();
    assert!(output.status.success(), "{command:?}: {}", String::from_utf8_lossy(&output.stderr));
    output.stdout
}

/// A folder with the data of the figures and nothing else.
fn scratch() -> Folder {
    let folder = Folder::new();
    for data in ["testdata/figures", "testdata/real"] {
        std::fs::create_dir_all(folder.path(data)).unwrap();
        for entry in std::fs::read_dir(repository(data)).unwrap() {
            let entry = entry.unwrap();
            std::fs::copy(entry.path(), Path::new(&folder.path(data)).join(entry.file_name())).unwrap();
        }
    }
    folder
}

#[test]
fn every_recorded_picture_is_what_its_command_draws() {
    let jobs = jobs();
    assert!(jobs.len() > 50, "{}", jobs.len());
    let (queue, stale) = (Mutex::new(jobs.iter()), Mutex::new(Vec::new()));
    std::thread::scope(|scope| {
        for _ in 0..std::thread::available_parallelism().map_or(1, usize::from) {
            scope.spawn(|| {
                let folder = scratch();
                loop {
                    let Some(job) = queue.lock().unwrap().next() else { break };
                    let (last, before) = job.commands.split_last().unwrap();
                    for command in before {
                        run(&folder, command, &[]);
                    }
                    for (file, options) in &job.files {
                        let drawn = run(&folder, last, &[&["-o", "-"], options.as_slice()].concat());
                        if std::fs::read(repository(file)).unwrap_or_default() != drawn {
                            stale.lock().unwrap().push(file);
                        }
                    }
                }
            });
        }
    });
    let stale = stale.into_inner().unwrap();
    assert!(stale.is_empty(), "differ from what their commands draw: {stale:?}; `cargo xtask gallery` draws them anew");
}

#[test]
fn the_gallery_is_light_enough_for_a_clone() {
    let entries = std::fs::read_dir(repository("docs/gallery")).unwrap().map(|entry| entry.unwrap());
    let size = |extension: &str, files: &[std::fs::DirEntry]| -> u64 {
        let of = files.iter().filter(|file| file.path().extension().is_some_and(|e| e == extension));
        of.map(|file| file.metadata().unwrap().len()).sum()
    };
    let files: Vec<_> = entries.collect();
    assert!((1..3_000_000).contains(&size("png", &files)), "{}", size("png", &files));
    assert!((1..3_000_000).contains(&size("svg", &files)), "{}", size("svg", &files));
}

/// The triplets of two figures are the tool's own.
#[test]
fn triplets_in_figures_are_those_of_the_scheme() {
    for (figure, places) in [("triplets", [(0, 0), (1, 0), (2, 0), (3, 0)]), ("jump", [(1, 1), (2, 2), (3, 4), (4, 8)])]
    {
        let file = std::fs::read_to_string(repository(&format!("testdata/figures/{figure}.json"))).unwrap();
        let document: serde_json::Value = serde_json::from_str(&file).unwrap();
        assert_eq!(document["shapes"].as_array().unwrap().len(), places.len());
        for (shape, (level, index)) in document["shapes"].as_array().unwrap().iter().zip(places) {
            let points = tool::numbers(&shape["points"]);
            for i in 0..3 {
                let only = format!("{level}:{}", index + i);
                let group = repository("testdata/figures/group.csv");
                let csv = tool::lath(["subdivide", &group, "--scheme", "cubic", "--only", &only]).done();
                assert_eq!(tool::rows(&csv)[0], points[2 * i..2 * i + 2], "{figure} {only}");
            }
        }
    }
}
