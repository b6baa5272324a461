//! The optimum: functional, q, and the exponent s that decides what it is.

use scene::{Balance, Fault, Functional, Modes, Optimum, Pair, Scene, Task, positive};

use crate::functional::{functional_row, power, s_minus_1};
use crate::problem;

/// Checks the optimum and fills in its defaults.
pub(super) fn resolve(scene: &mut Scene, tasks: &[Task]) -> Result<(), Fault> {
    if !tasks.contains(&Task::Pressure) && !tasks.contains(&Task::Shape) {
        return Ok(());
    }
    let optimum = scene.optimum.get_or_insert_with(Optimum::default);
    let functional = *optimum.functional.get_or_insert(Functional::Steady);
    optimum.balance.get_or_insert(Balance::Equilibrium);
    optimum.modes.get_or_insert(Modes::Kinematic);
    if let Some(cap) = optimum.p_max {
        positive("optimum.p_max", cap.0, "pressure", " MPa")?;
    }
    if optimum.q.is_some_and(f64::is_nan) {
        return Err(Fault::at("optimum.q", "wrong-value", "optimum.q is not a number", "give any real number, or inf"));
    }
    if !functional_row(functional).needs.q {
        return Ok(());
    }
    let q = *optimum.q.get_or_insert(1.0);
    let capped = optimum.p_max.is_some();
    let alone = tasks.iter().all(|task| *task == Task::Pressure);
    if alone || capped {
        return Ok(());
    }
    for b in exponents(scene) {
        let s_minus_1 = s_minus_1(functional, b, q);
        if s_minus_1.abs() < 1e-12 {
            let e = power(functional, b);
            let [below, above] = [0.95 / e, 1.05 / e].map(|q| (q * 1e4).round() / 1e4);
            let message = format!(
                "optimum.q = {q} is singular: s = e q = {e} x {q} = 1, where the optimal pressure concentrates on points or lines and has no shape"
            );
            let remedy = format!(
                "take a regular q such as {below} (a maximum) or {above} (a minimum), cap the pressure with optimum.p_max, or ask for tasks = [\"pressure\"] alone"
            );
            return Err(Fault::at("optimum.q", "singular", message, remedy));
        }
    }
    Ok(())
}

/// Exponents b of the bodies that wear.
pub(super) fn exponents(scene: &Scene) -> Vec<f64> {
    let Some(wear) = &scene.wear else {
        return vec![1.0];
    };
    let b = match wear.b {
        Some(Pair::Two(b)) => b,
        Some(Pair::One(b)) => [b, b],
        None => [1.0, 1.0],
    };
    let wearing = if wear.has_rule() { wear.wearing() } else { [true, false] };
    let mut kept: Vec<f64> = (0..2).filter(|i| wearing[*i]).map(|i| b[i]).collect();
    kept.dedup();
    kept
}

/// The choice of a resolved scene.
pub(super) fn choice(scene: &Scene) -> problem::Optimum {
    let optimum = scene.optimum.clone().unwrap_or_default();
    problem::Optimum {
        functional: optimum.functional.unwrap_or(Functional::Steady),
        q: optimum.q.unwrap_or(1.0),
        balance: optimum.balance.unwrap_or(Balance::Equilibrium),
        modes: optimum.modes.unwrap_or(Modes::Kinematic),
        p_max: optimum.p_max.map(|cap| cap.0),
    }
}
