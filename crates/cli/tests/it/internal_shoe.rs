//! A shoe inside its drum: balance, mirror images, a soft lining between stiff bodies, and the steady pressure from theory and from time.
//!
//! ```text
//!      \            /
//!    drum \__top__/        n points up, into the shoe; the bore moves towards +x under it
//!        \ \ shoe / /
//!          ' ---- '
//! ```

use approx::assert_relative_eq;
use serde_json::Value;

use crate::call::Bench;

/// Radius of the bore, mm, and half the angle of the shoe.
const RADIUS: f64 = 125.0;
const HALF: f64 = 40.0;

/// Runs the built-in scene with options; gives the summary and the columns.
fn run(bench: &Bench, options: &str) -> (Value, impl Fn(&str) -> Vec<f64> + use<>) {
    let call = bench.call(&format!("run internal-shoe {options} -q"));
    assert_eq!(call.code, 0, "{options}: {}{}", call.out, call.err);
    let table: Vec<Vec<String>> =
        bench.read("out/internal-shoe/contact.csv").lines().map(|line| line.split(',').map(str::to_string).collect()).collect();
    let column = move |name: &str| {
        let at = table[0].iter().position(|field| field == name).unwrap();
        table[1..].iter().map(|row| row[at].parse().unwrap()).collect::<Vec<f64>>()
    };
    (bench.summary("internal-shoe"), column)
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap()
}

#[test]
fn forces_and_moments_of_a_shoe_inside_its_drum_balance_to_round_off() {
    let bench = Bench::new();
    for (options, friction) in
        [("--set tasks=[contact] --set mesh.degree=6", 0.35), ("--set tasks=[shape] --set mesh.degree=6 --set check=false", 0.35)]
    {
        let (summary, column) = run(&bench, options);
        let [x, z, nx, nz] = ["x_mm", "z_mm", "nx", "nz"].map(&column);
        let [weight, pressure, shear] = ["weight_mm2", "pressure_MPa", "shear_MPa"].map(&column);
        let (mut force, mut moment) = ([0.0, 0.0], 0.0);
        for i in 0..x.len() {
            assert!((x[i] + RADIUS * nx[i]).abs() < 1e-9 && (z[i] + RADIUS * nz[i]).abs() < 1e-9, "n points to the centre");
            assert_relative_eq!(shear[i], friction * pressure[i], max_relative = 1e-12);
            // The drag is towards +x: n turned clockwise.
            let fx = weight[i] * (pressure[i] * nx[i] + shear[i] * nz[i]);
            let fz = weight[i] * (pressure[i] * nz[i] - shear[i] * nx[i]);
            force[0] += fx;
            force[1] += fz;
            moment += x[i] * fz - z[i] * fx;
        }
        let reaction = |edge: &str, key: &str| number(&summary["reactions"][edge][key]);
        assert_relative_eq!(force[1], 4000.0, max_relative = 1e-10);
        assert_relative_eq!(reaction("body2.outer", "z_N"), 4000.0, max_relative = 1e-10);
        assert_relative_eq!(reaction("body2.outer", "x_N"), force[0], max_relative = 1e-10);
        assert_relative_eq!(reaction("body1.left", "x_N") + reaction("body1.right", "x_N"), -force[0], max_relative = 1e-10);
        // All of the torque is carried by the rim; the guides hold the shoe against it.
        assert!(moment > 0.0);
        assert_relative_eq!(reaction("body2.outer", "moment_Nmm"), moment, max_relative = 1e-9);
        let guides = reaction("body1.left", "moment_Nmm") + reaction("body1.right", "moment_Nmm");
        assert_relative_eq!(guides, -moment, max_relative = 1e-9);
    }
}

#[test]
fn a_drum_that_turns_the_other_way_gives_the_mirror_image() {
    let bench = Bench::new();
    for task in ["contact", "shape"] {
        let options = format!("--set tasks=[{task}] --set mesh.degree=6 --set check=false --sample 41");
        let (_, one) = run(&bench, &options);
        let (_, other) = run(&bench, &format!("{options} --set sliding.omega=-10"));
        for name in ["s_mm", "pressure_MPa", "gap_um", "un1_um", "un2_um"] {
            let (a, mut b) = (one(name), other(name));
            b.reverse();
            let sign = if name == "s_mm" { -1.0 } else { 1.0 };
            let largest = a.iter().fold(1e-30_f64, |m, v| m.max(v.abs()));
            let off = a.iter().zip(&b).map(|(a, b)| (a - sign * b).abs()).fold(0.0, f64::max);
            assert!(off < 1e-8 * largest, "{task} {name}: {off:.2e} of {largest:.2e}");
        }
        let s = one("s_mm");
        assert!(s.windows(2).all(|pair| pair[0] < pair[1]) && one("x_mm")[40] > 0.0, "rows run towards +x");
    }
}

