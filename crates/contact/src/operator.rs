//! The contact of a pair of bodies, prepared once: compliance at the contact points.

use crate::complementarity::{Answer, Complementarity, Point};
use crate::error::Error;
use crate::load::{ContactLoad, Friction, Motion, MomentBalance};
use crate::pair::{ContactPoint, Pair, Side};
use crate::response::{Response, times};
use crate::solution::ContactSolution;
use crate::status::Status;
use crate::verdict;
use faer::Mat;
use hpfem::{InterfaceOperator, InterfaceState, TraceLoad};

/// Compliance of a pair at its contact points; every gap, load, coefficient of friction or prescribed motion reuses it.
///
/// `opening = gap + u_1 . n - u_2 . n = d + C lambda + C_nt sigma + Psi y`, with nodal normal forces `lambda >= 0`, nodal shear forces `sigma`
/// on body 1 and rigid coordinates `y`.
pub struct ContactOperator<'a> {
    pair: Pair<'a>,
    points: Vec<ContactPoint>,
    pub(crate) responses: Vec<Response>,
    /// `C`, `points x points`.
    pub(crate) normal: Mat<f64>,
    /// `C_nt`: normal opening by shear forces.
    pub(crate) normal_by_shear: Option<Mat<f64>>,
    /// `Psi`: opening by coordinates, both bodies side by side.
    pub(crate) influence: Mat<f64>,
    /// Tangential relative motion (body 1 less body 2) by coordinates.
    pub(crate) shear_influence: Option<Mat<f64>>,
}

/// `[1, -1]`: sign of a body's displacement in the opening and of the contact force on it.
pub(crate) const SIGNS: [f64; 2] = [1.0, -1.0];

impl<'a> ContactOperator<'a> {
    /// Solves both bodies for unit forces at all contact points: normal ones, and tangential ones if `shear` is asked for.
    ///
    /// # Errors
    /// [`Error::NotHeld`] if a body with its rigid edge held could still move.
    pub fn new(pair: &Pair<'a>, shear: bool) -> Result<ContactOperator<'a>, Error> {
        let points = pair.points();
        let mut responses = Vec::new();
        for side in [Side::Shaped, Side::Counter] {
            if let Some(body) = pair.side(side) {
                let places: Vec<(usize, f64)> = points.iter().map(|p| pair.place(side, p)).collect();
                responses.push(Response::new(body, side, &points, &places, shear)?);
            }
        }
        let n = points.len();
        let (mut normal, mut normal_by_shear) = (Mat::zeros(n, n), shear.then(|| Mat::zeros(n, n)));
        for r in &responses {
            normal += &r.normal * &r.to_normal;
            if let (Some(sum), Some(x)) = (&mut normal_by_shear, &r.to_tangential) {
                *sum += &r.normal * x;
            }
        }
        // Exactly symmetric, so that the answer does not depend on which half is read.
        let normal = Mat::from_fn(n, n, |i, j| 0.5 * (normal[(i, j)] + normal[(j, i)]));
        let side_by_side = |matrix: &dyn Fn(&Response) -> Mat<f64>| {
            let blocks: Vec<Mat<f64>> = responses.iter().map(matrix).collect();
            let columns: Vec<(usize, usize)> =
                blocks.iter().enumerate().flat_map(|(b, m)| (0..m.ncols()).map(move |j| (b, j))).collect();
            Mat::from_fn(n, columns.len(), |i, j| SIGNS[columns[j].0] * blocks[columns[j].0][(i, columns[j].1)])
        };
        let influence = side_by_side(&|r| &r.normal * &r.motions);
        let shear_influence = shear.then(|| {
            side_by_side(&|r| r.tangential.as_ref().map_or_else(|| Mat::zeros(n, r.motions.ncols()), |t| t * &r.motions))
        });
        Ok(ContactOperator { pair: *pair, points, responses, normal, normal_by_shear, influence, shear_influence })
    }

    /// The contact points, in order along the boundary.
    pub fn points(&self) -> &[ContactPoint] {
        &self.points
    }

    /// The bodies.
    pub fn pair(&self) -> &Pair<'a> {
        &self.pair
    }

