//! What only the result of a run can tell: remarks made after it is solved.

use meshing::outline;
use scene::short;

use crate::hot_hindsight;
use crate::problem::Problem;
use crate::remark::Remark;
use crate::solution::Solution;
use crate::surface::Patch;
use crate::words::Uniqueness;

/// Part of body 1's thickness that wear may take before the body is another one.
const WORN: f64 = 0.1;
/// Part of the scene's friction below which the end of a guarantee is no coefficient but the guarantee's own weakness: it asks for a positive
/// form on all surfaces that could touch, those that never do included.
const BARELY: f64 = 0.01;

/// Part of a threshold pressure up to which a pressure beyond it is the round-off of a run in time.
const AT_THRESHOLD: f64 = 1e-6;
/// Part of body 1's thickness beyond which a gap is no small displacement any more.
const WIDE: f64 = 0.01;

/// Remarks on what a run came to.
pub(crate) fn remarks(problem: &Problem, solution: &Solution) -> Vec<Remark> {
    let notes = [
        other_solutions(problem, solution),
        wide(problem, solution),
        not_worth_machining(solution),
        worn_through(problem, solution),
        no_life(problem, solution),
        worn_free(problem, solution),
        stopped(problem, solution),
        beyond_table(problem, solution),
        late(problem, solution),
        grooved(solution),
    ];
    notes.into_iter().flatten().chain(hot_hindsight::remarks(problem, solution)).collect()
}

/// What friction does to the one solution of a contact.
fn other_solutions(problem: &Problem, solution: &Solution) -> Option<Remark> {
    let found = solution.contact.as_ref()?.uniqueness.as_ref()?;
    let from = found.not_guaranteed_from?;
    let friction = problem.friction.shear();
    let message = match (found.verdict, found.singular_from.or(found.lost_from)) {
        (_, Some(lost)) => format!(
            "The contact followed up from no friction ends at a coefficient of {}: there its system is singular, and beyond it several contacts may be right, or none.",
            rounded(lost)
        ),
        (Uniqueness::Several, _) => {
            "At this friction the contact has several solutions: the one reported is not the one that grows from no friction."
                .into()
        }
        // A guarantee that ends as soon as there is friction tells nothing of this one, whose contact was followed up without branching.
        _ if from < BARELY * friction => return None,
        _ => format!(
            "From a coefficient of friction of {} on nothing guarantees that this is the only contact; the one reported grows from no friction without branching.",
            rounded(from)
        ),
    };
    let branches = matches!(found.verdict, Uniqueness::Singular | Uniqueness::Several);
    let code = if branches { "several-solutions" } else { "not-guaranteed-unique" };
    Some(Remark { code, message })
}

/// A coefficient or an error with the digits it deserves.
fn rounded(coefficient: f64) -> String {
    let text = format!("{coefficient:.2e}");
    short(text.parse().unwrap_or(coefficient))
}

/// A gap beyond small displacements.
fn wide(problem: &Problem, solution: &Solution) -> Option<Remark> {
    let given = problem.gap.spread(problem.patch.as_ref().and_then(Patch::places));
    let gap = solution.shape.as_ref().and_then(|shape| shape.gap_max).map(|gap| 1e-3 * gap).or(given)?;
    let thickness = outline(&problem.couple.as_ref()?.bodies[0]).thickness;
    let share = gap / thickness;
    let message = format!(
        "The gap of {} mm is {} % of the thickness of body 1 at the contact, {} mm: results are those of small displacements, and these are not small.",
        short(gap),
        short(100.0 * share),
        short(thickness)
    );
    (share > WIDE && share.is_finite()).then_some(Remark { code: "gap-not-small", message })
}

/// A shape that drowns in the roughness of its surface.
fn not_worth_machining(solution: &Solution) -> Option<Remark> {
    let machining = solution.machining.as_ref().filter(|machining| machining.worth_machining == Some(false))?;
    let (apart, roughness) = (machining.differs?, machining.roughness?);
    let message = format!(
        "Not worth machining: the shape differs by {} um at most from the surface as it is, less than the roughness of {} um; running in does as much.",
        rounded(apart),
        short(roughness)
    );
    Some(Remark { code: "not-worth-machining", message })
}

