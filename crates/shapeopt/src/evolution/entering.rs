//! Steps that end where a point comes into contact.
//!
//! A contact that grows as it wears takes up a new point within the time of its shortest ripple, which steps are far longer than: for a step the rates
//! jump there. Implicit stages need no rate at the start of a step, so that a step which ends just before the jump has the error of its order, and so has
//! the next one.

use crate::evolution::Evolution;
use crate::evolution::control::GROWTH;
use crate::stage_contact::Contact;
use crate::wear_problem::Scheme;
use crate::wear_state::{Entering, WearState};
use crate::wear_step::Trial;

/// Times that a step is cut to end where a point enters, and the least and largest part of it that is left.
const CUTS: usize = 3;
const LEAST: f64 = 0.02;
const LARGEST: f64 = 0.9;
/// Least part of a step that its error tells to try next: errors just after a point has entered fall with the step itself.
const SHARPEST: f64 = 0.03;
/// How many times longer than by the last error alone a step becomes where errors grow slower than by the order.
const SMOOTHER: f64 = 4.0;
/// How many times longer than after the last point that entered the first step after the next one is tried.
const LONGER: f64 = 2.0;

impl Evolution<'_> {
    /// The factor on a step with an error, which the order of the error tells, where points enter as it goes: just after one has entered errors fall with the
    /// step itself, and farther from it they grow slower than by the order, as the last two of them tell (Gustafsson 1994).
    pub(super) fn where_points_enter(
        &self,
        state: &WearState,
        (step, error): (f64, f64),
        (ratio, power): (f64, f64),
        told: f64,
    ) -> f64 {
        if !self.one_by_one() {
            return told;
        }
        if ratio < 1.0 {
            return (0.9 * ratio).clamp(SHARPEST, told);
        }
        if told <= 1.0 || state.error == 0.0 || error == 0.0 {
            return told;
        }
        let slower = step / state.step_size * (state.error / error).powf(1.0 / power);
        (told * slower.clamp(1.0, SMOOTHER)).min(GROWTH)
    }

    /// Whether points enter one by one for a step, at once against its length: a flat worn on a ball, deep against all that the bodies give way by, which is
    /// integrated with order 2. Elsewhere steps are as long as points take to come to their pressure, and levels would be apart by what this leaves of steps.
    fn one_by_one(&self) -> bool {
        self.problem.growing && self.problem.scheme == Scheme::Sdirk2
    }

    /// What a step tells of the points that enter: to be called before the contact of the state is that after the step.
    pub(super) fn await_next(&self, state: &mut WearState, after: &Contact, step: f64) {
        if self.one_by_one() {
            state.entering = entering(state, after, step);
        }
    }

    /// Part of a step whose error is too large that is tried next: up to where the first of the points that touch in it does, or the part that the error tells.
    pub(super) fn part_to_try(&self, state: &WearState, trial: Option<&Trial>, (failures, told): (usize, f64)) -> f64 {
        let entering = trial.filter(|_| self.problem.growing && failures < CUTS).and_then(|trial| first_to_enter(state, trial));
        entering.map_or(told, |part| part.clamp(LEAST, LARGEST))
    }
}

impl WearState {
    /// The step to try first: no farther than to where the next point is expected to enter, and after one has entered about as far as after the one before.
    pub(super) fn first_to_try(&self) -> f64 {
        let Entering { entered, expected, first_step } = self.entering;
        match (entered, expected > 0.0) {
            (true, _) if first_step > 0.0 => self.next_step.min(LONGER * first_step),
            (false, true) => self.next_step.min(expected.max(LEAST * self.next_step)),
            _ => self.next_step,
        }
    }
}

/// What is known of the points that enter after a step from a state to a contact; bodies go on to approach each other as they did in the step.
fn entering(state: &WearState, after: &Contact, step: f64) -> Entering {
    let open = |i: &usize| state.pressure[*i] == 0.0;
    let points = 0..state.pressure.len();
    let entered = points.clone().filter(open).any(|i| after.pressure[i] > 0.0);
    let closing = points.filter(open).filter(|i| after.opening[*i] > 0.0 && after.opening[*i] < state.opening[*i]);
    let until = |i: usize| step * after.opening[i] / (state.opening[i] - after.opening[i]);
    let expected = closing.map(until).reduce(f64::min).unwrap_or(0.0);
    let first_step = if state.entering.entered { step } else { state.entering.first_step };
    Entering { entered, expected, first_step }
}

