//! Mesh files as programs write them: torn, in metres, turned, of too low an order; and bodies of nearly one length.

use std::f64::consts::PI;

use crate::call::Bench;

const SCENE: &str = r#"units = "N-mm"
kinematics = "plane-strain"
thickness = 10
tasks = ["shape"]
accuracy = 1e-4
contact = { edges = ["bottom", "top"], friction = 0.1 }
sliding = { speed = 5 }
load = { edge = "top", as = "pressure", force = 600 }
wear = { beta = 1e-6 }
body1.material = { young = "210 GPa", poisson = 0.3 }
body1.support = { left = ["x"] }
body2.material = { young = "210 GPa", poisson = 0.3 }
body2.geometry.rectangle = { x = [-60, 60], z = [0, 100] }
body2.support = { bottom = ["x", "z"] }
body1.geometry.mesh = { file = "body.msh" }
"#;

/// A gmsh file 2.2: nodes, cells by their nodes, and lines by the name of their group.
fn msh(nodes: &[[f64; 2]], cells: &[Vec<usize>], lines: &[(&str, Vec<usize>)]) -> String {
    let mut names: Vec<&str> = lines.iter().map(|line| line.0).collect();
    names.dedup();
    let kind = |nodes: usize, of: [i32; 2]| if matches!(nodes, 2 | 4) { of[0] } else { of[1] };
    let words = |list: &[usize]| list.iter().map(|n| format!(" {}", n + 1)).collect::<String>();
    let mut text = format!("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n{}\n", names.len());
    names.iter().enumerate().for_each(|(i, name)| text += &format!("1 {} \"{name}\"\n", i + 1));
    text += &format!("$EndPhysicalNames\n$Nodes\n{}\n", nodes.len());
    nodes.iter().enumerate().for_each(|(i, [x, y])| text += &format!("{} {x:?} {y:?} 0\n", i + 1));
    text += &format!("$EndNodes\n$Elements\n{}\n", cells.len() + lines.len());
    for (i, (name, nodes)) in lines.iter().enumerate() {
        let group = names.iter().position(|known| known == name).unwrap() + 1;
        text += &format!("{} {} 2 {group} {group}{}\n", i + 1, kind(nodes.len(), [1, 8]), words(nodes));
    }
    for (i, nodes) in cells.iter().enumerate() {
        text += &format!("{} {} 2 99 99{}\n", lines.len() + i + 1, kind(nodes.len(), [3, 16]), words(nodes));
    }
    text + "$EndElements\n"
}

/// Two squares one above the other, 60 mm wide from z = 100, whose common nodes are written once, twice, or not at all.
fn squares(between: &str) -> String {
    let mut nodes = vec![[-30.0, 100.0], [30.0, 100.0], [30.0, 150.0], [-30.0, 150.0], [30.0, 200.0], [-30.0, 200.0]];
    let (mut cells, mut right) = (vec![vec![0, 1, 2, 3], vec![3, 2, 4, 5]], [2, 4]);
    match between {
        "twice" => {
            nodes.extend([[30.0, 150.0], [-30.0, 150.0]]);
            cells[1] = vec![7, 6, 4, 5];
            right = [6, 4];
        }
        "hanging" => {
            nodes.extend([[0.0, 150.0], [0.0, 200.0]]);
            cells[1] = vec![3, 6, 7, 5];
            cells.push(vec![6, 2, 4, 7]);
        }
        "apart" => {
            nodes.extend([[30.0, 151.0], [-30.0, 151.0]]);
            cells[1] = vec![7, 6, 4, 5];
            right = [6, 4];
        }
        _ => {}
    }
    let top = if between == "hanging" { vec![vec![5, 7], vec![7, 4]] } else { vec![vec![5, 4]] };
    let mut lines = vec![("bottom", vec![0, 1])];
    lines.extend(top.into_iter().map(|side| ("top", side)));
    lines.extend([("left", vec![0, 3]), ("right", vec![1, 2]), ("right", right.to_vec())]);
    msh(&nodes, &cells, &lines)
}

#[test]
fn mesh_files_that_are_not_one_body_are_refused_with_their_place() {
    let bench = Bench::new();
    bench.file("scene.toml", SCENE);
    bench.file("body.msh", &squares("once"));
    let call = bench.call("check scene.toml");
    assert_eq!(call.code, 0, "{}", call.err);
    for (between, said) in [
        ("twice", "cells 1 and 2 touch without sharing nodes at (30, 150)"),
        ("hanging", "touch without sharing nodes at (0, 150)"),
        ("apart", "in pieces: no shared edges join cell 2"),
    ] {
        bench.file("body.msh", &squares(between));
        for command in ["check scene.toml", "run scene.toml"] {
            let call = bench.call(command);
            assert_eq!(call.code, 2, "{between}: {}", call.err);
            assert!(
                call.err.contains(said) && call.err.contains("scene.toml:15:") && call.err.contains("remedy:"),
                "{}",
                call.err
            );
        }
    }
    bench.file("body.msh", &squares("once").replace("\"left\"", "\"@load\""));
    let call = bench.call("check scene.toml");
    assert!(call.code == 2 && call.err.contains("`@load` begins with @"), "{}", call.err);
}

