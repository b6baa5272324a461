//! Progress on a terminal: a bar for work that takes longer than a moment, nothing otherwise.

use std::io::IsTerminal;
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use shapeopt::WearState;

use crate::args::Common;
use crate::print::no_colour;

/// Work shorter than this shows no bar.
const MOMENT: Duration = Duration::from_millis(500);
/// Length of a bar that shows a share.
const SHARES: u64 = 1000;

/// A bar, or none.
pub(crate) struct Progress {
    bar: Option<ProgressBar>,
    start: Instant,
    level: String,
    share: f64,
}

impl Progress {
    /// No bar.
    pub(crate) fn none() -> Progress {
        Progress { bar: None, start: Instant::now(), level: String::new(), share: 0.0 }
    }

    /// A bar that shows a share of the work, where one is wanted.
    pub(crate) fn new(common: &Common) -> Progress {
        Progress { bar: wanted_here(common).then(|| bar(SHARES, "[{bar:30}] {percent}% {msg}")), ..Progress::none() }
    }

    /// A bar that counts, where one is wanted.
    pub(crate) fn counted(common: &Common, count: usize) -> Progress {
        Progress { bar: wanted_here(common).then(|| bar(count as u64, "[{bar:30}] {pos}/{len} {msg}")), ..Progress::none() }
    }

    /// So many of the things that are counted are done.
    pub(crate) fn done(&self, count: usize) {
        self.show(|bar| bar.set_position(count as u64));
    }

    /// Another level of discretisation begins.
    pub(crate) fn level(&mut self, name: &str) {
        self.share = 0.0;
        self.level = name.into();
    }

    /// A run in time has come to a state, this share of its way.
    pub(crate) fn wear(&mut self, state: &WearState, share: f64) {
        self.share = share.clamp(self.share, 1.0);
        self.show(|bar| {
            bar.set_position((self.share * SHARES as f64) as u64);
            bar.set_message(format!("{}, step {}, {:.4e} s", self.level, state.step, state.time));
        });
    }

    /// Takes the bar away.
    pub(crate) fn end(&self) {
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
        }
    }

    fn show(&self, change: impl FnOnce(&ProgressBar)) {
        if let Some(bar) = self.bar.as_ref().filter(|_| self.start.elapsed() >= MOMENT) {
            change(bar);
        }
    }
}

fn bar(length: u64, template: &str) -> ProgressBar {
    let style = ProgressStyle::with_template(template).unwrap_or_else(|_| ProgressStyle::default_bar());
    ProgressBar::with_draw_target(Some(length), ProgressDrawTarget::stderr_with_hz(10)).with_style(style.progress_chars("#> "))
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
}
