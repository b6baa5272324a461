//! Space and order of elimination of a body, before anything is assembled.

use crate::additions::{Additions, Foundation};
use crate::boundary::path;
use crate::check::check;
use crate::congruence::Congruence;
use crate::edge_load::{EdgeLoad, edge_loads};
use crate::error::Error;
use crate::foundation::edge_groups;
use crate::front::Plan;
use crate::mesh::Mesh;
use crate::problem::BodyProblem;
use crate::space::Space;

/// Space and order of elimination of a body.
pub(crate) struct Ordered<'a> {
    pub(crate) space: Space,
    /// Edges of the kept boundary along its path.
    pub(crate) walk: Vec<(usize, bool)>,
    pub(crate) edge_loads: Vec<Vec<EdgeLoad<'a>>>,
    /// Edges on foundations.
    pub(crate) foundations: Vec<(usize, &'a Foundation)>,
    pub(crate) congruence: Congruence,
    /// Groups of every element of the elimination, cells before foundations, sorted by rank.
    pub(crate) groups: Vec<Vec<usize>>,
    /// Number of unknowns of each group; the group after those of the space is that of the right-hand sides.
    pub(crate) size: Vec<usize>,
    /// Groups that are kept; the right-hand sides are the last.
    pub(crate) kept: Vec<usize>,
    pub(crate) plan: Plan,
    pub(crate) bytes: u64,
}

impl<'a> Ordered<'a> {
    pub(crate) fn new(problem: &'a BodyProblem<'_>, additions: &'a Additions<'_>) -> Result<Ordered<'a>, Error> {
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
        let edge_loads = edge_loads(mesh, problem.load_cases, &additions.segments)?;
        let foundations = additions.foundation_edges(mesh)?;
        let congruence = if problem.kinematics.is_revolved() {
            // The radius tells cells apart.
            Congruence::none(mesh, &space)
        } else {
            Congruence::of_plane_cells(mesh, &space)
        };
        let mut groups: Vec<Vec<usize>> = (0..mesh.cells.len()).map(|c| space.cell_groups(mesh, c)).collect();
        groups.extend(foundations.iter().map(|(e, _)| edge_groups(mesh, &space, *e)));
        let columns = space.size.len();
        let mut kept = kept_groups(mesh, &space, &walk);
        kept.push(columns);
        for (c, cell) in mesh.cells.iter().enumerate() {
            let vertices = mesh.vertices.len();
            let loaded = |e: usize| edge_loads[e].iter().any(|load| load.owner == c);
            let supported = |g: usize| space.is_supported(g);
            if !additions.body_forces.is_empty()
                || cell.vertices().iter().any(|v| supported(*v))
                || cell.sides().any(|(_, e)| loaded(e) || supported(vertices + e))
            {
                groups[c].push(columns);
            }
        }
        for (number, (e, _)) in foundations.iter().enumerate() {
            let [a, b] = mesh.edges[*e].vertices;
            if [a, b, mesh.vertices.len() + e].iter().any(|g| space.is_supported(*g)) {
                groups[mesh.cells.len() + number].push(columns);
            }
        }
        let middle = |corners: &[usize]| -> [f64; 2] {
            std::array::from_fn(|i| corners.iter().map(|v| mesh.vertices[*v][i]).sum::<f64>() / corners.len() as f64)
        };
        let mut places: Vec<[f64; 2]> = mesh.cells.iter().map(|c| middle(c.vertices())).collect();
        places.extend(foundations.iter().map(|(e, _)| middle(&mesh.edges[*e].vertices)));
        // The order does not depend on the number of right-hand sides.
        let mut size = space.size.clone();
        size.push(0);
        let plan = Plan::new(&groups, &places, &size, &kept);
        size[columns] = problem.load_cases.len() + 1 + 3 * (problem.supports.len() + additions.pins.len());
        groups.iter_mut().for_each(|groups| groups.sort_by_key(|g| plan.rank[*g]));
        let first = |e: usize| congruence.class.get(e).is_none_or(|class| congruence.classes[*class].first == e);
        let bytes = plan.bytes(&groups, &size, &kept, |e| first(e) || groups[e].last() == Some(&columns));
        Ok(Ordered { space, walk, edge_loads, foundations, congruence, groups, size, kept, plan, bytes })
    }
}

/// Number of unknowns of a whole body.
pub(crate) fn whole_size(mesh: &Mesh, space: &Space) -> usize {
    let interior = |c: usize| space.components * space.local_modes(mesh, c).interior;
    space.size.iter().sum::<usize>() + (0..mesh.cells.len()).map(interior).sum::<usize>()
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
