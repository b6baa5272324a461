//! Temperatures of a body on the same mesh as load cases: what each does to the kept boundary, without going inside for each.
//!
//! Inside a cell a temperature without sources there follows from its boundary, `T_i = E T_b`, `E = -K_ii^-1 K_ib`. The load of its thermal strain on the
//! boundary of the cell, the interior condensed, is therefore one matrix `B` times `T_b`, and what a cell takes is its size on the boundary, however many
//! temperatures there are.

use crate::assembly::Assembly;
use crate::basis::LocalModes;
use crate::body::Body;
use crate::cell_matrix::map_cells;
use crate::edge_load::Loads;
use crate::element::Workspace;
use crate::elimination::Forward;
use crate::error::Error;
use crate::interface::{InterfaceOperator, InterfaceState};
use crate::kinematics::Kinematics;
use crate::space::Target;
use crate::volume_load::ModeStrain;
use faer::linalg::matmul::matmul;
use faer::linalg::triangular_solve::{solve_lower_triangular_in_place, solve_upper_triangular_in_place};
use faer::{Accum, Mat, Par};

/// A temperature as a load case.
#[derive(Clone, Debug)]
pub struct TemperatureCase {
    /// Name of the load case.
    pub name: String,
    /// State of the body of temperature.
    pub state: InterfaceState,
    /// The temperature without strain.
    pub reference: f64,
}

/// What one cell takes of the temperatures, a column each.
struct CellHeat {
    targets: Vec<Target>,
    /// Loads on its boundary unknowns.
    load: Mat<f64>,
    /// Constant parts of the reactions.
    constant: Vec<(usize, Vec<f64>)>,
    /// Work on the interior that other load cases displace; none without loads inside.
    work: Option<Mat<f64>>,
}

/// Both problems of one mesh, and the temperatures on the groups of theirs.
struct Heating<'a> {
    elastic: Assembly<'a>,
    thermal: Assembly<'a>,
    values: Vec<Mat<f64>>,
    cases: &'a [TemperatureCase],
    expansion: &'a [f64],
}

impl Body {
    /// The reduced body with further load cases, the thermal strains `alpha (T - T_0)` of temperatures of another body on the same mesh and degrees:
    /// `expansion` has one coefficient a material, 1/K. What [`Body::new`] gives with
    /// [`Eigenstrain::of_temperature`](crate::Eigenstrain::of_temperature), to round-off, but for the work between two of these cases, which is not
    /// computed and stands as NaN in [`InterfaceOperator::work`].
    ///
    /// # Errors
    /// [`Error::NoMeaning`] for a field that is no potential, or that has sources inside; [`Error::Count`] where meshes or degrees differ;
    /// [`Error::OtherLoads`] for states of another body.
    pub fn heated(&self, temperature: &Body, cases: &[TemperatureCase], expansion: &[f64]) -> Result<InterfaceOperator, Error> {
        let (mesh, space) = (&*self.problem.mesh, &self.factored.space);
        let thermal = Loads::new(temperature.mesh(), &temperature.problem.load_cases)?;
        check(self, temperature, &thermal)?;
        let states: Vec<InterfaceState> = cases.iter().map(|case| case.state.clone()).collect();
        let heating = Heating {
            elastic: Assembly::new(&self.problem, space, Loads::new(mesh, &self.problem.load_cases)?),
            thermal: Assembly::new(&temperature.problem, &temperature.factored.space, thermal),
            values: temperature.values_of_groups(&states)?,
            cases,
            expansion,
        };
        let heats = map_cells(mesh.cells.len(), |work, cell| heating.cell(cell, work));
        let many = cases.len();
        let mut values: Vec<Mat<f64>> = vec![Mat::new(); space.size.len()];
        let mut constant = Mat::<f64>::zeros(self.interface.reaction_constant.nrows(), many);
        let first = self.interface.columns.ncols() - self.added.len();
        let mut inner = Mat::<f64>::zeros(self.problem.load_cases.len(), many);
        for heat in heats {
            let heat = heat?;
            for (row, target) in heat.targets.iter().enumerate() {
                for (group, index, c) in &target.active {
                    if values[*group].ncols() == 0 {
                        values[*group] = Mat::zeros(space.size[*group], many);
                    }
                    (0..many).for_each(|k| values[*group][(*index, k)] += c * heat.load[(row, k)]);
                }
            }
            for (r, parts) in heat.constant {
                parts.iter().enumerate().for_each(|(k, part)| constant[(r, k)] += part);
            }
            heat.work.iter().for_each(|work| inner += work);
        }
        let mut size = space.size.clone();
        size.push(first);
        values.push(Mat::new());
        let forward = self.factored.condensed.forward(&mut values, &size, [first, many]);
        let mut columns = Mat::<f64>::zeros(self.factored.kept.unknowns, many);
        for g in &self.factored.kept.groups {
            let start = self.factored.kept.start[*g].unwrap_or(0);
            if values[*g].ncols() > 0 {
                columns.as_mut().subrows_mut(start, space.size[*g]).copy_from(&values[*g]);
            }
        }
        let work = self.work_with(&forward, &inner);
        if let Some(value) = columns.col_iter().chain(constant.col_iter()).flat_map(|c| c.iter()).find(|v| !v.is_finite()) {
            return Err(Error::OutOfRange { quantity: "the load of a temperature".into(), value: *value, range: "finite" });
        }
        let unit = faer::Scale(heating.elastic.unit);
        let names = cases.iter().map(|case| case.name.clone());
        Ok(self.interface.with_cases(names, [unit * columns, unit * work, unit * constant]))
    }

