//! Temperatures that are known before a body is reduced, and which body they are of.

use crate::elimination::Forward;
use crate::interface::InterfaceState;
use faer::Mat;
use std::sync::{Arc, Weak};

/// A temperature as a load case.
#[derive(Clone, Debug, PartialEq)]
pub struct TemperatureCase {
    /// Name of the load case.
    pub name: String,
    /// State of the body of temperature.
    pub state: InterfaceState,
    /// The temperature without strain.
    pub reference: f64,
}

/// Temperatures on the groups of unknowns of their body, `temperatures x unknowns`.
pub(crate) type OnGroups = Arc<Vec<Mat<f64>>>;

/// What tells a factorised body with its later load cases from all others, and from other clones of it.
#[derive(Clone, Copy)]
pub(crate) struct Own<'a> {
    /// Shared by its clones.
    pub(crate) factors: &'a Arc<()>,
    pub(crate) added: &'a [Arc<Forward>],
}

/// The temperatures that something was made for.
pub(crate) struct KnownHeat {
    cases: Vec<TemperatureCase>,
    factors: Weak<()>,
    added: Vec<Weak<Forward>>,
    pub(crate) values: OnGroups,
}

impl KnownHeat {
    pub(crate) fn new(own: Own<'_>, cases: &[TemperatureCase], values: OnGroups) -> KnownHeat {
        KnownHeat {
            cases: cases.to_vec(),
            factors: Arc::downgrade(own.factors),
            added: own.added.iter().map(Arc::downgrade).collect(),
            values,
        }
    }

    /// Whether these are the temperatures of a body.
    pub(crate) fn are(&self, own: Own<'_>, cases: &[TemperatureCase]) -> bool {
        self.factors.as_ptr() == Arc::as_ptr(own.factors)
            && self.added.len() == own.added.len()
            && self.added.iter().zip(own.added).all(|(known, own)| known.as_ptr() == Arc::as_ptr(own))
            && self.cases == cases
    }
}
