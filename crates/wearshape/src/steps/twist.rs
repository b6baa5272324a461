//! Body 1 turned about the axis under its pressure: stick and slip around the axis, step after step.

use contact::{ContactOperator, ContactSolution, Pair, TorsionOperator, Turn, TwistSolution, TwistStatus, piecewise_linear};
use scene::{Fault, short};

use crate::faults::unsolved;
use crate::problem::Problem;
use crate::profile::Profile;
use crate::results::{ContactResult, TwistResult};
use crate::words::PointStatus;

/// The history of a twist at one level.
pub(crate) struct Twist {
    /// The end of the last step.
    pub last: TwistSolution,
    result: TwistResult,
    /// 1 or -1: the sense in which body 2 moved past body 1 in the last step, anti-clockwise positive.
    sense: f64,
    /// What levels are compared by.
    pub told: Turned,
    /// Why there is no answer.
    pub refused: Option<String>,
}

/// What the steps of a twist come to.
pub(crate) struct Turned {
    /// Torque or angle of each step, whichever is not given.
    answers: Vec<f64>,
    /// Where the outermost zone of stick ends after each step (mm from the axis).
    sticks: Vec<f64>,
}

/// Least distance of the end of stick of a step from the axis, the end of contact and that of another step, over the end of contact, for a node of its own.
const APART: f64 = 0.05;

impl Turned {
    /// The largest difference of the steps over the largest answer: what stays of the slip of a step has a kink where that ended, so that one step may be
    /// right by chance.
    pub(crate) fn apart(&self, other: &Turned) -> f64 {
        let largest = other.answers.iter().fold(0.0_f64, |most, answer| most.max(answer.abs()));
        let apart = self.answers.iter().zip(&other.answers).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max);
        if apart == 0.0 { 0.0 } else { apart / largest }
    }

    /// Places for element nodes, from the axis, in a contact with these ends: the ends of stick after all steps, of close ones the latest.
    pub(crate) fn nodes(&self, ends: &[f64]) -> Vec<f64> {
        let (end, mut nodes) = (ends.last().copied().unwrap_or(0.0), Vec::<f64>::new());
        for stick in self.sticks.iter().rev() {
            let far = nodes.iter().chain(&[0.0, end]).all(|node| (stick - node).abs() >= APART * end);
            nodes.extend(Some(*stick).filter(|_| far));
        }
        nodes.sort_unstable_by(f64::total_cmp);
        nodes
    }
}

impl Twist {
    /// Turns body 1 as the scene asks; `pair` is the bodies' scalar problem, `found` their contact, pressed without shear.
    pub(crate) fn new(problem: &Problem, pair: &Pair<'_>, found: &ContactSolution) -> Result<Option<Twist>, Fault> {
        let turns = &problem.load.turns;
        let Some(first) = turns.first() else { return Ok(None) };
        let operator = TorsionOperator::new(pair).map_err(unsolved)?;
        let friction = problem.friction.coefficient;
        let limits: Vec<f64> = found.nodal_force.iter().map(|force| friction * force.max(0.0)).collect();
        let mut result = TwistResult { slip_torque: operator.slip_torque(&limits), ..TwistResult::default() };
        let mut sticks = Vec::new();
        let mut step = |turn: Turn, slip: &[f64]| -> Result<TwistSolution, Fault> {
            let at = operator.solve(&limits, turn, slip).map_err(unsolved)?;
            if at.status.is_solved() {
                result.angle.push(at.angle);
                result.torque.push(at.torque);
                sticks.extend(at.stick.last().map(|[_, to]| to));
            }
            Ok(at)
        };
        let mut last = step(*first, &vec![0.0; limits.len()])?;
        for turn in &turns[1..] {
            if !last.status.is_solved() {
                break;
            }
            last = step(*turn, &last.slip)?;
        }
        let amount = |step: usize| match turns.get(step) {
            Some(Turn::Angle(amount) | Turn::Torque(amount)) => *amount,
            None => 0.0,
        };
        let before = if turns.len() > 1 { amount(turns.len() - 2) } else { 0.0 };
        let sense = if amount(turns.len() - 1) > before { -1.0 } else { 1.0 };
        result.status = (&last.status).into();
        let refused = match &last.status {
            status if status.is_solved() => None,
            TwistStatus::TurnsThrough => {
                let [most, torque] = [result.slip_torque, last.torque].map(short);
                Some(format!("{}: {most} N mm against {torque} N mm", last.status))
            }
            status => Some(status.to_string()),
        };
        let answers = if matches!(first, Turn::Angle(_)) { result.torque.clone() } else { result.angle.clone() };
        Ok(Some(Twist { last, result, sense, told: Turned { answers, sticks }, refused }))
    }

    /// Into the result of the contact; `start` is the surface coordinate where the path starts.
    pub(crate) fn report(&self, contact: &mut ContactResult, start: f64) {
        contact.stick_ends = self.last.stick.iter().flatten().map(|arc| start + arc).collect();
        let largest = self.last.shear.iter().fold(0.0_f64, |most, q| most.max(q.abs()));
        contact.q_max = Some(largest).filter(|_| contact.edge_exponents.is_empty());
        contact.twist = Some(self.result.clone());
    }

    /// Shear and states into the rows of a profile, which lie anywhere on the surface.
    pub(crate) fn fill(&self, operator: &ContactOperator<'_>, profile: &mut Profile, start: f64) {
        let arcs: Vec<f64> = operator.points().iter().map(|p| p.arc).collect();
        for row in 0..profile.s.len() {
            let arc = profile.s[row] - start;
            // Nothing slides steadily.
            profile.wear_rate[row] = f64::NAN;
            profile.shear[row] = self.sense * self.shear_at(operator, &arcs, arc);
            let sticks = self.last.stick.iter().any(|[from, to]| (*from..=*to).contains(&arc));
            profile.status[row] = match profile.status[row] {
                PointStatus::Open => PointStatus::Open,
                _ if sticks => PointStatus::Stick,
                _ => PointStatus::Slip,
            };
        }
    }

    /// The polynomial through the points of an edge on which all points stick, or all slip; straight lines on the others.
    fn shear_at(&self, operator: &ContactOperator<'_>, arcs: &[f64], arc: f64) -> f64 {
        let (edge, _) = operator.pair().trace().locate(arc);
        let states = &self.last.states[operator.edge_points(edge)];
        let inner = &states[1..states.len() - 1];
        if inner.windows(2).all(|two| two[0] == two[1]) {
            operator.value_at(&self.last.shear, arc)
        } else {
            piecewise_linear(arcs, &self.last.shear, arc)
        }
    }
}
