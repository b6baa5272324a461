//! Friction against turning: two bodies of revolution in contact, body 1 turned about the axis.
//!
//! For isotropic bodies the circumferential displacement is a scalar problem of its own, and shear around the axis moves no point along the
//! normal. The pressure is therefore known, and with it the limit `mu lambda` of every nodal force: stick and slip are a convex problem (Tresca) with
//! one solution, `slip = C sigma + r theta`, `|sigma| <= limit`, and `torque + r^T sigma = 0` where the torque is given.

use crate::coulomb::ContactState;
use crate::error::Error;
use crate::lcp::Point;
use crate::pair::Pair;
use crate::point::ContactPoint;
use crate::products::transposed_times;
use crate::segment::Station;
use crate::side::Side;
use crate::tresca::{Bound, SOFT, Tresca};
use crate::zones::zones;
use faer::Mat;
use hpfem::{InterfaceOperator, Kinematics};
use std::fmt;

/// Multiplier steps before giving up.
const LIMIT: usize = 20;
/// Plain steps on the states at a time.
const PLAIN_STEPS: usize = 40;
/// Stiffest penalty.
const STIFF: f64 = 1e12;

/// What a body of revolution is turned by.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Turn {
    /// Rotation (rad) of the place where body 1 is held, against that of body 2; anti-clockwise positive.
    Angle(f64),
    /// Torque on body 1, anti-clockwise positive.
    Torque(f64),
}

/// How a twist ended; `Display` gives the sentence.
#[derive(Clone, Debug, PartialEq)]
pub enum TwistStatus {
    /// No point slips.
    Sticks,
    /// Some points stick, others slip.
    SlipsInPart,
    /// Every point slips.
    Slips,
    /// The torque is more than friction carries.
    TurnsThrough,
    /// The iteration did not settle.
    IterationLimit {
        /// Largest force beyond its bounds, or motion against them, relative, at each step.
        history: Vec<f64>,
    },
}

impl TwistStatus {
    /// Whether shear and slip satisfy all conditions.
    pub fn is_solved(&self) -> bool {
        matches!(self, TwistStatus::Sticks | TwistStatus::SlipsInPart | TwistStatus::Slips)
    }
}

impl fmt::Display for TwistStatus {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            TwistStatus::Sticks => f.write_str("the twist is solved: the contact sticks everywhere"),
            TwistStatus::SlipsInPart => f.write_str("the twist is solved: part of the contact sticks, part of it slips"),
            TwistStatus::Slips => f.write_str("the twist is solved: the contact slips everywhere"),
            TwistStatus::TurnsThrough => f.write_str("the shaped body turns through: the torque is more than friction carries"),
            TwistStatus::IterationLimit { history } => {
                write!(f, "not converged: largest violation, step by step: {history:?}")
            }
        }
    }
}

/// Shear around the axis. Arrays hold one value a contact point.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct TwistSolution {
    /// How the solve ended.
    pub status: TwistStatus,
    /// Rotation of body 1.
    pub angle: f64,
    /// Torque on body 1, which the contact balances.
    pub torque: f64,
    /// Shear traction on body 1 around the axis, anti-clockwise positive.
    pub shear: Vec<f64>,
    /// Nodal force on body 1, `shear * weight`.
    pub nodal_shear: Vec<f64>,
    /// Circumferential displacement of body 1 less that of body 2; given to the next step it makes the history.
    pub slip: Vec<f64>,
    /// Stick, slip (shear on body 1 anti-clockwise: `Forward`) or no friction at all (`Open`).
    pub states: Vec<ContactState>,
    /// Arc lengths at which each sticking zone starts and ends.
    pub stick: Vec<[f64; 2]>,
    /// Largest force beyond its bounds, or motion against them, relative.
    pub residual: f64,
    /// Linear systems solved.
    pub iterations: usize,
}

/// The contact of a pair of bodies reduced in [`Kinematics::Torsion`], prepared once.
pub struct TorsionOperator {
    points: Vec<ContactPoint>,
    compliance: Mat<f64>,
    /// Length of the boundary if it is closed.
    turn: Option<f64>,
}

impl TorsionOperator {
    /// Solves both bodies for unit forces around the axis at all contact points. Each must be held against turning somewhere off the axis.
    ///
    /// # Errors
    /// [`Error::NoTurn`] for a body that is not reduced in [`Kinematics::Torsion`]; [`Error::FreeToTurn`].
    pub fn new(pair: &Pair<'_>) -> Result<TorsionOperator, Error> {
        let (points, stations) = pair.stations();
        let n = points.len();
        let mut compliance = Mat::zeros(n, n);
        for side in [Side::Shaped, Side::Counter] {
            let Some(body) = pair.side(side) else { continue };
            if body.kinematics != Kinematics::Torsion {
                return Err(Error::NoTurn { side, kinematics: body.kinematics });
            }
            if body.rigid_modes.ncols() > 0 {
                return Err(Error::FreeToTurn { side });
            }
            let rows = around(body, side, n, &stations);
            compliance += &rows * body.solve(&rows.transpose().to_owned(), &body.rigid_modes);
        }
        let compliance = Mat::from_fn(n, n, |i, j| 0.5 * (compliance[(i, j)] + compliance[(j, i)]));
        Ok(TorsionOperator { points, compliance, turn: pair.turn() })
    }

