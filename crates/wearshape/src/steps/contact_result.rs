//! A solved contact in numbers of the summary.

use contact::{ContactOperator, ContactSolution, Pair, without_slivers};

use crate::results::ContactResult;
use crate::stage::Stage;
use crate::steps::sharp_edges;

/// What the summary says of a contact; the ends are those of its points.
pub(crate) fn result(
    stage: Stage<'_>,
    pair: &Pair<'_>,
    operator: &ContactOperator<'_>,
    found: &ContactSolution,
) -> ContactResult {
    let start = stage.start(pair);
    let about = stage.about();
    let points = operator.points();
    let moment =
        points.iter().zip(&found.nodal_force).map(|(p, force)| (p.position[0] - about) * force * p.normal[1]).sum::<f64>();
    let [_, tz, theta] = motions(pair, found);
    let edge_exponents = sharp_edges::exponents(pair, operator, found);
    let singular = !edge_exponents.is_empty();
    let shear: Vec<f64> = found.shear.iter().map(|q| q.abs()).collect();
    ContactResult {
        status: (&found.status).into(),
        force: Some(found.force[1]),
        // About a pin it is that of the load.
        moment: Some(moment).filter(|_| !stage.couple.moves_one_way()),
        approach: tz.map(|z| -z),
        tilt: theta.map(|t| -t),
        ends: without_slivers(&found.zones, pair.trace().length()).iter().flatten().map(|arc| start + arc).collect(),
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

/// Motions of the rigid edge: t_x, t_z, theta, as far as it is there.
fn motions(pair: &Pair<'_>, found: &ContactSolution) -> [Option<f64>; 3] {
    let frame = pair.shaped.frame;
    frame.map(|unknown| unknown.map(|u| found.shaped.unknowns[u]))
}
