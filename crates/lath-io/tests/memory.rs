//! Hostile files cost little: at most 40 bytes for each byte read, and 1 MiB, in every reader.
//!
//! One test alone in its file, because the allocator counts for the whole process.
#![allow(clippy::unwrap_used)]

use std::alloc::System;

use lath::error::Limits;
use lath_io::format::{self, FORMATS};
use lath_io::{check, source::Source};
use peakmem_alloc::{INSTRUMENTED_SYSTEM, PeakMemAlloc, PeakMemAllocTrait};

#[global_allocator]
static COUNTING: &PeakMemAlloc<System> = &INSTRUMENTED_SYSTEM;

/// The size of each file, about.
const SIZE: usize = 1 << 20;
const EACH: usize = 40;
const BESIDE: usize = 1 << 20;

/// `before`, then `piece` again and again, then `after`.
fn filled(before: &str, piece: &str, after: &str) -> Vec<u8> {
    let count = SIZE.saturating_sub(before.len() + after.len()) / piece.len().max(1);
    [before, &piece.repeat(count), after].concat().into_bytes()
}

fn files() -> Vec<Vec<u8>> {
    let shapes = "{\"lath\":1,\"shapes\":[";
    let mut files = vec![
        filled("", "1\n", ""),
        filled("", "1,", "1\n"),
        filled("", "1 ", "1\n"),
        filled("", ",", "\n"),
        filled("", "\"\" ", "\n"),
        filled("", "x\n", ""),
        filled("x,y\n", "a,\n", ""),
        filled("", "x,", "x\n1,2\n"),
        filled("1\n", "nan\n", ""),
        filled("", "#\n", "1"),
        filled("", "\r", "1"),
        filled("", "\u{e9}", ""),
        filled("[", "1,", "1]"),
        filled("[", "1,", "true]"),
        filled("[true,", "1,", "1]"),
        filled("[", "[1],", "[1]]"),
        filled("[", "[],", "[1]]"),
        filled("[", "[1,2],", "[1,2]]"),
        filled("[", "[0,0,0,0,0],", "[1,2,3,4,5]]"),
        filled("[", "[[]],", "1]"),
        filled("[", "null,", "1]"),
        filled("[", "\"\",", "1]"),
        filled("[", "{},", "1]"),
        filled("[", "{\"\":1},", "1]"),
        filled("[", "[1,null],", "[1,2]]"),
        filled("{\"columns\":[", "\"\",", "\"\"],\"rows\":[[1]]}"),
        filled("{\"x\":[", "1,", "1]}"),
        filled("\"", "\\u0000", "\""),
        filled("", "[", ""),
        filled("{\"lath\":1,\"shapes\":[{\"kind\":\"polyline\",\"points\":[", "1,", "1]}]}"),
        filled("{\"lath\":1,\"shapes\":[{\"kind\":\"polyline\",\"points\":[", "[1],", "[1]]}]}"),
        filled(
            "{\"lath\":1,\"shapes\":[{\"kind\":\"polyline\",\"points\":[",
            "[0,0,0,0,0,0,0,0,0],",
            "[0,0,0,0,0,0,0,0,1]]}]}",
        ),
        filled("{\"lath\":1,\"shapes\":[{\"kind\":\"bezier\",\"points\":[", "1,", "1]}]}"),
        filled("{\"lath\":1,\"shapes\":[{\"kind\":\"bspline\",\"degree\":1,\"points\":[", "1,", "1]}]}"),
        filled(
            "{\"lath\":1,\"shapes\":[{\"kind\":\"bspline\",\"degree\":1,\"closed\":true,\"points\":[",
            "1,",
            "1]}]}",
        ),
        filled(
            "{\"lath\":1,\"shapes\":[{\"kind\":\"path\",\"pieces\":[",
            "{\"kind\":\"polyline\",\"points\":[0,1]},",
            "{\"kind\":\"polyline\",\"points\":[0,1]}]}]}",
        ),
        filled(shapes, "{\"kind\":\"bezier\",\"points\":[0]},", "{\"kind\":\"bezier\",\"points\":[0]}]}"),
        filled(
            shapes,
            "{\"kind\":\"bspline\",\"degree\":65,\"closed\":true,\"points\":[0]},",
            "{\"kind\":\"bezier\",\"points\":[0]}]}",
        ),
        filled(shapes, "{\"kind\":\"bezier\",\"points\":[[0,0,0,0,0,0,0,0,0]]},", "1]}"),
        filled(shapes, "{},", "{}]}"),
        filled("{\"t\":[", "0,", "1],\"c\":[1],\"k\":0}"),
        filled("{\"shape\":{\"type\":\"curve\",\"count\":1,\"data\":[", "{},", "{}]}}"),
    ];
    let mut keys = String::from("{");
    while keys.len() < SIZE {
        keys += &format!("\"{:x}\":1,", keys.len());
    }
    files.push((keys + "\"\":1}").into_bytes());
    let coefficients = "[1],".repeat(SIZE / 8);
    let breaks: Vec<String> = (0..=SIZE / 8 + 1).map(|i| i.to_string()).collect();
    let (breaks, shape) = (breaks.join(","), "\"kind\":\"power\"");
    files.push(
        format!("{shapes}{{{shape},\"breaks\":[{breaks}],\"coefficients\":[{coefficients}[1]]}}]}}").into_bytes(),
    );
    for (descr, size) in [("|u1", 1), ("<f8", 8)] {
        let header = format!("{{'descr': '{descr}', 'fortran_order': True, 'shape': ({}, 4), }}\n", SIZE / size / 4);
        let length = (header.len() as u16).to_le_bytes();
        files.push([b"\x93NUMPY\x01\x00", &length[..], header.as_bytes(), &vec![1; SIZE]].concat());
    }
    files
}

#[test]
fn files_cost_forty_bytes_a_byte_at_most() {
    let limits = Limits::default();
    let mut worst = (0.0, String::new());
    for bytes in files() {
        let shown = String::from_utf8_lossy(&bytes[..60.min(bytes.len())]).into_owned();
        let length = bytes.len();
        let mut measure = |name: &str, work: &mut dyn FnMut(&Source)| {
            let source = Source::from_bytes("any", bytes.clone());
            COUNTING.reset_peak_memory();
            work(&source);
            let each = COUNTING.get_peak_memory().saturating_sub(BESIDE) as f64 / length as f64;
            if each > worst.0 {
                worst = (each, format!("{name}: {shown}"));
            }
            assert!(each <= EACH as f64, "{name} takes {each:.1} bytes a byte of {shown:?}");
        };
        for format in FORMATS {
            measure(format.name, &mut |source| drop(format::read(source, Some(format), &limits)));
        }
        measure("columns", &mut |source| drop(format::read_columns(source, None, &["0"], &limits)));
        measure("check", &mut |source| drop(check::check(source, None, &limits)));
    }
    println!("at most {:.1} bytes a byte, {}", worst.0, worst.1);
}
