//! The surface as it is now against as machined, of a scene that asks for the contact and for the shape.

use crate::machining_result::MachiningResult;
use crate::problem::Problem;
use crate::profile::Profile;
use crate::solution::Solution;
use crate::step::Step;

/// Part of the surface under pressure, of a reversing motion in one sense at least.
fn share(curve: &Profile) -> f64 {
    let pressed = |row: &usize| curve.pressure[*row] > 0.0 || curve.pressure_back.get(*row).is_some_and(|back| *back > 0.0);
    let all = 0..curve.weight.len();
    all.filter(pressed).map(|row| curve.weight[row]).sum::<f64>() / curve.weight.iter().sum::<f64>()
}

/// Most that lies between the surface as it is and the one as machined, once they touch (um).
fn difference(now: &Profile, then: &Profile) -> Option<f64> {
    let apart = then.s.iter().zip(&then.gap).map(|(s, gap)| gap - at(now, *s));
    let [least, most] = apart.fold([f64::INFINITY, f64::NEG_INFINITY], |[least, most], d| [least.min(d), most.max(d)]);
    Some(most - least).filter(|depth| depth.is_finite())
}

/// Gap of a profile at an arc length, straight between its points (um).
fn at(profile: &Profile, s: f64) -> f64 {
    let after = profile.s.partition_point(|place| *place < s).clamp(1, profile.s.len().max(2) - 1);
    let (Some([from, to]), Some([low, high])) = (profile.s.get(after - 1..=after), profile.gap.get(after - 1..=after)) else {
        return f64::NAN;
    };
    let t = ((s - from) / (to - from)).clamp(0.0, 1.0);
    low + t * (high - low)
}

/// Takes down what a step says of the surface as it is now and as machined.
pub(crate) fn compare(problem: &Problem, step: Step, solution: &mut Solution) {
    let both = problem.plan.runs(Step::Contact) && problem.plan.runs(Step::Shape);
    let Some(curve) = solution.curve.as_ref().filter(|_| both) else { return };
    let share = share(curve);
    match (step, solution.machining.as_mut()) {
        (Step::Contact, _) => {
            let Some(contact) = &solution.contact else { return };
            let roughness = problem.scene.contact.as_ref().and_then(|contact| contact.roughness).map(|depth| 1e3 * depth.0);
            let p_max_now = contact.p_max;
            let now = MachiningResult { p_max_now, contact_share_now: share, roughness, ..MachiningResult::default() };
            (solution.machining, solution.unmachined) = (Some(now), Some(curve.clone()));
        }
        (Step::Shape, Some(machining)) => {
            let both_senses = solution.reversing.as_ref().map(|senses| senses.forward.p_max.max(senses.back.p_max));
            machining.p_max_then = both_senses.or(solution.pressure.as_ref().and_then(|pressure| pressure.p_max));
            machining.contact_share_then = Some(share);
            machining.gap_max = solution.shape.as_ref().and_then(|shape| shape.gap_max);
            machining.differs = solution.unmachined.as_ref().and_then(|now| difference(now, curve));
            machining.worth_machining = machining.differs.zip(machining.roughness).map(|(depth, roughness)| depth > roughness);
        }
        (Step::Evolution, Some(machining)) => {
            let settled = solution.wear.as_ref().and_then(|wear| wear.to_1_percent.as_ref());
            machining.run_in_distance_saved = settled.map(|settled| settled.distance);
        }
        _ => {}
    }
}
