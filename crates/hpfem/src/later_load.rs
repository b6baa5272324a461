//! Loads on a body that is factorised already: a substitution each.

use crate::alike_loads::OnBoundary;
use crate::assembly::Assembly;
use crate::body::Body;
use crate::check::check_case;
use crate::congruence::Congruence;
use crate::edge_load::Loads;
use crate::error::Error;
use crate::interface::InterfaceOperator;
use crate::load_case::LoadCase;
use faer::{Mat, MatRef};
use std::sync::Arc;

/// What one cell takes of a new load case.
struct CellLoad {
    /// `(group, index in group, value)`.
    active: Vec<(usize, usize, f64)>,
    /// Constant parts of the reactions.
    constant: Vec<(usize, f64)>,
    /// Work of the new load on the interior that each load case displaces; empty without loads inside.
    work: Vec<f64>,
}

impl Body {
    /// Adds a load case to the factorised body: what [`Body::new`] gives with the case in its problem, to round-off, for one forward
    /// substitution along the fronts between the load and the kept boundary. A case of the same name that was added before is
    /// replaced in its place. States solved before belong to the body as it was: solve again.
    ///
    /// # Errors
    /// [`Error::DuplicateLoadCase`] if the body was made with a case of that name; boundaries that do not exist, points outside
    /// the mesh, numbers that are not finite.
    pub fn add_load(&mut self, case: LoadCase) -> Result<(), Error> {
        let mesh = Arc::clone(&self.problem.mesh);
        check_case(&case, &mesh, self.problem.kinematics)?;
        if self.problem.load_cases[..self.factored.cases].iter().any(|known| known.name == case.name) {
            return Err(Error::DuplicateLoadCase { name: case.name });
        }
        let before = self.problem.load_cases.iter().position(|known| known.name == case.name);
        self.problem.load_cases.push(case);
        if let Err(error) = self.append_column() {
            self.problem.load_cases.pop();
            return Err(error);
        }
        if let Some(number) = before {
            self.remove_column(number);
            self.move_last_to(number);
        }
        Ok(())
    }

    /// Drops a load case that was added later.
    fn remove_column(&mut self, number: usize) {
        self.problem.load_cases.remove(number);
        self.added.remove(number - self.factored.cases);
        let InterfaceOperator { load_cases, columns, work, reaction_constant, .. } = &mut self.interface;
        load_cases.remove(number);
        *columns = without(columns.as_ref(), number);
        *work = without(without(work.as_ref(), number).transpose(), number);
        *reaction_constant = without(reaction_constant.as_ref(), number);
    }

    /// Gives the last load case another place among those that were added.
    fn move_last_to(&mut self, number: usize) {
        let last = self.problem.load_cases.len() - 1;
        self.problem.load_cases[number..].rotate_right(1);
        self.added[number - self.factored.cases..].rotate_right(1);
        let InterfaceOperator { load_cases, columns, work, reaction_constant, .. } = &mut self.interface;
        load_cases[number..].rotate_right(1);
        let from = |j: usize| match j {
            j if j == number => last,
            j if j > number && j <= last => j - 1,
            j => j,
        };
        *columns = Mat::from_fn(columns.nrows(), columns.ncols(), |i, j| columns[(i, from(j))]);
        *work = Mat::from_fn(work.nrows(), work.ncols(), |i, j| work[(from(i), from(j))]);
        *reaction_constant = Mat::from_fn(reaction_constant.nrows(), columns.ncols(), |i, j| reaction_constant[(i, from(j))]);
    }