    /// The contact points, those of the contact of the same bodies in their plane.
    pub fn points(&self) -> &[ContactPoint] {
        &self.points
    }

    /// Torque of friction when every point slips.
    pub fn slip_torque(&self, limits: &[f64]) -> f64 {
        self.points.iter().zip(limits).map(|(p, l)| p.position[0] * l).sum()
    }

    /// One step of the history: limits of the nodal forces (coefficient of friction times nodal normal force), what body 1 is turned by in
    /// all, and the slip at the end of the last step (zeros for bodies never turned).
    ///
    /// # Errors
    /// [`Error::Twist`] on wrong sizes or numbers.
    pub fn solve(&self, limits: &[f64], turn: Turn, slip_before: &[f64]) -> Result<TwistSolution, Error> {
        let n = self.points.len();
        let (Turn::Angle(amount) | Turn::Torque(amount)) = turn;
        let sound = limits.len() == n && slip_before.len() == n && limits.iter().all(|l| *l >= 0.0 && l.is_finite());
        if !(sound && amount.is_finite() && slip_before.iter().all(|s| s.is_finite())) {
            return Err(Error::Twist { given: limits.len().min(slip_before.len()), points: n });
        }
        // Points on the axis or without pressure carry nothing.
        let live: Vec<usize> = (0..n).filter(|i| limits[*i] > 0.0 && self.compliance[(*i, *i)] > 0.0).collect();
        let mut answer = TwistSolution {
            status: TwistStatus::Slips,
            angle: if let Turn::Angle(angle) = turn { angle } else { 0.0 },
            torque: 0.0,
            shear: vec![0.0; n],
            nodal_shear: vec![0.0; n],
            slip: vec![0.0; n],
            states: vec![ContactState::Open; n],
            stick: Vec::new(),
            residual: 0.0,
            iterations: 0,
        };
        if let Turn::Torque(torque) = turn
            && torque.abs() >= self.slip_torque(limits)
        {
            // No friction holds, and no torque turns.
            if torque != 0.0 {
                answer.status = TwistStatus::TurnsThrough;
            }
            answer.torque = torque;
            return Ok(answer);
        }
        let problem = self.problem(&live, turn, slip_before);
        let bounds: Vec<[f64; 2]> = live.iter().map(|i| [-limits[*i], limits[*i]]).collect();
        let (forces, stands) = search(problem, &bounds, &mut answer);
        for (k, i) in live.iter().enumerate() {
            answer.nodal_shear[*i] = forces.force[k];
            answer.states[*i] = match stands[k] {
                Bound::Free => ContactState::Stick,
                Bound::High(_) => ContactState::Forward,
                Bound::Low(_) => ContactState::Backward,
            };
        }
        answer.angle += forces.coordinates.first().copied().unwrap_or(0.0);
        self.complete(&mut answer, limits);
        Ok(answer)
    }

    /// Bounded forces at the live points, with the angle as a coordinate where the torque is given.
    fn problem(&self, live: &[usize], turn: Turn, slip_before: &[f64]) -> Tresca {
        let n = live.len();
        let compliance = Mat::from_fn(n, n, |i, j| self.compliance[(live[i], live[j])]);
        let own: Vec<f64> = (0..n).map(|i| compliance[(i, i)]).collect();
        let radius = |i: usize| self.points[live[i]].position[0];
        let (free, angle, load) = match turn {
            Turn::Angle(angle) => (0, angle, vec![]),
            Turn::Torque(torque) => (1, 0.0, vec![torque]),
        };
        let unit = 1.0 / (0..n).map(|i| radius(i) / own[i]).fold(f64::MIN_POSITIVE, f64::max);
        let resultant = (0..n).map(radius).fold(f64::MIN_POSITIVE, f64::max);
        Tresca {
            influence: Mat::from_fn(n, free, |i, _| radius(i)),
            offset: (0..n).map(|i| radius(i) * angle - slip_before[live[i]]).collect(),
            load,
            stiffness: Mat::zeros(free, free),
            compliance,
            own,
            penalty: SOFT,
            unit: vec![unit; free],
            resultant: vec![resultant; free],
        }
    }

