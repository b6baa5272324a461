//! Meshes of curved quadrilaterals and triangles.

use crate::curve::Curve;
use crate::error::Error;
use crate::triangle::{barycentric, triangle_map};

/// Ends of the four edges of a cell in its corner numbering, each walked towards growing reference coordinate:
/// edge 0 is `eta = -1`, edge 1 is `xi = 1`, edge 2 is `eta = 1`, edge 3 is `xi = -1`.
pub const CELL_EDGES: [[usize; 2]; 4] = [[0, 1], [1, 2], [3, 2], [0, 3]];

/// An edge between two vertices; its own direction is from the first to the second.
#[derive(Clone, Debug, PartialEq)]
pub struct Edge {
    /// The two vertices, indices into [`Mesh::vertices`].
    pub vertices: [usize; 2],
    /// The exact shape, `t = -1` at the first vertex.
    pub curve: Curve,
    /// Names of the boundaries this edge belongs to, as indices into [`Mesh::boundaries`].
    pub tags: Vec<usize>,
}

/// A quadrilateral or triangle with curved edges.
///
/// A quadrilateral is the blended image of `[-1, 1]^2`. A triangle has its last two corners at one vertex and no edge 2; reference
/// coordinates are those of the square too, whose side `eta = 1` is collapsed into corner 2.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cell {
    /// Corners, anti-clockwise, the images of (-1,-1), (1,-1), (1,1), (-1,1).
    pub corners: [usize; 4],
    /// Edges in the order of [`CELL_EDGES`]; the one between equal corners is `None`.
    pub edges: [Option<usize>; 4],
    /// Whether the edge's own direction is against the direction of [`CELL_EDGES`].
    pub against: [bool; 4],
    /// Index of the material.
    pub material: usize,
    /// Number of the geometric layer around a singular point this cell lies in; 0 outside all layers.
    pub layer: usize,
}

/// A conforming mesh of curved quadrilaterals and triangles with named boundaries. A mesh never changes; refinement makes a new one.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// Positions of the vertices, (x, z) or (r, z), mm.
    pub vertices: Vec<[f64; 2]>,
    /// All edges.
    pub edges: Vec<Edge>,
    /// All cells.
    pub cells: Vec<Cell>,
    /// Names that edges are tagged with.
    pub boundaries: Vec<String>,
}

/// A quadrilateral or triangle as given by the user of [`Mesh::new`]: corner vertices anti-clockwise and a material index.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quad {
    /// Corner vertices, anti-clockwise; a triangle repeats its last one, `[a, b, c, c]`.
    pub corners: [usize; 4],
    /// Index of the material.
    pub material: usize,
    /// Geometric layer, see [`Cell::layer`].
    pub layer: usize,
}

impl Cell {
    /// Whether the cell is a triangle.
    pub fn is_triangle(&self) -> bool {
        self.corners[2] == self.corners[3]
    }

    /// The three or four corners.
    pub fn vertices(&self) -> &[usize] {
        if self.is_triangle() { &self.corners[..3] } else { &self.corners }
    }

    /// The three or four edges as `(local edge, edge)`.
    pub fn sides(&self) -> impl Iterator<Item = (usize, usize)> {
        self.edges.into_iter().enumerate().filter_map(|(local, edge)| Some((local, edge?)))
    }

    /// Local edges that leave corner `k`: the one with the cell on its left, then the one with the cell on its right.
    pub(crate) fn leaving(&self, k: usize) -> [usize; 2] {
        [if self.is_triangle() && k == 2 { 3 } else { k }, (k + 3) % 4]
    }
}

impl Mesh {
    /// Builds a mesh from vertices, quads, the curves of those edges that are not straight, and the named edges.
    ///
    /// `curves` and `names` refer to edges by their two vertices in any order; a curve runs from the first vertex given.
    ///
    /// # Errors
    /// [`Error::NoCells`], [`Error::NoSuchEdge`], [`Error::CurveMissesVertex`], [`Error::FoldedCell`], [`Error::Overlapping`];
    /// [`Error::CellsOverlap`] if the middle of one cell lies inside another; [`Error::OutOfRange`] for numbers that are not finite,
    /// [`Error::Beyond`] for corners that do not exist.
    pub fn new(
        vertices: Vec<[f64; 2]>,
        quads: &[Quad],
        curves: &[([usize; 2], Curve)],
        names: &[([usize; 2], &str)],
    ) -> Result<Mesh, Error> {
        let mesh = Mesh::joined(vertices, quads, curves, names)?;
        mesh.check_cells()?;
        mesh.check_overlap()?;
        Ok(mesh)
    }

