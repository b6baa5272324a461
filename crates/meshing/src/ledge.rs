//! What a body with straight edges is longer than its contact by, where that is less than a cell: its side is moved out once the cells at the
//! ends of contact are graded to about that width, so that no cell becomes slender. The fields change there over the width, and over every size
//! above it.

use hpfem::{Error, Mesh, Quad};

use crate::coarse::RATIO;
use crate::names::CONTACT;

/// Names of the sides of a template that ledges are added to.
const SIDES: [&str; 2] = ["left", "right"];

/// A mesh graded towards points by so many layers, its ledges (mm, left and right) added in between, the wider one first.
pub(crate) fn graded(mesh: &Mesh, points: &[[f64; 2]], ledges: [f64; 2], layers: usize) -> Result<Mesh, Error> {
    let (mut mesh, mut points, mut left) = (mesh.clone(), points.to_vec(), layers);
    let mut order: Vec<usize> = (0..2).filter(|side| ledges[*side] > 0.0).collect();
    if ledges[1] > ledges[0] {
        order.reverse();
    }
    for side in order {
        let ends = ends(&mesh, side)?;
        let at = |x: &[f64; 2]| ends.iter().any(|end| near(*end, *x, &ends));
        // The triangle stands at the end of contact, beside whatever cells are there.
        let touching = points.iter().filter(|x| at(x) && touches(&mesh, **x));
        let widest = touching.map(|x| longest_edge(&mesh, *x)).fold(0.0, f64::max);
        let down = ((widest / ledges[side]).ln() / (1.0 / RATIO).ln()).ceil().max(0.0) as usize;
        mesh = towards(&mesh, &points, down.min(left))?;
        left -= down.min(left);
        // Corners of the far side go along with the ledge, the end of contact stays where it is.
        for x in points.iter_mut().filter(|x| at(x) && !touches(&mesh, **x)) {
            x[0] += step(side, ledges[side]);
        }
        mesh = widened(&mesh, side, ledges[side])?;
        // Over the width of the ledge nothing falls off: its cells keep their degree.
        mesh.cells.iter_mut().for_each(|cell| cell.layer = 0);
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

/// Whether the vertex at a point lies on the contact surface.
fn touches(mesh: &Mesh, x: [f64; 2]) -> bool {
    let vertex = mesh.nearest_vertex(x);
    mesh.boundary(CONTACT).is_ok_and(|contact| contact.iter().any(|e| mesh.edges[*e].vertices.contains(&vertex)))
}

/// Length of the longest edge at the vertex at a point.
fn longest_edge(mesh: &Mesh, x: [f64; 2]) -> f64 {
    let vertex = mesh.nearest_vertex(x);
    let own = mesh.edges.iter().filter(|edge| edge.vertices.contains(&vertex));
    own.map(|edge| edge.curve.length()).fold(0.0, f64::max)
}

/// The mesh with a side further out by a width, all but its end of contact, and a triangle between that and the new corner. The names of the
/// side go on to the new outside; those of the contact edge to the end of the body, but for the contact, which ends where it did.
fn widened(mesh: &Mesh, side: usize, width: f64) -> Result<Mesh, Error> {
    let own = mesh.boundary(SIDES[side])?;
    let contact = mesh.boundary(CONTACT)?;
    let touches = |v: &usize| contact.iter().any(|e| mesh.edges[*e].vertices.contains(v));
    let ends = |e: usize| mesh.edges[e].vertices;
    let Some((last, end)) = own.iter().find_map(|e| Some((*e, ends(*e).into_iter().find(touches)?))) else {
        return Err(Error::NotAPath { name: CONTACT.into() });
    };
    let mut vertices = mesh.vertices.clone();
    let mut on_side: Vec<usize> = own.iter().flat_map(|e| ends(*e)).filter(|v| *v != end).collect();
    on_side.sort_unstable();
    on_side.dedup();
    on_side.iter().for_each(|v| vertices[*v][0] += step(side, width));
    let corner = vertices.len();
    vertices.push([vertices[end][0] + step(side, width), vertices[end][1]]);
    let [a, b] = ends(last);
    let next = if a == end { b } else { a };
    let [second, third] = if side == 0 { [corner, next] } else { [next, corner] };
    let mut quads: Vec<Quad> = Vec::with_capacity(mesh.cells.len() + 1);
    quads.extend(mesh.cells.iter().map(|cell| Quad { corners: cell.corners, material: cell.material, layer: cell.layer }));
    let inner =
        mesh.cells.iter().find(|cell| cell.sides().any(|(_, e)| e == last)).map_or((0, 0), |cell| (cell.material, cell.layer));
    quads.push(Quad { corners: [end, second, third, third], material: inner.0, layer: inner.1 });
    let mut names: Vec<([usize; 2], &str)> = Vec::new();
    for (e, edge) in mesh.edges.iter().enumerate() {
        let tags = || edge.tags.iter().map(|tag| mesh.boundaries[*tag].as_str());
        let walk = if e == last { [next, corner] } else { edge.vertices };
        names.extend(tags().map(|name| (walk, name)));
        if contact.contains(&e) && edge.vertices.contains(&end) {
            names.extend(tags().filter(|name| *name != CONTACT).map(|name| ([end, corner], name)));
        }
    }
    Mesh::new(vertices, &quads, &[], &names)
}
