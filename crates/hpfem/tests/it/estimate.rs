//! Estimates against true errors, and the adaptive driver built on them.

use crate::classics::rectangle;
use crate::common::*;
use crate::lshape::{ENERGY, energy, l_shape};
use hpfem::*;

#[test]
fn energy_extrapolation_estimates_the_error_of_the_l_shape_on_a_fixed_mesh() {
    let mesh = l_shape();
    let solutions: Vec<(usize, f64)> = (2..=14)
        .map(|p| {
            let (u, n) = energy(&mesh, vec![p; 3]);
            (n, u)
        })
        .collect();
    for w in solutions.windows(3) {
        let estimate = energy_estimate([w[0], w[1], w[2]]).unwrap();
        let truth = (1.0 - w[2].1 / ENERGY).sqrt();
        let effectivity = estimate.error / truth;
        assert!((0.7..1.5).contains(&effectivity), "{} unknowns: effectivity {effectivity:.2}", w[2].0);
    }
}

#[test]
fn energy_extrapolation_is_exact_for_a_power_law_and_refuses_what_does_not_converge() {
    let u = |n: f64| 3.0 - 2.0 * n.powf(-1.1);
    let [a, b, c] = [100, 200, 370].map(|n| (n, u(n as f64)));
    let estimate = energy_estimate([a, b, c]).unwrap();
    assert!((estimate.energy - 3.0).abs() < 1e-9, "{}", estimate.energy);
    assert!(energy_estimate([a, c, b]).is_none());
    assert!(energy_estimate([(10, 1.0), (20, 2.0), (30, 3.5)]).is_none());
    // A degree that changes nothing tells nothing; several tell that there is no more to come. Energies that grow like a logarithm have no limit.
    assert!(energy_estimate([(10, 1.0), (20, 2.0), (30, 2.0)]).is_none());
    assert_eq!(energy_estimate([(10, 2.0), (20, 2.0), (30, 2.0)]).unwrap().error, 0.0);
    assert!(energy_estimate([(100, 1.0), (200, 2.0), (400, 3.0)]).is_none());
}

#[test]
fn levels_that_change_nothing_are_left_out_of_an_estimate() {
    let at = |values: &[f64]| sequence_estimate(&values.iter().map(|value| vec![*value]).collect::<Vec<_>>()).unwrap();
    assert_eq!(at(&[1.0, 1.1, 1.12, 1.12]), at(&[1.0, 1.1, 1.12]));
    assert_eq!(at(&[1.0, 1.0, 1.1, 1.1, 1.12, 1.12]), at(&[1.0, 1.1, 1.12]));
    assert_eq!([at(&[1.0, 1.1, 1.12, 1.12, 1.12]), at(&[3.0; 3]), at(&[0.0; 3])], [0.0; 3]);
}

/// A uniform source in one cell whose boundary is held: every second degree changes nothing.
#[test]
fn the_adaptive_driver_is_not_taken_in_by_degrees_that_change_nothing() {
    let mesh = rectangle([0.0, 3.0], [0.0, 1.0]);
    let energy = |mesh: &Mesh, degrees: &[usize]| -> Result<Vec<f64>, Error> {
        let problem = BodyProblem::new(mesh.clone(), 1, Kinematics::Potential { thickness: 1.0 }).degrees(degrees.to_vec());
        let held = ["left", "right", "bottom", "top"].into_iter().fold(problem, |problem, edge| problem.clamp(edge));
        let body = Body::new(held.material(Material::conductor(1.0)?).load("source", BodyForce::new(|_| [2.0, 0.0])))?;
        Ok(vec![body.interface.strain_energy(&body.solve(&[("source", 1.0)])?)])
    };
    // Saint-Venant's series of the torsion of a rectangle.
    let odd = |k: usize| (2 * k + 1) as f64;
    let rest: f64 = (0..50).map(|k| (odd(k) * std::f64::consts::FRAC_PI_2 * 3.0).tanh() / odd(k).powi(5)).sum();
    // The integral of the field is J / 2, and the energy half of that times the source 2.
    let exact = 0.5 * 3.0 * (1.0 - 192.0 / std::f64::consts::PI.powi(5) / 3.0 * rest) / 3.0;
    for accuracy in [1e-4, 1e-6, 1e-9] {
        let run = adapt(&mesh, &[], accuracy, 20, energy).unwrap();
        let truth = (run.quantities.last().unwrap()[0] / exact - 1.0).abs();
        println!("asked {accuracy:e}, told {:e}, true {truth:e}, degree {}", run.estimate, run.quantities.len() + 1);
        // The corners are singular, though weakly: errors fall like a power of the degree.
        assert!((0.5..3.0).contains(&(run.estimate / truth)), "{truth:e} {:e}", run.estimate);
    }
}

#[test]
fn layers_end_where_the_digits_of_a_vertex_do() {
    let mesh = rectangle([1000.0, 1001.0], [1000.0, 1001.0]);
    let corner = mesh.nearest_vertex([1000.0, 1000.0]);
    for exponent in [0.2, 0.5, 1.0] {
        let (fine, degrees) = graded_level(&mesh, &[SingularVertex { vertex: corner, exponent }], 20).unwrap();
        assert_eq!(degrees.len(), fine.cells.len());
    }
    for exponent in [0.0, -0.5, 1.5, f64::NAN] {
        let level = graded_level(&mesh, &[SingularVertex { vertex: corner, exponent }], 4);
        assert!(matches!(level, Err(Error::OutOfRange { .. })), "{exponent}");
    }
    assert!(matches!(
        graded_level(&mesh, &[SingularVertex { vertex: 9, exponent: 0.5 }], 4),
        Err(Error::Beyond { index: 9, .. })
    ));
}

