//! One level of discretisation: both bodies with nodes where a sense of sliding begins to open, and the steady shape on them.

use std::sync::Arc;

use contact::{ContactLoad, ContactOperator, ContactPoint};
use nalgebra::DMatrix;
use shapeopt::{Curve, NodalCurve, Reversing, ReversingProblem, closing, lowest_nonnegative, steady_reversing};

use crate::bodies::Reduced;
use crate::effort::Effort;
use crate::faults::unsolved;
use crate::ladder::Refusal;
use crate::level::Level;
use crate::stage::Stage;
use crate::step::Step;
use crate::steps::reversing::ends::{ends_of, moved};
use crate::steps::rigid_coordinates::coordinates;

/// Samples of the gap for the comparison of levels.
const SAMPLES: usize = 201;
/// Meshes of a level at most, and how near its nodes are to the ends by the accuracy asked for.
const MESHES: usize = 3;
const NEAR: f64 = 0.3;

/// A problem forward and backward.
pub(super) struct Senses<'a> {
    pub stages: [Stage<'a>; 2],
    /// Share of the time forward.
    pub share: f64,
}

/// One solved level.
pub(super) struct Solved {
    pub level: Level,
    /// Where the nodes are: places from -1 to 1 on the surface at which a sense begins to open.
    pub nodes: Vec<f64>,
    /// The places that the pressures then tell.
    pub ends: Vec<f64>,
    pub reduced: Arc<Reduced>,
    pub found: Reversing,
    /// Gap at the contact points (mm), its rigid part the smallest.
    pub gap: Vec<f64>,
    /// Gap at the samples (mm).
    pub gaps: Vec<f64>,
    /// Closing velocities of the rigid modes at the samples.
    pub closing: DMatrix<f64>,
    pub effort: Effort,
}

impl Senses<'_> {
    /// The loads forward and backward.
    pub(super) fn loads(&self, points: &[ContactPoint]) -> [ContactLoad; 2] {
        self.stages.map(|stage| stage.contact_load(points))
    }

    /// Whether shear acts on the bodies.
    pub(super) fn shear(&self) -> bool {
        self.stages[0].friction() > 0.0
    }

    /// Solves one level, from the ends of the one before.
    pub(super) fn level(&self, level: Level, ends: &[f64]) -> Result<Solved, Refusal> {
        let mut effort = Effort::default();
        let mut nodes = ends.to_vec();
        let near = NEAR * self.stages[0].accuracy();
        for mesh in 1.. {
            let (solved, work) = self.on(level, nodes)?;
            effort += work;
            let settled = solved.ends.is_empty() || moved(&solved.nodes, &solved.ends).is_some_and(|most| most <= near);
            if settled || mesh == MESHES {
                return Ok(Solved { effort, ..solved });
            }
            nodes = solved.ends;
        }
        Err(Refusal::Reason("no mesh was made".into()))
    }

    /// Solves a level with nodes at given places; without them where cells cannot be cut there.
    fn on(&self, level: Level, nodes: Vec<f64>) -> Result<(Solved, Effort), Refusal> {
        let stage = self.stages[0];
        let (nodes, (reduced, mut effort)) = match stage.reduced_at(level, &nodes) {
            Err(_) if !nodes.is_empty() => (Vec::new(), stage.reduced_at(level, &[])?),
            made => (nodes, made?),
        };
        let (found, gap, ends, gaps, modes) = {
            let pair = reduced.pair()?;
            (stage.options.begun)(Step::Shape);
            let operator = effort.timed(Step::Interface, stage.clock(), |_| reduced.operator(&pair, self.shear()))?;
            let found = effort.timed(Step::Shape, stage.clock(), |_| self.steady(&operator))?;
            let gap = lifted(stage, &operator, &found.gap);
            let length = pair.trace().length();
            let arcs = (0..SAMPLES).map(|i| length * i as f64 / (SAMPLES - 1) as f64);
            let points: Vec<ContactPoint> = arcs.map(|arc| pair.at_arc(arc)).collect();
            let gaps = points.iter().map(|p| operator.value_at(&gap, p.arc)).collect();
            let rows: Vec<f64> = points.iter().flat_map(|point| closing(&pair, point)).collect();
            let modes = DMatrix::from_row_slice(SAMPLES, rows.len() / SAMPLES, &rows);
            let arcs: Vec<f64> = operator.points().iter().map(|p| p.arc).collect();
            // A sense that takes no part in the wear leaves no trace where it opens.
            let both = self.share > 0.0 && self.share < 1.0;
            let ends = if both { ends_of(&found.pressure, &arcs, length) } else { Vec::new() };
            (found, gap, ends, gaps, modes)
        };
        Ok((Solved { level, nodes, ends, reduced, found, gap, gaps, closing: modes, effort: Effort::default() }, effort))
    }

    /// The steady shape on an operator.
    fn steady(&self, operator: &ContactOperator<'_>) -> Result<Reversing, Refusal> {
        let stage = self.stages[0];
        let (wear, counterface) = stage.rules()?;
        let [forward, backward] = self.loads(operator.points());
        let systems = [operator.system(&forward).map_err(unsolved)?, operator.system(&backward).map_err(unsolved)?];
        let points = operator.points().iter().map(|p| stage.surface_point(p.position, p.normal, p.weight)).collect();
        steady_reversing(&ReversingProblem {
            points,
            // Without friction the factors tell the pressure that vanishing friction has.
            wear: wear::WearPair { active: true, ..wear },
            counterface,
            track_area: stage.patch.surface.track_area(),
            systems,
            share: self.share,
        })
        .map_err(|error| Refusal::Reason(error.to_string()))
    }
}

/// A gap with its smallest rigid part; a prescribed rotation is kept.
fn lifted(stage: Stage<'_>, operator: &ContactOperator<'_>, gap: &[f64]) -> Vec<f64> {
    let pair = operator.pair();
    let along = stage.problem.load.tilt.filter(|_| stage.rigid_edge()).map(|_| coordinates(pair, [1.0, 0.0], stage.about()));
    let curve = Lowered { nodal: NodalCurve { pair, operator, gap }, along };
    let Some(found) = lowest_nonnegative(&curve) else { return gap.to_vec() };
    let lift = |point: &ContactPoint| curve.modes(closing(pair, point)).iter().zip(&found).map(|(phi, a)| phi * a).sum::<f64>();
    operator.points().iter().zip(gap).map(|(point, gap)| gap + lift(point)).collect()
}

/// A gap whose rigid part is free as a whole, or along one motion.
struct Lowered<'a> {
    nodal: NodalCurve<'a>,
    along: Option<Vec<f64>>,
}

impl Lowered<'_> {
    /// Closing velocities of the free motions.
    fn modes(&self, modes: Vec<f64>) -> Vec<f64> {
        match &self.along {
            None => modes,
            Some(along) => vec![modes.iter().zip(along).map(|(phi, a)| phi * a).sum()],
        }
    }
}

impl Curve for Lowered<'_> {
    fn length(&self) -> f64 {
        self.nodal.length()
    }

    fn samples(&self) -> Vec<f64> {
        self.nodal.samples()
    }

    fn value(&self, arc: f64) -> (f64, Vec<f64>) {
        let (gap, modes) = self.nodal.value(arc);
        (gap, self.modes(modes))
    }

    fn mean_modes(&self) -> Vec<f64> {
        self.modes(self.nodal.mean_modes())
    }
}
