//! The displacement and stress of a whole body at any point.

use crate::basis::LocalModes;
use crate::cell_point::{CellPoint, cell_rule};
use crate::error::Error;
use crate::kinematics::Kinematics;
use crate::load_case::{BodyPoint, Eigenstrain, Load};
use crate::material::Material;
use crate::mesh::Mesh;
use crate::moduli::Moduli;
use crate::point_search::CellBoxes;
use crate::problem::BodyProblem;
use crate::space::Space;
use crate::stress::Stress;
use std::sync::{Arc, OnceLock};

/// A displacement field with its stresses. It owns all it needs and can be sent to a thread.
#[derive(Clone)]
pub struct Field {
    mesh: Arc<Mesh>,
    pub(crate) kinematics: Kinematics,
    materials: Vec<Material>,
    degrees: Vec<usize>,
    components: usize,
    cells: Vec<(LocalModes, Vec<f64>)>,
    /// Eigenstrains with the factors of their load cases.
    eigenstrains: Vec<(f64, Eigenstrain)>,
    search: OnceLock<CellBoxes>,
}

/// What a field is made of.
pub(crate) struct FieldParts<'a> {
    pub(crate) problem: &'a BodyProblem,
    pub(crate) space: &'a Space,
    /// Factors of the load cases, others may follow.
    pub(crate) factors: &'a [f64],
    /// Modes and coefficients of every cell.
    pub(crate) cells: Vec<(LocalModes, Vec<f64>)>,
}

/// Displacement and stress at a point.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PointState {
    /// Displacement (u_x, u_z), (u_r, u_z) or (u_phi, 0), mm.
    pub displacement: [f64; 2],
    /// Displacement gradient `[[u_x,x, u_x,z], [u_z,x, u_z,z]]`, no unit; in torsion `[[u_phi,r, u_phi,z], [0, 0]]`.
    pub gradient: [[f64; 2]; 2],
    /// Stress, MPa, `[xx, zz, xz, yy]` (yy is the out-of-plane or hoop stress); in torsion `[r phi, phi z, 0, 0]`, of a
    /// potential `k grad u` (minus the flux) in the first two.
    pub stress: [f64; 4],
}

impl Field {
    pub(crate) fn new(FieldParts { problem, space, factors, cells }: FieldParts<'_>) -> Field {
        let mut eigenstrains = Vec::new();
        for (case, factor) in problem.load_cases.iter().zip(factors).filter(|(_, factor)| **factor != 0.0) {
            for load in &case.loads {
                if let Load::Eigenstrain(eigen) = load {
                    eigenstrains.push((*factor, eigen.clone()));
                }
            }
        }
        Field {
            mesh: Arc::clone(&problem.mesh),
            kinematics: problem.kinematics,
            materials: problem.materials.clone(),
            degrees: space.cell_degree.clone(),
            components: space.components,
            cells,
            eigenstrains,
            search: OnceLock::new(),
        }
    }

    /// The mesh.
    pub fn mesh(&self) -> &Arc<Mesh> {
        &self.mesh
    }

    /// The kinematics of the problem whose field it is.
    pub fn kinematics(&self) -> Kinematics {
        self.kinematics
    }

    /// Strain energy `1/2 int sigma : (eps - eps*) dV`, N mm, by Gauss quadrature; for a potential half the dissipation. Foundations are not
    /// part of it.
    pub fn strain_energy(&self) -> f64 {
        let mut energy = 0.0;
        for cell in 0..self.cells.len() {
            for ([xi, eta], weight) in cell_rule(self.mesh.cells[cell].is_triangle(), self.degrees[cell] + 3) {
                let point = CellPoint::new(&self.mesh, cell, self.degrees[cell], xi, eta);
                let (value, gradient) = self.state(&self.cells[cell], &point);
                let strain = self.elastic_strain(cell, [xi, eta], &point, (value, gradient));
                let moduli = self.materials[self.mesh.cells[cell].material].moduli(self.kinematics);
                let stress = moduli.stress(strain, self.kinematics);
                let work: f64 = strain.iter().zip(stress).map(|(e, s)| e * s).sum();
                energy += 0.5 * weight * point.jacobian() * self.kinematics.measure(point.position[0]) * work;
            }
        }
        energy
    }

    /// State at the reference point `(xi, eta)` of a cell; in a triangle the side `eta = 1` is corner 2, see [`Cell`](crate::Cell). Beyond -1..=1 the
    /// polynomials of the cell go on: what they say there is no state of the body.
    ///
    /// # Errors
    /// [`Error::Beyond`] for a cell that the mesh does not have.
    pub fn at(&self, cell: usize, xi: f64, eta: f64) -> Result<PointState, Error> {
        let beyond = || Error::Beyond { by: "a point".into(), what: "cell", index: cell, count: self.cells.len() };
        let local = self.cells.get(cell).ok_or_else(beyond)?;
        let point = CellPoint::new(&self.mesh, cell, self.degrees[cell], xi, eta);
        let (value, gradient) = self.state(local, &point);
        let moduli = self.materials[self.mesh.cells[cell].material].moduli(self.kinematics);
        let stress = match moduli {
            Moduli::Isotropic { c11, c12, shear } if self.eigenstrains.is_empty() => {
                self.isotropic_stress(cell, [c11, c12, shear], point.position[0], (value, gradient))
            }
            Moduli::Isotropic { .. } | Moduli::General { .. } | Moduli::Scalar { .. } => {
                moduli.stress(self.elastic_strain(cell, [xi, eta], &point, (value, gradient)), self.kinematics)
            }
        };
        Ok(PointState { displacement: value, gradient, stress })
    }

