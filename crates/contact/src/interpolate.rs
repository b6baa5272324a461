//! Quantities between the contact points: on every edge the polynomial through its points.

use crate::operator::ContactOperator;
use hpfem::{barycentric_weights, lagrange};
use std::ops::RangeInclusive;

impl ContactOperator<'_> {
    /// The contact points on an edge of [`Pair::trace`](crate::Pair::trace), both ends included.
    pub fn edge_points(&self, edge: usize) -> RangeInclusive<usize> {
        let edges = &self.pair.trace().edges;
        let first: usize = edges[..edge].iter().map(|e| e.degree).sum();
        first..=first + edges[edge].degree
    }

    /// Value at arc length `arc` of a quantity given at the contact points: pressure and shear are these polynomials of the arc length's edge
    /// parameter, everything else is interpolated by them.
    pub fn value_at(&self, values: &[f64], arc: f64) -> f64 {
        let (edge, t) = self.pair.trace().locate(arc);
        let range = self.edge_points(edge);
        let start = *range.start();
        let nodes: Vec<f64> = range.clone().map(|i| if i == start { -1.0 } else { self.unit.points[i].place.1 }).collect();
        let shapes = lagrange(&nodes, &barycentric_weights(&nodes), t.clamp(-1.0, 1.0));
        shapes.iter().zip(&values[range]).map(|(l, v)| l * v).sum()
    }
}
