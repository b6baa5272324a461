//! Bodies given by blocks and by gmsh files: the same answers as from templates, and known ones.

use crate::call::{Bench, files};

const HEAD: &str = r#"title = "Drum brake of cells"
units = "N-mm"
kinematics = "plane-stress"
thickness = 10
contact = { edges = ["inner", "outer"], friction = 0.25, gap = 0 }
sliding = { omega = "2.5 rad/s" }
load = { edge = "top", as = "pressure", force = "10 kN" }
wear = { beta = [2e-4, 0], a = 1, b = 0.5 }
body1.support = { left = ["x"], right = ["x"] }
body1.material = { young = "210 GPa", poisson = 0.3 }
body2.support = { inner = ["x", "z"] }
body2.material = { young = "210 GPa", poisson = 0.3 }
"#;

const SHOE: &str = r#"
[body1.geometry.blocks]
points = { a = { radius = 200, angle = "-30 deg" }, b = { radius = 200, angle = "30 deg" }, c = [100, 300], d = [-100, 300] }
curves.arc.arc = { ends = ["a", "b"] }
curves.right.line = ["b", "c"]
curves.top.line = ["c", "d"]
curves.left.line = ["d", "a"]
cells.shoe.curves = ["top", "left", "arc", "right"]
edges = { inner = ["arc"], left = ["left"], right = ["right"], top = ["top"] }
"#;

const DRUM: &str = r#"
[body2.geometry.blocks.points]
n = [0, 200]
e = [200, 0]
s = [0, -200]
w = [-200, 0]
ni = [0, 100]
ei = [100, 0]
si = [0, -100]
wi = [-100, 0]
[body2.geometry.blocks.curves]
ne.arc = { ends = ["n", "e"] }
es.arc = { ends = ["e", "s"] }
sw.arc = { ends = ["s", "w"] }
wn.arc = { ends = ["w", "n"] }
nei.arc = { ends = ["ni", "ei"] }
esi.arc = { ends = ["ei", "si"] }
swi.arc = { ends = ["si", "wi"] }
wni.arc = { ends = ["wi", "ni"] }
rn.line = ["ni", "n"]
re.line = ["ei", "e"]
rs.line = ["si", "s"]
rw.line = ["wi", "w"]
[body2.geometry.blocks.cells]
one.curves = ["ne", "re", "nei", "rn"]
two.curves = ["es", "rs", "esi", "re"]
three.curves = ["sw", "rw", "swi", "rs"]
four.curves = ["wn", "rn", "wni", "rw"]
[body2.geometry.blocks.edges]
outer = ["ne", "es", "sw", "wn"]
inner = ["nei", "esi", "swi", "wni"]
"#;

const SHOE_TEMPLATE: &str = "\n[body1.geometry.shoe-block]\nradius = 200\nhalf_angle = \"30 deg\"\ntop = 300\n";
const DRUM_TEMPLATE: &str = "\n[body2.geometry.ring]\ninner = 100\nouter = 200\n";

/// A file of data/meshes beside the scene.
fn mesh(bench: &Bench, name: &str) {
    let path = format!("{}/../../data/meshes/{name}", env!("CARGO_MANIFEST_DIR"));
    std::fs::copy(path, bench.path(name)).unwrap();
}

/// Runs a scene with options and returns a column of its contact.csv.
fn column(bench: &Bench, scene: &str, options: &str, name: &str) -> Vec<f64> {
    let call = bench.call(&format!("run {scene} --sample 61 -q -o table {options}"));
    assert_eq!(call.code, 0, "{scene} {options}: {}{}", call.out, call.err);
    let text = bench.read("table/contact.csv");
    let at = text.lines().next().unwrap().split(',').position(|field| field == name).unwrap();
    text.lines().skip(1).map(|line| line.split(',').nth(at).unwrap().parse().unwrap()).collect()
}

/// Largest difference over the largest value.
fn difference(a: &[f64], b: &[f64]) -> f64 {
    let largest = b.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max) / largest
}

