//! Refusing problems that cannot be, and the scale in which a problem is solved.

use crate::error::Error;
use crate::freedom::Direction;
use crate::kinematics::Kinematics;
use crate::load_case::{Load, LoadCase, Meant};
use crate::mesh::Mesh;
use crate::problem::BodyProblem;
use std::f64::consts::TAU;

/// Refuses a problem whose lists do not fit together or whose numbers cannot be.
pub(crate) fn check(problem: &BodyProblem) -> Result<(), Error> {
    let mesh = &*problem.mesh;
    let count = |what: &str, given, expected| Err(Error::Count { what: what.into(), given, expected });
    if mesh.cells.is_empty() {
        return Err(Error::NoCells);
    }
    if problem.degrees.len() != mesh.cells.len() {
        return count("degrees of cells", problem.degrees.len(), mesh.cells.len());
    }
    if let Some((cell, c)) = mesh.cells.iter().enumerate().find(|(_, c)| c.material >= problem.materials.len()) {
        let (by, index, count) = (format!("cell {cell}"), c.material, problem.materials.len());
        return Err(Error::Beyond { by, what: "material", index, count });
    }
    if let Some((rigid, value)) =
        problem.rigid_edge.as_ref().and_then(|rigid| Some((rigid, rigid.reference.into_iter().find(|x| !x.is_finite())?)))
    {
        return Err(Error::OutOfRange {
            quantity: format!("the reference point of the rigid edge \"{}\"", rigid.boundary),
            value,
            range: "finite",
        });
    }
    let out = |quantity: String, value, range| Err(Error::OutOfRange { quantity, value, range });
    if let Some(thickness) = problem.kinematics.thickness().filter(|t| !(*t > 0.0 && t.is_finite())) {
        return out("the thickness".into(), thickness, "positive and finite");
    }
    problem.materials.iter().enumerate().try_for_each(|(number, material)| material.check(number, problem.kinematics))?;
    let size = mesh.vertices.iter().flatten().fold(0.0_f64, |m, x| m.max(x.abs()));
    for (i, x) in mesh.vertices.iter().enumerate() {
        if problem.kinematics.is_revolved() && x[0] < -1e-12 * size {
            return out(format!("the radius of vertex {i}"), x[0], "zero or positive");
        }
    }
    if problem.kinematics.is_revolved() {
        check_radii(mesh, size)?;
    }
    check_scale(problem, size)?;
    check_components(problem)?;
    check_angles(problem)?;
    check_pins_and_foundations(problem)?;
    for (number, case) in problem.load_cases.iter().enumerate() {
        if problem.load_cases[..number].iter().any(|other| other.name == case.name) {
            return Err(Error::DuplicateLoadCase { name: case.name.clone() });
        }
        check_case(case, mesh, problem.kinematics)?;
    }
    Ok(())
}

/// Refuses curved edges that cross the axis of revolution between their ends.
fn check_radii(mesh: &Mesh, size: f64) -> Result<(), Error> {
    for (e, edge) in mesh.edges.iter().enumerate().filter(|(_, edge)| !edge.curve.is_straight()) {
        let least = edge.curve.between_ends().map(|x| x[0]).fold(f64::INFINITY, f64::min);
        if least < -1e-12 * size {
            let [a, b] = edge.vertices;
            let quantity = format!("the least radius of edge {e} from vertex {a} to {b}");
            return Err(Error::OutOfRange { quantity, value: least, range: "zero or positive" });
        }
    }
    Ok(())
}

/// Refuses moduli that bring displacements below or beyond all numbers: a load of 1 MPa moves by about the size of a body over its modulus.
fn check_scale(problem: &BodyProblem, size: f64) -> Result<(), Error> {
    for (number, material) in problem.materials.iter().enumerate() {
        let value = size / material.size(problem.kinematics);
        if !value.is_normal() {
            let quantity = format!("the size of the mesh over the stiffness of material {number}");
            return Err(Error::OutOfRange { quantity, value, range: "from 1e-307 to 1e308" });
        }
    }
    Ok(())
}

/// Refuses directions and rigid edges that the kinematics does not have.
fn check_components(problem: &BodyProblem) -> Result<(), Error> {
    let kinematics = problem.kinematics;
    let refuse = |what: String| Err(Error::NoMeaning { what, kinematics: kinematics.words() });
    let scalar = kinematics.components() == 1;
    if let Some(support) = problem.supports.iter().find(|s| scalar && s.direction != Direction::First) {
        return refuse(format!("the direction of the support of \"{}\" (the only component is the first)", support.boundary));
    }
    if let Some(pin) = problem.pins.iter().find(|pin| scalar && pin.direction != Direction::First) {
        return refuse(format!("the direction of the pin at vertex {} (the only component is the first)", pin.vertex));
    }
    match &problem.rigid_edge {
        Some(rigid) if scalar => refuse(format!("the rigid edge \"{}\"", rigid.boundary)),
        Some(rigid) if kinematics.is_revolved() && (rigid.free[0] || rigid.free[2]) => {
            refuse(format!("a free t_r or theta of the rigid edge \"{}\"", rigid.boundary))
        }
        _ => Ok(()),
    }
}

