//! Orthotropic materials in scenes.

use wearshape::{Document, Fault, Problem, Profile, builtin};

use crate::common::{digits, read, scene, solved};

/// A lining, MPa: Young's moduli, Poisson's ratios, shear modulus in the plane.
const LINING: &str = "{ young = [8000, 1500, 3000], poisson = [0.3, 0.2, 0.1], shear = 700";

fn profile(problem: &Problem) -> Profile {
    let solution = solved(problem);
    assert!(solution.reason.is_none(), "{:?}", solution.reason);
    solution.profile.unwrap()
}

fn fault(name: &str, settings: &[&str]) -> Fault {
    let settings: Vec<String> = settings.iter().map(|s| s.to_string()).collect();
    let document = Document::read(name, builtin(name).unwrap().text, &settings).unwrap();
    Problem::new(&document, &|_| Err("no file".into())).unwrap_err()
}

#[test]
fn an_isotropic_material_written_by_its_axes_gives_the_same_digits() {
    // G = E / (2 (1 + nu)) in floating point.
    let shear = 0.5 * 8e3 / (1.0 + 0.25);
    let coarse = ["tasks=[pressure,shape]", "mesh.degree=6", "check=false"];
    for (name, kinematics) in [("drum-brake-block", "plane-stress"), ("translating-punch", "plane-strain")] {
        let own = |material: &str| {
            let (material, kinematics) = (format!("body1.material={material}"), format!("kinematics={kinematics}"));
            digits(&solved(&scene(name, &[&coarse[..], &[&material, &kinematics]].concat())))
        };
        let isotropic = own("{ young = 8000, poisson = 0.25 }");
        let by_axes =
            own(&format!("{{ young = [8000, 8000, 8000], poisson = [0.25, 0.25, 0.25], shear = {shear:?}, angle = 0.7 }}"));
        assert_eq!(isotropic, by_axes, "{name}");
    }
}

/// ```text
///     p p p p p
///    +---------+    Body 1 is held on its left along x, at all heights, so that it cannot turn. Under a uniform pressure without
///  x||  fibres |    friction both bodies are uniformly strained: u_x = e_xx (x + 30) and u_z = e_zz z + g_xz x in body 1, and
///    +---------+    the side carries nothing.
///  x|| steel   |
///    +---------+
/// ```
const BLOCKS: &str = r#"
units = "N-mm"
kinematics = "KINEMATICS"
thickness = 10
tasks = ["pressure", "shape"]
mesh = { degree = 4, layers = 2 }
check = false
body1.material = { young = [8000, 1500, 3000], poisson = [0.3, 0.2, 0.1], shear = 700, angle = ANGLE }
body1.geometry.rectangle = { x = [-30, 30], z = [0, 40] }
body1.support = { left = ["x"] }
body2.material = { young = "210 GPa", poisson = 0.3 }
body2.geometry.rectangle = { x = [-30, 30], z = [-40, 0] }
body2.support = { bottom = ["z"], left = ["x"] }
contact = { edges = ["bottom", "top"], friction = 0, gap = 0 }
load = { edge = "top", as = "pressure", force = 6000 }
wear = { k = 1e-8 }
optimum = { functional = "uniform" }
"#;

/// Strains `[e_xx, g_xz]` of the lining under a pressure p along z, by its axes (Lekhnitskii 1968, sec. 4).
fn strained(pressure: f64, angle: f64, plane_strain: bool) -> [f64; 2] {
    let (young, [nu12, nu13, nu23], shear) = ([8e3, 1.5e3, 3e3], [0.3, 0.2, 0.1], 700.0);
    let (s, c) = angle.sin_cos();
    let [s1, s2, s12] = [-pressure * s * s, -pressure * c * c, -pressure * s * c];
    let s3 = if plane_strain { young[2] * (nu13 / young[0] * s1 + nu23 / young[1] * s2) } else { 0.0 };
    let e1 = (s1 - nu12 * s2 - nu13 * s3) / young[0];
    let e2 = s2 / young[1] - nu12 / young[0] * s1 - nu23 / young[1] * s3;
    let g12 = s12 / shear;
    [c * c * e1 + s * s * e2 - s * c * g12, 2.0 * s * c * (e1 - e2) + (c * c - s * s) * g12]
}

