//! Circumferential friction in axisymmetric scenes: a scalar problem of its own on the same meshes.

use contact::ContactPoint;
use hpfem::Kinematics;
use shapeopt::SurfacePlace;

use crate::fault::Fault;
use crate::fe::bodies::Level;
use crate::fe::shape::Shaper;
use crate::profile::Profile;
use crate::solution::Solution;

/// Fills in the circumferential displacements of both bodies under the friction `mu p`, positive along the drag on body 1.
pub(super) fn fill(
    shaper: &Shaper<'_>,
    level: Level,
    points: &[ContactPoint],
    profile: &mut Profile,
    solution: &mut Solution,
) -> Result<(), Fault> {
    let stage = shaper.stage;
    let reduced = stage.twisted(level, solution)?;
    for (body, operator) in reduced.interfaces.iter().enumerate() {
        let sign = if body == 0 { 1.0 } else { -1.0 };
        let load = operator.trace.load(Kinematics::Torsion, 4, |point| {
            let normal = if body == 0 { point.outward.map(|v| -v) } else { point.outward };
            let pressure = shaper.pressure(&SurfacePlace { position: point.position, normal });
            [sign * stage.friction() * pressure, 0.0]
        });
        let factors = operator.factors(&[]);
        let right = operator.right_hand_side(&load, &factors);
        let unknowns = operator.solve_one(&right);
        for (row, point) in points.iter().enumerate() {
            let (rows, constant) = operator.trace.displacement_row(point.place.0, point.place.1);
            let u = rows[0].iter().map(|(i, c)| c * unknowns[*i]).sum::<f64>() + constant[0];
            profile.hoop_displacement[body][row] = 1e3 * u;
        }
    }
    Ok(())
}