    /// Work of all columns with further right-hand sides, of which `inner` is that of the load cases inside cells.
    fn work_with(&self, forward: &Forward, inner: &Mat<f64>) -> Mat<f64> {
        let (known, added) = (self.factored.cases, self.added.len());
        Mat::from_fn(self.interface.columns.ncols(), inner.ncols(), |row, k| {
            let own = match row {
                row if row < known => forward.work[(row, k)],
                row if row < known + added => forward.dot(k, &self.added[row - known]),
                row => forward.work[(row - added, k)],
            };
            own + if row < known + added { inner[(row, k)] } else { 0.0 }
        })
    }
}

/// Refuses temperatures of another mesh, or with sources inside.
fn check(body: &Body, temperature: &Body, loads: &Loads<'_>) -> Result<(), Error> {
    let kinematics = temperature.problem.kinematics;
    let refuse = |what: &str| Err(Error::NoMeaning { what: what.to_string(), kinematics: kinematics.words() });
    if !matches!(kinematics, Kinematics::Potential { .. } | Kinematics::AxisymmetricPotential) {
        return refuse("a temperature");
    }
    if body.problem.kinematics.components() != 2 {
        return Err(Error::NoMeaning { what: "a thermal strain".to_string(), kinematics: body.problem.kinematics.words() });
    }
    let [cells, given] = [body, temperature].map(|body| body.mesh().cells.len());
    if cells != given {
        return Err(Error::Count { what: "cells of the temperature".into(), given, expected: cells });
    }
    let [own, other] = [body, temperature].map(|body| &body.factored.space.cell_degree);
    if let Some(cell) = (0..cells).find(|cell| own[*cell] != other[*cell]) {
        let what = format!("degree of the temperature in cell {cell}");
        return Err(Error::Count { what, given: other[cell], expected: own[cell] });
    }
    if (0..cells).any(|cell| loads.inside(cell)) {
        return refuse("a temperature with sources inside as load cases");
    }
    Ok(())
}

impl Heating<'_> {
    /// What a cell takes of the temperatures.
    fn cell(&self, cell: usize, work: &mut Workspace) -> Result<CellHeat, Error> {
        let Heating { elastic, thermal, .. } = self;
        let local = thermal.space.local_modes(thermal.mesh, cell);
        let boundary = self.boundary_values(cell, &local);
        // Where there are fewer temperatures than unknowns on the boundary each is a column, else each unknown.
        let by_unknowns = boundary.nrows() < boundary.ncols();
        let given = if by_unknowns { Mat::identity(boundary.nrows(), boundary.nrows()) } else { boundary.clone() };
        let inside = inside(thermal, cell, &local, &given, work)?;
        let expansion = self.expansion.get(elastic.mesh.cells[cell].material).copied().unwrap_or(0.0);
        let strain = |k: usize| -> ModeStrain {
            let at = |mode: usize| match mode {
                usize::MAX => 0.0,
                mode if mode < local.interior => inside[(mode, k)],
                mode => given[(mode - local.interior, k)],
            };
            (local.position.iter().map(|mode| expansion * at(*mode)).collect(), 0.0)
        };
        let strains: Vec<ModeStrain> = (0..given.ncols()).map(strain).collect();
        let (mut load, mut inner) = condensed_load(elastic, cell, &strains.iter().collect::<Vec<_>>(), work)?;
        if by_unknowns {
            load = load * &boundary;
            inner = inner.map(|inner| inner * &boundary);
        }
        let targets = elastic.targets(cell, &elastic.space.boundary_modes(elastic.mesh, cell));
        let motions = elastic.virtual_motion(&targets, elastic.columns - elastic.loads.cases - 1);
        let reaction = |motion: &[f64]| -> Vec<f64> {
            let force = |k: usize| -motion.iter().enumerate().map(|(row, m)| m * load[(row, k)]).sum::<f64>();
            (0..load.ncols()).map(force).collect()
        };
        let moved = motions.iter().enumerate().filter(|(_, motion)| !motion.is_empty());
        let constant = moved.map(|(r, motion)| (r, reaction(motion))).collect();
        Ok(CellHeat { targets, load, constant, work: inner })
    }

    /// Temperatures above those without strain on the unsigned boundary modes of a cell, a column each.
    fn boundary_values(&self, cell: usize, local: &LocalModes) -> Mat<f64> {
        let thermal = &self.thermal;
        let modes = thermal.space.boundary_modes(thermal.mesh, cell);
        let (sign, prescribed) = (local.signs(), thermal.loads.cases);
        let targets = thermal.targets(cell, &modes);
        Mat::from_fn(targets.len(), self.cases.len(), |row, k| {
            let TemperatureCase { state, reference, .. } = &self.cases[k];
            let target = &targets[row];
            let active: f64 = target.active.iter().map(|(group, index, c)| c * self.values[*group][(*index, k)]).sum();
            let fixed: f64 = target.fixed.iter().map(|fixed| fixed.share * fixed.value).sum();
            // The corners alone make up a constant.
            let above = if row < modes.corners { *reference } else { 0.0 };
            sign[local.interior + row] * (active + state.factors[prescribed] * fixed) - above
        })
    }
}

