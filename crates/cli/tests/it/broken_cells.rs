//! Broken blocks and mesh files: exit 2, with code, key and line.

use crate::call::Bench;

const BLOCKS: &str = r#"units = "N-mm"
kinematics = "plane-stress"
thickness = 10
tasks = ["shape"]
accuracy = 1e-2
contact = { edges = ["low", "top"] }
sliding = { speed = 5 }
load = { edge = "high", as = "pressure", force = 600 }
wear = { beta = 1e-6 }
body1.support = { sides = ["x"] }
body1.material = { young = "210 GPa", poisson = 0.3 }
body2.material = { young = "210 GPa", poisson = 0.3 }
body2.geometry.rectangle = { x = [-20, 20], z = [-15, 0] }
body2.support = { bottom = ["x", "z"] }
[body1.geometry.blocks]
points.a = [-10, 0]
points.b = [10, 0]
points.c = [10, 10]
points.d = [-10, 10]
points.e = [10, 25]
points.f = [-10, 25]
curves.low.line = ["a", "b"]
curves.bond.line = ["d", "c"]
curves.high.line = ["e", "f"]
curves.left1.line = ["a", "d"]
curves.left2.line = ["d", "f"]
curves.right1.line = ["b", "c"]
curves.right2.line = ["c", "e"]
cells.soft = { curves = ["low", "right1", "bond", "left1"], material = "lining" }
cells.back = { curves = ["bond", "right2", "high", "left2"] }
edges.low = ["low"]
edges.high = ["high"]
edges.sides = ["left1", "left2", "right1", "right2"]
materials.lining = { young = "1 GPa", poisson = 0.25 }
"#;

/// Runs a scene and compares code and key of its error, and the line of its place.
fn refused(bench: &Bench, text: &str, code: &str, key: &str, line: usize) {
    bench.file("scene.toml", text);
    bench.check_and_run("scene.toml");
    let call = bench.call("run scene.toml --json");
    let said: serde_json::Value = serde_json::from_str(&call.out).unwrap_or_default();
    let error = &said["error"];
    let found = (error["code"].as_str().unwrap_or(""), error["key"].as_str().unwrap_or(""), error["line"].as_u64());
    assert_eq!((call.code, found), (2, (code, key, Some(line as u64))), "{}", call.out);
    assert!(error["remedy"].as_str().is_some_and(|remedy| !remedy.is_empty()), "{error}");
    assert!(!bench.path("out").exists(), "a scene that is refused on reading leaves no folder");
}

#[test]
fn the_blocks_themselves_are_sound() {
    let bench = Bench::new();
    bench.file("scene.toml", BLOCKS);
    let call = bench.call("run scene.toml -q");
    assert_eq!(call.code, 0, "{}", call.err);
}

#[test]
fn every_mistake_in_blocks_is_named_with_its_place() {
    let bench = Bench::new();
    for (from, to, code, key) in [
        ("[\"d\", \"c\"]", "[\"d\", \"x\"]", "unknown-point", "curves.bond.line"),
        ("[\"a\", \"b\"]", "[\"a\", \"a\"]", "degenerate", "curves.low.line"),
        (
            "curves.bond.line = [\"d\", \"c\"]",
            "curves.bond.arc = { ends = [\"d\", \"c\"], centre = [1, 9] }",
            "degenerate",
            "curves.bond.arc.ends",
        ),
        (
            "curves.bond.line = [\"d\", \"c\"]",
            "curves.bond.arc = { ends = [\"d\", \"c\"], centre = [0, 10] }",
            "degenerate",
            "curves.bond.arc.ends",
        ),
        (
            "curves.bond.line = [\"d\", \"c\"]",
            "curves.bond.spline = { ends = [\"d\", \"c\"], through = [] }",
            "degenerate",
            "curves.bond.spline.ends",
        ),
        (
            "[\"low\", \"right1\", \"bond\", \"left1\"]",
            "[\"low\", \"rihgt1\", \"bond\", \"left1\"]",
            "unknown-curve",
            "cells.soft.curves",
        ),
        (
            "[\"low\", \"right1\", \"bond\", \"left1\"]",
            "[\"low\", \"right2\", \"bond\", \"left1\"]",
            "open-cell",
            "cells.soft.curves",
        ),
        (
            "[\"low\", \"right1\", \"bond\", \"left1\"]",
            "[\"low\", \"bond\", \"right1\", \"left1\"]",
            "open-cell",
            "cells.soft.curves",
        ),
        ("points.e = [10, 25]", "points.e = [-9, 11]", "folded-cell", "cells.back"),
        ("points.c = [10, 10]", "points.c = [-10, 10]", "duplicate-point", "points.d"),
        (
            "cells.back =",
            "cells.twin.curves = [\"left1\", \"bond\", \"right1\", \"low\"]\ncells.back =",
            "duplicate-cell",
            "cells.twin",
        ),
        ("material = \"lining\"", "material = \"linnig\"", "unknown-material", "cells.soft.material"),
        ("young = \"1 GPa\"", "young = 0", "wrong-value", "materials.lining.young"),
        ("[\"left1\", \"left2\", \"right1\", \"right2\"]", "[\"left1\", \"left3\"]", "unknown-curve", "edges.sides"),
        ("edges.high = [\"high\"]", "edges.high = []", "wrong-value", "edges.high"),
        ("edges.high = [\"high\"]", "edges.high = [\"high\", \"bond\"]", "not-on-boundary", "edges.high"),
        ("curves.left1", "curves.twin.line = [\"c\", \"d\"]\ncurves.left1", "duplicate-curve", "curves.twin"),
    ] {
        assert_eq!(BLOCKS.matches(from).count(), 1, "{from}");
        let text = BLOCKS.replacen(from, to, 1);
        let key = format!("body1.geometry.blocks.{key}");
        let written = key.strip_prefix("body1.geometry.blocks.").unwrap();
        // The line of the longest part of the key that is written.
        let parts: Vec<&str> = written.split('.').collect();
        let starts = |count: usize| text.lines().position(|line| line.starts_with(&parts[..count].join(".")));
        let line = (1..=parts.len()).rev().find_map(starts).unwrap() + 1;
        refused(&bench, &text, code, &key, line);
    }
}

