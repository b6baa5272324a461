//! What the theory has to say about a scene before it is solved.

use scene::{Balance, Functional, Modes, Task, with_short_numbers};
use wear::Shape;

use crate::freedom::{Role, guided_moment};
use crate::functional::{functional_row, s_minus_1};
use crate::gap::Noise;
use crate::problem::{Optimum, Problem};
use crate::remark::Remark;
use crate::surface::Patch;

/// All remarks, in a fixed order.
pub(super) fn remarks(problem: &Problem, tasks: &[Task]) -> Vec<Remark> {
    let mut found = Vec::new();
    let mut say = |code: &'static str, message: String| found.push(Remark { code, message: with_short_numbers(&message) });
    materials(problem, &mut say);
    expansions(problem, &mut say);
    guide(problem, &mut say);
    if let Some(residual) = problem.gap.residual {
        let [rms, most] = [residual.rms, residual.most].map(scene::short);
        say(
            "smoothed-gap",
            format!(
                "The gap is the smoothest curve near the rows of the profile: {rms} um from them in the root mean square, {most} um at most."
            ),
        );
    }
    noise(problem, tasks, &mut say);
    if problem.wear.of_friction && problem.friction.coefficient == 0.0 && tasks != [Task::Contact] {
        let message = "Friction is 0 and wear.beta stands in front of the friction stress: nothing wears, and rates, powers, multipliers and feed are 0. Pressure and shape are as for vanishing friction; wear.k wears without friction.";
        say("no-wear", message.to_string());
    }
    if let Some([first, second]) = problem.patch.as_ref().and_then(Patch::radii).filter(|_| tasks.contains(&Task::Shape)) {
        let message = format!(
            "Body 1 is drawn with a radius of {first} mm, the circle that it runs on has {second} mm: the shape is that of this circle with the gap taken off, and what is between both as they are drawn comes on top."
        );
        say("other-radius", message);
    }
    if tasks.contains(&Task::Pressure) || tasks.contains(&Task::Shape) {
        optimum(problem, &mut say);
        kern(problem, &mut say);
        jamming(problem, &mut say);
    }
    found
}

