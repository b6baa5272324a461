//! The whole body as sparse matrices, for solvers of one's own.

use crate::assembly::Assembly;
use crate::basis::{LocalModes, points_for};
use crate::body::Body;
use crate::cell_matrix::map_cells;
use crate::cell_point::{CellPoint, cell_rule};
use crate::check::check;
use crate::edge_load::Loads;
use crate::element::{Workspace, matrix_in, row_of};
use crate::error::Error;
use crate::field::{Field, FieldParts};
use crate::problem::BodyProblem;
use crate::space::{Space, Target};
use faer::Mat;
use faer::linalg::matmul::matmul;
use faer::sparse::{SparseColMat, Triplet};
use faer::{Accum, Par};

/// All unknowns of a body with its matrices, nothing eliminated: `K u = F a + f_0`, factors `a` of the load cases, `f_0` from prescribed displacements.
///
/// Unknowns are the hierarchic coefficients of vertices, then edges, then the rigid edge, then the interiors cell by cell, as far as they
/// are free, components running fastest; mm, rad for a rotation.
pub struct SparseBody {
    problem: BodyProblem,
    space: Space,
    /// First unknown of every group.
    start: Vec<usize>,
    /// First unknown inside every cell, then the number of all.
    inner_start: Vec<usize>,
}

/// The matrices of one cell.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Element {
    /// What each local row hangs on, `(unknown, coefficient)`; empty where it is prescribed.
    pub unknowns: Vec<Vec<(usize, f64)>>,
    /// The prescribed part of each local row, mm.
    pub prescribed: Vec<f64>,
    /// Stiffness on the local rows, N/mm, both triangles. Rows: interior modes, corners, edges 0 to 3 from mode 2 on, components
    /// running fastest.
    pub stiffness: Mat<f64>,
    /// Loads on the local rows, N, `rows x load cases`.
    pub loads: Mat<f64>,
}

impl SparseBody {
    /// Numbers the unknowns of a problem. Kept boundaries do not count.
    ///
    /// # Errors
    /// As for [`Body::new`], but a body that floats is taken.
    pub fn new(problem: BodyProblem) -> Result<SparseBody, Error> {
        check(&problem)?;
        let space = Space::new(&problem)?;
        let (mut start, mut inner_start, mut next) = (Vec::new(), Vec::new(), 0);
        for size in &space.size {
            start.push(next);
            next += size;
        }
        for cell in 0..problem.mesh.cells.len() {
            inner_start.push(next);
            next += space.components * space.local_modes(&problem.mesh, cell).interior;
        }
        inner_start.push(next);
        Ok(SparseBody { problem, space, start, inner_start })
    }

    /// The problem.
    pub fn problem(&self) -> &BodyProblem {
        &self.problem
    }

    /// Number of unknowns.
    pub fn unknowns(&self) -> usize {
        self.inner_start.last().copied().unwrap_or(0)
    }

    /// The matrices of a cell.
    ///
    /// # Errors
    /// [`Error::Beyond`] beyond the cells; a folded cell; boundaries of loads that do not exist.
    pub fn element(&self, cell: usize) -> Result<Element, Error> {
        let count = self.problem.mesh.cells.len();
        if cell >= count {
            return Err(Error::Beyond { by: "a call of `element`".into(), what: "cell", index: cell, count });
        }
        self.element_of(&self.assembly()?, cell, &mut Workspace::default())
    }

