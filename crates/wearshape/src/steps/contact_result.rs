//! A solved contact in numbers of the summary.

use contact::{ContactOperator, ContactSolution, Pair, without_slivers};

use crate::results::ContactResult;
use crate::stage::Stage;
use crate::steps::rigid_coordinates::motion;
use crate::steps::sharp_edges;
use shapeopt::Gauge;

/// What the summary says of a contact; the ends are those of its points.
pub(crate) fn result(
    stage: Stage<'_>,
    pair: &Pair<'_>,
    operator: &ContactOperator<'_>,
    found: &ContactSolution,
) -> ContactResult {
    let (start, length) = (stage.start(pair), pair.trace().length());
    let about = stage.about();
    let points = operator.points();
    let moment =
        points.iter().zip(&found.nodal_force).map(|(p, force)| (p.position[0] - about) * force * p.normal[1]).sum::<f64>();
    let [approach, tilt] = closings(stage, pair, found);
    let edge_exponents = sharp_edges::exponents(pair, operator, found);
    let singular = !edge_exponents.is_empty();
    let shear: Vec<f64> = found.shear.iter().map(|q| q.abs()).collect();
    ContactResult {
        status: (&found.status).into(),
        force: Some(found.force[1]),
        // About a pin it is that of the load.
        moment: Some(moment).filter(|_| !stage.couple.moves_one_way()),
        approach,
        tilt,
        ends: without_slivers(&found.zones, length).iter().flatten().map(|arc| start + arc.clamp(0.0, length)).collect(),
        // At a sharp corner the pressure is infinite: its exponent says more than the largest nodal value.
        p_max: Some(operator.maximum(&found.pressure)).filter(|_| !singular),
        edge_exponents,
        stick_ends: Vec::new(),
        q_max: Some(operator.maximum(&shear)).filter(|_| !singular),
        twist: None,
        uniqueness: None,
        complementarity: Some(found.complementarity),
        iterations: Some(found.iterations),
    }
}

/// What the summary says of a contact that was lost: its last iterate is none.
pub(crate) fn lost(found: &ContactSolution) -> ContactResult {
    ContactResult {
        status: (&found.status).into(),
        complementarity: Some(found.complementarity),
        iterations: Some(found.iterations),
        ..ContactResult::default()
    }
}

/// How far body 1 closes (mm) and turns (rad): by the motions of its rigid edge, or by those that its load edge has on the average, as far as
/// they are free.
pub(crate) fn closings(stage: Stage<'_>, pair: &Pair<'_>, found: &ContactSolution) -> [Option<f64>; 2] {
    let gauge = stage.gauge(pair);
    if !matches!(gauge, Gauge::MeanOf(_)) {
        let [_, tz, theta] = pair.shaped.frame.map(|unknown| unknown.map(|u| found.shaped.unknowns[u]));
        return [tz, theta].map(|motion| motion.map(|u| -u));
    }
    let coordinates = gauge.zero(pair.shaped, &mut found.shaped.clone());
    let [closing, turning] = motion(pair, &coordinates, stage.about());
    let free = |row: usize| pair.shaped.rigid_motions.iter().any(|of| of[row] != 0.0) && !coordinates.is_empty();
    [(1, closing), (2, turning)].map(|(row, value)| Some(value).filter(|_| free(row)))
}
