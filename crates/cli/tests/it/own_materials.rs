//! Bodies of cells that bring their own materials, without a material of the body: what asks for a body's stiffness finds theirs.

use crate::call::Bench;

/// A rectangle of one cell with the edges of the template and a material of its own.
fn rectangle(body: &str, [left, right]: [f64; 2], [low, high]: [f64; 2]) -> String {
    format!(
        r#"
[{body}.geometry.blocks]
points = {{ a = [{left}, {low}], b = [{right}, {low}], c = [{right}, {high}], d = [{left}, {high}] }}
curves = {{ low.line = ["a", "b"], out.line = ["b", "c"], high.line = ["c", "d"], in.line = ["d", "a"] }}
cells.all = {{ curves = ["low", "out", "high", "in"], material = "own" }}
materials.own = {{ young = "210 GPa", poisson = 0.3 }}
edges = {{ bottom = ["low"], right = ["out"], top = ["high"], left = ["in"] }}
"#
    )
}

/// The translating punch with both bodies of such cells.
fn punch(bench: &Bench) {
    let text = bench.call("new translating-punch").out;
    let kept = |line: &&str| !line.contains(".geometry.rectangle") && !line.contains(".material");
    let lines: Vec<&str> = text.lines().filter(kept).collect();
    assert_eq!(lines.len() + 4, text.lines().count());
    let cells = [rectangle("body1", [-30.0, 30.0], [100.0, 200.0]), rectangle("body2", [-60.0, 60.0], [0.0, 100.0])];
    bench.file("punch.toml", &format!("{}\n{}", lines.join("\n"), cells.concat()));
}

#[test]
fn the_force_of_an_approach_is_found_for_bodies_whose_cells_bring_their_own_materials() {
    let bench = Bench::new();
    punch(&bench);
    let force = |scene: &str| {
        let sets = "--set load.approach=1.3e-3 --set load.tilt=0 --set mesh.degree=4 --set check=false";
        let call = bench.call(&format!("run {scene} {sets} -o x"));
        assert_eq!(call.code, 0, "{scene}: {}{}", call.out, call.err);
        let summary: serde_json::Value = serde_json::from_str(&bench.read("x/summary.json")).unwrap();
        summary["pressure"]["force_N"].as_f64().unwrap()
    };
    let (own, template) = (force("punch.toml"), force("translating-punch"));
    assert!(own.is_finite() && own > 0.0, "{own}");
    // Coarse meshes of one and of several cells.
    approx::assert_relative_eq!(own, template, max_relative = 1e-2);
}

#[test]
fn an_implausible_modulus_of_cells_is_noted_for_their_body() {
    let bench = Bench::new();
    punch(&bench);
    let call = bench.call("check punch.toml");
    assert!(call.code == 0 && !call.out.contains("young-implausible"), "{}{}", call.out, call.err);
    for body in ["1", "2"] {
        let set = format!("body{body}.geometry.blocks.materials.own.young=0.21");
        let call = bench.call_with(&["check", "punch.toml", "--set", &set]);
        assert_eq!(call.code, 0, "{}", call.err);
        let said = format!("note [young-implausible]: Young's modulus of body {body} is 0.21 MPa");
        assert!(call.out.contains(&said), "{}", call.out);
    }
}
