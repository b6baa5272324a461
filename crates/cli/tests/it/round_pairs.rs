//! Shafts all around in their housings, and round bodies that touch from outside: against Persson and Hertz.
//!
//! The formulas of Persson stand in [`persson`](super::persson), with their source.
//!
//! ```text
//!       . - - - .              ( roller )   R1
//!      / . - - . \                 |
//!     | ( shaft ) |           .- - - - -.
//!      \ ' - - ' /           (    cam    )  R2       1/R = 1/R1 + 1/R2
//!       ' - - - ' housing     ' - - - - '
//! ```

use std::f64::consts::PI;

use serde_json::Value;

use crate::call::Bench;
use crate::persson::{POISSON, RADIUS, YOUNG, clearance_over_load, pressure};

/// A contact as the summary tells it: its ends (mm), and the largest pressure (MPa).
struct Touched {
    ends: [f64; 2],
    largest: f64,
}

impl Touched {
    fn half(&self) -> f64 {
        0.5 * (self.ends[1] - self.ends[0])
    }

    /// How far it is from symmetric, over its half length.
    fn skew(&self) -> f64 {
        ((self.ends[0] + self.ends[1]) / self.half()).abs()
    }
}

fn touched(bench: &Bench, arguments: &str) -> Touched {
    let call = bench.call(&format!("run {arguments} -q -o out"));
    assert_eq!(call.code, 0, "{arguments}: {}{}", call.out, call.err);
    let summary: Value = serde_json::from_str(&bench.read("out/summary.json")).unwrap();
    let contact = &summary["contact"];
    let ends = [0, 1].map(|i| contact["ends_mm"][i].as_f64().unwrap());
    Touched { ends, largest: contact["p_max_MPa"].as_f64().unwrap() }
}

/// A shaft in a housing whose outside, a circle of radius `size`, is rigid, as a plate without end is but for the square of its size; either may be body 1.
fn journal(size: f64, clearance: f64, force: f64, housing_first: bool) -> String {
    let housing = format!("geometry.ring = {{ inner = {RADIUS}, outer = {size} }}");
    let shaft = format!("geometry.ring = {{ inner = 0.1, outer = {RADIUS} }}");
    let bodies = if housing_first {
        [(housing, "inner", "outer"), (shaft, "outer", "inner")]
    } else {
        [(shaft, "outer", "inner"), (housing, "inner", "outer")]
    };
    let [(one, touches, held), (other, meets, fixed)] = bodies;
    format!(
        r#"units = "N-mm"
kinematics = "plane-strain"
thickness = 1
tasks = ["contact"]
accuracy = 1e-4
contact = {{ edges = ["{touches}", "{meets}"], clearance = {clearance} }}
load = {{ edge = "{held}", as = "rigid", force = {force}, tilt = 0 }}
[body1]
material = {{ young = {YOUNG}, poisson = {POISSON} }}
{one}
support = {{ {held} = ["x"] }}
[body2]
material = {{ young = {YOUNG}, poisson = {POISSON} }}
{other}
support = {{ {fixed} = ["x", "z"] }}
"#
    )
}

/// Half angles of contact from 10 to 78 degrees and the largest pressures, with the housing or the shaft as body 1, in the limit of a large housing from two
/// sizes; the rest is the clearance of 1e-4 of the radius, of which the closed form knows nothing.
#[test]
fn a_shaft_all_around_in_its_housing_touches_as_persson_has_it() {
    let bench = Bench::new();
    let clearance = 1e-4 * RADIUS;
    for (degrees, housing_first) in [(10.0_f64, true), (45.0, false), (60.0, true), (78.0, false)] {
        let eps = degrees.to_radians();
        let force = YOUNG / (1.0 - POISSON * POISSON) * clearance / clearance_over_load(eps);
        let errors = [200.0, 400.0].map(|size| {
            bench.file("journal.toml", &journal(size, clearance, force, housing_first));
            let found = touched(&bench, "journal.toml");
            assert!(found.skew() < 1e-6, "{degrees}: {:?}", found.ends);
            [found.half() / RADIUS / eps - 1.0, found.largest * RADIUS / force / pressure(eps, 0.0) - 1.0]
        });
        for (coarse, fine) in errors[0].iter().zip(&errors[1]) {
            let limit = (4.0 * fine - coarse) / 3.0;
            assert!(fine.abs() < 4e-4 && limit.abs() < 2e-4, "{degrees} deg: {coarse:e} {fine:e} {limit:e}");
        }
    }
}

