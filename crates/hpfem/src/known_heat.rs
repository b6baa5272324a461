//! Temperatures that are known before a body is reduced, on the cells of each class: where they are fewer than the modes on the boundary of a cell, what they do
//! is made at once, else that of each mode.

use crate::body::{Body, Factored};
use crate::cell_heat::{TemperatureCase, Warming};
use crate::congruence::Congruence;
use crate::elimination::Forward;
use faer::Mat;
use std::sync::{Arc, Weak};

/// Known temperatures on the unsigned boundary modes of the cells of a class, a column each, of one member after the other.
pub(crate) struct KnownHeat {
    pub(crate) temperatures: Mat<f64>,
}

/// The temperatures that something was made for.
pub(crate) struct KnownCases {
    cases: Vec<TemperatureCase>,
    factored: Weak<Factored>,
    added: Vec<Weak<Forward>>,
}

impl KnownCases {
    pub(crate) fn new(temperature: &Body, cases: &[TemperatureCase]) -> KnownCases {
        KnownCases {
            cases: cases.to_vec(),
            factored: Arc::downgrade(&temperature.factored),
            added: temperature.added.iter().map(Arc::downgrade).collect(),
        }
    }

    /// Whether these are the temperatures of a body.
    pub(crate) fn are(&self, temperature: &Body, cases: &[TemperatureCase]) -> bool {
        self.factored.as_ptr() == Arc::as_ptr(&temperature.factored)
            && self.added.len() == temperature.added.len()
            && self.added.iter().zip(&temperature.added).all(|(own, other)| own.as_ptr() == Arc::as_ptr(other))
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

impl Warming<'_> {
    /// Known temperatures of each class; none where none are known.
    pub(crate) fn known(&self, congruence: &Congruence, edges: &[[usize; 4]]) -> Option<Vec<KnownHeat>> {
        let many = self.many()?;
        let mut members = vec![Vec::new(); edges.len()];
        congruence.class.iter().enumerate().for_each(|(cell, class)| members[*class].push(cell));
        let of_class = |(members, edges): (Vec<usize>, &[usize; 4])| {
            let modes = self.boundary_modes(members.first().copied(), *edges);
            let mut temperatures = Mat::zeros(modes, members.len() * many);
            for (number, cell) in members.iter().enumerate() {
                let values = self.temperatures(*cell, (*edges, &congruence.turn[*cell]), modes);
                temperatures.get_mut(.., number * many..(number + 1) * many).copy_from(values.transpose());
            }
            KnownHeat { temperatures }
        };
        Some(members.into_iter().zip(edges).map(of_class).collect())
    }
}
