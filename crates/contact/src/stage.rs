//! From a gap and a load to the complementarity problem.

use crate::error::Error;
use crate::lcp::{Complementarity, Point};
use crate::load::{ContactLoad, Friction, MomentBalance, Motion};
use crate::operator::{ContactOperator, SIGNS};
use crate::products::times;
use crate::solution::ContactSolution;
use faer::{Mat, Side};
use std::borrow::Cow;

/// A load brought to the form of the complementarity problem.
pub(crate) struct Stage<'m> {
    pub(crate) problem: Complementarity<'m>,
    /// All factors of each body, and those of load cases and prescribed displacements.
    pub(crate) factors: Vec<(Vec<f64>, Vec<f64>)>,
    pub(crate) slide: Vec<f64>,
    /// Slip of the unloaded contact.
    pub(crate) slip: Vec<f64>,
    /// Slip by the free coordinates.
    pub(crate) sliding: Option<Mat<f64>>,
    pub(crate) prescribed: Vec<Option<f64>>,
    pub(crate) free: Vec<usize>,
}

impl Stage<'_> {
    /// The problem without shear; motions that only shear resists are held by a spring.
    pub(crate) fn without_shear(&self) -> Complementarity<'_> {
        let problem = &self.problem;
        let mut stiffness = problem.stiffness.clone();
        pin_idle_motions(&problem.influence, None, &mut stiffness, &problem.compliance);
        Complementarity {
            compliance: Cow::Borrowed(&*problem.compliance),
            influence: problem.influence.clone(),
            balance: problem.influence.clone(),
            stiffness,
            opening: problem.opening.clone(),
            load: problem.load.clone(),
            symmetric: true,
        }
    }

    /// Starting point from an earlier solution.
    pub(crate) fn start(&self, solution: &ContactSolution) -> Point {
        let all: Vec<f64> = solution.coordinates.iter().flatten().copied().collect();
        Point { force: solution.nodal_force.clone(), coordinates: self.free.iter().map(|j| all[*j]).collect() }
    }
}

/// What the load factors and prescribed motions do before any contact force acts.
struct Unloaded {
    /// Opening and slip at the points.
    opening: Vec<f64>,
    slip: Vec<f64>,
    /// Resultant along every coordinate.
    rows: Vec<f64>,
    /// All factors of each body, and those of load cases and prescribed displacements.
    factors: Vec<(Vec<f64>, Vec<f64>)>,
}