#[test]
fn contact_edges_that_no_pressure_is_known_for_are_refused() {
    let bench = Bench::new();
    for (from, to, code, key, line) in [
        ("points.b = [10, 0]", "points.b = [10, 1]", "not-available", "contact.edges.0", 6),
        ("z = [-15, 0]", "z = [-15, -1]", "no-contact", "contact.edges", 6),
        ("x = [-20, 20]", "x = [-9, 20]", "no-contact", "contact.edges", 6),
        ("[\"low\", \"top\"]", "[\"high\", \"top\"]", "not-available", "contact.edges.0", 6),
        ("[\"low\", \"top\"]", "[\"lwo\", \"top\"]", "unknown-edge", "contact.edges.0", 6),
        ("edge = \"high\"", "edge = \"hihg\"", "unknown-edge", "load.edge", 8),
        ("sides = [\"x\"]", "side = [\"x\"]", "unknown-edge", "body1.support.side", 10),
        (
            "curves.low.line = [\"a\", \"b\"]",
            "curves.low.spline = { ends = [\"a\", \"b\"], through = [[0, -1]] }",
            "not-available",
            "contact.edges.0",
            6,
        ),
        ("edges.low = [\"low\"]", "edges.low = [\"low\", \"high\"]", "not-available", "contact.edges.0", 6),
    ] {
        assert_eq!(BLOCKS.matches(from).count(), 1, "{from}");
        refused(&bench, &BLOCKS.replacen(from, to, 1), code, key, line);
    }
    // A cell whose corner lies in the middle of a side of the other.
    let text = BLOCKS.replace("points.c", "points.m = [0, 10]\npoints.c").replace(
        "cells.back = { curves = [\"bond\", \"right2\", \"high\", \"left2\"] }",
        "curves.b1.line = [\"d\", \"m\"]\ncurves.r3.line = [\"m\", \"e\"]\ncells.back = { curves = [\"b1\", \"r3\", \"high\", \"left2\"] }",
    );
    let text = text.replace("\"right1\", \"right2\"]", "\"right1\", \"r3\"]");
    let line = text.lines().position(|line| line.starts_with("cells.soft")).unwrap() + 1;
    refused(&bench, &text, "hanging-point", "body1.geometry.blocks.cells.soft", line);
}

#[test]
fn mesh_files_that_cannot_be_used_are_refused() {
    let bench = Bench::new();
    let path = format!("{}/../../data/meshes/punch.msh", env!("CARGO_MANIFEST_DIR"));
    let sound = std::fs::read_to_string(path).unwrap();
    let scene = |geometry: &str| {
        format!(
            r#"units = "N-mm"
kinematics = "plane-stress"
thickness = 10
tasks = ["shape"]
accuracy = 1e-2
contact = {{ edges = ["bottom", "top"] }}
sliding = {{ speed = 5 }}
load = {{ edge = "top", as = "pressure", force = 600 }}
wear = {{ beta = 1e-6 }}
body1.support = {{ left = ["x"] }}
body2.material = {{ young = "210 GPa", poisson = 0.3 }}
body2.geometry.rectangle = {{ x = [-60, 60], z = [0, 100] }}
body2.support = {{ bottom = ["x", "z"] }}
{geometry}
"#
        )
    };
    let steel = "body1.material = { young = \"210 GPa\", poisson = 0.3 }\n";
    let file = format!("{steel}body1.geometry.mesh.file = \"punch.msh\"");
    let at = "body1.geometry.mesh.file";
    refused(&bench, &scene(&file), "unreadable", at, 15);
    for (text, code) in [
        (sound[..sound.len() / 2].to_string(), "wrong-mesh"),
        (String::new(), "wrong-mesh"),
        ("solid of some other program".to_string(), "wrong-mesh"),
        (sound.replacen("4.1 0 8", "3.0 0 8", 1), "wrong-mesh"),
        (sound.replacen("\n2 1 3 16\n", "\n2 1 92 16\n", 1), "wrong-mesh"),
    ] {
        bench.file("punch.msh", &text);
        refused(&bench, &scene(&file), code, at, 15);
    }
    bench.file("punch.msh", &sound.replace("\"bottom\"", "\"base\""));
    refused(&bench, &scene(&file), "unknown-edge", "contact.edges.0", 6);
    let said = bench.call("check scene.toml").err;
    assert!(["base", "right", "top", "left"].iter().all(|name| said.contains(name)), "{said}");
    bench.file("punch.msh", &sound);
    let hash = format!("{file}\nbody1.geometry.mesh.sha256 = \"00\"");
    refused(&bench, &scene(&hash), "changed-mesh", "body1.geometry.mesh.sha256", 16);
    let other = format!("{file}\nbody1.geometry.mesh.materials.stel = {{ young = 1, poisson = 0 }}");
    refused(&bench, &scene(&other), "unknown-group", "body1.geometry.mesh.materials.stel", 16);
    bench.file("scene.toml", &scene(&file));
    let call = bench.call("run scene.toml -q");
    assert_eq!(call.code, 0, "{}", call.err);
}
