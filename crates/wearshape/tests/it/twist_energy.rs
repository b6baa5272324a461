//! Strain energy of the twist by friction about an axis of revolution.

use std::ops::ControlFlow;

use wearshape::{Bodies, Options, solve};

use crate::common::{read, scene, solved};

/// An annulus on a disc, and the same with a foot that reaches the axis.
const FOOT: &str = r#"
units = "N-mm"
kinematics = "axisymmetric"
tasks = ["pressure"]
body1.material = { young = 3000, poisson = 0.35 }
body1.geometry.rectangle = { x = [0, 20], z = [0, 15] }
body1.support = { top = ["phi"] }
body2.material = { young = 200000, poisson = 0.3 }
body2.geometry.rectangle = { x = [0, 50], z = [-15, 0] }
body2.support = { bottom = ["x", "z", "phi"] }
contact = { edges = ["bottom", "top"], friction = 0.2 }
sliding = { omega = "10 rad/s" }
load = { edge = "top", as = "rigid", force = 2000 }
wear = { k = [1e-8, 3e-9], counterface = "congruent" }
"#;

/// It is half the work of the shear on the surface, and no part of the energy in the plane.
#[test]
fn the_energy_of_the_twist_is_half_the_work_of_the_shear() {
    let solution = solved(&scene("annular-punch", &["accuracy=1e-3", "check=false"]));
    let (profile, energy) = (solution.profile.unwrap(), solution.energy.unwrap());
    for (body, told, sign) in [(0, energy.twist1.unwrap(), 1.0), (1, energy.twist2.unwrap(), -1.0)] {
        let work = |i: usize| sign * 1e-3 * profile.weight[i] * profile.shear[i] * profile.hoop_displacement[body][i];
        let work: f64 = (0..profile.s.len()).map(work).sum();
        assert!((0.5 * work - told).abs() < 1e-11 * told, "{body}: {} {told}", 0.5 * work);
    }
    let plain = solved(&scene("annular-punch", &["accuracy=1e-3", "check=false", "contact.friction=0"])).energy.unwrap();
    assert!(plain.twist1.is_none() && plain.twist2.is_none());
    assert!(solved(&scene("translating-punch", &["accuracy=1e-2", "check=false"])).energy.unwrap().twist1.is_none());
}

/// The steady pressure C / r of a foot that reaches the axis has no largest value.
#[test]
fn an_infinite_pressure_has_no_largest_value_and_no_shape() {
    let pressed = |settings: &[&str]| {
        let options = Options { machining: true, ..Options::default() };
        let solution = solve(&read(FOOT, settings), &options, &Bodies::default(), &mut |_| ControlFlow::Continue(()));
        solution.unwrap().pressure.unwrap()
    };
    let ring = pressed(&["body1.geometry.rectangle.x=[5,20]"]);
    assert!(ring.p_max.is_some() && ring.sensitivity.iter().any(|entry| entry.p_max_percent.is_some()));
    let pressed = pressed(&[]);
    assert!(pressed.p_max.is_none() && pressed.p_max_at.is_none() && pressed.p_mean.is_some(), "{pressed:?}");
    assert!(!pressed.sensitivity.is_empty() && pressed.sensitivity.iter().all(|entry| entry.p_max_percent.is_none()));
    let shape = solved(&read(FOOT, &["tasks=[shape]"]));
    assert!(shape.reason.is_some_and(|reason| reason.contains("infinite")));
}
