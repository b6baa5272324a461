//! Hot shapes: where there is none, bodies of revolution and a counter-face that always arrives fresh, against closed forms.

use std::ops::ControlFlow;

use wearshape::{Bodies, Event, FromCold, Options, Problem, Sampling, Solution, SpeedFactor, Status, solve};

use crate::common::{read, scene, solved};
use crate::heat::{Q, SLABS, near, profile};

/// Two bodies of revolution on each other that hardly slide, each at a temperature of its own.
const DISCS: &str = r#"
units = "N-mm"
kinematics = "axisymmetric"
tasks = ["shape"]
check = false
mesh = { degree = 6, layers = 0 }
body1.material = { young = "200 GPa", poisson = 0.3, conductivity = "40 W/(m K)", expansion = "12e-6 1/K" }
body1.geometry.rectangle = { x = [20, 60], z = [0, 10] }
body1.heat = { top = { temperature = 120 } }
body2.material = { young = "100 GPa", poisson = 0.25, conductivity = "8 W/(m K)", expansion = "20e-6 1/K" }
body2.geometry.rectangle = { x = [20, 60], z = [-15, 0] }
body2.support = { bottom = ["z"] }
body2.heat = { bottom = { temperature = 70 } }
contact = { edges = ["bottom", "top"], friction = 0.25 }
sliding = { omega = 1e-12 }
load = { edge = "top", as = "pressure", force = "600 N" }
wear = { k = 1e-8, counterface = "congruent" }
optimum = { functional = "uniform" }
heat = { share = 0.5 }
"#;

fn ended(problem: &Problem) -> Solution {
    solve(problem, &Options::default(), &Bodies::default(), &mut |_| ControlFlow::Continue(())).unwrap()
}

fn refused(solution: &Solution, words: &str) {
    assert_eq!(solution.status, Status::Refused, "{:?}", solution.reason);
    assert!(solution.reason.as_deref().is_some_and(|reason| reason.contains(words)), "{:?}", solution.reason);
}

#[test]
fn a_shape_beyond_the_critical_speed_is_refused_with_and_without_its_proof() {
    for mesh in [&["accuracy=1e-3"][..], &["mesh.degree=6", "mesh.layers=5"]] {
        for (speed, check) in [("5", "check=false"), ("5000", "check=false"), ("5", "check=true")] {
            let speed = format!("sliding.omega={speed}");
            let solution = ended(&scene("drum-brake-hot", &[mesh, &[&speed, check]].concat()));
            refused(&solution, "beyond the critical one");
        }
    }
}

#[test]
fn a_shape_that_comes_to_its_speed_cold_may_have_another_contact() {
    let from_cold = |name: &str, speed: &str| {
        let omega = format!("sliding.omega={speed}");
        let solution = solved(&scene(name, &["accuracy=1e-3", "check=false", &omega]));
        let noted = solution.remarks.iter().any(|remark| remark.code == "not-worn-in-from-cold");
        let heat = solution.heat.unwrap();
        assert_eq!(noted, heat.from_cold.is_some(), "{name} at {speed} rad/s");
        // Another contact may exist at half the speed at which the wanted one is singular.
        assert!(matches!(heat.critical_speed_factor, Some(SpeedFactor::At(factor)) if factor > 1.7), "{name} at {speed} rad/s");
        heat.from_cold
    };
    assert_eq!(from_cold("drum-brake-hot", "1.5"), None);
    assert_eq!(from_cold("clutch-hot", "2"), None);
    // A contact solve on the shape of 2.5 rad/s, on finer meshes: 0.8502 MPa from -39.85 to 44.89 mm.
    let Some(FromCold::Carries { largest, ends }) = from_cold("drum-brake-hot", "2.5") else { panic!("one contact alone") };
    assert!((largest / 0.8502 - 1.0).abs() < 0.06, "{largest} MPa");
    assert!((ends[0] + 39.85).abs() < 6.0 && (ends[1] - 44.89).abs() < 6.0, "{ends:?} mm");
}

