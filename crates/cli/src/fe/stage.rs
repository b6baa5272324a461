//! What the elastic stages share: the two reduced bodies of a level, the contact surface in the words of wear, common columns.

use std::sync::Arc;
use std::time::Instant;

use contact::{ContactLoad, ContactPoint, MomentBalance, Motion, Pair, Side};
use hpfem::{Body, InterfaceOperator, InterfaceState, Kinematics};
use nalgebra::Vector3;
use scene::{Fault, LoadKind, Scene};
use shapeopt::Gauge;

use crate::fe::bodies::{BodyParts, Level, MEAN_COLUMNS, kinematics};
use crate::fe::operators::{self, Place, Reduced};
use crate::fe::template::{Cut, Extent, meshes};
use crate::profile::Profile;
use crate::setup::Problem;
use crate::solution::{Reaction, Solution};
use crate::solve::{Options, Sampling, trapezoid_weights};
use crate::surface::Patch;

/// First and last degree of the ladder, and its step.
const DEGREES: [usize; 3] = [4, 16, 2];

/// A scene whose contact surface is known, ready for its elastic stages.
#[derive(Clone, Copy)]
pub(super) struct Stage<'a> {
    pub(super) problem: &'a Problem,
    pub(super) patch: &'a Patch,
    pub(super) extent: Extent,
}

/// The two bodies of a level before their reduction.
pub(super) struct Parts {
    pub(super) parts: [BodyParts; 2],
    /// Whether the surfaces face each other across a gap.
    pub(super) facing: bool,
}

impl<'a> Stage<'a> {
    pub(super) fn new(problem: &'a Problem) -> Result<Stage<'a>, Fault> {
        let none = || {
            let message = "the elastic stages do not know this contact surface yet";
            Fault::at("contact.edges", "not-available", message, "ask for the pressure alone: --set tasks=[pressure]")
        };
        let patch = problem.patch.as_ref().ok_or_else(none)?;
        let extent = Extent::of(patch.surface.shape()).ok_or_else(none)?;
        Ok(Stage { problem, patch, extent })
    }

    pub(super) fn scene(&self) -> &'a Scene {
        &self.problem.scene
    }

    /// Accuracy asked for.
    pub(super) fn accuracy(&self) -> f64 {
        accuracy(self.scene())
    }

    /// The fixed discretisation, if the scene has one.
    pub(super) fn fixed_level(&self) -> Option<Level> {
        fixed_level(self.scene())
    }

    /// The levels to solve: up to the fixed one, or until the caller has enough.
    pub(super) fn ladder(&self, options: Options) -> Vec<Level> {
        ladder(self.scene(), options)
    }

    /// Both bodies of a level with nodes at the ends of a pressure that does not fill the surface; without such ends as [`Stage::reduced`].
    pub(super) fn reduced_at(&self, level: Level, ends: &[f64], solution: &mut Solution) -> Result<Arc<Reduced>, Fault> {
        if ends.is_empty() {
            return self.reduced(level, Cut::Plain, solution);
        }
        let parts = self.parts(level, Cut::Ends(ends), solution)?;
        let reduced = Reduced::new(&parts, solution)?;
        solution.counters.factorisations += 2;
        reduced.count(&mut solution.counters);
        Ok(Arc::new(reduced))
    }

    /// Both bodies of a level, meshed and reduced unless that was done before.
    pub(super) fn reduced(&self, level: Level, cut: Cut<'static>, solution: &mut Solution) -> Result<Arc<Reduced>, Fault> {
        let place = Place { level, cut, torsion: false };
        // How far a round contact may reach follows from the load: such bodies fit no other run.
        if self.facing() {
            let reduced = Reduced::new(&self.parts(level, cut, solution)?, solution)?;
            solution.counters.factorisations += 2;
            reduced.count(&mut solution.counters);
            return Ok(Arc::new(reduced));
        }
        let reduced = self.problem.operators.get(self.scene(), place, solution, |solution| {
            let parts = self.parts(level, cut, solution)?;
            Reduced::new(&parts, solution)
        })?;
        reduced.count(&mut solution.counters);
        Ok(reduced)
    }

