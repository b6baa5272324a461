//! One case, one name: data/scenes/X.toml, data/reference/X.json, fn X() here.
#![allow(clippy::unwrap_used)]

use std::path::{Path, PathBuf};

use approx::assert_relative_eq;
use cli::Exit;

/// Runs a built-in scene in a folder of its own and returns the folder.
fn run(scene: &str, case: &str, set: &[&str]) -> (Exit, PathBuf) {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("{scene}-{case}"));
    let mut args = vec!["wearshape".to_string(), "run".into(), scene.into(), "-q".into(), "-o".into()];
    args.push(folder.display().to_string());
    for setting in set {
        args.extend(["--set".into(), setting.to_string()]);
    }
    (cli::run(args), folder)
}

fn summary(folder: &Path) -> serde_json::Value {
    serde_json::from_str(&std::fs::read_to_string(folder.join("summary.json")).unwrap()).unwrap()
}

fn number(value: &serde_json::Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is no number"))
}

/// Annulus r = 20 to 120, 100 MPa, a = b = 1 (Paczelt and Mroz 2007, section 7): the steady pressure is p r = const,
/// 350 MPa inside and 350/6 MPa outside, the torque mu F (r_i + r_e)/2.
#[test]
fn annular_punch() {
    let (exit, folder) = run("annular-punch", "pressure", &["tasks=[pressure]"]);
    assert_eq!(exit, Exit::Done);
    let pressure = &summary(&folder)["pressure"];
    assert_relative_eq!(number(&pressure["p_max_MPa"]), 350.0, max_relative = 1e-12);
    assert_relative_eq!(number(&pressure["p_min_MPa"]), 350.0 / 6.0, max_relative = 1e-12);
    assert_relative_eq!(number(&pressure["effective_radius_mm"]), 70.0, max_relative = 1e-12);
    assert_relative_eq!(number(&pressure["torque_Nmm"]), 0.25 * 4398229.715025711 * 70.0, max_relative = 1e-12);
}

/// Drum, b = 1/2: the steady pressure is p ~ cos^2, 5.45455 MPa in the middle and 4.09091 MPa at +-30 deg.
#[test]
fn drum_brake_block_pressure() {
    let (exit, folder) = run("drum-brake-block", "pressure", &["tasks=[pressure]"]);
    assert_eq!(exit, Exit::Done);
    let pressure = &summary(&folder)["pressure"];
    assert_relative_eq!(number(&pressure["p_max_MPa"]), 60.0 / 11.0, max_relative = 1e-12);
    assert_relative_eq!(number(&pressure["p_min_MPa"]), 45.0 / 11.0, max_relative = 1e-12);
}

/// Punch L = 60, b = 2, M0/F0 = 5 mm (section 6): edge pressures 1.430662 and 0.351531 of the mean.
#[test]
fn translating_punch_pressure() {
    let (exit, folder) = run("translating-punch", "pressure", &["tasks=[pressure]", "load.moment=5 kN mm"]);
    assert_eq!(exit, Exit::Done);
    let pressure = &summary(&folder)["pressure"];
    let mean = 1000.0 / 600.0;
    assert_relative_eq!(number(&pressure["p_max_MPa"]), 1.430662 * mean, max_relative = 1e-6);
    assert_relative_eq!(number(&pressure["p_min_MPa"]), 0.351531 * mean, max_relative = 2e-6);
}
