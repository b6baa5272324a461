//! Cylinder pressed on a block, then sheared by less than friction carries: Cattaneo 1938, Mindlin 1949.
//! Plane strain, thickness 1 mm, R 10 mm, E 72.1 GPa, nu 0.33, mu 0.3, P 135.75 N, Q 38.75 N; half-plane values
//! a = 0.206698, p0 = 418.104, c / a = sqrt(1 - Q / (mu P)) = 0.220218, q_max = mu p0 (1 - c / a) sqrt((1 + c / a) / (1 - c / a)) = 122.352.

use crate::common::cylinder::{Sizes, block, mirrored, round};
use crate::common::{material, touching};
use approx::{assert_abs_diff_eq, assert_relative_eq};
use contact::*;
use hpfem::{Body, BodyProblem, Kinematics, RigidEdge};

const SIZES: Sizes = Sizes { radius: 10.0, width: 20.0, depth: 20.0 };
pub(crate) const NORMAL: f64 = 135.75;
pub(crate) const SHEAR: f64 = 38.75;
pub(crate) const FRICTION: f64 = 0.3;

pub(crate) fn bodies(nodes: &[f64], candidate: f64, degree: usize, layers: usize) -> Rebuilt {
    let kinematics = Kinematics::PlaneStrain { thickness: 1.0 };
    let problem = |mesh| touching(mesh, [degree, layers], kinematics, material(72.1e3, 0.33));
    let edge = RigidEdge { boundary: "top".into(), reference: [0.0, 10.0], free: [true, true, false] };
    let upper = BodyProblem { rigid_edge: Some(edge), ..problem(mirrored(&round(&SIZES, nodes, candidate, layers))) };
    let lower = problem(mirrored(&block(&SIZES, nodes, candidate, layers))).clamp("bottom");
    let reduced = |problem| Body::new(problem).unwrap().interface;
    Rebuilt { shaped: reduced(upper), counter: reduced(lower), facing: true }
}

pub(crate) fn gap(point: &ContactPoint) -> f64 {
    let x = point.position[0];
    x * x / (SIZES.radius + (SIZES.radius.powi(2) - x * x).sqrt())
}

pub(crate) fn push(normal: f64, shear: f64, slip_before: &[f64]) -> ContactLoad {
    ContactLoad {
        motions: [Motion::Free { resultant: shear }, Motion::Free { resultant: -normal }, Motion::FREE],
        friction: Friction::Coulomb { coefficient: FRICTION, slip_before: slip_before.to_vec() },
        ..ContactLoad::factors(&[], &[])
    }
}

/// End of contact and highest pressure between half-planes.
pub(crate) fn hertz(normal: f64) -> (f64, f64) {
    let modulus = 72.1e3 / (2.0 * (1.0 - 0.33 * 0.33));
    let end = (4.0 * normal * SIZES.radius / (std::f64::consts::PI * modulus)).sqrt();
    (end, 2.0 * normal / (std::f64::consts::PI * end))
}

/// Stick over contact length and highest shear with nodes on both ends, at a scale of both loads.
fn positioned(scale: f64, degree: usize, layers: usize) -> (f64, f64, f64) {
    let (normal, shear) = (NORMAL * scale, SHEAR * scale);
    let a = hertz(normal).0;
    let start = Start {
        places: &[0.23 * a, 1.02 * a],
        jacobian: None,
        apart: false,
        tolerance: 1e-9,
        share: 0.0,
        within: contact::UNBOUNDED,
    };
    let nodes = position_nodes(start, |nodes| -> Result<_, Error> {
        let bodies = bodies(nodes, 1.5, degree, layers);
        let pair = bodies.pair()?;
        let operator = ContactOperator::new(&pair, true)?;
        let gap: Vec<f64> = operator.points().iter().map(gap).collect();
        let state = |x: f64| match x.abs() {
            x if x > nodes[1] * (1.0 + 1e-9) => ContactState::Open,
            x if x > nodes[0] * (1.0 + 1e-9) => ContactState::Backward,
            _ => ContactState::Stick,
        };
        let states: Vec<ContactState> = operator.points().iter().map(|p| state(p.position[0])).collect();
        let closed: Vec<bool> = states.iter().map(|s| *s != ContactState::Open).collect();
        let press = ContactLoad { friction: Friction::None, ..push(normal, 0.0, &[]) };
        let pressed = operator.solve_on(&gap, &press, &closed)?.ok_or(Error::Singular)?;
        let load = push(normal, shear, &pressed.slip);
        let sheared = operator.solve_states(&gap, &load, &states)?.ok_or(Error::Singular)?;
        let at = |x: f64| {
            let far = |i: &usize| (operator.points()[*i].position[0] - x).abs();
            (0..states.len()).min_by(|i, j| far(i).total_cmp(&far(j))).unwrap()
        };
        let (c, a) = (at(nodes[0]), at(nodes[1]));
        let excess = -sheared.shear[c] - FRICTION * sheared.pressure[c];
        Ok((vec![excess, pressed.pressure[a]], -sheared.shear[c]))
    })
    .unwrap();
    assert!(nodes.found);
    println!(
        "scale {scale}: c {:.8}, a {:.8}, c/a {:.6}, q {:.5}, {} bodies",
        nodes.places[0],
        nodes.places[1],
        nodes.places[0] / nodes.places[1],
        nodes.last,
        nodes.evaluations
    );
    (nodes.places[0], nodes.places[1], nodes.last)
}

