//! Elastic cylinder on an elastic block, NAFEMS R94 CB1 (plane strain, thickness 1 mm): E 210 and 70 GPa, nu 0.3, R 50 mm, 35 kN.

use crate::common::cylinder::{Sizes, block, round};
use crate::common::{material, touching};
use approx::{assert_abs_diff_eq, assert_relative_eq};
use contact::*;
use hpfem::{Body, Direction, EdgeTraction, Kinematics, Mesh};

const SIZES: Sizes = Sizes { radius: 50.0, width: 100.0, depth: 200.0 };

/// Both bodies as interface operators with a node at `end`, under `force` on the whole cylinder.
pub(crate) fn bodies(end: f64, candidate: f64, degree: usize, layers: usize, force: f64) -> Rebuilt {
    let kinematics = Kinematics::PlaneStrain { thickness: 1.0 };
    let pressure = force / (2.0 * SIZES.radius);
    let held =
        |mesh: Mesh, young| touching(mesh, [degree, layers], kinematics, material(young, 0.3)).hold("axis", Direction::First);
    let load = EdgeTraction::new("top", move |_| [0.0, -pressure]);
    let upper = held(round(&SIZES, &[end], candidate, layers), 210e3).load("force", load);
    let lower = held(block(&SIZES, &[end], candidate, layers), 70e3).clamp("bottom");
    let reduced = |problem| Body::new(problem).unwrap().interface;
    Rebuilt { shaped: reduced(upper), counter: reduced(lower), facing: true }
}

pub(crate) fn gap(point: &ContactPoint) -> f64 {
    let x = point.position[0];
    x * x / (SIZES.radius + (SIZES.radius.powi(2) - x * x).sqrt())
}

pub(crate) fn hertz(force: f64) -> (f64, f64) {
    let modulus = 1.0 / (0.91 / 210e3 + 0.91 / 70e3);
    let end = (4.0 * force * SIZES.radius / (std::f64::consts::PI * modulus)).sqrt();
    (end, 2.0 * force / (std::f64::consts::PI * end))
}

/// End of contact and highest pressure, with a node on the end.
pub(crate) fn positioned(degree: usize, layers: usize, force: f64) -> (Positioned, f64) {
    let problem = Positioning { gap: &gap, load: &|_| ContactLoad::factors(&[1.0], &[]), starts_closed: true, tolerance: 1e-10 };
    let trial = hertz(force).0 * 1.05;
    let result = position_ends::<Error>(&problem, &[trial], |ends| Ok(bodies(ends[0], 1.6, degree, layers, force))).unwrap();
    let highest = result.solution.pressure[0];
    (result, highest)
}

#[test]
fn cylinder_has_the_reference_end_of_contact_and_pressure() {
    let (result, highest) = positioned(14, 7, 35e3);
    println!("a {:.8} p0 {highest:.6} bodies made {}", result.ends[0], result.factorisations);
    assert!(result.found);
    assert_abs_diff_eq!(result.ends[0], 6.20119, epsilon = 1e-5);
    assert_relative_eq!(highest, 3586.190, max_relative = 1e-6);
    assert!(result.factorisations <= 10);
}

#[test]
fn deviation_from_the_half_plane_falls_like_the_square_of_the_contact_length() {
    let deviation = |force: f64| {
        let (result, highest) = positioned(16, 8, force);
        let (a, p) = hertz(force);
        println!("{force} N: a {:.4e}, p0 {:.4e}", result.ends[0] / a - 1.0, highest / p - 1.0);
        (result.ends[0] / a - 1.0, highest / p - 1.0)
    };
    let (large, small) = (deviation(35e3), deviation(350.0));
    assert_abs_diff_eq!(small.0, -2.145e-5, epsilon = 1e-7);
    assert_abs_diff_eq!(small.1, 2.14e-6, epsilon = 1e-7);
    assert_relative_eq!(large.0 / small.0, 100.0, max_relative = 0.02);
}

