//! From bodies, a gap and a load to plain numbers.

use crate::ending::Warm;
use crate::error::Error;
use crate::lcp::Point;
use crate::load::{ContactLoad, MomentBalance, Motion};
use crate::operator::{ContactOperator, SIGNS};
use crate::plain::{Held, Plain, Unloaded};
use crate::products::times;
use crate::solution::ContactSolution;
use faer::Mat;

/// Load factors of one body: all of them, and those of load cases and prescribed displacements.
type Factors = (Vec<f64>, Vec<f64>);

/// A load brought to plain numbers, and what leads back to the bodies.
pub(crate) struct Stage<'m> {
    pub(crate) plain: Plain<'m>,
    /// Of each body.
    pub(crate) factors: Vec<Factors>,
    pub(crate) prescribed: Vec<Option<f64>>,
    pub(crate) free: Vec<usize>,
    /// Factors that follow the nodal normal forces, of each body.
    pub(crate) following: [Option<Mat<f64>>; 2],
}

/// What a gap and a load do without contact, in all coordinates.
pub(crate) struct Acting {
    pub(crate) unloaded: Unloaded,
    pub(crate) held: Held,
    pub(crate) factors: Vec<Factors>,
    pub(crate) prescribed: Vec<Option<f64>>,
}

impl Stage<'_> {
    /// Load factors of a body under nodal normal forces: all of them, and those of load cases and prescribed displacements.
    pub(crate) fn factors_under(&self, body: usize, force: &[f64]) -> Factors {
        let (mut all, mut columns) = self.factors[body].clone();
        if let Some(following) = &self.following[body] {
            for (k, more) in times(following, force).into_iter().enumerate() {
                all[k] += more;
                columns[k] += more;
            }
        }
        (all, columns)
    }

    /// Start from an earlier solution at so many points.
    pub(crate) fn warm<'s>(&self, solution: &'s ContactSolution, points: usize) -> Result<Warm<'s>, Error> {
        let ContactSolution { nodal_force, nodal_shear, closed, states, .. } = solution;
        let all: Vec<f64> = solution.coordinates.iter().flatten().copied().collect();
        let point = Point { force: nodal_force.clone(), coordinates: all };
        let mut warm = Warm { point, shear: nodal_shear, closed, states }.fitting(points, self.prescribed.len())?;
        warm.point.coordinates = self.free.iter().map(|j| warm.point.coordinates[*j]).collect();
        Ok(warm)
    }
}

impl ContactOperator<'_> {
    /// The plain problem of a gap and a load.
    pub(crate) fn stage(&self, gap: &[f64], load: &ContactLoad) -> Result<Stage<'_>, Error> {
        let Acting { unloaded, held, factors, prescribed } = self.acting(gap, load)?;
        let mut plain = Plain::new(self.unit.matrices(), &load.friction, unloaded, &held)?;
        if let Some(followed) = self.followed(load)? {
            plain.follow(&followed, &held.free);
        }
        Ok(Stage { plain, factors, prescribed, free: held.free, following: load.following.clone() })
    }

    /// What a gap and a load do without contact.
    pub(crate) fn acting(&self, gap: &[f64], load: &ContactLoad) -> Result<Acting, Error> {
        let (mut unloaded, factors) = self.unloaded(gap, load)?;
        let (stiffness, prescribed) = self.held(load, &mut unloaded.forces)?;
        let free: Vec<usize> = (0..prescribed.len()).filter(|j| prescribed[*j].is_none()).collect();
        self.move_prescribed(&mut unloaded, &stiffness, &prescribed, &free);
        let by_pressure = load.moment == MomentBalance::Pressure;
        let guided = (0..prescribed.len()).map(|j| by_pressure && self.edge_motion(j) == Some(2)).collect();
        Ok(Acting { unloaded, held: Held { stiffness, free, guided }, factors, prescribed })
    }

    /// Both bodies under the load factors, from the gap.
    fn unloaded(&self, gap: &[f64], load: &ContactLoad) -> Result<(Unloaded, Vec<Factors>), Error> {
        let n = self.unit.points.len();
        if gap.len() != n || gap.iter().any(|g| !g.is_finite()) {
            return Err(Error::Gap { given: gap.len(), points: n });
        }
        let (mut opening, mut slip) = (gap.to_vec(), vec![0.0; n]);
        let (mut forces, mut factors) = (Vec::new(), Vec::new());
        for (b, response) in self.unit.responses.iter().enumerate() {
            let operator = self.operator(b);
            if load.factors[b].len() != operator.load_cases.len() || load.factors[b].iter().any(|a| !a.is_finite()) {
                return Err(Error::Factors { body: b + 1, given: load.factors[b].len(), cases: operator.load_cases.len() });
            }
            let all = operator.factors_in_order(&load.factors[b]);
            let columns = all[..=operator.prescribed_column()].to_vec();
            let u = times(&response.to_columns, &columns);
            let displaced = response.normal.times(&u);
            (0..n).for_each(|i| opening[i] += SIGNS[b] * (displaced[i] + response.constant[0][i]));
            if let Some(tangential) = &response.tangential {
                let displaced = tangential.times(&u);
                (0..n).for_each(|i| slip[i] += SIGNS[b] * (displaced[i] + response.constant[1][i]));
            }
            forces.extend(times(&response.motion_columns, &columns));
            factors.push((all, columns));
        }
        Ok((Unloaded { opening, slip, forces }, factors))
    }

    /// Stiffness of all coordinates and their prescribed values; resultants and springs of the rigid edge add to the forces.
    fn held(&self, load: &ContactLoad, forces: &mut [f64]) -> Result<(Mat<f64>, Vec<Option<f64>>), Error> {
        let total = forces.len();
        let mut stiffness = Mat::zeros(total, total);
        let mut offset = 0;
        for r in &self.unit.responses {
            let m = r.stiffness.ncols();
            (0..m).for_each(|i| (0..m).for_each(|j| stiffness[(offset + i, offset + j)] = r.stiffness[(i, j)]));
            offset += m;
        }
        let mut prescribed = vec![None; total];
        for j in 0..total {
            let Some(k) = self.edge_motion(j) else { continue };
            if !load.motions[k].is_finite() {
                return Err(Error::NotFinite { name: "motion of the rigid edge", row: k, column: 0 });
            }
            match load.motions[k] {
                Motion::Free { resultant } => forces[j] += resultant,
                Motion::Prescribed { value } => prescribed[j] = Some(value),
                Motion::Sprung { stiffness: spring, rest } => {
                    stiffness[(j, j)] += spring;
                    forces[j] += spring * rest;
                }
            }
        }
        Ok((stiffness, prescribed))
    }

    /// Opening, slip and resultants of the free coordinates by the prescribed motions.
    fn move_prescribed(&self, unloaded: &mut Unloaded, stiffness: &Mat<f64>, prescribed: &[Option<f64>], free: &[usize]) {
        let n = self.unit.points.len();
        for (j, value) in prescribed.iter().enumerate().filter_map(|(j, v)| v.map(|v| (j, v))) {
            (0..n).for_each(|i| unloaded.opening[i] += self.unit.influence[(i, j)] * value);
            if let Some(shear) = &self.unit.shear_influence {
                (0..n).for_each(|i| unloaded.slip[i] += shear[(i, j)] * value);
            }
            free.iter().for_each(|i| unloaded.forces[*i] -= stiffness[(*i, j)] * value);
        }
    }
}
