//! Force and moment of a load on an edge, by its curves: what turns a body about a pin.

use hpfem::{Curve, gauss};
use scene::LoadKind;

use crate::couple::{Body, Couple};
use crate::gmsh_file::circle;
use crate::outline::outline;

/// Points of the quadrature along a curve.
const POINTS: usize = 24;

/// A load of 1 N.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct UnitLoad {
    /// Force along x and z.
    pub force: [f64; 2],
    /// Moment about the origin, anti-clockwise (mm).
    pub moment: f64,
    /// Pressure or traction, force per area of a body 1 mm thick (1/mm); of a vertical load per projected length.
    pub intensity: f64,
}

impl UnitLoad {
    /// Moment about a point, anti-clockwise (mm).
    pub fn moment_about(&self, [x, z]: [f64; 2]) -> f64 {
        self.moment - (x * self.force[1] - z * self.force[0])
    }
}

/// Sums along an edge: its length, that of its projection, and the moments of both; the vector between its ends turned outwards.
#[derive(Default)]
struct Sums {
    length: f64,
    first: [f64; 2],
    projected: f64,
    first_projected: f64,
    normal: [f64; 2],
    /// int (x n_z - z n_x) ds.
    turning: f64,
}

impl Couple {
    /// A load of 1 N on the plane body 1, whichever way it acts; none of a load without a resultant: a pressure all around a hole, a vertical one on an
    /// upright edge, a rigid edge.
    pub fn unit_load(&self) -> Option<UnitLoad> {
        let load = &self.load;
        let sums = sums(&self.bodies[0], &load.edge);
        let size = sums.length;
        match load.kind {
            LoadKind::Rigid => None,
            LoadKind::Pressure => {
                let [x, z] = sums.normal;
                let whole = x.hypot(z);
                let intensity = 1.0 / whole;
                let force = [-x * intensity, -z * intensity];
                (whole > 1e-9 * size).then_some(UnitLoad { force, moment: -sums.turning * intensity, intensity })
            }
            LoadKind::Vertical => {
                let middle = load.strip.map_or(sums.first_projected / sums.projected, |strip| strip.centre);
                let width = load.strip.map_or(sums.projected, |strip| strip.width);
                (sums.projected > 1e-9 * size).then_some(UnitLoad { force: [0.0, -1.0], moment: -middle, intensity: 1.0 / width })
            }
            LoadKind::Traction => {
                let [dx, dz] = [load.direction.cos(), load.direction.sin()];
                let [x, z] = sums.first.map(|first| first / size);
                (size > 0.0).then_some(UnitLoad { force: [dx, dz], moment: x * dz - z * dx, intensity: 1.0 / size })
            }
        }
    }
}

fn sums(body: &Body, edge: &str) -> Sums {
    let mut sums = Sums::default();
    let rule = gauss(POINTS);
    for curve in outwards(body, edge) {
        for (t, w) in rule.points.iter().zip(&rule.weights) {
            let (x, d) = (curve.point(*t), curve.derivative(*t));
            let ds = w * d[0].hypot(d[1]);
            sums.length += ds;
            sums.first = [sums.first[0] + ds * x[0], sums.first[1] + ds * x[1]];
            sums.projected += w * d[0].abs();
            sums.first_projected += w * d[0].abs() * x[0];
            // The body lies on the left.
            let n = [w * d[1], -w * d[0]];
            sums.normal = [sums.normal[0] + n[0], sums.normal[1] + n[1]];
            sums.turning += x[0] * n[1] - x[1] * n[0];
        }
    }
    sums
}

/// The curves of an edge with the body on their left.
fn outwards(body: &Body, edge: &str) -> Vec<Curve> {
    let Some(mesh) = &body.cells else { return of_template(body, edge).into_iter().collect() };
    let neighbours = mesh.edge_cells();
    let edges = mesh.boundary(edge).unwrap_or_default().into_iter();
    let directed = |e: usize| {
        let (cell, local) = neighbours[e][0];
        let curve = mesh.edges[e].curve;
        // Local edges 0 and 1 have the cell on their left.
        if (local < 2) != mesh.cells[cell].against[local] { curve } else { curve.reversed() }
    };
    edges.map(directed).collect()
}

/// The one curve of an edge of a template, which bulges and faces away from the middle of its outline.
fn of_template(body: &Body, edge: &str) -> Option<Curve> {
    let outline = outline(body);
    let points = outline.points(edge);
    let (start, end) = (*points.first()?, *points.last()?);
    let curve = match points[..] {
        [_, middle, _] => match circle(&points) {
            Some((centre, radius)) => {
                let angle = |p: [f64; 2]| (p[1] - centre[1]).atan2(p[0] - centre[0]);
                let from = angle(start);
                let turned = |p: [f64; 2]| (angle(p) - from).rem_euclid(std::f64::consts::TAU);
                let sweep = if turned(middle) <= turned(end) { turned(end) } else { turned(end) - std::f64::consts::TAU };
                Curve::Arc { centre, radius, from, to: from + sweep }
            }
            None => Curve::Line { start, end },
        },
        _ => Curve::Line { start, end },
    };
    let all: Vec<[f64; 2]> = outline.edges.iter().flat_map(|edge| edge.points.iter().copied()).collect();
    let middle: [f64; 2] = std::array::from_fn(|k| all.iter().map(|p| p[k]).sum::<f64>() / all.len() as f64);
    let (x, d) = (curve.point(0.0), curve.derivative(0.0));
    let left = d[0] * (middle[1] - x[1]) - d[1] * (middle[0] - x[0]) > 0.0;
    Some(if left { curve } else { curve.reversed() })
}
