//! Whether a hot shape lasts, proofs of hot shapes near their critical speed, and what is flat.

use std::ops::ControlFlow;

use wearshape::{Bodies, Options, Solution, SpeedFactor, Status, solve};

use crate::common::{read, scene, solved};

/// An annulus that takes all heat, held at its rims: its leading eigenvalues are complex, so that no speed is critical.
const ANNULUS: &str = r#"
units = "N-mm"
kinematics = "axisymmetric"
tasks = ["shape"]
accuracy = 1e-3
check = false
body1.material = { young = 1000, poisson = 0.25, conductivity = 0.8, expansion = 14e-6 }
body1.geometry.rectangle = { x = [30, 80], z = [12, 20] }
body1.heat = { left = { temperature = 20 }, right = { temperature = 20 } }
body2.material = { young = 1e5, poisson = 0.3, conductivity = 50, expansion = 1.1e-5 }
body2.geometry.rectangle = { x = [30, 80], z = [0, 12] }
body2.support = { bottom = ["z"] }
body2.heat = { left = { temperature = 20 }, right = { temperature = 20 } }
contact = { edges = ["bottom", "top"], friction = 0.3 }
sliding = { omega = 0.2 }
load = { edge = "top", as = "rigid", force = 4000 }
heat = { share = 1, counterface = "congruent" }
wear = { k = [1e-8, 0], counterface = "congruent" }
"#;

/// A steel block on a steel ring that touches without resistance: near its critical speed heat closes each point further than its pressure opens it.
const SHOE: &str = r#"
units = "N-mm"
kinematics = "plane-stress"
thickness = 10
tasks = ["shape"]
accuracy = 1e-3
body1.material = { young = "210 GPa", poisson = 0.3, conductivity = 50, expansion = 1.2e-5 }
body1.geometry.shoe-block = { radius = 200, half_angle = "30 deg", top = 300 }
body1.support = { left = ["x"], right = ["x"] }
body1.heat = { top = { temperature = 20 } }
body2.material = { young = "210 GPa", poisson = 0.3, conductivity = 50, expansion = 1.2e-5 }
body2.geometry.ring = { inner = 100, outer = 200 }
body2.support = { inner = ["x", "z"] }
body2.heat = { inner = { temperature = 20 } }
contact = { edges = ["inner", "outer"], friction = 0.25, gap = 0 }
sliding = { omega = 2 }
load = { edge = "top", as = "pressure", force = "10 kN" }
wear = { beta = [2e-4, 0], a = 1, b = 0.5 }
heat = { conductance = "inf" }
"#;

/// Two equal blocks between walls, under a pressure that presses them alike everywhere.
const BLOCKS: &str = r#"
units = "N-mm"
kinematics = "plane-strain"
thickness = 10
tasks = ["shape"]
accuracy = 1e-3
body1.material = { young = 1000, poisson = 0.3, conductivity = 0.5, expansion = 1e-5 }
body1.geometry.rectangle = { x = [-20, 20], z = [0, 10] }
body1.support = { left = ["x"], right = ["x"] }
body1.heat = { top = { temperature = 20 } }
body2.material = { young = 1e5, poisson = 0.3, conductivity = 50, expansion = 1e-5 }
body2.geometry.rectangle = { x = [-20, 20], z = [-10, 0] }
body2.support = { left = ["x"], right = ["x"], bottom = ["z"] }
body2.heat = { bottom = { temperature = 20 } }
contact = { edges = ["bottom", "top"], friction = 0.3, shear = false }
sliding = { speed = 5 }
load = { edge = "top", as = "rigid", force = 400 }
wear = { beta = [2e-4, 0], counterface = "congruent" }
heat = { conductance = 1 }
"#;

fn is_told_not_to_last(solution: &Solution) -> bool {
    solution.remarks.iter().any(|remark| remark.code == "thermoelastic-instability")
}

