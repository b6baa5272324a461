//! Tractions as loads on the unknowns of cells.

use crate::assembly::Assembly;
use crate::basis::{BoundaryModes, points_for};
use crate::boundary::boundary_point;
use crate::legendre::shape_values;
use crate::mesh::CELL_EDGES;
use crate::quadrature::gauss;

impl Assembly<'_> {
    /// Consistent loads of the cell's loaded edges: `((local boundary unknown, column), value)`.
    pub(crate) fn cell_loads(&self, cell: usize, modes: &BoundaryModes) -> Vec<((usize, usize), f64)> {
        let mut loads = Vec::new();
        for (e, edge) in self.mesh.cells[cell].sides() {
            // Edge 3 of a triangle ends at corner 2, which is corner 3 too.
            let ends = CELL_EDGES[e].map(|k| k.min(modes.corners - 1));
            let against = self.mesh.cells[cell].against[e];
            for load in self.loads.edges[edge].iter().filter(|load| load.owner == cell) {
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
                    for (sum, shape) in sums.iter_mut().zip(shape_values(degree, t)) {
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
