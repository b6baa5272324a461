//! What has no answer is a solution that says so.

use wearshape::Status;

use crate::common::{scene, solved};

#[test]
fn a_load_without_an_answer_is_a_solution_with_a_reason() {
    for (name, settings, why) in [
        // 40 mm beside the middle of a punch of half-width 30 mm.
        ("translating-punch", &["load.moment=40 kN mm", "tasks=[pressure]"][..], "moment"),
        ("translating-punch", &["load.moment=40 kN mm", "mesh.degree=4"], "moment"),
        ("translating-punch", &["load.moment=40 kN mm", "mesh.degree=4", "tasks=[contact]"], "no balance"),
        ("translating-punch", &["load.approach=1e-3", "load.tilt=1e-3", "mesh.degree=4"], "no force goes with"),
        ("translating-punch", &["load.moment=40 kN mm", "mesh.degree=4", "tasks=[wear]"], "no balance"),
        (
            "translating-punch",
            &["wear.beta=1e-100", "wear.b=600", "mesh.degree=4", "tasks=[wear]"],
            "nothing wears in a finite time",
        ),
        // Held, and a hundred thousand times as high as wide.
        ("punch-wear", &["body1.geometry.rectangle.z.1=3.5e6", "mesh.degree=6"], "too far apart for the digits"),
        ("annular-punch", &["optimum.p_max=1", "tasks=[pressure]"], "under p_max"),
    ] {
        let solution = solved(&scene(name, settings));
        let reason = solution.reason.clone().unwrap_or_default();
        println!("{name} {settings:?}: {reason}");
        assert_eq!(solution.status, Status::Refused, "{settings:?}");
        assert!(!reason.is_empty() && reason.contains(why), "{settings:?}: {reason}");
        assert!(solution.shape.is_none() && solution.wear.is_none(), "{settings:?}");
    }
}

/// The fault of a built-in scene with settings.
fn fault(name: &str, settings: &[&str]) -> wearshape::Fault {
    let settings: Vec<String> = settings.iter().map(|s| s.to_string()).collect();
    let document = wearshape::Document::read(name, wearshape::builtin(name).unwrap().text, &settings).unwrap();
    wearshape::Problem::new(&document, &|_| Err("no file".into())).unwrap_err()
}

#[test]
fn a_depth_that_nothing_wears_is_no_end_of_a_run() {
    let settings = ["tasks=[\"wear\"]", "wear={ k = [0, 1e-6], counterface = \"congruent\", until = { depth = 0.1 } }"];
    let refused = fault("annular-punch", &settings);
    assert_eq!((refused.code, refused.key.as_deref()), ("no-wear", Some("wear.until.depth")));
}

#[test]
fn bodies_that_nothing_holds_are_refused_by_their_free_motions() {
    let first = fault("drum-brake-block", &["body1.support={ }"]);
    assert_eq!((first.code, first.key.as_deref()), ("not-held", Some("body1.support")));
    assert!(first.message.contains("slide along x and turn"), "{}", first.message);
    for (support, motions) in [
        ("{ }", "slide along x and slide along z and turn"),
        ("{ inner = [\"x\"] }", "slide along z"),
        ("{ inner = [\"z\"] }", "slide along x"),
    ] {
        let second = fault("drum-brake-block", &[&format!("body2.support={support}")]);
        assert_eq!((second.code, second.key.as_deref()), ("not-held", Some("body2.support")));
        assert!(second.message.contains(&format!("body 2 can {motions},")), "{}", second.message);
    }
    let turned = fault("annular-punch", &["body2.support={ }"]);
    assert!(turned.message.contains("body 2 can slide along z,"), "{}", turned.message);
}
