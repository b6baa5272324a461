//! Temperatures on the boundary of a cell as loads on its boundary, the interiors of both problems condensed; similar cells share them.
//!
//! Inside a cell a temperature without sources there follows from its boundary, `T_i = E T_b`, `E = -K_ii^-1 K_ib`. With `G` the load of thermal strains on
//! all modes of the cell, that on its boundary is `B T_b`, `B = [-L_21 L_11^-1, 1] G [E; 1]` with the factor of the elastic stiffness. A cell `c` times as
//! large and turned by `R` has `c R B`. Where the temperatures are known before, and fewer than modes on the boundary, `B T_b` is made at once.

use crate::assembly::Assembly;
use crate::basis::{LocalModes, SpaceKind};
use crate::cell_matrix::{SharedMatrices, boundary_block, map_cells};
use crate::check::check_temperature;
use crate::congruence::{Congruence, Turn};
use crate::edge_load::Loads;
use crate::element::Workspace;
use crate::error::Error;
use crate::interiors::{Interiors, from_boundary};
use crate::kinematics::Kinematics;
use crate::known_heat::{KnownHeat, OnGroups, Own, TemperatureCase};
use crate::material::Material;
use crate::mesh::Mesh;
use crate::on_boundary::by_cell;
use crate::problem::BodyProblem;
use crate::space::Space;
use faer::linalg::matmul::matmul;
use faer::linalg::triangular_solve::solve_lower_triangular_in_place;
use faer::{Accum, Mat, MatMut, MatRef, Par};
use std::sync::{Arc, OnceLock};

/// A body of temperature on the same mesh, by how much each material expands, 1/K, and temperatures where they are known.
pub(crate) struct Warm<'a> {
    pub(crate) problem: &'a BodyProblem,
    pub(crate) space: &'a Space,
    /// How the interiors of its cells follow from their boundaries, where that was kept.
    pub(crate) interiors: Option<&'a Interiors>,
    /// Which body it is.
    pub(crate) own: Own<'a>,
    pub(crate) expansion: &'a [f64],
    pub(crate) cases: Option<&'a [TemperatureCase]>,
    /// Finds these on the groups of its unknowns.
    pub(crate) find: Box<dyn Fn() -> OnGroups + Sync + 'a>,
    /// What that found, once it is asked for.
    pub(crate) values: OnceLock<OnGroups>,
}

/// What the temperatures of another body on the same mesh do to the cells of one.
pub(crate) struct Warming<'a> {
    /// The problem of temperature.
    pub(crate) thermal: Assembly<'a>,
    warm: Warm<'a>,
}

/// The loads of temperatures on the boundary modes of the cells of each class.
pub(crate) struct CellHeats {
    pub(crate) congruence: Congruence,
    /// Largest degree of temperature that any member of a class has on each edge, in the numbering of the first cell.
    pub(crate) edges: Vec<[usize; 4]>,
    /// Of each class, rows as in its condensed matrix: `B`, a column for each unsigned boundary mode of temperature, or `B T_b` of the temperatures that
    /// are known, of one member after the other.
    loads: Vec<Mat<f64>>,
    /// Number of each cell among the members of its class, where that holds `B T_b`.
    member: Vec<Option<usize>>,
    /// What they were made for.
    mesh: Arc<Mesh>,
    conductors: Vec<Material>,
    kinematics: Kinematics,
    space: SpaceKind,
    expansion: Vec<f64>,
    cases: Option<KnownHeat>,
}

impl CellHeats {
    /// Those of a body that was made without.
    pub(crate) fn new(elastic: &Assembly<'_>, problem: &BodyProblem, warming: &Warming<'_>) -> Result<CellHeats, Error> {
        let mut congruence = Congruence::of(problem, elastic.space);
        if !warming.is_alike(&congruence) {
            congruence = Congruence::none(elastic.mesh, elastic.space);
        }
        elastic.heated_matrices(congruence, warming).map(|(_, heats)| heats)
    }

