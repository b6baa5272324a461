//! Which balls on revolving discs are built.

use meshing::Couple;
use scene::Fault;
use wear::Counterface;

use crate::problem::Problem;

/// Refuses a track that no ball has, and a revolving counter-face without one.
pub(super) fn available(
    problem: &Problem,
    couple: &Couple,
    refuse: &dyn Fn(&str, &str, &str) -> Result<(), Fault>,
) -> Result<(), Fault> {
    let revolving = problem.wear.counterface == Counterface::Revolving;
    let first_wears = problem.wear.own_rule || problem.wear.laws.as_ref().is_ok_and(|laws| laws.wears(0));
    if !first_wears && problem.wear.counterface == Counterface::Fresh {
        let message = "body 1 does not wear, and a plate that is always new leaves the contact as it is";
        return refuse(
            "wear.k",
            message,
            "give body 1 a wear factor, as in wear.k = [1e-8, 1e-8], or write tasks = [\"contact\"]",
        );
    }
    if problem.track().is_none() {
        if !revolving {
            return Ok(());
        }
        let message = "body 2 has no closed track under this contact, nor a stroke to and fro";
        let remedy = "give sliding.track_radius of a ball on a disc, or sliding.cycle, or write \"fresh\" for a long plate";
        return refuse("wear.counterface", message, remedy);
    }
    if !couple.is_revolved() {
        let message = "a cylinder across a track has another speed at each of its ends";
        return refuse("sliding.track_radius", message, "give it to a ball (kinematics = \"axisymmetric\"), or leave it out");
    }
    if !revolving {
        let message = "a disc with a track revolves under the ball";
        return refuse("wear.counterface", message, "write \"revolving\", or leave out sliding.track_radius");
    }
    let Ok(laws) = &problem.wear.laws else { return Ok(()) };
    if !laws.wears(1) {
        return Ok(());
    }
    if !laws.wears(0) {
        let message = "a ball that does not wear sinks into a groove of its own shape, which is no contact about its axis";
        return refuse("wear.k", message, "give both bodies a wear factor");
    }
    if problem.wear.exponents.len() > 1 {
        let message = "a groove is known where both bodies wear with the same power of the pressure";
        return refuse("wear.b", message, "give one b for both bodies");
    }
    Ok(())
}
