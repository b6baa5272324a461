//! How a contact solve ended.

use std::fmt;

/// How a contact solve ended; `Display` gives the sentence.
#[derive(Clone, Debug, PartialEq)]
pub enum Status {
    /// Part of the candidate surface is in contact, part of it is open.
    Converged,
    /// Every point is in contact.
    ClosedEverywhere,
    /// No point is in contact: the prescribed motions or the load leave the surfaces apart.
    NoContact,
    /// No pressure, however distributed, can balance the load.
    NoBalance,
    /// Friction holds whatever the load presses with: the harder the contact, the more shear resists.
    Jammed,
    /// An equilibrium was found, but at this coefficient of friction it is not the only one.
    NotUnique,
    /// The iteration did not settle.
    IterationLimit {
        /// Number of points with a wrong sign at each step.
        history: Vec<usize>,
    },
}

impl Status {
    /// Whether pressures and displacements satisfy all conditions of contact.
    pub fn is_solved(&self) -> bool {
        matches!(self, Status::Converged | Status::ClosedEverywhere | Status::NoContact | Status::NotUnique)
    }
}

impl fmt::Display for Status {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Status::Converged => f.write_str("the contact is solved: it fills part of the candidate surface"),
            Status::ClosedEverywhere => f.write_str("the contact is solved: the gap is closed everywhere on the candidate surface"),
            Status::NoContact => f.write_str("no contact: the surfaces stay apart everywhere"),
            Status::NoBalance => f.write_str("no balance: no pressure between the surfaces can hold the load; check its direction, its moment, the supports and the friction"),
            Status::Jammed => f.write_str("jammed: friction alone holds the shaped body, the load cannot press it against the counter-face; lower the coefficient of friction"),
            Status::NotUnique => f.write_str("solved, but not unique: at this coefficient of friction other solutions exist; lower it or follow it up from zero"),
            Status::IterationLimit { history } => {
                write!(f, "not converged: points with a wrong sign, step by step: {history:?}")
            }
        }
    }
}