/// Wear beyond what body 1's stiffness stands for.
fn worn_through(problem: &Problem, solution: &Solution) -> Option<Remark> {
    let depth = 1e-3 * solution.wear.as_ref()?.depth?;
    let thickness = outline(&problem.couple.as_ref()?.bodies[0]).thickness;
    let allowed = WORN * thickness;
    // Without a thickness nothing can be said.
    if depth <= allowed || !allowed.is_finite() {
        return None;
    }
    let column = |name: &str| solution.history.iter().find(|(known, _)| known == name).map(|(_, values)| values.as_slice());
    let rows = column("time_s").zip(column("depth_um"));
    let within = rows.and_then(|(times, depths)| times.iter().zip(depths).take_while(|(_, d)| 1e-3 * **d <= allowed).last());
    let until = within.map_or(String::new(), |(time, _)| format!(" (up to {} s it is less)", short(*time)));
    let lined = problem.couple.as_ref()?.bodies[0].materials.len() > 1;
    let whose = if lined { "its lining's" } else { "its" };
    let message = format!(
        "Wear takes {} mm off body 1, more than a tenth of {whose} thickness of {} mm{until}; the bodies keep the stiffness they have unworn.",
        short(depth),
        short(thickness)
    );
    Some(Remark { code: "wear-beyond-body", message })
}

/// A life that is asked for, and that the run in time ends too early to tell.
fn no_life(problem: &Problem, solution: &Solution) -> Option<Remark> {
    let (wearable, wear) = (problem.wear.wearable.as_ref()?, solution.wear.as_ref()?);
    let told = wear.life.is_some() || solution.pressure.as_ref().is_some_and(|pressure| pressure.life.is_some());
    let message = format!(
        "No life is told: the run ends before the {} mm of body 1 that may wear off are gone, and before its wear is steady; end it later, or write until = \"steady\".",
        short(wearable.thickness)
    );
    (!told).then_some(Remark { code: "no-life", message })
}

/// How the pressure under a prescribed approach ends: the wear takes away the closing that makes it, so that `p' = -C p^b`.
fn worn_free(problem: &Problem, solution: &Solution) -> Option<Remark> {
    solution.wear.as_ref().filter(|_| problem.load.approach.is_some() && !problem.wear.own_rule)?;
    let law = if problem.wear.lowest_threshold().is_some() {
        "its pressure falls to the threshold of the wear rule, and what is left of it no longer wears".into()
    } else {
        powers_free(problem.wear.exponents.as_slice())?
    };
    let message = format!("Under a prescribed approach the contact wears itself free: {law}.");
    Some(Remark { code: "wears-itself-free", message })
}

/// The same of powers of the pressure; none of two different ones.
fn powers_free(exponents: &[f64]) -> Option<String> {
    let [exponent] = *exponents else { return None };
    let law = if exponent > 1.0 {
        format!(
            "with b = {} the pressure falls in the long run like t^(-1/(b - 1)) = t^-{}",
            short(exponent),
            short(1.0 / (exponent - 1.0))
        )
    } else if exponent == 1.0 {
        "with b = 1 the pressure falls exponentially in the long run".into()
    } else {
        format!("with b = {} the pressure is gone after a finite time", short(exponent))
    };
    Some(law)
}

/// Wear that has come to an end because the pressure is nowhere above the threshold any more.
fn stopped(problem: &Problem, solution: &Solution) -> Option<Remark> {
    let ended = solution.wear.as_ref().is_some_and(|wear| wear.steady);
    let threshold = problem.wear.lowest_threshold().filter(|_| ended)?;
    let largest = solution.profile.as_ref()?.pressure.iter().copied().fold(0.0, f64::max);
    let message = format!(
        "Wear has stopped: the pressure is nowhere above the threshold of {} MPa any more. No feed goes on, and the shape at the end depends on that at the start.",
        short(threshold)
    );
    (largest <= threshold * (1.0 + AT_THRESHOLD)).then_some(Remark { code: "wear-stopped", message })
}

