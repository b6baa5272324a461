//! Without friction nothing wears by `wear.beta`: what else is asked for is done.

use wearshape::{Status, Step};

use crate::common::{scene, solved};

#[test]
fn tasks_beside_the_wear_are_done_without_friction() {
    for tasks in ["[pressure,wear]", "[shape,wear]", "[contact,wear]"] {
        let problem = scene("punch-wear", &["contact.friction=0", "accuracy=1e-2", &format!("tasks={tasks}")]);
        assert!(!problem.plan().runs(Step::Evolution));
        let solution = solved(&problem);
        assert_eq!(solution.status, Status::Ok, "{tasks}: {:?}", solution.reason);
        assert!(solution.wear.is_none() && solution.profile.is_some());
        assert!(problem.remarks().iter().any(|remark| remark.code == "no-wear"), "{:?}", problem.remarks());
    }
}

/// What was left out for want of a pressure is not told to have been done.
#[test]
fn a_pressure_that_is_none_leaves_out_the_stages_after_it() {
    let problem = scene("translating-punch", &["load.moment=31000"]);
    let solution = solved(&problem);
    assert!(solution.status == Status::Refused && solution.without_pressure);
    let ran = |name: Step| problem.plan().without_pressure().iter().any(|stage| stage.name == name && stage.ran);
    assert!(problem.plan().runs(Step::Shape) && !ran(Step::Shape) && !ran(Step::Mesh) && !ran(Step::Table));
    assert!(ran(Step::Pressure) && ran(Step::Plots));
}