/// Housing and shaft of the scene written the other way around: the shaft pressed down into its housing touches at the bottom by the same arc.
#[test]
fn shaft_and_housing_may_change_places() {
    let bench = Bench::new();
    let one = touched(&bench, "journal --set contact.friction=0");
    let turned = "journal --set contact.friction=0 --set contact.edges=[outer,inner] --set load.edge=inner \
                  --set body1.material.young=210_GPa --set body1.material.poisson=0.3 --set body1.geometry.ring.inner=5 \
                  --set body1.geometry.ring.outer=25 --set body1.support={inner=[x]} --set body2.material.young=100_GPa \
                  --set body2.material.poisson=0.34 --set body2.geometry.ring.inner=25 --set body2.geometry.ring.outer=40 \
                  --set body2.support={outer=[x,z]}";
    let other = touched(&bench, turned);
    assert!(one.skew() < 1e-6 && other.skew() < 1e-6);
    // But for the clearance over the radius, 2e-3.
    assert!((one.half() / other.half() - 1.0).abs() < 2e-3 && (one.largest / other.largest - 1.0).abs() < 2e-3);
}

/// A contact a hundredth of the surface: the limit of Hertz, on a bush with ends and on a whole circle, by accuracy and by a fixed degree.
#[test]
fn a_short_contact_has_cells_of_its_size() {
    let bench = Bench::new();
    let modulus = 1.0 / ((1.0 - 0.34_f64.powi(2)) / 100e3 + (1.0 - 0.09) / 210e3);
    let radius = 25.0 * 25.05 / 0.05;
    let (per_length, close) = (5.0 / 30.0, |x: f64, y: f64, by: f64| (x / y - 1.0).abs() < by);
    let half = (4.0 * per_length * radius / (PI * modulus)).sqrt();
    for scene in ["journal", "bushing"] {
        let fine = touched(&bench, &format!("{scene} --set load.force=5 --set contact.friction=0 --set accuracy=1e-5"));
        assert!(
            close(fine.half(), half, 3e-3) && close(fine.largest, 2.0 * per_length / (PI * half), 3e-3),
            "{scene} {} {half}",
            fine.half()
        );
        let fixed = touched(&bench, &format!("{scene} --set load.force=5 --set contact.friction=0 --set mesh.degree=8"));
        assert!(
            close(fixed.half(), fine.half(), 2e-4) && close(fixed.largest, fine.largest, 2e-3),
            "{scene} {} {}",
            fixed.half(),
            fine.half()
        );
    }
}

/// Half lengths and largest pressures of Hertz, from which ours differ in proportion to the load: by the square of the contact over the radii.
#[test]
fn round_bodies_touch_from_outside_as_hertz_has_it_the_closer_the_lighter_the_load() {
    let bench = Bench::new();
    let modulus = 0.5 * 210e3 / (1.0 - 0.09);
    let radius = 1.0 / (1.0 / 10.0 + 1.0 / 25.0);
    let errors = [160e3, 40e3, 10e3, 1e3].map(|force| {
        let found =
            touched(&bench, &format!("cam --set accuracy={} --set load.force={force}", if force == 40e3 { 2e-4 } else { 1e-4 }));
        let half = (4.0 * force / 12.0 * radius / (PI * modulus)).sqrt();
        assert!(found.skew() < 1e-6, "{:?}", found.ends);
        [found.half() / half - 1.0, found.largest / (2.0 * force / 12.0 / (PI * half)) - 1.0]
    });
    for error in [0, 1] {
        let of = |k: usize| errors[k][error];
        assert!(of(0).abs() < 1.5e-2 && of(3).abs() < 3e-4, "{errors:?}");
        // The half length falls with the load; the largest pressure is told to a few 1e-4, too little for a rate.
        let rates = [of(0) / of(1), of(1) / of(2)];
        let near = |rate: f64| (rate - 4.0).abs() < 0.4;
        assert!(if error == 0 { rates.into_iter().all(near) } else { rates.into_iter().all(|rate| rate > 2.0) }, "{errors:?}");
    }
}

