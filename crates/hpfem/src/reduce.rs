//! From a problem to its reduced body.

use crate::assembly::Assembly;
use crate::cell_heat::{CellHeats, Warm, Warming};
use crate::cell_matrix::{Elements, SharedMatrices, map_cells};
use crate::effort::{Clock, Effort};
use crate::elimination::Condensed;
use crate::error::Error;
use crate::freedom::Foundation;
use crate::front::MEMORY_LIMIT;
use crate::interface::InterfaceOperator;
use crate::interiors::Interiors;
use crate::kept::Kept;
use crate::mesh::Mesh;
use crate::ordered::{Ordered, whole_size};
use crate::problem::BodyProblem;
use crate::rigid::{free_motions, rigid_columns};
use crate::space::Space;
use crate::trace::Trace;
use faer::Mat;

/// A reduced body, its problem aside.
pub(crate) struct Reduction {
    pub(crate) interface: InterfaceOperator,
    pub(crate) effort: Effort,
    pub(crate) space: Space,
    pub(crate) condensed: Condensed,
    pub(crate) kept: Kept,
    /// What temperatures do to its cells, where they were asked for.
    pub(crate) heats: Option<CellHeats>,
    /// How the interiors of its cells follow from their boundaries, where that was to be kept.
    pub(crate) interiors: Option<Interiors>,
}

/// What is kept of a reduction.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Keep {
    /// The interface alone.
    Interface,
    /// The factorised fronts as well.
    Fronts,
    /// These, and how the interiors of the cells follow from their boundaries.
    Interiors,
}

/// Reduces a body and keeps what is asked for; `warm` tells with whose temperatures, by the thermal expansion of each material,
/// its cells are to be loaded.
pub(crate) fn reduce(problem: &BodyProblem, keep: Keep, clock: Clock, warm: Option<Warm<'_>>) -> Result<Reduction, Error> {
    let start = clock();
    let ordered = Ordered::new(problem)?;
    let mesh = &*problem.mesh;
    if ordered.bytes > MEMORY_LIMIT {
        let unknowns = ordered.space.size.iter().sum();
        return Err(Error::TooLarge { unknowns, bytes: ordered.bytes, limit: MEMORY_LIMIT });
    }
    let after_order = clock() - start;
    let Ordered { space, kept, loads, foundations, congruence, groups, size, last, plan, bytes } = ordered;
    let assembly = Assembly::new(problem, &space, loads);
    let warming = warm.map(|warm| Warming::new((problem, &space), warm)).transpose()?;
    let warming = warming.filter(|warming| warming.is_alike(&congruence));
    let (shared, heats, interiors) = match &warming {
        Some(warming) => assembly.heated_matrices(congruence, warming).map(|(shared, heats)| (shared, Some(heats), None))?,
        None => {
            let (shared, interiors) = assembly.shared_matrices(congruence, keep == Keep::Interiors)?;
            (shared, None, interiors)
        }
    };
    let Own { matrices, reaction_constant, interior_work } = own_elements(&assembly, &groups, &foundations, &shared)?;
    let assembled = clock() - start;
    let mut elements = Elements::new(&assembly, &groups, shared, matrices);
    let mut condensed = plan
        .run(&mut elements, &size, &last, (keep != Keep::Interface, assembly.unit))
        .map_err(|g| mesh.hinge().unwrap_or_else(|| Error::NoStiffness { place: place(mesh, g) }))?;
    condensed.work += &interior_work;
    let finite = |m: &Mat<f64>| m.col_iter().all(|c| c.iter().all(|v| v.is_finite()));
    if !(finite(&condensed.rhs) && finite(&condensed.work) && finite(&reaction_constant)) {
        let first = |m: &Mat<f64>| m.col_iter().position(|c| c.iter().any(|v| !v.is_finite()));
        let works = || (0..condensed.work.ncols()).find(|k| !condensed.work[(*k, *k)].is_finite());
        let column = first(&condensed.rhs).or_else(works).or_else(|| first(&reaction_constant));
        let quantity = match column.and_then(|column| problem.load_cases.get(column)) {
            Some(case) => format!("a load of load case \"{}\", or what is left of it after elimination,", case.name),
            None => "a load, or what is left of it after elimination,".into(),
        };
        return Err(Error::OutOfRange { quantity, value: f64::NAN, range: "finite" });
    }
    let factored = clock() - start;
    let interface = interface(&assembly, problem, &kept, &mut condensed, &reaction_constant)?;
    let effort = Effort {
        cells: mesh.cells.len(),
        unknowns: whole_size(mesh, &space),
        bytes,
        assemble: assembled - after_order,
        factor: after_order + factored - assembled,
    };
    Ok(Reduction { interface, effort, space, condensed, kept, heats, interiors })
}

