//! The surface as it is now against as machined, of scenes that ask for contact and shape.

use crate::call::Bench;

const BOTH: &str = "tasks=[pressure,contact,shape] --set mesh.degree=6";

/// What a screen says, without its lines.
fn words_of(screen: &str) -> String {
    screen.split_whitespace().collect::<Vec<_>>().join(" ")
}

#[test]
fn a_scene_with_contact_and_shape_says_what_machining_brings() {
    let bench = Bench::new();
    let call = bench.call(&format!("run drum-brake-block --set {BOTH}"));
    assert_eq!(call.code, 0, "{}", call.err);
    let summary = bench.summary("drum-brake-block");
    let of = |part: &str, key: &str| summary[part][key].as_f64();
    let machining = &summary["machining"];
    assert_eq!(machining["p_max_now_MPa"].as_f64(), of("contact", "p_max_MPa"));
    assert_eq!(machining["p_max_then_MPa"].as_f64(), of("pressure", "p_max_MPa"));
    assert_eq!(machining["gap_max_um"].as_f64(), of("shape", "gap_max_um"));
    assert_eq!(machining["contact_share_then"].as_f64(), Some(1.0));
    assert!(machining["contact_share_now"].as_f64().is_some_and(|share| share > 0.0 && share <= 1.0), "{machining}");
    // Neither a roughness nor a run in time is given: nothing is said of what they would tell.
    assert!(machining["worth_machining"].is_null() && machining["run_in_distance_saved_mm"].is_null(), "{machining}");
    let said = words_of(&call.out);
    assert!(said.contains("now without limit at its edges on") && said.contains("; as machined at most"), "{said}");
    let page = bench.read("out/drum-brake-block/report.html");
    for words in ["as it is now", "As it is now against as machined", "part of the surface in contact as machined"] {
        assert!(page.contains(words), "{words}");
    }
    // contact.csv is that of the last task.
    assert!(bench.read("out/drum-brake-block/contact.csv").lines().next().unwrap().ends_with("uphi2_um,status"));
}

#[test]
fn a_shape_that_drowns_in_the_roughness_is_said_not_to_be_worth_machining() {
    let bench = Bench::new();
    let worth = |roughness: &str| {
        let call = bench.call(&format!("run drum-brake-block --set {BOTH} --set contact.roughness={roughness}"));
        assert_eq!(call.code, 0, "{}", call.err);
        (bench.summary("drum-brake-block")["machining"]["worth_machining"].clone(), call.out)
    };
    let (rough, said) = worth("2_um");
    assert!(rough == false && words_of(&said).contains("Not worth machining"), "{said}");
    let (fine, said) = worth("0.1_um");
    assert!(fine == true && !said.contains("Not worth machining"), "{said}");
    // A surface that is a crown of 30 um has these to lose, whatever the shape takes off the nominal one.
    let crowned = ["--set", "contact.gap={crown='30 um'}", "--set", "contact.roughness=2 um"];
    let args: Vec<&str> = ["run", "drum-brake-block", "--set"].into_iter().chain(BOTH.split(' ')).chain(crowned).collect();
    let call = bench.call_with(&args);
    let machining = &bench.summary("drum-brake-block")["machining"];
    assert!(machining["worth_machining"] == true && !call.out.contains("Not worth machining"), "{}", call.out);
    assert!(machining["differs_um"].as_f64().is_some_and(|apart| (28.0..32.0).contains(&apart)), "{machining}");
    let call = bench.call("run drum-brake-block --set tasks=[contact,shape] --set contact.roughness=-1");
    assert!(call.code == 2 && call.err.contains("contact.roughness") && call.err.contains("remedy:"), "{}", call.err);
    let plan = bench.call("check drum-brake-block --json --set contact.roughness=0.001").out;
    let plan: serde_json::Value = serde_json::from_str(&plan).unwrap();
    assert_eq!(plan["unused_keys"], serde_json::json!(["contact.roughness"]));
}

#[test]
fn scenes_that_do_not_ask_for_both_say_nothing_of_it() {
    let bench = Bench::new();
    assert_eq!(bench.call("run drum-brake-block --set mesh.degree=4").code, 0);
    assert!(bench.summary("drum-brake-block")["machining"].is_null());
}

#[test]
fn a_screen_that_says_what_to_machine_has_the_pressure_and_the_brake_of_that() {
    let bench = Bench::new();
    let said = |folder: &str, tasks: &str, more: &str| {
        let call = bench.call(&format!("run pinned-shoe-elastic --set {tasks} --set accuracy=1e-3 {more} -o {folder}"));
        assert_eq!(call.code, 0, "{}", call.err);
        call.out.lines().map(String::from).collect::<Vec<String>>()
    };
    let shape = said("shape", "tasks=[pressure,shape]", "");
    let worn = said("worn", "tasks=[pressure,shape,wear]", "--set wear.until=10h");
    for name in ["pressure", "wear", "brake"] {
        let line = |lines: &[String]| lines.iter().filter(|line| line.starts_with(name)).cloned().collect::<Vec<String>>();
        assert!(line(&shape).len() == 1 && line(&shape) == line(&worn), "{shape:?} {worn:?}");
    }
    assert!(worn.iter().any(|line| line.starts_with("in time   depth ")), "{worn:?}");
    let page = bench.read("worn/report.html");
    assert!(page.contains(">worn<") && page.contains(">as machined<"));
}
