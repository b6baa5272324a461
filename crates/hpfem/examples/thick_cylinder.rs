//! A thick cylinder under internal pressure as a body of revolution: one cell is enough.

use hpfem::*;

/// Radial displacement of the bore of a tube of radii 1 and 2, E = 210 GPa, nu = 0.3, pressure 50 MPa, ends held axially.
/// Lame: `(1 + nu)/E (A (1 - 2 nu) + B)` with `A = 50/3`, `B = 200/3`.
pub fn bore_displacement(degree: usize) -> Result<f64, Error> {
    let vertices = vec![[1.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 1.0]];
    let quad = Quad { corners: [0, 1, 2, 3], material: 0, layer: 0 };
    let names = [([0, 1], "lower end"), ([2, 3], "upper end"), ([3, 0], "bore")];
    let mesh = Mesh::new(vertices, &[quad], &[], &names)?;

    let problem = BodyProblem::new(mesh, degree, Kinematics::Axisymmetric)
        .material(Material::isotropic(210e3, 0.3)?)
        .roller("lower end")
        .roller("upper end")
        .load("pressure", EdgeTraction::pressure("bore", |_| 50.0));
    let body = Body::new(problem)?;
    let field = body.field(&body.solve(&[("pressure", 1.0)])?)?;
    Ok(field.at(0, -1.0, 0.0)?.displacement[0])
}

#[allow(dead_code)]
fn main() -> Result<(), Error> {
    let exact = 1.3 / 210e3 * (50.0 / 3.0 * 0.4 + 200.0 / 3.0);
    for degree in [1, 2, 4, 6, 8, 10] {
        let u = bore_displacement(degree)?;
        println!("degree {degree:2}: u_r = {u:.12}, relative error {:.1e}", (u / exact - 1.0).abs());
    }
    Ok(())
}
