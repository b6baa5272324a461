//! Boundaries: points on them, the path of their edges, fields on them as modes of edges.

use crate::curve::Curve;
use crate::error::Error;
use crate::mesh::Mesh;
use crate::quadrature::gauss_lobatto;
use std::cmp::Ordering;
use std::collections::BTreeMap;

/// A point on the boundary of a body.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct BoundaryPoint {
    /// Position (x, z) or (r, z), mm.
    pub position: [f64; 2],
    /// Unit normal out of the body.
    pub outward: [f64; 2],
    /// Unit tangent: the outward normal turned anti-clockwise by a right angle.
    pub tangent: [f64; 2],
}

/// The boundary point of a curve at `t` and the length factor `|dx/dt|`; `clockwise` tells that the curve has the body on its right.
pub(crate) fn boundary_point(curve: &Curve, t: f64, clockwise: bool) -> (BoundaryPoint, f64) {
    let d = curve.derivative(t);
    let length = d[0].hypot(d[1]);
    let sign = if clockwise { -1.0 } else { 1.0 };
    let tangent = [sign * d[0] / length, sign * d[1] / length];
    (BoundaryPoint { position: curve.point(t), outward: [tangent[1], -tangent[0]], tangent }, length)
}

impl Mesh {
    /// The edges of a boundary as a path of `(edge, against)`, `against` where it is walked against the edge's own direction: an open one from the end
    /// with the smaller coordinates (first coordinate first), a closed one from its vertex with the smallest, with the body on its left (an inner line
    /// that closes: the cell of the lower number).
    ///
    /// # Errors
    /// [`Error::NoSuchBoundary`]; [`Error::NotAPath`] where the edges are not one path.
    pub fn path(&self, name: &str) -> Result<Vec<(usize, bool)>, Error> {
        path(self, name)
    }
}

/// [`Mesh::path`].
pub(crate) fn path(mesh: &Mesh, name: &str) -> Result<Vec<(usize, bool)>, Error> {
    let edges = mesh.boundary(name)?;
    let broken = || Error::NotAPath { name: name.to_string() };
    let mut at: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
    for e in &edges {
        mesh.edges[*e].vertices.iter().for_each(|v| at.entry(*v).or_default().push(*e));
    }
    let ends: Vec<usize> = at.iter().filter(|(_, e)| e.len() == 1).map(|(v, _)| *v).collect();
    if !matches!(ends.len(), 0 | 2) || at.values().any(|e| e.len() > 2) {
        return Err(broken());
    }
    let closed = ends.is_empty();
    let starts: Vec<usize> = if closed { at.keys().copied().collect() } else { ends };
    let key = |v: usize| mesh.vertices[v];
    let smaller = |a: &usize, b: &usize| key(*a).partial_cmp(&key(*b)).unwrap_or(Ordering::Equal);
    let start = starts.into_iter().min_by(smaller).ok_or_else(broken)?;
    let mut next = at[&start].first().copied();
    if closed {
        let cells = mesh.edge_cells();
        let leads = |e: &&usize| (mesh.edges[**e].vertices[1] == start) != has_cell_on_left(mesh, cells[**e][0]);
        next = at[&start].iter().find(leads).copied().or(next);
    }
    let mut vertex = start;
    let mut walk = Vec::new();
    while let Some(e) = next {
        let against = mesh.edges[e].vertices[1] == vertex;
        walk.push((e, against));
        vertex = mesh.edges[e].vertices[usize::from(!against)];
        next = at[&vertex].iter().copied().find(|other| *other != e && vertex != start);
    }
    if walk.len() == edges.len() { Ok(walk) } else { Err(broken()) }
}

/// Whether a cell lies on the left of its local edge, walked in the edge's own direction.
pub(crate) fn has_cell_on_left(mesh: &Mesh, (cell, local): (usize, usize)) -> bool {
    // Local edges 0 and 1 run anti-clockwise.
    (local < 2) != mesh.cells[cell].against[local]
}

/// Coefficients of the modes 2.. of a field on an edge, interpolated at Lobatto points, in the edge's own parameter.
pub(crate) fn edge_modes(curve: &Curve, degree: usize, field: impl Fn([f64; 2]) -> [f64; 2]) -> Vec<[f64; 2]> {
    if degree < 2 {
        return Vec::new();
    }
    // With y = f - linear part, which vanishes at the ends, c_k = int y' N_k' = -sqrt((2k-1)/2) int y P_{k-1}', and the rule is exact for it.
    let rule = gauss_lobatto(degree + 1);
    let [first, last] = [-1.0, 1.0].map(|t| field(curve.point(t)));
    let mut modes = vec![[0.0; 2]; degree - 1];
    for (t, w) in rule.points[1..degree].iter().zip(&rule.weights[1..]) {
        let value = field(curve.point(*t));
        let y: [f64; 2] = std::array::from_fn(|i| w * (value[i] - 0.5 * ((1.0 - t) * first[i] + (1.0 + t) * last[i])));
        // P_{k-2}, P_{k-1} and the slopes P_{k-3}', P_{k-2}': P_j' = P_{j-2}' + (2j - 1) P_{j-1}.
        let (mut p, mut slope) = ([1.0, *t], [0.0, 1.0]);
        for (k, mode) in (2..).zip(&mut modes) {
            let factor = -(0.5 * (2 * k - 1) as f64).sqrt() * slope[1];
            mode[0] += factor * y[0];
            mode[1] += factor * y[1];
            slope = [slope[1], slope[0] + (2 * k - 1) as f64 * p[1]];
            p = [p[1], ((2 * k - 1) as f64 * t * p[1] - (k - 1) as f64 * p[0]) / k as f64];
        }
    }
    modes
}
