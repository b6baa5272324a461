//! What holds the bodies is said by `check`, and what nothing holds is refused.

use crate::call::Bench;

#[test]
fn check_says_what_each_support_takes_away() {
    let bench = Bench::new();
    for (scene, said) in [
        ("drum-brake-block", &["body 1: held by left and right: sliding, tilt; free: closing\n"][..]),
        (
            "translating-punch",
            &[
                "body 1: held by top: sliding; free: closing, tilt\n",
                "body 2: held by bottom: sliding, closing, tilt; free: nothing\n",
            ],
        ),
        ("translating-punch --set load.tilt=0", &["body 1: held by top: sliding; held by load.tilt: tilt; free: closing\n"]),
        (
            "annular-punch",
            &["body 1: held by top: turning; free: closing\n", "body 2: held by bottom: closing, turning; free: nothing\n"],
        ),
    ] {
        let call = bench.call(&format!("check {scene}"));
        assert!(said.iter().all(|line| call.out.contains(line)), "{scene}: {}{}", call.out, call.err);
    }
    let call = bench.call("check drum-brake-block --json");
    let plan: serde_json::Value = serde_json::from_str(&call.out).unwrap();
    assert_eq!(plan["holding"][0]["free"], serde_json::json!(["closing"]));
    assert_eq!(plan["holding"][1]["held"][0]["by"], serde_json::json!(["inner"]));
}

#[test]
fn a_moment_that_a_guide_carries_is_a_note_with_its_size() {
    let bench = Bench::new();
    let note = |settings: &[&str]| bench.call_with(&[&["check", "translating-punch"], settings].concat()).out;
    let guided = ["--set", "body1.support={left=[\"x\"]}", "--set", "load.moment=50000"];
    let said = note(&guided);
    assert!(said.contains("note [moment-on-guide]") && said.contains("50000 N mm") && said.contains("by left"), "{said}");
    // 1 kN, 3 mm beside the middle.
    let beside = note(&["--set", "body1.support={left=[\"x\"]}", "--set", "load.about=[3,100]"]);
    assert!(beside.contains("moment of 3000 N mm"), "{beside}");
    for settings in [&guided[2..], &guided[..2]] {
        assert!(!note(settings).contains("moment-on-guide"), "{settings:?}");
    }
    assert!(bench.call("explain moment-on-guide").out.contains("hold x at one height"));
}

#[test]
fn a_gap_beyond_a_hundredth_of_the_body_is_a_note_with_its_size() {
    let bench = Bench::new();
    let lints = |young: &str| {
        let call = bench.call(&format!("run drum-brake-block --set body1.material.young={young} --set mesh.degree=4 -q"));
        assert!(call.code < 2, "{}", call.err);
        bench.summary("drum-brake-block")["lints"].to_string()
    };
    assert!(!lints("210_GPa").contains("gap-not-small"));
    let soft = lints("20_MPa");
    assert!(soft.contains("gap-not-small") && soft.contains("100 mm"), "{soft}");
    let given =
        "run translating-punch -q --set tasks=[contact] --set mesh.degree=4 --set contact.gap={s_mm=[-30,30],gap_um=[0,1500]}";
    assert!(bench.call_with(&given.split(' ').collect::<Vec<_>>()).code < 2);
    let lints = bench.summary("translating-punch")["lints"].to_string();
    assert!(lints.contains("gap-not-small") && lints.contains("1.5 mm"), "{lints}");
}

/// A prescribed rigid part may ask for more material than is drawn.
#[test]
fn a_surface_that_is_to_stand_proud_is_said_so() {
    let bench = Bench::new();
    let load = "load={edge=top,as=rigid,force=1000,tilt=1e-5,approach_time=0}";
    let call = bench.call_with(&["run", "translating-punch", "--set", load, "--set", "accuracy=1e-3"]);
    assert!(call.code < 2 && call.out.contains("leave on most, "), "{}{}", call.out, call.err);
    assert!(!call.out.contains("take off"), "{}", call.out);
}

#[test]
fn bodies_that_nothing_holds_are_refused_before_anything_else() {
    let bench = Bench::new();
    for (scene, words) in [
        ("translating-punch --set body1.support={} --set contact.friction=0", "slide along x and turn, and without friction"),
        (
            "translating-punch --set body1.support={} --set contact.friction=0 --set load.tilt=0",
            "slide along x, and without friction",
        ),
        ("translating-punch --set body1.support={} --set tasks=[contact]", "friction drags it along"),
        ("translating-punch --set body1.support={} --set load.tilt=0", "friction drags it along"),
        ("drum-brake-block --set body1.support={} --set contact.friction=0 --set tasks=[contact]", "slide along x and turn"),
        ("hertz-cylinder --set body1.support={}", "slide along x and turn, and without friction"),
        ("hertz-cylinder --set body2.support={}", "body 2 can slide along x and slide along z and turn"),
        ("hertz-cylinder --set body2.support={bottom=[\"x\"]}", "body 2 can slide along z"),
        ("cattaneo-mindlin --set body2.support={bottom=[\"z\"]}", "body 2 can slide along x"),
        ("hertz-sphere --set body2.support={bottom=[\"x\"]}", "body 2 can slide along z"),
        ("hertz-sphere --set body2.support={left=[\"z\"]}", "lies on the axis of revolution"),
    ] {
        let call = bench.check_and_run(scene);
        assert_eq!(call.code, 2, "{scene}: {}", call.out);
        assert!(call.err.contains(words) && call.err.contains("remedy: "), "{scene}: {}", call.err);
    }
}
