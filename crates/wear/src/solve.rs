//! The balance for any density, under the pressure cap if there is one.

use crate::absolute::balance_absolute;
use crate::balance::{Balanced, balance, carried};
use crate::cap::is_too_low;
use crate::cells::BEYOND;
use crate::continuation::balance_by_continuation;
use crate::density::Density;
use crate::pressure_law::Node;
use crate::stage::Stage;
use crate::turn;
use crate::why::{AT_REST, CAPPED};
use crate::{Shape, WearError};

/// Solves the balance for any density, under the pressure cap if there is one: by Newton's method, and where that fails for two modes by
/// the direction of their multipliers.
pub(crate) fn balance_any(stage: &mut Stage<'_>, nodes: &mut Vec<Node>) -> Result<Balanced, WearError> {
    let cap = stage.problem.p_max.map_or(f64::INFINITY, f64::ln);
    let balanced = match by_newton(stage, nodes, cap) {
        Err(error) if turn::may_help(stage, &error) => turned(stage, nodes, cap),
        other => other,
    };
    let balanced = balanced.and_then(|balanced| carried(stage, nodes, &balanced).map(|()| balanced));
    // Whatever the search for multipliers has ended with, this is why.
    match balanced {
        Err(_) if at_rest(stage) => Err(stage.infeasible(AT_REST)),
        Err(_) if is_too_low(stage) => Err(stage.infeasible(CAPPED)),
        other => other,
    }
}

/// Whether some listed point does not slide while the pressure goes beyond all bounds with a falling speed.
fn at_rest(stage: &Stage<'_>) -> bool {
    let Shape::Points(points) = stage.problem.surface.shape() else { return false };
    let rests = points.iter().any(|point| point.sliding_speed == 0.0 && point.weight > 0.0);
    let unbounded = || stage.law.density.log_shape(0.0, f64::NEG_INFINITY, f64::NEG_INFINITY).0 >= BEYOND;
    rests && stage.problem.p_max.is_none() && unbounded()
}

/// By the direction of the multipliers: the state without the cap where it stays below it, else the state under the cap.
fn turned(stage: &mut Stage<'_>, nodes: &mut Vec<Node>, cap: f64) -> Result<Balanced, WearError> {
    (stage.law.absolute, stage.law.log_cap, stage.law.log_scale) = (false, f64::INFINITY, 0.0);
    if stage.law.density.scale_free() {
        let balanced = turn::balance_by_turning(stage, nodes)?;
        if balanced.log_scale + highest(nodes) <= cap {
            return Ok(balanced);
        }
        stage.law.log_scale = balanced.log_scale;
    }
    (stage.law.absolute, stage.law.log_cap) = (true, cap);
    turn::balance_by_turning(stage, nodes)
}

fn highest(nodes: &[Node]) -> f64 {
    nodes.iter().map(|node| node.log_h).fold(f64::NEG_INFINITY, f64::max)
}

fn by_newton(stage: &mut Stage<'_>, nodes: &mut Vec<Node>, cap: f64) -> Result<Balanced, WearError> {
    let several = stage.law.count > 1;
    match stage.law.density {
        Density::Power { k: target, speed_power } if several && (0.0..0.05).contains(&target) => {
            // Fronts jump for k = 0: come from k = 1 so that they start close to their places.
            let mut k = 1.0;
            // Until a front has appeared: in full contact the last equation does not see y.
            while k > target.max(1e-8) {
                let mut softer = Stage::new(stage.problem, Density::Power { k, speed_power })?;
                softer.law.y = stage.law.y;
                softer.on_the_way = true;
                match balance(&mut softer, nodes) {
                    Ok(_) | Err(WearError::NotConverged { .. }) => stage.law.y = softer.law.y,
                    Err(other) => return Err(other),
                }
                if k < 0.05 && softer.open_at_ends() {
                    break;
                }
                k *= 0.3;
            }
            if target > 0.0 && !stage.open_at_ends() {
                let balanced = balance(stage, nodes)?;
                return capped(stage, nodes, balanced, cap);
            }
            stage.law.log_cap = cap;
            balance_absolute(stage, nodes)
        }
        Density::Sum { .. } | Density::Receding { .. } | Density::BangBang { .. } | Density::Given(_) => {
            stage.law.log_cap = cap;
            balance_absolute(stage, nodes)
        }
        Density::Power { .. } | Density::Mixed { .. } | Density::Exponential => {
            let balanced = match balance(stage, nodes) {
                Err(WearError::NotConverged { .. }) if several && !stage.bends() => return second_way(stage, nodes, cap),
                other => other?,
            };
            capped(stage, nodes, balanced, cap)
        }
    }
}

/// When the iteration has stalled: differences of the exact residuals in place of the Jacobian, whose integrand f^(k-1) is not resolved
/// where the end of contact runs along a line of points, then continuation from a tame exponent.
fn second_way(stage: &mut Stage<'_>, nodes: &mut Vec<Node>, cap: f64) -> Result<Balanced, WearError> {
    let stalled = stage.law.y;
    stage.law.log_cap = cap;
    if let Ok(balanced) = balance_absolute(stage, nodes) {
        return Ok(balanced);
    }
    stage.law.absolute = false;
    stage.law.log_cap = f64::INFINITY;
    stage.law.log_scale = 0.0;
    stage.law.y = stalled;
    let balanced = balance_by_continuation(stage, nodes)?;
    capped(stage, nodes, balanced, cap)
}

/// The balanced state itself where it stays below the cap, else the state under the cap.
fn capped(stage: &mut Stage<'_>, nodes: &mut Vec<Node>, balanced: Balanced, cap: f64) -> Result<Balanced, WearError> {
    stage.law.log_scale = balanced.log_scale;
    if balanced.log_scale + highest(nodes) <= cap {
        return Ok(balanced);
    }
    stage.law.log_cap = cap;
    balance_absolute(stage, nodes)
}
