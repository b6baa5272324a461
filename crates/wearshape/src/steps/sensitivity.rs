//! What 1 % more of each number that a scene gives does to the optimal pressure, by the keys of the scene.

use scene::SurfaceShape;
use wear::{Given, Sensitivity, WearLaw, one_percent};

use crate::freedom::Role;
use crate::problem::Problem;
use crate::results::SensitivityResult;
use crate::step::Step;

/// Decimals of an effect in per cent; what is beyond them is rounding.
const DIGITS: f64 = 1e9;

/// One entry a given number; `wear` is the problem in the words of the theory. Empty where the pressure has no derivative, and where its force follows
/// from a prescribed approach, which nothing here keeps.
pub(crate) fn of(problem: &Problem, wear: &wear::Problem, optimum: &wear::Optimum) -> Vec<SensitivityResult> {
    if problem.plan.runs(Step::Force) {
        return Vec::new();
    }
    let mut all: Vec<SensitivityResult> = Vec::new();
    for found in one_percent(wear, optimum).unwrap_or_default() {
        let entry = entry(key(problem, wear, found.given), &found);
        match all.iter_mut().find(|other| other.given == entry.given) {
            Some(other) => other.add(&entry),
            None => all.push(entry),
        }
    }
    all
}

fn entry(given: String, found: &Sensitivity) -> SensitivityResult {
    // Zero without a sign.
    let percent = |value: f64| Some((value * DIGITS).round() / DIGITS + 0.0).filter(|value| value.is_finite());
    SensitivityResult {
        given,
        wear_rate_percent: found.wear_rate.and_then(percent),
        torque_percent: found.torque.and_then(percent),
        p_max_percent: percent(found.p_max),
    }
}

impl SensitivityResult {
    /// Adds the effect of the same number of the other body.
    fn add(&mut self, other: &SensitivityResult) {
        let sum = |a: Option<f64>, b: Option<f64>| a.zip(b).map(|(a, b)| a + b);
        self.wear_rate_percent = sum(self.wear_rate_percent, other.wear_rate_percent);
        self.torque_percent = sum(self.torque_percent, other.torque_percent);
        self.p_max_percent = sum(self.p_max_percent, other.p_max_percent);
    }
}

/// The key of a number in the scene. An exponent that both bodies share is one number.
fn key(problem: &Problem, wear: &wear::Problem, given: Given) -> String {
    let [first, second] = [0, 1].map(|body| wear.wear.rules[body].power());
    let shared = |exponent: fn(&WearLaw) -> f64| first.map(exponent) == second.map(exponent);
    let of_body =
        |name: &str, body: usize, shared: bool| if shared { format!("wear.{name}") } else { format!("wear.{name}.{body}") };
    match given {
        Given::Resultant(k) => resultant(problem, k).into(),
        Given::Friction => "contact.friction".into(),
        Given::WearFactor(body) => of_body(if problem.wear.of_friction { "beta" } else { "k" }, body, false),
        Given::PressureExponent(body) => of_body("b", body, shared(|law| law.pressure_exponent)),
        Given::SpeedExponent(body) => of_body("a", body, shared(|law| law.speed_exponent)),
        Given::SlidingSpeed => match problem.sliding.as_ref().and_then(|sliding| sliding.omega) {
            Some(_) => "sliding.omega".into(),
            None => "sliding.speed".into(),
        },
        Given::Thickness => thickness(problem).into(),
        Given::PressureCap => "optimum.p_max".into(),
    }
}

/// The load that a resultant is made of.
fn resultant(problem: &Problem, k: usize) -> &'static str {
    // A shoe on a pin is turned by its force.
    let by_actuator = problem.couple.as_ref().is_some_and(|couple| couple.moves_one_way() && !couple.has_rigid_edge());
    let pinned = by_actuator || matches!(problem.bare, Some(SurfaceShape::PinnedShoe(_)));
    match problem.freedoms.get(k).map(|freedom| freedom.role) {
        Some(Role::Moment) if !pinned => "load.moment",
        Some(Role::MomentY) => "load.moment_y",
        Some(Role::SideForce) => "load.shear_force",
        _ => "load.force",
    }
}

fn thickness(problem: &Problem) -> &'static str {
    match problem.bare {
        Some(SurfaceShape::PinnedShoe(_)) => "surface.pinned-shoe.width",
        Some(SurfaceShape::PivotedShoe(_)) => "surface.pivoted-shoe.width",
        Some(SurfaceShape::JournalArc(_)) => "surface.journal-arc.width",
        _ => "thickness",
    }
}
