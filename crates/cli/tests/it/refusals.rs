//! Settings of sound scenes that are refused, with words of the message and of the remedy; `check` refuses what `run` does.

use crate::call::Bench;

#[test]
fn settings_without_a_meaning_are_refused_with_a_remedy_that_helps() {
    let bench = Bench::new();
    for (setting, message, remedy) in [
        ("drum-brake-hot --set heat.reference=-300", "below absolute zero", "a temperature in degC"),
        ("clutch-hot --set body1.heat.top.temperature=-300", "below absolute zero", "a temperature in degC"),
        ("drum-brake-hot --set body2.heat.outer.ambient=-274", "below absolute zero", "a temperature in degC"),
        // A ring has no edge `top`.
        ("drum-brake-hot --set body2.heat={}", "nothing cools the body", "body2.heat.inner = "),
        ("clutch-hot --set contact.friction=nan", "no coefficient of friction: contact.friction = NaN", "0 or more"),
        // What holds the edge already is to stay.
        (
            "hertz-sphere --set load.twist=0.001 --set contact.friction=0.3 --set body1.support.top=[\"phi\"]",
            "no edge is held against turning",
            "body2.support.bottom = [\"x\", \"z\", \"phi\"]",
        ),
        (
            "hertz-cylinder --set tasks=[\"pressure\"] --set sliding.speed=2.5 --set wear.k=1e-8",
            "not known before it is meshed",
            "tasks = [\"contact\"]",
        ),
    ] {
        for command in ["check", "run"] {
            let call = bench.call(&format!("{command} {setting}"));
            assert_eq!(call.code, 2, "{command} {setting}: {}{}", call.out, call.err);
            let (said, remedied) = call.err.split_once("remedy: ").unwrap();
            assert!(said.contains(message) && remedied.contains(remedy), "{command} {setting}: {}", call.err);
            assert!(call.out.is_empty(), "{command} {setting}: {}", call.out);
        }
    }
    assert!(!bench.path("out").exists());
}

#[test]
fn a_sweep_over_one_key_twice_is_refused() {
    let bench = Bench::new();
    for (over, message) in [
        ("--over contact.friction=0,.1 --over contact.friction=.2,.3", "gives `contact.friction` twice"),
        ("--over load.force=1,2 --over load={}", "`load.force` and `load`, which replace each other"),
    ] {
        let call = bench.call(&format!("sweep disc-pad {over}"));
        assert!(call.code == 2 && call.err.contains(message), "{over}: {}", call.err);
    }
    // Keys that only begin alike.
    let call = bench.call("sweep disc-pad --over wear.b=1,2 --over wear.beta=1e-4,2e-4 --dry-run");
    assert!(call.code == 0 && call.out.contains("4 points"), "{}{}", call.out, call.err);
}

#[test]
fn the_gap_of_a_run_is_not_taken_beside_the_clearance_that_is_in_it() {
    let bench = Bench::new();
    let fixed = "-q --set mesh.degree=4";
    assert_eq!(bench.call(&format!("run bushing --set tasks=[\"shape\"] {fixed} -o s")).code, 0);
    for file in ["contact.csv", "profile.csv"] {
        let contact = format!("run bushing --set tasks=[\"contact\"] --set contact.gap=s/{file} {fixed} -o c --force");
        let call = bench.call(&contact);
        assert!(call.code == 2 && call.err.contains("is the whole gap of a run"), "{file}: {}", call.err);
        assert!(call.err.contains("contact.clearance = 0"), "{file}: {}", call.err);
        let call = bench.call(&format!("{contact} --set contact.clearance=0"));
        assert_eq!(call.code, 0, "{file}: {}", call.err);
        let number = |folder: &str, pointer: &str| -> f64 {
            let text = bench.read(&format!("{folder}/summary.json"));
            serde_json::from_str::<serde_json::Value>(&text).unwrap().pointer(pointer).unwrap().as_f64().unwrap()
        };
        let (wanted, found) = (number("s", "/pressure/p_max_MPa"), number("c", "/contact/p_max_MPa"));
        assert!((found / wanted - 1.0).abs() < 0.02, "{file}: {found} for {wanted}");
    }
}

#[test]
fn what_is_missing_in_a_call_is_named_for_machines_too() {
    let call = Bench::new().call("run --json");
    assert_eq!(call.code, 2);
    assert!(format!("{}{}", call.out, call.err).contains("were not provided: <SCENE>"), "{}{}", call.out, call.err);
}
