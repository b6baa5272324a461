//! Displacement and stress along lines: closed forms, the fields on the cells, symmetry, and lines that leave their bodies.

use std::ops::ControlFlow;

use wearshape::{Bodies, CellField, Document, Fault, Options, PathProfile, Problem, Sampling, builtin, solve};

use crate::common::{read, scene, solved};

/// Two blocks of equal width under a uniform pressure of 10 MPa, without friction: uniformly strained.
const BLOCKS: &str = r#"
units = "N-mm"
kinematics = "plane-strain"
thickness = 10
tasks = ["pressure", "shape"]
mesh = { degree = 4, layers = 2 }
check = false
body1.material = { young = "8 GPa", poisson = 0.25 }
body1.geometry.rectangle = { x = [-30, 30], z = [0, 40] }
body1.support = { left = ["x"] }
body2.material = { young = "210 GPa", poisson = 0.3 }
body2.geometry.rectangle = { x = [-30, 30], z = [-40, 0] }
body2.support = { bottom = ["z"], left = ["x"] }
contact = { edges = ["bottom", "top"], friction = 0, gap = 0 }
load = { edge = "top", as = "pressure", force = 6000 }
wear = { k = 1e-8 }
optimum = { functional = "uniform" }
output.paths = [{ name = "up", body = 1, from = [-30, 0], to = [30, 40] }, { name = "down", body = 2, from = [12, -40], to = [12, 0], points = 5 }]
"#;

#[test]
fn a_uniformly_strained_body_has_its_closed_form_along_any_line() {
    let problem = read(BLOCKS, &[]);
    let solution = solved(&problem);
    assert!(solution.fields.is_empty());
    let [up, down] = <[PathProfile; 2]>::try_from(solution.paths).unwrap();
    assert_eq!((up.name.as_str(), up.body, up.s.len(), up.s[100]), ("up", 1, 101, 60.0_f64.hypot(40.0)));
    for k in 0..101 {
        let stress = up.stress[k];
        for (found, wanted) in [(stress.zz, -10.0), (stress.xx, 0.0), (stress.xz, 0.0), (stress.yy, -2.5)] {
            assert!((found - wanted).abs() < 1e-9, "{found} {wanted}");
        }
        // e_xx = nu (1 + nu) p / E from the side that is held.
        let wanted = 0.25 * 1.25 * 10.0 / 8e3 * (up.position[k][0] + 30.0);
        assert!((up.displacement[k][0] - wanted).abs() < 1e-12, "{} {wanted}", up.displacement[k][0]);
    }
    // e_zz = -(1 - nu^2) p / E from the bottom.
    for (s, u) in down.s.iter().zip(&down.displacement) {
        assert!((u[2] + (1.0 - 0.09) * 10.0 / 210e3 * s).abs() < 1e-13, "{u:?}");
    }
    assert_eq!(read(&problem.resolved(), &[]).resolved(), problem.resolved());
}

#[test]
fn a_line_meets_the_fields_at_the_points_of_the_cells() {
    for (name, accuracy) in [
        ("drum-brake-block", "mesh.degree=6"),
        ("annular-punch", "mesh.degree=6"),
        ("hertz-cylinder", "accuracy=1e-3"),
        ("clutch-hot", "accuracy=1e-2"),
    ] {
        let fields = solved(&scene(name, &["tasks=[contact]", accuracy, "output.fields=true"]));
        for body in [0, 1] {
            let cells = &fields.fields[0].bodies[body].cells;
            let fine: Vec<&CellField> = cells.iter().filter(|cell| inner(cell).len() > 1).collect();
            for cell in [fine[0], fine[fine.len() / 2], fine[fine.len() - 1]] {
                let rows = [inner(cell)[0], inner(cell)[1]];
                let [from, to] = rows.map(|row| cell.position[row]);
                let path =
                    format!("output.paths=[{{ name = 'a', body = {}, from = {from:?}, to = {to:?}, points = 2 }}]", body + 1);
                let found = solved(&scene(name, &["tasks=[contact]", accuracy, &path])).paths.remove(0);
                rows.iter().enumerate().for_each(|(k, row)| assert_alike(name, (&found, k), (cell, *row)));
            }
        }
    }
}

/// Points of a cell off its border, where stresses of its neighbours are others.
fn inner(cell: &CellField) -> Vec<usize> {
    let p = cell.grid.degree;
    let inside = |(i, j): (usize, usize)| i > 0 && j > 0 && if cell.grid.triangle { i + j < p } else { i < p && j < p };
    cell.grid.steps().enumerate().filter(|(_, step)| inside(*step)).map(|(row, _)| row).collect()
}