#[test]
fn a_mesh_is_scaled_turned_and_moved_into_its_place() {
    let bench = Bench::new();
    let column = |folder: &str| -> Vec<f64> {
        let text = bench.read(&format!("{folder}/contact.csv"));
        text.lines().skip(1).map(|line| line.split(',').nth(11).unwrap().parse().unwrap()).collect()
    };
    bench.file("scene.toml", SCENE);
    bench.file("body.msh", &squares("once"));
    assert_eq!(bench.call("run scene.toml -q -o plain --set accuracy=1e-6").code, 0);
    // In metres, turned by -90 degrees about the origin and off its place.
    let turned = |x: f64, z: f64| [1e-3 * (z - 20.0), -1e-3 * (x + 5.0)];
    let nodes = [[-30.0, 100.0], [30.0, 100.0], [30.0, 150.0], [-30.0, 150.0], [30.0, 200.0], [-30.0, 200.0]];
    let nodes = nodes.map(|[x, z]| turned(x, z));
    let lines = [("bottom", vec![0, 1]), ("top", vec![5, 4]), ("left", vec![0, 3]), ("right", vec![1, 2])];
    bench.file("body.msh", &msh(&nodes, &[vec![0, 1, 2, 3], vec![3, 2, 4, 5]], &lines));
    let said = bench.call("check scene.toml --set body1.geometry.mesh.rotate=90_deg").err;
    assert!(said.contains("scale = \"m\"") && said.contains("0.1 mm long and the other body 120 mm"), "{said}");
    let placed =
        "--set body1.geometry.mesh.scale=m --set body1.geometry.mesh.rotate=90_deg --set body1.geometry.mesh.move=[-5,20]";
    let call = bench.call(&format!("run scene.toml -q -o placed --set accuracy=1e-6 {placed}"));
    assert_eq!(call.code, 0, "{}", call.err);
    let (plain, placed) = (column("plain"), column("placed"));
    let largest = plain.iter().fold(0.0_f64, |m, v| m.max(*v));
    assert!(plain.len() == placed.len() && plain.iter().zip(&placed).all(|(a, b)| (a - b).abs() < 1e-9 * largest));
    let call = bench.call("run placed/scene.resolved.toml -q -o again");
    assert_eq!(call.code, 0, "{}", call.err);
    for file in ["contact.csv", "scene.resolved.toml", "body1.msh"] {
        assert!(bench.bytes(&format!("placed/{file}")) == bench.bytes(&format!("again/{file}")), "{file}");
    }
    let call = bench.call("check scene.toml --set body1.geometry.mesh.scale=0");
    assert!(call.code == 2 && call.err.contains("zero scale"), "{}", call.err);
}

#[test]
fn straight_sides_on_an_arc_ask_for_a_mesh_of_order_2() {
    let bench = Bench::new();
    let point = |r: f64, i: usize| [r * (PI * (i as f64 - 3.0) / 18.0).sin(), r * (PI * (i as f64 - 3.0) / 18.0).cos()];
    let nodes: Vec<[f64; 2]> = (0..7).map(|i| point(200.0, i)).chain((0..7).map(|i| point(240.0, i))).collect();
    let cells: Vec<Vec<usize>> = (0..6).map(|i| vec![i, i + 7, i + 8, i + 1]).collect();
    let mut lines: Vec<(&str, Vec<usize>)> = (0..6).map(|i| ("bottom", vec![i, i + 1])).collect();
    lines.extend((0..6).map(|i| ("top", vec![i + 7, i + 8])));
    lines.push(("left", vec![0, 7]));
    bench.file("body.msh", &msh(&nodes, &cells, &lines));
    let ring = "ring = { inner = 100, outer = 200 }";
    let scene =
        SCENE.replace("rectangle = { x = [-60, 60], z = [0, 100] }", ring).replace("\"top\"], friction", "\"outer\"], friction");
    bench.file("scene.toml", &scene.replace("{ bottom = ", "{ inner = ").replace("speed = 5", "omega = 1"));
    let call = bench.call("check scene.toml");
    assert_eq!(call.code, 2, "{}", call.err);
    assert!(call.err.contains("an arc of radius 200 made of 6 straight sides"), "{}", call.err);
    assert!(call.err.contains("mesh with order 2 (Mesh.ElementOrder = 2)"), "{}", call.err);
}

#[test]
fn a_body_2_a_little_longer_than_body_1_comes_to_the_gap_of_equal_lengths() {
    let bench = Bench::new();
    let run = |scene: &str, x: [f64; 2]| {
        let call =
            bench.call(&format!("run {scene} -q --sample 61 -o made --set body2.geometry.rectangle.x=[{:?},{:?}]", x[0], x[1]));
        assert!(call.code < 2, "{scene} {x:?}: {}", call.err);
        let summary: serde_json::Value = serde_json::from_str(&bench.read("made/summary.json")).unwrap();
        let text = bench.read("made/contact.csv");
        let gap: Vec<f64> = text.lines().skip(1).map(|line| line.split(',').nth(11).unwrap().parse().unwrap()).collect();
        (gap, summary["error"]["gap_relative"].as_f64().unwrap())
    };
    for (scene, ends) in [("translating-punch", [-30.0, 30.0]), ("annular-punch", [20.0, 120.0])] {
        let (equal, _) = run(scene, ends);
        let largest = equal.iter().fold(0.0_f64, |m, v| m.max(*v));
        let mut last = f64::INFINITY;
        for ledge in [1e-2, 1e-3, 1e-4, 1e-5, 1e-6] {
            let (gap, estimate) = run(scene, [ends[0] - ledge, ends[1] + ledge]);
            assert!(estimate < 1e-4, "{scene}, {ledge} mm: estimate {estimate}");
            let off = gap.iter().zip(&equal).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max) / largest;
            // The change is of the order of the ledge, as long as it is above the accuracy.
            assert!(off < 0.3 * last || off < 1e-5, "{scene}, {ledge} mm: {off} after {last}");
            last = off;
        }
        assert!(last < 1e-2, "{scene}: {last}");
    }
}