/// A thin soft layer between rigid bodies is pressed in proportion to the closing, which is the cosine of the angle from the bottom.
#[test]
fn a_soft_lining_between_stiff_bodies_is_pressed_like_the_cosine() {
    let bench = Bench::new();
    let soft = "--set body1.geometry.blocks.materials.lining.young=10 --set body1.geometry.blocks.materials.steel.young=1e8";
    let options = "--set tasks=[contact] --set contact.friction=0 --set mesh.degree=6 --sample 81";
    let (_, column) = run(&bench, &format!("{options} {soft} --set body2.material.young=1e8"));
    let (s, pressure) = (column("s_mm"), column("pressure_MPa"));
    for i in 0..81 {
        let angle = s[i] / RADIUS;
        if angle.to_degrees().abs() < 0.8 * HALF {
            assert_relative_eq!(pressure[i] / pressure[40], angle.cos(), max_relative = 1e-3);
        }
    }
}

#[test]
fn wear_arrives_at_the_root_of_the_cosine_and_at_the_shape_that_gives_it_back() {
    let bench = Bench::new();
    for b in [1.0, 2.0] {
        let sets = format!("--set wear.b={b} --set mesh.degree=8 --sample 41");
        let (summary, shape) = run(&bench, &format!("{sets} --set tasks=[shape]"));
        assert!(number(&summary["shape"]["roundtrip_independent"]) < 5e-4, "{}", summary["shape"]);
        assert_relative_eq!(
            number(&summary["reactions"]["body2.outer"]["moment_Nmm"]),
            number(&summary["pressure"]["torque_Nmm"]),
            max_relative = 1e-9
        );
        let (_, pressure) = run(&bench, &format!("{sets} --set tasks=[pressure]"));
        let (_, worn) = run(&bench, &format!("{sets} --set tasks=[wear]"));
        let middle = shape("pressure_MPa")[20];
        for (i, s) in shape("s_mm").iter().enumerate() {
            let wanted = middle * (s / RADIUS).cos().powf(1.0 / b);
            assert_relative_eq!(shape("pressure_MPa")[i], wanted, max_relative = 1e-10);
            assert_relative_eq!(pressure("pressure_MPa")[i], wanted, max_relative = 1e-10);
            assert_relative_eq!(worn("pressure_MPa")[i], wanted, max_relative = 1e-7);
            for name in ["s_mm", "x_mm", "z_mm", "nx", "nz"] {
                assert!((pressure(name)[i] - shape(name)[i]).abs() < 1e-9, "{name} of the bare surface");
            }
        }
        // The same shape up to the rigid closing.
        let mode: Vec<f64> = shape("s_mm").iter().map(|s| (s / RADIUS).cos()).collect();
        let (worn, direct) = (worn("gap_um"), shape("gap_um"));
        let off: Vec<f64> = worn.iter().zip(&direct).map(|(a, b)| a - b).collect();
        let share = off.iter().zip(&mode).map(|(d, c)| d * c).sum::<f64>() / mode.iter().map(|c| c * c).sum::<f64>();
        let largest = direct.iter().copied().fold(0.0, f64::max);
        let error = off.iter().zip(&mode).map(|(d, c)| (d - share * c).abs()).fold(0.0, f64::max) / largest;
        assert!(error < 1e-4, "b = {b}: {error:.2e}");
    }
}

#[test]
fn bodies_on_one_side_of_the_circle_and_a_shoe_above_the_middle_are_refused() {
    let bench = Bench::new();
    let scene = bench.call("new internal-shoe").out;
    bench.file(
        "around.toml",
        &scene
            .replace("\"inner\"], friction", "\"outer\"], friction")
            .replace("inner = 125, outer = 137", "inner = 100, outer = 125"),
    );
    let call = bench.call("check around.toml");
    assert_eq!(call.code, 2, "{}", call.out);
    assert!(call.err.contains("body 1 lies inside its circle, and body 2 inside its own"), "{}", call.err);
    bench.file("top.toml", &scene.replace("140 deg", "40 deg").replace("220 deg", "-40 deg").replace(", -60]", ", 60]"));
    let call = bench.call("check top.toml");
    assert_eq!(call.code, 2, "{}", call.out);
    assert!(call.err.contains("must stay below its middle") && call.err.contains("remedy: "), "{}", call.err);
}