#[test]
fn stick_zone_and_highest_shear_approach_the_half_plane_values_as_the_load_falls() {
    let deviation = |scale: f64| {
        let (c, a, q) = positioned(scale, 12, 6);
        let stick = (1.0 - SHEAR / (FRICTION * NORMAL)).sqrt();
        let highest = FRICTION * hertz(NORMAL * scale).1 * (1.0 - stick * stick).sqrt();
        let d = (c / a / stick - 1.0, q / highest - 1.0);
        println!("c/a {:.3e}, q_max {:.3e}", d.0, d.1);
        d
    };
    let (large, small) = (deviation(1.0), deviation(0.01));
    assert!(small.0.abs() < 1e-3 && small.1.abs() < 1e-3);
    // Like a / R, which is ten times smaller.
    assert_relative_eq!(large.0 / small.0, 10.0, max_relative = 0.05);
    assert!(small.1.abs() < 0.2 * large.1.abs());
}

/// Coulomb's conditions at every point: shear within its limit, no slip below it, slip against the shear at it.
fn check_friction(solution: &ContactSolution, before: &[f64]) {
    let force = solution.nodal_force.iter().fold(0.0_f64, |m, v| m.max(*v));
    let slip: Vec<f64> = solution.slip.iter().zip(before).map(|(s, b)| s - b).collect();
    let size = slip.iter().zip(&solution.closed).filter(|(_, c)| **c).map(|(s, _)| s.abs()).fold(0.0, f64::max);
    for i in (0..slip.len()).filter(|i| solution.closed[*i]) {
        let (shear, limit) = (solution.nodal_shear[i], FRICTION * solution.nodal_force[i]);
        assert!(shear.abs() <= limit + 1e-9 * force);
        if shear.abs() < limit - 1e-9 * force {
            assert!(slip[i].abs() < 1e-9 * size);
        } else {
            assert!(slip[i] * shear.signum() < 1e-9 * size);
        }
    }
}

/// Shear between half-planes once the shear load is taken off again (Mindlin and Deresiewicz 1953): reversed slip from the edge inwards, doubled.
fn unloaded(x: f64) -> f64 {
    let (a, p0) = hertz(NORMAL);
    let carried = |share: f64| {
        let half = |c: f64| (c * c - x * x).max(0.0).sqrt() / a;
        FRICTION * p0 * (half(a) - half(a * (1.0 - share).sqrt()))
    };
    -carried(SHEAR / (FRICTION * NORMAL)) + 2.0 * carried(0.5 * SHEAR / (FRICTION * NORMAL))
}

/// Difference of the shear between first and second arrival at the full shear load, between second and third, and between the residual shear after both
/// unloadings (turned), in the L2 norm relative to the shear at full load.
fn loop_error(degree: usize, substeps: usize) -> [f64; 3] {
    let a = hertz(NORMAL).0;
    let bodies = bodies(&[0.22 * a, a], 1.3, degree, 4);
    let pair = bodies.pair().unwrap();
    let operator = ContactOperator::new(&pair, true).unwrap();
    let gap: Vec<f64> = operator.points().iter().map(gap).collect();
    let press = ContactLoad { friction: Friction::None, ..push(NORMAL, 0.0, &[]) };
    let mut last = operator.solve(&gap, &press, None).unwrap();
    assert_eq!(last.status, Status::Converged);
    let mut turns = Vec::new();
    let mut most = 0;
    let mut from = 0.0;
    for to in [SHEAR, 0.0, -SHEAR, 0.0, SHEAR, 0.0, -SHEAR, 0.0, SHEAR] {
        for k in 1..=substeps {
            let shear = from + (to - from) * k as f64 / substeps as f64;
            let before = last.slip.clone();
            last = operator.solve(&gap, &push(NORMAL, shear, &last.slip), Some(&last)).unwrap();
            assert_eq!(last.status, Status::Converged);
            most = most.max(last.iterations);
            assert_relative_eq!(last.force[0], -shear, epsilon = 1e-9);
            check_friction(&last, &before);
        }
        from = to;
        turns.push(last.clone());
    }
    let norm = |v: &[f64]| operator.points().iter().zip(v).map(|(p, v)| p.weight * v * v).sum::<f64>().sqrt();
    let difference = |a: &[f64], b: &[f64], sign: f64| norm(&a.iter().zip(b).map(|(a, b)| a - sign * b).collect::<Vec<_>>());
    let highest = norm(&turns[0].shear);
    let first = difference(&turns[4].shear, &turns[0].shear, 1.0) / highest;
    let closing = difference(&turns[8].shear, &turns[4].shear, 1.0) / highest;
    let mirrored: Vec<f64> = turns[7].shear.iter().rev().copied().collect();
    let turned = difference(&mirrored, &turns[5].shear, -1.0) / highest;
    let theory: Vec<f64> = operator.points().iter().map(|p| unloaded(p.position[0])).collect();
    let unloading = difference(&turns[1].shear, &theory, 1.0) / highest;
    println!(
        "degree {degree}, {substeps} substeps: first turn {first:.2e}, loop {closing:.2e}, residual shear {:.3}, turned {turned:.2e}, from theory {unloading:.2e}, at most {most} steps",
        norm(&turns[1].shear) / highest
    );
    assert!(most <= 20 && unloading < 0.02);
    [first, closing, turned]
}

