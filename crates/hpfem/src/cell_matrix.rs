//! The stiffness of a cell on its boundary modes, the interior being condensed; similar cells share it.

use crate::assemble::Assembly;
use crate::basis::LocalModes;
use crate::congruence::{Class, Congruence, Turn};
use crate::element::{Workspace, stiffness};
use crate::elimination::{factor_leading, not_held};
use crate::error::Error;
use crate::triangle_matrix::triangle_stiffness;
use faer::prelude::IntoConst;
use faer::{Mat, MatMut, MatRef};

/// Condensed matrices of the classes with several cells.
pub(crate) struct SharedMatrices {
    congruence: Congruence,
    /// Both triangles; `None` for a class of one cell.
    matrices: Vec<Option<Mat<f64>>>,
}

/// Applies `task` to `0..count`, in parallel with the `rayon` feature; results come in order either way.
pub(crate) fn map_cells<T: Send>(count: usize, task: impl Fn(&mut Workspace, usize) -> T + Sync + Send) -> Vec<T> {
    #[cfg(feature = "rayon")]
    if rayon::current_num_threads() > 1 {
        use rayon::prelude::*;
        return (0..count).into_par_iter().map_init(Workspace::default, task).collect();
    }
    let mut work = Workspace::default();
    (0..count).map(|i| task(&mut work, i)).collect()
}

impl Assembly<'_> {
    /// Condensed matrices that serve several cells. In axisymmetry and torsion the radius tells cells apart, so there are none.
    pub(crate) fn shared_matrices(&self) -> Result<SharedMatrices, Error> {
        let congruence = if self.kinematics.is_revolved() {
            Congruence::none(self.mesh, self.space)
        } else {
            Congruence::of_plane_cells(self.mesh, self.space)
        };
        let matrices = map_cells(congruence.classes.len(), |work, k| {
            let class = &congruence.classes[k];
            if class.members == 1 {
                return Ok(None);
            }
            let (k, ni) = self.condensed(class.first, &self.class_modes(class), work)?;
            Ok(Some(boundary_block(k, ni).to_owned()))
        });
        let matrices = matrices.into_iter().collect::<Result<_, _>>()?;
        Ok(SharedMatrices { congruence, matrices })
    }

    fn class_modes(&self, class: &Class) -> LocalModes {
        self.space.modes_of(self.mesh, class.first, class.edges, [false; 4])
    }

    /// Stiffness of a cell on its unsigned modes after elimination of the interior, and the number of interior unknowns. The first
    /// columns hold the factor.
    pub(crate) fn condensed<'w>(
        &self,
        cell: usize,
        local: &LocalModes,
        work: &'w mut Workspace,
    ) -> Result<(MatMut<'w, f64>, usize), Error> {
        let degree = self.space.cell_degree[cell];
        let moduli = self.materials[self.mesh.cells[cell].material].moduli(self.kinematics);
        let triangle = self.mesh.cells[cell].is_triangle();
        let mut k = match (&self.tables[degree], &self.triangle_tables[degree]) {
            (Some(table), _) if !triangle => stiffness(self.mesh, cell, table, local, moduli, self.kinematics, work)?,
            (_, Some(table)) if triangle => triangle_stiffness(self.mesh, cell, table, local, moduli, self.kinematics, work)?,
            _ => return Err(Error::Degree { cell, degree }),
        };
        let ni = self.space.components * local.interior;
        factor_leading(k.as_mut(), ni).map_err(|_| not_held(format!("the interior of cell {cell}")))?;
        Ok((k, ni))
    }

    /// Condensed stiffness of a cell on its boundary modes in the given order (corners are 0..4), displacement components running fastest:
    /// the lower triangle, columns one after the other.
    pub(crate) fn boundary_matrix(
        &self,
        cell: usize,
        local: &LocalModes,
        order: &[usize],
        shared: &SharedMatrices,
        work: &mut Workspace,
    ) -> Result<Vec<f64>, Error> {
        let number = shared.congruence.class[cell];
        let class = &shared.congruence.classes[number];
        let turn = &shared.congruence.turn[cell];
        let sources = sources(local, self.mesh.cells[cell].against, class.edges, turn);
        let sources: Vec<(usize, f64)> = order.iter().map(|mode| sources[*mode]).collect();
        if let Some(matrix) = &shared.matrices[number] {
            return Ok(turned(matrix.as_ref(), &sources, turn, self.space.components));
        }
        let (k, ni) = self.condensed(cell, &self.class_modes(class), work)?;
        Ok(turned(boundary_block(k, ni), &sources, turn, self.space.components))
    }
}

/// The trailing block of a condensed matrix, its upper triangle filled from the lower one.
fn boundary_block(k: MatMut<'_, f64>, ni: usize) -> MatRef<'_, f64> {
    let n = k.nrows() - ni;
    let mut s = k.submatrix_mut(ni, ni, n, n);
    for j in 0..n {
        for i in j + 1..n {
            s[(j, i)] = s[(i, j)];
        }
    }
    s.into_const()
}

/// For each boundary mode of a cell, corners first, the place of its mode in the matrix of the class, and its sign.
fn sources(local: &LocalModes, against: [bool; 4], edges: [usize; 4], turn: &Turn) -> Vec<(usize, f64)> {
    let mut sources = vec![(0, 1.0); local.modes - local.interior];
    let mut start = local.corners;
    for i in 0..4 {
        if i < local.corners {
            sources[turn.corner[i]].0 = i;
        }
        let (e, reversed) = turn.edge[i];
        let own = local.edge_start[e] - local.interior..local.edge_start[e + 1] - local.interior;
        for (m, source) in sources[own].iter_mut().enumerate() {
            let odd = m % 2 == 1;
            *source = (start + m, if odd && reversed != against[e] { -1.0 } else { 1.0 });
        }
        start += edges[i] - 1;
    }
    sources
}

/// The lower triangle of the matrix on the unknowns of a cell, displacement components running fastest.
fn turned(s: MatRef<'_, f64>, sources: &[(usize, f64)], turn: &Turn, components: usize) -> Vec<f64> {
    let n = s.nrows() / components;
    let size = components * sources.len();
    let [[a, b], [c, d]] = turn.matrix;
    let mut out = vec![0.0; size * size];
    let column = |j: usize| s.col(j).try_as_col_major().map_or(&[][..], |c| c.as_slice());
    for (j, (from, sign)) in sources.iter().enumerate() {
        if components == 1 {
            let source = column(*from);
            for (value, (i, other)) in out[j * size + j..(j + 1) * size].iter_mut().zip(&sources[j..]) {
                *value = sign * other * source[*i];
            }
            continue;
        }
        let ((xx, zx), (xz, zz)) = (column(*from).split_at(n), column(n + from).split_at(n));
        let (first, second) = out[2 * j * size..2 * (j + 1) * size].split_at_mut(size);
        let pairs = first[2 * j..].chunks_exact_mut(2).zip(second[2 * j..].chunks_exact_mut(2));
        for ((first, second), (i, other)) in pairs.zip(&sources[j..]) {
            let f = sign * other;
            // T B T^T with the 2 x 2 block B of a pair of modes.
            let (t00, t01) = (a * xx[*i] + b * zx[*i], a * xz[*i] + b * zz[*i]);
            let (t10, t11) = (c * xx[*i] + d * zx[*i], c * xz[*i] + d * zz[*i]);
            first[0] = f * (t00 * a + t01 * b);
            first[1] = f * (t10 * a + t11 * b);
            second[0] = f * (t00 * c + t01 * d);
            second[1] = f * (t10 * c + t11 * d);
        }
    }
    out
}