#[test]
fn the_adaptive_driver_reaches_its_accuracy_on_the_l_shape_and_the_estimate_is_within_a_factor_twelve() {
    let mesh = l_shape();
    let materials = [Material::isotropic(1.0, 0.3).unwrap()];
    let singular = singular_vertices(&mesh, PLANE_STRAIN, &materials, &[], &[]).unwrap();
    let reference = energy(&mesh.refined_towards(&[0], 0.15, 20).unwrap(), vec![16; 3 + 20 * 6]).0;
    for accuracy in [1e-3, 1e-5, 1e-7] {
        let run = adapt(&mesh, &singular, accuracy, 20, |m, d| Ok(vec![energy(m, d.to_vec()).0])).unwrap();
        assert_eq!(run.status, AdaptStatus::Reached);
        let truth = (run.quantities.last().unwrap()[0] / reference - 1.0).abs();
        let effectivity = run.estimate / truth;
        // Three levels know one ratio alone: 11.7 times; more of them less than twice.
        assert!(
            truth < accuracy && (0.5..12.0).contains(&effectivity),
            "{accuracy:.0e}: {truth:.1e}, effectivity {effectivity:.2}"
        );
    }
}

#[test]
fn the_adaptive_driver_stops_at_the_degree_limit_and_says_so() {
    let run = adapt(&l_shape(), &[], 1e-9, 5, |m, d| Ok(vec![energy(m, d.to_vec()).0])).unwrap();
    assert_eq!(run.status, AdaptStatus::DegreeLimit);
    assert!(run.status.sentence().contains("highest"));
    assert!(run.estimate > 1e-9 && run.degrees.iter().all(|d| *d == 5));
    assert!(adapt(&l_shape(), &[], 0.0, 5, |_, _| Ok(vec![])).is_err());
}

/// Displacements and stresses cross their limits on their way: a small difference is chance. An L-shape, held at its foot and drawn at its arm.
///
/// ```text
///   +---+---+
///   |       | ->
///   +---0---+
///   |   |         held below
///   +---+
/// ```
#[test]
fn estimates_at_points_of_an_l_shape_are_seldom_too_small_and_never_by_far() {
    let vertices = vec![[-1.0, -1.0], [0.0, -1.0], [-1.0, 0.0], [0.0, 0.0], [1.0, 0.0], [-1.0, 1.0], [0.0, 1.0], [1.0, 1.0]];
    let quads = [[0, 1, 3, 2], [2, 3, 6, 5], [3, 4, 7, 6]].map(|corners| Quad { corners, material: 0, layer: 0 });
    let mesh = Mesh::new(vertices, &quads, &[], &[([0, 1], "foot"), ([4, 7], "arm")]).unwrap();
    let steel = Material::isotropic(1.0, 0.3).unwrap();
    let supports = [Direction::First, Direction::Second].map(|direction| Support::hold("foot", direction));
    let singular = singular_vertices(&mesh, PLANE_STRAIN, &[steel], &supports, &["arm"]).unwrap();
    let places: Vec<[f64; 2]> = (0..81).map(|i| [-0.93 + 0.23 * f64::from(i / 9), -0.91 + 0.226 * f64::from(i % 9)]).collect();
    // Not beside the free face, where a stress vanishes and its relative error means nothing.
    let places: Vec<[f64; 2]> = places.into_iter().filter(|x| x[0] < -0.02 || x[1] > 0.02).collect();
    // Displacements and stresses at each place, by levels.
    let levels: Vec<Vec<Vec<f64>>> = (2..=16)
        .map(|p| {
            let (fine, degrees) = graded_level(&mesh, &singular, p).unwrap();
            let problem = BodyProblem::new(fine, 1, PLANE_STRAIN).degrees(degrees).material(steel).clamp("foot");
            let body = Body::new(problem.load("drawn", EdgeTraction::new("arm", |_| [0.3, 1.0]))).unwrap();
            let field = body.field(&body.solve(&[("drawn", 1.0)]).unwrap()).unwrap();
            let state = |x: &[f64; 2]| field.locate(*x).and_then(|(cell, xi, eta)| field.at(cell, xi, eta)).unwrap();
            places.iter().map(state).map(|s| vec![s.displacement[0], s.displacement[1], s.stress[0], s.stress[1]]).collect()
        })
        .collect();
    let truth = levels.last().unwrap();
    let (mut small, mut told, mut worst) = (0, 0, 0.0_f64);
    for (place, quantity, count) in (0..places.len() * 4 * 8).map(|i| (i / 32, i / 8 % 4, 3 + i % 8)) {
        let sequence: Vec<Vec<f64>> = levels[..count].iter().map(|level| vec![level[place][quantity]]).collect();
        let error = (sequence[count - 1][0] / truth[place][quantity] - 1.0).abs();
        let ratio = error / sequence_estimate(&sequence).unwrap();
        (small, told, worst) = (small + usize::from(ratio > 1.0), told + 1, worst.max(ratio));
    }
    assert!(20 * small < told && worst < 12.0, "{small} of {told}, {worst:.1} times");
}