#[test]
fn a_drum_brake_of_blocks_has_the_gap_of_the_templates_within_the_accuracy() {
    let bench = Bench::new();
    bench.file("tt.toml", &[HEAD, SHOE_TEMPLATE, DRUM_TEMPLATE].concat());
    bench.file("bb.toml", &[HEAD, SHOE, DRUM].concat());
    bench.file("bt.toml", &[HEAD, SHOE, DRUM_TEMPLATE].concat());
    bench.file("tb.toml", &[HEAD, SHOE_TEMPLATE, DRUM].concat());
    let shape = "--set check=false --set accuracy=1e-6";
    let wanted = column(&bench, "tt.toml", shape, "gap_um");
    for scene in ["bb.toml", "bt.toml", "tb.toml"] {
        let error = difference(&column(&bench, scene, shape, "gap_um"), &wanted);
        assert!(error < 1e-6, "{scene}: {error}");
    }
    let contact = "--set tasks=[contact] --set accuracy=1e-4";
    let energies = |scene: &str| {
        column(&bench, scene, contact, "pressure_MPa");
        let summary: serde_json::Value = serde_json::from_str(&bench.read("table/summary.json")).unwrap();
        ["body1_Nmm", "body2_Nmm"].map(|body| summary["energy"][body].as_f64().unwrap())
    };
    let (one, other) = (energies("bb.toml"), energies("tt.toml"));
    for body in 0..2 {
        assert!((one[body] / other[body] - 1.0).abs() < 1e-4, "energy of body {}: {} and {}", body + 1, one[body], other[body]);
    }
    // Both runs end within the accuracy.
    let wear = "--set tasks=[wear] --set accuracy=1e-3";
    let error = difference(&column(&bench, "bb.toml", wear, "gap_um"), &column(&bench, "tt.toml", wear, "gap_um"));
    assert!(error < 2e-3, "worn shapes: {error}");
}

#[test]
fn a_lining_on_its_back_stores_the_energy_of_two_springs_in_a_row() {
    // Held at its sides every layer is strained uniformly: w = p^2 A h / (2 M), M = E (1 - nu) / ((1 + nu) (1 - 2 nu)).
    let bench = Bench::new();
    bench.file(
        "column.toml",
        r#"units = "N-mm"
kinematics = "plane-strain"
thickness = 3
tasks = ["shape"]
mesh = { degree = 5, layers = 2 }
contact = { edges = ["low", "top"] }
sliding = { speed = 1 }
load = { edge = "high", as = "pressure", force = 600 }
wear = { beta = 1e-6 }
optimum = { functional = "uniform" }
body1.support = { sides = ["x"] }
body2.material = { young = 70000, poisson = 0.2 }
body2.geometry.rectangle = { x = [-10, 10], z = [-15, 0] }
body2.support = { left = ["x"], right = ["x"], bottom = ["z"] }
[body1.geometry.blocks]
points = { a = [-10, 0], b = [10, 0], c = [10, 10], d = [-10, 10], e = [10, 25], f = [-10, 25], p = [-3, 10], q = [3, 25], m = [1, 0] }
curves.low1.line = ["a", "m"]
curves.low2.line = ["m", "b"]
curves.bond1.spline = { ends = ["d", "p"], through = [[-6, 10]] }
curves.bond2.line = ["p", "c"]
curves.high1.line = ["e", "q"]
curves.high2.line = ["q", "f"]
curves.middle1.line = ["m", "p"]
curves.middle2.line = ["p", "q"]
curves.left1.line = ["a", "d"]
curves.left2.line = ["d", "f"]
curves.right1.line = ["b", "c"]
curves.right2.line = ["c", "e"]
cells.soft1 = { curves = ["low1", "middle1", "bond1", "left1"], material = "lining" }
cells.soft2 = { curves = ["low2", "right1", "bond2", "middle1"], material = "lining" }
cells.back1 = { curves = ["bond1", "middle2", "high2", "left2"], material = "steel" }
cells.back2 = { curves = ["bond2", "right2", "high1", "middle2"], material = "steel" }
edges = { low = ["low1", "low2"], high = ["high2", "high1"], sides = ["left1", "left2", "right1", "right2"] }
materials = { lining = { young = "1 GPa", poisson = 0.25 }, steel = { young = "210 GPa", poisson = 0.3 } }
"#,
    );
    let opening = column(&bench, "column.toml", "", "gap_um");
    assert!(opening.iter().all(|g| g.abs() < 1e-9), "the faces stay flat: {opening:?}");
    let summary: serde_json::Value = serde_json::from_str(&bench.read("table/summary.json")).unwrap();
    let modulus = |young: f64, nu: f64| young * (1.0 - nu) / ((1.0 + nu) * (1.0 - 2.0 * nu));
    let (pressure, area) = (600.0 / 60.0, 60.0);
    let energy = |height: f64, m: f64| 0.5 * pressure * pressure * area * height / m;
    let wanted = [energy(10.0, modulus(1e3, 0.25)) + energy(15.0, modulus(210e3, 0.3)), energy(15.0, modulus(70e3, 0.2))];
    for (body, wanted) in ["body1_Nmm", "body2_Nmm"].iter().zip(wanted) {
        let found = summary["energy"][body].as_f64().unwrap();
        assert!((found / wanted - 1.0).abs() < 1e-9, "{body}: {found}, not {wanted}");
    }
}

