//! The stiffness of a cell on its boundary modes, the interior being condensed; similar cells share it.

use crate::assembly::Assembly;
use crate::basis::{LocalModes, Table};
use crate::congruence::{Class, Congruence, Turn};
use crate::dense::factor_leading;
use crate::element::{CellForm, Workspace, matrix_in, stiffness};
use crate::error::Error;
use crate::interiors::{Interiors, from_boundary};
use crate::on_boundary::{OnBoundary, by_cell};
use crate::triangle_matrix::triangle_stiffness;
use faer::linalg::matmul::matmul;
use faer::linalg::triangular_solve::solve_upper_triangular_in_place;
use faer::{Accum, Mat, MatMut, Par};

/// Condensed matrices of the classes of similar cells.
pub(crate) struct SharedMatrices {
    pub(crate) congruence: Congruence,
    /// Both triangles, columns one after the other, boundary modes of one component after those of the other; empty once no cell needs it.
    pub(crate) matrices: Vec<Vec<f64>>,
    /// What loads inside quadrilaterals do to their boundaries, by cell; empty where no cell has any.
    pub(crate) loads: Vec<Option<OnBoundary>>,
}

/// The elements of the elimination: those of cells and foundations with loads or supports, and for all other cells the matrix of their
/// class, turned when a front asks for it.
pub(crate) struct Elements<'a> {
    assembly: &'a Assembly<'a>,
    /// Groups of each element, sorted by rank.
    pub(crate) groups: &'a [Vec<usize>],
    shared: SharedMatrices,
    /// Lower triangles, columns one after the other.
    own: Vec<Option<Vec<f64>>>,
    /// Number of cells that still need the matrix of a class.
    waiting: Vec<usize>,
}

impl<'a> Elements<'a> {
    pub(crate) fn new(
        assembly: &'a Assembly<'a>,
        groups: &'a [Vec<usize>],
        shared: SharedMatrices,
        own: Vec<Option<Vec<f64>>>,
    ) -> Elements<'a> {
        let mut elements = Elements { assembly, groups, waiting: vec![0; shared.matrices.len()], shared, own };
        let class = &elements.shared.congruence.class;
        for (cell, _) in elements.own.iter().enumerate().filter(|(_, own)| own.is_none()) {
            elements.waiting[class[cell]] += 1;
        }
        for (matrix, _) in elements.shared.matrices.iter_mut().zip(&elements.waiting).filter(|(_, waiting)| **waiting == 0) {
            *matrix = Vec::new();
        }
        elements
    }

    /// The lower triangle of an element, columns one after the other.
    pub(crate) fn matrix<'b>(&'b self, element: usize, buffer: &'b mut Vec<f64>) -> &'b [f64] {
        if let Some(matrix) = &self.own[element] {
            return matrix;
        }
        let order = self.assembly.order(element, &self.groups[element]);
        self.assembly.boundary_matrix(element, &order, &self.shared, buffer);
        buffer
    }

    /// Gives back the memory of an element that is not needed any more.
    pub(crate) fn release(&mut self, element: usize) {
        if self.own[element].take().is_none() {
            let class = self.shared.congruence.class[element];
            self.waiting[class] -= 1;
            if self.waiting[class] == 0 {
                self.shared.matrices[class] = Vec::new();
            }
        }
    }
}

/// Applies `task` to `0..count`, in parallel with the `rayon` feature; results come in order either way.
pub(crate) fn map_cells<T: Send>(count: usize, task: impl Fn(&mut Workspace, usize) -> T + Sync + Send) -> Vec<T> {
    #[cfg(all(feature = "rayon", not(target_family = "wasm")))]
    if rayon::current_num_threads() > 1 {
        use rayon::prelude::*;
        return (0..count).into_par_iter().map_init(Workspace::default, task).collect();
    }
    let mut work = Workspace::default();
    (0..count).map(|i| task(&mut work, i)).collect()
}

