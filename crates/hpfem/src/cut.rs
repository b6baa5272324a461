//! Cuts from edge to edge through a mesh.

use crate::curve::{CURVE_DEGREE, Curve};
use crate::error::Error;
use crate::mesh::{Cell, Mesh, Quad};
use crate::split::Split;
use std::collections::BTreeMap;

impl Mesh {
    /// Cuts an edge at parameter `t` of its own direction, and every cell in the row that the edge belongs to from side to side: no
    /// hanging nodes arise. The row goes on through opposite edges until it ends on the boundary or in the far corner of a triangle, or
    /// closes; the new edges follow the maps of the cells. Layer numbers, materials and names stay.
    ///
    /// ```text
    /// +---+---+---+        +-+-+---+---+
    /// |   |   |   |        | | |   |   |
    /// +---+---+---+   ->   +-+-+---+---+
    /// |   |   |   |        | | |   |   |
    /// +-e-+---+---+        +-+-+---+---+
    /// ```
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for `t` outside (-1, 1), [`Error::Beyond`] for an edge that does not exist, [`Error::FoldedCell`] if a cell
    /// cannot be cut.
    pub fn cut_through(&self, edge: usize, t: f64) -> Result<Mesh, Error> {
        if !(t > -1.0 && t < 1.0) {
            return Err(Error::OutOfRange { quantity: "the parameter of a cut".into(), value: t, range: "in (-1, 1)" });
        }
        self.check_edge(edge)?;
        self.cut_all_of(&self.row(edge, t))
    }

    /// Cuts every row of cells that holds one of the edges in the middle, as [`Mesh::cut_through`] does one row, and returns how many there are. The
    /// cells that come of it do not hang on the order of the edges.
    ///
    /// # Errors
    /// Those of [`Mesh::cut_through`].
    pub fn cut_rows(&self, edges: &[usize]) -> Result<(Mesh, usize), Error> {
        let (mut all, mut rows) = (BTreeMap::new(), 0);
        for edge in edges {
            self.check_edge(*edge)?;
            if !all.contains_key(edge) {
                all.extend(self.row(*edge, 0.0));
                rows += 1;
            }
        }
        Ok((self.cut_all_of(&all)?, rows))
    }

    /// Refuses an edge that does not exist.
    fn check_edge(&self, edge: usize) -> Result<(), Error> {
        let count = self.edges.len();
        if edge < count { Ok(()) } else { Err(Error::Beyond { by: "a cut".into(), what: "edge", index: edge, count }) }
    }

    /// Cuts the edges at their parameters, and the cells that they belong to.
    fn cut_all_of(&self, row: &BTreeMap<usize, f64>) -> Result<Mesh, Error> {
        let mut split = self.split_edges(|e| row.get(&e).copied());
        for (c, cell) in self.cells.iter().enumerate() {
            if cell.is_triangle() {
                self.cut_triangle(c, row, &mut split);
            } else {
                self.cut_quad(c, row, &mut split);
            }
        }
        let mesh = split.joined()?;
        mesh.check_cells()?;
        Ok(mesh)
    }

    /// Adds the pieces of a quadrilateral.
    fn cut_quad(&self, c: usize, row: &BTreeMap<usize, f64>, split: &mut Split<'_>) {
        let Split { vertices, quads, curves, cut, .. } = split;
        let cell = &self.cells[c];
        let place = |local: usize| cut_place(cell, local, row);
        let middle = |local: usize| cut.get(&cell.edges[local]?).copied();
        let [k0, k1, k2, k3] = cell.corners;
        let mut quad = |corners| quads.push(Quad { corners, material: cell.material, layer: cell.layer });
        // Vertices on the edges below, right, above, left.
        match (place(0).zip(middle(0)).zip(middle(2)), place(1).zip(middle(1)).zip(middle(3))) {
            (None, None) => quad(cell.corners),
            (Some(((xi, below), above)), None) => {
                curves.push(([below, above], self.inner_curve(c, xi, false)));
                quad([k0, below, above, k3]);
                quad([below, k1, k2, above]);
            }
            (None, Some(((eta, right), left))) => {
                curves.push(([left, right], self.inner_curve(c, eta, true)));
                quad([k0, k1, right, left]);
                quad([left, right, k2, k3]);
            }
            (Some(((xi, below), above)), Some(((eta, right), left))) => {
                let centre = vertices.len();
                let (up, across) = (self.inner_curve(c, xi, false), self.inner_curve(c, eta, true));
                vertices.push(self.map(c, xi, eta).0);
                curves.push(([below, centre], up.part(-1.0, eta)));
                curves.push(([centre, above], up.part(eta, 1.0)));
                curves.push(([left, centre], across.part(-1.0, xi)));
                curves.push(([centre, right], across.part(xi, 1.0)));
                quad([k0, below, centre, left]);
                quad([below, k1, right, centre]);
                quad([centre, right, k2, above]);
                quad([left, centre, above, k3]);
            }
        }
    }