#[test]
fn the_punch_from_gmsh_has_the_gap_of_the_template_within_both_accuracies() {
    let bench = Bench::new();
    mesh(&bench, "punch.msh");
    let text = bench.call("new translating-punch").out;
    let line = text.lines().find(|line| line.starts_with("body1.geometry")).unwrap();
    bench.file("punch.toml", &text.replace(line, "body1.geometry.mesh = { file = \"punch.msh\" }"));
    let wanted = column(&bench, "translating-punch", "--set check=false", "gap_um");
    let error = difference(&column(&bench, "punch.toml", "--set check=false", "gap_um"), &wanted);
    assert!(error < 2e-6, "{error}");
}

#[test]
fn curved_cells_of_second_order_from_gmsh_lie_on_the_exact_arc() {
    let bench = Bench::new();
    mesh(&bench, "shoe.msh");
    bench.file("mesh.toml", &[HEAD, "body1.geometry.mesh.file = \"shoe.msh\"\n", DRUM].concat());
    let options = "--set check=false --set accuracy=1e-6";
    let wanted = column(&bench, "drum-brake-block", "--set check=false", "gap_um");
    let error = difference(&column(&bench, "mesh.toml", options, "gap_um"), &wanted);
    assert!(error < 2e-6, "{error}");
}

/// Its 323 cells have different degrees, by how far they are from the ends of contact, load and supports.
#[test]
fn a_shoe_of_many_cells_has_the_gap_of_the_template_within_both_accuracies() {
    let bench = Bench::new();
    ["fine-shoe.msh", "fine-shoe.toml"].into_iter().for_each(|file| mesh(&bench, file));
    let wanted = column(&bench, "drum-brake-block", "--set check=false", "gap_um");
    let error = difference(&column(&bench, "fine-shoe.toml", "--set check=false", "gap_um"), &wanted);
    assert!(error < 2e-6, "{error}");
}

#[test]
fn a_lining_from_gmsh_with_triangles_has_the_gap_of_the_blocks_and_its_resolved_scene_runs() {
    let bench = Bench::new();
    mesh(&bench, "lining.msh");
    mesh(&bench, "lining.toml");
    std::fs::create_dir(bench.path("meshes")).unwrap();
    std::fs::rename(bench.path("lining.msh"), bench.path("meshes/lining.msh")).unwrap();
    bench.file("mesh.toml", &bench.read("lining.toml").replace("\"lining.msh\"", "\"meshes/lining.msh\""));
    let wanted = column(&bench, "lining-on-back", "--set check=false", "gap_um");
    let error = difference(&column(&bench, "mesh.toml", "--set check=false", "gap_um"), &wanted);
    assert!(error < 2e-5, "{error}");
    let call = bench.call("run table/scene.resolved.toml --sample 61 -q -o again");
    assert_eq!(call.code, 0, "{}", call.err);
    assert!(files(&bench.path("again")).contains(&"body1.msh".to_string()));
    for name in ["contact.csv", "body1.msh", "scene.resolved.toml"] {
        assert!(bench.bytes(&format!("table/{name}")) == bench.bytes(&format!("again/{name}")), "{name} differs");
    }
}

