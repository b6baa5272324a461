//! Space and order of elimination of a body, before anything is assembled.

use crate::amalgamation::sort_by_rank;
use crate::check::check;
use crate::congruence::Congruence;
use crate::edge_load::Loads;
use crate::error::Error;
use crate::foundation::edge_groups;
use crate::freedom::Foundation;
use crate::front::Plan;
use crate::kept::Kept;
use crate::mesh::Mesh;
use crate::problem::BodyProblem;
use crate::rigid::check_held;
use crate::space::Space;

/// Space and order of elimination of a body.
pub(crate) struct Ordered<'a> {
    pub(crate) space: Space,
    pub(crate) kept: Kept,
    pub(crate) loads: Loads<'a>,
    /// Edges on foundations.
    pub(crate) foundations: Vec<(usize, &'a Foundation)>,
    pub(crate) congruence: Congruence,
    /// Groups of every element of the elimination, cells before foundations, sorted by rank.
    pub(crate) groups: Vec<Vec<usize>>,
    /// Number of unknowns of each group; the group after those of the space is that of the right-hand sides.
    pub(crate) size: Vec<usize>,
    /// Groups that are not eliminated: the kept ones, then the right-hand sides.
    pub(crate) last: Vec<usize>,
    pub(crate) plan: Plan,
    pub(crate) bytes: u64,
}

impl<'a> Ordered<'a> {
    /// # Errors
    /// What is wrong with the problem, as far as no element is needed to see it.
    pub(crate) fn new(problem: &'a BodyProblem) -> Result<Ordered<'a>, Error> {
        check(problem)?;
        let mesh = &*problem.mesh;
        let space = Space::new(problem)?;
        let kept = Kept::new(mesh, &space, &problem.kept)?;
        let loads = Loads::new(mesh, &problem.load_cases)?;
        let foundations = problem.foundation_edges()?;
        check_held(problem, &space, &kept)?;
        let congruence = Congruence::of(problem, &space);
        let mut groups: Vec<Vec<usize>> = (0..mesh.cells.len()).map(|c| space.cell_groups(mesh, c)).collect();
        groups.extend(foundations.iter().map(|(e, _)| edge_groups(mesh, &space, *e)));
        let columns = space.size.len();
        for element in with_columns(mesh, &space, &loads, &foundations) {
            groups[element].push(columns);
        }
        // The order does not depend on the number of right-hand sides.
        let mut size = space.size.clone();
        size.push(0);
        let last: Vec<usize> = kept.groups.iter().copied().chain([columns]).collect();
        let plan = Plan::new(&groups, &places(mesh, &foundations), &size, &last);
        size[columns] = problem.columns();
        groups.iter_mut().for_each(|groups| sort_by_rank(groups, &plan.rank));
        let first = |e: usize| congruence.class.get(e).is_none_or(|class| congruence.classes[*class].first == e);
        let bytes = plan.bytes(&groups, &size, &last, |e| first(e) || groups[e].last() == Some(&columns));
        Ok(Ordered { space, kept, loads, foundations, congruence, groups, size, last, plan, bytes })
    }
}

/// Elements that have right-hand sides: cells with loads or supports, then foundations on supports.
fn with_columns(mesh: &Mesh, space: &Space, loads: &Loads<'_>, foundations: &[(usize, &Foundation)]) -> Vec<usize> {
    let vertices = mesh.vertices.len();
    let supported = |g: usize| space.is_supported(g);
    let cell = |c: &usize| {
        let (c, cell) = (*c, &mesh.cells[*c]);
        loads.inside(c)
            || loads.on_edges(mesh, c)
            || cell.vertices().iter().any(|v| supported(*v))
            || cell.sides().any(|(_, e)| supported(vertices + e))
    };
    let foundation = |number: &usize| {
        let (e, _) = foundations[*number];
        let [a, b] = mesh.edges[e].vertices;
        [a, b, vertices + e].iter().any(|g| supported(*g))
    };
    let cells = mesh.cells.len();
    (0..cells).filter(cell).chain((0..foundations.len()).filter(foundation).map(|number| cells + number)).collect()
}

/// Middles of the corners of all elements, cells before foundations.
fn places(mesh: &Mesh, foundations: &[(usize, &Foundation)]) -> Vec<[f64; 2]> {
    let middle = |corners: &[usize]| -> [f64; 2] {
        std::array::from_fn(|i| corners.iter().map(|v| mesh.vertices[*v][i]).sum::<f64>() / corners.len() as f64)
    };
    let mut places: Vec<[f64; 2]> = mesh.cells.iter().map(|c| middle(c.vertices())).collect();
    places.extend(foundations.iter().map(|(e, _)| middle(&mesh.edges[*e].vertices)));
    places
}

/// Number of unknowns of a whole body.
pub(crate) fn whole_size(mesh: &Mesh, space: &Space) -> usize {
    let interior = |c: usize| space.components * space.local_modes(mesh, c).interior;
    space.size.iter().sum::<usize>() + (0..mesh.cells.len()).map(interior).sum::<usize>()
}
