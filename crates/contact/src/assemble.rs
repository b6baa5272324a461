//! From forces and coordinates to a solution: pressures, states of the bodies, resultants, zones.

use crate::coulomb::ContactState;
use crate::ending::Ending;
use crate::operator::{ContactOperator, SIGNS};
use crate::solution::ContactSolution;
use crate::stage::Stage;
use crate::zones::zones;
use hpfem::{InterfaceState, TraceLoad};

impl ContactOperator<'_> {
    /// Puts a solution together from forces and coordinates.
    pub(crate) fn assemble(&self, stage: &Stage<'_>, ending: Ending) -> ContactSolution {
        let n = self.unit.points.len();
        let (force, shear) = (ending.point.force, ending.shear);
        let mut coordinates: Vec<f64> = stage.prescribed.iter().map(|p| p.unwrap_or(0.0)).collect();
        stage.free.iter().zip(&ending.point.coordinates).for_each(|(j, y)| coordinates[*j] = *y);
        let split = self.unit.responses[0].motions.ncols();
        let coordinates = [coordinates[..split].to_vec(), coordinates[split..].to_vec()];
        let (shaped, counter, slip) = self.bodies(stage, [&force, &shear], &coordinates);
        let (resultant, moment) = self.resultants(&force, &shear);
        let closed: Vec<bool> = ending.states.iter().map(|s| *s != ContactState::Open).collect();
        let over_weight = |v: &[f64]| (0..n).map(|i| v[i] / self.unit.points[i].weight).collect::<Vec<f64>>();
        ContactSolution {
            status: ending.status,
            pressure: over_weight(&force),
            shear: over_weight(&shear),
            zones: zones(&self.unit.points, &closed, &force, self.pair.turn()),
            nodal_force: force,
            nodal_shear: shear,
            opening: ending.opening,
            slip,
            closed,
            states: ending.states,
            shaped,
            counter,
            coordinates,
            force: resultant,
            moment,
            complementarity: ending.complementarity,
            balance: ending.balance,
            iterations: ending.iterations,
            took_over: ending.took_over,
            closes_itself: stage.plain.problem.closes_itself(),
        }
    }

    /// States of the shaped body and of the counter-face under nodal forces (normal, tangential) on body 1, and the slip at the points (empty
    /// without shear).
    fn bodies(
        &self,
        stage: &Stage<'_>,
        forces: [&[f64]; 2],
        coordinates: &[Vec<f64>; 2],
    ) -> (InterfaceState, Option<InterfaceState>, Vec<f64>) {
        let n = self.unit.points.len();
        let mut states = Vec::new();
        let mut slip = vec![0.0; if self.unit.shear_influence.is_some() { n } else { 0 }];
        for (b, response) in self.unit.responses.iter().enumerate() {
            let [lambda, sigma] = forces.map(|v| v.iter().map(|v| SIGNS[b] * v).collect::<Vec<f64>>());
            let (all, columns) = stage.factors_under(b, forces[0]);
            let unknowns = response.unknowns(&columns, &lambda, &sigma, &coordinates[b]);
            if let Some(tangential) = &response.tangential {
                let moved = tangential.times(&unknowns);
                (0..n).for_each(|i| slip[i] += SIGNS[b] * (moved[i] + response.constant[1][i]));
            }
            states.push(self.state(b, unknowns, [&lambda, &sigma], &all));
        }
        let counter = if states.len() > 1 { states.pop() } else { None };
        let Some(shaped) = states.pop() else { unreachable!("the shaped body always has a response") };
        (shaped, counter, slip)
    }

    /// Force of the contact on body 1, and its moment about the origin.
    fn resultants(&self, force: &[f64], shear: &[f64]) -> ([f64; 2], f64) {
        let mut resultant = [0.0; 2];
        let mut moment = 0.0;
        for station in &self.unit.stations {
            let (f, x) = (station.force(force, shear), station.point.position);
            resultant[0] += f[0];
            resultant[1] += f[1];
            moment += x[0] * f[1] - x[1] * f[0];
        }
        (resultant, moment)
    }

    /// State of a body under nodal forces on it, with the forces on its rigid edge counted among the loads.
    fn state(&self, body: usize, unknowns: Vec<f64>, forces: [&[f64]; 2], factors: &[f64]) -> InterfaceState {
        let operator = self.operator(body);
        let stiffness = &operator.stiffness;
        let mut load = TraceLoad { unknowns: vec![0.0; unknowns.len()], ..TraceLoad::default() };
        for station in &self.unit.stations {
            operator.trace.add_force(&mut load, station.places[body], station.force(forces[0], forces[1]));
        }
        for q in operator.frame.iter().flatten() {
            let internal: f64 = (0..unknowns.len()).map(|k| stiffness[(*q, k)] * unknowns[k]).sum();
            let condensed: f64 = factors.iter().enumerate().map(|(k, a)| a * operator.columns[(*q, k)]).sum();
            load.unknowns[*q] = internal - condensed;
        }
        InterfaceState { unknowns, factors: factors.to_vec(), load }
    }
}
