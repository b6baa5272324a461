//! The adaptive driver: an accuracy goes in, a mesh with degrees comes out.

use crate::basis::MAX_DEGREE;
use crate::error::Error;
use crate::estimate::{check_quantities, sequence_estimate};
use crate::mesh::Mesh;
use crate::singular::SingularVertex;

/// Ratio of the sizes of neighbouring layers, close to the best one, `(sqrt 2 - 1)^2 = 0.17` (Gui and Babuska 1986).
const RATIO: f64 = 0.15;

/// Length of the shortest edge at a singular vertex over the coordinates of the vertex below which no layer is cut: round-off of the places would shape its cells.
const FINEST: f64 = 1e-11;

/// How an adaptive run ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AdaptStatus {
    /// The estimated error is below the accuracy asked for.
    Reached,
    /// The highest degree was reached first.
    DegreeLimit,
}

impl AdaptStatus {
    /// The status as a sentence.
    pub fn sentence(self) -> &'static str {
        match self {
            AdaptStatus::Reached => "The estimated error is below the accuracy asked for.",
            AdaptStatus::DegreeLimit => "The highest allowed degree was reached before the accuracy asked for.",
        }
    }
}

/// Result of an adaptive run.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Adapted {
    /// The last mesh.
    pub mesh: Mesh,
    /// Degrees of its cells, one a cell.
    pub degrees: Vec<usize>,
    /// The quantities of every level, the last level last, in the units of `quantity`: `levels x quantities`, level `k` of degree `k + 2`.
    pub quantities: Vec<Vec<f64>>,
    /// Estimated relative error of the last quantities in the Euclidean norm, a number without unit; infinite below three levels.
    pub estimate: f64,
    /// How it ended.
    pub status: AdaptStatus,
}

/// Mesh and degrees of level `p`: geometric layers towards every singular vertex, degree `p` outside, falling linearly into the layers
/// (Babuska and Guo 1986). The coarse mesh is refined uniformly first where a cell touches two singular vertices.
///
/// The number of layers balances the error left in the innermost cell, `RATIO^(layers * exponent)`, with the one of the degree; it ends where round-off of the
/// coordinates would shape the cells, later at vertices near the origin.
///
/// # Errors
/// [`Error::FoldedCell`] if a cell cannot be cut; [`Error::OutOfRange`] if `p` is not in `1..=24` or an exponent not in `(0, 1]`; [`Error::Beyond`] for a
/// vertex that does not exist.
pub fn graded_level(coarse: &Mesh, singular: &[SingularVertex], p: usize) -> Result<(Mesh, Vec<usize>), Error> {
    if !(1..=MAX_DEGREE).contains(&p) {
        return Err(Error::OutOfRange { quantity: "the degree of a level".into(), value: p as f64, range: "in 1..=24" });
    }
    if let Some(s) = singular.iter().find(|s| !(s.exponent > 0.0 && s.exponent <= 1.0)) {
        let quantity = format!("the exponent of the singular vertex {}", s.vertex);
        return Err(Error::OutOfRange { quantity, value: s.exponent, range: "in (0, 1]" });
    }
    if let Some(s) = singular.iter().find(|s| s.vertex >= coarse.vertices.len()) {
        let (by, count) = ("the list of singular vertices".into(), coarse.vertices.len());
        return Err(Error::Beyond { by, what: "vertex", index: s.vertex, count });
    }
    let vertices: Vec<usize> = singular.iter().map(|s| s.vertex).collect();
    let mut mesh = coarse.clone();
    // Vertices keep their numbers in every refinement.
    while mesh.cells.iter().any(|c| c.vertices().iter().filter(|v| vertices.contains(v)).count() > 1) {
        mesh = mesh.refined()?;
    }
    let mut deepest = 0;
    let depth = |s: &SingularVertex| ((0.75 * p as f64 / s.exponent).ceil() as usize).clamp(1, 4 * p);
    loop {
        let open = singular.iter().filter(|s| depth(s) > deepest && has_room(&mesh, s.vertex));
        let open: Vec<usize> = open.map(|s| s.vertex).collect();
        if open.is_empty() {
            break;
        }
        mesh = mesh.refined_towards(&open, RATIO, 1)?;
        deepest += 1;
    }
    let degrees = mesh
        .cells
        .iter()
        .map(|c| (p + 1).saturating_sub(c.layer.saturating_mul(p).checked_div(deepest).unwrap_or(0)).clamp(2.min(p), p))
        .collect();
    Ok((mesh, degrees))
}

/// Whether the digits of the coordinates leave room for one more layer at a vertex.
fn has_room(mesh: &Mesh, vertex: usize) -> bool {
    let [x, z] = mesh.vertices[vertex];
    let own = mesh.edges.iter().filter(|edge| edge.vertices.contains(&vertex));
    let shortest = own.map(|edge| edge.curve.length()).fold(f64::INFINITY, f64::min);
    RATIO * shortest > FINEST * x.hypot(z)
}

/// Raises degree and layers together until the estimated relative error of `quantity(mesh, degrees)` (energies, displacements at points,
/// anything that converges) is at most `accuracy`, or the degree reaches `highest`. That of a single displacement or stress at a point may be told too small, see
/// [`sequence_estimate`].
///
/// # Errors
/// Those of `quantity` and of the refinement; [`Error::Count`] if there are no quantities or their number changes; [`Error::OutOfRange`] if one of them is not
/// finite, `accuracy` is not positive or `highest` not in `3..=24`.
pub fn adapt(
    coarse: &Mesh,
    singular: &[SingularVertex],
    accuracy: f64,
    highest: usize,
    mut quantity: impl FnMut(&Mesh, &[usize]) -> Result<Vec<f64>, Error>,
) -> Result<Adapted, Error> {
    if accuracy.is_nan() || accuracy <= 0.0 {
        return Err(Error::OutOfRange { quantity: "the accuracy".into(), value: accuracy, range: "positive" });
    }
    if !(3..=MAX_DEGREE).contains(&highest) {
        return Err(Error::OutOfRange { quantity: "the highest degree".into(), value: highest as f64, range: "in 3..=24" });
    }
    let mut quantities: Vec<Vec<f64>> = Vec::new();
    let mut p = 1;
    loop {
        p += 1;
        let (mesh, degrees) = graded_level(coarse, singular, p)?;
        let found = quantity(&mesh, &degrees)?;
        check_quantities(&found, || format!("the level of degree {p}"))?;
        quantities.push(found);
        // Three levels at least: an estimate from one difference cannot know the rate.
        let estimate = if quantities.len() < 3 { f64::INFINITY } else { sequence_estimate(&quantities)? };
        let status = if estimate <= accuracy { AdaptStatus::Reached } else { AdaptStatus::DegreeLimit };
        if status == AdaptStatus::Reached || p == highest {
            return Ok(Adapted { mesh, degrees, quantities, estimate, status });
        }
    }
}
