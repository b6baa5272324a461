//! Ends of contact next to an end of the surface: the cells there are graded to their distance first, by layers that make them square, then cut.

use hpfem::{Error, Mesh};

use crate::coarse::RATIO;
use crate::extent::{Cut, Extent};
use crate::names::CONTACT;

/// Share of half the surface within which an end of contact is next to its end: between the two, cells as high as the body would be slender.
const NEAR: f64 = 0.45;
/// Size of the cell at the end of the surface that an end of contact cuts, over their distance: with 1.5 and 2 the gap of a drum whose shoe needs nodes
/// at 0.75 of its half is off by two and seven times as much (degree 8), and with less a kink of the pressure lies next to a splinter.
const JUST_BEYOND: f64 = 1.3;
/// The same, at least, of an end of contact within this share of half the surface: runs in time, whose gap recedes there for ever, do not settle on cells as
/// small as that.
const CLOSEST: f64 = 0.05;
const BEYOND_CLOSEST: f64 = 1.5;

/// Share of half the surface within which two ends of contact are one place of the mesh, whose cells are to be of the size of their distance: the
/// stresses under a short contact fade within its length, and cells as high as the body know nothing of that.
const SMALL: f64 = 0.25;
/// The same of ends that have grown apart from a much shorter contact, which the cells under it have to know of.
const GROWN: f64 = 1.2;
/// Where the cells beside the middle of two ends end, over the distance of the farther one, and the steepest ratio of the layers that make them so.
const BEYOND: f64 = 1.8;
const STEEPEST: f64 = 0.35;
/// The flattest ratio of those layers inside the body, where it is less high than the contact is wide.
const FLATTEST: f64 = 0.7;

/// What round-off may do to a number of layers.
const ROUND_OFF: f64 = 1e-9;

/// Ends of contact (from -1 to 1 on the surface) by what they ask of a mesh.
pub(crate) struct Split {
    /// Far from the ends of the surface and from each other.
    pub far: Vec<f64>,
    /// Next to the ends of the surface.
    pub near: Vec<f64>,
    /// Next to each other.
    pub small: Vec<[f64; 2]>,
}

/// The place of a vertex between two ends next to each other: near their middle, the same for all ends but little apart, so that the mesh stays the
/// same in kind while they are looked for.
pub(crate) fn between(extent: Extent, pair: [f64; 2]) -> f64 {
    let [from, to] = extent.ends();
    // Steps of a quarter to an eighth of the distance.
    let steps = (8.0 / (pair[1] - pair[0])).log2().ceil().exp2();
    let middle = (0.5 * (pair[0] + pair[1]) * steps).round() / steps;
    from + 0.5 * (1.0 + middle) * (to - from)
}

/// Sorts the ends of contact, which have grown apart from a much shorter one or not, on a surface that ends at corners of a body or in the midst of them.
pub(crate) fn split(cut: Cut<'_>, grown: bool, at_corners: bool) -> Split {
    let small = if grown { GROWN } else { SMALL };
    let next = if at_corners { NEAR } else { CLOSEST };
    let (near, inner): (Vec<f64>, Vec<f64>) = cut.ends().iter().partition(|t| 1.0 - t.abs() < next);
    let mut split = Split { far: Vec::new(), near, small: Vec::new() };
    let mut rest = inner.as_slice();
    while let [first, others @ ..] = rest {
        rest = match others {
            [second, beyond @ ..] if second - first < small => {
                split.small.push([*first, *second]);
                beyond
            }
            _ => {
                split.far.push(*first);
                others
            }
        };
    }
    split
}

/// The mesh cut at pairs of places next to each other, and where its vertices on them are. The cells at the middle between the two, which is a vertex,
/// are first made about as small as the distance.
pub(crate) fn cut_small(mut mesh: Mesh, extent: Extent, pairs: &[[f64; 2]]) -> Result<(Mesh, Vec<[f64; 2]>), Error> {
    let [from, to] = extent.ends();
    let mut points = Vec::new();
    for pair in pairs {
        let [a, b] = pair.map(|t| from + 0.5 * (1.0 + t) * (to - from));
        let middle = between(extent, *pair);
        let Some((edge, side)) = at_end(&mesh, extent, middle) else { continue };
        let corner = mesh.edges[edge].vertices[side];
        let around = mesh.boundary(CONTACT)?.into_iter().filter(|e| mesh.edges[*e].vertices.contains(&corner));
        let ranges = around.map(|e| extent.range(&mesh.edges[e].curve)).map(|[from, to]| (to - from).abs());
        // The innermost cells end beyond the ends of contact, neither next to them nor far from them.
        let share = BEYOND * (b - middle).max(middle - a) / ranges.fold(f64::INFINITY, f64::min);
        if share < 1.0 {
            let layers = (share.ln() / STEEPEST.ln()).ceil().max(1.0);
            mesh = square_layers(mesh, corner, share, layers as usize)?;
        }
        for place in [a, b] {
            let (cut, point) = cut_at(mesh, extent, place)?;
            mesh = cut;
            points.extend(point);
        }
    }
    Ok((mesh, points))
}

