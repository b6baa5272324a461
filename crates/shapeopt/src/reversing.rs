//! The steady shape of a motion that reverses: forward a share of the time and backward the rest, with friction that turns with the sliding.
//!
//! Both senses press on one gap `g` with their own shear, so there are two pressures, `p+` and `p-`. Cycles that are short against wear see the
//! mean of both wear rates, and the shape stays when this mean is a rigid feed:
//!
//! ```text
//! g + E+ >= 0,  p+ >= 0,  p+ (g + E+) = 0      E+- = opening of the loaded bodies without gap, A+- W p+- + Psi y+- + known
//! g + E- >= 0,  p- >= 0,  p- (g + E-) = 0      load + B+-^T W p+- = K y+-
//! share w'(p+) + (1 - share) w'(p-) + R = V . phi     where V . phi > R, and no pressure elsewhere
//! ```
//!
//! with the recession `R` of a revolving counter-face. A point that is fed touches in one sense at least, hence `g = -min(E+, E-)`, and the gap drops
//! out: where `E+ = E-` both senses touch, where they differ the one that opens carries nothing. What is left is a complementarity problem in the
//! difference of the two pressures, which the mean rate holds between two ends ([`pressures`]); Newton's method on its normal map solves it together
//! with the balances and the feed. `w'` is any rule that grows with the pressure.

use crate::error::Error;
use crate::gap_rate::GapRate;
use crate::reversal_start::first_feed;
use crate::reversed_pressure::{Pressures, pressures};
use crate::rigid_wear::RigidWear;
use crate::wear_problem::{fits, not_finite};
use contact::ContactSystem;
use faer::Mat;
use faer::linalg::solvers::Solve;
use wear::{Counterface, SurfacePoint, WearPair};

const NEWTON_LIMIT: usize = 200;
/// Halvings of a Newton step that does not bring the residual down.
const HALVINGS: usize = 12;
/// Relative residual at which the iteration may end, and which it must reach.
const SETTLED: f64 = 1e-13;
const ENOUGH: f64 = 1e-9;

/// A contact that slides to and fro.
#[derive(Clone, Debug)]
pub struct ReversingProblem {
    /// The contact points with weights (mm^2) and sliding speeds (mm/s), the same in both senses.
    pub points: Vec<SurfacePoint>,
    /// Wear rules of the two bodies.
    pub wear: WearPair,
    /// How body 2 passes through the contact.
    pub counterface: Counterface,
    /// Area (mm^2) of body 2's closed track, needed by [`Counterface::Revolving`].
    pub track_area: Option<f64>,
    /// The contact under its load sliding forward and backward: the same bodies, the shear reversed.
    pub systems: [ContactSystem; 2],
    /// Share of the time that slides forward, from 0 to 1.
    pub share: f64,
}

/// A shape that wears steadily under a reversing motion; arrays hold one value a contact point.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Reversing {
    /// Unloaded gap (mm), up to a rigid part.
    pub gap: Vec<f64>,
    /// Pressure sliding forward and backward (MPa).
    pub pressure: [Vec<f64>; 2],
    /// Opening under load forward and backward (mm).
    pub opening: [Vec<f64>; 2],
    /// Rigid feed, body 1 towards body 2, at the points (mm/s): the mean rate at which the gap would open.
    pub feed: Vec<f64>,
    /// Newton steps.
    pub iterations: usize,
    /// Largest residual of openings and balances, each over what is in it.
    pub residual: f64,
}

/// Solves for the steady shape.
///
/// # Errors
/// [`Error::WearInput`] where numbers do not fit each other, nothing wears, or no load pushes along a free rigid motion;
/// [`Error::NoSteadyReversal`] if the iteration does not settle.
pub fn steady_reversing(problem: &ReversingProblem) -> Result<Reversing, Error> {
    problem.check()?;
    Search::new(problem)?.solve()
}

/// The problem with its held coordinates eliminated.
struct Search<'a> {
    problem: &'a ReversingProblem,
    rate: GapRate,
    weights: Vec<f64>,
    rigid: [RigidWear; 2],
    /// `A + Psi_h K_h^-1 B_h^T` times the weights, forward and backward.
    compliance: [Mat<f64>; 2],
    /// Openings without pressure.
    opening: [Vec<f64>; 2],
    /// `A_ii W_i`: units of the normal map.
    sigma: Vec<f64>,
}

/// Unknowns: normal map (MPa), difference of the rigid coordinates forward and backward, velocities of the rigid modes, recession.
#[derive(Clone)]
struct Unknowns {
    u: Vec<f64>,
    shift: Vec<f64>,
    velocity: Vec<f64>,
    recession: f64,
}

