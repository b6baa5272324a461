//! What the outline of a template says without a mesh is what its mesh has.

use hpfem::{Curve, Mesh};
use meshing::{Body, CONTACT, ContactLine, Couple, Cut, Extent, HalfDiscOnFlat, contact_line, meshes, outline};
use scene::LoadKind;

use crate::common::{DISC, DRUM, PLATE, PUNCH, SEGMENT, SHOE, UNDER_DISC, body, couple, extent, two_cells};

/// Lengths that agree (mm): bodies of the tests are about 100 mm large.
const NEAR: f64 = 1e-10;

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

/// Vertices at which a boundary begins or ends; none of a ring.
fn ends(mesh: &Mesh, edges: &[usize]) -> Vec<[f64; 2]> {
    let all: Vec<usize> = edges.iter().flat_map(|e| mesh.edges[*e].vertices).collect();
    let single = |v: &&usize| all.iter().filter(|other| other == v).count() == 1;
    all.iter().filter(single).map(|v| mesh.vertices[*v]).collect()
}

/// Whether a point lies on a line or arc.
fn lies_on(curve: &Curve, x: [f64; 2]) -> bool {
    match *curve {
        Curve::Line { start, end } => (distance(x, start) + distance(x, end) - distance(start, end)).abs() < NEAR,
        Curve::Arc { centre, radius, from, to } => {
            let turn = std::f64::consts::TAU;
            let off = ((x[1] - centre[1]).atan2(x[0] - centre[0]) - 0.5 * (from + to) + 0.5 * turn).rem_euclid(turn) - 0.5 * turn;
            (distance(x, centre) - radius).abs() < NEAR && off.abs() <= 0.5 * (to - from).abs() + 1e-12
        }
        Curve::Polynomial { .. } => false,
    }
}

/// The edges of the outline are boundaries of the mesh under the same names, and the only ones; their ends and the points between are there.
fn outline_agrees(body: &Body, mesh: &Mesh) {
    let outline = outline(body);
    let mut known = outline.names(true);
    let mut found: Vec<String> = mesh.boundaries.iter().filter(|name| !name.starts_with('@')).cloned().collect();
    known.sort();
    found.sort();
    found.dedup();
    assert_eq!(known, found);
    let sides = mesh.edge_cells();
    for edge in &outline.edges {
        let own = mesh.boundary(&edge.name).unwrap();
        assert!(!own.is_empty(), "{} is empty", edge.name);
        assert_eq!(own.iter().all(|e| sides[*e].len() == 2), edge.inside, "{}", edge.name);
        for x in &edge.points {
            assert!(own.iter().any(|e| lies_on(&mesh.edges[*e].curve, *x)), "{} has no point {x:?}", edge.name);
        }
        if body.is_given() {
            continue;
        }
        let ends = ends(mesh, &own);
        let spanned = [edge.points[0], edge.points[edge.points.len() - 1]];
        assert!(ends.is_empty() || ends.len() == 2, "{}: ends {ends:?}", edge.name);
        for end in &ends {
            assert!(spanned.iter().any(|x| distance(*x, *end) < NEAR), "{} ends at {end:?}, not in {spanned:?}", edge.name);
        }
    }
    let closed = outline.edges.iter().filter(|edge| ends(mesh, &mesh.boundary(&edge.name).unwrap()).is_empty());
    assert_eq!(closed.count(), if body.geometry.name() == "ring" { 2 } else { 0 });
}

