//! A half-disc on a rectangle under its load: what its contact is solved from, and the bodies of a level.

use hpfem::Mesh;
use meshing::{Couple, HalfDiscOnFlat};
use scene::Fault;

use crate::effort::Effort;
use crate::ladder::Refusal;
use crate::level::Level;
use crate::options::Options;
use crate::parts::{Meeting, Parts};
use crate::problem::Problem;
use crate::step::Step;
use crate::steps::hertz_trial::hertz_end;

/// Two such bodies under their load.
pub(crate) struct Setting<'a> {
    pub problem: &'a Problem,
    pub couple: &'a Couple,
    /// Sizes of both bodies.
    pub disc: HalfDiscOnFlat,
    pub options: &'a Options<'a>,
    /// Coefficient of friction of the shear on the bodies.
    pub friction: f64,
    /// Shear force (N) on body 1 along x.
    pub shear: f64,
}

impl<'a> Setting<'a> {
    /// The setting of a problem.
    pub(crate) fn new(problem: &'a Problem, couple: &'a Couple, disc: HalfDiscOnFlat, options: &'a Options<'a>) -> Setting<'a> {
        Setting { problem, couple, disc, options, friction: problem.friction.shear(), shear: problem.load.shear_force }
    }

    /// Whether the bodies are revolved.
    pub(crate) fn revolved(&self) -> bool {
        self.couple.is_revolved()
    }

    /// How often the meshed part is contained in the scene.
    pub(crate) fn copies(&self) -> f64 {
        if self.disc.whole || self.revolved() { 1.0 } else { 2.0 }
    }

    /// The plane of symmetry x = middle (mm), where the half beyond it alone is meshed.
    pub(crate) fn mirror(&self) -> Option<f64> {
        (self.copies() > 1.0).then_some(self.disc.middle)
    }

    /// Force on the whole scene (N).
    pub(crate) fn force(&self) -> f64 {
        self.problem.load.force.unwrap_or(0.0)
    }

    /// Trial ends between half-planes or half-spaces (Johnson 1985, sec. 4.2, 7.2): of contact, and before it of stick.
    pub(crate) fn trial(&self) -> Result<Vec<f64>, Refusal> {
        let approach = self.problem.load.approach;
        let end = hertz_end(self.disc.radius, self.couple, &self.problem.load);
        if end <= 0.0 || end.is_nan() {
            let message = format!("an approach of {} mm does not press body 1 on body 2", approach.unwrap_or(0.0));
            return Err(Fault::at("load.approach", "wrong-value", message, "give an approach greater than 0").into());
        }
        if self.shear == 0.0 {
            return Ok(vec![end]);
        }
        let most = self.friction * self.force();
        let carried = self.shear.abs() / most;
        if approach.is_none() && carried >= 1.0 {
            return Err(Refusal::Reason(format!(
                "the shear force {} N is no less than friction carries, {most} N",
                self.shear.abs()
            )));
        }
        let stick = (1.0 - carried.min(0.9)).sqrt();
        Ok(vec![stick * end, end])
    }

    /// Bodies with element nodes on the given ends.
    pub(crate) fn parts(&self, level: Level, nodes: &[f64]) -> Result<(Parts, Effort), Refusal> {
        self.on_meshes(level, nodes, Parts::new)
    }

    /// The same by another way to make parts of meshes.
    pub(crate) fn on_meshes(
        &self,
        level: Level,
        nodes: &[f64],
        make: fn(&Couple, [Mesh; 2], Level, Meeting) -> Result<Parts, Fault>,
    ) -> Result<(Parts, Effort), Refusal> {
        let (end, longest) = (nodes[nodes.len() - 1], self.disc.longest());
        if nodes.len() > 1 && nodes[0] <= 0.0 {
            let reason = "the zone of stick shrinks to nothing: friction hardly carries the shear force";
            return Err(Refusal::Reason(reason.into()));
        }
        if end.is_nan() || end > longest || end <= 0.0 {
            return Err(Refusal::Reason(format!(
                "the contact reaches {end:.4} mm from the middle, over the {longest:.4} mm that the bodies allow"
            )));
        }
        let mut effort = Effort::default();
        (self.options.begun)(Step::Mesh);
        let parts = effort.timed(Step::Mesh, self.options.clock, |_| {
            make(self.couple, self.disc.meshes(nodes, level.layers.div_ceil(2))?, level, Meeting::Across)
        })?;
        Ok((parts, effort))
    }
}
