//! Cells at the ends of the contact surface that are longer than high, as in a thin body or a lining: cut beside the ends at the same places of both bodies,
//! from side to side in a low body and around the ends in a high one, and beyond the ends in each by itself. The fields at a corner change over the distance
//! from it, and layers keep the shape of the cells that they are cut from.

use hpfem::Mesh;

use crate::coarse::Coarse;
use crate::extent::{Cut, Extent};
use crate::names::CONTACT;
use crate::near_ends::{at_end, square_layers};

/// Length of the lowest cell at an end over its height: beside a longer one the first cut is at this distance.
const LONGEST: f64 = 1.5;
/// The distance of a cut over that of the one before it, about.
const GROWTH: f64 = 3.0;
/// Least length of a cell on the contact surface and of one beyond it over the distance of a cut in it, that none becomes a splinter, and that the
/// latter, which the fields reach less, are cut where it helps.
const ROOM: f64 = 2.0;
const ROOM_BEYOND: f64 = 4.0;
/// Height of a cell over the distance of the first cut, beyond which it is cut around the end and not from side to side.
const HIGH: f64 = 2.0;
/// Longest edge at a singular point away from the contact over the shortest, beyond which there are rows of cells beside it.
const SLENDER: f64 = 4.0;
/// The distances of an independent mesh over these.
const SHIFTED: f64 = 0.8;
/// What round-off may do to a ratio of lengths: scenes that are alike but for that have the same cuts.
const ROUND_OFF: f64 = 1e-9;

/// The cuts of an edge of this `length` (mm) beside a cell of that `height` (mm), which leave `room` for the last: the distance of the first over the
/// length, and how many there are.
fn cuts_beside(height: f64, length: f64, room: f64, cut: Cut<'_>) -> (f64, usize) {
    let by = if cut == Cut::Shifted { SHIFTED } else { 1.0 };
    let first = by * LONGEST * height / length;
    (first, (-(room * first).ln() / GROWTH.ln() - ROUND_OFF).ceil().max(0.0) as usize)
}

/// Cuts the cells of both bodies at the ends of the contact surface that need layers: those of a thin body from side to side, those of a thick one around
/// the end. Bodies whose cells cannot be cut alike there stay as they are.
pub(crate) fn cut_beside(bodies: &mut [Coarse; 2], extent: Extent, cut: Cut<'_>) {
    for end in extent.ends() {
        let Some(corners) = both(bodies.each_ref().map(|body| Corner::at(body, extent, end))) else { continue };
        if !corners.iter().any(|corner| corner.graded) {
            continue;
        }
        let (share, cuts) = cuts_beside(corners[0].height.min(corners[1].height), corners[0].length, ROOM, cut);
        if cuts == 0 {
            continue;
        }
        let cut = |body: usize| {
            let (mesh, corner) = (&bodies[body].mesh, &corners[body]);
            let is_high = corner.height > (1.0 + ROUND_OFF) * HIGH * share * corner.length;
            if is_high {
                cut_around(mesh, extent, end, share, cuts)
            } else {
                cut_across(mesh, extent, [end, corner.other], share, cuts)
            }
        };
        let in_rows = |body: usize| cut(body).map(|mesh| in_rows(mesh, &bodies[body]));
        if let Some(cut) = both([in_rows(0), in_rows(1)]) {
            bodies.iter_mut().zip(cut).for_each(|(body, mesh)| body.mesh = mesh);
        }
    }
}