impl ContactOperator<'_> {
    /// The complementarity problem of a gap and a load.
    pub(crate) fn stage(&self, gap: &[f64], load: &ContactLoad) -> Result<Stage<'_>, Error> {
        let n = self.unit.points.len();
        let mut unloaded = self.unloaded(gap, load)?;
        let (slide, friction_active) = self.slide(load)?;
        let (compliance, balance) = self.sliding(load, &slide, friction_active);
        let (stiffness, prescribed) = self.held(load, &mut unloaded.rows);
        let free: Vec<usize> = (0..prescribed.len()).filter(|j| prescribed[*j].is_none()).collect();
        self.move_prescribed(&mut unloaded, &stiffness, &prescribed, &free);
        let Unloaded { opening, slip, rows, factors } = unloaded;
        let pick = |m: &Mat<f64>| Mat::from_fn(n, free.len(), |i, j| m[(i, free[j])]);
        let (influence, balance) = (pick(&self.unit.influence), pick(&balance));
        let sliding = self.unit.shear_influence.as_ref().map(pick);
        let mut stiffness = Mat::from_fn(free.len(), free.len(), |i, j| stiffness[(free[i], free[j])]);
        let held_by_shear = sliding.as_ref().filter(|_| matches!(load.friction, Friction::Coulomb { .. }));
        pin_idle_motions(&influence, held_by_shear, &mut stiffness, &self.unit.normal);
        let problem = Complementarity {
            compliance,
            influence,
            balance,
            stiffness,
            opening,
            load: free.iter().map(|j| rows[*j]).collect(),
            symmetric: !friction_active,
        };
        Ok(Stage { problem, factors, slide, slip, sliding, prescribed, free })
    }

    /// Both bodies under the load factors, from the gap.
    fn unloaded(&self, gap: &[f64], load: &ContactLoad) -> Result<Unloaded, Error> {
        let n = self.unit.points.len();
        if gap.len() != n || gap.iter().any(|g| !g.is_finite()) {
            return Err(Error::Gap { given: gap.len(), points: n });
        }
        let (mut opening, mut slip) = (gap.to_vec(), vec![0.0; n]);
        let (mut rows, mut factors) = (Vec::new(), Vec::new());
        for (b, response) in self.unit.responses.iter().enumerate() {
            let operator = self.operator(b);
            if load.factors[b].len() != operator.load_cases.len() || load.factors[b].iter().any(|a| !a.is_finite()) {
                return Err(Error::Factors { body: b + 1, given: load.factors[b].len(), cases: operator.load_cases.len() });
            }
            let all = operator.factors_in_order(&load.factors[b]);
            let columns = all[..=operator.prescribed_column()].to_vec();
            let u = times(&response.to_columns, &columns);
            let displaced = times(&response.normal, &u);
            (0..n).for_each(|i| opening[i] += SIGNS[b] * (displaced[i] + response.constant[0][i]));
            if let Some(tangential) = &response.tangential {
                let displaced = times(tangential, &u);
                (0..n).for_each(|i| slip[i] += SIGNS[b] * (displaced[i] + response.constant[1][i]));
            }
            rows.extend(times(&response.motion_columns, &columns));
            factors.push((all, columns));
        }
        Ok(Unloaded { opening, slip, rows, factors })
    }

    /// Compliance and balance with the shear of steady sliding in them.
    fn sliding(&self, load: &ContactLoad, slide: &[f64], friction_active: bool) -> (Cow<'_, Mat<f64>>, Mat<f64>) {
        let (n, unit) = (self.unit.points.len(), &*self.unit);
        let mut compliance = Cow::Borrowed(&unit.normal);
        let mut balance = unit.influence.clone();
        if let (true, Some(by_shear), Some(shear)) = (friction_active, &unit.normal_by_shear, &unit.shear_influence) {
            compliance = Cow::Owned(Mat::from_fn(n, n, |i, j| unit.normal[(i, j)] + by_shear[(i, j)] * slide[j]));
            for j in 0..balance.ncols() {
                let rotation = self.edge_motion(j) == Some(2);
                if !(rotation && load.moment == MomentBalance::Pressure) {
                    (0..n).for_each(|i| balance[(i, j)] += slide[i] * shear[(i, j)]);
                }
            }
        }
        (compliance, balance)
    }

    /// Stiffness of all coordinates and their prescribed values; resultants and springs of the rigid edge add to the rows.
    fn held(&self, load: &ContactLoad, rows: &mut [f64]) -> (Mat<f64>, Vec<Option<f64>>) {
        let total = rows.len();
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
            match load.motions[k] {
                Motion::Free { resultant } => rows[j] += resultant,
                Motion::Prescribed { value } => prescribed[j] = Some(value),
                Motion::Sprung { stiffness: spring, rest } => {
                    stiffness[(j, j)] += spring;
                    rows[j] += spring * rest;
                }
            }
        }
        (stiffness, prescribed)
    }

    /// Opening, slip and resultants of the free coordinates by the prescribed motions.
    fn move_prescribed(&self, unloaded: &mut Unloaded, stiffness: &Mat<f64>, prescribed: &[Option<f64>], free: &[usize]) {
        let n = self.unit.points.len();
        for (j, value) in prescribed.iter().enumerate().filter_map(|(j, v)| v.map(|v| (j, v))) {
            (0..n).for_each(|i| unloaded.opening[i] += self.unit.influence[(i, j)] * value);
            if let Some(shear) = &self.unit.shear_influence {
                (0..n).for_each(|i| unloaded.slip[i] += shear[(i, j)] * value);
            }
            free.iter().for_each(|i| unloaded.rows[*i] -= stiffness[(*i, j)] * value);
        }
    }

    /// Shear per normal force at each point, and whether there is any.
    pub(crate) fn slide(&self, load: &ContactLoad) -> Result<(Vec<f64>, bool), Error> {
        let n = self.unit.points.len();
        let Friction::Sliding { coefficient, drag } = &load.friction else { return Ok((vec![0.0; n], false)) };
        let sound = *coefficient >= 0.0 && coefficient.is_finite() && drag.len() == n && drag.iter().all(|d| d.abs() <= 1.0);
        if !sound {
            return Err(Error::Drag { coefficient: *coefficient, given: drag.len(), points: n });
        }
        let slide: Vec<f64> = drag.iter().map(|d| coefficient * d).collect();
        let active = slide.iter().any(|s| *s != 0.0);
        if active && self.unit.normal_by_shear.is_none() {
            return Err(Error::ShearNotPrepared);
        }
        Ok((slide, active))
    }
}

/// Rigid motions without any normal trace (an arc turning about its centre) would make the problem singular: a spring holds them, which
/// carries nothing if the load has no part along them.
fn pin_idle_motions(influence: &Mat<f64>, held_by_shear: Option<&Mat<f64>>, stiffness: &mut Mat<f64>, compliance: &Mat<f64>) {
    let shear = |k: usize, i: usize| held_by_shear.map_or(0.0, |s| s[(k, i)]);
    let (n, m) = (influence.nrows(), influence.ncols());
    if m == 0 || n == 0 {
        return;
    }
    let scale: Vec<f64> =
        (0..m).map(|j| (0..n).map(|i| influence[(i, j)].abs().max(shear(i, j).abs())).fold(0.0, f64::max)).collect();
    let typical = (0..n).map(|i| compliance[(i, i)]).fold(0.0, f64::max);
    let unit: Vec<f64> = scale.iter().map(|s| if *s > 0.0 { *s } else { 1.0 }).collect();
    let gram = Mat::from_fn(m, m, |i, j| {
        let product: f64 =
            (0..n).map(|k| (influence[(k, i)] * influence[(k, j)] + shear(k, i) * shear(k, j)) / unit[i] / unit[j]).sum();
        product + stiffness[(i, j)] * typical / (unit[i] * unit[j])
    });
    let Ok(eigen) = gram.self_adjoint_eigen(Side::Lower) else { return };
    for k in 0..m {
        if eigen.S()[k] > 1e-18 * n as f64 {
            continue;
        }
        for i in 0..m {
            for j in 0..m {
                stiffness[(i, j)] += eigen.U()[(i, k)] * eigen.U()[(j, k)] * unit[i] * unit[j] / typical;
            }
        }
    }
}
