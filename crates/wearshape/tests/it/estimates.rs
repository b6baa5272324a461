//! Estimated errors against true ones, and answers that more accuracy must not lose.

use std::ops::ControlFlow;

use wearshape::{Bodies, Document, Options, Problem, Sampling, Solution, Status, builtin, solve};

const SOFT_CYLINDER: &str = r#"
units = "N-mm"
kinematics = "plane-strain"
thickness = 16.146101142123335
tasks = ["contact"]
body1.material = { young = 72.60351838936228, poisson = 0.3 }
body2.material = { young = 98467.83970667166, poisson = 0.0 }
body1.geometry.half-disc = { radius = 49.83142333908507, centre = [0.0, 49.83142333908507] }
body1.support = { centre = ["x"] }
body2.geometry.rectangle = { x = [-69.90882546175752, 69.90882546175752], z = [-40.6426096806878, 0.0] }
body2.support = { bottom = ["x", "z"] }
contact = { edges = ["arc", "top"], friction = 0.0, gap = 0 }
load = { edge = "top", as = "pressure", force = 316.45395319550164 }
"#;

fn solved(text: &str, set: &[&str], alone: bool) -> Solution {
    let set: Vec<String> = set.iter().map(ToString::to_string).collect();
    let document = Document::read("scene.toml", text, &set).expect("the scene reads");
    let problem = Problem::new(&document, &|file| Err(format!("no file {file}"))).expect("the scene is sound");
    let options = Options { sample: Some(Sampling::Even(201)), alone, ..Options::default() };
    solve(&problem, &options, &Bodies::default(), &mut |_| ControlFlow::Continue(())).expect("the scene is solved")
}

fn scene(name: &str) -> &'static str {
    builtin(name).expect("a built-in scene").text
}

/// Largest difference of two gaps over the largest gap, without their mean along z.
fn apart(a: &Solution, b: &Solution) -> f64 {
    let [a, b] = [a, b].map(|solution| solution.profile.as_ref().expect("a table"));
    let along: Vec<f64> = b.normal.iter().map(|n| n[2]).collect();
    let off: Vec<f64> = a.gap.iter().zip(&b.gap).map(|(a, b)| a - b).collect();
    let dot = |x: &[f64], y: &[f64]| x.iter().zip(y).map(|(x, y)| x * y).sum::<f64>();
    let mean = dot(&off, &along) / dot(&along, &along);
    let most = |values: &mut dyn Iterator<Item = f64>| values.fold(0.0_f64, f64::max);
    most(&mut off.iter().zip(&along).map(|(d, n)| (d - mean * n).abs())) / most(&mut b.gap.iter().copied())
}

#[test]
fn an_estimate_at_a_fixed_discretisation_sees_its_layers() {
    for (name, levels) in [("annular-punch", &[[16, 12], [10, 6], [8, 4]][..]), ("internal-shoe", &[[10, 3], [8, 8]])] {
        let at = |[degree, layers]: [usize; 2], alone| {
            let mesh = [format!("mesh.degree={degree}"), format!("mesh.layers={layers}")];
            solved(scene(name), &["tasks=[\"shape\"]", "check=false", &mesh[0], &mesh[1]], alone)
        };
        let truth = at([18, 18], true);
        for level in levels {
            let found = at(*level, false);
            let estimate = found.error.as_ref().and_then(|error| error.gap_relative).expect("an estimate");
            let effectivity = apart(&found, &truth) / estimate;
            assert!((0.1..2.0).contains(&effectivity), "{name} {level:?}: {effectivity} of {estimate:e}");
        }
    }
}

/// The smallest gap of a punch touches in one point, where its tangent fixes the rotation: that round-off turns, as moduli and force times one factor
/// show, which leave the gap as it is.
#[test]
fn an_estimate_covers_what_round_off_leaves_in_a_shape() {
    let at = |factor: f64| {
        let [young, force] = [210e3 * factor, 1e3 * factor];
        let material = [1, 2].map(|body| format!("body{body}.material={{young={young},poisson=0.3}}"));
        let force = format!("load.force={force}");
        let mesh = ["mesh.degree=20", "mesh.layers=16", "check=false"];
        solved(
            scene("translating-punch"),
            &[&mesh[..], &["tasks=[\"shape\"]", &material[0], &material[1], &force]].concat(),
            false,
        )
    };
    let [one, other] = [at(1.0), at(3.33)];
    let gaps = [&one, &other].map(|solution| &solution.profile.as_ref().expect("a table").gap);
    let most = |values: &mut dyn Iterator<Item = f64>| values.fold(0.0_f64, f64::max);
    let apart = most(&mut gaps[0].iter().zip(gaps[1]).map(|(a, b)| (a - b).abs())) / most(&mut gaps[0].iter().copied());
    let estimate: f64 = [&one, &other].iter().filter_map(|found| found.error.as_ref()?.gap_relative).sum();
    assert!(apart < 2.0 * estimate && estimate < 1e-6, "{apart:e} {estimate:e}");
}

