//! The depth told is the largest of the profile, not that of the deepest contact point.

use wearshape::{Rung, Status};

use crate::common::{goes_on, read, scene, solved};

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

/// A housing worn as deep as its shaft is pressed into it: steps that are as coarse as elsewhere set the levels apart by more than the accuracy.
#[test]
fn a_journal_worn_little_is_as_accurate_as_asked_for() {
    let of = |accuracy: &str| solved(&scene("journal", &["tasks=[\"wear\"]", "wear.until={depth=2e-3}", accuracy]));
    let [rough, fine] = ["accuracy=1e-4", "accuracy=1e-5"].map(of);
    assert_eq!(rough.status, Status::Ok, "{:?}", rough.reason);
    let [time, true_time] = [&rough, &fine].map(|solution| solution.wear.as_ref().unwrap().time.unwrap());
    let error = (time / true_time - 1.0).abs();
    assert!(error < rough.error.unwrap().gap_relative.unwrap(), "{error:.1e}");
}

/// Stopped on the first level, on the second with its finer steps, and on the third.
#[test]
fn a_run_with_finer_steps_goes_on_from_where_it_was_stopped() {
    let problem = scene("journal", &["tasks=[\"wear\"]", "wear.until={depth=5e-3}"]);
    goes_on(&problem, &[10, 60, 120]);
}

/// A roller whose contact grows to more than four times its length: the cells under it have to know of the first one, or its stresses do not fade within them.
#[test]
fn a_roller_worn_far_is_as_accurate_as_asked_for() {
    // Its contact grows to 4, 5.5 and 13 times its first length.
    for until in ["wear.until=0.5", "wear.until=1", "wear.until=14"] {
        let of = |accuracy: &str| {
            let worn = ["wear.k=1e-7", "contact.friction=0.1", "sliding.omega=40", until, "tasks=[\"wear\"]", accuracy];
            solved(&scene("cam", &worn))
        };
        let [rough, fine] = ["accuracy=1e-4", "accuracy=1e-5"].map(of);
        assert_eq!(rough.status, Status::Ok, "{until}: {:?}", rough.reason);
        let [depth, true_depth] = [&rough, &fine].map(|solution| solution.wear.as_ref().unwrap().depth.unwrap());
        let error = (depth / true_depth - 1.0).abs();
        assert!(error < 1e-4, "{until}: {error:.1e}");
    }
}

/// The worn depth has a kink where the contact ends, and a node is there: a thousandth beside it levels were apart by the accuracy and more on any degree.
#[test]
fn a_contact_that_grows_ends_at_a_node() {
    let cam = ["wear.k=1e-7", "contact.friction=0.1", "sliding.omega=40", "wear.until=1", "tasks=[\"wear\"]", "accuracy=1e-3"];
    let journal = ["tasks=[\"wear\"]", "wear.until={depth=1e-3}"];
    let bushing = ["tasks=[\"wear\"]", "wear.until={depth=5e-2}"];
    for (name, settings) in [("cam", &cam[..]), ("journal", &journal[..]), ("bushing", &bushing[..])] {
        let solution = solved(&scene(name, settings));
        assert_eq!(solution.status, Status::Ok, "{name}: {:?}", solution.reason);
        let accuracy = if settings.contains(&"accuracy=1e-3") { 1e-3 } else { 1e-4 };
        let apart = |rung: &Rung| rung.degree <= 12 && rung.change.is_some_and(|change| change < accuracy);
        assert!(solution.ladder.iter().any(apart), "{name}: {:?}", solution.ladder);
    }
}

/// Points that have just come into contact press as the last step wears them: the largest pressure was told as 135 of 93 MPa, and 9 of 8 MPa, with one peak.
#[test]
fn the_pressure_at_the_end_of_a_contact_that_grows_is_told_as_closely_as_its_depth() {
    let cam = ["wear.k=1e-7", "contact.friction=0.1", "sliding.omega=40", "wear.until=1", "tasks=[\"wear\"]"];
    for (name, settings) in [("pin-on-disc", &[][..]), ("cam", &cam[..])] {
        let largest = |accuracy: &str| {
            let settings: Vec<&str> = settings.iter().copied().chain([accuracy]).collect();
            solved(&scene(name, &settings)).profile.unwrap().pressure.into_iter().fold(0.0, f64::max)
        };
        let [rough, fine] = ["accuracy=1e-4", "accuracy=1e-5"].map(largest);
        assert!((rough / fine - 1.0).abs() < 3e-5, "{name}: {rough} {fine} MPa");
    }
}

