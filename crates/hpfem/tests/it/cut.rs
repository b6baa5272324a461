//! Cuts from edge to edge: the region stays the same, and nothing hangs.

use crate::common::{Shape, patch};
use hpfem::*;

/// Area by quadrature of the Jacobian.
fn area(mesh: &Mesh) -> f64 {
    let rule = gauss(24);
    let at = |c: usize| {
        let points = rule.points.iter().zip(&rule.weights);
        points
            .flat_map(|(x, w)| rule.points.iter().zip(&rule.weights).map(move |(y, v)| (*x, *y, w * v)))
            .map(|(x, y, w)| {
                let d = mesh.map(c, x, y).1;
                w * (d[0][0] * d[1][1] - d[0][1] * d[1][0])
            })
            .sum::<f64>()
    };
    (0..mesh.cells.len()).map(at).sum()
}

fn length(mesh: &Mesh, name: &str) -> f64 {
    mesh.boundary(name).unwrap().iter().map(|e| mesh.edges[*e].curve.length()).sum()
}

#[test]
fn a_cut_goes_through_turned_cells_and_keeps_the_region() {
    for turns in [[0; 4], [1, 3, 2, 0], [3, 2, 1, 3]] {
        for shape in [Shape::Straight, Shape::Arcs, Shape::Polynomial(4)] {
            let mesh = patch(turns, shape, 0.0);
            let start = mesh.boundary("bottom").unwrap()[0];
            let cut = mesh.cut_through(start, 0.3).unwrap();
            assert_eq!((cut.cells.len(), cut.edges.len()), (6, 12 + 3 + 2));
            assert_eq!(["bottom", "top", "left", "right"].map(|n| cut.boundary(n).unwrap().len()), [3, 3, 2, 2]);
            assert!((area(&cut) - area(&mesh)).abs() < 1e-9, "{}", area(&cut) - area(&mesh));
            for name in ["bottom", "top", "left", "right"] {
                assert!((length(&cut, name) - length(&mesh, name)).abs() < 1e-9);
            }
            // The part next to the first vertex is 0.65 of the edge, whichever way the cells are turned.
            let piece = |p: f64| {
                let x = mesh.edges[start].curve.point(p);
                cut.vertices.iter().any(|v| (v[0] - x[0]).hypot(v[1] - x[1]) < 1e-12)
            };
            assert!(piece(0.3) && !piece(-0.3));
        }
    }
}

#[test]
fn rows_around_a_vertex_of_three_cells_cut_across_each_other() {
    // A hexagon of three cells around its middle: the row of 0-1 goes on through 2-6 to 3-4, that of 1-2 through 0-6 to 4-5.
    let ring = |k: usize| {
        let a = std::f64::consts::FRAC_PI_3 * k as f64;
        [a.cos(), a.sin()]
    };
    let mut vertices: Vec<[f64; 2]> = (0..6).map(ring).collect();
    vertices.push([0.0, 0.0]);
    let quads = [[6, 0, 1, 2], [6, 2, 3, 4], [6, 4, 5, 0]].map(|corners| Quad { corners, material: 0, layer: 0 });
    let mesh = Mesh::new(vertices, &quads, &[], &[]).unwrap();
    let find =
        |mesh: &Mesh, a: usize, b: usize| mesh.edges.iter().position(|e| e.vertices == [a, b] || e.vertices == [b, a]).unwrap();
    let once = mesh.cut_through(find(&mesh, 0, 1), 0.0).unwrap();
    assert_eq!(once.cells.len(), 5);
    let twice = once.cut_through(find(&once, 1, 2), 0.4).unwrap();
    assert_eq!(twice.cells.len(), 8);
    assert!((area(&twice) - area(&mesh)).abs() < 1e-13);
}

#[test]
fn a_row_ends_in_the_far_corner_of_a_triangle() {
    // Two quads beside each other, a triangle on top of the first, and one beside it that shares two cut edges with nothing.
    let vertices = vec![[0.0, 0.0], [1.0, 0.0], [2.0, 0.1], [0.0, 1.0], [1.1, 1.0], [2.0, 1.2], [0.5, 2.0]];
    let quads = [[0, 1, 4, 3], [1, 2, 5, 4], [3, 4, 6, 6], [4, 5, 6, 6]].map(|corners| Quad { corners, material: 0, layer: 0 });
    let mesh = Mesh::new(vertices, &quads, &[], &[]).unwrap();
    let find =
        |mesh: &Mesh, a: usize, b: usize| mesh.edges.iter().position(|e| e.vertices == [a, b] || e.vertices == [b, a]).unwrap();
    let once = mesh.cut_through(find(&mesh, 0, 1), 0.2).unwrap();
    assert_eq!(once.cells.len(), 6);
    // An edge between two triangles: both are cut in two.
    let twice = once.cut_through(find(&once, 4, 6), -0.3).unwrap();
    assert_eq!(twice.cells.len(), 8);
    for cut in [once, twice] {
        assert!((area(&cut) - area(&mesh)).abs() < 1e-13);
    }
}

