//! A ball or cylinder on a flat that wears in time, against the laws of rigid bodies and against finer runs.

use approx::assert_relative_eq;
use wearshape::{Problem, Solution, Status};

use crate::common::{scene, solved};

/// Settings of a run in time; the bodies may be stiffer by a factor.
fn worn(name: &str, stiffer: f64, settings: &[&str]) -> Problem {
    let young = [1, 2].map(|body| {
        let steel = if (name, body) == ("hertz-cylinder", 2) { 70e3 } else { 210e3 };
        format!("body{body}.material.young={}", steel * stiffer)
    });
    let set = ["tasks=[wear]", "contact.friction=0.1", "contact.shear=false", "sliding.speed=10", "wear.k=1e-7"];
    let all: Vec<&str> = set.into_iter().chain(young.iter().map(String::as_str)).chain(settings.iter().copied()).collect();
    scene(name, &all)
}

fn depth(solution: &Solution) -> f64 {
    1e-3 * solution.wear.as_ref().unwrap().depth.unwrap()
}

fn estimate(solution: &Solution) -> f64 {
    solution.error.as_ref().unwrap().gap_relative.unwrap()
}

fn column<'a>(solution: &'a Solution, name: &str) -> &'a [f64] {
    &solution.history.iter().find(|(known, _)| known == name).unwrap().1
}

/// The root of a growing function between 0 and `most`.
fn root(most: f64, f: impl Fn(f64) -> f64) -> f64 {
    let mut range = [0.0, most];
    for _ in 0..200 {
        let middle = 0.5 * (range[0] + range[1]);
        range[usize::from(f(middle) > 0.0)] = middle;
    }
    range[0]
}

/// A rigid ball wears flat: the cap of height h has the volume pi h^2 (R - h/3) = k F s, for small h that of h = sqrt(k F s/(pi R)).
#[test]
fn a_rigid_ball_loses_the_cap_of_its_volume() {
    let solution = solved(&worn("hertz-sphere", 1e3, &["wear.until=100", "accuracy=3e-4"]));
    assert_eq!(solution.status, Status::Ok, "{:?}", solution.reason);
    let volume = 1e-7 * 21.0 * 1e3;
    let exact = root(5.0, |h| std::f64::consts::PI * h * h * (5.0 - h / 3.0) - volume);
    let wear = solution.wear.as_ref().unwrap();
    assert_relative_eq!(wear.volume.unwrap(), volume, max_relative = 1e-10);
    assert_relative_eq!(depth(&solution), exact, max_relative = 3e-4);
    assert_relative_eq!(depth(&solution), (volume / (std::f64::consts::PI * 5.0)).sqrt(), max_relative = 2e-3);
    assert_relative_eq!(wear.scar.unwrap(), 2.0 * (exact * (10.0 - exact)).sqrt(), max_relative = 1e-3);
    // The volume is k F s at every step.
    let distances = column(&solution, "distance_mm").iter().zip(column(&solution, "volume1_mm3"));
    distances.for_each(|(s, v)| assert_relative_eq!(*v, 1e-7 * 21.0 * s, max_relative = 1e-9));
}

/// Where the same points always meet, the gap opens by the sum of both wear factors, whoever wears: ends, errors and steps are those of one problem.
#[test]
fn a_plate_that_wears_alone_has_the_scar_of_a_ball_that_does() {
    let settings = ["wear.until=100", "accuracy=1e-3", "wear.counterface=congruent"];
    for name in ["hertz-sphere", "hertz-cylinder"] {
        let of = |k: &str| solved(&worn(name, 1.0, &[&settings[..], &[k]].concat()));
        let [first, both, second] = ["wear.k=[1e-7, 0]", "wear.k=[5e-8, 5e-8]", "wear.k=[0, 1e-7]"].map(of);
        let scar = |solution: &Solution| solution.wear.as_ref().unwrap().scar.unwrap();
        for other in [&both, &second] {
            assert_eq!(other.status, Status::Ok, "{:?}", other.reason);
            assert_relative_eq!(scar(other), scar(&first), max_relative = 1e-9);
            assert_relative_eq!(estimate(other), estimate(&first), max_relative = 1e-2);
        }
        assert_eq!(depth(&second), 0.0, "it is that of body 1");
    }
}

/// A rigid cylinder: the segment of height h has the area R^2 acos(1 - h/R) - (R - h) sqrt(h (2R - h)) = k (F/t) s, about (4/3) sqrt(2R) h^(3/2).
#[test]
fn a_rigid_cylinder_loses_the_segment_of_its_volume() {
    let solution = solved(&worn("hertz-cylinder", 1e5, &["wear.until=10", "accuracy=1e-4"]));
    assert_eq!(solution.status, Status::Ok, "{:?}", solution.reason);
    let area = 1e-7 * 35e3 * 100.0;
    let segment = |h: f64| 2500.0 * (1.0 - h / 50.0).acos() - (50.0 - h) * (h * (100.0 - h)).sqrt();
    let exact = root(50.0, |h| segment(h) - area);
    assert_relative_eq!(solution.wear.as_ref().unwrap().volume.unwrap(), area, max_relative = 1e-10);
    assert_relative_eq!(depth(&solution), exact, max_relative = 2e-5);
    assert_relative_eq!(4.0 / 3.0 * 10.0 * exact.powf(1.5), area, max_relative = 1e-3);
}

