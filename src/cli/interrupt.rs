//! Ctrl-C (SIGINT) and SIGTERM: the first ends the runs and keeps their results, the second ends the program.

use super::code::Code;
use signal_hook::consts::{SIGINT, SIGTERM};
use signal_hook::flag;
use std::io;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, LazyLock};

static WANTED: LazyLock<Arc<AtomicBool>> = LazyLock::new(Arc::default);

/// Installs the handlers; once, before anything is solved.
pub fn listen() -> io::Result<()> {
    for signal in [SIGINT, SIGTERM] {
        // In this order: the first signal finds the flag down and raises it, the second finds it up.
        flag::register_conditional_shutdown(signal, Code::Interrupted as i32, Arc::clone(&WANTED))?;
        flag::register(signal, Arc::clone(&WANTED))?;
    }
    Ok(())
}

/// Whether a signal has come.
pub fn is_wanted() -> bool {
    WANTED.load(Ordering::Relaxed)
}
