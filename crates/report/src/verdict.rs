//! One sentence that says how a run ended.

use scene::{Functional, with_short_numbers};
use wearshape::{Character, ContactResult, PressureResult, Problem, Regime, Solution, Status, WearResult, functional_row};

use crate::brief::brief;
use crate::pressure_words::{extremes, pressures};
use crate::shape_words::taken_off;

/// How it ended: the reason it stopped, or the number that was asked for.
pub(crate) fn verdict(problem: &Problem, solution: &Solution) -> String {
    if let Some(reason) = &solution.reason {
        return stopped(solution.status, reason);
    }
    if solution.status == Status::Interrupted {
        return interrupted(problem, solution);
    }
    if solution.shape.is_some() {
        return machine(problem, solution);
    }
    if let Some(wear) = &solution.wear {
        return worn(problem, solution, wear);
    }
    if let Some(contact) = &solution.contact {
        return touching(contact);
    }
    match &solution.pressure {
        Some(pressure) => pressed(problem, solution, pressure),
        None => "Nothing was asked for.".into(),
    }
}

fn stopped(status: Status, reason: &str) -> String {
    let head = match status {
        Status::Refused => "This scene has no answer",
        Status::NotConverged => "The computation did not arrive",
        Status::AccuracyMissed => "Done, but not to the accuracy asked for",
        Status::Ok => "Done",
        Status::Interrupted => "Interrupted",
    };
    format!("{head}: {}.", with_short_numbers(reason))
}

const EARLY: &str = "Interrupted before the accuracy was reached";

/// What is known of a run that was stopped on the way, after what it lacks.
fn interrupted(problem: &Problem, solution: &Solution) -> String {
    let known = solution.error.as_ref().and_then(|error| error.gap_relative);
    let off = known.map_or("how far it is off is not known".into(), |error| format!("it is off by about {error:.0e}, relative"));
    if let Some(wear) = &solution.wear {
        // Of a level that was finished before.
        return format!("{EARLY}. So far: {}; {off}.", worn(problem, solution, wear).trim_end_matches('.'));
    }
    if let Some(shape) = &solution.shape {
        let words = taken_off(problem, solution).unwrap_or_default();
        return match shape.roundtrip_independent.or(shape.roundtrip_same) {
            Some(_) => {
                format!("Interrupted after the shape was found and before the run in time was done. The shape: {words}; {off}.")
            }
            None => format!("{EARLY}. The shape so far, which is not proved: {words}; {off}."),
        };
    }
    if let Some(contact) = &solution.contact {
        return format!("{EARLY}. So far: {}; {off}.", touching(contact).trim_end_matches('.'));
    }
    match &solution.pressure {
        // It needs no mesh: what was stopped came after it.
        Some(pressure) => format!("Interrupted after the pressure was found. {}", pressed(problem, solution, pressure)),
        None => "Interrupted before there was a result.".into(),
    }
}

fn machine(problem: &Problem, solution: &Solution) -> String {
    let words = taken_off(problem, solution);
    let steady = |pressure: &PressureResult| pressure.functional == Functional::Steady && !is_capped(problem, pressure);
    let steady = solution.pressure.as_ref().is_some_and(steady);
    let noted = |code: &str| solution.remarks.iter().any(|remark| remark.code == code);
    let end = match (steady, noted("thermoelastic-instability"), noted("not-worn-in-from-cold")) {
        (true, false, false) => "it starts worn in",
        (true, true, false) => "it starts worn in, but frictional heat does not let it stay so",
        (true, false, true) => "warm it has the steady pressure, but not from a cold start",
        (true, true, true) => "warm it has the steady pressure, but not from a cold start, nor for long",
        (false, _, false) => "it has the wanted pressure",
        (false, _, true) => "warm it has the wanted pressure, but not from a cold start",
    };
    format!("Machine this shape: {}; {end}.", words.unwrap_or_default())
}

