//! Exact outlines for boundaries that a mesh file gives as polynomials.

use crate::curve::Curve;
use crate::error::Error;
use crate::mesh::{Mesh, distance};
use std::f64::consts::{PI, TAU};

/// What the edges of a boundary lie on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Outline {
    /// A circle.
    Circle {
        /// Its centre, mm.
        centre: [f64; 2],
        /// Its radius, mm, positive.
        radius: f64,
    },
    /// A straight line.
    Line {
        /// Two different points of it, mm.
        points: [[f64; 2]; 2],
    },
}

impl Mesh {
    /// The mesh with the edges of a boundary replaced by exact pieces of a circle or a line, its vertices moved onto it; a round hole
    /// from a gmsh file, whose polynomial edges would limit the accuracy, becomes a circle. Edges of order 1 become arcs too. The
    /// insides of the cells and the other edges at moved vertices follow. Numbers, names, materials and layers stay.
    ///
    /// So that a wrong radius is not taken for round-off, a vertex may lie off the outline by a hundredth of the sagitta of its shortest edge
    /// of the boundary, or a millionth of the length of that edge, whichever is larger; and the middle of an edge by 1.1 times the
    /// sagitta, which is where a straight edge has it.
    ///
    /// # Errors
    /// [`Error::NoSuchBoundary`]; [`Error::OffOutline`] with the vertex and its distance; [`Error::EdgeOffOutline`] for an edge that runs
    /// elsewhere between its vertices; [`Error::OutOfRange`] for an outline that is none; [`Error::FoldedCell`] if a cell folds.
    pub fn with_outline(&self, boundary: &str, outline: Outline) -> Result<Mesh, Error> {
        outline.check()?;
        let edges = self.boundary(boundary)?;
        let mut allowed: Vec<Option<f64>> = vec![None; self.vertices.len()];
        for e in &edges {
            let [a, b] = self.edges[*e].vertices;
            let chord = distance(self.vertices[a], self.vertices[b]);
            let own = (0.01 * outline.sagitta(&self.edges[*e].curve)).max(1e-6 * chord);
            [a, b].iter().for_each(|v| allowed[*v] = Some(allowed[*v].unwrap_or(own).min(own)));
        }
        let mut mesh = self.clone();
        for (vertex, allowed) in allowed.iter().enumerate() {
            let Some(allowed) = *allowed else { continue };
            let distance = outline.distance(self.vertices[vertex]);
            if distance.is_nan() || distance > allowed {
                return Err(Error::OffOutline { boundary: boundary.to_string(), vertex, distance, allowed });
            }
            mesh.vertices[vertex] = outline.nearest(self.vertices[vertex]);
        }
        for (e, edge) in mesh.edges.iter_mut().enumerate() {
            let [a, b] = edge.vertices;
            let ends = [a, b].map(|v| mesh.vertices[v]);
            if edges.binary_search(&e).is_err() {
                if ends.iter().zip([a, b]).any(|(end, v)| *end != self.vertices[v]) {
                    edge.curve = edge.curve.with_ends(ends[0], ends[1]);
                }
                continue;
            }
            let distance = outline.distance(edge.curve.point(0.0));
            let allowed = 1.1 * outline.sagitta(&edge.curve) + 1e-3 * edge.curve.length();
            let piece = outline.piece(ends, edge.curve.point(0.0)).filter(|_| distance <= allowed);
            let refused = || Error::EdgeOffOutline { boundary: boundary.to_string(), a, b, distance, allowed };
            edge.curve = piece.ok_or_else(refused)?;
        }
        mesh.check_cells()?;
        Ok(mesh)
    }
}

impl Outline {
    /// Refuses circles without radius and lines without direction.
    fn check(&self) -> Result<(), Error> {
        let refused = |quantity: &str, value: f64| {
            Err(Error::OutOfRange { quantity: quantity.into(), value, range: "positive and finite, as its coordinates" })
        };
        if let Outline::Circle { centre, .. } = *self
            && let Some(value) = centre.into_iter().find(|x| !x.is_finite())
        {
            return Err(Error::OutOfRange { quantity: "the centre of an outline".into(), value, range: "finite" });
        }
        let (quantity, size, numbers) = match *self {
            Outline::Circle { centre, radius } => ("the radius of an outline", radius, [centre, centre]),
            Outline::Line { points } => ("the distance of the points of an outline", distance(points[0], points[1]), points),
        };
        let sound = size > 0.0 && size.is_finite() && numbers.iter().flatten().all(|x| x.is_finite());
        if sound { Ok(()) } else { refused(quantity, size) }
    }

    /// The point of the outline nearest to another one.
    fn nearest(&self, x: [f64; 2]) -> [f64; 2] {
        match *self {
            Outline::Circle { centre, radius } => {
                let share = radius / distance(x, centre);
                // What is there already stays, to the bit.
                if (share - 1.0).abs() <= 4.0 * f64::EPSILON { x } else { [0, 1].map(|i| centre[i] + share * (x[i] - centre[i])) }
            }
            Outline::Line { points: [a, b] } => {
                let d = [b[0] - a[0], b[1] - a[1]];
                let along = (d[0] * (x[0] - a[0]) + d[1] * (x[1] - a[1])) / (d[0] * d[0] + d[1] * d[1]);
                [0, 1].map(|i| a[i] + along * d[i])
            }
        }
    }

    fn distance(&self, x: [f64; 2]) -> f64 {
        match *self {
            Outline::Circle { centre, radius } => (distance(x, centre) - radius).abs(),
            Outline::Line { .. } => distance(x, self.nearest(x)),
        }
    }

    /// The angle that an edge opens at the centre of the circle, through its middle, with its sense; none if the middle lies at the centre.
    fn opening(centre: [f64; 2], [start, end]: [[f64; 2]; 2], middle: [f64; 2]) -> Option<(f64, f64)> {
        let angle = |x: [f64; 2]| (x[1] - centre[1]).atan2(x[0] - centre[0]);
        let turn = |a: f64, b: f64| (b - a + PI).rem_euclid(TAU) - PI;
        let (from, by) = (angle(start), angle(middle));
        let (before, after) = (turn(from, by), turn(by, angle(end)));
        let clear = distance(middle, centre) > 1e-6 * distance(start, centre) && before * after > 0.0;
        clear.then_some((from, before + after))
    }

    /// Height of the piece of the outline above the chord of an edge, mm.
    fn sagitta(&self, edge: &Curve) -> f64 {
        match *self {
            Outline::Circle { centre, radius } => {
                let opening = Outline::opening(centre, [edge.point(-1.0), edge.point(1.0)], edge.point(0.0));
                opening.map_or(0.0, |(_, angle)| radius * (1.0 - (0.5 * angle).cos()))
            }
            Outline::Line { .. } => 0.0,
        }
    }

    /// The piece of the outline between two points of it, on the side of a third one.
    fn piece(&self, ends: [[f64; 2]; 2], middle: [f64; 2]) -> Option<Curve> {
        match *self {
            Outline::Circle { centre, radius } => {
                let (from, angle) = Outline::opening(centre, ends, middle)?;
                Some(Curve::Arc { centre, radius, from, to: from + angle })
            }
            Outline::Line { .. } => Some(Curve::Line { start: ends[0], end: ends[1] }),
        }
    }
}
