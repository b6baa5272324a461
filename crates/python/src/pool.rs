//! Threads of our own. rayon's global pool is not used: a process that was forked, as by Python's `multiprocessing`, has none of the threads of its
//! parent, and waited for those of that pool for ever.

use std::sync::Mutex;

use rayon::{ThreadPool, ThreadPoolBuilder};
use scene::Fault;

/// Stack of a thread that solves: that of a program's main one.
pub(crate) const STACK: usize = 8 << 20;

/// A pool of as many threads as the machine has, which waits for the next call, and the process that it was made in. The lock is never waited for: a
/// process may have been forked while another thread of its parent held it.
static IDLE: Mutex<Option<(u32, ThreadPool)>> = Mutex::new(None);

/// Does work on so many threads, by default as many as the machine has. No other call has these threads meanwhile.
pub(crate) fn within<T: Send>(threads: Option<usize>, work: impl FnOnce() -> Result<T, Fault> + Send) -> Result<T, Fault> {
    let Some(threads) = threads else {
        let pool = idle().map_or_else(|| made(0), Ok)?;
        let found = pool.install(work);
        keep(pool);
        return found;
    };
    made(threads)?.install(work)
}

fn made(threads: usize) -> Result<ThreadPool, Fault> {
    let pool = ThreadPoolBuilder::new().num_threads(threads).stack_size(STACK).build();
    pool.map_err(|error| Fault::new("threads", format!("cannot start the threads: {error}"), "ask for fewer"))
}

/// The pool that waits, if one does.
fn idle() -> Option<ThreadPool> {
    let (process, pool) = IDLE.try_lock().ok()?.take()?;
    if process == std::process::id() {
        return Some(pool);
    }
    // Its threads are those of the parent: nobody is there to be told to end.
    std::mem::forget(pool);
    None
}

/// Keeps one pool for the next call; of calls at the same time the threads of the others end.
fn keep(pool: ThreadPool) {
    if let Ok(mut idle) = IDLE.try_lock() {
        idle.get_or_insert((std::process::id(), pool));
    }
}
