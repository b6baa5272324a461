//! wearshape as a WebAssembly module: one function that takes a question as JSON and gives its answer as JSON. The library runs on the thread
//! that calls; the page calls from a worker.
//!
//! The caller asks [`room`] for a place, writes the question there, calls [`ask`], and reads the answer at the place that [`answer`] names.
//! What the module needs from outside are a clock, and somebody to tell how far a solve is (`outside.rs`).

mod check;
mod engine;
mod fault;
mod outside;
mod question;
mod solve;

use std::cell::RefCell;

use engine::Engine;

thread_local! {
    /// A module has one caller, who keeps nothing of ours but addresses.
    static ENGINE: RefCell<Engine> = RefCell::default();
    static TEXTS: RefCell<Texts> = RefCell::default();
}

/// What goes in and out.
#[derive(Default)]
struct Texts {
    question: Vec<u8>,
    answer: Vec<u8>,
}

/// A place for a question of so many bytes.
#[unsafe(no_mangle)]
pub extern "C" fn room(length: usize) -> *mut u8 {
    TEXTS.with_borrow_mut(|texts| {
        texts.question.clear();
        texts.question.resize(length, 0);
        texts.question.as_mut_ptr()
    })
}

/// Answers the question in its place; returns the length of the answer in bytes.
#[unsafe(no_mangle)]
pub extern "C" fn ask() -> usize {
    let question = TEXTS.with_borrow_mut(|texts| std::mem::take(&mut texts.question));
    let answer = ENGINE.with_borrow_mut(|engine| question::answered(engine, &question));
    TEXTS.with_borrow_mut(|texts| {
        texts.answer = answer.to_string().into_bytes();
        texts.answer.len()
    })
}

/// Where the answer stands until the next call.
#[unsafe(no_mangle)]
pub extern "C" fn answer() -> *const u8 {
    TEXTS.with_borrow(|texts| texts.answer.as_ptr())
}

/// Length of what the module said when it ended by a fault of its own, which stands where [`answer`] says.
#[unsafe(no_mangle)]
pub extern "C" fn last_words() -> usize {
    let words = outside::last_words();
    TEXTS.with_borrow_mut(|texts| {
        texts.answer = words.into_bytes();
        texts.answer.len()
    })
}
