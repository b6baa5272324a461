//! Which cell holds a point.

use crate::error::Error;
use crate::mesh::{Mesh, distance};
use crate::triangle::collapsed;

/// The cell that holds a point (mm) and its reference coordinates, `(cell, xi, eta)`, by Newton's method on the map of nearby cells.
pub(crate) fn locate(mesh: &Mesh, x: [f64; 2]) -> Result<(usize, f64, f64), Error> {
    for cell in 0..mesh.cells.len() {
        let corners = mesh.cells[cell].corners.map(|v| mesh.vertices[v]);
        let size = corners.iter().map(|c| distance(*c, corners[0])).fold(0.0, f64::max);
        if corners.iter().all(|c| distance(*c, x) > 2.0 * size) {
            continue;
        }
        let triangle = mesh.cells[cell].is_triangle();
        // Newton's method in the cell's own coordinates, in which the map of a triangle is regular up to its corners.
        let map = |t: [f64; 2]| match triangle {
            true => mesh.reference_map(cell, [1.0 - t[0] - t[1], t[0], t[1]]),
            false => mesh.map(cell, t[0], t[1]),
        };
        let mut t = if triangle { [1.0 / 3.0; 2] } else { [0.0; 2] };
        for _ in 0..50 {
            let (at, [[a, b], [c, d]]) = map(t);
            let det = a * d - b * c;
            let r = [x[0] - at[0], x[1] - at[1]];
            let step = [(d * r[0] - b * r[1]) / det, (a * r[1] - c * r[0]) / det];
            t = [(t[0] + step[0]).clamp(-1.5, 1.5), (t[1] + step[1]).clamp(-1.5, 1.5)];
            if step[0].abs() + step[1].abs() < 1e-14 {
                break;
            }
        }
        let hit = distance(map(t).0, x) < 1e-9 * size;
        if triangle {
            let l = [1.0 - t[0] - t[1], t[0], t[1]];
            if hit && l.iter().all(|v| *v >= -1e-9) {
                let (xi, eta) = collapsed(l.map(|v| v.max(0.0)));
                return Ok((cell, xi, eta.clamp(-1.0, 1.0)));
            }
        } else if hit && t.iter().all(|v| v.abs() <= 1.0 + 1e-9) {
            return Ok((cell, t[0].clamp(-1.0, 1.0), t[1].clamp(-1.0, 1.0)));
        }
    }
    Err(Error::OutsideMesh { x: x[0], z: x[1] })
}
