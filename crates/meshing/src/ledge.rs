//! What a body is longer than its contact by, where that is less than a cell: a strip along its side, added once the cells at the ends of
//! contact are graded to about its width. The fields change there over that width, and over every size above it.

use hpfem::{Curve, Error, Mesh, Quad};

use crate::coarse::RATIO;
use crate::names::CONTACT;

/// Names of the sides of a template that ledges are added to.
const SIDES: [&str; 2] = ["left", "right"];

/// A mesh graded towards points by so many layers, its ledges (mm, left and right) added in between, the wider one first.
pub(crate) fn graded(mesh: &Mesh, points: &[[f64; 2]], ledges: [f64; 2], layers: usize) -> Result<Mesh, Error> {
    let (mut mesh, mut points, mut left) = (mesh.clone(), points.to_vec(), layers);
    let mut order: Vec<usize> = (0..2).filter(|side| ledges[*side] > 0.0).collect();
    order.sort_by(|a, b| ledges[*b].total_cmp(&ledges[*a]));
    for side in order {
        let ends = ends(&mesh, side)?;
        let at = |x: &[f64; 2]| ends.iter().any(|end| near(*end, *x, &ends));
        let widest = points.iter().filter(|x| at(x)).map(|x| longest_edge(&mesh, *x)).fold(0.0, f64::max);
        let down = ((widest / ledges[side]).ln() / (1.0 / RATIO).ln()).ceil().max(0.0) as usize;
        mesh = towards(&mesh, &points, down.min(left))?;
        left -= down.min(left);
        // Corners of the far side go along with the ledge, the end of contact stays where it is.
        let contact = mesh.boundary(CONTACT)?;
        for x in points.iter_mut().filter(|x| at(x)) {
            let vertex = mesh.nearest_vertex(*x);
            if !contact.iter().any(|e| mesh.edges[*e].vertices.contains(&vertex)) {
                x[0] += step(side, ledges[side]);
            }
        }
        mesh = widened(&mesh, side, ledges[side])?;
    }
    towards(&mesh, &points, left)
}

fn towards(mesh: &Mesh, points: &[[f64; 2]], layers: usize) -> Result<Mesh, Error> {
    let vertices: Vec<usize> = points.iter().map(|x| mesh.nearest_vertex(*x)).collect();
    mesh.refined_towards(&vertices, RATIO, layers)
}

/// From a side outwards.
fn step(side: usize, width: f64) -> f64 {
    if side == 0 { -width } else { width }
}

/// Lower and upper end of a side.
fn ends(mesh: &Mesh, side: usize) -> Result<[[f64; 2]; 2], Error> {
    let places = mesh.boundary(SIDES[side])?.into_iter().flat_map(|e| mesh.edges[e].vertices.map(|v| mesh.vertices[v]));
    let none = [[0.0, f64::INFINITY], [0.0, f64::NEG_INFINITY]];
    Ok(places.fold(none, |[low, high], x| [if x[1] < low[1] { x } else { low }, if x[1] > high[1] { x } else { high }]))
}

/// Whether two points are one, measured by the length of the side.
fn near(a: [f64; 2], b: [f64; 2], [low, high]: &[[f64; 2]; 2]) -> bool {
    (a[0] - b[0]).hypot(a[1] - b[1]) <= 1e-9 * (high[1] - low[1])
}

/// Length of the longest edge at the vertex at a point.
fn longest_edge(mesh: &Mesh, x: [f64; 2]) -> f64 {
    let vertex = mesh.nearest_vertex(x);
    let own = mesh.edges.iter().filter(|edge| edge.vertices.contains(&vertex));
    own.map(|edge| edge.curve.length()).fold(0.0, f64::max)
}

/// The mesh with a cell of the given width beside each edge of a side. The side's names go on to the new outside; those of the edges next to
/// the side to the ends of the strip, but for the contact, which ends where it did.
fn widened(mesh: &Mesh, side: usize, width: f64) -> Result<Mesh, Error> {
    let own = mesh.boundary(SIDES[side])?;
    let neighbours = mesh.edge_cells();
    let mut vertices = mesh.vertices.clone();
    let quad = |cell: &hpfem::Cell, corners| Quad { corners, material: cell.material, layer: cell.layer };
    let mut quads: Vec<Quad> = mesh.cells.iter().map(|cell| quad(cell, cell.corners)).collect();
    let mut beside: Vec<Option<usize>> = vec![None; mesh.vertices.len()];
    let mut names: Vec<([usize; 2], &str)> = Vec::new();
    for e in &own {
        let edge = &mesh.edges[*e];
        let [a, b] = edge.vertices;
        let [low, high] = if mesh.vertices[a][1] < mesh.vertices[b][1] { [a, b] } else { [b, a] };
        let [below, above] = [low, high].map(|v| {
            *beside[v].get_or_insert_with(|| {
                let [x, z] = mesh.vertices[v];
                vertices.push([x + step(side, width), z]);
                vertices.len() - 1
            })
        });
        names.extend(edge.tags.iter().map(|tag| ([below, above], mesh.boundaries[*tag].as_str())));
        let corners = if side == 0 { [below, low, high, above] } else { [low, below, above, high] };
        quads.push(quad(&mesh.cells[neighbours[*e][0].0], corners));
    }
    for (e, edge) in mesh.edges.iter().enumerate().filter(|(e, _)| !own.contains(e)) {
        let tags = || edge.tags.iter().map(|tag| mesh.boundaries[*tag].as_str());
        names.extend(tags().map(|name| (edge.vertices, name)));
        let ends = edge.vertices.into_iter().filter_map(|v| Some([v, beside[v]?]));
        for strip in ends.filter(|_| neighbours[e].len() == 1) {
            names.extend(tags().filter(|name| *name != CONTACT).map(|name| (strip, name)));
        }
    }
    let curves: Vec<([usize; 2], Curve)> = mesh.edges.iter().map(|edge| (edge.vertices, edge.curve)).collect();
    Mesh::new(vertices, &quads, &curves, &names)
}