/// A half-disc, given by cells, on the same cam.
#[test]
fn a_half_disc_may_touch_a_cam() {
    let bench = Bench::new();
    let disc = "cam --set contact.edges=[arc,outer] --set body1.geometry.half-disc={radius=10,centre=[0,35]} --set load.edge=top --set body1.support={top=[x]}";
    let (one, other) = (touched(&bench, disc), touched(&bench, "cam"));
    assert!((one.half() / other.half() - 1.0).abs() < 3e-4 && (one.largest / other.largest - 1.0).abs() < 1e-3);
}

#[test]
fn round_pairs_that_cannot_be_are_refused_by_name() {
    let bench = Bench::new();
    for (set, code, words) in [
        ("journal --set contact.clearance=-0.01", "contact.clearance", "negative clearance"),
        ("journal --set body1.geometry.ring.inner=24", "contact", "the arcs cross"),
        ("journal --set load.as=pressure", "load.as", "no force along z"),
        ("journal --set tasks=[pressure,shape]", "tasks", "the tasks contact and wear alone"),
        ("journal --set tasks=[wear,shape] --set wear.until=10", "tasks", "the tasks contact and wear alone"),
        ("journal --set tasks=[wear]", "wear.until", "worn for ever"),
        ("cam --set body1.geometry.ring.centre=[0,34]", "contact", "the round bodies cross"),
        ("cam --set body1.geometry.ring.centre=[0,36]", "contact", "do not touch"),
        ("cam --set body1.geometry.ring.centre=[1,35]", "contact", "beside the z axis"),
        ("cam --set contact.clearance=0.1", "contact.clearance", "touch from outside"),
        ("cam --set tasks=[shape] --set optimum.functional=steady", "tasks", "the tasks contact and wear alone"),
        ("cam --set tasks=[wear] --set wear.k=1e-7 --set sliding.omega=40", "wear.until", "two round bodies are worn for ever"),
    ] {
        let call = bench.check_and_run(set);
        assert!(call.code == 2 && call.err.contains(words) && call.err.contains(code), "{set}: {}", call.err);
    }
    // Contact beyond the part of the circle that can touch is found while solving, also where it has grown so far, or is closed from the start.
    for set in [
        "cam --set load.force=3e7",
        "journal --set tasks=[wear] --set wear.until=3e6 --set accuracy=1e-3",
        "journal --set tasks=[wear] --set wear.until=1 --set contact.clearance=0 --set accuracy=1e-3",
    ] {
        let call = bench.call(&format!("run {set} -q -o far"));
        let why = "reaches the end of the part of the circle";
        assert!(call.code == 1 && bench.read("far/summary.json").contains(why), "{set}: {}", call.err);
    }
}

/// A rigid shaft of radius R wears its housing of clearance c to its own circle: half the angle of contact a and the depth h in the middle follow from
/// `k F s / (R t c) = a / cos a - sin a`, `cos a = c / (c + h)` (docs/round-wear.md), whichever of both is body 1.
#[test]
fn a_rigid_shaft_all_around_wears_its_housing_to_its_own_circle() {
    let bench = Bench::new();
    // The scene's, in N, mm and s: k F v, R, t, c.
    let (rate, radius, length, clearance) = (1e-9 * 10e3 * (10.0 * PI * 25.0), 25.0, 30.0, 0.05);
    let angle = 1.0_f64;
    let depth = clearance / angle.cos() - clearance;
    let time = radius * length * clearance * (angle / angle.cos() - angle.sin()) / rate;
    let stiff = format!(
        "--set tasks=[wear] --set wear.until={time} --set contact.shear=false --set accuracy=1e-4 \
                 --set body1.material.young=1e8 --set body2.material.young=1e8"
    );
    let swapped = "--set contact.edges=[outer,inner] --set body1.geometry.ring={inner=5,outer=25} --set load.edge=inner \
                   --set body2.geometry.ring={inner=25,outer=40} --set body1.support={inner=[x]} --set body2.support={outer=[x,z]}";
    for set in [stiff.clone(), format!("{stiff} {swapped}")] {
        let call = bench.call(&format!("run journal -q {set} -o out"));
        assert_eq!(call.code, 0, "{}", call.err);
        let summary: Value = serde_json::from_str(&bench.read("out/summary.json")).unwrap();
        let number = |key: &str| summary["wear"][key].as_f64().unwrap();
        let apart = |found: f64, wanted: f64| (found / wanted - 1.0).abs();
        let [scar, deep] = [apart(number("scar_mm"), 2.0 * angle * radius), apart(number("depth_um"), 1e3 * depth)];
        assert!(scar < 2e-3 && deep < 2e-3, "{scar:e} {deep:e}");
    }
}

