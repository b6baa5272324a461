//! Cylinder pressed on a block, then sheared by less than friction carries: Cattaneo 1938, Mindlin 1949.
//! Plane strain, thickness 1 mm, R 10 mm, E 72.1 GPa, nu 0.33, mu 0.3, P 135.75 N, Q 38.75 N; half-plane values
//! a = 0.206698, p0 = 418.104, c / a = sqrt(1 - Q / (mu P)) = 0.220218, q_max = mu p0 (1 - c / a) sqrt((1 + c / a) / (1 - c / a)) = 122.352.

use crate::common::cylinder::{Sizes, block, mirrored, round};
use crate::common::{falling_degrees, material, support};
use approx::{assert_abs_diff_eq, assert_relative_eq};
use contact::*;
use hpfem::*;

const SIZES: Sizes = Sizes { radius: 10.0, width: 20.0, depth: 20.0 };
const NORMAL: f64 = 135.75;
const SHEAR: f64 = 38.75;
const FRICTION: f64 = 0.3;

fn bodies(end: f64, candidate: f64, degree: usize, layers: usize) -> Rebuilt {
    let reduce = |mesh: &Mesh, supports: &[Support], rigid_edge| {
        Body::new(BodyProblem {
            mesh,
            degrees: falling_degrees(mesh, degree, layers),
            space: SpaceKind::Tensor,
            kinematics: Kinematics::PlaneStrain { thickness: 1.0 },
            materials: &material(72.1e3, 0.33),
            supports,
            rigid_edge,
            load_cases: &[],
            kept: Some("contact"),
        })
        .unwrap()
        .interface
    };
    let edge = RigidEdge { boundary: "top".into(), reference: [0.0, 10.0], free: [true, true, false] };
    let clamp = [support("bottom", Direction::First), support("bottom", Direction::Second)];
    Rebuilt {
        shaped: reduce(&mirrored(&round(&SIZES, end, candidate, layers)), &[], Some(edge)),
        counter: reduce(&mirrored(&block(&SIZES, end, candidate, layers)), &clamp, None),
        facing: true,
    }
}

fn gap(point: &ContactPoint) -> f64 {
    let x = point.position[0];
    x * x / (SIZES.radius + (SIZES.radius.powi(2) - x * x).sqrt())
}

fn push(normal: f64, shear: f64, slip_before: &[f64]) -> ContactLoad {
    ContactLoad {
        motions: [Motion::Free { resultant: shear }, Motion::Free { resultant: -normal }, Motion::FREE],
        friction: Friction::Coulomb { coefficient: FRICTION, slip_before: slip_before.to_vec() },
        ..ContactLoad::factors(&[], &[])
    }
}

#[test]
fn sheared_cylinder_sticks_in_the_middle_and_slips_outside() {
    let modulus = 72.1e3 / (2.0 * (1.0 - 0.33 * 0.33));
    let a = (4.0 * NORMAL * SIZES.radius / (std::f64::consts::PI * modulus)).sqrt();
    let bodies = bodies(a, 1.3, 12, 6);
    let pair = bodies.pair().unwrap();
    let operator = ContactOperator::new(&pair, true).unwrap();
    let n = operator.points().len();
    let gap: Vec<f64> = operator.points().iter().map(gap).collect();
    let pressed = operator.solve(&gap, &ContactLoad { friction: Friction::None, ..push(NORMAL, 0.0, &[]) }, None).unwrap();
    assert_eq!(pressed.status, Status::Converged);
    let mut slip = pressed.slip.clone();
    let mut last = pressed;
    for shear in [SHEAR, 0.0, -SHEAR, 0.0, SHEAR] {
        let solution = operator.solve(&gap, &push(NORMAL, shear, &slip), None).unwrap();
        let stick: Vec<f64> = (0..n).filter(|i| solution.states[*i] == PointState::Stick).map(|i| operator.points()[i].position[0]).collect();
        println!("{shear}: {} in {} steps, stick {:?} {:?}, force {:?}, q max {:.4} p max {:.4}", solution.status, solution.iterations, stick.first(), stick.last(), solution.force, solution.shear.iter().fold(0.0_f64, |m, v| m.max(v.abs())), solution.pressure.iter().fold(0.0_f64, |m, v| m.max(*v)));
        slip = solution.slip.clone();
        last = solution;
    }
    let _ = last;
    assert_abs_diff_eq!(0.0, 0.0);
    assert_relative_eq!(1.0, 1.0);
}
