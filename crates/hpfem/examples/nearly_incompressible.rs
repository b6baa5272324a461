//! A nearly incompressible block of many cells: the mean stress as Poisson's ratio nears one half.
//!
//! A quarter of a thick ring under pressure in plane strain, cells without symmetry. Lame: the mean stress in the plane, half the sum
//! of radial and hoop stress, is the constant `p a^2 / (b^2 - a^2)`, whatever Poisson's ratio.

use hpfem::*;
use std::f64::consts::FRAC_PI_2;

/// Largest deviation of the mean stress in the plane from the exact one, relative to the pressure.
pub fn mean_stress_error(poisson: f64, degree: usize) -> Result<f64, Error> {
    let arc = |radius| Curve::Arc { centre: [0.0; 2], radius, from: FRAC_PI_2, to: 0.0 };
    let named = |side, name| Named { side, range: None, name };
    let names = [named(Side::Bottom, "bore"), named(Side::Left, "left"), named(Side::Right, "right")];
    let (breaks, levels) = ([-1.0, -0.3, 0.5, 1.0], [0.0, 0.35, 1.0]);
    let ring =
        Ruled { bottom: arc(1.0), top: arc(2.0), breaks: &breaks, levels: &levels, closed: false, material: 0, names: &names };
    let problem = BodyProblem::new(Mesh::ruled(&ring)?, degree, Kinematics::PlaneStrain { thickness: 1.0 })
        .material(Material::isotropic(1.0, poisson)?)
        .roller("left")
        .roller("right")
        .load("pressure", EdgeTraction::pressure("bore", |_| 1.0));
    let body = Body::new(problem)?;
    let field = body.field(&body.solve(&[("pressure", 1.0)])?)?;
    let mut error = 0.0_f64;
    for cell in 0..field.cells() {
        for (xi, eta) in [(-1.0, -1.0), (0.3, -0.7), (0.0, 0.0), (1.0, 1.0), (-0.5, 0.9)] {
            let [x, z, ..] = field.at(cell, xi, eta)?.stress;
            error = error.max((0.5 * (x + z) - 1.0 / 3.0).abs());
        }
    }
    Ok(error)
}

#[allow(dead_code)]
fn main() -> Result<(), Error> {
    for poisson in [0.3, 0.49, 0.4999, 0.49999] {
        let errors = [4, 8, 12].map(|degree| mean_stress_error(poisson, degree));
        let [a, b, c] = errors;
        println!("nu = {poisson:<8} error of the mean stress at degree 4, 8, 12: {:.1e} {:.1e} {:.1e}", a?, b?, c?);
    }
    // Beyond, digits are lost without end: refused.
    println!("{}", mean_stress_error(0.499999, 8).err().map(|e| e.to_string()).unwrap_or_default());
    Ok(())
}
