//! Both meshes of a couple: coarse cells with the same break points on the contact surface, graded towards singular points and ends of contact.

use hpfem::Mesh;
use scene::Fault;

use crate::cells::Cells;
use crate::coarse::{Coarse, RATIO, degenerate};
use crate::couple::Couple;
use crate::extent::{Cut, Extent};
use crate::half_disc::HalfDiscOnFlat;
use crate::ledge;
use crate::matching::matched;
use crate::near_ends::{self, Split, cut_between, cut_near, cut_small};
use crate::round_cells::as_cells;
use crate::slender_ends;
use crate::template::{at_corners, coarse, contact_cuts};

/// The meshes of body 1 and body 2, with so many `layers` of cells around each singular point, whose sizes fall by [`RATIO`], and half as
/// many around each end of contact, but for those given with corners of the gap. The edges named [`CONTACT`](crate::CONTACT) have the same break points in both.
///
/// # Errors
/// The fault of a body that is no body 1 or body 2 of this contact, that is too thin, or whose cells cannot be cut where the other's are.
pub fn meshes(couple: &Couple, extent: Extent, layers: usize, cut: Cut<'_>) -> Result<[Mesh; 2], Fault> {
    meshes_of(&GivenCells::new(couple, extent)?, couple, (extent, cut), layers)
}