#[test]
fn a_shape_that_does_not_last_is_told_where_a_run_in_time_from_it_becomes_unstable() {
    // Runs in time from these shapes wear in at 0.24 rad/s and end unstable at 0.25.
    for (omega, lasts) in [(0.24, true), (0.25, false), (1.0, false)] {
        let solution = solved(&read(ANNULUS, &[&format!("sliding.omega={omega}")]));
        assert_eq!(solution.heat.as_ref().unwrap().critical_speed_factor, Some(SpeedFactor::None));
        assert_eq!(is_told_not_to_last(&solution), !lasts, "{omega}: {:?}", solution.heat.unwrap().growth);
    }
    // Of another pressure nobody says that it would last.
    let wanted = solved(&read(ANNULUS, &["sliding.omega=1", "optimum.functional=uniform"]));
    assert!(!is_told_not_to_last(&wanted));
}

#[test]
fn a_hot_shape_is_proven_up_to_its_critical_speed() {
    for omega in [1.0, 2.0, 2.8] {
        let solution = solved(&read(SHOE, &[&format!("sliding.omega={omega}")]));
        let shape = solution.shape.as_ref().unwrap();
        let misses = [shape.roundtrip_same, shape.roundtrip_independent].map(Option::unwrap);
        assert!(misses[0] < 1e-9 && misses[1] < 1e-3, "{omega}: {misses:?}");
        let Some(SpeedFactor::At(critical)) = solution.heat.as_ref().unwrap().critical_speed_factor else { panic!("none") };
        assert!((critical * omega / 2.8106 - 1.0).abs() < 1e-3, "{omega}: {critical}");
    }
}

#[test]
fn a_shape_that_is_flat_is_done_with_nothing_to_take_off() {
    for settings in [&[][..], &["mesh.degree=6"][..]] {
        let solution = solved(&read(BLOCKS, settings));
        assert!(
            solution.shape.as_ref().unwrap().flat && solution.error.as_ref().unwrap().gap_relative.unwrap() < 1e-12,
            "{:?}",
            solution.error
        );
    }
    let bent = solved(&read(BLOCKS, &["body1.support={ left=[\"x\"] }"]));
    assert!(bent.status == Status::Ok && !bent.shape.unwrap().flat);
}

#[test]
fn a_plate_that_arrives_fresh_without_resistance_takes_all_that_friction_changes() {
    let fresh = ["heat.conductance=inf", "wear.counterface=fresh", "body2.heat.bottom.temperature=40", "check=false"];
    let heat = solved(&read(BLOCKS, &fresh)).heat.unwrap();
    let factors = [heat.staggered_limit_speed_factor, heat.separation_speed_factor, heat.critical_speed_factor];
    assert_eq!(factors, [Some(SpeedFactor::None); 3]);
}

#[test]
fn a_body_that_its_contact_alone_cools_and_one_held_at_two_temperatures_are_refused_by_what_is_wrong() {
    for (heat, words) in [
        ("body1.heat={ bottom={ convection=0.05, ambient=20 } }", "nothing cools body1 outside of the contact"),
        ("body1.heat.left.temperature=90", "are held at 90 and at 20 degC"),
    ] {
        let problem = read(BLOCKS, &["mesh.degree=4", heat]);
        let fault = solve(&problem, &Options::default(), &Bodies::default(), &mut |_| ControlFlow::Continue(())).unwrap_err();
        assert!(fault.message.contains(words) && fault.key.as_deref() == Some("body1.heat"), "{fault:?}");
    }
}

#[test]
fn a_setting_of_what_cools_an_edge_replaces_what_cooled_it() {
    // The edge has convection.
    for setting in ["body2.heat.bottom.temperature=30", "body2.heat.bottom.flux=1"] {
        scene("clutch-hot", &[setting]);
    }
}

#[test]
fn an_expansion_without_its_power_of_ten_is_noted() {
    let noted = |alpha: &str| {
        let problem = read(BLOCKS, &[&format!("body1.material.expansion={alpha}")]);
        problem.remarks().iter().any(|remark| remark.code == "expansion-implausible")
    };
    assert!(noted("12") && noted("12e-3") && !noted("2e-4"));
}