    /// Everything that follows from nodal forces, angle and states.
    fn complete(&self, answer: &mut TwistSolution, limits: &[f64]) {
        let n = self.points.len();
        let elastic = transposed_times(&self.compliance, &answer.nodal_shear);
        answer.slip = (0..n).map(|i| elastic[i] + self.points[i].position[0] * answer.angle).collect();
        answer.torque = -self.slip_torque(&answer.nodal_shear);
        answer.shear = (0..n).map(|i| answer.nodal_shear[i] / self.points[i].weight).collect();
        let sticks: Vec<bool> = answer.states.iter().map(|s| *s == ContactState::Stick).collect();
        let spare: Vec<f64> = limits.iter().zip(&answer.nodal_shear).map(|(l, f)| l - f.abs()).collect();
        // A point on the axis neither sticks nor slips: it belongs to its neighbour's zone.
        let mut within = sticks.clone();
        if within.len() > 1 && self.points[0].position[0] == 0.0 {
            within[0] = within[1];
        }
        answer.stick = zones(&self.points, &within, &spare, self.turn);
        if answer.status.is_solved() {
            let slips = answer.states.iter().any(|s| matches!(s, ContactState::Forward | ContactState::Backward));
            answer.status = match (sticks.contains(&true), slips) {
                (true, false) => TwistStatus::Sticks,
                (true, true) => TwistStatus::SlipsInPart,
                (false, _) => TwistStatus::Slips,
            };
        }
    }
}

/// States from sticking everywhere on until they are right; where they do not settle, multiplier steps show the way.
fn search(mut problem: Tresca, limits: &[[f64; 2]], answer: &mut TwistSolution) -> (Point, Vec<Bound>) {
    let mut centre = Point { force: vec![0.0; limits.len()], coordinates: vec![0.0; problem.load.len()] };
    let mut stands = vec![Bound::Free; limits.len()];
    let mut history = Vec::new();
    for _ in 0..LIMIT {
        if let Some(exact) = settle(&problem, limits, &mut stands, answer, &mut history) {
            return (exact, stands);
        }
        let Some((forces, found, solved)) = problem.step(&centre, limits) else { break };
        answer.iterations += solved;
        (centre, stands) = (forces, found);
        // The states stiffen as the multipliers settle.
        problem.penalty = (4.0 * problem.penalty).min(STIFF);
    }
    answer.status = TwistStatus::IterationLimit { history };
    (centre, stands)
}

/// Plain steps on the states: the problem is solved on them and they are read off again.
fn settle(
    problem: &Tresca,
    limits: &[[f64; 2]],
    stands: &mut [Bound],
    answer: &mut TwistSolution,
    history: &mut Vec<f64>,
) -> Option<Point> {
    let origin = Point { force: vec![0.0; limits.len()], coordinates: vec![0.0; problem.load.len()] };
    for _ in 0..PLAIN_STEPS {
        let value = |i: usize| match stands[i] {
            Bound::Free => 0.0,
            Bound::Low(v) | Bound::High(v) => v,
        };
        let bounds: Vec<(f64, Bound)> = (0..limits.len()).map(|i| (value(i), stands[i])).collect();
        answer.iterations += 1;
        let exact = problem.newton(&origin, &bounds, f64::INFINITY)?;
        let wrong = violation(problem, limits, &exact, stands);
        history.push(wrong);
        answer.residual = wrong;
        if wrong < 1e-10 {
            return Some(exact);
        }
        let gaps = problem.gaps(&exact);
        for (i, stand) in stands.iter_mut().enumerate() {
            let [low, high] = limits[i];
            *stand = match *stand {
                Bound::Free if exact.force[i] < low => Bound::Low(low),
                Bound::Free if exact.force[i] > high => Bound::High(high),
                Bound::Low(_) if gaps[i] < 0.0 => Bound::Free,
                Bound::High(_) if gaps[i] > 0.0 => Bound::Free,
                right @ (Bound::Free | Bound::Low(_) | Bound::High(_)) => right,
            };
        }
    }
    None
}

/// Largest free force beyond its bounds, and slip the wrong way at a bound, relative to the largest limit and the largest elastic slip.
fn violation(problem: &Tresca, limits: &[[f64; 2]], at: &Point, stands: &[Bound]) -> f64 {
    let gaps = problem.gaps(at);
    let largest = limits.iter().map(|l| l[1]).fold(f64::MIN_POSITIVE, f64::max);
    let elastic = (0..limits.len()).map(|i| problem.own[i] * limits[i][1]).fold(f64::MIN_POSITIVE, f64::max);
    (0..limits.len())
        .map(|i| match stands[i] {
            Bound::Free => (at.force[i].abs() - limits[i][1]) / largest,
            Bound::Low(_) => -gaps[i] / elastic,
            Bound::High(_) => gaps[i] / elastic,
        })
        .fold(0.0, f64::max)
}

/// Circumferential displacement at the points, the mean over their stations, as rows on the kept unknowns.
fn around(body: &InterfaceOperator, side: Side, points: usize, stations: &[Station]) -> Mat<f64> {
    let mut rows = Mat::zeros(points, body.stiffness.nrows());
    for station in stations {
        let (edge, t) = station.places[side as usize];
        let ([row, _], _) = body.trace.displacement_row(edge, t);
        for (i, share) in &station.shares {
            row.iter().for_each(|(u, c)| rows[(*i, *u)] += share * c);
        }
    }
    rows
}