    /// [`Mesh::new`] before the cells are checked.
    pub(crate) fn joined(
        vertices: Vec<[f64; 2]>,
        quads: &[Quad],
        curves: &[([usize; 2], Curve)],
        names: &[([usize; 2], &str)],
    ) -> Result<Mesh, Error> {
        if quads.is_empty() {
            return Err(Error::NoCells);
        }
        check_vertices(&vertices, quads)?;
        let mut mesh = Mesh { vertices, ..Mesh::default() };
        mesh.edges.reserve(3 * quads.len());
        mesh.cells.reserve(quads.len());
        let mut index = EdgeIndex { first: vec![usize::MAX; mesh.vertices.len()], next: Vec::new() };
        let mut sides: Vec<[bool; 2]> = Vec::new();
        for quad in quads {
            let mut cell =
                Cell { corners: quad.corners, edges: [None; 4], against: [false; 4], material: quad.material, layer: quad.layer };
            for (local, ends) in CELL_EDGES.iter().enumerate() {
                let walk = [quad.corners[ends[0]], quad.corners[ends[1]]];
                if local == 2 && cell.is_triangle() {
                    continue;
                }
                let edge = index.find(&mesh.edges, walk).unwrap_or_else(|| {
                    let curve = Curve::Line { start: mesh.vertices[walk[0]], end: mesh.vertices[walk[1]] };
                    mesh.edges.push(Edge { vertices: walk, curve, tags: Vec::new() });
                    sides.push([false; 2]);
                    index.push(walk)
                });
                cell.edges[local] = Some(edge);
                cell.against[local] = mesh.edges[edge].vertices != walk;
                // Cells lie on the left of edges 0 and 1 and on the right of edges 2 and 3.
                if std::mem::replace(&mut sides[edge][usize::from((local < 2) != cell.against[local])], true) {
                    return Err(Error::Overlapping { a: walk[0], b: walk[1] });
                }
            }
            mesh.cells.push(cell);
        }
        for (walk, curve) in curves {
            let edge = index.find(&mesh.edges, *walk).ok_or(Error::NoSuchEdge { a: walk[0], b: walk[1] })?;
            mesh.bend(edge, if mesh.edges[edge].vertices == *walk { *curve } else { curve.reversed() })?;
        }
        for (walk, name) in names {
            let edge = index.find(&mesh.edges, *walk).ok_or(Error::NoSuchEdge { a: walk[0], b: walk[1] })?;
            let tag = mesh.boundaries.iter().position(|n| n == name).unwrap_or_else(|| {
                mesh.boundaries.push((*name).to_string());
                mesh.boundaries.len() - 1
            });
            if !mesh.edges[edge].tags.contains(&tag) {
                mesh.edges[edge].tags.push(tag);
            }
        }
        Ok(mesh)
    }

    /// Gives an edge its curve, which runs in the edge's own direction.
    fn bend(&mut self, edge: usize, curve: Curve) -> Result<(), Error> {
        let [a, b] = self.edges[edge].vertices;
        if let Curve::Arc { radius, .. } = curve
            && !(radius > 0.0 && radius.is_finite())
        {
            let quantity = format!("the radius of the arc given for the edge {a}-{b}");
            return Err(Error::OutOfRange { quantity, value: radius, range: "positive and finite" });
        }
        let miss = distance(curve.point(-1.0), self.vertices[a]).max(distance(curve.point(1.0), self.vertices[b]));
        // Deep layers are so small that the round-off of their coordinates counts.
        let circle = match &curve {
            Curve::Arc { centre, radius, .. } => radius + centre[0].abs().max(centre[1].abs()),
            Curve::Line { .. } | Curve::Polynomial { .. } => 0.0,
        };
        let size = self.vertices[a].iter().fold(circle, |m, x| m.max(x.abs()));
        let round_off = 64.0 * f64::EPSILON * size;
        // Lengths of polynomials take long.
        if miss.is_nan() || miss > round_off && miss > 1e-9 * curve.length() + round_off {
            return Err(Error::CurveMissesVertex { a, b, distance: miss });
        }
        self.edges[edge].curve = curve;
        Ok(())
    }

