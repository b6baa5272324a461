//! Remarks on the heat of a run, made after it is solved.

use meshing::outline;
use scene::short;

use crate::heat_result::FromCold;
use crate::problem::Problem;
use crate::remark::Remark;
use crate::solution::Solution;
use crate::words::ContactStatus;

/// Part of a body's thickness beyond which a thermal displacement is no small one any more.
const WIDE: f64 = 0.01;

/// Remarks on the heat of a run; none of a scene without it.
pub(crate) fn remarks(problem: &Problem, solution: &Solution) -> Vec<Remark> {
    [several(solution), growing(solution), from_cold(solution), too_hot(solution), too_cold(solution), far(problem, solution)]
        .into_iter()
        .flatten()
        .collect()
}

/// A contact with an odd number of critical speeds below its own.
fn several(solution: &Solution) -> Option<Remark> {
    solution.heat.as_ref()?;
    let message = "Frictional heat makes this contact one of several that carry the load: it lies beyond a speed at which contacts branch. \
                   Slide more slowly, or take less of the heat into the bodies.";
    let branched = solution.contact.as_ref()?.status == ContactStatus::NotUnique;
    branched.then(|| Remark { code: "several-solutions", message: message.into() })
}

/// A shape whose steady pressure does not last.
fn growing(solution: &Solution) -> Option<Remark> {
    let growth = solution.heat.as_ref()?.growth.filter(|growth| *growth > 0.0)?;
    let message = format!(
        "Frictional heat lets deviations from this pressure grow, by e in {} s, instead of wearing off: the shape does not stay worn in. \
         Slide more slowly, or take less of the heat into the bodies.",
        rounded(1.0 / growth)
    );
    Some(Remark { code: "thermoelastic-instability", message })
}

/// A shape that has another contact when it comes to its speed cold.
fn from_cold(solution: &Solution) -> Option<Remark> {
    let what = match solution.heat.as_ref()?.from_cold? {
        FromCold::Carries { largest, ends: [from, to] } => format!(
            "another contact carries the load as well, about from s = {} to {} mm, with some {} MPa at most",
            about(from),
            about(to),
            about(largest)
        ),
        FromCold::Lost => "none that grows from that of the cold bodies carries the load".into(),
    };
    let message = format!(
        "Brought to its speed cold, this shape does not start worn in: at that speed {what}. \
         Only bodies that are as warm as the wanted pressure makes them have that pressure; slide more slowly, or let it wear in."
    );
    Some(Remark { code: "not-worn-in-from-cold", message })
}

/// A material beyond the temperature that it bears.
fn too_hot(solution: &Solution) -> Option<Remark> {
    let told = |text: String, hot: &crate::heat_result::TooHot| {
        let (temperature, limit) = (rounded(hot.temperature), short(hot.limit));
        format!(
            "{text}{}body {} reaches {temperature} degC in a material that bears {limit} degC",
            if text.is_empty() { "" } else { ", " },
            hot.body
        )
    };
    let hot = &solution.heat.as_ref()?.too_hot;
    let message = format!("Too hot: {}.", hot.iter().fold(String::new(), told));
    (!hot.is_empty()).then_some(Remark { code: "too-hot", message })
}

/// Absolute zero (degC).
const ABSOLUTE_ZERO: f64 = -273.15;

/// A surface that is colder than anything can be.
fn too_cold(solution: &Solution) -> Option<Remark> {
    solution.heat.as_ref()?;
    let lowest = |values: &Vec<f64>| values.iter().copied().fold(f64::INFINITY, f64::min);
    let [first, second] = solution.profile.as_ref()?.temperature.each_ref().map(lowest);
    let (body, temperature) = if first <= second { (1, first) } else { (2, second) };
    let message = format!(
        "The surface of body {body} comes to {} degC, which is below absolute zero: more heat is drawn off than comes in.",
        rounded(temperature)
    );
    (temperature < ABSOLUTE_ZERO).then_some(Remark { code: "below-absolute-zero", message })
}

/// A thermal displacement beyond small ones.
fn far(problem: &Problem, solution: &Solution) -> Option<Remark> {
    solution.heat.as_ref()?;
    let (profile, couple) = (solution.profile.as_ref()?, problem.couple.as_ref()?);
    let share = |number: usize| {
        let moved = 1e-3 * profile.thermal_displacement[number].iter().fold(0.0_f64, |max, u| max.max(u.abs()));
        (number, moved, moved / outline(&couple.bodies[number]).thickness)
    };
    let (number, moved, share) = [0, 1].map(share).into_iter().max_by(|a, b| a.2.total_cmp(&b.2))?;
    let message = format!(
        "Heat moves the surface of body {} by {} mm, {} % of the body's thickness: results are those of small displacements, and these are not small.",
        number + 1,
        rounded(moved),
        rounded(100.0 * share)
    );
    (share > WIDE && share.is_finite()).then_some(Remark { code: "thermal-part-not-small", message })
}

/// Two digits.
fn about(number: f64) -> String {
    short(format!("{number:.1e}").parse().unwrap_or(number))
}

/// Three digits.
fn rounded(number: f64) -> String {
    let text = format!("{number:.2e}");
    short(text.parse().unwrap_or(number))
}