fn worn(problem: &Problem, solution: &Solution, wear: &WearResult) -> String {
    let time = wear.time.map(brief).unwrap_or_default();
    if let Some(scar) = wear.scar {
        return format!("Worn for {time} s: the scar is {} mm wide.", brief(scar));
    }
    if !wear.steady {
        return format!("Worn for {time} s; not yet steady.");
    }
    if solution.remarks.iter().any(|remark| remark.code == "wear-stopped") {
        return format!("Wear has stopped after {time} s: the pressure is nowhere above the threshold any more.");
    }
    let by_approach = problem.scene().load.as_ref().is_some_and(|load| load.approach.is_some());
    match &wear.to_1_percent {
        // The end is where the last step ended, and the steps before a steady state are long: it is not the time that running in takes.
        Some(near) => format!("Worn in to 1 % after {} s; steady at the end, after {time} s.", brief(near.time)),
        None if by_approach => {
            format!("The contact has worn itself free after {time} s: under the prescribed approach nothing presses any more.")
        }
        None => format!("Worn in after {time} s: the pressure no longer changes."),
    }
}

fn touching(contact: &ContactResult) -> String {
    let force = contact.force.map(brief).unwrap_or_default();
    let peak = match contact.p_max {
        Some(peak) => format!("at most {} MPa", brief(peak)),
        None => towards_edges(&contact.edge_exponents),
    };
    let turned = contact.twist.as_ref().and_then(|twist| twist.angle.last().zip(twist.torque.last()));
    let turned = turned.map_or(String::new(), |(angle, torque)| {
        format!("; turned by {} rad, a torque of {} N mm acts", brief(*angle), brief(*torque))
    });
    format!("The bodies touch with {force} N, {peak}{turned}.")
}

/// How the pressure goes with the distance from the edges: a negative exponent lets it grow, a positive one takes it away.
fn towards_edges(exponents: &[f64]) -> String {
    let powers = |exponents: &[f64]| {
        let each: Vec<String> = exponents.iter().map(|exponent| format!("d^({exponent:.2})")).collect();
        each.join(" and ")
    };
    let (growing, falling): (Vec<f64>, Vec<f64>) = exponents.iter().partition(|exponent| **exponent < 0.0);
    match (growing.as_slice(), falling.as_slice()) {
        (growing, []) => format!("the pressure grows towards the edges like {}", powers(growing)),
        ([], falling) => format!("the pressure falls towards the edges like {}", powers(falling)),
        (growing, falling) => {
            format!(
                "the pressure grows towards one edge like {} and falls towards the other like {}",
                powers(growing),
                powers(falling)
            )
        }
    }
}

fn pressed(problem: &Problem, solution: &Solution, pressure: &PressureResult) -> String {
    let functional = problem.scene().optimum.as_ref().and_then(|optimum| optimum.functional);
    let what = functional_row(functional.unwrap_or_default()).sentence;
    if pressure.regime == Some(Regime::Singular) {
        return format!("{what} concentrates on points or lines: see the limit measure.");
    }
    let curve = solution.curve.as_ref().or(solution.profile.as_ref());
    let on_plane = extremes(solution, pressure);
    let numbers = on_plane.or_else(|| curve.and_then(|curve| pressures(problem, curve, pressure))).unwrap_or_default();
    let kind = if pressure.character == Some(Character::Maximum) { ", the worst case" } else { "" };
    let cap = if is_capped(problem, pressure) { ", held down by optimum.p_max," } else { "" };
    format!("{what}{cap} is {numbers}{kind}.")
}

/// Largest relative difference of a pressure from the one that holds it down.
const AT_CAP: f64 = 1e-9;

/// Whether the largest admissible pressure holds down the wanted one, which is then no longer steady where that is asked for.
fn is_capped(problem: &Problem, pressure: &PressureResult) -> bool {
    let cap = problem.scene().optimum.as_ref().and_then(|optimum| optimum.p_max);
    cap.zip(pressure.p_max).is_some_and(|(cap, most)| most >= cap.0 * (1.0 - AT_CAP))
}