    /// Makes the column of the last load case, for which the interface operator has none yet; nothing is changed on an error.
    fn append_column(&mut self) -> Result<(), Error> {
        let factored = Arc::clone(&self.factored);
        let (mesh, space) = (&*self.problem.mesh, &factored.space);
        let new = self.problem.load_cases.len() - 1;
        let assembly = Assembly::new(&self.problem, space, Loads::new(mesh, &self.problem.load_cases)?);
        let touched: Vec<usize> = (0..mesh.cells.len()).filter(|c| assembly.loads.of_case(mesh, *c, new)).collect();
        let inside: Vec<usize> = touched.iter().copied().filter(|cell| assembly.loads.inside(*cell)).collect();
        let of_shapes = || assembly.inner_loads(&inside, &Congruence::of(&self.problem, space));
        let mut inner_loads = if inside.is_empty() { Vec::new() } else { of_shapes()? }.into_iter();
        let mut values: Vec<Mat<f64>> = vec![Mat::new(); space.size.len()];
        let reactions = self.interface.reaction_constant.nrows();
        // Work with the cases before, then with itself.
        let (mut constant, mut inner) = (vec![0.0; reactions], vec![0.0; new + 1]);
        for cell in touched {
            let inside = if assembly.loads.inside(cell) { inner_loads.next() } else { None };
            let load = assembly.new_load(cell, new, inside);
            for (group, index, value) in load.active {
                if values[group].ncols() == 0 {
                    values[group] = Mat::zeros(space.size[group], 1);
                }
                values[group][(index, 0)] += value;
            }
            load.constant.iter().for_each(|(r, value)| constant[*r] += value);
            inner.iter_mut().zip(&load.work).for_each(|(sum, w)| *sum += w);
        }
        let first = self.interface.columns.ncols() - self.added.len();
        let mut size = space.size.clone();
        size.push(first);
        values.push(Mat::new());
        let forward = factored.condensed.forward(&mut values, &size, [first, 1]);
        let mut column = vec![0.0; factored.kept.unknowns];
        for g in &factored.kept.groups {
            let start = factored.kept.start[*g].unwrap_or(0);
            values[*g].col_iter().flat_map(|v| v.iter()).enumerate().for_each(|(i, v)| column[start + i] = *v);
        }
        // Work with all columns in their order: the cases of the factorisation, those added, this one, all others.
        let mut work = forward.work.col_as_slice(0).to_vec();
        work.splice(
            factored.cases..factored.cases,
            self.added.iter().map(|other| forward.dot(0, other)).chain([forward.dot(0, &forward)]),
        );
        work.iter_mut().zip(&inner).for_each(|(sum, w)| *sum += w);
        let unit = assembly.unit;
        let scaled = |v: Vec<f64>| v.into_iter().map(|v| unit * v).collect::<Vec<_>>();
        if let Some(value) = column.iter().chain(&work).chain(&constant).find(|v| !v.is_finite()) {
            let quantity = format!("a number of load case \"{}\"", self.problem.load_cases[new].name);
            return Err(Error::OutOfRange { quantity, value: *value, range: "finite" });
        }
        self.interface.insert_case(new, &self.problem.load_cases[new].name, [scaled(column), scaled(work), scaled(constant)]);
        self.added.push(Arc::new(forward));
        Ok(())
    }
}

impl Assembly<'_> {
    /// What a cell takes of load case `new`, of which `inside` is what the loads inside do.
    fn new_load(&self, cell: usize, new: usize, inside: Option<OnBoundary>) -> CellLoad {
        let modes = self.space.boundary_modes(self.mesh, cell);
        let mut load = self.cell_loads(cell, &modes);
        let mut inner = Vec::new();
        if let Some(OnBoundary { boundary, work, .. }) = inside {
            load.extend(boundary);
            inner = (0..=new).map(|k| work[(k, new)]).collect();
        }
        let targets = self.targets(cell, &modes);
        let motions = self.virtual_motion(&targets, self.columns - self.loads.cases - 1);
        let (mut active, mut constant) = (Vec::new(), Vec::new());
        for ((row, _), value) in load.iter().filter(|((_, case), _)| *case == new) {
            active.extend(targets[*row].active.iter().map(|(group, index, c)| (*group, *index, c * value)));
            for (r, motion) in motions.iter().enumerate().filter(|(_, motion)| !motion.is_empty()) {
                constant.push((r, -motion[*row] * value));
            }
        }
        CellLoad { active, constant, work: inner }
    }
}

impl InterfaceOperator {
    /// Inserts a load case: its column on the kept unknowns, its work with all columns once it is among them, its constant reactions.
    fn insert_case(&mut self, number: usize, name: &str, [column, work, constant]: [Vec<f64>; 3]) {
        self.load_cases.insert(number, name.to_string());
        self.columns = with(self.columns.as_ref(), number, &column);
        let mut shorter = work.clone();
        shorter.remove(number);
        self.work = with(with(self.work.as_ref(), number, &shorter).transpose(), number, &work);
        self.reaction_constant = with(self.reaction_constant.as_ref(), number, &constant);
    }
}

/// A matrix with one more column.
fn with(m: MatRef<'_, f64>, at: usize, column: &[f64]) -> Mat<f64> {
    Mat::from_fn(m.nrows(), m.ncols() + 1, |i, j| if j == at { column[i] } else { m[(i, j - usize::from(j > at))] })
}

/// A matrix with one column less.
fn without(m: MatRef<'_, f64>, at: usize) -> Mat<f64> {
    Mat::from_fn(m.nrows(), m.ncols() - 1, |i, j| m[(i, j + usize::from(j >= at))])
}
