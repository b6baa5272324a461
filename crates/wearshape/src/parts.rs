//! The bodies of a scene as finite element problems of one discretisation.

use std::sync::Arc;

use hpfem::{
    Body, BodyProblem, Direction, EdgeTraction, InterfaceOperator, Kinematics, LoadCase, Mesh, RigidEdge, Sizes, Support,
    TemperatureCase,
};
use meshing::{self, AXIS, BodyLoad, CONTACT, Couple, LOAD, LoadedEdge};
use scene::{Component, Fault, LoadKind};

use crate::degrees::degrees;
use crate::effort::{Clock, Effort};
use crate::level::Level;
use crate::step::Step;

/// Kind of error of a body that is held, and too slender or too unlike in its parts for the digits there are.
pub(crate) const NO_STIFFNESS: &str = "no-stiffness";

/// Everything a body of one level is made of.
pub(crate) struct BodyParts {
    key: &'static str,
    problem: BodyProblem,
    /// What holds it.
    pub held: Held,
}

/// What holds a body.
#[derive(Debug, Clone)]
pub(crate) struct Held {
    /// Names of the edges with a reaction, one a support; none is a plane of symmetry.
    pub names: Vec<String>,
    /// Load cases of what acts on the mass of the body, and the force [F_x, F_z] (N) and moment about the origin (N mm) by which the last of the edges, which is
    /// rigid, carries each.
    pub carried: Vec<(usize, [f64; 3])>,
}

/// Load cases of body 1: a load of 1 N, then mean displacement functionals of the load edge along x, z, and in rotation.
pub(crate) const CASES: [&str; 4] = ["load", "mean x", "mean z", "mean turn"];

/// Columns of the mean displacement functionals.
pub(crate) const MEAN_COLUMNS: [usize; 3] = [1, 2, 3];

/// What temperatures are to do to a body.
pub(crate) enum BodyHeat<'a> {
    /// Of itself as a problem of temperature, of whose temperatures some are known already, with the thermal expansion of its materials (1/K).
    Field { temperature: &'a Body, known: Option<&'a [TemperatureCase]>, expansion: Vec<f64> },
    /// Load cases of strains that are known at every place.
    Strains(Vec<LoadCase>),
}

impl BodyParts {
    /// Body 1 (`shaped`) or body 2 on its mesh, with the degrees of its cells.
    fn new(couple: &Couple, shaped: bool, mesh: Mesh, degrees: Vec<usize>, kinematics: Kinematics) -> Result<BodyParts, Fault> {
        let body = &couple.bodies[usize::from(!shaped)];
        let key = body.key;
        let materials = body.elastic().map_err(|error| {
            Fault::at(format!("{key}.material"), "wrong-value", error.to_string(), "give young > 0 and poisson below 0.5")
        })?;
        let pin = body.pin().filter(|_| shaped && kinematics != Kinematics::Torsion);
        let rigid = Some(&couple.load).filter(|_| shaped && couple.has_rigid_edge() && !couple.moves_one_way());
        let (mut supports, mut support_names) = (held_edges(body, rigid, kinematics), Vec::new());
        support_names.extend(supports.iter().map(|support| format!("{key}.{}", support.boundary)));
        if mesh.boundaries.iter().any(|name| name == AXIS) {
            supports.push(Support::hold(AXIS, Direction::First));
            support_names.push(String::new());
        }
        // The reaction of an edge that turns about a pin, or is guided, is the last one.
        support_names.extend(pin.map(|(edge, _)| format!("{key}.{edge}")));
        let rigid = rigid.filter(|_| kinematics != Kinematics::Torsion);
        support_names.extend(rigid.map(|load| format!("{key}.{}", load.edge)));
        let rigid_edge = rigid.map(|load| rigid_edge(body, load, &mesh, kinematics));
        let mut load_cases = match (shaped, kinematics) {
            (true, Kinematics::Torsion) | (false, _) => Vec::new(),
            (true, _) => load_cases(couple, &mesh, kinematics),
        };
        let mut carried = Vec::new();
        for load in body.loads.iter().filter(|_| kinematics != Kinematics::Torsion) {
            if rigid.is_some() && load.has_resultant() {
                let force = meshing::resultant(*load, (&mesh, &body.densities()), kinematics, [0.0; 2]);
                carried.push((load_cases.len(), force.map(|force| -force)));
            }
            load_cases.push(by_mass(body, *load, shaped, (&mesh, kinematics)));
        }
        let problem = BodyProblem {
            degrees,
            materials,
            supports,
            edge_reaction: pin.is_some() || rigid.is_some(),
            rigid_edge: rigid_edge.or(pin.map(turning)),
            load_cases,
            ..BodyProblem::new(mesh, 1, kinematics).keep(CONTACT)
        };
        Ok(BodyParts { key, problem, held: Held { names: support_names, carried } })
    }

