//! What a reduction will take, known from the mesh and the degrees before anything is computed.

use crate::basis::LocalModes;
use crate::body::Body;
use crate::error::Error;
use crate::front::partial_factor;
use crate::ordered::{Ordered, whole_size};
use crate::problem::BodyProblem;

/// Sizes of a reduction before it is done.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Sizes {
    /// Number of cells.
    pub cells: usize,
    /// Number of unknowns of the whole body.
    pub unknowns: usize,
    /// Number of unknowns that are kept: those of the kept boundary and of the rigid edge.
    pub kept_unknowns: usize,
    /// Gauss-Lobatto points of the kept boundaries.
    pub points: usize,
    /// Memory that [`Body::new`] will hold at once, factors, right-hand sides and mesh included, bytes; bodies beyond 12 GiB
    /// are refused by this number. Between 0.9 and 1.3 of what is measured, for bodies beyond some 20 MB.
    pub bytes: u64,
    /// Multiplications of the element matrices, of condensing them and of the elimination, right-hand sides not counted.
    pub operations: f64,
    /// Unknowns on the boundaries of all cells, of which each counts its own.
    pub(crate) outer_unknowns: usize,
    /// Numbers of what temperatures do to cells, of similar ones once.
    pub(crate) cell_heats: usize,
}

impl Sizes {
    /// Memory that [`Body::for_heat`] and [`Body::of_temperature`] hold more than [`Body::new`], bytes: what temperatures on the boundary of a cell do to
    /// it, and how they go on inside. A body that was made without takes it in [`Body::heated`].
    pub fn for_heat_bytes(&self) -> u64 {
        8 * self.cell_heats as u64
    }

    /// Memory that [`Body::heated`] will hold at once for so many temperatures, bytes, besides both bodies: the loads on the boundary of each cell,
    /// the temperatures on all edges, displacements forwards along the fronts, and the columns of the reduced body.
    pub fn heated_bytes(&self, temperatures: usize) -> u64 {
        let (many, kept) = (temperatures as u64, self.kept_unknowns as u64);
        // An edge belongs to two cells, and a temperature has one component.
        let on_edges = self.outer_unknowns as u64 / 2;
        let cells = self.outer_unknowns as u64 + on_edges / 2 + on_edges;
        8 * (many * (cells + 2 * kept) + many * many)
    }
}

impl Body {
    /// What [`Body::new`] will take: it meshes nothing, assembles nothing and factors nothing. A body beyond the memory has sizes too.
    ///
    /// # Errors
    /// As for [`Body::new`], as far as no element is needed to see it.
    pub fn sizes(problem: &BodyProblem) -> Result<Sizes, Error> {
        let ordered = Ordered::new(problem)?;
        let (mesh, space) = (&*problem.mesh, &ordered.space);
        // Similar cells share one matrix.
        let matrices = ordered.congruence.classes.iter().map(|class| {
            let modes = space.local_modes(mesh, class.first);
            let points = (space.cell_degree[class.first] + 2) as f64;
            let scalar = modes.modes as f64;
            // Four products of derivatives for each pair of components, summed over one direction of points after the other.
            let pairs = if space.components == 2 { 3.0 } else { 1.0 };
            4.0 * pairs * scalar * scalar * points
                + partial_factor((space.components * modes.interior) as f64, space.components as f64 * scalar)
        });
        let size = |groups: &[usize]| groups.iter().map(|g| ordered.size[*g]).sum::<usize>() as f64;
        let fronts = ordered.plan.fronts.iter().map(|f| partial_factor(size(&f.groups[..f.eliminated]), size(&f.groups)));
        let outer = |modes: &LocalModes| space.components * (modes.modes - modes.interior);
        let points = |walk: &Vec<(usize, bool)>| walk.iter().map(|(edge, _)| space.edge_degree[*edge]).sum::<usize>() + 1;
        // A column for each temperature, which has one component.
        let heats = ordered.congruence.classes.iter().map(|class| {
            let modes = space.modes_of(mesh, class.first, class.edges, [false; 4]);
            (outer(&modes) + modes.interior) * (modes.modes - modes.interior)
        });
        Ok(Sizes {
            cells: mesh.cells.len(),
            unknowns: whole_size(mesh, space),
            kept_unknowns: ordered.kept.unknowns,
            points: ordered.kept.walks.iter().map(points).sum(),
            bytes: ordered.bytes,
            operations: matrices.sum::<f64>() + fronts.sum::<f64>(),
            cell_heats: heats.sum(),
            outer_unknowns: (0..mesh.cells.len()).map(|cell| outer(&space.local_modes(mesh, cell))).sum(),
        })
    }
}