    /// Coefficients of the first component in a cell with so many modes, in the numbering of [`CellPoint::modes`]; none where the field has
    /// others.
    pub(crate) fn coefficients(&self, cell: usize, modes: usize) -> Option<Vec<f64>> {
        let (local, u) = self.cells.get(cell)?;
        let of =
            |(position, sign): (&usize, &f64)| if *position == usize::MAX { 0.0 } else { sign * u[self.components * position] };
        (local.position.len() == modes).then(|| local.position.iter().zip(&local.sign).map(of).collect())
    }

    /// Displacement and its gradient at a point of a cell, given with its modes and coefficients.
    fn state(&self, (local, u): &(LocalModes, Vec<f64>), point: &CellPoint) -> ([f64; 2], [[f64; 2]; 2]) {
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
        (value, gradient)
    }

    /// Strains `[xx, zz, gamma_xz, yy]` at a point without the eigenstrains, of a scalar problem its two strains.
    fn elastic_strain(&self, cell: usize, reference: [f64; 2], point: &CellPoint, (u, g): ([f64; 2], [[f64; 2]; 2])) -> [f64; 4] {
        let hoop = self.hoop_strain(cell, point.position[0], u, g);
        let mut strain = match self.kinematics {
            Kinematics::Torsion => [g[0][0] - hoop, g[0][1], 0.0, 0.0],
            Kinematics::Potential { .. } | Kinematics::AxisymmetricPotential => [g[0][0], g[0][1], 0.0, 0.0],
            Kinematics::Axisymmetric => [g[0][0], g[1][1], g[0][1] + g[1][0], hoop],
            Kinematics::PlaneStress { .. } | Kinematics::PlaneStrain { .. } => [g[0][0], g[1][1], g[0][1] + g[1][0], 0.0],
        };
        let place = BodyPoint { cell, reference, position: point.position, material: self.mesh.cells[cell].material };
        for (factor, eigen) in &self.eigenstrains {
            let own = (eigen.strain)(&place);
            strain.iter_mut().zip(own).for_each(|(e, own)| *e -= factor * own);
        }
        strain
    }

    /// `u_r / r`, `u_phi / r`.
    fn hoop_strain(&self, cell: usize, r: f64, u: [f64; 2], g: [[f64; 2]; 2]) -> f64 {
        // Near the axis it is round-off over round-off; its limit is u_r,r.
        let corners = self.mesh.cells[cell].corners.map(|v| self.mesh.vertices[v]);
        let size = corners.iter().fold(0.0_f64, |m, c| m.max((c[0] - corners[0][0]).abs()));
        if r > 1e-8 * size { u[0] / r } else { g[0][0] }
    }

    /// Number of cells.
    pub fn cells(&self) -> usize {
        self.cells.len()
    }

    /// Degree of a cell.
    ///
    /// # Panics
    /// For a cell that the mesh does not have.
    pub fn degree(&self, cell: usize) -> usize {
        self.degrees[cell]
    }

    /// Position (x, z) or (r, z) of a reference point, mm.
    ///
    /// # Panics
    /// For a cell that the mesh does not have.
    pub fn position(&self, cell: usize, xi: f64, eta: f64) -> [f64; 2] {
        self.mesh.map(cell, xi, eta).0
    }

    /// The cell that holds a point (mm) and its reference coordinates, `(cell, xi, eta)`, as by [`PointSearch::locate`](crate::PointSearch::locate); the search is
    /// built with the first point.
    ///
    /// # Errors
    /// [`Error::OutsideMesh`].
    pub fn locate(&self, x: [f64; 2]) -> Result<(usize, f64, f64), Error> {
        self.search.get_or_init(|| CellBoxes::new(&self.mesh)).locate(&self.mesh, x)
    }

    /// Stress in an isotropic material, in the order of operations of its own law.
    fn isotropic_stress(&self, cell: usize, [c11, c12, shear]: [f64; 3], r: f64, (u, g): ([f64; 2], [[f64; 2]; 2])) -> [f64; 4] {
        let hoop = self.hoop_strain(cell, r, u, g);
        let in_plane = || [c11 * g[0][0] + c12 * g[1][1], c11 * g[1][1] + c12 * g[0][0], shear * (g[0][1] + g[1][0])];
        match self.kinematics {
            Kinematics::Torsion => [shear * (g[0][0] - hoop), shear * g[0][1], 0.0, 0.0],
            Kinematics::Potential { .. } | Kinematics::AxisymmetricPotential => [0.0; 4],
            Kinematics::Axisymmetric => [
                c11 * g[0][0] + c12 * (g[1][1] + hoop),
                c11 * g[1][1] + c12 * (g[0][0] + hoop),
                shear * (g[0][1] + g[1][0]),
                c11 * hoop + c12 * (g[0][0] + g[1][1]),
            ],
            Kinematics::PlaneStress { .. } => {
                let [xx, zz, xz] = in_plane();
                [xx, zz, xz, 0.0]
            }
            Kinematics::PlaneStrain { .. } => {
                let [xx, zz, xz] = in_plane();
                let poisson = self.materials[self.mesh.cells[cell].material].poisson().unwrap_or(0.0);
                [xx, zz, xz, poisson * (xx + zz)]
            }
        }
    }
}

impl PointState {
    /// Von Mises stress of the stored components, MPa. It has a meaning in the plane and in bodies of revolution alone: for torsion see [`Stress`], and a potential has
    /// fluxes in their place.
    pub fn von_mises(&self) -> f64 {
        Stress::new(self.stress, [0.0; 2]).von_mises()
    }
}
