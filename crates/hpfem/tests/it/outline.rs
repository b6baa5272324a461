//! Round boundaries of mesh files become circles.

use crate::classics::rectangle;
use crate::common::*;
use hpfem::*;
use std::path::PathBuf;

fn file(name: &str) -> Mesh {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/meshes").join(name);
    GmshMesh::read(&std::fs::read(path).unwrap()).unwrap().mesh
}

fn circle(radius: f64) -> Outline {
    Outline::Circle { centre: [0.0; 2], radius }
}

/// Relative error of the displacement of a tube of radii 1 and 2 with 50 MPa inside at its bore.
fn lame_error(mesh: &Mesh, degree: usize) -> f64 {
    let materials = steel();
    let supports = [support("z0", Direction::Second), support("x0", Direction::First)];
    let load = [vec![traction("inner surface", |p| p.outward.map(|n| -50.0 * n))]];
    let body = Body::new(problem(mesh, degree, PLANE_STRAIN, &materials, &supports, &load, None)).unwrap();
    let field = body.field(&solved(&body, &[1.0])).unwrap();
    let (cell, xi, eta) = field.locate(mesh.vertices[mesh.nearest_vertex([1.0, 0.0])]).unwrap();
    // u_r(a) = (1 + nu)/E (A (1 - 2 nu) a + B / a), A = 50/3, B = 200/3.
    let exact = 1.3 / 210e3 * (50.0 / 3.0 * 0.4 + 200.0 / 3.0);
    (field.at(cell, xi, eta).unwrap().displacement[0] / exact - 1.0).abs()
}

#[test]
fn a_ring_from_a_file_of_any_order_reaches_lame_once_its_edges_are_circles() {
    // Without the circles the geometry stops the error at these.
    let stalled = [1e-2, 1e-4, 1e-5, 1e-8];
    for (name, degree) in [("ring", 12), ("mixed", 14)] {
        for order in 1..=4 {
            let mesh = file(&format!("{name}_{order}_41.msh"));
            let round =
                mesh.with_outline("inner surface", circle(1.0)).and_then(|m| m.with_outline("outer", circle(2.0))).unwrap();
            let (before, after) = (lame_error(&mesh, degree), lame_error(&round, degree));
            println!("{name} {order}: {before:.1e} {after:.1e}");
            assert!(before > stalled[order - 1], "{name} {order}: {before:.1e}");
            assert!(after < 1e-9, "{name} {order}: {after:.1e}");
            assert_eq!((round.cells, round.boundaries), (mesh.cells, mesh.boundaries));
        }
    }
}

#[test]
fn vertices_are_moved_onto_the_outline_and_their_other_edges_follow() {
    let ring = file("ring_3_41.msh");
    let shaken = ring.mapped(|[x, z]| [x + 1e-7 * (30.0 * z).sin(), z - 1e-7 * (20.0 * x).cos()]).unwrap();
    let round = shaken.with_outline("inner surface", circle(1.0)).unwrap();
    for e in round.boundary("inner surface").unwrap() {
        assert!(matches!(round.edges[e].curve, Curve::Arc { .. }));
        assert!(round.edges[e].vertices.iter().all(|v| (round.vertices[*v][0].hypot(round.vertices[*v][1]) - 1.0).abs() < 1e-15));
    }
    for edge in &round.edges {
        for (t, v) in [-1.0, 1.0].into_iter().zip(edge.vertices) {
            let (x, y) = (edge.curve.point(t), round.vertices[v]);
            assert!((x[0] - y[0]).hypot(x[1] - y[1]) < 1e-14);
        }
    }
    // A straight side that is straight but for noise becomes a line.
    let line = Outline::Line { points: [[0.0; 2], [1.0, 0.0]] };
    let shaken = ring.mapped(|[x, z]| [x, z + 1e-8 * (20.0 * x).cos()]).unwrap();
    let straight = shaken.with_outline("z0", line).unwrap();
    let on_it = |e: &usize| {
        straight.edges[*e].curve.is_straight() && straight.edges[*e].vertices.iter().all(|v| straight.vertices[*v][1] == 0.0)
    };
    assert!(straight.boundary("z0").unwrap().iter().all(on_it));
}

#[test]
fn an_outline_that_is_not_there_is_refused_with_the_vertex_and_its_distance() {
    let ring = file("ring_2_41.msh");
    let error = ring.with_outline("inner surface", circle(1.001)).unwrap_err();
    let Error::OffOutline { boundary, vertex, distance, allowed } = &error else { panic!("{error}") };
    assert_eq!(boundary, "inner surface");
    assert!((ring.vertices[*vertex][0].hypot(ring.vertices[*vertex][1]) - 1.0).abs() < 1e-12);
    assert!((distance - 1e-3).abs() < 1e-12 && *allowed < 1e-3, "{error}");
    assert!(error.to_string().contains("\"inner surface\" is 1.000e-3 away"), "{error}");
    let line = Outline::Line { points: [[0.0; 2], [1.0, 0.1]] };
    assert!(matches!(ring.with_outline("z0", line), Err(Error::OffOutline { .. })));
    assert!(matches!(ring.with_outline("hub", circle(1.0)), Err(Error::NoSuchBoundary { .. })));
    for wrong in [circle(0.0), circle(-1.0), circle(f64::NAN), Outline::Line { points: [[1.0; 2]; 2] }] {
        assert!(matches!(ring.with_outline("inner surface", wrong), Err(Error::OutOfRange { .. })), "{wrong:?}");
    }
    // Both ends on the circle, but the edge bends to its other side.
    let square = rectangle([0.0, 1.0], [0.0, 1.0]);
    let outward = Outline::Circle { centre: [0.5, 2.0], radius: 2.0_f64.hypot(0.5) };
    let bent = square.with_outline("bottom", outward).unwrap();
    let inward = Outline::Circle { centre: [0.5, -2.0], radius: 2.0_f64.hypot(0.5) };
    let error = bent.with_outline("bottom", inward).unwrap_err();
    assert!(matches!(error, Error::EdgeOffOutline { .. }), "{error}");
}