#[test]
fn a_row_that_turns_round_cuts_a_triangle_twice() {
    // Three quads around the triangle 0-1-2; what is left of the ring between the first and the last is the triangle 0-6-3.
    let at = |radius: f64, degrees: f64| [radius * degrees.to_radians().cos(), radius * degrees.to_radians().sin()];
    let inner = [0.0, 120.0, 240.0].map(|a| at(1.0, a));
    let outer = [20.0, 120.0, 240.0, 340.0].map(|a| at(3.0, a));
    let vertices: Vec<[f64; 2]> = inner.into_iter().chain(outer).collect();
    let quads = [[0, 1, 2, 2], [0, 3, 4, 1], [1, 4, 5, 2], [2, 5, 6, 0], [0, 6, 3, 3]].map(|corners| Quad {
        corners,
        material: 0,
        layer: 0,
    });
    let mesh = Mesh::new(vertices, &quads, &[], &[]).unwrap();
    let edge = mesh.edges.iter().position(|e| e.vertices == [0, 3] || e.vertices == [3, 0]).unwrap();
    let cut = mesh.cut_through(edge, 0.2).unwrap();
    assert_eq!((cut.cells.len(), cut.cells.iter().filter(|c| c.is_triangle()).count()), (9, 2));
    assert!((area(&cut) - area(&mesh)).abs() < 1e-12);
}

#[test]
fn a_closed_row_of_polar_cells_is_cut_into_rings_of_arcs() {
    let turn = std::f64::consts::TAU;
    let arc = |radius| Curve::Arc { centre: [1.0, 2.0], radius, from: 0.0, to: turn };
    let names = [Named { side: Side::Left, range: None, name: "seam" }];
    let breaks = [-1.0, -0.4, 0.2, 0.5, 1.0];
    let mesh = Mesh::ruled(&Ruled {
        bottom: arc(3.0),
        top: arc(2.0),
        breaks: &breaks,
        levels: &[0.0, 1.0],
        closed: true,
        material: 0,
        names: &names,
    })
    .unwrap();
    let cut = mesh.cut_through(mesh.boundary("seam").unwrap()[0], -0.5).unwrap();
    assert_eq!((cut.cells.len(), cut.boundary("seam").unwrap().len()), (8, 2));
    let radii = |r: f64| {
        let round = |e: &Edge| matches!(e.curve, Curve::Arc { radius, .. } if (radius - r).abs() < 1e-14);
        cut.edges.iter().filter(|e| round(e)).count()
    };
    assert_eq!([3.0, 2.75, 2.25, 2.0].map(radii), [4, 4, 0, 4]);
    assert!((area(&cut) - 5.0 * std::f64::consts::PI).abs() < 1e-10);
}

#[test]
fn a_cut_outside_the_edge_is_refused() {
    let mesh = patch([0; 4], Shape::Straight, 0.0);
    for t in [-1.0, 1.0, f64::NAN] {
        assert!(matches!(mesh.cut_through(0, t), Err(Error::OutOfRange { .. })));
    }
    assert!(matches!(mesh.cut_through(99, 0.0), Err(Error::Beyond { index: 99, .. })));
}

/// Two rows that cross each other, whichever edge is named first; an edge of a row that is cut already adds nothing.
#[test]
fn rows_are_cut_at_once_and_in_no_order() {
    let mesh = patch([1, 3, 2, 0], Shape::Arcs, 0.0);
    let [bottom, top, left] = ["bottom", "top", "left"].map(|name| mesh.boundary(name).unwrap()[0]);
    let (cut, rows) = mesh.cut_rows(&[bottom, left]).unwrap();
    assert_eq!((cut.cells.len(), rows), (9, 2));
    assert!((area(&cut) - area(&mesh)).abs() < 1e-9);
    let (other, _) = mesh.cut_rows(&[left, bottom]).unwrap();
    assert_eq!(other, cut);
    let both: Vec<usize> = [bottom, top, left].into_iter().chain(mesh.boundary("bottom").unwrap()).collect();
    assert!(mesh.cut_rows(&both).unwrap().1 <= 3, "of {both:?}");
    let (same, none) = mesh.cut_rows(&[]).unwrap();
    assert_eq!((same.cells.len(), none), (4, 0));
    assert!(matches!(mesh.cut_rows(&[mesh.edges.len()]), Err(Error::Beyond { .. })));
}
