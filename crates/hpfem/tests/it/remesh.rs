//! Moving a vertex along the boundary.

use approx::assert_abs_diff_eq;
use hpfem::*;

fn block() -> Mesh {
    let line = |z| Curve::Line { start: [-1.0, z], end: [1.0, z] };
    let names = [Named { side: Side::Bottom, range: None, name: "contact" }, Named { side: Side::Top, range: None, name: "top" }];
    let region = Ruled {
        bottom: line(0.0),
        top: line(1.0),
        breaks: &[-1.0, 0.0, 1.0],
        levels: &[0.0, 1.0],
        closed: false,
        material: 0,
        names: &names,
    };
    Mesh::ruled(&region).unwrap()
}

fn ring() -> Mesh {
    let arc = |radius| Curve::Arc { centre: [0.0; 2], radius, from: 2.0, to: 1.0 };
    let names = [Named { side: Side::Top, range: None, name: "contact" }];
    let breaks = [-1.0, 0.0, 1.0];
    let region = Ruled {
        bottom: arc(1.0),
        top: arc(2.0),
        breaks: &breaks,
        levels: &[0.0, 1.0],
        closed: false,
        material: 0,
        names: &names,
    };
    Mesh::ruled(&region).unwrap()
}

#[test]
fn a_vertex_moves_along_a_line_towards_larger_coordinates() {
    let mesh = block();
    let v = mesh.nearest_vertex([0.0, 0.0]);
    for shift in [-0.6, 0.0, 0.3, 0.9] {
        let moved = mesh.with_vertex_moved(v, shift).unwrap();
        assert_abs_diff_eq!(moved.vertices[v][0], shift, epsilon = 1e-15);
        assert_eq!(moved.boundary("contact").unwrap().len(), 2);
        let graded = moved.refined_towards(&[v], 0.15, 4).unwrap();
        assert_eq!(graded.cells.len(), 2 + 4 * 4);
    }
}

/// Cells of 1 by 4 around the middle of one edge: with ratios by the lengths the small ones are squares, from whatever corner a cell is walked.
#[test]
fn small_cells_of_slender_ones_are_as_long_as_high_by_a_ratio_for_each_edge() {
    let vertices = vec![[-1.0, 0.0], [0.0, 0.0], [1.0, 0.0], [1.0, 4.0], [0.0, 4.0], [-1.0, 4.0]];
    for turned in 0..4 {
        let quad =
            |corners: [usize; 4]| Quad { corners: std::array::from_fn(|k| corners[(k + turned) % 4]), material: 0, layer: 0 };
        let mesh = Mesh::new(vertices.clone(), &[quad([0, 1, 4, 5]), quad([1, 2, 3, 4])], &[], &[]).unwrap();
        let graded = mesh.refined_towards_by(&[1], |e| 0.25 / mesh.edges[e].curve.length()).unwrap();
        assert_eq!(graded.cells.len(), 6);
        let small: Vec<&Cell> = graded.cells.iter().filter(|cell| cell.layer == 1).collect();
        assert_eq!(small.len(), 2);
        for edge in small.iter().flat_map(|cell| cell.sides()).map(|(_, e)| &graded.edges[e]) {
            assert_abs_diff_eq!(edge.curve.length(), 0.25, epsilon = 1e-15);
        }
        // One ratio for all is the layer of `refined_towards`.
        let [by, alike] = [mesh.refined_towards_by(&[1], |_| 0.3), mesh.refined_towards(&[1], 0.3, 1)].map(Result::unwrap);
        assert_eq!(by.vertices, alike.vertices);
    }
}

#[test]
fn a_vertex_moves_along_an_arc_and_the_arc_stays() {
    let mesh = ring();
    let v = mesh.nearest_vertex([2.0 * 1.5_f64.cos(), 2.0 * 1.5_f64.sin()]);
    for shift in [-0.8, 0.5] {
        let moved = mesh.with_vertex_moved(v, shift).unwrap();
        let x = moved.vertices[v];
        // The path runs towards larger x: angles fall.
        assert_abs_diff_eq!(x[1].atan2(x[0]), 1.5 - shift / 2.0, epsilon = 1e-14);
        for e in moved.boundary("contact").unwrap() {
            let middle = moved.edges[e].curve.point(0.1);
            assert_abs_diff_eq!(middle[0].hypot(middle[1]), 2.0, epsilon = 1e-14);
        }
    }
}

#[test]
fn impossible_moves_are_refused_with_the_reason() {
    let mesh = block();
    let v = mesh.nearest_vertex([0.0, 0.0]);
    for shift in [1.0, -1.0, 5.0, f64::NAN] {
        assert!(matches!(mesh.with_vertex_moved(v, shift), Err(Error::Immovable { .. })), "{shift}");
    }
    let corner = mesh.nearest_vertex([-1.0, 0.0]);
    assert!(matches!(mesh.with_vertex_moved(corner, 0.1), Err(Error::Immovable { .. })));
    assert!(matches!(mesh.with_vertex_moved(99, 0.1), Err(Error::Immovable { .. })));
}
