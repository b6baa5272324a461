//! Where the contact of a cylinder or ball with a flat would end between half-planes or half-spaces: a first guess, never a result.

use hpfem::Kinematics;
use scene::{Load, Material};

/// Half the width of contact, or its radius (Johnson 1985, sec. 4.2 and 7.2), of the softest materials of both bodies.
pub(super) fn hertz_end(radius: f64, materials: [&[Material]; 2], load: &Load, kinematics: Kinematics) -> f64 {
    let plane_stress = matches!(kinematics, Kinematics::PlaneStress { .. });
    let softness = |m: &Material| (if plane_stress { 1.0 } else { 1.0 - m.poisson * m.poisson }) / m.young.0;
    let softest = |materials: &[Material]| materials.iter().map(softness).fold(0.0, f64::max);
    let modulus = 1.0 / (softest(materials[0]) + softest(materials[1]));
    let force = load.force.map_or(0.0, |force| force.0);
    match (load.approach.map(|approach| approach.0.max(0.0)), kinematics) {
        (Some(approach), Kinematics::Axisymmetric) => (radius * approach).sqrt(),
        (Some(approach), _) => 0.5 * (radius * approach).sqrt(),
        (None, Kinematics::Axisymmetric) => (0.75 * force * radius / modulus).cbrt(),
        (None, Kinematics::PlaneStress { thickness } | Kinematics::PlaneStrain { thickness }) => {
            (4.0 * force * radius / (std::f64::consts::PI * modulus * thickness)).sqrt()
        }
        (None, Kinematics::Torsion) => 0.0,
    }
}