/// The line of the contact edge contains the vertices of the contact, which reach from end to end of the extent.
fn contact_line_agrees(body: &Body, shaped: bool, mesh: &Mesh) {
    let line = contact_line(body, shaped).unwrap();
    for e in mesh.boundary(CONTACT).unwrap() {
        for v in mesh.edges[e].vertices {
            let x = mesh.vertices[v];
            match line {
                ContactLine::Line { z, x: [from, to] } => {
                    assert!((x[1] - z).abs() < NEAR && x[0] > from - NEAR && x[0] < to + NEAR, "{x:?} off {line:?}");
                }
                ContactLine::Circle { centre, radius, angles: [from, to], internal } => {
                    let middle = 0.5 * (from + to);
                    let turn = std::f64::consts::TAU;
                    let angle = (x[0] - centre[0]).atan2(x[1] - centre[1]);
                    let off = (angle - middle + 0.5 * turn).rem_euclid(turn) - 0.5 * turn;
                    assert!(
                        (distance(x, centre) - radius).abs() < NEAR && off.abs() <= 0.5 * (to - from) + 1e-12,
                        "{x:?} off {line:?}"
                    );
                    // Body 1 inside the circle, or body 2 outside: the other side is no part of it.
                    let inner = mesh.vertices.iter().all(|x| distance(*x, centre) < radius + NEAR);
                    assert_eq!(inner, internal == shaped);
                }
            }
        }
    }
}

fn both_agree(couple: &Couple, meshes: &[Mesh; 2]) {
    for (number, mesh) in meshes.iter().enumerate() {
        outline_agrees(&couple.bodies[number], mesh);
        contact_line_agrees(&couple.bodies[number], number == 0, mesh);
    }
}

fn on_known_surface(couple: &Couple) {
    let extent = extent(couple);
    for cut in [Cut::Plain, Cut::Shifted, Cut::Ends(&[-0.3, 0.45])] {
        both_agree(couple, &meshes(couple, extent, 2, cut).unwrap());
    }
}

#[test]
fn shoe_block_on_ring() {
    let drum = body("body2", DRUM, "outer", "inner = ['x', 'z']");
    on_known_surface(&couple(body("body1", SHOE, "inner", "left = ['x']"), drum, "top", LoadKind::Pressure));
}

/// The line at x = 0 is in the mesh of a symmetric segment that is held there.
#[test]
fn ring_segment_on_ring() {
    let drum = || body("body2", DRUM, "outer", "inner = ['x', 'z']");
    let symmetric = SEGMENT.replace("120", "90");
    on_known_surface(&couple(body("body1", &symmetric, "inner", "centre = ['x']"), drum(), "outer", LoadKind::Pressure));
}

#[test]
fn rectangle_on_rectangle() {
    let plate = body("body2", PLATE, "top", "bottom = ['x', 'z']");
    on_known_surface(&couple(body("body1", PUNCH, "bottom", "left = ['x']"), plate, "top", LoadKind::Rigid));
}

/// A drum around its shoe is touched on its bore.
#[test]
fn ring_around_cells() {
    let shoe = "
        blocks.points.a = { radius = 200, angle = '150 deg' }
        blocks.points.b = { radius = 200, angle = '210 deg' }
        blocks.points.c = { radius = 150, angle = '210 deg' }
        blocks.points.d = { radius = 150, angle = '150 deg' }
        blocks.curves.ab.arc = { ends = ['a', 'b'] }
        blocks.curves.bc.line = ['b', 'c']
        blocks.curves.dc.arc = { ends = ['d', 'c'] }
        blocks.curves.ad.line = ['a', 'd']
        blocks.cells.one = { curves = ['ab', 'bc', 'dc', 'ad'] }
        blocks.edges = { face = ['ab'], left = ['bc'], right = ['ad'], back = ['dc'] }
    ";
    let drum = body("body2", "ring = { inner = 200, outer = 260 }", "inner", "outer = ['x', 'z']");
    on_known_surface(&couple(body("body1", shoe, "face", "left = ['x']"), drum, "back", LoadKind::Pressure));
}

