//! Poisson's equation `-div grad u = f` on an L-shaped domain: a singular solution with exponent 2/3, met by graded layers.

use hpfem::*;

/// Dissipation `1/2 int |grad u|^2` of `-div grad u = 1`, `u = 0` around the L of three unit squares, on so many graded layers.
pub fn energy(degree: usize, layers: usize) -> Result<f64, Error> {
    let at = |i: usize| [(i % 3) as f64 - 1.0, (i / 3) as f64 - 1.0];
    let cells = [[0, 1, 4, 3], [1, 2, 5, 4], [3, 4, 7, 6]].map(|corners| Quad { corners, material: 0, layer: 0 });
    let around = [[0, 1], [1, 2], [2, 5], [5, 4], [4, 7], [7, 6], [6, 3], [3, 0]].map(|edge| (edge, "wall"));
    let mesh = Mesh::new((0..8).map(at).collect(), &cells, &[], &around)?.refined_towards(&[4], 0.15, layers)?;
    let problem = BodyProblem::new(mesh, degree, Kinematics::Potential { thickness: 1.0 })
        .material(Material::conductor(1.0)?)
        .clamp("wall")
        .load("source", BodyForce::new(|_| [1.0, 0.0]));
    let body = Body::new(problem)?;
    Ok(body.field(&body.solve(&[("source", 1.0)])?)?.strain_energy())
}

#[allow(dead_code)]
fn main() -> Result<(), Error> {
    let best = energy(14, 14)?;
    for degree in [2, 4, 6, 8, 10, 12] {
        let value = energy(degree, degree)?;
        println!("degree and layers {degree:2}: 1/2 int |grad u|^2 = {value:.12}, off by {:.1e}", (value / best - 1.0).abs());
    }
    Ok(())
}
