//! A shaft with a round groove under torsion: the shear stress at the bottom of the groove against the nominal one of the
//! section there, `2 M / (pi r^3)`.

use hpfem::*;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

/// Stress concentration factor of a shaft of radius 1 with a half-round groove of radius 0.1.
///
/// # Errors
/// Those of the mesh and the body.
pub fn stress_concentration(degree: usize) -> Result<f64, Error> {
    let (radius, groove, length) = (1.0, 0.1, 4.0);
    // Coordinates (r, z). Half of the shaft: the plane z = 0 through the groove is held, the far end is twisted.
    //
    //   6 --- 7 ------ 8   z = length
    //   |     |        |
    //   3 --- 4 ------ 5   z = 0.4, 5 on the surface
    //   |     | .   arc
    //   0 --- 1 -- 2       z = 0, 2 at the bottom of the groove
    let h = groove * FRAC_PI_4.sin();
    let middle = [radius - h, h];
    let vertices = vec![
        [0.0, 0.0],
        [0.6, 0.0],
        [radius - groove, 0.0],
        [0.0, 0.4],
        [0.6, 0.4],
        [radius, 0.4],
        [0.0, length],
        [0.6, length],
        [radius, length],
        middle,
        [radius, groove],
    ];
    let quad = |corners| Quad { corners, material: 0, layer: 0 };
    let quads = [quad([0, 1, 4, 3]), quad([1, 2, 9, 4]), quad([9, 10, 5, 4]), quad([3, 4, 7, 6]), quad([4, 5, 8, 7])];
    let arc = |from, to| Curve::Arc { centre: [radius, 0.0], radius: groove, from, to };
    let curves = [([2, 9], arc(PI, PI - FRAC_PI_4)), ([9, 10], arc(PI - FRAC_PI_4, FRAC_PI_2))];
    let names = [([0, 1], "middle"), ([1, 2], "middle"), ([6, 7], "end"), ([7, 8], "end")];
    let mesh = Mesh::new(vertices, &quads, &curves, &names)?.refined()?.refined()?;

    // tau = r on the end: the moment is pi / 2.
    let problem = BodyProblem::new(mesh, degree, Kinematics::Torsion)
        .material(Material::isotropic(2.6, 0.3)?)
        .clamp("middle")
        .load("twist", EdgeTraction::new("end", |p| [p.position[0], 0.0]));
    let body = Body::new(problem)?;
    let field = body.field(&body.solve(&[("twist", 1.0)])?)?;
    let (cell, xi, eta) = field.locate([radius - groove, 0.0])?;
    let nominal = 2.0 * FRAC_PI_2 / (PI * (radius - groove).powi(3));
    Ok(field.at(cell, xi, eta)?.stress[1] / nominal)
}

#[allow(dead_code)]
fn main() -> Result<(), Error> {
    for degree in [4, 6, 8, 10, 12, 14] {
        println!("degree {degree:2}: stress concentration {:.8}", stress_concentration(degree)?);
    }
    Ok(())
}