/// What the elements that are no shared ones make up.
struct Own {
    /// The matrix of each element; `None` where it is that of its class.
    matrices: Vec<Option<Vec<f64>>>,
    /// Constant parts of the reactions, `reactions x columns`.
    reaction_constant: Mat<f64>,
    /// Work of body forces on the interior they displace, `columns x columns`.
    interior_work: Mat<f64>,
}

/// The elements with loads or supports and those of foundations, summed up in order.
fn own_elements(
    assembly: &Assembly<'_>,
    groups: &[Vec<usize>],
    foundations: &[(usize, &Foundation)],
    shared: &SharedMatrices,
) -> Result<Own, Error> {
    let (cells, columns) = (assembly.mesh.cells.len(), assembly.columns);
    let results = map_cells(cells, |work, c| assembly.own_element(c, &groups[c], shared, work));
    let on_foundations = foundations.iter().zip(&groups[cells..]);
    let on_foundations = on_foundations.map(|((e, f), groups)| Ok(Some(assembly.foundation(*e, f, groups))));
    let mut matrices = Vec::with_capacity(groups.len());
    let mut reaction_constant = Mat::zeros(columns - assembly.loads.cases - 1, columns);
    let mut interior_work = Mat::<f64>::zeros(columns, columns);
    for result in results.into_iter().chain(on_foundations) {
        let Some(element) = result? else {
            matrices.push(None);
            continue;
        };
        if let Some(work) = element.interior_work {
            let mut part = interior_work.as_mut().submatrix_mut(0, 0, work.nrows(), work.ncols());
            part += &work;
        }
        if let Some(constant) = element.constant {
            reaction_constant += &constant;
        }
        matrices.push(Some(element.matrix));
    }
    Ok(Own { matrices, reaction_constant, interior_work })
}

/// The interface operator in the units of the problem.
fn interface(
    assembly: &Assembly<'_>,
    problem: &BodyProblem,
    kept: &Kept,
    condensed: &mut Condensed,
    reaction_constant: &Mat<f64>,
) -> Result<InterfaceOperator, Error> {
    let Assembly { mesh, space, kinematics, .. } = *assembly;
    let unit = faer::Scale(assembly.unit);
    let rigid_motions = free_motions(problem, space)?;
    let mut traces = kept.walks.iter().map(|walk| Trace::new(mesh, space, kinematics, (kept, walk)));
    let trace = traces.next().unwrap_or_else(|| Trace::new(mesh, space, kinematics, (kept, &[])));
    Ok(InterfaceOperator {
        kinematics,
        trace,
        more_traces: traces.collect(),
        stiffness: std::mem::replace(&mut condensed.stiffness, Mat::new()),
        columns: unit * &condensed.rhs,
        work: unit * &condensed.work,
        rigid_modes: rigid_columns(mesh, space, kinematics, kept, &rigid_motions),
        rigid_motions,
        load_cases: problem.load_cases.iter().map(|case| case.name.clone()).collect(),
        frame: kept.frame(space),
        reaction_constant: unit * reaction_constant,
    })
}

/// Words for the place of a group.
fn place(mesh: &Mesh, group: usize) -> String {
    let at = |x: [f64; 2]| format!("({:.4}, {:.4})", x[0], x[1]);
    match group.checked_sub(mesh.vertices.len()) {
        None => format!("the vertex at {}", at(mesh.vertices[group])),
        Some(e) if e < mesh.edges.len() => {
            format!("the edge around {}", at(mesh.edges[e].curve.point(0.0)))
        }
        Some(_) => "the rigid edge".to_string(),
    }
}
