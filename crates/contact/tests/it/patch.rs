//! A block cut along an arc and pressed from all sides transmits the same pressure everywhere.
//!
//! ```text
//!        p p p p
//!     o---------+         u = -p (1 + nu) (1 - 2 nu) / E (x, z): linear, plane strain
//!     o  upper  | p
//!     o___   ___|         the cut: radius 2 about (0, 3)
//!     o   ---   | p
//!     o  lower  | p
//!     +---------+
//!      o o o o o
//! ```

use crate::common::{material, support};
use approx::assert_relative_eq;
use contact::{ContactLoad, ContactOperator, Error, Pair, Status};
use hpfem::{
    Body, BodyProblem, BoundaryPoint, Curve, Direction, EdgeTraction, Kinematics, LoadCase, Mesh, Named, Ruled, Side, SpaceKind,
};
use std::f64::consts::FRAC_PI_2;

const PRESSURE: f64 = 7.0;
const YOUNG: f64 = 1000.0;
const POISSON: f64 = 0.3;

fn block(upper: bool, breaks: &[f64]) -> Mesh {
    let arc = Curve::Arc { centre: [0.0, 3.0], radius: 2.0, from: -FRAC_PI_2, to: -FRAC_PI_2 + 0.5_f64.asin() };
    let flat = |z: f64| Curve::Line { start: [0.0, z], end: [1.0, z] };
    let name = |side, name| Named { side, range: None, name };
    let (cut, far) = if upper { (Side::Bottom, Side::Top) } else { (Side::Top, Side::Bottom) };
    Mesh::ruled(&Ruled {
        bottom: if upper { arc } else { flat(0.0) },
        top: if upper { flat(2.0) } else { arc },
        breaks,
        levels: &[0.0, 1.0],
        closed: false,
        material: 0,
        names: &[name(cut, "cut"), name(far, "far"), name(Side::Left, "left"), name(Side::Right, "right")],
    })
    .unwrap()
}

fn press(boundary: &str) -> EdgeTraction<'static> {
    EdgeTraction { boundary: boundary.into(), traction: Box::new(|p: &BoundaryPoint| p.outward.map(|n| -PRESSURE * n)) }
}

fn body<'a>(mesh: &'a Mesh, upper: bool, loads: &'a [LoadCase<'a>], degree: usize) -> hpfem::InterfaceOperator {
    let mut supports = vec![support("left", Direction::First)];
    if !upper {
        supports.push(support("far", Direction::Second));
    }
    Body::new(BodyProblem {
        mesh,
        degrees: vec![degree; mesh.cells.len()],
        space: SpaceKind::Tensor,
        kinematics: Kinematics::PlaneStrain { thickness: 1.0 },
        materials: &material(YOUNG, POISSON),
        supports: &supports,
        rigid_edge: None,
        load_cases: loads,
        kept: Some("cut"),
    })
    .unwrap()
    .interface
}

#[test]
fn curved_cut_passes_the_patch_test_with_force_energy_and_reaction() {
    let breaks = [-1.0, -0.2, 1.0];
    let meshes = [block(true, &breaks), block(false, &breaks)];
    let loads = [[vec![press("far"), press("right")]], [vec![press("right")]]];
    for degrees in [[9, 9], [10, 8]] {
        let upper = body(&meshes[0], true, &loads[0], degrees[0]);
        let lower = body(&meshes[1], false, &loads[1], degrees[1]);
        let pair = Pair::new(&upper, Some(&lower)).unwrap();
        let operator = ContactOperator::new(&pair, false).unwrap();
        let gap = vec![0.0; operator.points().len()];
        let solution = operator.solve(&gap, &ContactLoad::factors(&[1.0], &[1.0]), None).unwrap();
        assert_eq!(solution.status, Status::ClosedEverywhere);
        for p in &solution.pressure {
            assert_relative_eq!(*p, PRESSURE, max_relative = 1e-7);
        }
        assert_relative_eq!(solution.force[1], PRESSURE, max_relative = 1e-12);
        let counter = solution.counter.unwrap();
        let energy = upper.strain_energy(&solution.shaped) + lower.strain_energy(&counter);
        let exact = 2.0 * PRESSURE * PRESSURE * (1.0 + POISSON) * (1.0 - 2.0 * POISSON) / YOUNG;
        assert_relative_eq!(energy, exact, max_relative = 1e-10);
        assert_relative_eq!(lower.reaction(1, &counter)[1], PRESSURE, max_relative = 1e-11);
    }
}

#[test]
fn boundaries_with_different_break_points_are_refused() {
    let meshes = [block(true, &[-1.0, -0.2, 1.0]), block(false, &[-1.0, 0.1, 1.0]), block(false, &[-1.0, 1.0])];
    let upper = body(&meshes[0], true, &[], 4);
    let shifted = body(&meshes[1], false, &[], 4);
    let fewer = body(&meshes[2], false, &[], 4);
    assert!(matches!(Pair::new(&upper, Some(&shifted)), Err(Error::Unmatched { edge: 0, .. })));
    assert!(matches!(Pair::new(&upper, Some(&fewer)), Err(Error::EdgeCount { shaped: 2, counter: 1 })));
}
