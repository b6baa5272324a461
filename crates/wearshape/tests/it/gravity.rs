//! The weight of bodies: it bends the surfaces before they are pressed, and is carried by the supports of body 2 and the loaded edge of body 1.

use wearshape::{Profile, Solution};

use crate::common::{read, scene, solved};

const SMOOTH: [&str; 6] =
    ["tasks=[pressure,shape]", "mesh.degree=6", "mesh.layers=2", "check=false", "contact.friction=0", "wear={k=[1e-7,0]}"];
const E: f64 = 210e3;
const NU: f64 = 0.3;
const DENSITY: f64 = 7.85e-9;
/// mm/s^2: that of a fast rotor, so that its digits are well above those of the pressure.
const G: f64 = 5e6;
/// Both bodies of `translating-punch` are 100 mm high.
const HEIGHT: f64 = 100.0;

fn profile(solution: Solution) -> Profile {
    assert!(solution.reason.is_none(), "{:?}", solution.reason);
    solution.profile.unwrap()
}

fn shaped(more: &[&str]) -> Profile {
    profile(solved(&scene("translating-punch", &[&SMOOTH[..], more].concat())))
}

fn dense(body: usize) -> String {
    format!("body{body}.material={{ young = 210000, poisson = 0.3, density = '7850 kg/m3' }}")
}

/// A plate between smooth walls on smooth ground, in plane stress: eps_x = 0, M = E / (1 - nu^2), and its top sinks by rho g H^2 / (2 M).
#[test]
fn a_plate_between_walls_sinks_under_its_weight() {
    let walls = "body2.support={ bottom = [z], left = [x], right = [x] }";
    let (dense, gravity) = (dense(2), format!("body2.gravity=[0, -{G}]"));
    let (still, heavy) = (shaped(&[walls]), shaped(&[walls, &dense, &gravity]));
    let sinks = -1e3 * DENSITY * G * HEIGHT * HEIGHT * (1.0 - NU * NU) / (2.0 * E);
    assert!(sinks < -0.5, "{sinks}");
    for k in 0..still.s.len() {
        let moved = heavy.normal_displacement[1][k] - still.normal_displacement[1][k];
        assert!((moved / sinks - 1.0).abs() < 1e-9, "{moved} {sinks}");
        assert!((heavy.normal_displacement[0][k] - still.normal_displacement[0][k]).abs() < 1e-9 * sinks.abs());
    }
    assert_eq!(heavy.pressure, still.pressure);
}

/// A block between smooth walls that hangs from its evenly loaded top: from its bottom `s_z = rho g z` and `s_x = nu s_z`, and it grows by
/// rho g H^2 / (2 M).
#[test]
fn a_block_that_hangs_from_its_loaded_edge_is_strained_by_the_closed_form() {
    let pressed = ["load={edge=top,as=pressure,force='1 kN'}", "body1.support={ left = [x], right = [x] }"];
    let (dense, gravity) = (dense(1), format!("body1.gravity=[0, '-{} m/s2']", G / 1e3));
    let path = "output.paths=[{ name = 'middle', body = 1, from = [7, 100], to = [7, 200], points = 5 }]";
    let of = |more: &[&str]| solved(&scene("translating-punch", &[&SMOOTH[..], &pressed, &[path], more].concat()));
    let (still, heavy) = (of(&[]), of(&[&dense, &gravity]));
    let whole = DENSITY * G * HEIGHT;
    let (before, after) = (&still.paths[0], &heavy.paths[0]);
    for (k, s) in before.s.iter().enumerate() {
        let more = |of: fn(&wearshape::Stress) -> f64| of(&after.stress[k]) - of(&before.stress[k]);
        let [xx, zz, xz] = [more(|s| s.xx), more(|s| s.zz), more(|s| s.xz)];
        let wanted = DENSITY * G * s;
        assert!((zz - wanted).abs() < 1e-9 * whole, "{s}: {zz} {wanted}");
        assert!((xx - NU * wanted).abs() < 1e-9 * whole && xz.abs() < 1e-9 * whole, "{s}: {xx} {xz}");
    }
    let length = |path: &wearshape::PathProfile| path.displacement[4][2] - path.displacement[0][2];
    let grows = whole * HEIGHT * (1.0 - NU * NU) / (2.0 * E);
    let found = length(after) - length(before);
    assert!((found / grows - 1.0).abs() < 1e-9, "{found} {grows}");
    assert_eq!(profile(heavy).pressure, profile(still).pressure);
}

