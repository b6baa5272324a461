//! How thick the layer of a material at the contact is.

use scene::Material;

use crate::couple::Body;
use crate::outline::Foot;

/// Places on each edge where the thickness is looked at, and how near to its ends.
const PLACES: u32 = 33;
const NEAR: f64 = 1e-9;

/// Least thickness (mm) of the layer of a material that is the contact edge: along normals of it, to where another material begins.
///
/// `None` where the edge is of another material, or of several, or no other material follows along any normal.
pub fn layer_thickness(body: &Body, material: &Material) -> Option<f64> {
    let mesh = body.cells.as_ref()?;
    let cells = mesh.edge_cells();
    let is_of_it = |cell: usize| body.materials[mesh.cells[cell].material] == *material;
    let bonds: Vec<usize> = (0..cells.len())
        .filter(|e| matches!(cells[*e][..], [(one, _), (other, _)] if is_of_it(one) != is_of_it(other)))
        .collect();
    let mut least = f64::INFINITY;
    for edge in mesh.boundary(&body.contact).ok()? {
        for place in 0..PLACES {
            let at = (1.0 - NEAR) * (2.0 * f64::from(place) / f64::from(PLACES - 1) - 1.0);
            let foot = Foot::on(mesh, &cells, edge, at)?;
            if body.materials[foot.material] != *material {
                return None;
            }
            least = bonds.iter().filter_map(|bond| foot.distance(&mesh.edges[*bond].curve)).fold(least, f64::min);
        }
    }
    least.is_finite().then_some(least)
}