impl Assembly<'_> {
    /// Condensed matrices of all classes, and how their interiors follow from their boundaries where that is to be kept.
    pub(crate) fn shared_matrices(
        &self,
        congruence: Congruence,
        keep: bool,
    ) -> Result<(SharedMatrices, Option<Interiors>), Error> {
        let loaded = self.loaded(&congruence);
        let made = map_cells(congruence.classes.len(), |work, k| {
            let (class, local) = (&congruence.classes[k], self.class_modes(&congruence.classes[k]));
            let (matrix, ni) = self.condensed(class.first, &local, work)?;
            let inside = keep.then(|| from_boundary(matrix.as_ref(), ni));
            let loads = self.loads_of(loaded.get(k), &local, (matrix.as_ref(), ni));
            Ok((boundary_block(matrix, ni), (inside, loads)))
        });
        let made: Result<Vec<_>, Error> = made.into_iter().collect();
        let (matrices, (inside, loads)): (Vec<_>, (Vec<_>, Vec<_>)) = made?.into_iter().unzip();
        let interiors = keep.then(|| Interiors::new(&congruence, inside.into_iter().flatten().collect()));
        Ok((SharedMatrices { congruence, matrices, loads: by_cell(self.mesh, loads) }, interiors))
    }

    pub(crate) fn class_modes(&self, class: &Class) -> LocalModes {
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
        self.whole_stiffness(cell, local, work)?;
        let ni = self.space.components * local.interior;
        let n = self.space.components * local.modes;
        factor_leading(&mut work.matrix[..n * n], n, ni)
            .map_err(|_| Error::NoStiffness { place: format!("the interior of cell {cell}") })?;
        Ok((matrix_in(&mut work.matrix, n, n), ni))
    }

    /// Fills the lower triangle of a cell's stiffness on its unsigned modes into the workspace.
    pub(crate) fn whole_stiffness(&self, cell: usize, local: &LocalModes, work: &mut Workspace) -> Result<(), Error> {
        let degree = self.space.cell_degree[cell];
        let moduli = self.moduli[self.mesh.cells[cell].material];
        let form = CellForm { mesh: self.mesh, cell, local, moduli, kinematics: self.kinematics };
        if self.mesh.cells[cell].is_triangle() {
            let table = self.triangle_tables[degree].as_ref().ok_or(Error::Degree { cell, degree })?;
            triangle_stiffness(&form, table, work)?;
        } else {
            stiffness(&form, Table::of(degree), work)?;
        }
        Ok(())
    }

    /// Interior unknowns of a cell from its boundary unknowns: `u_i = -K_ii^-1 K_ib u_b`, followed by the boundary unknowns.
    /// `kept` has how those of some cells follow.
    pub(crate) fn recover(
        &self,
        (cell, kept): (usize, Option<&Interiors>),
        boundaries: &[Vec<f64>],
        work: &mut Workspace,
    ) -> Result<Vec<Vec<f64>>, Error> {
        let local = self.space.local_modes(self.mesh, cell);
        let components = self.space.components;
        let ni = components * local.interior;
        let edges = self.space.edge_degrees(self.mesh, cell);
        // From the order of unknowns to that of the matrix: unsigned, one component after the other.
        let rows = boundaries.first().map_or(0, Vec::len);
        let modes = rows / components;
        let sign = local.signs();
        let unsigned =
            |row: usize, j: usize| sign[local.interior + row % modes] * boundaries[j][components * (row % modes) + row / modes];
        let mut x = Mat::zeros(ni, boundaries.len());
        let known = Mat::from_fn(rows, boundaries.len(), unsigned);
        if let Some(inside) = kept.and_then(|kept| kept.of(cell, edges)) {
            matmul(x.as_mut(), Accum::Replace, inside.as_ref(), known.as_ref(), 1.0, Par::Seq);
        } else {
            let (k, ni) = self.condensed(cell, &local, work)?;
            let (l11, l21) = k.as_ref().subcols(0, ni).split_at_row(ni);
            matmul(x.as_mut(), Accum::Replace, l21.transpose(), known.as_ref(), -1.0, Par::Seq);
            solve_upper_triangular_in_place(l11.transpose(), x.as_mut(), Par::Seq);
        }
        let row = |i: usize| (i % components) * local.interior + i / components;
        let mut cells = Vec::with_capacity(boundaries.len());
        for (j, boundary) in boundaries.iter().enumerate() {
            cells.push((0..ni).map(|i| x[(row(i), j)]).chain(boundary.iter().copied()).collect());
        }
        Ok(cells)
    }

    /// Boundary modes of a cell in the order of its groups; groups that are no corner or edge of it are left out.
    pub(crate) fn order(&self, cell: usize, groups: &[usize]) -> Vec<usize> {
        let c = &self.mesh.cells[cell];
        let vertices = self.mesh.vertices.len();
        let boundary = self.space.boundary_modes(self.mesh, cell);
        let mut order = Vec::with_capacity(boundary.len());
        for g in groups {
            match g.checked_sub(vertices) {
                None => order.extend(c.vertices().iter().position(|v| v == g)),
                Some(edge) => {
                    order.extend(c.sides().filter(|(_, e)| *e == edge).flat_map(|(local, _)| boundary.edge(local)));
                }
            }
        }
        order
    }

    /// Condensed stiffness of a cell on its boundary modes in the given order (corners come first), displacement components running
    /// fastest: the lower triangle, columns one after the other.
    pub(crate) fn boundary_matrix(&self, cell: usize, order: &[usize], shared: &SharedMatrices, out: &mut Vec<f64>) {
        let number = shared.congruence.class[cell];
        let (class, turn) = (&shared.congruence.classes[number], &shared.congruence.turn[cell]);
        let boundary = self.space.boundary_modes(self.mesh, cell);
        let sources = turn.sources(&boundary, self.mesh.cells[cell].against, class.edges);
        let sources: Vec<(usize, f64)> = order.iter().map(|mode| sources[*mode]).collect();
        turned(&shared.matrices[number], &sources, turn, self.space.components, out);
    }
}

