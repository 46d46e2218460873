//! lath beside its peers: the same input, answers compared first, then times taken in turns; one table at the end.
//!
//! ```text
//! main
//! ├── interpolation, evaluation, subdivision, lengths   the workloads: their input, what is timed
//! ├── accuracy                    a command of its own: no times, but errors
//! ├── contender                   lath and each peer, one file each; scipy through a process of its own
//! ├── comparison                  agreement, then rounds in which everybody runs once
//! └── table, memory, random       printing, counting bytes, the same input on every machine
//! ```

mod accuracy;
mod comparison;
mod contender;
mod evaluation;
mod interpolation;
mod lengths;
mod memory;
mod random;
mod subdivision;
mod table;

use comparison::Comparison;
use contender::scipy::Scipy;
use std::cell::RefCell;
use std::process::ExitCode;

type Result<T> = std::result::Result<T, Box<dyn std::error::Error>>;

fn main() -> ExitCode {
    match run() {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => {
            eprintln!("bench: a peer failed or differs from lath by more than {:e}", comparison::TOLERANCE);
            ExitCode::FAILURE
        }
        Err(error) => {
            eprintln!("bench: {error}");
            ExitCode::FAILURE
        }
    }
}

/// Whether everybody agreed.
fn run() -> Result<bool> {
    const WORKLOADS: [&str; 4] = ["interpolate", "evaluate", "subdivide", "length"];
    let named: Vec<String> = std::env::args().skip(1).collect();
    if let Some((first, options)) = named.split_first()
        && first == "accuracy"
    {
        println!("machine: {}", machine());
        return if accuracy::run(options)? { Ok(true) } else { Err("lath breaks its bound".into()) };
    }
    if let Some(other) = named.iter().find(|name| !WORKLOADS.contains(&name.as_str())) {
        return Err(format!("no workload is called {other}; there are {}, and accuracy", WORKLOADS.join(", ")).into());
    }
    let wanted = |name: &str| named.is_empty() || named.iter().any(|other| other == name);
    println!("machine: {}", machine());
    let scipy = match Scipy::start() {
        Ok(scipy) => {
            println!("scipy: {}", scipy.versions());
            Some(RefCell::new(scipy))
        }
        Err(reason) => {
            println!("scipy: skipped, because {reason}");
            None
        }
    };
    println!("heavy peers (scirs2-interpolate, curvo, geo): {}", if cfg!(feature = "heavy") { "yes" } else { "no" });
    let mut all: Vec<Comparison> = Vec::new();
    if wanted("interpolate") {
        interpolation::compare(scipy.as_ref(), &mut all)?;
    }
    if wanted("evaluate") {
        evaluation::compare(scipy.as_ref(), &mut all)?;
    }
    if wanted("subdivide") {
        subdivision::compare(&mut all)?;
    }
    if wanted("length") {
        lengths::compare(&mut all)?;
    }
    println!("\n{}", table::markdown(&all));
    Ok(all.iter().all(Comparison::agreed))
}

fn machine() -> String {
    let cores = std::thread::available_parallelism().map_or_else(|_| "?".to_owned(), |n| n.to_string());
    let model = std::fs::read_to_string("/proc/cpuinfo").ok().and_then(|text| {
        let line = text.lines().find(|line| line.starts_with("model name"))?;
        Some(line.split_once(':')?.1.trim().to_owned())
    });
    format!("{cores} cores, {}", model.as_deref().unwrap_or("model unknown"))
}
