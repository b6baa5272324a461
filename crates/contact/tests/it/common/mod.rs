//! Bodies that the tests share.

pub(crate) mod cylinder;
pub(crate) mod drum;
pub(crate) mod punch;
pub(crate) mod wedge;

use hpfem::{BodyProblem, Kinematics, Material, Mesh};

pub(crate) fn material(young: f64, poisson: f64) -> Material {
    Material::isotropic(young, poisson).unwrap()
}

/// A body of degrees that fall towards the layers, whose boundary "contact" is kept.
pub(crate) fn touching(mesh: Mesh, [degree, layers]: [usize; 2], kinematics: Kinematics, material: Material) -> BodyProblem {
    let degrees = falling_degrees(&mesh, degree, layers);
    BodyProblem::new(mesh, degree, kinematics).degrees(degrees).material(material).keep("contact")
}

/// Degrees that fall from `degree` outside the layers to 2 in the innermost.
pub(crate) fn falling_degrees(mesh: &Mesh, degree: usize, layers: usize) -> Vec<usize> {
    let fall = |layer: usize| (layer * degree).checked_div(layers).unwrap_or(0);
    mesh.cells.iter().map(|c| (degree + 1).saturating_sub(fall(c.layer)).clamp(2, degree)).collect()
}

/// Value at arc length `arc` of a quantity given at the contact points: the polynomial of the edge through its points.
pub(crate) fn at_arc(operator: &contact::ContactOperator<'_>, values: &[f64], arc: f64) -> f64 {
    let trace = &operator.pair().shaped.trace;
    let (edge, t) = trace.locate(arc);
    let (low, high) = (trace.edges[edge].start, trace.edges[edge].start + trace.edges[edge].curve.length());
    let tolerance = 1e-12 * trace.length();
    let on: Vec<usize> =
        (0..values.len()).filter(|i| (low - tolerance..=high + tolerance).contains(&operator.points()[*i].arc)).collect();
    let places: Vec<f64> = on.iter().map(|i| 2.0 * (operator.points()[*i].arc - low) / (high - low) - 1.0).collect();
    let weights = hpfem::barycentric_weights(&places);
    hpfem::lagrange(&places, &weights, t).iter().zip(&on).map(|(l, i)| l * values[*i]).sum()
}