    /// Whether another mesh has the same cells in the same places, whatever their materials and boundaries are.
    pub(crate) fn has_cells_of(&self, other: &Mesh) -> bool {
        let alike = |(a, b): (&Edge, &Edge)| a.vertices == b.vertices && a.curve == b.curve;
        std::ptr::eq(self, other)
            || self.vertices == other.vertices
                && self.cells.iter().map(|cell| cell.corners).eq(other.cells.iter().map(|cell| cell.corners))
                && self.edges.iter().zip(&other.edges).all(alike)
    }

    /// Refuses folded cells.
    pub(crate) fn check_cells(&self) -> Result<(), Error> {
        (0..self.cells.len()).try_for_each(|cell| self.check_cell(cell))
    }

    /// The edges that carry the name.
    ///
    /// # Errors
    /// [`Error::NoSuchBoundary`].
    pub fn boundary(&self, name: &str) -> Result<Vec<usize>, Error> {
        let tag = self
            .boundaries
            .iter()
            .position(|n| n == name)
            .ok_or_else(|| Error::NoSuchBoundary { name: name.to_string(), known: names(&self.boundaries) })?;
        Ok((0..self.edges.len()).filter(|e| self.edges[*e].tags.contains(&tag)).collect())
    }

    /// For each edge the cells that share it, one or two, as `(cell, local edge)`.
    pub fn edge_cells(&self) -> Vec<Vec<(usize, usize)>> {
        let mut neighbours: Vec<Vec<(usize, usize)>> = self.edges.iter().map(|_| Vec::with_capacity(2)).collect();
        for (c, cell) in self.cells.iter().enumerate() {
            cell.sides().for_each(|(local, edge)| neighbours[edge].push((c, local)));
        }
        neighbours
    }

    /// The curve of a cell's local edge, 0 to 3, walked towards growing reference coordinate.
    ///
    /// # Panics
    /// For a cell that the mesh does not have, or a local edge beyond 3.
    pub fn local_curve(&self, cell: usize, local: usize) -> Curve {
        assert!(local < 4, "local edge {local} of a cell, which has 4, counted from 0");
        let cell = self.cell(cell);
        let Some(edge) = cell.edges[local] else {
            let x = self.vertices[cell.corners[2]];
            return Curve::Line { start: x, end: x };
        };
        let curve = &self.edges[edge].curve;
        if cell.against[local] { curve.reversed() } else { *curve }
    }

    /// A cell by its index, which must be one of the mesh.
    fn cell(&self, cell: usize) -> &Cell {
        assert!(cell < self.cells.len(), "cell {cell} of a mesh that has {}, counted from 0", self.cells.len());
        &self.cells[cell]
    }

    /// Transfinite (blended) map of a cell, `X(xi, eta)`, mm, and its derivative as `[[dx/dxi, dx/deta], [dz/dxi, dz/deta]]`
    /// (Gordon and Hall 1973; Szabo and Babuska 1991, sec. 6.2). In a triangle the derivative by `xi` vanishes at `eta = 1`.
    ///
    /// # Panics
    /// For a cell that the mesh does not have.
    pub fn map(&self, cell: usize, xi: f64, eta: f64) -> ([f64; 2], [[f64; 2]; 2]) {
        if self.cell(cell).is_triangle() {
            let (x, d) = self.reference_map(cell, barycentric(xi, eta));
            let by_xi = 0.25 * (1.0 - eta);
            return (x, d.map(|[r, s]| [by_xi * r, 0.5 * s - 0.25 * (1.0 + xi) * r]));
        }
        let edges: [Curve; 4] = std::array::from_fn(|e| self.local_curve(cell, e));
        let corners = self.cells[cell].corners.map(|v| self.vertices[v]);
        let at = |e: usize, t: f64| (edges[e].point(t), edges[e].derivative(t));
        blend(&corners, [at(0, xi), at(1, eta), at(2, xi), at(3, eta)], xi, eta)
    }

    /// The blended map of a triangle at barycentric coordinates, with the derivatives by the last two of them.
    pub(crate) fn reference_map(&self, cell: usize, l: [f64; 3]) -> ([f64; 2], [[f64; 2]; 2]) {
        let [a, b, c, _] = self.cells[cell].corners.map(|v| self.vertices[v]);
        triangle_map([a, b, c], &[0, 1, 3].map(|e| self.local_curve(cell, e)), l)
    }

