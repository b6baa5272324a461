//! What comes out: stresses along a line as a table, reactions, and a file for ParaView.

use hpfem::*;

/// A cantilever of 100 x 10, 1 N/mm on its end: the deflection at the middle of the end, the reactions and the file.
pub fn cantilever(degree: usize) -> Result<(f64, [f64; 3], String), Error> {
    let vertices = vec![[0.0, -5.0], [100.0, -5.0], [100.0, 5.0], [0.0, 5.0]];
    let names = [([1, 2], "end"), ([3, 0], "wall")];
    let cell = Quad { corners: [0, 1, 2, 3], material: 0, layer: 0 };
    let mesh = Mesh::new(vertices, &[cell], &[], &names)?.refined_towards(&[0], 0.15, 6)?.refined_towards(&[3], 0.15, 6)?;
    let problem = BodyProblem::new(mesh, degree, Kinematics::PlaneStress { thickness: 1.0 })
        .material(Material::isotropic(210e3, 0.3)?)
        .clamp("wall")
        .load("end", EdgeTraction::new("end", |_| [0.0, -1.0]));
    let body = Body::new(problem)?;
    let state = body.solve(&[("end", 1.0)])?;
    // The first support holds the first direction, the second the second.
    let [along, across] = [0, 1].map(|support| body.interface.reaction(support, &state));
    let field = body.field(&state)?;
    let (cell, xi, eta) = field.locate([100.0, 0.0])?;
    let deflection = field.at(cell, xi, eta)?.displacement[1];
    Ok((deflection, [0, 1, 2].map(|k| along[k] + across[k]), field.vtu()?.text()?))
}

#[allow(dead_code)]
fn main() -> Result<(), Box<dyn std::error::Error>> {
    let (deflection, reaction, file) = cantilever(8)?;
    println!("deflection {deflection:.6} mm, reaction {reaction:.6?} (N, N, N mm)");
    let name = std::env::temp_dir().join("cantilever.vtu");
    std::fs::write(&name, file)?;
    println!("written {}", name.display());
    Ok(())
}
