//! A pin in the hole of a large plate of the same material, without friction: the closed form of Persson for the arc of contact.
//!
//! Source: A. Persson, On the stress distribution of cylindrical elastic bodies in contact, dissertation, Chalmers, Gothenburg 1964; M. Ciavarella,
//! P. Decuzzi, The state of stress induced by the plane frictionless cylindrical contact, I. The case of elastic similarity, Int. J. Solids
//! Struct. 38 (2001) 4507-4523: with b = tan(eps/2), E' = E/(1 - nu^2), the load Q per thickness and y = tan(phi/2)
//!
//! ```text
//!        . - - .             E' dR / Q = (2 - 2 b^4 - ln(1 + b^2)) / (pi b^2 (1 + b^2))
//!      /   eps   \\
//!     | \\  |  /  |           R p(phi) / Q = 2/(pi sqrt(1 + b^2)) sqrt(b^2 - y^2)/(1 + y^2)
//!     |    \\|/   |               + 1/(2 pi b^2 (1 + b^2)) ln((sqrt(1 + b^2) + sqrt(b^2 - y^2)) / (sqrt(1 + b^2) - sqrt(b^2 - y^2)))
//! ```

use std::f64::consts::PI;

use serde_json::Value;

use crate::call::Bench;

/// `E' dR / Q` of a half angle of contact.
pub(crate) fn clearance_over_load(eps: f64) -> f64 {
    let b = (0.5 * eps).tan();
    let square = b * b;
    (2.0 - 2.0 * square * square - square.ln_1p()) / (PI * square * (1.0 + square))
}

/// `R p / Q` at an angle.
pub(crate) fn pressure(eps: f64, phi: f64) -> f64 {
    let (b, y) = ((0.5 * eps).tan(), (0.5 * phi).tan());
    let (root, side) = ((b * b - y * y).max(0.0).sqrt(), (1.0 + b * b).sqrt());
    let logarithm = ((side + root) / (side - root)).ln();
    2.0 / (PI * side) * root / (1.0 + y * y) + logarithm / (2.0 * PI * b * b * (1.0 + b * b))
}

/// The Fourier series of disc and hole (Michell): pressure `p_n cos(n phi)` opens the two by `4 n/(n^2 - 1) R p_n / E'` for n >= 2, a uniform one by
/// `2 R p_0 / E'`. In the contact the opening and the clearance are one rigid motion, `D cos(phi) - dR`.
#[test]
fn the_closed_form_solves_the_series_of_disc_and_hole() {
    const NODES: usize = 1500;
    for eps in [0.3, 1.0, 1.3] {
        let nodes: Vec<f64> = (0..NODES).map(|i| PI * (i as f64 + 0.5) / NODES as f64).collect();
        let weighted: Vec<[f64; 2]> = nodes
            .iter()
            .map(|t| {
                let phi = eps * t.cos();
                [phi, pressure(eps, phi) * eps * t.sin() * PI / NODES as f64]
            })
            .collect();
        let load: f64 = weighted.iter().map(|[phi, p]| p * phi.cos()).sum();
        assert!((load - 1.0).abs() < 1e-12, "{load}");
        let coefficient = |n: usize| weighted.iter().map(|[phi, p]| p * (n as f64 * phi).cos()).sum::<f64>() / PI;
        let coefficients: Vec<f64> = (0..NODES).map(coefficient).collect();
        let opening = |phi: f64| {
            let term = |n: usize| 4.0 * n as f64 / (n * n - 1) as f64 * coefficients[n] * (n as f64 * phi).cos();
            coefficients[0] + (2..NODES).map(term).sum::<f64>()
        };
        for share in [0.5, 0.8] {
            let phi = share * eps;
            let rigid = (opening(0.0) - opening(phi)) / (1.0 - phi.cos());
            let found = rigid - opening(0.0);
            assert!((found / clearance_over_load(eps) - 1.0).abs() < 5e-6, "{eps} {share}: {found}");
        }
    }
}

pub(crate) const RADIUS: f64 = 10.0;
pub(crate) const YOUNG: f64 = 210e3;
pub(crate) const POISSON: f64 = 0.3;