#[test]
fn a_shape_has_its_critical_speed_with_and_without_its_proof() {
    let factors = |check: &str| {
        let heat = solved(&scene("drum-brake-hot", &["accuracy=1e-3", check])).heat.unwrap();
        (heat.staggered_limit_speed_factor, heat.separation_speed_factor, heat.critical_speed_factor)
    };
    let found = factors("check=false");
    assert_eq!(found, factors("check=true"));
    // One level alone tells it too.
    let fixed = scene("drum-brake-hot", &["mesh={ degree = 6, layers = 5 }", "check=false"]);
    let options = Options { alone: true, ..Options::default() };
    let alone = solve(&fixed, &options, &Bodies::default(), &mut |_| ControlFlow::Continue(())).unwrap().heat.unwrap();
    for critical in [found.2, alone.critical_speed_factor] {
        assert!(matches!(critical, Some(SpeedFactor::At(factor)) if (factor / 1.751 - 1.0).abs() < 1e-2), "{critical:?}");
    }
}

#[test]
fn a_thousand_times_the_speed_at_which_surfaces_separate_there_is_no_answer() {
    let solution = solved(&scene("clutch-hot", &["accuracy=1e-3", "check=false"]));
    let Some(SpeedFactor::At(factor)) = solution.heat.unwrap().separation_speed_factor else { panic!("no speed") };
    let speed = format!("sliding.omega={}", 2e3 * factor);
    let contact = ended(&scene("clutch-hot", &["tasks=[contact]", "accuracy=1e-3", &speed]));
    refused(&contact, "slide more slowly");
    assert!(contact.heat.is_none(), "of a contact that there is not, nothing is told");
    refused(&ended(&scene("clutch-hot", &["tasks=[shape]", "accuracy=1e-3", &speed])), "beyond the critical one");
}

