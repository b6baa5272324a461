//! Displacement and stress inside the bodies: right on the contact surface, and left out unless asked for.

use base64::Engine;

use crate::call::{Bench, files};

/// Numbers of an array of a VTU file.
pub(crate) fn array(text: &str, name: &str) -> Vec<f64> {
    bytes(text, name).chunks(8).map(|chunk| f64::from_le_bytes(chunk.try_into().unwrap())).collect()
}

/// Bytes of an array of a VTU file.
fn bytes(text: &str, name: &str) -> Vec<u8> {
    let start = text.find(&format!("Name=\"{name}\"")).unwrap();
    let body = text[start..].split_once('>').unwrap().1.split_once('<').unwrap().0;
    let bytes = base64::engine::general_purpose::STANDARD.decode(body).unwrap();
    let (head, rest) = bytes.split_at(8);
    assert_eq!(u64::from_le_bytes(head.try_into().unwrap()) as usize, rest.len());
    rest.to_vec()
}

#[test]
fn without_fields_nothing_is_recovered_and_no_file_appears() {
    let bench = Bench::new();
    for scene in ["drum-brake-block", "hertz-cylinder"] {
        assert_eq!(bench.call(&format!("run {scene} -q --set mesh.degree=4")).code, 0);
        assert!(!bench.path(&format!("out/{scene}/fields")).exists());
        let without = bench.summary(scene);
        assert_eq!(without["counters"]["back_substitutions"], 0);
        let times = bench.read(&format!("out/{scene}/timing.json"));
        assert!(!times.contains("field recovery"), "{times}");
        assert_eq!(bench.call(&format!("run {scene} -q --set mesh.degree=4 --set output.fields=true")).code, 0);
        let with = bench.summary(scene);
        assert_eq!(with["counters"]["back_substitutions"], 2);
        assert_eq!(with["counters"]["factorisations"].as_u64(), without["counters"]["factorisations"].as_u64().map(|n| n + 2));
        assert_eq!(with["shape"], without["shape"]);
        let found = files(&bench.path(&format!("out/{scene}/fields")));
        assert_eq!(found, ["body1.lagrange.vtu", "body1.vtu", "body2.lagrange.vtu", "body2.vtu", "fields.pvd"]);
    }
}

#[test]
fn the_stress_along_the_normal_is_minus_the_pressure_on_the_shaped_contact() {
    let bench = Bench::new();
    let call = bench.call("run drum-brake-block -q --sample 2001 --set output.fields=true --set mesh.degree=10");
    assert_eq!(call.code, 0, "{}", call.err);
    let table = bench.read("out/drum-brake-block/contact.csv");
    let rows: Vec<Vec<f64>> =
        table.lines().skip(1).map(|row| row.split(',').take(20).map(|word| word.parse().unwrap()).collect()).collect();
    for (number, column) in [(1, 14), (2, 15)] {
        let text = bench.read(&format!("out/drum-brake-block/fields/body{number}.vtu"));
        let (place, u) = (array(&text, "position_mm"), array(&text, "displacement_mm"));
        let [x, z, t] = ["sigma_x_MPa", "sigma_z_MPa", "tau_xz_MPa"].map(|name| array(&text, name));
        let largest = rows.iter().map(|row| row[column].abs()).fold(0.0, f64::max);
        let mut seen = 0;
        for (i, at) in place.chunks(3).enumerate() {
            let s = 200.0 * at[0].atan2(at[2]);
            let inner = 0.8 * rows[2000][0];
            if (at[0].hypot(at[2]) - 200.0).abs() > 1e-9 || s.abs() > inner {
                continue;
            }
            let share = (s - rows[0][0]) / (rows[2000][0] - rows[0][0]) * 2000.0;
            let (below, part) = (share.floor() as usize, share.fract());
            let value = |k: usize| (1.0 - part) * rows[below][k] + part * rows[(below + 1).min(2000)][k];
            let n = [at[0] / 200.0, at[2] / 200.0];
            let normal = x[i] * n[0] * n[0] + 2.0 * t[i] * n[0] * n[1] + z[i] * n[1] * n[1];
            approx::assert_relative_eq!(normal, -value(8), max_relative = 1e-4);
            let along = 1e3 * (u[3 * i] * n[0] + u[3 * i + 2] * n[1]);
            approx::assert_abs_diff_eq!(along, value(column), epsilon = 1e-6 * largest);
            seen += 1;
        }
        assert!(seen >= 20, "{seen}");
    }
}

