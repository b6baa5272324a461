//! Caps on the pressure that are too low for the load.

use wearshape::Status;

use crate::common::{scene, solved};

/// 10 kN, 40 and -15 N m on 60 x 40 mm: by linear programming the lowest cap that carries them is 4.8896 MPa.
#[test]
fn a_cap_too_low_for_force_and_moments_is_infeasible_and_the_lowest_one_is_met() {
    let under = |cap: f64| solved(&scene("rectangular-punch", &["tasks=[pressure]", &format!("optimum.p_max={cap}")]));
    for cap in [2.0, 4.5, 4.88] {
        let solution = under(cap);
        assert_eq!(solution.status, Status::Refused, "{cap}: {:?}", solution.reason);
        assert!(solution.reason.as_ref().is_some_and(|why| why.contains("under p_max")), "{cap}: {:?}", solution.reason);
    }
    for cap in [4.8896, 4.9, 5.5] {
        let solution = under(cap);
        assert_eq!(solution.status, Status::Ok, "{cap}: {:?}", solution.reason);
    }
}