    fn assembly(&self) -> Result<Assembly<'_>, Error> {
        let loads = Loads::new(&self.problem.mesh, &self.problem.load_cases)?;
        Ok(Assembly::new(&self.problem, &self.space, loads))
    }

    fn element_of(&self, assembly: &Assembly<'_>, cell: usize, work: &mut Workspace) -> Result<Element, Error> {
        let local = self.space.local_modes(&self.problem.mesh, cell);
        let components = self.space.components;
        assembly.whole_stiffness(cell, &local, work)?;
        let n = components * local.modes;
        let k = matrix_in(&mut work.matrix, n, n);
        let sign = local.signs();
        // Place of a local row, components fastest, in the matrix, one component after the other.
        let row = |i: usize| row_of(&local, components, i % components, i / components);
        let entry = |i: usize, j: usize| {
            let (r, s) = (row(i), row(j));
            assembly.unit * sign[i / components] * sign[j / components] * k[(r.max(s), r.min(s))]
        };
        let stiffness = Mat::from_fn(n, n, entry);
        let mut loads = assembly.load_on_modes(cell, &local);
        loads = Mat::from_fn(n, loads.ncols(), |i, c| assembly.unit * sign[i / components] * loads[(row(i), c)]);
        let modes = self.space.boundary_modes(&self.problem.mesh, cell);
        for ((boundary, case), value) in assembly.cell_loads(cell, &modes) {
            loads[(components * local.interior + boundary, case)] += assembly.unit * value;
        }
        let inner = (0..components * local.interior).map(|i| (vec![(self.inner_start[cell] + i, 1.0)], 0.0));
        let outer = assembly.targets(cell, &modes).into_iter().map(|target| self.hang(&target));
        let (unknowns, prescribed) = inner.chain(outer).unzip();
        Ok(Element { unknowns, prescribed, stiffness, loads })
    }

    /// The unknowns that a local row hangs on, and its prescribed part.
    fn hang(&self, target: &Target) -> (Vec<(usize, f64)>, f64) {
        let active = target.active.iter().map(|(group, index, c)| (self.start[*group] + index, *c)).collect();
        (active, target.fixed.iter().map(|f| f.share * f.value).sum())
    }

    /// The stiffness of the whole body, foundations included, N/mm, both triangles, and the right-hand sides: one column a load case and
    /// one, the last, of the prescribed displacements, N.
    ///
    /// # Errors
    /// A folded cell; boundaries of loads that do not exist.
    pub fn stiffness(&self) -> Result<(SparseColMat<usize, f64>, Mat<f64>), Error> {
        let assembly = self.assembly()?;
        let cells = self.problem.mesh.cells.len();
        let elements = map_cells(cells, |work, cell| self.element_of(&assembly, cell, work));
        let mut entries = Vec::new();
        let cases = self.problem.load_cases.len();
        let mut right = Mat::<f64>::zeros(self.unknowns(), cases + 1);
        for element in elements {
            let element = element?;
            for (row, i) in element.unknowns.iter().enumerate().flat_map(|(row, u)| u.iter().map(move |u| (row, u))) {
                (0..cases).for_each(|case| right[(i.0, case)] += i.1 * element.loads[(row, case)]);
            }
            scatter(&element.unknowns, &element.stiffness, &mut entries);
            self.prescribe(&element.unknowns, &element.prescribed, &element.stiffness, &mut right);
        }
        for (edge, foundation) in self.problem.foundation_edges()? {
            let (k, targets) = assembly.foundation_matrix(edge, foundation);
            let k = faer::Scale(assembly.unit) * k;
            let (unknowns, prescribed): (Vec<_>, Vec<_>) = targets.iter().map(|target| self.hang(target)).unzip();
            scatter(&unknowns, &k, &mut entries);
            self.prescribe(&unknowns, &prescribed, &k, &mut right);
        }
        if right.col_iter().any(|column| column.iter().any(|v| !v.is_finite())) {
            return Err(Error::OutOfRange { quantity: "a load".into(), value: f64::NAN, range: "finite" });
        }
        Ok((self.collected(&entries)?, right))
    }

    /// Adds the load that prescribed displacements leave on the unknowns to the last column.
    fn prescribe(&self, unknowns: &[Vec<(usize, f64)>], prescribed: &[f64], k: &Mat<f64>, right: &mut Mat<f64>) {
        let last = right.ncols() - 1;
        for (j, value) in prescribed.iter().enumerate().filter(|(_, value)| **value != 0.0) {
            for (i, row) in unknowns.iter().enumerate() {
                row.iter().for_each(|(u, c)| right[(*u, last)] -= c * k[(i, j)] * value);
            }
        }
    }

    /// The mass matrix `int rho u . v dV` with a density for every material, t/mm^3 with N and mm; for a potential the capacity. Prescribed
    /// components have no mass.
    ///
    /// # Errors
    /// [`Error::Count`], [`Error::OutOfRange`] for other densities than one positive a material.
    pub fn mass(&self, density: &[f64]) -> Result<SparseColMat<usize, f64>, Error> {
        let expected = self.problem.materials.len();
        if density.len() != expected {
            return Err(Error::Count { what: "densities of materials".into(), given: density.len(), expected });
        }
        if let Some(value) = density.iter().find(|d| !(**d > 0.0 && d.is_finite())) {
            return Err(Error::OutOfRange { quantity: "a density".into(), value: *value, range: "positive and finite" });
        }
        let assembly = self.assembly()?;
        let mesh = &self.problem.mesh;
        let mut entries = Vec::new();
        for (cell, own) in mesh.cells.iter().enumerate() {
            let local = self.space.local_modes(mesh, cell);
            let m = faer::Scale(density[own.material]) * self.cell_mass(cell, &local);
            let inner = (0..self.space.components * local.interior).map(|i| vec![(self.inner_start[cell] + i, 1.0)]);
            let modes = self.space.boundary_modes(mesh, cell);
            let outer = assembly.targets(cell, &modes).into_iter().map(|target| self.hang(&target).0);
            let unknowns: Vec<_> = inner.chain(outer).collect();
            scatter(&unknowns, &m, &mut entries);
        }
        self.collected(&entries)
    }

    /// `int u . v dV` on the local rows of a cell.
    fn cell_mass(&self, cell: usize, local: &LocalModes) -> Mat<f64> {
        let (mesh, degree, components) = (&self.problem.mesh, self.space.cell_degree[cell], self.space.components);
        let rule = cell_rule(mesh.cells[cell].is_triangle(), points_for(degree) + 1);
        let (mut values, mut weighted) = (Mat::<f64>::zeros(rule.len(), local.modes), Mat::<f64>::zeros(rule.len(), local.modes));
        for (q, ([xi, eta], weight)) in rule.iter().enumerate() {
            let point = CellPoint::new(mesh, cell, degree, *xi, *eta);
            let volume = weight * point.jacobian() * self.problem.kinematics.measure(point.position[0]);
            let present = point.modes.iter().zip(&local.position).zip(&local.sign).filter(|((_, p), _)| **p != usize::MAX);
            for ((jet, position), sign) in present {
                values[(q, *position)] = sign * jet[0];
                weighted[(q, *position)] = volume * sign * jet[0];
            }
        }
        let mut scalar = Mat::<f64>::zeros(local.modes, local.modes);
        matmul(scalar.as_mut(), Accum::Replace, values.transpose(), weighted.as_ref(), 1.0, Par::Seq);
        let same = |i: usize, j: usize| i % components == j % components;
        let n = components * local.modes;
        Mat::from_fn(n, n, |i, j| if same(i, j) { scalar[(i / components, j / components)] } else { 0.0 })
    }

    fn collected(&self, entries: &[Triplet<usize, usize, f64>]) -> Result<SparseColMat<usize, f64>, Error> {
        let n = self.unknowns();
        let too_large =
            |_| Error::Count { what: "entries of a sparse matrix".into(), given: entries.len(), expected: usize::MAX };
        SparseColMat::try_new_from_triplets(n, n, entries).map_err(too_large)
    }

    /// The field of a vector of unknowns, under load cases with these factors, which matter for the stress under eigenstrains.
    ///
    /// # Errors
    /// [`Error::Count`] for vectors of other lengths than the unknowns and the load cases.
    pub fn field(&self, unknowns: &[f64], factors: &[f64]) -> Result<Field, Error> {
        self.field_with(unknowns, factors, 1.0)
    }

    /// The same with the prescribed displacements times a factor: none in a natural mode.
    pub(crate) fn field_with(&self, unknowns: &[f64], factors: &[f64], share: f64) -> Result<Field, Error> {
        let check = |what: &str, given: usize, expected: usize| match given == expected {
            true => Ok(()),
            false => Err(Error::Count { what: what.into(), given, expected }),
        };
        check("unknowns", unknowns.len(), self.unknowns())?;
        check("factors of load cases", factors.len(), self.problem.load_cases.len())?;
        let mesh = &self.problem.mesh;
        let assembly = self.assembly()?;
        let coefficients = |cell: usize| {
            let local = self.space.local_modes(mesh, cell);
            let start = self.inner_start[cell];
            let mut u = unknowns[start..self.inner_start[cell + 1]].to_vec();
            for target in assembly.targets(cell, &self.space.boundary_modes(mesh, cell)) {
                let (active, prescribed) = self.hang(&target);
                u.push(active.iter().map(|(i, c)| c * unknowns[*i]).sum::<f64>() + share * prescribed);
            }
            (local, u)
        };
        let cells = (0..mesh.cells.len()).map(coefficients).collect();
        Ok(Field::new(FieldParts { problem: &self.problem, space: &self.space, factors, cells }))
    }
}

impl Body {
    /// The stiffness of a cell on its local rows, see [`Element::stiffness`].
    ///
    /// # Errors
    /// As for [`SparseBody::element`].
    pub fn element_matrix(&self, cell: usize) -> Result<Element, Error> {
        SparseBody::new(self.problem.clone())?.element(cell)
    }
}

/// Adds a local matrix to the entries of a sparse one.
fn scatter(unknowns: &[Vec<(usize, f64)>], matrix: &Mat<f64>, entries: &mut Vec<Triplet<usize, usize, f64>>) {
    for (j, columns) in unknowns.iter().enumerate() {
        for (i, rows) in unknowns.iter().enumerate().filter(|(i, _)| matrix[(*i, j)] != 0.0) {
            for (column, b) in columns {
                entries.extend(rows.iter().map(|(row, a)| Triplet::new(*row, *column, a * b * matrix[(i, j)])));
            }
        }
    }
}
