//! Cells at the ends of the contact surface that are longer than high, in a thin body or a lining: cut beside the ends, in both bodies alike. The fields
//! at a corner change over the distance from it, and layers keep the shape of the cells that they are cut from.

use hpfem::{Error, Mesh};

use crate::coarse::Coarse;
use crate::extent::{Cut, Extent};
use crate::names::CONTACT;
use crate::near_ends::at_end;

/// Length of the lowest cell at an end over its height: beside a longer one the first cut is at this distance.
const LONGEST: f64 = 1.5;
/// The same of the highest one, at least: a body that is not thin is not cut into slices for the sake of a layer on it.
const SHORTEST: f64 = 0.25;
/// The distance of a cut over that of the one before it.
const GROWTH: f64 = 3.0;
/// Least length of a cell over the distance of a cut in it, that none becomes a splinter.
const ROOM: f64 = 2.0;
/// The distances of an independent mesh over these.
const SHIFTED: f64 = 0.8;

/// Cuts the cells of both bodies at the ends of the contact surface that need layers. Bodies whose cells cannot be cut alike there stay as they are.
pub(crate) fn cut_beside(bodies: &mut [Coarse; 2], extent: Extent, cut: Cut<'_>) {
    let by = if cut == Cut::Shifted { SHIFTED } else { 1.0 };
    for end in extent.ends() {
        let Some(corners) = both(bodies.each_ref().map(|body| Corner::at(body, extent, end))) else { continue };
        if !corners.iter().any(|corner| corner.graded) {
            continue;
        }
        let heights = corners.each_ref().map(|corner| corner.height);
        let first = by * (LONGEST * heights[0].min(heights[1])).max(SHORTEST * heights[0].max(heights[1])) / corners[0].length;
        let distances = std::iter::successors(Some(first), |distance| Some(GROWTH * distance));
        let shares = distances.take_while(|share| ROOM * share < 1.0);
        let places: Vec<f64> = shares.map(|share| end + share * (corners[0].other - end)).collect();
        if places.is_empty() {
            continue;
        }
        if let Some(cut) = both(bodies.each_ref().map(|body| cut_at(&body.mesh, extent, &places).ok())) {
            bodies.iter_mut().zip(cut).for_each(|(body, mesh)| body.mesh = mesh);
        }
    }
}

/// Both or none.
fn both<T>([first, second]: [Option<T>; 2]) -> Option<[T; 2]> {
    Some([first?, second?])
}

/// The cell of a body at an end of the contact surface.
struct Corner {
    /// Whether the body is graded towards it.
    graded: bool,
    /// Coordinate of the other end of its contact edge, and the length of that (mm).
    other: f64,
    length: f64,
    /// Length of its other edge at the corner (mm).
    height: f64,
}

impl Corner {
    fn at(Coarse { mesh, singular, .. }: &Coarse, extent: Extent, end: f64) -> Option<Corner> {
        let (edge, side) = at_end(mesh, extent, end)?;
        let own = &mesh.edges[edge];
        let vertex = own.vertices[side];
        let cell = mesh.cells.iter().find(|cell| cell.edges.contains(&Some(edge)))?;
        let touches = |e: &usize| *e != edge && mesh.edges[*e].vertices.contains(&vertex);
        let height = cell.edges.iter().flatten().copied().find(touches).map(|e| mesh.edges[e].curve.length())?;
        Some(Corner {
            graded: singular.iter().any(|x| mesh.nearest_vertex(*x) == vertex),
            other: extent.range(&own.curve)[1 - side],
            length: own.curve.length(),
            height,
        })
    }
}

/// The mesh with rows of cells cut at places of the contact surface, and nowhere else on it.
fn cut_at(mesh: &Mesh, extent: Extent, places: &[f64]) -> Result<Mesh, Error> {
    let mut cut = mesh.clone();
    for place in places {
        let edges = cut.boundary(CONTACT)?;
        let hit = edges.into_iter().map(|e| (e, extent.parameter(&cut.edges[e].curve, *place))).find(|(_, t)| t.abs() < 1.0);
        if let Some((edge, t)) = hit {
            cut = cut.cut_through(edge, t)?;
        }
    }
    let added = cut.boundary(CONTACT)?.len() - mesh.boundary(CONTACT)?.len();
    if added == places.len() { Ok(cut) } else { Err(Error::NotAPath { name: CONTACT.into() }) }
}
