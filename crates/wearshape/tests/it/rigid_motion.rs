//! The rigid motion that displacements leave out stands in the summary: opening = gap + (u1 - u2) . n with it.

use wearshape::{Profile, Solution, Status};

use crate::common::{scene, solved};

/// Largest distance (um) of points in contact from a closing at `about` (mm) and a turning (rad), and the largest displacement.
fn off(profile: &Profile, [closing, turning]: [f64; 2], about: f64) -> [f64; 2] {
    let mut most = [0.0_f64; 2];
    for i in (0..profile.s.len()).filter(|i| profile.pressure[*i] > 0.0) {
        let [first, second] = [0, 1].map(|body| profile.normal_displacement[body][i]);
        let rigid = -1e3 * (closing + turning * (profile.position[i][0] - about)) * profile.normal[i][2];
        most[0] = most[0].max((profile.opening[i] - profile.gap[i] - first + second - rigid).abs());
        most[1] = most[1].max(first.abs()).max(second.abs());
    }
    most
}

fn contact(name: &str, settings: &[&str]) -> Solution {
    solved(&scene(name, &[&["tasks=[contact]", "accuracy=1e-3"], settings].concat()))
}

#[test]
fn a_contact_closes_by_its_approach_and_tilt_with_or_without_a_rigid_edge() {
    for (name, settings, about) in [
        ("bushing", [].as_slice(), 0.0),
        ("drum-brake-block", &[], 0.0),
        ("drum-brake-ring", &[], 0.0),
        ("translating-punch", &["load.about=[10,100]"], 10.0),
        ("translating-punch", &["load={ edge = \"top\", as = \"pressure\", force = 1000 }"], 0.0),
    ] {
        let solution = contact(name, settings);
        let told = solution.contact.as_ref().unwrap();
        let [miss, size] = off(solution.profile.as_ref().unwrap(), [told.approach.unwrap(), told.tilt.unwrap_or(0.0)], about);
        assert!(miss < 1e-11 * size && told.approach.unwrap() > 0.0, "{name} {settings:?}: {miss:e} of {size}");
    }
}

#[test]
fn the_rigid_part_of_a_shape_is_a_motion_along_its_normal_and_a_turn() {
    let shape = |settings: &[&str]| {
        let solution = solved(&scene("translating-punch", &[&["accuracy=1e-3", "check=false"], settings].concat()));
        let about = if settings.iter().any(|set| set.contains("about")) { 10.0 } else { 0.0 };
        let shape = solution.shape.as_ref().unwrap();
        let [lifted, turned] = [shape.rigid.unwrap(), shape.turned.unwrap_or(0.0)];
        let [miss, size] = off(solution.profile.as_ref().unwrap(), [-lifted, -turned], about);
        assert!(miss < 1e-11 * size, "{settings:?}: {miss:e} of {size}");
        assert_eq!(shape.turned.is_none(), settings.contains(&"load.tilt=0"));
        [lifted, turned]
    };
    let ([one, turned], [mirrored, back]) = (shape(&[]), shape(&["sliding.speed=-5"]));
    assert!(
        (one - mirrored).abs() < 1e-9 * one.abs() && (turned + back).abs() < 1e-9 * turned.abs(),
        "{one} {mirrored} {turned} {back}"
    );
    shape(&["load.about=[10,100]"]);
    shape(&["load.tilt=0"]);
    shape(&["load.approach=0.03"]);
}

/// In a run in time as in a contact: the opening is the gap with the displacements of both bodies and the rigid motion of body 1.
#[test]
fn a_run_in_time_tells_the_rigid_motion_between_its_gap_and_its_opening() {
    let solution = solved(&scene("punch-wear", &["accuracy=1e-2", "load.moment=4000"]));
    let (profile, wear) = (solution.profile.unwrap(), solution.wear.unwrap());
    let (approach, tilt) = (wear.approach.unwrap(), wear.tilt.unwrap());
    assert!(tilt > 1e-7, "{tilt:e}");
    for i in 0..profile.s.len() {
        let [un1, un2] = [0, 1].map(|body| profile.normal_displacement[body][i]);
        let closed = 1e3 * (approach + tilt * profile.position[i][0]);
        let opening = profile.gap[i] + un1 - un2 - closed;
        assert!((opening - profile.opening[i]).abs() < 1e-12, "{opening} {}", profile.opening[i]);
    }
}

/// Of a punch far from the origin a turn about that was taken for no motion of its edge, and the scene was refused for want of a rigid edge.
#[test]
fn a_punch_is_held_by_its_edge_wherever_it_is() {
    let crown = |settings: &[&str]| {
        let solution = solved(&scene("translating-punch", &[&["accuracy=1e-4", "check=false"], settings].concat()));
        assert_eq!(solution.status, Status::Ok, "{:?}", solution.reason);
        solution.shape.unwrap().crown.unwrap()
    };
    let punch = "body1.geometry.rectangle={x=[999970,1000030],z=[100,200]}";
    let far = crown(&[punch, "body2.geometry.rectangle={x=[999940,1000060],z=[0,100]}", "load.about=[1000000,100]"]);
    let near = crown(&[]);
    assert!((far / near - 1.0).abs() < 1e-5, "{far} {near}");
}