/// Cuts the cells of a body that lie beyond the ends of the contact surface and are longer there than its cells at the ends are high.
pub(crate) fn cut_beyond(body: &mut Coarse, extent: Extent, cut: Cut<'_>) {
    for end in extent.ends() {
        let Some(corner) = Corner::at(body, extent, end).filter(|corner| corner.graded) else { continue };
        let Some(edge) = beyond(&body.mesh, extent, end) else { continue };
        let (share, cuts) = cuts_beside(corner.height, body.mesh.edges[edge].curve.length(), ROOM_BEYOND, cut);
        // Each cuts what the one before it has left at the end.
        for _ in 0..cuts {
            let Some(mesh) = cut_next_to(&body.mesh, extent, end, share.powf(1.0 / cuts as f64)) else { break };
            body.mesh = mesh;
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

/// Layers of cells around an end of the contact surface, the innermost as long and high as a `share` of the contact edge there.
fn cut_around(mesh: &Mesh, extent: Extent, end: f64, share: f64, cuts: usize) -> Option<Mesh> {
    let (edge, side) = at_end(mesh, extent, end)?;
    square_layers(mesh.clone(), mesh.edges[edge].vertices[side], share, cuts).ok()
}

/// Rows of cells cut where [`cut_around`] cuts the contact edge from an end of the surface to its `other` one, and nowhere else on the surface.
fn cut_across(mesh: &Mesh, extent: Extent, [end, other]: [f64; 2], share: f64, cuts: usize) -> Option<Mesh> {
    let mut cut = mesh.clone();
    for left in 1..=cuts {
        let place = end + share.powf(left as f64 / cuts as f64) * (other - end);
        let parameter = |e: usize| (e, extent.parameter(&cut.edges[e].curve, place));
        let (edge, t) = cut.boundary(CONTACT).ok()?.into_iter().map(parameter).find(|(_, t)| t.abs() < 1.0)?;
        cut = cut.cut_through(edge, t).ok()?;
    }
    (touching(&cut) == touching(mesh) + cuts).then_some(cut)
}

/// The mesh with cells that a cut from side to side has made slender at singular points away from the contact, as where a thin lining ends on its back, cut
/// in rows beside these.
fn in_rows(mut mesh: Mesh, before: &Coarse) -> Mesh {
    for x in &before.singular {
        let own = edges_at(&mesh, *x);
        let all = |edges: &[(usize, f64)]| edges.iter().map(|(_, length)| length).sum::<f64>();
        let short = own.iter().map(|(_, length)| *length).fold(f64::INFINITY, f64::min);
        let long = own.iter().map(|(_, length)| *length).fold(0.0, f64::max);
        let is_cut = all(&own) < (1.0 - ROUND_OFF) * all(&edges_at(&before.mesh, *x));
        let touches = mesh.boundary(CONTACT).is_ok_and(|contact| own.iter().any(|(e, _)| contact.contains(e)));
        if touches || !is_cut || long <= (1.0 + ROUND_OFF) * SLENDER * short {
            continue;
        }
        let cuts = ((long / (ROOM * short)).ln() / GROWTH.ln() - ROUND_OFF).ceil() as usize;
        for left in (1..=cuts).rev() {
            let longest = edges_at(&mesh, *x).into_iter().max_by(|a, b| a.1.total_cmp(&b.1));
            let Some((edge, length)) = longest else { break };
            let t = 2.0 * (short / length).powf(1.0 / left as f64) - 1.0;
            let starts = mesh.edges[edge].vertices[0] == mesh.nearest_vertex(*x);
            match mesh.cut_through(edge, if starts { t } else { -t }) {
                Ok(cut) if touching(&cut) == touching(&mesh) => mesh = cut,
                _ => break,
            }
        }
    }
    mesh
}

/// The edges at the vertex at a point, with their lengths (mm).
fn edges_at(mesh: &Mesh, x: [f64; 2]) -> Vec<(usize, f64)> {
    let vertex = mesh.nearest_vertex(x);
    let own = mesh.edges.iter().enumerate().filter(|(_, edge)| edge.vertices.contains(&vertex));
    own.map(|(e, edge)| (e, edge.curve.length())).collect()
}

/// Number of cells on the contact surface.
fn touching(mesh: &Mesh) -> usize {
    mesh.boundary(CONTACT).map_or(0, |edges| edges.len())
}

/// The edge of the outline that goes on from an end of the contact surface, in a cell that does not touch.
fn beyond(mesh: &Mesh, extent: Extent, end: f64) -> Option<usize> {
    let (contact, side) = at_end(mesh, extent, end)?;
    let vertex = mesh.edges[contact].vertices[side];
    let beside = mesh.edge_cells();
    let own = beside[contact][0].0;
    let goes_on = |e: &usize| mesh.edges[*e].vertices.contains(&vertex) && beside[*e].len() == 1 && beside[*e][0].0 != own;
    (0..mesh.edges.len()).find(goes_on)
}

/// The mesh with the cell beyond an end of the contact surface cut at a share of its edge there, if that cuts no contact edge.
fn cut_next_to(mesh: &Mesh, extent: Extent, end: f64, share: f64) -> Option<Mesh> {
    let (contact, side) = at_end(mesh, extent, end)?;
    let edge = beyond(mesh, extent, end)?;
    let starts = mesh.edges[edge].vertices[0] == mesh.edges[contact].vertices[side];
    let t = 2.0 * share - 1.0;
    let cut = mesh.cut_through(edge, if starts { t } else { -t }).ok()?;
    (touching(&cut) == touching(mesh)).then_some(cut)
}