#[test]
fn a_measured_start_profile_is_the_gap_of_a_contact_and_forgotten_by_wear() {
    let bench = Bench::new();
    bench.file("profile.csv", "# measured\ns_mm,gap_um\n-110,0\n0,0.5\n110,0\n");
    bench.file("bb.toml", &[HEAD, SHOE, DRUM].concat().replace("gap = 0", "gap = \"profile.csv\""));
    bench.file("flat.toml", &[HEAD, SHOE, DRUM].concat());
    let contact = "--set tasks=[contact] --set mesh.degree=4";
    let (s, gap) = (column(&bench, "bb.toml", contact, "s_mm"), column(&bench, "bb.toml", contact, "gap_um"));
    let wanted: Vec<f64> = s.iter().map(|s| 0.5 * (1.0 - s.abs() / 110.0)).collect();
    assert!(difference(&gap, &wanted) < 1e-12, "{gap:?}");
    // A hollow face carries less in the middle than a flat one.
    let middle = |scene: &str| column(&bench, scene, contact, "pressure_MPa")[30];
    assert!(middle("bb.toml") < 0.99 * middle("flat.toml"), "{} and {}", middle("bb.toml"), middle("flat.toml"));
    let wear = "--set tasks=[wear] --set accuracy=1e-3";
    let error = difference(&column(&bench, "bb.toml", wear, "gap_um"), &column(&bench, "flat.toml", wear, "gap_um"));
    assert!(error < 2e-3, "worn shapes from two starts: {error}");
}

#[test]
fn points_curves_and_materials_that_no_cell_uses_are_listed() {
    let bench = Bench::new();
    let idle = SHOE.replace("b = {", "idle = [0, 400], far = [50, 400], b = {").replace(
        "cells.shoe",
        "curves.spare.line = [\"idle\", \"far\"]\nmaterials.lead = { young = 1e4, poisson = 0.4 }\ncells.shoe",
    );
    bench.file("idle.toml", &[HEAD, &idle, DRUM].concat());
    let call = bench.call("run idle.toml -q --set tasks=[pressure]");
    assert_eq!(call.code, 0, "{}", call.err);
    let unused = bench.summary("idle")["unused_keys"].to_string();
    for key in ["curves.spare", "materials.lead", "points.far", "points.idle"] {
        assert!(unused.contains(&format!("\"body1.geometry.blocks.{key}\"")), "{key} is not in {unused}");
    }
    assert!(!unused.contains("points.a\"") && !unused.contains("body2.geometry"), "{unused}");
}

/// A rectangle of one cell with the edges of the template.
fn rectangle(body: &str, [left, right]: [f64; 2], [low, high]: [f64; 2]) -> String {
    format!(
        r#"
[{body}.geometry.blocks]
points = {{ a = [{left}, {low}], b = [{right}, {low}], c = [{right}, {high}], d = [{left}, {high}] }}
curves = {{ low.line = ["a", "b"], out.line = ["b", "c"], high.line = ["c", "d"], in.line = ["d", "a"] }}
cells.all.curves = ["low", "out", "high", "in"]
edges = {{ bottom = ["low"], right = ["out"], top = ["high"], left = ["in"] }}
"#
    )
}

