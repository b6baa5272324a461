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

use crate::common::material;
use approx::assert_relative_eq;
use contact::{ContactLoad, ContactOperator, Error, Pair, Status};
use hpfem::{Body, BodyProblem, BoundaryPoint, Curve, Direction, EdgeTraction, Kinematics, Mesh, Named, Ruled, Side};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_6};

const PRESSURE: f64 = 7.0;
const YOUNG: f64 = 1000.0;
const POISSON: f64 = 0.3;

/// The cut with the angle as parameter.
const ARC: Curve = Curve::Arc { centre: [0.0, 3.0], radius: 2.0, from: -FRAC_PI_2, to: -FRAC_PI_2 + FRAC_PI_6 };

/// The same with x as parameter.
fn graph() -> Curve {
    Curve::graph(0.0, 1.0, |x| 3.0 - (4.0 - x * x).sqrt())
}

fn block(upper: bool, breaks: &[f64], cut_curve: Curve) -> Mesh {
    let flat = |z: f64| Curve::Line { start: [0.0, z], end: [1.0, z] };
    let name = |side, name| Named { side, range: None, name };
    let (cut, far) = if upper { (Side::Bottom, Side::Top) } else { (Side::Top, Side::Bottom) };
    Mesh::ruled(&Ruled {
        bottom: if upper { cut_curve } else { flat(0.0) },
        top: if upper { flat(2.0) } else { cut_curve },
        breaks,
        levels: &[0.0, 1.0],
        closed: false,
        material: 0,
        names: &[name(cut, "cut"), name(far, "far"), name(Side::Left, "left"), name(Side::Right, "right")],
    })
    .unwrap()
}

fn press(boundary: &str) -> EdgeTraction {
    EdgeTraction::new(boundary, |p: &BoundaryPoint| p.outward.map(|n| -PRESSURE * n))
}

fn body(mesh: &Mesh, upper: bool, loads: &[&str], degree: usize) -> hpfem::InterfaceOperator {
    body_of(mesh, upper, loads, degree, YOUNG)
}

fn body_of(mesh: &Mesh, upper: bool, loads: &[&str], degree: usize, young: f64) -> hpfem::InterfaceOperator {
    let kinematics = Kinematics::PlaneStrain { thickness: 1.0 };
    let mut problem = BodyProblem::new(mesh.clone(), degree, kinematics).material(material(young, POISSON)).keep("cut");
    problem = problem.hold("left", Direction::First);
    if !upper {
        problem = problem.hold("far", Direction::Second);
    }
    let problem = loads.iter().fold(problem, |problem, boundary| problem.load("pressure", press(boundary)));
    Body::new(problem).unwrap().interface
}