    /// Refuses a cell whose Jacobian is not positive at its corners and centre.
    fn check_cell(&self, cell: usize) -> Result<(), Error> {
        let corners = self.cells[cell].corners.map(|v| self.vertices[v]);
        let size = distance(corners[0], corners[2]).max(distance(corners[1], corners[3]));
        let triangle = self.cells[cell].is_triangle();
        let places = [-1.0, 1.0, 0.0];
        let curves: [Curve; 4] = std::array::from_fn(|local| self.local_curve(cell, local));
        let edges = curves.each_ref().map(|curve| places.map(|t| (curve.point(t), curve.derivative(t))));
        for [i, j] in [[0, 0], [1, 0], [1, 1], [0, 1], [2, 2]] {
            let (xi, eta) = (places[i], places[j]);
            let (x, d) = match triangle {
                true => self.reference_map(cell, barycentric(xi, eta)),
                false => blend(&corners, [edges[0][i], edges[1][j], edges[2][i], edges[3][j]], xi, eta),
            };
            let jacobian = d[0][0] * d[1][1] - d[0][1] * d[1][0];
            if jacobian.is_nan() || jacobian <= 1e-14 * size * size {
                return Err(Error::FoldedCell { cell, jacobian, x: x[0], z: x[1] });
            }
        }
        Ok(())
    }
}

/// A point of a curve and its derivative there.
pub(crate) type CurvePoint = ([f64; 2], [f64; 2]);

/// The blended map from the four edge points at `(xi, eta)`.
pub(crate) fn blend(corners: &[[f64; 2]; 4], edges: [CurvePoint; 4], xi: f64, eta: f64) -> ([f64; 2], [[f64; 2]; 2]) {
    let (a, b) = (0.5 * (1.0 - xi), 0.5 * (1.0 + xi));
    let (c, d) = (0.5 * (1.0 - eta), 0.5 * (1.0 + eta));
    let [(e0, t0), (e1, t1), (e2, t2), (e3, t3)] = edges;
    let mut x = [0.0; 2];
    let mut j = [[0.0; 2]; 2];
    for i in 0..2 {
        let v = [corners[0][i], corners[1][i], corners[2][i], corners[3][i]];
        x[i] = c * e0[i] + d * e2[i] + a * e3[i] + b * e1[i] - (a * c * v[0] + b * c * v[1] + b * d * v[2] + a * d * v[3]);
        j[i][0] = c * t0[i] + d * t2[i] + 0.5 * (e1[i] - e3[i]) - 0.5 * (c * (v[1] - v[0]) + d * (v[2] - v[3]));
        j[i][1] = 0.5 * (e2[i] - e0[i]) + a * t3[i] + b * t1[i] - 0.5 * (a * (v[3] - v[0]) + b * (v[2] - v[1]));
    }
    (x, j)
}

/// Refuses coordinates that are no numbers and corners that do not exist.
fn check_vertices(vertices: &[[f64; 2]], quads: &[Quad]) -> Result<(), Error> {
    for (i, x) in vertices.iter().enumerate() {
        if let Some(value) = x.iter().find(|v| !v.is_finite()) {
            return Err(Error::OutOfRange { quantity: format!("a coordinate of vertex {i}"), value: *value, range: "finite" });
        }
    }
    for (cell, quad) in quads.iter().enumerate() {
        if let Some(corner) = quad.corners.iter().find(|v| **v >= vertices.len()) {
            let (by, count) = (format!("cell {cell}"), vertices.len());
            return Err(Error::Beyond { by, what: "vertex", index: *corner, count });
        }
    }
    Ok(())
}

/// Finds edges by their vertices: for each vertex the chain of the edges whose lower vertex it is.
struct EdgeIndex {
    first: Vec<usize>,
    next: Vec<usize>,
}

impl EdgeIndex {
    fn find(&self, edges: &[Edge], walk: [usize; 2]) -> Option<usize> {
        let [a, b] = walk;
        let mut at = *self.first.get(a.min(b))?;
        while let Some(edge) = edges.get(at) {
            if edge.vertices == walk || edge.vertices == [b, a] {
                return Some(at);
            }
            at = self.next[at];
        }
        None
    }

    /// Adds the next edge and returns its number.
    fn push(&mut self, [a, b]: [usize; 2]) -> usize {
        let edge = self.next.len();
        self.next.push(std::mem::replace(&mut self.first[a.min(b)], edge));
        edge
    }
}

pub(crate) fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

/// Names in a row, or that there is none.
pub(crate) fn names(known: &[String]) -> String {
    if known.is_empty() { "none".into() } else { known.join(", ") }
}
