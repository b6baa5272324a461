//! Tractions as loads on the unknowns of cells: on whole boundaries, or on a part of one between two arc lengths.

use crate::additions::SegmentTraction;
use crate::assemble::{Assembly, BoundaryTraction, LoadCase};
use crate::basis::{BoundaryModes, points_for};
use crate::boundary::{boundary_point, path};
use crate::error::Error;
use crate::legendre::shape_functions;
use crate::mesh::{CELL_EDGES, Mesh};
use crate::quadrature::gauss;

/// A traction on an edge, or on a part of it.
pub(crate) struct EdgeLoad<'a> {
    /// The cell that takes it.
    pub(crate) owner: usize,
    /// Column of the load case.
    case: usize,
    traction: &'a BoundaryTraction<'a>,
    /// Part of the edge in its own parameter.
    part: [f64; 2],
}

/// The loads of every edge.
pub(crate) fn edge_loads<'b>(
    mesh: &Mesh,
    cases: &'b [LoadCase<'_>],
    segments: &'b [SegmentTraction<'_>],
) -> Result<Vec<Vec<EdgeLoad<'b>>>, Error> {
    let neighbours = mesh.edge_cells();
    let mut loads: Vec<Vec<EdgeLoad<'b>>> = mesh.edges.iter().map(|_| Vec::new()).collect();
    for (case, tractions) in cases.iter().enumerate() {
        for load in tractions {
            for e in mesh.boundary(&load.boundary)? {
                loads[e].push(EdgeLoad { owner: neighbours[e][0].0, case, traction: &load.traction, part: [-1.0, 1.0] });
            }
        }
    }
    for segment in segments {
        let mut start = 0.0;
        for (e, against) in path(mesh, &segment.boundary)? {
            let own = mesh.edges[e].curve;
            let curve = if against { own.reversed() } else { own };
            let length = curve.length();
            let [a, b] = segment.range.map(|s| curve.parameter_at_length((s - start).clamp(0.0, length)));
            if b > a {
                let part = if against { [-b, -a] } else { [a, b] };
                loads[e].push(EdgeLoad { owner: neighbours[e][0].0, case: segment.case, traction: &segment.traction, part });
            }
            start += length;
        }
    }
    Ok(loads)
}

impl Assembly<'_> {
    /// Consistent loads of the cell's loaded edges: `((local boundary unknown, column), value)`.
    pub(crate) fn cell_loads(&self, cell: usize, modes: &BoundaryModes) -> Vec<((usize, usize), f64)> {
        let mut loads = Vec::new();
        for (e, edge) in self.mesh.cells[cell].sides() {
            // Edge 3 of a triangle ends at corner 2, which is corner 3 too.
            let ends = CELL_EDGES[e].map(|k| k.min(modes.corners - 1));
            let against = self.mesh.cells[cell].against[e];
            for load in self.edge_loads[edge].iter().filter(|load| load.owner == cell) {
                let degree = self.space.edge_degree[edge];
                let rule = gauss(points_for(degree) + 4);
                let curve = self.mesh.local_curve(cell, e);
                let [from, to] = if against { [-load.part[1], -load.part[0]] } else { load.part };
                let mut sums = vec![[0.0; 2]; degree + 1];
                for (s, w) in rule.points.iter().zip(&rule.weights) {
                    let t = 0.5 * ((1.0 - s) * from + (1.0 + s) * to);
                    let (point, length) = boundary_point(&curve, t, e >= 2);
                    let value = (load.traction)(&point);
                    let measure = self.kinematics.measure(point.position[0]) / self.unit;
                    let weight = 0.5 * (to - from) * w * length * measure;
                    for (sum, shape) in sums.iter_mut().zip(shape_functions(degree, t).0) {
                        sum[0] += weight * shape * value[0];
                        sum[1] += weight * shape * value[1];
                    }
                }
                let components = self.space.components;
                for (mode, sum) in sums.iter().enumerate() {
                    let scalar = if mode < 2 { ends[mode] } else { modes.edge(e).start + mode - 2 };
                    let sign = if mode >= 2 && mode % 2 == 1 && against { -1.0 } else { 1.0 };
                    for (k, value) in sum.iter().enumerate().take(components) {
                        loads.push(((components * scalar + k, load.case), sign * value));
                    }
                }
            }
        }
        loads
    }
}
