//! From cells to elements of the elimination: stiffness, condensed interior, loads, supports.

use crate::additions::BodyForce;
use crate::basis::{LocalModes, Table};
use crate::cell_matrix::SharedMatrices;
use crate::curve::Curve;
use crate::element::Workspace;
use crate::elimination::Element;
use crate::error::Error;
use crate::legendre::shape_functions;
use crate::loads::EdgeLoad;
use crate::material::{Kinematics, Material};
use crate::mesh::Mesh;
use crate::quadrature::{barycentric_weights, gauss, gauss_lobatto, lagrange};
use crate::space::{Space, Target, rigid_rows};
use crate::triangle_matrix::TriangleTable;
use faer::linalg::matmul::matmul;
use faer::linalg::triangular_solve::solve_upper_triangular_in_place;
use faer::{Accum, Mat, MatRef, Par};
use std::sync::Arc;

/// A point on the boundary of a body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BoundaryPoint {
    /// Position (x, z) or (r, z).
    pub position: [f64; 2],
    /// Unit normal out of the body.
    pub outward: [f64; 2],
    /// Unit tangent: the outward normal turned anti-clockwise by a right angle.
    pub tangent: [f64; 2],
}

/// A traction on a named boundary, force per deformed area as a function of the point: `[t_x, t_z]`, in torsion `[t_phi, _]`.
pub struct EdgeTraction<'a> {
    /// Name of the boundary.
    pub boundary: String,
    /// The traction; it must be smooth on each edge for the quadrature to be accurate.
    pub traction: BoundaryTraction<'a>,
}

/// A traction as a function of the boundary point.
pub type BoundaryTraction<'a> = Box<dyn Fn(&BoundaryPoint) -> [f64; 2] + Sync + 'a>;

/// Tractions that act together; the interface operator keeps one column a load case.
pub type LoadCase<'a> = Vec<EdgeTraction<'a>>;

/// Everything needed to assemble a cell.
pub(crate) struct Assembly<'a> {
    pub(crate) mesh: &'a Mesh,
    pub(crate) space: &'a Space,
    pub(crate) kinematics: Kinematics,
    /// Materials in units of `unit`.
    pub(crate) materials: Vec<Material>,
    /// Stiffnesses and loads are divided by this power of two.
    pub(crate) unit: f64,
    pub(crate) tables: Vec<Option<Arc<Table>>>,
    pub(crate) triangle_tables: Vec<Option<Arc<TriangleTable>>>,
    /// Tractions by edge.
    pub(crate) edge_loads: Vec<Vec<EdgeLoad<'a>>>,
    pub(crate) load_cases: &'a [LoadCase<'a>],
    /// Rigid rotation about the origin, modal coefficients of each group with prescribed parts, for the moments of reactions.
    pub(crate) rotation: Vec<Vec<[f64; 2]>>,
    /// Number of right-hand-side columns: load cases, one for prescribed displacements, reactions.
    pub(crate) columns: usize,
}

/// Result of assembling one cell.
pub(crate) struct CellElement {
    pub(crate) element: Element,
    /// Parts of the reactions that do not depend on active unknowns, `reactions x columns`.
    pub(crate) constant: Mat<f64>,
    /// Work of body forces on the interior they displace, by load cases.
    pub(crate) interior_work: Option<Mat<f64>>,
}

/// Number of Gauss points a direction for a cell of the given degree; curved maps need a little more than `degree + 1`.
pub(crate) fn points_for(degree: usize) -> usize {
    degree + 2
}

