//! Profiles with a corner: the pressure under it is singular, and needs nodes there.

use std::ops::ControlFlow;

use wearshape::{Bodies, Options, Problem, Sampling, Solution, Status, solve};

use crate::common::{scene, solved};

fn at(problem: &Problem, places: &[f64]) -> Solution {
    let options = Options { sample: Some(Sampling::At(places)), ..Options::default() };
    solve(problem, &options, &Bodies::default(), &mut |_| ControlFlow::Continue(())).unwrap()
}

/// A punch with a wedge as its profile, the tip in its middle, where the mesh has a vertex anyway, or aside of that; a ring that touches in part.
#[test]
fn pressures_under_a_corner_are_as_near_as_they_are_told_to_be() {
    let punch = "load={edge='top',as='rigid',force=1e4,tilt=0}";
    for (name, settings) in [
        ("translating-punch", &[punch, "contact.friction=0", "contact.gap={s_mm=[-30,0,30],gap_um=[0.5,0,0.5]}"][..]),
        ("translating-punch", &[punch, "contact.friction=0.2", "contact.gap={s_mm=[-30,7,30],gap_um=[0.5,0,0.5]}"]),
        ("drum-brake-ring", &["kinematics=plane-strain", "contact.gap={s_mm=[-104.8,0,104.8],gap_um=[2,0,2]}"]),
    ] {
        let with = |more: &[&str]| at(&scene(name, &[settings, &["tasks=[contact]"], more].concat()), &[-8.0, -1.0, 2.0, 9.0]);
        let [coarse, fine] = [with(&["accuracy=1e-3"]), with(&["mesh.degree=10", "mesh.layers=10"])];
        assert!(coarse.status == Status::Ok && fine.status == Status::Ok, "{:?}", coarse.reason);
        let told = coarse.error.as_ref().unwrap().pressure_relative.unwrap();
        let [coarse, fine] = [coarse, fine].map(|solution| solution.profile.unwrap().pressure);
        let largest = fine.iter().fold(0.0, |most: f64, p| most.max(*p));
        let apart = coarse.iter().zip(&fine).fold(0.0, |most: f64, (a, b)| most.max((a - b).abs())) / largest;
        assert!(apart < 3.0 * told && told < 1e-3, "{name} {apart:e} {told:e}");
    }
}

/// The spike itself is part of what is told: with half the layers it was off by 2.7e-5, all of it within .02 mm of the tip, where 2e-6 was told.
#[test]
fn the_spike_under_a_corner_is_as_near_as_it_is_told_to_be() {
    // The places miss the tip itself.
    let options = Options { sample: Some(Sampling::Even(3000)), ..Options::default() };
    let with = |fineness: &[&str]| {
        let settings = [
            "tasks=[contact]",
            "load={edge='top',as='rigid',force=1e4,tilt=0}",
            "contact.friction=0",
            "contact.gap={s_mm=[-30,0,30],gap_um=[0.5,0,0.5]}",
        ];
        let problem = scene("translating-punch", &[&settings, fineness].concat());
        solve(&problem, &options, &Bodies::default(), &mut |_| ControlFlow::Continue(())).unwrap()
    };
    let [coarse, fine] = [with(&["accuracy=1e-5"]), with(&["mesh.degree=12", "mesh.layers=12"])];
    let told = coarse.error.as_ref().unwrap().pressure_relative.unwrap();
    let [coarse, fine] = [coarse, fine].map(|solution| solution.profile.unwrap());
    let inner = |k: &usize| fine.s[*k].abs() < 28.5;
    let square = |f: &dyn Fn(usize) -> f64| (0..fine.s.len()).filter(inner).map(|k| f(k).powi(2)).sum::<f64>();
    let apart = (square(&|k| coarse.pressure[k] - fine.pressure[k]) / square(&|k| fine.pressure[k])).sqrt();
    assert!(apart < told && told < 1e-5, "{apart:e} {told:e}");
}

/// Hardly worn, a surface has the gap that it was given. (Waves in the elements with the corner lay below the surface, and lifted the whole gap by 1.7 %.)
#[test]
fn a_profile_with_a_corner_that_has_hardly_worn_is_the_one_given() {
    let settings = [
        "tasks=[wear]",
        "wear={k=[1e-10,0],until={revolutions=1e-6}}",
        "accuracy=1e-4",
        "contact.gap={s_mm=[20,77,120],gap_um=[5,0,5]}",
    ];
    let solution = solved(&scene("annular-punch", &settings));
    assert_eq!(solution.status, Status::Ok, "{:?}", solution.reason);
    let profile = solution.profile.unwrap();
    let given = |s: f64| if s < 77.0 { 5.0 * (77.0 - s) / 57.0 } else { 5.0 * (s - 77.0) / 43.0 };
    for (s, gap) in profile.s.iter().zip(&profile.gap) {
        assert!((gap - given(*s)).abs() < 1e-6, "{s} {gap} {}", given(*s));
    }
}
