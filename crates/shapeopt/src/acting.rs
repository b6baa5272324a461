//! A load that acts, with the rigid motions of its contact.

use crate::implicit_stage::Load;
use crate::rigid_wear::RigidWear;
use std::sync::Arc;

/// A load with the rigid motions of its contact.
pub(crate) struct Acting<'a> {
    pub(crate) load: Load<'a>,
    pub(crate) rigid: RigidWear,
}

/// The load of a stage while certain points conduct heat.
pub(crate) struct Conducting<'a> {
    pub(crate) stage: usize,
    pub(crate) points: Vec<bool>,
    pub(crate) acting: Arc<Acting<'a>>,
}
