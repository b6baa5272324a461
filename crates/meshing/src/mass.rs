//! The mass of a body: its centre, about which a plane body spins in balance, and the resultants of loads by the mass.

use hpfem::{Kinematics, Mesh, gauss};
use scene::{Geometry, Material};

use crate::body_load::BodyLoad;
use crate::couple::Body;

/// Points of the quadrature along each side of a cell.
const POINTS: usize = 16;

/// Centre of mass [x, z] of a plane body (mm) and its size (mm); none of a template without two axes of symmetry, or without a density. A template is of
/// one material, which has any density.
pub(crate) fn mass_centre(body: &Body) -> Option<([f64; 2], f64)> {
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
    let (mut mass, mut first) = (0.0, [0.0; 2]);
    for number in 0..mesh.cells.len() {
        let density = materials.get(mesh.cells[number].material)?.density?.0;
        over_cell(mesh, number, &mut |x, area| {
            let part = density * area;
            mass += part;
            first = [first[0] + part * x[0], first[1] + part * x[1]];
        });
    }
    let reach = |k: usize| {
        let places = || mesh.vertices.iter().map(move |x| x[k]);
        places().fold(f64::NEG_INFINITY, f64::max) - places().fold(f64::INFINITY, f64::min)
    };
    (mass > 0.0).then(|| (first.map(|first| first / mass), reach(0).hypot(reach(1))))
}

/// Force [F_x, F_z] (N) and anti-clockwise moment about a point (N mm) of what acts on the mass of a body whose materials have these densities; of a body of
/// revolution for the full turn.
pub fn resultant(load: BodyLoad, (mesh, densities): (&Mesh, &[f64]), kinematics: Kinematics, about: [f64; 2]) -> [f64; 3] {
    let mut sum = [0.0; 3];
    for number in 0..mesh.cells.len() {
        let density = densities.get(mesh.cells[number].material).copied().unwrap_or(0.0);
        over_cell(mesh, number, &mut |x, area| {
            let part = density * area * kinematics.measure(x[0]);
            let force = load.at(x, kinematics.is_revolved()).map(|f| part * f);
            let moment = (x[0] - about[0]) * force[1] - (x[1] - about[1]) * force[0];
            sum = [sum[0] + force[0], sum[1] + force[1], sum[2] + moment];
        });
    }
    sum
}

/// Calls with the points of a quadrature over a cell and their areas.
fn over_cell(mesh: &Mesh, number: usize, act: &mut dyn FnMut([f64; 2], f64)) {
    let rule = gauss(POINTS);
    for (xi, w) in rule.points.iter().zip(&rule.weights) {
        for (eta, v) in rule.points.iter().zip(&rule.weights) {
            let (x, [[xx, xe], [zx, ze]]) = mesh.map(number, *xi, *eta);
            act(x, w * v * (xx * ze - xe * zx));
        }
    }
}
