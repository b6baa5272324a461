//! Pads held at their sides, which wear evenly: closed forms of depth and pressure, and what is told of their errors.

use wearshape::Status;

use crate::common::{read, scene, solved};

/// Two pads of one stiffness in uniaxial strain, each 100 mm high.
const PADS: &str = r#"
units = "N-mm"
kinematics = "plane-strain"
thickness = 10
tasks = ["wear"]
accuracy = 1e-4
body1.material = { young = 3000, poisson = 0.3 }
body1.geometry.rectangle = { x = [-30, 30], z = [100, 200] }
body1.support = { left = ["x"], right = ["x"], top = ["x"] }
body2.material = { young = 3000, poisson = 0.3 }
body2.geometry.rectangle = { x = [-30, 30], z = [0, 100] }
body2.support = { bottom = ["x", "z"], left = ["x"], right = ["x"] }
contact = { edges = ["bottom", "top"], friction = 0, gap = 0 }
sliding = { speed = 10 }
"#;

#[test]
fn a_gap_that_is_round_off_has_no_error() {
    let pressed =
        format!("{PADS}load = {{ edge = 'top', as = 'rigid', force = 6000, tilt = 0 }}\nwear = {{ k = 1e-6, until = 100 }}");
    let cosine = "contact.gap={ cosine = { amplitude = '0.1 um', wavelength = '60 mm' } }";
    for settings in
        [&[][..], &["mesh.degree=6"], &["wear.threshold=1"], &["wear.until={ depth = 0.01 }"], &[cosine, "wear.until='steady'"]]
    {
        let solution = solved(&read(&pressed, settings));
        assert_eq!(solution.status, Status::Ok, "{settings:?} {:?}", solution.reason);
        let told = solution.error.unwrap().gap_relative.unwrap();
        let wear = solution.wear.unwrap();
        assert!(told < 1e-12 && wear.steady, "{settings:?}: {told:e}");
        let ended = wear.depth.unwrap();
        let depth = if settings == ["wear.threshold=1"] { 9.0 } else { 10.0 };
        assert!(settings.contains(&cosine) || (ended / depth - 1.0).abs() < 1e-11, "{settings:?}: {ended} um");
    }
}

#[test]
fn a_pressure_that_wears_itself_away_tells_what_the_steps_leave() {
    // p = p0 e^(-k v t / c), what is closed to begin with being c p0; the depth of both bodies is what that has lost.
    let stiffness: f64 = 3000.0 * (1.0 - 0.3) / ((1.0 + 0.3) * (1.0 - 2.0 * 0.3));
    let (closed, compliance) = (0.05, 2.0 * 100.0 / stiffness);
    let held = "load = { edge = 'top', as = 'rigid', approach = 0.05, tilt = 0 }";
    for (factors, sum, share) in [("1e-6", 1e-6_f64, 1.0), ("[1e-6, 5e-7], counterface = 'congruent'", 1.5e-6, 2.0 / 3.0)] {
        for accuracy in [1e-3, 1e-5] {
            let text = format!("{PADS}{held}\nwear = {{ k = {factors}, until = 3000 }}");
            let solution = solved(&read(&text, &[&format!("accuracy={accuracy}")]));
            assert_eq!(solution.status, Status::Ok, "{:?}", solution.reason);
            let told = solution.error.unwrap().gap_relative.unwrap();
            let exact = share * 1e3 * closed * (1.0 - (-sum * 10.0 * 3000.0 / compliance).exp());
            let off = (solution.wear.unwrap().depth.unwrap() / exact - 1.0).abs();
            assert!(off < 2.0 * told && told < accuracy, "{factors}: {off:e} where {told:e} is told");
        }
    }
}

#[test]
fn a_run_that_ends_long_after_it_is_steady_says_so() {
    let run = |until: &str| {
        let solution = solved(&scene("punch-wear", &["accuracy=1e-4", until]));
        let wear = solution.wear.unwrap();
        assert!(wear.steady, "{until}");
        let error = wear.run_in_error.unwrap();
        (wear.to_1_percent.unwrap().time, error)
    };
    let (steady, error) = run("wear.until='steady'");
    for until in ["wear.until=100", "wear.until={ depth = 0.02 }"] {
        let (found, told) = run(until);
        assert!((found / steady - 1.0).abs() < error + told, "{until}: {found} and {steady} s");
    }
}