    /// Normal compliance `C` at the points, `points x points`: opening by nodal normal forces with the rigid coordinates at zero.
    pub fn compliance(&self) -> &Mat<f64> {
        &self.normal
    }

    /// Solves for a gap (one value a point, positive open) under a load, from an earlier solution if there is one.
    ///
    /// # Errors
    /// [`Error::Gap`], [`Error::Factors`], [`Error::Drag`], [`Error::ShearNotPrepared`] on wrong sizes.
    pub fn solve(
        &self,
        gap: &[f64],
        load: &ContactLoad,
        warm_start: Option<&ContactSolution>,
    ) -> Result<ContactSolution, Error> {
        let stage = self.stage(gap, load)?;
        let start = warm_start.map(|s| (stage.start(s), s.closed.clone()));
        let answer = stage.problem.solve(start.as_ref().map(|(p, a)| (p, a.as_slice())));
        let status = verdict::status(&stage.problem, &stage.frictionless, &answer);
        Ok(self.solution(&stage, answer, status))
    }

    /// Solves with the exact active-set method alone, as a second opinion.
    ///
    /// # Errors
    /// As [`ContactOperator::solve`].
    pub fn solve_by_pivoting(&self, gap: &[f64], load: &ContactLoad) -> Result<ContactSolution, Error> {
        let stage = self.stage(gap, load)?;
        let answer = stage.problem.solve_by_pivoting();
        let status = verdict::status(&stage.problem, &stage.frictionless, &answer);
        Ok(self.solution(&stage, answer, status))
    }

    /// Solves with a given set of points in contact and no conditions on signs: pressures may come out negative. Node positioning uses it.
    ///
    /// # Errors
    /// As [`ContactOperator::solve`].
    pub fn solve_on(&self, gap: &[f64], load: &ContactLoad, closed: &[bool]) -> Result<Option<ContactSolution>, Error> {
        let stage = self.stage(gap, load)?;
        let answer = stage.problem.solve_on(closed);
        Ok(answer.map(|a| self.solution(&stage, a, Status::Converged)))
    }

