//! Two meshes made one where they touch.

use crate::box_tree::{Bounds, BoxTree};
use crate::curve::Curve;
use crate::error::Error;
use crate::mesh::{Edge, Mesh, Quad, distance};
use crate::point_search::CellBoxes;
use std::collections::{BTreeMap, BTreeSet, HashMap};

/// How two meshes are joined; the default fits meshes that meet up to round-off and have materials of their own.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Joint {
    /// Boundary vertices of the two meshes that are at most this far apart become one, mm; `None` for 1e-9 times the diagonal of the box around
    /// both meshes.
    pub tolerance: Option<f64>,
    /// What is added to the material indices of the second mesh: 0 where both use one list of materials, `None` for the first index that the
    /// first mesh does not use (its highest plus one), so that the lists follow each other.
    pub material_offset: Option<usize>,
}

impl Mesh {
    /// This mesh and another one as one body, connected where they touch.
    ///
    /// Vertices of the two boundaries within the tolerance of each other become one, in the place that this mesh gives it; edges between
    /// such vertices are shared and keep the curve of this mesh. All other edges stay, bent by their share of the shift where an end moved. The
    /// vertices, edges and cells of this mesh keep their numbers, the cells of the other follow. Boundaries of the same name become one. An edge
    /// that is shared keeps the names of both sides, as an inner line: supports and loads on such a name act on it as well.
    ///
    /// ```text
    /// +---+---+         +---+           +---+---+---+
    /// |   |   |         |   |           |   |   |   |
    /// +---+---+  joined +---+    ->     +---+---+---+
    /// |   |   |                         |   |   |
    /// +---+---+                         +---+---+
    /// ```
    ///
    /// # Errors
    /// [`Error::NotTouching`] if no edge is shared; [`Error::HangingVertex`] if a vertex of one lies between the ends of an edge of the
    /// other; [`Error::CurvesDisagree`] if shared edges run more than the tolerance apart; [`Error::MeshesOverlap`] and
    /// [`Error::CellsOverlap`] if they lie on each other; [`Error::AmbiguousVertex`] where a vertex has two partners, as at the mouth of
    /// a slit; [`Error::OutOfRange`] for a tolerance that is not positive; [`Error::FoldedCell`] if a cell does not survive the shift.
    pub fn join(&self, other: &Mesh, joint: Joint) -> Result<Mesh, Error> {
        let meeting = Meeting::new(self, other, joint)?;
        meeting.check_shared()?;
        meeting.check_apart()?;
        let mesh = meeting.whole(joint.material_offset)?;
        mesh.check_cells()?;
        mesh.check_overlap()?;
        Ok(mesh)
    }
}

/// Two meshes that meet.
struct Meeting<'m> {
    meshes: [&'m Mesh; 2],
    tolerance: f64,
    /// Edges with one cell.
    outer: [Vec<usize>; 2],
    /// The vertex of the first mesh that each merged vertex of the second becomes.
    partner: BTreeMap<usize, usize>,
    /// Edges of the two meshes that become one.
    shared: Vec<[usize; 2]>,
}