/// Rows of a profile that are those of noise.
fn noise(problem: &Problem, tasks: &[Task], say: &mut impl FnMut(&'static str, String)) {
    let followed = tasks.iter().any(|task| matches!(task, Task::Contact | Task::Wear));
    let surface = problem.patch.as_ref().and_then(|patch| patch.places()).filter(|_| followed);
    let Some(Noise { bends: [bends, rows], digit, deviation }) = surface.and_then(|surface| problem.gap.noise(surface)) else {
        return;
    };
    // Two digits; a little more than the noise leaves the curve room to be smooth.
    let two_digits = |value: f64| {
        let unit = 10f64.powf(value.log10().floor() - 1.0);
        scene::short((value / unit).round() * unit)
    };
    let [deviation, smooth] = [deviation, 1.1 * deviation].map(two_digits);
    let how = match digit {
        Some(digit) => format!(
            "The rows of the gap's profile are rounded to {} um, more than they bend from one to the next, and the gap goes through each of them",
            scene::short(digit)
        ),
        None => format!(
            "The gap goes through every row of its profile and bends back and forth at {bends} of {rows}, as noise of {deviation} um would"
        ),
    };
    let remedy = format!("contact.gap = {{ profile = ..., smooth = \"{smooth} um\" }} takes the smooth curve");
    say("noisy-gap", format!("{how}: it may touch in spots. Of a measured profile, {remedy}."));
}

/// Moduli that no material has, each said once a body, by the name of the material where cells bring their own.
fn materials(problem: &Problem, say: &mut impl FnMut(&'static str, String)) {
    let own = [&problem.scene.body1, &problem.scene.body2];
    for (body, own) in problem.couple.iter().flat_map(|couple| &couple.bodies).zip(own) {
        let mut said: Vec<f64> = Vec::new();
        for young in body.materials.iter().flat_map(|material| material.young.each()).map(|young| young.0) {
            if (1.0..=1.3e6).contains(&young) || said.contains(&young) {
                continue;
            }
            said.push(young);
            let name =
                own.as_ref().and_then(|own| name_of(own, young)).map_or(String::new(), |name| format!(" (material {name})"));
            let of = body.key.replace("body", "body ");
            say(
                "young-implausible",
                format!(
                    "Young's modulus of {of} is {young} MPa{name}: is the unit right? Steel has 210 GPa, rubber 1 to 10 MPa."
                ),
            );
        }
    }
}

/// Expansions that no solid has.
fn expansions(problem: &Problem, say: &mut impl FnMut(&'static str, String)) {
    for body in problem.heat.iter().zip(&problem.couple).flat_map(|(_, couple)| &couple.bodies) {
        let alphas = body.materials.iter().filter_map(|material| material.expansion).map(|alpha| alpha.0);
        let largest = alphas.fold(0.0, f64::max);
        if largest > IMPLAUSIBLE {
            let of = body.key.replace("body", "body ");
            let message =
                format!("{of} expands by {largest} for each kelvin: is the power of ten right? Steel has 12e-6, rubber 2e-4.");
            say("expansion-implausible", message);
        }
    }
}

/// Thermal expansion (1/K) beyond that of any solid.
const IMPLAUSIBLE: f64 = 2e-3;

/// Names of the materials of cells with a modulus.
fn name_of(body: &scene::Body, young: f64) -> Option<String> {
    let materials = body.geometry.materials()?;
    let names: Vec<&str> = materials
        .iter()
        .filter(|(_, own)| own.young.each().iter().any(|own| own.0 == young))
        .map(|(name, _)| name.as_str())
        .collect();
    (!names.is_empty()).then(|| names.join(", "))
}

/// A moment of the load that goes into the supports.
fn guide(problem: &Problem, say: &mut impl FnMut(&'static str, String)) {
    let Some((couple, patch)) = problem.couple.as_ref().zip(problem.patch.as_ref()) else { return };
    let Some(moment) = guided_moment(couple, &problem.load, patch) else { return };
    let edges: Vec<&str> = couple.bodies[0].supports.keys().map(String::as_str).collect();
    let guides = edges.join(" and ");
    say(
        "moment-on-guide",
        format!(
            "Body 1 is held against tilting by {guides}: that carries the load's moment of {moment} N mm about the middle of the contact, and the pressure does not."
        ),
    );
}

/// What the theory says of the functional.
fn optimum(problem: &Problem, say: &mut impl FnMut(&'static str, String)) {
    let Optimum { functional, q, balance, modes, .. } = problem.optimum;
    let curved = problem.patch.as_ref().is_some_and(|patch| matches!(patch.surface.shape(), Shape::Arc { .. }));
    let bent = problem.friction.on_bodies && problem.friction.coefficient != 0.0 || balance == Balance::Paper;
    // Kinematic modes whose balance is another one have a stationary pressure and no functional of which it is an extremum.
    let no_extremum = curved && bent && modes == Modes::Kinematic;
    if functional_row(functional).needs.q {
        for b in &problem.wear.exponents {
            let s_minus_1 = s_minus_1(functional, *b, q);
            let s = 1.0 + s_minus_1;
            if s_minus_1.abs() < 1e-12 {
                say("s-one", "s = 1: the functional has no regular optimum; its bound is approached by pressure on points or lines (the limit measure).".into());
            } else if s < 1.0 {
                let what = match no_extremum {
                    true => "the stationary pressure is no minimum of the functional, and others are better",
                    false => "the stationary pressure is the worst one, a maximum of the functional",
                };
                say("s-below-one", format!("s = {s:.6} is less than 1: {what}."));
            }
        }
    }
    if curved && functional == Functional::Uniform {
        say("not-steady", "Uniform pressure on an arc wears uniformly along the normal, which no rigid motion follows: it is not the steady state. optimum.functional = \"steady\" is.".into());
    }
    if curved && balance == Balance::Paper {
        say("paper-balance", "The paper's normalisation int p dS = F0 leaves out the direction of the pressure: the vertical force comes out smaller than the load (summary: force_N), and a shape is found under the force that this pressure carries.".into());
    }
}

/// Friction that lifts body 1 where it is pressed.
fn jamming(problem: &Problem, say: &mut impl FnMut(&'static str, String)) {
    let push = problem.freedoms.iter().find(|freedom| freedom.role == Role::Force);
    let (Some(patch), Some(push)) = (&problem.patch, push) else { return };
    let mu = problem.friction.shear();
    let weights = patch.surface.sample(201).into_iter().map(|point| push.mode.motion.force_weight(&point, mu));
    if weights.fold(f64::MAX, f64::min) <= 0.0 && mu > 0.0 {
        let message = format!(
            "With friction {mu} part of the surface lifts body 1 when pressed (self-locking): the load may have no balance."
        );
        say("jamming", message);
    }
}

/// Moments on a plane strip: full contact needs |M| <= F c k / (k + 2), k = 1/(s - 1).
fn kern(problem: &Problem, say: &mut impl FnMut(&'static str, String)) {
    let Some(Shape::Strip { x, .. }) = problem.patch.as_ref().map(|patch| patch.surface.shape()) else {
        return;
    };
    let find = |role: Role| problem.freedoms.iter().find(|freedom| freedom.role == role).map(|freedom| freedom.mode);
    let (Some(force), Some(moment)) = (find(Role::Force), find(Role::Moment)) else {
        return;
    };
    let wear::RigidMotion::Rotation { about, .. } = moment.motion else {
        return;
    };
    // The force of a prescribed approach is not known yet.
    if force.resultant <= 0.0 {
        return;
    }
    let half = 0.5 * (x[1] - x[0]);
    let arm = (moment.resultant / force.resultant + about.x - 0.5 * (x[0] + x[1])).abs();
    if arm >= half {
        say(
            "moment-beyond-edge",
            format!(
                "The moment puts the force {arm} mm off the middle of a contact of half length {half} mm: no pressure can balance it."
            ),
        );
        return;
    }
    let Optimum { functional, q, .. } = problem.optimum;
    let k = problem.wear.exponents.first().map(|b| 1.0 / s_minus_1(functional, *b, q));
    if let Some(k) = k.filter(|k| *k > 0.0) {
        let kern = half * k / (k + 2.0);
        if arm > kern {
            say(
                "moment-beyond-kern",
                format!(
                    "The force is {arm} mm off the middle, beyond the kern of {kern} mm for this optimum: part of the surface opens."
                ),
            );
        }
    }
}
