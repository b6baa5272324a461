//! An L-shaped plate with a re-entrant corner: the program finds the singular corner and grades mesh and degrees towards it until the strain
//! energy is as accurate as asked.

use hpfem::*;

/// Strain energy of an L of three unit squares, clamped at its foot and pulled sideways at its top, with the estimated relative error.
///
/// # Errors
/// Those of the mesh and the body.
pub fn strain_energy(accuracy: f64) -> Result<(f64, f64), Error> {
    //   2---3        The corner at vertex 4 is re-entrant.
    //   |   |
    //   1---4---6
    //   |   |   |
    //   0---5---7
    let vertices = vec![[0.0, 0.0], [0.0, 1.0], [0.0, 2.0], [1.0, 2.0], [1.0, 1.0], [1.0, 0.0], [2.0, 1.0], [2.0, 0.0]];
    let quad = |corners| Quad { corners, material: 0, layer: 0 };
    let quads = [quad([0, 5, 4, 1]), quad([1, 4, 3, 2]), quad([5, 7, 6, 4])];
    let names = [([0, 5], "foot"), ([5, 7], "foot"), ([2, 3], "top")];
    let coarse = Mesh::new(vertices, &quads, &[], &names)?;

    let problem = BodyProblem::new(coarse, 1, Kinematics::PlaneStrain { thickness: 1.0 })
        .material(Material::isotropic(1.0, 0.3)?)
        .clamp("foot")
        .load("pull", EdgeTraction::new("top", |_| [1.0, 0.0]));
    let singular = singular_vertices(&problem.mesh, problem.kinematics, &problem.materials, &problem.supports, &["top"])?;
    let run = adapt(&problem.mesh, &singular, accuracy, 16, |mesh, degrees| {
        let finer = BodyProblem { mesh: mesh.clone().into(), ..problem.clone() };
        let body = Body::new(finer.degrees(degrees.to_vec()))?;
        Ok(vec![body.interface.strain_energy(&body.solve(&[("pull", 1.0)])?)])
    })?;
    Ok((run.quantities.last().map_or(f64::NAN, |q| q[0]), run.estimate))
}

#[allow(dead_code)]
fn main() -> Result<(), Error> {
    for accuracy in [1e-2, 1e-4, 1e-6, 1e-8] {
        let (energy, estimate) = strain_energy(accuracy)?;
        println!("accuracy {accuracy:.0e}: strain energy {energy:.10}, estimated relative error {estimate:.1e}");
    }
    Ok(())
}
