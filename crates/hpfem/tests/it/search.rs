//! The search for the cell of a point: the answers of trying every cell, only faster.

use crate::common::*;
use hpfem::*;

/// Uniform numbers in [0, 1).
fn random() -> impl FnMut() -> f64 {
    let mut state = 0x2545_f491_4f6c_dd1d_u64;
    move || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) as f64 / (1_u64 << 53) as f64
    }
}

/// The first cell that holds a point, by Newton's method in every one of them.
fn by_force(mesh: &Mesh, x: [f64; 2]) -> Option<usize> {
    (0..mesh.cells.len()).find(|cell| {
        let (mut t, triangle) = ([0.0; 2], mesh.cells[*cell].is_triangle());
        for _ in 0..60 {
            let (at, [[a, b], [c, d]]) = mesh.map(*cell, t[0], t[1]);
            let (det, r) = (a * d - b * c, [x[0] - at[0], x[1] - at[1]]);
            t = [t[0] + (d * r[0] - b * r[1]) / det, t[1] + (a * r[1] - c * r[0]) / det].map(|v| v.clamp(-1.5, 1.5));
            // The collapsed side of a triangle is no place for Newton's method.
            t[1] = if triangle { t[1].min(1.0 - 1e-9) } else { t[1] };
        }
        let (at, _) = mesh.map(*cell, t[0], t[1]);
        (at[0] - x[0]).hypot(at[1] - x[1]) < 1e-9 && t.iter().all(|v| v.abs() <= 1.0 + 1e-9)
    })
}

#[test]
fn the_search_finds_the_cell_that_trying_all_finds_on_curved_cells_and_triangles() {
    let mut random = random();
    for shape in [Shape::Straight, Shape::Arcs, Shape::Polynomial(6)] {
        let mesh = mixed([0, 1, 2, 3], shape, 0.0).refined().unwrap().refined_towards(&[4], 0.15, 3).unwrap();
        let search = PointSearch::new(&mesh);
        let (mut inside, mut outside) = (0, 0);
        for _ in 0..3000 {
            let x = [0.7 + 2.7 * random(), -0.4 + 2.8 * random()];
            match (search.locate(x), by_force(&mesh, x)) {
                (Ok((cell, xi, eta)), found) => {
                    let (at, _) = mesh.map(cell, xi, eta);
                    assert!((at[0] - x[0]).hypot(at[1] - x[1]) < 1e-9, "{shape:?}: {x:?}");
                    assert_eq!(Some(cell), found, "{x:?}");
                    inside += 1;
                }
                (Err(Error::OutsideMesh { .. }), None) => outside += 1,
                (other, found) => panic!("{x:?}: {other:?}, {found:?}"),
            }
        }
        assert!(inside > 1000 && outside > 300, "{inside} {outside}");
    }
}

impl std::fmt::Debug for Shape {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Shape::Straight => "straight",
            Shape::Arcs => "arcs",
            Shape::Polynomial(_) => "polynomials",
        })
    }
}

#[test]
fn points_on_edges_and_vertices_belong_to_the_first_of_their_cells() {
    for shape in [Shape::Straight, Shape::Arcs, Shape::Polynomial(6)] {
        let mesh = mixed([3, 0, 2, 1], shape, 0.0).refined().unwrap();
        let search = PointSearch::new(&mesh);
        for (edge, cells) in mesh.edges.iter().zip(mesh.edge_cells()) {
            for t in [-0.8, 0.0, 0.3] {
                let (cell, ..) = search.locate(edge.curve.point(t)).unwrap();
                assert_eq!(Some(cell), cells.iter().map(|(cell, _)| *cell).min());
            }
        }
        for (vertex, x) in mesh.vertices.iter().enumerate() {
            let first = mesh.cells.iter().position(|cell| cell.vertices().contains(&vertex));
            assert_eq!(search.locate(*x).ok().map(|(cell, ..)| cell), first);
        }
        assert!(matches!(search.locate([f64::NAN, 1.0]), Err(Error::OutsideMesh { .. })));
    }
}

#[test]
fn points_next_to_a_vertex_are_found_in_deep_layers() {
    let mesh = patch([0; 4], Shape::Straight, 0.0).refined_towards(&[4], 0.15, 12).unwrap();
    let search = PointSearch::new(&mesh);
    let x = mesh.vertices[4];
    for depth in 1..10 {
        let r = 0.15_f64.powi(depth);
        let (cell, ..) = search.locate([x[0] + 0.6 * r, x[1] + 0.3 * r]).unwrap();
        assert!(mesh.cells[cell].layer + 1 >= depth as usize, "{depth}: {}", mesh.cells[cell].layer);
    }
}

/// Fifteen layers around a vertex: its cells are as small as the round-off of its place.
#[test]
fn a_vertex_between_cells_of_the_size_of_round_off_is_found() {
    let at = |x: f64, z: f64| [x + 90.0, z + 100.0];
    let side = |start: [f64; 2], end: [f64; 2]| Curve::Line { start, end };
    let names: [Named<'_>; 0] = [];
    let ruled = Ruled {
        bottom: side(at(0.0, 0.0), at(2.0, 0.0)),
        top: side(at(0.0, 1.0), at(2.0, 1.0)),
        breaks: &[-1.0, 0.1, 1.0],
        levels: &[0.0, 1.0],
        closed: false,
        material: 0,
        names: &names,
    };
    let coarse = Mesh::ruled(&ruled).unwrap();
    let vertex = coarse.nearest_vertex(at(1.1, 1.0));
    let place = coarse.vertices[vertex];
    let mesh = coarse.refined_towards(&[vertex], 0.15, 15).unwrap();
    let search = PointSearch::new(&mesh);
    for off in [0.0, 1e-14, -1e-14] {
        let x = [place[0] + off, place[1] - off.abs()];
        let (cell, xi, eta) = search.locate(x).unwrap();
        let (found, _) = mesh.map(cell, xi, eta);
        assert!((found[0] - x[0]).hypot(found[1] - x[1]) < 1e-12, "{off:e}");
    }
    assert!(search.locate([place[0], place[1] + 1e-9]).is_err());
}