/// The trailing block of a condensed matrix, its upper triangle filled from the lower one.
pub(crate) fn boundary_block(k: MatMut<'_, f64>, ni: usize) -> Vec<f64> {
    let n = k.nrows() - ni;
    let mut block = vec![0.0; n * n];
    for j in 0..n {
        for i in j..n {
            let value = k[(ni + i, ni + j)];
            block[j * n + i] = value;
            block[i * n + j] = value;
        }
    }
    block
}

/// The lower triangle of the matrix on the unknowns of a cell, displacement components running fastest.
fn turned(matrix: &[f64], sources: &[(usize, f64)], turn: &Turn, components: usize, out: &mut Vec<f64>) {
    let rows = matrix.len().isqrt();
    let size = components * sources.len();
    out.resize(size * size, 0.0);
    let column = |j: usize| &matrix[j * rows..(j + 1) * rows];
    if components == 1 {
        for (j, (from, sign)) in sources.iter().enumerate() {
            let source = column(*from);
            for (value, (i, other)) in out[j * size + j..(j + 1) * size].iter_mut().zip(&sources[j..]) {
                *value = sign * other * source[*i];
            }
        }
        return;
    }
    let [[a, b], [c, d]] = turn.matrix;
    let n = rows / 2;
    let turned = turn.matrix != Turn::NONE.matrix;
    for (j, (from, sign)) in sources.iter().enumerate() {
        let ((xx, zx), (xz, zz)) = (column(*from).split_at(n), column(n + from).split_at(n));
        let (first, second) = out[2 * j * size..2 * (j + 1) * size].split_at_mut(size);
        let pairs = first[2 * j..].chunks_exact_mut(2).zip(second[2 * j..].chunks_exact_mut(2));
        for ((first, second), (i, other)) in pairs.zip(&sources[j..]) {
            let f = sign * other;
            if !turned {
                [first[0], first[1], second[0], second[1]] = [xx[*i], zx[*i], xz[*i], zz[*i]].map(|k| f * k);
                continue;
            }
            // T B T^T with the 2 x 2 block B of a pair of modes.
            let (t00, t01) = (a * xx[*i] + b * zx[*i], a * xz[*i] + b * zz[*i]);
            let (t10, t11) = (c * xx[*i] + d * zx[*i], c * xz[*i] + d * zz[*i]);
            first[0] = f * (t00 * a + t01 * b);
            first[1] = f * (t10 * a + t11 * b);
            second[0] = f * (t00 * c + t01 * d);
            second[1] = f * (t10 * c + t11 * d);
        }
    }
}
