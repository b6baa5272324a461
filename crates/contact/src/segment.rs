//! Where the forces of the contact points act: at the points themselves, or at Gauss points of the segments between the break points of both
//! boundaries.
//!
//! With nodal forces `f_j` the pressure is `p = sum_j f_j / W_j phi_j`, `phi_j` the polynomial of the edge that is 1 at point `j`, and
//! `W_j = int phi_j dA`. Its work on a displacement `v` of either body is `int p n . v dA`, summed over the same Gauss points `g` for both:
//! point `j` gives the share `w_g phi_j(g) / W_j` of its force to `g`. The opening at a point is the mean of the opening at the `g`, weighted
//! alike, so that the compliance stays symmetric (Bernardi, Maday and Patera 1994; for contact McDevitt and Laursen 2000).

use crate::facing::{breaks_on, crossing};
use crate::pair::Pair;
use crate::point::ContactPoint;
use crate::side::Side;
use hpfem::{barycentric_weights, gauss, lagrange};

/// A place of both surfaces at which contact forces act.
#[derive(Clone, Debug)]
pub(crate) struct Station {
    /// Place, normal and tangent.
    pub(crate) point: ContactPoint,
    /// The place on body 1 and body 2.
    pub(crate) places: [(usize, f64); 2],
    /// Contact points and the shares of their forces; the shares of a point sum to 1.
    pub(crate) shares: Vec<(usize, f64)>,
}

impl Station {
    /// Force on body 1 of nodal normal and tangential forces.
    pub(crate) fn force(&self, normal: &[f64], tangential: &[f64]) -> [f64; 2] {
        let part = |forces: &[f64]| self.shares.iter().map(|(j, share)| share * forces[*j]).sum::<f64>();
        let (p, q) = (part(normal), part(tangential));
        [0, 1].map(|k| p * self.point.normal[k] + q * self.point.tangent[k])
    }
}

/// Gauss points of a segment beyond those that a straight edge needs.
const EXTRA: usize = 4;

impl Pair<'_> {
    /// The contact points with their weights, and the stations where their forces act.
    pub(crate) fn stations(&self) -> (Vec<ContactPoint>, Vec<Station>) {
        let points = self.points();
        if !self.is_nodal() {
            return self.segments(points);
        }
        let station = |(j, point): (usize, &ContactPoint)| {
            let places = [Side::Shaped, Side::Counter].map(|side| self.place(side, point));
            Station { point: *point, places, shares: vec![(j, 1.0)] }
        };
        let stations = points.iter().enumerate().map(station).collect();
        (points, stations)
    }

    /// Pieces of the surface between the break points of both boundaries: ranges of arc length, and the higher of the two degrees.
    /// Displacements are smooth on each.
    pub fn pieces(&self) -> Vec<([f64; 2], usize)> {
        let (side, body) = self.surface();
        let other = self.side(side.other()).map(|body| &body.trace);
        let mut pieces = Vec::new();
        for (number, edge) in body.trace.edges.iter().enumerate() {
            let breaks = match other {
                Some(other) if !self.is_nodal() => breaks_on(number, &body.trace, other),
                _ => vec![-1.0, 1.0],
            };
            for ends in breaks.windows(2) {
                let middle = self.point((number, 0.5 * (ends[0] + ends[1])), 0.0, 0.0);
                let degree = other.map_or(0, |other| other.edges[self.place(side.other(), &middle).0].degree);
                let range = [ends[0], ends[1]].map(|t| edge.start + edge.curve.length_until(t));
                pieces.push((range, degree.max(edge.degree)));
            }
        }
        pieces
    }

    /// Gauss points of all segments; weights of the points become integrals of their polynomials.
    pub(crate) fn segments(&self, mut points: Vec<ContactPoint>) -> (Vec<ContactPoint>, Vec<Station>) {
        let (side, body) = self.surface();
        let Some(other) = self.side(side.other()) else { return (points, Vec::new()) };
        let trace = &body.trace;
        let mut stations: Vec<Station> = Vec::new();
        points.iter_mut().for_each(|p| p.weight = 0.0);
        let mut first = 0;
        for (number, edge) in trace.edges.iter().enumerate() {
            let nodes: Vec<f64> = (0..=edge.degree)
                .map(|k| if k == 0 { -1.0 } else { trace.points.get(first + k).map_or(1.0, |p| p.parameter) })
                .collect();
            let barycentric = barycentric_weights(&nodes);
            for ends in breaks_on(number, trace, &other.trace).windows(2) {
                let (middle, half) = (0.5 * (ends[0] + ends[1]), 0.5 * (ends[1] - ends[0]));
                let facing = crossing(&other.trace, &self.point((number, middle), 0.0, 0.0));
                let degree = facing.map_or(edge.degree, |((e, _), _)| other.trace.edges[e].degree);
                // Degree of p n . v, and one for the radius.
                let rule = gauss((edge.degree + degree + 3).div_ceil(2) + EXTRA);
                for (t, w) in rule.points.iter().zip(&rule.weights) {
                    let t = middle + half * t;
                    let (boundary, length) = trace.boundary_point(number, t);
                    let area = w * half * length * body.kinematics.measure(boundary.position[0]);
                    let point = self.point((number, t), edge.start + edge.curve.length_until(t), area);
                    let there = self.place(side.other(), &point);
                    let places = if side == Side::Shaped { [point.place, there] } else { [there, point.place] };
                    let shapes = lagrange(&nodes, &barycentric, t);
                    let shares: Vec<(usize, f64)> =
                        shapes.iter().enumerate().map(|(k, phi)| ((first + k) % points.len(), area * phi)).collect();
                    shares.iter().for_each(|(j, share)| points[*j].weight += share);
                    stations.push(Station { point, places, shares });
                }
            }
            first += edge.degree;
        }
        for station in &mut stations {
            station.shares.iter_mut().for_each(|(j, share)| *share /= points[*j].weight);
        }
        (points, stations)
    }
}
