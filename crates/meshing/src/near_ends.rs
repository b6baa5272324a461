//! Ends of contact next to an end of the surface: the cells there are graded to their distance first, then cut.

use hpfem::{Error, Mesh};

use crate::coarse::RATIO;
use crate::extent::{Cut, Extent};
use crate::names::CONTACT;

/// Share of half the surface within which an end of contact is next to its end.
const NEAR: f64 = 0.05;

/// The places (from -1 to 1) far from the ends of the surface, and those next to them.
pub(crate) fn split(cut: Cut<'_>) -> [Vec<f64>; 2] {
    let (near, far) = cut.ends().iter().partition(|t| 1.0 - t.abs() < NEAR);
    [far, near]
}

/// The mesh cut at places next to the ends of the surface, and where its vertices on them are. The cells at the end of the surface are first
/// made about as small as the distance, which both bodies do alike since they have common break points; a cut between the end of contact
/// and that of the surface keeps their layers apart.
pub(crate) fn cut_near(mut mesh: Mesh, extent: Extent, places: &[f64]) -> Result<(Mesh, Vec<[f64; 2]>), Error> {
    let [from, to] = extent.ends();
    let mut points = Vec::new();
    for t in places {
        let place = from + 0.5 * (1.0 + t) * (to - from);
        let end = if *t < 0.0 { from } else { to };
        let distance = (place - end).abs();
        let Some((edge, side)) = at_end(&mesh, extent, end) else { continue };
        let [a, b] = extent.range(&mesh.edges[edge].curve);
        let layers = ((b - a).abs() / (1.5 * distance)).ln() / (1.0 / RATIO).ln();
        if layers >= 1.0 {
            let corner = mesh.edges[edge].vertices[side];
            mesh = mesh.refined_towards(&[corner], RATIO, layers as usize)?;
            mesh.cells.iter_mut().for_each(|cell| cell.layer = 0);
        }
        for x in [place, 0.5 * (place + end)] {
            let edges = mesh.boundary(CONTACT)?;
            let hit =
                edges.into_iter().map(|e| (e, extent.parameter(&mesh.edges[e].curve, x))).find(|(_, t)| t.abs() < 1.0 - 1e-9);
            if let Some((edge, t)) = hit {
                let point = mesh.edges[edge].curve.point(t);
                mesh = mesh.cut_through(edge, t)?;
                if x == place {
                    points.push(point);
                }
            }
        }
    }
    Ok((mesh, points))
}

/// The contact edge at an end of the surface, and which of its ends that is.
fn at_end(mesh: &Mesh, extent: Extent, end: f64) -> Option<(usize, usize)> {
    let [from, to] = extent.ends();
    mesh.boundary(CONTACT).ok()?.into_iter().find_map(|e| {
        let range = extent.range(&mesh.edges[e].curve);
        let side = (0..2).find(|k| (range[*k] - end).abs() <= 1e-9 * (to - from))?;
        Some((e, side))
    })
}
