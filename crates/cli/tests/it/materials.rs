//! Materials by name: the same as their numbers, in bodies, blocks and groups of a mesh; and what is no name.

use crate::call::{Bench, files};

/// The words of `wearshape materials` in columns of a name: Young's modulus (GPa) and Poisson's ratio.
fn listed(bench: &Bench) -> Vec<(String, [String; 2])> {
    let call = bench.call("materials");
    assert_eq!(call.code, 0, "{}", call.err);
    let rows = call.out.lines().skip(2).take_while(|line| !line.is_empty());
    rows.map(|line| {
        let words: Vec<&str> = line.split_whitespace().collect();
        (words[0].to_string(), [words[1].to_string(), words[2].to_string()])
    })
    .collect()
}

/// The finished folder without what tells of the call: the text of the scene as it was given, and its times.
fn same_results(bench: &Bench, [one, other]: [&str; 2]) {
    for name in files(&bench.path(one)) {
        if !["timing.json", "summary.json", "report.html"].contains(&name.as_str()) {
            assert!(bench.bytes(&format!("{one}/{name}")) == bench.bytes(&format!("{other}/{name}")), "{name} differs");
        }
    }
}

#[test]
fn a_name_means_its_numbers_in_the_resolved_scene_and_in_the_results() {
    let bench = Bench::new();
    let coarse = "--set mesh.degree=3 --set mesh.layers=1 -q";
    let numbers = "--set body2.material.young=110_GPa --set body2.material.poisson=.26";
    for (sets, folder) in [(numbers, "a"), ("--set body2.material=grey-cast-iron", "b")] {
        let call = bench.call(&format!("run drum-brake-block {coarse} {sets} -o {folder}"));
        assert!(call.code < 2, "{}", call.err);
    }
    same_results(&bench, ["a", "b"]);
    let resolved = bench.read("b/scene.resolved.toml");
    assert!(!resolved.contains("grey-cast-iron") && resolved.contains("110000"), "{resolved}");
    std::fs::copy(bench.path("b/scene.resolved.toml"), bench.path("again.toml")).unwrap();
    assert!(bench.call("run again.toml -q -o c").code < 2);
    same_results(&bench, ["b", "c"]);
}

#[test]
fn every_listed_name_is_a_material_of_a_body() {
    let bench = Bench::new();
    let listed = listed(&bench);
    assert!(listed.len() >= 20, "{listed:?}");
    for (name, [young, poisson]) in &listed {
        let call = bench.call(&format!("check translating-punch -v --set body1.material={name}"));
        assert_eq!(call.code, 0, "{name}: {}", call.err);
        let by_numbers = format!("check translating-punch -v --set body1.material={{young=\"{young}_GPa\",poisson={poisson}}}");
        let same = |text: &str| text.lines().filter(|line| !line.contains("about ")).collect::<Vec<_>>().join("\n");
        assert_eq!(same(&call.out), same(&bench.call(&by_numbers).out), "{name}");
    }
}

#[test]
fn blocks_and_groups_of_a_mesh_take_names_too() {
    let bench = Bench::new();
    let sets = "--set body1.geometry.blocks.materials.lining=brake-lining --set body1.geometry.blocks.materials.steel=steel";
    let call = bench.call(&format!("check internal-shoe {sets}"));
    assert_eq!(call.code, 0, "{}", call.err);
    let data = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/meshes");
    bench.file("lining.msh", &std::fs::read_to_string(data.join("lining.msh")).unwrap());
    let scene = std::fs::read_to_string(data.join("lining.toml")).unwrap();
    let named = scene.replace("steel = { young = \"210 GPa\", poisson = 0.3 }", "steel = \"steel\"");
    assert_ne!(named, scene);
    bench.file("lining.toml", &scene);
    bench.file("named.toml", &named);
    for name in ["lining", "named"] {
        let call = bench.call(&format!("run {name}.toml -q -o {name} --set mesh.degree=3 --set mesh.layers=1"));
        assert!(call.code < 2, "{}", call.err);
    }
    let resolved = |name: &str| bench.read(&format!("{name}/scene.resolved.toml"));
    assert_eq!(resolved("lining"), resolved("named"));
    same_results(&bench, ["lining", "named"]);
}

#[test]
fn a_name_that_is_none_is_answered_by_the_nearest_with_its_place() {
    let bench = Bench::new();
    let text = bench.call("new drum-brake-block").out;
    let line = "body2.material = { young = \"210 GPa\", poisson = 0.3 }";
    assert!(text.contains(line));
    for (word, words) in [
        ("\"stele\"", "did you mean `steel`?"),
        ("\"cast-iron\"", "grey-cast-iron"),
        ("\"Steel\"", "did you mean `steel`?"),
        ("\"\"", "known here: steel"),
    ] {
        bench.file("s.toml", &text.replace(line, &format!("body2.material = {word}")));
        let call = bench.check_and_run("s.toml");
        assert_eq!(call.code, 2, "{word}");
        let place = text.lines().position(|own| own == line).unwrap() + 1;
        assert!(call.err.contains("there is no material") && call.err.contains(words), "{}", call.err);
        assert!(call.err.contains(&format!("s.toml:{place}:")), "{}", call.err);
    }
    // One number of a material that is given by its name.
    bench.file("s.toml", &text.replace(line, "body2.material = \"steel\""));
    let call = bench.check_and_run("s.toml --set body2.material.young=200_GPa");
    assert_eq!(call.code, 2, "{}", call.out);
}

#[test]
fn editors_know_the_names() {
    let schema: serde_json::Value = serde_json::from_str(&Bench::new().call("schema").out).unwrap();
    let names = &schema["definitions"]["Material"]["anyOf"][1]["enum"];
    assert!(names.as_array().unwrap().iter().any(|name| name == "steel"), "{names}");
}
