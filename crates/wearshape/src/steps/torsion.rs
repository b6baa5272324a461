//! Circumferential friction in axisymmetric scenes: a scalar problem of its own on the same meshes.

use contact::{ContactPoint, Pair, Side};
use scene::Fault;

use crate::effort::Effort;
use crate::profile::Profile;
use crate::results::EnergyResult;
use crate::stage::Stage;
use crate::steps::reported::Reported;

/// Shear `mu p tau` around the axis on body 1 (MPa), positive where body 2 drags it anti-clockwise; of a stage under its own sliding.
pub(crate) fn around(stage: Stage<'_>, points: &[ContactPoint], pressure: &[f64]) -> Vec<f64> {
    let drag = |point: &ContactPoint| stage.surface_point(point.position, point.normal, 0.0).drag.y;
    points.iter().zip(pressure).map(|(point, p)| stage.friction() * p * drag(point)).collect()
}

/// Circumferential displacements of both bodies under the shear at the contact points, into the rows of a profile that lie at `rows`. Gives the strain
/// energies of this twist (N mm).
pub(crate) fn write(pair: &Pair<'_>, around: &[f64], rows: &[ContactPoint], profile: &mut Profile) -> [Option<f64>; 2] {
    let mut energies = [None, None];
    for (body, side) in [Side::Shaped, Side::Counter].into_iter().enumerate() {
        let Some(operator) = pair.side(side) else { continue };
        let state = pair.twisted(side, operator, around);
        energies[body] = Some(operator.strain_energy(&state));
        for (value, point) in profile.hoop_displacement[body].iter_mut().zip(rows) {
            *value = 1e3 * pair.hoop_displacement(side, &state, point);
        }
    }
    energies
}

/// Fills the circumferential displacements of both bodies into the reported columns, positive anti-clockwise, and adds the strain energies of this twist.
pub(crate) fn fill(
    stage: Stage<'_>,
    reported: &Reported,
    (profile, energy): (&mut Profile, &mut EnergyResult),
) -> Result<Effort, Fault> {
    let Some(moment) = reported.moments.first() else { return Ok(Effort::default()) };
    let (twist, effort) = stage.twisted(reported.level, &reported.ends)?;
    let pair = twist.pair()?;
    let rows = stage.options.sample.map_or_else(|| pair.points(), |sampling| stage.sample(&pair, sampling));
    [energy.twist1, energy.twist2] = write(&pair, &moment.around, &rows, profile);
    Ok(effort)
}
