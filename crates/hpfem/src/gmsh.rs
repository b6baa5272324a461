//! Meshes from gmsh files: MSH 4.1 and 2.2, text and binary, quadrilaterals and triangles of order 1 to 4, physical groups by name.
//!
//! Bytes in, mesh out; no file is opened here. Physical curves become boundaries, physical surfaces materials in the order of their tags.
//! Edges of higher order become polynomial curves through their nodes. The mesh must be plane: in (x, y) with constant z, or in (x, z)
//! with constant y; the first coordinate is x (or r), the second the other one.

use crate::curve::Curve;
use crate::error::Error;
use crate::gmsh_error::GmshError;
use crate::gmsh_read::{Element, Tables, read};
use crate::mesh::{Mesh, Quad};
use std::collections::{BTreeSet, HashMap};

/// A mesh from a file with the names of its materials.
#[derive(Clone, Debug, PartialEq)]
pub struct GmshMesh {
    /// The mesh; its boundaries carry the names of the physical curves.
    pub mesh: Mesh,
    /// Names of the physical surfaces, by material index; cells in no group have the last index, named "" if there are any.
    pub materials: Vec<String>,
}

impl GmshMesh {
    /// Reads a file.
    ///
    /// # Errors
    /// [`GmshError`]; never a panic, whatever the bytes.
    pub fn read(bytes: &[u8]) -> Result<GmshMesh, GmshError> {
        let tables = read(bytes)?;
        let plane = Plane::of(&tables)?;
        let surfaces = surface_tags(&tables);
        let mut materials: Vec<String> = surfaces.iter().map(|t| group_name(&tables, 2, *t)).collect();
        let mut cells = Cells::default();
        for element in tables.elements.iter().filter(|e| corners(e.kind) > 0) {
            let group = element.physical.first().and_then(|t| surfaces.binary_search(t).ok());
            cells.push(&tables, &plane, element, group.unwrap_or(surfaces.len()))?;
        }
        if cells.quads.is_empty() {
            return Err(GmshError::NoCells);
        }
        if cells.quads.iter().any(|q| q.material == surfaces.len()) {
            materials.push(String::new());
        }
        let named = cells.named_edges(&tables)?;
        let mut curves: Vec<([usize; 2], Curve)> = cells.curves.into_iter().collect();
        curves.sort_unstable_by_key(|(e, _)| *e);
        let names: Vec<([usize; 2], &str)> = named.iter().map(|(e, n)| (*e, n.as_str())).collect();
        let node = |vertex: usize| cells.numbers.iter().find(|(_, v)| **v == vertex).map_or(0, |(node, _)| *node);
        let mesh = Mesh::new(cells.vertices, &cells.quads, &curves, &names).map_err(|error| {
            if let Error::Overlapping { a, b } = error {
                return GmshError::Overlapping { nodes: [node(a), node(b)] };
            }
            GmshError::Mesh(error)
        })?;
        Ok(GmshMesh { mesh, materials })
    }
}

/// The cells of a file.
#[derive(Default)]
struct Cells {
    /// Number of the vertex at each node that is a corner.
    numbers: HashMap<u64, usize>,
    vertices: Vec<[f64; 2]>,
    quads: Vec<Quad>,
    /// Curves of the edges of higher order, by their vertices.
    curves: HashMap<[usize; 2], Curve>,
}

impl Cells {
    /// Adds an element of the file as a cell of the given material.
    fn push(&mut self, tables: &Tables, plane: &Plane, element: &Element, material: usize) -> Result<(), GmshError> {
        let at = |k: usize| plane.position(tables, element.tag, element.nodes[k]);
        let (n, order) = (corners(element.kind), order(element.kind));
        let mut corners = [0; 4];
        for (k, corner) in corners.iter_mut().enumerate().take(n) {
            let x = at(k)?;
            *corner = *self.numbers.entry(element.nodes[k]).or_insert_with(|| {
                self.vertices.push(x);
                self.vertices.len() - 1
            });
        }
        if n == 3 {
            corners[3] = corners[2];
        }
        for k in 0..n {
            let (a, b) = (corners[k], corners[(k + 1) % n]);
            if order > 1 && !self.curves.contains_key(&[a, b]) && !self.curves.contains_key(&[b, a]) {
                let mut points = vec![at(k)?];
                for i in 0..order - 1 {
                    points.push(at(n + k * (order - 1) + i)?);
                }
                points.push(at((k + 1) % n)?);
                self.curves.insert([a, b], edge_curve(&points)?);
            }
        }
        let x = corners.map(|v| self.vertices[v]);
        // Twice the area by the diagonals, of triangles too.
        let area = (x[2][0] - x[0][0]) * (x[3][1] - x[1][1]) - (x[3][0] - x[1][0]) * (x[2][1] - x[0][1]);
        if area < 0.0 {
            corners = if n == 3 {
                [corners[0], corners[2], corners[1], corners[1]]
            } else {
                [corners[0], corners[3], corners[2], corners[1]]
            };
        }
        self.quads.push(Quad { corners, material, layer: 0 });
        Ok(())
    }

