//! Second-order character and regime of a stationary pressure, said only where the second variation in README proves it.

use crate::density::Density;
use crate::pressure_law::Node;
use crate::reduce::wearing_powers;
use crate::stage::Stage;
use crate::{Character, Counterface, Functional, Modes, Regime, WearLaw};

/// Character from the exponents: all s_i >= 1 and e_i >= 1 give a global minimum, all s_i <= 1 and e_i <= 1 a global maximum; one
/// effective body needs s alone. Where psi != phi under kinematic modes there is no functional: stationary.
pub(crate) fn character(stage: &Stage<'_>, nodes: &[Node], s: f64) -> Character {
    let problem = stage.problem;
    if !(problem.mode_kind == Modes::Associated || stage.symmetric(nodes)) {
        return Character::Stationary;
    }
    match problem.functional {
        // The minimum of the largest pressure, of a convex functional, and of Phi = sum int beta~ v^a p^(b+1)/(b+1).
        Functional::Uniform | Functional::Own(_) => return Character::Minimum,
        Functional::Steady if problem.counterface != Counterface::Revolving => {
            return Character::Minimum;
        }
        Functional::Steady if matches!(stage.law.density, Density::Receding { .. }) => {
            return Character::Stationary;
        }
        Functional::Steady | Functional::WearVolume | Functional::FrictionPower | Functional::WearPower => {}
    }
    // A convex functional under a threshold, the steady state on a full ring.
    if matches!(stage.law.density, Density::Given(_)) {
        return Character::Minimum;
    }
    if matches!(stage.law.density, Density::Exponential) {
        return Character::Indifferent;
    }
    if matches!(stage.law.density, Density::BangBang { .. }) {
        return Character::Minimum;
    }
    let single = matches!(stage.law.density, Density::Power { .. });
    if single {
        return if s > 1.0 { Character::Minimum } else { Character::Maximum };
    }
    let power = |law: &WearLaw| problem.functional.pressure_power(law.pressure_exponent);
    let above = wearing_powers(problem).all(|(_, law)| power(&law) * problem.q >= 1.0 && power(&law) >= 1.0);
    let below = wearing_powers(problem).all(|(_, law)| power(&law) * problem.q <= 1.0 && power(&law) <= 1.0);
    match (above, below) {
        (true, _) => Character::Minimum,
        (_, true) => Character::Maximum,
        _ => Character::Stationary,
    }
}

/// Partial contact where p = 0 on a part of positive area; near-singular where s within 0.05 of 1 concentrates the pressure (largest
/// over mean above 1.5), or anything concentrates it tenfold.
pub(crate) fn regime(stage: &Stage<'_>, s: f64, largest: f64, mean: f64) -> Regime {
    let ratio = largest / mean;
    let near = (s - 1.0).abs() <= 0.05 + 1e-12 && ratio >= 1.5 && prefers_a_place(stage);
    if open(stage) {
        Regime::PartialContact
    } else if near || ratio >= 10.0 {
        Regime::NearSingular
    } else {
        Regime::Regular
    }
}

/// True when the solution leaves a part of the surface without pressure (f is of order 1 where the pressure is).
fn open(stage: &Stage<'_>) -> bool {
    let mut open = false;
    stage.problem.surface.survey(&mut |point| open |= stage.law.node(*point).f < -1e-13);
    open
}

/// False where g is proportional to the pivot mode (plane punch): s -> 1 then concentrates nothing ("plane punch, s -> 1" in README).
fn prefers_a_place(stage: &Stage<'_>) -> bool {
    let (mut low, mut high) = (f64::INFINITY, 0.0_f64);
    let Density::Power { speed_power, k } = stage.law.density else {
        return true;
    };
    stage.problem.surface.survey(&mut |point| {
        let cost = (speed_power / (k + 1.0) * (point.sliding_speed / stage.law.reference_speed).ln()).exp();
        let ratio = cost / stage.law.mode_values(point).phi[stage.law.pivot];
        (low, high) = (low.min(ratio), high.max(ratio));
    });
    !(low > 0.0 && high - low <= 1e-12 * high)
}
