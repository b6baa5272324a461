//! Why a step has no result.

use scene::Fault;

use crate::parts::NO_STIFFNESS;

/// Why a step has no result.
pub(crate) enum Refusal {
    /// The scene has no answer: a sentence for the summary.
    Reason(String),
    /// A level has none that a finer one may have.
    TooCoarse(String),
    /// The user's to mend.
    Fault(Fault),
}

impl From<Fault> for Refusal {
    fn from(fault: Fault) -> Refusal {
        // Nothing in the scene is wrong, and the digits do not suffice: that only elimination tells.
        let body = fault.key.as_deref().filter(|_| fault.code == NO_STIFFNESS).and_then(|key| key.split_once('.'));
        match body {
            Some((body, _)) => Refusal::Reason(format!("{body}: {}; {}", fault.message, fault.remedy)),
            None => Refusal::Fault(fault),
        }
    }
}
