//! What does not keep the rules today. These lists may only shrink: an entry that is no longer needed is a finding.

/// Modules that hang in circles, by crate.
#[rustfmt::skip]
pub(super) const CIRCLES: &[(&str, usize)] = &[
    ("cli", 85),
    ("contact", 8),
    ("hpfem", 26),
    ("wear", 19),
    ("xtask", 12),
];

/// Functions of more than 60 lines.
#[rustfmt::skip]
pub(super) const LONG_FUNCTIONS: &[&str] = &[
    "cli/commands/run.rs: run",
    "cli/commands/sweep.rs: run",
    "cli/fe/contact.rs: solve_level",
    "cli/fe/ends.rs: Setting::result",
    "cli/fe/matching.rs: matched",
    "cli/fe/wear/level.rs: run",
    "cli/lints.rs: lints",
    "cli/plan.rs: Plan::new",
    "cli/report/page.rs: page",
    "cli/report/terminal.rs: verdict",
    "cli/reproduce/ring.rs: gaps",
    "cli/setup/bodies.rs: geometry",
    "cli/surface.rs: along",
    "cli/surface.rs: between",
    "contact/assemble.rs: ContactOperator::assemble",
    "contact/stage.rs: ContactOperator::stage",
    "hpfem/body.rs: reduce",
    "hpfem/cut.rs: Mesh::cut_through",
    "hpfem/elimination.rs: Plan::run",
    "hpfem/gmsh.rs: GmshMesh::read",
    "hpfem/mesh.rs: Mesh::joined",
    "hpfem/plan.rs: Plan::minimum_degree",
    "hpfem/refine_edges.rs: Mesh::cut_along",
    "hpfem/rigid.rs: free_motions",
    "hpfem/space.rs: Space::new",
    "hpfem/triangle_matrix.rs: triangle_stiffness",
    "shapeopt/implicit_stage.rs: Load::solve",
    "shapeopt/tolerance.rs: tolerances",
    "wear/cells.rs: Line::judge",
    "wear/reduce.rs: reduce",
    "wear/report.rs: report",
    "wear/sensitivity.rs: sensitivity",
    "wear/singular.rs: limit",
    "wear/solve.rs: newton",
];

/// Functions of more than 5 arguments.
#[rustfmt::skip]
pub(super) const WIDE_SIGNATURES: &[&str] = &[
    "cli/commands/sweep.rs: row",
    "cli/fe/recover.rs: twist",
    "cli/fe/wear/problem.rs: wear_problem",
    "cli/lints.rs: kern",
    "cli/report.rs: write",
    "cli/reproduce/drum.rs: by_q",
    "cli/reproduce/drum.rs: localisation",
    "contact/step.rs: ContactOperator::sheared",
    "hpfem/element.rs: stiffness",
    "hpfem/elimination.rs: add",
    "hpfem/plan.rs: Plan::ordered",
    "hpfem/rigid.rs: rigid_columns",
    "hpfem/singular.rs: corner",
    "hpfem/space.rs: Space::new",
    "hpfem/trace.rs: Trace::new",
    "hpfem/triangle_matrix.rs: triangle_stiffness",
    "shapeopt/implicit_stage.rs: Load::right",
    "xtask/verify/study/ladder.rs: ours",
    "xtask/verify/study/ladder.rs: solve",
];

/// Libraries that look at a clock or keep global state.
#[rustfmt::skip]
pub(super) const OUTSIDE_LIBRARIES: &[&str] = &[
    "hpfem/basis.rs: static TABLES",
    "hpfem/body.rs: std::time",
    "wear/quadrature.rs: static RULE",
];