/// The meshes of [`meshes`] from cells that are made ready.
///
/// # Errors
/// Those of [`meshes`].
pub fn meshes_of(
    given: &GivenCells,
    couple: &Couple,
    (extent, cut): (Extent, Cut<'_>),
    layers: usize,
) -> Result<[Mesh; 2], Fault> {
    if let Extent::Round { x: [from, to], touch, .. } = extent
        && let Some(mut disc) = HalfDiscOnFlat::of(couple)?
    {
        let places = cut.ends().iter().map(|t| from + 0.5 * (1.0 + t) * (to - from) - touch);
        let nodes: Vec<f64> = places.filter(|x| *x > 0.0).collect();
        disc.whole = !couple.is_revolved();
        return disc.meshes_reaching(&nodes, to - touch, around_ends(layers, matches!(cut, Cut::Corners(_))));
    }
    coarse_meshes(given, couple, extent, cut)?.graded(layers)
}

/// The bodies of a couple that are given by cells, cut where contact and load end and where these are slender, with the points towards which they are
/// graded: the same for every mesh of the couple.
#[derive(Debug)]
pub struct GivenCells {
    bodies: [Option<Cells>; 2],
}

impl GivenCells {
    /// Makes the cells of the bodies ready; templates have none, but where two round bodies or a round and a flat one touch.
    ///
    /// # Errors
    /// The fault of cells that cannot be cut there.
    pub fn new(couple: &Couple, extent: Extent) -> Result<GivenCells, Fault> {
        let round = matches!(extent, Extent::Round { .. } | Extent::Convex { .. });
        let one = |number: usize| {
            let body = &couple.bodies[number];
            let own = body.cells.as_deref().cloned();
            let mesh = own.or_else(|| if round { as_cells(couple, body) } else { None });
            mesh.map(|mesh| Cells::new(couple, number, mesh, extent)).transpose()
        };
        Ok(GivenCells { bodies: [one(0)?, one(1)?] })
    }
}

/// Both meshes of a couple before their layers: the same for every number of them.
#[derive(Debug)]
pub struct CoarseMeshes {
    bodies: [Coarse; 2],
    extent: Extent,
    /// Ends of contact next to those of the surface, from -1 to 1.
    near: Vec<f64>,
    /// Pairs of ends next to each other, from -1 to 1.
    small: Vec<[f64; 2]>,
    /// Whether the places of the cut have as many layers as singular points.
    corners: bool,
}

/// The meshes of [`meshes_of`] before their layers.
///
/// # Errors
/// Those of [`meshes`].
pub fn coarse_meshes(given: &GivenCells, couple: &Couple, extent: Extent, cut: Cut<'_>) -> Result<CoarseMeshes, Fault> {
    let (ends, passed) = passed(cut);
    let cut = if matches!(cut, Cut::Passed(_)) { Cut::Ends(&ends) } else { cut };
    let Split { far, near, small } = near_ends::split(cut, grown(&ends, passed), at_corners(couple, extent));
    let cut = if near.is_empty() && small.is_empty() { cut } else { cut.at(&far) };
    let mut middles: Vec<f64> = small.iter().map(|pair| near_ends::between(extent, *pair)).collect();
    if small.is_empty() {
        middles.extend(apart(extent, passed, &contact_cuts(couple, extent, cut, &[])));
    }
    let mut bodies = if given.bodies.iter().all(Option::is_none) {
        templates(couple, extent, cut, &middles)?
    } else {
        matched(couple, &given.bodies, extent, cut, &middles)?
    };
    slender_ends::cut_beside(&mut bodies, extent, cut);
    bodies.iter_mut().for_each(|body| slender_ends::cut_beyond(body, extent, cut));
    Ok(CoarseMeshes { bodies, extent, near, small, corners: matches!(cut, Cut::Corners(_)) })
}

/// Least distance of a place that ends of contact pass from another break point, over that from the next such place.
const APART: f64 = 0.4;

/// The outermost of the places that ends of contact pass, and those between them; none of the other cuts.
fn passed(cut: Cut<'_>) -> (Vec<f64>, &[f64]) {
    match cut {
        Cut::Passed([first, passed @ .., last]) => (vec![*first, *last], passed),
        Cut::Passed(ends) => (ends.to_vec(), &[]),
        Cut::Plain | Cut::Shifted | Cut::Ends(_) | Cut::Corners(_) => (Vec::new(), &[]),
    }
}

/// How many times as long as at its start a contact is that has grown much, and the most: a shorter start is within one cell of the size of the end.
const MUCH: [f64; 2] = [2.0, 15.0];

/// Whether the ends of contact come from a much shorter one, which is twice as long as the two innermost of the places that they pass are apart.
fn grown(ends: &[f64], passed: &[f64]) -> bool {
    let middle = passed.len() / 2;
    match (ends, &passed[middle.saturating_sub(1)..], passed.len() % 2) {
        ([from, to], [a, b, ..], 0) => (MUCH[0]..MUCH[1]).contains(&(0.5 * (to - from) / (b - a))),
        _ => false,
    }
}

/// Those of the places (from -1 to 1) that make no splinters with other break points, as coordinates.
fn apart(extent: Extent, passed: &[f64], others: &[f64]) -> Vec<f64> {
    let [from, to] = extent.ends();
    let places: Vec<f64> = passed.iter().map(|t| from + 0.5 * (1.0 + t) * (to - from)).collect();
    let least = |i: usize| {
        let beside = [i.checked_sub(1), Some(i + 1)].into_iter().flatten().filter_map(|j| places.get(j));
        beside.map(|place| (place - places[i]).abs()).fold(to - from, f64::min)
    };
    let far = |i: &usize| others.iter().all(|other| (other - places[*i]).abs() > APART * least(*i));
    (0..places.len()).filter(far).map(|i| places[i]).collect()
}

impl CoarseMeshes {
    /// The meshes of body 1 and body 2 with so many layers, as by [`meshes`].
    ///
    /// # Errors
    /// The fault of a body whose cells cannot be cut any further.
    pub fn graded(&self, layers: usize) -> Result<[Mesh; 2], Fault> {
        let [first, second] = &self.bodies;
        Ok([self.graded_body(first, layers, "body1.geometry")?, self.graded_body(second, layers, "body2.geometry")?])
    }

    fn graded_body(&self, coarse: &Coarse, layers: usize, key: &str) -> Result<Mesh, Fault> {
        let vertices = |mesh: &Mesh, points: &[[f64; 2]]| points.iter().map(|x| mesh.nearest_vertex(*x)).collect::<Vec<usize>>();
        let (mesh, near) = cut_near(coarse.mesh.clone(), self.extent, &self.near).map_err(|error| degenerate(key, &error))?;
        let (mesh, small) = cut_small(mesh, self.extent, &self.small).map_err(|error| degenerate(key, &error))?;
        let free = [coarse.free.as_slice(), &near, &small].concat();
        let points = [coarse.singular.as_slice(), &free].concat();
        let mesh = cut_between(mesh, |mesh| vertices(mesh, &points)).map_err(|error| degenerate(key, &error))?;
        // Cells that are sound with one layer are too small with many.
        let grade = |layers| ledge::graded(&mesh, &coarse.singular, coarse.ledges, layers);
        let mesh = grade(layers).map_err(|error| match grade(1) {
            Ok(_) => too_many(key, layers, &error),
            Err(_) => degenerate(key, &error),
        })?;
        let free = vertices(&mesh, &free);
        if free.is_empty() {
            return Ok(mesh);
        }
        mesh.refined_towards(&free, RATIO, around_ends(layers, self.corners)).map_err(|error| too_many(key, layers, &error))
    }
}

/// Layers around ends of contact, where singular points have so many: the pressure falls there as a root, which takes half of them; under a corner of the
/// gap it is infinite.
fn around_ends(layers: usize, corners: bool) -> usize {
    if corners { layers } else { layers.div_ceil(2) }
}

/// The fault of a mesh that has cells before it is graded, and none that are sound after: they are too small for their coordinates.
fn too_many(key: &str, layers: usize, error: &hpfem::Error) -> Fault {
    let message = format!("{layers} layers of cells around a point of {key}, each 1/{} of the one before: {error}", 1.0 / RATIO);
    Fault::at("mesh.layers", "degenerate", message, "give fewer layers, as in mesh.layers = 8")
}

/// The coarse meshes of two templates, with further `breaks` on the contact surface.
fn templates(couple: &Couple, extent: Extent, cut: Cut<'_>, breaks: &[f64]) -> Result<[Coarse; 2], Fault> {
    let cuts = contact_cuts(couple, extent, cut, breaks);
    let first = coarse(couple, 0, extent, &cuts, cut)?;
    let mut second = coarse(couple, 1, extent, &cuts, cut)?;
    // Points of the contact surface that need layers in the shaped body need them in both, for common break points.
    second.free = first.free.iter().map(|x| extent.facing(0, *x)).collect();
    for x in first.singular.iter().map(|x| extent.facing(0, *x)) {
        let y = second.mesh.vertices[second.mesh.nearest_vertex(x)];
        let scale = x[0].hypot(x[1]);
        let near = |z: &[f64; 2]| (x[0] - z[0]).hypot(x[1] - z[1]) <= 1e-9 * scale;
        if near(&y) && !second.singular.iter().any(near) {
            second.singular.push(x);
        }
    }
    Ok([first, second])
}
