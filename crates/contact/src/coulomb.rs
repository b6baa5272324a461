//! Coulomb friction with stick and slip: one load step, backward Euler in the slip.
//!
//! Return mapping of the augmented shear `sigma - r (s - s_before)` onto `|sigma| <= mu lambda` as semismooth Newton: every point is
//! open, sticks (`s = s_before`), or slips with `sigma = +- mu lambda` against its slip; the linear system of these states is solved and the states are read off again.

use crate::lcp::{Complementarity, PENALTY, Point};
use crate::linear::refined;
use crate::products::{add, times, transposed_times};
use crate::tresca::{Bound, SOFT, Tresca};
use faer::Mat;

/// State of a contact point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ContactState {
    /// The surfaces are apart.
    Open,
    /// In contact without slip.
    Stick,
    /// Slipping, shear on body 1 along the point's tangent.
    Forward,
    /// Slipping, shear on body 1 against the point's tangent.
    Backward,
}

/// Linear systems before giving up.
const LIMIT: usize = 300;
/// Plain steps on the states before shear limits are held.
const PLAIN_STEPS: usize = 24;
/// Steps without fewer changes before plain steps end.
const IDLE: usize = 8;

/// The frictionless problem and what shear adds to it.
pub(crate) struct Coulomb<'m> {
    pub(crate) normal: &'m Complementarity<'m>,
    /// Normal opening by shear forces; its transpose is the slip by normal forces.
    pub(crate) by_shear: &'m Mat<f64>,
    /// Slip by shear forces.
    pub(crate) tangential: &'m Mat<f64>,
    /// Slip by coordinates.
    pub(crate) influence: &'m Mat<f64>,
    /// Slip of the unloaded contact less the slip at the end of the last step.
    pub(crate) slip: Vec<f64>,
    pub(crate) coefficient: f64,
}

/// Normal forces and coordinates, shear forces.
#[derive(Clone, Debug)]
pub(crate) struct Sheared {
    pub(crate) point: Point,
    pub(crate) shear: Vec<f64>,
}

/// What the iteration found.
pub(crate) struct Outcome {
    pub(crate) at: Option<Sheared>,
    pub(crate) states: Vec<ContactState>,
    pub(crate) steps: usize,
    pub(crate) history: Vec<usize>,
    pub(crate) settled: bool,
}

/// State of a point by where its normal and its shear force stand.
fn state(normal: Bound, shear: Bound, force: f64) -> ContactState {
    match (normal, shear) {
        (Bound::Low(_) | Bound::High(_), _) => ContactState::Open,
        (_, Bound::Free) => ContactState::Stick,
        _ if force > 0.0 => ContactState::Forward,
        _ => ContactState::Backward,
    }
}

