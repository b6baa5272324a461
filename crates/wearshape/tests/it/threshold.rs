//! A wear rule with a threshold pressure, from the scene: none is none, the run in time ends where the steady state says, and where nothing wears any
//! more it says so.

use std::ops::ControlFlow;

use wearshape::{Bodies, Document, Options, Problem, Solution, Status, solve};

fn read(name: &str, settings: &[&str]) -> Result<Problem, scene::Fault> {
    let settings: Vec<String> = settings.iter().map(ToString::to_string).collect();
    let text = scene::builtin(name).unwrap().text;
    Problem::new(&Document::read(name, text, &settings)?, &|_| Err("no file".into()))
}

fn solved(name: &str, settings: &[&str]) -> Solution {
    let problem = read(name, settings).unwrap();
    solve(&problem, &Options::default(), &Bodies::default(), &mut |_| ControlFlow::Continue(())).unwrap()
}

/// A punch without friction on its bodies, whose mean pressure is 1 kN/600 mm^2, that wears in by k (p - p0) v.
const WORN: [&str; 4] =
    ["contact={edges=[\"bottom\",\"top\"],friction=0,gap=0}", "accuracy=1e-3", "wear.b=1", "wear.until=steady"];

fn worn(more: &[&str]) -> Solution {
    // Archard's factor in place of the one with friction in it.
    let text = scene::builtin("punch-wear").unwrap().text.replace("beta = [2e-4, 0]", "k = [1e-5, 0]");
    let settings: Vec<String> = WORN.iter().chain(more).map(ToString::to_string).collect();
    let problem = Problem::new(&Document::read("punch-wear", &text, &settings).unwrap(), &|_| Err("no file".into())).unwrap();
    solve(&problem, &Options::default(), &Bodies::default(), &mut |_| ControlFlow::Continue(())).unwrap()
}

#[test]
fn a_threshold_of_zero_is_none() {
    for name in ["drum-brake-block", "punch-wear", "annular-punch"] {
        let [without, zero, both] = [vec![], vec!["wear.threshold=0"], vec!["wear.threshold=[0,\"0 MPa\"]"]]
            .map(|settings| read(name, &settings).unwrap());
        assert_eq!(without.resolved(), zero.resolved());
        assert!(without == zero && without == both);
    }
    assert!(read("drum-brake-block", &["wear.threshold=0.5"]).unwrap().resolved().contains("threshold = [0.5, 0.5]"));
}

#[test]
fn the_pressure_on_the_drum_is_the_threshold_and_a_power_of_the_cosine() {
    // b = 1/2: p = p0 + C cos^2, 5 MPa = p0 + C (1/2 - 1/24)/(1/2) by the force 10 kN on R = 200, t = 10.
    let solution = solved("drum-brake-block", &["tasks=[\"pressure\"]", "wear.threshold=\"3 MPa\""]);
    let (curve, c) = (solution.curve.unwrap(), 2.0 / (1.0 - 0.125 / 1.5));
    for (s, p) in curve.s.iter().zip(&curve.pressure) {
        let wanted = 3.0 + c * (s / 200.0).cos().powi(2);
        assert!((p / wanted - 1.0).abs() < 1e-9, "{s}: {p} {wanted}");
    }
    let result = solution.pressure.unwrap();
    assert_eq!((result.wear_rule, result.s), (Some("with a threshold"), None));
}

#[test]
fn the_run_in_time_ends_at_the_steady_pressure_above_the_threshold() {
    // Plane, one speed: the steady pressure is uniform, 5/3 MPa, whatever the threshold below it; the rate is that of the excess.
    let solution = worn(&["wear.threshold=1.2"]);
    assert_eq!(solution.status, Status::Ok, "{:?}", solution.reason);
    let (profile, mean) = (solution.profile.unwrap(), 1000.0 / 600.0);
    for (p, rate) in profile.pressure.iter().zip(&profile.wear_rate) {
        assert!((p / mean - 1.0).abs() < 1e-6, "{p}");
        assert!((rate / (1e3 * 1e-5 * 5.0 * (mean - 1.2)) - 1.0).abs() < 1e-5, "{rate}");
    }
    assert!(!solution.remarks.iter().any(|note| note.code == "wear-stopped"));
}

#[test]
fn where_the_load_ends_below_the_threshold_wear_stops_and_it_is_said() {
    let solution = worn(&["wear.threshold=1.8"]);
    let profile = solution.profile.unwrap();
    assert!(profile.pressure.iter().all(|p| *p <= 1.8 * (1.0 + 1e-5)));
    // The ends have worn down to the threshold, the middle never wore.
    let middle = profile.pressure.len() / 2;
    assert!(profile.pressure[0] > 1.79 && profile.pressure[middle] < 1.7, "{:?}", profile.pressure);
    let note = solution.remarks.iter().find(|note| note.code == "wear-stopped").unwrap();
    assert!(note.message.contains("1.8 MPa"), "{}", note.message);
    // Nowhere above: no start.
    let refused = worn(&["wear.threshold=\"1 GPa\""]);
    assert_eq!(refused.status, Status::Refused);
    assert!(refused.reason.unwrap().contains("nowhere above wear.threshold"));
}

#[test]
fn what_a_threshold_does_not_go_with_is_refused_with_its_key() {
    let cases: [(&str, &[&str], &str); 9] = [
        ("drum-brake-block", &["wear.threshold=-1"], "wear.threshold"),
        ("drum-brake-block", &["wear.threshold=[1,inf]"], "wear.threshold.1"),
        ("drum-brake-block", &["wear.threshold=1", "contact.friction=0"], "contact.friction"),
        ("drum-brake-block", &["wear.threshold=1", "optimum.functional=wear-power"], "optimum.q"),
        ("drum-brake-block", &["wear.threshold=1", "wear.b=1", "optimum.functional=wear-volume"], "optimum.q"),
        ("drum-brake-block", &["wear.threshold=1", "wear.beta=[1e-4,1e-4]", "wear.counterface=revolving"], "wear.counterface"),
        (
            "annular-punch",
            &["wear.threshold=1", "wear.k=[1e-7,1e-7]", "optimum.functional=wear-power", "optimum.q=2"],
            "wear.threshold",
        ),
        ("reciprocating-pad", &["wear.threshold=0.01"], "sliding.reversing"),
        ("pin-on-disc", &["wear.threshold=1"], "wear.threshold"),
    ];
    for (name, settings, key) in cases {
        let fault = read(name, settings).unwrap_err();
        assert_eq!(fault.key.as_deref(), Some(key), "{name} {settings:?}: {}", fault.message);
        assert!(!fault.remedy.is_empty());
    }
    read("drum-brake-block", &["wear.threshold=1", "wear.b=1", "optimum.functional=wear-power"]).unwrap();
}
