//! What the elastic stages share: the problem with its surface and couple, the reduced bodies of a level, loads and columns of the contact.

use std::sync::Arc;

use contact::{ContactLoad, ContactPoint, MomentBalance, Motion, Pair, Side};
use hpfem::InterfaceState;
use meshing::{Body, Couple, Cut, Extent, meshes, meshes_of};
use nalgebra::Vector3;
use scene::Fault;
use shapeopt::{EdgeLoad, Gauge};

use crate::bodies::{Bodies, Place, Reduced};
use crate::effort::{Clock, Effort};
use crate::faults::wrong_wear;
use crate::level::Level;
use crate::options::{Options, Sampling, trapezoid_weights};
use crate::parts::{MEAN_COLUMNS, Meeting, Parts};
use crate::problem::Problem;
use crate::profile::Profile;
use crate::step::Step;
use crate::surface::Patch;
use crate::words::PointStatus;

/// A problem whose contact surface is known, ready for its elastic stages.
#[derive(Clone, Copy)]
pub(crate) struct Stage<'a> {
    pub problem: &'a Problem,
    pub couple: &'a Couple,
    pub patch: &'a Patch,
    pub extent: Extent,
    pub options: &'a Options<'a>,
    pub bodies: &'a Bodies,
}

impl<'a> Stage<'a> {
    pub(crate) fn new(problem: &'a Problem, options: &'a Options<'a>, bodies: &'a Bodies) -> Result<Stage<'a>, Fault> {
        let none = || {
            let message = "the elastic stages do not know this contact surface yet";
            Fault::at("contact.edges", "not-available", message, "ask for the pressure alone: --set tasks=[pressure]")
        };
        let patch = problem.patch.as_ref().ok_or_else(none)?;
        let extent = patch.extent().ok_or_else(none)?;
        let couple = problem.couple.as_ref().ok_or_else(none)?;
        Ok(Stage { problem, couple, patch, extent, options, bodies })
    }

    /// The same with other numbers of load and sliding; a round contact has one load.
    pub(crate) fn with(self, problem: &'a Problem) -> Result<Stage<'a>, Fault> {
        if self.facing() {
            return Ok(Stage { problem, ..self });
        }
        Stage::new(problem, self.options, self.bodies)
    }

    pub(crate) fn clock(&self) -> Clock {
        self.options.clock
    }

    /// Accuracy asked for.
    pub(crate) fn accuracy(&self) -> f64 {
        self.problem.wanted.accuracy
    }

    /// Both bodies of a level with nodes at the ends of a pressure that does not fill the surface; without such ends as [`Stage::reduced`].
    pub(crate) fn reduced_at(&self, level: Level, ends: &[f64]) -> Result<(Arc<Reduced>, Effort), Fault> {
        if ends.is_empty() { self.reduced(level, Cut::Plain) } else { self.made(level, self.cut(ends)) }
    }

    /// Both bodies of a level, meshed and reduced unless that was done before.
    pub(crate) fn reduced(&self, level: Level, cut: Cut<'static>) -> Result<(Arc<Reduced>, Effort), Fault> {
        // How far a round contact may reach follows from the load: such bodies fit no other run.
        if self.facing() || !self.corners().is_empty() {
            return self.made(level, cut);
        }
        self.bodies.get(self.couple, Place { level, cut, torsion: false }, || self.make(level, cut))
    }

    /// Both bodies of a level on meshes of their own, not kept.
    pub(crate) fn made(&self, level: Level, cut: Cut<'_>) -> Result<(Arc<Reduced>, Effort), Fault> {
        self.make(level, cut).map(|(reduced, effort)| (Arc::new(reduced), effort))
    }

    fn make(&self, level: Level, cut: Cut<'_>) -> Result<(Reduced, Effort), Fault> {
        let (parts, mut effort) = self.parts(level, cut)?;
        (self.options.begun)(Step::Factor);
        let (reduced, work) = Reduced::new(&parts, self.clock())?;
        effort += work;
        Ok((reduced, effort))
    }

    /// Both bodies of a level in the scalar problem of twisting; kept unless their meshes are cut at ends of contact.
    pub(crate) fn twisted(&self, level: Level, ends: &[f64]) -> Result<(Arc<Reduced>, Effort), Fault> {
        let make = |cut: Cut<'_>| -> Result<(Reduced, Effort), Fault> {
            let mut effort = Effort::default();
            (self.options.begun)(Step::Torsion);
            let meshes = effort.timed(Step::Mesh, self.clock(), |_| self.meshes(level.layers, cut))?;
            let (reduced, work) = Reduced::new(&Parts::torsion(self.couple, meshes, level, self.meeting())?, self.clock())?;
            effort += work;
            Ok((reduced, effort))
        };
        let (reduced, effort) = if ends.is_empty() && self.corners().is_empty() {
            self.bodies.get(self.couple, Place { level, cut: Cut::Plain, torsion: true }, || make(Cut::Plain))?
        } else {
            make(Cut::Ends(ends)).map(|(reduced, effort)| (Arc::new(reduced), effort))?
        };
        Ok((reduced, effort.aside()))
    }

    /// The scalar problem of the bodies of a contact in which body 1 is turned.
    pub(crate) fn turned_pair(&self, level: Level, ends: &[f64]) -> Result<Option<(Arc<Reduced>, Effort)>, Fault> {
        if self.problem.load.turns.is_empty() { Ok(None) } else { self.twisted(level, ends).map(Some) }
    }

    /// Whether the surfaces face each other across a gap.
    pub(crate) fn facing(&self) -> bool {
        matches!(self.extent, Extent::Round { .. })
    }

    /// Whether two circles of different radii wear until a given end: their contact grows.
    pub(crate) fn grows(&self) -> bool {
        let Problem { plan, wear, gap, .. } = self.problem;
        plan.runs(Step::Evolution) && wear.until.is_some() && gap.touch().is_some()
    }

    /// Whether ends of contact move as it wears, so that the depth worn off is the result, and no rigid part of it is left open.
    pub(crate) fn ends_move(&self) -> bool {
        self.facing() || self.grows()
    }

    /// The cut of meshes at nodes along the surface, from -1 to 1.
    pub(crate) fn cut<'n>(&self, nodes: &'n [f64]) -> Cut<'n> {
        if self.grows() && !nodes.is_empty() { Cut::Passed(nodes) } else { Cut::Ends(nodes) }
    }

    /// How the surfaces lie to each other.
    pub(crate) fn meeting(&self) -> Meeting {
        match self.extent {
            Extent::Round { .. } => Meeting::Across,
            Extent::Circles { .. } => Meeting::ByAngle,
            Extent::Convex { .. } => Meeting::ByArc,
            Extent::Angles(_) | Extent::X(_) => Meeting::Together,
        }
    }

    /// The meshes of both bodies with so many layers, cut at the corners of the gap too, where they can be.
    pub(crate) fn meshes(&self, layers: usize, cut: Cut<'_>) -> Result<[hpfem::Mesh; 2], Fault> {
        let with_corners = self.with_corners(cut).and_then(|nodes| self.meshes_at(layers, Cut::Corners(&nodes)).ok());
        with_corners.map_or_else(|| self.meshes_at(layers, cut), Ok)
    }

    fn meshes_at(&self, layers: usize, cut: Cut<'_>) -> Result<[hpfem::Mesh; 2], Fault> {
        // The coordinate of a surface may fall along its path.
        let turned: Vec<f64> = if self.patch.backwards { cut.ends().iter().rev().map(|t| -t).collect() } else { Vec::new() };
        let cut = if turned.is_empty() { cut } else { cut.at(&turned) };
        let kept = match cut {
            Cut::Plain => Some(Cut::Plain),
            Cut::Shifted => Some(Cut::Shifted),
            Cut::Ends(_) | Cut::Corners(_) | Cut::Passed(_) => None,
        };
        if !self.couple.bodies.iter().any(Body::is_given) {
            return meshes(self.couple, self.extent, layers, cut);
        }
        match kept {
            Some(cut) => self.bodies.coarse(self.couple, self.extent, cut)?.graded(layers),
            None => meshes_of(&*self.bodies.given(self.couple, self.extent)?, self.couple, (self.extent, cut), layers),
        }
    }

    /// Meshes, supports and loads of both bodies.
    pub(crate) fn parts(&self, level: Level, cut: Cut<'_>) -> Result<(Parts, Effort), Fault> {
        let mut effort = Effort::default();
        (self.options.begun)(Step::Mesh);
        let parts = effort.timed(Step::Mesh, self.clock(), |_| {
            Parts::new(self.couple, self.meshes(level.layers, cut)?, level, self.meeting())
        })?;
        Ok((parts, effort))
    }

    /// Coefficient of the friction shear on the bodies.
    pub(crate) fn friction(&self) -> f64 {
        self.problem.friction.shear()
    }

    /// Wear rules of both bodies, and how body 2 passes.
    pub(crate) fn rules(&self) -> Result<(wear::WearPair, wear::Counterface), Fault> {
        let wear = &self.problem.wear;
        let laws = wear.laws.clone().map_err(|error| wrong_wear(&error))?;
        Ok((laws, wear.counterface))
    }

    /// A point of the contact surface with sliding speed and drag direction.
    pub(crate) fn surface_point(&self, x: [f64; 2], n: [f64; 2], weight: f64) -> wear::SurfacePoint {
        self.patch.surface.point(Vector3::new(x[0], 0.0, x[1]), Vector3::new(n[0], 0.0, n[1]), weight)
    }

    /// Sense of the drag along a point's tangent: 1, -1, or 0 without sliding in the plane.
    pub(crate) fn drag(&self, point: &ContactPoint) -> f64 {
        sense(&self.surface_point(point.position, point.normal, 0.0), point)
    }

    /// Whether body 1 is loaded through a rigid edge.
    pub(crate) fn rigid_edge(&self) -> bool {
        self.couple.has_rigid_edge() && !self.couple.moves_one_way()
    }

    /// Whether the rigid part of a gap is prescribed instead of the smallest.
    pub(crate) fn rigid_prescribed(&self) -> bool {
        let load = &self.problem.load;
        self.rigid_edge() && (load.approach.is_some() || load.approach_time.is_some())
    }

    /// Rotation that is prescribed and not zero, or 0.
    pub(crate) fn turned(&self) -> f64 {
        self.problem.load.tilt.filter(|_| self.rigid_edge()).unwrap_or(0.0)
    }

    /// Place x about which the rigid edge turns.
    pub(crate) fn about(&self) -> f64 {
        self.problem.load.about[0]
    }

    /// Load-case factors of both bodies: the force on body 1, and those of loads by the mass.
    pub(crate) fn cases(&self) -> [Vec<f64>; 2] {
        let force = self.problem.load.force.unwrap_or(0.0);
        let mut cases = [if self.couple.has_rigid_edge() { vec![] } else { vec![force, 0.0, 0.0, 0.0] }, vec![]];
        for (cases, body) in cases.iter_mut().zip([&self.problem.scene.body1, &self.problem.scene.body2]) {
            cases.extend(body.iter().flat_map(meshing::BodyLoad::of).map(|(_, factor)| factor));
        }
        cases
    }

    /// Load, motions of the rigid edge and friction of a contact solve.
    pub(crate) fn contact_load(&self, points: &[ContactPoint]) -> ContactLoad {
        let [shaped, counter] = self.cases();
        let mut contact = ContactLoad::factors(&shaped, &counter);
        contact.moment = MomentBalance::Pressure;
        let load = &self.problem.load;
        if self.couple.moves_one_way() {
            // The pin turns under pressure and friction alike.
            contact.moment = MomentBalance::Traction;
            contact.motions[2] = Motion::Free { resultant: load.moment };
        } else if self.rigid_edge() {
            let force = load.force.unwrap_or(0.0);
            contact.motions[1] = match load.approach {
                Some(approach) => Motion::Prescribed { value: -approach },
                None => Motion::Free { resultant: -force },
            };
            contact.motions[2] = match load.tilt {
                Some(tilt) => Motion::Prescribed { value: -tilt },
                None => Motion::Free { resultant: -load.moment },
            };
        }
        if self.friction() > 0.0 {
            contact = contact.sliding(self.friction(), points.iter().map(|p| self.drag(p)).collect());
        }
        contact
    }

    /// What counts as body 1 unmoved: the rigid edge held, or the mean displacement of the load edge zero.
    pub(crate) fn gauge(&self, pair: &Pair<'_>) -> Gauge {
        if self.couple.bodies[0].pin().is_some() {
            return Gauge::HeldEdge;
        }
        if !self.rigid_edge() {
            return Gauge::MeanOf(mean_columns(pair));
        }
        if !shapeopt::is_held_elastically(pair.shaped) {
            return Gauge::HeldEdge;
        }
        let ContactLoad { motions, moment, .. } = self.contact_load(&[]);
        Gauge::LoadedEdge(EdgeLoad { motions, moment })
    }

    /// A state of body 1 with its rigid motion taken out.
    pub(crate) fn held(&self, pair: &Pair<'_>, state: &InterfaceState) -> InterfaceState {
        let mut held = state.clone();
        self.gauge(pair).zero(pair.shaped, &mut held);
        held
    }

    /// Surface coordinate at the start of the path: minus half the length, or the radius there.
    pub(crate) fn start(&self, pair: &Pair<'_>) -> f64 {
        let trace = pair.trace();
        match self.patch.surface.shape() {
            wear::Shape::Annulus { .. } => trace.boundary_point(0, -1.0).0.position[0],
            wear::Shape::Points(_)
            | wear::Shape::Arc { .. }
            | wear::Shape::Strip { .. }
            | wear::Shape::Sector { .. }
            | wear::Shape::Rectangle { .. }
            | wear::Shape::Ellipse { .. } => -0.5 * trace.length(),
        }
    }

    /// Points of the path with trapezoid weights.
    pub(crate) fn sample(&self, pair: &Pair<'_>, sampling: Sampling<'_>) -> Vec<ContactPoint> {
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
    pub(crate) fn profile(
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
        let held = states[0].map(|state| self.held(pair, state));
        let states = [held.as_ref(), states[1]];
        for (row, (point, on_surface)) in points.iter().zip(&surface).enumerate() {
            profile.pressure[row] = pressure[row];
            profile.shear[row] = self.friction() * pressure[row];
            if let Some(rate) = self.problem.wear.rate(pressure[row], on_surface.sliding_speed) {
                profile.wear_rate[row] = 1e3 * rate;
            }
            // Without sliding in the plane tau is the tangent itself.
            let sense = if sense(on_surface, point) < 0.0 { -1.0 } else { 1.0 };
            for (body, side) in [Side::Shaped, Side::Counter].into_iter().enumerate() {
                let Some(state) = states[body] else { continue };
                let u = pair.displacement(side, state, point);
                profile.normal_displacement[body][row] = 1e3 * u[0];
                profile.tangential_displacement[body][row] = 1e3 * sense * u[1];
            }
            profile.status[row] = PointStatus::pressed(pressure[row] > 0.0);
        }
        profile
    }
}

/// Columns of the mean displacement functionals that fix the free rigid modes, one a mode, each in turn the one of z, x,
/// rotation that still moves.
pub(crate) fn mean_columns(pair: &Pair<'_>) -> Vec<usize> {
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

/// Sense of the drag at a point of the surface along its tangent: 1, -1, or 0 without sliding in the plane.
fn sense(on_surface: &wear::SurfacePoint, point: &ContactPoint) -> f64 {
    let along = on_surface.drag.dot(&Vector3::new(point.tangent[0], 0.0, point.tangent[1]));
    if along == 0.0 { 0.0 } else { along.signum() }
}
