//! The round contacts through the program, against finite-body reference values and the formulas of Hertz, Cattaneo and Mindlin.

use approx::{assert_abs_diff_eq, assert_relative_eq};
use serde_json::Value;

use crate::call::{Bench, Call};

const PI: f64 = std::f64::consts::PI;

/// A run into the folder x.
fn start(bench: &Bench, args: &str) -> Call {
    bench.call_with(&["run"].into_iter().chain(args.split(' ')).chain(["-q", "-o", "x"]).collect::<Vec<_>>())
}

fn run(bench: &Bench, args: &str) -> Value {
    let call = start(bench, args);
    assert_eq!(call.code, 0, "{args}: {}", call.err);
    serde_json::from_str(&bench.read("x/summary.json")).unwrap()
}

fn number(summary: &Value, key: &str) -> f64 {
    summary["contact"][key].as_f64().unwrap_or_else(|| panic!("no {key} in {summary}"))
}

fn last(summary: &Value, key: &str) -> f64 {
    summary["contact"][key][1].as_f64().unwrap_or_else(|| panic!("no {key} in {summary}"))
}

/// Half length and highest pressure of a cylinder of radius R pressed by F a mm on a half-plane (Johnson 1985, sec. 4.2).
fn line(force: f64, radius: f64, modulus: f64) -> (f64, f64) {
    let end = (4.0 * force * radius / (PI * modulus)).sqrt();
    (end, 2.0 * force / (PI * end))
}

/// A column of the contact table.
fn column(bench: &Bench, name: &str) -> Vec<f64> {
    let table = bench.read("x/contact.csv");
    let mut lines = table.lines();
    let at = lines.next().unwrap().split(',').position(|column| column == name).unwrap();
    lines.map(|line| line.split(',').nth(at).unwrap().parse().unwrap()).collect()
}

#[test]
fn the_cylinder_of_nafems_r94_has_the_finite_body_end_of_contact_and_pressure() {
    let bench = Bench::new();
    let summary = run(&bench, "hertz-cylinder");
    // For the finite bodies of the scene a = 6.20119(1), p0 = 3586.190, as in verify/known.toml.
    assert_abs_diff_eq!(last(&summary, "ends_mm"), 6.20119, epsilon = 1e-5);
    assert_relative_eq!(number(&summary, "p_max_MPa"), 3586.190, max_relative = 1e-6);
    assert_eq!(summary["contact"]["ends_mm"][0].as_f64().unwrap(), -last(&summary, "ends_mm"));
    assert_relative_eq!(number(&summary, "force_N"), 35e3, max_relative = 1e-9);
    assert!(summary["error"]["pressure_relative"].as_f64().unwrap() <= 1e-6);
    assert!(summary["contact"]["iterations"].as_u64().unwrap() <= 30);
    let (weight, pressure) = (column(&bench, "weight_mm2"), column(&bench, "pressure_MPa"));
    let carried: f64 = weight.iter().zip(&pressure).map(|(w, p)| w * p).sum();
    assert_relative_eq!(carried, 35e3, max_relative = 1e-9);
    let gap = column(&bench, "opening_um");
    assert!(gap.iter().zip(&pressure).all(|(g, p)| *p >= 0.0 && *g >= 0.0 && p.min(*g) < 1e-6));
}

#[test]
fn at_a_hundredth_of_the_load_the_cylinder_is_within_its_finite_body_deviation_of_hertz() {
    let summary = run(&Bench::new(), "hertz-cylinder --set load.force=350 --set accuracy=1e-7");
    let (end, highest) = line(350.0, 50.0, 1.0 / (0.91 / 210e3 + 0.91 / 70e3));
    assert_abs_diff_eq!(last(&summary, "ends_mm") / end - 1.0, -2.145e-5, epsilon = 2e-7);
    assert_abs_diff_eq!(number(&summary, "p_max_MPa") / highest - 1.0, 2.14e-6, epsilon = 1e-6);
}

#[test]
fn the_ball_approaches_hertz_as_the_load_falls() {
    let deviation = |force: f64| {
        let summary = run(&Bench::new(), &format!("hertz-sphere --set load.force={force}"));
        let end = (0.75 * force * 5.0 * 1.82 / 2.1e5).cbrt();
        let highest = 1.5 * force / (PI * end * end);
        assert_eq!(summary["contact"]["ends_mm"][0].as_f64().unwrap(), 0.0);
        [last(&summary, "ends_mm") / end - 1.0, number(&summary, "p_max_MPa") / highest - 1.0].map(f64::abs)
    };
    let (large, small) = (deviation(21.0), deviation(0.021));
    // Measured: a tenth of the contact length leaves a seventh of the deviation of the end, a ninth of that of the pressure.
    assert!(large[0] < 2e-4 && large[1] < 5e-4, "{large:?}");
    assert!(small[0] < 0.2 * large[0] && small[1] < 0.2 * large[1], "{small:?} {large:?}");
}

