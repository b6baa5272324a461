//! A checked scene: everything that is computed from, typed, with every default filled in.

use meshing::Couple;
use scene::{Scene, SurfaceShape};
use shapeopt::Measure;
use std::f64::consts::TAU;
use wear::{Counterface, Rule, WearError, WearPair};

use crate::freedom::Freedom;
use crate::gap::StartGap;
use crate::heat::Heat;
use crate::level::Level;
use crate::load::Load;
use crate::outlines::BodyOutline;
use crate::plan::Plan;
use crate::remark::Remark;
use crate::surface::Patch;

/// A checked scene: everything the stages need.
#[derive(Debug, Clone, PartialEq)]
pub struct Problem {
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
    /// Frictional heat; none of scenes without it.
    pub(crate) heat: Option<Heat>,
    /// Unloaded gap at the start.
    pub(crate) gap: StartGap,
    /// What presses, shifts and turns body 1.
    pub(crate) load: Load,
    /// Motion of body 2; none where nothing slides.
    pub(crate) sliding: Option<scene::Sliding>,
    /// Share of the time that a reversing motion goes forward; none where the motion keeps its sense, or nothing asks for its mean wear.
    pub(crate) reversing: Option<f64>,
    /// Wear rules and where a run in time ends.
    pub(crate) wear: Wear,
    /// Pieces of a run in time; none where load and sliding stay.
    pub(crate) pieces: Vec<Piece>,
    /// How often the pieces are run through; none where they are once.
    pub(crate) cycles: Option<Cycles>,
    /// Which pressure is wanted.
    pub(crate) optimum: Optimum,
    /// Stages and reasons.
    pub(crate) plan: Plan,
    /// What the theory has to say about the scene.
    pub(crate) remarks: Vec<Remark>,
    /// Keys that were written but are not used.
    pub(crate) unused_keys: Vec<String>,
    /// Lines along which displacement and stress are written.
    pub(crate) paths: Vec<Path>,
}

/// Places inside a body, in order along a line.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Path {
    /// Its key in the scene.
    pub key: String,
    /// Goes into the name of the file.
    pub name: String,
    /// 0 for body 1, 1 for body 2.
    pub body: usize,
    /// Distances from the beginning along the line, and the points (mm).
    pub places: Vec<(f64, [f64; 2])>,
}

/// How accurate the answer is to be.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Wanted {
    /// Relative error.
    pub accuracy: f64,
    /// A fixed discretisation instead of the accuracy.
    pub fixed: Option<Level>,
    /// Whether the shape of a thin body 1 is wanted, whose gap comes from bending.
    pub bends: bool,
}

/// Coulomb friction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Friction {
    /// Coefficient, 0 or more.
    pub coefficient: f64,
    /// Whether the shear acts on the bodies and in the balance.
    pub on_bodies: bool,
}

impl Friction {
    /// Coefficient of the shear on the bodies.
    pub(crate) fn shear(self) -> f64 {
        if self.on_bodies { self.coefficient } else { 0.0 }
    }
}

/// Wear of both bodies.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Wear {
    /// Rules of body 1 and 2; an error where the scene's factors leave them open.
    pub laws: Result<WearPair, WearError>,
    /// Exponents b of the bodies with a wear factor, each once; none where a rule is no power of the pressure.
    pub exponents: Vec<f64>,
    /// How the counter-face meets body 1.
    pub counterface: wear::Counterface,
    /// Where a run in time ends; none for the steady state.
    pub until: Option<End>,
    /// What of body 1 may wear off; none where its life is not asked for.
    pub wearable: Option<Wearable>,
    /// Whether the factors stand in front of the friction stress.
    pub of_friction: bool,
    /// Whether body 1 wears by a rule of the caller's own in place of the scene's, and body 2 not at all.
    pub own_rule: bool,
}

/// Where a run in time ends before it is steady.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum End {
    /// At a time (s).
    Time(f64),
    /// At the largest depth worn off body 1 (mm).
    Depth(f64),
    /// At the volume worn off both bodies (mm^3).
    Volume(f64),
}

/// Cycles of a schedule, one after the other.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Cycles {
    /// Their number.
    pub count: f64,
    /// How long each takes (s).
    pub period: f64,
}

/// A layer of body 1 that may wear off.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Wearable {
    /// Its thickness (mm).
    pub thickness: f64,
    /// Relative spread of the wear factor; none where it is not given.
    pub spread: Option<f64>,
}

impl Wear {
    /// Wear rate of both bodies (mm/s) at a pressure (MPa) and a sliding speed (mm/s); none where the scene's factors leave it open.
    pub(crate) fn rate(&self, pressure: f64, sliding_speed: f64) -> Option<f64> {
        let pair = self.laws.as_ref().ok()?;
        let worn = (0..2).filter(|body| pair.wears(*body));
        Some(worn.map(|body| pair.rules[body].rate(pressure, sliding_speed)).sum())
    }