impl<'m> Meeting<'m> {
    fn new(first: &'m Mesh, second: &'m Mesh, joint: Joint) -> Result<Meeting<'m>, Error> {
        let [across, up] = Bounds::around(first.vertices.iter().chain(&second.vertices).copied()).widths();
        let tolerance = joint.tolerance.unwrap_or(1e-9 * across.hypot(up));
        if !(tolerance > 0.0 && tolerance.is_finite()) {
            let quantity = "the tolerance of a joint".into();
            return Err(Error::OutOfRange { quantity, value: tolerance, range: "positive and finite" });
        }
        let outer = [first, second].map(outer_edges);
        let mut meeting = Meeting { meshes: [first, second], tolerance, outer, partner: BTreeMap::new(), shared: Vec::new() };
        meeting.pair_vertices()?;
        meeting.pair_edges();
        Ok(meeting)
    }

    /// Vertices on the boundary of one of the meshes, ascending.
    fn vertices(&self, which: usize) -> Vec<usize> {
        let mut vertices: Vec<usize> = self.outer[which].iter().flat_map(|e| self.meshes[which].edges[*e].vertices).collect();
        vertices.sort_unstable();
        vertices.dedup();
        vertices
    }

    fn pair_vertices(&mut self) -> Result<(), Error> {
        let ours = self.vertices(0);
        let [first, second] = self.meshes;
        let around = |v: &usize| Bounds::around([first.vertices[*v]]).widened([self.tolerance; 2]);
        let tree = BoxTree::new(ours.iter().map(around).collect());
        let mut taken: HashMap<usize, usize> = HashMap::new();
        let mut near = Vec::new();
        for v in self.vertices(1) {
            let x = second.vertices[v];
            tree.holding(x, &mut near);
            near.retain(|k| distance(first.vertices[ours[*k]], x) <= self.tolerance);
            let Some(partner) = near.first().map(|k| ours[*k]) else { continue };
            if near.len() > 1 || taken.insert(partner, v).is_some() {
                return Err(Error::AmbiguousVertex { tolerance: self.tolerance, x: x[0], z: x[1] });
            }
            self.partner.insert(v, partner);
        }
        Ok(())
    }

    fn pair_edges(&mut self) {
        let key = |[a, b]: [usize; 2]| [a.min(b), a.max(b)];
        let [first, second] = self.meshes;
        let ours: HashMap<[usize; 2], usize> = self.outer[0].iter().map(|e| (key(first.edges[*e].vertices), *e)).collect();
        let pair = |e: &usize| {
            let [a, b] = second.edges[*e].vertices.map(|v| self.partner.get(&v).copied());
            Some([*ours.get(&key([a?, b?]))?, *e])
        };
        self.shared = self.outer[1].iter().filter_map(pair).collect();
    }

    /// Refuses meshes without a shared edge, and shared edges that run differently.
    fn check_shared(&self) -> Result<(), Error> {
        if self.shared.is_empty() {
            self.check_hanging()?;
            return Err(Error::NotTouching { tolerance: self.tolerance, distance: self.closest() });
        }
        for pair in &self.shared {
            let [a, b] = [0, 1].map(|i| self.meshes[i].edges[pair[i]].curve);
            for t in [-0.75, -0.4, 0.0, 0.4, 0.75] {
                let x = b.point(t);
                let distance = distance_from(&a, x);
                if distance.is_nan() || distance > self.tolerance {
                    return Err(Error::CurvesDisagree { x: x[0], z: x[1], distance });
                }
            }
        }
        Ok(())
    }

    /// Refuses vertices of one mesh on the edges of the other, and points of one boundary inside the other mesh.
    fn check_apart(&self) -> Result<(), Error> {
        self.check_hanging()?;
        let mut near = Vec::new();
        for which in [0, 1] {
            let search = CellBoxes::new(self.meshes[1 - which]);
            let points =
                self.free_edges(which).into_iter().flat_map(|edge| [-1.0, -0.6, 0.1, 0.7, 1.0].map(|t| edge.curve.point(t)));
            let rim = |x: [f64; 2]| {
                let edges = self.outer[1 - which].iter().map(|e| &self.meshes[1 - which].edges[*e]);
                edges.map(|edge| distance_from(&edge.curve, x)).any(|distance| distance <= self.tolerance)
            };
            for x in points {
                if search.other_cell(self.meshes[1 - which], None, x, &mut near).is_some() && !rim(x) {
                    return Err(Error::MeshesOverlap { x: x[0], z: x[1] });
                }
            }
        }
        Ok(())
    }

    fn check_hanging(&self) -> Result<(), Error> {
        for which in [0, 1] {
            let (mesh, edges) = (self.meshes[which], self.free_edges(1 - which));
            let tree = BoxTree::new(edges.iter().map(|edge| curve_bounds(&edge.curve).widened([self.tolerance; 2])).collect());
            let mut near = Vec::new();
            let pairs = self.partner.iter().map(|(theirs, ours)| [*ours, *theirs][which]);
            let merged: BTreeSet<usize> = pairs.collect();
            for v in self.vertices(which) {
                let x = mesh.vertices[v];
                tree.holding(x, &mut near);
                // A merged vertex ends edges of the other mesh, but may still lie within one of those that it does not end.
                let own = |k: &usize| {
                    let ends = edges[*k].vertices.map(|end| self.meshes[1 - which].vertices[end]);
                    merged.contains(&v) && ends.iter().any(|end| distance(*end, x) <= self.tolerance)
                };
                if near.iter().any(|k| !own(k) && distance_from(&edges[*k].curve, x) <= self.tolerance) {
                    return Err(Error::HangingVertex { x: x[0], z: x[1] });
                }
            }
        }
        Ok(())
    }

    /// The outer edges of a mesh that are not shared.
    fn free_edges(&self, which: usize) -> Vec<&'m Edge> {
        let shared: BTreeSet<usize> = self.shared.iter().map(|pair| pair[which]).collect();
        let mesh = self.meshes[which];
        self.outer[which].iter().filter(|e| !shared.contains(e)).map(|e| &mesh.edges[*e]).collect()
    }

    /// Smallest distance between boundary vertices of the two meshes.
    fn closest(&self) -> f64 {
        let [ours, theirs] = [0, 1].map(|i| self.vertices(i).into_iter().map(|v| self.meshes[i].vertices[v]).collect::<Vec<_>>());
        ours.iter().flat_map(|a| theirs.iter().map(|b| distance(*a, *b))).fold(f64::INFINITY, f64::min)
    }

    /// The mesh of both.
    fn whole(&self, offset: Option<usize>) -> Result<Mesh, Error> {
        let [first, second] = self.meshes;
        let mut vertices = first.vertices.clone();
        let number = |v: usize| {
            self.partner.get(&v).copied().unwrap_or_else(|| {
                vertices.push(second.vertices[v]);
                vertices.len() - 1
            })
        };
        let numbers: Vec<usize> = (0..second.vertices.len()).map(number).collect();
        let offset = offset.unwrap_or_else(|| first.cells.iter().map(|cell| cell.material.saturating_add(1)).max().unwrap_or(0));
        let ours = first.cells.iter().map(|cell| Quad { corners: cell.corners, material: cell.material, layer: cell.layer });
        let theirs = second.cells.iter().map(|cell| Quad {
            corners: cell.corners.map(|v| numbers[v]),
            material: cell.material.saturating_add(offset),
            layer: cell.layer,
        });
        let quads: Vec<Quad> = ours.chain(theirs).collect();
        let mut curves: Vec<([usize; 2], Curve)> = first.edges.iter().map(|edge| (edge.vertices, edge.curve)).collect();
        let mut names = named(first, |v| v);
        names.extend(named(second, |v| numbers[v]));
        let shared: BTreeSet<usize> = self.shared.iter().map(|pair| pair[1]).collect();
        for (_, edge) in second.edges.iter().enumerate().filter(|(e, _)| !shared.contains(e)) {
            let ends = edge.vertices.map(|v| numbers[v]);
            let [start, end] = edge.vertices.map(|v| match self.partner.get(&v) {
                Some(partner) if first.vertices[*partner] != second.vertices[v] => Some(first.vertices[*partner]),
                Some(_) | None => None,
            });
            let moved = start.is_some() || end.is_some();
            let [from, to] = ends.map(|v| vertices[v]);
            curves.push((ends, if moved { edge.curve.with_ends(from, to) } else { edge.curve }));
        }
        Mesh::joined(vertices, &quads, &curves, &names)
    }
}

