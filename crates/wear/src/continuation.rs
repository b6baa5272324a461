//! Continuation in the exponent: the way round for a Newton iteration that fails from its first guess.

use crate::WearError;
use crate::balance::{Balanced, balance};
use crate::density::Density;
use crate::pressure_law::Node;
use crate::stage::Stage;

/// Reaches the exponent k from 1 (s = 2) or -1 (s = 0, the analytic centre, which exists for every load inside the moment cone) in
/// steps, when the direct iteration has failed.
pub(crate) fn balance_by_continuation(stage: &mut Stage<'_>, nodes: &mut Vec<Node>) -> Result<Balanced, WearError> {
    let target = stage.law.density.clone();
    let (Density::Power { k, .. } | Density::Mixed { k, .. }) = target else {
        return Err(WearError::NotConverged { iterations: 0, residual: f64::NAN });
    };
    let steps = (3.0 * k.abs().ln().abs()).ceil().clamp(3.0, 24.0) as i32;
    stage.law.y = Default::default();
    let mut last = k.signum();
    for step in 0..=steps {
        let here = k.signum() * k.abs().powf(f64::from(step) / f64::from(steps));
        stage.on_the_way = step < steps;
        stage.law.density = if step == steps { target.clone() } else { with_exponent(&target, k, here) };
        if step > 0 {
            // Towards small k the ends of contact settle, not the bends k y.
            let ratio = if k.abs() > 1.0 { last / here } else { 1.0 };
            stage.law.y = stage.law.y.map(|y| y * ratio);
        }
        last = here;
        let balanced = balance(stage, nodes);
        if step == steps {
            return balanced;
        }
        match balanced {
            // A step that has stalled close to its solution is good enough to go on from.
            Ok(_) | Err(WearError::NotConverged { .. }) => {}
            Err(other) => {
                stage.on_the_way = false;
                return Err(other);
            }
        }
    }
    Err(WearError::NotConverged { iterations: 0, residual: f64::NAN })
}

/// The same density with another exponent of f, the share of the speed kept.
fn with_exponent(density: &Density, k: f64, here: f64) -> Density {
    match *density {
        Density::Power { speed_power, .. } => Density::Power { k: here, speed_power: speed_power * here / k },
        Density::Mixed { log_theta, powers, .. } => Density::Mixed { k: here, log_theta, powers },
        Density::Exponential | Density::BangBang { .. } | Density::Given(_) | Density::Receding { .. } | Density::Sum { .. } => {
            density.clone()
        }
    }
}
