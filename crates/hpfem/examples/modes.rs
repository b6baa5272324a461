//! Natural frequencies of a free ring, and the stiffness and mass matrices behind them.

use hpfem::*;

/// Angular frequencies, rad/s, of the lowest in-plane modes of a free steel ring of radii 95 and 105 mm, rigid motions left out.
pub fn frequencies(degree: usize, count: usize) -> Result<Vec<f64>, Error> {
    let arc = |radius| Curve::Arc { centre: [0.0; 2], radius, from: std::f64::consts::TAU, to: 0.0 };
    let breaks: Vec<f64> = (0..=8).map(|k| f64::from(k) / 4.0 - 1.0).collect();
    let (bottom, top) = (arc(95.0), arc(105.0));
    let ring = Mesh::ruled(&Ruled { bottom, top, breaks: &breaks, levels: &[0.0, 1.0], closed: true, material: 0, names: &[] })?;
    let problem =
        BodyProblem::new(ring, degree, Kinematics::PlaneStress { thickness: 1.0 }).material(Material::isotropic(210e3, 0.3)?);
    let modes = SparseBody::new(problem)?.modes(&[7.85e-9], count + 3)?;
    Ok(modes[3..].iter().map(|mode| mode.eigenvalue.sqrt()).collect())
}

/// Bending of a thin inextensible ring (Hoppe 1871): `w_n^2 = E I / (rho A R^4) n^2 (n^2 - 1)^2 / (n^2 + 1)`, each twice.
pub fn thin_ring(n: f64) -> f64 {
    let (radius, height) = (100.0_f64, 10.0_f64);
    (210e3 * height * height / 12.0 / 7.85e-9).sqrt() / (radius * radius) * n * (n * n - 1.0) / (n * n + 1.0).sqrt()
}

#[allow(dead_code)]
fn main() -> Result<(), Error> {
    for degree in [4, 6, 8, 10] {
        println!("degree {degree:2}: {:.4?}", frequencies(degree, 4)?);
    }
    println!("thin ring: {:.4?}", [2.0, 2.0, 3.0, 3.0].map(thin_ring));
    Ok(())
}