#[test]
fn a_uniform_pressure_strains_a_lining_by_its_turned_compliance() {
    for (kinematics, angle) in
        [("plane-stress", 0.0), ("plane-stress", 0.35), ("plane-stress", 2.1), ("plane-strain", 0.35), ("plane-strain", -0.8)]
    {
        let found = profile(&read(&BLOCKS.replace("KINEMATICS", kinematics).replace("ANGLE", &format!("{angle:?}")), &[]));
        let [along, shear] = strained(10.0, angle, kinematics == "plane-strain");
        let last = found.s.len() - 1;
        let size = 1e3 * 60.0 * (along.abs() + shear.abs());
        for row in 0..=last {
            let x = found.s[row] - found.s[0];
            let stretch = found.tangential_displacement[0][row] - found.tangential_displacement[0][0];
            assert!((stretch - 1e3 * along * x).abs() < 1e-10 * size, "{kinematics} {angle}: {stretch} {}", 1e3 * along * x);
            let tilt = found.gap[row] - found.gap[0];
            assert!((tilt + 1e3 * shear * x).abs() < 1e-10 * size, "{kinematics} {angle}: {tilt} {}", -1e3 * shear * x);
        }
        assert!(found.gap.iter().copied().fold(f64::INFINITY, f64::min).abs() < 1e-9 * size);
    }
}

/// The scene seen in a mirror: fibres, sliding and moment change sign.
#[test]
fn a_mirrored_scene_has_the_mirrored_shape() {
    let base = ["tasks=[pressure,shape]", "mesh.degree=6", "check=false", "load.moment=0"];
    let shape = |angle: f64, speed: f64| {
        let material = format!("body1.material={LINING}, angle = {angle:?} }}");
        let speed = format!("sliding.speed={speed:?}");
        profile(&scene("translating-punch", &[&base[..], &[&material, &speed]].concat()))
    };
    // Bowed off the line through the first and the last point: where the lowest gap touches is sampled, and leaves the tilt less sure.
    let bow = |profile: &Profile| -> Vec<f64> {
        let (s, g, last) = (&profile.s, &profile.gap, profile.s.len() - 1);
        let line = |s: f64| g[0] + (g[last] - g[0]) * (s + 30.0) / 60.0;
        s.iter().zip(g).map(|(s, g)| g - line(*s)).collect()
    };
    let [one, other, turned] = [(0.35, 5.0), (-0.35, -5.0), (-0.35, 5.0)].map(|(angle, speed)| bow(&shape(angle, speed)));
    let largest = one.iter().fold(0.0_f64, |m, g| m.max(g.abs()));
    assert!(largest > 1e-2, "{largest}");
    for (a, b) in one.iter().zip(other.iter().rev()) {
        assert!((a - b).abs() < 1e-9 * largest, "{a} {b}");
    }
    // The fibres count: turned the other way, the shape is another one.
    assert!(one.iter().zip(&turned).any(|(a, b)| (a - b).abs() > 1e-2 * largest));
}

#[test]
fn axes_turned_by_a_quarter_are_the_other_axes() {
    let base = ["tasks=[pressure,shape]", "mesh.degree=6", "check=false"];
    let shape =
        |material: &str| profile(&scene("drum-brake-block", &[&base[..], &[&format!("body1.material={material}")]].concat()));
    let one = shape(&format!("{LINING}, angle = '90 deg' }}"));
    // nu_21 = nu_12 E_2 / E_1, and the pairs 13 and 23 change places.
    let other = shape("{ young = [1500, 8000, 3000], poisson = [0.05625, 0.1, 0.2], shear = 700 }");
    let largest = one.gap.iter().fold(0.0_f64, |m, g| m.max(*g));
    for (a, b) in one.gap.iter().zip(&other.gap) {
        assert!((a - b).abs() < 1e-9 * largest, "{a} {b}");
    }
}