#[test]
fn a_wear_run_writes_its_start_and_its_end() {
    let bench = Bench::new();
    let call = bench.call("run punch-wear -q --set output.fields=true --set mesh.degree=4 --set mesh.layers=3");
    assert_eq!(call.code, 0, "{}", call.err);
    let series = bench.read("out/punch-wear/fields/fields.pvd");
    let time = bench.summary("punch-wear")["wear"]["time_s"].as_f64().unwrap();
    for file in [
        "timestep=\"0\" group=\"\" part=\"0\" name=\"body1\" file=\"body1.start.vtu\"".to_string(),
        format!("timestep=\"{time}\" group=\"\" part=\"1\" name=\"body2\" file=\"body2.vtu\""),
    ] {
        assert!(series.contains(&file), "{file} is not in {series}");
    }
    let start = array(&bench.read("out/punch-wear/fields/body1.start.vtu"), "von_mises_MPa");
    let end = array(&bench.read("out/punch-wear/fields/body1.vtu"), "von_mises_MPa");
    assert_eq!(start.len(), end.len());
    assert!(start.iter().zip(&end).any(|(a, b)| (a - b).abs() > 0.01 * b.abs()), "wear changes the stress");
}

/// The lining of data/meshes: 8 of its cells are triangles of order 3.
#[test]
fn a_body_of_triangles_has_its_area_in_flat_pieces_and_the_pressure_on_its_contact() {
    let bench = Bench::new();
    for name in ["lining.toml", "lining.msh"] {
        let path = format!("{}/../../data/meshes/{name}", env!("CARGO_MANIFEST_DIR"));
        std::fs::copy(path, bench.path(name)).unwrap();
    }
    let options = "--set output.fields=true --set check=false --set mesh.degree=10 --sample 2001 -o x";
    let call = bench.call(&format!("run lining.toml -q {options}"));
    assert_eq!(call.code, 0, "{}", call.err);
    let table = bench.read("x/contact.csv");
    let rows: Vec<[f64; 2]> =
        table.lines().skip(1).map(|row| [0, 8].map(|k| row.split(',').nth(k).unwrap().parse().unwrap())).collect();
    let pressure = |s: f64| {
        let share = (s - rows[0][0]) / (rows[2000][0] - rows[0][0]) * 2000.0;
        let below = (share.floor() as usize).min(1999);
        let part = share - below as f64;
        (1.0 - part) * rows[below][1] + part * rows[below + 1][1]
    };
    let text = bench.read("x/fields/body1.vtu");
    let place = array(&text, "position_mm");
    let [x, z, t] = ["sigma_x_MPa", "sigma_z_MPa", "tau_xz_MPa"].map(|name| array(&text, name));
    let mut seen = 0;
    for (i, at) in place.chunks(3).enumerate() {
        let s = 200.0 * at[0].atan2(at[2]);
        if (at[0].hypot(at[2]) - 200.0).abs() < 1e-9 && s.abs() < 0.8 * rows[2000][0] {
            let n = [at[0] / 200.0, at[2] / 200.0];
            let normal = x[i] * n[0] * n[0] + 2.0 * t[i] * n[0] * n[1] + z[i] * n[1] * n[1];
            approx::assert_relative_eq!(normal, -pressure(s), max_relative = 1e-4);
            seen += 1;
        }
    }
    assert!(seen >= 20, "{seen}");
    // Flat pieces of both kinds, none of them folded, fill the body but for the bulge of its arcs.
    let integers = |name: &str| -> Vec<usize> {
        bytes(&text, name).chunks(8).map(|chunk| i64::from_le_bytes(chunk.try_into().unwrap()) as usize).collect()
    };
    let (nodes, ends, types) = (integers("connectivity"), integers("offsets"), bytes(&text, "types"));
    let (mut area, mut first, mut triangles) = (0.0, 0, 0);
    for (end, kind) in ends.iter().zip(&types) {
        let corners: Vec<[f64; 2]> = nodes[first..*end].iter().map(|k| [place[3 * k], place[3 * k + 2]]).collect();
        assert_eq!(corners.len(), if *kind == 5 { 3 } else { 4 });
        let next = |k: usize| corners[(k + 1) % corners.len()];
        let piece = 0.5 * (0..corners.len()).map(|k| corners[k][0] * next(k)[1] - corners[k][1] * next(k)[0]).sum::<f64>();
        assert!(piece > 0.0, "{corners:?}");
        triangles += usize::from(*kind == 5);
        (area, first) = (area + piece, *end);
    }
    assert!(triangles >= 8 * 16, "{triangles}");
    // 210 mm x 240 mm less the segment and the triangle under the arc of 200 mm, and what lies below the lining's sides.
    let third = std::f64::consts::FRAC_PI_6;
    let lining = third * (210.0f64.powi(2) - 200.0f64.powi(2));
    let back = 210.0 * 240.0 - 210.0f64.powi(2) * (third + third.sin() * third.cos());
    approx::assert_relative_eq!(area, lining + back, max_relative = 1e-4);
    let whole = bytes(&bench.read("x/fields/body1.lagrange.vtu"), "types");
    assert!(whole.iter().all(|kind| [69, 70].contains(kind)) && whole.iter().filter(|kind| **kind == 69).count() >= 8);
}
