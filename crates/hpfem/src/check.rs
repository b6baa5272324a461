//! Refusing problems that cannot be, and the scale in which a problem is solved.

use crate::additions::Additions;
use crate::error::Error;
use crate::freedom::Direction;
use crate::material::Kinematics;
use crate::problem::BodyProblem;
use std::f64::consts::TAU;

/// Refuses a problem whose lists do not fit together or whose numbers cannot be.
pub(crate) fn check(problem: &BodyProblem<'_>) -> Result<(), Error> {
    let mesh = problem.mesh;
    let count = |what: &str, given, expected| Err(Error::Count { what: what.into(), given, expected });
    if problem.degrees.len() != mesh.cells.len() {
        return count("degrees of cells", problem.degrees.len(), mesh.cells.len());
    }
    if let Some(cell) = mesh.cells.iter().find(|c| c.material >= problem.materials.len()) {
        return count("materials", problem.materials.len(), cell.material + 1);
    }
    let out = |quantity: String, value, range| Err(Error::OutOfRange { quantity, value, range });
    if let Kinematics::PlaneStress { thickness } | Kinematics::PlaneStrain { thickness } = problem.kinematics
        && !(thickness > 0.0 && thickness.is_finite())
    {
        return out("the thickness".into(), thickness, "positive and finite");
    }
    let size = mesh.vertices.iter().flatten().fold(0.0_f64, |m, x| m.max(x.abs()));
    for (i, x) in mesh.vertices.iter().enumerate() {
        if problem.kinematics.is_revolved() && x[0] < -1e-12 * size {
            return out(format!("the radius of vertex {i}"), x[0], "zero or positive");
        }
    }
    for support in problem.supports {
        if !support.value.is_finite() {
            return out(format!("the displacement of support \"{}\"", support.boundary), support.value, "finite");
        }
    }
    Ok(())
}

impl Additions<'_> {
    /// Refuses what cannot be.
    pub(crate) fn check(&self, problem: &BodyProblem<'_>) -> Result<(), Error> {
        let (mesh, cases) = (problem.mesh, problem.load_cases.len());
        for pin in &self.pins {
            if pin.vertex >= mesh.vertices.len() {
                let what = "pinned vertex, vertices".into();
                return Err(Error::Count { what, given: pin.vertex + 1, expected: mesh.vertices.len() });
            }
            if pin.direction == Direction::Normal {
                return Err(Error::NotStraight { what: "a pin along the normal", boundary: format!("vertex {}", pin.vertex) });
            }
        }
        for f in &self.foundations {
            for value in [f.normal, f.tangential] {
                if !(value.is_finite() && value >= 0.0) {
                    let quantity = format!("the stiffness of the foundation of \"{}\"", f.boundary);
                    return Err(Error::OutOfRange { quantity, value, range: "zero or positive" });
                }
            }
        }
        let used = |what: &str, given: Option<usize>, expected: usize| match given {
            Some(number) if number >= expected => Err(Error::Count { what: what.into(), given: number + 1, expected }),
            _ => Ok(()),
        };
        used("load case of a body force, load cases", self.body_forces.iter().map(|f| f.case).max(), cases)?;
        used("load case of a traction on a part, load cases", self.segments.iter().map(|f| f.case).max(), cases)?;
        let supports = self.displacements.iter().map(|d| d.support).max();
        used("support of a displacement, supports", supports, problem.supports.len())?;
        for segment in &self.segments {
            let [a, b] = segment.range;
            if !(a.is_finite() && b.is_finite() && a < b) {
                let quantity = format!("the length of a loaded part of \"{}\"", segment.boundary);
                return Err(Error::OutOfRange { quantity, value: b - a, range: "positive and finite" });
            }
        }
        Ok(())
    }
}

/// The power of two that brings stiffnesses to the order of one. Problems that differ by powers of two then run through the same
/// square roots, and their results differ by powers of two bit for bit.
pub(crate) fn unit_of_stiffness(problem: &BodyProblem<'_>) -> f64 {
    let young = problem.materials.iter().fold(0.0_f64, |m, e| m.max(e.young()));
    let measure = match problem.kinematics {
        Kinematics::PlaneStress { thickness } | Kinematics::PlaneStrain { thickness } => thickness,
        _ => TAU * problem.mesh.vertices.iter().fold(0.0_f64, |m, x| m.max(x[0].abs())),
    };
    power_of_two_below(young * measure)
}

/// The largest power of two not above a positive number; 1 for numbers that have none.
pub(crate) fn power_of_two_below(x: f64) -> f64 {
    let power = f64::from_bits(x.abs().to_bits() & 0x7ff0_0000_0000_0000);
    if power.is_normal() && (1.0 / power).is_normal() { power } else { 1.0 }
}
