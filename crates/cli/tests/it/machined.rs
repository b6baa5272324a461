//! The surface to machine: its points, its spline and its drawing say the same.

use crate::call::Bench;

/// Numbers after a group code of a DXF text between two marks, in order.
fn groups(text: &str, code: &str) -> Vec<f64> {
    let lines: Vec<&str> = text.lines().map(str::trim).collect();
    lines.chunks(2).filter(|pair| pair[0] == code).map(|pair| pair[1].parse().unwrap()).collect()
}

/// A point of a cubic B-spline (de Boor).
fn de_boor(knots: &[f64], points: &[[f64; 2]], t: f64) -> [f64; 2] {
    let k = knots.partition_point(|u| *u <= t).clamp(4, points.len()) - 1;
    let mut d: Vec<[f64; 2]> = points[k - 3..=k].to_vec();
    for r in 1..=3 {
        for j in (r..=3).rev() {
            let (a, b) = (knots[j + k - 3], knots[j + 1 + k - r]);
            let w = (t - a) / (b - a);
            d[j] = [0, 1].map(|c| (1.0 - w) * d[j - 1][c] + w * d[j][c]);
        }
    }
    d[3]
}

#[test]
fn the_drawing_and_the_cubic_pieces_are_the_computed_shape_within_a_nanometre_thousandth() {
    let bench = Bench::new();
    for (scene, level) in [("drum-brake-block", "6"), ("annular-punch", "6")] {
        let call = bench.call(&format!("run {scene} -q --set mesh.degree={level} --set check=false"));
        assert_eq!(call.code, 0, "{}", call.err);
        let table = |name: &str| -> Vec<Vec<f64>> {
            let text = bench.read(&format!("out/{scene}/{name}"));
            text.lines().skip(1).map(|row| row.split(',').map(|word| word.parse().unwrap()).collect()).collect()
        };
        let (points, pieces) = (table("profile.csv"), table("profile-spline.csv"));
        let drawing = bench.read(&format!("out/{scene}/profile.dxf"));
        let spline = drawing.split_once("SPLINE").unwrap().1.split_once("POINT").unwrap().0;
        let spline = spline.split_once('\n').unwrap().1;
        let (knots, x, z) = (groups(spline, "40"), groups(spline, "10"), groups(spline, "20"));
        assert_eq!(knots.len(), x.len() + 4);
        let control: Vec<[f64; 2]> = x.iter().zip(&z).map(|(x, z)| [*x, *z]).collect();
        assert_eq!(points.len(), 1001);
        for row in &points {
            let [s, x, z, gap, a, b, nx, nz] = row[..] else { panic!("{row:?}") };
            // Finished = nominal + gap along the normal.
            approx::assert_abs_diff_eq!(x, a + 1e-3 * gap * nx, epsilon = 1e-12);
            approx::assert_abs_diff_eq!(z, b + 1e-3 * gap * nz, epsilon = 1e-12);
            let drawn = de_boor(&knots, &control, s - points[0][0]);
            assert!((drawn[0] - x).abs() < 1e-9 && (drawn[1] - z).abs() < 1e-9, "{drawn:?} is not {x}, {z} at {s}");
            let piece = pieces.iter().find(|piece| s <= piece[1]).unwrap();
            let d = s - piece[0];
            let value = |k: usize| piece[k] + d * (piece[k + 1] + d * (piece[k + 2] + d * piece[k + 3]));
            assert!((value(2) - x).abs() < 1e-9 && (value(6) - z).abs() < 1e-9 && (value(10) - 1e-3 * gap).abs() < 1e-9);
        }
        let largest = points.iter().map(|row| row[3]).fold(0.0, f64::max);
        let crown = bench.summary(scene)["shape"]["crown_um"].as_f64().unwrap();
        approx::assert_relative_eq!(largest, crown, max_relative = 1e-3);
    }
}

#[test]
fn without_a_shape_there_is_nothing_to_machine() {
    let bench = Bench::new();
    assert_eq!(bench.call("run drum-brake-block -q --set tasks=[pressure]").code, 0);
    for name in ["profile.csv", "profile-spline.csv", "profile.dxf"] {
        assert!(!bench.path(&format!("out/drum-brake-block/{name}")).exists());
    }
}

#[test]
fn a_shape_that_is_refused_is_offered_to_no_machine() {
    let bench = Bench::new();
    let run = "run drum-brake-hot -q --set mesh.degree=6 --set mesh.layers=5";
    let machined = || {
        ["profile.csv", "profile-spline.csv", "profile.dxf"]
            .map(|name| bench.path(&format!("out/drum-brake-hot/{name}")).exists())
    };
    for (omega, code, to_machine) in [("20", 1, false), ("1", 0, true)] {
        let call = bench.call(&format!("{run} --set sliding.omega={omega}"));
        assert_eq!(call.code, code, "{}{}", call.out, call.err);
        assert_eq!(machined(), [to_machine; 3], "{omega}");
        let (summary, page) = (bench.summary("drum-brake-hot"), bench.read("out/drum-brake-hot/report.html"));
        assert!(summary["shape"]["gap_max_um"].is_number() && bench.path("out/drum-brake-hot/contact.csv").exists());
        assert_eq!(page.contains("must not be machined"), !to_machine, "{omega}");
        assert_eq!(page.contains("profile.csv"), to_machine, "{omega}");
        assert_eq!(page.contains("<h2>Tolerance</h2>"), to_machine, "{omega}");
        let ran =
            |name: &str| summary["stages"].as_array().unwrap().iter().any(|stage| stage["name"] == name && stage["ran"] == true);
        assert_eq!(["machined profile", "round trip"].map(ran), [to_machine; 2], "{omega}");
    }
}

#[test]
fn the_surface_to_machine_is_as_long_as_the_contact_whatever_radius_body_1_is_drawn_with() {
    let bench = Bench::new();
    let name = "drum-brake-block";
    for radius in [200, 220, 250] {
        let fixed = "--set mesh.degree=4 --set check=false";
        let call = bench.call(&format!("run {name} -q --force --set body1.geometry.shoe-block.radius={radius} {fixed}"));
        assert_eq!(call.code, 0, "{}", call.err);
        let ends = |file: &str| -> [Vec<f64>; 2] {
            let text = bench.read(&format!("out/{name}/{file}"));
            let rows: Vec<&str> = text.lines().skip(1).collect();
            [rows[0], rows[rows.len() - 1]].map(|row| row.split(',').map(|word| word.parse().unwrap_or(f64::NAN)).collect())
        };
        // Arc length, place and gap of both ends.
        for (machined, touching) in ends("profile.csv").iter().zip(&ends("contact.csv")) {
            let [machined, touching] = [[0, 4, 5, 3].map(|k| machined[k]), [0, 1, 3, 11].map(|k| touching[k])];
            machined.iter().zip(touching).for_each(|(m, t)| approx::assert_abs_diff_eq!(*m, t, epsilon = 1e-9));
        }
        let summary = bench.summary(name);
        let largest = summary["shape"]["gap_max_um"].as_f64().unwrap();
        let verdict = summary["verdict"].as_str().unwrap();
        assert!(verdict.contains(&format!("take off most, {largest:.3} um")), "{verdict} {largest}");
        let noted = summary["lints"].to_string().contains("other-radius");
        assert_eq!(noted, radius != 200, "{}", summary["lints"]);
    }
}
