//! What a reduction will take, known from the mesh and the degrees before anything is computed.

use crate::additions::{Additions, edge_groups};
use crate::body::{Body, BodyProblem};
use crate::check::check;
use crate::congruence::Congruence;
use crate::error::Error;
use crate::mesh::Mesh;
use crate::plan::Plan;
use crate::space::Space;
use crate::trace::path;

/// Sizes of a reduction before it is done.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Sizes {
    /// Number of cells.
    pub cells: usize,
    /// Number of unknowns of the whole body.
    pub unknowns: usize,
    /// Number of unknowns that are kept: those of the kept boundary and of the rigid edge.
    pub kept_unknowns: usize,
    /// Gauss-Lobatto points of the kept boundary.
    pub points: usize,
    /// Memory that the elimination will hold at once, bytes; [`Body::new`] refuses bodies by this number.
    pub bytes: u64,
    /// Multiplications of the element matrices, of condensing them and of the elimination, right-hand sides not counted.
    pub operations: f64,
}

/// Space and order of elimination of a body.
pub(crate) struct Ordered {
    pub(crate) space: Space,
    /// Edges of the kept boundary along its path.
    pub(crate) walk: Vec<(usize, bool)>,
    pub(crate) kept_groups: Vec<usize>,
    pub(crate) plan: Plan,
    pub(crate) bytes: u64,
}

impl Ordered {
    pub(crate) fn new(problem: &BodyProblem<'_>, additions: &Additions<'_>) -> Result<Ordered, Error> {
        check(problem)?;
        additions.check(problem)?;
        let mesh = problem.mesh;
        let space = Space::new(
            mesh,
            problem.degrees.clone(),
            problem.space,
            problem.kinematics,
            problem.supports,
            problem.rigid_edge.as_ref(),
            additions,
        )?;
        let walk = problem.kept.map(|name| path(mesh, name)).transpose()?.unwrap_or_default();
        let kept_groups = kept_groups(mesh, &space, &walk);
        let foundations = additions.foundation_edges(mesh)?;
        let mut element_groups: Vec<Vec<usize>> = (0..mesh.cells.len()).map(|c| space.cell_groups(mesh, c, &[])).collect();
        element_groups.extend(foundations.iter().map(|(e, _)| edge_groups(mesh, &space, *e, &[])));
        let middle = |corners: &[usize]| -> [f64; 2] {
            std::array::from_fn(|i| corners.iter().map(|v| mesh.vertices[*v][i]).sum::<f64>() / corners.len() as f64)
        };
        let mut places: Vec<[f64; 2]> = mesh.cells.iter().map(|c| middle(c.vertices())).collect();
        places.extend(foundations.iter().map(|(e, _)| middle(&mesh.edges[*e].vertices)));
        let plan = Plan::new(&element_groups, &places, &space.size, &kept_groups);
        let bytes = plan.bytes(&element_groups, &space.size);
        Ok(Ordered { space, walk, kept_groups, plan, bytes })
    }
}

/// Number of unknowns of a whole body.
pub(crate) fn whole_size(mesh: &Mesh, space: &Space) -> usize {
    let interior = |c: usize| space.components * space.local_modes(mesh, c).interior;
    space.size.iter().sum::<usize>() + (0..mesh.cells.len()).map(interior).sum::<usize>()
}

impl Body<'_> {
    /// What [`Body::new`] will take: it meshes nothing, assembles nothing and factors nothing. A body beyond the memory has sizes too.
    ///
    /// # Errors
    /// As for [`Body::new`], as far as no element is needed to see it.
    pub fn sizes(problem: &BodyProblem<'_>) -> Result<Sizes, Error> {
        let ordered = Ordered::new(problem, &Additions::default())?;
        let (mesh, space) = (problem.mesh, &ordered.space);
        // Similar cells share one matrix.
        let congruence = if problem.kinematics.is_revolved() {
            Congruence::none(mesh, space)
        } else {
            Congruence::of_plane_cells(mesh, space)
        };
        let matrices = congruence.classes.iter().map(|class| {
            let modes = space.local_modes(mesh, class.first);
            let points = (space.cell_degree[class.first] + 2) as f64;
            let scalar = modes.modes as f64;
            // Four products of derivatives for each pair of components, summed over one direction of points after the other.
            let pairs = if space.components == 2 { 3.0 } else { 1.0 };
            4.0 * pairs * scalar * scalar * points
                + partial_factor((space.components * modes.interior) as f64, space.components as f64 * scalar)
        });
        let size = |groups: &[usize]| groups.iter().map(|g| space.size[*g]).sum::<usize>() as f64;
        let fronts = ordered.plan.fronts.iter().map(|f| partial_factor(size(&f.groups[..f.eliminated]), size(&f.groups)));
        let points: usize = ordered.walk.iter().map(|(edge, _)| space.edge_degree[*edge]).sum();
        Ok(Sizes {
            cells: mesh.cells.len(),
            unknowns: whole_size(mesh, space),
            kept_unknowns: ordered.kept_groups.iter().map(|g| space.size[*g]).sum(),
            points: points + usize::from(!ordered.walk.is_empty()),
            bytes: ordered.bytes,
            operations: matrices.sum::<f64>() + fronts.sum::<f64>(),
        })
    }
}

/// Multiplications to eliminate `gone` of `all` unknowns of a dense symmetric matrix.
fn partial_factor(gone: f64, all: f64) -> f64 {
    let left = all - gone;
    gone.powi(3) / 6.0 + 0.5 * gone * gone * left + 0.5 * gone * left * left
}

/// Groups whose unknowns are kept: those of the path in order, then the rigid edge.
fn kept_groups(mesh: &Mesh, space: &Space, walk: &[(usize, bool)]) -> Vec<usize> {
    let mut groups = Vec::new();
    for (i, (edge, against)) in walk.iter().enumerate() {
        let [a, b] = mesh.edges[*edge].vertices;
        let (from, to) = if *against { (b, a) } else { (a, b) };
        if i == 0 {
            groups.push(from);
        }
        groups.extend([mesh.vertices.len() + edge, to]);
    }
    groups.extend(space.frame.iter().map(|(g, _)| *g));
    groups.retain(|g| space.size[*g] > 0);
    groups
}