    /// Whether they were made for these temperatures.
    pub(crate) fn are_for(&self, warming: &Warming<'_>) -> bool {
        let Warm { problem, own, expansion, cases, .. } = &warming.warm;
        let cases = cases.unwrap_or_default();
        Arc::ptr_eq(&self.mesh, &problem.mesh)
            && self.conductors == problem.materials
            && self.kinematics == problem.kinematics
            && self.space == problem.space
            && self.expansion == *expansion
            && self.edges == warming.edges(&self.congruence)
            && self.cases.as_ref().is_none_or(|known| known.are(*own, cases))
    }

    /// Loads of the temperatures of `warming` on the boundary modes of the class of a cell, `temperatures x rows of the class`.
    pub(crate) fn of_cell(&self, warming: &Warming<'_>, cell: usize) -> Mat<f64> {
        let class = self.congruence.class[cell];
        let (loads, many) = (&self.loads[class], warming.many());
        match self.member[cell] {
            Some(member) => loads.get(.., member * many..(member + 1) * many).transpose().to_owned(),
            None => {
                warming.temperatures(cell, (self.edges[class], &self.congruence.turn[cell]), loads.ncols()) * loads.transpose()
            }
        }
    }
}

impl<'a> Warming<'a> {
    /// Refuses temperatures of another mesh, or with sources inside.
    pub(crate) fn new((problem, space): (&BodyProblem, &Space), warm: Warm<'a>) -> Result<Warming<'a>, Error> {
        let loads = Loads::new(&warm.problem.mesh, &warm.problem.load_cases)?;
        check((problem, space), &warm, &loads)?;
        Ok(Warming { thermal: Assembly::new(warm.problem, warm.space, loads), warm })
    }

    /// The known temperatures on the groups of unknowns.
    fn values(&self) -> &OnGroups {
        self.warm.values.get_or_init(|| (self.warm.find)())
    }

    /// Takes the known temperatures on the groups of unknowns from what was made for them.
    pub(crate) fn take_values(&self, heats: &CellHeats) {
        heats.cases.iter().for_each(|known| drop(self.warm.values.set(Arc::clone(&known.values))));
    }

    /// Number of temperatures that are known.
    fn many(&self) -> usize {
        self.warm.cases.map_or(0, <[TemperatureCase]>::len)
    }

    /// Known temperatures of the members of each class on its boundary modes, a column each, of one member after the other, where they are fewer than
    /// such modes.
    pub(crate) fn known(&self, congruence: &Congruence, edges: &[[usize; 4]]) -> Vec<Option<Mat<f64>>> {
        let Some(cases) = self.warm.cases else { return vec![None; edges.len()] };
        let mut members = vec![Vec::new(); edges.len()];
        congruence.class.iter().enumerate().for_each(|(cell, class)| members[*class].push(cell));
        let class = |(members, edges): (Vec<usize>, &[usize; 4])| {
            let first = *members.first()?;
            let modes = self.thermal.space.modes_of(self.thermal.mesh, first, *edges, [false; 4]);
            let on_boundary = modes.modes - modes.interior;
            if members.len() * cases.len() >= on_boundary {
                return None;
            }
            let mut known = Mat::zeros(on_boundary, members.len() * cases.len());
            for (number, cell) in members.iter().enumerate() {
                let values = self.temperatures(*cell, (*edges, &congruence.turn[*cell]), on_boundary);
                known.get_mut(.., number * cases.len()..(number + 1) * cases.len()).copy_from(values.transpose());
            }
            Some(known)
        };
        members.into_iter().zip(edges).map(class).collect()
    }

    /// Temperatures that are known, above those without strain, a row each, on the unsigned boundary modes of the class of a cell, which has so many.
    pub(crate) fn temperatures(&self, cell: usize, (edges, turn): ([usize; 4], &Turn), many: usize) -> Mat<f64> {
        let (thermal, prescribed) = (&self.thermal, self.thermal.loads.cases);
        let cases = self.warm.cases.unwrap_or_default();
        let modes = thermal.space.boundary_modes(thermal.mesh, cell);
        let targets = thermal.targets(cell, &modes);
        let to = turn.sources(&modes, thermal.mesh.cells[cell].against, edges);
        let known = self.values();
        let mut values = Mat::zeros(cases.len(), many);
        for (row, (target, (mode, sign))) in targets.iter().zip(&to).enumerate() {
            let column = values.col_as_slice_mut(*mode);
            for (group, index, c) in &target.active {
                add(column, sign * c, known[*group].col_as_slice(*index));
            }
            let fixed: f64 = target.fixed.iter().map(|fixed| fixed.share * fixed.value).sum();
            if fixed == 0.0 && row >= modes.corners {
                continue;
            }
            for (value, TemperatureCase { state, reference, .. }) in column.iter_mut().zip(cases) {
                // The corners alone make up a constant.
                let above = if row < modes.corners { *reference } else { 0.0 };
                *value += sign * state.factors[prescribed] * fixed - above;
            }
        }
        values
    }

    /// Whether cells that are alike as elastic ones are so as conductors of heat.
    pub(crate) fn is_alike(&self, congruence: &Congruence) -> bool {
        let Assembly { mesh, kinematics, .. } = self.thermal;
        congruence.class.iter().zip(&congruence.turn).enumerate().all(|(cell, (class, turn))| {
            let material = mesh.cells[cell].material;
            let conductor = &self.warm.problem.materials[material];
            let first = congruence.classes[*class].first;
            cell == first
                || material == mesh.cells[first].material
                    && (conductor.is_isotropic(kinematics) || conductor.is_alike_after(turn.matrix))
        })
    }

    /// Largest degree of temperature that any member of a class has on each edge.
    pub(crate) fn edges(&self, congruence: &Congruence) -> Vec<[usize; 4]> {
        let mut edges = vec![[1; 4]; congruence.classes.len()];
        for (cell, (class, turn)) in congruence.class.iter().zip(&congruence.turn).enumerate() {
            let own = self.thermal.space.edge_degrees(self.thermal.mesh, cell);
            for (degree, (e, _)) in edges[*class].iter_mut().zip(turn.edge) {
                *degree = own[e].max(*degree);
            }
        }
        edges
    }

    /// The loads of the classes, of which some hold those of known temperatures; where any are known, kept for these alone.
    pub(crate) fn kept(
        &self,
        congruence: &Congruence,
        edges: Vec<[usize; 4]>,
        (loads, known): (Vec<Mat<f64>>, &[Option<Mat<f64>>]),
    ) -> CellHeats {
        let Warm { problem, own, expansion, cases, .. } = &self.warm;
        let mut members = vec![0; edges.len()];
        let member = congruence.class.iter().map(|class| {
            members[*class] += 1;
            known[*class].is_some().then_some(members[*class] - 1)
        });
        CellHeats {
            congruence: congruence.clone(),
            member: member.collect(),
            edges,
            loads,
            mesh: Arc::clone(&problem.mesh),
            conductors: problem.materials.clone(),
            kinematics: problem.kinematics,
            space: problem.space,
            expansion: expansion.to_vec(),
            cases: cases.map(|cases| KnownHeat::new(*own, cases, Arc::clone(self.values()))),
        }
    }

    /// Loads of the thermal strains on the modes `local` of a cell, into the workspace, a column for each temperature on its boundary modes, which are those
    /// of edges of these degrees: the `known` ones, or a unit on each.
    pub(crate) fn strains(
        &self,
        elastic: &Assembly<'_>,
        (cell, edges): (usize, [usize; 4]),
        (local, known): (&LocalModes, Option<&Mat<f64>>),
        work: &mut Workspace,
    ) -> Result<(), Error> {
        let thermal = &self.thermal;
        let modes = thermal.space.modes_of(thermal.mesh, cell, edges, [false; 4]);
        let made;
        let inside = match self.warm.interiors.and_then(|interiors| interiors.of(cell, edges)) {
            Some(inside) => inside,
            None => {
                let (k, ni) = thermal.condensed(cell, &modes, work)?;
                made = from_boundary(k.as_ref(), ni);
                &made
            }
        };
        let by_known = known.map(|known| inside * known);
        let inside = by_known.as_ref().unwrap_or(inside);
        let expansion = self.warm.expansion.get(elastic.mesh.cells[cell].material).copied().unwrap_or(0.0);
        let Workspace { coefficients_of_sums: coefficients, sums, load, .. } = work;
        coefficients.clear();
        coefficients.resize(modes.position.len() * inside.ncols(), 0.0);
        for ((k, inside), column) in inside.col_iter().enumerate().zip(coefficients.chunks_exact_mut(modes.position.len())) {
            let on_boundary = |mode: usize| match known {
                Some(known) => known[(mode, k)],
                None => f64::from(u8::from(mode == k)),
            };
            let ni = modes.interior;
            for (to, mode) in column.iter_mut().zip(&modes.position).filter(|(_, m)| **m != usize::MAX) {
                *to = expansion * if *mode < ni { inside[*mode] } else { on_boundary(*mode - ni) };
            }
        }
        elastic.strain_matrix((cell, local), coefficients, sums, load);
        Ok(())
    }
}

impl Assembly<'_> {
    /// Condensed matrices of all classes, and what temperatures load their cells with.
    pub(crate) fn heated_matrices(
        &self,
        congruence: Congruence,
        warming: &Warming<'_>,
    ) -> Result<(SharedMatrices, CellHeats), Error> {
        let edges = warming.edges(&congruence);
        let known = warming.known(&congruence, &edges);
        let loaded = self.loaded(&congruence);
        let made = map_cells(congruence.classes.len(), |work, k| {
            let class = &congruence.classes[k];
            let local = self.class_modes(class);
            warming.strains(self, (class.first, edges[k]), (&local, known[k].as_ref()), work)?;
            let mut load = std::mem::take(&mut work.load);
            let (matrix, ni) = self.condensed(class.first, &local, work)?;
            let heat = eliminate(matrix.as_ref(), ni, &mut load).get(ni.., ..).to_owned();
            let loads = self.loads_of(loaded.get(k), &local, (matrix.as_ref(), ni));
            let made = (boundary_block(matrix, ni), (heat, loads));
            work.load = load;
            Ok(made)
        });
        let made: Result<Vec<_>, Error> = made.into_iter().collect();
        let (matrices, (heats, loads)): (Vec<_>, (Vec<_>, Vec<_>)) = made?.into_iter().unzip();
        let heats = warming.kept(&congruence, edges, (heats, &known));
        Ok((SharedMatrices { congruence, matrices, loads: by_cell(self.mesh, loads) }, heats))
    }
}