#[test]
fn the_sheared_cylinder_sticks_inside_and_slips_outside_as_cattaneo_and_mindlin_found() {
    let (friction, modulus) = (0.3, 72.1e3 / (2.0 * (1.0 - 0.33 * 0.33)));
    let deviation = |scale: f64| {
        let (normal, shear) = (135.75 * scale, 38.75 * scale);
        let bench = Bench::new();
        let summary = run(&bench, &format!("cattaneo-mindlin --set load.force={normal} --set load.shear_force={shear}"));
        let stick = (1.0 - shear / (friction * normal)).sqrt();
        let highest = friction * line(normal, 10.0, modulus).1 * (1.0 - stick * stick).sqrt();
        let [weight, pressure, q] = ["weight_mm2", "pressure_MPa", "shear_MPa"].map(|name| column(&bench, name));
        let carried: f64 = weight.iter().zip(&q).map(|(w, q)| w * q).sum();
        assert_relative_eq!(carried, shear, max_relative = 1e-9);
        let limit = |p: &f64| friction * p + 1e-9 * highest;
        assert!(q.iter().zip(&pressure).all(|(q, p)| q.abs() <= limit(p)));
        let ratio = last(&summary, "stick_ends_mm") / last(&summary, "ends_mm");
        [ratio / stick - 1.0, number(&summary, "q_max_MPa") / highest - 1.0].map(f64::abs)
    };
    let (large, small) = (deviation(1.0), deviation(0.01));
    assert!(large[0] < 0.03 && large[1] < 0.03, "{large:?}");
    assert!(small[0] < 1e-3 && small[1] < 1e-3, "{small:?}");
    assert!(small[0] < large[0], "{small:?} {large:?}");
}

#[test]
fn evenly_spaced_points_carry_the_force_with_their_trapezoid_weights() {
    let bench = Bench::new();
    run(&bench, "hertz-cylinder --sample 2001");
    let [s, weight, pressure] = ["s_mm", "weight_mm2", "pressure_MPa"].map(|name| column(&bench, name));
    assert_eq!(s.len(), 2001);
    assert!(s.windows(2).all(|pair| pair[1] > pair[0]) && s[0] == -s[2000]);
    let carried: f64 = weight.iter().zip(&pressure).map(|(w, p)| w * p).sum();
    assert_relative_eq!(carried, 35e3, max_relative = 1e-4);
}

#[test]
fn what_a_half_disc_cannot_do_is_refused_by_name() {
    let bench = Bench::new();
    for (args, word) in [
        ("hertz-cylinder --set tasks=[contact,wear] --set sliding.speed=1 --set wear.k=1e-7", "wear"),
        ("hertz-cylinder --set body2.geometry.rectangle.x=[-100,90]", "symmetric"),
        ("cattaneo-mindlin --set contact.friction=0", "friction"),
    ] {
        let call = start(&bench, args);
        assert_eq!(call.code, 2, "{args}: {}", call.out);
        assert!(call.err.contains(word), "{args}: {}", call.err);
    }
    for (args, word) in
        [("cattaneo-mindlin --set load.shear_force=41", "friction"), ("hertz-cylinder --set load.force=1e7", "reaches")]
    {
        let call = start(&bench, args);
        assert_eq!(call.code, 1, "{args}: {}", call.err);
        assert!(bench.read("x/summary.json").contains("refused") && bench.read("x/summary.json").contains(word), "{args}");
    }
}

/// Bodies of unlike materials stick further on one side: no single place is the end of stick, and the answer says where the outermost points
/// stick instead of being refused.
#[test]
fn a_sheared_cylinder_on_an_unlike_block_sticks_further_on_one_side() {
    let bench = Bench::new();
    let args = "cattaneo-mindlin --set body2.material.poisson=0 --set contact.friction=0.6 --set mesh={degree=6,layers=6}";
    let contact = &run(&bench, args)["contact"];
    let places = |key: &str| contact[key].as_array().unwrap().iter().map(|v| v.as_f64().unwrap()).collect::<Vec<f64>>();
    let (ends, stick) = (places("ends_mm"), places("stick_ends_mm"));
    assert!(stick.len() == 2 && (stick[0] + stick[1]).abs() > 0.01 * ends[1], "{contact}");
    assert!(stick[0] > ends[0] && stick[1] < ends[1], "{contact}");
}

/// Pressures at the same places, from near the middle to near the end of contact, and the error that is told of them.
fn inner_pressures(bench: &Bench, args: &str) -> (Vec<f64>, f64) {
    let summary = run(bench, args);
    let curves: Value = serde_json::from_str(&bench.read("x/plots/curves.json")).unwrap();
    let pressure = &curves.as_array().unwrap().iter().find(|curve| curve["file"] == "pressure").unwrap()["chart"]["series"][0];
    let [x, y] = ["x", "y"].map(|of| pressure[of].as_array().unwrap().iter().map(|v| v.as_f64().unwrap()).collect::<Vec<_>>());
    let inside = x.iter().zip(&y).filter(|(x, _)| x.abs() < 0.95 * last(&summary, "ends_mm")).map(|(_, y)| *y);
    (inside.collect(), summary["error"]["pressure_relative"].as_f64().unwrap())
}

/// At a rough accuracy levels have their nodes equally far from the ends of contact: the difference of levels is a quarter of the error.
#[test]
fn the_error_told_counts_what_nodes_are_off_by_from_the_ends_of_contact() {
    let bench = Bench::new();
    let (exact, _) = inner_pressures(&bench, "cattaneo-mindlin --set accuracy=1e-6");
    let (rough, told) = inner_pressures(&bench, "cattaneo-mindlin --set accuracy=1e-3");
    assert!(exact.len() == rough.len() && exact.len() > 40, "{} {}", exact.len(), rough.len());
    let norm = |values: &mut dyn Iterator<Item = f64>| values.map(|v| v * v).sum::<f64>().sqrt();
    let off = norm(&mut rough.iter().zip(&exact).map(|(a, b)| a - b)) / norm(&mut exact.iter().copied());
    println!("told {told:.2e}, off by {off:.2e}");
    assert!(off < 1.5 * told && told < 1e-4, "told {told:.2e}, off by {off:.2e}");
}
