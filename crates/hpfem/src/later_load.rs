//! Loads on a body that is factorised already: a substitution each.

use crate::assembly::Assembly;
use crate::body::Body;
use crate::check::check_case;
use crate::congruence::Congruence;
use crate::edge_load::Loads;
use crate::error::Error;
use crate::interface::InterfaceOperator;
use crate::load_case::LoadCase;
use crate::on_boundary::OnBoundary;
use crate::summed::Summed;
use faer::{Mat, MatRef};
use std::sync::Arc;

/// What one cell takes of new load cases, numbered from 0.
struct CellLoad {
    /// `(group, index in group, case, value)`.
    active: Vec<(usize, usize, usize, f64)>,
    /// Constant parts of the reactions, `(reaction, case, value)`.
    constant: Vec<(usize, usize, f64)>,
    /// Work of all load cases on the interior that each displaces; none without loads inside.
    work: Option<Mat<f64>>,
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
        if self.problem.load_cases[..self.factored.cases].iter().any(|known| known.name == case.name) {
            return Err(Error::DuplicateLoadCase { name: case.name });
        }
        let before = self.problem.load_cases.iter().position(|known| known.name == case.name);
        self.append(vec![case])?;
        if let Some(number) = before {
            self.remove_column(number);
            self.move_last_to(number);
        }
        Ok(())
    }

    /// Adds load cases of new names at once: what [`Body::add_load`] gives for one after the other, to round-off, but each cell is condensed once for all
    /// that acts inside it.
    ///
    /// # Errors
    /// As [`Body::add_load`]; [`Error::DuplicateLoadCase`] for every name that the body has, or that comes twice. Nothing is added then.
    pub fn add_loads(&mut self, cases: Vec<LoadCase>) -> Result<(), Error> {
        let known = |k: usize| self.problem.load_cases.iter().chain(&cases[..k]).any(|known| known.name == cases[k].name);
        if let Some(k) = (0..cases.len()).find(|k| known(*k)) {
            return Err(Error::DuplicateLoadCase { name: cases[k].name.clone() });
        }
        self.append(cases)
    }

    /// Puts load cases after those that are there; nothing is changed on an error.
    fn append(&mut self, cases: Vec<LoadCase>) -> Result<(), Error> {
        let (mesh, many) = (Arc::clone(&self.problem.mesh), cases.len());
        cases.iter().try_for_each(|case| check_case(case, &mesh, self.problem.kinematics))?;
        let first = self.problem.load_cases.len();
        self.problem.load_cases.extend(cases);
        let appended = self.append_columns(many);
        if appended.is_err() {
            self.problem.load_cases.truncate(first);
        }
        appended
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

    /// Makes the columns of the last load cases, for which the interface operator has none yet; nothing is changed on an error.
    fn append_columns(&mut self, many: usize) -> Result<(), Error> {
        let factored = Arc::clone(&self.factored);
        let new = self.problem.load_cases.len() - many;
        let assembly = Assembly::new(&self.problem, &factored.space, Loads::new(&self.problem.mesh, &self.problem.load_cases)?);
        let Summed { values, constant, inner } = self.summed_loads(&assembly, new)?;
        let (forward, columns) = self.eliminated(values, many);
        let forwards = forward.columns();
        let unit = assembly.unit;
        let scaled = |v: &[f64]| v.iter().map(|v| unit * v).collect::<Vec<_>>();
        let mut made = Vec::with_capacity(many);
        for (k, forward) in forwards.iter().enumerate() {
            // Work with all columns in their order: the cases of the factorisation, those added, these, all others.
            let mut work = forward.work.col_as_slice(0).to_vec();
            let later = self.added.iter().map(Arc::as_ref).chain(&forwards[..=k]).map(|other| forward.dot(0, other));
            work.splice(factored.cases..factored.cases, later);
            work.iter_mut().zip(&inner.col_as_slice(k)[..=new + k]).for_each(|(sum, w)| *sum += w);
            let numbers = [columns.col_as_slice(k), &work, constant.col_as_slice(k)];
            if let Some(value) = numbers.into_iter().flatten().find(|v| !v.is_finite()) {
                let quantity = format!("a number of load case \"{}\"", self.problem.load_cases[new + k].name);
                return Err(Error::OutOfRange { quantity, value: *value, range: "finite" });
            }
            made.push(numbers.map(scaled));
        }
        for ((k, numbers), forward) in made.into_iter().enumerate().zip(forwards) {
            self.interface.insert_case(new + k, &self.problem.load_cases[new + k].name, numbers);
            self.added.push(Arc::new(forward));
        }
        Ok(())
    }

    /// Sums over the cells that the load cases from number `new` on act on.
    fn summed_loads(&self, assembly: &Assembly<'_>, new: usize) -> Result<Summed, Error> {
        let (mesh, space) = (assembly.mesh, assembly.space);
        let (all, reactions) = (assembly.loads.cases, self.interface.reaction_constant.nrows());
        let acts = |cell: &usize| (new..all).any(|case| assembly.loads.of_case(mesh, *cell, case));
        let touched: Vec<usize> = (0..mesh.cells.len()).filter(acts).collect();
        let inside: Vec<usize> = touched.iter().copied().filter(|cell| assembly.loads.inside(*cell)).collect();
        let of_shapes = || assembly.inner_loads(&inside, &Congruence::of(&self.problem, space));
        let mut inner_loads = if inside.is_empty() { Vec::new() } else { of_shapes()? }.into_iter();
        let mut values: Vec<Mat<f64>> = vec![Mat::new(); space.size.len()];
        let (mut constant, mut inner) = (Mat::zeros(reactions, all - new), Mat::zeros(all, all - new));
        for cell in touched {
            let inside = if assembly.loads.inside(cell) { inner_loads.next() } else { None };
            let load = assembly.new_loads(cell, new, inside);
            for (group, index, k, value) in load.active {
                if values[group].ncols() == 0 {
                    values[group] = Mat::zeros(space.size[group], all - new);
                }
                values[group][(index, k)] += value;
            }
            load.constant.iter().for_each(|(r, k, value)| constant[(*r, *k)] += value);
            load.work.iter().for_each(|work| inner += work.subcols(new, all - new));
        }
        Ok(Summed { values, constant, inner })
    }
}

impl Assembly<'_> {
    /// What a cell takes of the load cases from number `new` on, of which `inside` is what the loads inside do.
    fn new_loads(&self, cell: usize, new: usize, inside: Option<OnBoundary>) -> CellLoad {
        let modes = self.space.boundary_modes(self.mesh, cell);
        let mut load = self.cell_loads(cell, &modes);
        let mut inner = None;
        if let Some(OnBoundary { boundary, work, .. }) = inside {
            load.extend(boundary);
            inner = Some(work);
        }
        let targets = self.targets(cell, &modes);
        let motions = self.virtual_motion(&targets, self.columns - self.loads.cases - 1);
        let (mut active, mut constant) = (Vec::new(), Vec::new());
        for ((row, case), value) in load.iter().filter(|((_, case), _)| *case >= new) {
            active.extend(targets[*row].active.iter().map(|(group, index, c)| (*group, *index, case - new, c * value)));
            for (r, motion) in motions.iter().enumerate().filter(|(_, motion)| !motion.is_empty()) {
                constant.push((r, case - new, -motion[*row] * value));
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
