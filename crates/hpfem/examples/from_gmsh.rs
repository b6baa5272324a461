//! A ring from a gmsh file: with the file's own curved edges the error stalls, with exact circles laid on them it does not.

use hpfem::*;

/// Relative errors of the displacement of the bore of a tube under inner pressure in plane strain (Lame), first with the edges of the
/// file (gmsh 4.1, second order), then with exact circles.
pub fn errors(degree: usize) -> Result<[f64; 2], Box<dyn std::error::Error>> {
    let file = GmshMesh::read(include_bytes!("../tests/meshes/ring_2_41.msh"))?.mesh;
    let circle = |radius| Outline::Circle { centre: [0.0; 2], radius };
    let exact = file.with_outline("inner surface", circle(1.0))?.with_outline("outer", circle(2.0))?;
    let error = |mesh: Mesh| -> Result<f64, Error> {
        let bore = mesh.vertices[mesh.nearest_vertex([1.0, 0.0])];
        let problem = BodyProblem::new(mesh, degree, Kinematics::PlaneStrain { thickness: 1.0 })
            .material(Material::isotropic(210e3, 0.3)?)
            .hold("x0", Direction::First)
            .hold("z0", Direction::Second)
            .load("pressure", EdgeTraction::pressure("inner surface", |_| 50.0));
        let body = Body::new(problem)?;
        let field = body.field(&body.solve(&[("pressure", 1.0)])?)?;
        let (cell, xi, eta) = field.locate(bore)?;
        let lame = 1.3 / 210e3 * (50.0 / 3.0 * 0.4 + 200.0 / 3.0);
        Ok((field.at(cell, xi, eta)?.displacement[0] / lame - 1.0).abs())
    };
    Ok([error(file)?, error(exact)?])
}

#[allow(dead_code)]
fn main() -> Result<(), Box<dyn std::error::Error>> {
    for degree in [2, 4, 6, 8, 10, 12] {
        let [file, exact] = errors(degree)?;
        println!("degree {degree:2}: error with the edges of the file {file:.1e}, with circles {exact:.1e}");
    }
    Ok(())
}
