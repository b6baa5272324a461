//! Temperatures of a body on the same mesh as load cases: what each does to the kept boundary, without going inside for each.
//!
//! The load of a thermal strain on the boundary of a cell, the interior condensed, is one matrix times the temperature there (`cell_heat.rs`), and what a cell
//! takes is its size on the boundary, however many temperatures there are.

use crate::assembly::Assembly;
use crate::body::{Body, Factored};
use crate::cell_heat::{CellHeats, Warm, Warming, add, eliminate};
use crate::cell_matrix::map_cells;
use crate::congruence::Turn;
use crate::edge_load::Loads;
use crate::element::Workspace;
use crate::elimination::Forward;
use crate::error::Error;
use crate::interface::{InterfaceOperator, InterfaceState};
use crate::known_heat::{Own, TemperatureCase};
use crate::space::Target;
use crate::summed::Summed;
use faer::Mat;
use std::sync::{Arc, OnceLock};

/// Cells whose loads are there at once: those of many temperatures are large.
const AT_ONCE: usize = 16;

/// What one cell takes of the temperatures.
struct CellHeat {
    targets: Vec<Target>,
    /// Loads on the rows of its class, `temperatures x rows`: the temperatures stand next to each other wherever they are summed up.
    of_class: Mat<f64>,
    /// Of each of its boundary unknowns the rows of the class that its load is made of, with their factors.
    made_of: Vec<[(usize, f64); 2]>,
    /// Constant parts of the reactions.
    constant: Vec<(usize, Vec<f64>)>,
    /// Work on the interior that other load cases displace; none without loads inside.
    work: Option<Mat<f64>>,
}

/// Both problems of one mesh, and the temperatures on the groups of theirs.
struct Heating<'a> {
    elastic: Assembly<'a>,
    warming: Warming<'a>,
    heats: &'a CellHeats,
}

impl Body {
    /// The reduced body with further load cases, the thermal strains `alpha (T - T_0)` of temperatures of another body on the same mesh and degrees:
    /// `expansion` has one coefficient a material, 1/K. What [`Body::new`] gives with
    /// [`Eigenstrain::of_temperature`](crate::Eigenstrain::of_temperature), to round-off, but for the work between two of these cases, which is not
    /// computed and stands as NaN in [`InterfaceOperator::work`]. It is solved like any other: [`InterfaceOperator::factors`] by the names of the cases, then
    /// [`InterfaceOperator::right_hand_side`] and [`InterfaceOperator::solve_one`]. The operator knows what these temperatures do to the kept boundary; fields and stresses
    /// inside are those of a body with [`Eigenstrain::of_temperature`](crate::Eigenstrain::of_temperature). A material without a coefficient does not expand.
    ///
    /// # Errors
    /// [`Error::NoMeaning`] for a field that is no potential, is of the other kind (plane, of revolution), or that has sources inside; [`Error::OtherMesh`] where meshes
    /// differ, [`Error::Count`] where degrees do; [`Error::OtherLoads`] for states of another body; [`Error::DuplicateLoadCase`] for a name that is there.
    pub fn heated(&self, temperature: &Body, cases: &[TemperatureCase], expansion: &[f64]) -> Result<InterfaceOperator, Error> {
        let names = self.interface.load_cases.iter().chain(cases.iter().map(|case| &case.name));
        let names: Vec<&String> = names.collect();
        if let Some(k) = (self.interface.load_cases.len()..names.len()).find(|k| names[..*k].contains(&names[*k])) {
            return Err(Error::DuplicateLoadCase { name: names[k].clone() });
        }
        let (mesh, space) = (&*self.problem.mesh, &self.factored.space);
        let warming = Warming::new((&self.problem, space), temperature.warm(Some(cases), expansion)?)?;
        let elastic = Assembly::new(&self.problem, space, Loads::new(mesh, &self.problem.load_cases)?);
        let made;
        let heats = match self.factored.heats.as_ref().filter(|heats| heats.are_for(&warming)) {
            Some(known) => known,
            None => {
                made = CellHeats::new(&elastic, &self.problem, &warming)?;
                &made
            }
        };
        warming.take_values(heats);
        let heating = Heating { elastic, warming, heats };
        let many = cases.len();
        let Summed { values, constant, inner } = self.summed(&heating, many)?;
        let (forward, columns) = self.eliminated(values, many);
        let work = self.work_with(&forward, &inner);
        if let Some(value) = columns.col_iter().chain(constant.col_iter()).flat_map(|c| c.iter()).find(|v| !v.is_finite()) {
            return Err(Error::OutOfRange { quantity: "the load of a temperature".into(), value: *value, range: "finite" });
        }
        let unit = faer::Scale(heating.elastic.unit);
        let names = cases.iter().map(|case| case.name.clone());
        Ok(self.interface.with_cases(names, [unit * columns, unit * work, unit * constant]))
    }