/// The first levels give back their temperatures, for they are hardly the last: one that is reported all the same is solved again.
#[test]
fn a_hot_shape_that_is_stopped_tells_the_heat_of_the_level_it_came_to() {
    let problem = scene("clutch-hot", &["accuracy=1e-6", "check=false"]);
    let whole = solved(&problem).heat.unwrap();
    assert!(whole.critical_speed_factor.is_some());
    for (finished, off) in [(1, 1e-6), (2, 1e-7)] {
        let mut levels = 0;
        let stopped = solve(&problem, &Options::default(), &Bodies::default(), &mut |event| {
            levels += usize::from(matches!(event, Event::Level { .. }));
            if levels > finished { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        });
        let stopped = stopped.unwrap();
        assert_eq!((stopped.status, levels), (Status::Interrupted, finished + 1));
        let heat = stopped.heat.unwrap();
        let apart = (heat.into_body1 / whole.into_body1 - 1.0).abs();
        assert!(heat.balance.unwrap() < 1e-10 && apart < off, "{finished}: {apart:.1e} {heat:?}");
        assert!(heat.critical_speed_factor.is_none());
    }
}

/// Friction drags the end of the lining off the drum, or does not: then heat has to part them.
#[test]
fn surfaces_separate_at_no_speed_where_they_do_without_heat() {
    let found = |friction: f64| {
        let settings = ["mesh={ degree = 8, layers = 6 }", "check=false", &format!("contact.friction={friction}")];
        let shape = solved(&scene("drum-brake-hot", &settings));
        let slow = [&settings[..], &["tasks=[contact]", "sliding.omega=1e-9"]].concat();
        let cold = solved(&scene("drum-brake-hot", &slow)).contact.unwrap();
        let arc = 200.0 * std::f64::consts::PI / 6.0;
        assert_eq!(cold.ends.len(), 2);
        (shape.heat.unwrap().separation_speed_factor, cold.ends.iter().map(|end| arc - end.abs()).fold(0.0, f64::max))
    };
    let (factor, open) = found(0.35);
    assert!(factor == Some(SpeedFactor::At(0.0)) && (0.15..0.25).contains(&open), "{factor:?} {open}");
    let (factor, open) = found(0.1);
    assert!(
        matches!(factor, Some(SpeedFactor::At(factor)) if (factor / 0.2437 - 1.0).abs() < 1e-2) && open < 1e-9,
        "{factor:?} {open}"
    );
}

#[test]
fn a_counter_face_that_arrives_fresh_takes_its_share_away_and_is_not_distorted() {
    let settings = ["heat.counterface=fresh", "body2.heat={ bottom = { temperature = 50 } }"];
    for (split, into) in [
        ("heat.share=0.7", 0.7 * Q),
        ("heat={ conductance = 0.05, counterface = \"fresh\" }", (0.5 * Q + 0.05 * 30.0) / 1.05),
        ("heat={ conductance = \"inf\", counterface = \"fresh\" }", 30.0),
    ] {
        // Body 2 needs no conductivity: its temperature is that at which it arrives.
        let material = "body2.material={ young = \"100 GPa\", poisson = 0.25 }";
        let solution = solved(&read(SLABS, &[&settings[..], &[material, split]].concat()));
        let (heat, profile) = (solution.heat.as_ref().unwrap(), profile(&solution));
        // Heat flows through body 1 between its source and its top at 20 degC: 1 K for each mW/mm^2.
        for k in 0..profile.s.len() {
            near(profile.heat[0][k], into, 1e-9);
            near(profile.heat[1][k], Q - into, 1e-9);
            near(profile.temperature[0][k], 20.0 + into, 1e-9);
            near(profile.temperature[1][k], 50.0, 1e-12);
            assert_eq!(profile.thermal_displacement[1][k], 0.0);
        }
        near(heat.into_body2, (Q - into) * 600.0, 1e-9);
        assert!(heat.balance.unwrap() < 1e-11, "{heat:?}");
    }
}

#[test]
fn an_even_temperature_of_a_free_disc_or_annulus_moves_its_surface_evenly() {
    for inner in [20.0, 0.0] {
        let bodies = [("body1", "[0, 10]"), ("body2", "[-15, 0]")]
            .map(|(body, z)| format!("{body}.geometry.rectangle={{ x = [{inner}, 60], z = {z} }}"));
        let solution = solved(&read(DISCS, &[&bodies[0], &bodies[1]]));
        let profile = profile(&solution);
        for k in 0..profile.s.len() {
            near(profile.temperature[0][k], 120.0, 1e-9);
            near(profile.temperature[1][k], 70.0, 1e-9);
            // Body 1 grows downwards from where it is loaded, body 2 upwards from where it stands.
            near(profile.thermal_displacement[0][k], -1e3 * 12e-6 * 100.0 * 10.0, 1e-8);
            near(profile.thermal_displacement[1][k], 1e3 * 20e-6 * 50.0 * 15.0, 1e-8);
        }
    }
}

/// A thin ring, warm inside: `T = A + B ln r`, and it is thicker by `h alpha ((1 + nu) T - nu T_mean)`, as in plane stress (Timoshenko and Goodier,
/// art. 150), but for its rims.
#[test]
fn a_thin_ring_that_is_warm_inside_is_as_warm_as_its_logarithm_says_and_grows_so() {
    let settings = [
        "body1.geometry.rectangle={ x = [20, 60], z = [0, 1] }",
        "body1.heat={ left = { temperature = 100 }, right = { temperature = 20 } }",
        "mesh={ degree = 14, layers = 2 }",
    ];
    let solution = solved(&read(DISCS, &settings));
    let profile = profile(&solution);
    let rise = |r: f64| 80.0 * (60.0 / r).ln() / 3_f64.ln();
    // Mean of the area: 2 / (b^2 - a^2) times the integral of (T - T_0) r.
    let mean = 80.0 / 3_f64.ln() * (0.5 - 400.0 * 3_f64.ln() / (3600.0 - 400.0));
    let thicker = |r: f64| 1e3 * 12e-6 * (1.3 * rise(r) - 0.3 * mean);
    for (k, r) in profile.s.iter().enumerate() {
        near(profile.temperature[0][k], 20.0 + rise(*r), 1e-7);
        if (26.0..54.0).contains(r) {
            // Half of it below, and the mean of the other half above, where the ring is loaded.
            let wanted = -0.5 * thicker(*r) - 0.5 * 1e3 * 12e-6 * mean;
            let found = profile.thermal_displacement[0][k];
            assert!((found - wanted).abs() < 2e-3 * wanted.abs(), "{r}: {found} for {wanted}");
        }
    }
}

/// The tolerance of a hot shape is what a contact with its heat makes of an error: the heat follows the pressure too.
#[test]
fn a_crown_on_a_hot_shape_changes_the_pressure_by_what_its_tolerance_says() {
    let mesh = "mesh={ degree = 6, layers = 3 }";
    let shape = |speed: &str| {
        let options = Options { machining: true, ..Options::default() };
        let problem = scene("clutch-hot", &[mesh, "check=false", speed]);
        solve(&problem, &options, &Bodies::default(), &mut |_| ControlFlow::Continue(())).unwrap()
    };
    let of_a_crown = |solution: &Solution| {
        let all = &solution.shape.as_ref().unwrap().tolerance;
        all.iter().find(|entry| entry.error == "crown").unwrap().pressure_change_relative
    };
    let crown = 0.02;
    let mean = 4000.0 / (std::f64::consts::PI * (110.0 * 110.0 - 70.0 * 70.0));
    let told_and_found = |speed: &str| {
        let shape = shape(speed);
        let made = profile(&shape);
        // The inner 95 %, both ends included.
        let inner: Vec<f64> = made.s.iter().copied().filter(|s| *s > 71.0 && *s < 109.0).chain([71.0, 109.0]).collect();
        let pressures = |crown: f64| {
            let (s, gap, crown) = (&made.s, &made.gap, 1e-3 * crown);
            let gap = format!("contact.gap={{ profile = {{ s_mm = {s:?}, gap_um = {gap:?} }}, crown = {crown:?} }}");
            let options = Options { sample: Some(Sampling::At(&inner)), ..Options::default() };
            let problem = scene("clutch-hot", &["tasks=[contact]", mesh, speed, &gap]);
            profile(&solve(&problem, &options, &Bodies::default(), &mut |_| ControlFlow::Continue(())).unwrap()).pressure.clone()
        };
        let changes = pressures(0.001).into_iter().zip(pressures(0.001 + crown));
        let most = changes.map(|(before, after)| (after - before).abs() / (mean * crown)).fold(0.0, f64::max);
        [of_a_crown(&shape), most]
    };
    let ([hot, found_hot], [cold, found_cold]) = (told_and_found("sliding.omega=2"), told_and_found("sliding.omega=1e-9"));
    near(found_cold, cold, 1e-6);
    // The heat that the tolerance of a hot shape follows is made of few functions, which end at the ends of the surface.
    near(found_hot, hot, 2e-5);
    assert!(hot > 1.05 * cold);
}

/// A lining on a plate, without heat: its closing is free.
const CLUTCH: &str = r#"
units = "N-mm"
kinematics = "axisymmetric"
tasks = ["shape"]
check = false
mesh = { degree = 6, layers = 3 }
body1.material = { young = "300 MPa", poisson = 0.25 }
body1.geometry.rectangle = { x = [70, 110], z = [12, 16] }
body2.material = { young = "110 GPa", poisson = 0.26 }
body2.geometry.rectangle = { x = [65, 115], z = [0, 12] }
body2.support = { bottom = ["z"] }
contact = { edges = ["bottom", "top"], friction = 0.3, gap = 0 }
sliding = { omega = "2 rad/s" }
load = { edge = "top", as = "rigid", force = "4 kN" }
wear = { k = [1e-8, 0], counterface = "congruent" }
optimum = { functional = "steady" }
"#;

/// An error that a free motion takes up presses by round-off alone, and is to say nothing about how soon the others wear away.
#[test]
fn errors_that_press_are_worn_away_beside_one_that_a_free_motion_takes_up() {
    let options = Options { machining: true, ..Options::default() };
    let solution = solve(&read(CLUTCH, &[]), &options, &Bodies::default(), &mut |_| ControlFlow::Continue(())).unwrap();
    let tolerance = &solution.shape.as_ref().unwrap().tolerance;
    assert!(tolerance.len() > 5 && tolerance.iter().all(|entry| entry.error != "offset"), "{tolerance:?}");
    assert!(tolerance.iter().all(|entry| entry.run_in_distance.is_some()), "{tolerance:?}");
}

/// A block of three by two cells, warm along the line between the two in its middle, which ends inside it.
const WIRE: &str = r#"
units = "N-mm"
kinematics = "plane-strain"
thickness = 10
tasks = ["contact"]
mesh = { degree = 4, layers = 2 }
body1.material = { young = "200 GPa", poisson = 0.3, conductivity = "40 W/(m K)", expansion = "1e-9 1/K" }
body1.heat = { head = { temperature = 20 }, wire = { temperature = 200 } }
body1.support = { head = ["x"] }
body2.material = { young = "200 GPa", poisson = 0.3, conductivity = "40 W/(m K)", expansion = "1e-9 1/K" }
body2.geometry.rectangle = { x = [-40, 40], z = [-30, 0] }
body2.support = { bottom = ["x", "z"] }
body2.heat = { bottom = { temperature = 20 } }
contact = { edges = ["foot", "top"], friction = 0.1 }
sliding = { speed = 1 }
load = { edge = "head", as = "pressure", force = "1 kN" }
heat = { share = 0.5, reference = 20 }
[body1.geometry.blocks]
points = { a0 = [-15, 0], a1 = [-5, 0], a2 = [5, 0], a3 = [15, 0], b0 = [-15, 10], b1 = [-5, 10], b2 = [5, 10], b3 = [15, 10], c0 = [-15, 20], c1 = [-5, 20], c2 = [5, 20], c3 = [15, 20] }
[body1.geometry.blocks.curves]
f0.line = ["a0", "a1"]
f1.line = ["a1", "a2"]
f2.line = ["a2", "a3"]
m0.line = ["b0", "b1"]
m1.line = ["b1", "b2"]
m2.line = ["b2", "b3"]
h0.line = ["c0", "c1"]
h1.line = ["c1", "c2"]
h2.line = ["c2", "c3"]
l0.line = ["a0", "b0"]
l1.line = ["a1", "b1"]
l2.line = ["a2", "b2"]
l3.line = ["a3", "b3"]
u0.line = ["b0", "c0"]
u1.line = ["b1", "c1"]
u2.line = ["b2", "c2"]
u3.line = ["b3", "c3"]
[body1.geometry.blocks.cells]
p0 = { curves = ["f0", "l1", "m0", "l0"] }
p1 = { curves = ["f1", "l2", "m1", "l1"] }
p2 = { curves = ["f2", "l3", "m2", "l2"] }
q0 = { curves = ["m0", "u1", "h0", "u0"] }
q1 = { curves = ["m1", "u2", "h1", "u1"] }
q2 = { curves = ["m2", "u3", "h2", "u2"] }
[body1.geometry.blocks.edges]
foot = ["f0", "f1", "f2"]
head = ["h0", "h1", "h2"]
wire = ["m1"]
"#;

#[test]
fn a_body_is_hottest_on_a_warm_line_inside_it() {
    let heat = ended(&read(WIRE, &[])).heat.unwrap();
    near(heat.highest1.unwrap(), 200.0, 1e-9);
    let [x, z] = heat.highest1_at.unwrap();
    assert!(x.abs() <= 5.0 && (z - 10.0).abs() < 1e-9, "{x} {z}");
}

/// Three discretisations of two bodies, that of the level, a finer one beside it and the proof's; a drum has its temperature in closed form.
#[test]
fn factorised_temperatures_count_as_factorisations() {
    for (name, fields, count) in [("clutch-hot", false, 12), ("drum-brake-hot", false, 9), ("drum-brake-hot", true, 12)] {
        let fields = format!("output.fields={fields}");
        let solution = solved(&scene(name, &["tasks=[shape]", "mesh.degree=4", &fields]));
        assert_eq!(solution.effort.counters.factorisations, count, "{name} {fields}");
    }
}

/// Nothing that a factor can be told from: the search for the speed at which surfaces part once had no end.
#[test]
fn a_friction_that_makes_next_to_no_heat_has_no_limits_of_speed() {
    let solution = solved(&scene("clutch-hot", &["contact.friction=1e-320", "accuracy=1e-3"]));
    assert!(solution.reason.is_none(), "{:?}", solution.reason);
    let heat = solution.heat.unwrap();
    println!("{:?} {:?}", heat.separation_speed_factor, heat.staggered_limit_speed_factor);
    for factor in [heat.separation_speed_factor, heat.staggered_limit_speed_factor] {
        assert_eq!(serde_json::to_value(factor).unwrap(), "none");
    }
}
