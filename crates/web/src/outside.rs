//! What the module needs from the page: a clock, and who is told how far a solve is. Elsewhere the clock stands and nobody listens.

use std::cell::RefCell;
use std::panic::PanicHookInfo;

thread_local! {
    static WORDS: RefCell<String> = const { RefCell::new(String::new()) };
}

#[cfg(target_arch = "wasm32")]
#[link(wasm_import_module = "page")]
unsafe extern "C" {
    /// Seconds since any moment.
    safe fn clock() -> f64;
    /// The share that is done, and words of a length at a place.
    safe fn progress(share: f64, words: *const u8, length: usize);
}

#[cfg(not(target_arch = "wasm32"))]
fn clock() -> f64 {
    0.0
}

#[cfg(not(target_arch = "wasm32"))]
fn progress(_: f64, _: *const u8, _: usize) {}

/// Seconds since any moment.
pub(crate) fn seconds() -> f64 {
    clock()
}

/// Tells the share of a solve that is done, in words too.
pub(crate) fn tell(share: f64, words: &str) {
    progress(share, words.as_ptr(), words.len());
}

/// Keeps what is said when the module ends by a fault of its own.
pub(crate) fn listen_to_faults() {
    std::panic::set_hook(Box::new(|said: &PanicHookInfo<'_>| {
        let words = said.to_string();
        // Lost only if the fault is in here.
        let _ = WORDS.try_with(|kept| kept.try_borrow_mut().map(|mut kept| *kept = words));
    }));
}

/// What was said at such an end.
pub(crate) fn last_words() -> String {
    WORDS.with_borrow(String::clone)
}
