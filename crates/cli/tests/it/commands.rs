//! Help, schema, completions, page, and what is not there yet.

use crate::call::Bench;

#[test]
fn help_and_version_go_to_stdout_with_exit_0() {
    let bench = Bench::new();
    let call = bench.call("--help");
    assert_eq!((call.code, call.err.as_str()), (0, ""));
    assert!(call.out.contains("wearshape run drum-brake-block"), "{}", call.out);
    let call = bench.call("--version");
    assert_eq!((call.code, call.out.trim()), (0, concat!("wearshape ", env!("CARGO_PKG_VERSION"))));
    for command in ["run", "check", "new", "sweep", "study", "diff", "report", "reproduce", "schema", "completions"] {
        let call = bench.call(&format!("{command} --help"));
        assert!(call.code == 0 && (call.out.contains("Example") || command == "completions"), "{command}: {}", call.out);
    }
}

#[test]
fn a_wrong_command_is_exit_2() {
    let bench = Bench::new();
    for args in ["", "rnu", "run", "run a b c", "new", "run drum-brake-block --sample many"] {
        let call = bench.call(args);
        assert_eq!(call.code, 2, "{args}");
        assert!(!call.err.is_empty() && call.out.is_empty(), "{args}");
    }
}

#[test]
fn the_schema_knows_units_and_least_numbers() {
    let bench = Bench::new();
    let schema: serde_json::Value = serde_json::from_str(&bench.call("schema").out).unwrap();
    let definitions = &schema["definitions"];
    let length = definitions["Length"]["anyOf"][1]["pattern"].as_str().unwrap();
    assert!(length.contains("(mm|m|cm|um|") && length.starts_with('^') && length.ends_with('$'), "{length}");
    let least = |of: &serde_json::Value, key: &str| of["properties"][key]["exclusiveMinimum"].as_f64();
    assert_eq!(least(&schema, "thickness"), Some(0.0));
    assert_eq!(least(&definitions["MaterialNumbers"], "young"), Some(0.0));
    assert_eq!(least(&definitions["MaterialNumbers"], "poisson"), Some(-1.0));
    assert_eq!(definitions["Contact"]["properties"]["friction"]["minimum"].as_f64(), Some(0.0));
    let mesh = &definitions["MeshFile"]["properties"];
    assert!(["scale", "rotate", "move"].iter().all(|key| mesh[key].is_object()), "{mesh}");
}

/// Each with the last number that the program takes and one that it refuses.
#[test]
fn the_schema_has_the_bounds_that_the_program_has() {
    let bench = Bench::new();
    let schema: serde_json::Value = serde_json::from_str(&bench.call("schema").out).unwrap();
    let of = |table: &str, key: &str| match table {
        "" => schema["properties"][key].clone(),
        table => schema["definitions"][table]["properties"][key].clone(),
    };
    for (table, key, word, bound, taken, refused) in [
        ("", "accuracy", "minimum", 1e-13, "accuracy=1e-13", "accuracy=9e-14"),
        ("", "accuracy", "maximum", 0.5, "accuracy=0.5", "accuracy=0.51"),
        ("Mesh", "degree", "minimum", 1.0, "mesh={degree=1}", "mesh={degree=0}"),
        ("Mesh", "degree", "maximum", 24.0, "mesh={degree=24}", "mesh={degree=25}"),
        ("Mesh", "layers", "maximum", 60.0, "mesh={degree=4,layers=60}", "mesh={degree=4,layers=61}"),
        ("Contact", "clearance", "minimum", 0.0, "contact.clearance=0", "contact.clearance=-0.001"),
        ("Contact", "roughness", "exclusiveMinimum", 0.0, "contact.roughness=1e-9", "contact.roughness=0"),
        ("Wear", "a", "minimum", 0.0, "wear.a=0", "wear.a=-0.1"),
        ("Wear", "wearable", "exclusiveMinimum", 0.0, "wear.wearable=1e-9", "wear.wearable=0"),
        ("Body", "wearable", "exclusiveMinimum", 0.0, "body1.wearable=1e-9", "body1.wearable=0"),
        ("", "tasks", "minItems", 1.0, "tasks=[pressure]", "tasks=[]"),
    ] {
        assert_eq!(of(table, key)[word].as_f64(), Some(bound), "{key}: {}", of(table, key));
        // A surface without bodies has no cells in which so many layers would be too thin.
        let scene = match key {
            "clearance" => "bushing",
            "layers" => "disc-pad",
            _ => "drum-brake-block",
        };
        for (set, code) in [(taken, 0), (refused, 2)] {
            let call = bench.call(&format!("check {scene} --set {set}"));
            assert_eq!(call.code, code, "{set}: {}", call.err);
        }
    }
    // A mesh has a degree, unless an accuracy is given beside it.
    let no_degree = serde_json::json!({ "required": ["mesh"], "properties": { "mesh": { "not": { "required": ["degree"] } } } });
    assert_eq!((&schema["if"], &schema["then"]), (&no_degree, &serde_json::json!({ "required": ["accuracy"] })));
    let text = include_str!("../../../../data/scenes/drum-brake-block.toml");
    for (mesh, code) in [("accuracy = 1e-6\nmesh.layers = 2\n", 0), ("mesh.layers = 2\n", 2), ("mesh.degree = 4\n", 0)] {
        bench.file("x.toml", &text.replace("accuracy = 1e-6 ", mesh));
        let call = bench.call("check x.toml");
        assert_eq!(call.code, code, "{mesh}: {}", call.err);
    }
}

