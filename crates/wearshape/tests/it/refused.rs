//! What has no answer is a solution that says so.

use wearshape::Status;

use crate::common::{scene, solved};

#[test]
fn a_load_without_an_answer_is_a_solution_with_a_reason() {
    for (name, settings, why) in [
        // 40 mm beside the middle of a punch of half-width 30 mm.
        ("translating-punch", &["load.moment=40 kN mm", "tasks=[pressure]"][..], "moment"),
        ("translating-punch", &["load.moment=40 kN mm", "mesh.degree=4"], "moment"),
        ("translating-punch", &["load.moment=40 kN mm", "mesh.degree=4", "tasks=[contact]"], "no balance"),
        ("translating-punch", &["load.approach=1e-3", "load.tilt=1e-3", "mesh.degree=4"], "no force goes with"),
        ("translating-punch", &["load.moment=40 kN mm", "mesh.degree=4", "tasks=[wear]"], "no balance"),
        (
            "translating-punch",
            &["wear.beta=1e-100", "wear.b=600", "mesh.degree=4", "tasks=[wear]"],
            "nothing wears in a finite time",
        ),
        ("annular-punch", &["optimum.p_max=1", "tasks=[pressure]"], "under p_max"),
    ] {
        let solution = solved(&scene(name, settings));
        let reason = solution.reason.clone().unwrap_or_default();
        println!("{name} {settings:?}: {reason}");
        assert_eq!(solution.status, Status::Refused, "{settings:?}");
        assert!(!reason.is_empty() && reason.contains(why), "{settings:?}: {reason}");
        assert!(solution.shape.is_none() && solution.wear.is_none(), "{settings:?}");
    }
}
