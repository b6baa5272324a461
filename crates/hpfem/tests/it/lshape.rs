//! The L-shaped domain of Szabo and Babuska, *Finite Element Analysis*, 1991, sec. 4.1 and fig. 4.2: opening mode at a re-entrant
//! corner of 270 degrees, plane strain, nu = 0.3, exact tractions on the outer edges, all edges through the corner free.
//!
//! ```text
//!        z
//!        |    a rotated L: the bisector of the solid angle is the x axis, free edges at +-135 degrees
//!   \    |
//!    \   |
//!     0--+--- x
//!    /
//!   /
//! ```

use crate::common::*;
use hpfem::*;

/// Exponent and constant of the opening mode.
const LAMBDA: f64 = 0.544483736782464;
const Q: f64 = 0.543075578836737;
/// Strain energy of the exact solution for `A_1 = a = E = t = 1`, Szabo and Babuska eq. (4.22).
pub(crate) const ENERGY: f64 = 4.15454423;

fn stress(x: [f64; 2]) -> [f64; 3] {
    let (r, t) = (x[0].hypot(x[1]), x[1].atan2(x[0]));
    let c = LAMBDA * r.powf(LAMBDA - 1.0);
    let (l1, l3) = (LAMBDA - 1.0, LAMBDA - 3.0);
    [
        c * ((2.0 - Q * (LAMBDA + 1.0)) * (l1 * t).cos() - l1 * (l3 * t).cos()),
        c * ((2.0 + Q * (LAMBDA + 1.0)) * (l1 * t).cos() + l1 * (l3 * t).cos()),
        c * (l1 * (l3 * t).sin() + Q * (LAMBDA + 1.0) * (l1 * t).sin()),
    ]
}

/// Three unit squares around the corner at vertex 0, turned by 45 degrees.
pub(crate) fn l_shape() -> Mesh {
    let h = 0.5_f64.sqrt();
    let turn = |x: [f64; 2]| [h * (x[0] - x[1]), h * (x[0] + x[1])];
    // Before the turn the missing square is x < 0, z < 0, turned so that the solid is symmetric about the x axis.
    let vertices = [[0.0, 0.0], [0.0, -1.0], [1.0, -1.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [-1.0, 1.0], [-1.0, 0.0]];
    let vertices = vertices.map(|x| turn([x[0], x[1]])).map(|x| [x[1], -x[0]]).to_vec();
    let quad = |corners| Quad { corners, material: 0, layer: 0 };
    let quads = [quad([0, 1, 2, 3]), quad([0, 3, 4, 5]), quad([0, 5, 6, 7])];
    let outer = [[1, 2], [2, 3], [3, 4], [4, 5], [5, 6], [6, 7]].map(|e| (e, "outer"));
    let mut names = outer.to_vec();
    names.push(([1, 2], "held"));
    Mesh::new(vertices, &quads, &[], &names).unwrap()
}

pub(crate) fn energy(mesh: &Mesh, degrees: Vec<usize>) -> (f64, usize) {
    let materials = [Material::isotropic(1.0, 0.3).unwrap()];
    let load = [vec![traction("outer", |p| {
        let ([x, z, t], n) = (stress(p.position), p.outward);
        [x * n[0] + t * n[1], t * n[0] + z * n[1]]
    })]];
    let kinematics = Kinematics::PlaneStrain { thickness: 1.0 };
    let body = Body::new(BodyProblem { degrees, ..problem(mesh, 1, kinematics, &materials, &[], &load, Some("held")) }).unwrap();
    (body.interface.strain_energy(&solved(&body, &[1.0])), body.effort.unknowns)
}

#[test]
fn on_a_fixed_mesh_the_energy_norm_converges_with_the_power_two_lambda_of_the_degree() {
    let mesh = l_shape();
    let reference = energy(&mesh.refined_towards(&[0], 0.15, 18).unwrap(), vec![14; 3 + 18 * 6]).0;
    assert!((reference / ENERGY - 1.0).abs() < 1e-8, "{reference}");
    let error = |p: usize| (1.0 - energy(&mesh, vec![p; 3]).0 / reference).sqrt();
    let slope = (error(8) / error(20)).ln() / (20.0_f64 / 8.0).ln();
    // The asymptotic slope is 2 lambda = 1.089; degrees shifted by a constant differ at finite p.
    assert!((slope - 2.0 * LAMBDA).abs() < 0.08, "{slope}");
}

#[test]
fn on_a_graded_mesh_the_energy_norm_converges_exponentially() {
    let mesh = l_shape();
    // Degree p with p layers, degree falling linearly into the layers.
    let mut errors = Vec::new();
    let mut roots = Vec::new();
    for p in 2..=10 {
        let graded = mesh.refined_towards(&[0], 0.15, p).unwrap();
        let degrees = graded.cells.iter().map(|c| (p + 1 - c.layer.min(p)).max(2)).collect();
        let (u, unknowns) = energy(&graded, degrees);
        errors.push((1.0 - u / ENERGY).abs().sqrt());
        roots.push((unknowns as f64).cbrt());
    }
    // ln(error) falls linearly in the cube root of the unknowns (Babuska and Guo 1986).
    let rate = (errors[0] / errors[7]).ln() / (roots[7] - roots[0]);
    assert!(rate > 0.55, "rate {rate:.2}: {errors:?}");
    assert!(errors[8] < 1e-4, "{errors:?}");
}