    /// Both bodies of a level in the scalar problem of twisting; kept unless their meshes are cut at ends of contact.
    pub(super) fn twisted(&self, level: Level, ends: &[f64], solution: &mut Solution) -> Result<Arc<Reduced>, Fault> {
        let make = |cut: Cut<'_>, solution: &mut Solution| {
            let parts = self.parts_in(level, cut, Kinematics::Torsion, solution)?;
            Reduced::new(&parts, solution)
        };
        if !ends.is_empty() {
            solution.counters.factorisations += 2;
            return make(Cut::Ends(ends), solution).map(Arc::new);
        }
        let place = Place { level, cut: Cut::Plain, torsion: true };
        self.problem.operators.get(self.scene(), place, solution, |solution| make(Cut::Plain, solution))
    }

    /// The scalar problem of the bodies of a contact in which body 1 is turned.
    pub(super) fn turned_pair(&self, level: Level, ends: &[f64], solution: &mut Solution) -> Result<Option<Arc<Reduced>>, Fault> {
        if crate::setup::turns(self.scene()).is_empty() { Ok(None) } else { self.twisted(level, ends, solution).map(Some) }
    }

    /// Whether the surfaces face each other across a gap.
    pub(super) fn facing(&self) -> bool {
        matches!(self.extent, Extent::Round { .. })
    }

    /// The meshes of both bodies with so many layers.
    pub(super) fn meshes(&self, layers: usize) -> Result<[hpfem::Mesh; 2], Fault> {
        meshes(self.scene(), self.extent, layers, Cut::Plain)
    }

    /// Meshes, supports and loads of both bodies.
    pub(super) fn parts(&self, level: Level, cut: Cut<'_>, solution: &mut Solution) -> Result<Parts, Fault> {
        self.parts_in(level, cut, kinematics(self.scene()), solution)
    }

    fn parts_in(&self, level: Level, cut: Cut<'_>, kinematics: Kinematics, solution: &mut Solution) -> Result<Parts, Fault> {
        let start = Instant::now();
        // The coordinate of a surface may fall along its path.
        let turned: Vec<f64> = if self.patch.backwards { cut.ends().iter().rev().map(|t| -t).collect() } else { Vec::new() };
        let cut = if turned.is_empty() { cut } else { Cut::Ends(&turned) };
        let [mesh1, mesh2] = meshes(self.scene(), self.extent, level.layers, cut)?;
        let parts = [
            BodyParts::new(self.scene(), true, mesh1, level, kinematics)?,
            BodyParts::new(self.scene(), false, mesh2, level, kinematics)?,
        ];
        note(solution, "mesh", start);
        Ok(Parts { parts, facing: self.facing() })
    }

    /// Coefficient of the friction shear on the bodies.
    pub(super) fn friction(&self) -> f64 {
        let contact = self.scene().contact.as_ref();
        let shear = contact.and_then(|c| c.shear).unwrap_or(true);
        if shear { contact.and_then(|c| c.friction).unwrap_or(0.0) } else { 0.0 }
    }

    /// A point of the contact surface with sliding speed and drag direction.
    pub(super) fn surface_point(&self, x: [f64; 2], n: [f64; 2], weight: f64) -> wear::SurfacePoint {
        self.patch.surface.point(Vector3::new(x[0], 0.0, x[1]), Vector3::new(n[0], 0.0, n[1]), weight)
    }

    /// Sense of the drag along a point's tangent: 1, -1, or 0 without sliding in the plane.
    pub(super) fn drag(&self, point: &ContactPoint) -> f64 {
        let along = self.surface_point(point.position, point.normal, 0.0).drag.dot(&Vector3::new(
            point.tangent[0],
            0.0,
            point.tangent[1],
        ));
        if along == 0.0 { 0.0 } else { along.signum() }
    }

    /// Whether body 1 is loaded through a rigid edge.
    pub(super) fn rigid_edge(&self) -> bool {
        self.scene().load.as_ref().is_some_and(|load| load.kind == Some(LoadKind::Rigid))
    }

    /// Whether the rigid part of a gap is prescribed instead of the smallest.
    pub(super) fn rigid_prescribed(&self) -> bool {
        let load = self.scene().load.as_ref().filter(|_| self.rigid_edge());
        load.is_some_and(|load| load.approach.is_some() || load.approach_time.is_some())
    }

    /// Rotation that is prescribed and not zero, or 0.
    pub(super) fn turned(&self) -> f64 {
        let load = self.scene().load.as_ref().filter(|_| self.rigid_edge());
        load.and_then(|load| load.tilt).map_or(0.0, |tilt| tilt.0)
    }

    /// Place x about which the rigid edge turns.
    pub(super) fn about(&self) -> f64 {
        self.scene().load.as_ref().and_then(|load| load.about).map_or(0.0, |about| about[0].0)
    }

    /// Load-case factors of body 1: the force alone.
    pub(super) fn cases(&self) -> Vec<f64> {
        let force = self.scene().load.as_ref().and_then(|load| load.force).map_or(0.0, |force| force.0);
        if self.rigid_edge() { vec![] } else { vec![force, 0.0, 0.0, 0.0] }
    }

    /// Load, motions of the rigid edge and friction of a contact solve.
    pub(super) fn contact_load(&self, points: &[ContactPoint]) -> ContactLoad {
        let mut contact = ContactLoad::factors(&self.cases(), &[]);
        contact.moment = MomentBalance::Pressure;
        if let Some(load) = self.scene().load.as_ref().filter(|_| self.rigid_edge()) {
            let force = load.force.map_or(0.0, |f| f.0);
            contact.motions[1] = match load.approach {
                Some(approach) => Motion::Prescribed { value: -approach.0 },
                None => Motion::Free { resultant: -force },
            };
            contact.motions[2] = match load.tilt {
                Some(tilt) => Motion::Prescribed { value: -tilt.0 },
                None => Motion::Free { resultant: -load.moment.map_or(0.0, |m| m.0) },
            };
        }
        if self.friction() > 0.0 {
            contact = contact.sliding(self.friction(), points.iter().map(|p| self.drag(p)).collect());
        }
        contact
    }

    /// What counts as body 1 unmoved: the rigid edge held, or the mean displacement of the load edge zero.
    pub(super) fn gauge(&self, pair: &Pair<'_>) -> Gauge {
        if self.rigid_edge() { Gauge::HeldEdge } else { Gauge::MeanOf(mean_columns(pair)) }
    }

    /// A state of body 1 with its rigid motion taken out.
    pub(super) fn held(&self, pair: &Pair<'_>, state: &InterfaceState) -> InterfaceState {
        let mut held = state.clone();
        self.gauge(pair).zero(pair.shaped, &mut held);
        held
    }

    /// Surface coordinate at the start of the path: minus half the length, or the radius there.
    pub(super) fn start(&self, pair: &Pair<'_>) -> f64 {
        let trace = pair.trace();
        match self.patch.surface.shape() {
            wear::Shape::Annulus { .. } => trace.boundary_point(0, -1.0).0.position[0],
            _ => -0.5 * trace.length(),
        }
    }

    /// Points of the path with trapezoid weights.
    pub(super) fn sample(&self, pair: &Pair<'_>, sampling: Sampling<'_>) -> Vec<ContactPoint> {
        let start = self.start(pair);
        let places = sampling.places([start, start + pair.trace().length()]);
        let weights = trapezoid_weights(&places);
        let place = |(s, weight): (&f64, f64)| {
            let mut point = pair.at_arc(s - start);
            point.weight = weight * pair.shaped.kinematics.measure(point.position[0]);
            point
        };
        places.iter().zip(weights).map(place).collect()
    }

    /// Columns that follow from a pressure and the states of both bodies.
    pub(super) fn profile(
        &self,
        pair: &Pair<'_>,
        points: &[ContactPoint],
        pressure: &[f64],
        states: [Option<&InterfaceState>; 2],
    ) -> Profile {
        let start = self.start(pair);
        let surface: Vec<wear::SurfacePoint> =
            points.iter().map(|p| self.surface_point(p.position, p.normal, p.weight)).collect();
        let mut profile = Profile::new(points.iter().map(|p| start + p.arc).collect(), &surface);
        let friction = self.scene().contact.as_ref().and_then(|c| c.friction).unwrap_or(0.0);
        let laws = crate::solve::pressure::wear_pair(self.scene(), friction);
        let held = states[0].map(|state| self.held(pair, state));
        let states = [held.as_ref(), states[1]];
        for (row, (point, on_surface)) in points.iter().zip(&surface).enumerate() {
            profile.pressure[row] = pressure[row];
            profile.shear[row] = self.friction() * pressure[row];
            if let Ok(pair) = &laws {
                let worn = (0..2).filter(|body| pair.wears(*body));
                let rate: f64 = worn.map(|body| wear::wear_rate(&pair.laws[body], pressure[row], on_surface.sliding_speed)).sum();
                profile.wear_rate[row] = 1e3 * rate;
            }
            // Without sliding in the plane tau is the tangent itself.
            let sense = if self.drag(point) < 0.0 { -1.0 } else { 1.0 };
            for (body, side) in [Side::Shaped, Side::Counter].into_iter().enumerate() {
                let Some((operator, state)) = pair.side(side).zip(states[body]) else { continue };
                let u = displacement(operator, state, point, pair.place(side, point));
                profile.normal_displacement[body][row] = 1e3 * u[0];
                profile.tangential_displacement[body][row] = 1e3 * sense * u[1];
            }
            profile.status[row] = if pressure[row] > 0.0 { "contact" } else { "open" };
        }
        profile
    }
}

