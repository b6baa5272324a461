//! Meshes of a changed body: a vertex moved along the boundary, for the end of a contact that is itself unknown; all points moved by
//! a map, for a profile laid on the body.

use crate::curve::{CURVE_DEGREE, Curve};
use crate::error::Error;
use crate::mesh::{Mesh, Quad, distance};

impl Mesh {
    /// The mesh with every point moved by a smooth one-to-one map: a machined or worn profile laid on the body. Each edge becomes the
    /// polynomial of degree 8 through the images of its Gauss-Lobatto points, or stays a straight line; the insides of the cells follow
    /// by blending.
    ///
    /// # Errors
    /// [`Error::FoldedCell`] if a cell folds.
    pub fn mapped(&self, map: impl Fn([f64; 2]) -> [f64; 2]) -> Result<Mesh, Error> {
        let mut mesh = self.clone();
        mesh.vertices = self.vertices.iter().map(|x| map(*x)).collect();
        for (image, edge) in mesh.edges.iter_mut().zip(&self.edges) {
            let [start, end] = edge.vertices.map(|v| mesh.vertices[v]);
            let curve = Curve::interpolated(CURVE_DEGREE, |t| match t {
                -1.0 => start,
                1.0 => end,
                _ => map(edge.curve.point(t)),
            });
            let line = Curve::Line { start, end };
            let on_line = |t: &f64| distance(curve.point(*t), line.point(*t)) <= 1e-14 * line.length();
            // A map that is no number somewhere is on no line.
            image.curve = if [-0.6, -0.2, 0.2, 0.6].iter().all(on_line) { line } else { curve };
        }
        mesh.check_cells()?;
        Ok(mesh)
    }

    /// The mesh with a boundary vertex moved by the arc length `shift` (mm) along the boundary, positive towards the end with the larger
    /// coordinates (first coordinate first), as a contact path runs. The shape of the body stays exactly as it is: the
    /// two boundary edges at the vertex must be parts of one line or of one circle, or the shift must be zero; inner edges at the
    /// vertex must be straight and stay so. All other vertices stay.
    ///
    /// Move vertices on the coarse mesh and refine towards them afterwards: then the layers travel with the vertex.
    ///
    /// # Errors
    /// [`Error::Immovable`] if the vertex is inside or at a corner, or the shift reaches a neighbouring vertex;
    /// [`Error::FoldedCell`] if a cell would fold.
    pub fn with_vertex_moved(&self, vertex: usize, shift: f64) -> Result<Mesh, Error> {
        let immovable = |reason: &'static str| Error::Immovable { vertex, shift, reason };
        if vertex >= self.vertices.len() || !shift.is_finite() {
            return Err(immovable("there is no such vertex, or the shift is no number"));
        }
        let sides = self.edge_cells();
        let outer: Vec<usize> =
            (0..self.edges.len()).filter(|e| sides[*e].len() == 1 && self.edges[*e].vertices.contains(&vertex)).collect();
        let [e, f] = outer[..] else {
            return Err(immovable("it does not lie between two boundary edges"));
        };
        // Both curves walked through the vertex: the first ends there, the second starts there, towards larger coordinates.
        let far = |e: usize| self.edges[e].vertices[usize::from(self.edges[e].vertices[0] == vertex)];
        let key = |v: usize| (self.vertices[v][0], self.vertices[v][1]);
        let (e, f) = if key(far(e)) <= key(far(f)) { (e, f) } else { (f, e) };
        let towards = |e: usize, end: usize| {
            let edge = &self.edges[e];
            if edge.vertices[1] == end { edge.curve } else { edge.curve.reversed() }
        };
        let (before, after) = (towards(e, vertex), towards(f, far(f)));
        let whole = joined(&before, &after).ok_or_else(|| immovable("its boundary edges are not parts of one line or circle"))?;
        let (left, total) = (before.length(), whole.length());
        if !(shift > -left && shift < total - left) {
            return Err(immovable("the shift reaches the next vertex"));
        }
        let t = 2.0 * (left + shift) / total - 1.0;
        let mut vertices = self.vertices.clone();
        vertices[vertex] = whole.point(t);
        let mut curves = Vec::with_capacity(self.edges.len());
        let mut names = Vec::new();
        for (number, edge) in self.edges.iter().enumerate() {
            let curve = if number == e {
                ([far(e), vertex], whole.part(-1.0, t))
            } else if number == f {
                ([vertex, far(f)], whole.part(t, 1.0))
            } else if edge.vertices.contains(&vertex) {
                if !edge.curve.is_straight() {
                    return Err(immovable("a curved inner edge ends there"));
                }
                continue;
            } else {
                (edge.vertices, edge.curve)
            };
            curves.push(curve);
        }
        for edge in &self.edges {
            names.extend(edge.tags.iter().map(|t| (edge.vertices, self.boundaries[*t].as_str())));
        }
        let quads: Vec<Quad> =
            self.cells.iter().map(|c| Quad { corners: c.corners, material: c.material, layer: c.layer }).collect();
        let mesh = Mesh::joined(vertices, &quads, &curves, &names)?;
        mesh.check_cells()?;
        Ok(mesh)
    }
}

/// One line or arc made of two that follow each other.
fn joined(a: &Curve, b: &Curve) -> Option<Curve> {
    match (*a, *b) {
        (Curve::Line { start, end }, Curve::Line { end: last, .. }) => {
            let (d, e) = ([end[0] - start[0], end[1] - start[1]], [last[0] - end[0], last[1] - end[1]]);
            let straight = (d[0] * e[1] - d[1] * e[0]).abs() <= 1e-10 * a.length() * b.length();
            straight.then_some(Curve::Line { start, end: last })
        }
        (Curve::Arc { centre, radius, from, to }, Curve::Arc { centre: c, radius: r, from: f, to: t }) => {
            let same = distance(centre, c) <= 1e-10 * radius && (radius - r).abs() <= 1e-10 * radius;
            // The second angle may be a full turn off.
            (same && (to - from) * (t - f) > 0.0).then_some(Curve::Arc { centre, radius, from, to: to + (t - f) })
        }
        (Curve::Line { .. } | Curve::Arc { .. } | Curve::Polynomial { .. }, _) => None,
    }
}