    /// The mesh.
    pub(crate) fn mesh(&self) -> &Arc<Mesh> {
        &self.problem.mesh
    }

    /// The degrees of its cells.
    pub(crate) fn degrees(&self) -> &[usize] {
        &self.problem.degrees
    }

    /// The degrees of the cells at its contact surface, added up.
    fn contact_degrees(&self) -> usize {
        let mesh = self.mesh();
        let (cells, edges) = (mesh.edge_cells(), mesh.boundary(CONTACT).unwrap_or_default());
        edges.iter().filter_map(|edge| cells[*edge].first()).map(|(cell, _)| self.problem.degrees[*cell]).sum()
    }

    /// The wedge of the body at a vertex of its boundary.
    pub(crate) fn corner(&self, vertex: usize, kinematics: Kinematics) -> Option<hpfem::Corner> {
        hpfem::Corner::at(self.mesh(), vertex, kinematics, &self.problem.materials, &self.problem.supports).ok().flatten()
    }

    /// Assembles and reduces the body.
    pub(crate) fn reduce(&self, clock: Clock) -> Result<Body, Fault> {
        Body::timed(self.problem.clone(), clock).map_err(|error| self.not_held(&error))
    }

    /// Assembles and reduces the body for temperatures that are to load it.
    fn reduce_for(&self, heat: Option<BodyHeat<'_>>, clock: Clock) -> Result<Body, Fault> {
        let mut problem = self.problem.clone();
        let reduced = match heat {
            None => Body::timed(problem, clock),
            Some(BodyHeat::Field { temperature, known, expansion }) => {
                Body::for_heat(problem, temperature, known, &expansion, clock)
            }
            Some(BodyHeat::Strains(cases)) => {
                problem.load_cases.extend(cases);
                Body::timed(problem, clock)
            }
        };
        reduced.map_err(|error| self.not_held(&error))
    }

    /// Reduces the body to its contact edge, keeping nothing of its inside.
    pub(crate) fn interface(&self, clock: Clock) -> Result<(InterfaceOperator, hpfem::Effort), Fault> {
        Body::interface_timed(&self.problem, clock).map_err(|error| self.not_held(&error))
    }

    /// What the reduction takes.
    fn sizes(&self) -> Result<Sizes, Fault> {
        Body::sizes(&self.problem).map_err(|error| self.not_held(&error))
    }

    fn not_held(&self, error: &hpfem::Error) -> Fault {
        if matches!(error, hpfem::Error::NoStiffness { .. }) {
            let remedy = "bring lengths and moduli of the body closer to each other";
            return Fault::at(format!("{}.geometry", self.key), NO_STIFFNESS, error.to_string(), remedy);
        }
        let remedy = "hold it by supports so that only the load's own motions stay free";
        Fault::at(format!("{}.support", self.key), "not-held", error.to_string(), remedy)
    }
}

/// The components held on the edges of a body, but for those of its rigid edge, which are motions.
fn held_edges(body: &meshing::Body, rigid: Option<&LoadedEdge>, kinematics: Kinematics) -> Vec<Support> {
    let torsion = kinematics == Kinematics::Torsion;
    let direction = |component: &Component| match component {
        Component::Phi => torsion.then_some(Direction::First),
        Component::X => (!torsion).then_some(Direction::First),
        Component::Z => (!torsion).then_some(Direction::Second),
    };
    let mut supports = Vec::new();
    for (edge, held) in &body.supports {
        if torsion || !rigid.is_some_and(|load| load.is(edge)) {
            supports.extend(held.components().iter().filter_map(direction).map(|direction| Support::hold(edge, direction)));
        }
        if let scene::Support::Roller(angle) = held {
            supports.push(Support::sliding(edge, angle.0));
        }
    }
    supports
}

/// A load of a body by its mass. What it has as a resultant on body 1 the loaded edge carries.
fn by_mass(body: &meshing::Body, load: BodyLoad, shaped: bool, (mesh, kinematics): (&Mesh, Kinematics)) -> LoadCase {
    let densities = body.densities();
    let case = load.case(&densities, kinematics.is_revolved());
    if !(shaped && load.has_resultant()) {
        return case;
    }
    let edge = LoadedEdges::of(mesh, kinematics);
    let [x, z, moment] = meshing::resultant(load, (mesh, &densities), kinematics, edge.middle);
    let (area, inertia, middle) = (edge.area, edge.inertia, edge.middle);
    let turning = if kinematics.is_revolved() { 0.0 } else { moment / inertia };
    let carried = move |p: &hpfem::BoundaryPoint| {
        let [dx, dz] = [p.position[0] - middle[0], p.position[1] - middle[1]];
        [-x / area + turning * dz, -z / area - turning * dx]
    };
    case.with(EdgeTraction::new(LOAD, carried))
}

