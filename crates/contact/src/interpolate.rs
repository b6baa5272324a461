//! Quantities between the contact points: on every edge the polynomial through its points.

use crate::maximum::maximum;
use crate::operator::ContactOperator;
use crate::pair::Pair;
use crate::point::ContactPoint;
use hpfem::{barycentric_weights, lagrange};
use std::ops::RangeInclusive;

impl Pair<'_> {
    /// The contact points on an edge of [`Pair::trace`], both ends included.
    pub fn edge_points(&self, edge: usize) -> RangeInclusive<usize> {
        let edges = &self.trace().edges;
        let first: usize = edges[..edge].iter().map(|e| e.degree).sum();
        first..=first + edges[edge].degree
    }

    /// Value at arc length `arc` of a quantity given at the points [`Pair::points`]: a polynomial of each edge's parameter.
    pub fn value_at(&self, points: &[ContactPoint], values: &[f64], arc: f64) -> f64 {
        let (range, shapes) = self.shapes_at(points, arc);
        shapes.iter().zip(&values[range]).map(|(l, v)| l * v).sum()
    }

    /// The points that have a say in [`Pair::value_at`], and the weight of each.
    pub fn shapes_at(&self, points: &[ContactPoint], arc: f64) -> (RangeInclusive<usize>, Vec<f64>) {
        let (edge, t) = self.trace().locate(arc);
        let range = self.edge_points(edge);
        let start = *range.start();
        let nodes: Vec<f64> = range.clone().map(|i| if i == start { -1.0 } else { points[i].place.1 }).collect();
        let shapes = lagrange(&nodes, &barycentric_weights(&nodes), t.clamp(-1.0, 1.0));
        (range, shapes)
    }

    /// Value at arc length `arc` of a quantity that vanishes where the surfaces are apart: [`Pair::value_at`], or [`piecewise_linear`] on an edge with
    /// a point of no value, where the polynomial would change its sign beside the end of contact.
    pub fn closed_value_at(&self, points: &[ContactPoint], values: &[f64], arc: f64) -> f64 {
        let (edge, _) = self.trace().locate(arc);
        let range = self.edge_points(edge);
        if values[range.clone()].contains(&0.0) {
            let arcs: Vec<f64> = points[range.clone()].iter().map(|p| p.arc).collect();
            return piecewise_linear(&arcs, &values[range], arc);
        }
        self.value_at(points, values, arc)
    }
}

impl ContactOperator<'_> {
    /// The contact points on an edge of [`Pair::trace`], both ends included.
    pub fn edge_points(&self, edge: usize) -> RangeInclusive<usize> {
        self.pair.edge_points(edge)
    }

    /// Value at arc length `arc` of a quantity given at the contact points: pressure and shear are these polynomials of the arc length's edge
    /// parameter, everything else is interpolated by them.
    pub fn value_at(&self, values: &[f64], arc: f64) -> f64 {
        self.pair.value_at(&self.unit.points, values, arc)
    }

    /// Pressure at arc length `arc` of one given at the contact points, see [`Pair::closed_value_at`].
    pub fn pressure_at(&self, pressure: &[f64], arc: f64) -> f64 {
        self.pair.closed_value_at(&self.unit.points, pressure, arc)
    }

    /// Largest value of a quantity at the contact points that vanishes where the surfaces are apart, in its unit: the pressure, or the size of the shear. It
    /// is that of the polynomials of [`ContactOperator::pressure_at`], between the neighbours of the point with the largest value.
    pub fn maximum(&self, values: &[f64]) -> f64 {
        let arcs: Vec<f64> = self.unit.points.iter().map(|point| point.arc).collect();
        maximum(&arcs, values, &|arc| self.pressure_at(values, arc))[1]
    }
}

/// Straight lines between values at ascending places; the nearest value outside them, nan without any. What one list has more than the other does
/// not count.
pub fn piecewise_linear(places: &[f64], values: &[f64], at: f64) -> f64 {
    let count = places.len().min(values.len());
    let (places, values) = (&places[..count], &values[..count]);
    if count < 2 {
        return values.first().copied().unwrap_or(f64::NAN);
    }
    let after = places.partition_point(|p| *p < at).clamp(1, places.len() - 1);
    let (a, b) = (places[after - 1], places[after]);
    let t = ((at - a) / (b - a)).clamp(0.0, 1.0);
    (1.0 - t) * values[after - 1] + t * values[after]
}

#[cfg(test)]
mod tests {
    use super::piecewise_linear;

    #[test]
    fn straight_lines_meet_the_values_and_go_on_level() {
        let (places, values) = ([-1.0, 0.0, 4.0], [2.0, 6.0, 4.0]);
        for (at, value) in [(-9.0, 2.0), (-1.0, 2.0), (-0.5, 4.0), (0.0, 6.0), (1.0, 5.5), (4.0, 4.0), (5.0, 4.0)] {
            assert_eq!(piecewise_linear(&places, &values, at), value);
        }
    }
}