/// The first state is the contact of the task contact.
#[test]
fn a_run_begins_with_the_contact_of_hertz() {
    for (name, force) in [("hertz-sphere", "load.force=21"), ("hertz-cylinder", "load.force=3500")] {
        let contact = solved(&scene(name, &["accuracy=1e-6", force]));
        let run = solved(&worn(name, 1.0, &["wear.until=1", "accuracy=1e-3", force]));
        let peak = contact.contact.as_ref().unwrap().p_max.unwrap();
        assert_relative_eq!(column(&run, "p_max_MPa")[0], peak, max_relative = 2e-3);
        let ends = &contact.contact.as_ref().unwrap().ends;
        let half = ends.iter().copied().fold(0.0, f64::max);
        assert_relative_eq!(column(&run, "scar_mm")[0], 2.0 * half, max_relative = 2e-2);
    }
}

/// Errors against a finer run are within the estimates, for powers of the pressure above and below 1.
#[test]
fn errors_are_within_their_estimates() {
    for rule in [["wear.b=2", "wear.k=1e-9"], ["wear.b=0.5", "wear.k=1e-6"]] {
        let of = |accuracy: &str| solved(&worn("hertz-sphere", 1.0, &["wear.until=5", accuracy, rule[0], rule[1]]));
        let fine = of("accuracy=1e-4");
        for accuracy in ["accuracy=1e-2", "accuracy=1e-3"] {
            let rough = of(accuracy);
            let error = (depth(&rough) / depth(&fine) - 1.0).abs();
            println!("{rule:?} {accuracy}: true {error:.1e}, estimated {:.1e} ({:?})", estimate(&rough), rough.status);
            assert!(error < estimate(&rough) + estimate(&fine), "{rule:?} {accuracy}: {error:.1e}, {:.1e}", estimate(&rough));
        }
    }
}

/// Where a cylinder has worn next to nothing yet, and where the contact is wider than a tenth of the radius, meshes are sound, and what is worn is k F s.
#[test]
fn short_runs_and_large_contacts_are_meshed() {
    for (until, force) in [(1e-6, 3500.0), (1e-3, 3500.0), (1e-3, 350.0), (1.0, 35e3), (30.0, 35e3)] {
        let set = [format!("wear.until={until}"), format!("load.force={force}"), "accuracy=1e-2".into()];
        let run = solved(&worn("hertz-cylinder", 1.0, &set.each_ref().map(String::as_str)));
        assert_eq!(run.status, Status::Ok, "{until} s, {force} N: {:?}", run.reason);
        assert_relative_eq!(run.wear.as_ref().unwrap().volume.unwrap(), 1e-7 * force * 10.0 * until, max_relative = 1e-9);
    }
}

/// As the scar grows ever more slowly, its pressure becomes that of a flat punch that wears steadily: uniform, F/A.
#[test]
fn a_scar_that_hardly_grows_has_the_pressure_of_a_flat_punch() {
    let deviation = |until: &str| {
        let run = solved(&worn("hertz-sphere", 1.0, &[until, "accuracy=1e-2"]));
        let profile = run.profile.as_ref().unwrap();
        let end = 0.5 * run.wear.as_ref().unwrap().scar.unwrap();
        let mean = 21.0 / (std::f64::consts::PI * end * end);
        let inner = profile.s.iter().zip(&profile.pressure).filter(|(s, _)| **s < 0.8 * end);
        inner.map(|(_, p)| (p / mean - 1.0).abs()).fold(0.0, f64::max)
    };
    let [early, late, last] = ["wear.until=0.5", "wear.until=20", "wear.until=800"].map(deviation);
    println!("off by {early:.2e}, {late:.2e}, {last:.2e}");
    assert!(late < 0.5 * early && last < 0.5 * late && last < 0.02, "{early:e} {late:e} {last:e}");
}

/// Friction on the bodies drags the scar of a cylinder to one side; the mirror image of the run slides the other way.
#[test]
fn shear_on_a_cylinder_turns_with_the_sense_of_sliding() {
    let of = |speed: &str| {
        let set = ["load.force=3500", "wear.until=1", "accuracy=1e-2", "contact.shear=true", "contact.friction=0.3", speed];
        solved(&worn("hertz-cylinder", 1.0, &set))
    };
    let [there, back] = ["sliding.speed=10", "sliding.speed=-10"].map(of);
    assert_relative_eq!(depth(&there), depth(&back), max_relative = 1e-6);
    let pressure = |solution: &Solution| solution.profile.as_ref().unwrap().pressure.clone();
    let (there, mut back) = (pressure(&there), pressure(&back));
    let peak = there.iter().copied().fold(0.0, f64::max);
    back.reverse();
    let apart = there.iter().zip(&back).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    back.reverse();
    let moved = there.iter().zip(&back).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(apart < 1e-3 * peak && moved > 3.0 * apart, "mirrored {apart:.1e}, as it is {moved:.1e}, of {peak:.1e}");
}
