//! Bodies that spin: the centrifugal force bends the surfaces before they are pressed, as heat does.

use wearshape::{Document, Fault, Problem, Profile, Solution, builtin};

use crate::common::{computed_from, read, scene, solved};

const SMOOTH: [&str; 4] = ["tasks=[pressure,shape]", "mesh.degree=16", "mesh.layers=2", "check=false"];

fn profile(solution: Solution) -> Profile {
    assert!(solution.reason.is_none(), "{:?}", solution.reason);
    solution.profile.unwrap()
}

/// Speed of the drum, rad/s, and the settings that spin it.
const SPEED: f64 = 2000.0;
const SPINS: [&str; 2] =
    ["body2.material={ young = 210000, poisson = 0.3, density = '7850 kg/m3' }", "body2.spin={ omega = 2000 }"];

/// Radial displacement (um) and stresses `[s_r, s_t]` (MPa) at the radius r of the drum of 100 and 200 mm, its bore held: `u = A r + B / r - c r^3`
/// in plane stress with `c = (1 - nu^2) rho w^2 / (8 E)`, `u(100) = 0` and `s_r(200) = 0`.
fn drum(r: f64) -> [f64; 3] {
    let (e, nu, density) = (210e3, 0.3, 7.85e-9);
    let (a, b) = (100.0_f64, 200.0_f64);
    let c = (1.0 - nu * nu) * density * SPEED * SPEED / (8.0 * e);
    // s_r = E / (1 - nu^2) ((1 + nu) A - (1 - nu) B / r^2 - (3 + nu) c r^2).
    let m = nalgebra::Matrix2::new(a, 1.0 / a, 1.0 + nu, -(1.0 - nu) / (b * b));
    let [first, second]: [f64; 2] =
        m.try_inverse().map(|m| m * nalgebra::Vector2::new(c * a.powi(3), (3.0 + nu) * c * b * b)).unwrap().into();
    let stiff = e / (1.0 - nu * nu);
    let radial = stiff * ((1.0 + nu) * first - (1.0 - nu) * second / (r * r) - (3.0 + nu) * c * r * r);
    let hoop = stiff * ((1.0 + nu) * first + (1.0 - nu) * second / (r * r) - (1.0 + 3.0 * nu) * c * r * r);
    [1e3 * (first * r + second / r - c * r.powi(3)), radial, hoop]
}

/// The drum grows by its closed form, and the gap with it: by that less what the shoe, which moves along z, makes up for.
#[test]
fn a_drum_that_spins_grows_under_its_shoe() {
    let still = profile(solved(&scene("drum-brake-block", &SMOOTH)));
    let spins = profile(solved(&scene("drum-brake-block", &[&SMOOTH[..], &SPINS].concat())));
    let [grown, ..] = drum(200.0);
    assert!(grown > 10.0, "{grown}");
    // What the motion along z adds, from the middle.
    let middle = still.s.len() / 2;
    let moved = spins.gap[middle] - still.gap[middle] - grown;
    let along = |k: usize| still.normal[k][2] / still.normal[middle][2];
    for k in 0..still.s.len() {
        let normal = spins.normal_displacement[1][k] - still.normal_displacement[1][k];
        assert!((normal - grown).abs() < 1e-9 * grown, "{normal} {grown}");
        assert!((spins.normal_displacement[0][k] - still.normal_displacement[0][k]).abs() < 1e-9 * grown);
        let gap = spins.gap[k] - still.gap[k];
        assert!((gap - grown - moved * along(k)).abs() < 1e-9 * grown, "{gap} {grown} {moved}");
    }
    assert_eq!(spins.pressure, still.pressure);
}