/// A plate between the hole and a circle of radius `size`, on a pin held in its middle; the load pushes on the upper half of the rim and pulls on the
/// lower one, as in a plate without end, so that what the rim changes falls with the square of the size.
fn scene(size: f64, clearance: f64, force: f64) -> String {
    let angles = [-80, 0, 80, 90, 180, 270];
    let names = ["a", "b", "c", "d", "e", "f"];
    let [mut points, mut curves, mut cells] = [String::new(), String::new(), String::new()];
    for (k, angle) in angles.iter().enumerate() {
        let (one, next) = (names[k], names[(k + 1) % 6]);
        points += &format!("{one} = {{ radius = {RADIUS}, angle = \"{angle} deg\" }}\n");
        points += &format!("{one}-far = {{ radius = {size}, angle = \"{angle} deg\" }}\n");
        curves += &format!("{one}-hole.arc = {{ ends = [\"{one}\", \"{next}\"] }}\n");
        curves += &format!("{one}-rim.arc = {{ ends = [\"{one}-far\", \"{next}-far\"] }}\n");
        curves += &format!("{one}-ray.line = [\"{one}\", \"{one}-far\"]\n");
        cells += &format!("{one} = {{ curves = [\"{one}-hole\", \"{next}-ray\", \"{one}-rim\", \"{one}-ray\"] }}\n");
    }
    format!(
        r#"units = "N-mm"
kinematics = "plane-strain"
thickness = 1
tasks = ["contact"]
accuracy = 1e-4
contact = {{ edges = ["hole", "outer"], clearance = {clearance} }}
load = {{ edge = "rim", as = "vertical", force = {force} }}
[body1]
material = {{ young = {YOUNG}, poisson = {POISSON} }}
support = {{ middle = ["x"] }}
[body1.geometry.blocks.points]
{points}
[body1.geometry.blocks.curves]
{curves}
[body1.geometry.blocks.cells]
{cells}
[body1.geometry.blocks.edges]
hole = ["a-hole", "b-hole"]
rim = ["a-rim", "b-rim", "c-rim", "d-rim", "e-rim", "f-rim"]
middle = ["b-ray"]
[body2]
material = {{ young = {YOUNG}, poisson = {POISSON} }}
geometry.ring = {{ inner = 0.1, outer = {RADIUS} }}
support = {{ inner = ["x", "z"] }}
"#
    )
}

/// Half angle of contact, and `R p_max / Q`, of a plate of this size.
fn found(bench: &Bench, size: f64, clearance: f64, eps: f64) -> [f64; 2] {
    let force = YOUNG / (1.0 - POISSON * POISSON) * clearance / clearance_over_load(eps);
    bench.file("pin.toml", &scene(size, clearance, force));
    let call = bench.call("run pin.toml -q -o pin");
    assert_eq!(call.code, 0, "{size} {eps}: {}{}", call.out, call.err);
    let summary: Value = serde_json::from_str(&bench.read("pin/summary.json")).unwrap();
    let contact = &summary["contact"];
    let ends = [0, 1].map(|i| contact["ends_mm"][i].as_f64().unwrap() / RADIUS);
    assert!((ends[0] + ends[1]).abs() < 1e-6, "{ends:?}");
    [0.5 * (ends[1] - ends[0]), contact["p_max_MPa"].as_f64().unwrap() * RADIUS / force]
}

/// Half angle and largest pressure of Persson in the limit of a plate without end, from two sizes; the rest is the clearance of 1e-4 of the radius,
/// of which the closed form knows nothing.
#[test]
fn the_arc_of_contact_and_the_largest_pressure_are_those_of_persson() {
    let bench = Bench::new();
    for degrees in [25.0_f64, 60.0] {
        let eps = degrees.to_radians();
        let errors = [200.0, 400.0].map(|size| {
            let [half, largest] = found(&bench, size, 1e-4 * RADIUS, eps);
            [half / eps - 1.0, largest / pressure(eps, 0.0) - 1.0]
        });
        for (coarse, fine) in errors[0].iter().zip(&errors[1]) {
            let limit = (4.0 * fine - coarse) / 3.0;
            assert!(fine.abs() < 4e-4 && limit.abs() < 1e-4, "{degrees} deg: {coarse:e} {fine:e} {limit:e}");
        }
    }
}

