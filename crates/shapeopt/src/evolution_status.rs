//! How a run in time stands.

use std::fmt;

/// How a run stands.
#[derive(Clone, Debug, PartialEq)]
pub enum EvolutionStatus {
    /// More steps follow.
    Running,
    /// The wear is a rigid motion: the shape no longer changes.
    Steady,
    /// The end time is reached.
    TimeReached,
    /// The depth or volume wanted is worn off.
    WornOff,
    /// Frictional heat lets a deviation of the pressure grow faster than wear takes it off, or the contact jumps again and again.
    Unstable {
        /// Time at which the contact came to it.
        time: f64,
    },
    /// Nothing wears any more before the depth or volume wanted is worn off.
    Unreached {
        /// Time from which nothing wears.
        time: f64,
    },
    /// No step, however short, could be solved.
    Stuck {
        /// Time at which the run stopped.
        time: f64,
        /// Length of the step that failed.
        step: f64,
    },
}

impl fmt::Display for EvolutionStatus {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            EvolutionStatus::Running => f.write_str("the run goes on"),
            EvolutionStatus::Steady => f.write_str("steady: the worn surfaces recede as rigid bodies and keep their shape"),
            EvolutionStatus::TimeReached => f.write_str("the end time is reached"),
            EvolutionStatus::WornOff => f.write_str("what was to be worn off is worn off"),
            EvolutionStatus::Unstable { time } => {
                write!(
                    f,
                    "thermoelastic instability: at {} s frictional heat lets a deviation of the pressure grow instead of wearing off, \
                     so that the contact jumps from one place to another; slide more slowly, or begin with a gap nearer to the steady shape",
                    readable(*time)
                )
            }
            EvolutionStatus::Unreached { time } => {
                write!(
                    f,
                    "from {} s on nothing wears, so that the depth or volume to be worn off is never reached; \
                     end the run at a time, or let the bodies wear, slide and press on each other",
                    readable(*time)
                )
            }
            EvolutionStatus::Stuck { time, step } => {
                write!(
                    f,
                    "not converged: at {} s even a step of {step:.3e} s has no solution; the load may have lost its contact",
                    readable(*time)
                )
            }
        }
    }
}

/// The number of four digits next to another one, which is read as it is written.
fn readable(value: f64) -> f64 {
    format!("{value:.3e}").parse().unwrap_or(value)
}
