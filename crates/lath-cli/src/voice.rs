//! What is said on standard error beside failures: notes, and the progress of long work.
//!
//! `--quiet` silences both. Progress is for people who watch: it needs a terminal, and is silent where the results go to
//! the same one.

use std::io::{self, IsTerminal, Write};
use std::time::{Duration, Instant};

/// Whether anything is said.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Voice {
    pub(crate) quiet: bool,
}

impl Voice {
    /// The same, silent where the results are for a program.
    pub(crate) fn unless(self, silent: bool) -> Voice {
        Voice { quiet: self.quiet || silent }
    }

    /// One line for the user.
    pub(crate) fn note(self, text: &str) {
        if !self.quiet {
            // Nobody is left to be told that standard error cannot be written.
            let _ = writeln!(io::stderr().lock(), "lath: {text}");
        }
    }

    /// Progress through `total` steps, where that is known; `to_file`: the results do not go to standard output.
    pub(crate) fn progress(self, total: Option<u64>, to_file: bool) -> Progress {
        let seen = !self.quiet && io::stderr().is_terminal() && (to_file || !io::stdout().is_terminal());
        Progress { seen, total, done: 0, next: Instant::now() + PATIENCE, shown: false }
    }
}

/// What is done sooner needs no report.
const PATIENCE: Duration = Duration::from_millis(300);
/// How often the report changes.
const PACE: Duration = Duration::from_millis(100);
/// How many steps pass between two looks at the clock.
const STRIDE: u64 = 1024;

/// A line that says how far the work is; it goes away with this.
pub(crate) struct Progress {
    seen: bool,
    total: Option<u64>,
    done: u64,
    next: Instant,
    shown: bool,
}

impl Progress {
    /// One more step is done.
    pub(crate) fn step(&mut self) {
        self.done += 1;
        if self.seen && self.done.is_multiple_of(STRIDE) && Instant::now() >= self.next {
            self.next = Instant::now() + PACE;
            self.shown = true;
            let (done, mut out) = (self.done, io::stderr().lock());
            let _ = match self.total {
                Some(total) => {
                    let percent = done as f64 / total.max(1) as f64 * 100.0;
                    write!(out, "\r{percent:4.0} %  {done} of {total} rows")
                }
                None => write!(out, "\r{done} rows"),
            };
        }
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        if self.shown {
            let _ = write!(io::stderr().lock(), "\r{:60}\r", "");
        }
    }
}
