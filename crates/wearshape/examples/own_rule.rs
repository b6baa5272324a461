//! A shoe whose lining wears by a rule of its own: not at all below a threshold pressure. Pressure, shape and proof with that rule and with the
//! power law it grows out of, from a scene in memory; no file is read or written.

use std::ops::ControlFlow;

use wearshape::{Bodies, Document, Fault, Options, OwnRule, Problem, Solution, solve};

/// The drum brake with a block shoe, after Paczelt and Mroz (2007), with w' = k p^b v.
pub const SCENE: &str = r#"
units = "N-mm"
kinematics = "plane-stress"
thickness = 10
tasks = ["pressure", "shape"]
accuracy = 1e-6

body1.material = { young = "210 GPa", poisson = 0.3 }
body1.geometry.shoe-block = { radius = 200, half_angle = "30 deg", top = 300 }
body1.support = { left = ["x"], right = ["x"] }

body2.material = { young = "210 GPa", poisson = 0.3 }
body2.geometry.ring = { inner = 100, outer = 200, centre = [0, 0] }
body2.support = { inner = ["x", "z"] }

contact = { edges = ["inner", "outer"], friction = 0.25, gap = 0 }
sliding = { omega = "2.5 rad/s" }
load = { edge = "top", as = "pressure", force = "10 kN" }
wear = { k = [1e-6, 0], a = 1, b = 0.5 }
"#;

/// k and b of the scene.
const FACTOR: f64 = 1e-6;
const EXPONENT: f64 = 0.5;

/// w' = k max(p - p0, 0)^b v with its slope, for a threshold p0 in MPa.
pub fn above(threshold: f64, pressure: f64, sliding_speed: f64) -> [f64; 2] {
    let excess = pressure - threshold;
    if excess <= 0.0 {
        return [0.0, 0.0];
    }
    let rate = FACTOR * excess.powf(EXPONENT) * sliding_speed;
    [rate, EXPONENT * rate / excess]
}

/// The rule of this shoe: nothing wears below 3 MPa.
pub fn rule(pressure: f64, sliding_speed: f64) -> [f64; 2] {
    above(3.0, pressure, sliding_speed)
}

/// The scene, checked; no file stands beside it.
pub fn scene() -> Result<Problem, Fault> {
    Problem::new(&Document::read("own-rule", SCENE, &[])?, &|_| Err("this scene names no file".into()))
}

/// Its solution, not to be stopped.
pub fn solved(problem: &Problem, bodies: &Bodies) -> Result<Solution, Fault> {
    solve(problem, &Options::default(), bodies, &mut |_| ControlFlow::Continue(()))
}

fn tell(name: &str, solution: &Solution) {
    println!("{name}");
    if let Some(curve) = &solution.curve {
        println!("   angle/deg  pressure/MPa      gap/um  wear/(um/s)");
        for row in (0..curve.s.len()).step_by(50) {
            let angle = (curve.s[row] / 200.0).to_degrees();
            println!("{angle:12.1}{:14.4}{:12.4}{:13.6}", curve.pressure[row], curve.gap[row], curve.wear_rate[row]);
        }
    }
    if let Some(shape) = &solution.shape {
        println!("   crown {:.4} um", shape.crown.unwrap_or(f64::NAN));
        println!(
            "   a contact solve on other meshes gives the pressure back to {:.1e}",
            shape.roundtrip_independent.unwrap_or(f64::NAN)
        );
    }
}

/// Solves both and prints them side by side; the factored bodies serve both.
pub fn main() -> Result<(), Fault> {
    let bodies = Bodies::default();
    let power_law = scene()?;
    tell("w' = k p^0.5 v", &solved(&power_law, &bodies)?);
    tell("w' = k max(p - 3 MPa, 0)^0.5 v", &solved(&power_law.with_wear_rule(OwnRule::new(rule))?, &bodies)?);
    Ok(())
}
