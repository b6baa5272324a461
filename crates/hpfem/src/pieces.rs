//! Vertices, cells and what edges are besides straight, of a mesh that is being cut: its edges are numbered once, when it is done.

use std::collections::BTreeMap;

use crate::curve::Curve;
use crate::error::Error;
use crate::mesh::{CELL_EDGES, Mesh, Quad, blend};

/// An edge that is curved or has names.
struct Special {
    /// Its vertices in the direction of the curve.
    walk: [usize; 2],
    curve: Curve,
    /// Indices of its names.
    tags: Vec<usize>,
}

/// The cells of a mesh on their way to those of a finer one.
pub(crate) struct Pieces<'m> {
    vertices: Vec<[f64; 2]>,
    quads: Vec<Quad>,
    /// By the lower vertex and the higher one.
    special: BTreeMap<[usize; 2], Special>,
    names: &'m [String],
}

/// The vertices that cut edges, with the vertices of those in their direction and the ratios of the cuts.
type Cuts = Vec<([usize; 2], usize, f64)>;

impl<'m> Pieces<'m> {
    /// The cells of a mesh.
    pub(crate) fn of(mesh: &'m Mesh) -> Pieces<'m> {
        let quads = mesh.cells.iter().map(|c| Quad { corners: c.corners, material: c.material, layer: c.layer }).collect();
        let special = mesh.edges.iter().filter(|edge| !edge.curve.is_straight() || !edge.tags.is_empty());
        let special = special.map(|edge| {
            let own = Special { walk: edge.vertices, curve: edge.curve, tags: edge.tags.clone() };
            (key(edge.vertices), own)
        });
        Pieces { vertices: mesh.vertices.clone(), quads, special: special.collect(), names: &mesh.boundaries }
    }

    /// The mesh of the cells, whose names keep their order.
    pub(crate) fn joined(self) -> Result<Mesh, Error> {
        let curved = self.special.values().filter(|edge| !edge.curve.is_straight());
        let curves: Vec<([usize; 2], Curve)> = curved.map(|edge| (edge.walk, edge.curve)).collect();
        let tagged = |tag: usize| self.special.values().filter(move |edge| edge.tags.contains(&tag)).map(|edge| edge.walk);
        let names = self.names.iter().enumerate().flat_map(|(tag, name)| tagged(tag).map(|walk| (walk, name.as_str())));
        let names: Vec<([usize; 2], &str)> = names.collect();
        let mesh = Mesh::joined(self.vertices, &self.quads, &curves, &names)?;
        mesh.check_cells()?;
        Ok(mesh)
    }

    /// The curve of an edge in a direction.
    fn curve(&self, walk: [usize; 2]) -> Curve {
        match self.special.get(&key(walk)) {
            Some(edge) if edge.walk == walk => edge.curve,
            Some(edge) => edge.curve.reversed(),
            None => Curve::Line { start: self.vertices[walk[0]], end: self.vertices[walk[1]] },
        }
    }

    /// One cut of [`Mesh::refined_towards`], at a ratio for each edge, told by its vertices.
    pub(crate) fn cut(&mut self, singular: &[usize], ratio: &dyn Fn([usize; 2]) -> Result<f64, Error>) -> Result<(), Error> {
        let touched = |quad: &Quad| quad.corners.iter().position(|v| singular.contains(v));
        let mut cuts = Cuts::new();
        for quad in self.quads.iter().filter(|quad| touched(quad).is_some()) {
            let walks = CELL_EDGES.map(|ends| ends.map(|k| quad.corners[k]));
            for walk in walks.into_iter().filter(|[a, b]| a != b && (singular.contains(a) || singular.contains(b))) {
                if found(&cuts, walk).is_none() {
                    cuts.push((walk, self.vertices.len() + cuts.len(), ratio(walk)?));
                }
            }
        }
        // Their curves are whole before the edges are cut.
        let quads = std::mem::take(&mut self.quads);
        let centre = |quad: &Quad| touched(quad).and_then(|corner| self.centre(quad, corner, &cuts));
        let centres: Vec<Option<[f64; 2]>> = quads.iter().map(centre).collect();
        for (walk, v, ratio) in &cuts {
            self.cut_edge(*walk, *v, if singular.contains(&walk[0]) { 2.0 * ratio - 1.0 } else { 1.0 - 2.0 * ratio });
        }
        for (number, (quad, centre)) in quads.iter().zip(centres).enumerate() {
            let Some(corner) = touched(quad) else {
                self.quads.push(*quad);
                continue;
            };
            let folded = Error::FoldedCell { cell: number, jacobian: 0.0, x: 0.0, z: 0.0 };
            self.quads.extend(self.parts(quad, corner, &cuts).ok_or(folded)?);
            self.vertices.extend(centre);
        }
        Ok(())
    }

    /// Cuts an edge at a parameter by a new vertex, the next one.
    fn cut_edge(&mut self, walk: [usize; 2], v: usize, at: f64) {
        let curve = self.curve(walk);
        self.vertices.push(curve.point(at));
        let Some(old) = self.special.remove(&key(walk)) else { return };
        for (walk, part) in [([walk[0], v], [-1.0, at]), ([v, walk[1]], [at, 1.0])] {
            let [from, to] = part;
            self.special.insert(key(walk), Special { walk, curve: curve.part(from, to), tags: old.tags.clone() });
        }
    }

    /// Where a quadrilateral with a singular corner is cut inside; `None` for a triangle.
    fn centre(&self, cell: &Quad, corner: usize, cuts: &Cuts) -> Option<[f64; 2]> {
        let at = |i: usize| cell.corners[(corner + i) % 4];
        let [(_, r1), (_, r3)] = [found(cuts, [at(0), at(1)])?, found(cuts, [at(0), at(3)])?];
        let (near, next, far) = (REFERENCE[corner], REFERENCE[(corner + 1) % 4], REFERENCE[(corner + 2) % 4]);
        let ratio = |i: usize| if next[i] == near[i] { r3 } else { r1 };
        let place = std::array::from_fn(|i| (1.0 - ratio(i)) * near[i] + ratio(i) * far[i]);
        (!is_triangle(cell)).then(|| self.point_in(cell, place))
    }

    /// The parts of a cell with a singular corner, whose edges there are cut; the one inside a quadrilateral has the next vertex.
    fn parts(&self, cell: &Quad, corner: usize, cuts: &Cuts) -> Option<Vec<Quad>> {
        let quad = |corners, layer| Quad { corners, material: cell.material, layer };
        // Walk the corners from the singular one anti-clockwise.
        let sides = if is_triangle(cell) { 3 } else { 4 };
        let at = |i: usize| cell.corners[(corner + i) % sides];
        let [(m1, _), (m3, _)] = [found(cuts, [at(0), at(1)])?, found(cuts, [at(0), at(sides - 1)])?];
        if is_triangle(cell) {
            return Some(vec![quad([at(0), m1, m3, m3], cell.layer + 1), quad([m1, at(1), at(2), m3], cell.layer)]);
        }
        let centre = self.vertices.len();
        Some(vec![
            quad([at(0), m1, centre, m3], cell.layer + 1),
            quad([m1, at(1), at(2), centre], cell.layer),
            quad([m3, centre, at(2), at(3)], cell.layer),
        ])
    }

    /// The point of a quadrilateral at reference coordinates.
    fn point_in(&self, cell: &Quad, [xi, eta]: [f64; 2]) -> [f64; 2] {
        let edges = CELL_EDGES.map(|ends| self.curve(ends.map(|k| cell.corners[k])));
        let at = |e: usize, t: f64| (edges[e].point(t), edges[e].derivative(t));
        blend(&cell.corners.map(|v| self.vertices[v]), [at(0, xi), at(1, eta), at(2, xi), at(3, eta)], xi, eta).0
    }
}

/// Reference coordinates of the corners.
const REFERENCE: [[f64; 2]; 4] = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];

/// Whether the last two corners are one.
fn is_triangle(cell: &Quad) -> bool {
    cell.corners[2] == cell.corners[3]
}

/// The vertices of an edge in order.
fn key([a, b]: [usize; 2]) -> [usize; 2] {
    [a.min(b), a.max(b)]
}

/// The vertex that cuts an edge, and its ratio.
fn found(cuts: &Cuts, [a, b]: [usize; 2]) -> Option<(usize, f64)> {
    cuts.iter().find(|(walk, ..)| *walk == [a, b] || *walk == [b, a]).map(|(_, v, ratio)| (*v, *ratio))
}