#[test]
fn the_schema_is_draft_7_and_knows_the_keys() {
    let bench = Bench::new();
    let schema: serde_json::Value = serde_json::from_str(&bench.call("schema").out).unwrap();
    assert_eq!(schema["$schema"], "http://json-schema.org/draft-07/schema#");
    assert_eq!(schema["additionalProperties"], false);
    for key in ["units", "body1", "contact", "load", "wear", "optimum", "surface", "mesh", "accuracy", "tasks"] {
        assert!(schema["properties"][key].is_object(), "{key}");
    }
    assert_eq!(schema["required"], serde_json::json!(["units"]));
}

#[test]
fn completions_come_for_every_shell() {
    let bench = Bench::new();
    for shell in ["bash", "zsh", "fish", "elvish", "powershell"] {
        let call = bench.call(&format!("completions {shell}"));
        assert!(call.code == 0 && call.out.contains("wearshape"), "{shell}");
    }
}

#[test]
fn the_page_is_rebuilt_to_the_same_bytes_and_asks_for_nothing_from_outside() {
    let bench = Bench::new();
    assert_eq!(bench.call("run disc-pad -q").code, 0);
    let page = bench.read("out/disc-pad/report.html");
    for word in ["src=", "http://", "https://", "@import", "url("] {
        let hits = page.replace("http://www.w3.org/2000/svg", "");
        assert!(!hits.contains(word), "the page contains {word}");
    }
    std::fs::remove_file(bench.path("out/disc-pad/report.html")).unwrap();
    let call = bench.call("report out/disc-pad");
    assert_eq!(call.code, 0, "{}", call.err);
    assert!(bench.read("out/disc-pad/report.html") == page, "the page differs");
    assert_eq!(bench.call("report nowhere").code, 2);
    let table = bench.read("out/disc-pad/contact.csv");
    for emptied in ["", table.split_inclusive('\n').next().unwrap()] {
        bench.file("out/disc-pad/contact.csv", emptied);
        let call = bench.call("report out/disc-pad");
        assert_eq!(call.code, 2, "{emptied:?}: {}", call.err);
        for words in ["out/disc-pad: contact.csv is damaged: it has no rows", "remedy: run the scene again"] {
            assert!(call.err.contains(words), "{}", call.err);
        }
        assert!(bench.read("out/disc-pad/report.html") == page, "the page of before is gone");
    }
    bench.file("out/disc-pad/contact.csv", &table);
    bench.file("out/disc-pad/summary.json", "{");
    assert_eq!(bench.call("report out/disc-pad").code, 2);
}

#[test]
fn colour_is_only_for_terminals() {
    let bench = Bench::new();
    let call = bench.call("check drum-brake-block --set thickness=-1");
    assert!(!call.err.contains('\x1b'), "{}", call.err);
}