/// Part of a step after which the first of the points that enter the contact in it does; none if none does. The bodies approach each other there as fast
/// as at the nearest point that stays open.
fn first_to_enter(state: &WearState, trial: &Trial) -> Option<f64> {
    let n = state.opening.len();
    let open = |i: &usize| state.pressure[*i] == 0.0 && !trial.touched[*i];
    let closes = |i: usize| {
        let nearest = (0..n).filter(open).min_by_key(|j| j.abs_diff(i))?;
        let approach = state.opening[nearest] - trial.contact.opening[nearest];
        (approach > state.opening[i]).then(|| state.opening[i] / approach)
    };
    let entering = (0..n).filter(|i| state.pressure[*i] == 0.0 && trial.touched[*i]);
    entering.filter_map(closes).reduce(f64::min)
}

#[cfg(test)]
mod tests {
    use super::{entering, first_to_enter};
    use crate::stage_contact::Contact;
    use crate::wear_state::{Entering, WearState};
    use crate::wear_step::Trial;

    /// Openings of 1, 2 and 5 um, all of which fall by 4 um in the step: the first point touches after a quarter of it, and the second after half.
    #[test]
    fn the_first_point_to_touch_tells_where_the_step_is_cut() {
        let state = WearState { pressure: vec![7.0, 0.0, 0.0, 0.0], opening: vec![0.0, 1.0, 2.0, 5.0], ..WearState::default() };
        let trial = |touched: [bool; 4]| Trial {
            contact: Contact { pressure: vec![7.0, 1.0, 1.0, 0.0], opening: vec![0.0, 0.0, 0.0, 1.0], coordinates: Vec::new() },
            touched: touched.to_vec(),
            ..Trial::default()
        };
        assert_eq!(first_to_enter(&state, &trial([true, true, true, false])), Some(0.25));
        assert_eq!(first_to_enter(&state, &trial([true, false, false, false])), None);
        assert_eq!(first_to_enter(&state, &trial([true; 4])), None, "no point tells how fast the bodies approach");
    }

    /// Openings of 4 and 9 um that fall to 3 and 7 um in 2 s: the first point is expected after 6 s, and the step ends there. It enters with a step of 5 s; the
    /// one after that is as long as its error lets it, .25 s, and so is tried first after the next point.
    #[test]
    fn steps_end_at_the_next_point_and_begin_as_after_the_last() {
        let contact = |pressure: [f64; 3], opening: [f64; 3]| Contact {
            pressure: pressure.to_vec(),
            opening: opening.to_vec(),
            coordinates: Vec::new(),
        };
        let mut state =
            WearState { pressure: vec![7.0, 0.0, 0.0], opening: vec![0.0, 4.0, 9.0], next_step: 8.0, ..WearState::default() };
        assert_eq!(state.first_to_try(), 8.0, "nothing is known yet");

        state.entering = entering(&state, &contact([7.0, 0.0, 0.0], [0.0, 3.0, 7.0]), 2.0);
        assert_eq!(state.entering, Entering { entered: false, expected: 6.0, first_step: 0.0 });
        assert_eq!(state.first_to_try(), 6.0);

        state.entering = entering(&state, &contact([6.0, 1.0, 0.0], [0.0, 0.0, 5.0]), 5.0);
        assert!(state.entering.entered);
        assert_eq!(state.first_to_try(), 8.0, "no step is known that follows a point");

        (state.pressure, state.opening) = (vec![6.0, 1.0, 0.0], vec![0.0, 0.0, 5.0]);
        state.entering = entering(&state, &contact([6.0, 2.0, 0.0], [0.0, 0.0, 5.0]), 0.25);
        assert_eq!(state.entering, Entering { entered: false, expected: 0.0, first_step: 0.25 });

        state.entering.entered = true;
        assert_eq!(state.first_to_try(), 0.5);
    }
}
