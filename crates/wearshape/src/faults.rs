//! The errors of the crates below in the user's words.

use meshing::{AXIS, CONTACT, Couple, LOAD};
use scene::Fault;
use wear::WearError;

/// A fault with the edges of the meshes in the names of the scene.
pub(crate) fn in_names_of(couple: Option<&Couple>, mut fault: Fault) -> Fault {
    let Some(couple) = couple else { return fault };
    let first = !fault.key.as_deref().is_some_and(|key| key.starts_with("body2"));
    let contact = &couple.bodies[usize::from(!first)].contact;
    for (inner, name) in [(CONTACT, contact.as_str()), (LOAD, &couple.load.edge), (AXIS, "the axis")] {
        fault.message = fault.message.replace(inner, name);
    }
    fault
}

/// What is wrong with wear factors.
pub(crate) fn wrong_wear(error: &WearError) -> Fault {
    Fault::at("wear", "wrong-value", error.to_string(), "mend the numbers in the message")
}

/// A friction that edges refuse.
pub(crate) fn wrong_friction(error: hpfem::Error) -> Fault {
    Fault::at("contact.friction", "wrong-value", error.to_string(), "give a finite friction")
}

/// A contact that its own solver refuses.
pub(crate) fn unsolved(error: contact::Error) -> Fault {
    Fault::at("contact", "no-contact", error.to_string(), "check the contact and its load")
}
