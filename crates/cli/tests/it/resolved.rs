//! scene.resolved.toml: every default, base units, and the same result when it is run.

use crate::call::{Bench, files};

#[test]
fn the_resolved_scene_gives_the_same_result() {
    let bench = Bench::new();
    for scene in [
        "drum-brake-block --set tasks=[pressure]",
        "drum-brake-ring --set tasks=[pressure] --set optimum.functional=wear-power --set optimum.q=inf",
        "translating-punch --set tasks=[pressure] --set load.moment=-5_kN_mm --set optimum.q=2",
        "annular-punch --set tasks=[pressure] --set optimum.functional=friction-power --set optimum.q=-1",
        "disc-pad",
        "pinned-shoe",
        "pivoted-shoe",
        "rectangular-punch",
        "elliptic-punch",
        "journal-arc",
    ] {
        let call = bench.call(&format!("run {scene} -q -o first"));
        assert_eq!(call.code, 0, "{scene}: {}", call.err);
        std::fs::copy(bench.path("first/scene.resolved.toml"), bench.path("again.toml")).unwrap();
        let call = bench.call("run again.toml -q -o second");
        assert_eq!(call.code, 0, "{scene}: {}", call.err);
        for name in files(&bench.path("first")) {
            if !["timing.json", "summary.json", "report.html"].contains(&name.as_str()) {
                assert!(
                    bench.bytes(&format!("first/{name}")) == bench.bytes(&format!("second/{name}")),
                    "{scene}: {name} differs"
                );
            }
        }
        let read = |folder: &str| -> serde_json::Value {
            let mut summary: serde_json::Value = serde_json::from_str(&bench.read(&format!("{folder}/summary.json"))).unwrap();
            assert!(summary.as_object_mut().unwrap().remove("scene").is_some());
            summary
        };
        assert_eq!(read("first"), read("second"), "{scene}");
    }
}

/// Every built-in scene, with its own tasks and with each other that it can have, on a coarse mesh: all files but the times.
#[test]
fn a_resolved_scene_run_again_gives_the_same_bytes() {
    let bench = Bench::new();
    let mut scenes = 0;
    for name in bench.call("new --list").out.lines().map(|line| line.split(' ').next().unwrap().to_string()) {
        for tasks in ["", "pressure", "contact", "shape", "wear"] {
            let tasks = if tasks.is_empty() { String::new() } else { format!("--set tasks=[{tasks}]") };
            let call = bench.call(&format!("run {name} -q -o first/{name} {tasks} --set mesh.degree=4 --set mesh.layers=3"));
            if call.code == 2 {
                assert!(!tasks.is_empty(), "{name}: {}", call.err);
                continue;
            }
            scenes += 1;
            std::fs::copy(bench.path(&format!("first/{name}/scene.resolved.toml")), bench.path(&format!("{name}.toml"))).unwrap();
            let again = bench.call(&format!("run {name}.toml -q -o second/{name}"));
            assert_eq!(again.code, call.code, "{name} {tasks}: {}", again.err);
            for folder in ["first", "second"] {
                std::fs::remove_file(bench.path(&format!("{folder}/{name}/timing.json"))).unwrap();
            }
            let [first, second] = ["first", "second"].map(|folder| bench.path(&format!("{folder}/{name}")));
            assert_eq!(files(&first), files(&second), "{name} {tasks}");
            for file in files(&first) {
                let [a, b] = [&first, &second].map(|folder| std::fs::read(folder.join(&file)).unwrap());
                assert!(a == b, "{name} {tasks}: {file} differs");
            }
        }
    }
    assert!(scenes > 40, "{scenes}");
}

#[test]
fn the_hash_is_that_of_the_resolved_scene() {
    let bench = Bench::new();
    assert_eq!(bench.call("run disc-pad -q").code, 0);
    let summary = bench.summary("disc-pad");
    let hash = summary["scene_sha256"].as_str().unwrap();
    let digest = <sha2::Sha256 as sha2::Digest>::digest(bench.bytes("out/disc-pad/scene.resolved.toml"));
    let text: String = digest.iter().map(|byte| format!("{byte:02x}")).collect();
    assert_eq!(hash, text);
}

#[test]
fn quantities_come_out_in_base_units_with_defaults() {
    let bench = Bench::new();
    assert_eq!(bench.call("run drum-brake-block --set tasks=[pressure] -q").code, 0);
    let scene: toml::Table = bench.read("out/drum-brake-block/scene.resolved.toml").parse().unwrap();
    assert_eq!(scene["body1"]["material"]["young"].as_float(), Some(210e3));
    assert_eq!(scene["body1"]["geometry"]["shoe-block"]["half_angle"].as_float(), Some(30.0 * std::f64::consts::PI / 180.0));
    assert_eq!(scene["load"]["force"].as_float(), Some(10e3));
    assert_eq!(scene["wear"]["a"].as_array().map(Vec::len), Some(2));
    assert_eq!(scene["wear"]["counterface"].as_str(), Some("revolving"));
    assert_eq!(scene["optimum"]["balance"].as_str(), Some("equilibrium"));
    assert_eq!(scene["contact"]["shear"].as_bool(), Some(true));
}