#[test]
fn stresses_of_the_spin_along_a_radius_have_their_closed_form() {
    let path = "output.paths=[{ name = 'radius', body = 2, from = [-80, -60], to = [-160, -120], points = 11 }]";
    let found = |more: &[&str]| solved(&scene("drum-brake-block", &[&SMOOTH[..], &[path], more].concat())).paths.remove(0);
    let (still, spins) = (found(&[]), found(&SPINS));
    assert_eq!((spins.name.as_str(), spins.body, spins.s.len()), ("radius", 2, 11));
    for k in 0..11 {
        let r = 100.0 + spins.s[k];
        let [u, radial, hoop] = drum(r);
        let size = drum(100.0)[1];
        // Along (-0.8, -0.6).
        let (c, s) = (-0.8, -0.6);
        let more = |of: fn(&wearshape::Stress) -> f64| of(&spins.stress[k]) - of(&still.stress[k]);
        let [xx, zz, xz] = [more(|s| s.xx), more(|s| s.zz), more(|s| s.xz)];
        let along = |k: usize, i: usize| spins.displacement[k][i] - still.displacement[k][i];
        let found_u = 1e3 * (c * along(k, 0) + s * along(k, 2));
        assert!((found_u - u).abs() < 1e-8 * drum(200.0)[0], "{r}: {found_u} {u}");
        let found_r = c * c * xx + s * s * zz + 2.0 * s * c * xz;
        let found_t = s * s * xx + c * c * zz - 2.0 * s * c * xz;
        assert!(
            (found_r - radial).abs() < 1e-6 * size && (found_t - hoop).abs() < 1e-6 * size,
            "{r}: {found_r} {radial} {found_t} {hoop}"
        );
    }
}

/// All around the bore and half around the middle of the drum, anti-clockwise: one radial and one hoop stress each.
#[test]
fn stresses_of_the_spin_on_circles_have_their_closed_form() {
    let paths = "output.paths=[{ name = 'bore', body = 2, from = [60, 80], to = [60, 80], centre = [0, 0], points = 9 }, \
                 { name = 'half', body = 2, from = [150, 0], to = [-150, 0], centre = [0, 0], points = 7 }]";
    let found = |more: &[&str]| solved(&scene("drum-brake-block", &[&SMOOTH[..], &[paths], more].concat())).paths;
    let (still, spins) = (found(&[]), found(&SPINS));
    for (number, (r, turn)) in [(100.0, 2.0 * std::f64::consts::PI), (150.0, std::f64::consts::PI)].into_iter().enumerate() {
        let (still, spins) = (&still[number], &spins[number]);
        let ([_, radial, hoop], size) = (drum(r), drum(100.0)[1]);
        assert!((spins.s[spins.s.len() - 1] - r * turn).abs() < 1e-9, "{}", spins.s[spins.s.len() - 1]);
        for k in 0..spins.s.len() {
            let [x, z] = spins.position[k];
            let begins = if number == 0 { f64::atan2(80.0, 60.0) } else { 0.0 };
            let angle = begins + spins.s[k] / r;
            assert!((x - r * angle.cos()).abs() < 1e-9 && (z - r * angle.sin()).abs() < 1e-9, "{x} {z}");
            let (c, s) = (x / r, z / r);
            let more = |of: fn(&wearshape::Stress) -> f64| of(&spins.stress[k]) - of(&still.stress[k]);
            let [xx, zz, xz] = [more(|s| s.xx), more(|s| s.zz), more(|s| s.xz)];
            let [r_found, t_found] = [c * c * xx + s * s * zz + 2.0 * s * c * xz, s * s * xx + c * c * zz - 2.0 * s * c * xz];
            assert!(
                (r_found - radial).abs() < 1e-6 * size && (t_found - hoop).abs() < 1e-6 * size,
                "{x} {z}: {r_found} {t_found}"
            );
        }
    }
}

