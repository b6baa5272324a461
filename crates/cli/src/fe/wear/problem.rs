//! The wear problem of a level: contact points, wear rules, start gap, and the loads of the schedule.

use contact::{ContactLoad, ContactOperator, Pair, Status as ContactStatus};
use scene::Fault;
use shapeopt::{Interval, LoadStage, Stepping, Until, WearProblem};

use crate::fe::contact::start_gap;
use crate::fe::stage::Stage;

/// Certificate of the steady state.
const STEADY: f64 = 1e-9;
/// Part of the accuracy asked for that the wear still to come may make where the contact wears itself free.
const REST: f64 = 0.01;

/// The residual at which a run is steady: of the certificate, or of the wear still to come under a prescribed approach.
pub(super) fn steady_residual(stage: Stage<'_>) -> f64 {
    let approach = stage.scene().load.as_ref().and_then(|load| load.approach);
    if approach.is_some() { STEADY.max(REST * stage.accuracy()) } else { STEADY }
}

/// Wear rules of both bodies, and how body 2 passes.
pub(in crate::fe) fn rules(stage: Stage<'_>) -> Result<(wear::WearPair, wear::Counterface), Fault> {
    let friction = stage.scene().contact.as_ref().and_then(|c| c.friction).unwrap_or(0.0);
    let laws = crate::solve::pressure::wear_pair(stage.scene(), friction)
        .map_err(|error| Fault::at("wear", "wrong-value", error.to_string(), "mend the numbers in the message"))?;
    let counterface = match stage.scene().wear.as_ref().and_then(|wear| wear.counterface) {
        Some(scene::Counterface::Congruent) => wear::Counterface::Congruent,
        Some(scene::Counterface::Revolving) => wear::Counterface::Revolving,
        _ => wear::Counterface::Fresh,
    };
    Ok((laws, counterface))
}

/// The wear problem on an operator; one stage a load that occurs. A run until the steady state goes on to the time `not_before` at least. The inner `Err` says why it has no answer.
pub(super) fn wear_problem(
    stages: &[Stage<'_>],
    intervals: &[Interval],
    pair: &Pair<'_>,
    operator: &ContactOperator<'_>,
    loads: &[ContactLoad],
    not_before: f64,
) -> Result<Result<WearProblem, String>, Fault> {
    let stage = stages[intervals[0].stage];
    let surface = |stage: &Stage<'_>| -> Vec<wear::SurfacePoint> {
        operator.points().iter().map(|p| stage.surface_point(p.position, p.normal, p.weight)).collect()
    };
    let (laws, counterface) = rules(stage)?;
    let gap: Vec<f64> = operator.points().iter().map(|p| start_gap(stage, pair, p.arc)).collect();
    let start = match operator.solve(&gap, &loads[intervals[0].stage], None) {
        Ok(start) if start.status.is_solved() && start.status != ContactStatus::NoContact => start,
        Ok(start) => return Ok(Err(start.status.to_string())),
        Err(error) => return Ok(Err(error.to_string())),
    };
    let mut load_stages = Vec::new();
    for (stage, load) in stages.iter().zip(loads) {
        let speeds = surface(stage).iter().map(|p| p.sliding_speed).collect();
        match operator.system(load) {
            Ok(system) => load_stages.push(LoadStage { system, speeds }),
            Err(error) => return Ok(Err(error.to_string())),
        }
    }
    let first = load_stages[intervals[0].stage].system.clone();
    let mut problem = WearProblem::new(surface(&stage), laws, counterface, gap, first);
    problem.stages = load_stages;
    problem.schedule = intervals.to_vec();
    problem.start = Some([start.pressure, start.opening]);
    problem.track_area = stage.patch.surface.track_area();
    problem.until = Until::Steady { residual: steady_residual(stage), not_before };
    if let Some(scene::Until::Time(time)) = stage.scene().wear.as_ref().and_then(|wear| wear.until) {
        problem.until = Until::Time(time.0);
        problem.stepping = Stepping::Adaptive { accuracy: stage.accuracy() };
    }
    Ok(Ok(problem))
}
