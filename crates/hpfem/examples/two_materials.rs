//! A compound tube: a soft liner in a stiff ring, pressed from inside, as a body of revolution with the ends held.

use hpfem::*;

/// Radial stress at the joint, MPa: liner of radii 1 to 1.4 with E = 3 GPa, nu = 0.4, ring to 2 with E = 210 GPa, nu = 0.3, 50 MPa inside.
pub fn joint_stress(degree: usize) -> Result<f64, Error> {
    let vertices = [0.0, 1.0].iter().flat_map(|z| [1.0, 1.4, 2.0].map(|r| [r, *z])).collect();
    let cell = |corners, material| Quad { corners, material, layer: 0 };
    let names = [([0, 1], "ends"), ([1, 2], "ends"), ([3, 4], "ends"), ([4, 5], "ends"), ([3, 0], "bore")];
    let mesh = Mesh::new(vertices, &[cell([0, 1, 4, 3], 0), cell([1, 2, 5, 4], 1)], &[], &names)?;
    let problem = BodyProblem::new(mesh, degree, Kinematics::Axisymmetric)
        .material(Material::isotropic(3e3, 0.4)?)
        .material(Material::isotropic(210e3, 0.3)?)
        .roller("ends")
        .load("pressure", EdgeTraction::pressure("bore", |_| 50.0));
    let body = Body::new(problem)?;
    let field = body.field(&body.solve(&[("pressure", 1.0)])?)?;
    Ok(field.at(0, 1.0, 0.0)?.stress[0])
}

/// Lame's solution of both tubes, joined by equal displacement at the joint.
pub fn exact() -> f64 {
    // u(r) / r at the radius r of a tube under inner pressure p and outer pressure q, plane strain.
    let stretch = |(e, nu): (f64, f64), [a, b]: [f64; 2], [p, q]: [f64; 2], r: f64| {
        let (a, b) = (a * a, b * b);
        let (mean, rest) = ((p * a - q * b) / (b - a), (p - q) * a * b / (b - a));
        (1.0 + nu) / e * ((1.0 - 2.0 * nu) * mean + rest / (r * r))
    };
    let jump = |q: f64| stretch((3e3, 0.4), [1.0, 1.4], [50.0, q], 1.4) - stretch((210e3, 0.3), [1.4, 2.0], [q, 0.0], 1.4);
    // The jump is linear in the pressure of the joint.
    -jump(0.0) / (jump(0.0) - jump(1.0))
}

#[allow(dead_code)]
fn main() -> Result<(), Error> {
    for degree in [2, 4, 8, 12] {
        println!("degree {degree:2}: stress at the joint {:.12} MPa, exact {:.12}", joint_stress(degree)?, exact());
    }
    Ok(())
}
