//! Cells with loads or supports as elements of the elimination: their matrix on the active unknowns of groups, with right-hand sides
//! and reactions.

use crate::assembly::Assembly;
use crate::cell_matrix::SharedMatrices;
use crate::element::Workspace;
use crate::error::Error;
use crate::on_boundary::OnBoundary;
use crate::space::Target;
use faer::{Mat, MatRef};

/// An element of the elimination that has loads or supports, or is a foundation.
pub(crate) struct OwnElement {
    /// Lower triangle on the element's groups, columns one after the other.
    pub(crate) matrix: Vec<f64>,
    /// Parts of the reactions that do not depend on active unknowns, `reactions x columns`; `None` without prescribed parts.
    pub(crate) constant: Option<Mat<f64>>,
    /// Work of loads inside on the interior they displace, by load cases.
    pub(crate) interior_work: Option<Mat<f64>>,
}

/// A symmetric matrix on local unknowns, with what these hang on.
pub(crate) struct LocalMatrix<'m> {
    /// The matrix, both triangles.
    pub(crate) matrix: MatRef<'m, f64>,
    /// One target a row.
    pub(crate) targets: &'m [Target],
    /// Loads: `((row, column), value)`.
    pub(crate) load: &'m [((usize, usize), f64)],
}

impl Assembly<'_> {
    /// The cell's element on its groups, sorted by rank; `None` if it is that of its class: without loads, and with unknowns that are
    /// neither prescribed nor turned nor tied to a rigid edge.
    pub(crate) fn own_element(
        &self,
        cell: usize,
        groups: &[usize],
        shared: &SharedMatrices,
        work: &mut Workspace,
    ) -> Result<Option<OwnElement>, Error> {
        let c = &self.mesh.cells[cell];
        let plain = |g: usize| self.space.freedom[g].is_plain();
        let all_plain = c.corners.iter().all(|v| plain(*v)) && c.sides().all(|(_, e)| plain(self.mesh.vertices.len() + e));
        if all_plain && groups.last() != Some(&self.columns_group()) {
            return Ok(None);
        }
        let modes = self.space.boundary_modes(self.mesh, cell);
        let mut load = self.cell_loads(cell, &modes);
        let mut interior_work = None;
        if self.loads.inside(cell) {
            interior_work = Some(match shared.loads.get(cell).and_then(Option::as_ref) {
                Some(OnBoundary { boundary, work, .. }) => {
                    load.extend_from_slice(boundary);
                    work.clone()
                }
                None => {
                    let inner = self.inner_load(cell, work)?;
                    load.extend(inner.boundary);
                    inner.work
                }
            });
        }
        let mut s = Vec::new();
        self.boundary_matrix(cell, &(0..modes.len()).collect::<Vec<_>>(), shared, &mut s);
        let size = self.space.components * modes.len();
        for j in 0..size {
            for i in j + 1..size {
                s[i * size + j] = s[j * size + i];
            }
        }
        let s = MatRef::from_column_major_slice(&s, size, size);
        let local = LocalMatrix { matrix: s, targets: &self.targets(cell, &modes), load: &load };
        let (matrix, constant) = self.on_groups(&local, groups);
        Ok(Some(OwnElement { matrix, constant, interior_work }))
    }

    /// The lower triangle of a matrix of local unknowns on the active unknowns of the groups, with the right-hand sides as last rows if the
    /// groups end with theirs, and the constant parts of the reactions.
    pub(crate) fn on_groups(&self, local: &LocalMatrix<'_>, groups: &[usize]) -> (Vec<f64>, Option<Mat<f64>>) {
        let LocalMatrix { matrix: s, targets, load } = *local;
        let has_columns = groups.last() == Some(&self.columns_group());
        let groups = &groups[..groups.len() - usize::from(has_columns)];
        let mut start = vec![0; groups.len() + 1];
        for (i, g) in groups.iter().enumerate() {
            start[i + 1] = start[i] + self.space.size[*g];
        }
        let active = start[groups.len()];
        let n = active + if has_columns { self.columns } else { 0 };
        let mut matrix = vec![0.0; n * n];
        let slot = |group: usize| groups.iter().position(|g| *g == group).map(|i| start[i]);
        // Rows of the transformation from active unknowns to local ones.
        let row = |t: &Target| t.active.iter().filter_map(|(g, i, c)| slot(*g).map(|s| (s + i, *c))).collect();
        let rows: Vec<Vec<(usize, f64)>> = targets.iter().map(row).collect();
        if let Some(local) = one_to_one(&rows, active) {
            for (j, from) in local.iter().enumerate() {
                let column = s.col(*from);
                matrix[j * n + j..j * n + active].iter_mut().zip(&local[j..]).for_each(|(m, i)| *m = column[*i]);
            }
        } else {
            for (j, row) in rows.iter().enumerate() {
                for (tj, cj) in row {
                    for (i, row) in rows.iter().enumerate() {
                        for (ti, ci) in row.iter().filter(|(ti, _)| ti >= tj) {
                            matrix[tj * n + ti] += ci * cj * s[(i, j)];
                        }
                    }
                }
            }
        }
        if !has_columns {
            return (matrix, None);
        }
        let mut rhs = Mat::zeros(active, self.columns);
        for ((row, column), value) in load {
            rows[*row].iter().for_each(|(t, c)| rhs[(*t, *column)] += c * value);
        }
        let constant = self.supports(local, &rows, &mut rhs);
        for i in 0..active {
            (0..self.columns).for_each(|k| matrix[i * n + active + k] = rhs[(i, k)]);
        }
        (matrix, constant)
    }

    /// Adds the columns of prescribed displacements and reactions; returns the constant parts of the reactions.
    fn supports(&self, local: &LocalMatrix<'_>, rows: &[Vec<(usize, f64)>], rhs: &mut Mat<f64>) -> Option<Mat<f64>> {
        let LocalMatrix { matrix: s, targets, load } = *local;
        let prescribed_column = self.loads.cases;
        let reactions = self.columns - prescribed_column - 1;
        if targets.iter().all(|t| t.fixed.is_empty()) {
            return None;
        }
        let mut constant = Mat::zeros(reactions, self.columns);
        let nb = targets.len();
        let prescribed: Vec<f64> = targets.iter().map(|t| t.fixed.iter().map(|f| f.share * f.value).sum()).collect();
        let virtual_motion = self.virtual_motion(targets, reactions);
        let times = |v: &[f64]| -> Vec<f64> {
            let mut out = vec![0.0; nb];
            for (j, factor) in v.iter().enumerate().filter(|(_, factor)| **factor != 0.0) {
                let column = s.col(j);
                out.iter_mut().zip(column.iter()).for_each(|(o, s)| *o += s * factor);
            }
            out
        };
        let of_prescribed = times(&prescribed);
        let mut add = |column: usize, sign: f64, forces: &[f64]| {
            for (row, value) in rows.iter().zip(forces) {
                row.iter().for_each(|(t, c)| rhs[(*t, column)] += sign * c * value);
            }
        };
        add(prescribed_column, -1.0, &of_prescribed);
        for (r, motion) in virtual_motion.iter().enumerate().filter(|(_, motion)| !motion.is_empty()) {
            add(prescribed_column + 1 + r, 1.0, &times(motion));
            constant[(r, prescribed_column)] += motion.iter().zip(&of_prescribed).map(|(a, b)| a * b).sum::<f64>();
            for ((row, column), value) in load {
                constant[(r, *column)] -= motion[*row] * value;
            }
        }
        Some(constant)
    }
}

