//! Boundaries that close: their paths start at the vertex with the smallest coordinates and have the body on the left.

use crate::common::*;
use hpfem::*;
use std::f64::consts::{PI, TAU};

/// A ring of radii 1 and 2 whose columns start at the angle `start`; cells in the order of the walk, or turned round.
fn ring(start: f64, columns: u32, backwards: bool) -> Mesh {
    let sense = if backwards { -1.0 } else { 1.0 };
    let arc = |radius| Curve::Arc { centre: [0.0; 2], radius, from: start, to: start + sense * TAU };
    let [inner, outer] = if backwards { [Side::Bottom, Side::Top] } else { [Side::Top, Side::Bottom] };
    let names = [Named { side: outer, range: None, name: "outer" }, Named { side: inner, range: None, name: "hub" }];
    let breaks: Vec<f64> = (0..=columns).map(|i| f64::from(2 * i) / f64::from(columns) - 1.0).collect();
    let [bottom, top] = if backwards { [1.0, 2.0] } else { [2.0, 1.0] }.map(arc);
    Mesh::ruled(&Ruled { bottom, top, breaks: &breaks, levels: &[0.0, 1.0], closed: true, material: 0, names: &names }).unwrap()
}

/// Force of a traction along the tangent over a part of a boundary of a ring held at its other side.
fn force(mesh: &Mesh, boundary: &str, range: [f64; 2]) -> [f64; 2] {
    let (materials, held) = (steel(), if boundary == "hub" { "outer" } else { "hub" });
    let supports = [support(held, Direction::First), support(held, Direction::Second)];
    let load = [vec![traction(boundary, |p| p.outward).within(range)]];
    let body = Body::new(problem(mesh, 6, PLANE_STRESS, &materials, &supports, &load, None)).unwrap();
    let state = solved(&body, &[1.0]);
    [0, 1].map(|k| -(0..2).map(|s| body.interface.reaction(s, &state)[k]).sum::<f64>() / 0.7)
}

#[test]
fn a_part_of_a_closed_boundary_starts_at_its_smallest_vertex_with_the_body_on_the_left() {
    for columns in [4, 5, 8] {
        for (start, backwards) in
            [(PI, false), (PI, true), (PI + TAU / f64::from(columns), false), (PI - TAU / f64::from(columns), true)]
        {
            let mesh = ring(start, columns, backwards);
            // Arc length s from (-2, 0) anti-clockwise on the outside, from (-1, 0) clockwise in the hole.
            let (a, b) = (0.7, 2.9);
            let outer = force(&mesh, "outer", [a, b]);
            let [from, to] = [a, b].map(|s| PI + s / 2.0);
            let wanted = [2.0 * (to.sin() - from.sin()), 2.0 * (from.cos() - to.cos())];
            assert!((0..2).all(|i| (outer[i] - wanted[i]).abs() < 1e-9), "{columns} {start} {backwards}: {outer:?} {wanted:?}");
            let hub = force(&mesh, "hub", [a, b]);
            let [from, to] = [a, b].map(|s| PI - s);
            let wanted = [to.sin() - from.sin(), from.cos() - to.cos()];
            assert!((0..2).all(|i| (hub[i] - wanted[i]).abs() < 1e-9), "{columns} {start} {backwards}: {hub:?} {wanted:?}");
        }
    }
}

#[test]
fn the_whole_of_a_closed_boundary_balances_and_two_rings_are_no_path() {
    let mesh = ring(PI, 4, false);
    assert!(force(&mesh, "outer", [0.0, 4.0 * PI]).iter().all(|f| f.abs() < 1e-9));
    let names: Vec<([usize; 2], &str)> = mesh.edges.iter().filter(|e| !e.tags.is_empty()).map(|e| (e.vertices, "both")).collect();
    let curves: Vec<([usize; 2], Curve)> = mesh.edges.iter().map(|e| (e.vertices, e.curve)).collect();
    let quads: Vec<Quad> = mesh.cells.iter().map(|c| Quad { corners: c.corners, material: 0, layer: 0 }).collect();
    let both = Mesh::new(mesh.vertices.clone(), &quads, &curves, &names).unwrap();
    let load = [vec![traction("both", |p| p.outward).within([0.0, 1.0])]];
    let supports = [support("both", Direction::First), support("both", Direction::Second)];
    let error = Body::new(problem(&both, 3, PLANE_STRESS, &steel(), &supports, &load, None)).err().unwrap();
    assert!(matches!(error, Error::NotAPath { .. }), "{error}");
}
