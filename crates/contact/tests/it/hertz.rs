//! Elastic cylinder on an elastic block, NAFEMS R94 CB1 (plane strain, thickness 1 mm): E 210 and 70 GPa, nu 0.3, R 50 mm, 35 kN.

use crate::common::cylinder::{Sizes, block, round};
use crate::common::{falling_degrees, material, support};
use contact::*;
use hpfem::*;

const SIZES: Sizes = Sizes { radius: 50.0, width: 100.0, depth: 200.0 };

/// Both bodies as interface operators with a node at `end`, under `force` on the whole cylinder.
fn bodies(end: f64, candidate: f64, degree: usize, layers: usize, force: f64) -> Rebuilt {
    let kinematics = Kinematics::PlaneStrain { thickness: 1.0 };
    let pressure = force / (2.0 * SIZES.radius);
    let load = vec![vec![EdgeTraction { boundary: "top".into(), traction: Box::new(move |_| [0.0, -pressure]) }]];
    let reduce = |mesh: &Mesh, young: f64, supports: &[Support], load: &[LoadCase<'_>]| {
        Body::new(BodyProblem {
            mesh,
            degrees: falling_degrees(mesh, degree, layers),
            space: SpaceKind::Tensor,
            kinematics,
            materials: &material(young, 0.3),
            supports,
            rigid_edge: None,
            load_cases: load,
            kept: Some("contact"),
        })
        .unwrap()
        .interface
    };
    let axis = support("axis", Direction::First);
    let clamp = [axis.clone(), support("bottom", Direction::First), support("bottom", Direction::Second)];
    Rebuilt {
        shaped: reduce(&round(&SIZES, end, candidate, layers), 210e3, &[axis], &load),
        counter: reduce(&block(&SIZES, end, candidate, layers), 70e3, &clamp, &[]),
        facing: true,
    }
}

fn gap(point: &ContactPoint) -> f64 {
    let x = point.position[0];
    x * x / (SIZES.radius + (SIZES.radius.powi(2) - x * x).sqrt())
}

fn hertz(force: f64) -> (f64, f64) {
    let modulus = 1.0 / (0.91 / 210e3 + 0.91 / 70e3);
    let end = (4.0 * force * SIZES.radius / (std::f64::consts::PI * modulus)).sqrt();
    (end, 2.0 * force / (std::f64::consts::PI * end))
}

/// End of contact and highest pressure, with a node on the end.
fn positioned(degree: usize, layers: usize, force: f64) -> (Positioned, f64) {
    let problem = Positioning {
        gap: &gap,
        load: &|_| ContactLoad::factors(&[1.0], &[]),
        starts_closed: true,
        tolerance: 1e-10,
    };
    let trial = hertz(force).0 * 1.05;
    let result =
        position_ends::<Error>(&problem, &[trial], |ends| Ok(bodies(ends[0], 1.6, degree, layers, force))).unwrap();
    let highest = result.solution.pressure[0];
    (result, highest)
}

#[test]
fn cylinder_has_the_reference_end_of_contact_and_pressure() {
    for (degree, layers) in [(8, 4), (10, 5), (12, 6)] {
        let (result, highest) = positioned(degree, layers, 35e3);
        println!("{degree} {layers}: a {:.9} p0 {:.6} made {} {:.1e}", result.ends[0], highest, result.factorisations, result.history.last().unwrap());
        let (result, highest) = positioned(degree, layers, 350.0);
        let (a, p) = hertz(350.0);
        println!("  350 N: {:.4e} {:.4e}", result.ends[0] / a - 1.0, highest / p - 1.0);
    }
}
