//! Points of a cell, evenly spaced in its own coordinates, and the pieces between them.

/// The points of a quadrilateral, `(degree + 1)^2` in rows, or of a triangle, `(degree + 1)(degree + 2) / 2` in rows that grow shorter
/// towards its last corner: just enough for the displacement, a polynomial of that degree.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct CellGrid {
    /// Degree of the cell.
    pub degree: usize,
    /// Whether the cell is a triangle.
    pub triangle: bool,
}

impl CellGrid {
    /// Number of the point at step `i` along row `j`.
    pub fn at(self, i: usize, j: usize) -> usize {
        if self.triangle { j * (self.degree + 1) - j * j.saturating_sub(1) / 2 + i } else { i + (self.degree + 1) * j }
    }

    /// Steps `(i, j)` of all points in their order.
    pub fn steps(self) -> impl Iterator<Item = (usize, usize)> {
        let row = move |j: usize| if self.triangle { self.degree - j } else { self.degree };
        (0..=self.degree).flat_map(move |j| (0..=row(j)).map(move |i| (i, j)))
    }

    /// Coordinates of all points in the square `[-1, 1]^2` that stands for the cell; the last row of a triangle is its corner 2.
    pub fn reference(self) -> impl Iterator<Item = [f64; 2]> {
        let whole = self.degree as f64;
        self.steps().map(move |(i, j)| {
            let length = if self.triangle { self.degree - j } else { self.degree };
            let along = if length == 0 { 0.0 } else { 2.0 * i as f64 / length as f64 - 1.0 };
            [along, 2.0 * j as f64 / whole - 1.0]
        })
    }

    /// Once around the cell, anti-clockwise from its first corner.
    pub fn outline(self) -> Vec<usize> {
        let p = self.degree;
        let along = (0..p).map(|i| self.at(i, 0));
        if self.triangle {
            let rest = (0..p).map(|j| self.at(p - j, j)).chain((1..=p).rev().map(|j| self.at(0, j)));
            return along.chain(rest).collect();
        }
        let rest = (0..p).map(|j| self.at(p, j)).chain((1..=p).rev().map(|i| self.at(i, p)));
        along.chain(rest).chain((1..=p).rev().map(|j| self.at(0, j))).collect()
    }

    /// Flat triangles and quadrilaterals between points, anti-clockwise, about `along` times `up` of a quadrilateral; the sides of a
    /// triangle fall into equal parts, at least as many as asked for. None of degree 0, a point.
    pub fn pieces(self, along: usize, up: usize) -> Vec<Vec<usize>> {
        let p = self.degree;
        if p == 0 {
            return Vec::new();
        }
        if self.triangle {
            let parts = (along.max(up).clamp(1, p)..=p).find(|parts| p.is_multiple_of(*parts)).unwrap_or(p);
            let step = p / parts;
            let at = |i: usize, j: usize| self.at(step * i, step * j);
            let row = |j: usize| {
                let upright = (0..parts - j).map(move |i| vec![at(i, j), at(i + 1, j), at(i, j + 1)]);
                let turned = (1..parts - j).map(move |i| vec![at(i, j), at(i, j + 1), at(i - 1, j + 1)]);
                upright.chain(turned)
            };
            return (0..parts).flat_map(row).collect();
        }
        let marks = |count: usize| -> Vec<usize> {
            let count = count.clamp(1, p);
            (0..=count).map(|k| (k * p + count / 2) / count).collect()
        };
        let (columns, rows) = (marks(along), marks(up));
        let corners = |i: &[usize], j: &[usize]| [(i[0], j[0]), (i[1], j[0]), (i[1], j[1]), (i[0], j[1])];
        let piece = |i: &[usize], j: &[usize]| corners(i, j).iter().map(|(i, j)| self.at(*i, *j)).collect();
        rows.windows(2).flat_map(|j| columns.windows(2).map(move |i| piece(i, j))).collect()
    }

    /// All points in the order of a Lagrange cell of VTK (types 70 and 69): corners, edges, inside.
    pub fn lagrange(self) -> Vec<usize> {
        let p = self.degree;
        if self.triangle {
            return self.rings();
        }
        // Edges run in the direction of growing coordinates; inside the first coordinate is the fastest.
        let mut nodes = vec![self.at(0, 0), self.at(p, 0), self.at(p, p), self.at(0, p)];
        nodes.extend((1..p).map(|i| self.at(i, 0)));
        nodes.extend((1..p).map(|j| self.at(p, j)));
        nodes.extend((1..p).map(|i| self.at(i, p)));
        nodes.extend((1..p).map(|j| self.at(0, j)));
        nodes.extend((1..p).flat_map(|j| (1..p).map(move |i| self.at(i, j))));
        nodes
    }