/// Refuses directions of supports and pins at angles that are not finite.
fn check_angles(problem: &BodyProblem) -> Result<(), Error> {
    let supports = problem.supports.iter().map(|s| (s.direction, format!("the support of \"{}\"", s.boundary)));
    let pins = problem.pins.iter().map(|pin| (pin.direction, format!("the pin at vertex {}", pin.vertex)));
    supports.chain(pins).try_for_each(|(direction, place)| direction.check(&place))
}

/// Refuses pins and foundations that cannot be.
fn check_pins_and_foundations(problem: &BodyProblem) -> Result<(), Error> {
    let vertices = problem.mesh.vertices.len();
    for pin in &problem.pins {
        if pin.vertex < vertices && problem.mesh.cells.iter().all(|cell| !cell.vertices().contains(&pin.vertex)) {
            let what = format!("cells at the pinned vertex {}", pin.vertex);
            return Err(Error::Count { what, given: 0, expected: 1 });
        }
        if pin.vertex >= vertices {
            return Err(Error::Beyond { by: "a pin".into(), what: "vertex", index: pin.vertex, count: vertices });
        }
        if pin.direction == Direction::Normal {
            return Err(Error::NoNormal(pin.vertex));
        }
    }
    for f in &problem.foundations {
        for value in [f.normal, f.tangential] {
            if !(value.is_finite() && value >= 0.0) {
                let quantity = format!("the stiffness of the foundation of \"{}\"", f.boundary);
                return Err(Error::OutOfRange { quantity, value, range: "zero or positive" });
            }
        }
    }
    Ok(())
}

/// Refuses a load case with a boundary, a length or a force that cannot be.
pub(crate) fn check_case(case: &LoadCase, mesh: &Mesh, kinematics: Kinematics) -> Result<(), Error> {
    let scalar = kinematics.components() == 1;
    let refuse = |what: &str| {
        let what = format!("{what} (load case \"{}\")", case.name);
        Err(Error::NoMeaning { what, kinematics: kinematics.words() })
    };
    for load in &case.loads {
        match load {
            Load::Traction(traction) if scalar && traction.along_normal => return refuse("a pressure along the normal"),
            Load::Eigenstrain(eigen) if scalar && eigen.of_normals => return refuse("a thermal strain"),
            Load::Traction(traction) => {
                mesh.boundary(&traction.boundary)?;
                let Some([a, b]) = traction.range else { continue };
                if !(a.is_finite() && b.is_finite() && a < b) {
                    let quantity = format!("the length of a loaded part of \"{}\"", traction.boundary);
                    return Err(Error::OutOfRange { quantity, value: b - a, range: "positive and finite" });
                }
            }
            Load::PointForce(point) => {
                if let Some(value) = point.at.iter().chain(&point.force).find(|v| !v.is_finite()) {
                    let quantity = format!("a number of a point force of load case \"{}\"", case.name);
                    return Err(Error::OutOfRange { quantity, value: *value, range: "finite" });
                }
                let [r, z] = point.at;
                if kinematics.is_revolved() && r.abs() <= 1e-12 * r.hypot(z) && point.force[0] != 0.0 {
                    return refuse("a force on the axis of revolution along what is held there");
                }
            }
            Load::Eigenstrain(eigen) => {
                if let Some((of_mesh, conduction)) = &eigen.temperature {
                    check_temperature((mesh, kinematics), (of_mesh, *conduction))?;
                }
            }
            Load::BodyForce(body) => match body.meant {
                Meant::Weight([across, _]) if kinematics.is_revolved() && across != 0.0 => {
                    return refuse("a weight across the axis");
                }
                Meant::Weight(_) if scalar => return refuse("a weight"),
                Meant::Spin if kinematics != Kinematics::Axisymmetric => {
                    return refuse("a centrifugal force of a body of revolution");
                }
                Meant::Weight(_) | Meant::Spin | Meant::Anything => {}
            },
        }
    }
    Ok(())
}

/// Refuses temperatures that are not those of a mesh and its kinematics.
pub(crate) fn check_temperature(
    (mesh, kinematics): (&Mesh, Kinematics),
    (of_mesh, conduction): (&Mesh, Kinematics),
) -> Result<(), Error> {
    if !conduction.conducts_in(kinematics) {
        let what = format!("a thermal strain by {}", conduction.words());
        return Err(Error::NoMeaning { what, kinematics: kinematics.words() });
    }
    if !mesh.has_cells_of(of_mesh) {
        return Err(Error::OtherMesh);
    }
    Ok(())
}

/// The power of two that brings stiffnesses to the order of one. Problems that differ by powers of two then run through the same
/// square roots, and their results differ by powers of two bit for bit.
pub(crate) fn unit_of_stiffness(problem: &BodyProblem) -> f64 {
    let young = problem.materials.iter().fold(0.0_f64, |m, e| m.max(e.size(problem.kinematics)));
    let radius = || problem.mesh.vertices.iter().fold(0.0_f64, |m, x| m.max(x[0].abs()));
    let measure = problem.kinematics.thickness().unwrap_or_else(|| TAU * radius());
    power_of_two_below(young * measure)
}

/// The largest power of two not above a positive number; 1 for numbers that have none.
pub(crate) fn power_of_two_below(x: f64) -> f64 {
    let power = f64::from_bits(x.abs().to_bits() & 0x7ff0_0000_0000_0000);
    if power.is_normal() && (1.0 / power).is_normal() { power } else { 1.0 }
}
