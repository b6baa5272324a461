//! Ctrl-C: a wish, looked at between steps, so that what is finished is kept. The same wish is SIGTERM, which ends services and jobs of a queue, and
//! SIGHUP, which comes when a terminal is closed.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, LazyLock};

static ASKED: LazyLock<Arc<AtomicBool>> = LazyLock::new(Arc::default);

/// Exit code of a call that is ended at once.
const AT_ONCE: i32 = 130;

/// Listens for Ctrl-C and its like. A second one ends the program at once.
pub(crate) fn listen() {
    // A handler that is there already (a test in the same process) stays.
    let first = ctrlc::set_handler(|| {
        if ASKED.swap(true, Ordering::SeqCst) {
            std::process::exit(AT_ONCE);
        }
    });
    if first.is_ok() {
        listen_for_ends();
    }
}

/// A signal that cannot be listened for ends the program as ever; what is recorded is kept then too.
#[cfg(unix)]
fn listen_for_ends() {
    use signal_hook::consts::{SIGHUP, SIGTERM};
    use signal_hook::flag::{register, register_conditional_shutdown};
    let hangs_up = (!hang_up_is_ignored()).then_some(SIGHUP);
    for signal in std::iter::once(SIGTERM).chain(hangs_up) {
        // In this order: the first signal sees the wish unset, the second one ends the program.
        let _ = register_conditional_shutdown(signal, AT_ONCE, Arc::clone(&ASKED));
        let _ = register(signal, Arc::clone(&ASKED));
    }
}

#[cfg(not(unix))]
fn listen_for_ends() {}

/// Whether the call was started to outlive its terminal (`nohup`): the signals that are ignored stand as bits of a hexadecimal number.
#[cfg(unix)]
fn hang_up_is_ignored() -> bool {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let ignored = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    ignored.and_then(|bits| u64::from_str_radix(bits.trim(), 16).ok()).is_some_and(|bits| bits & 1 == 1)
}

/// Whether the user wants to stop.
pub(crate) fn asked() -> bool {
    ASKED.load(Ordering::SeqCst)
}