impl Coulomb<'_> {
    /// `w` and the slip since the last step.
    pub(crate) fn gaps(&self, at: &Sheared) -> (Vec<f64>, Vec<f64>) {
        let mut opening = self.normal.openings(&at.point);
        add(&mut opening, &times(self.by_shear, &at.shear));
        let mut slip = self.slip.clone();
        add(&mut slip, &transposed_times(self.by_shear, &at.point.force));
        add(&mut slip, &times(self.tangential, &at.shear));
        add(&mut slip, &times(self.influence, &at.point.coordinates));
        (opening, slip)
    }

    /// `f + Psi^T lambda + Psi_t^T sigma - K y`, relative to the sum of magnitudes.
    pub(crate) fn relative_imbalance(&self, at: &Sheared) -> f64 {
        let mut balance = self.normal.imbalance(&at.point);
        add(&mut balance, &transposed_times(self.influence, &at.shear));
        let n = at.shear.len();
        (0..balance.len())
            .map(|j| {
                let parts: f64 = (0..n)
                    .map(|i| {
                        (self.normal.influence[(i, j)] * at.point.force[i]).abs() + (self.influence[(i, j)] * at.shear[i]).abs()
                    })
                    .sum();
                let size = parts + self.normal.load[j].abs();
                if size > 0.0 { balance[j].abs() / size } else { 0.0 }
            })
            .fold(0.0, f64::max)
    }

    /// Points in contact, and those of them that stick.
    fn touching(states: &[ContactState]) -> [Vec<usize>; 2] {
        let all = |wanted: &dyn Fn(ContactState) -> bool| (0..states.len()).filter(|i| wanted(states[*i])).collect();
        [all(&|s| s != ContactState::Open), all(&|s| s == ContactState::Stick)]
    }

    /// Shear per normal force of a slipping point.
    fn slide(&self, state: ContactState) -> f64 {
        match state {
            ContactState::Forward => self.coefficient,
            ContactState::Backward => -self.coefficient,
            ContactState::Open | ContactState::Stick => 0.0,
        }
    }

    /// Compliance of a point in its own direction.
    fn own(&self, normal: bool, i: usize) -> f64 {
        if normal { self.normal.compliance[(i, i)] } else { self.tangential[(i, i)] }
    }

    /// The scaled system of given states: points in contact, sticking points, coordinates.
    pub(crate) fn matrix(&self, states: &[ContactState]) -> Mat<f64> {
        let m = self.normal.load.len();
        let [contact, stick] = Self::touching(states);
        let (c, s) = (contact.len(), stick.len());
        let (unit, resultant) = self.scales();
        let own = |normal: bool, points: &[usize]| -> Vec<f64> { points.iter().map(|i| self.own(normal, *i)).collect() };
        let [own_normal, own_shear] = [own(true, &contact), own(false, &stick)];
        let mut matrix = Mat::zeros(c + s + m, c + s + m);
        // A normal force acts with the shear of its slip, the shear of a sticking point alone.
        let pressed = contact.iter().map(|k| (*k, 1.0, self.slide(states[*k])));
        for (j, (k, force, shear)) in pressed.chain(stick.iter().map(|k| (*k, 0.0, 1.0))).enumerate() {
            let (openings, rest) = matrix.col_as_slice_mut(j).split_at_mut(c);
            let (slips, resultants) = rest.split_at_mut(s);
            let (by_force, by_shear) = (self.normal.compliance.col_as_slice(k), self.by_shear.col_as_slice(k));
            for ((opening, i), own) in openings.iter_mut().zip(&contact).zip(&own_normal) {
                *opening = (force * by_force[*i] + shear * by_shear[*i]) / own;
            }
            let by_shear = self.tangential.col_as_slice(k);
            for ((slip, i), own) in slips.iter_mut().zip(&stick).zip(&own_shear) {
                *slip = (force * self.by_shear[(k, *i)] + shear * by_shear[*i]) / own;
            }
            for (i, sum) in resultants.iter_mut().enumerate() {
                *sum = (force * self.normal.influence[(k, i)] + shear * self.influence[(k, i)]) / resultant[i];
            }
        }
        for (k, unit) in unit.iter().enumerate() {
            let column = matrix.col_as_slice_mut(c + s + k);
            let (opened, slid) = (self.normal.influence.col_as_slice(k), self.influence.col_as_slice(k));
            let openings = contact.iter().zip(&own_normal).map(|(i, own)| unit * opened[*i] / own);
            let slips = stick.iter().zip(&own_shear).map(|(i, own)| unit * slid[*i] / own);
            let resultants = (0..m).map(|i| -self.normal.stiffness[(i, k)] * unit / resultant[i]);
            column.iter_mut().zip(openings.chain(slips).chain(resultants)).for_each(|(to, value)| *to = value);
        }
        matrix
    }

    /// Solves with given states; `None` if that is singular.
    pub(crate) fn on_states(&self, states: &[ContactState]) -> Option<Sheared> {
        let (n, m) = (states.len(), self.normal.load.len());
        let [contact, stick] = Self::touching(states);
        let (c, s) = (contact.len(), stick.len());
        let (unit, resultant) = self.scales();
        let right = Mat::from_fn(c + s + m, 1, |i, _| {
            if i < c {
                -self.normal.opening[contact[i]] / self.own(true, contact[i])
            } else if i < c + s {
                -self.slip[stick[i - c]] / self.own(false, stick[i - c])
            } else {
                -self.normal.load[i - c - s] / resultant[i - c - s]
            }
        });
        let matrix = self.matrix(states);
        let lu = matrix.partial_piv_lu();
        let pivots = (0..c + s + m).map(|i| lu.U()[(i, i)].abs());
        let (low, high) = pivots.fold((f64::INFINITY, 0.0_f64), |(l, h), p| (l.min(p), h.max(p)));
        if low <= 1e-15 * high {
            return None;
        }
        let x = refined(&lu, &matrix, &right);
        let mut at = Sheared { point: Point { force: vec![0.0; n], coordinates: vec![0.0; m] }, shear: vec![0.0; n] };
        for (j, k) in contact.iter().enumerate() {
            at.point.force[*k] = x[(j, 0)];
            at.shear[*k] = self.slide(states[*k]) * x[(j, 0)];
        }
        stick.iter().enumerate().for_each(|(j, k)| at.shear[*k] = x[(c + j, 0)]);
        (0..m).for_each(|k| at.point.coordinates[k] = x[(c + s + k, 0)] * unit[k]);
        at.point.force.iter().chain(&at.shear).all(|v| v.is_finite()).then_some(at)
    }

    /// Unit of each coordinate and size of its resultant.
    pub(crate) fn scales(&self) -> (Vec<f64>, Vec<f64>) {
        let n = self.slip.len();
        let m = self.normal.load.len();
        let largest = |j: usize, over: bool| {
            (0..n)
                .map(|i| {
                    let divide = |v: f64, by: f64| if over && by > 0.0 { v.abs() / by } else { v.abs() };
                    divide(self.normal.influence[(i, j)], self.normal.compliance[(i, i)])
                        .max(divide(self.influence[(i, j)], self.tangential[(i, i)]))
                })
                .fold(0.0, f64::max)
        };
        let positive = |v: f64| if v > 0.0 { v } else { 1.0 };
        ((0..m).map(|j| 1.0 / positive(largest(j, true))).collect(), (0..m).map(|j| positive(largest(j, false))).collect())
    }

    /// The convex problem with shear limits held: normal forces, then shear forces.
    fn tresca(&self) -> Tresca {
        let n = self.slip.len();
        let normal = self.normal;
        let compliance = Mat::from_fn(2 * n, 2 * n, |i, j| match (i < n, j < n) {
            (true, true) => normal.compliance[(i, j)],
            (true, false) => self.by_shear[(i, j - n)],
            (false, true) => self.by_shear[(j, i - n)],
            (false, false) => self.tangential[(i - n, j - n)],
        });
        let m = normal.load.len();
        let influence = Mat::from_fn(2 * n, m, |i, j| if i < n { normal.influence[(i, j)] } else { self.influence[(i - n, j)] });
        let (unit, resultant) = self.scales();
        Tresca {
            penalty: SOFT,
            own: (0..2 * n).map(|i| compliance[(i, i)]).collect(),
            compliance,
            influence,
            offset: normal.opening.iter().chain(&self.slip).copied().collect(),
            load: normal.load.clone(),
            stiffness: normal.stiffness.clone(),
            unit,
            resultant,
        }
    }

    /// States read off a solution, and how many differ from those it was solved with; signs within round-off do not count.
    fn read(&self, at: &Sheared, states: &[ContactState]) -> (Vec<ContactState>, usize) {
        let (opening, slip) = self.gaps(at);
        let (force_tolerance, opening_tolerance) = self.normal.tolerances(&at.point);
        let slip_size = times(self.tangential, &at.shear).iter().fold(0.0_f64, |m, v| m.max(v.abs()));
        let slip_tolerance = 1e-11 * slip_size;
        let read: Vec<ContactState> = (0..states.len())
            .map(|i| {
                let (force, shear) = (at.point.force[i], at.shear[i]);
                let limit = self.coefficient * force + self.coefficient.max(1.0) * force_tolerance;
                match states[i] {
                    ContactState::Open if opening[i] >= -opening_tolerance[i] => ContactState::Open,
                    // A point that closes slips already: as a sticking one it would take any shear, and the normal states go round in circles.
                    ContactState::Open if slip[i] > slip_tolerance => ContactState::Backward,
                    ContactState::Open if slip[i] < -slip_tolerance => ContactState::Forward,
                    ContactState::Open => ContactState::Stick,
                    _ if force < -force_tolerance => ContactState::Open,
                    ContactState::Stick if shear > limit => ContactState::Forward,
                    ContactState::Stick if shear < -limit => ContactState::Backward,
                    ContactState::Stick => ContactState::Stick,
                    ContactState::Forward if slip[i] > slip_tolerance => ContactState::Stick,
                    ContactState::Backward if slip[i] < -slip_tolerance => ContactState::Stick,
                    slipping @ (ContactState::Forward | ContactState::Backward) => slipping,
                }
            })
            .collect();
        let changed = read.iter().zip(states).filter(|(a, b)| a != b).count();
        (read, changed)
    }

    /// Iterates on the states from `start`; where that does not settle, shear limits are held while the convex problem they make is solved, and the
    /// states found there are tried.
    pub(crate) fn solve(&self, start: &[ContactState], near: &Sheared) -> Outcome {
        let mut outcome = Outcome { at: None, states: start.to_vec(), steps: 0, history: Vec::new(), settled: false };
        self.iterate(&mut outcome, PLAIN_STEPS);
        if outcome.settled {
            return outcome;
        }
        let n = start.len();
        let mut tresca = self.tresca();
        let limits = |force: &[f64]| -> Vec<[f64; 2]> {
            let shear = force.iter().map(|f| self.coefficient * f.max(0.0)).map(|l| [-l, l]);
            std::iter::repeat_n([0.0, f64::INFINITY], n).chain(shear).collect()
        };
        let mut centre = Point {
            force: near.point.force.iter().chain(&near.shear).copied().collect(),
            coordinates: near.point.coordinates.clone(),
        };
        while outcome.steps < LIMIT {
            let Some((forces, bounds, solved)) = tresca.step(&centre, &limits(&centre.force[..n])) else { break };
            outcome.steps += solved;
            outcome.states = (0..n).map(|i| state(bounds[i], bounds[n + i], forces.force[n + i])).collect();
            self.iterate(&mut outcome, 3);
            if outcome.settled {
                break;
            }
            centre = forces;
            // The states stiffen as the multipliers settle.
            tresca.penalty = (4.0 * tresca.penalty).min(PENALTY);
        }
        outcome
    }

    /// Up to `steps` plain steps on the states, fewer if the number of changes does not fall for long.
    fn iterate(&self, outcome: &mut Outcome, steps: usize) {
        let (mut best, mut idle) = (usize::MAX, 0);
        for _ in 0..steps {
            outcome.steps += 1;
            let Some(at) = self.on_states(&outcome.states) else { break };
            let (read, changed) = self.read(&at, &outcome.states);
            outcome.at = Some(at);
            outcome.history.push(changed);
            if changed == 0 {
                outcome.settled = true;
                break;
            }
            outcome.states = read;
            idle = if changed < best { 0 } else { idle + 1 };
            best = best.min(changed);
            if idle > IDLE {
                break;
            }
        }
    }
}