#[test]
fn the_proof_of_a_lining_gives_its_pressure_back() {
    let material = format!("body1.material={LINING}, angle = '25 deg' }}");
    let solution = solved(&scene("drum-brake-block", &["accuracy=1e-4", &material]));
    let shape = solution.shape.unwrap();
    assert!(shape.roundtrip_same.unwrap() < 1e-6 && shape.roundtrip_independent.unwrap() < 1e-2, "{shape:?}");
}

#[test]
fn a_lining_of_cells_on_its_steel_back_is_graded_where_both_end() {
    let own = format!("body1.geometry.blocks.materials.lining={LINING}, angle = '25 deg' }}");
    let solution = solved(&scene("lining-on-back", &["accuracy=1e-3", &own]));
    let shape = solution.shape.unwrap();
    assert!(shape.roundtrip_same.unwrap() < 1e-6 && shape.roundtrip_independent.unwrap() < 3e-2, "{shape:?}");
    // An isotropic lining written by its axes: the same digits.
    let lining = |material: &str| {
        let own = format!("body1.geometry.blocks.materials.lining={material}");
        digits(&solved(&scene("lining-on-back", &["tasks=[pressure,shape]", "mesh.degree=4", "check=false", &own])))
    };
    let shear = 0.5 * 8e3 / (1.0 + 0.25);
    let by_axes = lining(&format!("{{ young = [8000, 8000, 8000], poisson = [0.25, 0.25, 0.25], shear = {shear:?} }}"));
    assert_eq!(lining("{ young = 8000, poisson = 0.25 }"), by_axes);
}

#[test]
fn the_resolved_scene_has_the_axes() {
    let problem = scene("drum-brake-block", &[&format!("body1.material={LINING}, angle = '90 deg' }}")]);
    let text = problem.resolved();
    let again = read(&text, &[]);
    assert_eq!(again.resolved(), text);
    assert!(text.contains("young = [8000.0, 1500.0, 3000.0]") && text.contains("shear = 700.0"), "{text}");
}

#[test]
fn numbers_that_no_material_has_are_refused_with_their_key() {
    for (material, key, why) in [
        ("{ young = [8000, 1500, 3000], poisson = 0.3, shear = 700 }", ".poisson", "by one number"),
        ("{ young = 8000, poisson = [0.3, 0.2, 0.1], shear = 700 }", ".young", "by one number"),
        ("{ young = [8000, 1500, 3000], poisson = [0.3, 0.2, 0.1] }", ".shear", "`body1.material.shear` is missing"),
        ("{ young = 8000, poisson = 0.3, shear = 700 }", ".shear", "has no `shear`"),
        ("{ young = 8000, poisson = 0.3, angle = 0.1 }", ".angle", "has no `angle`"),
        ("{ young = [8000, -1500, 3000], poisson = [0.3, 0.2, 0.1], shear = 700 }", ".young.1", "negative Young's modulus"),
        ("{ young = [8000, 1500, 3000], poisson = [0.3, 0.2, 0.1], shear = [700, 0, 500] }", ".shear.1", "zero shear modulus"),
        (
            "{ young = [8000, 1500, 3000], poisson = [2.4, 0.2, 0.1], shear = 700 }",
            ".poisson.0",
            "nu12 = 2.4 is not below sqrt(E1/E2) = 2.309401",
        ),
        ("{ young = [8000, 8000, 8000], poisson = [0.9, 0.9, 0.9], shear = 700 }", ".poisson", "not positive definite"),
    ] {
        let found = fault("translating-punch", &[&format!("body1.material={material}")]);
        assert_eq!(found.key.as_deref(), Some(format!("body1.material{key}").as_str()), "{material}");
        assert!(found.message.contains(why), "{material}: {}", found.message);
    }
}

#[test]
fn axes_that_do_not_stand_still_or_have_no_symmetry_are_refused() {
    let turned = format!("{LINING}, angle = '20 deg' }}");
    let found = fault("drum-brake-block", &[&format!("body2.material={turned}")]);
    assert_eq!((found.code, found.key.as_deref()), ("not-available", Some("body2.material")));
    assert!(found.message.contains("body 2 turns"), "{}", found.message);
}