/// An iterate with its pressures and residuals.
struct State {
    at: Unknowns,
    pressures: Vec<Pressures>,
    /// Rate fed to the points; 0 where the rigid feed leaves the surface.
    residual: Vec<f64>,
    /// Size of the residuals, each over its unit.
    size: f64,
}

impl ReversingProblem {
    fn check(&self) -> Result<(), Error> {
        let n = self.points.len();
        let wrong = |what: String| Err(Error::WearInput { what });
        if !(0.0..=1.0).contains(&self.share) {
            return wrong(format!("the share of the time forward is {}; it must be from 0 to 1", self.share));
        }
        let second = self.counterface == Counterface::Congruent && self.wear.wears(1);
        if !(self.wear.wears(0) || second) {
            return wrong("nothing wears the contact surface; body 1 needs a wear factor".into());
        }
        let alike = self.systems[0].load.len() == self.systems[1].load.len();
        if !alike || !self.systems.iter().all(|system| fits(system, n)) {
            return wrong(format!("a contact system does not fit the {n} contact points"));
        }
        for (sense, system) in ["forward", "backward"].iter().zip(&self.systems) {
            if let Some(place) = not_finite(system) {
                return wrong(format!("the contact system {sense} has a number that is not finite: {place}"));
            }
        }
        if self.counterface == Counterface::Revolving && !self.track_area.is_some_and(|area| area > 0.0) {
            return wrong("a revolving counter-face needs the area of its closed track".into());
        }
        Ok(())
    }
}

