//! Compliances of loads that are half solved.

use crate::common::*;
use faer::Mat;
use hpfem::*;

/// By half of the work of solving for unit loads, what they do to each other: held, free, with unknowns left out, and in another order.
#[test]
fn a_compliance_is_what_solving_for_its_loads_gives() {
    let mesh = patch(TURNS[3], Shape::Arcs, 0.0);
    for supports in [vec![], vec![support("left", Direction::First), support("bottom", Direction::Second)]] {
        let body = Body::new(problem(&mesh, 7, PLANE_STRAIN, &steel(), &supports, &[], Some("top"))).unwrap();
        let i = &body.interface;
        let n = i.stiffness.nrows();
        // Loads of a few unknowns each, some at the same ones; the last one on a single unknown that is left out below.
        let mut loads: Vec<Vec<(usize, f64)>> =
            (0..7).map(|j| (0..4).map(|k| ((5 * j + 3 * k) % n, (j + k) as f64 - 2.3)).collect()).collect();
        loads.push(vec![(n / 2, 2.0)]);
        let right = Mat::from_fn(n, loads.len(), |k, j| loads[j].iter().filter(|(u, _)| *u == k).map(|(_, f)| f).sum::<f64>());
        for order in [(0..n).collect::<Vec<usize>>(), (0..n).rev().collect(), (0..n).filter(|k| *k != n / 2).collect()] {
            let factor = i.factor(&i.rigid_modes, order);
            let solved = right.transpose() * factor.solve(&right);
            let half = factor.half_solved(&loads.iter().map(Vec::as_slice).collect::<Vec<_>>());
            let mut compliance = Mat::zeros(loads.len(), loads.len());
            half.add(&mut compliance);
            assert!((&compliance - &solved).norm_max() < 1e-13 * solved.norm_max(), "{:e}", (&compliance - &solved).norm_max());
            assert_eq!(compliance, compliance.transpose().to_owned());
        }
    }
}
