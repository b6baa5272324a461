//! The displacement and stress of a whole body at any point.

use crate::basis::LocalModes;
use crate::cell_point::CellPoint;
use crate::error::Error;
use crate::material::{Kinematics, Material};
use crate::mesh::Mesh;
use crate::point_search::PointSearch;
use crate::space::Space;
use crate::stress::Stress;
use std::sync::OnceLock;

/// A displacement field with its stresses.
pub struct Field<'a> {
    pub(crate) mesh: &'a Mesh,
    pub(crate) kinematics: Kinematics,
    materials: Vec<Material>,
    degrees: Vec<usize>,
    components: usize,
    cells: Vec<(LocalModes, Vec<f64>)>,
    search: OnceLock<PointSearch<'a>>,
}

/// Displacement and stress at a point.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PointState {
    /// Displacement (u_x, u_z), (u_r, u_z) or (u_phi, 0), mm.
    pub displacement: [f64; 2],
    /// Displacement gradient `[[u_x,x, u_x,z], [u_z,x, u_z,z]]`, no unit; in torsion `[[u_phi,r, u_phi,z], [0, 0]]`.
    pub gradient: [[f64; 2]; 2],
    /// Stress, MPa, `[xx, zz, xz, yy]` (yy is the out-of-plane or hoop stress); in torsion `[r phi, phi z, 0, 0]`.
    pub stress: [f64; 4],
}

impl<'a> Field<'a> {
    pub(crate) fn new(
        mesh: &'a Mesh,
        kinematics: Kinematics,
        materials: &[Material],
        space: &Space,
        cells: Vec<(LocalModes, Vec<f64>)>,
    ) -> Field<'a> {
        Field {
            mesh,
            kinematics,
            materials: materials.to_vec(),
            degrees: space.cell_degree.clone(),
            components: space.components,
            cells,
            search: OnceLock::new(),
        }
    }

    /// State at the reference point `(xi, eta)` of a cell; in a triangle the side `eta = 1` is corner 2, see [`Cell`](crate::Cell).
    ///
    /// # Errors
    /// [`Error::Count`] for a cell that the mesh does not have.
    pub fn at(&self, cell: usize, xi: f64, eta: f64) -> Result<PointState, Error> {
        let beyond =
            || Error::Count { what: format!("cell {cell} of the field, cells"), given: cell + 1, expected: self.cells.len() };
        let (local, u) = self.cells.get(cell).ok_or_else(beyond)?;
        let point = CellPoint::new(self.mesh, cell, self.degrees[cell], xi, eta);
        let [[xx, xe], [zx, ze]] = point.derivative;
        let jacobian = point.jacobian();
        let mut value = [0.0; 2];
        let mut slope = [[0.0; 2]; 2];
        for ((mode, position), sign) in point.modes.iter().zip(&local.position).zip(&local.sign) {
            if *position == usize::MAX {
                continue;
            }
            for c in 0..self.components {
                let a = sign * u[self.components * position + c];
                value[c] += a * mode[0];
                slope[c][0] += a * mode[1];
                slope[c][1] += a * mode[2];
            }
        }
        let gradient: [[f64; 2]; 2] = std::array::from_fn(|c| {
            [(slope[c][0] * ze - slope[c][1] * zx) / jacobian, (slope[c][1] * xx - slope[c][0] * xe) / jacobian]
        });
        let stress = self.stress(cell, point.position[0], value, gradient);
        Ok(PointState { displacement: value, gradient, stress })
    }

    /// Number of cells.
    pub fn cells(&self) -> usize {
        self.cells.len()
    }

    /// Degree of a cell.
    pub fn degree(&self, cell: usize) -> usize {
        self.degrees[cell]
    }

    /// Position (x, z) or (r, z) of a reference point, mm.
    pub fn position(&self, cell: usize, xi: f64, eta: f64) -> [f64; 2] {
        self.mesh.map(cell, xi, eta).0
    }

    /// The cell that holds a point (mm) and its reference coordinates, `(cell, xi, eta)`, as by [`PointSearch::locate`]; the search is
    /// built with the first point.
    ///
    /// # Errors
    /// [`Error::OutsideMesh`].
    pub fn locate(&self, x: [f64; 2]) -> Result<(usize, f64, f64), Error> {
        self.search.get_or_init(|| PointSearch::new(self.mesh)).locate(x)
    }

    fn stress(&self, cell: usize, r: f64, u: [f64; 2], g: [[f64; 2]; 2]) -> [f64; 4] {
        let material = self.materials[self.mesh.cells[cell].material];
        let m = material.moduli(self.kinematics);
        // Near the axis u_r / r is round-off over round-off; its limit is u_r,r.
        let corners = self.mesh.cells[cell].corners.map(|v| self.mesh.vertices[v]);
        let size = corners.iter().fold(0.0_f64, |m, c| m.max((c[0] - corners[0][0]).abs()));
        let hoop = if r > 1e-8 * size { u[0] / r } else { g[0][0] };
        match self.kinematics {
            Kinematics::Torsion => [m.shear * (g[0][0] - hoop), m.shear * g[0][1], 0.0, 0.0],
            Kinematics::Axisymmetric => [
                m.c11 * g[0][0] + m.c12 * (g[1][1] + hoop),
                m.c11 * g[1][1] + m.c12 * (g[0][0] + hoop),
                m.shear * (g[0][1] + g[1][0]),
                m.c11 * hoop + m.c12 * (g[0][0] + g[1][1]),
            ],
            _ => {
                let xx = m.c11 * g[0][0] + m.c12 * g[1][1];
                let zz = m.c11 * g[1][1] + m.c12 * g[0][0];
                let plane_strain = matches!(self.kinematics, Kinematics::PlaneStrain { .. });
                let yy = if plane_strain { material.poisson() * (xx + zz) } else { 0.0 };
                [xx, zz, m.shear * (g[0][1] + g[1][0]), yy]
            }
        }
    }
}

impl PointState {
    /// Von Mises stress of the stored components, MPa (not for torsion).
    pub fn von_mises(&self) -> f64 {
        Stress::new(self.stress, [0.0; 2]).von_mises()
    }
}