    /// Edges on physical curves with the names of these.
    fn named_edges(&self, tables: &Tables) -> Result<Vec<([usize; 2], String)>, GmshError> {
        let mut edges: BTreeSet<[usize; 2]> = BTreeSet::new();
        for quad in &self.quads {
            for k in 0..4 {
                let (a, b) = (quad.corners[k], quad.corners[(k + 1) % 4]);
                edges.insert([a.min(b), a.max(b)]);
            }
        }
        let mut named: Vec<([usize; 2], String)> = Vec::new();
        for element in tables.elements.iter().filter(|e| matches!(e.kind, 1 | 8 | 26 | 27)) {
            for tag in element.physical.iter() {
                let name = group_name(tables, 1, *tag);
                let ends = [0, 1].map(|k| self.numbers.get(&element.nodes[k]).copied());
                match ends {
                    [Some(a), Some(b)] if edges.contains(&[a.min(b), a.max(b)]) => named.push(([a, b], name)),
                    _ => return Err(GmshError::LooseLine { element: element.tag, name }),
                }
            }
        }
        Ok(named)
    }
}

/// Which of y and z is the second coordinate.
struct Plane {
    second: usize,
}

impl Plane {
    fn of(tables: &Tables) -> Result<Plane, GmshError> {
        let used: Vec<u64> =
            tables.elements.iter().filter(|e| corners(e.kind) > 0).flat_map(|e| e.nodes.iter().copied()).collect();
        let extent = |k: usize| {
            let values = used.iter().filter_map(|n| tables.nodes.get(n)).map(|x| x[k]);
            let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(v), h.max(v)));
            high - low
        };
        let (x, y, z) = (extent(0), extent(1), extent(2));
        let flat = |v: f64| v <= 1e-12 * x.max(1e-300);
        match (flat(z), flat(y)) {
            (true, _) => Ok(Plane { second: 1 }),
            (false, true) => Ok(Plane { second: 2 }),
            _ if used.is_empty() => Err(GmshError::NoCells),
            _ => Err(GmshError::NotPlane { y, z }),
        }
    }

    fn position(&self, tables: &Tables, element: u64, node: u64) -> Result<[f64; 2], GmshError> {
        let x = tables.nodes.get(&node).ok_or(GmshError::NoSuchNode { element, node })?;
        Ok([x[0], x[self.second]])
    }
}

/// Number of corners of a cell; 0 for points and lines.
fn corners(kind: i32) -> usize {
    match kind {
        2 | 9 | 20 | 21 | 22 | 23 => 3,
        3 | 10 | 16 | 36 | 37 | 39 | 40 => 4,
        _ => 0,
    }
}

/// Polynomial order of a cell's edges.
fn order(kind: i32) -> usize {
    match kind {
        2 | 3 => 1,
        9 | 10 | 16 => 2,
        20 | 21 | 36 | 39 => 3,
        _ => 4,
    }
}

/// The curve through the nodes of an edge; a line if they lie on one, equally spaced.
fn edge_curve(points: &[[f64; 2]]) -> Result<Curve, Error> {
    let n = points.len() - 1;
    let (a, b) = (points[0], points[n]);
    let length = (b[0] - a[0]).hypot(b[1] - a[1]);
    let straight = points.iter().enumerate().all(|(i, p)| {
        let s = i as f64 / n as f64;
        (p[0] - (1.0 - s) * a[0] - s * b[0]).hypot(p[1] - (1.0 - s) * a[1] - s * b[1]) <= 1e-13 * length
    });
    if straight { Ok(Curve::Line { start: a, end: b }) } else { Curve::through(points) }
}

/// Tags of the physical surfaces that have cells, ascending.
fn surface_tags(tables: &Tables) -> Vec<i32> {
    let cells = tables.elements.iter().filter(|e| corners(e.kind) > 0);
    let mut tags = Vec::new();
    for tag in cells.filter_map(|e| e.physical.first()) {
        if let Err(place) = tags.binary_search(tag) {
            tags.insert(place, *tag);
        }
    }
    tags
}

/// Name of a physical group, its number if it has none.
fn group_name(tables: &Tables, dimension: i32, tag: i32) -> String {
    tables.names.get(&(dimension, tag)).cloned().unwrap_or_else(|| tag.to_string())
}