impl Assembly<'_> {
    /// Virtual displacements of local unknowns, one vector a reaction, empty where the reaction does not touch them.
    pub(crate) fn virtual_motion(&self, targets: &[Target], reactions: usize) -> Vec<Vec<f64>> {
        let mut virtual_motion = vec![Vec::new(); reactions];
        for (i, target) in targets.iter().enumerate() {
            for fixed in &target.fixed {
                let vertex = fixed.group < self.mesh.vertices.len();
                let unit = f64::from(u8::from(vertex));
                let rotation = self.rotation[fixed.group].get(fixed.mode).copied().unwrap_or_default();
                for (k, motion) in [[unit, 0.0], [0.0, unit], rotation].iter().enumerate() {
                    let along = fixed.axis[0] * motion[0] + fixed.axis[1] * motion[1];
                    if let Some(v) = virtual_motion.get_mut(3 * fixed.support + k).filter(|_| along != 0.0) {
                        v.resize(targets.len(), 0.0);
                        v[i] += fixed.share * along;
                    }
                }
            }
        }
        virtual_motion
    }
}

/// The local unknown of every active one, if each is exactly one local one.
fn one_to_one(rows: &[Vec<(usize, f64)>], active: usize) -> Option<Vec<usize>> {
    let mut local = vec![usize::MAX; active];
    for (i, row) in rows.iter().enumerate().filter(|(_, row)| !row.is_empty()) {
        match row[..] {
            [(t, 1.0)] if local[t] == usize::MAX => local[t] = i,
            _ => return None,
        }
    }
    local.iter().all(|i| *i != usize::MAX).then_some(local)
}
