//! Cook's membrane: a tapered panel, clamped on the left, sheared on the right.

use hpfem::*;

/// Deflection at mid-height of the loaded edge, `(48, 52)`; converged low-order meshes in the literature give 23.96.
///
/// # Errors
/// Those of the mesh and the body.
pub fn deflection(degree: usize, layers: usize) -> Result<f64, Error> {
    let line = |start, end| Curve::Line { start, end };
    let named = |side, name| Named { side, range: None, name };
    let mesh = Mesh::ruled(&Ruled {
        bottom: line([0.0, 0.0], [48.0, 44.0]),
        top: line([0.0, 44.0], [48.0, 60.0]),
        breaks: &[-1.0, 0.0, 1.0],
        levels: &[0.0, 0.5, 1.0],
        closed: false,
        material: 0,
        names: &[named(Side::Left, "wall"), named(Side::Right, "sheared")],
    })?;
    let corners = [[0.0, 0.0], [0.0, 44.0], [48.0, 44.0], [48.0, 60.0]].map(|x| mesh.nearest_vertex(x));
    let mesh = mesh.refined_towards(&corners, 0.15, layers)?;

    let problem = BodyProblem::new(mesh, degree, Kinematics::PlaneStress { thickness: 1.0 })
        .material(Material::isotropic(1.0, 1.0 / 3.0)?)
        .clamp("wall")
        .load("shear", EdgeTraction::new("sheared", |_| [0.0, 1.0 / 16.0]));
    let body = Body::new(problem)?;
    let field = body.field(&body.solve(&[("shear", 1.0)])?)?;
    let (cell, xi, eta) = field.locate([48.0, 52.0])?;
    Ok(field.at(cell, xi, eta)?.displacement[1])
}

#[allow(dead_code)]
fn main() -> Result<(), Error> {
    for degree in [2, 4, 6, 8, 10, 12] {
        println!("degree {degree:2}: deflection {:.8}", deflection(degree, 8)?);
    }
    Ok(())
}