/// Loads on all modes of a cell, a column each, from its stiffness with the first `ni` columns factorised: `y = L_11^-1 f_i`, then the loads on
/// the boundary with the interior condensed.
pub(crate) fn eliminate<'l>(k: MatRef<'_, f64>, ni: usize, load: &'l mut [f64]) -> MatRef<'l, f64> {
    let (l11, l21) = k.subcols(0, ni).split_at_row(ni);
    let many = load.len() / k.nrows();
    let (mut y, mut boundary) = MatMut::from_column_major_slice_mut(load, k.nrows(), many).split_at_row_mut(ni);
    solve_lower_triangular_in_place(l11, y.as_mut(), Par::Seq);
    matmul(boundary.as_mut(), Accum::Add, l21, y.as_ref(), -1.0, Par::Seq);
    MatRef::from_column_major_slice(load, k.nrows(), many)
}

/// Adds a multiple of numbers to others.
pub(crate) fn add(to: &mut [f64], factor: f64, from: &[f64]) {
    if factor != 0.0 {
        to.iter_mut().zip(from).for_each(|(to, from)| *to += factor * from);
    }
}

/// Refuses temperatures of another mesh, or with sources inside.
fn check((problem, space): (&BodyProblem, &Space), warm: &Warm<'_>, loads: &Loads<'_>) -> Result<(), Error> {
    let kinematics = warm.problem.kinematics;
    let refuse = |what: &str| Err(Error::NoMeaning { what: what.to_string(), kinematics: kinematics.words() });
    if !matches!(kinematics, Kinematics::Potential { .. } | Kinematics::AxisymmetricPotential) {
        return refuse("a temperature");
    }
    check_temperature((&problem.mesh, problem.kinematics), (&warm.problem.mesh, kinematics))?;
    let cells = problem.mesh.cells.len();
    let [own, other] = [&space.cell_degree, &warm.space.cell_degree];
    if let Some(cell) = (0..cells).find(|cell| own[*cell] != other[*cell]) {
        let what = format!("degree of the temperature in cell {cell}");
        return Err(Error::Count { what, given: other[cell], expected: own[cell] });
    }
    if (0..cells).any(|cell| loads.inside(cell)) {
        return refuse("a temperature with sources inside as load cases");
    }
    Ok(())
}