/// Pressures beyond the last one of a table of wear factors.
fn beyond_table(problem: &Problem, solution: &Solution) -> Option<Remark> {
    let (last, _) = problem.scene.wear.as_ref()?.table.as_ref()?.last()?;
    let optimal = solution.pressure.as_ref().and_then(|pressure| pressure.p_max);
    let worn = solution.profile.iter().flat_map(|profile| &profile.pressure).copied();
    let largest = optimal.into_iter().chain(worn).fold(0.0, f64::max);
    let message = format!(
        "The pressure reaches {} MPa and the wear table ends at {} MPa: beyond it wear is taken to go on as the straight line that the table ends with.",
        short(largest),
        short(last.0)
    );
    (largest > last.0).then_some(Remark { code: "beyond-wear-table", message })
}

/// A groove that the contact knows by its mean.
fn grooved(solution: &Solution) -> Option<Remark> {
    let ratio = solution.wear.as_ref()?.groove.as_ref()?.depth_ratio;
    let message = format!(
        "The groove in body 2 is {} of the depth worn off body 1; the contact knows it by its mean around the axis of the ball, which leaves out about {} of that depth.",
        rounded(ratio),
        rounded(ratio * ratio)
    );
    Some(Remark { code: "groove-mean", message })
}

/// A time that is less accurate than the shape.
fn late(problem: &Problem, solution: &Solution) -> Option<Remark> {
    let wear = solution.wear.as_ref()?;
    let accuracy = problem.wanted.accuracy;
    let error = wear.run_in_error.filter(|error| *error > accuracy && problem.wanted.fixed.is_none())?;
    let what = if wear.to_1_percent.is_some() { "time to 1 % of the steady pressure" } else { "depth worn off" };
    let message = format!("The {what} is accurate to {}, not to the {} asked for.", rounded(error), short(accuracy));
    Some(Remark { code: "time-less-accurate", message })
}

#[cfg(test)]
mod tests {
    use scene::{Document, builtin};

    use super::*;
    use crate::results::{ContactResult, UniquenessResult};

    /// The remark on a drum brake with friction 0.25 whose contact is unique, or not, from some coefficients on.
    fn said(verdict: Uniqueness, not_guaranteed_from: f64, singular_from: Option<f64>) -> Option<(&'static str, String)> {
        let document = Document::read("scene", builtin("drum-brake-block")?.text, &[]).ok()?;
        let problem = Problem::new(&document, &|_| Err("no file".into())).ok()?;
        let found = UniquenessResult { verdict, not_guaranteed_from: Some(not_guaranteed_from), singular_from, lost_from: None };
        let contact = ContactResult { uniqueness: Some(found), ..ContactResult::default() };
        let solution = Solution { contact: Some(contact), ..Solution::default() };
        other_solutions(&problem, &solution).map(|remark| (remark.code, remark.message))
    }

    #[test]
    fn a_guarantee_that_ends_at_once_is_no_word_about_this_friction() {
        assert_eq!(said(Uniqueness::NotGuaranteed, 3.0518e-6, None), None);
        let (code, message) = said(Uniqueness::NotGuaranteed, 0.123456, None).unwrap_or_default();
        assert_eq!(code, "not-guaranteed-unique");
        assert!(message.contains("a coefficient of friction of 0.123 on"), "{message}");
    }

    #[test]
    fn a_contact_that_branches_is_said_wherever_its_guarantee_ended() {
        let (code, message) = said(Uniqueness::Singular, 3.0518e-6, Some(0.204_567)).unwrap_or_default();
        assert_eq!(code, "several-solutions");
        assert!(message.contains("at a coefficient of 0.205:"), "{message}");
        let (code, _) = said(Uniqueness::Several, 0.0, None).unwrap_or_default();
        assert_eq!(code, "several-solutions");
    }
}