/// The edge carries the moment of the weight too: a rigid one, and gravity across.
#[test]
fn the_proof_of_a_shape_under_gravity_agrees_with_it_and_the_force_stays() {
    let (first, second) = (dense(1), dense(2));
    let settings = ["accuracy=1e-4", &first, &second, "body1.gravity=[3e6, -5e6]", "body2.gravity=[0, -5e6]"];
    for scene_of in ["translating-punch", "drum-brake-block"] {
        let heavy = solved(&scene(scene_of, &settings));
        assert!(heavy.reason.is_none(), "{:?}", heavy.reason);
        let shape = heavy.shape.unwrap();
        assert!(shape.roundtrip_same.unwrap() < 1e-5 && shape.roundtrip_independent.unwrap() < 5e-2, "{scene_of}: {shape:?}");
    }
    let revolved = ["accuracy=1e-4", &first, &second, "body1.gravity=[0, -5e6]", "body2.gravity=[0, -5e6]"];
    let shape = solved(&scene("annular-punch", &revolved)).shape.unwrap();
    assert!(shape.roundtrip_same.unwrap() < 1e-5 && shape.roundtrip_independent.unwrap() < 5e-2, "{shape:?}");
    let contact = ["tasks=[contact]", "mesh.degree=6", "contact.friction=0", &first, "body1.gravity=[3e6, -5e6]"];
    let result = solved(&scene("translating-punch", &contact)).contact.unwrap();
    assert!((result.force.unwrap() / 1e3 - 1.0).abs() < 1e-9, "{:?}", result.force);
}

#[test]
fn gravity_needs_a_density_and_does_not_go_with_everything() {
    let refused = |name: &str, settings: &[&str]| {
        let text = scene::builtin(name).unwrap().text;
        let settings: Vec<String> = settings.iter().map(ToString::to_string).collect();
        let read = wearshape::Document::read(name, text, &settings);
        read.and_then(|document| wearshape::Problem::new(&document, &|_| Err("no file".into())))
            .and_then(|problem| problem.available())
            .unwrap_err()
    };
    let fault = refused("translating-punch", &["body2.gravity=[0, -9810]"]);
    assert_eq!((fault.code, fault.key.as_deref()), ("missing-key", Some("body2.material.density")));
    let steel = "body1.material=steel";
    let fault = refused("annular-punch", &[steel, "body1.gravity=[1, -9810]"]);
    assert_eq!((fault.code, fault.key.as_deref()), ("wrong-value", Some("body1.gravity.0")));
    let fault = refused("pinned-shoe-elastic", &[steel, "body1.gravity=[0, -9810]"]);
    assert_eq!((fault.code, fault.key.as_deref()), ("not-available", Some("body1.gravity")));
    let fault = refused("hertz-cylinder", &[steel, "body1.gravity=[0, -9810]"]);
    assert_eq!((fault.code, fault.key.as_deref()), ("not-available", Some("body1.gravity")));
    let again = scene("translating-punch", &["body2.material=steel", "body2.gravity=[0, '-1 gn']"]);
    assert_eq!(read(&again.resolved(), &[]).resolved(), again.resolved());
    assert!(again.resolved().contains("-9806.65"), "{}", again.resolved());
    let pressure = scene("translating-punch", &["body2.material=steel", "body2.gravity=[0, -9810]", "tasks=[pressure]"]);
    assert!(pressure.unused_keys().contains(&"body2.gravity".to_string()), "{:?}", pressure.unused_keys());
}

/// What the supports carry beside the contact is no imbalance of it.
#[test]
fn the_weight_of_body_2_is_no_error_of_a_contact() {
    for gravity in ["body2.gravity=[0, '-1 gn']", "body2.gravity=['1 gn', 0]"] {
        let settings = ["tasks=[contact]", "accuracy=1e-3", "contact.friction=0", &dense(2), gravity];
        let solution = solved(&scene("translating-punch", &settings));
        assert!(solution.reason.is_none(), "{gravity}: {:?}", solution.reason);
        let error = solution.error.unwrap();
        assert!(error.pressure_relative.unwrap() < 1e-3 && error.energy_relative.unwrap() < 1e-3, "{gravity}");
    }
}
