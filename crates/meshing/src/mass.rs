//! The centre of mass of a plane body: what spins about it spins in balance.

use hpfem::{Mesh, gauss};
use scene::{Geometry, Material};

use crate::couple::Body;

/// Points of the quadrature along each side of a cell.
const POINTS: usize = 16;

/// Centre of mass [x, z] of a plane body (mm) and its size (mm); none of a template without two axes of symmetry, or without a density. A template is of
/// one material, which has any density.
pub fn mass_centre(body: &Body) -> Option<([f64; 2], f64)> {
    match (&body.geometry, &body.cells) {
        (_, Some(mesh)) => of_cells(mesh, &body.materials),
        (Geometry::Ring(ring), None) => {
            let centre = ring.centre.map_or([0.0; 2], |centre| centre.map(|x| x.0));
            Some((centre, 2.0 * ring.outer.0))
        }
        (Geometry::Rectangle(sides), None) => {
            let ([left, right], [low, high]) = (sides.x.map(|x| x.0), sides.z.map(|z| z.0));
            Some(([0.5 * (left + right), 0.5 * (low + high)], (right - left).hypot(high - low)))
        }
        _ => None,
    }
}

fn of_cells(mesh: &Mesh, materials: &[Material]) -> Option<([f64; 2], f64)> {
    let rule = gauss(POINTS);
    let (mut mass, mut first) = (0.0, [0.0; 2]);
    for (number, cell) in mesh.cells.iter().enumerate() {
        let density = materials.get(cell.material)?.density?.0;
        for (xi, w) in rule.points.iter().zip(&rule.weights) {
            for (eta, v) in rule.points.iter().zip(&rule.weights) {
                let (x, [[xx, xe], [zx, ze]]) = mesh.map(number, *xi, *eta);
                let part = density * w * v * (xx * ze - xe * zx);
                mass += part;
                first = [first[0] + part * x[0], first[1] + part * x[1]];
            }
        }
    }
    let reach = |k: usize| {
        let places = || mesh.vertices.iter().map(move |x| x[k]);
        places().fold(f64::NEG_INFINITY, f64::max) - places().fold(f64::INFINITY, f64::min)
    };
    (mass > 0.0).then(|| (first.map(|first| first / mass), reach(0).hypot(reach(1))))
}