/// A block with a hollow of radius 26 and one with a round top of radius 24, far sides flat; `up` where they touch at the top of their circles.
fn block(name: &str, hollow: bool, up: bool) -> String {
    let (radius, flat) = if hollow { (26.0, 46.0) } else { (24.0, 4.0) };
    let x = radius * 40.0_f64.to_radians().sin();
    let angles = if up { [-40, 40] } else { [220, 140] };
    let z = if up { flat } else { -flat };
    format!(
        r#"[{name}.geometry.blocks]
points = {{ a = {{ radius = {radius}, angle = "{} deg" }}, b = {{ radius = {radius}, angle = "{} deg" }}, c = [{x}, {z}], d = [-{x}, {z}] }}
curves = {{ touch.arc = {{ ends = ["a", "b"] }}, right.line = ["b", "c"], flat.line = ["c", "d"], left.line = ["d", "a"] }}
cells.one.curves = ["touch", "right", "flat", "left"]
edges = {{ touch = ["touch"], flat = ["flat"] }}
"#,
        angles[0], angles[1]
    )
}

/// Half length of contact and largest pressure, with the hollow block as body 1 or as body 2; the same two blocks either way.
fn drawn(bench: &Bench, hollow_first: bool, force: f64) -> [f64; 2] {
    let materials = if hollow_first { [[800.0, 0.46], [2000.0, 0.3]] } else { [[2000.0, 0.3], [800.0, 0.46]] };
    let [[one, nu], [other, mu]] = materials;
    let head = format!(
        r#"units = "N-mm"
kinematics = "plane-strain"
thickness = 20
tasks = ["contact"]
accuracy = 1e-4
contact = {{ edges = ["touch", "touch"] }}
load = {{ edge = "flat", as = "rigid", force = {force}, tilt = 0 }}
body1.material = {{ young = {one}, poisson = {nu} }}
body1.support = {{ flat = ["x"] }}
body2.material = {{ young = {other}, poisson = {mu} }}
body2.support = {{ flat = ["x", "z"] }}
"#
    );
    let blocks = block("body1", hollow_first, hollow_first) + &block("body2", !hollow_first, hollow_first);
    bench.file("arcs.toml", &(head + &blocks));
    let call = bench.call("run arcs.toml -q -o arcs");
    assert_eq!(call.code, 0, "{}{}", call.out, call.err);
    let summary: Value = serde_json::from_str(&bench.read("arcs/summary.json")).unwrap();
    let contact = &summary["contact"];
    let ends = [0, 1].map(|i| contact["ends_mm"][i].as_f64().unwrap());
    assert!((ends[0] + ends[1]).abs() < 1e-6 * ends[1], "{ends:?}");
    [0.5 * (ends[1] - ends[0]), contact["p_max_MPa"].as_f64().unwrap()]
}

/// Arcs of radii 24 and 26 drawn as they are: under a small load the contact is that of Hertz, and which block is body 1 makes no difference but that
/// of the square of the angle (0.05 rad) times the difference of the radii.
#[test]
fn arcs_of_two_radii_touch_as_hertz_has_it_and_either_may_be_body_1() {
    let bench = Bench::new();
    let modulus = 1.0 / ((1.0 - 0.46 * 0.46) / 800.0 + (1.0 - 0.3 * 0.3) / 2000.0);
    let (force, radius) = (50.0, 24.0 * 26.0 / 2.0);
    let half = (4.0 * force / 20.0 * radius / (PI * modulus)).sqrt();
    let [one, other] = [true, false].map(|hollow_first| drawn(&bench, hollow_first, force));
    for [found, largest] in [one, other] {
        assert!((found / half - 1.0).abs() < 6e-3, "{found} {half}");
        assert!((largest / (2.0 * force / 20.0 / (PI * half)) - 1.0).abs() < 6e-3, "{largest}");
    }
    assert!((one[0] / other[0] - 1.0).abs() < 1e-3 && (one[1] / other[1] - 1.0).abs() < 1e-3, "{one:?} {other:?}");
}

/// A bush drawn with its own radius has the contact of one drawn with that of the shaft and a clearance, but for the clearance over the radius.
#[test]
fn a_clearance_is_the_difference_of_the_radii() {
    let bench = Bench::new();
    let ends = |set: &str| {
        let call = bench.call(&format!("run bushing -q -o bush {set}"));
        assert_eq!(call.code, 0, "{}{}", call.out, call.err);
        let summary: Value = serde_json::from_str(&bench.read("bush/summary.json")).unwrap();
        [0, 1].map(|i| summary["contact"]["ends_mm"][i].as_f64().unwrap())
    };
    let (given, drawn) = (ends(""), ends("--set contact.clearance=0 --set body2.geometry.ring.outer=24.95"));
    for (a, b) in given.iter().zip(&drawn) {
        assert!((a / b - 1.0).abs() < 4e-3, "{given:?} {drawn:?}");
    }
}