/// Rigid rollers wear to a flat that ends at `a`, seen from the curvature `1/R = 1/R1 + 1/R2` of both: the depth in the middle is `h = a^2 / 2R`, and
/// the volume `k F s = 2 a^3 t / 3R` (docs/round-wear.md), whichever of both wears; elastic ones begin with the contact of Hertz.
/// Rigid is 500 times as stiff as steel: ten times more, and at 10 N estimates hang on the round-off of the gap (4e-9 to 3e-4).
#[test]
fn a_rigid_roller_wears_on_its_cam_to_a_flat_and_an_elastic_one_begins_with_hertz() {
    let bench = Bench::new();
    let worn = |set: &str, wanted: i32| -> Value {
        let cam = "run cam -q --set tasks=[wear] --set wear.k=1e-7 --set contact.friction=0.1 --set sliding.omega=40";
        let call = bench.call(&format!("{cam} {set} -o out"));
        assert_eq!(call.code, wanted, "{}", call.err);
        serde_json::from_str(&bench.read("out/summary.json")).unwrap()
    };
    let (length, curved) = (12.0, 10.0 * 25.0 / 35.0);
    let apart = |found: &Value, wanted: f64| (found.as_f64().unwrap() / wanted - 1.0).abs();
    for (force, end) in [(1e3, 0.12_f64), (10.0, 0.3)] {
        let depth = end * end / (2.0 * curved);
        let distance = 2.0 * end.powi(3) * length / (3.0 * curved) / (1e-7 * force);
        let stiff = format!(
            "--set load.force={force} --set wear.until.depth={depth} --set body1.material.young=1e8 --set body2.material.young=1e8"
        );
        let wear = &worn(&stiff, 0)["wear"];
        let [scar, deep, far] = [("scar_mm", 2.0 * end), ("depth_um", 1e3 * depth), ("distance_mm", distance)]
            .map(|(key, wanted)| apart(&wear[key], wanted));
        assert!(scar < 2e-3 && deep < 1e-9 && far < 1e-3, "{scar:e} {deep:e} {far:e}");
    }
    // What wears off is k F s at any time, up to the cosine of the end; the width at the start is that of Hertz, as far as points tell it that the ends only pass:
    // a fifth of half of it apart.
    let wear = &worn("--set wear.until.depth=1e-3", 0)["wear"];
    let volume = 1e-7 * 1e3 * wear["distance_mm"].as_f64().unwrap();
    assert!(apart(&wear["volume_mm3"], volume) < 1e-5, "{wear}");
    let history = bench.read("out/history.csv");
    let start: Vec<f64> = history.lines().nth(1).unwrap().split(',').map(|word| word.parse().unwrap_or(f64::NAN)).collect();
    let at = history.lines().next().unwrap().split(',').position(|name| name == "scar_mm").unwrap();
    let softness = 2.0 * (1.0 - 0.3 * 0.3) / 210e3;
    let hertz = 2.0 * (4.0 * 1e3 * curved * softness / (PI * length)).sqrt();
    assert!((start[at] / hertz - 1.0).abs() < 3e-2, "{} {hertz}", start[at]);
}

/// A roller set on an edge with a pin takes its place, and the other way around.
#[test]
fn a_support_that_is_set_takes_the_place_of_the_one_in_the_scene() {
    let bench = Bench::new();
    let call = bench.call("run pinned-shoe-elastic --set body1.support.seat.roller=20_deg --set tasks=[pressure] -q -o roller");
    assert!(call.code < 2, "{}", call.err);
    let resolved = bench.read("roller/scene.resolved.toml");
    assert!(resolved.contains("roller") && !resolved.contains("pin ="), "{resolved}");
}
