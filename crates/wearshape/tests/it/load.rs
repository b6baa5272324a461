//! Where a load acts.

use approx::assert_relative_eq;
use wearshape::Problem;

use crate::common::{read, scene, solved};

/// ```text
///      d---------m--c        vertical load on the whole of the top edge, x = -15 to 25: its middle is x = 5
///     /               \
///    a----------n------b     contact, x = -30 to 30
/// ```
/// The top is held along x at one height, so that the body may turn. Without friction the contact pressure alone carries the load:
/// `int (x - 5) p dS = 0`. With b = 1 the steady pressure is linear in x.
const TRAPEZOID: &str = r#"
units = "N-mm"
kinematics = "plane-stress"
thickness = 10
mesh = { degree = 8, layers = 6 }
check = false
body1.material = { young = "210 GPa", poisson = 0.3 }
body1.support = { top = ["x"] }
body2.material = { young = "210 GPa", poisson = 0.3 }
body2.geometry.rectangle = { x = [-60, 60], z = [0, 100] }
body2.support = { bottom = ["x", "z"] }
contact = { edges = ["bottom", "top"], friction = 0 }
load = { edge = "top", as = "vertical", force = "1 kN" }
sliding.speed = 5
wear = { k = 1e-8, b = 1 }
[body1.geometry.blocks]
points = { a = [-30, 100], n = [4, 100], b = [30, 100], c = [25, 200], m = [17, 200], d = [-15, 200] }
curves.right.line = ["b", "c"]
curves.left.line = ["d", "a"]
"#;

/// The same body as one cell, and as two with a top of two curves.
const CELLS: [&str; 2] = [
    r#"
curves.low.line = ["a", "b"]
curves.high.line = ["c", "d"]
cells.all.curves = ["low", "right", "high", "left"]
edges = { bottom = ["low"], right = ["right"], top = ["high"], left = ["left"] }
"#,
    r#"
curves.low1.line = ["a", "n"]
curves.low2.line = ["n", "b"]
curves.high1.line = ["c", "m"]
curves.high2.line = ["m", "d"]
curves.middle.line = ["n", "m"]
cells.one.curves = ["low1", "middle", "high2", "left"]
cells.two.curves = ["low2", "right", "high1", "middle"]
edges = { bottom = ["low1", "low2"], right = ["right"], top = ["high1", "high2"], left = ["left"] }
"#,
];

/// Force and `int (x - centre) p dS` of the columns of a solution.
fn resultants(problem: &Problem, centre: f64) -> [f64; 2] {
    let profile = solved(problem).profile.unwrap();
    let carried = |arm: &dyn Fn(f64) -> f64| -> f64 {
        (0..profile.s.len()).map(|i| profile.weight[i] * profile.pressure[i] * arm(profile.position[i][0])).sum()
    };
    [carried(&|_| 1.0), carried(&|x| x - centre)]
}

#[test]
fn a_vertical_load_on_a_whole_edge_passes_through_its_middle() {
    for (cells, task) in CELLS.into_iter().flat_map(|cells| ["pressure", "shape", "contact"].map(|task| (cells, task))) {
        let problem = read(&[TRAPEZOID, cells].concat(), &[&format!("tasks=[{task}]")]);
        let [force, moment] = resultants(&problem, 5.0);
        println!("{task}: {force} {moment}");
        assert_relative_eq!(force, 1000.0, max_relative = 1e-9);
        assert!(moment.abs() < 1e-9 * 1000.0 * 30.0, "{task}: {moment} N mm about the middle of the edge");
    }
}

/// A pressure acts on the whole edge: a strip of it is refused, unless it is the whole edge, or the pressure alone is asked for.
#[test]
fn the_width_of_a_pressure_is_refused_where_it_would_be_left_out() {
    let read = |settings: &[&str]| {
        let settings: Vec<String> = settings.iter().map(|setting| setting.to_string()).collect();
        let text = wearshape::builtin("drum-brake-ring").unwrap().text;
        let document = wearshape::Document::read("drum-brake-ring", text, &settings).unwrap();
        wearshape::Problem::new(&document, &|_| Err("no file".into()))
    };
    let fault = read(&["load.as=pressure", "load.width=40"]).unwrap_err();
    assert_eq!((fault.code, fault.key.as_deref()), ("not-carried", Some("load.width")));
    assert!(fault.message.contains("load.width = 40") && fault.remedy.contains("vertical"), "{fault:?}");
    let whole = read(&["load.as=pressure", "load.width=200", "load.centre=0"]).unwrap();
    assert_eq!(whole.unused_keys(), ["load.centre", "load.width"]);
    assert_eq!(
        read(&["load.as=pressure", "load.width=40", "tasks=[pressure]"]).unwrap().unused_keys(),
        ["load.centre", "load.width"]
    );
    // As a strip it cuts the mesh.
    let [whole, strip] = [whole, scene("drum-brake-ring", &["mesh.degree=4"])];
    assert!(strip.meshes().unwrap()[0].cells.len() > whole.meshes().unwrap()[0].cells.len());
}