    /// Adds the pieces of a triangle.
    fn cut_triangle(&self, c: usize, row: &BTreeMap<usize, f64>, split: &mut Split<'_>) {
        let Split { quads, curves, cut, .. } = split;
        let cell = &self.cells[c];
        let [k0, k1, k2, _] = cell.corners;
        let middle = |local: usize| cut.get(&cell.edges[local]?).copied();
        let (corners, middles) = ([k0, k1, k2], [0, 1, 3].map(middle));
        let pieces = triangle_pieces(corners, middles);
        // Barycentric coordinates of the corners and of the vertices that cut the sides.
        let unit = |k: usize| std::array::from_fn(|i| if i == k { 1.0 } else { 0.0 });
        let mut known: Vec<(usize, [f64; 3])> = (0..3).map(|k| (corners[k], unit(k))).collect();
        for (side, ends) in [[0, 1], [1, 2], [0, 2]].into_iter().enumerate() {
            let Some((v, at)) = middles[side].zip(cut_place(cell, [0, 1, 3][side], row)) else { continue };
            let [a, b] = ends.map(unit);
            known.push((v, std::array::from_fn(|i| 0.5 * ((1.0 - at) * a[i] + (1.0 + at) * b[i]))));
        }
        let bent = cell.sides().any(|(_, e)| !self.edges[e].curve.is_straight());
        let outer = |a: [f64; 3], b: [f64; 3]| (0..3).any(|i| a[i] == 0.0 && b[i] == 0.0);
        for piece in pieces.iter().filter(|_| bent) {
            for (p, q) in (0..4).map(|i| (piece[i], piece[(i + 1) % 4])) {
                let at = |v: usize| known.iter().find(|(known, _)| *known == v).map(|(_, l)| *l);
                let Some((a, b)) = at(p).zip(at(q)).filter(|(a, b)| p < q && !outer(*a, *b)) else { continue };
                let along = |t: f64| std::array::from_fn(|i| 0.5 * ((1.0 - t) * a[i] + (1.0 + t) * b[i]));
                curves.push(([p, q], Curve::interpolated(CURVE_DEGREE, |t| self.reference_map(c, along(t)).0)));
            }
        }
        quads.extend(pieces.into_iter().map(|corners| Quad { corners, material: cell.material, layer: cell.layer }));
    }

    /// The edges of a row with the parameter of the cut in each edge's own direction.
    fn row(&self, edge: usize, t: f64) -> BTreeMap<usize, f64> {
        let neighbours = self.edge_cells();
        let mut row = BTreeMap::from([(edge, t)]);
        let mut open = vec![edge];
        while let Some(e) = open.pop() {
            for (c, local) in &neighbours[e] {
                // Opposite edges of a cell are both walked towards growing reference coordinate.
                let (cell, opposite) = (&self.cells[*c], (local + 2) % 4);
                let Some(other) = cell.edges[opposite].filter(|_| !cell.is_triangle()) else { continue };
                let at = if cell.against[*local] == cell.against[opposite] { row[&e] } else { -row[&e] };
                if let std::collections::btree_map::Entry::Vacant(entry) = row.entry(other) {
                    entry.insert(at);
                    open.push(other);
                }
            }
        }
        row
    }

    /// The image of the line `xi = at`, or with `across` of `eta = at`, towards growing reference coordinate.
    fn inner_curve(&self, cell: usize, at: f64, across: bool) -> Curve {
        let point = |t: f64| if across { self.map(cell, t, at).0 } else { self.map(cell, at, t).0 };
        // The edges at whose sides the line runs, and those it joins.
        let (sides, ends) = if across { ([0, 2], [3, 1]) } else { ([3, 1], [0, 2]) };
        let curve = |local: usize| self.local_curve(cell, local);
        match sides.map(curve) {
            [Curve::Line { .. }, Curve::Line { .. }] => Curve::Line { start: point(-1.0), end: point(1.0) },
            [Curve::Arc { centre, radius, from, to }, Curve::Arc { centre: c, radius: r, from: f, to: t }]
                if same_sector((centre, [from, to]), (c, [f, t]))
                    && ends.iter().all(|e| matches!(curve(*e), Curve::Line { .. })) =>
            {
                let share = 0.5 * (1.0 + at);
                Curve::Arc { centre, radius: (1.0 - share) * radius + share * r, from, to }
            }
            [Curve::Line { .. } | Curve::Arc { .. } | Curve::Polynomial { .. }, _] => Curve::interpolated(CURVE_DEGREE, point),
        }
    }
}

/// Parameter of the cut of a cell's local edge, towards growing reference coordinate.
fn cut_place(cell: &Cell, local: usize, row: &BTreeMap<usize, f64>) -> Option<f64> {
    row.get(&cell.edges[local]?).map(|at| if cell.against[local] { -at } else { *at })
}

/// The cells that a triangle falls into, by the vertices that cut its sides, the first of which joins the first two corners.
fn triangle_pieces(corners: [usize; 3], middles: [Option<usize>; 3]) -> Vec<[usize; 4]> {
    // Turned so that a side without a cut, if there is one, comes last, and a side with a cut first.
    let turn = (0..3).find(|t| middles[*t].is_some() && middles[(t + 2) % 3].is_none()).unwrap_or(0);
    let [a, b, c] = std::array::from_fn(|i| corners[(turn + i) % 3]);
    match std::array::from_fn(|i| middles[(turn + i) % 3]) {
        [Some(m), None, _] => vec![[a, m, c, c], [m, b, c, c]],
        [Some(m), Some(n), None] => vec![[m, b, n, n], [a, m, n, c]],
        [Some(m), Some(n), Some(o)] => vec![[a, m, o, o], [m, b, n, n], [n, c, o, o], [m, n, o, o]],
        [None, ..] => vec![[a, b, c, c]],
    }
}

/// Whether two arcs have the same centre and angles up to round-off.
fn same_sector((centre, [from, to]): ([f64; 2], [f64; 2]), (c, [f, t]): ([f64; 2], [f64; 2])) -> bool {
    let near = |a: f64, b: f64| (a - b).abs() <= 1e-14 * (1.0 + a.abs());
    near(centre[0], c[0]) && near(centre[1], c[1]) && near(from, f) && near(to, t)
}
