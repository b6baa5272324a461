//! The loads of a body by edges and cells.

use crate::boundary::path;
use crate::error::Error;
use crate::load_case::{BoundaryTraction, EdgeTraction, Load, LoadCase, PointForce};
use crate::mesh::Mesh;
use crate::point_search::PointSearch;
use std::cell::OnceCell;
use std::collections::BTreeMap;

/// A traction on an edge, or on a part of it.
pub(crate) struct EdgeLoad<'a> {
    /// The cell that takes it.
    pub(crate) owner: usize,
    /// Column of the load case.
    pub(crate) case: usize,
    /// The traction, MPa.
    pub(crate) traction: &'a BoundaryTraction,
    /// Part of the edge in its own parameter.
    pub(crate) part: [f64; 2],
}

/// A force at a point of a cell.
pub(crate) struct CellForce {
    /// Column of the load case.
    pub(crate) case: usize,
    /// Reference coordinates.
    pub(crate) reference: [f64; 2],
    /// The force, N.
    pub(crate) force: [f64; 2],
}

/// The loads of all cases, by what takes them.
pub(crate) struct Loads<'a> {
    /// Number of load cases.
    pub(crate) cases: usize,
    /// Tractions by edge.
    pub(crate) edges: Vec<Vec<EdgeLoad<'a>>>,
    /// Body forces and eigenstrains, with the number of their case; they act on every cell.
    pub(crate) volume: Vec<(usize, &'a Load)>,
    /// Forces at points, by cell.
    pub(crate) points: BTreeMap<usize, Vec<CellForce>>,
}

impl<'a> Loads<'a> {
    /// Finds what takes the loads of these cases.
    ///
    /// # Errors
    /// Boundaries that do not exist or are no path where part of them is loaded, parts off the path, points outside the mesh.
    pub(crate) fn new(mesh: &Mesh, cases: &'a [LoadCase]) -> Result<Loads<'a>, Error> {
        let edges = mesh.edges.iter().map(|_| Vec::new()).collect();
        let mut loads = Loads { cases: cases.len(), edges, volume: Vec::new(), points: BTreeMap::new() };
        if cases.iter().all(|case| case.loads.is_empty()) {
            return Ok(loads);
        }
        let neighbours = mesh.edge_cells();
        let search = OnceCell::new();
        for (number, case) in cases.iter().enumerate() {
            for load in &case.loads {
                match load {
                    Load::Traction(traction) => loads.push_traction(mesh, &neighbours, (number, traction))?,
                    Load::PointForce(point) => {
                        loads.push_point(search.get_or_init(|| PointSearch::new(mesh)), (number, point))?
                    }
                    Load::BodyForce(_) | Load::Eigenstrain(_) => loads.volume.push((number, load)),
                }
            }
        }
        Ok(loads)
    }

    fn push_traction(
        &mut self,
        mesh: &Mesh,
        neighbours: &[Vec<(usize, usize)>],
        (case, load): (usize, &'a EdgeTraction),
    ) -> Result<(), Error> {
        let traction = &load.traction;
        let Some(range) = load.range else {
            for e in mesh.boundary(&load.boundary)? {
                self.edges[e].push(EdgeLoad { owner: neighbours[e][0].0, case, traction, part: [-1.0, 1.0] });
            }
            return Ok(());
        };
        let mut start = 0.0;
        for (e, against) in path(mesh, &load.boundary)? {
            let own = mesh.edges[e].curve;
            let curve = if against { own.reversed() } else { own };
            let length = curve.length();
            let [a, b] = range.map(|s| curve.parameter_at_length((s - start).clamp(0.0, length)));
            if b > a {
                let part = if against { [-b, -a] } else { [a, b] };
                self.edges[e].push(EdgeLoad { owner: neighbours[e][0].0, case, traction, part });
            }
            start += length;
        }
        if range[0] >= start || range[1] <= 0.0 {
            let quantity = format!("the start of a loaded part of \"{}\", which is {start} long", load.boundary);
            return Err(Error::OutOfRange { quantity, value: range[0], range: "on it" });
        }
        Ok(())
    }

    fn push_point(&mut self, search: &PointSearch<'_>, (case, load): (usize, &PointForce)) -> Result<(), Error> {
        let (cell, xi, eta) = search.locate(load.at)?;
        self.points.entry(cell).or_default().push(CellForce { case, reference: [xi, eta], force: load.force });
        Ok(())
    }

    /// Whether a cell has loads inside.
    pub(crate) fn inside(&self, cell: usize) -> bool {
        !self.volume.is_empty() || self.points.contains_key(&cell)
    }

    /// Whether a cell takes a load on one of its edges.
    pub(crate) fn on_edges(&self, mesh: &Mesh, cell: usize) -> bool {
        mesh.cells[cell].sides().any(|(_, e)| self.edges[e].iter().any(|load| load.owner == cell))
    }

    /// Whether a cell takes a load of one case.
    pub(crate) fn of_case(&self, mesh: &Mesh, cell: usize, case: usize) -> bool {
        let on_edge = |e: usize| self.edges[e].iter().any(|load| load.owner == cell && load.case == case);
        self.volume.iter().any(|(number, _)| *number == case)
            || self.points.get(&cell).is_some_and(|points| points.iter().any(|point| point.case == case))
            || mesh.cells[cell].sides().any(|(_, e)| on_edge(e))
    }
}
