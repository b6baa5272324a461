//! Elastic foundations: where they hold a body, and the stiffness of one on an edge.

use crate::assembly::Assembly;
use crate::basis::points_for;
use crate::boundary::boundary_point;
use crate::error::Error;
use crate::freedom::Foundation;
use crate::kinematics::Kinematics;
use crate::legendre::shape_values;
use crate::mesh::Mesh;
use crate::own_element::{LocalMatrix, OwnElement};
use crate::problem::BodyProblem;
use crate::quadrature::gauss;
use crate::space::{Space, Target};
use faer::Mat;

/// A place that a foundation holds; in torsion the direction does not count.
#[derive(Clone, Copy)]
pub(crate) struct HeldPlace {
    /// The group of its edge.
    pub(crate) group: usize,
    pub(crate) position: [f64; 2],
    /// The direction in which it is held.
    pub(crate) direction: [f64; 2],
}

impl BodyProblem {
    /// Edges on foundations.
    pub(crate) fn foundation_edges(&self) -> Result<Vec<(usize, &Foundation)>, Error> {
        let mesh = &self.mesh;
        let mut edges = Vec::new();
        for f in &self.foundations {
            edges.extend(mesh.boundary(&f.boundary)?.into_iter().map(|e| (e, f)));
        }
        Ok(edges)
    }

    /// Places and directions that foundations hold elastically.
    pub(crate) fn held(&self) -> Result<Vec<HeldPlace>, Error> {
        let mesh = &self.mesh;
        let mut held = Vec::new();
        for (e, f) in self.foundation_edges()? {
            for t in [-0.9, 0.0, 0.9] {
                let (p, _) = boundary_point(&mesh.edges[e].curve, t, false);
                let held_there = match self.kinematics {
                    Kinematics::Torsion => vec![(f.tangential, p.tangent)],
                    Kinematics::Potential { .. } | Kinematics::AxisymmetricPotential => vec![(f.normal, [1.0, 0.0])],
                    Kinematics::PlaneStress { .. } | Kinematics::PlaneStrain { .. } | Kinematics::Axisymmetric => {
                        vec![(f.normal, p.outward), (f.tangential, p.tangent)]
                    }
                };
                let (group, position) = (mesh.vertices.len() + e, p.position);
                let stiff = held_there.into_iter().filter(|(k, _)| *k > 0.0);
                held.extend(stiff.map(|(_, direction)| HeldPlace { group, position, direction }));
            }
        }
        Ok(held)
    }
}

impl Assembly<'_> {
    /// The stiffness of a foundation on one edge, as an element of its own on groups sorted by rank.
    pub(crate) fn foundation(&self, edge: usize, foundation: &Foundation, groups: &[usize]) -> OwnElement {
        let (k, targets) = self.foundation_matrix(edge, foundation);
        let local = LocalMatrix { matrix: k.as_ref(), targets: &targets, load: &[] };
        let (matrix, constant) = self.on_groups(&local, groups);
        OwnElement { matrix, constant, interior_work: None }
    }

    /// The stiffness of a foundation on the local unknowns of one edge, and what these hang on.
    pub(crate) fn foundation_matrix(&self, edge: usize, foundation: &Foundation) -> (Mat<f64>, Vec<Target>) {
        let own = &self.mesh.edges[edge];
        let components = self.space.components;
        let degree = self.space.edge_degree[edge];
        let rule = gauss(points_for(degree));
        let n = components * (degree + 1);
        let mut k = Mat::<f64>::zeros(n, n);
        for (t, w) in rule.points.iter().zip(&rule.weights) {
            let (p, length) = boundary_point(&own.curve, *t, false);
            let weight = w * length * self.kinematics.measure(p.position[0]) / self.unit;
            let shapes: Vec<f64> = shape_values(degree, *t).collect();
            let stiffness = |c: usize, d: usize| match self.kinematics {
                Kinematics::Torsion => foundation.tangential,
                Kinematics::Potential { .. } | Kinematics::AxisymmetricPotential => foundation.normal,
                Kinematics::PlaneStress { .. } | Kinematics::PlaneStrain { .. } | Kinematics::Axisymmetric => {
                    foundation.normal * p.outward[c] * p.outward[d] + foundation.tangential * p.tangent[c] * p.tangent[d]
                }
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
        (k, targets)
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