/// The names of the edges of a mesh, its vertices numbered anew.
fn named(mesh: &Mesh, number: impl Fn(usize) -> usize) -> Vec<([usize; 2], &str)> {
    let of = |edge: &Edge| edge.tags.iter().map(|t| mesh.boundaries[*t].as_str()).collect::<Vec<_>>();
    mesh.edges.iter().flat_map(|edge| of(edge).into_iter().map(|name| (edge.vertices.map(&number), name))).collect()
}

/// Edges with one cell.
fn outer_edges(mesh: &Mesh) -> Vec<usize> {
    mesh.edge_cells().iter().enumerate().filter(|(_, cells)| cells.len() == 1).map(|(e, _)| e).collect()
}

/// A box that holds a curve.
fn curve_bounds(curve: &Curve) -> Bounds {
    Bounds::around([curve.point(-1.0), curve.point(1.0)]).widened(curve.bulge())
}

/// Distance of a point from a curve: the closest of a few points, improved by Newton's method for the foot of the perpendicular.
fn distance_from(curve: &Curve, x: [f64; 2]) -> f64 {
    const PIECES: i32 = 16;
    let places = (0..=PIECES).map(|i| f64::from(2 * i) / f64::from(PIECES) - 1.0);
    let away = |t: f64| distance(curve.point(t), x);
    let mut t = places.min_by(|a, b| away(*a).total_cmp(&away(*b))).unwrap_or(0.0);
    for _ in 0..20 {
        let (p, d) = (curve.point(t), curve.derivative(t));
        let step = (d[0] * (x[0] - p[0]) + d[1] * (x[1] - p[1])) / (d[0] * d[0] + d[1] * d[1]);
        let next = (t + step).clamp(-1.0, 1.0);
        if next.is_nan() || away(next) >= away(t) {
            break;
        }
        t = next;
    }
    away(t)
}
