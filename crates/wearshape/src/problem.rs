//! A checked scene: everything that is computed from, typed, with every default filled in.

use contact::Turn;
use wear::{WearError, WearPair};
use scene::{Gap, Scene, SurfaceShape};

use crate::couple::Couple;
use crate::fe::Level;
use crate::freedom::Freedom;
use crate::lints::Lint;
use crate::plan::Plan;
use crate::surface::Patch;

/// A checked scene: everything the stages need.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Problem {
    /// Short name of the scene.
    pub(crate) name: String,
    /// The scene with every default filled in, in base units. It is written, and nothing is computed from it.
    pub(crate) scene: Scene,
    /// The accuracy asked for, or a fixed discretisation.
    pub(crate) wanted: Wanted,
    /// The elastic bodies; none of a surface alone.
    pub(crate) couple: Option<Couple>,
    /// A surface without bodies.
    pub(crate) bare: Option<SurfaceShape>,
    /// The contact surface, when it is known without a mesh.
    pub(crate) patch: Option<Patch>,
    /// The rigid freedoms of body 1 with their resultants.
    pub(crate) freedoms: Vec<Freedom>,
    /// Friction between the bodies.
    pub(crate) friction: Friction,
    /// Unloaded gap at the start.
    pub(crate) gap: Gap,
    /// What presses, shifts and turns body 1.
    pub(crate) load: Load,
    /// Motion of body 2; none where nothing slides.
    pub(crate) sliding: Option<scene::Sliding>,
    /// Wear rules and where a run in time ends.
    pub(crate) wear: Wear,
    /// Pieces of a run in time; none where load and sliding stay.
    pub(crate) pieces: Vec<Piece>,
    /// Which pressure is wanted.
    pub(crate) optimum: Optimum,
    /// Stages and reasons.
    pub(crate) plan: Plan,
    /// What the theory has to say about the scene.
    pub(crate) lints: Vec<Lint>,
    /// Keys that were written but are not used.
    pub(crate) unused_keys: Vec<String>,
}

/// How accurate the answer is to be.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Wanted {
    /// Relative error.
    pub(crate) accuracy: f64,
    /// A fixed discretisation instead of the accuracy.
    pub(crate) fixed: Option<Level>,
    /// Whether the shape of a thin body 1 is wanted, whose gap comes from bending.
    pub(crate) bends: bool,
}

/// Coulomb friction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Friction {
    /// Coefficient, 0 or more.
    pub(crate) coefficient: f64,
    /// Whether the shear acts on the bodies and in the balance.
    pub(crate) on_bodies: bool,
}

impl Friction {
    /// Coefficient of the shear on the bodies.
    pub(crate) fn shear(self) -> f64 {
        if self.on_bodies { self.coefficient } else { 0.0 }
    }
}

/// What presses, shifts and turns body 1. Where it acts is said by [`crate::couple::LoadedEdge`].
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Load {
    /// Force that presses body 1 on body 2 (N); under a prescribed approach none until it is found.
    pub(crate) force: Option<f64>,
    /// Prescribed closing of a rigid edge (mm).
    pub(crate) approach: Option<f64>,
    /// Adds the worn approach of this time (s) to the prescribed one.
    pub(crate) approach_time: Option<f64>,
    /// Prescribed rotation of a rigid edge (rad), positive when the +x side closes.
    pub(crate) tilt: Option<f64>,
    /// Moment int (x - about_x) p dS (N mm).
    pub(crate) moment: f64,
    /// Moment int (y - about_y) p dS (N mm).
    pub(crate) moment_y: f64,
    /// The point the moments are about (mm).
    pub(crate) about: [f64; 2],
    /// Shear force on a rigid edge, applied after the normal force (N).
    pub(crate) shear_force: f64,
    /// What body 1 is turned by about the axis, step after step.
    pub(crate) turns: Vec<Turn>,
}

/// Wear of both bodies.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Wear {
    /// Rules w' = k p^b v^a of body 1 and 2; an error where the scene's factors leave them open.
    pub(crate) laws: Result<WearPair, WearError>,
    /// Exponents b of the bodies with a wear factor, each once.
    pub(crate) exponents: Vec<f64>,
    /// How the counter-face meets body 1.
    pub(crate) counterface: wear::Counterface,
    /// Time at which a run in time ends (s); none for the steady state.
    pub(crate) until: Option<f64>,
    /// Whether the factors stand in front of the friction stress.
    pub(crate) of_friction: bool,
}

/// A piece of a run in time: factors on what load and sliding give.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Piece {
    /// Time at which it begins (s).
    pub(crate) time: f64,
    /// Factors on force, moment and speed.
    pub(crate) factors: [f64; 3],
}

/// Which pressure is wanted.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Optimum {
    /// What is made stationary.
    pub(crate) functional: scene::Functional,
    /// Exponent of the generalised functionals.
    pub(crate) q: f64,
    /// Which balance the pressure fulfils.
    pub(crate) balance: scene::Balance,
    /// Which modes the optimality conditions hold.
    pub(crate) modes: scene::Modes,
    /// Cap of the pressure (MPa).
    pub(crate) p_max: Option<f64>,
}

impl Problem {
    /// Level of a degree: as many layers as the degree asks for.
    pub(crate) fn level(&self, degree: usize) -> Level {
        Level::of(degree, self.wanted.bends)
    }

    /// The problem under a force, its approach kept.
    pub(crate) fn with_force(&self, force: f64) -> Problem {
        let mut problem = self.clone();
        problem.load.force = Some(force);
        problem.freedoms = problem.own_freedoms();
        problem
    }

    /// The problem with load and sliding multiplied by factors on force, moment and speed.
    pub(crate) fn under(&self, [force, moment, speed]: [f64; 3]) -> Problem {
        let mut problem = self.clone();
        problem.load.force = problem.load.force.map(|f| f * force);
        problem.load.moment *= moment;
        problem.patch = problem.patch.map(|patch| patch.faster(speed));
        problem.freedoms = problem.own_freedoms();
        problem
    }

    /// The freedoms under the load as it is; none where it takes a mesh to know them.
    pub(crate) fn own_freedoms(&self) -> Vec<Freedom> {
        match (&self.bare, &self.couple, &self.patch) {
            (Some(surface), _, _) => crate::freedom::of_surface(surface, &self.load),
            (None, Some(couple), Some(patch)) => crate::freedom::of_bodies(couple, &self.load, patch),
            _ => Vec::new(),
        }
    }
}