/// Unknowns inside a cell by those on its boundary, unsigned, a column each.
fn inside(
    assembly: &Assembly<'_>,
    cell: usize,
    local: &LocalModes,
    boundary: &Mat<f64>,
    work: &mut Workspace,
) -> Result<Mat<f64>, Error> {
    let (k, ni) = assembly.condensed(cell, local, work)?;
    let (l11, l21) = k.as_ref().subcols(0, ni).split_at_row(ni);
    let mut x = Mat::zeros(ni, boundary.ncols());
    matmul(x.as_mut(), Accum::Replace, l21.transpose(), boundary.as_ref(), -1.0, Par::Seq);
    solve_upper_triangular_in_place(l11.transpose(), x.as_mut(), Par::Seq);
    Ok(x)
}

/// The load of strains on the boundary unknowns of a cell, its interior condensed, a column each; and the work on what other load cases displace inside.
fn condensed_load(
    assembly: &Assembly<'_>,
    cell: usize,
    strains: &[&ModeStrain],
    work: &mut Workspace,
) -> Result<(Mat<f64>, Option<Mat<f64>>), Error> {
    let local = assembly.space.local_modes(assembly.mesh, cell);
    let components = assembly.space.components;
    let mut load = assembly.strain_columns(cell, &local, strains);
    let others = assembly.loads.inside(cell).then(|| assembly.load_on_modes(cell, &local));
    let (k, ni) = assembly.condensed(cell, &local, work)?;
    let (l11, l21) = k.as_ref().subcols(0, ni).split_at_row(ni);
    let (mut y, mut boundary) = load.as_mut().split_at_row_mut(ni);
    solve_lower_triangular_in_place(l11, y.as_mut(), Par::Seq);
    let nb = boundary.nrows();
    matmul(boundary.as_mut(), Accum::Add, l21.get(..nb, ..), y.as_ref(), -1.0, Par::Seq);
    let inner = others.map(|mut others| {
        let mut other = others.as_mut().subrows_mut(0, ni);
        solve_lower_triangular_in_place(l11, other.as_mut(), Par::Seq);
        other.transpose() * y.as_ref()
    });
    // From the order of the matrix to that of unknowns: signed, components fastest.
    let (sign, modes) = (local.signs(), nb / components);
    let row = |i: usize| (i % components) * modes + i / components;
    let signed = |i: usize, k: usize| sign[local.interior + i / components] * boundary[(row(i), k)];
    Ok((Mat::from_fn(nb, strains.len(), signed), inner))
}

impl InterfaceOperator {
    /// The operator with further load cases: their columns on the kept unknowns, their work with all columns before them, their constant reactions.
    fn with_cases(&self, names: impl Iterator<Item = String>, [columns, work, constant]: [Mat<f64>; 3]) -> InterfaceOperator {
        let (at, many) = (self.load_cases.len(), columns.ncols());
        // Of a column the place before, or among those that are new.
        let from = |k: usize| match k {
            k if k < at => Ok(k),
            k if k < at + many => Err(k - at),
            k => Ok(k - many),
        };
        let pick = |old: &Mat<f64>, new: &Mat<f64>| {
            Mat::from_fn(old.nrows(), old.ncols() + many, |i, k| from(k).map_or_else(|k| new[(i, k)], |k| old[(i, k)]))
        };
        let all = self.columns.ncols() + many;
        let between = |i: usize, k: usize| match (from(i), from(k)) {
            (Ok(i), Ok(k)) => self.work[(i, k)],
            (Ok(i), Err(k)) | (Err(k), Ok(i)) => work[(i, k)],
            (Err(_), Err(_)) => f64::NAN,
        };
        let mut load_cases = self.load_cases.clone();
        load_cases.extend(names);
        InterfaceOperator {
            columns: pick(&self.columns, &columns),
            work: Mat::from_fn(all, all, between),
            reaction_constant: pick(&self.reaction_constant, &constant),
            load_cases,
            ..self.clone()
        }
    }
}