/// The mesh with a vertex at a place on the contact surface, and where that is: one that is there stays.
fn cut_at(mesh: Mesh, extent: Extent, place: f64) -> Result<(Mesh, Option<[f64; 2]>), Error> {
    let edges = mesh.boundary(CONTACT)?;
    let inside =
        edges.into_iter().map(|e| (e, extent.parameter(&mesh.edges[e].curve, place))).find(|(_, t)| t.abs() < 1.0 - 1e-9);
    if let Some((edge, t)) = inside {
        let point = mesh.edges[edge].curve.point(t);
        return Ok((mesh.cut_through(edge, t)?, Some(point)));
    }
    let vertex = at_end(&mesh, extent, place).map(|(edge, side)| mesh.vertices[mesh.edges[edge].vertices[side]]);
    Ok((mesh, vertex))
}

/// Layers around a vertex on the contact surface that make the edges of that `share` times as long, and those inside the body about as long as these: cells
/// as high as the body are no longer than high beside a short contact. Nothing is singular there: these cells keep their degree.
pub(crate) fn square_layers(mut mesh: Mesh, vertex: usize, share: f64, layers: usize) -> Result<Mesh, Error> {
    let along = share.powf(1.0 / layers as f64);
    let contact = mesh.boundary(CONTACT)?;
    let own = contact.iter().filter(|e| mesh.edges[**e].vertices.contains(&vertex));
    let size = share * own.map(|e| mesh.edges[*e].curve.length()).fold(f64::INFINITY, f64::min);
    for left in (1..=layers).rev() {
        let contact = mesh.boundary(CONTACT)?;
        let inwards = |length: f64| (size / length).powf(1.0 / left as f64).min(FLATTEST);
        let ratio = |edge: usize| if contact.contains(&edge) { along } else { inwards(mesh.edges[edge].curve.length()) };
        mesh = mesh.refined_towards_by(&[vertex], ratio)?;
    }
    mesh.cells.iter_mut().for_each(|cell| cell.layer = 0);
    Ok(mesh)
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
        let length = (b - a).abs();
        let share = if 1.0 - t.abs() < CLOSEST {
            let layers = (BEYOND_CLOSEST * distance / length).ln() / RATIO.ln();
            RATIO.powi(layers.floor() as i32)
        } else {
            JUST_BEYOND * distance / length
        };
        if share < 1.0 {
            let corner = mesh.edges[edge].vertices[side];
            let layers = (share.ln() / RATIO.ln() - ROUND_OFF).ceil().max(1.0);
            mesh = square_layers(mesh, corner, share, layers as usize)?;
        }
        let (cut, point) = cut_at(mesh, extent, place)?;
        points.extend(point);
        mesh = cut_at(cut, extent, 0.5 * (place + end))?.0;
    }
    Ok((mesh, points))
}

/// The mesh with the cells on the contact cut in their middle that touch two of the vertices towards which it is to be graded. Both bodies have the same
/// break points and such vertices there, and so the same cuts.
pub(crate) fn cut_between(mut mesh: Mesh, graded: impl Fn(&Mesh) -> Vec<usize>) -> Result<Mesh, Error> {
    loop {
        let vertices = graded(&mesh);
        let touches_two = |edge: &usize| mesh.edges[*edge].vertices.iter().all(|vertex| vertices.contains(vertex));
        let Some(edge) = mesh.boundary(CONTACT)?.into_iter().find(touches_two) else { return Ok(mesh) };
        mesh = mesh.cut_through(edge, 0.0)?;
    }
}

/// The contact edge at an end of the surface, and which of its ends that is.
pub(crate) fn at_end(mesh: &Mesh, extent: Extent, end: f64) -> Option<(usize, usize)> {
    let [from, to] = extent.ends();
    mesh.boundary(CONTACT).ok()?.into_iter().find_map(|e| {
        let range = extent.range(&mesh.edges[e].curve);
        let side = (0..2).find(|k| (range[*k] - end).abs() <= 1e-9 * (to - from))?;
        Some((e, side))
    })
}
