//! All modes of a cell at one point, quadrilateral or triangle alike.

use crate::element::cell_geometry;
use crate::legendre::shape_functions;
use crate::mesh::Mesh;
use crate::quadrature::gauss;
use crate::triangle::{Jet, barycentric, collapsed, triangle_modes, triangle_rule};

/// A point of a cell. Derivatives are by the cell's own coordinates: `xi, eta`, in a triangle the last two barycentric ones.
pub(crate) struct CellPoint {
    /// Position in the plane.
    pub(crate) position: [f64; 2],
    /// Derivative of the position.
    pub(crate) derivative: [[f64; 2]; 2],
    /// Unsigned modes in the numbering of [`LocalModes::position`](crate::basis::LocalModes::position).
    pub(crate) modes: Vec<Jet>,
}

impl CellPoint {
    /// The point at reference coordinates of the (collapsed) square.
    pub(crate) fn new(mesh: &Mesh, cell: usize, degree: usize, xi: f64, eta: f64) -> CellPoint {
        if mesh.cells[cell].is_triangle() {
            let l = barycentric(xi, eta);
            let (position, derivative) = mesh.reference_map(cell, l);
            return CellPoint { position, derivative, modes: triangle_modes(degree, l) };
        }
        let geometry = cell_geometry(mesh, cell, &[xi], &[eta]);
        let ((vx, dx), (vy, dy)) = (shape_functions(degree, xi), shape_functions(degree, eta));
        let modes = (0..=degree).flat_map(|j| (0..=degree).map(move |i| (i, j)));
        let modes = modes.map(|(i, j)| [vx[i] * vy[j], dx[i] * vy[j], vx[i] * dy[j]]).collect();
        CellPoint { position: geometry.position[0], derivative: geometry.derivative[0], modes }
    }

    /// Jacobian determinant of the map by the cell's own coordinates.
    pub(crate) fn jacobian(&self) -> f64 {
        let [[xx, xe], [zx, ze]] = self.derivative;
        xx * ze - xe * zx
    }
}

/// Quadrature points of a cell in the (collapsed) square and weights for the area in its own coordinates.
pub(crate) fn cell_rule(triangle: bool, points: usize) -> Vec<([f64; 2], f64)> {
    if triangle {
        let (points, weights) = triangle_rule(points);
        return points.into_iter().map(collapsed).map(|(xi, eta)| [xi, eta]).zip(weights).collect();
    }
    let rule = gauss(points);
    let line = || rule.points.iter().zip(&rule.weights);
    line().flat_map(|(eta, v)| line().map(move |(xi, w)| ([*xi, *eta], v * w))).collect()
}
