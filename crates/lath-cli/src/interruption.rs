//! Ctrl-C while a file is written: the unfinished file is taken away, the old one stays, and the exit code is 130.
//!
//! The first signal ends the writing in order; a second one ends the process at once. Before a file is written nothing is
//! to be taken away, and the system's own answer stands. From the first file on the process listens to its end.

use signal_hook::consts::{SIGINT, SIGTERM};
use signal_hook::flag;
use std::io::{self, Write};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, OnceLock};

/// What a shell reports of an interrupted command.
const INTERRUPTED: i32 = 130;

/// Whether the user wants to stop.
pub(crate) struct Interruption(Arc<AtomicBool>);

impl Interruption {
    /// Listens from now on, once for all that watch.
    pub(crate) fn watch() -> Interruption {
        static WANTED: OnceLock<Arc<AtomicBool>> = OnceLock::new();
        let wanted = WANTED.get_or_init(|| {
            let wanted = Arc::new(AtomicBool::new(false));
            for signal in [SIGINT, SIGTERM] {
                // In this order: the first signal only raises the flag, the second finds it raised. Where signals cannot be
                // caught, they act as ever.
                let _ = flag::register_conditional_shutdown(signal, INTERRUPTED, Arc::clone(&wanted));
                let _ = flag::register(signal, Arc::clone(&wanted));
            }
            wanted
        });
        Interruption(Arc::clone(wanted))
    }

    /// Whether it has happened.
    pub(crate) fn happened(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }
}

/// A writer that refuses to go on after an interruption.
pub(crate) struct Interruptible<'a> {
    pub(crate) out: &'a mut dyn Write,
    pub(crate) interruption: &'a Interruption,
}

impl Write for Interruptible<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        if self.interruption.happened() {
            return Err(io::Error::other("interrupted"));
        }
        self.out.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.out.flush()
    }
}