#[test]
fn signorini_on_a_fixed_mesh_agrees_with_pivoting_within_thirty_steps() {
    for (end, candidate, degree) in [(5.0, 2.5, 8), (7.0, 1.3, 12), (2.0, 12.0, 8), (12.0, 2.0, 16)] {
        let bodies = bodies(end, candidate, degree, 0, 35e3);
        let pair = bodies.pair().unwrap();
        let operator = ContactOperator::new(&pair, false).unwrap();
        let gap: Vec<f64> = operator.points().iter().map(gap).collect();
        let load = ContactLoad::factors(&[1.0], &[]);
        let solution = operator.solve(&gap, &load, None).unwrap();
        let second = operator.solve_by_pivoting(&gap, &load).unwrap();
        let zone = solution.zones[0];
        println!(
            "{end} {degree}: {} in {} steps, pivoting {}, end {:.4}, {:.1e}",
            solution.status, solution.iterations, second.iterations, zone[1], solution.complementarity
        );
        assert_eq!(solution.status, Status::Converged);
        assert!(!solution.took_over && solution.iterations <= 30);
        assert!(solution.complementarity < 1e-10 && solution.balance < 1e-10);
        for (p, q) in solution.pressure.iter().zip(&second.pressure) {
            assert_abs_diff_eq!(p, q, epsilon = 1e-8 * 3586.0);
        }
        assert_relative_eq!(zone[1], 6.2, max_relative = 0.05);
        let warm = operator.solve(&gap, &load, Some(&solution)).unwrap();
        assert!(warm.iterations <= 2, "{}", warm.iterations);
    }
}

/// Relative L2 error of the pressure on the contact against the positioned solution's own Hertz profile, at the points.
fn pressure_error(operator: &ContactOperator<'_>, pressure: &[f64], reference: impl Fn(f64) -> f64) -> f64 {
    let mut sums = [0.0; 2];
    for (point, p) in operator.points().iter().zip(pressure) {
        let exact = reference(point.position[0]);
        sums[0] += point.weight * (p - exact).powi(2);
        sums[1] += point.weight * exact * exact;
    }
    (sums[0] / sums[1]).sqrt()
}

/// Total variation of the pressure error on the inner part of the contact.
fn variation(operator: &ContactOperator<'_>, pressure: &[f64], reference: impl Fn(f64) -> f64, inner: f64) -> f64 {
    let error: Vec<f64> = operator
        .points()
        .iter()
        .zip(pressure)
        .filter(|(point, _)| point.position[0] < inner)
        .map(|(point, p)| p - reference(point.position[0]))
        .collect();
    error.windows(2).map(|w| (w[1] - w[0]).abs()).sum()
}

#[test]
fn a_node_on_the_end_of_contact_doubles_the_rate_and_layers_beat_any_power() {
    // At 350 N the half-plane profile holds to 2e-5.
    let force = 350.0;
    let load = ContactLoad::factors(&[1.0], &[]);
    let degrees = [4, 6, 8, 12, 16];
    let mut curves = [Vec::new(), Vec::new(), Vec::new()];
    let mut variations = Vec::new();
    for degree in degrees {
        let fine = positioned(14, 7, force).0;
        let (a, p0) = (fine.ends[0], fine.solution.pressure[0]);
        let profile = |x: f64| p0 * (1.0 - (x / a).powi(2)).max(0.0).sqrt();
        for (curve, (end, layers)) in curves.iter_mut().zip([(0.8 * a, 0), (a, 0), (a, degree / 2)]) {
            let bodies = bodies(end, 1.6, degree, layers, force);
            let pair = bodies.pair().unwrap();
            let operator = ContactOperator::new(&pair, false).unwrap();
            let gap: Vec<f64> = operator.points().iter().map(gap).collect();
            let solution = operator.solve(&gap, &load, None).unwrap();
            assert_eq!(solution.status, Status::Converged);
            assert!(solution.iterations <= 30);
            curve.push(pressure_error(&operator, &solution.pressure, profile));
            if layers > 0 {
                variations.push(variation(&operator, &solution.pressure, profile, 0.8 * a) / p0);
            }
        }
    }
    let names = ["fixed mesh", "node on the end", "travelling layers"];
    for (name, curve) in names.iter().zip(&curves) {
        let rate = (curve[1] / curve[4]).ln() / (16.0_f64 / 6.0).ln();
        println!("{name}: {:?}", curve.iter().map(|e| format!("{e:.1e}")).collect::<Vec<_>>());
        println!("    rate {rate:.2}");
    }
    println!("total variation of the error: {:?}", variations.iter().map(|e| format!("{e:.1e}")).collect::<Vec<_>>());
    assert!(curves[2][4] < 0.1 * curves[1][4] && curves[1][4] < 0.5 * curves[0][4]);
    assert!(variations[4] < 0.1 * variations[0]);
}
