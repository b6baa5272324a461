//! Temperatures that are known before a body is reduced, on the cells of each class: where they are fewer than the modes on the boundary of a cell, what they do
//! is made at once, else that of each mode.

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

/// Known temperatures on the unsigned boundary modes of the cells of a class, a column each, of one member after the other.
pub(crate) struct KnownHeat {
    pub(crate) temperatures: Mat<f64>,
}

/// What tells a factorised body with its later load cases from all others, and from other clones of it.
#[derive(Clone, Copy)]
pub(crate) struct Own<'a> {
    /// Shared by its clones.
    pub(crate) factors: &'a Arc<()>,
    pub(crate) added: &'a [Arc<Forward>],
}

/// The temperatures that something was made for.
pub(crate) struct KnownCases {
    cases: Vec<TemperatureCase>,
    factors: Weak<()>,
    added: Vec<Weak<Forward>>,
}

impl KnownCases {
    pub(crate) fn new(own: Own<'_>, cases: &[TemperatureCase]) -> KnownCases {
        KnownCases {
            cases: cases.to_vec(),
            factors: Arc::downgrade(own.factors),
            added: own.added.iter().map(Arc::downgrade).collect(),
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

impl KnownHeat {
    /// The temperatures, where they are fewer than the modes.
    pub(crate) fn few(&self) -> Option<&Mat<f64>> {
        Some(&self.temperatures).filter(|all| all.ncols() < all.nrows())
    }

    /// What the temperatures of a member of the class, so many, do, a row each, by the loads of the class: of all its temperatures, or of each mode.
    pub(crate) fn of_member(&self, member: usize, many: usize, loads: &Mat<f64>) -> Mat<f64> {
        let own = member * many..(member + 1) * many;
        match self.few() {
            Some(_) => loads.get(.., own).transpose().to_owned(),
            None => self.temperatures.get(.., own).transpose() * loads.transpose(),
        }
    }
}
