//! Steps that end where a point comes into contact.
//!
//! A contact that grows as it wears takes up a new point within the time of its shortest ripple, which steps are far longer than: for a step the rates
//! jump there. Implicit stages need no rate at the start of a step, so that a step which ends just before the jump has the error of its order, and so has
//! the next one.

use crate::evolution::Evolution;
use crate::wear_state::WearState;
use crate::wear_step::Trial;

/// Times that a step is cut to end where a point enters, and the least and largest part of it that is left.
const CUTS: usize = 3;
const LEAST: f64 = 0.02;
const LARGEST: f64 = 0.9;

impl Evolution<'_> {
    /// Part of a step whose error is too large that is tried next: up to where the first of the points that touch in it does, or the part that the error tells.
    pub(super) fn part_to_try(&self, state: &WearState, trial: Option<&Trial>, (failures, told): (usize, f64)) -> f64 {
        let entering = trial.filter(|_| self.problem.growing && failures < CUTS).and_then(|trial| first_to_enter(state, trial));
        entering.map_or(told, |part| part.clamp(LEAST, LARGEST))
    }
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
    use super::first_to_enter;
    use crate::stage_contact::Contact;
    use crate::wear_state::WearState;
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
}
