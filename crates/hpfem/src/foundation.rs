//! Elastic foundations: where they hold a body, and the stiffness of one on an edge.

use crate::additions::{Additions, Foundation};
use crate::assembly::Assembly;
use crate::basis::points_for;
use crate::boundary::boundary_point;
use crate::error::Error;
use crate::legendre::shape_functions;
use crate::material::Kinematics;
use crate::mesh::Mesh;
use crate::own_element::{LocalMatrix, OwnElement};
use crate::quadrature::gauss;
use crate::space::{Space, Target};
use faer::Mat;

/// A place and the direction in which it is held.
pub(crate) type HeldPlace = ([f64; 2], [f64; 2]);

impl Additions<'_> {
    /// Edges on foundations.
    pub(crate) fn foundation_edges(&self, mesh: &Mesh) -> Result<Vec<(usize, &Foundation)>, Error> {
        let mut edges = Vec::new();
        for f in &self.foundations {
            edges.extend(mesh.boundary(&f.boundary)?.into_iter().map(|e| (e, f)));
        }
        Ok(edges)
    }

    /// Places and directions that foundations hold elastically.
    pub(crate) fn held(&self, mesh: &Mesh) -> Result<Vec<HeldPlace>, Error> {
        let mut held = Vec::new();
        for (e, f) in self.foundation_edges(mesh)? {
            for t in [-0.9, 0.0, 0.9] {
                let (p, _) = boundary_point(&mesh.edges[e].curve, t, false);
                let directions = [(f.normal, p.outward), (f.tangential, p.tangent)];
                held.extend(directions.iter().filter(|(k, _)| *k > 0.0).map(|(_, d)| (p.position, *d)));
            }
        }
        Ok(held)
    }
}

impl Assembly<'_> {
    /// The stiffness of a foundation on one edge, as an element of its own on groups sorted by rank.
    pub(crate) fn foundation(&self, edge: usize, foundation: &Foundation, groups: &[usize]) -> OwnElement {
        let own = &self.mesh.edges[edge];
        let components = self.space.components;
        let degree = self.space.edge_degree[edge];
        let rule = gauss(points_for(degree));
        let n = components * (degree + 1);
        let mut k = Mat::<f64>::zeros(n, n);
        for (t, w) in rule.points.iter().zip(&rule.weights) {
            let (p, length) = boundary_point(&own.curve, *t, false);
            let weight = w * length * self.kinematics.measure(p.position[0]) / self.unit;
            let shapes = shape_functions(degree, *t).0;
            let stiffness = |c: usize, d: usize| match self.kinematics {
                Kinematics::Torsion => foundation.tangential,
                _ => foundation.normal * p.outward[c] * p.outward[d] + foundation.tangential * p.tangent[c] * p.tangent[d],
            };
            for j in 0..n {
                for i in 0..n {
                    let shape = shapes[i / components] * shapes[j / components];
                    k[(i, j)] += weight * shape * stiffness(i % components, j % components);
                }
            }
        }
        let targets: Vec<Target> = (0..=degree)
            .flat_map(|m| {
                let (group, mode) = if m < 2 { (own.vertices[m], 0) } else { (self.mesh.vertices.len() + edge, m - 2) };
                (0..components).map(move |c| (group, mode, c))
            })
            .map(|(group, mode, c)| self.space.target(self.mesh, group, mode, c))
            .collect();
        let local = LocalMatrix { matrix: k.as_ref(), targets: &targets, load: &[] };
        let (matrix, constant) = self.on_groups(&local, groups);
        OwnElement { matrix, constant, interior_work: None }
    }
}

/// Groups of an edge with unknowns, the rigid edge's included.
pub(crate) fn edge_groups(mesh: &Mesh, space: &Space, edge: usize) -> Vec<usize> {
    let [a, b] = mesh.edges[edge].vertices;
    let mut groups = vec![a, b, mesh.vertices.len() + edge];
    if let Some((frame, _)) = &space.frame
        && groups.iter().any(|g| space.freedom[*g].slaved)
    {
        groups.push(*frame);
    }
    groups.retain(|g| space.size[*g] > 0);
    groups
}