#[test]
fn curved_cut_passes_the_patch_test_with_force_energy_and_reaction() {
    let breaks = [-1.0, -0.2, 1.0];
    let meshes = [block(true, &breaks, ARC), block(false, &breaks, ARC)];
    let loads = [&["far", "right"][..], &["right"]];
    for degrees in [[9, 9], [10, 8]] {
        let upper = body(&meshes[0], true, loads[0], degrees[0]);
        let lower = body(&meshes[1], false, loads[1], degrees[1]);
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

/// Largest relative error of the pressure, and force and moment left over between the bodies (relative), without common break points.
fn unmatched(cuts: [Curve; 2], degrees: [usize; 2], young: [f64; 2]) -> [f64; 3] {
    let meshes = [block(true, &[-1.0, -0.2, 1.0], cuts[0]), block(false, &[-1.0, 0.1, 0.4, 1.0], cuts[1])];
    let loads = [&["far", "right"][..], &["right"]];
    let upper = body_of(&meshes[0], true, loads[0], degrees[0], young[0]);
    let lower = body_of(&meshes[1], false, loads[1], degrees[1], young[1]);
    let pair = Pair::new(&upper, Some(&lower)).unwrap();
    assert!(!pair.is_nodal());
    let operator = ContactOperator::new(&pair, false).unwrap();
    let gap = vec![0.0; operator.points().len()];
    let solution = operator.solve(&gap, &ContactLoad::factors(&[1.0], &[1.0]), None).unwrap();
    assert_eq!(solution.status, Status::ClosedEverywhere);
    let error = solution.pressure.iter().map(|p| (p / PRESSURE - 1.0).abs()).fold(0.0, f64::max);
    let [a, b] = [solution.shaped.load.resultant, solution.counter.unwrap().load.resultant];
    let left = [0, 1, 2].map(|k| (a[k] + b[k]).abs() / PRESSURE);
    assert!((a[0] - solution.force[0]).abs() + (a[2] - solution.moment).abs() < 1e-13 * PRESSURE);
    [error, left[0].max(left[1]), left[2]]
}

#[test]
fn unmatched_straight_boundaries_pass_the_patch_test_to_round_off() {
    let line = Curve::Line { start: [0.0, 1.0], end: [1.0, 1.0] };
    for degrees in [[1, 2], [2, 2], [3, 5], [6, 4], [9, 10]] {
        let [error, force, moment] = unmatched([line; 2], degrees, [YOUNG; 2]);
        println!("{degrees:?}: pressure {error:.1e}, force {force:.1e}, moment {moment:.1e}");
        assert!(error < 1e-11 && force < 1e-13 && moment < 1e-13);
    }
}

#[test]
fn unmatched_arcs_pass_the_patch_test_exponentially_and_balance_to_round_off() {
    for cuts in [[ARC, ARC], [ARC, graph()], [graph(), ARC]] {
        let mut last = f64::INFINITY;
        for degree in [3, 5, 7, 9, 11] {
            let [error, force, moment] = unmatched(cuts, [degree, degree - 1], [YOUNG; 2]);
            println!("{degree}: pressure {error:.1e}, force {force:.1e}, moment {moment:.1e}");
            // The graph is a polynomial: it leaves the arc by its own error.
            let floor = if matches!(cuts, [Curve::Arc { .. }, Curve::Arc { .. }]) { 1e-11 } else { 2e-7 };
            assert!(error < (0.1 * last).max(floor) && force < 1e-13 && moment < 1e-13);
            last = error;
        }
    }
}

#[test]
fn unmatched_bodies_a_million_times_softer_or_stiffer_transmit_the_pressure_without_oscillation() {
    let line = Curve::Line { start: [0.0, 1.0], end: [1.0, 1.0] };
    for ratio in [1e-6, 1e6] {
        for degrees in [[3, 9], [9, 3], [12, 5]] {
            let [error, force, moment] = unmatched([line; 2], degrees, [ratio * YOUNG, YOUNG]);
            println!("E1/E2 {ratio:.0e}, {degrees:?}: pressure {error:.1e}, force {force:.1e}, moment {moment:.1e}");
            assert!(error < 1e-11 && force < 1e-13 && moment < 1e-13);
        }
    }
}

#[test]
fn boundaries_of_different_extent_or_apart_are_refused() {
    let line = |start: [f64; 2], end: [f64; 2]| Curve::Line { start, end };
    let breaks = [-1.0, 1.0];
    let meshes = [block(true, &breaks, ARC), block(false, &breaks, line([0.0, 0.5], [1.0, 0.5]))];
    let upper = body(&meshes[0], true, &[], 4);
    let apart = body(&meshes[1], false, &[], 4);
    assert!(matches!(Pair::new(&upper, Some(&apart)), Err(Error::Unmatched { edge: 0, .. })));
    let short = Mesh::ruled(&Ruled {
        bottom: line([0.2, 0.5], [1.5, 0.5]),
        top: line([0.2, 1.0], [1.5, 1.0]),
        breaks: &breaks,
        levels: &[0.0, 1.0],
        closed: false,
        material: 0,
        names: &["cut", "far", "left"].map(|name| {
            let side = if name == "cut" { Side::Bottom } else { Side::Top };
            Named { side, range: None, name }
        }),
    });
    let short = body(&short.unwrap(), true, &[], 4);
    let error = Pair::new(&short, Some(&apart)).err().unwrap();
    println!("{error}");
    assert!(matches!(error, Error::Unmatched { .. }));
}