/// Displacement along normal and tangent of a point.
fn displacement(
    operator: &hpfem::InterfaceOperator,
    state: &InterfaceState,
    point: &ContactPoint,
    place: (usize, f64),
) -> [f64; 2] {
    let (rows, constant) = operator.trace.displacement_row(place.0, place.1);
    let u: [f64; 2] = std::array::from_fn(|k| rows[k].iter().map(|(i, c)| c * state.unknowns[*i]).sum::<f64>() + constant[k]);
    let along = |d: [f64; 2]| u[0] * d[0] + u[1] * d[1];
    [along(point.normal), along(point.tangent)]
}

impl Parts {
    /// Assembles and reduces both bodies, and counts the work.
    pub(super) fn reduce(&self, solution: &mut Solution) -> Result<[Body<'_>; 2], Fault> {
        let bodies = [self.parts[0].reduce("body1")?, self.parts[1].reduce("body2")?];
        operators::count([0, 1].map(|k| (&bodies[k].interface, bodies[k].effort)), solution);
        Ok(bodies)
    }

    /// Reduces both bodies to their contact surface, keeping nothing of their inside, and counts the work.
    pub(super) fn interfaces(&self, solution: &mut Solution) -> Result<[InterfaceOperator; 2], Fault> {
        let [(first, effort), (second, other)] = [self.parts[0].interface("body1")?, self.parts[1].interface("body2")?];
        operators::count([(&first, effort), (&second, other)], solution);
        Ok([first, second])
    }