    /// The complementarity problem of a gap and a load.
    pub(crate) fn stage(&self, gap: &[f64], load: &ContactLoad) -> Result<Stage, Error> {
        let n = self.points.len();
        if gap.len() != n || gap.iter().any(|g| !g.is_finite()) {
            return Err(Error::Gap { given: gap.len(), points: n });
        }
        let mut opening = gap.to_vec();
        let mut rows = Vec::new();
        let mut factors = Vec::new();
        for (b, response) in self.responses.iter().enumerate() {
            let operator = self.operator(b);
            if load.factors[b].len() != operator.load_cases || load.factors[b].iter().any(|a| !a.is_finite()) {
                return Err(Error::Factors { body: b + 1, given: load.factors[b].len(), cases: operator.load_cases });
            }
            let all = operator.factors(&load.factors[b]);
            let columns = all[..=operator.load_cases].to_vec();
            let u = times(&response.to_columns, &columns);
            let displaced = times(&response.normal, &u);
            (0..n).for_each(|i| opening[i] += SIGNS[b] * (displaced[i] + response.constant[0][i]));
            rows.extend(times(&response.motion_columns, &columns));
            factors.push((all, columns));
        }
        let (slide, friction_active) = self.slide(load)?;
        let mut compliance = self.normal.clone();
        let mut balance = self.influence.clone();
        if let (true, Some(by_shear), Some(shear)) = (friction_active, &self.normal_by_shear, &self.shear_influence) {
            for j in 0..n {
                (0..n).for_each(|i| compliance[(i, j)] += by_shear[(i, j)] * slide[j]);
            }
            for j in 0..balance.ncols() {
                let rotation = self.edge_motion(j) == Some(2);
                if !(rotation && load.moment == MomentBalance::Pressure) {
                    (0..n).for_each(|i| balance[(i, j)] += slide[i] * shear[(i, j)]);
                }
            }
        }
        // Springs, resultants and prescribed values of the rigid edge.
        let total = rows.len();
        let mut stiffness = Mat::zeros(total, total);
        let mut offset = 0;
        for r in &self.responses {
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
        let free: Vec<usize> = (0..total).filter(|j| prescribed[*j].is_none()).collect();
        for (j, value) in prescribed.iter().enumerate().filter_map(|(j, v)| v.map(|v| (j, v))) {
            (0..n).for_each(|i| opening[i] += self.influence[(i, j)] * value);
            free.iter().for_each(|i| rows[*i] -= stiffness[(*i, j)] * value);
        }
        let pick = |m: &Mat<f64>| Mat::from_fn(n, free.len(), |i, j| m[(i, free[j])]);
        let (influence, balance) = (pick(&self.influence), pick(&balance));
        let mut stiffness = Mat::from_fn(free.len(), free.len(), |i, j| stiffness[(free[i], free[j])]);
        verdict::pin_idle_motions(&influence, &mut stiffness, &self.normal);
        let problem = Complementarity {
            compliance,
            influence,
            balance,
            stiffness,
            opening,
            load: free.iter().map(|j| rows[*j]).collect(),
            symmetric: !friction_active,
        };
        let frictionless = Complementarity {
            compliance: self.normal.clone(),
            influence: problem.influence.clone(),
            balance: problem.influence.clone(),
            stiffness: problem.stiffness.clone(),
            opening: problem.opening.clone(),
            load: problem.load.clone(),
            symmetric: true,
        };
        Ok(Stage { problem, frictionless, factors, slide, prescribed, free })
    }

    /// Shear per normal force at each point, and whether there is any.
    fn slide(&self, load: &ContactLoad) -> Result<(Vec<f64>, bool), Error> {
        let n = self.points.len();
        let Friction::Sliding { coefficient, drag } = &load.friction else { return Ok((vec![0.0; n], false)) };
        let sound = *coefficient >= 0.0 && coefficient.is_finite() && drag.len() == n && drag.iter().all(|d| d.abs() <= 1.0);
        if !sound {
            return Err(Error::Drag { coefficient: *coefficient, given: drag.len(), points: n });
        }
        let slide: Vec<f64> = drag.iter().map(|d| coefficient * d).collect();
        let active = slide.iter().any(|s| *s != 0.0);
        if active && self.normal_by_shear.is_none() {
            return Err(Error::ShearNotPrepared);
        }
        Ok((slide, active))
    }

    fn operator(&self, body: usize) -> &'a InterfaceOperator {
        match (body, self.pair.counter) {
            (1, Some(counter)) => counter,
            _ => self.pair.shaped,
        }
    }

    /// Motion of the shaped body's rigid edge that coordinate `j` is.
    fn edge_motion(&self, j: usize) -> Option<usize> {
        self.responses[0].edge_motion.get(j).copied().flatten()
    }

    fn solution(&self, stage: &Stage, answer: Answer, status: Status) -> ContactSolution {
        let n = self.points.len();
        let problem = &stage.problem;
        let complementarity = problem.complementarity(&answer.point, &answer.opening);
        let balance = problem.relative_imbalance(&answer.point);
        let force = answer.point.force;
        let shear: Vec<f64> = force.iter().zip(&stage.slide).map(|(f, s)| f * s).collect();
        let mut coordinates: Vec<f64> = stage.prescribed.iter().map(|p| p.unwrap_or(0.0)).collect();
        stage.free.iter().zip(&answer.point.coordinates).for_each(|(j, y)| coordinates[*j] = *y);
        let split = self.responses[0].motions.ncols();
        let coordinates = [coordinates[..split].to_vec(), coordinates[split..].to_vec()];
        let mut states = Vec::new();
        for (b, response) in self.responses.iter().enumerate() {
            let on_body = |v: &[f64]| v.iter().map(|v| SIGNS[b] * v).collect::<Vec<f64>>();
            let (lambda, sigma) = (on_body(&force), on_body(&shear));
            let (all, columns) = &stage.factors[b];
            let unknowns = response.unknowns(columns, &lambda, &sigma, &coordinates[b]);
            states.push(self.state(b, unknowns, &lambda, &sigma, all));
        }
        let counter = if states.len() > 1 { states.pop() } else { None };
        let Some(shaped) = states.pop() else { unreachable!("the shaped body always has a response") };
        let mut resultant = [0.0; 2];
        let mut moment = 0.0;
        for (i, p) in self.points.iter().enumerate() {
            let f: [f64; 2] = std::array::from_fn(|k| force[i] * p.normal[k] + shear[i] * p.tangent[k]);
            resultant[0] += f[0];
            resultant[1] += f[1];
            moment += p.position[0] * f[1] - p.position[1] * f[0];
        }
        let over_weight = |v: &[f64]| (0..n).map(|i| v[i] / self.points[i].weight).collect::<Vec<f64>>();
        ContactSolution {
            status,
            pressure: over_weight(&force),
            shear: over_weight(&shear),
            zones: self.zones(&answer.active, &force),
            nodal_force: force,
            nodal_shear: shear,
            opening: answer.opening,
            closed: answer.active,
            shaped,
            counter,
            coordinates,
            force: resultant,
            moment,
            complementarity,
            balance,
            iterations: answer.factorisations,
            took_over: answer.pivoted,
        }
    }

