//! Caps on the pressure that are too low for the load.

use wearshape::{Solution, Status};

use crate::common::{scene, solved};

fn is_refused(solution: &Solution) -> bool {
    let reason = solution.reason.as_deref().unwrap_or_default();
    solution.status == Status::Refused && reason.ends_with("the load is larger than the surface carries under p_max")
}

/// 10 kN, 40 and -15 N m on 60 x 40 mm: the lowest cap that carries them is 4.88956 MPa, F over the least int max(lambda . psi, 0) dS with lambda . F = F on
/// 800 x 800 points.
#[test]
fn a_cap_too_low_for_force_and_moments_has_no_answer_and_the_lowest_one_has() {
    let under = |cap: f64| solved(&scene("rectangular-punch", &["tasks=[pressure]", &format!("optimum.p_max={cap}")]));
    for cap in [2.0, 4.5, 4.889] {
        let solution = under(cap);
        assert!(is_refused(&solution), "{cap}: {:?}", solution.reason);
    }
    for cap in [4.8896, 5.5] {
        let solution = under(cap);
        assert_eq!(solution.status, Status::Ok, "{cap}: {:?}", solution.reason);
    }
}

/// A force F at the distance e from the middle of a surface of length 2 a and width t is carried by no less than F / (2 t (a - e)) on the part that has it in its middle.
#[test]
fn a_strip_carries_its_load_under_no_less_than_that_of_the_part_around_it() {
    for (moment, exponent) in [(3000.0_f64, 1.0), (-12_000.0, 2.0), (0.0, 1.0), (25_000.0, 0.5)] {
        let lowest = 1000.0 / (2.0 * 10.0 * (30.0 - moment.abs() * 1e-3));
        let under = |share: f64| {
            let settings =
                [&format!("load.moment={moment}"), &format!("wear.b={exponent}"), &format!("optimum.p_max={}", share * lowest)];
            let all =
                [&["tasks=[pressure]", "contact.friction=0", "optimum.functional=steady"], &settings.map(String::as_str)[..]]
                    .concat();
            solved(&scene("translating-punch", &all))
        };
        for share in [0.3, 0.9, 0.9998] {
            let solution = under(share);
            assert!(is_refused(&solution), "{moment} {share}: {:?}", solution.reason);
        }
        for share in [1.01, 1.1, 2.0] {
            let solution = under(share);
            assert_eq!(solution.status, Status::Ok, "{moment} {share}: {:?}", solution.reason);
        }
    }
}