/// An edge that turns about a pin.
fn turning((edge, pin): (&str, [f64; 2])) -> RigidEdge {
    RigidEdge { boundary: edge.into(), reference: pin, free: [false, false, true] }
}

/// The rigid edge of body 1.
fn rigid_edge(body: &meshing::Body, load: &LoadedEdge, mesh: &Mesh, kinematics: Kinematics) -> RigidEdge {
    let held = body.supports.get(&load.edge);
    let holds = |component| held.is_some_and(|held| held.holds(component));
    // A support along x that ends at the edge, level with it, holds the edge along x.
    let vertices = |name: &str| -> Vec<usize> {
        mesh.boundary(name).unwrap_or_default().into_iter().flat_map(|e| mesh.edges[e].vertices).collect()
    };
    let own = vertices(LOAD);
    let meets = |edge: &str| vertices(edge).iter().any(|v| own.contains(v));
    let along_x = body.supports.iter().any(|(edge, held)| held.holds(Component::X) && meets(edge));
    let about = load.about;
    let height = mesh.boundary(LOAD).ok().and_then(|edges| edges.first().map(|e| mesh.edges[*e].curve.point(0.0)[1]));
    let revolved = kinematics.is_revolved();
    RigidEdge {
        boundary: LOAD.into(),
        reference: [about[0], height.unwrap_or(about[1])],
        // A rotation prescribed as zero is held; another one is a motion.
        free: [!along_x && !revolved, !holds(Component::Z), !revolved && !load.level],
    }
}

/// How the contact surfaces of two bodies lie to each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Meeting {
    /// On each other.
    Together,
    /// Across a gap, along the normals of body 2.
    Across,
    /// As arcs of two radii, by the angle.
    ByAngle,
    /// As two round bodies that touch from outside, by the arc length.
    ByArc,
}

/// The two bodies of a level before their reduction.
pub(crate) struct Parts {
    /// Body 1 and body 2.
    pub parts: [BodyParts; 2],
    /// How the surfaces lie to each other.
    pub meeting: Meeting,
}

impl Parts {
    /// Both bodies on their meshes.
    pub(crate) fn new(couple: &Couple, [first, second]: [Mesh; 2], level: Level, meeting: Meeting) -> Result<Parts, Fault> {
        Parts::of(couple, [first, second], level, couple.kinematics, meeting)
    }

    /// The scalar problem of twisting on the same meshes.
    pub(crate) fn torsion(couple: &Couple, [first, second]: [Mesh; 2], level: Level, meeting: Meeting) -> Result<Parts, Fault> {
        Parts::of(couple, [first, second], level, Kinematics::Torsion, meeting)
    }

    fn of(
        couple: &Couple,
        [first, second]: [Mesh; 2],
        level: Level,
        kinematics: Kinematics,
        meeting: Meeting,
    ) -> Result<Parts, Fault> {
        // What the waves of a gap do is smooth in no cell that is as long as they are.
        let level = if couple.longest < 1.0 { level.evenly() } else { level };
        let [of_first, of_second] = degrees([&first, &second], level, meeting == Meeting::Together);
        let parts = [
            BodyParts::new(couple, true, first, of_first, kinematics)?,
            BodyParts::new(couple, false, second, of_second, kinematics)?,
        ];
        Ok(Parts { parts, meeting })
    }

    /// The same with further load cases of body 1 and body 2, after those they have.
    pub(crate) fn with_loads(mut self, loads: [Vec<LoadCase>; 2]) -> Parts {
        self.parts.iter_mut().zip(loads).for_each(|(part, loads)| part.problem.load_cases.extend(loads));
        self
    }

    /// What the reduction of both bodies takes.
    pub(crate) fn sizes(&self) -> Result<[Sizes; 2], Fault> {
        Ok([self.parts[0].sizes()?, self.parts[1].sizes()?])
    }

    /// Unknowns on both contact surfaces, but for the last point of each.
    pub(crate) fn contact_unknowns(&self) -> usize {
        self.parts.iter().map(|part| 2 * part.contact_degrees()).sum()
    }

    /// Assembles and reduces both bodies.
    pub(crate) fn reduce(&self, clock: Clock) -> Result<([Body; 2], Effort), Fault> {
        let bodies = [self.parts[0].reduce(clock)?, self.parts[1].reduce(clock)?];
        let effort = counted([0, 1].map(|k| (&bodies[k].interface, bodies[k].effort)));
        Ok((bodies, effort))
    }