impl Assembly<'_> {
    /// The cell's element on its active groups.
    pub(crate) fn cell(
        &self,
        cell: usize,
        rank: &[usize],
        shared: &SharedMatrices,
        forces: &[BodyForce<'_>],
        work: &mut Workspace,
    ) -> Result<CellElement, Error> {
        let space = self.space;
        let local = space.local_modes(self.mesh, cell);
        let mut load = self.cell_loads(cell, &local);
        let mut interior_work = None;
        if !forces.is_empty() {
            let body = self.body_load(cell, forces, work)?;
            load.extend(body.boundary);
            interior_work = Some(body.work);
        }
        let groups = space.cell_groups(self.mesh, cell, rank);
        let mut start = vec![0; groups.len() + 1];
        for (i, g) in groups.iter().enumerate() {
            start[i + 1] = start[i] + space.size[*g];
        }
        let n = start[groups.len()];
        let mut rhs = Mat::zeros(n, self.columns);
        if let Some(order) = self.plain_order(cell, &local, &groups) {
            let matrix = self.boundary_matrix(cell, &local, &order, shared, work)?;
            if !load.is_empty() {
                let mut place = vec![0; order.len()];
                order.iter().enumerate().for_each(|(i, mode)| place[*mode] = i);
                let components = space.components;
                for ((row, column), value) in &load {
                    rhs[(components * place[row / components] + row % components, *column)] += value;
                }
            }
            let constant = Mat::zeros(self.columns - self.load_cases.len() - 1, self.columns);
            return Ok(CellElement { element: Element { groups, matrix, rhs }, constant, interior_work });
        }
        let order: Vec<usize> = (0..local.modes - local.interior).collect();
        let mut s = self.boundary_matrix(cell, &local, &order, shared, work)?;
        let size = space.components * order.len();
        for j in 0..size {
            for i in j + 1..size {
                s[i * size + j] = s[j * size + i];
            }
        }
        let s = MatRef::from_column_major_slice(&s, size, size);
        let slot = |group: usize| groups.iter().position(|g| *g == group).map(|i| start[i]);
        let mut matrix = vec![0.0; n * n];
        // Rows of the transformation from active unknowns to local ones.
        let targets = self.targets(cell, &local);
        let active = |t: &Target| t.active.iter().filter_map(|(g, i, c)| slot(*g).map(|s| (s + i, *c))).collect();
        let rows: Vec<Vec<(usize, f64)>> = targets.iter().map(active).collect();
        for (j, row) in rows.iter().enumerate() {
            for (tj, cj) in row {
                for (i, row) in rows.iter().enumerate() {
                    for (ti, ci) in row.iter().filter(|(ti, _)| ti >= tj) {
                        matrix[tj * n + ti] += ci * cj * s[(i, j)];
                    }
                }
            }
        }
        for ((row, column), value) in &load {
            for (t, c) in &rows[*row] {
                rhs[(*t, *column)] += c * value;
            }
        }
        let constant = self.supports(&targets, &rows, s, &load, &mut rhs);
        Ok(CellElement { element: Element { groups, matrix, rhs }, constant, interior_work })
    }

    /// The cell's boundary modes in the order of its groups, if no component of any is prescribed, turned or tied to a rigid edge.
    fn plain_order(&self, cell: usize, local: &LocalModes, groups: &[usize]) -> Option<Vec<usize>> {
        let c = &self.mesh.cells[cell];
        let vertices = self.mesh.vertices.len();
        let freedom = &self.space.freedom;
        let plain = |g: usize| freedom[g].is_plain();
        if !(c.corners.iter().all(|v| plain(*v)) && c.sides().all(|(_, e)| plain(vertices + e))) {
            return None;
        }
        let mut order = Vec::with_capacity(local.modes - local.interior);
        for g in groups {
            match g.checked_sub(vertices) {
                None => order.push(c.corners.iter().position(|v| v == g)?),
                Some(edge) => {
                    let e = c.edges.iter().position(|e| *e == Some(edge))?;
                    order.extend(local.edge_start[e] - local.interior..local.edge_start[e + 1] - local.interior);
                }
            }
        }
        Some(order)
    }

    /// Adds the columns of prescribed displacements and reactions; returns the constant parts of the reactions.
    pub(crate) fn supports(
        &self,
        targets: &[Target],
        rows: &[Vec<(usize, f64)>],
        s: MatRef<'_, f64>,
        load: &[((usize, usize), f64)],
        rhs: &mut Mat<f64>,
    ) -> Mat<f64> {
        let prescribed_column = self.load_cases.len();
        let reactions = self.columns - prescribed_column - 1;
        let mut constant = Mat::zeros(reactions, self.columns);
        if targets.iter().all(|t| t.fixed.is_empty()) {
            return constant;
        }
        let nb = targets.len();
        let prescribed: Vec<f64> = targets.iter().map(|t| t.fixed.iter().map(|f| f.share * f.value).sum()).collect();
        // Virtual displacements of the local unknowns, one vector a reaction.
        let mut virtual_motion = vec![vec![0.0; nb]; reactions];
        for (i, target) in targets.iter().enumerate() {
            for fixed in &target.fixed {
                let vertex = fixed.group < self.mesh.vertices.len();
                let unit = f64::from(u8::from(vertex));
                let rotation = self.rotation[fixed.group].get(fixed.mode).copied().unwrap_or_default();
                for (k, motion) in [[unit, 0.0], [0.0, unit], rotation].iter().enumerate() {
                    let along = fixed.axis[0] * motion[0] + fixed.axis[1] * motion[1];
                    if let Some(v) = virtual_motion.get_mut(3 * fixed.support + k) {
                        v[i] += fixed.share * along;
                    }
                }
            }
        }
        let times = |v: &[f64]| -> Vec<f64> {
            let mut out = vec![0.0; nb];
            for j in (0..nb).filter(|j| v[*j] != 0.0) {
                for (i, o) in out.iter_mut().enumerate() {
                    *o += s[(i, j)] * v[j];
                }
            }
            out
        };
        let of_prescribed = times(&prescribed);
        for (row, value) in rows.iter().zip(&of_prescribed) {
            for (t, c) in row {
                rhs[(*t, prescribed_column)] -= c * value;
            }
        }
        for (r, motion) in virtual_motion.iter().enumerate() {
            let column = prescribed_column + 1 + r;
            for (row, value) in rows.iter().zip(times(motion)) {
                for (t, c) in row {
                    rhs[(*t, column)] += c * value;
                }
            }
            constant[(r, prescribed_column)] += motion.iter().zip(&of_prescribed).map(|(a, b)| a * b).sum::<f64>();
            for ((row, column), value) in load {
                constant[(r, *column)] -= motion[*row] * value;
            }
        }
        constant
    }

    /// Targets of the cell's local boundary unknowns, components fastest.
    pub(crate) fn targets(&self, cell: usize, local: &LocalModes) -> Vec<Target> {
        let c = &self.mesh.cells[cell];
        let mut targets = Vec::new();
        let mut push = |group, mode| {
            (0..self.space.components).for_each(|k| targets.push(self.space.target(self.mesh, group, mode, k)));
        };
        c.vertices().iter().for_each(|v| push(*v, 0));
        for (local_edge, edge) in c.sides() {
            let modes = local.edge_start[local_edge + 1] - local.edge_start[local_edge];
            (0..modes).for_each(|m| push(self.mesh.vertices.len() + edge, m));
        }
        targets
    }

    /// Interior unknowns of a cell from its boundary unknowns: `u_i = -K_ii^-1 K_ib u_b`, followed by the boundary unknowns.
    pub(crate) fn recover(&self, cell: usize, boundary: &[f64], work: &mut Workspace) -> Result<Vec<f64>, Error> {
        let local = self.space.local_modes(self.mesh, cell);
        let components = self.space.components;
        let (k, ni) = self.condensed(cell, &local, work)?;
        // From the order of unknowns to that of the matrix: unsigned, one component after the other.
        let modes = boundary.len() / components;
        let mut sign = vec![1.0; local.modes];
        local.position.iter().zip(&local.sign).filter(|(p, _)| **p != usize::MAX).for_each(|(p, s)| sign[*p] = *s);
        let unsigned = |row: usize| sign[local.interior + row % modes] * boundary[components * (row % modes) + row / modes];
        let mut x = Mat::zeros(ni, 1);
        let known = Mat::from_fn(boundary.len(), 1, |row, _| unsigned(row));
        let (l11, l21) = k.as_ref().subcols(0, ni).split_at_row(ni);
        matmul(x.as_mut(), Accum::Replace, l21.transpose(), known.as_ref(), -1.0, Par::Seq);
        solve_upper_triangular_in_place(l11.transpose(), x.as_mut(), Par::Seq);
        let interior = (0..ni).map(|i| x[((i % components) * local.interior + i / components, 0)]);
        Ok(interior.chain(boundary.iter().copied()).collect())
    }
}

