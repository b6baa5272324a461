//! A plate with a circular hole, pulled along x: the stress concentration at the hole.
//!
//! A quarter of a square plate of half side 4 with a hole of radius 1; rollers on the symmetry planes.
//! For an infinite plate the factor is 3 (Kirsch 1898); this one is short and narrow, and its factor larger.

use hpfem::*;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

/// Largest stress at the hole divided by the pull.
///
/// # Errors
/// Those of the mesh and the body.
pub fn stress_concentration(degree: usize) -> Result<f64, Error> {
    let (h, side) = (0.5_f64.sqrt(), 4.0);
    let vertices = vec![[1.0, 0.0], [side, 0.0], [side, side], [h, h], [0.0, side], [0.0, 1.0]];
    let quad = |corners| Quad { corners, material: 0, layer: 0 };
    let arc = |from, to| Curve::Arc { centre: [0.0; 2], radius: 1.0, from, to };
    let curves = [([0, 3], arc(0.0, FRAC_PI_4)), ([3, 5], arc(FRAC_PI_4, FRAC_PI_2))];
    let names = [([0, 1], "below"), ([1, 2], "pulled"), ([4, 5], "left")];
    let mesh = Mesh::new(vertices, &[quad([0, 1, 2, 3]), quad([3, 2, 4, 5])], &curves, &names)?.refined()?.refined()?;

    let problem = BodyProblem::new(mesh, degree, Kinematics::PlaneStress { thickness: 1.0 })
        .material(Material::isotropic(210e3, 0.3)?)
        .roller("below")
        .roller("left")
        .load("pull", EdgeTraction::new("pulled", |p| p.outward));
    let body = Body::new(problem)?;
    let field = body.field(&body.solve(&[("pull", 1.0)])?)?;
    let (cell, xi, eta) = field.locate([0.0, 1.0])?;
    Ok(field.at(cell, xi, eta)?.stress[0])
}

#[allow(dead_code)]
fn main() -> Result<(), Error> {
    for degree in [4, 6, 8, 10, 12, 14, 16] {
        println!("degree {degree:2}: stress at the hole / pull = {:.10}", stress_concentration(degree)?);
    }
    Ok(())
}
