//! Progress on a terminal: a bar for work that takes longer than a moment, nothing otherwise.

use std::io::IsTerminal;
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use report::{Track, step_words};
use wearshape::{Event, Problem, Step};

use crate::args::Common;
use crate::print::no_colour;

/// Work shorter than this shows no bar.
const MOMENT: Duration = Duration::from_millis(500);
/// Time between two drawings: the seconds go on while one factorisation does.
const TICK: Duration = Duration::from_millis(200);
/// Length of a bar that shows a share.
const SHARES: u64 = 1000;

/// Lines of work whose length is not known, of a share, and of things that are counted.
const BUSY: &str = "{spinner} {elapsed:>3}  {wide_msg}";
const SHARE: &str = "[{bar:14}] {percent:>3}% {elapsed:>4}  {wide_msg}";
const COUNT: &str = "[{bar:20}] {pos}/{len} {elapsed:>4}  {wide_msg}";

/// A bar, or none.
pub(crate) struct Progress {
    bar: Option<ProgressBar>,
    start: Instant,
    track: Mutex<Track>,
}

impl Progress {
    /// No bar.
    pub(crate) fn none() -> Progress {
        Progress::with(None)
    }

    fn with(bar: Option<ProgressBar>) -> Progress {
        Progress { bar, start: Instant::now(), track: Mutex::default() }
    }

    /// A line that says what is done, where one is wanted.
    pub(crate) fn new(common: &Common) -> Progress {
        Progress::with(wanted_here(common).then(|| bar(SHARES, BUSY)))
    }

    /// A bar that counts, where one is wanted.
    pub(crate) fn counted(common: &Common, count: usize) -> Progress {
        Progress::with(wanted_here(common).then(|| bar(count as u64, COUNT)))
    }

    /// Says what is done.
    pub(crate) fn say(&self, what: &str) {
        self.show(|bar| bar.set_message(what.to_string()));
    }

    /// So many of the things that are counted are done.
    pub(crate) fn done(&self, count: usize) {
        self.show(|bar| bar.set_position(count as u64));
    }

    /// From here on the bar shows the share of a run.
    pub(crate) fn run(&self, problem: &Problem) {
        *self.track() = Track::of(problem);
        self.show(|bar| bar.set_style(style(SHARE)));
    }

    /// Something happened in a run.
    pub(crate) fn see(&self, event: &Event<'_>) {
        self.track().see(event);
        self.draw();
    }

    /// A part of the work of a run begins.
    pub(crate) fn part(&self, step: Step) {
        self.track().part(step);
        self.draw();
    }

    /// A part of work of unknown length begins.
    pub(crate) fn busy(&self, step: Step) {
        self.say(step_words(step));
    }

    /// Prints beside the bar.
    pub(crate) fn beside<T>(&self, print: impl FnOnce() -> T) -> T {
        match &self.bar {
            Some(bar) => bar.suspend(print),
            None => print(),
        }
    }

    /// Takes the bar away.
    pub(crate) fn end(&self) {
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
        }
    }

    fn draw(&self) {
        self.show(|bar| {
            let track = self.track();
            bar.set_position((track.share() * SHARES as f64) as u64);
            let left = track.left(self.start.elapsed().as_secs_f64());
            let left = left.map_or(String::new(), |left| format!("about {} left, ", span(left)));
            bar.set_message(left + &track.words());
        });
    }

    /// A panic elsewhere is reported there.
    fn track(&self) -> MutexGuard<'_, Track> {
        self.track.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn show(&self, change: impl FnOnce(&ProgressBar)) {
        if let Some(bar) = &self.bar {
            change(bar);
        }
    }
}

impl Drop for Progress {
    /// What is said of a fault stands in a line of its own.
    fn drop(&mut self) {
        self.end();
    }
}

/// Seconds in the unit that fits.
fn span(seconds: f64) -> String {
    match seconds {
        s if s < 90.0 => format!("{s:.0} s"),
        s if s < 5400.0 => format!("{:.0} min", s / 60.0),
        s => format!("{:.1} h", s / 3600.0),
    }
}

/// A bar that comes after a moment and is drawn again and again, whatever the work does.
fn bar(length: u64, template: &str) -> ProgressBar {
    let bar = ProgressBar::with_draw_target(Some(length), ProgressDrawTarget::hidden()).with_style(style(template));
    let shown = bar.clone();
    std::thread::spawn(move || {
        std::thread::sleep(MOMENT);
        if !shown.is_finished() {
            shown.set_draw_target(ProgressDrawTarget::stderr_with_hz(10));
            shown.enable_steady_tick(TICK);
        }
    });
    bar
}

fn style(template: &str) -> ProgressStyle {
    ProgressStyle::with_template(template)
        .unwrap_or_else(|_| ProgressStyle::default_bar())
        .progress_chars("#> ")
        .tick_chars("|/-\\ ")
}

fn wanted_here(common: &Common) -> bool {
    wanted(common, std::io::stderr().is_terminal(), no_colour())
}

/// Bars are for a terminal whose user wants them.
fn wanted(common: &Common, terminal: bool, plain: bool) -> bool {
    terminal && !plain && !common.quiet && !common.no_progress && !common.json
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_bar_is_shown_on_a_terminal_alone_and_only_when_wanted() {
        let common = Common::default();
        assert!(wanted(&common, true, false));
        assert!(!wanted(&common, false, false) && !wanted(&common, true, true));
        assert!(!wanted(&Common { quiet: true, ..Common::default() }, true, false));
        assert!(!wanted(&Common { no_progress: true, ..Common::default() }, true, false));
    }

    #[test]
    fn the_time_left_has_a_unit_that_fits() {
        assert_eq!([12.4, 100.0, 7200.0].map(span), ["12 s", "2 min", "2.0 h"]);
    }
}
