//! Both meshes of a couple: coarse cells with the same break points on the contact surface, graded towards singular points and ends of contact.

use hpfem::Mesh;
use scene::Fault;

use crate::coarse::{Coarse, RATIO, degenerate};
use crate::couple::Couple;
use crate::extent::{Cut, Extent};
use crate::matching::matched;
use crate::near_ends::{self, cut_near};
use crate::round_cells::as_cells;
use crate::template::{coarse, contact_cuts};

/// The meshes of body 1 and body 2, with so many `layers` of cells around each singular point, whose sizes fall by [`RATIO`], and half as
/// many around each end of contact. The edges named [`CONTACT`](crate::CONTACT) have the same break points in both.
///
/// # Errors
/// The fault of a body that is no body 1 or body 2 of this contact, that is too thin, or whose cells cannot be cut where the other's are.
pub fn meshes(couple: &Couple, extent: Extent, layers: usize, cut: Cut<'_>) -> Result<[Mesh; 2], Fault> {
    let [far, near] = near_ends::split(cut);
    let cut = if near.is_empty() { cut } else { Cut::Ends(&far) };
    let cells = couple.bodies.each_ref().map(|body| body.cells.as_deref().cloned());
    let [first, second] = if cells.iter().all(Option::is_none) {
        templates(couple, extent, cut)?
    } else {
        let round = matches!(extent, Extent::Round { .. });
        let [first, second] = couple.bodies.each_ref().map(|body| if round { as_cells(couple, body) } else { None });
        let [own, other] = cells;
        matched(couple, [own.or(first), other.or(second)], extent, cut)?
    };
    let graded = |coarse: Coarse, key: &str| {
        let vertices = |mesh: &Mesh, points: &[[f64; 2]]| points.iter().map(|x| mesh.nearest_vertex(*x)).collect::<Vec<usize>>();
        let (mesh, near) = cut_near(coarse.mesh, extent, &near).map_err(|error| degenerate(key, &error))?;
        let singular = vertices(&mesh, &coarse.singular);
        let mesh = mesh.refined_towards(&singular, RATIO, layers).map_err(|error| degenerate(key, &error))?;
        let free = vertices(&mesh, &[coarse.free, near].concat());
        if free.is_empty() {
            return Ok(mesh);
        }
        mesh.refined_towards(&free, RATIO, layers.div_ceil(2)).map_err(|error| degenerate(key, &error))
    };
    Ok([graded(first, "body1.geometry")?, graded(second, "body2.geometry")?])
}

/// The coarse meshes of two templates.
fn templates(couple: &Couple, extent: Extent, cut: Cut<'_>) -> Result<[Coarse; 2], Fault> {
    let cuts = contact_cuts(couple, extent, cut, &[]);
    let first = coarse(couple, 0, &cuts, cut)?;
    let mut second = coarse(couple, 1, &cuts, cut)?;
    // Points of the contact surface that need layers in the shaped body need them in both, for common break points.
    second.free.clone_from(&first.free);
    for x in &first.singular {
        let y = second.mesh.vertices[second.mesh.nearest_vertex(*x)];
        let scale = x[0].hypot(x[1]);
        let near = |z: &[f64; 2]| (x[0] - z[0]).hypot(x[1] - z[1]) <= 1e-9 * scale;
        if near(&y) && !second.singular.iter().any(near) {
            second.singular.push(*x);
        }
    }
    Ok([first, second])
}
