//! The depth told is the largest of the profile, not that of the deepest contact point.

use crate::common::{scene, solved};

/// Worn for a time; a lining is deepest somewhere between its points, which fall elsewhere on every degree: 1.5e-5 short at the points of degree 8.
#[test]
fn the_depth_of_a_lining_is_not_that_of_a_point() {
    for (name, until) in [("drum-brake-block", "wear.until=2"), ("reciprocating-pad", "wear.until=1e5")] {
        let [coarse, fine] = ["mesh.degree=8", "mesh.degree=11"].map(|degree| {
            let solution = solved(&scene(name, &["tasks=[\"wear\"]", until, degree]));
            solution.wear.unwrap().depth.unwrap()
        });
        assert!((coarse / fine - 1.0).abs() < 1e-6, "{name}: {coarse} {fine}");
    }
}