#[test]
fn an_annular_punch_of_blocks_is_shaped_and_twisted_as_one_of_templates() {
    let bench = Bench::new();
    let text = bench.call("new annular-punch").out;
    let lines: Vec<&str> = text.lines().filter(|line| !line.contains(".geometry.rectangle")).collect();
    assert_eq!(lines.len() + 2, text.lines().count());
    let cells = [rectangle("body1", [20.0, 120.0], [50.0, 100.0]), rectangle("body2", [10.0, 140.0], [0.0, 50.0])];
    bench.file("blocks.toml", &format!("{}\n{}", lines.join("\n"), cells.concat()));
    for (name, most) in [("gap_um", 1e-6), ("uphi1_um", 1e-6), ("uphi2_um", 1e-6)] {
        let of = |scene: &str| column(&bench, scene, "--set check=false --set accuracy=1e-7", name);
        let error = difference(&of("blocks.toml"), &of("annular-punch"));
        assert!(error < most, "{name}: {error}");
    }
    let moment = |scene: &str| {
        assert_eq!(bench.call(&format!("run {scene} --set check=false -q -o m")).code, 0);
        let summary: serde_json::Value = serde_json::from_str(&bench.read("m/summary.json")).unwrap();
        summary["reactions"]["body2.bottom"]["moment_Nmm"].as_f64().unwrap()
    };
    approx::assert_relative_eq!(moment("blocks.toml"), moment("annular-punch"), max_relative = 1e-8);
}

#[test]
fn a_strip_of_load_wears_a_ring_of_blocks_as_one_of_templates() {
    let bench = Bench::new();
    let head = HEAD.replace(
        "load = { edge = \"top\", as = \"pressure\"",
        "load = { edge = \"outer\", as = \"vertical\", width = 40, centre = 5",
    );
    let head = head.replace("wear = { ", "wear = { until = \"2 s\", ");
    // Half of the chord is 100 mm on both arcs.
    let (inner, outer) = (30000.0_f64.sqrt(), 38400.0_f64.sqrt());
    let ring = format!(
        r#"
[body1.geometry.blocks]
points = {{ a = [-100, {inner}], b = [100, {inner}], c = [100, {outer}], d = [-100, {outer}] }}
curves = {{ low.arc = {{ ends = ["a", "b"] }}, right.line = ["b", "c"], high.arc = {{ ends = ["c", "d"] }}, left.line = ["d", "a"] }}
cells.all.curves = ["low", "right", "high", "left"]
edges = {{ inner = ["low"], right = ["right"], outer = ["high"], left = ["left"] }}
"#
    );
    let template = "\nbody1.geometry.ring-segment = { inner = 200, outer = 220, x = [-100, 100] }\n";
    bench.file("blocks.toml", &[head.as_str(), &ring, DRUM_TEMPLATE].concat());
    bench.file("templates.toml", &[head.as_str(), template, DRUM_TEMPLATE].concat());
    let wear = "--set tasks=[wear] --set accuracy=1e-4";
    let gap = |scene: &str, more: &str| column(&bench, scene, &format!("{wear} {more}"), "gap_um");
    let error = difference(&gap("blocks.toml", ""), &gap("templates.toml", ""));
    assert!(error < 2e-4, "{error}");
    // The strip matters, and its load stands 5 mm right of the middle: the supports carry its moment about the origin.
    assert!(difference(&gap("blocks.toml", "--set load.width=80"), &gap("templates.toml", "")) > 1e-2);
    let call = bench.call("run blocks.toml --set tasks=[wear] --set accuracy=1e-4 -q -o b");
    assert_eq!(call.code, 0, "{}", call.err);
    let summary: serde_json::Value = serde_json::from_str(&bench.read("b/summary.json")).unwrap();
    let moments = summary["reactions"].as_object().unwrap().values().map(|r| r["moment_Nmm"].as_f64().unwrap());
    approx::assert_relative_eq!(moments.sum::<f64>(), 5.0 * 10_000.0, max_relative = 1e-8);
}

#[test]
fn a_strip_of_load_on_a_template_that_has_none_is_refused() {
    let bench = Bench::new();
    let strip = "--set load.as=vertical --set load.width=40";
    for scene in ["drum-brake-block", "annular-punch"] {
        let call = bench.call(&format!("check {scene} {strip} --set load.centre=60"));
        assert_eq!(call.code, 2, "{scene}: {}", call.out);
        assert!(call.err.contains("not on a strip") && call.err.contains("geometry.blocks"), "{}", call.err);
    }
    assert_eq!(bench.call(&format!("check drum-brake-block {strip} --set tasks=[pressure]")).code, 0);
}