impl<'a> Search<'a> {
    fn new(problem: &'a ReversingProblem) -> Result<Search<'a>, Error> {
        let weights: Vec<f64> = problem.points.iter().map(|p| p.weight).collect();
        let speeds: Vec<f64> = problem.points.iter().map(|p| p.sliding_speed).collect();
        let rate = GapRate::new(&problem.wear, problem.counterface, &speeds, &weights, problem.track_area);
        let rigid = problem.systems.each_ref().map(RigidWear::new);
        if !rigid[0].driven {
            let what = "no load pushes along a free rigid motion, so that wear relieves the contact; press by a force".into();
            return Err(Error::WearInput { what });
        }
        let n = weights.len();
        let compliance = [0, 1].map(|side| {
            let held = &rigid[side].held_influence * rigid[side].held_balance.transpose();
            let own = &problem.systems[side].compliance;
            Mat::from_fn(n, n, |i, j| (own[(i, j)] + held[(i, j)]) * weights[j])
        });
        let opening = [0, 1].map(|side| {
            let held = |i: usize| -> f64 {
                rigid[side].held_load.iter().enumerate().map(|(k, y)| rigid[side].held_influence[(i, k)] * y).sum()
            };
            (0..n).map(|i| problem.systems[side].opening[i] + held(i)).collect()
        });
        let largest = (0..n).map(|i| compliance[0][(i, i)].abs()).fold(f64::MIN_POSITIVE, f64::max);
        let sigma = (0..n).map(|i| compliance[0][(i, i)].abs().max(1e-14 * largest)).collect();
        Ok(Search { problem, rate, weights, rigid, compliance, opening, sigma })
    }

    fn modes(&self) -> usize {
        self.rigid[0].influence.ncols()
    }

    /// Rigid feed at a point by the velocities of the modes.
    fn feed(&self, velocity: &[f64], i: usize) -> f64 {
        -velocity.iter().enumerate().map(|(k, v)| self.rigid[0].influence[(i, k)] * v).sum::<f64>()
    }

    /// Openings of a side without gap and rigid motion.
    fn elastic(&self, side: usize, pressures: &[Pressures]) -> Vec<f64> {
        let mut opening = self.opening[side].clone();
        for (j, p) in pressures.iter().enumerate().map(|(j, p)| (j, p.value[side])).filter(|(_, p)| *p != 0.0) {
            self.compliance[side].col_as_slice(j).iter().zip(&mut opening).for_each(|(a, o)| *o += a * p);
        }
        opening
    }

    /// Shift of the rigid coordinates at a point.
    fn shifted(&self, shift: &[f64], i: usize) -> f64 {
        shift.iter().enumerate().map(|(k, y)| self.rigid[0].influence[(i, k)] * y).sum()
    }

    /// Mean recession of a revolving counter-face by the pressures.
    fn recession(&self, pressures: &[Pressures]) -> f64 {
        let share = [self.problem.share, 1.0 - self.problem.share];
        let of = |side: usize| self.rate.recession(&pressures.iter().map(|p| p.value[side]).collect::<Vec<f64>>());
        (0..2).map(|side| share[side] * of(side)).sum()
    }

    fn state(&self, at: Unknowns) -> State {
        let n = self.weights.len();
        let share = self.problem.share;
        let pressures: Vec<Pressures> =
            (0..n).map(|i| pressures(&self.rate, i, share, at.u[i], self.feed(&at.velocity, i) - at.recession)).collect();
        let elastic = [0, 1].map(|side| self.elastic(side, &pressures));
        let mut residual: Vec<f64> = (0..n)
            .map(|i| {
                let beyond = self.sigma[i] * (at.u[i] - pressures[i].difference());
                elastic[0][i] - elastic[1][i] + self.shifted(&at.shift, i) + beyond
            })
            .collect();
        let unit = elastic.iter().flatten().fold(f64::MIN_POSITIVE, |m, e| m.max(e.abs()));
        let mut size = residual.iter().fold(0.0_f64, |m, r| m.max(r.abs() / unit));
        for side in [0, 1] {
            for k in 0..self.modes() {
                let work = |i: usize| self.rigid[side].balance[(i, k)] * self.weights[i] * pressures[i].value[side];
                let load = self.rigid[side].load[k];
                let off = load + (0..n).map(work).sum::<f64>();
                let all = load.abs() + (0..n).map(|i| work(i).abs()).sum::<f64>();
                size = size.max(off.abs() / all.max(f64::MIN_POSITIVE));
                residual.push(off);
            }
        }
        if self.rate.recedes() {
            let off = at.recession - self.recession(&pressures);
            size = size.max(off.abs() / at.recession.abs().max(f64::MIN_POSITIVE));
            residual.push(off);
        }
        // What is no number is no answer.
        let size = if residual.iter().all(|r| r.is_finite()) { size } else { f64::INFINITY };
        State { at, pressures, residual, size }
    }

    fn solve(&self) -> Result<Reversing, Error> {
        let (n, modes) = (self.weights.len(), self.modes());
        let velocity = first_feed(&self.rigid[0], &self.rate, &self.weights);
        let start = Unknowns { u: vec![0.0; n], shift: vec![0.0; modes], velocity, recession: 0.0 };
        let mut state = self.state(start);
        let mut iterations = 0;
        while iterations < NEWTON_LIMIT {
            iterations += 1;
            let Some(change) = self.newton(&state) else { break };
            let next = self.along(&state, &change);
            let idle = next.size >= 0.5 * state.size && next.size < ENOUGH;
            if idle && state.size <= next.size {
                break;
            }
            state = next;
            if state.size < SETTLED || idle {
                break;
            }
        }
        if state.size.is_nan() || state.size > ENOUGH {
            let why = format!("residual {:.1e} after {iterations} steps", state.size);
            return Err(Error::NoSteadyReversal { why });
        }
        Ok(self.found(state, iterations))
    }

    /// The Newton point or, where it is farther off, a point on the way to it.
    fn along(&self, from: &State, change: &[f64]) -> State {
        let mut part = 1.0;
        let mut nearest = self.state(self.moved(&from.at, change, part));
        for _ in 0..HALVINGS {
            if nearest.size < from.size {
                break;
            }
            part *= 0.5;
            let next = self.state(self.moved(&from.at, change, part));
            if next.size < nearest.size {
                nearest = next;
            }
        }
        nearest
    }

    fn moved(&self, from: &Unknowns, change: &[f64], part: f64) -> Unknowns {
        let (n, modes) = (from.u.len(), self.modes());
        let add = |values: &[f64], first: usize| values.iter().zip(&change[first..]).map(|(v, c)| v + part * c).collect();
        Unknowns {
            u: add(&from.u, 0),
            shift: add(&from.shift, n),
            velocity: add(&from.velocity, n + modes),
            recession: from.recession + change.get(n + 2 * modes).map_or(0.0, |c| part * c),
        }
    }

    /// The Newton step; `None` where the system has no solution.
    fn newton(&self, state: &State) -> Option<Vec<f64>> {
        let (n, modes) = (self.weights.len(), self.modes());
        let matrix = self.jacobian(state);
        let size = matrix.nrows();
        let largest = |values: &mut dyn Iterator<Item = f64>| match values.fold(0.0_f64, |m, v| m.max(v.abs())) {
            most if most > 0.0 && most.is_finite() => Some(most),
            _ => None,
        };
        let rows = (0..size).map(|i| largest(&mut (0..size).map(|j| matrix[(i, j)]))).collect::<Option<Vec<f64>>>()?;
        let columns =
            (0..size).map(|j| largest(&mut (0..size).map(|i| matrix[(i, j)] / rows[i]))).collect::<Option<Vec<f64>>>()?;
        let scaled = Mat::from_fn(size, size, |i, j| matrix[(i, j)] / rows[i] / columns[j]);
        let right = Mat::from_fn(size, 1, |i, _| -state.residual[i] / rows[i]);
        let x = scaled.partial_piv_lu().solve(&right);
        let change: Vec<f64> = (0..size).map(|j| x[(j, 0)] / columns[j]).collect();
        debug_assert!(size == n + 2 * modes + usize::from(self.rate.recedes()), "as many equations as unknowns");
        change.iter().all(|c| c.is_finite()).then_some(change)
    }

    /// Derivatives of the residuals by the unknowns.
    fn jacobian(&self, state: &State) -> Mat<f64> {
        let (n, modes) = (self.weights.len(), self.modes());
        let recedes = self.rate.recedes();
        let mut matrix = Mat::zeros(state.residual.len(), state.residual.len());
        for j in 0..n {
            let p = &state.pressures[j];
            self.add_pressure(&mut matrix, state, (j, j), p.by_difference);
            matrix[(j, j)] += self.sigma[j] * (1.0 - (p.by_difference[0] - p.by_difference[1]));
            (0..modes).for_each(|k| matrix[(j, n + k)] = self.rigid[0].influence[(j, k)]);
            // A softer feed raises the mean rate at every point that is fed.
            let fed = |k: usize| if k < modes { -self.rigid[0].influence[(j, k)] } else { -1.0 };
            for k in 0..modes + usize::from(recedes) {
                let by = p.by_rate.map(|slope| if slope == 0.0 { 0.0 } else { slope * fed(k) });
                self.add_pressure(&mut matrix, state, (j, n + modes + k), by);
                matrix[(j, n + modes + k)] -= self.sigma[j] * (by[0] - by[1]);
            }
        }
        if recedes {
            matrix[(n + 2 * modes, n + 2 * modes)] += 1.0;
        }
        matrix
    }

    /// Adds to a column what pressures at a point that change by `by` do to openings, balances and recession.
    fn add_pressure(&self, matrix: &mut Mat<f64>, state: &State, (j, column): (usize, usize), by: [f64; 2]) {
        let (n, modes) = (self.weights.len(), self.modes());
        if by == [0.0; 2] {
            return;
        }
        let [forward, backward] = [0, 1].map(|side| self.compliance[side].col(j));
        for i in 0..n {
            matrix[(i, column)] += forward[i] * by[0] - backward[i] * by[1];
        }
        for side in [0, 1] {
            for k in 0..modes {
                matrix[(n + side * modes + k, column)] += self.rigid[side].balance[(j, k)] * self.weights[j] * by[side];
            }
        }
        if self.rate.recedes() {
            let share = [self.problem.share, 1.0 - self.problem.share];
            let slope = |side: usize| self.rate.recession_slope(j, state.pressures[j].value[side]);
            let all = (0..2).filter(|side| share[*side] * by[*side] != 0.0);
            matrix[(n + 2 * modes, column)] -= all.map(|side| share[side] * slope(side) * by[side]).sum::<f64>();
        }
    }

    /// The answer at a solution.
    fn found(&self, state: State, iterations: usize) -> Reversing {
        let n = self.weights.len();
        let [mut forward, backward] = [0, 1].map(|side| self.elastic(side, &state.pressures));
        (0..n).for_each(|i| forward[i] += self.shifted(&state.at.shift, i));
        let mut found = Reversing {
            gap: vec![0.0; n],
            pressure: [0, 1].map(|side| state.pressures.iter().map(|p| p.value[side]).collect()),
            opening: [vec![0.0; n], vec![0.0; n]],
            feed: (0..n).map(|i| self.feed(&state.at.velocity, i)).collect(),
            iterations,
            residual: state.size,
        };
        for i in 0..n {
            let apart = forward[i] - backward[i];
            let touches =
                if state.pressures[i].ended() { -forward[i].min(backward[i]) } else { -0.5 * (forward[i] + backward[i]) };
            found.gap[i] = touches;
            if state.pressures[i].ended() {
                found.opening[0][i] = apart.max(0.0);
                found.opening[1][i] = (-apart).max(0.0);
            }
        }
        found
    }
}
