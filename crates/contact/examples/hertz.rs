//! Hertz: two steel blocks, one of them ground to a radius of 10 mm, pressed together by 100 N per mm of length (plane strain). The roundness is
//! the gap. Between half-planes the contact ends at `a = sqrt(4 P R / (pi E'))`, `1 / E' = 2 (1 - nu^2) / E`, and the highest pressure is `2 P / (pi a)`.

use contact::{ContactLoad, ContactOperator, Motion, Pair};
use hpfem::{Body, BodyProblem, Curve, InterfaceOperator, Kinematics, Material, Mesh, Named, RigidEdge, Ruled, Side};
use std::f64::consts::PI;

const FORCE: f64 = 100.0;
const RADIUS: f64 = 10.0;

/// A block of 40 x 20 mm above the surface z = 0 (`turn` = 1, pressed by its far edge), or turned by half a turn below it (-1, clamped), with cells
/// between `-a` and `a` and finer ones towards both.
fn block(turn: f64, a: f64) -> Result<InterfaceOperator, hpfem::Error> {
    let line = |z: f64| Curve::Line { start: [-20.0 * turn, z * turn], end: [20.0 * turn, z * turn] };
    let right = [0.0, 0.5 * a, 0.8 * a, 0.95 * a, a, 1.05 * a, 1.2 * a, 2.0 * a, 8.0 * a, 20.0];
    let breaks: Vec<f64> = right.iter().skip(1).rev().map(|x| -x / 20.0).chain(right.map(|x| x / 20.0)).collect();
    let name = |side, name| Named { side, range: None, name };
    let mesh = Mesh::ruled(&Ruled {
        bottom: line(0.0),
        top: line(20.0),
        breaks: &breaks,
        levels: &[0.0, 0.01, 0.04, 0.15, 0.4, 1.0],
        closed: false,
        material: 0,
        names: &[name(Side::Bottom, "contact"), name(Side::Top, "far")],
    })?;
    let block = BodyProblem::new(mesh, 8, Kinematics::PlaneStrain { thickness: 1.0 })
        .material(Material::isotropic(210e3, 0.3)?)
        .keep("contact");
    let press = RigidEdge { boundary: "far".into(), reference: [0.0, 20.0], free: [false, true, false] };
    let problem = if turn > 0.0 { BodyProblem { rigid_edge: Some(press), ..block } } else { block.clamp("far") };
    Ok(Body::interface(&problem)?.0)
}

/// Highest pressure (MPa) and half the contact length (mm), each with the value of Hertz.
pub fn pressure_and_length() -> Result<[[f64; 2]; 2], Box<dyn std::error::Error>> {
    let a = (8.0 * FORCE * RADIUS * (1.0 - 0.3 * 0.3) / (PI * 210e3)).sqrt();
    let (shaped, counter) = (block(1.0, a)?, block(-1.0, a)?);
    let operator = ContactOperator::new(&Pair::new(&shaped, Some(&counter))?, false)?;
    let gap: Vec<f64> = operator.points().iter().map(|p| p.position[0].powi(2) / (2.0 * RADIUS)).collect();
    let mut load = ContactLoad::factors(&[], &[]);
    load.motions[1] = Motion::Free { resultant: -FORCE };
    let solution = operator.solve(&gap, &load, None)?;
    let highest = solution.pressure.iter().fold(0.0, |most: f64, p| most.max(*p));
    let length: f64 = solution.zones.iter().map(|zone| zone[1] - zone[0]).sum();
    Ok([[highest, 2.0 * FORCE / (PI * a)], [0.5 * length, a]])
}

#[allow(dead_code)]
fn main() -> Result<(), Box<dyn std::error::Error>> {
    let [[highest, hertz], [half, a]] = pressure_and_length()?;
    println!("highest pressure {highest:.4} MPa, Hertz {hertz:.4}; half the contact length {half:.5} mm, Hertz {a:.5}");
    // The end of contact is known to a point here; `position_ends` moves a node onto it.
    assert!((highest / hertz - 1.0).abs() < 1e-4 && (half / a - 1.0).abs() < 1e-2);
    Ok(())
}
