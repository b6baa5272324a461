//! Where the contact of a cylinder or ball with a flat would end between half-planes or half-spaces: a first guess, never a result.

use hpfem::Kinematics;
use meshing::{Body, Couple};
use scene::Material;

use crate::load::Load;
use crate::stage::Stage;

/// Half the width (mm) of a contact of two circles that is shorter than a share of half the surface, and where they touch first; none of other contacts.
pub(crate) fn short_contact(stage: Stage<'_>, share: f64) -> Option<(f64, f64)> {
    let ((touch, radius), [from, to]) = (stage.problem.gap.touch()?, stage.patch.places()?);
    let half = 0.5 * (to - from);
    let end = hertz_end(radius, stage.couple, &stage.problem.load);
    let inside = end > 0.0 && end < share * half && (touch - 0.5 * (from + to)).abs() + 2.0 * end < half;
    inside.then_some((end, touch))
}

/// Half the width of contact, or its radius (Johnson 1985, sec. 4.2 and 7.2), of the softest materials of both bodies.
pub(crate) fn hertz_end(radius: f64, couple: &Couple, load: &Load) -> f64 {
    let plane_stress = matches!(couple.kinematics, Kinematics::PlaneStress { .. });
    let softness = |m: &Material| {
        let [young, poisson] = m.in_plane();
        (if plane_stress { 1.0 } else { 1.0 - poisson * poisson }) / young
    };
    let softest = |body: &Body| body.materials.iter().map(softness).fold(0.0, f64::max);
    let modulus = 1.0 / (softest(&couple.bodies[0]) + softest(&couple.bodies[1]));
    let force = load.force.unwrap_or(0.0);
    match (load.approach.map(|approach| approach.max(0.0)), couple.kinematics) {
        (Some(approach), Kinematics::Axisymmetric) => (radius * approach).sqrt(),
        (Some(approach), _) => 0.5 * (radius * approach).sqrt(),
        (None, Kinematics::Axisymmetric) => (0.75 * force * radius / modulus).cbrt(),
        (None, Kinematics::PlaneStress { thickness } | Kinematics::PlaneStrain { thickness }) => {
            (4.0 * force * radius / (std::f64::consts::PI * modulus * thickness)).sqrt()
        }
        // Problems of one component have no load across the surface.
        (None, Kinematics::Torsion | Kinematics::Potential { .. } | Kinematics::AxisymmetricPotential) => 0.0,
    }
}