/// Worn in, each sense of sliding opens at a place of its own, and nodes stand there: without them the levels of these shares stayed 2e-5 apart on any degree,
/// and .3 missed 1e-4. It is the shape that is found directly, whichever way the longer part of the time goes.
#[test]
fn a_reversing_run_comes_to_its_shape_with_nodes_where_the_senses_open() {
    let gap = |share: &str, task: &str| {
        let solution = solved(&scene("reciprocating-pad", &[share, task]));
        assert_eq!(solution.status, Status::Ok, "{share}: {:?}", solution.reason);
        assert!(solution.error.unwrap().gap_relative.unwrap() < 1e-5, "{share}");
        assert!(solution.ladder.last().unwrap().degree <= 8, "{share}");
        solution.profile.unwrap().gap.into_iter().fold(0.0, f64::max)
    };
    for share in ["sliding.reversing.share=0.3", "sliding.reversing.share=0.5", "sliding.reversing.share=0.7"] {
        let [worn, shape] = ["tasks=[\"wear\"]", "tasks=[\"pressure\",\"shape\"]"].map(|task| gap(share, task));
        assert!((worn / shape - 1.0).abs() < 1e-8, "{share}: {worn} {shape} um");
    }
}

#[test]
fn a_run_that_begins_worn_in_is_no_better_than_its_pressures() {
    // Like seed 61000220 of the campaign, in two systems of units, between which round-off sets the depths apart; two columns under an even load are worn in.
    let scene =
        |thickness: &str, force: &str, speed: &str, until: &str, [young1, young2]: [&str; 2], [x1, z1, x2, z2]: [&str; 4]| {
            format!(
                r#"
units = "N-mm"
kinematics = "plane-stress"
tasks = ["wear"]
mesh = {{ degree = 8, layers = 8 }}
check = false
thickness = {thickness}
contact = {{ edges = ["bottom", "top"], friction = 0, gap = 0 }}
load = {{ edge = "top", as = "pressure", force = {force} }}
sliding = {{ speed = {speed} }}
wear = {{ k = [6e-9, 0.0], a = 0.5124, b = 1.868, until = {until} }}
optimum = {{ functional = "steady" }}
body1.material = {{ young = {young1}, poisson = 0.3266 }}
body1.support.left = ["x"]
body1.geometry.rectangle = {{ x = {x1}, z = {z1} }}
body2.material = {{ young = {young2}, poisson = 0.4115 }}
body2.support = {{ left = ["x"], bottom = ["z"] }}
body2.geometry.rectangle = {{ x = {x2}, z = {z2} }}
"#
            )
        };
    let millimetres =
        ["[-22.61, 4.609999999999999]", "[0.0, 73.9023]", "[-22.61, 4.609999999999999]", "[-8.457253999999999, 0.0]"];
    let metres = [
        r#"["-2.261e-2 m", "4.609999999999999e-3 m"]"#,
        r#"["0e-3 m", "7.39023e-2 m"]"#,
        r#"["-2.261e-2 m", "4.609999999999999e-3 m"]"#,
        r#"["-8.457253999999999e-3 m", "0e-3 m"]"#,
    ];
    let [force, until] = [r#""1.5990586889399998e-1 kN""#, r#""6.209065978150816e8 ms""#];
    let runs = [
        scene("1.198", "159.90586889399998", "0.2803", "620906.5978150816", ["7692.0", "50010.0"], millimetres),
        scene(r#""1.198e-3 m""#, force, r#""2.803e-4 m/s""#, until, [r#""7.692e0 GPa""#, r#""5.001e1 GPa""#], metres),
    ];
    let [one, other] = runs.map(|text| solved(&read(&text, &[])).wear.unwrap());
    let apart = (one.depth.unwrap() / other.depth.unwrap() - 1.0).abs();
    let told = [&one, &other].map(|wear| wear.run_in_error.unwrap());
    println!("{apart:.1e} {told:?}");
    assert!(apart <= told[0] + told[1] && (1e-10..1e-9).contains(&told[0]), "{apart:.1e} {told:?}");
}