    /// What all cells take of so many temperatures.
    fn summed(&self, heating: &Heating<'_>, many: usize) -> Result<Summed, Error> {
        let space = &self.factored.space;
        let mut sums: Vec<Mat<f64>> = vec![Mat::new(); space.size.len()];
        let mut constant = Mat::<f64>::zeros(self.interface.reaction_constant.nrows(), many);
        let mut inner = Mat::<f64>::zeros(self.problem.load_cases.len(), many);
        let cells = self.problem.mesh.cells.len();
        for start in (0..cells).step_by(AT_ONCE) {
            for heat in map_cells(AT_ONCE.min(cells - start), |work, cell| heating.cell(start + cell, work)) {
                let heat = heat?;
                for (row, target) in heat.targets.iter().enumerate() {
                    for (group, index, c) in &target.active {
                        if sums[*group].ncols() == 0 {
                            sums[*group] = Mat::zeros(many, space.size[*group]);
                        }
                        for (from, factor) in heat.made_of[row] {
                            add(sums[*group].col_as_slice_mut(*index), c * factor, heat.of_class.col_as_slice(from));
                        }
                    }
                }
                for (r, parts) in heat.constant {
                    parts.iter().enumerate().for_each(|(k, part)| constant[(r, k)] += part);
                }
                heat.work.iter().for_each(|work| inner += work);
            }
        }
        Ok(Summed { values: sums.iter().map(|sum| sum.transpose().to_owned()).collect(), constant, inner })
    }

    /// This body of temperature as what heats another one.
    pub(crate) fn warm<'a>(&'a self, cases: Option<&'a [TemperatureCase]>, expansion: &'a [f64]) -> Result<Warm<'a>, Error> {
        let states: Vec<&InterfaceState> = cases.unwrap_or_default().iter().map(|case| &case.state).collect();
        states.iter().try_for_each(|state| self.check_state(state))?;
        let find = move || Arc::new(self.values_of_groups(&states).iter().map(|values| values.transpose().to_owned()).collect());
        let Factored { space, interiors, identity, .. } = &*self.factored;
        Ok(Warm {
            problem: &self.problem,
            space,
            interiors: interiors.as_ref(),
            own: Own { factors: identity, added: &self.added },
            expansion,
            cases,
            find: Box::new(find),
            values: OnceLock::new(),
        })
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

impl Heating<'_> {
    /// What a cell takes of the temperatures.
    fn cell(&self, cell: usize, work: &mut Workspace) -> Result<CellHeat, Error> {
        let Heating { elastic, heats, .. } = self;
        let class = heats.congruence.class[cell];
        let turn = &heats.congruence.turn[cell];
        let of_class = heats.of_cell(&self.warming, cell);
        let (modes, against) = (elastic.space.boundary_modes(elastic.mesh, cell), elastic.mesh.cells[cell].against);
        let from = turn.sources(&modes, against, heats.congruence.classes[class].edges);
        let below = of_class.ncols() / 2;
        let (matrix, scale) = (turn.matrix, turn.scale);
        // Components fastest.
        let of_mode = |(source, sign): &(usize, f64)| {
            matrix.map(|[a, b]| [(*source, scale * sign * a), (below + source, scale * sign * b)])
        };
        let made_of: Vec<[(usize, f64); 2]> = from.iter().flat_map(of_mode).collect();
        let targets = elastic.targets(cell, &modes);
        let motions = elastic.virtual_motion(&targets, elastic.columns - elastic.loads.cases - 1);
        let reaction = |motion: &[f64]| -> Vec<f64> {
            let mut forces = vec![0.0; of_class.nrows()];
            for (m, made_of) in motion.iter().zip(&made_of) {
                made_of.iter().for_each(|(from, factor)| add(&mut forces, -m * factor, of_class.col_as_slice(*from)));
            }
            forces
        };
        let moved = motions.iter().enumerate().filter(|(_, motion)| !motion.is_empty());
        let constant = moved.map(|(r, motion)| (r, reaction(motion))).collect();
        let inner = elastic.loads.inside(cell).then(|| self.inner(cell, work)).transpose()?;
        Ok(CellHeat { targets, of_class, made_of, constant, work: inner })
    }

    /// Work of the temperatures on what other load cases displace inside a cell.
    fn inner(&self, cell: usize, work: &mut Workspace) -> Result<Mat<f64>, Error> {
        let Heating { elastic, warming, .. } = self;
        let local = elastic.space.local_modes(elastic.mesh, cell);
        let edges = warming.thermal.space.edge_degrees(warming.thermal.mesh, cell);
        warming.strains(elastic, (cell, edges), (&local, None), work)?;
        let mut strains = std::mem::take(&mut work.load);
        let mut others: Vec<f64> = elastic.load_on_modes(cell, &local).col_iter().flat_map(|c| c.iter()).copied().collect();
        let (k, ni) = elastic.condensed(cell, &local, work)?;
        let [by_strain, others] = [&mut strains, &mut others].map(|load| eliminate(k.as_ref(), ni, load).get(..ni, ..));
        let given = warming.temperatures(cell, (edges, &Turn::NONE), by_strain.ncols());
        let inner = others.transpose() * (by_strain * given.transpose());
        work.load = strains;
        Ok(inner)
    }
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