#[test]
fn the_proof_of_a_shape_under_spin_and_the_run_in_time_agree_with_it() {
    let settings = [&["accuracy=1e-4"][..], &SPINS].concat();
    let proved = solved(&scene("drum-brake-block", &settings)).shape.unwrap();
    assert!(proved.roundtrip_same.unwrap() < 1e-6 && proved.roundtrip_independent.unwrap() < 3e-2, "{proved:?}");
    // Bodies of revolution that both spin, one of them through a rigid edge.
    let spin = |body: usize| format!("body{body}.spin.omega='60000 rpm'");
    let dense = |body: usize| format!("body{body}.material={{ young = 210000, poisson = 0.3, density = '7850 kg/m3' }}");
    let settings = ["accuracy=1e-4".to_string(), dense(1), dense(2), spin(1), spin(2)];
    let settings: Vec<&str> = settings.iter().map(String::as_str).collect();
    let both = solved(&scene("annular-punch", &settings)).shape.unwrap();
    assert!(both.roundtrip_same.unwrap() < 1e-6 && both.roundtrip_independent.unwrap() < 3e-2, "{both:?}");
    // Worn from flat surfaces until it is steady: the pressure of the theory.
    let run = ["tasks=[wear]", "mesh.degree=4", "wear={ beta = [2e-4, 0] }", "body2.spin.omega=200"];
    let worn = profile(solved(&scene("drum-brake-block", &[&run[..], &SPINS[..1]].concat())));
    let steady = profile(solved(&scene(
        "drum-brake-block",
        &["tasks=[pressure,shape]", "check=false", "mesh.degree=4", "wear={ beta = [2e-4, 0] }"],
    )));
    let largest = steady.pressure.iter().copied().fold(0.0, f64::max);
    for (a, b) in worn.pressure.iter().zip(&steady.pressure) {
        assert!((a - b).abs() < 1e-3 * largest, "{a} {b}");
    }
}

#[test]
fn a_body_that_does_not_spin_is_untouched_by_its_density() {
    let dense = "body2.material={ young = 210000, poisson = 0.3, density = '7850 kg/m3' }";
    let problem = scene("drum-brake-block", &[dense]);
    assert_eq!(problem.unused_keys(), ["body2.material.density"]);
    // The density of a material by name is no part of a scene that does not need it.
    let named = scene("drum-brake-block", &["body2.material=steel"]);
    assert!(!named.resolved().contains("density"), "{}", named.resolved());
    let spins = scene("drum-brake-block", &["body2.material=steel", "body2.spin.omega='3000 rpm'"]);
    assert!(spins.resolved().contains("density") && spins.resolved().contains("centre = [0.0, 0.0]"), "{}", spins.resolved());
    assert_eq!(computed_from(&read(&spins.resolved(), &[])), computed_from(&spins));
    assert!(spins.unused_keys().is_empty());
    let pressure = scene("drum-brake-block", &["body2.material=steel", "body2.spin.omega='3000 rpm'", "tasks=[pressure]"]);
    assert!(pressure.unused_keys().contains(&"body2.spin".to_string()), "{:?}", pressure.unused_keys());
}

fn fault(name: &str, settings: &[&str]) -> Fault {
    let settings: Vec<String> = settings.iter().map(|s| s.to_string()).collect();
    let document = Document::read(name, builtin(name).unwrap().text, &settings).unwrap();
    Problem::new(&document, &|_| Err("no file".into())).and_then(|problem| problem.available()).unwrap_err()
}

#[test]
fn what_cannot_spin_is_refused_with_its_key() {
    let dense = |body: usize| format!("body{body}.material={{ young = 210000, poisson = 0.3, density = '7850 kg/m3' }}");
    for (name, settings, key, why) in [
        ("drum-brake-block", vec!["body2.spin.omega=10".to_string()], "body2.material.density", "is missing"),
        (
            "drum-brake-block",
            vec![dense(2), "body2.spin={ omega = 10, centre = [0, 1] }".into()],
            "body2.spin.centre",
            "1 mm off its centre of mass",
        ),
        ("drum-brake-block", vec![dense(1), "body1.spin.omega=10".into()], "body1.spin", "only a ring, a rectangle or cells"),
        (
            "annular-punch",
            vec![dense(1), "body1.spin={ omega = 10, centre = [0, 0] }".into()],
            "body1.spin.centre",
            "about its axis",
        ),
        ("hertz-sphere", vec![dense(1), "body1.spin.omega=10".into()], "body1.spin", "half-disc"),
        (
            "drum-brake-block",
            vec!["body2.material={ young = 210000, poisson = 0.3, density = -1 }".into(), "body2.spin.omega=10".into()],
            "body2.material.density",
            "negative density",
        ),
    ] {
        let settings: Vec<&str> = settings.iter().map(String::as_str).collect();
        let found = fault(name, &settings);
        assert_eq!(found.key.as_deref(), Some(key), "{settings:?}: {}", found.message);
        assert!(found.message.contains(why), "{settings:?}: {}", found.message);
    }
}