#[test]
fn the_first_screen_has_ten_lines_at_most_and_begins_with_the_verdict() {
    let bench = Bench::new();
    for scene in ["disc-pad", "drum-brake-block --set tasks=[pressure] --set contact.friction=0 --set optimum.q=3"] {
        let call = bench.call(&format!("run {scene}"));
        assert_eq!(call.code, 0, "{}", call.err);
        assert!(call.out.lines().count() <= 10, "{}", call.out);
        assert!(call.out.starts_with("The worn-in pressure is "), "{}", call.out);
        assert!(call.out.lines().last().unwrap().starts_with("files     out"), "{}", call.out);
    }
    assert!(bench.call("run disc-pad -q").out.is_empty());
}

#[test]
fn check_draws_the_scene_where_it_is_asked_to() {
    let bench = Bench::new();
    let call = bench.call("check drum-brake-block -v");
    assert_eq!(call.code, 0, "{}", call.err);
    assert!(bench.read("drum-brake-block.svg").starts_with("<svg ") && call.err.contains("drum-brake-block.svg"), "{}", call.err);
    assert_eq!(bench.call("check disc-pad -q -o pad.svg").code, 0);
    assert!(bench.read("pad.svg").contains("Disc brake pad"));
    let call = bench.call("check disc-pad -o no/such/folder/pad.svg");
    assert!(call.code == 2 && call.err.contains("cannot write"), "{}", call.err);
    // A drawing may be drawn anew, and nothing else is written over.
    assert_eq!(bench.call("check drum-brake-block -q -o pad.svg").code, 0);
    assert!(!bench.read("pad.svg").contains("Disc brake pad"));
    assert_eq!(bench.call("new disc-pad mine.toml").code, 0);
    let (before, call) = (bench.read("mine.toml"), bench.call("check mine.toml -o mine.toml"));
    assert!(call.code == 2 && call.err.contains("mine.toml exists already"), "{}", call.err);
    assert_eq!(bench.read("mine.toml"), before);
}

#[test]
fn a_run_in_time_has_curves_over_time() {
    let bench = Bench::new();
    let call = bench.call("run punch-wear --set mesh.degree=4 --set mesh.layers=3");
    assert_eq!(call.code, 0, "{}", call.err);
    assert!(call.out.contains(" um/h") && call.out.contains(" mm per 1000 km"), "{}", call.out);
    let page = bench.read("out/punch-wear/report.html");
    for name in ["history-pressure", "history-depth", "history-volume", "gap", "scene"] {
        assert!(bench.read(&format!("out/punch-wear/plots/{name}.svg")).contains("role=\"img\""), "{name}");
    }
    assert!(page.contains("href=\"history.csv\"") && page.contains("href=\"run.mcap\""));
    assert!(bench.call("report out/punch-wear").code == 0 && page == bench.read("out/punch-wear/report.html"));
}

#[test]
fn a_report_under_a_schedule_tells_no_load_and_speed_as_if_they_held() {
    let bench = Bench::new();
    let run = "run punch-wear -q --set mesh.degree=4 --set mesh.layers=3 --set wear.until=40_s";
    let told = |schedule: &str| {
        let call = bench.call(&format!("{run} --set schedule={{time=[0,10,20],{schedule}}}"));
        assert_eq!(call.code, 0, "{}", call.err);
        let drawing = bench.read("out/punch-wear/plots/scene.svg");
        // Of wrapped lines too.
        let words: Vec<&str> = drawing.split('<').filter_map(|part| Some(part.split_once('>')?.1.trim())).collect();
        let words = words.join(" ").split_whitespace().collect::<Vec<_>>().join(" ");
        let has = |start: &str| words.contains(&format!("{start} by the schedule"));
        let axis = bench.read("out/punch-wear/plots/history-depth.svg").contains("mm of sliding a second");
        (has("load: 1000 N times 0.5 to 1"), has("body 2 slides at 5 mm/s times 0.1 to 3"), axis)
    };
    assert_eq!(told("force=[1,.5,1],speed=[1,.1,3]"), (true, true, false));
    assert_eq!(told("force=[1,.5,1]"), (true, false, true));
    // The other way it slides as fast.
    assert_eq!(told("speed=[1,-1,1]"), (false, false, true));
}