#[test]
fn unloading_and_reversing_the_shear_closes_the_loop() {
    for (degree, substeps) in [(8, 1), (8, 4), (12, 1), (12, 4), (16, 1), (16, 4)] {
        let [first, closing, turned] = loop_error(degree, substeps);
        // The shear moves the ends of contact a little, which the first turn keeps (to one side: the
        // two unloadings are not quite each other's mirror image); from then on the loop is closed.
        assert!(first < 1e-3 && closing < 1e-8 && turned < 1e-5, "{first:.2e} {closing:.2e} {turned:.2e}");
    }
}

#[test]
fn shear_beyond_friction_has_no_balance() {
    let bodies = bodies(&[hertz(NORMAL).0], 1.3, 6, 2);
    let pair = bodies.pair().unwrap();
    let operator = ContactOperator::new(&pair, true).unwrap();
    let gap: Vec<f64> = operator.points().iter().map(gap).collect();
    let none = vec![0.0; gap.len()];
    let solution = operator.solve(&gap, &push(NORMAL, 1.01 * FRICTION * NORMAL, &none), None).unwrap();
    assert_eq!(solution.status, Status::NoBalance);
    let below = operator.solve(&gap, &push(NORMAL, 0.95 * FRICTION * NORMAL, &none), None).unwrap();
    assert_eq!(below.status, Status::Converged);
}

/// Loads, unloads and reverses at a coefficient of friction, the normal force going up and down with the shear.
fn most_steps(friction: f64, degree: usize) -> usize {
    let a = hertz(NORMAL).0;
    let bodies = bodies(&[0.22 * a, a], 1.3, degree, 4);
    let pair = bodies.pair().unwrap();
    let operator = ContactOperator::new(&pair, true).unwrap();
    let gap: Vec<f64> = operator.points().iter().map(gap).collect();
    let press = ContactLoad { friction: Friction::None, ..push(0.5 * NORMAL, 0.0, &[]) };
    let mut last = operator.solve(&gap, &press, None).unwrap();
    let mut most = 0;
    for (normal, shear) in [(0.5, 0.0), (1.0, 0.3), (1.0, 0.9), (0.9, -0.6), (0.4, -0.3), (1.2, 1.1), (1.2, -1.1), (0.1, 0.0)] {
        let mut load = push(normal * NORMAL, shear * friction * NORMAL, &last.slip);
        load.friction = Friction::Coulomb { coefficient: friction, slip_before: last.slip.clone() };
        last = operator.solve(&gap, &load, Some(&last)).unwrap();
        println!("mu {friction}, degree {degree}: {normal} {shear}: {} steps", last.iterations);
        assert_eq!(last.status, Status::Converged);
        assert!(last.complementarity < 1e-9 && last.balance < 1e-10);
        most = most.max(last.iterations);
    }
    most
}

#[test]
fn stick_and_slip_settle_within_twenty_steps_from_little_to_much_friction() {
    for (friction, degree) in [(0.01, 12), (0.3, 6), (0.3, 12), (2.0, 12)] {
        assert!(most_steps(friction, degree) <= 20);
    }
}

#[test]
fn opening_and_slip_are_differences_of_the_displacements() {
    let bodies = bodies(&[hertz(NORMAL).0], 1.3, 6, 2);
    let pair = bodies.pair().unwrap();
    let operator = ContactOperator::new(&pair, true).unwrap();
    let gap: Vec<f64> = operator.points().iter().map(gap).collect();
    let found = operator.solve(&gap, &push(NORMAL, 0.5 * FRICTION * NORMAL, &vec![0.0; gap.len()]), None).unwrap();
    let size = found.slip.iter().fold(0.0_f64, |most, slip| most.max(slip.abs()));
    for (i, point) in operator.points().iter().enumerate() {
        let [first, tangential] = pair.displacement(Side::Shaped, &found.shaped, point);
        let [second, along] = pair.displacement(Side::Counter, found.counter.as_ref().unwrap(), point);
        assert_abs_diff_eq!(gap[i] + first - second, found.opening[i], epsilon = 1e-9 * size);
        assert_abs_diff_eq!(tangential - along, found.slip[i], epsilon = 1e-9 * size);
    }
}
