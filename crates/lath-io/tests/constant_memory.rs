//! Rows go in and out in constant memory: ten times as many take no more.
//!
//! One test alone in its file, because the allocator counts for the whole process.
#![allow(clippy::unwrap_used, clippy::panic)] // a failing unwrap is a failing test

use std::alloc::System;
use std::fs::File;
use std::io::{self, BufWriter, Write};
use std::path::Path;

use lath::error::Limits;
use lath_io::format::{self, Opened};
use lath_io::stream::Stream;
use peakmem_alloc::{INSTRUMENTED_SYSTEM, PeakMemAlloc, PeakMemAllocTrait};

#[global_allocator]
static COUNTING: &PeakMemAlloc<System> = &INSTRUMENTED_SYSTEM;

const FEW: u64 = 50_000;
const MANY: u64 = 500_000;
/// What two runs may differ by: names, lengths of numbers.
const SLACK: usize = 4096;

/// A table of three columns with this many rows.
fn write(path: &Path, rows: u64) {
    let name = path.extension().unwrap().to_str().unwrap();
    let mut out = BufWriter::new(File::create(path).unwrap());
    if name == "fortran" {
        let header = format!("{{'descr': '<f8', 'fortran_order': True, 'shape': ({rows}, 3), }}\n");
        out.write_all(b"\x93NUMPY\x01\x00").unwrap();
        out.write_all(&(header.len() as u16).to_le_bytes()).unwrap();
        out.write_all(header.as_bytes()).unwrap();
        (0..3 * rows).for_each(|i| out.write_all(&(i as f64).to_le_bytes()).unwrap());
        out.flush().unwrap();
        return;
    }
    let names = ["x", "y", "z"].map(str::to_owned);
    let mut sink = format::by_name(name).unwrap().rows_counted(&mut out, Some(&names), rows).unwrap();
    (0..rows).for_each(|i| sink.row(&[i as f64, 0.1 * i as f64, 1.0 / (1.0 + i as f64)]).unwrap());
    sink.finish().unwrap();
}

/// Reads all rows twice and writes them in another format; returns the greatest memory meanwhile.
fn peak(stream: Stream<'_>, from: &str, to: &str, rows: u64) -> usize {
    let limits = Limits::default();
    COUNTING.reset_peak_memory();
    let from = format::by_name(from).unwrap();
    let Opened::Rows(mut input) = format::open(stream, Some(from), None, &limits).unwrap() else { panic!("shapes") };
    while input.next_row().unwrap().is_some() {}
    assert_eq!(input.count(), rows);
    input.rewind().unwrap();
    let mut out = io::sink();
    let mut sink = format::by_name(to).unwrap().rows_counted(&mut out, None, rows).unwrap();
    while let Some(row) = input.next_row().unwrap() {
        sink.row(row).unwrap();
    }
    sink.finish().unwrap();
    COUNTING.get_peak_memory()
}

#[test]
fn ten_times_the_rows_take_no_more_memory() {
    let folder = tempfile::tempdir().unwrap();
    for (extension, from) in [("csv", "csv"), ("text", "text"), ("npy", "npy"), ("fortran", "npy")] {
        let [few, many] = [FEW, MANY].map(|rows| {
            let path = folder.path().join(format!("{rows}.{extension}"));
            write(&path, rows);
            (path, rows)
        });
        for to in ["csv", "tsv", "text", "json", "npy"] {
            if extension != "csv" && to != "npy" {
                continue; // the formats know nothing of each other
            }
            let [a, b] = [&few, &many].map(|(path, rows)| peak(Stream::open(path).unwrap(), from, to, *rows));
            assert!(b <= a + SLACK, "{extension} to {to} takes {b} bytes for {MANY} rows, {a} for {FEW}");
        }
        // What comes through a pipe is kept on the disk; both are longer than what is kept in memory.
        let [a, b] =
            [&few, &many].map(|(path, rows)| peak(Stream::pipe("pipe", File::open(path).unwrap()), from, "csv", *rows));
        assert!(b <= a + SLACK, "{extension} from a pipe takes {b} bytes for {MANY} rows, {a} for {FEW}");
        println!("{extension}: {a} bytes through a pipe");
    }
}
