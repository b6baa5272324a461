//! `check` and `run` agree on what is sound, whatever is wrong with a scene.

use crate::call::Bench;

#[test]
fn what_cannot_be_meshed_is_refused_by_check_as_by_run() {
    let bench = Bench::new();
    for (scene, words) in [
        ("drum-brake-block --set mesh={degree=4,layers=30}", "30 layers"),
        ("drum-brake-block --set body2.geometry.ring.inner=199.9999999", "make the body less thin"),
        ("drum-brake-block --set body1.geometry.shoe-block.half_angle=1.5533", "make the body less thin"),
        ("translating-punch --set body2.geometry.rectangle.x=[-1e12,1e12]", "2e12 mm wide for a contact of 60 mm"),
        ("translating-punch --set load.edge=left", "rigid edge"),
        ("hertz-cylinder --set tasks=[contact,wear] --set sliding.speed=1 --set wear.k=1e-7", "has the task wear alone"),
        ("hertz-cylinder --set body2.geometry.rectangle.x=[-100,90]", "symmetric"),
        ("cattaneo-mindlin --set contact.friction=0", "friction"),
        ("cattaneo-mindlin --set load.tilt=1e-3", "without tilt"),
        ("hertz-sphere --set load.twist=1e-3", "nothing resists"),
    ] {
        let call = bench.check_and_run(scene);
        assert_eq!(call.code, 2, "{scene}: {}", call.out);
        assert!(call.err.contains(words), "{scene}: {}", call.err);
    }
}

/// A load that no pressure carries is an answer of `run`, with exit 1, which `check` foretells.
#[test]
fn check_says_that_no_pressure_carries_a_load_where_run_ends_without_one() {
    let bench = Bench::new();
    for (scene, words) in [
        ("rectangular-punch --set optimum.p_max=4", "under p_max"),
        ("rectangular-punch --set load.moment=310000", "at or beyond the edge"),
        ("elliptic-punch --set optimum.p_max=1e-3", "under p_max"),
        ("translating-punch --set optimum.p_max=1.6 --set tasks=[pressure]", "under p_max"),
        ("drum-brake-block --set optimum.p_max=.1", "under p_max"),
    ] {
        let call = |call: &str| bench.call_with(&call.split_whitespace().collect::<Vec<_>>());
        let [check, run] = ["check", "run"].map(|command| call(&format!("{command} {scene} --set output.report=false")));
        assert_eq!((check.code, run.code), (0, 1), "{scene}: {}{}", check.err, run.out);
        assert!(check.out.contains("\nno answer: no pressure") && check.out.contains(words), "{scene}: {}", check.out);
        let plan: serde_json::Value = serde_json::from_str(&call(&format!("check {scene} --json")).out).unwrap();
        assert!(plan["no_answer"].as_str().unwrap().contains(words), "{scene}: {plan}");
    }
    for scene in ["rectangular-punch", "elliptic-punch", "disc-pad", "translating-punch", "bushing"] {
        assert!(!bench.call(&format!("check {scene}")).out.contains("no answer"), "{scene}");
    }
}

/// Every single support on every edge of every built-in scene with bodies.
#[test]
fn check_and_run_agree_under_all_supports() {
    let bench = Bench::new();
    for (scene, edges) in [
        ("translating-punch", [&["top", "left", "bottom"][..], &["bottom", "left", "top"]]),
        ("drum-brake-block", [&["left", "top", "inner"], &["inner", "outer"]]),
        ("drum-brake-ring", [&["left", "centre", "outer"], &["inner", "outer"]]),
        ("annular-punch", [&["top", "left"], &["bottom", "left", "top"]]),
        ("hertz-cylinder", [&["centre", "top", "arc"], &["bottom", "left", "top"]]),
        ("hertz-sphere", [&["centre", "top", "arc"], &["bottom", "left", "right"]]),
        ("cattaneo-mindlin", [&["centre", "top"], &["bottom", "left"]]),
        ("lining-on-back", [&["left", "top", "face"], &["inner", "outer"]]),
        ("internal-shoe", [&["left", "face"], &["inner", "outer"]]),
    ] {
        for (body, edges) in ["body1", "body2"].iter().zip(edges) {
            let held = edges.iter().flat_map(|edge| ["\"x\"", "\"z\"", "\"x\",\"z\""].map(|c| format!("{{{edge}=[{c}]}}")));
            for support in held.chain(["{}".to_string()]) {
                let sets = format!("--set {body}.support={support} --set mesh.degree=4 --set output.report=false -q");
                let run = bench.check_and_run(&format!("{scene} {sets}"));
                println!("{scene} {body} {support}: {}", run.code);
                assert!([0, 1, 2].contains(&run.code), "{}", run.err);
            }
        }
    }
}
