//! How a call ends.

use std::process::ExitCode;

use wearshape::Status;

/// End of a call, with the number the shell sees.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Exit {
    /// 0: done.
    Done,
    /// 1: computed, but the goal is not met (not converged, accuracy missed, no answer).
    GoalMissed,
    /// 2: wrong command, invalid scene, or a file that cannot be read or written.
    Wrong,
    /// 130: interrupted, resumable.
    Interrupted,
}

impl Exit {
    /// The end of a run with this status.
    pub(crate) fn of(status: Status) -> Exit {
        match status {
            Status::Ok => Exit::Done,
            Status::AccuracyMissed | Status::NotConverged | Status::Refused => Exit::GoalMissed,
            Status::Interrupted => Exit::Interrupted,
        }
    }

    /// The number.
    pub fn code(self) -> u8 {
        match self {
            Exit::Done => 0,
            Exit::GoalMissed => 1,
            Exit::Wrong => 2,
            Exit::Interrupted => 130,
        }
    }
}

impl From<Exit> for ExitCode {
    fn from(exit: Exit) -> ExitCode {
        ExitCode::from(exit.code())
    }
}