    /// Forces of the supports on their bodies.
    pub(super) fn reactions(&self, bodies: &[Body<'_>; 2], states: [Option<&InterfaceState>; 2]) -> Vec<(String, Reaction)> {
        let names = [self.parts[0].support_names.as_slice(), self.parts[1].support_names.as_slice()];
        operators::reactions([&bodies[0].interface, &bodies[1].interface], names, states)
    }
}

/// Accuracy a scene asks for.
pub(super) fn accuracy(scene: &Scene) -> f64 {
    scene.accuracy.unwrap_or(1e-6)
}

/// The fixed discretisation of a scene, if it has one.
pub(super) fn fixed_level(scene: &Scene) -> Option<Level> {
    let mesh = scene.mesh.clone().unwrap_or_default();
    mesh.degree.or(mesh.layers).map(|_| {
        let degree = mesh.degree.unwrap_or(8);
        let standing = Level::of(scene, degree);
        Level { layers: mesh.layers.unwrap_or(standing.layers), ..standing }
    })
}

/// The levels to solve of a scene.
pub(super) fn ladder(scene: &Scene, options: Options) -> Vec<Level> {
    let [first, last, step] = DEGREES;
    match fixed_level(scene) {
        Some(level) if options.alone => vec![level],
        None => (first..=last).step_by(step).map(|degree| Level::of(scene, degree)).collect(),
        Some(level) => [4, 2, 0]
            .iter()
            .filter(|down| level.degree > **down)
            .map(|down| Level { degree: level.degree - down, layers: level.layers })
            .collect(),
    }
}

/// Notes the seconds of a stage, summed over levels.
pub(super) fn note(solution: &mut Solution, stage: &str, start: Instant) {
    solution.times.push((stage.to_string(), start.elapsed().as_secs_f64()));
}

/// Estimated error of the last of at least three levels from the differences of successive ones, `older` and `newer`: they fall
/// nearly like a geometric series, and since the fall slows down the ratio enters with the power 3/4 (true error over estimate
/// between 0.3 and 1 on the drum in degrees 8 to 14).
pub(crate) fn rest(older: f64, newer: f64) -> f64 {
    if newer == 0.0 {
        return f64::EPSILON;
    }
    let ratio = (newer / older).clamp(0.0, 0.85).powf(0.75);
    (newer * ratio / (1.0 - ratio)).max(1e-14)
}

/// Columns of the mean displacement functionals that fix the free rigid modes, one a mode, each in turn the one of z, x,
/// rotation that still moves.
fn mean_columns(pair: &Pair<'_>) -> Vec<usize> {
    let body = pair.shaped;
    let [x, z, rotation] = MEAN_COLUMNS;
    let moves = |k: usize| body.rigid_motions.iter().any(|m| m[k] != 0.0);
    match body.rigid_motions.len() {
        0 => Vec::new(),
        1 if moves(1) => vec![z],
        1 if moves(0) => vec![x],
        1 => vec![rotation],
        2 if !moves(2) => vec![x, z],
        2 if moves(1) => vec![z, rotation],
        2 => vec![x, rotation],
        _ => vec![x, z, rotation],
    }
}
