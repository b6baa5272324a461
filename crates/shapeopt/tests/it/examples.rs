//! The examples of the crate with their numbers pinned.

#[path = "../../examples/own_gap_iteration.rs"]
#[allow(dead_code)]
mod own_gap_iteration;

use approx::assert_relative_eq;

#[test]
fn a_gap_iteration_of_ones_own_arrives_at_the_direct_shape() {
    let found = own_gap_iteration::iterated(8, 1e-9).unwrap();
    assert!(found.solves < 250 && found.deviation < 1e-9, "{} solves, {:e}", found.solves, found.deviation);
    assert_relative_eq!(found.crown, 3.85911161e-4, max_relative = 1e-8);
    assert!(found.from_shape < 1e-8, "{:e}", found.from_shape);
}
