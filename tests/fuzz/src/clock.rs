//! Time that a piece of work takes: of the processor where the system tells it, so that a busy machine makes no input slow.

use std::time::{Duration, Instant};

/// Ticks a second of the times that Linux tells of a process.
const TICKS: u64 = 100;

/// When a piece of work began.
pub(crate) struct Clock {
    wall: Instant,
    processor: Option<Duration>,
}

impl Clock {
    /// Begins now.
    pub(crate) fn start() -> Clock {
        Clock { wall: Instant::now(), processor: processor() }
    }

    /// What it took until now.
    pub(crate) fn took(&self) -> Duration {
        let of_processor = processor().zip(self.processor).map(|(now, before)| now.saturating_sub(before));
        of_processor.unwrap_or_else(|| self.wall.elapsed())
    }
}

/// Time of the processor for this process so far.
fn processor() -> Option<Duration> {
    told("/proc/self/stat")
}

/// Time of the processor in such a file: fields 14 and 15 of the line, of which two end with the name in brackets.
fn told(file: &str) -> Option<Duration> {
    let line = std::fs::read_to_string(file).ok()?;
    let (_, behind) = line.rsplit_once(')')?;
    let ticks: Vec<u64> = behind.split_whitespace().skip(11).take(2).filter_map(|text| text.parse().ok()).collect();
    (ticks.len() == 2).then(|| Duration::from_millis(ticks.iter().sum::<u64>() * 1000 / TICKS))
}

#[cfg(all(test, target_os = "linux"))]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn work_counts_and_waiting_does_not() {
        // Of this thread alone: others work meanwhile.
        let of_thread = || told("/proc/thread-self/stat").unwrap();
        let before = of_thread();
        std::thread::sleep(Duration::from_millis(300));
        let waited = of_thread() - before;
        assert!(waited < Duration::from_millis(150), "{waited:?}");
        let clock = Clock::start();
        while processor().unwrap() < clock.processor.unwrap() + Duration::from_millis(200) {}
        assert!(clock.took() >= Duration::from_millis(200));
    }
}
