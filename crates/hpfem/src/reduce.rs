//! From a problem to its reduced body.

use crate::additions::Additions;
use crate::assembly::Assembly;
use crate::cell_matrix::{Elements, map_cells};
use crate::effort::{Clock, Effort};
use crate::elimination::Condensed;
use crate::error::Error;
use crate::front::MEMORY_LIMIT;
use crate::interface::InterfaceOperator;
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
    pub(crate) kept_groups: Vec<usize>,
}

/// Reduces a body; `factors` tells whether the factorised fronts are kept.
pub(crate) fn reduce(
    problem: &BodyProblem<'_>,
    additions: &Additions<'_>,
    factors: bool,
    clock: Clock,
) -> Result<Reduction, Error> {
    let start = clock();
    let ordered = Ordered::new(problem, additions)?;
    let mesh = problem.mesh;
    if ordered.bytes > MEMORY_LIMIT {
        let unknowns = ordered.space.size.iter().sum();
        return Err(Error::TooLarge { unknowns, bytes: ordered.bytes, limit: MEMORY_LIMIT });
    }
    let after_order = clock() - start;
    let Ordered { space, walk, edge_loads, foundations, congruence, groups, size, kept, plan, bytes } = ordered;
    let assembly = Assembly::new(problem, &space, additions, edge_loads);
    let (columns, unit) = (assembly.columns, assembly.unit);
    let shared = assembly.shared_matrices(congruence)?;
    let forces = &additions.body_forces;
    let results = map_cells(mesh.cells.len(), |work, c| assembly.own_element(c, &groups[c], &shared, forces, work));
    let on_foundations = foundations.iter().zip(&groups[mesh.cells.len()..]);
    let on_foundations = on_foundations.map(|((e, f), groups)| Ok(Some(assembly.foundation(*e, f, groups))));
    let mut own = Vec::with_capacity(groups.len());
    let mut reaction_constant = Mat::zeros(3 * (problem.supports.len() + additions.pins.len()), columns);
    let mut interior_work = Mat::<f64>::zeros(columns, columns);
    for result in results.into_iter().chain(on_foundations) {
        let Some(element) = result? else {
            own.push(None);
            continue;
        };
        if let Some(work) = element.interior_work {
            let mut part = interior_work.as_mut().submatrix_mut(0, 0, work.nrows(), work.ncols());
            part += &work;
        }
        if let Some(constant) = element.constant {
            reaction_constant += &constant;
        }
        own.push(Some(element.matrix));
    }
    let assembled = clock() - start;
    let mut elements = Elements::new(&assembly, &groups, shared, own);
    let mut condensed = plan.run(&mut elements, &size, &kept, factors).map_err(|g| Error::NotHeld { place: place(mesh, g) })?;
    condensed.work += &interior_work;
    let finite = |m: &Mat<f64>| m.col_iter().all(|c| c.iter().all(|v| v.is_finite()));
    if !(finite(&condensed.rhs) && finite(&condensed.work)) {
        let quantity = "a load, or what is left of it after elimination,".into();
        return Err(Error::OutOfRange { quantity, value: f64::NAN, range: "finite" });
    }
    let factored = clock() - start;
    let kept_groups = kept[..kept.len() - 1].to_vec();
    let mut offsets = vec![None; space.size.len()];
    let mut unknowns = 0;
    for g in &kept_groups {
        offsets[*g] = Some(unknowns);
        unknowns += space.size[*g];
    }
    let trace = Trace::new(mesh, &space, problem.kinematics, &walk, |g| offsets[g], unknowns);
    let rigid_motions = free_motions(mesh, &space, problem.kinematics, &additions.held(mesh)?);
    let rigid_modes = rigid_columns(mesh, &space, &kept_groups, &rigid_motions, unknowns, problem.kinematics);
    let interface = InterfaceOperator {
        kinematics: problem.kinematics,
        trace,
        stiffness: faer::Scale(unit) * &condensed.stiffness,
        columns: faer::Scale(unit) * &condensed.rhs,
        work: faer::Scale(unit) * &condensed.work,
        rigid_modes,
        rigid_motions,
        load_cases: problem.load_cases.len(),
        frame: frame_unknowns(&space, &offsets),
        reaction_constant: faer::Scale(unit) * reaction_constant,
    };
    let effort = Effort {
        cells: mesh.cells.len(),
        unknowns: whole_size(mesh, &space),
        bytes,
        assemble: assembled - after_order,
        factor: after_order + factored - assembled,
    };
    Ok(Reduction { interface, effort, space, condensed, kept_groups })
}

/// Kept unknowns of the free motions of the rigid edge.
fn frame_unknowns(space: &Space, offsets: &[Option<usize>]) -> [Option<usize>; 3] {
    let mut frame = [None; 3];
    if let Some((group, rigid)) = &space.frame {
        let mut next = offsets[*group];
        for (slot, _) in frame.iter_mut().zip(rigid.free).filter(|(_, free)| *free) {
            *slot = next;
            next = next.map(|n| n + 1);
        }
    }
    frame
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