    /// Lowest threshold pressure (MPa) of the bodies that wear, if all of them have one.
    pub(crate) fn lowest_threshold(&self) -> Option<f64> {
        let wearing = self.laws.as_ref().ok()?.rules.iter().filter(|rule| rule.wears());
        let thresholds = wearing.map(|rule| if let Rule::Threshold(law) = rule { Some(law.threshold) } else { None });
        thresholds.collect::<Option<Vec<f64>>>()?.into_iter().reduce(f64::min)
    }
}

/// A piece of a run in time: factors on what load and sliding give.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Piece {
    /// Time at which it begins (s).
    pub time: f64,
    /// Factors on force, moment and speed.
    pub factors: [f64; 3],
}

/// Which pressure is wanted.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Optimum {
    /// What is made stationary.
    pub functional: scene::Functional,
    /// Exponent of the generalised functionals.
    pub q: f64,
    /// Which balance the pressure fulfils.
    pub balance: scene::Balance,
    /// Which modes the optimality conditions hold.
    pub modes: scene::Modes,
    /// Cap of the pressure (MPa).
    pub p_max: Option<f64>,
}

impl Problem {
    /// Short name of the scene.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Title of the scene, or its name.
    pub fn title(&self) -> &str {
        self.scene.title.as_deref().unwrap_or(&self.name)
    }

    /// The scene with every default filled in, in base units.
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// The stages, with reasons.
    pub fn plan(&self) -> &Plan {
        &self.plan
    }

    /// What the theory has to say about the scene.
    pub fn remarks(&self) -> &[Remark] {
        &self.remarks
    }

    /// Keys that were written but are not used, sorted.
    pub fn unused_keys(&self) -> &[String] {
        &self.unused_keys
    }

    /// Text of scene.resolved.toml: the scene with every default, in base units; solving it gives the same result, but for a wear rule given as
    /// a function.
    pub fn resolved(&self) -> String {
        let same = if self.wear.own_rule {
            "The pressure was found by another wear rule, given as a function."
        } else {
            "Running this file gives the same result."
        };
        let head = format!("# Every default filled in; units N, mm, MPa, s, rad. {same}\n");
        head + &scene::scene_text(&self.scene)
    }

    /// The files that the resolved scene names, to stand beside it: name and bytes.
    pub fn files(&self) -> Vec<(String, Vec<u8>)> {
        let bodies = [&self.scene.body1, &self.scene.body2].into_iter().flatten();
        let files = bodies.filter_map(|body| body.geometry.mesh());
        files.filter_map(|file| Some((file.file.clone(), file.content.as_ref()?.to_vec()))).collect()
    }

    /// Area of the contact surface (mm^2), where it is known without a mesh.
    pub fn contact_area(&self) -> Option<f64> {
        self.patch.as_ref().map(|patch| patch.surface.area())
    }

    /// Radius (mm) of the track of a ball on a revolving disc; none of other scenes. A stroke to and fro is as long as the full turn of that: each point of
    /// the counter-face is passed once in the way from end to end.
    pub(crate) fn track(&self) -> Option<f64> {
        let radius = self.sliding.as_ref()?.track_radius.map(|radius| radius.0);
        radius.or(self.stroke().map(|stroke| stroke / TAU))
    }

    /// Way from end to end (mm) of a ball that goes to and fro in the groove it makes; none of other scenes.
    pub(crate) fn stroke(&self) -> Option<f64> {
        let stroke = self.sliding.as_ref()?.cycle.as_ref()?.stroke?;
        (self.wear.counterface == Counterface::Revolving).then_some(stroke.0)
    }

    /// Number of free rigid modes of body 1.
    pub fn free_modes(&self) -> usize {
        self.freedoms.len()
    }

    /// Both bodies as a picture shows them; none of a surface alone.
    pub fn outlines(&self) -> Option<[BodyOutline; 2]> {
        let couple = self.couple.as_ref()?;
        Some(couple.bodies.each_ref().map(|body| BodyOutline::of(body, couple.is_revolved())))
    }

    /// The contact surface, where it is known without a mesh.
    pub fn contact_shape(&self) -> Option<&wear::Shape> {
        self.patch.as_ref().map(|patch| patch.surface.shape())
    }

    /// The angle (rad, from the z axis towards +x) at an arc length from the middle (mm); none off an arc.
    pub fn angle(&self, s: f64) -> Option<f64> {
        self.patch.as_ref()?.angle(s)
    }

    /// What differences of its gap are measured by.
    pub fn measure(&self) -> Measure {
        let rigid = self.couple.as_ref().is_some_and(|couple| couple.has_rigid_edge());
        let prescribed = rigid && (self.load.approach.is_some() || self.load.approach_time.is_some());
        if prescribed { Measure::Crown } else { Measure::Largest }
    }

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