#[test]
fn an_estimate_of_the_energies_does_not_take_one_bodys_error_for_the_others() {
    // At this level body 1 has as much too much as body 2 has too little, but for a sixteenth of it, and so its sum is as good as that of the next one.
    let bodies = [
        "body1.material={young=238.00002673511094,poisson=0.16996447291123212}",
        "body2.material={young=11826.47286683466,poisson=0.3882465866201942}",
        "load.force=0.0019534654675680435",
    ];
    let at = |mesh: [&str; 2], alone| solved(scene("hertz-cylinder"), &[&bodies[..], &mesh].concat(), alone);
    let (found, truth) = (at(["mesh.degree=10", "mesh.layers=3"], false), at(["mesh.degree=14", "mesh.layers=14"], true));
    let [a, b] = [&found, &truth].map(|solution| solution.energy.as_ref().expect("energies"));
    let off = |a: Option<f64>, b: Option<f64>| (a.expect("an energy") - b.expect("an energy")).abs();
    let apart = (off(a.body1, b.body1) + off(a.body2, b.body2)) / b.total();
    let estimate = found.error.as_ref().and_then(|error| error.energy_relative).expect("an estimate");
    assert!((0.1..2.0).contains(&(apart / estimate)), "{apart:e} {estimate:e}");
}

#[test]
fn a_cylinder_of_many_layers_ends_where_one_of_few_does() {
    // The first point outside contact lies closer to its end than a billionth of the contact.
    let found = solved(scene("hertz-cylinder"), &["mesh.degree=17", "mesh.layers=17"], false);
    let end = found.contact.as_ref().expect("a contact").ends[1];
    assert!((end / 6.2011910478 - 1.0).abs() < 1e-8, "{end}");
    let error = found.error.and_then(|error| error.pressure_relative).expect("an estimate");
    assert!(error < 1e-7, "{error:e}");
}

#[test]
fn an_end_of_contact_stays_where_it_is_under_more_layers() {
    // In the smallest cells points are closer to each other than a billionth of the contact.
    for layers in [18, 20] {
        let found = solved(SOFT_CYLINDER, &["mesh.degree=20", &format!("mesh.layers={layers}")], true);
        let end = found.contact.as_ref().expect("a contact").ends[1];
        assert!((end / 3.952551008 - 1.0).abs() < 1e-9, "{layers} layers: {end}");
    }
}

#[test]
fn more_accuracy_does_not_lose_the_answer() {
    let reached = [1e-7, 1e-8, 2e-9, 1e-9].map(|accuracy| (accuracy, Status::Ok));
    for (accuracy, status) in reached.into_iter().chain([(1e-12_f64, Status::AccuracyMissed)]) {
        let found = solved(SOFT_CYLINDER, &[&format!("accuracy={accuracy}")], false);
        assert_eq!(found.status, status, "{accuracy}: {:?}", found.reason);
        let end = found.contact.as_ref().expect("a contact").ends[1];
        assert!((end / 3.9525510083 - 1.0).abs() < accuracy.max(1e-8), "{accuracy}: {end}");
        let error = found.error.and_then(|error| error.pressure_relative).expect("an estimate");
        assert!(error < 1e-7, "{accuracy}: {error:e}");
    }
}

#[test]
fn an_estimate_is_no_smaller_than_what_equilibrium_is_off_by() {
    // Held by a hub of a micrometre the disc turns by what round-off makes of its equations, and levels agree by chance.
    let set =
        ["tasks=[\"contact\"]", "accuracy=1e-5", "body1.geometry.shoe-block.half_angle=0.5", "body2.geometry.ring.inner=0.001"];
    let found = solved(scene("drum-brake-block"), &set, false);
    let error = found.error.and_then(|error| error.pressure_relative).expect("an estimate");
    assert!(error > 1e-6, "{error:e}");
}
