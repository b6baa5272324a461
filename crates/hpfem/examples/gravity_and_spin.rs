//! A flywheel that stands on its rim and spins: two load cases on one factorisation, the second added after it.

use hpfem::*;

/// Density of steel, t/mm^3.
const DENSITY: f64 = 7.85e-9;

/// Force on the bottom under the weight, N, and the hoop stress at the bore at 1000 rad/s, MPa, of a disc of radii 50 and 200 and a
/// thickness of 10, mm.
pub fn flywheel(degree: usize) -> Result<[f64; 2], Error> {
    let vertices = vec![[50.0, 0.0], [200.0, 0.0], [200.0, 10.0], [50.0, 10.0]];
    let names = [([0, 1], "bottom"), ([2, 3], "top")];
    let mesh = Mesh::new(vertices, &[Quad { corners: [0, 1, 2, 3], material: 0, layer: 0 }], &[], &names)?;
    let problem = BodyProblem::new(mesh, degree, Kinematics::Axisymmetric)
        .material(Material::isotropic(210e3, 0.0)?)
        .roller("bottom")
        .load("weight", BodyForce::weight(DENSITY, [0.0, -9810.0]));
    let mut body = Body::new(problem)?;
    body.add_load(LoadCase::new("spin").with(BodyForce::spin(DENSITY, 1.0)))?;
    let weight = body.interface.reaction(0, &body.solve(&[("weight", 1.0)])?)[1];
    let spinning = body.field(&body.solve(&[("spin", 1000.0 * 1000.0)])?)?;
    Ok([weight, spinning.at(0, -1.0, 0.5)?.stress[3]])
}

/// `rho g V`, and the hoop stress at the bore of a thin disc without lateral contraction, `rho w^2 (3 b^2 + a^2) / 4`.
pub fn exact() -> [f64; 2] {
    let (a, b) = (50.0_f64.powi(2), 200.0_f64.powi(2));
    [DENSITY * 9810.0 * std::f64::consts::PI * (b - a) * 10.0, DENSITY * 1e6 * (3.0 * b + a) / 4.0]
}

#[allow(dead_code)]
fn main() -> Result<(), Error> {
    for degree in [2, 4, 8, 12] {
        println!("degree {degree:2}: weight and hoop stress {:?}, exact {:?}", flywheel(degree)?, exact());
    }
    Ok(())
}
