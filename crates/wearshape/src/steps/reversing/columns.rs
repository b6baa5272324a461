//! The report of a level: the shape, both pressures, columns and surface to machine.

use contact::{ContactOperator, ContactPoint, ContactSolution, maximum, piecewise_linear};

use crate::effort::Effort;
use crate::ladder::Refusal;
use crate::machined::{Machined, SurfacePoint};
use crate::profile::Profile;
use crate::results::ShapeResult;
use crate::step::Step;
use crate::steps::answer::{Answer, Outcome, Own, Told};
use crate::steps::reported::{Moment, Reported};
use crate::steps::reversing::level::{Senses, Solved};
use crate::steps::reversing::proof::{disproved, independent, same};

impl Senses<'_> {
    /// Everything that is reported of a level, with its proof.
    pub(super) fn report(&self, solved: &Solved, outcome: &mut Outcome) -> Result<Effort, Refusal> {
        let stage = self.stages[0];
        let pair = solved.reduced.pair()?;
        let operator = solved.reduced.operator(&pair, self.shear())?;
        let (start, length) = (stage.start(&pair), pair.trace().length());
        let between = (solved.gaps.len() - 1) as f64;
        let arcs: Vec<f64> = (0..solved.gaps.len()).map(|i| length * i as f64 / between).collect();
        let [highest, most] = maximum(&arcs, &solved.gaps, &|arc| operator.value_at(&solved.gap, arc));
        let mut shape = ShapeResult {
            iterations: 1,
            gap_max: Some(1e3 * most),
            gap_where: Some(start + highest),
            crown: Some(1e3 * most),
            ..ShapeResult::default()
        };
        outcome.pressure = Some(self.pressure(solved, operator.points()));
        outcome.reversing = Some(self.senses(solved, operator.points(), [start, length]));
        outcome.machined = stage.options.machining.then(|| {
            let surface = |s: f64| {
                let point = pair.at_arc((s - start).clamp(0.0, length));
                SurfacePoint { s, nominal: point.position, normal: point.normal, gap: operator.value_at(&solved.gap, point.arc) }
            };
            Machined::new(surface, [start, start + length])
        });
        let (misses, back) = same(self, solved, &operator)?;
        let mut told = self.told(solved, &operator, &back);
        let mut effort = Effort::default();
        if stage.problem.plan.runs(Step::RoundTrip) && !outcome.stopped {
            let begun = stage.clock()();
            (stage.options.begun)(Step::RoundTrip);
            let (other, work) = independent(self, solved, &operator, &mut told)?;
            (shape.roundtrip_same, shape.roundtrip_independent) = (Some(misses), Some(other));
            let disproof = disproved([misses, other], outcome.error.gap_relative);
            shape.proof_failed = disproof.is_some();
            outcome.ended = disproof.or(outcome.ended.take());
            effort.counters.factorisations = work.counters.factorisations;
            effort.counters.check_solves = 4;
            effort.add_seconds(Step::RoundTrip, stage.clock()() - begun);
        }
        let moment = back.counter.clone().map(|counter| Moment {
            time: 0.0,
            name: "",
            states: [stage.held(&pair, &back.shaped), counter],
            around: vec![0.0; operator.points().len()],
        });
        outcome.reported =
            moment.map(|moment| Reported { level: solved.level, ends: solved.nodes.clone(), heat: None, moments: vec![moment] });
        (outcome.shape, outcome.told) = (Some(shape), Some(told));
        Ok(effort)
    }

    /// Energies, reactions and columns as it goes forward, with the pressure backward and the mean wear rate.
    fn told(&self, solved: &Solved, operator: &ContactOperator<'_>, forward: &ContactSolution) -> Told {
        let (stage, pair) = (self.stages[0], operator.pair());
        let Solved { found, gap, .. } = solved;
        let arcs: Vec<f64> = operator.points().iter().map(|p| p.arc).collect();
        let between = |point: &ContactPoint| {
            let opening = piecewise_linear(&arcs, &found.opening[0], point.arc).max(0.0);
            [operator.pressure_at(&found.pressure[0], point.arc), operator.value_at(gap, point.arc), opening]
        };
        let closed: Vec<bool> = found.pressure[0].iter().map(|p| *p > 0.0).collect();
        let own = Own {
            points: operator.points(),
            pressure: &found.pressure[0],
            gap,
            opening: &found.opening[0],
            closed: Some(&closed),
        };
        let states = [Some(&forward.shaped), forward.counter.as_ref()];
        let mut told = Answer { stage, reduced: &solved.reduced, pair, states, own, between: &between }.told();
        let start = stage.start(pair);
        for profile in [&mut told.profile, &mut told.curve] {
            self.fill(profile, |s| operator.pressure_at(&found.pressure[1], s - start), |s| pair.at_arc(s - start));
        }
        told
    }

    /// The pressure backward and the mean wear rate at the places of a profile.
    fn fill(&self, profile: &mut Profile, backward: impl Fn(f64) -> f64, point: impl Fn(f64) -> ContactPoint) {
        profile.pressure_back = profile.s.iter().map(|s| backward(*s)).collect();
        for row in 0..profile.s.len() {
            let point = point(profile.s[row]);
            let speed = self.stages[0].surface_point(point.position, point.normal, 0.0).sliding_speed;
            if let Some(rate) = self.mean_rate([profile.pressure[row], profile.pressure_back[row]], speed) {
                profile.wear_rate[row] = 1e3 * rate;
            }
        }
    }
}
