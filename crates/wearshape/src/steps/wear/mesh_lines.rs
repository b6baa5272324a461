//! The meshes of both bodies as lines, for a viewer.

use hpfem::Mesh;
use scene::Fault;

use crate::level::Level;
use crate::stage::Stage;

/// Straight pieces of a curved edge.
const PIECES: usize = 8;

/// The edges of both meshes of a level, cut at `ends`; two points (x, z) in mm a line.
pub(super) fn mesh_lines(stage: Stage<'_>, level: Level, ends: &[f64]) -> Result<[Vec<[f64; 2]>; 2], Fault> {
    Ok(stage.meshes(level.layers, stage.cut(ends))?.map(|mesh| lines(&mesh)))
}

/// Two points a line.
fn lines(mesh: &Mesh) -> Vec<[f64; 2]> {
    let mut points = Vec::new();
    for edge in &mesh.edges {
        let pieces = if edge.curve.is_straight() { 1 } else { PIECES };
        let at = |i: usize| edge.curve.point(2.0 * i as f64 / pieces as f64 - 1.0);
        (0..pieces).for_each(|i| points.extend([at(i), at(i + 1)]));
    }
    points
}
