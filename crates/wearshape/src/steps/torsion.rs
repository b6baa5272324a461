//! Circumferential friction in axisymmetric scenes: a scalar problem of its own on the same meshes.

use contact::{ContactPoint, Pair, Side};
use hpfem::{InterfaceOperator, InterfaceState, TraceLoad};
use scene::Fault;

use crate::effort::Effort;
use crate::profile::Profile;
use crate::stage::Stage;
use crate::steps::reported::Reported;

/// Shear `mu p tau` around the axis on body 1 (MPa), positive where body 2 drags it anti-clockwise; of a stage under its own sliding.
pub(crate) fn around(stage: Stage<'_>, points: &[ContactPoint], pressure: &[f64]) -> Vec<f64> {
    let drag = |point: &ContactPoint| stage.surface_point(point.position, point.normal, 0.0).drag.y;
    points.iter().zip(pressure).map(|(point, p)| stage.friction() * p * drag(point)).collect()
}

/// A body of the pair twisted by the shear at the contact points, with the same point forces that the contact has; `operator` is its scalar
/// problem on the same mesh.
pub(crate) fn twisted(
    operator: &InterfaceOperator,
    pair: &Pair<'_>,
    side: Side,
    points: &[ContactPoint],
    around: &[f64],
) -> InterfaceState {
    let sign = if side == Side::Shaped { 1.0 } else { -1.0 };
    let mut load = TraceLoad { unknowns: vec![0.0; operator.trace.unknowns], ..TraceLoad::default() };
    for (point, shear) in points.iter().zip(around) {
        operator.trace.add_force(&mut load, pair.place(side, point), [sign * shear * point.weight, 0.0]);
    }
    let factors = operator.factors(&[]);
    let unknowns = operator.solve_one(&operator.right_hand_side(&load, &factors));
    InterfaceState { unknowns, factors, load }
}

/// Circumferential displacements of both bodies under the shear at the contact points, into the rows of a profile that lie at `rows`.
pub(crate) fn write(pair: &Pair<'_>, around: &[f64], rows: &[ContactPoint], profile: &mut Profile) {
    let points = pair.points();
    for (body, side) in [Side::Shaped, Side::Counter].into_iter().enumerate() {
        let Some(operator) = pair.side(side) else { continue };
        let state = twisted(operator, pair, side, &points, around);
        for (value, point) in profile.hoop_displacement[body].iter_mut().zip(rows) {
            let (edge, t) = pair.place(side, point);
            let (rows, constant) = operator.trace.displacement_row(edge, t);
            *value = 1e3 * (rows[0].iter().map(|(i, c)| c * state.unknowns[*i]).sum::<f64>() + constant[0]);
        }
    }
}

/// Fills the circumferential displacements of both bodies into the reported columns, positive anti-clockwise.
pub(crate) fn fill(stage: Stage<'_>, reported: &Reported, profile: &mut Profile) -> Result<Effort, Fault> {
    let Some(moment) = reported.moments.first() else { return Ok(Effort::default()) };
    let (twist, effort) = stage.twisted(reported.level, &reported.ends)?;
    let pair = twist.pair()?;
    let rows = stage.options.sample.map_or_else(|| pair.points(), |sampling| stage.sample(&pair, sampling));
    write(&pair, &moment.around, &rows, profile);
    Ok(effort)
}
