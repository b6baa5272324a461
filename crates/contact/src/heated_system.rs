//! A contact whose frictional heat follows the pressure, as plain numbers: a [`ContactSystem`] for each set of points that conduct.
//!
//! With the frictional heat `g = rate f` of nodal normal forces `f` the bodies take `q_i = S_i g + s_i` ([`share_heat`]), and heat `q_i` opens the points by
//! `H_i q_i` and pushes along the coordinates by `F_i^T q_i`: `A = A_cold + sum H_i S_i rate`, `opening = opening_cold + sum H_i s_i`.

use crate::error::Error;
use crate::heat::{HeatSplit, HeatedSurface, SharedHeat, share_heat};
use crate::load::ContactLoad;
use crate::operator::ContactOperator;
use crate::products::{add, times, transposed_times};
use crate::system::ContactSystem;
use faer::Mat;

/// How the frictional heat at the points is made and shared.
#[derive(Clone, Debug)]
pub struct HeatExchange {
    /// Temperatures of the surfaces of body 1 and 2.
    pub surfaces: [HeatedSurface; 2],
    /// Areas of the points (mm^2).
    pub weights: Vec<f64>,
    /// Frictional heat by a unit normal force at each point, coefficient of friction times sliding speed (mm/s).
    pub rates: Vec<f64>,
    /// What decides how much goes into each body.
    pub split: HeatSplit,
}

/// A contact with frictional heat, for any set of points that conduct.
#[derive(Clone, Debug)]
pub struct HeatedSystem {
    /// With what flows where no point conducts and nothing rubs.
    cold: ContactSystem,
    /// What a unit of heat into each body at each point does; none of a body that heat does not distort.
    by_heat: [Option<ByHeat>; 2],
    exchange: HeatExchange,
}

/// What a unit of heat into a body at each point does.
#[derive(Clone, Debug)]
struct ByHeat {
    /// Opening, `points x points`.
    opening: Mat<f64>,
    /// Force along the free coordinates, `points x coordinates`.
    forces: Mat<f64>,
}

impl HeatExchange {
    /// Frictional heat at the points (mW) by the normal forces there.
    pub fn friction(&self, forces: &[f64]) -> Vec<f64> {
        self.rates.iter().zip(forces).map(|(rate, force)| rate * force.max(0.0)).collect()
    }

    /// How heat goes into the bodies where the closed points conduct.
    ///
    /// # Errors
    /// As [`share_heat`].
    pub fn shared(&self, closed: &[bool]) -> Result<SharedHeat, Error> {
        let [first, second] = &self.surfaces;
        share_heat([first, second], &self.weights, closed, self.split)
    }
}

impl HeatedSystem {
    /// How the heat is made and shared.
    pub fn exchange(&self) -> &HeatExchange {
        &self.exchange
    }

    /// Whether it matters what points are in contact: by a share the heat goes everywhere alike.
    pub fn conducts(&self) -> bool {
        matches!(self.exchange.split, HeatSplit::Conductance(conductance) if conductance > 0.0)
    }

    /// The system where the closed points conduct.
    ///
    /// # Errors
    /// As [`share_heat`].
    pub fn on(&self, closed: &[bool]) -> Result<ContactSystem, Error> {
        let shared = self.exchange.shared(closed)?;
        let mut system = self.cold.clone();
        system.symmetric = false;
        let rates = &self.exchange.rates;
        for (body, by_heat) in self.by_heat.iter().enumerate() {
            let Some(ByHeat { opening, forces }) = by_heat else { continue };
            let into = &shared.into[body];
            let by_force = Mat::from_fn(into.nrows(), into.ncols(), |i, j| into[(i, j)] * rates[j]);
            system.compliance += opening * &by_force;
            system.balance += by_force.transpose() * forces;
            add(&mut system.opening, &times(opening, &shared.still[body]));
            add(&mut system.load, &transposed_times(forces, &shared.still[body]));
        }
        Ok(system)
    }
}

impl ContactOperator<'_> {
    /// The contact of a load with frictional heat: `load` holds what acts without any heat at the contact, `by_heat` what a unit of heat into each body at
    /// each point adds to the factors of its load cases, `cases x points`; none of a body that heat does not distort.
    ///
    /// # Errors
    /// As [`ContactOperator::solve`]; [`Error::Shape`] and [`Error::NotFinite`] of `by_heat`.
    pub fn heated_system(
        &self,
        load: &ContactLoad,
        by_heat: [Option<Mat<f64>>; 2],
        exchange: HeatExchange,
    ) -> Result<HeatedSystem, Error> {
        let without = ContactLoad { following: [None, None], ..load.clone() };
        let gap = vec![0.0; self.points().len()];
        let stage = self.stage(&gap, &without)?;
        let free = stage.free.clone();
        let cold = ContactSystem::of(stage.plain.problem);
        let [first, second] = by_heat;
        let of = |following: [Option<Mat<f64>>; 2]| -> Result<Option<ByHeat>, Error> {
            let followed = self.followed(&ContactLoad { following, ..without.clone() })?;
            let forces = |all: &Mat<f64>| Mat::from_fn(all.nrows(), free.len(), |i, j| all[(i, free[j])]);
            Ok(followed.map(|followed| ByHeat { forces: forces(&followed.forces), opening: followed.opening }))
        };
        Ok(HeatedSystem { cold, by_heat: [of([first, None])?, of([None, second])?], exchange })
    }
}