/// The boundary point of a curve at `t` and the length factor `|dx/dt|`; `clockwise` tells that the curve has the body on its right.
pub(crate) fn boundary_point(curve: &Curve, t: f64, clockwise: bool) -> (BoundaryPoint, f64) {
    let d = curve.derivative(t);
    let length = d[0].hypot(d[1]);
    let sign = if clockwise { -1.0 } else { 1.0 };
    let tangent = [sign * d[0] / length, sign * d[1] / length];
    (BoundaryPoint { position: curve.point(t), outward: [tangent[1], -tangent[0]], tangent }, length)
}

/// Coefficients of the modes 2.. of a field on an edge, interpolated at Lobatto points, in the edge's own parameter.
pub(crate) fn edge_modes(curve: &Curve, degree: usize, field: impl Fn([f64; 2]) -> [f64; 2]) -> Vec<[f64; 2]> {
    if degree < 2 {
        return Vec::new();
    }
    let nodes = gauss_lobatto(degree + 1).points;
    let barycentric = barycentric_weights(&nodes);
    let values: Vec<[f64; 2]> = nodes.iter().map(|t| field(curve.point(*t))).collect();
    // The N_k' are orthonormal, so the coefficient of N_k is int f' N_k'. The rule has no point in common with the nodes.
    let rule = gauss(degree + 2);
    let mut modes = vec![[0.0; 2]; degree - 1];
    for (t, w) in rule.points.iter().zip(&rule.weights) {
        let here = lagrange(&nodes, &barycentric, *t);
        let terms: Vec<f64> = nodes.iter().zip(&barycentric).map(|(x, b)| b / (t - x)).collect();
        let total: f64 = terms.iter().sum();
        let slope: [f64; 2] = std::array::from_fn(|k| {
            let f: f64 = here.iter().zip(&values).map(|(l, v)| l * v[k]).sum();
            (0..nodes.len()).map(|i| terms[i] * (f - values[i][k]) / (t - nodes[i])).sum::<f64>() / total
        });
        for (mode, shape) in modes.iter_mut().zip(&shape_functions(degree, *t).1[2..]) {
            mode[0] += w * shape * slope[0];
            mode[1] += w * shape * slope[1];
        }
    }
    modes
}

/// Rigid rotation about the origin.
pub(crate) fn rotation_about_origin(x: [f64; 2]) -> [f64; 2] {
    rigid_rows(x, [0.0, 0.0])[2]
}
