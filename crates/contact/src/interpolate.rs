//! Quantities between the contact points: on every edge the polynomial through its points.

use crate::maximum::maximum;
use crate::operator::ContactOperator;
use crate::pair::Pair;
use crate::point::ContactPoint;
use hpfem::{barycentric_weights, lagrange};
use std::ops::RangeInclusive;

impl Pair<'_> {
    /// The contact points on an edge of [`Pair::trace`], both ends included. On the last edge of a closed boundary the range ends with the number of points, which
    /// stands for point 0 there.
    ///
    /// # Panics
    /// For an edge that the boundary does not have.
    pub fn edge_points(&self, edge: usize) -> RangeInclusive<usize> {
        let edges = &self.trace().edges;
        let first: usize = edges[..edge].iter().map(|e| e.degree).sum();
        first..=first + edges[edge].degree
    }

    /// The length of a closed boundary, at which point 0 is met again; none of an open one.
    pub(crate) fn turn(&self) -> Option<f64> {
        self.trace().closed.then(|| self.trace().length())
    }

    /// Value at arc length `arc` (that of the nearest end beyond the boundary) of a quantity given at the points [`Pair::points`]: a polynomial of each edge's
    /// parameter.
    ///
    /// # Panics
    /// For fewer points or values than the contact has.
    pub fn value_at(&self, points: &[ContactPoint], values: &[f64], arc: f64) -> f64 {
        let (range, shapes) = self.shapes_at(points, arc);
        shapes.iter().zip(range).map(|(l, i)| l * values[i % points.len()]).sum()
    }

    /// The points that have a say in [`Pair::value_at`], as by [`Pair::edge_points`], and the weight of each.
    ///
    /// # Panics
    /// For fewer points than the contact has.
    pub fn shapes_at(&self, points: &[ContactPoint], arc: f64) -> (RangeInclusive<usize>, Vec<f64>) {
        let (edge, t) = self.trace().locate(arc);
        let range = self.edge_points(edge);
        let start = *range.start();
        let node = |i: usize| points.get(i).map_or(1.0, |point| point.place.1);
        let nodes: Vec<f64> = range.clone().map(|i| if i == start { -1.0 } else { node(i) }).collect();
        let shapes = lagrange(&nodes, &barycentric_weights(&nodes), t.clamp(-1.0, 1.0));
        (range, shapes)
    }

    /// Value at arc length `arc` of a quantity that vanishes where the surfaces are apart: [`Pair::value_at`], or [`piecewise_linear`] on an edge with
    /// a point of no value, where the polynomial would change its sign beside the end of contact.
    ///
    /// # Panics
    /// For fewer points or values than the contact has.
    pub fn closed_value_at(&self, points: &[ContactPoint], values: &[f64], arc: f64) -> f64 {
        let (edge, _) = self.trace().locate(arc);
        let own = || self.edge_points(edge).map(|i| values[i % points.len()]);
        if own().any(|value| value == 0.0) {
            let place = |i: usize| points.get(i).map_or(self.trace().length(), |point| point.arc);
            let arcs: Vec<f64> = self.edge_points(edge).map(place).collect();
            return piecewise_linear(&arcs, &own().collect::<Vec<f64>>(), arc);
        }
        self.value_at(points, values, arc)
    }
}

impl ContactOperator<'_> {
    /// The contact points on an edge, see [`Pair::edge_points`].
    ///
    /// # Panics
    /// For an edge that the boundary does not have.
    pub fn edge_points(&self, edge: usize) -> RangeInclusive<usize> {
        self.pair.edge_points(edge)
    }

    /// Value at arc length `arc` of a quantity given at the contact points: pressure and shear are these polynomials of the arc length's edge
    /// parameter, everything else is interpolated by them.
    ///
    /// # Panics
    /// For fewer values than contact points.
    pub fn value_at(&self, values: &[f64], arc: f64) -> f64 {
        self.pair.value_at(&self.unit.points, values, arc)
    }

    /// Pressure at arc length `arc` of one given at the contact points, see [`Pair::closed_value_at`].
    ///
    /// # Panics
    /// For fewer values than contact points.
    pub fn pressure_at(&self, pressure: &[f64], arc: f64) -> f64 {
        self.pair.closed_value_at(&self.unit.points, pressure, arc)
    }

    /// Largest value of a quantity at the contact points that vanishes where the surfaces are apart, in its unit: the pressure, or the size of the shear. It
    /// is that of the polynomials of [`ContactOperator::pressure_at`], between the neighbours of the point with the largest value.
    ///
    /// # Panics
    /// For fewer values than contact points.
    pub fn maximum(&self, values: &[f64]) -> f64 {
        let arcs: Vec<f64> = self.unit.points.iter().map(|point| point.arc).collect();
        let Some(length) = self.pair.turn() else {
            return maximum(&arcs, values, &|arc| self.pressure_at(values, arc))[1];
        };
        // Around a closed boundary every point lies between two: the walk begins opposite the largest value.
        let n = arcs.len();
        let most = (0..n).max_by(|a, b| values[*a].total_cmp(&values[*b])).unwrap_or(0);
        let around = || (most + n / 2..most + n / 2 + n).map(|i| (i % n, (i / n) as f64));
        let places: Vec<f64> = around().map(|(i, turns)| arcs[i] + turns * length).collect();
        let values_around: Vec<f64> = around().map(|(i, _)| values[i]).collect();
        maximum(&places, &values_around, &|arc| self.pressure_at(values, arc % length))[1]
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
