//! The clock of the program: the library has none.

use std::sync::LazyLock;
use std::time::Instant;

static START: LazyLock<Instant> = LazyLock::new(Instant::now);

/// Seconds since the first call.
pub(crate) fn seconds() -> f64 {
    START.elapsed().as_secs_f64()
}
