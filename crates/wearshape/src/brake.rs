//! A shoe as a brake: what its actuator makes of the friction on it, how far it is from locking itself, and what its pin carries.

use nalgebra::Vector3;
use serde::Serialize;
use wear::SurfacePoint;

use crate::freedom::Role;
use crate::problem::Problem;

/// What friction does to the motion that closes a shoe, over pressure times motion, below which it does nothing.
const NEUTRAL: f64 = 1e-9;

/// What friction does to a shoe.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Sense {
    /// It helps to press the shoe on.
    Leading,
    /// It lifts the shoe off.
    Trailing,
    /// It does neither.
    Neutral,
}

/// A body 1 on a pin or a roller as a brake. With the closing velocity phi of its one motion u and the drag tau,
///
/// ```text
/// M = int phi p dS - mu int (tau . u) p dS,    mu_lock = int phi p dS / int (tau . u) p dS,
/// ```
///
/// the pressure as it is: beyond mu_lock no actuator is needed (Shigley's Mechanical Engineering Design, 16-2).
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct BrakeResult {
    /// Leading or trailing.
    pub shoe: Sense,
    /// Force of the actuator; none where a moment about the pin presses.
    #[serde(rename = "actuator_N")]
    pub actuator: Option<f64>,
    /// Moment of the load about the pin, positive as it closes.
    #[serde(rename = "moment_Nmm")]
    pub moment: Option<f64>,
    /// Moment of the contact pressure about the pin, against the load.
    #[serde(rename = "pressure_moment_Nmm")]
    pub pressure_moment: Option<f64>,
    /// Moment of the friction about the pin, positive where it helps the load.
    #[serde(rename = "friction_moment_Nmm")]
    pub friction_moment: Option<f64>,
    /// Force of the friction along the surface, mu int p dS.
    #[serde(rename = "friction_force_N")]
    pub friction_force: f64,
    /// Torque on body 2 about the centre of the arc.
    #[serde(rename = "torque_Nmm")]
    pub torque: Option<f64>,
    /// Friction force over the force of the actuator.
    pub brake_factor: Option<f64>,
    /// Coefficient of friction at which a leading shoe locks itself under a pressure so distributed.
    pub locks_at_friction: Option<f64>,
    /// That coefficient over the one given.
    pub lock_reserve: Option<f64>,
    /// Force of pin or roller on body 1, by the balance of contact and load.
    pub support_force: SupportForce,
}

/// A force in the plane (N).
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct SupportForce {
    /// Along x.
    #[serde(rename = "x_N")]
    pub x: f64,
    /// Along z.
    #[serde(rename = "z_N")]
    pub z: f64,
}

/// Body 1 as a brake under a pressure (MPa) at points of the contact surface; none without a pin or a roller.
pub(crate) fn brake(problem: &Problem, points: &[SurfacePoint], pressure: &[f64]) -> Option<BrakeResult> {
    let couple = problem.couple.as_ref().filter(|couple| couple.moves_one_way())?;
    let freedom = problem.freedoms.first()?;
    let motion = freedom.mode.motion;
    let friction = problem.friction.shear();
    let [mut normal, mut dragged, mut moved, mut total] = [0.0; 4];
    let mut contact = Vector3::zeros();
    for (point, p) in points.iter().zip(pressure) {
        let force = point.weight * p;
        let u = motion.displacement(&point.position);
        normal += force * motion.closing(point);
        dragged += force * point.drag.dot(&u);
        moved += force * u.norm();
        total += force;
        contact += force * (point.normal + friction * point.drag);
    }
    // What is jammed has no pressure to speak of.
    if pressure.iter().zip(points).any(|(p, point)| p * point.weight < -NEUTRAL * total.abs()) || normal <= 0.0 {
        return None;
    }
    let shoe = match dragged {
        _ if dragged.abs() <= NEUTRAL * moved => Sense::Neutral,
        _ if dragged > 0.0 => Sense::Leading,
        _ => Sense::Trailing,
    };
    let locks_at = (shoe == Sense::Leading).then(|| normal / dragged);
    let turns = freedom.role == Role::Moment;
    let actuator = problem.load.force;
    let pressed = couple.unit_load().zip(actuator).map_or([0.0; 2], |(unit, force)| unit.force.map(|f| f * force));
    let radius = problem.patch.as_ref()?.circle().map(|(radius, _)| radius);
    let friction_force = friction * total;
    Some(BrakeResult {
        shoe,
        actuator,
        moment: turns.then_some(freedom.mode.resultant),
        pressure_moment: turns.then_some(normal),
        friction_moment: turns.then_some(friction * dragged),
        friction_force,
        torque: radius.map(|radius| radius * friction_force),
        brake_factor: actuator.map(|force| friction_force / force),
        locks_at_friction: locks_at,
        lock_reserve: locks_at.filter(|_| friction > 0.0).map(|at| at / friction),
        support_force: SupportForce { x: -contact.x - pressed[0], z: -contact.z - pressed[1] },
    })
}
