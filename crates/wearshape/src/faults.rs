//! The errors of the crates below in the user's words.

use scene::Fault;
use wear::WearError;

/// What is wrong with wear factors.
pub(crate) fn wrong_wear(error: &WearError) -> Fault {
    Fault::at("wear", "wrong-value", error.to_string(), "mend the numbers in the message")
}

/// A contact that its own solver refuses.
pub(crate) fn unsolved(error: contact::Error) -> Fault {
    Fault::at("contact", "no-contact", error.to_string(), "check the contact and its load")
}