/// The half-disc's own meshes, whole (through a rigid edge) and the right half.
#[test]
fn half_disc_on_rectangle() {
    let bodies = || [body("body1", DISC, "arc", "centre = ['x']"), body("body2", UNDER_DISC, "top", "bottom = ['x', 'z']")];
    let [disc, plate] = bodies();
    let whole = couple(disc, plate, "top", LoadKind::Rigid);
    let on_flat = HalfDiscOnFlat::of(&whole).unwrap().unwrap();
    both_agree(&whole, &on_flat.meshes(&[0.8, 1.3], 2).unwrap());

    let [disc, plate] = bodies();
    let half = couple(disc, plate, "top", LoadKind::Pressure);
    let on_flat = HalfDiscOnFlat::of(&half).unwrap().unwrap();
    let meshes = on_flat.meshes(&[1.3], 2).unwrap();
    for (number, mesh) in meshes.iter().enumerate() {
        contact_line_agrees(&half.bodies[number], number == 0, mesh);
        assert!(mesh.vertices.iter().all(|x| x[0] >= 4.0), "the half right of the centre");
        for edge in outline(&half.bodies[number]).edges.iter().filter(|edge| edge.name != "left") {
            let far = edge.points.iter().map(|x| x[0]).fold(f64::MIN, f64::max);
            let own = mesh.boundary(&edge.name).unwrap();
            let reached = own.iter().flat_map(|e| mesh.edges[*e].vertices).map(|v| mesh.vertices[v][0]).fold(f64::MIN, f64::max);
            assert!((reached - far).abs() < NEAR, "{}: {reached}, not {far}", edge.name);
        }
    }
}

/// The same templates as cells, to meet a body that is given by its own.
#[test]
fn templates_as_cells() {
    let extent = Extent::Round { x: [2.0, 6.5], touch: 4.0, radius: 50.0 };
    let disc = || body("body1", DISC, "arc", "centre = ['x']");
    let cells = body("body2", &two_cells([-56.0, 9.0, 64.0], [-80.0, 0.0]), "top", "bottom = ['x', 'z']");
    let first = couple(disc(), cells, "top", LoadKind::Pressure);
    both_agree(&first, &meshes(&first, extent, 2, Cut::Plain).unwrap());
    both_agree(&first, &meshes(&first, extent, 2, Cut::Ends(&[-0.5, 0.6])).unwrap());
}

/// What a body is as high as, above the middle of its contact edge.
#[test]
fn thickness_is_that_of_the_mesh() {
    for (geometry, contact, thickness) in
        [(SHOE, "inner", 100.0), (SEGMENT, "inner", 15.0), (PUNCH, "bottom", 100.0), (DISC, "arc", 50.0)]
    {
        assert_eq!(outline(&body("body1", geometry, contact, "")).thickness, thickness, "{geometry}");
    }
    assert_eq!(outline(&body("body1", &two_cells([-3.0, 1.0, 5.0], [2.0, 9.0]), "bottom", "")).thickness, 7.0);
}

/// Body 1 of a built-in scene that is given by its cells.
fn built_in(name: &str) -> Body {
    let document = scene::Document::read(name, scene::builtin(name).unwrap().text, &[]).unwrap();
    let contact = document.scene.contact.unwrap().edges.unwrap()[0].clone();
    let mut body = document.scene.body1.unwrap();
    let given = meshing::read_cells("body1", &mut body, &|_| Err("no files".to_string())).unwrap().unwrap();
    let cells = Some(std::sync::Arc::new(given.mesh));
    Body {
        key: "body1",
        geometry: body.geometry,
        cells,
        materials: given.materials,
        supports: body.support,
        contact,
        loads: Vec::new(),
    }
}

/// Of a body of several materials the one at the contact counts, outside a drum as inside: no back plate, and nothing negative.
#[test]
fn thickness_of_a_lined_shoe_is_that_of_its_lining() {
    for (name, thickness) in [("lining-on-back", 10.0), ("internal-shoe", 6.0)] {
        let found = outline(&built_in(name)).thickness;
        assert!((found - thickness).abs() < 1e-2 * thickness, "{name}: {found}");
    }
}
