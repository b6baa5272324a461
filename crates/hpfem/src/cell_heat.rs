//! Temperatures on the boundary of a cell as loads on its boundary, the interiors of both problems condensed; similar cells share them.
//!
//! Inside a cell a temperature without sources there follows from its boundary, `T_i = E T_b`, `E = -K_ii^-1 K_ib`. With `G` the load of thermal strains on
//! all modes of the cell, that on its boundary is `B T_b`, `B = [-L_21 L_11^-1, 1] G [E; 1]` with the factor of the elastic stiffness. A cell `c` times as
//! large and turned by `R` has `c R B`.

use crate::assembly::Assembly;
use crate::basis::{LocalModes, SpaceKind};
use crate::congruence::Congruence;
use crate::edge_load::Loads;
use crate::element::Workspace;
use crate::error::Error;
use crate::kinematics::Kinematics;
use crate::material::Material;
use crate::mesh::Mesh;
use crate::problem::BodyProblem;
use crate::space::Space;
use faer::linalg::matmul::matmul;
use faer::linalg::triangular_solve::{solve_lower_triangular_in_place, solve_upper_triangular_in_place};
use faer::{Accum, Mat, MatRef, Par};
use std::sync::Arc;

/// A body of temperature on the same mesh, and by how much each material expands, 1/K.
#[derive(Clone, Copy)]
pub(crate) struct Warm<'a> {
    pub(crate) problem: &'a BodyProblem,
    pub(crate) space: &'a Space,
    pub(crate) expansion: &'a [f64],
}

/// What the temperatures of another body on the same mesh do to the cells of one.
pub(crate) struct Warming<'a> {
    /// The problem of temperature.
    pub(crate) thermal: Assembly<'a>,
    warm: Warm<'a>,
}

/// The loads of unit temperatures on the boundary modes of the cells of each class.
pub(crate) struct CellHeats {
    pub(crate) congruence: Congruence,
    /// Largest degree of temperature that any member of a class has on each edge, in the numbering of the first cell.
    pub(crate) edges: Vec<[usize; 4]>,
    /// `B` of each class, rows as in its condensed matrix, a column for each unsigned boundary mode of temperature.
    pub(crate) loads: Vec<Mat<f64>>,
    /// What they were made for.
    mesh: Arc<Mesh>,
    conductors: Vec<Material>,
    kinematics: Kinematics,
    space: SpaceKind,
    expansion: Vec<f64>,
}

impl CellHeats {
    /// Those of a body that was made without.
    pub(crate) fn new(elastic: &Assembly<'_>, problem: &BodyProblem, warming: &Warming<'_>) -> Result<Option<CellHeats>, Error> {
        let mut congruence = Congruence::of(problem, elastic.space);
        if !warming.is_alike(&congruence) {
            congruence = Congruence::none(elastic.mesh, elastic.space);
        }
        elastic.shared_matrices(congruence, Some(warming)).map(|(_, heats)| heats)
    }

    /// Whether they were made for these temperatures.
    pub(crate) fn are_for(&self, warming: &Warming<'_>) -> bool {
        let Warm { problem, expansion, .. } = warming.warm;
        Arc::ptr_eq(&self.mesh, &problem.mesh)
            && self.conductors == problem.materials
            && self.kinematics == problem.kinematics
            && self.space == problem.space
            && self.expansion == expansion
            && self.edges == warming.edges(&self.congruence)
    }
}

impl<'a> Warming<'a> {
    /// Refuses temperatures of another mesh, or with sources inside.
    pub(crate) fn new((problem, space): (&BodyProblem, &Space), warm: Warm<'a>) -> Result<Warming<'a>, Error> {
        let loads = Loads::new(&warm.problem.mesh, &warm.problem.load_cases)?;
        check((problem, space), warm, &loads)?;
        Ok(Warming { thermal: Assembly::new(warm.problem, warm.space, loads), warm })
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

    /// The loads of the classes, kept for these temperatures.
    pub(crate) fn kept(&self, congruence: &Congruence, edges: Vec<[usize; 4]>, loads: Vec<Mat<f64>>) -> CellHeats {
        let Warm { problem, expansion, .. } = self.warm;
        CellHeats {
            congruence: congruence.clone(),
            edges,
            loads,
            mesh: Arc::clone(&problem.mesh),
            conductors: problem.materials.clone(),
            kinematics: problem.kinematics,
            space: problem.space,
            expansion: expansion.to_vec(),
        }
    }

    /// Loads of the thermal strains on the modes `local` of a cell, a column for each unit temperature on its boundary modes, which are those of
    /// edges of these degrees.
    pub(crate) fn strains(
        &self,
        elastic: &Assembly<'_>,
        (cell, edges): (usize, [usize; 4]),
        local: &LocalModes,
        work: &mut Workspace,
    ) -> Result<Mat<f64>, Error> {
        let thermal = &self.thermal;
        let modes = thermal.space.modes_of(thermal.mesh, cell, edges, [false; 4]);
        let (k, ni) = thermal.condensed(cell, &modes, work)?;
        let (l11, l21) = k.as_ref().subcols(0, ni).split_at_row(ni);
        let mut inside = l21.transpose().to_owned();
        solve_upper_triangular_in_place(l11.transpose(), inside.as_mut(), Par::Seq);
        let expansion = self.warm.expansion.get(elastic.mesh.cells[cell].material).copied().unwrap_or(0.0);
        let coefficient = |m: usize, k: usize| match modes.position[m] {
            usize::MAX => 0.0,
            mode if mode < ni => -expansion * inside[(mode, k)],
            mode if mode - ni == k => expansion,
            _ => 0.0,
        };
        let coefficients = Mat::from_fn(modes.position.len(), inside.ncols(), coefficient);
        Ok(elastic.strain_matrix(cell, local, coefficients.as_ref()))
    }
}

/// Loads on all modes of a cell, a column each, from its stiffness with the first `ni` columns factorised: `y = L_11^-1 f_i`, then the loads on
/// the boundary with the interior condensed.
pub(crate) fn eliminate(k: MatRef<'_, f64>, ni: usize, mut load: Mat<f64>) -> Mat<f64> {
    let (l11, l21) = k.subcols(0, ni).split_at_row(ni);
    let (mut y, mut boundary) = load.as_mut().split_at_row_mut(ni);
    solve_lower_triangular_in_place(l11, y.as_mut(), Par::Seq);
    matmul(boundary.as_mut(), Accum::Add, l21, y.as_ref(), -1.0, Par::Seq);
    load
}

/// Refuses temperatures of another mesh, or with sources inside.
fn check((problem, space): (&BodyProblem, &Space), warm: Warm<'_>, loads: &Loads<'_>) -> Result<(), Error> {
    let kinematics = warm.problem.kinematics;
    let refuse = |what: &str| Err(Error::NoMeaning { what: what.to_string(), kinematics: kinematics.words() });
    if !matches!(kinematics, Kinematics::Potential { .. } | Kinematics::AxisymmetricPotential) {
        return refuse("a temperature");
    }
    if problem.kinematics.components() != 2 {
        return Err(Error::NoMeaning { what: "a thermal strain".to_string(), kinematics: problem.kinematics.words() });
    }
    let [cells, given] = [&problem.mesh, &warm.problem.mesh].map(|mesh| mesh.cells.len());
    if cells != given {
        return Err(Error::Count { what: "cells of the temperature".into(), given, expected: cells });
    }
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