    /// State of a body, with the forces on its rigid edge counted among the loads.
    fn state(&self, body: usize, unknowns: Vec<f64>, lambda: &[f64], sigma: &[f64], factors: &[f64]) -> InterfaceState {
        let operator = self.operator(body);
        let side = if body == 0 { Side::Shaped } else { Side::Counter };
        let stiffness = &operator.stiffness;
        let mut load = TraceLoad { unknowns: vec![0.0; unknowns.len()], ..TraceLoad::default() };
        for (i, p) in self.points.iter().enumerate() {
            let force = std::array::from_fn(|k| lambda[i] * p.normal[k] + sigma[i] * p.tangent[k]);
            operator.trace.add_force(&mut load, self.pair.place(side, p), force);
        }
        for q in operator.frame.iter().flatten() {
            let internal: f64 = (0..unknowns.len()).map(|k| stiffness[(*q, k)] * unknowns[k]).sum();
            let condensed: f64 = factors.iter().enumerate().map(|(k, a)| a * operator.columns[(*q, k)]).sum();
            load.unknowns[*q] = internal - condensed;
        }
        InterfaceState { unknowns, factors: factors.to_vec(), load }
    }

    /// Contact zones: arcs between the ends of contact. An end between a closed and an open point is placed where the square of the pressure,
    /// linear near a smooth end, vanishes.
    fn zones(&self, active: &[bool], force: &[f64]) -> Vec<[f64; 2]> {
        let n = self.points.len();
        let pressure = |i: usize| force[i] / self.points[i].weight;
        let arc = |i: usize| self.points[i].arc;
        let end = |inside: usize, before: Option<usize>, outside: Option<usize>| {
            let Some(outside) = outside else { return arc(inside) };
            let (low, high) = (arc(inside), arc(outside));
            let Some(before) = before else { return 0.5 * (low + high) };
            let (a, b) = (pressure(before).powi(2), pressure(inside).powi(2));
            if a <= b {
                return 0.5 * (low + high);
            }
            let reach = (low - arc(before)).abs() * b / (a - b);
            if high > low { low + reach.min(high - low) } else { low - reach.min(low - high) }
        };
        let mut zones = Vec::new();
        let mut i = 0;
        while i < n {
            if !active[i] {
                i += 1;
                continue;
            }
            let start = i;
            while i + 1 < n && active[i + 1] {
                i += 1;
            }
            let inner = |k: usize| (start..=i).contains(&k).then_some(k);
            let left = end(start, inner(start + 1), start.checked_sub(1));
            let right = end(i, i.checked_sub(1).and_then(inner), Some(i + 1).filter(|k| *k < n));
            zones.push([left, right]);
            i += 1;
        }
        zones
    }
}

/// A load brought to the form of the complementarity problem.
pub(crate) struct Stage {
    pub(crate) problem: Complementarity,
    frictionless: Complementarity,
    /// All factors of each body, and those of load cases and prescribed displacements.
    factors: Vec<(Vec<f64>, Vec<f64>)>,
    slide: Vec<f64>,
    prescribed: Vec<Option<f64>>,
    free: Vec<usize>,
}

impl Stage {
    /// Starting point from an earlier solution.
    fn start(&self, solution: &ContactSolution) -> Point {
        let all: Vec<f64> = solution.coordinates.iter().flatten().copied().collect();
        Point { force: solution.nodal_force.clone(), coordinates: self.free.iter().map(|j| all[*j]).collect() }
    }
}