    /// The points of a triangle ring by ring inwards: of each the corners, then the edges in the sense of going round.
    fn rings(self) -> Vec<usize> {
        let mut nodes = Vec::new();
        // Ring k is the boundary of a triangle of degree p - 3 k whose first corner is (k, k).
        for k in 0..=self.degree / 3 {
            let p = self.degree - 3 * k;
            let at = |i: usize, j: usize| self.at(k + i, k + j);
            if p == 0 {
                nodes.push(at(0, 0));
                break;
            }
            nodes.extend([at(0, 0), at(p, 0), at(0, p)]);
            nodes.extend((1..p).map(|i| at(i, 0)));
            nodes.extend((1..p).map(|j| at(p - j, j)));
            nodes.extend((1..p).rev().map(|j| at(0, j)));
        }
        nodes
    }

    /// The point at which each point of the mirror image stood, the image's corners running anti-clockwise again.
    pub fn mirror(self) -> Vec<usize> {
        let last = |j: usize| if self.triangle { self.degree - j } else { self.degree };
        self.steps().map(|(i, j)| self.at(last(j) - i, j)).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::CellGrid;

    fn both(degree: usize) -> [CellGrid; 2] {
        [false, true].map(|triangle| CellGrid { degree, triangle })
    }

    /// Position in the plane, corner 0 at (0, 0), corner 1 at (1, 0).
    fn place(grid: CellGrid, point: usize) -> [f64; 2] {
        let (i, j) = grid.steps().nth(point).unwrap_or_default();
        [i, j].map(|k| k as f64 / grid.degree as f64)
    }

    fn area(points: &[[f64; 2]]) -> f64 {
        let next = |i: usize| points[(i + 1) % points.len()];
        0.5 * (0..points.len()).map(|i| points[i][0] * next(i)[1] - points[i][1] * next(i)[0]).sum::<f64>()
    }

    #[test]
    fn every_point_of_a_cell_is_a_node_of_its_lagrange_element_once() {
        for grid in (1..=16).flat_map(both) {
            let count = grid.steps().count();
            assert_eq!(grid.steps().map(|(i, j)| grid.at(i, j)).collect::<Vec<_>>(), (0..count).collect::<Vec<_>>());
            for mut nodes in [grid.lagrange(), grid.mirror()] {
                nodes.sort_unstable();
                assert_eq!(nodes, (0..count).collect::<Vec<_>>(), "{grid:?}");
            }
        }
    }

    #[test]
    fn pieces_of_any_size_and_the_outline_have_the_area_of_the_cell() {
        for grid in (1..=9).flat_map(both) {
            let whole = if grid.triangle { 0.5 } else { 1.0 };
            let at = |nodes: &Vec<usize>| area(&nodes.iter().map(|k| place(grid, *k)).collect::<Vec<_>>());
            approx::assert_relative_eq!(at(&grid.outline()), whole, epsilon = 1e-14);
            for (along, up) in [(1, 1), (2, 1), (3, 2), (grid.degree, grid.degree)] {
                let areas: Vec<f64> = grid.pieces(along, up).iter().map(at).collect();
                assert!(areas.iter().all(|a| *a > 0.0), "{grid:?}: {areas:?}");
                approx::assert_relative_eq!(areas.iter().sum::<f64>(), whole, epsilon = 1e-13);
            }
            assert_eq!(grid.pieces(grid.degree, grid.degree).len(), grid.degree * grid.degree);
        }
    }

    #[test]
    fn the_nodes_of_a_cubic_quadrilateral_stand_in_vtk_order() {
        // 12 13 14 15
        //  8  9 10 11
        //  4  5  6  7
        //  0  1  2  3
        let grid = CellGrid { degree: 3, triangle: false };
        assert_eq!(grid.lagrange(), [0, 3, 15, 12, 1, 2, 7, 11, 13, 14, 4, 8, 5, 6, 9, 10]);
    }

    #[test]
    fn the_nodes_of_a_quartic_triangle_stand_in_vtk_order() {
        // 14
        // 12 13
        //  9 10 11
        //  5  6  7  8
        //  0  1  2  3  4
        let grid = CellGrid { degree: 4, triangle: true };
        assert_eq!(grid.lagrange(), [0, 4, 14, 1, 2, 3, 8, 11, 13, 12, 9, 5, 6, 7, 10]);
    }
}
