//! Estimates against true errors, and the adaptive driver built on them.

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
    assert_eq!(energy_estimate([(10, 1.0), (20, 2.0), (30, 2.0)]).unwrap().error, 0.0);
}

#[test]
fn the_adaptive_driver_reaches_its_accuracy_on_the_l_shape_and_the_estimate_is_within_a_factor_ten() {
    let mesh = l_shape();
    let materials = [Material::isotropic(1.0, 0.3).unwrap()];
    let singular = singular_vertices(&mesh, PLANE_STRAIN, &materials, &[], &[]).unwrap();
    let reference = energy(&mesh.refined_towards(&[0], 0.15, 20).unwrap(), vec![16; 3 + 20 * 6]).0;
    for accuracy in [1e-3, 1e-5, 1e-7] {
        let run = adapt(&mesh, &singular, accuracy, 20, |m, d| Ok(vec![energy(m, d.to_vec()).0])).unwrap();
        assert_eq!(run.status, AdaptStatus::Reached);
        let truth = (run.quantities.last().unwrap()[0] / reference - 1.0).abs();
        let effectivity = run.estimate / truth;
        assert!(
            truth < accuracy && (0.5..10.0).contains(&effectivity),
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