fn assert_alike(name: &str, (path, k): (&PathProfile, usize), (cell, row): (&CellField, usize)) {
    let (a, b) = (path.stress[k], cell.stress[row]);
    let size = 1e-8 * (1.0 + b.von_mises());
    let near = [(a.xx, b.xx), (a.zz, b.zz), (a.xz, b.xz), (a.yy, b.yy), (a.xy, b.xy), (a.yz, b.yz)];
    assert!(near.iter().all(|(a, b)| (a - b).abs() < size), "{name} {near:?}");
    for (a, b) in path.displacement[k].iter().zip(cell.displacement[row]) {
        assert!((a - b).abs() < 1e-12, "{name} {a} {b}");
    }
    assert_eq!(path.temperature.len() / 2, cell.temperature.len().min(1), "{name}");
    if let (Some(a), Some(b)) = (path.temperature.get(k), cell.temperature.get(row)) {
        assert!((a - b).abs() < 1e-9 * b.abs(), "{name} {a} {b}");
    }
}

/// Rigid coordinates of body 1 are zero inside as on the surface, of round bodies too, whose lines began with the approach.
#[test]
fn a_line_begins_with_the_displacement_of_the_contact_surface() {
    for name in ["hertz-cylinder", "hertz-sphere", "cattaneo-mindlin", "translating-punch", "drum-brake-block"] {
        let z = match name {
            "drum-brake-block" => 200.0,
            "translating-punch" => 100.0,
            _ => 0.0,
        };
        for (body, up) in [(0, 1.0), (1, -1.0)] {
            let line = format!(
                "output.paths=[{{ name = 'a', body = {}, from = [0, {z}], to = [0, {}], points = 2 }}]",
                body + 1,
                z + up
            );
            let problem = scene(name, &["tasks=[contact]", "mesh.degree=6", &line]);
            let options = Options { sample: Some(Sampling::At(&[0.0])), ..Options::default() };
            let solution = solve(&problem, &options, &Bodies::default(), &mut |_| ControlFlow::Continue(())).unwrap();
            let (inside, profile) = (solution.paths[0].displacement[0], solution.profile.unwrap());
            let along = [profile.tangential_displacement[body][0], profile.normal_displacement[body][0]];
            let size = 1e-9 * along[0].hypot(along[1]);
            // What is tangential counts in the sense of the sliding, which may be against x.
            for (inside, column) in [(inside[0].abs(), along[0].abs()), (inside[2], along[1])] {
                assert!((1e3 * inside - column).abs() < size, "{name} body {}: {inside} mm {column} um", body + 1);
            }
        }
    }
}

fn fault(name: &str, paths: &str) -> Fault {
    let document = Document::read(name, builtin(name).unwrap().text, &[format!("output.paths=[{paths}]")]).unwrap();
    Problem::new(&document, &|_| Err("no file".into())).and_then(|problem| problem.available()).unwrap_err()
}

#[test]
fn lines_that_cannot_be_are_refused_before_anything_is_solved() {
    for (path, key, why) in [
        (
            "{ name = 'a', body = 2, from = [0, -150], to = [0, 150] }",
            "output.paths.0",
            "`a` leaves body 2: (0, -99), 51 mm from its beginning",
        ),
        ("{ name = 'a', body = 1, from = [0, 250], to = [0, 190] }", "output.paths.0", "leaves body 1"),
        (
            "{ name = 'a b', body = 1, from = [0, 250], to = [0, 260] }",
            "output.paths.0.name",
            "cannot go into the name of a file",
        ),
        ("{ name = 'a', body = 3, from = [0, 250], to = [0, 260] }", "output.paths.0.body", "no body 3"),
        ("{ name = 'a', body = 1, from = [0, 250], to = [0, 260], points = 1 }", "output.paths.0.points", "1 points"),
        ("{ name = 'a', body = 1, from = [0, 250], to = [0, 250] }", "output.paths.0.to", "ends where it begins"),
        (
            "{ name = 'a', body = 2, from = [0, 150], to = [0, 160], centre = [0, 0] }",
            "output.paths.0.centre",
            "begins 150 mm from its centre and ends 160 mm",
        ),
        (
            "{ name = 'a', body = 1, from = [0, 250], to = [0, 260] }, { name = 'A', body = 1, from = [0, 250], to = [0, 260] }",
            "output.paths.1.name",
            "two paths",
        ),
    ] {
        let found = fault("drum-brake-block", path);
        assert_eq!(found.key.as_deref(), Some(key), "{path}: {}", found.message);
        assert!(found.message.contains(why), "{path}: {}", found.message);
    }
}