    /// The same for temperatures that are to load them.
    pub(crate) fn reduce_for(
        &self,
        [first, second]: [Option<BodyHeat<'_>>; 2],
        clock: Clock,
    ) -> Result<([Body; 2], Effort), Fault> {
        let bodies = [self.parts[0].reduce_for(first, clock)?, self.parts[1].reduce_for(second, clock)?];
        let effort = counted([0, 1].map(|k| (&bodies[k].interface, bodies[k].effort)));
        Ok((bodies, effort))
    }

    /// Reduces both bodies to their contact surface, keeping nothing of their inside.
    pub(crate) fn interfaces(&self, clock: Clock) -> Result<([InterfaceOperator; 2], Effort), Fault> {
        let [(first, effort), (second, other)] = [self.parts[0].interface(clock)?, self.parts[1].interface(clock)?];
        let effort = counted([(&first, effort), (&second, other)]);
        Ok(([first, second], effort))
    }
}

/// The work of reducing both bodies.
fn counted(bodies: [(&InterfaceOperator, hpfem::Effort); 2]) -> Effort {
    let total = |f: &dyn Fn(&hpfem::Effort) -> f64| bodies.iter().map(|(_, effort)| f(effort)).sum::<f64>();
    let mut effort = Effort::default();
    effort.add_seconds(Step::Assemble, total(&|e| e.assemble));
    effort.add_seconds(Step::Factor, total(&|e| e.factor));
    effort.counters.cells = bodies.iter().map(|(_, effort)| effort.cells).sum();
    effort.counters.dofs = bodies.iter().map(|(_, effort)| effort.unknowns).sum();
    effort.counters.trace_dofs = bodies.iter().map(|(interface, _)| interface.stiffness.nrows()).sum();
    effort.counters.factorisations = bodies.len();
    effort
}

/// The load for a force of 1 N, and the mean displacement functionals of the load edge.
fn load_cases(couple: &Couple, mesh: &Mesh, kinematics: Kinematics) -> Vec<LoadCase> {
    if couple.has_rigid_edge() {
        return Vec::new();
    }
    let load = &couple.load;
    let vertical = load.kind == LoadKind::Vertical;
    let LoadedEdges { area, projected, middle, .. } = LoadedEdges::of(mesh, kinematics);
    // The force of an actuator is that of its resultant, whichever way it acts.
    let actuator = couple.unit_load().filter(|_| couple.moves_one_way() && !vertical);
    let intensity = actuator.map_or(1.0 / projected, |unit| unit.intensity / kinematics.measure(1.0));
    let along = Some([load.direction.cos(), load.direction.sin()]).filter(|_| load.kind == LoadKind::Traction);
    let traction = move |point: &hpfem::BoundaryPoint| {
        let [nx, nz] = point.outward;
        match along {
            Some(along) => along.map(|d| intensity * d),
            None if vertical => [0.0, -intensity * nz.abs()],
            None => [-intensity * nx, -intensity * nz],
        }
    };
    let tractions = [
        EdgeTraction::new(LOAD, traction),
        EdgeTraction::new(LOAD, move |_| [1.0 / area, 0.0]),
        EdgeTraction::new(LOAD, move |_| [0.0, 1.0 / area]),
        EdgeTraction::new(LOAD, move |p| [(middle[1] - p.position[1]) / area, (p.position[0] - middle[0]) / area]),
    ];
    CASES.into_iter().zip(tractions).map(|(name, traction)| LoadCase::new(name).with(traction)).collect()
}

/// Sums over the loaded edges.
struct LoadedEdges {
    /// Area and projected area (mm^2).
    area: f64,
    projected: f64,
    /// Middle [x, z] (mm).
    middle: [f64; 2],
    /// Second moment of the area about the middle (mm^4).
    inertia: f64,
}

impl LoadedEdges {
    fn of(mesh: &Mesh, kinematics: Kinematics) -> LoadedEdges {
        let (mut area, mut projected, mut middle, mut second) = (0.0, 0.0, [0.0; 2], 0.0);
        for edge in mesh.boundary(LOAD).unwrap_or_default() {
            let curve = &mesh.edges[edge].curve;
            let rule = hpfem::gauss(12);
            for (t, w) in rule.points.iter().zip(&rule.weights) {
                let (x, d) = (curve.point(*t), curve.derivative(*t));
                let da = w * kinematics.measure(x[0]);
                area += da * d[0].hypot(d[1]);
                projected += da * d[0].abs();
                middle[0] += da * d[0].hypot(d[1]) * x[0];
                middle[1] += da * d[0].hypot(d[1]) * x[1];
                second += da * d[0].hypot(d[1]) * (x[0] * x[0] + x[1] * x[1]);
            }
        }
        let middle = middle.map(|m| m / area);
        LoadedEdges { area, projected, middle, inertia: second - area * (middle[0] * middle[0] + middle[1] * middle[1]) }
    }
}
